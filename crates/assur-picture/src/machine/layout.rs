//! Where shafts, sliders and ropes are that the file leaves without a place: from what has one along the transmissions.

use super::arrangement::{Arrangement, Thread};
use super::rope::{self, Around, Disc, End, Rope, Station};
use super::{base, moved_link, range};
use crate::scene::Scene;
use crate::symbol::thread;
use crate::train::Layout;
use assur_drawing::Rect;
use assur_math::math::Vec2;
use assur_model::model::{
    Bearing, Guide, LinkId, Mechanism, PairId, PairKind, Rate, Transmission, TransmissionKind, Wheel,
};
use assur_solve::solve::Pose;

/// Between two wheels of a belt, and between parts that nothing joins, mm of paper.
const GAP: f64 = 16.0;
/// From the pitch circle of a wheel to the axis of its worm, and from a shaft to its spindle.
pub const AXIS: f64 = 3.0;
const SPINDLE: f64 = 18.0;
/// How far a slider on a rope goes at most on paper, mm; where the file places its wheels in parts of their extent.
const TRAVEL: f64 = 60.0;
const EXTENTS: f64 = 2.0;
/// The paper for which marks of a size are placed between those of the file, mm.
const PAPER: f64 = 100.0;

/// A mechanism with all its places for these positions, and what is drawn beside it.
pub fn placed(scene: &Scene<'_>, poses: &[Pose]) -> (Mechanism, Arrangement) {
    let mechanism = scene.mechanism().clone();
    let links = mechanism.links.len();
    let is_free = (1..links).all(|i| !scene.is_placed(LinkId::at(i)));
    let mut room = Room {
        scene,
        mechanism,
        poses,
        unit: 1.0,
        axes: vec![None; links],
        to_scale: true,
        shares: vec![1.0; links],
        threads: Vec::new(),
    };
    if is_free {
        room.stack();
    } else {
        room.unit = room.extent() / PAPER;
        room.walk();
    }
    room.threads();
    room.sliders();
    let ropes = room.ropes(is_free);
    let Room { mechanism, threads, unit, to_scale, shares, .. } = room;
    (mechanism, Arrangement { ropes, threads, unit, to_scale, shares })
}

/// A shaft that has nothing but worms and screws on it: its axis lies in the paper.
pub fn is_across(mechanism: &Mechanism, link: LinkId) -> bool {
    let turns = |t: &Transmission| match t.kind {
        TransmissionKind::Worm => t.links.first() == Some(&link),
        TransmissionKind::Screw => t.links.contains(&link),
        _ => false,
    };
    let other = |wheel: &Wheel| wheel.link == link && !is_worm(mechanism, &wheel.name);
    transmissions(mechanism).any(|(_, t)| turns(t)) && !mechanism.wheels.iter().any(other)
}

/// Whether a wheel is the pitch cylinder of a worm.
fn is_worm(mechanism: &Mechanism, wheel: &str) -> bool {
    transmissions(mechanism).any(|(_, t)| {
        t.kind == TransmissionKind::Worm && t.ends.first().is_some_and(|end| bare(end) == wheel)
    })
}

fn bare(end: &str) -> &str {
    end.rsplit('.').next().unwrap_or(end)
}

fn transmissions(mechanism: &Mechanism) -> impl Iterator<Item = (PairId, &Transmission)> {
    mechanism.pairs.iter().enumerate().filter_map(|(i, pair)| match &pair.kind {
        PairKind::Transmission(t) => Some((PairId::at(i), t)),
        _ => None,
    })
}

/// What is being placed.
struct Room<'a, 's> {
    scene: &'s Scene<'a>,
    mechanism: Mechanism,
    poses: &'s [Pose],
    /// A millimetre of paper, m.
    unit: f64,
    /// Axes of shafts that have got a place, in ground axes at the position of the scene, m.
    axes: Vec<Option<Vec2>>,
    to_scale: bool,
    shares: Vec<f64>,
    threads: Vec<Thread>,
}

impl Room<'_, '_> {
    /// All shafts as in section: above each other, beside each other where ropes hang.
    fn stack(&mut self) {
        let layout = Layout::of(self.scene);
        let scale = layout.scale(&self.mechanism);
        self.to_scale = scale.is_some();
        self.unit = layout.unit(&self.mechanism);
        for wheel in &layout.wheels {
            self.mechanism.wheels[wheel.wheel].radius = wheel.radius * self.unit;
        }
        self.mechanism.open_sizes.clear();
        let ropes = rope::ropes(&self.mechanism);
        let rows = if ropes.is_empty() {
            vec![Vec2::new(0.0, 1.0)]
        } else {
            [1.0, -1.0].map(|x| Vec2::new(x, 0.0)).to_vec()
        };
        let crossed = |row: &Vec2| {
            let disc = |i: usize| {
                let wheel = layout.wheel(i)?;
                Some(Disc { at: *row * layout.axis_level(&self.mechanism, wheel), radius: wheel.radius })
            };
            let wheels: Vec<Option<Disc>> = (0..self.mechanism.wheels.len()).map(disc).collect();
            let all = ropes.iter().map(|(_, ends)| rope::crossings(ends, &wheels));
            all.fold((0, 0.0), |sum: (usize, f64), one| (sum.0 + one.0, sum.1 + one.1))
        };
        let order = |a: &(usize, f64), b: &(usize, f64)| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1));
        let Some(row) = rows.into_iter().min_by(|a, b| order(&crossed(a), &crossed(b))) else { return };
        for shaft in &layout.shafts {
            let carrier = layout.shafts.iter().find(|s| s.link == shaft.on).map_or(0.0, |s| s.level);
            self.axes[shaft.link.index()] = Some(row * (shaft.level * self.unit));
            self.bear(shaft.link, row * ((shaft.level - carrier) * self.unit));
        }
        for wheel in &layout.wheels {
            if self.mechanism.wheels[wheel.wheel].link == LinkId::GROUND {
                let at = row * (layout.axis_level(&self.mechanism, wheel) * self.unit);
                self.mechanism.wheels[wheel.wheel].centre = Some(at);
            }
        }
    }

    /// The greatest size of what has a place, m.
    fn extent(&self) -> f64 {
        let mut bounds = Rect::NOTHING;
        let placed =
            (0..self.mechanism.links.len()).map(LinkId::at).filter(|link| self.scene.is_placed(*link));
        for link in placed {
            bounds.add(self.scene.at(link, Vec2::zero()));
            self.mechanism.link(link).points.iter().for_each(|p| bounds.add(self.scene.at(link, p.at)));
        }
        for (i, wheel) in self.mechanism.wheels.iter().enumerate() {
            if let Some(at) = self.centre(i) {
                let r = Vec2::new(wheel.radius, wheel.radius);
                bounds.add(at - r);
                bounds.add(at + r);
            }
        }
        let size = bounds.size();
        Some(size.x.max(size.y)).filter(|size| *size > 0.0 && size.is_finite()).unwrap_or(0.1)
    }

    /// The axis of a wheel in ground axes, m.
    fn centre(&self, wheel: usize) -> Option<Vec2> {
        let wheel = &self.mechanism.wheels[wheel];
        if let Some(axis) = self.axes[wheel.link.index()] {
            return Some(axis);
        }
        wheel.centre.filter(|_| self.scene.is_placed(wheel.link)).map(|at| self.scene.at(wheel.link, at))
    }

    fn wheel_named(&self, end: &str) -> Option<usize> {
        self.mechanism.wheels.iter().position(|w| w.name == bare(end))
    }

    /// Where a place of the ground is on a link.
    fn on(&self, link: LinkId, at: Vec2) -> Vec2 {
        let body = self.scene.body(link);
        let origin = self.axes[link.index()].unwrap_or(body.p);
        (at - origin).turned_back(body.u)
    }

    /// Gives a shaft its bearing at a place of what carries it.
    fn bear(&mut self, link: LinkId, at: Vec2) {
        if is_across(&self.mechanism, link) {
            return;
        }
        for pair in &mut self.mechanism.pairs {
            if let PairKind::Revolute(pins) = &mut pair.kind
                && pair.bearing == Some(Bearing::Open)
                && pins.last().is_some_and(|pin| pin.link == link)
            {
                pins[0].at = at;
                pair.bearing = Some(Bearing::Placed);
            }
        }
        for wheel in self.mechanism.wheels.iter_mut().filter(|w| w.link == link) {
            wheel.centre = Some(Vec2::zero());
        }
    }

    /// The link that carries a shaft.
    fn carrier(&self, link: LinkId) -> LinkId {
        let own = self.mechanism.pairs.iter().find(|p| p.bearing.is_some() && moved_link(&p.kind) == link);
        own.map_or(LinkId::GROUND, |pair| base(&pair.kind))
    }

    fn is_left(&self, link: LinkId) -> bool {
        link != LinkId::GROUND && !self.scene.is_placed(link) && self.axes[link.index()].is_none()
    }

    /// Puts the axis of a shaft somewhere, and that of its carrier where another axis is.
    fn put(&mut self, link: LinkId, at: Vec2, other: Vec2) {
        let carrier = self.carrier(link);
        if self.is_left(carrier) {
            self.put(carrier, other, other);
        }
        let place = self.on(carrier, at);
        self.axes[link.index()] = Some(at);
        self.bear(link, place);
    }

    /// From what has a place along the transmissions; what nothing joins to it beside all.
    fn walk(&mut self) {
        loop {
            let all: Vec<Transmission> = transmissions(&self.mechanism).map(|(_, t)| t.clone()).collect();
            if all.iter().any(|t| self.step(t)) {
                continue;
            }
            let meets = |link: LinkId| {
                let bevel = all.iter().filter(|t| t.bevel.is_some() && t.links.contains(&link));
                bevel.flat_map(|t| &t.links).any(|other| !self.is_left(*other))
            };
            let links = (1..self.axes.len()).map(LinkId::at);
            let left: Vec<LinkId> =
                links.filter(|link| self.turns(*link) && self.is_left(*link) && !meets(*link)).collect();
            let Some(link) = left.iter().copied().min_by_key(|l| self.is_left(self.carrier(*l))) else {
                return;
            };
            let radius =
                self.mechanism.wheels.iter().filter(|w| w.link == link).map(|w| w.radius).fold(0.0, f64::max);
            let right = self.right() + GAP * self.unit + radius;
            self.put(link, Vec2::new(right, 0.0), Vec2::new(right, 0.0));
        }
    }

    /// Whether it is a shaft whose axis is a point of the picture.
    fn turns(&self, link: LinkId) -> bool {
        let own = |pair: &&assur_model::model::Pair| pair.bearing.is_some() && moved_link(&pair.kind) == link;
        let pair = self.mechanism.pairs.iter().find(own);
        pair.is_some_and(|p| matches!(p.kind, PairKind::Revolute(_))) && !is_across(&self.mechanism, link)
    }

    /// The greatest abscissa of what has a place, m.
    fn right(&self) -> f64 {
        let wheels = (0..self.mechanism.wheels.len())
            .filter_map(|i| Some(self.centre(i)?.x + self.mechanism.wheels[i].radius));
        let axes = self.axes.iter().flatten().map(|at| at.x);
        let placed =
            (0..self.mechanism.links.len()).map(LinkId::at).filter(|link| self.scene.is_placed(*link));
        let points = placed.flat_map(|link| {
            self.mechanism.link(link).points.iter().map(move |p| self.scene.at(link, p.at).x)
        });
        wheels.chain(axes).chain(points).fold(0.0, f64::max)
    }

    /// Places what a transmission joins to what has a place; whether there was anything.
    fn step(&mut self, t: &Transmission) -> bool {
        match t.kind {
            // an axis that meets another is none of the picture
            TransmissionKind::Mesh if t.bevel.is_some() => false,
            TransmissionKind::Mesh | TransmissionKind::Belt | TransmissionKind::Chain => {
                let wheels: Vec<usize> = t.ends.iter().filter_map(|end| self.wheel_named(end)).collect();
                let [a, b] = wheels.as_slice() else { return false };
                self.beside(t, *a, *b) || self.beside(t, *b, *a)
            }
            TransmissionKind::Clutch => {
                let [a, b] = t.links.as_slice() else { return false };
                let axis = |link: LinkId| self.axis(link);
                match (self.is_left(*a), self.is_left(*b)) {
                    (true, false) => axis(*b).map(|at| self.put(*a, at, at)).is_some(),
                    (false, true) => axis(*a).map(|at| self.put(*b, at, at)).is_some(),
                    _ => false,
                }
            }
            TransmissionKind::Rack => self.at_rack(t),
            TransmissionKind::Rope | TransmissionKind::Worm | TransmissionKind::Screw => false,
        }
    }

    /// The axis of a shaft that has a place.
    fn axis(&self, link: LinkId) -> Option<Vec2> {
        let placed = self.scene.is_placed(link) && link != LinkId::GROUND;
        self.axes[link.index()].or_else(|| placed.then(|| self.scene.at(link, Vec2::zero())))
    }

    /// A wheel without a place beside one that has a place.
    fn beside(&mut self, t: &Transmission, known: usize, new: usize) -> bool {
        let (Some(from), link) = (self.centre(known), self.mechanism.wheels[new].link) else { return false };
        let [own, other] = [known, new].map(|i| self.mechanism.wheels[i].link);
        if link == LinkId::GROUND {
            let carrier = self.axis(self.carrier(own));
            let is_left = self.mechanism.wheels[new].centre.is_none();
            if let Some(at) = carrier.filter(|_| is_left) {
                self.mechanism.wheels[new].centre = Some(at);
                return true;
            }
            return false;
        }
        if !self.is_left(link) {
            return false;
        }
        let carrier = self.carrier(own);
        let coaxial =
            self.axis(carrier).filter(|_| self.carrier(other) == LinkId::GROUND && carrier != LinkId::GROUND);
        let [r_1, r_2] = [known, new].map(|i| self.mechanism.wheels[i].radius);
        let apart = match t.kind {
            TransmissionKind::Mesh if crate::train::is_internal(t, [own, other]) => (r_1 - r_2).abs(),
            TransmissionKind::Mesh => r_1 + r_2,
            _ => r_1 + r_2 + GAP * self.unit,
        };
        let at = coaxial.unwrap_or_else(|| self.freest(from, apart, r_2));
        self.put(link, at, from);
        true
    }

    /// The place at a distance in that of eight directions in which least is covered, up first.
    fn freest(&self, from: Vec2, apart: f64, radius: f64) -> Vec2 {
        let wheels = (0..self.mechanism.wheels.len())
            .filter_map(|i| Some((self.centre(i)?, self.mechanism.wheels[i].radius)));
        let placed =
            (0..self.mechanism.links.len()).map(LinkId::at).filter(|link| self.scene.is_placed(*link));
        let points = placed.flat_map(|link| {
            self.mechanism.link(link).points.iter().map(move |p| (self.scene.at(link, p.at), 0.0))
        });
        let taken: Vec<(Vec2, f64)> = wheels.chain(points).filter(|(at, _)| *at != from).collect();
        let covered = |at: Vec2| -> f64 {
            taken.iter().map(|(other, r)| (radius + r - (*other - at).norm()).max(0.0)).sum()
        };
        let side = std::f64::consts::FRAC_1_SQRT_2;
        let eight = [
            (0.0, 1.0),
            (1.0, 0.0),
            (-1.0, 0.0),
            (0.0, -1.0),
            (side, side),
            (-side, side),
            (side, -side),
            (-side, -side),
        ];
        let places = eight.map(|(x, y)| from + Vec2::new(x, y) * apart);
        places.into_iter().min_by(|a, b| covered(*a).total_cmp(&covered(*b))).unwrap_or(from)
    }

    /// A pinion on the line of a rack that has a place: the wheel lies to the left of the line along which that slides.
    fn at_rack(&mut self, t: &Transmission) -> bool {
        let Some(wheel) = t.ends.iter().find_map(|end| self.wheel_named(end)) else { return false };
        let (link, radius) = (self.mechanism.wheels[wheel].link, self.mechanism.wheels[wheel].radius);
        let Some(g) = self.slide(t).filter(|g| self.is_left(link) && self.scene.is_placed(g.slider)) else {
            return false;
        };
        let along = g.along.turned(self.scene.body(g.guide).u);
        let through = self.line_of(t).unwrap_or_else(|| self.scene.at(g.slider, g.point));
        let at = through + along.perp() * radius;
        self.put(link, at, at);
        true
    }

    /// The guide of the slider of a transmission.
    fn slide(&self, t: &Transmission) -> Option<Guide> {
        let pair = t.laws.first()?.terms.iter().find_map(|(rate, _)| match rate {
            Rate::Slide(pair) => Some(*pair),
            Rate::Turn(_) => None,
        })?;
        match &self.mechanism.pair(pair).kind {
            PairKind::Prismatic(g) => Some(g.clone()),
            _ => None,
        }
    }

    /// A place of the line of a link that is an end, in ground axes.
    fn line_of(&self, t: &Transmission) -> Option<Vec2> {
        let (link, line) = t.ends.iter().find_map(|end| end.split_once('.'))?;
        let index = self.mechanism.links.iter().position(|l| l.name == link)?;
        let line = self.mechanism.links[index].lines.iter().find(|l| l.name == line)?;
        Some(self.scene.at(LinkId::at(index), line.through))
    }

    /// Worms above their wheels, spindles beside the shafts that turn them.
    fn threads(&mut self) {
        let all: Vec<(PairId, Transmission)> =
            transmissions(&self.mechanism).map(|(id, t)| (id, t.clone())).collect();
        let mut free = 0.0;
        for (pair, t) in all {
            let at = match t.kind {
                TransmissionKind::Worm => {
                    let wheel = t.ends.get(1).and_then(|end| self.wheel_named(end));
                    let Some((wheel, centre)) = wheel.and_then(|i| Some((i, self.centre(i)?))) else {
                        continue;
                    };
                    centre + Vec2::new(0.0, self.mechanism.wheels[wheel].radius + AXIS * self.unit)
                }
                TransmissionKind::Screw => {
                    let axis = t.links.iter().find_map(|link| self.axes[link.index()]);
                    let axis = axis.unwrap_or_else(|| {
                        free += 1.0;
                        Vec2::new(0.0, -2.0 * GAP * self.unit * (free - 1.0))
                    });
                    axis + Vec2::new(SPINDLE * self.unit, 0.0)
                }
                _ => continue,
            };
            // a spindle is as long as the way of its nut
            let half = match t.kind {
                TransmissionKind::Worm => thread::WORM * self.unit,
                _ => {
                    let ways =
                        t.links.iter().map(|link| range(self.poses, *link)).map(|[a, b]| 0.5 * (b - a));
                    thread::SPINDLE * self.unit + ways.fold(0.0, f64::max)
                }
            };
            self.threads.push(Thread { pair, at, half });
        }
    }

    /// Racks below their wheels, nuts on their spindles, others beside all but for those that ropes carry.
    fn sliders(&mut self) {
        let all: Vec<Transmission> = transmissions(&self.mechanism).map(|(_, t)| t.clone()).collect();
        let open: Vec<LinkId> = self.open_sliders().collect();
        let mut free = self.right() + GAP * self.unit;
        for link in open {
            let own = |kind: TransmissionKind| all.iter().find(|t| t.kind == kind && t.links.contains(&link));
            let along = Vec2::new(1.0, 0.0);
            let rack = own(TransmissionKind::Rack).and_then(|t| {
                let wheel = t.ends.iter().find_map(|end| self.wheel_named(end))?;
                Some(self.centre(wheel)? - Vec2::new(0.0, self.mechanism.wheels[wheel].radius))
            });
            let thread = || {
                self.threads.iter().find(|thread| self.links_of(thread.pair).contains(&link)).map(|t| t.at)
            };
            let place = rack.or_else(thread);
            if place.is_none() && own(TransmissionKind::Rope).is_some() {
                continue;
            }
            let at = place.unwrap_or_else(|| {
                free += 2.0 * GAP * self.unit;
                Vec2::new(free, 0.0)
            });
            let [least, greatest] = range(self.poses, link);
            self.guide(link, at - along * ((least + greatest) / 2.0), along);
        }
    }

    fn links_of(&self, pair: PairId) -> Vec<LinkId> {
        self.mechanism.pair(pair).kind.links()
    }

    fn open_sliders(&self) -> impl Iterator<Item = LinkId> {
        let open = self.mechanism.pairs.iter().filter(|pair| pair.bearing == Some(Bearing::Open));
        open.filter_map(|pair| match &pair.kind {
            PairKind::Prismatic(g) => Some(g.slider),
            _ => None,
        })
    }

    fn guide(&mut self, link: LinkId, through: Vec2, along: Vec2) {
        for pair in &mut self.mechanism.pairs {
            if let PairKind::Prismatic(g) = &mut pair.kind
                && g.slider == link
                && pair.bearing == Some(Bearing::Open)
            {
                (g.through, g.along) = (through, along);
                pair.bearing = Some(Bearing::Placed);
            }
        }
    }

    /// Ropes with all that they touch, and the sliders that they carry.
    fn ropes(&mut self, is_free: bool) -> Vec<Rope> {
        let unit = self.unit;
        let disc = |i: usize| {
            Some(Disc { at: self.centre(i)? / unit, radius: self.mechanism.wheels[i].radius / unit })
        };
        let wheels: Vec<Option<Disc>> = (0..self.mechanism.wheels.len()).map(disc).collect();
        let mut hung: Vec<(LinkId, Vec2)> = Vec::new();
        let mut placed = Vec::new();
        for (pair, ends) in rope::ropes(&self.mechanism) {
            let places = rope::placed(&ends, &mut Around { wheels: &wheels, hung: &mut hung });
            placed.push((pair, ends, places));
        }
        let most = if is_free { TRAVEL * unit } else { EXTENTS * PAPER * unit };
        let open: Vec<LinkId> = self.open_sliders().collect();
        hung.retain(|(link, _)| open.contains(link));
        // one for all, so that ropes keep their lengths
        let farthest =
            hung.iter().map(|(link, _)| range(self.poses, *link)).map(|[a, b]| b - a).fold(0.0, f64::max);
        let share = (most / farthest).min(1.0);
        for (link, at) in &hung {
            let [least, _] = range(self.poses, *link);
            self.shares[link.index()] = share;
            // its highest place is below all wheels
            self.guide(*link, *at * unit + Vec2::new(0.0, least * share), Vec2::new(0.0, -1.0));
        }
        let station = |(end, (at, radius, sense)): (End, (Vec2, f64, f64))| {
            let at = at * unit;
            let hangs = |link: LinkId| hung.iter().find(|w| w.0 == link).map_or(at, |w| w.1 * unit);
            let (link, at) = match &end {
                End::Wheel(wheel) => {
                    let wheel = &self.mechanism.wheels[*wheel];
                    (wheel.link, wheel.centre.unwrap_or(at))
                }
                End::Slider(link) => (*link, Vec2::zero()),
                // a slider does not turn
                End::Under(link) => (*link, at - hangs(*link)),
                End::Ground(Some(point)) if !is_free => (LinkId::GROUND, *point),
                End::Over(_) | End::Ground(_) => (LinkId::GROUND, at),
            };
            Station { end, link, at, radius: radius * unit, sense }
        };
        let rope = |(pair, ends, places): (PairId, Vec<End>, Vec<(Vec2, f64, f64)>)| Rope {
            pair,
            stations: ends.into_iter().zip(places).map(station).collect(),
        };
        placed.into_iter().map(rope).collect()
    }
}
