//! Positions one after another: the same answers as all at once, in memory that does not grow with their number.

#![allow(clippy::unwrap_used)] // a test that cannot read its files has failed

use crate::share::{least, spread};
use assur::internals::check::Overrides;
use assur::internals::report::lines::{CsvLines, PoseLines};
use assur::internals::report::{Answers, PrintedDigits, csv, json, table_of_poses};
use assur::internals::solve::{Block, Following, Model, Pose, PoseOutputs, Solved};
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
            rows.begin(answers, None);
            rows.add(answers, pose, &mut Vec::new(), &mut text);
            objects.push(json::render_position("a", None, answers, Some(pose)));
            true
        });
        let solved = solved.unwrap();
        if objects.is_empty() {
            rows.begin(&solved.answers(PrintedDigits::READABLE), None);
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

/// The numbers of a position: angles, motion, reactions, efforts.
fn numbers(solved: &Solved) -> Vec<f64> {
    let mut all = solved.angles.clone();
    for b in &solved.state.motion.bodies {
        all.extend([b.p.x, b.p.y, b.u.x, b.u.y, b.v.x, b.v.y, b.omega, b.a.x, b.a.y, b.alpha]);
    }
    for r in &solved.state.forces.reactions {
        all.extend([r.force.x, r.force.y, r.couple]);
    }
    all.extend(&solved.state.forces.efforts);
    all
}

/// The numbers of all positions and what is said about them; in lanes where that goes, on which it is counted.
fn all_numbers(model: &Model<'_>, in_lanes: Option<&mut usize>) -> (Vec<Vec<f64>>, String) {
    let Ok(Some(mut following)) = Following::new(model, Vec::new()) else { return Default::default() };
    let of = |pose: &Pose| pose.outcome.as_ref().map(numbers).unwrap_or_default();
    let mut all = Vec::new();
    if let Some(counted) = in_lanes {
        all.extend(following.next().map(|pose| pose.map(|pose| of(&pose)).unwrap_or_default()));
        // in parts that come in another order
        let each = |_: &Vec<_>, count: usize, work: &(dyn Fn(usize) + Sync)| (0..count).rev().for_each(work);
        let found = following.side_by_side(PoseOutputs::ALL, &mut all, each, |all, sweep| {
            let mut block = Block::default();
            for number in 0..sweep.blocks() {
                sweep.solve(number, &mut block);
                all.extend(block.poses().iter().map(of));
            }
            true
        });
        *counted += usize::from(found.is_some());
    }
    while let Some(pose) = following.next() {
        all.push(pose.map(|pose| of(&pose)).unwrap_or_default());
    }
    let end = following.end();
    (all, format!("{:?} {}", end.notes, end.unlisted))
}

/// A sweep in lanes is what following finds, but for rounding, with the same notes.
#[test]
fn a_sweep_in_lanes_is_the_one_followed() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let mut in_lanes = 0;
    for path in spread(crate::folder::files(&root, "mech")) {
        let text = in_steps(&std::fs::read_to_string(&path).unwrap(), 480);
        let source = Source::new(path.display().to_string(), text);
        let Some(compiled) = compiled(&source) else { continue };
        let model = compiled.model();
        let (lanes, followed) = (all_numbers(&model, Some(&mut in_lanes)), all_numbers(&model, None));
        assert_eq!(lanes.1, followed.1, "{}", source.name);
        assert_eq!(lanes.0.len(), followed.0.len(), "{}", source.name);
        for (one, other) in lanes.0.iter().zip(&followed.0) {
            let greatest = other.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
            assert_eq!(one.len(), other.len(), "{}", source.name);
            for (x, y) in one.iter().zip(other) {
                assert!(
                    (x - y).abs() <= 1e-12 * greatest || x.is_nan() && y.is_nan(),
                    "{}: {x} {y}",
                    source.name
                );
            }
        }
    }
    assert!(in_lanes > least(15), "{in_lanes} examples go in lanes");
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
                rows.begin(answers, None);
                rows.add(answers, pose, &mut Vec::new(), &mut text);
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
