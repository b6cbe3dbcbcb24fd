//! `assur grade`, as run from a shell.

#![allow(clippy::unwrap_used)] // a test that cannot write its files has failed

use crate::run::{Folder, Said, assur, column};

const KEY: &str =
    "row,pose,Mb [N*m],\"reaction(B, rod).x [N]\",\"reaction(B, rod).y [N]\",phi [deg],w [rad/s],Mc [N*m]
1,1,26,-500,120,40,15,77
2,1,31,-620,150,55,12,88
";

fn marks(answers: &str) -> (Said, Vec<(String, String)>) {
    let folder = Folder::new(&format!("grade-{}", answers.len())).with("key.csv", KEY).with("a.csv", answers);
    let said = assur(&folder, &["grade", "key.csv", "a.csv", "--format", "csv"]);
    let (cells, slips) = (column(&said.stdout, "verdict"), column(&said.stdout, "slip"));
    let marks = cells.into_iter().zip(slips).collect();
    (said, marks)
}

/// The verdict and the slip of one answer in the first row.
fn mark(header: &str, answer: &str) -> (String, String) {
    let (said, mut marks) = marks(&format!("row,{header}\n1,{answer}\n"));
    assert_eq!(marks.len(), 1, "{}{}", said.stdout, said.stderr);
    marks.remove(0)
}

#[test]
fn answers_are_marked_in_any_unit() {
    for (header, answer) in [
        ("Mb [N*m]", "26"),
        ("Mb [N*m]", "25.3"),
        ("Mb [kN*m]", "0.026"),
        ("Mb [N*m]", "0.026 kN*m"),
        ("Mb [N*m]", "\"26,4\""),
        ("phi [deg]", "400"),
        ("phi [rad]", "0.698"),
        ("\"reaction(B, rod).x [kN]\"", "-0.5"),
    ] {
        assert_eq!(mark(header, answer).0, "right", "{header} {answer}");
    }
    assert_eq!(mark("Mb [N*m]", "").0, "missing");
    assert_eq!(mark("Mb [N*m]", "about 26").0, "unreadable");
}

#[test]
fn the_usual_slips_are_recognised() {
    for (header, answer, slip) in [
        ("Mb [N*m]", "-26", "sign"),
        ("Mb [N*m]", "26000", "factor"),
        ("Mb [N*m]", "0.026", "factor"),
        ("Mb [N*m]", "-0.0262", "factor"),
        ("phi [deg]", "0.698", "factor"),
        ("w [rad/s]", "143.2", "factor"),
        ("\"reaction(B, rod).x [N]\"", "500", "other link"),
        ("\"reaction(B, rod).x [N]\"", "120", "other component"),
        ("\"reaction(B, rod).y [N]\"", "514.2", "magnitude"),
        ("Mb [N*m]", "77", "other quantity"),
        ("Mb [N*m]", "31.1", "other row"),
        ("Mb [N*m]", "24.6", "near"),
        ("Mb [N*m]", "39", ""),
    ] {
        assert_eq!(mark(header, answer), ("wrong".to_owned(), slip.to_owned()), "{header} {answer}");
    }
}

#[test]
fn marks_are_added_up_per_row_and_quantity() {
    let answers = "student,row,Mb [N*m],phi [deg]\nAnna,1,26,40\nBo,2,-31,\n";
    let (said, marks) = marks(answers);
    assert_eq!(said.status, 1);
    let verdicts: Vec<&str> = marks.iter().map(|m| m.0.as_str()).collect();
    assert_eq!(verdicts, ["right", "right", "wrong", "missing"]);
    let folder = Folder::new("totals").with("key.csv", KEY).with("a.csv", answers);
    let said = assur(&folder, &["grade", "key.csv", "a.csv"]);
    for part in [
        "2 of 4 right, within 3 %",
        "row 2, pose 1, Bo",
        "right but for the sign",
        "missing",
        "2 of 2",
        "0 of 2",
        "1 of 2",
    ] {
        assert!(said.stdout.contains(part), "{part}: {}", said.stdout);
    }
    let said = assur(&folder, &["grade", "key.csv", "a.csv", "--format", "json"]);
    assert!(
        said.stdout.starts_with("{\"schema\":\"assur.grade/1\",\"within\":0.03,\"right\":2,\"total\":4,"),
        "{}",
        said.stdout
    );
    let said = assur(&folder, &["grade", "key.csv", "a.csv", "--within", "5"]);
    assert_eq!(said.status, 2);
}

#[test]
fn a_row_that_nobody_answered_is_listed() {
    let folder = Folder::new("nobody").with("key.csv", KEY).with("a.csv", "row,Mb [N*m]\n1,26\n");
    let said = assur(&folder, &["grade", "key.csv", "a.csv"]);
    assert_eq!(said.status, 1);
    assert!(said.stdout.contains("no answers for row 2"), "{}", said.stdout);
    assert!(said.stdout.contains("1 of 1 right"), "{}", said.stdout);
}
