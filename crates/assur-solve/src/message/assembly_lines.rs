//! The assemblies there are, each as a line to paste.

use super::error::{SolveError, label};
use super::format::{labels, length, short};
use crate::answer::PoseAnswers;
use crate::math::Vec2;
use crate::model::{Hint, HintKind, PairKind};
use crate::position::{Model, SAME, State, extent};
use crate::structure::{BodyOrigin, Dyad, Group, GroupKind, JointKind};

/// More lines than this are no help.
const MOST_LINES: usize = 8;

/// Several assemblies remain: the groups in which they differ, with the lines that choose.
pub(crate) fn ambiguous(model: &Model<'_>, states: &[&State]) -> SolveError {
    let mut sections = Vec::new();
    let mut marks = Vec::new();
    for group in &model.structure.motion {
        let ways = distinct(model, states, group);
        if ways.len() < 2 {
            continue;
        }
        marks.extend(labels(model, group, "can be assembled in several ways"));
        sections.push(section(&lines(model, &ways, group)));
    }
    SolveError::Ambiguous {
        count: states.len(),
        pose: String::new(),
        help: format!("write one of{}", sections.join("\nand one of")),
        labels: marks,
    }
}

/// No candidate fits a hint: what there is instead.
pub(crate) fn not_met(model: &Model<'_>, hint: &Hint, states: &[&State], index: usize) -> SolveError {
    let group = &model.structure.motion[index];
    let ways = distinct(model, states, group);
    let mut found = lines(model, &ways, group);
    if let HintKind::Coordinate { pair, .. } = hint.kind {
        for (line, state) in found.iter_mut().zip(&ways) {
            let value = coordinate(model, state, pair);
            let value = match model.mechanism.pair(pair).kind {
                PairKind::Revolute(_) => format!("{} deg", short(value.to_degrees())),
                _ => length(model, value),
            };
            *line += &format!("   // {} = {value}", model.mechanism.pair(pair).name);
        }
    }
    let mut marks = vec![label("no assembly is so", hint.span)];
    marks.extend(labels(model, group, "this group"));
    let help = match found.len() {
        0 => "leave the clause out".to_owned(),
        1 => format!("there is only{}", section(&found)),
        _ => format!("there are{}", section(&found)),
    };
    SolveError::HintNotMet { pose: String::new(), help, labels: marks }
}

fn section(lines: &[String]) -> String {
    lines.iter().take(MOST_LINES).map(|l| format!("\n  {l}")).collect()
}

/// One state for every way in which the group stands.
fn distinct<'s>(model: &Model<'_>, states: &[&'s State], group: &Group) -> Vec<&'s State> {
    let extent = extent(model);
    let same = |a: &State, b: &State| {
        group.bodies.iter().all(|i| {
            let (x, y) = (&a.motion.bodies[i.0], &b.motion.bodies[i.0]);
            (x.p - y.p).norm() <= SAME * extent && (x.u - y.u).norm() <= SAME
        })
    };
    let mut ways: Vec<&State> = Vec::new();
    for &state in states {
        if !ways.iter().any(|w| same(w, state)) {
            ways.push(state);
        }
    }
    ways
}

/// An `assemble` line for every way: by side, order or sign where these tell them apart, else by the place of a point.
pub(crate) fn lines(model: &Model<'_>, ways: &[&State], group: &Group) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for state in ways {
        match by_kind(model, state, group) {
            Some(line) if !lines.contains(&line) => lines.push(line),
            // two groups before this one may stand differently: the line is the same
            Some(_) if ways.len() > 2 && matches!(group.kind, GroupKind::Dyad(Dyad::Rrr | Dyad::Rrp)) => {}
            _ => return near_lines(model, ways, group),
        }
    }
    lines
}

fn by_kind(model: &Model<'_>, state: &State, group: &Group) -> Option<String> {
    let GroupKind::Dyad(dyad) = group.kind else { return None };
    let replaced = &model.structure.replaced;
    let real = |i: usize| {
        let pair = model.mechanism.pair(replaced.joint(group.joints[i].joint).pair);
        matches!(pair.kind, PairKind::Revolute(_) | PairKind::Prismatic(_)).then_some(pair)
    };
    let pin = |i: usize| {
        let joint = group.joints[i];
        match &replaced.joint(joint.joint).kind {
            JointKind::Revolute(members) => members
                .iter()
                .find(|m| m.0 == joint.body)
                .map(|m| state.motion.bodies[joint.body.0].position(m.1)),
            JointKind::Prismatic { .. } | JointKind::Law(_) => None,
        }
    };
    match dyad {
        Dyad::Rrr => {
            let (a, c, b) = (pin(0)?, pin(1)?, pin(2)?);
            let side = if (b - a).cross(c - a) >= 0.0 { "left" } else { "right" };
            Some(format!("assemble {} {side} of {}-{}", real(1)?.name, real(0)?.name, real(2)?.name))
        }
        Dyad::Rrp => {
            let (a, c) = (pin(0)?, pin(1)?);
            let guide = real(2)?;
            let JointKind::Prismatic { guide: base, along, .. } = replaced.joint(group.joints[2].joint).kind
            else {
                return None;
            };
            if !matches!(guide.kind, PairKind::Prismatic(_)) {
                return None;
            }
            let ahead = (c - a).dot(along.turned(state.motion.bodies[base.0].u)) >= 0.0;
            let word = if ahead { "ahead of" } else { "behind" };
            Some(format!("assemble {} {word} {}", real(1)?.name, real(0)?.name))
        }
        Dyad::Rpr => {
            let pair = replaced.joint(group.joints[1].joint).pair;
            let round = matches!(
                replaced.joint(group.joints[1].joint).kind,
                JointKind::Prismatic { offset, .. } if offset > 0.0
            );
            let value = coordinate(model, state, pair);
            if round || !value.is_finite() || value == 0.0 {
                return None;
            }
            let sign = if value > 0.0 { ">" } else { "<" };
            Some(format!("assemble {} {sign} 0", model.mechanism.pair(pair).name))
        }
        Dyad::Prp | Dyad::Rpp => None,
    }
}

fn coordinate(model: &Model<'_>, state: &State, pair: crate::model::PairId) -> f64 {
    let angles: Vec<f64> = state.motion.bodies.iter().map(|b| b.u.angle()).collect();
    PoseAnswers { angles: &angles, ..PoseAnswers::bare(model, state) }.displacement(pair)
}

/// The points of a group that a clause can name, with their bodies.
fn points<'a>(model: &Model<'a>, group: &Group) -> Vec<(String, usize, Vec2)> {
    let mut out = Vec::new();
    for body in &group.bodies {
        let BodyOrigin::Link(id) = model.structure.replaced.bodies[body.0].origin else { continue };
        let link = model.mechanism.link(id);
        // the two links of a cylinder have no names of their own
        if link.name.contains('.') {
            continue;
        }
        out.extend(link.points.iter().map(|p| (format!("{}.{}", link.name, p.name), body.0, p.at)));
    }
    out
}

/// A point of a group as a clause names it.
pub(crate) fn point_of(model: &Model<'_>, group: &Group) -> Option<String> {
    points(model, group).into_iter().next().map(|p| p.0)
}

/// `assemble L.P near (x, y)` with the point that differs most from way to way.
pub(crate) fn near_lines(model: &Model<'_>, ways: &[&State], group: &Group) -> Vec<String> {
    let mut best: Option<(f64, (String, usize, Vec2))> = None;
    for point in points(model, group) {
        let places: Vec<Vec2> = ways.iter().map(|s| s.motion.bodies[point.1].position(point.2)).collect();
        let apart = places.iter().enumerate().flat_map(|(i, p)| places[..i].iter().map(|q| (*p - *q).norm()));
        let apart = apart.fold(f64::INFINITY, f64::min);
        if best.as_ref().is_none_or(|b| apart > b.0) {
            best = Some((apart, point));
        }
    }
    let Some((_, (name, body, at))) = best else { return Vec::new() };
    let places = ways.iter().map(|s| s.motion.bodies[body].position(at));
    places.map(|p| format!("assemble {name} near ({}, {})", length(model, p.x), length(model, p.y))).collect()
}
