//! Streams of Arrow: the columns of CSV, with units in the metadata and nulls where there is no answer.

#![allow(clippy::unwrap_used)] // a test that cannot read its files has failed

mod tables;

use crate::run::{Folder, assur, into_file};
use assur::internals::exercise::table::{Separator, cells as cells_of};
use assur_arrow::arrow_array::{Array, BooleanArray, Float64Array, Int64Array, RecordBatch, StringArray};

/// A four-bar that does not close everywhere, with a condition among its answers.
const OPEN: &str = r#"mech 1
ground { A (0, 0); D (400 mm, 0) }
link crank   A-B 200 mm
link coupler B-C 150 mm
link rocker  D-C 200 mm
revolute A: ground - crank
revolute B: crank - coupler
revolute C: coupler - rocker
revolute D: ground - rocker
drive crank = 40 deg .. 140 deg in 20 steps at 10 rad/s
assemble C left of B-D
find angle(rocker) as deg, position(C) as mm, fast = omega(rocker) > 2 rad/s
"#;

/// The stream of a file, on this many threads.
fn stream(folder: &Folder, threads: &str) -> Vec<u8> {
    let path = folder.path("answers.arrow");
    let args = ["solve", "a.mech", "--format", "arrow", "--threads", threads];
    let ran = into_file(folder, &args, &path, false);
    assert_eq!(ran.status, 0, "{}", ran.stderr);
    std::fs::read(path).unwrap()
}

/// A column of all batches as CSV writes it, but for its digits.
fn cells(batches: &[RecordBatch], column: usize) -> Vec<String> {
    let of = |batch: &RecordBatch| {
        let array = batch.column(column).as_any();
        let each = |i: usize| {
            if batch.column(column).is_null(i) {
                return String::new();
            }
            let whole = array.downcast_ref::<Int64Array>();
            match (array.downcast_ref::<Float64Array>(), array.downcast_ref::<BooleanArray>()) {
                (Some(numbers), _) => numbers.value(i).to_string(),
                (_, Some(truths)) => truths.value(i).to_string(),
                _ if whole.is_some() => whole.unwrap().value(i).to_string(),
                _ => array.downcast_ref::<StringArray>().unwrap().value(i).to_owned(),
            }
        };
        (0..batch.num_rows()).map(each).collect::<Vec<_>>()
    };
    batches.iter().flat_map(of).collect()
}

fn same_as_csv(text: &str) {
    let folder = Folder::new("arrow").with("a.mech", text);
    stream(&folder, "2");
    let csv = assur(&folder, &["solve", "a.mech", "--format", "csv"]).stdout;
    same_as(&read(&folder, "answers.arrow"), &csv);
}

/// All batches of a table.
fn read(folder: &Folder, name: &str) -> Vec<RecordBatch> {
    let file = std::fs::File::open(folder.path(name)).unwrap();
    assur_arrow::open(file).unwrap().collect::<Result<_, _>>().unwrap()
}

/// Columns have the header, the cells and the empty places of comma-separated values.
fn same_as(batches: &[RecordBatch], csv: &str) {
    let mut lines = csv.lines();
    let schema = batches[0].schema();
    let names = schema.fields().iter().map(|field| match field.metadata().get("unit") {
        Some(unit) => format!("{} [{unit}]", field.name()),
        None => field.name().clone(),
    });
    let header = names.map(|name| if name.contains(',') { format!("\"{name}\"") } else { name });
    assert_eq!(header.collect::<Vec<_>>().join(","), lines.next().unwrap());
    let columns: Vec<Vec<String>> = (0..schema.fields().len()).map(|i| cells(batches, i)).collect();
    let mut count = 0;
    for (row, line) in lines.enumerate() {
        let wanted = cells_of(line, Separator::Comma).unwrap();
        assert_eq!(wanted.len(), columns.len(), "{line}");
        for (column, cell) in columns.iter().zip(wanted.iter().map(|cell| cell.text.as_ref())) {
            let same = match (column[row].parse::<f64>(), cell.parse::<f64>()) {
                (Ok(a), Ok(b)) => (a - b).abs() <= 1e-14 * b.abs(),
                _ => column[row] == cell,
            };
            assert!(same, "{line}: {} is not {cell}", column[row]);
        }
        count += 1;
    }
    assert_eq!(columns[0].len(), count);
}

#[test]
fn a_stream_has_the_columns_of_csv() {
    same_as_csv(include_str!("../../benches/peers/four-bar.mech"));
    same_as_csv(OPEN);
}

#[test]
fn a_long_stream_is_the_same_on_any_number_of_threads() {
    let text = include_str!("../../benches/peers/four-bar.mech").replace("in 360 steps", "in 30000 steps");
    let folder = Folder::new("arrow").with("a.mech", &text);
    let one = stream(&folder, "1");
    assert!(one.len() > 30_000 * 15 * 8);
    assert!(one == stream(&folder, "2"));
}

#[test]
fn one_file_without_variants() {
    let folder = Folder::new("arrow").with("a.mech", OPEN).with("b.mech", OPEN);
    let ran = assur(&folder, &["solve", "a.mech", "b.mech", "--format", "arrow"]);
    assert_eq!(ran.status, 2);
    assert!(ran.stderr.contains("one file without variants"), "{}", ran.stderr);
}
