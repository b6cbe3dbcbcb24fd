//! A class of 200 students with everything that goes wrong in a table of answers: every sum against one that is reckoned
//! here, in eighths of a point, from what the students were made to do.

mod students;

use super::graded_bytes;
use crate::run::{Said, rows};
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use students::{Class, Deed, Line, POINTS, key_file};

/// The columns of quantities.
const NAMES: [&str; 5] = ["Mb", "Fx", "phi", "z", "locks"];

/// A sum, points in eighths.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Total {
    right: i64,
    total: i64,
    points: i64,
    possible: i64,
}

impl Total {
    fn add(&mut self, other: Self) {
        self.right += other.right;
        self.total += other.total;
        self.points += other.points;
        self.possible += other.possible;
    }
}

#[derive(Clone, Copy)]
struct Teacher {
    only_answered: bool,
    /// Eighths for the opposite sign and for a unit.
    credit: (i64, i64),
    /// `first`, `best` or `last`
    submissions: &'static str,
}

impl Teacher {
    /// What one answer comes to.
    fn mark(self, problem: usize, quantity: usize, deed: Deed) -> Total {
        let possible = POINTS[problem][quantity];
        if possible == 0 || self.only_answered && deed == Deed::Nothing {
            return Total::default();
        }
        let eighths = match deed {
            Deed::Right => 8,
            Deed::Sign => self.credit.0,
            Deed::Unit => self.credit.1,
            _ => 0,
        };
        Total { right: i64::from(deed == Deed::Right), total: 1, points: possible * eighths / 8, possible }
    }

    fn row(self, line: &Line) -> Total {
        let mut sum = Total::default();
        (0..5).for_each(|q| sum.add(self.mark(line.problem, q, line.deeds[q])));
        sum
    }

    /// Which of several submissions counts.
    fn choose(self, lines: &[&Line]) -> usize {
        match self.submissions {
            "first" => 0,
            "last" => lines.len() - 1,
            _ => {
                let mut best = 0;
                for i in 1..lines.len() {
                    if self.row(lines[i]).points >= self.row(lines[best]).points {
                        best = i;
                    }
                }
                best
            }
        }
    }
}

/// What is to come out.
#[derive(Default)]
struct Expected {
    students: BTreeMap<String, Total>,
    problems: [Total; 2],
    quantities: [Total; 5],
    class: Total,
    not_counted: BTreeSet<usize>,
}

fn expected(class: &Class, teacher: Teacher) -> Expected {
    let mut all = Expected::default();
    for student in &class.students {
        let mut deeds: Vec<(usize, [Deed; 5])> = Vec::new();
        for (problem, pose) in [(0, 1), (0, 2), (1, 1)] {
            let own = |l: &&Line| l.student == *student && (l.problem, l.pose) == (problem, pose);
            let lines: Vec<&Line> = class.lines.iter().filter(own).collect();
            if lines.is_empty() {
                deeds.push((problem, [Deed::Nothing; 5]));
                continue;
            }
            let counts = teacher.choose(&lines);
            all.not_counted
                .extend(lines.iter().enumerate().filter(|(i, _)| *i != counts).map(|(_, l)| l.number));
            deeds.push((problem, lines[counts].deeds));
        }
        let is_there = class.lines.iter().any(|l| l.student == *student);
        if teacher.only_answered && !is_there {
            continue;
        }
        let mut own = Total::default();
        for (problem, deeds) in deeds {
            for (q, deed) in deeds.into_iter().enumerate() {
                let mark = teacher.mark(problem, q, deed);
                own.add(mark);
                all.problems[problem].add(mark);
                all.quantities[q].add(mark);
            }
        }
        all.class.add(own);
        all.students.insert(student.clone(), own);
    }
    all
}

/// A sum as it is printed: points in eighths.
fn printed(row: &[String]) -> Total {
    let eighths = |text: &str| {
        let x = text.parse::<f64>().unwrap() * 8.0;
        assert_eq!(x, x.round(), "{row:?}");
        x as i64
    };
    let whole = |text: &str| text.parse().unwrap();
    Total {
        right: whole(&row[16]),
        total: whole(&row[17]),
        points: eighths(&row[18]),
        possible: eighths(&row[19]),
    }
}

fn said(class: &Class, teacher: Teacher, format: &str) -> Said {
    let (sign, unit) = teacher.credit;
    let credit = format!("sign={},unit={}%", sign as f64 / 8.0, unit as f64 * 12.5);
    let mut more = vec!["--submissions", teacher.submissions, "--credit", &credit, "--format", format];
    more.extend(teacher.only_answered.then_some("--only-answered"));
    graded_bytes(&key_file(), &class.bytes, &more)
}

const TEACHERS: [Teacher; 4] = [
    Teacher { only_answered: false, credit: (0, 0), submissions: "last" },
    Teacher { only_answered: false, credit: (4, 2), submissions: "best" },
    Teacher { only_answered: true, credit: (0, 0), submissions: "first" },
    Teacher { only_answered: true, credit: (8, 4), submissions: "last" },
];

#[test]
fn every_sum_is_what_it_is_by_another_reckoning() {
    let class = Class::new();
    assert!(class.lines.len() > 500 && class.bad.len() > 15, "{} {}", class.lines.len(), class.bad.len());
    for teacher in TEACHERS {
        let expected = expected(&class, teacher);
        let said = said(&class, teacher, "csv");
        assert_eq!(said.status, 1, "{}", said.stderr);
        let rows = rows(&said.stdout);
        let of = |record: &str| -> Vec<&Vec<String>> { rows.iter().filter(|r| r[0] == record).collect() };
        let students: BTreeMap<String, Total> =
            of("student").into_iter().map(|r| (r[5].clone(), printed(r))).collect();
        assert_eq!(students, expected.students);
        let problems: Vec<Total> = of("problem").into_iter().map(|r| printed(r)).collect();
        assert_eq!(problems, expected.problems);
        for row in of("quantity") {
            let q = NAMES.iter().position(|name| *name == row[7]).unwrap();
            assert_eq!(printed(row), expected.quantities[q], "{}", row[7]);
        }
        assert_eq!(printed(of("total")[0]), expected.class);
        every_line_is_there(&class, &expected, &rows);
    }
}

/// Every line of the table that is not blank is marked, not counted or reported.
fn every_line_is_there(class: &Class, expected: &Expected, rows: &[Vec<String>]) {
    let lines = |records: &[&str]| -> BTreeSet<usize> {
        let of = rows.iter().filter(|r| records.contains(&r[0].as_str()) && !r[6].is_empty());
        of.map(|r| r[6].parse().unwrap()).collect()
    };
    let aside = lines(&["not counted row"]);
    assert_eq!(aside, expected.not_counted);
    let mut unmarked = class.bad.clone();
    unmarked.insert(1); // columns
    assert_eq!(lines(&["not marked"]), unmarked);
    let marked: BTreeSet<usize> =
        class.lines.iter().map(|l| l.number).filter(|n| !aside.contains(n)).collect();
    assert_eq!(lines(&["row"]), marked);
    for (line, deeds) in class.lines.iter().map(|l| (l.number, l.deeds)) {
        let of = rows.iter().filter(|r| matches!(r[0].as_str(), "answer" | "not counted"));
        let nonsense = of.filter(|r| r[6] == line.to_string() && r[13] == "unreadable").count();
        assert_eq!(nonsense, deeds.iter().filter(|d| **d == Deed::Nonsense).count(), "line {line}");
    }
}

#[test]
fn all_formats_have_the_same_sums() {
    let class = Class::new();
    let teacher = TEACHERS[1];
    let expected = expected(&class, teacher);
    let json = said(&class, teacher, "json");
    let value: Value = serde_json::from_str(&json.stdout).unwrap();
    let total = |v: &Value| {
        let whole = |what: &str| v[what].as_i64().unwrap();
        let eighths = |what: &str| (v[what].as_f64().unwrap() * 8.0) as i64;
        Total {
            right: whole("right"),
            total: whole("total"),
            points: eighths("points"),
            possible: eighths("possible"),
        }
    };
    assert_eq!(total(&value), expected.class);
    let students: Vec<Total> = value["students"].as_array().unwrap().iter().map(total).collect();
    let in_order: Vec<Total> = class.students.iter().map(|s| expected.students[s]).collect();
    assert_eq!(students, in_order);
    let parts: Vec<f64> = in_order.iter().map(|t| t.points as f64 / t.possible as f64).collect();
    let mean = parts.iter().sum::<f64>() / parts.len() as f64;
    assert!((value["mean"].as_f64().unwrap() - mean).abs() < 1e-12);
    let problems: Vec<Total> = value["problems"].as_array().unwrap().iter().map(total).collect();
    assert_eq!(problems, expected.problems);
    assert_eq!(value["not_counted"].as_array().unwrap().len(), expected.not_counted.len());
    // a header without a name, the address, the remarks
    assert_eq!(value["diagnostics"].as_array().unwrap().len(), class.bad.len() + 3);
    crate::schema::fits_schema("grade-2.json", &value);
    let text = said(&class, teacher, "table");
    let points = |t: Total| format!("{} of {}", t.points as f64 / 8.0, t.possible as f64 / 8.0);
    let Total { right, total, .. } = expected.class;
    let title = format!("{right} of {total} right, {} points, within 3 %\n", points(expected.class));
    assert!(text.stdout.starts_with(&title), "{title}: {}", &text.stdout[..200]);
    let table = text.stdout.split("\nStudents\n").nth(1).unwrap().split("\n\n").next().unwrap();
    let lines: Vec<&str> = table.lines().skip(2).collect();
    assert_eq!(lines.len(), in_order.len());
    for (line, sum) in lines.iter().zip(&in_order) {
        let sums = format!("  {} of {}  ", sum.right, sum.total);
        assert!(line.contains(&sums) && line.contains(&points(*sum)), "{line}: {sum:?}");
    }
    for said in [json, text] {
        let plain = |c: char| !c.is_control() || matches!(c, '\n' | '\r');
        assert!(said.stdout.chars().all(plain) && said.stderr.chars().all(plain), "no command to a terminal");
    }
}
