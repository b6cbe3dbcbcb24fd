//! A pair with a wrong end, or at a wrong place: another one written in its place makes all determined.

use super::add_pair::{candidates, guide};
use super::defect::Defect;
use super::leave_out::{is_driven, is_spare};
use super::order::{Order, Rank};
use super::trial::{Change, Statement, Trial};
use super::uses::Uses;
use super::words::{ends, free_name, is_taken, line, links, statement};
use crate::model::{Link, LinkId, Mechanism, Pair, PairId, PairKind, Pin};

/// Pairs that may be wrong, and lines tried in their place.
const MOST_WRONG: usize = 48;
const MOST_TRIED: usize = 600;
/// Lines offered as alternatives.
const MOST_SHOWN: usize = 3;

/// A pair in place of another.
struct Swap {
    wrong: PairId,
    kind: PairKind,
    /// What to write, and the statement in whose place.
    line: String,
    likelihood: Likelihood,
}

/// The least is the likeliest.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Likelihood {
    /// Its ends have several letters, or its name is another one.
    odd: bool,
    /// Other pairs at its ends.
    used: usize,
    /// The pair in whose place it is looks right.
    rank: Rank,
    /// More than one end changes.
    moved: bool,
}

/// Lines to write in place of a pair, the likeliest alone where no other is as likely: as help.
pub(super) fn swapped(trial: Trial<'_>, defect: &Defect) -> Option<String> {
    let mut all = swaps(trial, defect);
    all.sort_by_key(|swap| swap.likelihood);
    let mut found: Vec<Swap> = Vec::new();
    for swap in all.into_iter().take(trial.most_tried(MOST_TRIED)) {
        let alike = |first: &Swap| {
            first.likelihood.odd == swap.likelihood.odd && swap.likelihood.used <= first.likelihood.used + 1
        };
        if found.len() == MOST_SHOWN || !found.first().is_none_or(alike) {
            break;
        }
        let is_new = found.iter().all(|other| (other.wrong, &other.line) != (swap.wrong, &swap.line));
        if is_new && trial.after(&Change::writing(swap.wrong, swap.kind.clone())).is_sound() {
            found.push(swap);
        }
    }
    let words =
        |swap: &Swap| format!("write `{}` in place of {}", swap.line, statement(trial.mechanism, swap.wrong));
    let words: Vec<String> = found.iter().map(words).collect();
    (!words.is_empty()).then(|| words.join("\nor "))
}

fn swaps(trial: Trial<'_>, defect: &Defect) -> Vec<Swap> {
    let mechanism = trial.mechanism;
    let order = Order::of(trial);
    let pairs = defect.over.iter().flat_map(|part| part.pairs.iter().map(|pair| pair.0));
    let mut wrong: Vec<(Rank, PairId)> = pairs
        .filter(|&p| !is_driven(trial, p) && mechanism.pair(p).bearing.is_none())
        .map(|p| (order.rank(Statement::Pair(p)), p))
        .collect();
    wrong.sort_unstable();
    wrong.dedup();
    let mut all = Vec::new();
    for (rank, pair) in wrong.into_iter().take(trial.most_tried(MOST_WRONG)) {
        let left = trial.after(&Change::without(Statement::Pair(pair)));
        let missing = left.fit.missing;
        if left.fit.surplus > 0 || left.incidence.split().is_some() || missing == 0 {
            continue;
        }
        let uses = Uses::of(mechanism, Some(pair));
        let mut offer = |name: &str, kind: PairKind, used: usize, moved: bool| {
            if conditions(&kind) != missing {
                return;
            }
            let Some(line) = line(mechanism, name, &kind) else { return };
            let ends = ends(&kind);
            let is_slide = !moved && kind.word() != mechanism.pair(pair).kind.word();
            // a pin that is called as a point was meant as a pin
            let odd = match is_slide {
                true => mechanism.links.iter().flat_map(|link| &link.points).any(|point| point.name == name),
                false => ends.iter().any(|end| end.1 != name),
            };
            // what looks right is not given up for a guess
            if moved && odd && rank.0 >= 0 {
                return;
            }
            let likelihood = Likelihood { odd, used, rank, moved };
            all.push(Swap { wrong: pair, kind, line, likelihood });
        };
        let is_spare = is_spare(mechanism, pair);
        let Pair { name, kind, .. } = mechanism.pair(pair);
        let others = if is_spare { of_another_kind(mechanism, kind) } else { Vec::new() };
        for kind in with_another_end(mechanism, kind).into_iter().chain(others) {
            let used = ends(&kind).iter().map(|end| uses.count(end.0, end.1)).sum();
            offer(name, kind, used, false);
        }
        if !is_spare {
            continue;
        }
        let mut loose: Vec<LinkId> = links(trial.replaced, &defect.loose).collect();
        loose.extend(mechanism.pair(pair).kind.links().into_iter().filter(|l| *l != LinkId::GROUND));
        loose.sort_unstable();
        loose.dedup();
        for candidate in candidates(trial, &loose, Some(pair)) {
            let name = free_name(&candidate.name, |name| is_taken(mechanism, name, Some(pair)));
            offer(&name, candidate.kind, candidate.used, true);
        }
    }
    all
}

/// Freedoms that a pair takes.
fn conditions(kind: &PairKind) -> usize {
    match kind {
        PairKind::Revolute(pins) => 2 * pins.len().saturating_sub(1),
        PairKind::Prismatic(_) => 2,
        PairKind::Slot(_) | PairKind::Contact { .. } | PairKind::Transmission(_) => 1,
        PairKind::Weld { pins, .. } => 3 * pins.len().saturating_sub(1),
        PairKind::Cylinder { .. } => 0,
    }
}

/// The pair with one of its ends at another point, or on another line, of the same link.
fn with_another_end(mechanism: &Mechanism, kind: &PairKind) -> Vec<PairKind> {
    let points = |link: LinkId, name: &str| {
        let Link { points, .. } = mechanism.link(link);
        points.iter().filter(|point| point.name != name).collect::<Vec<_>>()
    };
    match kind {
        PairKind::Revolute(pins) => {
            let ends = pins.iter().enumerate();
            let other = ends.flat_map(|(i, pin)| {
                points(pin.link, &pin.name).into_iter().map(move |point| {
                    let mut pins = pins.clone();
                    pins[i] = Pin { link: pin.link, name: point.name.clone(), at: point.at };
                    PairKind::Revolute(pins)
                })
            });
            other.collect()
        }
        PairKind::Prismatic(guide) | PairKind::Slot(guide) if guide.own_line.is_none() => {
            let again = |guide| match kind {
                PairKind::Slot(_) => PairKind::Slot(guide),
                _ => PairKind::Prismatic(guide),
            };
            let mut all = Vec::new();
            for point in points(guide.slider, &guide.point_name) {
                let mut guide = guide.clone();
                (guide.point_name, guide.point) = (point.name.clone(), point.at);
                all.push(again(guide));
            }
            for line in mechanism.link(guide.guide).lines.iter().filter(|l| l.name != guide.line_name) {
                let mut guide = guide.clone();
                guide.line_name.clone_from(&line.name);
                (guide.through, guide.along) = (line.through, line.along);
                all.push(again(guide));
            }
            all
        }
        _ => Vec::new(),
    }
}

/// A pin of two links as a slide of one of its points along a line of the other link.
fn of_another_kind(mechanism: &Mechanism, kind: &PairKind) -> Vec<PairKind> {
    let PairKind::Revolute(pins) = kind else { return Vec::new() };
    let [first, second] = pins.as_slice() else { return Vec::new() };
    let ways = [(first, second), (second, first)].into_iter();
    let guides = ways.flat_map(|(pin, other)| {
        let lines = mechanism.link(other.link).lines.iter();
        lines.map(|line| guide((pin.link, &pin.name, pin.at), (other.link, line)))
    });
    guides.flat_map(|guide| [PairKind::Prismatic(guide.clone()), PairKind::Slot(guide)]).collect()
}
