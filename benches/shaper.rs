//! The whole shaper project, 360 positions with flywheel, after its text has been parsed. `cargo bench --bench shaper`.

use assur::internals::check::{Overrides, check};
use assur::internals::source::Source;
use assur::internals::syntax::document::Document;
use divan::{Bencher, black_box};

fn main() {
    divan::main();
}

/// The example with 360 positions; the answer key is that of twelve.
fn text() -> String {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/shaper/shaper-a.mech");
    let text = std::fs::read_to_string(path).expect("the example");
    let (machine, _) = text.split_once("\n// synthesis").expect("its answer key");
    machine.replace("in 12 steps", "in 360 steps")
}

fn document() -> Document {
    let (document, problems) = assur::internals::syntax::parse(&Source::new("shaper-a.mech", text()));
    assert!(problems.is_empty());
    document
}

/// Names, units, structure, plan, and all answers.
fn solved(document: &Document) -> f64 {
    let (mechanism, _) = check(document, &Overrides::none());
    let mechanism = mechanism.expect("it is sound");
    let (structure, _) = assur::internals::structure::structure(&mechanism).expect("it is determined");
    let plan = assur::internals::plan::plan(&mechanism, &structure);
    let model = assur::internals::solve::Model { mechanism: &mechanism, structure: &structure, plan: &plan };
    let solution = assur::internals::solve::solve(&model).expect("it is solved");
    assert_eq!(solution.poses.len(), 363);
    solution.statics.flywheels[0].inertia
}

#[divan::bench]
fn after_parsing(bencher: Bencher<'_, '_>) {
    let document = document();
    assert!((solved(&document) - 59.541_690_738_681_69).abs() < 1e-8);
    bencher.bench_local(|| black_box(solved(&document)));
}

#[divan::bench]
fn with_parsing(bencher: Bencher<'_, '_>) {
    let text = text();
    bencher.bench_local(|| {
        let (document, _) = assur::internals::syntax::parse(&Source::new("shaper-a.mech", text.clone()));
        black_box(solved(&document))
    });
}
