//! Places between which the lines of a picture follow numbers: in millimetres of paper, whatever the numbers are.

use super::places::{Look, Places, Pole, Spread};

/// A panel of a plot, mm.
const WIDTH: f64 = 150.0;
const HEIGHT: f64 = 75.0;
/// What a line may leave its curve by, mm, and a long one.
const OFF: f64 = 0.04;
const OFF_LONG: f64 = 0.02;
/// From this length on a line is long; it is no wider than this, mm.
const LONG: f64 = 6.0;
const WIDEST: f64 = 2.5;
/// Where long lines have places within they must lie as their share says, mm.
const UNEVEN: f64 = 0.5;
/// Narrower is one place, mm; a rise of this is a jump there.
const THIN: f64 = 0.01;
const JUMP: f64 = 0.2;
/// Where a line is looked at between its ends.
const WITHIN: [f64; 2] = [0.41, 0.73];
/// Beyond the window the reciprocal is to be right within this part of it, as long as the line is wider than this, mm.
const BEYOND: f64 = 1e-3;
const NARROW: f64 = 0.3;
/// How far beyond the window a number is beyond it, as a part of the window.
const OUTSIDE: f64 = 0.02;
/// Looks at more places end a refinement: of what is noise.
const MOST: usize = 12_000;

/// What was found of several numbers together.
pub(crate) struct Refined {
    /// Places that are joined, piece by piece.
    pub pieces: Vec<Vec<f64>>,
    /// What is shown of each number.
    pub looks: Vec<Look>,
}

/// Places at which lines follow all of `count` numbers; breaks are known places where they may jump or grow without bound.
pub(crate) fn refined(places: &mut Places<'_>, count: usize, breaks: &[f64], turns: f64) -> Option<Refined> {
    let grid = places.grid(breaks, turns);
    let looks = (0..count).map(|which| places.look(&grid, breaks, which)).collect::<Option<Vec<Look>>>()?;
    let mut poles: Vec<Pole> = looks.iter().flat_map(|look| look.poles.iter().copied()).collect();
    poles.sort_by(|a, b| a.from.total_cmp(&b.from));
    let mut refiner = Refiner { places, looks, pieces: Vec::new(), line: Vec::new() };
    let mut before = f64::NEG_INFINITY;
    for stretch in &grid {
        let mut start = stretch[0];
        if poles.iter().any(|pole| (before..=start).contains(&(0.5 * (pole.from + pole.to)))) {
            refiner.end();
        }
        before = stretch[stretch.len() - 1];
        refiner.line.push(start);
        for end in &stretch[1..] {
            // a line ends before a pole and begins anew behind it
            for pole in &poles {
                if start <= pole.to && pole.from < *end && pole.to > start {
                    if pole.from > start {
                        refiner.fill(start, pole.from);
                    }
                    refiner.end();
                    start = pole.to;
                    refiner.line.push(start);
                }
            }
            if start < *end {
                refiner.fill(start, *end);
                start = *end;
            }
        }
    }
    refiner.end();
    let Refiner { pieces, looks, .. } = refiner;
    Some(Refined { pieces, looks })
}

struct Refiner<'r, 'p> {
    places: &'r mut Places<'p>,
    looks: Vec<Look>,
    pieces: Vec<Vec<f64>>,
    line: Vec<f64>,
}

/// How a stretch between two places looks.
#[derive(Clone, Copy, PartialEq)]
enum Stretch {
    Line,
    /// It is to be halved.
    Bent,
    /// There is no value at any of its places.
    Nothing,
}

impl Refiner<'_, '_> {
    /// Ends a piece.
    fn end(&mut self) {
        let mut line = std::mem::take(&mut self.line);
        line.retain(|s| self.has_value(*s));
        if line.len() > 1 {
            self.pieces.push(line);
        }
    }

    /// Goes on from one place to another.
    fn fill(&mut self, from: f64, to: f64) {
        let mut waiting = vec![(from, to)];
        while let Some((from, to)) = waiting.pop() {
            if self.wide(from, to) < THIN {
                self.thin(from, to);
                continue;
            }
            match self.stretch(from, to) {
                Stretch::Line => self.line.push(to),
                Stretch::Nothing => self.end(),
                Stretch::Bent if self.places.count() > MOST => self.line.push(to),
                Stretch::Bent => {
                    let middle = 0.5 * (from + to);
                    waiting.extend([(middle, to), (from, middle)]);
                }
            }
        }
    }

    /// Millimetres along the axis.
    fn wide(&self, from: f64, to: f64) -> f64 {
        WIDTH * (to - from) / (self.places.range.1 - self.places.range.0)
    }

    /// The height of a number on paper, mm, held within a panel's height beyond the window.
    fn high(&self, y: f64, which: usize) -> f64 {
        let (low, high) = self.looks[which].window;
        let wide = self.span(which);
        HEIGHT * (y.clamp(low - wide, high + wide) - low) / wide
    }

    /// How much is shown of a number; what hardly changes is shown as if it did a little.
    fn span(&self, which: usize) -> f64 {
        let (low, high) = self.looks[which].window;
        let most = low.abs().max(high.abs()).max(f64::MIN_POSITIVE);
        if high - low < 1e-9 * most { 1e-3 * most } else { high - low }
    }

    fn side(&self, y: f64, which: usize) -> f64 {
        let (low, high) = self.looks[which].window;
        let slack = OUTSIDE * self.span(which);
        if y > high + slack {
            1.0
        } else if y < low - slack {
            -1.0
        } else {
            0.0
        }
    }

    fn stretch(&mut self, from: f64, to: f64) -> Stretch {
        let inner = WITHIN.map(|share| from + share * (to - from));
        let mut all = Stretch::Line;
        for which in 0..self.looks.len() {
            let values = [from, inner[0], inner[1], to].map(|s| self.places.at(s, which));
            let undefined = values.iter().filter(|y| !y.is_finite()).count();
            if undefined == values.len() {
                return Stretch::Nothing;
            }
            if undefined > 0 || !self.is_line(values, self.wide(from, to), which) {
                all = Stretch::Bent;
            }
        }
        all
    }

    fn is_line(&self, values: [f64; 4], wide: f64, which: usize) -> bool {
        let sides = values.map(|y| self.side(y, which));
        let [a, b, c, d] = values;
        if sides[0] != 0.0 && sides.iter().all(|side| *side == sides[0]) {
            // beside a pole the reciprocal is nearly straight
            let off = |y: f64, share: f64| (y * (1.0 / a + (1.0 / d - 1.0 / a) * share) - 1.0).abs();
            return wide < NARROW || off(b, WITHIN[0]).max(off(c, WITHIN[1])) < BEYOND;
        }
        let [a, b, c, d] = [a, b, c, d].map(|y| self.high(y, which));
        let above = [(b, WITHIN[0]), (c, WITHIN[1])].map(|(y, share)| (y - (a + share * (d - a))).abs());
        let above = above[0].max(above[1]);
        let long = wide.hypot(d - a);
        // numbers that are drawn over one another have no slope of their own
        let off = if self.looks.len() > 1 { above } else { above * wide / long };
        wide < WIDEST && if long < LONG { off < OFF } else { off < OFF_LONG && above < UNEVEN }
    }

    /// A stretch that is one place on paper: steep, a jump, an end of what has a value, or a pole that was not seen before.
    fn thin(&mut self, mut from: f64, mut to: f64) {
        let count = self.looks.len();
        match [from, to].map(|s| self.has_value(s)) {
            [true, true] => {}
            [true, false] => {
                let last = self.last_value(from, to);
                self.line.push(last);
                return self.end();
            }
            [false, after] => {
                self.end();
                if after {
                    let first = self.last_value(to, from);
                    self.line.extend([first, to]);
                }
                return;
            }
        }
        for which in 0..count {
            let [before, after] = [from, to].map(|s| self.places.at(s, which));
            if self.side(before, which) * self.side(after, which) < 0.0
                && let Some(pole) = self.late((from, to), which)
            {
                self.looks[which].poles.push(pole);
                self.end();
                self.line.push(to);
                return;
            }
            if (self.high(before, which) - self.high(after, which)).abs() > JUMP {
                (from, to) = self.jump((from, to), which);
                self.line.extend([from, to]);
            }
        }
        if self.line.last().is_none_or(|last| *last < to) {
            self.line.push(to);
        }
    }

    fn has_value(&mut self, s: f64) -> bool {
        (0..self.looks.len()).all(|which| self.places.at(s, which).is_finite())
    }

    /// How far there are values from a place towards one that has none.
    fn last_value(&mut self, mut known: f64, mut open: f64) -> f64 {
        loop {
            let middle = 0.5 * (known + open);
            if middle == known || middle == open {
                return known;
            }
            if self.has_value(middle) { known = middle } else { open = middle }
        }
    }

    fn late(&mut self, stretch: (f64, f64), which: usize) -> Option<Pole> {
        let (low, high) = self.looks[which].window;
        let of = Spread::of(&[low, 0.5 * (low + high), high], 0.0)?;
        self.places.between(stretch, which, &of)
    }

    /// Both sides of a jump, or of the steepest part.
    fn jump(&mut self, (mut from, mut to): (f64, f64), which: usize) -> (f64, f64) {
        let least = 0.5 * self.span(which) * JUMP / HEIGHT;
        let [mut before, mut after] = [from, to].map(|s| self.places.at(s, which));
        while (after - before).abs() > least {
            let middle = 0.5 * (from + to);
            let here = self.places.at(middle, which);
            if middle == from || middle == to || !here.is_finite() {
                break;
            }
            if (here - before).abs() > (after - here).abs() {
                (to, after) = (middle, here);
            } else {
                (from, before) = (middle, here);
            }
        }
        (from, to)
    }
}
