//! Labels of marks, and slips of angles: the case of tests/cases/use3/sheets, and at random.

use super::{graded, graded_bytes};
use crate::run::{Folder, assur, column, rows};
use proptest::prelude::*;
use serde_json::Value;

const KEY: &str = include_str!("../../cases/use3/sheets/key.csv");
const ANSWERS: &str = include_str!("../../cases/use3/sheets/answers.csv");

#[test]
fn a_label_has_the_whole_name_and_the_file_without_its_folder() {
    let whole = "Firstname Of-Considerable-Breadth, 1-slider-crank, row 2, variant A2, pose 1";
    let said = graded(KEY, ANSWERS, &[]);
    assert!(said.stdout.contains(&format!("{whole}  psi         ")), "{}", said.stdout);
    assert!(said.stdout.contains("wrong: the supplement: 180° less the angle"), "{}", said.stdout);
    assert!(!said.stdout.contains("autumn-term"), "{}", said.stdout);
    for format in ["markdown", "latex"] {
        let said = graded(KEY, ANSWERS, &["--format", format]);
        assert!(said.stdout.contains(whole), "{}", said.stdout);
    }
    let said = graded(KEY, ANSWERS, &["--format", "csv"]);
    let (slips, students) = (column(&said.stdout, "slip"), column(&said.stdout, "student"));
    assert_eq!(&slips[..4], ["", "", "supplement", "sign"]);
    assert_eq!(students[2], "Firstname Of-Considerable-Breadth");
    let said = graded(KEY, ANSWERS, &["--format", "json"]);
    let json: Value = serde_json::from_str(&said.stdout).unwrap();
    assert_eq!(json["rows"][1]["student"], "Firstname Of-Considerable-Breadth");
    assert_eq!(json["rows"][1]["marks"][0]["slip"], "supplement");
}

#[test]
fn files_of_one_name_are_told_apart() {
    let key = "file,row,x [mm]\na/crank.mech,1,10\nb/crank.mech,1,20\nb/rocker.mech,1,30\n";
    let answers = "problem,row,x [mm]\na/crank.mech,1,15\nb/crank.mech,1,15\nrocker,1,15\n";
    let said = graded(key, answers, &[]);
    for label in ["  a/crank.mech, row 1  x", "  b/crank.mech, row 1  x", "  rocker, row 1        x"] {
        assert!(said.stdout.contains(label), "{label}: {}", said.stdout);
    }
}

#[test]
fn points_beyond_all_marks_are_refused() {
    let key = "row,Mb [N*m]\npoints,1e308\n1,26\n";
    let said = graded(key, "row,Mb [N*m]\n1,26\n", &[]);
    assert_eq!(said.status, 2, "{}", said.stdout);
    assert!(said.stderr.contains("`1e308` points are more than 1e9"), "{}", said.stderr);
    let said = graded(KEY, ANSWERS, &["--points", "*=1e308"]);
    assert_eq!(said.status, 2);
    assert!(said.stderr.contains("1e9 points at most"), "{}", said.stderr);
}

/// A table longer than one part of the report: all rows are there, once.
#[test]
fn long_tables_are_printed_in_parts() {
    let lines: String = (0..10_050).map(|i| format!("s{i},1,{},40\n", 26 + i % 2)).collect();
    let answers = format!("student,row,Mb [N*m],phi [deg]\n{lines}");
    let folder = Folder::new("parts").with("key.csv", "row,Mb [N*m],phi [deg]\n1,26,40\n");
    folder.write_bytes("a.csv", answers.as_bytes());
    let said = assur(&folder, &["grade", "key.csv", "a.csv"]);
    for i in [0, 1, 9_999, 10_000, 10_049] {
        let row = format!("  s{i}, row 1");
        let lines = said.stdout.lines().filter(|l| l.starts_with(&row));
        // of two blocks of columns where it is wrong
        assert_eq!(lines.count(), 1 + 2 * (i % 2), "{row}");
        assert_eq!(said.stdout.lines().filter(|l| l.starts_with(&format!("  s{i} "))).count(), 1);
    }
    assert_eq!(said.stdout.lines().filter(|l| l.trim() == "Students").count(), 1);
}

fn rounded(x: f64) -> String {
    format!("{x:.2}")
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(crate::share::part(12)) })]

    /// The supplement and the opposite of an angle are called that, also where another row has just this value.
    #[test]
    fn supplements_and_opposites_are_named(angles in prop::collection::vec(6.0..174.0_f64, 4..12), turns in -1_i32..2) {
        let mut key = "row,psi [deg]\n".to_owned();
        let (mut supplements, mut opposites) = ("row,psi [deg]\n".to_owned(), "row,psi [deg]\n".to_owned());
        let mut wanted = Vec::new();
        for (i, angle) in angles.iter().enumerate().filter(|(_, a)| (*a - 90.0).abs() > 8.0) {
            let angle = if i % 3 == 0 { -angle } else { *angle };
            let (own, turned) = (2 * i + 1, 360.0 * f64::from(turns));
            let supplement = 180.0 - angle;
            key += &format!("{own},{}\n{},{}\n", rounded(angle), own + 1, rounded(supplement));
            supplements += &format!("{own},{}\n", rounded(supplement + turned));
            opposites += &format!("{own},{}\n", rounded(angle + 180.0 + turned));
            wanted.push(own.to_string());
        }
        for (answers, slip) in [(supplements, "supplement"), (opposites, "opposite-direction")] {
            let said = graded(&key, &answers, &["--only-answered", "--format", "csv"]);
            let marks: Vec<(String, String)> = rows(&said.stdout).into_iter().filter(|r| r[0] == "answer").map(|mut r| (r.swap_remove(2), r.swap_remove(14))).collect();
            let all: Vec<(String, String)> = wanted.iter().map(|row| (row.clone(), slip.to_owned())).collect();
            prop_assert_eq!(marks, all, "{}", answers);
        }
    }

    /// Names with signs that CSV, Markdown, LaTeX or HTML read: whole in every format.
    #[test]
    fn any_name_of_a_student_is_whole(words in prop::collection::vec("[A-Za-zÄß\"'<>&,;|*_#$%{}\\\\ЖΩ王-]{1,24}", 1..4)) {
        let name = words.join(" ");
        prop_assume!(!name.starts_with(['-', '\'', '"', '=', '+', '@']));
        let answers = format!("student,row,Mb [N*m]\n\"{}\",1,99\n", name.replace('"', "\"\""));
        let key = "row,Mb [N*m]\n1,26\n2,31\n";
        let said = graded_bytes(key, answers.as_bytes(), &[]);
        let label = format!("  {name}, row 1  Mb ");
        prop_assert!(said.stdout.contains(&label), "{}\n{}", label, said.stdout);
        let csv = graded_bytes(key, answers.as_bytes(), &["--format", "csv"]).stdout;
        let of_csv = &column(&csv, "student")[0];
        prop_assert_eq!(of_csv, &name);
        let json: Value = serde_json::from_str(&graded_bytes(key, answers.as_bytes(), &["--format", "json"]).stdout).unwrap();
        prop_assert_eq!(json["rows"][0]["student"].as_str(), Some(name.as_str()));
        let markdown = graded_bytes(key, answers.as_bytes(), &["--format", "markdown"]).stdout;
        prop_assert_eq!(markdown.replace('\\', "").matches(&name.replace('\\', "")).count() >= 2, true, "{}", markdown);
    }
}
