//! Which label has which place: the cheapest free one first, then moves to something cheaper, alone or with one neighbour. Every place that
//! was looked at knows who is in its way, and hears when a neighbour moves.

use crate::geometry::Rect;
use crate::ground::Grounds;
use crate::label::Label;
use crate::placement::{APART, Later};
use crate::places::{Blockers, Place, Places};
use assur_math::math::Vec2;

/// The part of the later frames in which two labels may overlap.
const PASSING: f64 = 0.1;
/// What it costs to have no place inside, mm.
const OUTSIDE: f64 = 60.0;
/// Room for so many labels that may come in the way of one.
const NEAR: usize = 16;
/// By how much a place is cheaper than another at least, mm.
const CHEAPER: f64 = 1e-9;

pub(crate) struct Board<'a> {
    places: Vec<Places>,
    grounds: &'a Grounds<'a>,
    later: &'a [Later],
    ranks: Vec<u8>,
    /// By how much each label moves in later frames.
    ways: Vec<Rect>,
    /// The labels that may come in each other's way.
    near: Vec<Vec<usize>>,
    chosen: Vec<Option<usize>>,
    /// The boxes that labels have.
    boxes: Vec<Rect>,
    /// How many moves there were; the last one of a label or near it; and the last one before a label found nothing cheaper.
    moves: usize,
    stirred: Vec<usize>,
    tried: Vec<Option<usize>>,
}

impl<'a> Board<'a> {
    pub fn new(
        labels: &[Label],
        places: Vec<Places>,
        (grounds, later): (&'a Grounds<'a>, &'a [Later]),
    ) -> Self {
        let count = labels.len();
        let ways: Vec<Rect> = (0..count).map(|label| way_of(later, label)).collect();
        let reach: Vec<Rect> = places.iter().zip(&ways).map(|(p, way)| swept(way, &p.reach)).collect();
        Self {
            near: near(&reach),
            places,
            grounds,
            later,
            ranks: labels.iter().map(|l| l.rank).collect(),
            ways,
            chosen: vec![None; count],
            boxes: vec![Rect::NOTHING; count],
            moves: 0,
            stirred: vec![0; count],
            tried: vec![None; count],
        }
    }

    fn cost(&self, label: usize) -> f64 {
        match self.chosen[label] {
            Some(number) => self.known(label, number).cost,
            None => OUTSIDE - f64::from(self.ranks[label]),
        }
    }

    /// A place that was looked at.
    fn known(&self, label: usize, number: usize) -> Place {
        self.places[label].known[number]
    }

    /// The place of a number, the cheapest first, where there are so many; none is asked for before those with lower numbers.
    #[inline]
    fn place(&mut self, label: usize, number: usize) -> Option<Place> {
        match self.places[label].known.get(number) {
            Some(place) => Some(*place),
            None => self.find(label),
        }
    }

    fn find(&mut self, label: usize) -> Option<Place> {
        let mut place = self.places[label].find(self.grounds)?;
        place.blockers = self.blockers(label, &place.bounds);
        self.places[label].known.push(place);
        Some(place)
    }

    /// Who is in the way of a place.
    fn blockers(&self, label: usize, bounds: &Rect) -> Blockers {
        let (mut blockers, near) = (Blockers::default(), bounds.grown(APART));
        for &other in &self.near[label] {
            let its = &self.boxes[other];
            if its.overlaps(&near) || self.meets_later((label, bounds), (other, its)) {
                blockers.add(other);
            }
        }
        blockers
    }

    /// Whether two labels at places overlap, or do so in too many of the later frames.
    fn meets(&self, (one, own): (usize, &Rect), (other, its): (usize, &Rect)) -> bool {
        its.overlaps(&own.grown(APART)) || self.meets_later((one, own), (other, its))
    }

    /// Whether two labels at places overlap in too many of the later frames.
    #[inline]
    fn meets_later(&self, one: (usize, &Rect), other: (usize, &Rect)) -> bool {
        !self.later.is_empty() && self.meets_often(one, other)
    }

    fn meets_often(&self, (one, own): (usize, &Rect), (other, its): (usize, &Rect)) -> bool {
        if !swept(&self.ways[one], own).overlaps(&swept(&self.ways[other], its)) {
            return false;
        }
        let on = |l: &&Later| its.shifted(l.shifts[other]).overlaps(&own.shifted(l.shifts[one]));
        self.later.iter().filter(on).count() as f64 > PASSING * self.later.len() as f64
    }

    /// Moves a label to another place, or to none.
    fn choose(&mut self, label: usize, number: Option<usize>) {
        let left = self.boxes[label];
        let taken = number.map_or(Rect::NOTHING, |n| self.known(label, n).bounds);
        (self.chosen[label], self.boxes[label]) = (number, taken);
        self.moves += 1;
        self.stirred[label] = self.moves;
        let near = std::mem::take(&mut self.near[label]);
        for &other in &near {
            self.stirred[other] = self.moves;
            let reach = self.places[other].reach.grown(APART);
            if self.later.is_empty() && !reach.overlaps(&left) && !reach.overlaps(&taken) {
                continue;
            }
            let mut known = std::mem::take(&mut self.places[other].known);
            for place in &mut known {
                if self.meets((other, &place.bounds), (label, &left)) {
                    place.blockers.remove(label);
                }
                if self.meets((other, &place.bounds), (label, &taken)) {
                    place.blockers.add(label);
                }
            }
            self.places[other].known = known;
        }
        self.near[label] = near;
    }

    /// Takes the cheapest place that is free.
    pub fn take_cheapest(&mut self, label: usize) {
        let mut number = 0;
        while let Some(place) = self.place(label, number) {
            if place.blockers.are_none() {
                return self.choose(label, Some(number));
            }
            number += 1;
        }
    }

    /// Whether no place of a label is cheaper than the one it has, taken or not.
    fn has_best(&self, label: usize) -> bool {
        self.places[label].known.first().is_some_and(|best| best.cost >= self.cost(label) - CHEAPER)
    }

    /// The last move of the labels that may be in the way of a label, or in the way of these.
    fn last_move_around(&self, label: usize) -> usize {
        self.near[label].iter().map(|other| self.stirred[*other]).fold(self.stirred[label], usize::max)
    }

    /// Moves a label to a cheaper place, where needed by moving one neighbour; whether anything changed.
    pub fn improve(&mut self, label: usize) -> bool {
        if self.has_best(label) || self.tried[label].is_some_and(|at| self.last_move_around(label) <= at) {
            return false;
        }
        let changed = self.search(label);
        self.tried[label] = (!changed).then_some(self.moves);
        changed
    }

    fn search(&mut self, label: usize) -> bool {
        let own = self.cost(label);
        let (mut reached, mut number) = (own, 0);
        let mut found: Option<(usize, Option<(usize, usize)>)> = None;
        while let Some(place) = self.place(label, number).filter(|p| p.cost < own - CHEAPER) {
            if place.blockers.are_none() {
                (reached, found) = (place.cost, Some((number, None)));
                break;
            }
            number += 1;
        }
        for number in 0..number {
            let Place { bounds, cost, blockers } = self.known(label, number);
            if cost >= reached - CHEAPER {
                break;
            }
            let Some(neighbour) = blockers.only() else { continue };
            let most = reached - cost + self.cost(neighbour);
            if let Some(moved) = self.gives_way(neighbour, (label, &bounds), most - CHEAPER) {
                found = Some((number, Some((neighbour, moved))));
                break;
            }
        }
        let Some((number, moved)) = found else { return false };
        if let Some((neighbour, to)) = moved {
            self.choose(neighbour, Some(to));
        }
        self.choose(label, Some(number));
        true
    }

    /// The cheapest place of a label that costs less and would be free if another one moved to a place.
    fn gives_way(&mut self, label: usize, (to, place): (usize, &Rect), below: f64) -> Option<usize> {
        let mut number = 0;
        loop {
            while let Some(own) = self.places[label].known.get(number) {
                let by = own.blockers;
                if own.cost >= below {
                    return None;
                } else if (by.are_none() || by.only() == Some(to))
                    && !self.meets((label, &own.bounds), (to, place))
                {
                    return Some(number);
                }
                number += 1;
            }
            self.find(label)?;
        }
    }

    /// The places of all labels; better in the way later than outside.
    pub fn end(mut self, order: &[usize]) -> Vec<Option<Rect>> {
        self.later = &[];
        for &label in order {
            let mut number = 0;
            while let (None, Some(place)) = (self.chosen[label], self.place(label, number)) {
                if self.blockers(label, &place.bounds).are_none() {
                    (self.chosen[label], self.boxes[label]) = (Some(number), place.bounds);
                }
                number += 1;
            }
        }
        (0..order.len()).map(|i| self.chosen[i].map(|_| self.boxes[i])).collect()
    }
}

/// The labels whose boxes may meet.
fn near(reach: &[Rect]) -> Vec<Vec<usize>> {
    let mut near: Vec<Vec<usize>> = reach.iter().map(|_| Vec::with_capacity(NEAR)).collect();
    let mut sorted: Vec<(&Rect, usize)> = reach.iter().zip(0..).collect();
    sorted.sort_unstable_by(|a, b| a.0.min.x.total_cmp(&b.0.min.x));
    for (place, (own, i)) in sorted.iter().enumerate() {
        let own = own.grown(APART);
        for (its, j) in sorted[place + 1..].iter().take_while(|(its, _)| its.min.x < own.max.x) {
            if own.overlaps(its) {
                near[*i].push(*j);
                near[*j].push(*i);
            }
        }
    }
    near
}

/// Where a label is in any of the frames from a place.
fn swept(way: &Rect, place: &Rect) -> Rect {
    Rect { min: place.min + way.min, max: place.max + way.max }
}

/// The box of all that a label moves by, with nothing.
fn way_of(later: &[Later], label: usize) -> Rect {
    let mut way = Rect::around(Vec2::zero(), Vec2::zero());
    later.iter().for_each(|l| way.add(l.shifts[label]));
    way
}
