//! Ropes in front view: straight down from their wheels and pulleys, up to idlers and to the ground.

use super::layout::{Layout, wheel_named};
use super::{BLOCK, NAME, SMALL};
use crate::symbol::{gear, hinge};
use assur_drawing::{Drawing, Label, Shape, Style, Text};
use assur_math::math::Vec2;
use assur_model::model::{LinkId, Mechanism, PairKind, Rate, Transmission, TransmissionKind};

/// Radius of a pulley or an idler, where no two parts of a rope give it.
const PULLEY: f64 = 4.0;
/// From idlers to all wheels, and from these to what ropes carry.
const ABOVE: f64 = 11.0;
const BELOW: f64 = 13.0;
/// From an idler to the next one, and between a pulley and its weight.
const BESIDE: f64 = 14.0;
const HOOK: f64 = 3.5;
/// From an idler to the ceiling.
const CEILING: f64 = 2.5;
/// Weights nearer than this hang at different heights; how much lower.
const NEAR: f64 = 15.0;
const LOWER: f64 = 15.0;

/// What a rope touches.
#[derive(Clone, Debug)]
enum Station {
    /// A drawn wheel.
    Wheel(usize),
    Slider(LinkId),
    /// The pulley of a slider.
    Under(LinkId),
    /// An idler by its name.
    Over(String),
    Ground,
}

impl Station {
    const fn is_high(&self) -> bool {
        matches!(self, Self::Over(_) | Self::Ground)
    }

    const fn is_pulley(&self) -> bool {
        matches!(self, Self::Over(_) | Self::Under(_))
    }
}

/// A rope with the places of its parts: of a pulley its middle and radius, of all else where the rope is.
pub struct Rope<'l> {
    name: &'l str,
    stations: Vec<Station>,
    sides: Vec<f64>,
    /// The abscissa of each upright part; none of one that lies between two pulleys or two wheels.
    parts: Vec<Option<f64>>,
    pulleys: Vec<Option<(f64, f64)>>,
}

/// The wheels of a front view: abscissas of their middles with their radii, by drawn wheel.
pub type Discs<'d> = dyn Fn(usize) -> (f64, f64) + 'd;

/// All ropes that have a wheel or a slider of the train.
pub fn ropes<'l>(mechanism: &'l Mechanism, layout: &Layout, discs: &Discs<'_>) -> Vec<Rope<'l>> {
    let ropes = mechanism.pairs.iter().filter_map(|pair| match &pair.kind {
        PairKind::Transmission(t) if t.kind == TransmissionKind::Rope => Some((pair.name.as_str(), t)),
        _ => None,
    });
    ropes.map(|(name, t)| Rope::of(mechanism, layout, (name, t), discs)).collect()
}

/// The drawn wheels that a rope touches.
pub fn wheels(mechanism: &Mechanism, layout: &Layout, t: &Transmission) -> Vec<usize> {
    let own = stations(mechanism, layout, t).into_iter().filter_map(|station| match station {
        Station::Wheel(wheel) => Some(wheel),
        _ => None,
    });
    own.collect()
}

fn stations(mechanism: &Mechanism, layout: &Layout, t: &Transmission) -> Vec<Station> {
    let station = |end: &String| {
        let inner = |word: &str| end.strip_prefix(word)?.strip_suffix(')');
        let slider = |name: &str| mechanism.links.iter().position(|l| l.name == name).map(LinkId::at);
        if let Some(name) = inner("over(") {
            return Station::Over(name.to_owned());
        }
        if let Some(link) = inner("under(").and_then(slider) {
            return Station::Under(link);
        }
        let index = wheel_named(mechanism, end);
        let drawn = index.and_then(|i| layout.wheels.iter().position(|w| w.wheel == i));
        match (drawn, slider(end)) {
            (Some(wheel), _) => Station::Wheel(wheel),
            (None, Some(link)) if link != LinkId::GROUND => Station::Slider(link),
            _ => Station::Ground,
        }
    };
    t.ends.iter().map(station).collect()
}

impl<'l> Rope<'l> {
    fn of(
        mechanism: &Mechanism,
        layout: &Layout,
        (name, t): (&'l str, &Transmission),
        discs: &Discs<'_>,
    ) -> Self {
        let stations = stations(mechanism, layout, t);
        let sides = sides(mechanism, layout, t, &stations);
        let mut parts: Vec<Option<f64>> = vec![None; stations.len().saturating_sub(1)];
        for (i, station) in stations.iter().enumerate() {
            let Station::Wheel(wheel) = station else { continue };
            let (x, radius) = discs(*wheel);
            for (part, side) in
                [(i.checked_sub(1), sides[i]), (Some(i), if i > 0 { -sides[i] } else { sides[i] })]
            {
                if let Some(place) = part.and_then(|part| parts.get_mut(part)) {
                    *place = Some(x + side * radius);
                }
            }
        }
        for i in 0..parts.len() {
            if matches!((&stations[i], &stations[i + 1]), (Station::Wheel(_), Station::Wheel(_))) {
                parts[i] = None;
            }
        }
        let mut rope = Self { name, pulleys: vec![None; stations.len()], stations, sides, parts };
        let without = rope.stations.iter().all(|s| !matches!(s, Station::Wheel(_)));
        if without && !rope.parts.is_empty() {
            let right = (0..layout.wheels.len()).map(discs).map(|(x, r)| x + r).fold(0.0, f64::max);
            rope.parts[0] = Some(right + BESIDE);
        }
        // the largest wheel on the axis of each
        let level = |wheel: usize| layout.wheels[wheel].level;
        let largest = |station: &Station| {
            let Station::Wheel(own) = station else { return None };
            let same = (0..layout.wheels.len()).filter(|i| (level(*i) - level(*own)).abs() < 0.5);
            Some((discs(*own).0, same.map(|i| discs(i).1).fold(0.0, f64::max)))
        };
        let reaches: Vec<Option<(f64, f64)>> = rope.stations.iter().map(largest).collect();
        rope.spread(&reaches);
        rope
    }

    /// From the parts at wheels to those behind pulleys, away from the wheel.
    fn spread(&mut self, reaches: &[Option<(f64, f64)>]) {
        let count = self.stations.len();
        for forward in [true, false] {
            let (mut outwards, mut beyond) = (1.0, None);
            for step in 0..count {
                let i = if forward { step } else { count - 1 - step };
                if matches!(self.stations[i], Station::Wheel(_)) {
                    let behind = forward && i > 0 && i + 1 < count;
                    outwards = if behind { -self.sides[i] } else { self.sides[i] };
                    beyond = reaches[i].map(|(x, radius)| x + outwards * (radius + 4.0));
                }
                if self.stations[i].is_pulley() {
                    self.around(i, forward, (outwards, beyond.take()));
                }
            }
        }
    }

    /// A pulley beside the part that comes to it, and the part that leaves it.
    fn around(&mut self, i: usize, forward: bool, (outwards, beyond): (f64, Option<f64>)) {
        let (comes, leaves) = if forward { (i - 1, i) } else { (i, i - 1) };
        let before = if forward { i - 1 } else { i + 1 };
        let after = if forward { i + 1 } else { i - 1 };
        let flat = |s: &Self, other: usize| {
            s.stations[other].is_pulley() && s.stations[other].is_high() == s.stations[i].is_high()
        };
        let place = match (self.parts[comes], self.parts[leaves]) {
            (Some(a), Some(b)) => Some(((a + b) / 2.0, (a - b).abs() / 2.0)),
            (Some(x), None) => {
                // past the largest wheel on the axis
                let carries = |other: usize| matches!(self.stations[other], Station::Slider(_));
                let least = if carries(before) && carries(after) { NEAR / 2.0 + 0.5 } else { PULLEY };
                let radius =
                    beyond.map_or(least, |far| ((far - x) * outwards / 2.0).clamp(PULLEY, 3.0 * PULLEY));
                Some((x + outwards * radius, radius))
            }
            (None, _) if flat(self, before) => {
                self.pulleys[before].map(|(x, _)| (x + outwards * BESIDE, PULLEY))
            }
            _ => None,
        };
        let Some((x, radius)) = place else { return };
        self.pulleys[i] = Some((x, radius.max(1.0)));
        if self.parts[leaves].is_none() && !flat(self, after) {
            self.parts[leaves] = Some(x + outwards * radius);
        }
    }

    /// The least abscissa that it takes.
    pub fn left(&self) -> f64 {
        let parts = self.parts.iter().flatten().map(|x| x - BLOCK.x);
        let pulleys = self.pulleys.iter().flatten().map(|(x, r)| x - r.max(BLOCK.x));
        parts.chain(pulleys).fold(f64::INFINITY, f64::min)
    }

    /// The greatest abscissa that it takes.
    pub fn right(&self) -> f64 {
        self.parts.iter().flatten().copied().fold(f64::NEG_INFINITY, f64::max)
    }

    /// How often a part passes before a wheel of another axis.
    pub fn crossed(&self, discs: &[(f64, f64)], own: &Discs<'_>) -> usize {
        let axes: Vec<f64> = self
            .stations
            .iter()
            .filter_map(|s| match s {
                Station::Wheel(wheel) => Some(own(*wheel).0),
                _ => None,
            })
            .collect();
        let other = |x: f64| {
            discs
                .iter()
                .filter(|(at, r)| (x - at).abs() < *r && axes.iter().all(|axis| (axis - at).abs() > 0.5))
                .count()
        };
        self.parts.iter().flatten().map(|x| other(*x)).sum()
    }

    /// Draws it between the greatest and the least height of all wheels; where its sliders hang.
    pub fn draw(
        &self,
        drawing: &mut Drawing,
        (axis, top, bottom): (f64, f64, f64),
        (discs, taken): (&Discs<'_>, &mut Vec<(LinkId, Vec2)>),
    ) {
        drawing.begin("pair", self.name);
        let high = top - ABOVE;
        let weights = self.weights(bottom, taken);
        let height = |i: usize| match &self.stations[i] {
            Station::Wheel(_) => axis,
            Station::Over(_) | Station::Ground => high,
            Station::Slider(link) => hangs(&weights, *link).y - BLOCK.y,
            Station::Under(link) => {
                hangs(&weights, *link).y - BLOCK.y - HOOK - self.pulleys[i].map_or(PULLEY, |p| p.1)
            }
        };
        let mut longest: Option<(Vec2, Vec2)> = None;
        for (i, part) in self.parts.iter().enumerate() {
            let ends = match part {
                Some(x) => [i, i + 1].map(|end| Vec2::new(*x, height(end))),
                None => self
                    .between(i, axis, discs)
                    .unwrap_or_else(|| [i, i + 1].map(|end| self.flat(end, height(end), discs))),
            };
            drawing.line(Style::Medium, ends[0], ends[1]);
            let length = (ends[1] - ends[0]).norm();
            if longest.is_none_or(|(a, b)| (b - a).norm() < length) {
                longest = Some((ends[0], ends[1]));
            }
        }
        for (i, station) in self.stations.iter().enumerate() {
            self.station(drawing, (i, station), &weights, height(i));
        }
        if let Some((a, b)) = longest {
            let words = format!("{} (rope)", self.name);
            drawing.label(Label::along(Text::upright(&words), SMALL, a, b).ranked(5));
        }
        let new: Vec<_> = weights.into_iter().filter(|w| taken.iter().all(|t| t.0 != w.0)).collect();
        taken.extend(new);
        drawing.end();
    }

    fn station(
        &self,
        drawing: &mut Drawing,
        (i, station): (usize, &Station),
        weights: &[(LinkId, Vec2)],
        y: f64,
    ) {
        if let (Some((x, radius)), true) = (self.pulleys[i], station.is_pulley()) {
            let centre = Vec2::new(x, y);
            drawing.mark(Style::Hinge, Shape::Circle { centre, radius });
            match station {
                Station::Under(link) => {
                    let at = hangs(weights, *link);
                    drawing.line(
                        Style::Link,
                        centre,
                        Vec2::new(at.x.clamp(x - BLOCK.x, x + BLOCK.x), at.y - BLOCK.y),
                    );
                    hinge::moving(drawing, centre);
                }
                Station::Over(name) => {
                    let ceiling = centre - Vec2::new(0.0, radius + CEILING);
                    drawing.line(Style::Link, centre, ceiling);
                    fixed(drawing, ceiling);
                    hinge::moving(drawing, centre);
                    drawing.label(Label::at(Text::upright(name), NAME, centre, radius).ranked(4));
                }
                _ => {}
            }
        }
        if let Station::Ground = station {
            let part = if i == 0 { self.parts.first() } else { self.parts.get(i - 1) };
            let Some(x) = part.copied().flatten() else { return };
            fixed(drawing, Vec2::new(x, y));
        }
    }

    /// A part between two wheels, above or between them as they turn.
    fn between(&self, i: usize, axis: f64, discs: &Discs<'_>) -> Option<[Vec2; 2]> {
        let (Station::Wheel(a), Station::Wheel(b)) = (&self.stations[i], &self.stations[i + 1]) else {
            return None;
        };
        let circle = |wheel: usize| (Vec2::new(discs(wheel).0, axis), discs(wheel).1);
        let leaves = if i == 0 { self.sides[i] } else { -self.sides[i] };
        let tangents = gear::tangents(circle(*a), circle(*b), leaves * self.sides[i + 1] > 0.0)?;
        let (from, to) = tangents.into_iter().min_by(|one, other| one.0.y.total_cmp(&other.0.y))?;
        Some([from, to])
    }

    /// Where a part that lies begins: on top of an idler or a wheel, below a movable pulley.
    fn flat(&self, i: usize, y: f64, discs: &Discs<'_>) -> Vec2 {
        match (&self.stations[i], self.pulleys[i]) {
            (Station::Wheel(wheel), _) => {
                let (x, radius) = discs(*wheel);
                Vec2::new(x, y - radius)
            }
            (Station::Under(_), Some((x, radius))) => Vec2::new(x, y + radius),
            (_, Some((x, radius))) => Vec2::new(x, y - radius),
            _ => Vec2::new(0.0, y),
        }
    }

    /// Sliders below all wheels, none on another.
    fn weights(&self, bottom: f64, taken: &[(LinkId, Vec2)]) -> Vec<(LinkId, Vec2)> {
        let mut weights: Vec<(LinkId, Vec2)> = Vec::new();
        for (i, station) in self.stations.iter().enumerate() {
            let (link, x, room) = match station {
                Station::Slider(link) => {
                    let part = if i == 0 { self.parts[0] } else { self.parts[i - 1] };
                    (*link, part.unwrap_or(0.0), 0.0)
                }
                Station::Under(link) => {
                    let own = self.stations.iter().zip(&self.pulleys);
                    let own = own
                        .filter(|(s, _)| matches!(s, Station::Under(l) if l == link))
                        .filter_map(|(_, p)| *p);
                    let places: Vec<(f64, f64)> = own.collect();
                    let middle = places.iter().map(|p| p.0).sum::<f64>() / places.len().max(1) as f64;
                    (*link, middle, places.iter().map(|p| 2.0 * p.1).fold(0.0, f64::max) + HOOK)
                }
                _ => continue,
            };
            if weights.iter().any(|w| w.0 == link) {
                continue;
            }
            if let Some(known) = taken.iter().find(|t| t.0 == link) {
                weights.push(*known);
                continue;
            }
            let mut at = Vec2::new(x, bottom + BELOW + BLOCK.y + room);
            let clash = |at: Vec2| {
                let near =
                    |other: &Vec2| (other.x - at.x).abs() < NEAR && (other.y - at.y).abs() < LOWER - 1.0;
                taken.iter().chain(&weights).any(|(_, other)| near(other))
            };
            while clash(at) {
                at.y += LOWER;
            }
            weights.push((link, at));
        }
        weights
    }
}

/// A piece of the ceiling.
fn fixed(drawing: &mut Drawing, at: Vec2) {
    let half = Vec2::new(4.0, 0.0);
    drawing.line(Style::Medium, at - half, at + half);
    hinge::hatch(drawing, at - half, at + half, Vec2::new(0.0, -1.0));
}

fn hangs(weights: &[(LinkId, Vec2)], link: LinkId) -> Vec2 {
    weights.iter().find(|w| w.0 == link).map_or(Vec2::zero(), |w| w.1)
}

/// On which side of its wheel the part before each station is, and for the first the part behind it, so that the rope keeps
/// its length as its laws say. Seen from the front, counter-clockwise is positive.
fn sides(mechanism: &Mechanism, layout: &Layout, t: &Transmission, stations: &[Station]) -> Vec<f64> {
    let at: Vec<usize> = (0..stations.len()).filter(|i| matches!(stations[*i], Station::Wheel(_))).collect();
    let trial = |bits: usize| {
        let mut sides = vec![1.0; stations.len()];
        for (bit, i) in at.iter().enumerate() {
            sides[*i] = if bits >> bit & 1 == 1 { -1.0 } else { 1.0 };
        }
        sides
    };
    let trials = (0..1usize << at.len().min(6)).map(trial);
    let misses = |sides: &Vec<f64>| differs(mechanism, layout, t, stations, sides);
    trials.min_by(|a, b| misses(a).total_cmp(&misses(b))).unwrap_or_default()
}

/// How far the lengths between wheels are from the laws of the rope.
fn differs(
    mechanism: &Mechanism,
    layout: &Layout,
    t: &Transmission,
    stations: &[Station],
    sides: &[f64],
) -> f64 {
    let supply = |i: usize, part: usize, before: bool| {
        let Station::Wheel(wheel) = &stations[i] else { return None };
        let own = &mechanism.wheels[layout.wheels[*wheel].wheel];
        let other = if part == i { i + 1 } else { i - 1 };
        let up = if stations[other].is_high() { 1.0 } else { -1.0 };
        let side = if before || i == 0 { sides[i] } else { -sides[i] };
        Some((own.link, -up * side * own.radius))
    };
    let mut laws = t.laws.iter();
    let mut turns: Vec<(LinkId, f64)> = Vec::new();
    let mut slides: Vec<(LinkId, f64)> = Vec::new();
    let mut miss = 0.0;
    for (i, station) in stations.iter().enumerate() {
        match station {
            Station::Slider(link) => slides.push((*link, 1.0)),
            Station::Under(link) => slides.push((*link, 2.0)),
            Station::Wheel(_) => {
                if i > 0 {
                    turns.extend(supply(i, i - 1, true));
                    miss += laws.next().map_or(0.0, |law| off(mechanism, &law.terms, &turns, &slides));
                    (turns, slides) = (Vec::new(), Vec::new());
                }
                if i + 1 < stations.len() {
                    turns.extend(supply(i, i, false));
                }
            }
            _ => {}
        }
    }
    miss + laws.next().map_or(0.0, |law| off(mechanism, &law.terms, &turns, &slides))
}

/// How far a law with these terms is from one with those, up to a common factor.
fn off(
    mechanism: &Mechanism,
    terms: &[(Rate, f64)],
    turns: &[(LinkId, f64)],
    slides: &[(LinkId, f64)],
) -> f64 {
    let own = |rate: &Rate| -> f64 {
        let sum = |all: &[(LinkId, f64)], link: LinkId| all.iter().filter(|t| t.0 == link).map(|t| t.1).sum();
        match rate {
            Rate::Turn(link) => sum(turns, *link),
            Rate::Slide(pair) => {
                let links = mechanism.pair(*pair).kind.links();
                links.into_iter().map(|link| sum(slides, link)).sum()
            }
        }
    };
    let pairs: Vec<(f64, f64)> = terms.iter().map(|(rate, c)| (*c, own(rate))).collect();
    let norm = |of: fn(&(f64, f64)) -> f64| pairs.iter().map(|p| of(p) * of(p)).sum::<f64>().sqrt();
    let (a, b) = (norm(|p| p.0), norm(|p| p.1));
    let dot: f64 = pairs.iter().map(|p| p.0 * p.1).sum();
    if a * b > 0.0 { 1.0 - (dot / (a * b)).abs() } else { 1.0 }
}
