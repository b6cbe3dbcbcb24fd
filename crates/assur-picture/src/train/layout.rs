//! Where shafts, wheels and sliders are in the section. Levels grow upwards, mm; y of paper is their negative.

use super::bevel::{self, Cones};
use super::worm;
use crate::scene::Scene;
use assur_drawing::Scale;
use assur_math::math::Vec2;
use assur_model::model::{Bearing, Bevel, LinkId, Mechanism, PairKind, Rate, Transmission, TransmissionKind};

/// Radius of the largest wheel, and the least that is drawn.
const LARGEST: f64 = 24.0;
pub const LEAST: f64 = 5.0;
/// From column to column.
pub const COLUMN: f64 = 22.0;
/// What a shaft is longer than its wheels, on the side of its bearing and on the other.
const LONG: f64 = 15.0;
const SHORT: f64 = 4.5;
/// From a ring to the disc that joins it to its shaft, and from bevel wheels to the frame of their carrier.
pub const BELL: f64 = COLUMN / 2.0 + 4.5;
const FRAME: f64 = 10.0;
/// From the end of a shaft to that of another on the same axis.
const BEHIND: f64 = 12.5;
/// Between two wheels of a belt, and between shafts that nothing joins.
const GAP: f64 = 16.0;

#[derive(Clone, Debug)]
pub struct Shaft {
    pub link: LinkId,
    /// The link on which it turns.
    pub on: LinkId,
    /// Height of its axis.
    pub level: f64,
    /// Where it begins and ends.
    pub ends: (f64, f64),
    /// Its bearing is at the right end.
    pub right: bool,
    /// Its axis stands upright here, from this height; the level is its top.
    pub upright: Option<(f64, f64)>,
    /// It is hollow: another turns in it.
    pub hollow: bool,
    /// The frame of a carrier of bevel planets begins at this axis.
    pub frame: Option<f64>,
}

/// A wheel in the section.
#[derive(Clone, Debug)]
pub struct Drawn {
    /// Index into the mechanism's wheels.
    pub wheel: usize,
    /// Its radius, mm.
    pub radius: f64,
    pub x: f64,
    /// Height of its axis.
    pub level: f64,
    /// The wheel lies within this one; where they touch.
    pub ring_at: Option<f64>,
    /// A bevel wheel: where its axis meets that of another, and whether it stands upright.
    pub cone: Option<(Vec2, bool)>,
}

#[derive(Clone, Debug, Default)]
pub struct Layout {
    pub shafts: Vec<Shaft>,
    pub wheels: Vec<Drawn>,
    /// Sliders with the middle of their blocks, on paper.
    pub sliders: Vec<(LinkId, Vec2)>,
    /// Those that are nuts: they move along their spindles.
    pub nuts: Vec<LinkId>,
    /// What runs on what.
    pub runs: Vec<Run>,
}

/// From the free end of a shaft to the middle of a spindle.
const SPINDLE: f64 = 10.0;

impl Shaft {
    /// A shaft that has no place yet.
    pub const fn new(link: LinkId, on: LinkId) -> Self {
        let (right, upright, hollow, frame) = (false, None, false, None);
        Self { link, on, level: 0.0, ends: (0.0, 0.0), right, upright, hollow, frame }
    }

    /// The middle of the spindle at its free end, on paper.
    pub fn spindle(&self) -> Vec2 {
        let x = if self.right { self.ends.0 - SPINDLE } else { self.ends.1 + SPINDLE };
        Vec2::new(x, -self.level)
    }
}

/// Two wheels that run on each other.
#[derive(Clone, Debug)]
pub struct Run {
    /// Indices of drawn wheels.
    pub wheels: [usize; 2],
    /// One lies within the other.
    pub internal: bool,
    /// A belt or a chain joins them.
    pub apart: bool,
    pub cones: Option<Cones>,
}

impl Layout {
    /// The section of a mechanism.
    pub fn of(scene: &Scene<'_>) -> Self {
        let mechanism = scene.mechanism();
        let shafts = shafts(mechanism);
        let drawn: Vec<usize> = (0..mechanism.wheels.len())
            .filter(|i| {
                let wheel = &mechanism.wheels[*i];
                let is_shaft = |link| shafts.iter().any(|shaft: &Shaft| shaft.link == link);
                (is_shaft(wheel.link) || wheel.link == LinkId::GROUND) && !worm::is_worm(mechanism, *i)
            })
            .collect();
        let runs = runs(mechanism, &drawn);
        let mut layout = Self { shafts, ..Self::default() };
        let radii = radii(mechanism, &drawn);
        let columns = columns(&drawn, &runs);
        for (i, wheel) in drawn.iter().enumerate() {
            let x = COLUMN * columns[i] as f64;
            layout.wheels.push(Drawn {
                wheel: *wheel,
                radius: radii[i],
                x,
                level: 0.0,
                ring_at: None,
                cone: None,
            });
        }
        let levels = layout.levels(mechanism, &runs);
        for (shaft, level) in layout.shafts.iter_mut().zip(&levels) {
            shaft.level = level.unwrap_or(0.0);
        }
        for wheel in &mut layout.wheels {
            let link = mechanism.wheels[wheel.wheel].link;
            wheel.level = layout.shafts.iter().find(|s| s.link == link).map_or(0.0, |s| s.level);
        }
        layout.rings(mechanism, &runs);
        layout.runs = runs;
        bevel::place(&mut layout, mechanism);
        layout.ends(mechanism);
        layout.place_sliders(mechanism);
        layout
    }

    /// The scale of all wheels; none where small ones are drawn larger, or where the file leaves sizes open.
    pub fn scale(&self, mechanism: &Mechanism) -> Option<Scale> {
        let radius = |w: &Drawn| mechanism.wheels[w.wheel].radius;
        let scale = Scale::fitting(self.wheels.iter().map(radius).fold(0.0, f64::max), LARGEST)?;
        let fits = |w: &Drawn| w.cone.is_none() && (w.radius - radius(w) / scale.factor()).abs() < 1e-9;
        (mechanism.open_sizes.is_empty() && self.wheels.iter().all(fits)).then_some(scale)
    }

    /// A millimetre of paper, m.
    pub fn unit(&self, mechanism: &Mechanism) -> f64 {
        let radii = mechanism.wheels.iter().map(|wheel| wheel.radius);
        Scale::fitting(radii.fold(0.0, f64::max), LARGEST).map_or(1e-3, |scale| scale.factor())
    }

    /// The height of the axis of a wheel: of a ring of the ground that of the wheel in it shows it.
    pub fn axis_level(&self, mechanism: &Mechanism, wheel: &Drawn) -> f64 {
        match wheel.ring_at {
            Some(touch) if mechanism.wheels[wheel.wheel].link == LinkId::GROUND => touch - wheel.radius,
            _ => wheel.level,
        }
    }

    /// Heights of the shafts, each from one that it meshes with.
    fn levels(&self, mechanism: &Mechanism, runs: &[Run]) -> Vec<Option<f64>> {
        let mut levels: Vec<Option<f64>> = vec![None; self.shafts.len()];
        let shaft_of = |link: LinkId| self.shafts.iter().position(|s| s.link == link);
        let of_wheel = |i: usize| shaft_of(mechanism.wheels[self.wheels[i].wheel].link);
        let carrier = |shaft: usize| shaft_of(self.shafts[shaft].on);
        let mut next = 0.0;
        loop {
            let mut changed = false;
            for run in runs {
                for [a, b] in [run.wheels, [run.wheels[1], run.wheels[0]]] {
                    let (Some(from), Some(to)) = (of_wheel(a), of_wheel(b)) else { continue };
                    let (Some(level), None) = (levels[from], levels[to]) else { continue };
                    let (r_a, r_b) = (self.wheels[a].radius, self.wheels[b].radius);
                    let coaxial = carrier(from).and_then(|c| levels[c]);
                    levels[to] = Some(match coaxial {
                        // a central wheel of a planet is on the axis of its carrier
                        Some(axis) if carrier(to).is_none() => axis,
                        _ if run.internal => level + r_a - r_b,
                        _ if run.apart => level + r_a + r_b + GAP,
                        _ => level + r_a + r_b,
                    });
                    if let Some(c) = carrier(to).filter(|c| levels[*c].is_none()) {
                        levels[c] = Some(level);
                    }
                    changed = true;
                }
            }
            for (shaft, on) in clutches(mechanism) {
                let (Some(a), Some(b)) = (shaft_of(shaft), shaft_of(on)) else { continue };
                match (levels[a], levels[b]) {
                    (Some(level), None) => (levels[b], changed) = (Some(level), true),
                    (None, Some(level)) => (levels[a], changed) = (Some(level), true),
                    _ => {}
                }
            }
            if changed {
                continue;
            }
            // a planet starts no row of its own where its carrier or another shaft is left
            let free = |i: &usize| levels[*i].is_none();
            let first = (0..levels.len()).filter(free).min_by_key(|i| (carrier(*i).is_some(), *i));
            let Some(first) = first else { return levels };
            let highest = levels.iter().flatten().copied().fold(f64::NEG_INFINITY, f64::max);
            let apart = if self.wheels.is_empty() { 0.0 } else { 2.0 * LARGEST };
            next = if highest.is_finite() { highest + apart + GAP } else { next };
            levels[first] = Some(next);
        }
    }

    /// Where rings touch their inner wheels.
    fn rings(&mut self, mechanism: &Mechanism, runs: &[Run]) {
        for run in runs.iter().filter(|r| r.internal) {
            let [a, b] = run.wheels;
            let (ring, inner) = if self.wheels[a].radius >= self.wheels[b].radius { (a, b) } else { (b, a) };
            let touch = self.wheels[inner].level + self.wheels[inner].radius;
            self.wheels[ring].ring_at = Some(touch);
            if mechanism.wheels[self.wheels[ring].wheel].link == LinkId::GROUND {
                self.wheels[ring].level = self.wheels[inner].level;
            }
        }
    }

    /// Begins and ends of the shafts; the first on an axis has its bearing on the left, others on the right. Hollow ones come
    /// first: others end beyond them.
    fn ends(&mut self, mechanism: &Mechanism) {
        let link_of = |wheel: &Drawn| mechanism.wheels[wheel.wheel].link;
        let carries = |own: &Shaft, upright: bool| {
            self.shafts.iter().any(|s| s.on == own.link && s.upright.is_some() == upright)
        };
        let bell = |own: &Shaft| self.wheels.iter().any(|w| link_of(w) == own.link && w.ring_at.is_some());
        let holds = |own: &Shaft| {
            let inside = |s: &Shaft| s.link != own.link && carries(s, false) && same(s.level, own.level);
            carries(own, true) || bell(own) && self.shafts.iter().any(inside)
        };
        let hollow: Vec<bool> = self.shafts.iter().map(holds).collect();
        let bells: Vec<bool> = self.shafts.iter().map(bell).collect();
        let mut order: Vec<usize> = (0..self.shafts.len()).collect();
        order.sort_by_key(|i| !hollow[*i]);
        let mut used: Vec<usize> = Vec::new();
        for i in order {
            self.shafts[i].hollow = hollow[i];
            self.frame(mechanism, i);
            let (ends, right) = self.ends_of(mechanism, i, bells[i], &used);
            (self.shafts[i].ends, self.shafts[i].right) = (ends, right);
            used.push(i);
        }
    }

    /// Where the frame of a carrier of bevel planets goes down to its axis: beyond the wheels, on the side of its own.
    fn frame(&mut self, mechanism: &Mechanism, i: usize) {
        let link = self.shafts[i].link;
        let link_of = |wheel: &Drawn| mechanism.wheels[wheel.wheel].link;
        let planets: Vec<LinkId> =
            self.shafts.iter().filter(|s| s.on == link && s.upright.is_some()).map(|s| s.link).collect();
        let cones: Vec<Cones> = self.runs.iter().filter_map(|run| run.cones).collect();
        let beside = cones.iter().filter(|c| planets.contains(&link_of(&self.wheels[c.upright])));
        let xs = beside.map(|c| self.wheels[c.lying].x);
        let (low, high) = xs.fold((f64::MAX, f64::MIN), |(a, b), x| (a.min(x), b.max(x)));
        if low > high {
            return;
        }
        let own = self.wheels.iter().filter(|w| link_of(w) == link).map(|w| w.x).fold(f64::MAX, f64::min);
        self.shafts[i].frame = Some(if own < low { low - FRAME } else { high + FRAME });
    }

    fn ends_of(&self, mechanism: &Mechanism, i: usize, bell: bool, used: &[usize]) -> ((f64, f64), bool) {
        let shaft = &self.shafts[i];
        if let Some((x, _)) = shaft.upright {
            return ((x, x), false);
        }
        let link_of = |wheel: &Drawn| mechanism.wheels[wheel.wheel].link;
        let widest = self.wheels.iter().map(|w| w.x).fold(0.0, f64::max);
        let own = |w: &&Drawn| link_of(w) == shaft.link;
        let of_planets = |w: &&Drawn| {
            w.cone.is_none() && self.shafts.iter().any(|s| s.link == link_of(w) && s.on == shaft.link)
        };
        let reach = if bell { BELL } else { 0.0 };
        let xs = self.wheels.iter().filter(own).map(|w| w.x + reach);
        let arms: Vec<f64> = self.wheels.iter().filter(of_planets).map(|w| w.x + COLUMN / 2.0).collect();
        let all = xs.chain(arms.iter().copied()).chain(shaft.frame);
        let (low, high) = all.fold((f64::MAX, f64::MIN), |(a, b), x| (a.min(x), b.max(x)));
        let (low, high) = if low > high { (widest + COLUMN, widest + COLUMN) } else { (low, high) };
        if shaft.on != LinkId::GROUND {
            return ((low - SHORT, high + COLUMN / 2.0), false);
        }
        let here = || used.iter().map(|u| &self.shafts[*u]).filter(|u| same(u.level, shaft.level));
        let clash = |(from, to): (f64, f64)| {
            here().filter(|u| !u.hollow).any(|u| from < u.ends.1 + 1.0 && u.ends.0 < to + 1.0)
        };
        let short = |on: bool| if on { SHORT } else { 0.0 };
        let free = arms.is_empty() && shaft.frame.is_none();
        // in a hollow shaft, and beyond its bearing
        let through = here().filter(|u| u.hollow && u.ends.1 <= low + 1.0).map(|u| u.ends.0 - BEHIND);
        let left = ((low - LONG).min(through.fold(f64::MAX, f64::min)), high + short(free));
        let far = self
            .runs
            .iter()
            .filter_map(|run| run.cones)
            .any(|cones| cones.side == Bevel::Far && link_of(&self.wheels[cones.lying]) == shaft.link);
        let frame_left = shaft.frame.is_some_and(|x| x > low);
        let is_right = !frame_left && (bell || far || !free || clash(left));
        if !is_right {
            return (left, false);
        }
        let near =
            |end: f64| here().map(|u| u.ends.1).filter(|e| (e - end).abs() < BEHIND).fold(f64::MIN, f64::max);
        let around = here().filter(|u| u.hollow && u.ends.0 >= low - 1.0).map(|u| u.ends.1 + BEHIND);
        let mut end = around.fold(high + LONG, f64::max);
        while near(end) > f64::MIN {
            end = near(end) + BEHIND;
        }
        ((low - short(free && !bell), end), true)
    }

    /// Racks below their wheels, nuts on their spindles; others side by side. Those on ropes are seen from the front.
    fn place_sliders(&mut self, mechanism: &Mechanism) {
        let wheels = self.wheels.iter().map(|w| w.level - w.radius);
        let lowest = wheels.chain(self.shafts.iter().map(|s| s.level - 6.0)).fold(0.0, f64::min);
        let start = self.wheels.iter().map(|w| w.x).fold(-COLUMN, f64::max) + COLUMN;
        let open = mechanism.pairs.iter().filter(|p| p.bearing == Some(Bearing::Open));
        let sliders = open.filter_map(|p| match &p.kind {
            PairKind::Prismatic(g) => Some(g.slider),
            _ => None,
        });
        let mut free = 0.0;
        for link in sliders {
            let own = |kind: TransmissionKind| {
                mechanism.pairs.iter().find_map(|pair| match &pair.kind {
                    PairKind::Transmission(t) if t.kind == kind && t.links.contains(&link) => Some(t),
                    _ => None,
                })
            };
            let racks = super::rack::racks(mechanism, self);
            let rack = racks.iter().find(|rack| rack.link == link).map(super::rack::Rack::middle);
            let nut = own(TransmissionKind::Screw)
                .and_then(|t| self.shafts.iter().find(|s| t.links.contains(&s.link)).map(Shaft::spindle));
            if rack.is_none() && nut.is_none() && own(TransmissionKind::Rope).is_some() {
                continue;
            }
            let at = rack.or(nut).unwrap_or_else(|| {
                free += 1.0;
                Vec2::new(start + COLUMN * (free - 1.0), -lowest + 14.0)
            });
            if nut.is_some() {
                self.nuts.push(link);
            }
            self.sliders.push((link, at));
        }
    }

    /// The wheel of an index of the mechanism.
    pub fn wheel(&self, index: usize) -> Option<&Drawn> {
        self.wheels.iter().find(|w| w.wheel == index)
    }
}

/// Whether two levels are one axis.
fn same(a: f64, b: f64) -> bool {
    (a - b).abs() < 4.0
}

fn shafts(mechanism: &Mechanism) -> Vec<Shaft> {
    let own = mechanism.pairs.iter().filter(|p| p.bearing.is_some());
    let shafts = own.filter_map(|p| match &p.kind {
        PairKind::Revolute(pins) => Some((pins.first()?.link, pins.last()?.link)),
        _ => None,
    });
    let shafts = shafts.filter(|(_, link)| !worm::is_across(mechanism, *link));
    shafts.map(|(on, link)| Shaft::new(link, on)).collect()
}

/// Shafts that a clutch joins.
fn clutches(mechanism: &Mechanism) -> Vec<(LinkId, LinkId)> {
    let transmissions = mechanism.pairs.iter().filter_map(|p| match &p.kind {
        PairKind::Transmission(t) if t.kind == TransmissionKind::Clutch => Some(t),
        _ => None,
    });
    transmissions.filter_map(|t| Some((*t.links.first()?, *t.links.get(1)?))).collect()
}

/// The index of a wheel by the name of an end.
pub fn wheel_named(mechanism: &Mechanism, end: &str) -> Option<usize> {
    let bare = end.rsplit('.').next().unwrap_or(end);
    mechanism.wheels.iter().position(|w| w.name == bare || w.name == end)
}

fn runs(mechanism: &Mechanism, drawn: &[usize]) -> Vec<Run> {
    let mut runs = Vec::new();
    for pair in &mechanism.pairs {
        let PairKind::Transmission(t) = &pair.kind else { continue };
        let apart = matches!(t.kind, TransmissionKind::Belt | TransmissionKind::Chain);
        if !apart && t.kind != TransmissionKind::Mesh {
            continue;
        }
        let [first, second] = t.ends.as_slice() else { continue };
        let place = |end: &str| drawn.iter().position(|i| Some(*i) == wheel_named(mechanism, end));
        if let (Some(a), Some(b)) = (place(first), place(second)) {
            let links = [a, b].map(|i| mechanism.wheels[drawn[i]].link);
            let cones = bevel::cones(t, [a, b], links);
            let internal = t.kind == TransmissionKind::Mesh && cones.is_none() && is_internal(t, links);
            runs.push(Run { wheels: [a, b], internal, apart, cones });
        }
    }
    runs
}

/// Whether one wheel lies within the other: then both turn in one sense, seen from their carrier.
pub fn is_internal(t: &Transmission, links: [LinkId; 2]) -> bool {
    if let Some(meeting) = &t.meeting {
        return meeting.internal;
    }
    let Some(law) = t.laws.first() else { return false };
    let term = |link: LinkId| law.terms.iter().find(|(r, _)| *r == Rate::Turn(link)).map(|t| t.1);
    match links.map(term) {
        [Some(a), Some(b)] => a * b < 0.0,
        [Some(own), None] | [None, Some(own)] => {
            let other = law.terms.iter().find(|(r, _)| r.turning().is_some_and(|l| !links.contains(&l)));
            other.is_some_and(|(_, c)| c * own > 0.0)
        }
        [None, None] => false,
    }
}

fn radii(mechanism: &Mechanism, drawn: &[usize]) -> Vec<f64> {
    let largest = drawn.iter().map(|i| mechanism.wheels[*i].radius).fold(0.0, f64::max);
    let Some(scale) = Scale::fitting(largest, LARGEST) else { return vec![LARGEST / 2.0; drawn.len()] };
    drawn.iter().map(|i| (mechanism.wheels[*i].radius / scale.factor()).max(LEAST)).collect()
}

/// Wheels that run on each other share a column; columns are in the order of the wheels.
fn columns(drawn: &[usize], runs: &[Run]) -> Vec<usize> {
    let mut same: Vec<usize> = (0..drawn.len()).collect();
    for run in runs {
        let [a, b] = run.wheels.map(|i| same[i]);
        same.iter_mut().filter(|s| **s == a.max(b)).for_each(|s| *s = a.min(b));
    }
    let mut order: Vec<usize> = same.clone();
    order.sort_unstable();
    order.dedup();
    same.iter().map(|s| order.iter().position(|o| o == s).unwrap_or(0)).collect()
}
