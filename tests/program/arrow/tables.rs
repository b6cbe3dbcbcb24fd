//! Rows of variants from tables of columns, and answers to such tables.

use super::{read, same_as};
use crate::run::{Folder, assur};
use assur_arrow::arrow_array::{ArrayRef, Float32Array, Float64Array, RecordBatch, StringArray};
use assur_arrow::arrow_ipc::{CompressionType, writer::FileWriter, writer::IpcWriteOptions};
use assur_arrow::{Kind, Schema, Writer};
use std::sync::Arc;

const PRESS: &str = "mech 1
given r = 100 mm
given phi = 60 deg
ground { A (0, 0); line guide through A along 0 deg }
link 1 crank  A-B r
link 2 rod    B-C 350 mm
link 3 piston { C (0, 0); mass 2 kg at C }
revolute  A: ground - crank
revolute  B: crank - rod
revolute  C: rod - piston
prismatic D: piston.C - ground.guide
drive crank = phi at 100 rpm
assemble C ahead of B
balance torque M on crank
find x = position(C).x as mm, M as N*m, far = position(C).x > 400 mm, reactions
";

/// Rows of which every hundredth does not close.
fn lengths(count: usize) -> Vec<f64> {
    (0..count).map(|i| if i % 100 == 17 { 900.0 } else { 80.0 + (i % 40) as f64 }).collect()
}

fn angles(count: usize) -> Vec<f64> {
    (0..count).map(|i| (i * 37 % 360) as f64 + 0.5).collect()
}

fn csv(count: usize) -> String {
    let rows = lengths(count).into_iter().zip(angles(count));
    "r [mm],phi [deg]\n".to_owned() + &rows.map(|(r, phi)| format!("{r},{phi}\n")).collect::<String>()
}

/// A table of columns with their units.
fn table(columns: Vec<(&str, &str, ArrayRef)>) -> RecordBatch {
    let fields = columns.iter().map(|(name, unit, array)| {
        let unit = [("unit".to_owned(), (*unit).to_owned())].into_iter().filter(|(_, unit)| !unit.is_empty());
        assur_arrow::Field::new(*name, array.data_type().clone(), true)
            .with_metadata(unit.collect::<std::collections::HashMap<_, _>>())
    });
    let schema = Arc::new(Schema::new(fields.collect::<Vec<_>>()));
    RecordBatch::try_new(schema, columns.into_iter().map(|(_, _, array)| array).collect()).unwrap()
}

fn write(folder: &Folder, name: &str, kind: Kind, batches: &[RecordBatch]) {
    let mut writer = Writer::of(kind, &batches[0].schema()).unwrap();
    batches.iter().for_each(|batch| writer.write(batch).unwrap());
    writer.end().unwrap();
    folder.write_bytes(name, &writer.take());
}

fn rows(count: usize) -> RecordBatch {
    table(vec![
        ("r", "mm", Arc::new(Float64Array::from(lengths(count)))),
        ("phi [deg]", "", Arc::new(Float64Array::from(angles(count)))),
    ])
}

fn kinds() -> Vec<(&'static str, Kind)> {
    vec![
        ("t.arrows", Kind::Stream),
        ("t.feather", Kind::File),
        #[cfg(feature = "parquet")]
        ("t.parquet", Kind::Parquet),
    ]
}

#[test]
fn columns_have_the_answers_of_comma_separated_values() {
    let folder = Folder::new("columns").with("p.mech", PRESS).with("t.csv", &csv(500));
    let wanted = assur(&folder, &["batch", "p.mech", "--variants", "t.csv", "--format", "csv"]);
    for (name, kind) in kinds() {
        write(&folder, name, kind, &[rows(500).slice(0, 123), rows(500).slice(123, 377)]);
        let found = assur(&folder, &["batch", "p.mech", "--variants", name, "--format", "csv"]);
        assert_eq!((found.status, found.stderr), (1, wanted.stderr.clone()), "{name}");
        assert!(found.stdout == wanted.stdout, "{name}");
        for table in ["t.csv", name] {
            let out = format!("out-{name}");
            let said = assur(&folder, &["batch", "p.mech", "--variants", table, "--out", &out]);
            assert_eq!((said.status, said.stderr), (1, wanted.stderr.clone()), "{name}");
            same_as(&read(&folder, &out), &wanted.stdout);
        }
    }
}

#[test]
fn files_that_are_compressed_are_read() {
    let folder = Folder::new("compressed").with("p.mech", PRESS);
    write(&folder, "plain.arrow", Kind::File, &[rows(500)]);
    let options = IpcWriteOptions::default().try_with_compression(Some(CompressionType::LZ4_FRAME)).unwrap();
    let mut bytes = Vec::new();
    let mut writer = FileWriter::try_new_with_options(&mut bytes, &rows(0).schema(), options).unwrap();
    writer.write(&rows(500)).unwrap();
    writer.finish().unwrap();
    drop(writer);
    folder.write_bytes("packed.arrow", &bytes);
    let answers = |name| assur(&folder, &["batch", "p.mech", "--variants", name, "--format", "csv"]).stdout;
    assert!(bytes.len() < std::fs::metadata(folder.path("plain.arrow")).unwrap().len() as usize);
    assert!(answers("packed.arrow") == answers("plain.arrow"));
}

#[test]
fn the_bytes_of_columns_do_not_depend_on_threads() {
    let folder = Folder::new("bytes").with("p.mech", PRESS);
    write(&folder, "t.arrows", Kind::Stream, &[rows(8_500)]);
    for (name, _) in kinds() {
        let out = format!("out-{name}");
        let bytes = |threads: &str| {
            let args = ["batch", "p.mech", "--variants", "t.arrows", "--threads", threads, "--out", &out];
            assert_eq!(assur(&folder, &args).status, 1);
            std::fs::read(folder.path(&out)).unwrap()
        };
        let one = bytes("1");
        assert!(one.len() > 8_500 * 8, "{name}: {}", one.len());
        assert!(one == bytes("3"), "{name}");
    }
    let args = ["batch", "p.mech", "--variants", "t.arrows", "--out", "t.arrows"];
    assert_eq!(assur(&folder, &args).status, 2, "an input stays");
}

#[test]
fn a_broken_row_is_null_and_says_why() {
    let folder = Folder::new("broken").with("p.mech", PRESS);
    let names = StringArray::from(vec!["good", "no number", "no end", "too long"]);
    let lengths = Float32Array::from(vec![Some(90.0), None, Some(f32::INFINITY), Some(900.0)]);
    write(
        &folder,
        "t.arrow",
        Kind::File,
        &[table(vec![("variant", "", Arc::new(names)), ("r", "", Arc::new(lengths))])],
    );
    let said = assur(&folder, &["batch", "p.mech", "--variants", "t.arrow", "--out", "a.arrow"]);
    assert_eq!(said.status, 1);
    assert!(said.stderr.contains("row 2: the value of `r` is missing"), "{}", said.stderr);
    assert!(
        said.stderr.contains("1 solved, 2 cannot be read: rows 2, 3, 1 does not close: row 4"),
        "{}",
        said.stderr
    );
    let batches = read(&folder, "a.arrow");
    let column = |name: &str| {
        let at = batches[0].schema().index_of(name).unwrap();
        super::cells(&batches, at)
    };
    assert_eq!(column("variant"), ["good", "no number", "no end", "too long"]);
    assert_eq!(column("r"), ["90", "", "inf", "900"]);
    assert!(!column("M")[0].is_empty() && column("M")[1..].iter().all(String::is_empty), "{:?}", column("M"));
    let errors = column("error");
    assert_eq!(errors[..3], ["", "the value of `r` is missing", "the value of `r` is infinite"]);
    assert!(errors[3].contains("close"), "{errors:?}");
}

#[test]
fn a_wrong_table_is_a_diagnostic() {
    let folder =
        Folder::new("wrong").with("p.mech", PRESS).with("no.arrow", "mech 1").with("empty.arrow", "");
    let one = || Arc::new(Float64Array::from(vec![1.0]));
    let words = || Arc::new(StringArray::from(vec!["1"]));
    write(&folder, "name.arrow", Kind::File, &[table(vec![("rr", "mm", one())])]);
    write(&folder, "unit.arrow", Kind::File, &[table(vec![("r", "kg", one())])]);
    write(&folder, "kind.arrow", Kind::File, &[table(vec![("r", "mm", words())])]);
    write(&folder, "none.arrow", Kind::File, &[rows(1).slice(0, 0)]);
    for (name, status, why) in [
        ("no.arrow", 2, "`no.arrow` cannot be read"),
        ("empty.arrow", 2, "`empty.arrow` cannot be read"),
        ("missing.arrow", 2, "no file or folder `missing.arrow`"),
        ("name.arrow", 1, "there is no given `rr`"),
        ("unit.arrow", 1, "kg"),
        ("kind.arrow", 1, "column `r` takes numbers, but has Utf8"),
        ("none.arrow", 1, "the table has no rows"),
    ] {
        let said = assur(&folder, &["batch", "p.mech", "--variants", name, "--format", "csv"]);
        assert_eq!(said.status, status, "{name}: {}", said.stderr);
        assert!(said.stderr.contains(why), "{name}: {}", said.stderr);
    }
}

#[test]
fn a_table_of_columns_is_of_one_file() {
    let folder = Folder::new("one").with("p.mech", PRESS).with("q.mech", PRESS);
    let said = assur(&folder, &["batch", "p.mech", "q.mech", "--out", "a.arrow"]);
    assert_eq!(said.status, 2);
    assert!(said.stderr.contains("answers of one file"), "{}", said.stderr);
    assert_eq!(folder.names(), ["p.mech", "q.mech"]);
}
