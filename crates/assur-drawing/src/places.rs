//! The places of a label, the cheapest first, looked for as far as they are asked for.

use crate::blockers::Blockers;
use crate::geometry::Rect;
use crate::ground::Grounds;
use crate::label::{Anchor, Label};
use assur_math::math::Vec2;
use std::f64::consts::TAU;

/// Directions around a point.
const DIRECTIONS: usize = 24;
/// Distances from the anchor, mm.
const DISTANCES: [f64; 7] = [0.5, 1.0, 1.7, 2.6, 4.0, 6.0, 9.0];
/// Places along a line.
const ALONG: [f64; 7] = [0.5, 0.42, 0.58, 0.34, 0.66, 0.25, 0.75];
/// Price of a radian away from the best direction, in millimetres of distance; the same beside a line that has none.
const PER_RADIAN: f64 = 1.1;
const BESIDE: f64 = 0.3;
/// Price of the ends of a line against its middle.
const PER_PART: f64 = 4.0;
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
struct Ray {
    from: Vec2,
    direction: Vec2,
    /// From the point at a distance to the middle of the box, whose side or corner is there.
    to_middle: Vec2,
    turned: f64,
    extra: f64,
    /// At which distances it is free.
    free: [bool; DISTANCES.len()],
    /// The order among rays, and that among distances: of equal places the first is taken.
    order: (usize, bool),
}

impl Ray {
    /// The middle of the box at a distance.
    fn middle(&self, distance: f64) -> Vec2 {
        self.from + self.direction * distance + self.to_middle
    }
}

/// The directions around a point.
pub(crate) struct Directions([Vec2; DIRECTIONS]);

impl Directions {
    pub fn new() -> Self {
        Self(std::array::from_fn(|i| Vec2::direction(TAU * i as f64 / DIRECTIONS as f64)))
    }
}

/// The places of a label.
pub(crate) struct Places {
    /// The number of the label.
    index: usize,
    half: Vec2,
    round: bool,
    rays: Vec<Ray>,
    /// Their prices with their numbers, the best first.
    prices: Vec<(f64, usize)>,
    /// How many places are free.
    pub count: usize,
    /// What they all lie in.
    pub reach: Rect,
    /// Whether some may cross a line.
    crosses: bool,
    /// For every distance the next ray, and the least that the place there costs.
    next: [usize; DISTANCES.len()],
    least: [f64; DISTANCES.len()],
    /// Free places, the cheapest first.
    pub known: Vec<Place>,
    /// Others before which there may be cheaper ones, with their order, the cheapest last.
    waiting: Vec<(Place, usize)>,
}

impl Places {
    pub fn of(index: usize, label: &Label, directions: &Directions, grounds: &Grounds<'_>) -> Self {
        let half = label.half();
        let round = label.ring.is_some_and(|r| half.x <= r);
        let mut rays = rays(label, half, directions);
        let mut reach = Rect::NOTHING;
        for ray in &rays {
            reach.add(ray.middle(DISTANCES[0]));
            reach.add(ray.middle(DISTANCES[DISTANCES.len() - 1]));
        }
        reach = Rect { min: reach.min - half, max: reach.max + half };
        let crosses = grounds.has_thin(&reach);
        let (clearance, mut count) = (grounds.clearance(&reach, half, round), 0);
        for ray in &mut rays {
            let middles = DISTANCES.map(|far| ray.middle(far));
            let is_open = |at: Vec2| !grounds.is_closed(label, &Rect::around(at, half), round);
            ray.free = middles.map(is_open);
            clearance.thin((ray.middle(0.0), ray.direction), &DISTANCES, &middles, &mut ray.free);
            count += ray.free.into_iter().filter(|free| *free).count();
        }
        let mut prices: Vec<(f64, usize)> =
            rays.iter().enumerate().map(|(i, ray)| (ray.turned + ray.extra, i)).collect();
        prices.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let best = prices.first().map_or(f64::INFINITY, |(price, _)| *price);
        let (next, least) = (Default::default(), DISTANCES.map(|distance| distance + best - ROUNDING));
        let (known, waiting) = (Vec::with_capacity(16), Vec::with_capacity(16));
        Self { index, half, round, rays, prices, count, reach, crosses, next, least, known, waiting }
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
            self.look(distance, grounds);
        }
    }

    /// Looks at the next place at a distance.
    fn look(&mut self, distance: usize, grounds: &Grounds<'_>) {
        let ray = &self.rays[self.prices[self.next[distance]].1];
        self.next[distance] += 1;
        let price = self.prices.get(self.next[distance]).map_or(f64::INFINITY, |(price, _)| *price);
        self.least[distance] = DISTANCES[distance] + price - ROUNDING;
        if !ray.free[distance] {
            return;
        }
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

/// The rays of a label: around its point, or to both sides of its line.
fn rays(label: &Label, half: Vec2, directions: &Directions) -> Vec<Ray> {
    let best = label.towards.and_then(Vec2::unit);
    let away = best.unwrap_or(Vec2::new(0.707, -0.707));
    let turned =
        |weight: f64, direction: Vec2| weight * libm::atan2(away.cross(direction).abs(), away.dot(direction));
    let to_middle = |direction: Vec2| {
        let largest = direction.x.abs().max(direction.y.abs());
        Vec2::new(half.x * direction.x / largest, half.y * direction.y / largest)
    };
    let free = [false; DISTANCES.len()];
    let mut rays = Vec::with_capacity(DIRECTIONS);
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
    rays
}
