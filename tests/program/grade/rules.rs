//! The rules of marking, one test each.

use super::{graded, snapshot};
use crate::run::{column, rows};

const KEY: &str = "file,row,pose,Mb [N*m],F_A [N],z [mm]
p1.mech,1,1,26,-500,0
p1.mech,1,2,27,-510,0
p1.mech,2,1,31,-620,0
p1.mech,2,2,32,-630,0
p2.mech,1,1,11,,
p2.mech,2,1,12,,
";
/// One problem with one position.
const SHORT: &str = "row,Mb [N*m],F_A [N]\n1,26,-500\n2,31,-620\n";

/// `right of total, points of possible` of every student, with the name.
fn students(key: &str, answers: &str, more: &[&str]) -> Vec<String> {
    let said = graded(key, answers, &[more, &["--format", "csv"]].concat());
    sums(&said.stdout, "student", "student")
}

/// The same of any record.
fn sums(csv: &str, record: &str, name: &str) -> Vec<String> {
    let cells = |what: &str| column(csv, what);
    let (records, names) = (cells("record"), cells(name));
    let (right, total, points, possible) =
        (cells("right"), cells("total"), cells("points"), cells("possible"));
    let of = (0..records.len()).filter(|i| records[*i] == record);
    of.map(|i| format!("{} {}/{} {}/{}", names[i], right[i], total[i], points[i], possible[i])).collect()
}

#[test]
fn missing_answers_are_wrong_unless_only_answers_count() {
    let answers = "student,row,Mb [N*m],F_A [N]\nAnna,1,26,\nBo,2,,\n";
    assert_eq!(students(SHORT, answers, &[]), ["Anna 1/2 1/2", "Bo 0/2 0/2"]);
    assert_eq!(students(SHORT, answers, &["--only-answered"]), ["Anna 1/1 1/1", "Bo 0/0 0/0"]);
    // a column that is not there is missing too
    let answers = "student,row,Mb [N*m]\nAnna,1,26\n";
    assert_eq!(students(SHORT, answers, &[]), ["Anna 1/2 1/2"]);
    let said = graded(SHORT, answers, &[]);
    snapshot("no-column", &said.stdout);
    assert_eq!(students(SHORT, answers, &["--points", "Mb=1,*=0"]), ["Anna 1/1 1/1"]);
    assert_eq!(students(SHORT, answers, &["--only-answered"]), ["Anna 1/1 1/1"]);
    // and so is what cannot be read, but that is an answer
    let answers = "student,row,Mb [N*m],F_A [N]\nAnna,1,26,=1+1\n";
    assert_eq!(students(SHORT, answers, &["--only-answered"]), ["Anna 1/2 1/2"]);
}

#[test]
fn without_students_the_whole_key_is_asked() {
    let said = graded(SHORT, "row,Mb [N*m],F_A [N]\n1,26,-500\n", &[]);
    assert_eq!(said.status, 1);
    assert!(said.stdout.starts_with("2 of 4 right, 2 of 4 points, within 3 %\n"), "{}", said.stdout);
    assert!(said.stdout.contains("  - nobody answered row 2\n"), "{}", said.stdout);
    let said = graded(SHORT, "row,Mb [N*m],F_A [N]\n1,26,-500\n", &["--only-answered"]);
    assert_eq!(said.status, 0, "what is there is right");
    assert!(said.stdout.starts_with("2 of 2 right"), "{}", said.stdout);
    assert!(said.stdout.contains("nobody answered row 2"), "{}", said.stdout);
}

#[test]
fn a_student_answers_one_variant_of_every_problem_in_all_positions() {
    // Anna left out a position; Bo the second problem; Cy the first, with another variant of nothing to go by
    let answers = "student,problem,row,pose,Mb [N*m],F_A [N],z [mm]\nAnna,p1,1,1,26,-500,0\nAnna,P2,1,1,11,,\n\
                   Bo,p1,2,1,31,-620,0\nBo,p1,2,2,32,-630,0\nCy,p2,2,1,12,,\n";
    let all = ["Anna 4/7 4/7", "Bo 6/7 6/7", "Cy 1/7 1/7"];
    assert_eq!(students(KEY, answers, &[]), all);
    let said = graded(KEY, answers, &["--format", "csv"]);
    assert_eq!(sums(&said.stdout, "problem", "file"), ["p1.mech 9/18 9/18", "p2.mech 2/3 2/3"]);
    assert_eq!(sums(&said.stdout, "total", "record"), ["total 11/21 11/21"]);
    let hints = rows(&said.stdout);
    let missing: Vec<&str> =
        hints.iter().filter(|r| r[0] == "not answered").map(|r| r[15].as_str()).collect();
    let [anna, bo, cy, again] = missing[..] else { panic!("{missing:?}") };
    assert_eq!(anna, "Anna, p1, row 1, pose 2");
    assert_eq!(bo, "Bo, p2, row 2, pose 1");
    assert_eq!([cy, again], ["Cy, p1, row 2, pose 1", "Cy, p1, row 2, pose 2"]);
    assert_eq!(students(KEY, answers, &["--only-answered"]), ["Anna 4/4 4/4", "Bo 6/6 6/6", "Cy 1/1 1/1"]);
}

#[test]
fn where_nothing_tells_the_variant_its_key_is_not_shown() {
    let answers = "student,problem,row,pose,Mb [N*m]\nAnna,p1,9,1,26\nBo,p1,1,1,26\n";
    let said = graded(KEY, answers, &["--format", "csv"]);
    assert_eq!(sums(&said.stdout, "student", "student"), ["Anna 0/7 0/7", "Bo 1/7 1/7"]);
    for row in rows(&said.stdout).iter().filter(|r| r[0] == "answer" && r[5] == "Anna") {
        assert_eq!((row[2].as_str(), row[10].as_str()), ("", ""), "{row:?}");
    }
    assert!(said.stderr.contains("line 2: the key has no file p1, row 9, pose 1 (Anna)"), "{}", said.stderr);
}

#[test]
fn a_key_with_students_says_who_is_asked_what() {
    let key = "student,row,pose,Mb [N*m]\nAnna,1,1,26\nAnna,1,2,27\nBo,1,3,28\nCy,1,1,26\n";
    let answers = "student,row,pose,Mb [N*m]\nAnna,1,1,26\nBo,,,28\nBo,1,1,26\n";
    assert_eq!(students(key, answers, &[]), ["Anna 1/2 1/2", "Bo 1/1 1/1", "Cy 0/1 0/1"]);
    let said = graded(key, answers, &[]);
    assert!(said.stdout.contains("  - line 4: the key has no row 1, pose 1 (Bo)\n"), "{}", said.stdout);
}

#[test]
fn points_are_in_the_key_or_on_the_command_line() {
    let answers = "student,row,Mb [N*m],F_A [N]\nAnna,1,26,1\nBo,2,1,-620\n";
    let key = SHORT.replace("1,26", "points,2,0.5\n1,26");
    assert_eq!(students(&key, answers, &[]), ["Anna 1/2 2/2.5", "Bo 1/2 0.5/2.5"]);
    assert_eq!(students(&key, answers, &["--points", "F_A=3"]), ["Anna 1/2 2/5", "Bo 1/2 3/5"]);
    assert_eq!(students(SHORT, answers, &["--points", "Mb=4"]), ["Anna 1/2 4/5", "Bo 1/2 1/5"]);
    assert_eq!(students(SHORT, answers, &["--points", "Mb=4, *=0"]), ["Anna 1/1 4/4", "Bo 0/1 0/4"]);
    // an empty cell in the row of points has none, and what has none is not asked
    let key = SHORT.replace("1,26", "Points,2,\n1,26");
    assert_eq!(students(&key, answers, &[]), ["Anna 1/1 2/2", "Bo 0/1 0/2"]);
    // of each problem its own
    let key = KEY.replace("p1.mech,1,1", "p2.mech,points,,5,,\n,points,,1,2,0\np1.mech,1,1");
    let answers = "student,problem,row,pose,Mb [N*m],F_A [N]\nAnna,p1,1,1,26,-500\nAnna,p2,1,,11,\n";
    assert_eq!(students(&key, answers, &[]), ["Anna 3/5 8/11"]);
}

#[test]
fn points_for_what_is_not_there_are_refused() {
    let answers = "row,Mb [N*m]\n1,26\n";
    let said = graded(SHORT, answers, &["--points", "M_b=2"]);
    assert_eq!((said.status, said.stdout.as_str()), (2, ""));
    assert!(said.stderr.contains("`--points`: the key has no `M_b`"), "{}", said.stderr);
    assert!(said.stderr.contains("did you mean `Mb`?"), "{}", said.stderr);
    for wrong in ["Mb", "Mb=", "Mb=-1", "Mb=x", "=2", "Mb=inf"] {
        let said = graded(SHORT, answers, &["--points", wrong]);
        assert_eq!(said.status, 2, "{wrong}");
        assert!(said.stderr.contains("write NAME=POINTS"), "{wrong}: {}", said.stderr);
    }
    // commas in a name
    let key = "row,\"reaction(B, rod).x [N]\",Mb [N*m]\n1,5,2\n";
    let answers = "row,\"reaction(B, rod).x [N]\",Mb [N*m]\n1,5,9\n";
    let said = graded(key, answers, &["--points", "reaction(B, rod).x=3,Mb=2"]);
    assert!(said.stdout.contains("3 of 5 points"), "{}{}", said.stdout, said.stderr);
}

#[test]
fn slips_have_credit_only_where_the_teacher_gives_it() {
    let answers = "student,row,Mb [N*m],F_A [N]\nAnna,1,-26,-0.5\nBo,2,-62,0.62\n";
    assert_eq!(students(SHORT, answers, &[]), ["Anna 0/2 0/2", "Bo 0/2 0/2"]);
    let credit = ["--credit", "sign=0.5,unit=25%"];
    assert_eq!(students(SHORT, answers, &credit), ["Anna 0/2 0.75/2", "Bo 0/2 0.125/2"]);
    let credit = ["--credit", "unit=0.25", "--credit", "half=1", "--points", "F_A=2"];
    // the opposite sign has no credit, and nothing has it together with one
    assert_eq!(students(SHORT, answers, &credit), ["Anna 0/2 0.5/3", "Bo 0/2 0/3"]);
    for (wrong, says) in [
        ("sing=0.5", "`sing` is not a slip; these are: sign, other-link, unit"),
        ("sign=2", "the credit for `sign` is a part from 0 to 1"),
        ("sign", "write SLIP=PART"),
    ] {
        let said = graded(SHORT, answers, &["--credit", wrong]);
        assert!(said.status == 2 && said.stderr.contains(says), "{wrong}: {}", said.stderr);
    }
}

#[test]
fn one_submission_of_a_row_counts() {
    let answers = "student,row,Mb [N*m],F_A [N]\nAnna,1,26,1\nAnna,1,26,-500\nAnna,01,1,1\nBo,2,31,-620\n";
    assert_eq!(students(SHORT, answers, &[]), ["Anna 0/2 0/2", "Bo 2/2 2/2"]);
    assert_eq!(students(SHORT, answers, &["--submissions", "last"]), ["Anna 0/2 0/2", "Bo 2/2 2/2"]);
    assert_eq!(students(SHORT, answers, &["--submissions", "first"]), ["Anna 1/2 1/2", "Bo 2/2 2/2"]);
    assert_eq!(students(SHORT, answers, &["--submissions", "best"]), ["Anna 2/2 2/2", "Bo 2/2 2/2"]);
    let said = graded(SHORT, answers, &["--submissions", "best"]);
    snapshot("submissions", &said.stdout);
}

#[test]
fn columns_and_rows_that_are_not_in_the_key_are_reported() {
    let answers = "Student;Surname;e-mail;Row;Mb [N*m];F_A [N];;Mark (%);Mb [kN*m]\n\
                   Anna;Berg;a@x.example;1;26;-500;;;\nBo;Lund;;9;31;-620;x;;\nCy;Moe;;2;31;-620;;;0,031\n";
    let said = graded(SHORT, answers, &[]);
    assert_eq!(said.status, 1, "{}", said.stdout);
    assert_eq!(said.stderr.matches('⚠').count(), 5, "{}", said.stderr);
    snapshot("not-in-the-key", &said.stdout);
    // columns alone are no reason to fail
    let said = graded(SHORT, "student,e-mail,row,Mb [N*m],F_A [N]\nAnna,a@x,1,26,-500\n", &[]);
    assert_eq!(said.status, 0, "{}{}", said.stdout, said.stderr);
    // where nothing can be marked the file cannot be used
    for nothing in ["student,row,Mc [N*m]\nAnna,1,26\n", "student,row,Mb [N*m]\nAnna,9,26\n,1,26\n"] {
        let said = graded(SHORT, nothing, &[]);
        assert_eq!((said.status, said.stdout.as_str()), (2, ""), "{nothing}");
        assert!(said.stderr.contains('×'), "{}", said.stderr);
    }
    // a unit that does not fit is the teacher's to mend: all would be wrong
    for wrong in [
        "row,Mb [N]\n1,26\n",
        "row,Mb (N*m)\n1,26\n",
        "row,Mb [N*m],Mb [N*m]\n1,2,3\n",
        "row,Row,Mb [N*m]\n1,1,2\n",
    ] {
        assert_eq!(graded(SHORT, wrong, &[]).status, 2, "{wrong}");
    }
}

#[test]
fn rows_are_found_by_names_that_are_alike() {
    let key = "problem,variant,Mb [N*m]\nhomework/01-engine.mech,A.1,26\nhomework/01-engine.mech,A.2,31\n\
               homework/02-press.mech,A.1,11\n";
    for (row, answer) in [
        ("1,A.2", "31"),
        ("01-engine,a.2", "31"),
        ("01-Engine.mech,A.2", "31"),
        ("2,A.1", "11"),
        ("2,", "11"),
    ] {
        let answers = format!("file,variant,Mb [N*m]\n{row},{answer}\n");
        let said = graded(key, &answers, &["--only-answered"]);
        assert_eq!(said.status, 0, "{row}: {}{}", said.stdout, said.stderr);
    }
    for (row, says) in [
        ("1,", "write the variant into this row"),
        ("3,A.1", "it has files homework/01-engine.mech"),
        ("1,A.3", "it has variants A.1, A.2"),
    ] {
        let said = graded(key, &format!("file,variant,Mb [N*m]\n{row},1\n"), &[]);
        let words = said.stderr.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(said.status == 2 && words.contains(says), "{row}: {}", said.stderr);
    }
}

#[test]
fn a_key_of_zero_has_no_part_to_be_off_by() {
    let answers = "problem,row,pose,Mb [N*m],F_A [N],z [mm]\np1,1,1,26,-500,0.5\n";
    let said = graded(KEY, answers, &["--only-answered", "--format", "csv"]);
    let cells = rows(&said.stdout);
    let row = cells.iter().find(|r| r[7] == "z").unwrap();
    assert_eq!((&*row[11], &*row[12], &*row[13], &*row[15]), ("", "0.5", "wrong", "key is 0"));
    let said = graded(KEY, answers, &["--only-answered"]);
    assert!(!said.stdout.contains("inf"), "{}", said.stdout);
    snapshot("key-is-0", &said.stdout);
}

#[test]
fn answers_that_are_not_asked_are_reported_and_do_not_count() {
    let answers = "student,problem,row,Mb [N*m],F_A [N]\nAnna,p2,1,11,3\nBo,p2,2,12,x\n";
    let said = graded(KEY, answers, &["--only-answered", "--format", "csv"]);
    assert_eq!(sums(&said.stdout, "student", "student"), ["Anna 1/1 1/1", "Bo 1/1 1/1"]);
    let verdicts = column(&said.stdout, "verdict");
    assert_eq!(verdicts.iter().filter(|v| *v == "not asked").count(), 2);
    assert_eq!(said.status, 0);
}

#[test]
fn the_edge_of_the_tolerance_is_within_it() {
    let key = "row,a [N],b [N],c [N]\n1,1,0.7,300\n";
    let said = graded(key, "row,a [N],b [N],c [N]\n1,1.03,0.721,291\n", &[]);
    assert_eq!(said.status, 0, "{}", said.stdout);
}

/// The tables of the page, as a teacher copies them.
#[test]
fn the_example_of_the_reference_is_marked() {
    let page = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/teaching.md");
    let page = std::fs::read_to_string(page).unwrap();
    let section = page.split("\n### grade\n").nth(1).unwrap().split("\n## ").next().unwrap();
    let tables: Vec<&str> =
        section.split("```csv\n").skip(1).map(|part| part.split("```").next().unwrap()).collect();
    let [answers, key] = tables[..] else { panic!("{tables:?}") };
    let said = graded(key, answers, &["--credit", "sign=0.5,unit=0.25"]);
    assert_eq!(said.status, 0, "{}", said.stderr);
    snapshot("reference", &said.stdout);
    let said = graded(key, answers, &["--submissions", "first", "--credit", "sign=0.5,unit=0.25"]);
    assert!(said.stdout.starts_with("2 of 4 right, 4 of 6 points, within 3 %\n"), "{}", said.stdout);
}
