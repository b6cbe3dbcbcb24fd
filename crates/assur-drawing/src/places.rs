//! The places of a label, the cheapest first, looked for as far as they are asked for.

use crate::clearance::{Clearance, SIDE};
use crate::geometry::Rect;
use crate::ground::{Grounds, Met};
use crate::label::{Anchor, Label};
use assur_math::math::Vec2;
use std::f64::consts::TAU;

/// Directions around a point.
const DIRECTIONS: usize = 24;
/// Distances from the anchor, mm.
const DISTANCES: [f64; 8] = [0.5, 1.0, 1.7, 2.6, 4.0, 6.0, 9.0, 12.0];
/// Places along a line.
const ALONG: [f64; 7] = [0.5, 0.42, 0.58, 0.34, 0.66, 0.25, 0.75];
/// Price of a radian away from the best direction, in millimetres of distance; the same beside a line that has none.
const PER_RADIAN: f64 = 1.1;
const BESIDE: f64 = 0.3;
/// Price of the ends of a line against its middle.
const PER_PART: f64 = 4.0;
/// A label beside a line with fewer free places looks around its ends too, in every third direction; what that costs, mm.
const FEW: u32 = 6;
const EVERY: usize = 3;
const AT_END: f64 = 6.0;
/// The first bit of four for each distance.
const EACH: u32 = 0x1111_1111;
/// What prices may be off by rounding.
const ROUNDING: f64 = 1e-9;

/// A place that a label may take.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Place {
    pub bounds: Rect,
    pub cost: f64,
    pub blockers: Blockers,
}

/// Where labels may go from an anchor: a point and a direction, with its prices.
#[derive(Clone, Copy)]
struct Ray {
    from: Vec2,
    direction: Vec2,
    /// From the point at a distance to the middle of the box, whose side or corner is there.
    to_middle: Vec2,
    turned: f64,
    extra: f64,
    /// At which distances it is free: a bit of four for each.
    free: u32,
    /// The order among rays, and that among distances: of equal places the first is taken.
    order: (usize, bool),
}

impl Ray {
    /// The middle of the box at a distance.
    fn middle(&self, distance: f64) -> Vec2 {
        self.from + self.direction * distance + self.to_middle
    }

    /// Takes the places that are in a circle in which other things are magnified.
    fn close(&mut self, label: &Label, half: Vec2, round: bool, grounds: &Grounds<'_>) {
        for (i, distance) in DISTANCES.into_iter().enumerate() {
            let place = Rect::around(self.middle(distance), half);
            self.free &= !(u32::from(grounds.is_closed(label, &place, round)) << (SIDE * i));
        }
    }
}

/// Finds at which distances a few rays are free.
fn find_free(rays: &mut [Ray], clearance: &Clearance) {
    // what is behind the last is the last again
    let ray = |i: usize| &rays[i.min(rays.len() - 1)];
    let lines = std::array::from_fn(|i| (ray(i).middle(0.0), ray(i).direction));
    let middle = |i: usize, distance: usize| ray(i).middle(DISTANCES[distance]);
    let free = clearance.free(&lines, &DISTANCES, middle);
    rays.iter_mut().enumerate().for_each(|(i, ray)| ray.free = free >> i & EACH);
}

/// The directions around a point.
pub(crate) struct Directions([Vec2; DIRECTIONS]);

impl Directions {
    pub fn new() -> Self {
        Self(std::array::from_fn(|i| Vec2::direction(TAU * i as f64 / DIRECTIONS as f64)))
    }
}

/// What is filled for each label again.
#[derive(Default)]
pub(crate) struct SearchMemory {
    rays: Vec<Ray>,
    /// The prices of rays with their numbers.
    prices: Vec<(f64, usize)>,
    met: Met,
}

/// The places of a label.
pub(crate) struct Places {
    /// The number of the label.
    index: usize,
    half: Vec2,
    round: bool,
    /// Those on which there is a free place, the cheapest first.
    rays: Vec<Ray>,
    /// How many places are free.
    pub count: u32,
    /// What they all lie in.
    pub reach: Rect,
    /// Whether some may cross a line.
    crosses: bool,
    /// For every distance the rays on which a place was not looked at, a bit each, and the least that the next one costs.
    open: [u32; DISTANCES.len()],
    least: [f64; DISTANCES.len()],
    /// Free places, the cheapest first.
    pub known: Vec<Place>,
    /// Others before which there may be cheaper ones, with their order, the cheapest last.
    waiting: Vec<(Place, usize)>,
}

impl Places {
    pub fn of(
        (index, label): (usize, &Label),
        directions: &Directions,
        grounds: &Grounds<'_>,
        again: &mut SearchMemory,
    ) -> Self {
        let half = label.half();
        let round = label.ring.is_some_and(|r| half.x <= r);
        let SearchMemory { rays: all, prices, met } = again;
        all.clear();
        let free = |rays: &mut [Ray], met: &mut Met| {
            let reach = reach(half, rays);
            let clearance = grounds.clearance(&reach, half, round, met);
            for rays in rays.chunks_mut(SIDE) {
                find_free(rays, clearance);
                if grounds.closes() {
                    rays.iter_mut().for_each(|ray| ray.close(label, half, round, grounds));
                }
            }
            rays.iter().map(|ray| ray.free.count_ones()).sum::<u32>()
        };
        find_rays(label, half, directions, all);
        let mut count = free(all, met);
        if let (Anchor::Line(a, b), true) = (label.anchor, count < FEW) {
            let known = all.len();
            find_rays_at_ends((a, b), half, directions, all);
            count += free(&mut all[known..], met);
        }
        let crosses = grounds.has_thin(&reach(half, all));
        let reach = open_reach(all, half);
        prices.clear();
        let free = all.iter().enumerate().filter(|(_, ray)| ray.free != 0);
        prices.extend(free.map(|(i, ray)| (ray.turned + ray.extra, i)));
        prices.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let rays: Vec<Ray> = prices.iter().map(|(_, i)| all[*i]).collect();
        let mut open = [0; DISTANCES.len()];
        for (i, ray) in rays.iter().enumerate() {
            let is_free = |distance: usize| ray.free >> (SIDE * distance) & 1;
            open.iter_mut().enumerate().for_each(|(distance, open)| *open |= is_free(distance) << i);
        }
        let (known, waiting) = (Vec::with_capacity(8), Vec::with_capacity(8));
        let least = [0.0; DISTANCES.len()];
        let mut places =
            Self { index, half, round, rays, count, reach, crosses, open, least, known, waiting };
        (0..DISTANCES.len()).for_each(|distance| places.expect(distance));
        places
    }

    /// The least that the next place at a distance costs.
    fn expect(&mut self, distance: usize) {
        let ray = self.rays.get(self.open[distance].trailing_zeros() as usize);
        let price = ray.map_or(f64::INFINITY, |ray| ray.turned + ray.extra);
        self.least[distance] = DISTANCES[distance] + price - ROUNDING;
    }

    /// The cheapest place that is not known yet, if there is one.
    pub fn find(&mut self, grounds: &Grounds<'_>) -> Option<Place> {
        loop {
            let (mut distance, mut least) = (0, f64::INFINITY);
            for (i, price) in self.least.iter().enumerate() {
                if *price < least {
                    (distance, least) = (i, *price);
                }
            }
            if self.waiting.last().is_some_and(|(place, _)| place.cost < least) {
                return self.waiting.pop().map(|(place, _)| place);
            } else if least == f64::INFINITY {
                return None;
            }
            self.try_distance(distance, grounds);
        }
    }

    /// Looks at the next place at a distance.
    fn try_distance(&mut self, distance: usize, grounds: &Grounds<'_>) {
        let ray = self.rays[self.open[distance].trailing_zeros() as usize];
        self.open[distance] &= self.open[distance] - 1;
        self.expect(distance);
        let bounds = Rect::around(ray.middle(DISTANCES[distance]), self.half);
        let cost = DISTANCES[distance] + ray.turned + ray.extra;
        let cost = grounds.priced(self.index, (&bounds, self.crosses), self.round, cost);
        let order = match ray.order {
            (i, true) => distance * DIRECTIONS + i,
            (i, false) => i * DISTANCES.len() + distance,
        };
        let before =
            |(other, its): &(Place, usize)| other.cost.total_cmp(&cost).then(its.cmp(&order)).is_gt();
        let at = self.waiting.partition_point(before);
        self.waiting.insert(at, (Place { bounds, cost, blockers: Blockers::default() }, order));
    }
}

/// What the free places lie in.
fn open_reach(rays: &[Ray], half: Vec2) -> Rect {
    let mut reach = Rect::NOTHING;
    for ray in rays.iter().filter(|ray| ray.free != 0) {
        let (first, last) = (ray.free.trailing_zeros(), ray.free.ilog2());
        for distance in [first, last] {
            reach.add(ray.middle(DISTANCES[distance as usize / SIDE]));
        }
    }
    Rect { min: reach.min - half, max: reach.max + half }
}

/// What all places of a label lie in.
fn reach(half: Vec2, rays: &[Ray]) -> Rect {
    let mut reach = Rect::NOTHING;
    for ray in rays {
        reach.add(ray.middle(0.0));
        reach.add(ray.middle(DISTANCES[DISTANCES.len() - 1]));
    }
    Rect { min: reach.min - half, max: reach.max + half }
}

/// The rays of a label: around its point, or to both sides of its line.
fn find_rays(label: &Label, half: Vec2, directions: &Directions, rays: &mut Vec<Ray>) {
    let best = label.towards.and_then(Vec2::unit);
    let away = best.unwrap_or(Vec2::new(0.707, -0.707));
    let turned =
        |weight: f64, direction: Vec2| weight * libm::atan2(away.cross(direction).abs(), away.dot(direction));
    let to_middle = |direction: Vec2| to_middle(half, direction);
    let free = 0;
    match label.anchor {
        Anchor::Point(p, radius) => {
            for (i, direction) in directions.0.into_iter().enumerate() {
                let (from, turned) = (p + direction * radius, turned(PER_RADIAN, direction));
                let (to_middle, order) = (to_middle(direction), (i, true));
                rays.push(Ray { from, direction, to_middle, turned, extra: 0.0, free, order });
            }
        }
        Anchor::Line(a, b) => {
            let along = (b - a).unit().unwrap_or(Vec2::new(1.0, 0.0));
            let weight = if best.is_some() { PER_RADIAN } else { BESIDE };
            let sides =
                [along.perp(), -along.perp()].map(|side| (side, turned(weight, side), to_middle(side)));
            for (i, part) in ALONG.into_iter().enumerate() {
                let (from, extra) = (a + (b - a) * part, PER_PART * (part - 0.5).abs());
                for (j, (direction, turned, to_middle)) in sides.into_iter().enumerate() {
                    let order = (2 * i + j, false);
                    rays.push(Ray { from, direction, to_middle, turned, extra, free, order });
                }
            }
        }
    }
}

/// The rays around the ends of a line.
fn find_rays_at_ends((a, b): (Vec2, Vec2), half: Vec2, directions: &Directions, rays: &mut Vec<Ray>) {
    for from in [b, a] {
        for direction in directions.0.into_iter().step_by(EVERY) {
            let order = (rays.len(), false);
            let to_middle = to_middle(half, direction);
            rays.push(Ray { from, direction, to_middle, turned: 0.0, extra: AT_END, free: 0, order });
        }
    }
}

/// From the side or the corner of a box to its middle.
fn to_middle(half: Vec2, direction: Vec2) -> Vec2 {
    let largest = direction.x.abs().max(direction.y.abs());
    Vec2::new(half.x * direction.x / largest, half.y * direction.y / largest)
}

// Who is in the way of a place.

/// The labels in the way of a place: how many they are, and the sum of their numbers, which is that of the one if there is one.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Blockers {
    count: usize,
    sum: usize,
}

impl Blockers {
    pub const fn are_none(self) -> bool {
        self.count == 0
    }

    /// The one that is alone in the way.
    pub const fn only(self) -> Option<usize> {
        if self.count == 1 { Some(self.sum) } else { None }
    }

    pub const fn add(&mut self, label: usize) {
        self.count += 1;
        self.sum += label;
    }

    pub const fn remove(&mut self, label: usize) {
        self.count -= 1;
        self.sum -= label;
    }
}
