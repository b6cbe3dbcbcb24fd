//! Functions over a motion under loads, and the numbers at the instants that are printed: none is beyond the greatest or the least.

#![allow(clippy::unwrap_used)] // a test that cannot read its files has failed

use crate::share::{least, spread};
use assur::internals::Solved;
use assur::internals::check::Overrides;
use assur::internals::model::{LinkId, PairKind, TransmissionKind};
use assur::internals::source::Source;
use std::path::Path;

/// Of the greatest in play: integration and rounding.
const WITHIN: f64 = 1e-6;

fn solved(name: &str, text: &str) -> Option<Solved> {
    let (solved, problems) = assur::internals::solve_source(&Source::new(name, text), &Overrides::none());
    solved.filter(|_| !problems.has_errors())
}

/// What may be asked of the links and pairs of a mechanism.
fn questions(solved: &Solved) -> Vec<String> {
    let mechanism = solved.compiled.model().mechanism;
    let links = (1..mechanism.links.len()).map(|i| &mechanism.link(LinkId::at(i)).name);
    let mut all: Vec<String> =
        links.flat_map(|link| [format!("omega({link})"), format!("alpha({link})")]).collect();
    for pair in mechanism.pairs.iter().filter(|pair| pair.bearing.is_none()) {
        let name = &pair.name;
        let on = pair.kind.links().into_iter().find(|link| *link != LinkId::GROUND);
        let on = on.map_or("ground", |link| &mechanism.link(link).name);
        all.push(match &pair.kind {
            PairKind::Transmission(it) if it.kind == TransmissionKind::Rope => format!("tension({name})"),
            PairKind::Transmission(_) => format!("tangential_force({name}, {on})"),
            _ => format!("mag(reaction({name}, {on}))"),
        });
    }
    all
}

/// The questions with their extremes, in a file.
fn asked(text: &str, questions: &[String]) -> String {
    let line =
        |(i, q): (usize, &String)| format!("find at{i} = {q}, most{i} = max({q}), least{i} = min({q})\n");
    let lines: String = questions.iter().enumerate().map(line).collect();
    format!("{text}\n{lines}")
}

#[test]
fn no_printed_number_is_beyond_the_extremes() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let motions = crate::folder::files(&root, "mech").into_iter().filter(|path| {
        std::fs::read_to_string(path).unwrap().lines().any(|line| line.trim_start().starts_with("simulate"))
    });
    let (mut compared, mut forces, mut wrong) = (0, 0, Vec::new());
    for path in spread(motions.collect()) {
        let name = path.strip_prefix(&root).unwrap().display().to_string();
        let text = std::fs::read_to_string(&path).unwrap();
        let Some(own) = solved(&name, &text) else { continue };
        let all = questions(&own);
        let solution = |questions: &[String]| assur::solve(asked(&text, questions)).ok();
        let kept: Vec<String> = match solution(&all) {
            Some(_) => all,
            None => all.into_iter().filter(|q| solution(std::slice::from_ref(q)).is_some()).collect(),
        };
        let Some(solution) = solution(&kept) else { continue };
        for (i, question) in kept.iter().enumerate() {
            let number = |pose: &assur::Pose, what: &str| {
                pose.get(&format!("{what}{i}")).and_then(assur::Answer::number)
            };
            let row = solution.poses().iter().filter_map(|pose| number(pose, "at")).filter(|x| x.is_finite());
            let rows: Vec<f64> = row.collect();
            let whole = |what: &str| solution.poses().first().and_then(|pose| number(pose, what));
            let (Some(most), Some(least)) = (whole("most"), whole("least")) else { continue };
            let greatest = rows.iter().fold(f64::NEG_INFINITY, |a, b| a.max(*b));
            let smallest = rows.iter().fold(f64::INFINITY, |a, b| a.min(*b));
            // what is nothing is not nothing to the last digit at every instant
            let size = greatest.abs().max(smallest.abs()).max(1e-3);
            if greatest > most + WITHIN * size || smallest < least - WITHIN * size {
                wrong.push(format!("{name}: {question} is {smallest} to {greatest}, not {least} to {most}"));
            }
            compared += 1;
            forces += usize::from(!question.starts_with(['o', 'a']));
        }
    }
    assert!(compared >= least(200) && forces >= least(60), "{compared}, {forces}");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
