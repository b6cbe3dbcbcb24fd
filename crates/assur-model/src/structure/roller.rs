//! Links that turn freely: what would turn them is balanced by nothing.

use crate::math::Vec2;
use crate::model::{Drive, Link, LinkId, LoadKind, Mechanism, Pair, PairKind, Place};
use crate::source::Span;
use assur_text::diagnostic::{Diagnosis, Fix};
use assur_text::source::Edit;
use miette::LabeledSpan;

/// A place this close to the hinge, as a part of both distances, is on it.
const ROUNDING: f64 = 1e-9;

/// One defect per roller that something would turn.
pub(super) fn turned(mechanism: &Mechanism, rollers: &[LinkId]) -> Vec<Diagnosis> {
    rollers.iter().filter_map(|roller| describe(mechanism, *roller)).collect()
}

fn describe(mechanism: &Mechanism, roller: LinkId) -> Option<Diagnosis> {
    let link = mechanism.link(roller);
    let (pair, hinge) = hinge(mechanism, roller)?;
    let beside = |at: Vec2| (at - hinge).norm() > ROUNDING * (at.norm() + hinge.norm());
    let mut found = loads(mechanism, roller, &beside);
    for pair in mechanism.pairs.iter().filter(|p| p.kind.links().contains(&roller)) {
        if pair.friction.is_some_and(|f| f.is_some()) {
            found.push((format!("the friction in `{}`", pair.name), pair.span));
        }
    }
    if weighs(mechanism, link) && link.mass.is_some_and(|m| m.mass > 0.0 && beside(m.centre)) {
        found.push(("its mass, which is not at the hinge".to_owned(), link.span));
    }
    if found.is_empty() {
        return None;
    }
    let words: Vec<String> = found.iter().map(|f| f.0.clone()).collect();
    let mut labels = vec![label("turns freely here", pair.span)];
    labels.retain(|_| found.iter().all(|f| f.1 != pair.span));
    labels.extend(found.into_iter().map(|(_, span)| label("acts on its rotation", span)));
    Some({
        let name = link.name.clone();
        Diagnosis::error(
            "mech::determinacy::free_roller",
            format!("`{name}` turns freely in `{}`: nothing balances {}", pair.name, listed(&words, "and")),
        )
        .labels(labels)
        .help(format!(
            "leave that out, or give the circle to the link that carries `{name}`, so \
             that it slides instead of rolling: the rotation of a free roller is not \
             solved"
        ))
    })
}

/// The pair on which it turns, and the hinge in its frame.
fn hinge(mechanism: &Mechanism, roller: LinkId) -> Option<(&Pair, Vec2)> {
    mechanism.pairs.iter().find_map(|pair| match &pair.kind {
        PairKind::Revolute(pins) => pins.iter().find(|p| p.link == roller).map(|p| (pair, p.at)),
        _ => None,
    })
}

/// Loads and springs that have a moment about the hinge.
fn loads(mechanism: &Mechanism, roller: LinkId, beside: &impl Fn(Vec2) -> bool) -> Vec<(String, Span)> {
    let mut found = Vec::new();
    for load in &mechanism.loads {
        let what = match &load.kind {
            LoadKind::Torque { on, .. } if *on == roller => "the torque on it".to_owned(),
            LoadKind::Force { on, at, .. } | LoadKind::ForceAgainstMotion { on, at, .. } if *on == roller => {
                match at {
                    Place::Local(at) if !beside(*at) => continue,
                    _ => "the force on it, which does not act at the hinge".to_owned(),
                }
            }
            LoadKind::InPair { pair, .. } if mechanism.pair(*pair).kind.links().contains(&roller) => {
                format!("the torque in `{}`", mechanism.pair(*pair).name)
            }
            _ => continue,
        };
        found.push((what, load.span));
    }
    for spring in &mechanism.springs {
        if [spring.from, spring.to].iter().any(|(link, at)| *link == roller && beside(*at)) {
            found.push(("the spring on it, which is not joined at the hinge".to_owned(), spring.span));
        }
    }
    found
}

/// Gravity or inertia acts on the link.
fn weighs(mechanism: &Mechanism, link: &Link) -> bool {
    let moves = |d: &Drive| d.speed.is_some();
    link.mass.is_some() && (mechanism.gravity.is_some() || mechanism.drives.iter().any(moves))
}

// Words and labels of what is wrong with a structure.

/// The groups that a help lists, in place of one that is wrong.
pub(super) fn groups(help: &str, at: Span) -> Vec<Fix> {
    let lines = help.lines().filter_map(|line| line.strip_prefix("  ")).collect::<Vec<_>>();
    let (title, all) = (format!("write `{}`", lines.join("` and `")), lines.join("\n"));
    let fix = || Fix { title, edits: vec![Edit::new(at, all)], certain: false };
    (!lines.is_empty()).then(fix).into_iter().collect()
}

pub(super) fn label(text: impl Into<String>, span: Span) -> LabeledSpan {
    LabeledSpan::new_with_span(Some(text.into()), span)
}

/// `1 freedom`, `2 freedoms`.
pub(super) fn counted(n: usize, what: &str) -> String {
    format!("{n} {what}{}", if n == 1 { "" } else { "s" })
}

/// `a`, `a and b`, `a, b and c`.
pub(super) fn listed(items: &[String], and: &str) -> String {
    match items {
        [] => String::new(),
        [one] => one.clone(),
        [first @ .., last] => format!("{} {and} {last}", first.join(", ")),
    }
}

/// Lines to paste below a sentence.
pub(super) fn with_lines(sentence: &str, lines: &[String]) -> String {
    let lines: String = lines.iter().map(|l| format!("\n  {l}")).collect();
    format!("{sentence}{lines}")
}

/// A whole number with the minus sign of text.
pub(super) fn whole(x: i64) -> String {
    if x < 0 { format!("−{}", x.unsigned_abs()) } else { x.to_string() }
}

// Names of links in a message.

/// More labels than this tell nothing.
pub(super) const MOST_LABELS: usize = 12;
/// More names than this are counted.
const MOST_NAMES: usize = 6;

/// `` `a`, `b` and `c` ``, the last ones counted where there are many.
pub(super) fn names(mechanism: &Mechanism, links: impl Iterator<Item = LinkId>) -> String {
    let mut names: Vec<String> = links.map(|l| format!("`{}`", mechanism.link(l).name)).collect();
    let more = names.len().saturating_sub(MOST_NAMES);
    if more > 1 {
        names.truncate(MOST_NAMES);
        names.push(format!("{more} more"));
    }
    listed(&names, "and")
}
