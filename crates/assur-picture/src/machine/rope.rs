//! Ropes with all that they touch in its place: straight down from their wheels to what they carry, up to idlers and to the ceiling.

use assur_math::math::Vec2;
use assur_model::model::{LinkId, Mechanism, PairId, PairKind, Transmission, TransmissionKind};

/// Radius of a pulley or an idler, where no two parts of a rope give it; of the largest, mm of paper.
const PULLEY: f64 = 4.0;
const LARGEST: f64 = 12.0;
/// From idlers to all wheels, and from these to what ropes carry.
const ABOVE: f64 = 11.0;
const BELOW: f64 = 18.0;
/// From an idler to the next one, and between a pulley and its weight.
const BESIDE: f64 = 14.0;
const HOOK: f64 = 8.5;
/// Weights nearer than this hang at different heights; how much lower.
const NEAR: f64 = 15.0;
const LOWER: f64 = 15.0;

/// What a rope touches.
#[derive(Clone, Debug, PartialEq)]
pub enum End {
    /// A wheel of the mechanism.
    Wheel(usize),
    Slider(LinkId),
    /// The pulley of a slider.
    Under(LinkId),
    /// An idler by its name.
    Over(String),
    /// The ground, at a point where it has one.
    Ground(Option<Vec2>),
}

impl End {
    const fn is_high(&self) -> bool {
        matches!(self, Self::Over(_) | Self::Ground(_))
    }

    const fn is_pulley(&self) -> bool {
        matches!(self, Self::Over(_) | Self::Under(_))
    }
}

/// A place where a rope touches something: a circle around which it goes, or where it is fastened, a point.
#[derive(Clone, Debug)]
pub struct Station {
    pub end: End,
    pub link: LinkId,
    /// The middle in the frame of the link, m.
    pub at: Vec2,
    /// m; 0 of a point.
    pub radius: f64,
    /// Around it the rope goes counter-clockwise, +1, or clockwise, −1, from its first end to its last.
    pub sense: f64,
}

/// A rope in its order.
#[derive(Clone, Debug)]
pub struct Rope {
    pub pair: PairId,
    pub stations: Vec<Station>,
}

/// The ropes of a mechanism with their ends.
pub fn ropes(mechanism: &Mechanism) -> Vec<(PairId, Vec<End>)> {
    let rope = |(i, kind): (usize, &PairKind)| match kind {
        PairKind::Transmission(t) if t.kind == TransmissionKind::Rope => {
            Some((PairId::at(i), ends(mechanism, t)))
        }
        _ => None,
    };
    mechanism.pairs.iter().map(|pair| &pair.kind).enumerate().filter_map(rope).collect()
}

fn ends(mechanism: &Mechanism, t: &Transmission) -> Vec<End> {
    let named = |name: &str| mechanism.links.iter().position(|l| l.name == name).map(LinkId::at);
    let end = |end: &String| {
        let inner = |word: &str| end.strip_prefix(word)?.strip_suffix(')');
        if let Some(name) = inner("over(") {
            return End::Over(name.to_owned());
        }
        if let Some(link) = inner("under(").and_then(named) {
            return End::Under(link);
        }
        match (mechanism.wheels.iter().position(|w| w.name == *end), named(end)) {
            (Some(wheel), _) => End::Wheel(wheel),
            (None, Some(link)) if link != LinkId::GROUND => End::Slider(link),
            _ => {
                let points = &mechanism.link(LinkId::GROUND).points;
                let point = end.split_once('.').and_then(|(_, name)| points.iter().find(|p| p.name == name));
                End::Ground(point.map(|point| point.at))
            }
        }
    };
    t.ends.iter().map(end).collect()
}

/// A circle on paper, mm, y up.
#[derive(Clone, Copy, Debug)]
pub struct Disc {
    pub at: Vec2,
    pub radius: f64,
}

/// What is placed already, mm of paper, y up.
pub struct Around<'a> {
    /// Wheels by their index; none of those without a place.
    pub wheels: &'a [Option<Disc>],
    /// Sliders that hang.
    pub hung: &'a mut Vec<(LinkId, Vec2)>,
}

/// A rope that is being placed: the abscissa of each upright part, none of one that lies between two wheels or two pulleys.
struct Placing<'e> {
    ends: &'e [End],
    /// The sense of the rope around its wheels.
    sense: f64,
    parts: Vec<Option<f64>>,
    pulleys: Vec<Option<(f64, f64)>>,
}

/// A rope with its ends where they are on paper, mm, and what hangs on it.
pub fn placed(ends: &[End], around: &mut Around<'_>) -> Vec<(Vec2, f64, f64)> {
    let sense = sense(ends, around.wheels);
    let mut rope = Placing {
        ends,
        sense,
        parts: vec![None; ends.len().saturating_sub(1)],
        pulleys: vec![None; ends.len()],
    };
    rope.at_wheels(around.wheels);
    rope.spread(around.wheels);
    let circles = || around.wheels.iter().flatten();
    let top = circles().map(|c| c.at.y + c.radius).fold(f64::NEG_INFINITY, f64::max);
    let bottom = circles().map(|c| c.at.y - c.radius).fold(f64::INFINITY, f64::min);
    let (top, bottom) = if top > bottom { (top, bottom) } else { (0.0, 0.0) };
    rope.weights(bottom, around.hung);
    let hung = |link: LinkId| around.hung.iter().find(|w| w.0 == link).map_or(Vec2::zero(), |w| w.1);
    let place = |i: usize| match &ends[i] {
        End::Wheel(wheel) => around.wheels[*wheel].map_or((Vec2::zero(), 0.0), |disc| (disc.at, disc.radius)),
        End::Ground(_) => (Vec2::new(rope.part_at(i), top + ABOVE), 0.0),
        End::Slider(link) => (hung(*link), 0.0),
        End::Over(_) => {
            let (x, radius) = rope.pulleys[i].unwrap_or((0.0, PULLEY));
            (Vec2::new(x, top + ABOVE), radius)
        }
        End::Under(link) => {
            let (x, radius) = rope.pulleys[i].unwrap_or((0.0, PULLEY));
            (Vec2::new(x, hung(*link).y + HOOK + radius), radius)
        }
    };
    (0..ends.len())
        .map(|i| {
            let (at, radius) = place(i);
            (at, radius, rope.sense_at(i))
        })
        .collect()
}

/// The sense of a rope around its wheels, from its first end to its last: what it carries at its first end goes down where they turn
/// counter-clockwise, and all wheels of a rope keep their sense. One on wheels alone runs above them.
fn sense(ends: &[End], wheels: &[Option<Disc>]) -> f64 {
    let x = |end: Option<&End>| match end {
        Some(End::Wheel(wheel)) => wheels[*wheel].map(|disc| disc.at.x),
        _ => None,
    };
    match (x(ends.first()), x(ends.last())) {
        (Some(from), Some(to)) if ends.len() == 2 => (from - to).signum(),
        _ if matches!(ends.first(), Some(End::Wheel(_))) => 1.0,
        _ => -1.0,
    }
}

impl Placing<'_> {
    /// Parts beside the wheels on which they run.
    fn at_wheels(&mut self, wheels: &[Option<Disc>]) {
        for (i, end) in self.ends.iter().enumerate() {
            let End::Wheel(wheel) = end else { continue };
            let Some(disc) = wheels[*wheel] else { continue };
            for (part, other, comes) in [(i.wrapping_sub(1), i.wrapping_sub(1), true), (i, i + 1, false)] {
                let Some(other) = self.ends.get(other) else { continue };
                // to the right of what goes up is the wheel that turns counter-clockwise
                let goes_up = comes != other.is_high();
                let side = if goes_up { self.sense } else { -self.sense };
                self.parts[part] = Some(disc.at.x + side * disc.radius);
            }
        }
        for i in 0..self.parts.len() {
            if matches!((&self.ends[i], &self.ends[i + 1]), (End::Wheel(_), End::Wheel(_))) {
                self.parts[i] = None;
            }
        }
        if !self.ends.iter().any(|end| matches!(end, End::Wheel(_))) && !self.parts.is_empty() {
            let right = wheels.iter().flatten().map(|disc| disc.at.x + disc.radius).fold(0.0, f64::max);
            self.parts[0] = Some(right + BESIDE);
        }
    }

    /// From the parts at wheels to those after pulleys, away from the wheel.
    fn spread(&mut self, wheels: &[Option<Disc>]) {
        let count = self.ends.len();
        for forward in [true, false] {
            let (mut outwards, mut beyond) = (1.0, None);
            for step in 0..count {
                let i = if forward { step } else { count - 1 - step };
                if let End::Wheel(wheel) = self.ends[i]
                    && let Some(disc) = wheels[wheel]
                {
                    let part = if forward { self.parts.get(i) } else { self.parts.get(i.wrapping_sub(1)) };
                    let x = part.copied().flatten().unwrap_or(disc.at.x + disc.radius);
                    outwards = if x < disc.at.x { -1.0 } else { 1.0 };
                    let axis = wheels.iter().flatten().filter(|d| (d.at - disc.at).norm() < 0.5);
                    let reach = axis.map(|d| d.radius).fold(0.0, f64::max);
                    beyond = Some(disc.at.x + outwards * (reach + 4.0));
                }
                if self.ends[i].is_pulley() {
                    self.around(i, forward, (outwards, beyond.take()));
                }
            }
        }
    }

    /// A pulley beside the part that comes to it, and the part that leaves it.
    fn around(&mut self, i: usize, forward: bool, (outwards, beyond): (f64, Option<f64>)) {
        if i == 0 || i + 1 == self.ends.len() {
            return;
        }
        let (comes, leaves) = if forward { (i - 1, i) } else { (i, i - 1) };
        let (before, after) = if forward { (i - 1, i + 1) } else { (i + 1, i - 1) };
        let flat = |s: &Self, other: usize| {
            s.ends[other].is_pulley() && s.ends[other].is_high() == s.ends[i].is_high()
        };
        let place = match (self.parts[comes], self.parts[leaves]) {
            (Some(a), Some(b)) => Some(((a + b) / 2.0, (a - b).abs() / 2.0)),
            (Some(x), None) => {
                // past the largest wheel on the axis
                let carries = |other: usize| matches!(self.ends[other], End::Slider(_));
                let least = if carries(before) && carries(after) { NEAR / 2.0 + 0.5 } else { PULLEY };
                let radius = beyond.map_or(least, |far| ((far - x) * outwards / 2.0).clamp(PULLEY, LARGEST));
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

    /// The abscissa of the part at an end.
    fn part_at(&self, i: usize) -> f64 {
        let part = if i == 0 { self.parts.first() } else { self.parts.get(i - 1) };
        part.copied().flatten().unwrap_or(0.0)
    }

    /// The sense around a station: of a pulley by the sides on which its parts are.
    fn sense_at(&self, i: usize) -> f64 {
        let Some((x, _)) = self.pulleys[i] else {
            return if matches!(self.ends[i], End::Wheel(_)) { self.sense } else { 0.0 };
        };
        let comes = i.checked_sub(1).and_then(|part| self.parts[part]).map(|part| part - x);
        let leaves = self.parts.get(i).copied().flatten().map(|part| x - part);
        // over it from the left to the right is clockwise
        let right = comes.or(leaves).is_none_or(|beside| beside <= 0.0);
        if right == self.ends[i].is_high() { -1.0 } else { 1.0 }
    }

    /// Sliders below all wheels, none on another.
    fn weights(&self, bottom: f64, hung: &mut Vec<(LinkId, Vec2)>) {
        for (i, end) in self.ends.iter().enumerate() {
            let (link, x, room) = match end {
                End::Slider(link) => (*link, self.part_at(i), 0.0),
                End::Under(link) => {
                    let own = self.ends.iter().zip(&self.pulleys);
                    let own = own.filter(|(end, _)| *end == &End::Under(*link)).filter_map(|(_, p)| *p);
                    let places: Vec<(f64, f64)> = own.collect();
                    let middle = places.iter().map(|p| p.0).sum::<f64>() / places.len().max(1) as f64;
                    (*link, middle, places.iter().map(|p| 2.0 * p.1).fold(0.0, f64::max) + HOOK)
                }
                _ => continue,
            };
            if hung.iter().any(|known| known.0 == link) {
                continue;
            }
            let mut at = Vec2::new(x, bottom - BELOW - room);
            let near = |at: Vec2, other: &Vec2| {
                (other.x - at.x).abs() < NEAR && (other.y - at.y).abs() < LOWER - 1.0
            };
            while hung.iter().any(|(_, other)| near(at, other)) {
                at.y -= LOWER;
            }
            hung.push((link, at));
        }
    }

    /// How far apart its parts reach.
    fn reach(&self) -> [f64; 2] {
        let parts = self.parts.iter().flatten().copied();
        let pulleys = self.pulleys.iter().flatten().flat_map(|(x, r)| [x - r, x + r]);
        parts.chain(pulleys).fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| [a.min(x), b.max(x)])
    }
}

/// How often parts of a rope pass before wheels of other axes, and less of what is better: how far apart they reach.
pub fn crossings(ends: &[End], wheels: &[Option<Disc>]) -> (usize, f64) {
    let mut rope = Placing {
        ends,
        sense: sense(ends, wheels),
        parts: vec![None; ends.len().saturating_sub(1)],
        pulleys: vec![None; ends.len()],
    };
    rope.at_wheels(wheels);
    rope.spread(wheels);
    let own = |disc: &Disc| {
        ends.iter().any(|end| match end {
            End::Wheel(wheel) => wheels[*wheel].is_some_and(|d| (d.at.x - disc.at.x).abs() < 0.5),
            _ => false,
        })
    };
    let passed =
        |x: f64| wheels.iter().flatten().filter(|d| (x - d.at.x).abs() < d.radius && !own(d)).count();
    let [left, right] = rope.reach();
    (rope.parts.iter().flatten().map(|x| passed(*x)).sum(), left - right)
}

/// A part of a rope from one circle to the next: where it leaves the first and meets the second. None where one lies in the other.
pub fn wound((from, r_1): (Vec2, f64), (to, r_2): (Vec2, f64)) -> Option<[Vec2; 2]> {
    let d = to - from;
    let along = d.unit()?;
    let sin = (r_1 - r_2) / d.norm();
    if sin.abs() >= 1.0 {
        return None;
    }
    // radii are positive where the rope goes counter-clockwise: the middle is on its left
    let t = along * (1.0 - sin * sin).sqrt() + along.perp() * sin;
    let right = -t.perp();
    Some([from + right * r_1, to + right * r_2])
}
