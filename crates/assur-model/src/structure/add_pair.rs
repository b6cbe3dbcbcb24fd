//! Pairs that may be missing where something can still move: lines to paste, each of them tried.

use super::defect::{Defect, Fit};
use super::joint::BodyId;
use super::trial::{Change, Trial};
use super::uses::Uses;
use super::words::{ends, free_name, is_taken, line, links, pairs_of};
use crate::math::Vec2;
use crate::model::{
    Circle, Guide, Line, LinkId, Mechanism, PairId, PairKind, Pin, Profile, ProfileShape, Wheel,
};
use assur_math::math::SAME;

const MOST_TRIED: usize = 96;
/// Lines offered as alternatives.
const MOST_SHOWN: usize = 4;
/// Couples of links between which guides and contacts are looked for.
const MOST_COUPLES: usize = 5_000;
/// The ground as a slider comes after links with fewer pairs.
const GROUNDED: usize = 3;
/// Other pairs at the places of one that is added in addition to another: more make it a guess.
const MOST_USED: usize = 2;

/// A pair that might be missing.
#[derive(Clone)]
pub(super) struct Candidate {
    /// The name that the point or line suggests.
    pub name: String,
    pub kind: PairKind,
    /// How unlikely it is: places that other pairs use already.
    pub used: usize,
}

pub(super) enum Missing {
    /// Any one of these lines holds everything.
    OneOf(Vec<String>),
    /// These lines together; what they leave loose has to be driven.
    Together { lines: Vec<String>, pairs: Vec<PairKind>, left: Fit },
}

/// Pairs between the loose links and others that make nothing overconstrained. `None` where no points or lines suggest any.
pub(super) fn missing_pairs(trial: Trial<'_>, defect: &Defect, among: &[BodyId]) -> Option<Missing> {
    let loose: Vec<LinkId> = links(trial.replaced, among).collect();
    let mut candidates = candidates(trial, &loose, None);
    let (mut chosen, mut lines) = (Vec::new(), Vec::new());
    let mut now = defect.fit;
    loop {
        let mut best: Option<(usize, Fit)> = None;
        let (mut alone, mut likeliest) = (Vec::new(), None);
        candidates.retain(|c| chosen.is_empty() || c.used <= MOST_USED);
        for (i, candidate) in candidates.iter().enumerate() {
            let with = [chosen.as_slice(), std::slice::from_ref(&candidate.kind)].concat();
            let fit = match is_hub(trial.mechanism, &candidate.kind) {
                true => trial.after(&Change { added: with.clone(), ..Change::default() }).fit,
                false => trial.with(&with, &[]).fit(),
            };
            let helps = fit.surplus <= defect.fit.surplus && fit.missing < now.missing;
            if !helps || !trial.agrees_with(&with) {
                continue;
            }
            if fit.missing == 0 && chosen.is_empty() {
                let likeliest = *likeliest.get_or_insert(candidate.used);
                if alone.len() == MOST_SHOWN || candidate.used > likeliest + 1 {
                    break;
                }
                alone.extend(written(trial.mechanism, candidate, &lines));
            }
            if best.is_none_or(|(_, b)| fit.missing < b.missing) {
                best = Some((i, fit));
            }
            if fit.missing == 0 && !chosen.is_empty() {
                break;
            }
        }
        if !alone.is_empty() {
            return Some(Missing::OneOf(alone));
        }
        let Some((i, fit)) = best else { break };
        let candidate = candidates.remove(i);
        lines.extend(written(trial.mechanism, &candidate, &lines));
        chosen.push(candidate.kind);
        now = fit;
    }
    (!lines.is_empty()).then_some(Missing::Together { lines, pairs: chosen, left: now })
}

/// A pin in the centre of a circle: the rotation of a roller changes nothing.
fn is_hub(mechanism: &Mechanism, kind: &PairKind) -> bool {
    let PairKind::Revolute(pins) = kind else { return false };
    pins.iter().any(|pin| mechanism.link(pin.link).circles.iter().any(|circle| circle.centre == pin.at))
}

/// A weld that holds all, where a link is free in its place and in its angle.
pub(super) fn missing_weld(trial: Trial<'_>, defect: &Defect, among: &[BodyId]) -> Option<String> {
    if defect.fit != (Fit { missing: 3, surplus: 0 }) {
        return None;
    }
    let loose: Vec<LinkId> = links(trial.replaced, among).collect();
    let welds = candidates(trial, &loose, None).into_iter().filter_map(|candidate| {
        let PairKind::Revolute(pins) = candidate.kind else { return None };
        let kind = PairKind::Weld { pins, angle: 0.0 };
        (candidate.used <= MOST_USED).then_some(Candidate { kind, ..candidate })
    });
    let mut welds = welds.take(MOST_SHOWN);
    let weld = welds.find(|weld| trial.after(&Change::adding(weld.kind.clone())).is_sound())?;
    written(trial.mechanism, &weld, &[])
}

/// The line of a candidate, under a name that nothing has, the lines before it included.
fn written(mechanism: &Mechanism, candidate: &Candidate, others: &[String]) -> Option<String> {
    let taken = |name: &str| {
        is_taken(mechanism, name, None)
            || others.iter().any(|line| line.split([' ', ':']).nth(1) == Some(name))
    };
    line(mechanism, &free_name(&candidate.name, taken), &candidate.kind)
}

/// Pairs of some links, in addition or in place of one: the likeliest first, at points that no other pair uses, of links that have the
/// fewest pairs.
pub(super) fn candidates(trial: Trial<'_>, loose: &[LinkId], but: Option<PairId>) -> Vec<Candidate> {
    let mechanism = trial.mechanism;
    let couples = couples(mechanism, loose);
    let uses = Uses::of(mechanism, but);
    let mut all = pins(mechanism, &uses, loose);
    all.extend(hinges(mechanism, &uses, &couples));
    if couples.len() <= MOST_COUPLES {
        all.extend(guides(mechanism, &uses, &couples));
        all.extend(faces(mechanism, &uses, &couples));
        all.extend(contacts(mechanism, &uses, &couples));
    }
    // a slider is seldom the ground
    let pairs = |l: LinkId| if l == LinkId::GROUND { GROUNDED } else { pairs_of(mechanism, l).len() };
    all.sort_by_cached_key(|c| {
        let ends = ends(&c.kind);
        let alike = ends[1].1.contains(ends[0].1) || is_on_its_line(&uses, &c.kind);
        (c.used, !alike, pairs(ends[0].0))
    });
    all.truncate(trial.most_tried(MOST_TRIED));
    all
}

/// A point whose letter is that of the point through which a line that nothing uses goes.
fn is_on_its_line(uses: &Uses<'_>, kind: &PairKind) -> bool {
    let (PairKind::Prismatic(guide) | PairKind::Slot(guide)) = kind else { return false };
    let mut points = uses.points(guide.guide).iter();
    uses.count(guide.guide, &guide.line_name) == 0
        && points.any(|point| point.at == guide.through && point.name == guide.point_name)
}

/// Every two links of which one is loose at least, each two once.
fn couples(mechanism: &Mechanism, loose: &[LinkId]) -> Vec<[LinkId; 2]> {
    let mut couples = Vec::new();
    for &a in loose {
        for b in (0..mechanism.links.len()).map(LinkId::at).filter(|b| *b != a) {
            if !(loose.contains(&b) && b < a) {
                couples.push(if a < b { [a, b] } else { [b, a] });
            }
        }
    }
    couples
}

/// Hinges at points of one name.
fn hinges(mechanism: &Mechanism, uses: &Uses<'_>, couples: &[[LinkId; 2]]) -> Vec<Candidate> {
    let mut out = Vec::new();
    for &[a, b] in couples {
        for point in &mechanism.link(a).points {
            let Some(twin) = mechanism.link(b).points.iter().find(|p| p.name == point.name) else { continue };
            if are_hinged(mechanism, (a, &point.name), (b, &twin.name)) {
                continue;
            }
            let pin = |link, at| Pin { link, name: point.name.clone(), at };
            out.push(Candidate {
                name: point.name.clone(),
                kind: PairKind::Revolute(vec![pin(a, point.at), pin(b, twin.at)]),
                used: uses.count(a, &point.name) + uses.count(b, &twin.name),
            });
        }
    }
    out
}

/// Pins at points of one name that three links or more have, where no two of them are joined.
fn pins(mechanism: &Mechanism, uses: &Uses<'_>, loose: &[LinkId]) -> Vec<Candidate> {
    let mut out: Vec<Candidate> = Vec::new();
    for point in loose.iter().flat_map(|link| &mechanism.link(*link).points) {
        let name = &point.name;
        let at = |link: LinkId| mechanism.link(link).points.iter().find(|p| p.name == *name);
        let ids = (0..mechanism.links.len()).map(LinkId::at);
        let pins: Vec<Pin> = ids
            .filter_map(|link| at(link).map(|p| Pin { link, name: name.clone(), at: p.at }))
            .filter(|pin| uses.count(pin.link, name) == 0)
            .collect();
        if pins.len() < 3 || out.iter().any(|other| other.name == *name) {
            continue;
        }
        out.push(Candidate { name: name.clone(), kind: PairKind::Revolute(pins), used: 0 });
    }
    out
}

fn are_hinged(mechanism: &Mechanism, a: (LinkId, &str), b: (LinkId, &str)) -> bool {
    mechanism.pairs.iter().any(|p| match &p.kind {
        PairKind::Revolute(pins) => {
            [a, b].iter().all(|e| pins.iter().any(|p| p.link == e.0 && p.name == e.1))
        }
        _ => false,
    })
}

/// Points on lines, as prismatic pairs and as slots.
fn guides(mechanism: &Mechanism, uses: &Uses<'_>, couples: &[[LinkId; 2]]) -> Vec<Candidate> {
    let mut out = Vec::new();
    for &[a, b] in couples {
        for (slider, base) in [(a, b), (b, a)] {
            for line in &mechanism.link(base).lines {
                for point in &mechanism.link(slider).points {
                    let of_line = uses.count(base, &line.name);
                    let of_point = uses.count(slider, &point.name) + uses.of_lines(slider, point);
                    if of_point > 0 && of_line > 0 && !has_one_pair(mechanism, slider) {
                        continue;
                    }
                    let guide = guide((slider, &point.name, point.at), (base, line));
                    let used = of_point + 2 * of_line;
                    let offer = |kind| Candidate { name: point.name.clone(), kind, used: 1 + used };
                    out.push(offer(PairKind::Prismatic(guide.clone())));
                    out.push(offer(PairKind::Slot(guide)));
                }
            }
        }
    }
    out
}

/// Lines on lines that no other pair uses.
fn faces(mechanism: &Mechanism, uses: &Uses<'_>, couples: &[[LinkId; 2]]) -> Vec<Candidate> {
    let unused = |link: LinkId| {
        let lines = mechanism.link(link).lines.iter();
        lines.filter(move |line| uses.count(link, &line.name) == 0)
    };
    let mut out = Vec::new();
    for &[base, slider] in couples {
        for (own, line) in unused(slider).flat_map(|own| unused(base).map(move |line| (own, line))) {
            let points = &mechanism.link(slider).points;
            let Some(point) = points.iter().find(|point| point.at == own.through) else { continue };
            let guide = Guide {
                direction: own.along,
                own_line: Some(own.name.clone()),
                ..guide((slider, &point.name, point.at), (base, line))
            };
            out.push(Candidate { name: "c".to_owned(), kind: PairKind::Prismatic(guide), used: 0 });
        }
    }
    out
}

fn has_one_pair(mechanism: &Mechanism, link: LinkId) -> bool {
    link != LinkId::GROUND && pairs_of(mechanism, link).len() == 1
}

pub(super) fn guide(
    (slider, point_name, point): (LinkId, &str, Vec2),
    (guide, line): (LinkId, &Line),
) -> Guide {
    Guide {
        slider,
        point_name: point_name.to_owned(),
        point,
        direction: Vec2::new(1.0, 0.0),
        own_line: None,
        guide,
        line_name: line.name.clone(),
        through: line.through,
        along: line.along,
        contacts: None,
        guide_first: false,
    }
}

/// Contacts of circles with circles and lines.
fn contacts(mechanism: &Mechanism, uses: &Uses<'_>, couples: &[[LinkId; 2]]) -> Vec<Candidate> {
    let circle = |link, c: &Circle| Profile {
        link,
        name: c.name.clone(),
        shape: ProfileShape::Circle(c.centre, c.radius),
    };
    let line = |link, l: &Line| Profile {
        link,
        name: l.name.clone(),
        shape: ProfileShape::Line(l.through, l.along),
    };
    let mut out = Vec::new();
    for &[a, b] in couples {
        for (one, other) in [(a, b), (b, a)] {
            let (one_link, other_link) = (mechanism.link(one), mechanism.link(other));
            for first in one_link.circles.iter().map(|c| circle(one, c)) {
                // two circles once
                let circles = other_link.circles.iter().filter(|_| one < other).map(|c| circle(other, c));
                for second in circles.chain(other_link.lines.iter().map(|l| line(other, l))) {
                    let used = uses.count(one, &first.name) + uses.count(other, &second.name);
                    out.push(Candidate {
                        name: "K".to_owned(),
                        kind: PairKind::Contact {
                            first: first.clone(),
                            second,
                            internal: false,
                            parts: false,
                        },
                        used: 1 + used,
                    });
                }
            }
        }
    }
    out
}

/// Gear pairs of wheels that nothing runs on yet: each with such a wheel of what is loose, else with any wheel of that.
pub(super) fn missing_meshes(trial: Trial<'_>, defect: &Defect) -> Vec<String> {
    let wheels = &trial.mechanism.wheels;
    let idle: Vec<&Wheel> = wheels
        .iter()
        .filter(|w| running(trial.mechanism, &w.name).next().is_none())
        .take(MOST_TRIED)
        .collect();
    let loose: Vec<LinkId> = links(trial.replaced, &defect.loose).collect();
    let of_loose = |wheels: &[&Wheel]| meshes(trial.mechanism, &loose, wheels, &idle);
    let both_idle = of_loose(&idle);
    if both_idle.is_empty() { of_loose(&wheels.iter().collect::<Vec<_>>()) } else { both_idle }
}

fn meshes(mechanism: &Mechanism, loose: &[LinkId], wheels: &[&Wheel], idle: &[&Wheel]) -> Vec<String> {
    let taken = |name: &str| is_taken(mechanism, name, None);
    let mut lines = Vec::new();
    for wheel in loose.iter().flat_map(|l| wheels.iter().filter(move |w| w.link == *l)) {
        for other in idle.iter().filter(|other| other.link != wheel.link && can_mesh(other, wheel)) {
            let (a, b) = if other.span.start < wheel.span.start { (other, wheel) } else { (wheel, other) };
            let is_around = is_around(mechanism, other, wheel);
            let word = if is_around { "mesh" } else { transmission(mechanism, a, b) };
            let around = if is_around { " { internal }" } else { "" };
            let line = format!("{word} {}: {} - {}{around}", free_name("k", taken), a.name, b.name);
            // the wheel that fits into the ring of another is its sun
            let fits = is_around || is_sun(mechanism, other, wheel);
            if !lines.contains(&(!fits, line.clone())) {
                lines.push((!fits, line));
            }
        }
    }
    lines.sort_by_key(|line| line.0);
    lines.truncate(if lines.first().is_some_and(|line| !line.0) { 1 } else { MOST_SHOWN - 1 });
    lines.into_iter().map(|line| line.1).collect()
}

/// What runs between two wheels: teeth that may meet do, and pulleys only where they touch.
fn transmission(mechanism: &Mechanism, a: &Wheel, b: &Wheel) -> &'static str {
    let of_teeth = a.teeth.zip(b.teeth);
    let known = if a.open { b } else { a };
    let sum = match of_teeth {
        Some((of_a, of_b)) => known.teeth.map(|own| known.radius / own * (of_a + of_b)),
        None => (!a.open && !b.open).then_some(a.radius + b.radius),
    };
    let Some(sum) = sum.filter(|_| !known.open) else { return "mesh" };
    let is_apart = apart(mechanism, a, b).map(|distance| distance - sum > SAME * sum);
    match (of_teeth.is_some(), is_apart) {
        (true, Some(true)) => "chain",
        (false, None | Some(true)) => "belt",
        (true, _) | (false, Some(false)) => "mesh",
    }
}

/// How far apart the axes of two wheels are that turn on one link.
fn apart(mechanism: &Mechanism, a: &Wheel, b: &Wheel) -> Option<f64> {
    let axis = |wheel: &Wheel| {
        mechanism.pairs.iter().find_map(|pair| {
            let PairKind::Revolute(pins) = &pair.kind else { return None };
            let [one, other] = pins.as_slice() else { return None };
            let on = if one.link == wheel.link { other } else { one };
            let own = if one.link == wheel.link { one } else { other };
            let is_axis = own.link == wheel.link && wheel.centre == Some(own.at);
            is_axis.then_some((on.link, on.at))
        })
    };
    let (of_a, of_b) = (axis(a)?, axis(b)?);
    (of_a.0 == of_b.0).then(|| (of_a.1 - of_b.1).norm())
}

/// Whether two wheels have teeth of one size, as far as both are known.
fn can_mesh(a: &Wheel, b: &Wheel) -> bool {
    let size = |wheel: &Wheel| wheel.teeth.filter(|_| !wheel.open).map(|teeth| wheel.radius / teeth);
    let (Some(of_a), Some(of_b)) = (size(a), size(b)) else { return a.teeth.is_some() == b.teeth.is_some() };
    (of_a - of_b).abs() <= SAME * of_a
}

/// The transmissions in which a wheel or a slider runs.
pub(super) fn running<'m>(mechanism: &'m Mechanism, name: &'m str) -> impl Iterator<Item = &'m [String]> {
    mechanism.pairs.iter().filter_map(move |pair| match &pair.kind {
        PairKind::Transmission(t) => {
            let is_end = |end: &String| end.split(['(', ')']).any(|word| word == name);
            t.ends.iter().any(is_end).then_some(t.ends.as_slice())
        }
        _ => None,
    })
}

/// Whether a wheel has the teeth of a ring around another one and a wheel with which that runs already.
fn is_around(mechanism: &Mechanism, ring: &Wheel, planet: &Wheel) -> bool {
    beside(mechanism, planet).any(|sun| is_ring(ring, sun, planet))
}

/// Whether a wheel has the teeth of a sun between another one and a ring in which that runs already.
fn is_sun(mechanism: &Mechanism, sun: &Wheel, planet: &Wheel) -> bool {
    beside(mechanism, planet).any(|ring| is_ring(ring, sun, planet))
}

fn is_ring(ring: &Wheel, sun: &Wheel, planet: &Wheel) -> bool {
    let around = sun.teeth.zip(planet.teeth).map(|(sun, planet)| sun + 2.0 * planet);
    around.is_some() && ring.teeth == around
}

/// The wheels with which a wheel runs.
fn beside<'m>(mechanism: &'m Mechanism, wheel: &'m Wheel) -> impl Iterator<Item = &'m Wheel> {
    running(mechanism, &wheel.name).flat_map(|ends| {
        let others = mechanism.wheels.iter().filter(|other| other.name != wheel.name);
        others.filter(|other| ends.contains(&other.name))
    })
}
