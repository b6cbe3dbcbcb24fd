//! Places for labels: the cheapest free one for each, first for those with few, then rounds in which each moves to something cheaper or takes
//! the place of one neighbour where both together gain. What finds no place is put outside by `outside`. Nothing is random, so that
//! the same labels come to the same places.

use crate::board::Board;
use crate::geometry::Rect;
use crate::ground::Grounds;
use crate::label::{Anchor, Label};
use crate::mark::Mark;
use crate::places::{Directions, Places, SearchMemory};
use assur_math::math::Vec2;

/// What is kept free around a label, mm.
pub(crate) const APART: f64 = 0.35;
const ROUNDS: usize = 8;
/// How far labels may be from what is drawn, mm.
const MARGIN: f64 = 30.0;

/// What there is later, where the marks move and labels with them.
#[derive(Clone, Debug, Default)]
pub struct Later {
    pub marks: Vec<Mark>,
    /// How far each label has moved.
    pub shifts: Vec<Vec2>,
}

/// The boxes of all labels, in their order; none for those that found no place. `boxes` are those of the marks.
pub fn place((marks, boxes): (&[Mark], &[Rect]), labels: &[Label], later: &[Later]) -> Vec<Option<Rect>> {
    let mut all = Rect::NOTHING;
    boxes.iter().for_each(|own| all.join(own));
    later.iter().flat_map(|l| &l.marks).for_each(|mark| all.join(&mark.shape.bounds()));
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
    let grounds = Grounds::of(marks, later, &around);
    let (directions, mut again) = (Directions::new(), SearchMemory::default());
    let places_of = |label| Places::of(label, &directions, &grounds, &mut again);
    let places: Vec<Places> = labels.iter().enumerate().map(places_of).collect();
    let mut order: Vec<usize> = (0..labels.len()).collect();
    order.sort_by_key(|i| (labels[*i].rank, places[*i].count, *i));
    let mut board = Board::new(labels, places, (&grounds, later));
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
