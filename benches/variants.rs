//! Rows of variants of a crank-slider with all reactions, from numbers to solutions on one thread: checked, solved,
//! without reading and writing. Items are rows. `cargo bench --bench variants`.

use assur::internals::check::{Overrides, Row, RowCell, RowColumn, columns};
use assur::internals::exercise::table::Table;
use assur::internals::pipeline::VariantSolver;
use assur::internals::source::Source;
use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use std::sync::Arc;

const ROWS: usize = 1000;
const HEADER: &str = "r [mm],l [mm],n [rpm],phi [deg],P [N]\n";

fn main() {
    divan::main();
}

#[divan::bench]
fn crank_slider(bencher: Bencher<'_, '_>) {
    let source = Source::new("crank-slider.mech", include_str!("../examples/variants/crank-slider.mech"));
    let (document, _) = assur::internals::syntax::parse(&source);
    let document = Arc::new(document);
    let none = Overrides::none();
    let header =
        Table::open("rows.csv", HEADER.as_bytes()).expect("read").unwrap_or_else(|_| panic!("a header"));
    let (found, _) = columns(&document, &none, &header.columns);
    let found: Arc<[RowColumn]> = found.expect("columns that fit").into();
    let row = |i: usize| {
        let values = [80 + i % 40, 300 + i % 77, 500 + i, 7 * i % 360, i].map(|x| x as f64);
        let cell = |(column, x): (&RowColumn, f64)| RowCell { value: column.unit.to_si(x), digit: 1.0 };
        Row::new(found.clone(), found.iter().zip(values).map(cell).collect())
    };
    let rows: Vec<Row> = (0..ROWS).map(row).collect();
    let mut family = VariantSolver::new(&document, &none);
    bencher
        .counter(ItemsCount::new(ROWS))
        .bench_local(|| rows.iter().filter(|row| black_box(family.solve_in_place(row)).0.is_some()).count());
}
