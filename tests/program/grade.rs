//! `assur grade`, as run from a shell.

#![allow(clippy::unwrap_used)] // a test that cannot write its files has failed

mod class;
mod labels;
mod rules;

use crate::run::{Folder, Said, assur, column};

const KEY: &str =
    "row,pose,Mb [N*m],\"reaction(B, rod).x [N]\",\"reaction(B, rod).y [N]\",phi [deg],w [rad/s],Mc [N*m]
1,1,26,-500,120,40,15,77
2,1,31,-620,150,55,12,88
";

/// The verdict and the slip of every answer that is there.
fn marks(answers: &str) -> (Said, Vec<(String, String)>) {
    let said = graded(KEY, answers, &["--format", "csv", "--only-answered"]);
    let records = column(&said.stdout, "record");
    let (cells, slips) = (column(&said.stdout, "verdict"), column(&said.stdout, "slip"));
    let marks = cells.into_iter().zip(slips).zip(records).filter(|(_, record)| record == "answer");
    let marks = marks.map(|(mark, _)| mark).collect();
    (said, marks)
}

fn graded(key: &str, answers: &str, more: &[&str]) -> Said {
    graded_bytes(key, answers.as_bytes(), more)
}

fn graded_bytes(key: &str, answers: &[u8], more: &[&str]) -> Said {
    let folder = Folder::new("grade").with("key.csv", key);
    folder.write_bytes("a.csv", answers);
    assur(&folder, &[&["grade", "key.csv", "a.csv"], more].concat())
}

/// What is printed is that in `grade/NAME.snap`.
fn snapshot(name: &str, text: &str) {
    insta::with_settings!({
        snapshot_path => "grade",
        prepend_module_to_snapshot => false,
        omit_expression => true,
    }, {
        insta::assert_snapshot!(name, text);
    });
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

/// Whole turns are free of a direction, not of what turns many times or is counted in turns.
#[test]
fn whole_turns_count_where_something_turns_many_times() {
    let right = |key: &str, header: &str, answer: &str| {
        let key = format!(
            "row,pose,a [{}]\n1,1,{}\n",
            key.split_once(' ').unwrap().1,
            key.split_once(' ').unwrap().0
        );
        let said =
            graded(&key, &format!("row,a [{header}]\n1,{answer}\n"), &["--format", "csv", "--within", "3 %"]);
        column(&said.stdout, "verdict")[0] == "right"
    };
    for (key, header, answer, wanted) in [
        ("79.58 rev", "rev", "79.6", true),
        ("79.58 rev", "rev", "5.2", false),
        ("79.58 rev", "rev", "-7.11", false),
        ("79.58 rev", "rev", "1000.4", false),
        ("79.58 rev", "deg", "28648.8", true),
        ("0.5 rev", "rev", "1.5", false),
        ("500 rad", "rad", "493.7168", true),
        ("50 rad", "rad", "43.7168", false),
        ("400 deg", "deg", "40", false),
        ("10 deg", "deg", "370", true),
        ("-350 deg", "deg", "10", true),
        ("360 deg", "deg", "0", true),
        // no direction is off by more than half a turn
        ("350 deg", "deg", "345", true),
        ("350 deg", "deg", "343", false),
    ] {
        assert_eq!(right(key, header, answer), wanted, "{key}: {answer} {header}");
    }
}

#[test]
fn the_usual_slips_are_recognised() {
    for (header, answer, slip) in [
        ("Mb [N*m]", "-26", "sign"),
        ("Mb [N*m]", "26000", "unit"),
        ("Mb [N*m]", "0.026", "unit"),
        ("Mb [N*m]", "-0.0262", "unit"),
        ("phi [deg]", "0.698", "unit"),
        ("w [rad/s]", "143.2", "unit"),
        ("\"reaction(B, rod).x [N]\"", "500", "other-link"),
        ("\"reaction(B, rod).x [N]\"", "120", "other-component"),
        ("\"reaction(B, rod).y [N]\"", "514.2", "magnitude"),
        ("Mb [N*m]", "77", "other-quantity"),
        ("Mb [N*m]", "31.1", "other-row"),
        ("Mb [N*m]", "24.6", "close"),
        ("Mb [N*m]", "52", "half"),
        ("Mb [N*m]", "-13", "half"),
        ("Mb [N*m]", "255", "weight"),
        ("Mb [N*m]", "2.6", "decimal-point"),
        ("Mb [N*m]", "39", ""),
        // a thousandfold of it is near 40 deg modulo a turn
        ("phi [deg]", "60.4", ""),
        ("phi [deg]", "140", "supplement"),
        ("phi [rad]", "2.443", "supplement"),
        ("phi [deg]", "-140", "opposite-direction"),
        ("phi [deg]", "220", "opposite-direction"),
        ("phi [deg]", "-40", "sign"),
        // the value of the other row: nothing simpler explains it
        ("phi [deg]", "55", "other-row"),
    ] {
        assert_eq!(mark(header, answer), ("wrong".to_owned(), slip.to_owned()), "{header} {answer}");
    }
}

#[test]
fn marks_are_added_up_per_row_and_quantity() {
    let answers = "student,row,Mb [N*m],phi [deg]\nAnna,1,26,40\nBo,2,-31,\n";
    let said = graded(KEY, answers, &["--points", "Mb=1,phi=1,*=0"]);
    assert_eq!(said.status, 1);
    snapshot("sums", &said.stdout);
    let said = graded(KEY, answers, &["--format", "json"]);
    let head = "{\"schema\":\"assur.grade/2\",\"within\":0.03,\"only_answered\":false,\"submissions\":\"last\",\
                \"credit\":{},\"right\":2,\"total\":12,\"points\":2.0,\"possible\":12.0,";
    assert!(said.stdout.starts_with(head), "{}", said.stdout);
    assert_eq!(graded(KEY, answers, &["--within", "5"]).status, 2);
}

#[test]
fn what_slips_come_to_in_words() {
    let answers = "row,Mb [N*m],w [rad/s],Mc [N*m]\n1,-52,143.2,38.5\n2,29.5,-0.012,8.63\n";
    let said = graded(KEY, answers, &["--only-answered"]);
    snapshot("slips", &said.stdout);
}

/// A key says where whole turns count; without it angles up to a turn are directions.
#[test]
fn a_row_of_the_key_says_where_turns_count() {
    let verdicts = |turns: &str| {
        let key = format!("file,row,a [deg],b [deg]\n{turns}x.mech,1,40,40\ny.mech,1,40,40\n");
        let answers = "file,row,a [deg],b [deg]\nx.mech,1,400,400\ny.mech,1,400,400\n";
        let said = graded(&key, answers, &["--format", "csv"]);
        column(&said.stdout, "verdict")[..4].join(" ")
    };
    assert_eq!(verdicts(""), "right right right right");
    assert_eq!(verdicts(",turns,,counted\n"), "right wrong right wrong");
    assert_eq!(verdicts("y.mech,turns,counted,\n"), "right right wrong right");
    // a key that is filled in is a table of answers
    let key = "row,a [deg]\nturns,counted\n1,40\n";
    assert_eq!(graded(key, key, &[]).status, 0);
    let said = graded("row,a [deg]\nturns,many\n1,40\n", "row,a [deg]\n1,40\n", &[]);
    assert!(said.stderr.contains("`many` says nothing of whole turns"), "{}", said.stderr);
}

const CYCLE: &str = "row,pose,M [N*m],J [kg*m^2],W [J]\n1,1,5,188,3712\n1,2,7,,\n1,3,9,,\n2,1,6,134,3314\n2,2,8,,\n2,3,10,,\n";

/// What a row has once is read from any line of the row, and asked once.
#[test]
fn cells_belong_to_a_place_and_not_to_a_line() {
    let summary = |answers: &str| {
        let said = graded(CYCLE, answers, &[]);
        (said.stdout.lines().next().unwrap_or_default().to_owned(), said.stdout + &said.stderr)
    };
    for answers in [
        "row,pose,M [N*m],J [kg*m^2],W [J]\n1,1,5,188,3712\n1,2,7,,\n1,3,9,,\n",
        // in the line of another position, in several, in a line without a position
        "row,pose,M [N*m],J [kg*m^2],W [J]\n1,1,5,,\n1,2,7,188,\n1,3,9,,3712\n",
        "row,pose,M [N*m],J [kg*m^2],W [J]\n1,1,5,188,3712\n1,2,7,188,3712\n1,3,9,188,3712\n",
        "row,pose,M [N*m],J [kg*m^2],W [J]\n1,,,188,3712\n1,3,9,,\n1,2,7,,\n1,1,5,,\n",
    ] {
        let (first, all) = summary(answers);
        assert!(first.starts_with("5 of 10 right"), "{answers}{all}");
    }
    let student = |answers: &str, more: &[&str]| graded(CYCLE, answers, more).stdout;
    let all = student("student,row,J [kg*m^2]\nA,1,188\nA,1,180\nA,1,150\n", &["--submissions", "best"]);
    assert!(all.starts_with("1 of 5 right"), "{all}");
    let all = student("student,row,J [kg*m^2]\nA,1,188\nA,1,150\n", &[]);
    assert!(all.starts_with("0 of 5 right"), "{all}");
    let (first, all) = summary("row,M [N*m],J [kg*m^2]\n1,5,188\n2,,134\n");
    assert!(first.starts_with("2 of 10 right"), "{all}");
    assert!(all.contains("line 2: `M` has 3 positions") && all.contains("add a column `pose`"), "{all}");
    let (_, all) = summary("row,pose,J [kg*m^2]\n1,1,188\n1,2,150\n");
    assert!(all.contains("line 3: `J` is answered otherwise in line 2"), "{all}");
}

#[test]
fn one_question_needs_no_name() {
    let key = "row,pose,n [rpm]\n1,1,120\n2,1,150\n";
    for answers in ["row,n\n1,120\n2,150\n", "row,answer\n1,120\n2,150\n", "row;Antwort\n1;120,5\n2;149,5\n"]
    {
        let said = graded(key, answers, &[]);
        assert!(said.stdout.starts_with("2 of 2 right"), "{answers}{}{}", said.stdout, said.stderr);
    }
    let said = graded(key, "row,note,answer\n1,120,120\n", &["--only-answered"]);
    assert!(said.stdout.starts_with("1 of 1 right"), "{}{}", said.stdout, said.stderr);
}

#[test]
fn answers_are_read_as_spreadsheets_write_them() {
    let key = "row,Mb [N*m],\"reaction(B, rod).x [N]\"\n1,3.71,-500\n2,4,-600\n";
    for answers in [
        "row,Mb [N*m]\n1,\"3,71\"\n2,4\n",
        "row;Mb [N*m]\r\n1;3,71\r\n2;4,0\r\n",
        "row\tMb [N*m]\n1\t3,71\n2\t4\n",
        "row;\"Mb\n[N*m]\"\n1;3,71\n2;4\n",
        "\"the row\n(1, 2; 3)\";row;Mb [N*m]\n;1;3,71\n;2;4\n",
    ] {
        let said = graded(key, answers, &["--only-answered"]);
        assert!(said.stdout.starts_with("2 of 2 right"), "{answers}{}{}", said.stdout, said.stderr);
    }
    let said = graded(key, "student,row,Mb [N*m]\n\"Berg,\nAnna\",1,3.71\nBo,2,4\n", &["--only-answered"]);
    assert!(said.stdout.starts_with("2 of 2 right") && said.stdout.contains("Berg, Anna"), "{}", said.stdout);
    // a quote too much spoils its own line
    let said = graded(key, "student,row,Mb [N*m]\nA,\"1,3.71\nB,2,4\nC,1,3.71\n", &["--only-answered"]);
    assert!(said.stdout.starts_with("2 of 2 right"), "{}{}", said.stdout, said.stderr);
    assert!(said.stderr.contains("line 2"), "{}", said.stderr);
}
