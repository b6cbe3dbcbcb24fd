//! Which label has which place: the cheapest free one first, then moves to something cheaper, alone or with one neighbour.

use crate::geometry::Rect;
use crate::grid::Grid;
use crate::label::Label;
use crate::placement::{APART, Candidate, Later};

/// The part of the later frames in which two labels may overlap.
const PASSING: f64 = 0.1;

/// Who sits where.
pub(crate) struct Board<'a> {
    candidates: &'a [Vec<Candidate>],
    later: &'a [Later],
    chosen: Vec<Option<usize>>,
    /// The places that labels have, or had.
    boxes: Vec<Rect>,
    /// Labels by the cells of the places that they have.
    taken: Grid<usize>,
    ranks: Vec<u8>,
    /// Where anything must change before a label that found nothing cheaper finds it.
    regions: Vec<Rect>,
    /// The boxes that labels have left or taken, in order.
    changes: Vec<Rect>,
    /// How many changes there were when a label last found nothing cheaper.
    looked: Vec<Option<usize>>,
}

/// What it costs to have no place inside, mm.
const OUTSIDE: f64 = 60.0;

impl<'a> Board<'a> {
    pub fn new(
        labels: &[Label],
        candidates: &'a [Vec<Candidate>],
        later: &'a [Later],
        around: &Rect,
    ) -> Self {
        let taken = Grid::knowing((0..labels.len()).collect(), around);
        let ranks = labels.iter().map(|l| l.rank).collect();
        let (chosen, boxes) = (vec![None; candidates.len()], vec![Rect::NOTHING; candidates.len()]);
        let (regions, looked) = (regions(candidates), vec![None; candidates.len()]);
        Self { candidates, later, chosen, boxes, taken, ranks, regions, changes: Vec::new(), looked }
    }

    fn cost(&self, label: usize) -> f64 {
        match self.chosen[label] {
            Some(number) => self.candidates[label][number].cost,
            None => OUTSIDE - f64::from(self.ranks[label]),
        }
    }

    /// Moves a label to another place, or to none.
    fn choose(&mut self, label: usize, number: Option<usize>) {
        let all = &self.candidates[label];
        if let Some(old) = self.chosen[label] {
            self.taken.put(label, &all[old].bounds, false);
        }
        if let Some(new) = number {
            self.taken.put(label, &all[new].bounds, true);
            self.boxes[label] = all[new].bounds;
        }
        self.chosen[label] = number;
    }

    /// The first labels whose boxes overlap a place: one of them where no more are wanted, else two.
    fn in_the_way(&self, label: usize, bounds: &Rect, both: bool) -> [Option<usize>; 2] {
        let wanted = bounds.grown(APART);
        let mut found = [None; 2];
        self.taken.any(&wanted, |&other| {
            if other == label || found[0] == Some(other) || !self.boxes[other].overlaps(&wanted) {
                return false;
            }
            found[usize::from(found[0].is_some())] = Some(other);
            !both || found[1].is_some()
        });
        if !self.later.is_empty() && found[usize::from(both)].is_none() {
            self.in_the_way_later(label, bounds, &mut found);
        }
        found
    }

    /// Adds those that overlap it in too many of the later frames.
    fn in_the_way_later(&self, label: usize, bounds: &Rect, found: &mut [Option<usize>; 2]) {
        for other in (0..self.chosen.len()).filter(|o| *o != label && self.chosen[*o].is_some()) {
            let on = |l: &&Later| {
                self.boxes[other].shifted(l.shifts[other]).overlaps(&bounds.shifted(l.shifts[label]))
            };
            let passes = || self.later.iter().filter(on).count() as f64 <= PASSING * self.later.len() as f64;
            if found.contains(&Some(other)) || passes() {
                continue;
            }
            found[usize::from(found[0].is_some())] = Some(other);
            if found[1].is_some() {
                return;
            }
        }
    }

    pub fn take_cheapest(&mut self, label: usize) {
        let number = self.cheapest(label, f64::INFINITY);
        self.choose(label, number);
    }

    /// The cheapest place that is free and costs less.
    fn cheapest(&self, label: usize, below: f64) -> Option<usize> {
        let all = &self.candidates[label];
        (0..all.len())
            .take_while(|number| all[*number].cost < below)
            .find(|number| self.in_the_way(label, &all[*number].bounds, false)[0].is_none())
    }

    /// Moves a label to a cheaper place, where needed by moving one neighbour; whether anything changed.
    pub fn improve(&mut self, label: usize) -> bool {
        let region = self.regions[label];
        // labels that are apart now may meet in later frames
        if self.later.is_empty()
            && let Some(looked) = self.looked[label]
            && !self.changes[looked..].iter().any(|change| change.overlaps(&region))
        {
            return false;
        }
        let before = self.chosen[label].map(|_| self.boxes[label]);
        let changed = self.search(label);
        if changed {
            self.changes.extend(before);
            self.changes.extend(self.chosen[label].map(|_| self.boxes[label]));
        }
        self.looked[label] = (!changed).then_some(self.changes.len());
        changed
    }

    fn search(&mut self, label: usize) -> bool {
        let own = self.cost(label);
        let free = self.cheapest(label, own - 1e-9);
        let reached = free.map_or(own, |number| self.candidates[label][number].cost);
        for number in 0..self.candidates[label].len() {
            let candidate = self.candidates[label][number];
            if candidate.cost >= reached - 1e-9 {
                break;
            }
            let [Some(neighbour), None] = self.in_the_way(label, &candidate.bounds, true) else { continue };
            let before = self.cost(neighbour);
            let (old, old_neighbour) = (self.chosen[label], self.chosen[neighbour]);
            self.choose(neighbour, None);
            self.choose(label, Some(number));
            let most = reached - candidate.cost + before;
            if let Some(moved) = self.cheapest(neighbour, most - 1e-9) {
                self.changes.extend(old_neighbour.map(|old| self.candidates[neighbour][old].bounds));
                self.choose(neighbour, Some(moved));
                self.changes.push(self.boxes[neighbour]);
                return true;
            }
            self.choose(label, old);
            self.choose(neighbour, old_neighbour);
        }
        if free.is_some() {
            self.choose(label, free);
        }
        free.is_some()
    }

    /// The places of all labels; better in the way later than outside.
    pub fn end(mut self, order: &[usize]) -> Vec<Option<Rect>> {
        self.later = &[];
        for &label in order {
            if self.chosen[label].is_none() {
                self.take_cheapest(label);
            }
        }
        self.chosen.iter().zip(self.candidates).map(|(chosen, all)| chosen.map(|c| all[c].bounds)).collect()
    }
}

/// For each label the box of the places that it, or a label in its way, may take.
fn regions(candidates: &[Vec<Candidate>]) -> Vec<Rect> {
    let reach = |all: &Vec<Candidate>| {
        let mut reach = Rect::NOTHING;
        all.iter().for_each(|candidate| reach.join(&candidate.bounds.grown(APART)));
        reach
    };
    let reaches: Vec<Rect> = candidates.iter().map(reach).collect();
    let region = |own: &Rect| {
        let mut region = *own;
        reaches.iter().filter(|other| other.overlaps(own)).for_each(|other| region.join(other));
        region
    };
    reaches.iter().map(region).collect()
}
