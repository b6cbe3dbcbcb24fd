//! Statements and what they join, as helps name them.

use super::joint::{BodyId, BodyOrigin, Replaced};
use super::lines::{self, degrees};
use super::roller::listed;
use crate::model::{Drive, LinkId, Mechanism, PairId, PairKind};
use assur_math::math::SAME;

/// The links of a list of bodies.
pub(super) fn links<'a>(replaced: &'a Replaced, bodies: &'a [BodyId]) -> impl Iterator<Item = LinkId> + 'a {
    bodies.iter().filter_map(|b| match replaced.bodies[b.0].origin {
        BodyOrigin::Link(id) => Some(id),
        BodyOrigin::Imaginary(_) => None,
    })
}

/// A pair as its statement begins: `slot E`.
pub(super) fn statement(mechanism: &Mechanism, pair: PairId) -> String {
    let pair = mechanism.pair(pair);
    format!("`{} {}`", pair.kind.word(), pair.name)
}

/// A drive as its statement begins: `drive crank`, `start crank`.
pub(super) fn drive_statement(drive: &Drive) -> String {
    format!("`{} {}`", drive_word(drive), drive.written_name())
}

pub(super) const fn drive_word(drive: &Drive) -> &'static str {
    if drive.free { "start" } else { "drive" }
}

/// The line that writes a pair of this kind, with points of its own name left out. `None` for those that take more than their ends.
pub(super) fn line(mechanism: &Mechanism, name: &str, kind: &PairKind) -> Option<String> {
    let short = match kind {
        PairKind::Revolute(_) | PairKind::Weld { .. } => true,
        PairKind::Prismatic(g) | PairKind::Slot(g) if !g.point_name.is_empty() => false,
        PairKind::Contact { .. } => false,
        _ => return None,
    };
    let end = |(link, point): &(LinkId, &str)| {
        let link = &mechanism.link(*link).name;
        if short && *point == name { link.clone() } else { format!("{link}.{point}") }
    };
    let ends: Vec<String> = ends(kind).iter().map(end).collect();
    Some(format!("{} {name}: {}{}", kind.word(), ends.join(" - "), angle(kind)))
}

/// ` { angle 70 deg }`, where a slider does not lie along its guide.
fn angle(kind: &PairKind) -> String {
    match kind {
        PairKind::Prismatic(g)
            if g.own_line.is_none() && g.direction.y.abs() + (g.direction.x - 1.0).abs() > SAME =>
        {
            format!(" {{ angle {} }}", degrees(-lines::angle(g.direction)))
        }
        _ => String::new(),
    }
}

/// The points, lines and circles that a pair joins, by link and name.
pub(super) fn ends(kind: &PairKind) -> Vec<(LinkId, &str)> {
    match kind {
        PairKind::Revolute(pins) | PairKind::Weld { pins, .. } => {
            pins.iter().map(|pin| (pin.link, pin.name.as_str())).collect()
        }
        PairKind::Prismatic(g) | PairKind::Slot(g) => {
            let own = g.own_line.as_ref().unwrap_or(&g.point_name);
            vec![(g.slider, own.as_str()), (g.guide, g.line_name.as_str())]
        }
        PairKind::Contact { first, second, .. } => {
            [first, second].map(|profile| (profile.link, profile.name.as_str())).to_vec()
        }
        PairKind::Cylinder { from, to, .. } => [from, to].map(|pin| (pin.link, pin.name.as_str())).to_vec(),
        PairKind::Transmission(_) => Vec::new(),
    }
}

/// A truss or a beam: forces inside links are asked for, and nothing has to move.
pub(super) fn is_structure(mechanism: &Mechanism) -> bool {
    !mechanism.bars.is_empty() || !mechanism.asked_inside().is_empty()
}

/// Forces on links that nothing is said to move.
pub(super) fn is_at_rest(mechanism: &Mechanism) -> bool {
    is_structure(mechanism)
        || !mechanism.loads.is_empty()
            && mechanism.drives.is_empty()
            && mechanism.balances.is_empty()
            && mechanism.simulation.is_none()
}

pub(super) fn pairs_of(mechanism: &Mechanism, link: LinkId) -> Vec<PairId> {
    let pairs = mechanism.pairs.iter().enumerate();
    pairs.filter(|(_, p)| p.kind.links().contains(&link)).map(|(i, _)| PairId::at(i)).collect()
}

/// `` `a`, `b` or `c` ``
pub(super) fn one_of(items: &[String]) -> String {
    listed(items, "or")
}

/// Whether a statement has a name already, the pair `but` left aside.
pub(super) fn is_taken(mechanism: &Mechanism, name: &str, but: Option<PairId>) -> bool {
    let mut pairs = mechanism.pairs.iter().enumerate().filter(|(i, _)| Some(PairId::at(*i)) != but);
    mechanism.links.iter().any(|l| l.name == name)
        || pairs.any(|(_, p)| p.name == name)
        || mechanism.groups.iter().any(|g| g.name == name)
}

/// The name wished, else a letter, else the name with a number.
pub(super) fn free_name(wish: &str, taken: impl Fn(&str) -> bool) -> String {
    let letters = ('A'..='Z').map(String::from);
    let numbered = (1..).map(|i| format!("{wish}{i}"));
    let mut names = std::iter::once(wish.to_owned()).chain(letters).chain(numbered);
    names.find(|n| !taken(n)).unwrap_or_else(|| wish.to_owned())
}
