//! Cylinders and ropes whose lines may be lost, where something can still move: between points, wheels and sliders that nothing uses.

use super::add_effort::{Adds, missing_efforts};
use super::add_pair::running;
use super::defect::{Defect, Fit};
use super::effort;
use super::incidence::Incidence;
use super::order::Named;
use super::replace;
use super::trial::Trial;
use super::uses::Uses;
use super::words::{is_structure, links};
use crate::math::Vec2;
use crate::model::{
    DriveTarget, Law, LinkId, LinkPoint, Mechanism, PairId, PairKind, Point, Profile, ProfileShape, Rate,
    Transmission, TransmissionKind,
};

/// Couples of points tried.
const MOST_TRIED: usize = 48;
/// Alternatives.
const MOST_SHOWN: usize = 3;

/// What may be lost, and what else would hold the same.
#[derive(Clone, Debug, Default)]
pub struct Lost {
    /// Alternatives: after all statements of one of them nothing is loose, the cylinders driven.
    pub ways: Vec<Vec<LostPair>>,
    /// Lines of drives that hold the same freedoms, at some values.
    pub drives: Vec<String>,
}

/// A statement that may be lost.
#[derive(Clone, Debug, PartialEq)]
pub struct LostPair {
    /// `ground.G - boom.K`
    pub ends: String,
    /// The points that a cylinder joins; none of a rope.
    pub cylinder: Option<[LinkPoint; 2]>,
}

struct Candidate {
    pair: LostPair,
    /// As it takes a freedom: a driven cylinder is a rod.
    kind: PairKind,
    unlikely: usize,
}

/// What may be lost of a mechanism that is underconstrained and nowhere overconstrained. Where so many pairs are named and
/// not declared, a cylinder may end at a point that another pair uses, and it may hold nothing.
#[must_use]
pub fn lost(mechanism: &Mechanism, named: usize) -> Lost {
    let replaced = replace::replace(mechanism);
    let efforts = effort::of_drives(mechanism, &replaced);
    let trial = Trial { mechanism, replaced: &replaced, efforts: &efforts };
    let defect = match Incidence::new(&replaced, &efforts).defect(&replaced) {
        Some(defect) if defect.fit.surplus == 0 => defect,
        None if named > 0 => return Lost { ways: idle_cylinders(mechanism, named), drives: Vec::new() },
        _ => return Lost::default(),
    };
    let ways = ways(trial, &defect, named > 0);
    let drives = match ways.is_empty() {
        true => Vec::new(),
        false => missing_efforts(trial, &defect, Adds::Drives),
    };
    Lost { ways, drives }
}

/// Cylinders that hold nothing: what else is said of them is lost with them.
fn idle_cylinders(mechanism: &Mechanism, named: usize) -> Vec<Vec<LostPair>> {
    let moving: Vec<LinkId> = (1..mechanism.links.len()).map(LinkId::at).collect();
    let mut candidates = cylinders(mechanism, &moving, false);
    // which of more points is meant is not known
    let idle = Idle::of(mechanism);
    let points = mechanism
        .links
        .iter()
        .enumerate()
        .flat_map(|(i, link)| link.points.iter().map(move |p| (LinkId::at(i), p)));
    if points.filter(|(link, point)| idle.has(*link, point)).count() != 2 * named {
        return Vec::new();
    }
    candidates.sort_by_key(|candidate| candidate.unlikely);
    let mut pairs = Vec::<LostPair>::new();
    for candidate in candidates {
        if pairs.len() < named && pairs.iter().all(|pair| !share(&pair.ends, &candidate.pair.ends)) {
            pairs.push(candidate.pair);
        }
    }
    if pairs.len() == named { vec![pairs] } else { Vec::new() }
}

fn ways(trial: Trial<'_>, defect: &Defect, is_named: bool) -> Vec<Vec<LostPair>> {
    let loose: Vec<LinkId> = links(trial.replaced, &defect.loose).collect();
    let mut candidates = ropes(trial.mechanism, &loose);
    if !is_structure(trial.mechanism) {
        candidates.extend(cylinders(trial.mechanism, &loose, is_named));
    }
    candidates.sort_by_key(|candidate| candidate.unlikely);
    candidates.truncate(trial.most_tried(MOST_TRIED));
    let missing = defect.fit.missing;
    if missing == 1 {
        let holds = |c: &Candidate| trial.with(std::slice::from_ref(&c.kind), &[]).fit() == Fit::default();
        let found = candidates.into_iter().filter(holds).take(MOST_SHOWN);
        return found.map(|candidate| vec![candidate.pair]).collect();
    }
    let (mut kinds, mut pairs) = (Vec::new(), Vec::<LostPair>::new());
    for candidate in candidates {
        let is_new = pairs.iter().all(|pair| !share(&pair.ends, &candidate.pair.ends));
        if !is_new || pairs.len() == missing {
            continue;
        }
        kinds.push(candidate.kind);
        let now = trial.with(&kinds, &[]).fit();
        if now.surplus == 0 && now.missing + kinds.len() == missing {
            pairs.push(candidate.pair);
        } else {
            kinds.pop();
        }
    }
    if pairs.len() == missing && missing > 0 { vec![pairs] } else { Vec::new() }
}

/// Whether two statements have an end in common.
fn share(one: &str, other: &str) -> bool {
    one.split(" - ").any(|end| other.split(" - ").any(|of_other| of_other == end))
}

/// Between points that nothing uses, or one of which something uses, of links of which one is loose at least.
fn cylinders(mechanism: &Mechanism, loose: &[LinkId], with_used: bool) -> Vec<Candidate> {
    let idle = Idle::of(mechanism);
    let points: Vec<(LinkId, &Point, bool)> = (0..mechanism.links.len())
        .map(LinkId::at)
        .flat_map(|link| mechanism.link(link).points.iter().map(move |point| (link, point)))
        .map(|(link, point)| (link, point, !idle.has(link, point)))
        .filter(|point| with_used || !point.2)
        .take(MOST_TRIED)
        .collect();
    let mut out = Vec::new();
    for (i, &(link, from, is_used)) in points.iter().enumerate() {
        for &(other, to, of_other) in points.iter().skip(i + 1).filter(|point| point.0 != link) {
            let is_loose = loose.contains(&link) || loose.contains(&other);
            if !is_loose || is_used && of_other {
                continue;
            }
            let profile = |link, point: &Point| Profile {
                link,
                name: point.name.clone(),
                shape: ProfileShape::Point(point.at),
            };
            let name = |link: LinkId, point: &Point| format!("{}.{}", mechanism.link(link).name, point.name);
            out.push(Candidate {
                pair: LostPair {
                    ends: format!("{} - {}", name(link, from), name(other, to)),
                    cylinder: Some([(link, from.at), (other, to.at)]),
                },
                kind: PairKind::Contact {
                    first: profile(link, from),
                    second: profile(other, to),
                    internal: false,
                    parts: false,
                },
                unlikely: 1
                    + usize::from(!are_alike(&from.name, &to.name))
                    + 2 * usize::from(is_used || of_other),
            });
        }
    }
    out
}

/// Points of one letter, or of one number: `K1` and `G1`.
fn are_alike(one: &str, other: &str) -> bool {
    let parts = |name: &str| {
        let letters = name.trim_end_matches(|c: char| c.is_ascii_digit());
        (letters.to_owned(), name[letters.len()..].to_owned())
    };
    let (one, other) = (parts(one), parts(other));
    one.0 == other.0 || !one.1.is_empty() && one.1 == other.1
}

/// Points that no statement uses.
struct Idle<'a> {
    mechanism: &'a Mechanism,
    uses: Uses<'a>,
    named: Named,
    points: Vec<LinkPoint>,
}

impl<'a> Idle<'a> {
    fn of(mechanism: &'a Mechanism) -> Self {
        let mut named = Named::one_by_one(mechanism);
        mechanism.expects.iter().for_each(|expect| named.ask(&expect.expr));
        let mut points: Vec<LinkPoint> = Vec::new();
        points.extend(mechanism.drives.iter().filter_map(|drive| match drive.target {
            DriveTarget::Point(link, at) | DriveTarget::Place(link, at, _) => Some((link, at)),
            DriveTarget::Link(_) | DriveTarget::Pair(_) => None,
        }));
        let wheels = mechanism.wheels.iter();
        points.extend(wheels.filter_map(|wheel| Some((wheel.link, wheel.centre?))));
        Self { mechanism, uses: Uses::of(mechanism, None), named, points }
    }

    fn has(&self, link: LinkId, point: &Point) -> bool {
        let of = self.mechanism.link(link);
        let is_named = self.named.has_point(link, point.at) || self.points.contains(&(link, point.at));
        self.uses.count(link, &point.name) == 0
            && !is_named
            && of.lines.iter().all(|line| line.through != point.at)
            && of.circles.iter().all(|circle| circle.centre != point.at)
            && of.mass.as_ref().is_none_or(|mass| mass.centre != point.at)
            && !of.name.contains('.')
            // what is pinned there under another name
            && !self.is_pinned(link, point.at)
    }

    fn is_pinned(&self, link: LinkId, at: Vec2) -> bool {
        self.mechanism.pairs.iter().any(|pair| match &pair.kind {
            PairKind::Revolute(pins) | PairKind::Weld { pins, .. } => {
                pins.iter().any(|pin| pin.link == link && pin.at == at)
            }
            _ => false,
        })
    }
}

/// Between sliders of a train and wheels that nothing runs on.
fn ropes(mechanism: &Mechanism, loose: &[LinkId]) -> Vec<Candidate> {
    let idle = |name: &str| running(mechanism, name).next().is_none();
    let sliders: Vec<(PairId, LinkId)> = mechanism
        .pairs
        .iter()
        .enumerate()
        .filter_map(|(i, pair)| match &pair.kind {
            PairKind::Prismatic(guide) if pair.bearing.is_some() => Some((PairId::at(i), guide.slider)),
            _ => None,
        })
        .filter(|(_, slider)| idle(&mechanism.link(*slider).name))
        .collect();
    let mut out = Vec::new();
    for (pair, slider) in sliders {
        for wheel in mechanism.wheels.iter().filter(|wheel| idle(&wheel.name)) {
            if !loose.contains(&slider) && !loose.contains(&wheel.link) {
                continue;
            }
            let law = Law {
                terms: vec![(Rate::Slide(pair), 1.0), (Rate::Turn(wheel.link), 1.0)],
                constant: 0.0,
                force: 1.0,
                efficiency: None,
            };
            out.push(Candidate {
                pair: LostPair {
                    ends: format!("{} - {}", mechanism.link(slider).name, wheel.name),
                    cylinder: None,
                },
                kind: PairKind::Transmission(Transmission {
                    kind: TransmissionKind::Rope,
                    ends: Vec::new(),
                    links: vec![slider, wheel.link],
                    laws: vec![law],
                    meeting: None,
                    bevel: None,
                    pressure_angle: None,
                    grip: None,
                    slip: 0.0,
                    freewheel: 0.0,
                }),
                unlikely: 0,
            });
        }
    }
    out
}
