//! What labels meet on the paper: what they may not touch, and what they cross at a price.

use crate::clearance::{Boxes, Clearance};
use crate::geometry::{Rect, Segment};
use crate::grid::{Grid, bounds, pieces, touches};
use crate::label::{Anchor, Label};
use crate::mark::{Mark, Obstacle, Shape};
use crate::placement::{APART, Later};
use crate::style::Style;
use assur_math::math::Vec2;

/// Price of a millimetre of thin line inside, in millimetres of distance.
const PER_LINE: f64 = 0.9;
/// Price of a place that marks lie on in all later frames, in millimetres of distance.
const LATER: f64 = 20.0;

struct Ground {
    /// What no label may touch, and which of it is where.
    obstacles: Vec<Obstacle>,
    solid: Grid<usize>,
    thin: Grid<Segment>,
    /// Circles that only labels of what is in them may enter.
    insets: Vec<Obstacle>,
    /// What is kept free around labels, mm.
    apart: f64,
}

/// What is drawn now and in later frames.
pub(crate) struct Grounds<'a> {
    now: Ground,
    later: Vec<(Ground, &'a Later)>,
}

/// The obstacles that a search meets, none between searches, and what came of the last one.
#[derive(Default)]
pub(crate) struct Met {
    numbers: Vec<usize>,
    is_met: Vec<bool>,
    clearance: Clearance,
}

impl<'a> Grounds<'a> {
    pub fn of(marks: &[Mark], later: &'a [Later], around: &Rect) -> Self {
        let now = Ground::of(marks, around, APART);
        Self { now, later: later.iter().map(|l| (Ground::of(&l.marks, around, 0.0), l)).collect() }
    }

    /// What is solid in a box, for boxes of a size in it.
    pub fn clearance<'m>(&self, around: &Rect, half: Vec2, round: bool, met: &'m mut Met) -> &'m Clearance {
        // several pieces of one, and pieces in several cells
        met.is_met.resize(self.now.obstacles.len(), false);
        self.now.solid.any(around, |number| {
            if !std::mem::replace(&mut met.is_met[*number], true) {
                met.numbers.push(*number);
            }
            false
        });
        let obstacles = met.numbers.iter().map(|number| self.now.obstacles[*number]);
        met.clearance.fill(obstacles, Boxes { half, round, apart: self.now.apart }, around.centre());
        met.numbers.drain(..).for_each(|number| met.is_met[number] = false);
        &met.clearance
    }

    /// Whether there are circles in which things are magnified.
    pub const fn closes(&self) -> bool {
        !self.now.insets.is_empty()
    }

    /// Whether a place is in a circle in which other things are magnified.
    pub fn is_closed(&self, label: &Label, place: &Rect, round: bool) -> bool {
        self.now.is_closed(label, place, round)
    }

    /// Whether a line may be crossed in a box.
    pub fn has_thin(&self, around: &Rect) -> bool {
        self.now.thin.any(around, |_| true)
    }

    /// What a place costs a label with the lines that it crosses, if there are any.
    pub fn priced(&self, index: usize, (place, crosses): (&Rect, bool), round: bool, cost: f64) -> f64 {
        let cost = if crosses { cost + PER_LINE * self.now.crossed(place) } else { cost };
        if self.later.is_empty() {
            return cost;
        }
        let on =
            |(ground, later): &&(Ground, &Later)| ground.is_taken(&place.shifted(later.shifts[index]), round);
        let hits = self.later.iter().filter(on).count();
        cost + LATER * hits as f64 / self.later.len() as f64
    }
}

impl Ground {
    fn of(marks: &[Mark], around: &Rect, apart: f64) -> Self {
        let (solid, thin) = (Grid::over(around), Grid::over(around));
        let mut ground = Self { obstacles: Vec::new(), solid, thin, insets: Vec::new(), apart };
        for mark in marks {
            if let (Style::Inset, Shape::Circle { centre, radius }) = (mark.style, &mark.shape) {
                ground.insets.push(Obstacle::Disc(*centre, *radius));
            }
            if mark.style.is_solid() {
                mark.shape.each_obstacle(mark.style.half_width(), |obstacle| ground.add(obstacle));
            } else if mark.style.paint().stroke.is_some() {
                mark.shape.each_segment(|segment| {
                    pieces(&segment).for_each(|piece| ground.thin.add(piece, &piece.bounds()));
                });
            }
        }
        ground
    }

    /// Adds what no label may touch.
    fn add(&mut self, obstacle: Obstacle) {
        // the sectors of a mass centre
        if self.obstacles.last().is_some_and(|last| covers(last, &obstacle)) {
            return;
        }
        let number = self.obstacles.len();
        self.obstacles.push(obstacle);
        match obstacle {
            Obstacle::Stroke(segment, half) => {
                for piece in pieces(&segment) {
                    self.solid.add(number, &bounds(&Obstacle::Stroke(piece, half)).grown(APART));
                }
            }
            Obstacle::Disc(..) => self.solid.add(number, &bounds(&obstacle).grown(APART)),
        }
    }

    /// Whether something that no label may touch is in a box, or in the disc in it.
    fn is_taken(&self, place: &Rect, round: bool) -> bool {
        self.solid.any(place, |number| touches(place, round, &self.obstacles[*number], self.apart))
    }

    /// Whether a place is in an inset of something else.
    fn is_closed(&self, label: &Label, place: &Rect, round: bool) -> bool {
        self.insets.iter().any(|inset| !holds(inset, label) && touches(place, round, inset, APART))
    }

    /// The length of thin lines in a place, mm.
    fn crossed(&self, place: &Rect) -> f64 {
        let mut inside = 0.0;
        self.thin.any(place, |s| {
            inside += place.inside(s).unwrap_or(0.0);
            false
        });
        inside
    }
}

/// Whether a stroke lies in a disc.
fn covers(disc: &Obstacle, stroke: &Obstacle) -> bool {
    let (Obstacle::Disc(centre, radius), Obstacle::Stroke(Segment { a, b }, half)) = (disc, stroke) else {
        return false;
    };
    // square ends
    [a, b].into_iter().all(|end| (*end - *centre).norm() + half * std::f64::consts::SQRT_2 <= *radius)
}

/// Whether what a label is about lies in a disc.
fn holds(inset: &Obstacle, label: &Label) -> bool {
    let (Obstacle::Disc(centre, radius), Anchor::Point(at, _) | Anchor::Line(at, _)) = (inset, label.anchor)
    else {
        return false;
    };
    (at - *centre).norm() < *radius
}
