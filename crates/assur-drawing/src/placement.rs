//! Places for labels: candidates around the anchor, the cheapest free one for each in a fixed order, then rounds in which
//! each moves to something cheaper or takes the place of one neighbour where both together gain. What finds no place is put
//! outside by `outside`. Nothing is random, so that the same labels come to the same places.

use crate::board::Board;
use crate::geometry::{Rect, Segment};
use crate::grid::{Grid, bounds, pieces, touches};
use crate::label::{Anchor, Label};
use crate::mark::{Mark, Obstacle, Shape};
use crate::style::Style;
use assur_math::math::Vec2;
use std::f64::consts::TAU;

/// Directions around a point.
const DIRECTIONS: usize = 24;
/// Distances from the anchor, mm.
const DISTANCES: [f64; 7] = [0.5, 1.0, 1.7, 2.6, 4.0, 6.0, 9.0];
/// Places along a line.
const ALONG: [f64; 7] = [0.5, 0.42, 0.58, 0.34, 0.66, 0.25, 0.75];
/// What is kept free around a label, mm.
pub(crate) const APART: f64 = 0.35;
/// Rounds of improvement.
const ROUNDS: usize = 8;
/// How far labels may be from what is drawn, mm.
const MARGIN: f64 = 30.0;
/// Price of a radian away from the best direction, and of a millimetre of thin line inside, in millimetres of distance.
const PER_RADIAN: f64 = 1.1;
const PER_LINE: f64 = 0.9;
/// Price of the ends of a line against its middle.
const PER_PART: f64 = 4.0;

/// A place that a label may take.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Candidate {
    pub bounds: Rect,
    pub cost: f64,
}

/// What there is later, where the marks move and labels with them.
#[derive(Clone, Debug, Default)]
pub struct Later {
    /// The marks.
    pub marks: Vec<Mark>,
    /// How far each label has moved.
    pub shifts: Vec<Vec2>,
}

/// Price of a place that marks lie on in all later frames, in millimetres of distance.
const LATER: f64 = 20.0;
/// The boxes of all labels, in their order; none for those that found no place.
pub fn place(marks: &[Mark], labels: &[Label], later: &[Later]) -> Vec<Option<Rect>> {
    let mut all = Rect::NOTHING;
    marks.iter().chain(later.iter().flat_map(|l| &l.marks)).for_each(|mark| all.join(&mark.shape.bounds()));
    labels.iter().for_each(|label| match label.anchor {
        Anchor::Point(p, _) => all.add(p),
        Anchor::Line(a, b) => {
            all.add(a);
            all.add(b);
        }
    });
    if all.is_nothing() {
        return vec![None; labels.len()];
    }
    let around = all.grown(MARGIN);
    let ground = Ground::of(marks, &around);
    let grounds: Vec<Ground> = later.iter().map(|l| Ground::of(&l.marks, &around)).collect();
    let candidates = labels.iter().enumerate().map(|(i, label)| {
        let mut own = ground.candidates(label);
        if !later.is_empty() {
            let round = label.ring.is_some_and(|r| label.half().x <= r);
            for candidate in &mut own {
                let on = |(ground, later): &(&Ground, &Later)| {
                    let there = candidate.bounds.shifted(later.shifts[i]);
                    ground.solid.any(&there, |o| touches(&there, round, o, 0.0))
                };
                let hits = grounds.iter().zip(later).filter(on).count();
                candidate.cost += LATER * hits as f64 / later.len() as f64;
            }
            own.sort_by(|a, b| a.cost.total_cmp(&b.cost));
        }
        own
    });
    let candidates: Vec<Vec<Candidate>> = candidates.collect();
    let mut order: Vec<usize> = (0..labels.len()).collect();
    order.sort_by_key(|i| (labels[*i].rank, candidates[*i].len(), *i));
    let mut board = Board::new(labels, &candidates, later, &around);
    for &label in &order {
        board.take_cheapest(label);
    }
    for _ in 0..ROUNDS {
        let mut changed = false;
        for &label in &order {
            changed |= board.improve(label);
        }
        if !changed {
            break;
        }
    }
    board.end(&order)
}

/// What is drawn.
struct Ground {
    solid: Grid<Obstacle>,
    thin: Grid<Segment>,
    /// Circles that only labels of what is in them may enter.
    insets: Vec<Obstacle>,
    /// The directions around a point.
    directions: [Vec2; DIRECTIONS],
}

impl Ground {
    fn of(marks: &[Mark], around: &Rect) -> Self {
        let directions = std::array::from_fn(|i| Vec2::direction(TAU * i as f64 / DIRECTIONS as f64));
        let (solid, thin) = (Grid::over(around), Grid::over(around));
        let mut ground = Self { solid, thin, insets: Vec::new(), directions };
        for mark in marks {
            if let (Style::Inset, Shape::Circle { centre, radius }) = (mark.style, &mark.shape) {
                ground.insets.push(Obstacle::Disc(*centre, *radius));
            }
            if mark.style.is_solid() {
                for obstacle in mark.shape.obstacles(mark.style.half_width()) {
                    match obstacle {
                        Obstacle::Stroke(segment, half) => {
                            for piece in pieces(&segment) {
                                let piece = Obstacle::Stroke(piece, half);
                                ground.solid.add(piece, &bounds(&piece).grown(APART));
                            }
                        }
                        disc @ Obstacle::Disc(..) => ground.solid.add(disc, &bounds(&disc).grown(APART)),
                    }
                }
            } else if mark.style.paint().stroke.is_some() {
                for segment in mark.shape.segments() {
                    pieces(&segment).for_each(|piece| ground.thin.add(piece, &piece.bounds()));
                }
            }
        }
        ground
    }

    /// The free places of a label, the cheapest first.
    fn candidates(&self, label: &Label) -> Vec<Candidate> {
        let half = label.half();
        let mut all = Vec::with_capacity(DISTANCES.len() * DIRECTIONS);
        let best = label.towards.and_then(Vec2::unit);
        let away = best.unwrap_or(Vec2::new(0.707, -0.707));
        let is_point = matches!(label.anchor, Anchor::Point(..));
        let weight = if best.is_some() || is_point { PER_RADIAN } else { 0.3 };
        let turned = |direction: Vec2| weight * libm::atan2(away.cross(direction).abs(), away.dot(direction));
        let mut offer = |from: Vec2, (direction, turned): (Vec2, f64), distance: f64, extra: f64| {
            let bounds = beyond(from, direction, distance, half);
            all.push(Candidate { bounds, cost: distance + turned + extra });
        };
        match label.anchor {
            Anchor::Point(p, radius) => {
                let directions = self.directions.map(|direction| (direction, turned(direction)));
                for distance in DISTANCES {
                    for direction in directions {
                        offer(p + direction.0 * radius, direction, distance, 0.0);
                    }
                }
            }
            Anchor::Line(a, b) => {
                let along = (b - a).unit().unwrap_or(Vec2::new(1.0, 0.0));
                let normals = [along.perp(), -along.perp()].map(|normal| (normal, turned(normal)));
                for part in ALONG {
                    let from = a + (b - a) * part;
                    for normal in normals {
                        for distance in DISTANCES {
                            offer(from, normal, distance, PER_PART * (part - 0.5).abs());
                        }
                    }
                }
            }
        }
        let round = label.ring.is_some_and(|r| half.x <= r);
        all.retain(|c| !self.solid.any(&c.bounds, |o| touches(&c.bounds, round, o, APART)));
        for inset in self.insets.iter().filter(|inset| !holds(inset, label)) {
            all.retain(|c| !touches(&c.bounds, round, inset, APART));
        }
        for candidate in &mut all {
            let mut inside = 0.0;
            self.thin.any(&candidate.bounds, |s| {
                inside += candidate.bounds.inside(s).unwrap_or(0.0);
                false
            });
            candidate.cost += PER_LINE * inside;
        }
        all.sort_by(|a, b| a.cost.total_cmp(&b.cost));
        all
    }
}

/// Whether what a label is about lies in a disc.
fn holds(inset: &Obstacle, label: &Label) -> bool {
    let (Obstacle::Disc(centre, radius), Anchor::Point(at, _) | Anchor::Line(at, _)) = (inset, label.anchor)
    else {
        return false;
    };
    (at - *centre).norm() < *radius
}

/// The box that lies beyond a point in a direction: its side or its corner has the distance.
fn beyond(from: Vec2, direction: Vec2, distance: f64, half: Vec2) -> Rect {
    let largest = direction.x.abs().max(direction.y.abs());
    let near = from + direction * distance;
    let centre = near + Vec2::new(half.x * direction.x / largest, half.y * direction.y / largest);
    Rect::around(centre, half)
}
