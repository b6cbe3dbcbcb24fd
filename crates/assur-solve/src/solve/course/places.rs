//! Numbers at places of a way, each computed once; where they have no bound, and what range a picture of them shows.

use std::collections::HashMap;

/// Intervals of the first look, per turn where there are several, and the most of them.
const INTERVALS: f64 = 128.0;
pub(super) const MOST: f64 = 2048.0;
/// How near to a known break a piece comes, as a part of the way.
const BESIDE: f64 = 1e-9;
/// The least distance from a place at which a number is evaluated, or the next where it has no value; then `NEARER` and `NEARER`² times
/// as far. It has no bound if it changes over the first step by more than `GROWS` times what it changes over the second: a logarithm
/// changes as much, a pole more, a root 0.03 times as much.
const DISTANCES: [f64; 3] = [1e-9, 1e-8, 1e-7];
const NEARER: f64 = 1e3;
const GROWS: f64 = 0.7;
/// And only if this change, relative to the number, is more than this many times the distance: less is a steep slope.
const STEEP: f64 = 1e5;
/// A height of `FAR` spreads is a pole, or of `HIGHER` times the height seen first; `HIGHER_OF_BOTH` where the signs differ.
const FAR: f64 = 1e7;
const HIGHER: f64 = 1e5;
const HIGHER_OF_BOTH: f64 = 1e4;
/// A peak lower than this part of the spread is none.
const LOW: f64 = 0.05;
/// Poles nearer to one another, as a part of the way, are one.
const ONE: f64 = 2e-5;
/// Steps of the golden section and of halving, and after how many a height must have grown how often.
const GOLDEN: usize = 45;
const GOLDEN_GIVES_UP: (usize, f64) = (10, 5.0);
const HALVINGS: usize = 60;
const HALVINGS_GIVE_UP: (usize, f64) = (6, 4.0);
/// Share of the golden section.
const SHARE: f64 = 0.618_033_988_749_894_9;

/// A place where a number has no bound.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pole {
    /// It lies between these two.
    pub from: f64,
    pub to: f64,
    /// The sign of the number on either side; 0 where the way ends.
    pub signs: [f64; 2],
}

/// What a picture of one of the numbers shows.
#[derive(Clone, Debug, Default)]
pub(crate) struct Look {
    /// From the least to the greatest; where it has poles what is worth seeing beside them.
    pub window: (f64, f64),
    pub poles: Vec<Pole>,
}

/// Numbers at places of a way.
pub(crate) struct Places<'p> {
    /// Puts the numbers at a place.
    path: &'p mut dyn FnMut(f64, &mut Vec<f64>),
    /// Where the way begins and ends.
    pub range: (f64, f64),
    /// What is no greater is rounding.
    rounding: f64,
    known: HashMap<u64, usize>,
    numbers: Vec<f64>,
}

impl<'p> Places<'p> {
    pub fn new(range: (f64, f64), rounding: f64, path: &'p mut dyn FnMut(f64, &mut Vec<f64>)) -> Self {
        Self { path, range, rounding, known: HashMap::new(), numbers: Vec::new() }
    }

    /// One of the numbers at a place; not a number where it has no value.
    pub fn at(&mut self, s: f64, which: usize) -> f64 {
        let first = match self.known.get(&s.to_bits()) {
            Some(first) => *first,
            None => {
                let first = self.numbers.len();
                (self.path)(s, &mut self.numbers);
                self.known.insert(s.to_bits(), first);
                first
            }
        };
        self.numbers[first + which]
    }

    /// How many places have been looked at.
    pub fn count(&self) -> usize {
        self.known.len()
    }

    fn length(&self) -> f64 {
        self.range.1 - self.range.0
    }

    /// The sign with which a number grows without bound towards a place, from one side.
    pub fn grows(&mut self, s: f64, inward: f64, which: usize) -> Option<f64> {
        let step = inward * self.length();
        let mut near = DISTANCES.into_iter().map(|d| (d, self.at(s + step * d, which)));
        let (distance, near) = near.find(|found| !found.1.is_nan())?;
        let [far, farther] =
            [NEARER, NEARER * NEARER].map(|times| self.at(s + step * distance * times, which));
        let [changes, before] = [near - far, far - farther].map(f64::abs);
        let lasts = before.is_nan() || changes > GROWS * before;
        let grows = lasts && changes > STEEP * distance * far.abs();
        (grows || near.is_infinite()).then(|| if near.is_infinite() { near } else { near - far }.signum())
    }

    /// The pole at a place, if it is one.
    pub fn pole(&mut self, s: f64, which: usize) -> Option<Pole> {
        let (first, last) = self.range;
        let before = if s > first { self.grows(s, -1.0, which) } else { None };
        let after = if s < last { self.grows(s, 1.0, which) } else { None };
        let beside = BESIDE * self.length();
        (before.is_some() || after.is_some()).then(|| Pole {
            from: (s - beside).max(first),
            to: (s + beside).min(last),
            signs: [before, after].map(|sign| sign.unwrap_or(0.0)),
        })
    }

    /// Even places between the breaks and beside them, stretch by stretch.
    pub(super) fn grid(&self, breaks: &[f64], turns: f64) -> Vec<Vec<f64>> {
        let (first, last) = self.range;
        let beside = BESIDE * self.length();
        let all = (INTERVALS * (0.5 * turns).max(1.0)).min(MOST);
        let inside = breaks.iter().copied().filter(|s| *s > first + 2.0 * beside && *s < last - 2.0 * beside);
        let ends: Vec<f64> = std::iter::once(first).chain(inside).chain([last]).collect();
        let stretch = |pair: &[f64]| {
            let from = if pair[0] > first { pair[0] + beside } else { first };
            let to = if pair[1] < last { pair[1] - beside } else { last };
            let count = (all * (to - from) / self.length()).round().max(4.0);
            let mut places = vec![from];
            let mut i = 1.0;
            while i < count {
                places.push(from + (to - from) * i / count);
                i += 1.0;
            }
            places.push(to);
            places
        };
        ends.windows(2).map(stretch).collect()
    }

    /// Where one of the numbers has poles, and what is shown of it; `None` where it has no value at all.
    pub(super) fn look(&mut self, grid: &[Vec<f64>], breaks: &[f64], which: usize) -> Option<Look> {
        let mut all: Vec<f64> = grid.iter().flatten().map(|s| self.at(*s, which)).collect();
        all.retain(|y| y.is_finite());
        all.sort_by(f64::total_cmp);
        let of = Spread::of(&all, self.rounding)?;
        let (first, last) = self.range;
        let known = breaks.iter().copied().chain([first, last]);
        let mut poles: Vec<Pole> = known.filter_map(|s| self.pole(s, which)).collect();
        for stretch in grid {
            let heights: Vec<f64> = stretch.iter().map(|s| self.at(*s, which) - of.middle).collect();
            for i in 1..stretch.len() - 1 {
                poles.extend(self.peak([i - 1, i, i + 1].map(|i| stretch[i]), which, &of));
            }
            for i in 0..stretch.len() - 1 {
                let (a, b) = (heights[i], heights[i + 1]);
                let rises = i > 0
                    && i + 2 < stretch.len()
                    && a.abs() > heights[i - 1].abs()
                    && b.abs() > heights[i + 2].abs();
                if a * b < 0.0 && (rises || a.abs().min(b.abs()) > of.spread) {
                    poles.extend(self.between((stretch[i], stretch[i + 1]), which, &of));
                }
            }
        }
        let poles = self.merged(poles);
        Some(Look { window: of.window(&all, &poles), poles })
    }

    /// What several searches found of one pole is one, with the sign before the first and that behind the last.
    fn merged(&self, mut poles: Vec<Pole>) -> Vec<Pole> {
        let one = ONE * self.length();
        poles.sort_by(|a, b| a.from.total_cmp(&b.from));
        let mut all: Vec<Pole> = Vec::new();
        for pole in poles {
            match all.last_mut() {
                Some(before) if pole.from - before.to < one => {
                    if pole.to >= before.to {
                        (before.to, before.signs[1]) = (pole.to, pole.signs[1]);
                    }
                }
                _ => all.push(pole),
            }
        }
        all
    }

    /// The pole at a place that lies higher than both its neighbours.
    fn peak(&mut self, [from, middle, to]: [f64; 3], which: usize, of: &Spread) -> Option<Pole> {
        let mut height = |s: f64| self.at(s, which) - of.middle;
        let [before, here, after] = [from, middle, to].map(&mut height);
        if !before.is_finite() || !after.is_finite() || here.is_nan() {
            return None;
        }
        let up = here.signum();
        if here.abs() < LOW * of.spread || up * here < (up * before).max(up * after) {
            return None;
        }
        let mut least = |s: f64| {
            let y = -up * height(s);
            if y.is_nan() { f64::INFINITY } else { y }
        };
        let (mut a, mut b) = (from, to);
        let (mut c, mut d) = (b - SHARE * (b - a), a + SHARE * (b - a));
        let (mut at_c, mut at_d) = (least(c), least(d));
        for step in 0..GOLDEN {
            let highest = -at_c.min(at_d);
            if step == GOLDEN_GIVES_UP.0 && highest < GOLDEN_GIVES_UP.1 * here.abs() {
                return None;
            }
            if highest > FAR * of.spread {
                break;
            }
            if at_c < at_d {
                (b, d, at_d) = (d, c, at_c);
                c = b - SHARE * (b - a);
                at_c = least(c);
            } else {
                (a, c, at_c) = (c, d, at_d);
                d = a + SHARE * (b - a);
                at_d = least(d);
            }
        }
        if -at_c.min(at_d) <= HIGHER * here.abs().max(LOW * of.spread) {
            return None;
        }
        let beside = BESIDE * self.length();
        let (from, to) = ((a - beside).max(from), (b + beside).min(to));
        Some(Pole { from, to, signs: [from, to].map(|s| (self.at(s, which) - of.middle).signum()) })
    }

    /// The pole between two places where a number lies far on either side of its middle.
    pub(super) fn between(
        &mut self,
        (mut from, mut to): (f64, f64),
        which: usize,
        of: &Spread,
    ) -> Option<Pole> {
        let [mut before, mut after] = [from, to].map(|s| self.at(s, which) - of.middle);
        let first = before.abs().min(after.abs());
        let signs = [before.signum(), after.signum()];
        for step in 0..HALVINGS {
            let middle = 0.5 * (from + to);
            let lower = before.abs().min(after.abs());
            let gives_up = step == HALVINGS_GIVE_UP.0 && lower < HALVINGS_GIVE_UP.1 * first;
            if middle == from || middle == to || gives_up || lower > FAR * of.spread {
                break;
            }
            let here = self.at(middle, which) - of.middle;
            if !here.is_finite() {
                let beside = f64::EPSILON * self.length();
                (from, to) = (middle - beside, middle + beside);
                break;
            }
            if here * signs[0] > 0.0 { (from, before) = (middle, here) } else { (to, after) = (middle, here) }
        }
        let higher = before.abs().min(after.abs()) > HIGHER_OF_BOTH * first.max(of.spread);
        (higher || to - from < 4.0 * f64::EPSILON * self.length()).then_some(Pole { from, to, signs })
    }
}

/// Where the numbers mostly lie.
pub(super) struct Spread {
    pub middle: f64,
    pub spread: f64,
    tenths: (f64, f64),
}

impl Spread {
    /// Of numbers in order; what is no greater than that is rounding.
    #[allow(clippy::cast_precision_loss, clippy::cast_possible_truncation, clippy::cast_sign_loss)] // some thousands
    pub fn of(sorted: &[f64], rounding: f64) -> Option<Self> {
        let (first, last) = (*sorted.first()?, *sorted.last()?);
        let at = |share: f64| sorted[((share * sorted.len() as f64) as usize).min(sorted.len() - 1)];
        let (middle, tenths) = (at(0.5), (at(0.1), at(0.9)));
        let rounding = (f64::EPSILON * first.abs().max(last.abs())).max(rounding).max(f64::MIN_POSITIVE);
        Some(Self { middle, spread: (tenths.1 - tenths.0).max(rounding), tenths })
    }

    /// What is shown of these numbers beside poles.
    fn window(&self, sorted: &[f64], poles: &[Pole]) -> (f64, f64) {
        let (mut low, mut high) = (sorted[0], sorted[sorted.len() - 1]);
        let (least, greatest) = self.tenths;
        let wide = (greatest - least).max(0.05 * least.abs().max(greatest.abs()));
        let goes = |sign: f64| poles.iter().any(|pole| pole.signs.contains(&sign));
        if goes(1.0) {
            high = high.min(greatest + 0.5 * wide);
        }
        if goes(-1.0) {
            low = low.max(least - 0.5 * wide);
        }
        (low, high)
    }
}
