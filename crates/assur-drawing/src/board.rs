//! Which label has which place: the cheapest free one first, then moves to something cheaper, alone or with one neighbour.

use crate::geometry::Rect;
use crate::ground::Grounds;
use crate::label::Label;
use crate::placement::{APART, Later};
use crate::places::{Place, Places};
use crate::seats::Seats;
use assur_math::math::Vec2;

/// The part of the later frames in which two labels may overlap.
const PASSING: f64 = 0.1;
/// What it costs to have no place inside, mm.
const OUTSIDE: f64 = 60.0;
/// What places may cost beyond what is asked for and are looked at with the others, mm.
const BEYOND: f64 = 2.0;

/// By how much a place is cheaper than another at least, mm.
const CHEAPER: f64 = 1e-9;

/// Who sits where.
pub(crate) struct Board<'a> {
    places: Vec<Places>,
    grounds: &'a Grounds<'a>,
    later: &'a [Later],
    chosen: Vec<Option<usize>>,
    /// The boxes that labels have.
    boxes: Vec<Rect>,
    /// By how much each of them moves in later frames.
    ways: Vec<Rect>,
    /// Where they are in any of the frames.
    seats: Seats,
    ranks: Vec<u8>,
    /// Where labels were that have left, and are that have come, in any of the frames; in order.
    changes: Vec<Rect>,
    /// Of a label that found nothing cheaper: when that was, and where it looked.
    looked: Vec<Option<Moment>>,
    views: Vec<View>,
}

/// How many changes there were, and where another one counts.
#[derive(Clone, Copy)]
struct Moment {
    changes: usize,
    region: Rect,
}

/// The places of a label that cost less than something, with at most one other in the way, as they were at a moment.
#[derive(Clone)]
struct View {
    below: f64,
    at: Moment,
    places: Vec<(usize, Option<usize>)>,
}

/// Who is in the way of a place.
enum Way {
    Free,
    Of(usize),
    OfSeveral,
}

impl<'a> Board<'a> {
    pub fn new(
        labels: &[Label],
        places: Vec<Places>,
        (grounds, later): (&'a Grounds<'a>, &'a [Later]),
        around: &Rect,
    ) -> Self {
        let count = labels.len();
        let at = Moment { changes: 0, region: Rect::NOTHING };
        Self {
            places,
            grounds,
            later,
            chosen: vec![None; count],
            boxes: vec![Rect::NOTHING; count],
            ways: (0..count).map(|label| way_of(later, label)).collect(),
            seats: Seats::over(around),
            ranks: labels.iter().map(|l| l.rank).collect(),
            changes: Vec::new(),
            looked: vec![None; count],
            views: vec![View { below: f64::NEG_INFINITY, at, places: Vec::new() }; count],
        }
    }

    fn cost(&self, label: usize) -> f64 {
        match self.chosen[label] {
            Some(number) => self.place(label, number).cost,
            None => OUTSIDE - f64::from(self.ranks[label]),
        }
    }

    /// A place that was looked at.
    fn place(&self, label: usize, number: usize) -> Place {
        self.places[label].known[number]
    }

    /// Where a label is in any of the frames from a place.
    fn swept(&self, label: usize, place: &Rect) -> Rect {
        let way = &self.ways[label];
        Rect { min: place.min + way.min, max: place.max + way.max }
    }

    /// Where the box of a label is in any of the frames.
    fn seat(&self, label: usize) -> Rect {
        self.swept(label, &self.boxes[label])
    }

    /// Moves a label to another place, or to none.
    fn choose(&mut self, label: usize, number: Option<usize>) {
        if self.chosen[label].is_some() {
            self.seats.put(label, &self.seat(label), false);
        }
        self.boxes[label] = number.map_or(Rect::NOTHING, |n| self.place(label, n).bounds);
        if number.is_some() {
            self.seats.put(label, &self.seat(label), true);
        }
        self.chosen[label] = number;
    }

    /// Tells of the places that cost less, the cheapest first, who is in their way, until it is told enough; where it looked.
    fn each_below(
        &mut self,
        label: usize,
        below: f64,
        mut is_enough: impl FnMut(usize, Way) -> bool,
    ) -> Rect {
        let mut seen = Rect::NOTHING;
        let mut number = 0;
        while let Some(place) = self.places[label].get(number, self.grounds).filter(|p| p.cost < below) {
            seen.join(&self.swept(label, &place.bounds).grown(APART));
            if is_enough(number, self.way(label, &place.bounds)) {
                break;
            }
            number += 1;
        }
        seen
    }

    /// Who is in the way of a place.
    fn way(&self, label: usize, bounds: &Rect) -> Way {
        let (mut way, near) = (Way::Free, bounds.grown(APART));
        self.seats.any(&self.swept(label, &near), |other| {
            let its = &self.boxes[other];
            if (its.overlaps(&near) || self.meets_later((label, bounds), (other, its))) && other != label {
                way = match way {
                    Way::Free => Way::Of(other),
                    Way::Of(known) if known == other => Way::Of(known),
                    _ => Way::OfSeveral,
                };
            }
            matches!(way, Way::OfSeveral)
        });
        way
    }

    /// Whether two labels at places overlap, or do so in too many of the later frames.
    fn meets(&self, (one, own): (usize, &Rect), (other, its): (usize, &Rect)) -> bool {
        its.overlaps(&own.grown(APART)) || self.meets_later((one, own), (other, its))
    }

    /// Whether two labels at places overlap in too many of the later frames.
    fn meets_later(&self, (one, own): (usize, &Rect), (other, its): (usize, &Rect)) -> bool {
        if self.later.is_empty() || !self.swept(one, own).overlaps(&self.swept(other, its)) {
            return false;
        }
        let on = |l: &&Later| its.shifted(l.shifts[other]).overlaps(&own.shifted(l.shifts[one]));
        self.later.iter().filter(on).count() as f64 > PASSING * self.later.len() as f64
    }

    /// Takes the cheapest place that is free.
    pub fn take_cheapest(&mut self, label: usize) {
        let mut found = None;
        self.each_below(label, f64::INFINITY, |number, way| {
            found = matches!(way, Way::Free).then_some(number);
            found.is_some()
        });
        self.choose(label, found);
    }

    /// Whether nothing has changed since, where it counts.
    fn is_as(&self, at: &Moment) -> bool {
        !self.changes[at.changes..].iter().any(|change| change.overlaps(&at.region))
    }

    /// Looks at the places of a label that cost less, if that is not known.
    fn look(&mut self, label: usize, below: f64) {
        let known = &self.views[label];
        if known.below >= below && self.is_as(&known.at) {
            return;
        }
        let (below, mut places) = (below + BEYOND, std::mem::take(&mut self.views[label].places));
        places.clear();
        let region = self.each_below(label, below, |number, way| {
            match way {
                Way::Free => places.push((number, None)),
                Way::Of(other) => places.push((number, Some(other))),
                Way::OfSeveral => {}
            }
            false
        });
        self.views[label] = View { below, at: Moment { changes: self.changes.len(), region }, places };
    }

    /// Whether no place of a label is cheaper than the one it has, taken or not.
    fn has_best(&self, label: usize) -> bool {
        self.places[label].known.first().is_some_and(|best| best.cost >= self.cost(label) - CHEAPER)
    }

    /// Moves a label to a cheaper place, where needed by moving one neighbour; whether anything changed.
    pub fn improve(&mut self, label: usize) -> bool {
        if self.has_best(label) || self.looked[label].is_some_and(|at| self.is_as(&at)) {
            return false;
        }
        let before = self.seat(label);
        let mut seen = before;
        let changed = self.search(label, &mut seen);
        if changed {
            self.changes.extend([before, self.seat(label)]);
        }
        self.looked[label] = (!changed).then_some(Moment { changes: self.changes.len(), region: seen });
        changed
    }

    /// The same, with where it looked.
    fn search(&mut self, label: usize, seen: &mut Rect) -> bool {
        let own = self.cost(label);
        self.look(label, own - CHEAPER);
        seen.join(&self.views[label].at.region);
        let places = std::mem::take(&mut self.views[label].places);
        let cost = |board: &Self, number: usize| board.place(label, number).cost;
        let free =
            places.iter().find(|(number, other)| other.is_none() && cost(self, *number) < own - CHEAPER);
        let free = free.map(|(number, _)| *number);
        let reached = free.map_or(own, |number| cost(self, number));
        let mut swap = None;
        for &(number, other) in &places {
            let Place { bounds, cost } = self.place(label, number);
            if cost >= own - CHEAPER || cost >= reached - CHEAPER {
                break;
            }
            let Some(neighbour) = other else { continue };
            let most = reached - cost + self.cost(neighbour);
            if let Some(moved) = self.gives_way(neighbour, (label, &bounds), most - CHEAPER, seen) {
                swap = Some((number, neighbour, moved));
                break;
            }
        }
        self.views[label].places = places;
        if let Some((number, neighbour, moved)) = swap {
            let left = self.seat(neighbour);
            self.choose(neighbour, Some(moved));
            self.changes.extend([left, self.seat(neighbour)]);
            self.choose(label, Some(number));
        } else if free.is_some() {
            self.choose(label, free);
        }
        swap.is_some() || free.is_some()
    }

    /// The cheapest place of a label that costs less and would be free if another one moved to a place.
    fn gives_way(
        &mut self,
        label: usize,
        (to, place): (usize, &Rect),
        below: f64,
        seen: &mut Rect,
    ) -> Option<usize> {
        self.look(label, below);
        let view = &self.views[label];
        seen.join(&view.at.region);
        let left = view.places.iter().map(|(number, other)| (*number, self.place(label, *number), *other));
        let mut left = left.take_while(|(_, own, _)| own.cost < below);
        let free = |(_, own, other): &(usize, Place, Option<usize>)| {
            other.is_none_or(|other| other == to) && !self.meets((label, &own.bounds), (to, place))
        };
        left.find(free).map(|(number, ..)| number)
    }

    /// The places of all labels; better in the way later than outside.
    pub fn end(mut self, order: &[usize]) -> Vec<Option<Rect>> {
        self.later = &[];
        for &label in order {
            if self.chosen[label].is_none() {
                self.take_cheapest(label);
            }
        }
        (0..order.len()).map(|i| self.chosen[i].map(|_| self.boxes[i])).collect()
    }
}

/// The box of all that a label moves by, with nothing.
fn way_of(later: &[Later], label: usize) -> Rect {
    let mut way = Rect::around(Vec2::zero(), Vec2::zero());
    later.iter().for_each(|l| way.add(l.shifts[label]));
    way
}
