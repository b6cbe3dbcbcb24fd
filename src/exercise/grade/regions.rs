//! Which intervals of the number line mean what, for one quantity of one row.

use super::common_mistake::{CommonMistake, factors};
use super::marker::Marker;
use super::rules::Rules;
use super::sheet::Sheet;
use crate::exercise::expect::is_within;
use crate::exercise::turns::{self, difference};
use assur_text::units::Dimension;
use std::f64::consts::{PI, TAU};

/// The tolerance of a smaller angle is that of this one, rad.
const LEAST_ANGLE: f64 = 1e-3;
/// An answer this many tolerances away is close.
const NEAR: f64 = 3.0;
/// Centres nearer than this part of them are one.
const SAME: f64 = 1e-12;
/// A piece narrower than this part of its middle holds no number that anybody writes.
const NARROW: f64 = 1e-5;
/// What writing an end with six digits may move it by.
const MOVED: f64 = 1e-6;

/// An interval with its ends, SI, and what an answer in it means.
#[derive(Clone, Debug, PartialEq)]
pub struct Region {
    pub middle: f64,
    /// Half its width.
    pub half: f64,
    /// It is there again after every turn.
    pub turns: bool,
    /// What was done wrong; nothing where the answer is right.
    pub slip: Option<CommonMistake>,
}

impl Region {
    const fn new(middle: f64, half: f64, turns: bool, slip: CommonMistake) -> Self {
        Self { middle, half, turns, slip: Some(slip) }
    }

    fn between(from: f64, to: f64, turns: bool, slip: CommonMistake) -> Self {
        Self::new(f64::midpoint(from, to), (to - from) / 2.0, turns, slip)
    }

    /// Whether a number is in it.
    #[must_use]
    pub fn contains(&self, x: f64) -> bool {
        is_within(difference(self.turns, x, self.middle).abs(), self.half)
    }
}

/// What answers mean for a quantity in a row of a key: the first region that contains an answer counts. None where the key has no
/// number there. The values of other rows are not among them.
#[must_use]
pub fn regions(key: &Sheet, row: usize, quantity: usize, rules: &Rules) -> Vec<Region> {
    let marker = Marker { key, index: row, rules };
    marker.number(quantity).map_or_else(Vec::new, |key| marker.regions(quantity, key).collect())
}

/// Regions of one kind, for a place with its key.
type Kind<'k> = fn(&Marker<'k>, usize, f64) -> Vec<Region>;

impl<'k> Marker<'k> {
    /// Slips in the order in which they are looked for.
    const ORDER: [Kind<'k>; 6] = [
        Self::of_angle,
        Self::of_sign,
        Self::of_factors,
        Self::of_vector,
        Self::of_other_quantities,
        Self::of_close,
    ];

    /// What answers mean: right first, then slips.
    pub(super) fn regions(&self, place: usize, key: f64) -> impl Iterator<Item = Region> {
        let half = self.rules.within * self.scale(place, key);
        let right = Region { middle: key, half, turns: self.turns(place, key), slip: None };
        std::iter::once(right).chain(Self::ORDER.into_iter().flat_map(move |kind| kind(self, place, key)))
    }

    /// Whether whole turns make no difference to a quantity.
    pub(super) fn turns(&self, place: usize, key: f64) -> bool {
        let unit = &self.key.quantities[place].unit;
        let is_free = unit.dimension == Dimension::ANGLE && turns::are_free(key, unit.factor);
        is_free && !self.key.counts_turns(&self.key.rows[self.index], place)
    }

    /// Of an angle the opposite sign, the opposite direction and the supplement, each as far as it is the nearest.
    fn of_angle(&self, place: usize, key: f64) -> Vec<Region> {
        if !self.turns(place, key) {
            return Vec::new();
        }
        let meant = [
            (-key, CommonMistake::Sign),
            (key + PI, CommonMistake::Opposite),
            (PI - key, CommonMistake::Supplement),
        ];
        let cut = |i: usize| {
            let (angle, slip) = &meant[i];
            let is_same = |other: &f64| difference(true, *other, *angle).abs() <= LEAST_ANGLE * SAME;
            if meant[..i].iter().any(|(other, _)| is_same(other)) {
                return None;
            }
            let half = self.rules.within * difference(true, *angle, 0.0).abs().max(LEAST_ANGLE);
            let (mut below, mut above) = (half, half);
            for other in meant.iter().map(|(other, _)| other).filter(|other| !is_same(other)) {
                let ahead = (other - angle).rem_euclid(TAU);
                above = above.min(ahead / 2.0);
                below = below.min((TAU - ahead) / 2.0);
            }
            Some(Region::between(angle - below, angle + above, true, slip.clone()))
        };
        (0..meant.len()).filter_map(cut).collect()
    }

    fn of_sign(&self, place: usize, key: f64) -> Vec<Region> {
        if self.is_zero(place, key) {
            return Vec::new();
        }
        let slip = self.other_link(place).unwrap_or(CommonMistake::Sign);
        // a component is small beside its vector: what it would be right for is measured by itself
        vec![Region::new(-key, self.rules.within * key.abs(), self.turns(place, key), slip)]
    }

    /// Factors with a name, the sign aside, each as far as it is the nearest: between f₁ and f₂ up to 2k/(1/f₁ + 1/f₂) of the key k.
    fn of_factors(&self, place: usize, key: f64) -> Vec<Region> {
        if self.is_zero(place, key) {
            return Vec::new();
        }
        // whole turns are taken off the key alone: a thousandfold angle would come near anything
        let in_turn = difference(self.turns(place, key), key, 0.0);
        let keys = [Some(key), Some(in_turn).filter(|it| *it != key && *it != 0.0)];
        let of = self.dimension(place);
        let each = keys.into_iter().flatten();
        let each = each.flat_map(|key| factors(of).map(move |(f, slip)| (f * key, slip)));
        let mut centres: Vec<(f64, CommonMistake)> = each.collect();
        centres.sort_by(|one, two| one.0.total_cmp(&two.0));
        centres.dedup_by(|next, one| (next.0 - one.0).abs() <= SAME * one.0.abs());
        let border = |i: usize, other: Option<usize>, own: f64| {
            let centre = centres[i].0;
            let other = other.and_then(|i| Some(centres.get(i)?.0)).filter(|it| it * centre > 0.0);
            let border = other.map_or(own, |other| 2.0 / (1.0 / centre + 1.0 / other));
            if (border - centre).abs() < (own - centre).abs() { border } else { own }
        };
        let cut = |(i, (centre, slip)): (usize, &(f64, CommonMistake))| {
            let half = self.rules.within * centre.abs();
            let from = border(i, i.checked_sub(1), centre - half);
            let to = border(i, Some(i + 1), centre + half);
            Region::between(from, to, false, slip.clone())
        };
        centres.iter().enumerate().map(cut).collect()
    }

    fn of_vector(&self, place: usize, key: f64) -> Vec<Region> {
        let Some((partner, other)) = self.partner(place).and_then(|i| Some((i, self.number(i)?))) else {
            return Vec::new();
        };
        let of = |at: usize, value: f64, slip| {
            Region::new(value, self.rules.within * self.scale(at, value), self.turns(place, value), slip)
        };
        let size = libm::hypot(key, other);
        vec![of(partner, other, CommonMistake::Swapped), of(place, size, CommonMistake::Magnitude)]
    }

    /// The values of other quantities of the row, then each with the other sign.
    fn of_other_quantities(&self, place: usize, _: f64) -> Vec<Region> {
        let quantities = &self.key.quantities;
        let others =
            (0..quantities.len()).filter(|i| *i != place && self.dimension(*i) == self.dimension(place));
        let others: Vec<(usize, f64)> = others.filter_map(|i| Some((i, self.number(i)?))).collect();
        let of = |(factor, sign): (f64, bool), (i, value): &(usize, f64)| {
            let slip = CommonMistake::OtherQuantity { name: quantities[*i].name.clone(), sign };
            Region::new(factor * value, self.rules.within * value.abs(), false, slip)
        };
        let with = |sign| others.iter().filter(|(_, value)| *value != 0.0).map(move |other| of(sign, other));
        with((1.0, false)).chain(with((-1.0, true))).collect()
    }

    fn of_close(&self, place: usize, key: f64) -> Vec<Region> {
        let half = NEAR * self.rules.within * self.scale(place, key);
        vec![Region::new(key, half, self.turns(place, key), CommonMistake::Close)]
    }

    fn other_link(&self, place: usize) -> Option<CommonMistake> {
        let name = &self.key.quantities[place].name;
        name.starts_with("reaction(").then_some(CommonMistake::OtherLink)
    }
}

/// A piece of a region that has no number in common with the pieces of others.
#[derive(Clone, Copy, Debug)]
pub struct Piece<'r> {
    pub middle: f64,
    pub half: f64,
    pub slip: Option<&'r CommonMistake>,
}

/// Regions cut against those before them, so that any of them can be left out and no answer gets another name. Those that come again
/// after every turn are there three times, the right answer about its own digits and slips about zero.
#[must_use]
pub fn pieces(regions: &[Region]) -> Vec<Piece<'_>> {
    let plain = regions.iter().filter(|region| !region.turns);
    let reach = plain.map(|region| region.middle.abs() + region.half).fold(2.0 * TAU, f64::max);
    let mut taken: Vec<[f64; 2]> = Vec::new();
    let mut found = Vec::new();
    for region in regions {
        let first = taken.len();
        for middle in again(region, reach) {
            let ends = [middle - region.half, middle + region.half];
            let slip = region.slip.as_ref();
            let written = !region.turns
                || if slip.is_none() {
                    (middle - region.middle).abs() < 1.5 * TAU
                } else {
                    middle.abs() <= 1.5 * TAU
                };
            if written && slip.is_none() {
                found.push(Piece { middle, half: region.half, slip });
            } else if written {
                found.extend(left(ends, &taken[..first]).map(|[from, to]| Piece {
                    middle: f64::midpoint(from, to),
                    half: (to - from) / 2.0,
                    slip,
                }));
            }
            taken.push(ends);
        }
    }
    found
}

/// The middles of a region, after every turn where it comes again; too many turns are none.
fn again(region: &Region, reach: f64) -> Vec<f64> {
    const MOST: f64 = 2000.0;
    if !region.turns {
        return vec![region.middle];
    }
    let turns = (reach / TAU).min(MOST).ceil() as i32;
    let base = difference(true, region.middle, 0.0);
    let mut all: Vec<f64> = (-turns..=turns).map(|n| base + f64::from(n) * TAU).collect();
    if region.slip.is_none() {
        // its own digits, first
        all.retain(|x| (x - region.middle).abs() > 1.0);
        all.insert(0, region.middle);
    }
    all
}

/// What is left of an interval without others: a little less, since what is written with some digits moves by a part of its greatest.
fn left(ends: [f64; 2], taken: &[[f64; 2]]) -> impl Iterator<Item = [f64; 2]> + use<> {
    let shy = MOVED * ends[0].abs().max(ends[1].abs());
    let mut parts = vec![ends];
    for [from, to] in taken.iter().filter(|t| t[0] <= ends[1] && ends[0] <= t[1]) {
        let without = |[a, b]: [f64; 2]| {
            [[a, b.min(from - shy)], [a.max(to + shy), b]].into_iter().filter(|[a, b]| a < b)
        };
        parts = parts.into_iter().flat_map(without).collect();
    }
    parts.into_iter().filter(|[a, b]| b - a > NARROW * a.abs().max(b.abs()))
}
