//! What is asked where is the same in keys, tables, sheets, grades and courses.

#![allow(clippy::unwrap_used)] // a test that cannot read what was written has failed

use crate::run::{Folder, assur, rows};
use crate::share;
use std::path::{Path, PathBuf};

/// The columns of a key that are questions, and its lines of the first row: the position, and which columns have a value.
struct Key {
    columns: usize,
    /// Components of vectors count apart.
    lines: Vec<(String, Vec<bool>)>,
    /// How many of them are numbers.
    numbers: usize,
}

impl Key {
    fn of(text: &str) -> Self {
        let all = rows(text);
        let (row, pose) = (place(&all[0], "row").unwrap(), place(&all[0], "pose").unwrap());
        let first = pose + 1;
        let is_first = |cells: &&Vec<String>| cells[row] == "1";
        let lines: Vec<&Vec<String>> = all[1..].iter().filter(is_first).collect();
        let numbers =
            lines.iter().flat_map(|cells| &cells[first..]).filter(|cell| cell.parse::<f64>().is_ok()).count();
        let filled = |cells: &&Vec<String>| {
            (cells[pose].clone(), cells[first..].iter().map(|cell| !cell.is_empty()).collect())
        };
        Self { columns: all[0].len() - first, lines: lines.iter().map(filled).collect(), numbers }
    }

    /// How many cells a sheet has: every column in every line where any line has it, but what is asked once in one.
    fn cells(&self) -> usize {
        if self.lines.len() == 1 {
            return self.columns;
        }
        let is_whole = |column: usize| {
            self.lines[0].0.is_empty()
                && self.lines.iter().all(|(pose, cells)| pose.is_empty() == cells[column])
        };
        let whole = (0..self.columns).filter(|column| is_whole(*column)).count();
        let positions = self.lines.iter().filter(|(pose, _)| !pose.is_empty()).count();
        whole + (self.columns - whole) * positions
    }

    /// Every question has an answer.
    fn is_full(&self) -> bool {
        self.cells() == self.lines.iter().flat_map(|(_, cells)| cells).filter(|filled| **filled).count()
    }
}

fn examples() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let folders = std::fs::read_dir(folder).unwrap().flatten().map(|entry| entry.path());
    let files =
        folders.filter(|path| path.is_dir()).flat_map(|path| std::fs::read_dir(path).unwrap().flatten());
    let mut files: Vec<PathBuf> = files.map(|entry| entry.path()).collect();
    files.retain(|path| path.extension().is_some_and(|e| e == "mech"));
    files.sort();
    files
}

fn place(headers: &[String], name: &str) -> Option<usize> {
    headers.iter().position(|header| header == name)
}

/// Where a column has values: rows and positions, but those of events.
fn places(table: &[Vec<String>], header: &str) -> Vec<(String, String)> {
    let headers = &table[0];
    let (row, own) = (place(headers, "row").unwrap(), place(headers, header).unwrap());
    let pose = headers.iter().position(|h| h == "pose" || h.starts_with("time [")).unwrap();
    let event = place(headers, "event");
    let filled = table[1..].iter().filter(|cells| !cells[own].is_empty() && cells[row] != "turns");
    let asked = filled.filter(|cells| event.is_none_or(|event| ["", "end"].contains(&cells[event].as_str())));
    asked.map(|cells| (cells[row].clone(), cells[pose].clone())).collect()
}

#[test]
fn the_same_is_asked_everywhere() {
    let (mut seen, mut full) = (0, 0);
    for path in share::spread(examples()) {
        let text = std::fs::read_to_string(&path).unwrap();
        let folder = Folder::new("asked").with("a.mech", &text);
        let batch = assur(&folder, &["batch", "a.mech", "--key", "key.csv", "--out", "all.csv"]);
        if batch.status != 0 {
            continue;
        }
        let key_text = folder.read("key.csv");
        let key = Key::of(&key_text);
        if key.columns == 0 {
            continue;
        }
        let name = path.display();
        seen += 1;
        // a sheet has a cell for each
        let sheet = assur(&folder, &["report", "a.mech", "--sheet", "--format", "html"]);
        assert_eq!(sheet.status, 0, "{name}: {}", sheet.stderr);
        let cells = sheet.stdout.matches("\u{2003}").count();
        if key.is_full() {
            full += 1;
            assert_eq!(cells, key.cells(), "{name}: cells of the sheet\n{key_text}");
        }
        // the table of all has the same values in the same lines, and those of events
        let (table, asked) = (rows(&folder.read("all.csv")), rows(&key_text));
        let first = place(&asked[0], "pose").unwrap() + 1;
        for header in &asked[0][first..] {
            let (mut of_key, mut of_all) = (places(&asked, header), places(&table, header));
            if key.lines.len() == 1 {
                // beside positions of events a table has two lines
                of_key.iter_mut().chain(&mut of_all).for_each(|(_, pose)| pose.clear());
            }
            // a key has a word for the instant at which an event ends the motion
            for (row, pose) in of_key.iter_mut().filter(|(_, pose)| pose == "end") {
                let last = of_all.iter().rfind(|(own, _)| own == row);
                *pose = last.map_or_else(String::new, |(_, pose)| pose.clone());
            }
            // the last instant tells the period
            let tells = text.contains("period()") && of_all.len() == of_key.len() + 1;
            of_all.truncate(of_all.len() - usize::from(tells));
            assert_eq!(of_key, of_all, "{name}: {header}");
        }
        // whoever answers as the key does gets all points, for each question once
        let grade = assur(&folder, &["grade", "key.csv", "key.csv"]);
        assert_eq!(grade.status, 0, "{name}: {}{}", grade.stdout, grade.stderr);
        // a course has a gap for each number
        let course = assur(&folder, &["course", "moodle", "a.mech", "--steps", "none", "--picture", "none"]);
        if course.status == 0 && key.is_full() {
            let question = course.stdout.split("type=\"cloze\"").nth(1).unwrap_or_default();
            let gaps = question.matches(":NM:").count();
            assert_eq!(gaps, key.numbers, "{name}: gaps of the course\n{key_text}");
        }
    }
    assert!(full > share::least(100), "{full} of {seen}");
}

/// A table of three positions, and the mean of it.
const POSITIONS: &str = "given r = 100 mm
ground { A (0, 0) }
link crank A-B r
revolute A: ground - crank
drive crank = 30 deg, 60 deg, 120 deg, 200 deg at 10 rad/s
find v = velocity(crank.B).x, top = max(velocity(crank.B).y)
";

#[test]
fn positions_are_chosen() {
    let folder = Folder::new("positions").with("a.mech", POSITIONS);
    let page = |more: &[&str]| {
        let said = assur(&folder, &[&["report", "a.mech", "--positions", "2,4"], more].concat());
        assert_eq!((said.status, said.stderr.as_str()), (0, ""));
        said.stdout
    };
    let (sheet, key) = (page(&["--sheet"]), page(&["--key"]));
    let lines = |page: &str, from: &str| -> Vec<String> {
        let after = page.split_once(from).unwrap().1;
        let first = after.lines().filter_map(|line| line.split_whitespace().next());
        first.filter(|word| word.len() == 1).map(str::to_owned).collect()
    };
    assert_eq!(lines(&sheet, "\nAnswers\n"), ["2", "4"], "{sheet}");
    // v = −r ω sin φ
    let second = format!("{:.4}", -0.1 * 10.0 * libm::sin(60.0_f64.to_radians())).replace('-', "−");
    assert!(key.contains(&second) && !key.contains("−0.5000"), "{key}");
    let course = assur(&folder, &["course", "moodle", "a.mech", "--positions", "2,4", "--steps", "none"]);
    assert_eq!(course.stdout.matches(":NM:").count(), 3, "{}", course.stderr);
    let wrong = assur(&folder, &["report", "a.mech", "--sheet", "--positions", "2,5"]);
    assert!(wrong.status != 0 && wrong.stderr.contains("`5`"), "{}", wrong.stderr);
}

/// The crank passes a height that it reaches in the first row alone.
const PASSES: &str = "given r = 100 mm
ground { A (0, 0) }
link crank A-B r
revolute A: ground - crank
drive crank = 0 deg .. 90 deg in 3 steps at 10 rad/s
event high: position(crank.B).y = 70 mm
find y = position(crank.B).y
variants {
  r [mm]
  100
  60
}
";

#[test]
fn events_do_not_count_among_positions() {
    let folder = Folder::new("numbers").with("a.mech", PASSES);
    let said = assur(&folder, &["batch", "a.mech", "--key", "key.csv", "--out", "all.csv"]);
    assert_eq!(said.status, 0, "{}", said.stderr);
    let poses = |name: &str, row: &str| -> Vec<String> {
        let table = rows(&folder.read(name));
        let pose = place(&table[0], "pose").unwrap();
        table[1..].iter().filter(|cells| cells[0] == row).map(|cells| cells[pose].clone()).collect()
    };
    for row in ["1", "2"] {
        assert_eq!(poses("key.csv", row), ["1", "2", "3", "4"]);
    }
    assert_eq!(poses("all.csv", "1"), ["1", "2", "high", "3", "4"]);
    assert_eq!(poses("all.csv", "2"), ["1", "2", "3", "4"]);
}
