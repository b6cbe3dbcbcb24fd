//! The places of a label, the cheapest first, looked for as far as they are asked for.

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
}

/// Where labels may go from an anchor: a point and a direction, with its prices.
struct Ray {
    from: Vec2,
    direction: Vec2,
    turned: f64,
    extra: f64,
    /// At which distances it is free.
    free: [bool; DISTANCES.len()],
    /// The order among rays, and that among distances: of equal places the first is taken.
    order: (usize, bool),
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
        let best = label.towards.and_then(Vec2::unit);
        let away = best.unwrap_or(Vec2::new(0.707, -0.707));
        let turned = |weight: f64, direction: Vec2| {
            weight * libm::atan2(away.cross(direction).abs(), away.dot(direction))
        };
        let free = |from: Vec2, direction: Vec2| {
            DISTANCES.map(|far| grounds.is_free(label, &beyond(from, direction, far, half), round))
        };
        let free = &free;
        let rays: Vec<Ray> = match label.anchor {
            Anchor::Point(p, radius) => {
                let ray = |(i, direction): (usize, &Vec2)| {
                    let (from, turned) = (p + *direction * radius, turned(PER_RADIAN, *direction));
                    let free = free(from, *direction);
                    Ray { from, direction: *direction, turned, extra: 0.0, free, order: (i, true) }
                };
                directions.0.iter().enumerate().map(ray).collect()
            }
            Anchor::Line(a, b) => {
                let along = (b - a).unit().unwrap_or(Vec2::new(1.0, 0.0));
                let weight = if best.is_some() { PER_RADIAN } else { BESIDE };
                let normals = [along.perp(), -along.perp()].map(|normal| (normal, turned(weight, normal)));
                let ray = |(i, part): (usize, f64)| {
                    let (from, extra) = (a + (b - a) * part, PER_PART * (part - 0.5).abs());
                    let ray = move |(j, (direction, turned)): (usize, (Vec2, f64))| Ray {
                        from,
                        direction,
                        turned,
                        extra,
                        free: free(from, direction),
                        order: (2 * i + j, false),
                    };
                    normals.into_iter().enumerate().map(ray)
                };
                ALONG.into_iter().enumerate().flat_map(ray).collect()
            }
        };
        let mut prices: Vec<(f64, usize)> =
            rays.iter().enumerate().map(|(i, ray)| (ray.turned + ray.extra, i)).collect();
        prices.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let count = rays.iter().flat_map(|ray| ray.free).filter(|free| *free).count();
        let best = prices.first().map_or(f64::INFINITY, |(price, _)| *price);
        let (next, least) = (Default::default(), DISTANCES.map(|distance| distance + best - ROUNDING));
        let (known, waiting) = (Vec::with_capacity(16), Vec::with_capacity(16));
        Self { index, half, round, rays, prices, count, next, least, known, waiting }
    }

    /// The place of a number, where there are so many.
    pub fn get(&mut self, number: usize, grounds: &Grounds<'_>) -> Option<Place> {
        while self.known.len() <= number {
            let (mut distance, mut least) = (0, f64::INFINITY);
            for (i, price) in self.least.iter().enumerate() {
                if *price < least {
                    (distance, least) = (i, *price);
                }
            }
            if self.waiting.last().is_some_and(|(place, _)| place.cost < least) {
                self.known.extend(self.waiting.pop().map(|(place, _)| place));
            } else if least < f64::INFINITY {
                self.look(distance, grounds);
            } else {
                return None;
            }
        }
        self.known.get(number).copied()
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
        let bounds = beyond(ray.from, ray.direction, DISTANCES[distance], self.half);
        let cost = DISTANCES[distance] + ray.turned + ray.extra;
        let cost = grounds.priced(self.index, &bounds, self.round, cost);
        let order = match ray.order {
            (i, true) => distance * DIRECTIONS + i,
            (i, false) => i * DISTANCES.len() + distance,
        };
        let before =
            |(other, its): &(Place, usize)| other.cost.total_cmp(&cost).then(its.cmp(&order)).is_gt();
        let at = self.waiting.partition_point(before);
        self.waiting.insert(at, (Place { bounds, cost }, order));
    }
}

/// The box that lies beyond a point in a direction: its side or its corner has the distance.
fn beyond(from: Vec2, direction: Vec2, distance: f64, half: Vec2) -> Rect {
    let largest = direction.x.abs().max(direction.y.abs());
    let near = from + direction * distance;
    let centre = near + Vec2::new(half.x * direction.x / largest, half.y * direction.y / largest);
    Rect::around(centre, half)
}
