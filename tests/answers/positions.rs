//! Positions one after another: the same answers as all at once, in memory that does not grow with their number.

#![allow(clippy::unwrap_used)] // a test that cannot read its files has failed

use crate::share::{least, spread};
use assur::internals::check::Overrides;
use assur::internals::report::json::JsonLines;
use assur::internals::report::lines::{CsvLines, LineMemory};
use assur::internals::report::rows::AnswerColumns;
use assur::internals::report::{Answers, NumberRows, PrintedDigits, csv, json, table_of_poses};
use assur::internals::solve::{Block, Following, Model, Pose, Solution};
use assur::internals::source::Source;
use std::path::Path;

fn compiled(source: &Source) -> Option<assur::internals::Compiled> {
    let (compiled, problems) = assur::internals::compile(source, &Overrides::none());
    compiled.filter(|_| !problems.has_errors())
}

#[test]
fn every_example_comes_out_the_same() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let (mut files, mut lines) = (0, 0);
    for path in spread(crate::folder::files(&root, "mech")) {
        let source = Source::new(path.display().to_string(), std::fs::read_to_string(&path).unwrap());
        let (Some(first), Some(second)) = (compiled(&source), compiled(&source)) else { continue };
        let (Ok(all), _) = assur::internals::pipeline::solve(first) else { continue };
        let answers = all.answers(PrintedDigits::READABLE);
        let mut rows = CsvLines::of(&second.model(), None);
        let (mut text, mut objects) = (rows.header().into_bytes(), Vec::new());
        let (solved, _) = assur::internals::solve_each(second, &mut |answers: &Answers<'_>, pose: &Pose| {
            rows.begin(answers);
            rows.add(answers, pose, &mut LineMemory::default(), &mut text);
            objects.push(json::render_position("a", None, answers, Some(pose)));
            true
        });
        let solved = solved.unwrap();
        if objects.is_empty() {
            rows.begin(&solved.answers(PrintedDigits::READABLE));
            rows.add_without_pose(&solved.answers(PrintedDigits::READABLE), &mut text);
        }
        let mut table = csv::render(&table_of_poses(&answers));
        if answers.poses().next().is_none() && table.lines().count() == 1 {
            table += "\r\n";
        }
        assert_eq!(String::from_utf8(text).unwrap(), table, "{}", source.name);
        for (pose, object) in answers.poses().zip(&objects) {
            assert_eq!(*object, json::render_position("a", None, &answers, Some(pose)), "{}", source.name);
        }
        assert_eq!(solved.outcomes.len(), all.outcomes.len(), "{}", source.name);
        files += 1;
        lines += objects.len();
    }
    assert!(files > least(100) && lines > least(600), "{files} files, {lines} positions");
}

/// The text with its sweeps in this many steps, a single angle of a drive made a sweep over a turn, and without positions beside.
fn in_steps(text: &str, steps: usize) -> String {
    let beside = |line: &&str| ["expect", "pose"].iter().any(|word| line.starts_with(word));
    let line = |line: &str| {
        let words = line.split(' ').collect::<Vec<_>>();
        let (is_drive, is_swept) = (words[0] == "drive", words.contains(&".."));
        let word = |(i, word): (usize, &&str)| match word {
            &"deg" if is_drive && !is_swept => match words[i - 1].parse::<f64>() {
                Ok(from) => format!("deg .. {} deg in {steps} steps", from + 360.0),
                Err(_) => "deg".to_owned(),
            },
            _ if i > 0 && words[i - 1] == "in" && words.get(i + 1) == Some(&"steps") => steps.to_string(),
            word => (*word).to_owned(),
        };
        words.iter().enumerate().map(word).collect::<Vec<_>>().join(" ") + "\n"
    };
    text.lines().filter(|line| !beside(line)).map(line).collect()
}

/// Every number of every position, as far as the sweep goes, and what is said about it.
fn all_numbers(following: Option<Following<'_, '_>>) -> (Vec<String>, String) {
    let Some(mut following) = following else { return Default::default() };
    let mut poses = Vec::new();
    while let Some(pose) = following.next() {
        poses.push(format!("{pose:?}"));
    }
    let end = following.end();
    (poses, format!("{:?} {}", end.notes, end.unlisted))
}

/// Where positions are solved side by side they are what following finds, to the last bit, with the same notes.
#[test]
fn side_by_side_is_one_by_one() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let mut aside = 0;
    for path in spread(crate::folder::files(&root, "mech")) {
        let text = in_steps(&std::fs::read_to_string(&path).unwrap(), 480);
        let source = Source::new(path.display().to_string(), text);
        let Some(compiled) = compiled(&source) else { continue };
        let model = compiled.model();
        let (Ok(first), Ok(second)) =
            (Following::new(&model, Vec::new()), Following::new(&model, Vec::new()))
        else {
            continue;
        };
        let one_by_one = all_numbers(first.map(Following::one_by_one));
        let mut ahead = second;
        if let Some(following) = &mut ahead {
            following.next();
            aside += usize::from(following.side_by_side(&mut Vec::new()).is_some());
        }
        let side_by_side = all_numbers(Following::new(&model, Vec::new()).unwrap_or_default());
        assert_eq!(one_by_one.1, side_by_side.1, "{}", source.name);
        for (one, other) in one_by_one.0.iter().zip(&side_by_side.0) {
            assert_eq!(one, other, "{}", source.name);
        }
        assert_eq!(one_by_one.0.len(), side_by_side.0.len(), "{}", source.name);
    }
    assert!(aside > least(20), "{aside} examples go side by side");
}

/// Columns that are read from lanes are those of whole positions, to the last bit; gives how many positions were compared.
fn compare_columns(model: &Model<'_>, name: &str) -> usize {
    let Ok(Some(mut following)) = Following::new(model, Vec::new()) else { return 0 };
    following.next();
    let solution = Solution { statics: following.statics().clone(), ..Solution::default() };
    let precision = PrintedDigits::READABLE;
    let answers = Answers { model: *model, solution: &solution, outcomes: &[], reached: None, precision };
    let mut rows = NumberRows::of(AnswerColumns::of_file(model).each_once());
    rows.begin(&answers);
    let Some(wide) = rows.wide() else { return 0 };
    let width = AnswerColumns::of_file(model).each_once().fields(model.mechanism).len();
    let (mut block, mut branches, mut row, mut compared) = (Block::default(), Vec::new(), Vec::new(), 0);
    while let Some((ahead, mut taking)) = following.side_by_side(&mut branches) {
        ahead.solve(&mut block, 0);
        taking.take(&mut block);
        let mut columns = vec![Vec::new(); width];
        block.read(wide, &mut columns);
        let quality: Vec<_> = block.quality(model).collect();
        ahead.answer(&mut block, true);
        assert_eq!(block.poses().len(), block.len(), "{name}");
        for (i, pose) in block.poses().iter().enumerate() {
            rows.read(&answers, pose, &mut row);
            let finite = |x: f64| if x.is_finite() { x.to_bits() } else { f64::NAN.to_bits() };
            let read: Vec<u64> = columns.iter().map(|column| finite(column[i])).collect();
            assert_eq!(read, row.iter().map(|x| finite(*x)).collect::<Vec<_>>(), "{name}, {}", pose.name);
            let solved = pose.outcome.as_ref().unwrap();
            assert_eq!(quality[i], (solved.residuals, solved.condition), "{name}");
        }
        compared += block.len();
        if block.is_empty() {
            break;
        }
    }
    compared
}

/// Compares sweeps of 480 steps of all examples.
fn in_all_examples(compare: impl Fn(&Model<'_>, &str) -> usize) {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let (mut files, mut positions) = (0, 0);
    for path in spread(crate::folder::files(&root, "mech")) {
        let text = in_steps(&std::fs::read_to_string(&path).unwrap(), 480);
        let source = Source::new(path.display().to_string(), text);
        let Some(compiled) = compiled(&source) else { continue };
        let compared = compare(&compiled.model(), &source.name);
        files += usize::from(compared > 0);
        positions += compared;
    }
    assert!(files > least(10) && positions > least(2_000), "{files} files, {positions} positions");
}

#[test]
fn columns_side_by_side_are_those_of_whole_positions() {
    in_all_examples(compare_columns);
}

/// Lines of JSON that are filled in from lanes are those of whole positions; gives how many were compared.
fn compare_objects(model: &Model<'_>, name: &str) -> usize {
    let Ok(Some(mut following)) = Following::new(model, Vec::new()) else { return 0 };
    following.next();
    let solution = Solution { statics: following.statics().clone(), ..Solution::default() };
    let precision = PrintedDigits::READABLE;
    let answers = Answers { model: *model, solution: &solution, outcomes: &[], reached: None, precision };
    let mut lines = JsonLines::of("a".to_owned());
    let (mut block, mut branches, mut memory) = (Block::default(), Vec::new(), LineMemory::default());
    let mut compared = 0;
    while let Some((ahead, mut taking)) = following.side_by_side(&mut branches) {
        ahead.solve(&mut block, 0);
        taking.take(&mut block);
        let mut filled = Vec::new();
        let is_filled = lines.add_block(&block, &mut memory, &mut filled);
        ahead.answer(&mut block, true);
        for pose in block.poses() {
            lines.begin(&answers, pose);
        }
        if is_filled {
            let object = |pose| json::render_position("a", None, &answers, Some(pose)) + "\n";
            let whole: String = block.poses().iter().map(object).collect();
            assert_eq!(String::from_utf8(filled).unwrap(), whole, "{name}");
            compared += block.len();
        }
        if block.is_empty() {
            break;
        }
    }
    compared
}

#[test]
fn objects_from_lanes_are_those_of_whole_positions() {
    in_all_examples(compare_objects);
}

/// The greatest number of bytes in use while a sweep is printed.
fn peak(name: &str, steps: usize) -> u64 {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cases/hostile").join(name);
    let text = std::fs::read_to_string(path).unwrap().replace("1000000 steps", &format!("{steps} steps"));
    let source = Source::new(name, text);
    let mut lines = 0;
    let info = allocation_counter::measure(|| {
        let compiled = compiled(&source).unwrap();
        let mut rows = CsvLines::of(&compiled.model(), None);
        let mut text = Vec::new();
        let (solved, _) =
            assur::internals::solve_each(compiled, &mut |answers: &Answers<'_>, pose: &Pose| {
                text.clear();
                rows.begin(answers);
                rows.add(answers, pose, &mut LineMemory::default(), &mut text);
                lines += 1;
                true
            });
        assert!(solved.is_ok(), "{name}");
    });
    assert!(lines >= steps, "{lines} of {steps}");
    info.bytes_max
}

#[test]
fn memory_does_not_grow_with_the_number_of_positions() {
    for name in ["steps1e6.mech", "steps1e6-few.mech", "hang-113626.mech", "hang-46872.mech"] {
        let (some, many) = (peak(name, 25_000), peak(name, 75_000));
        assert!(many < some + some / 10 + 10_000, "{name}: {some} and {many} bytes");
        assert!(many < 20_000_000, "{name}: {many} bytes");
    }
}
