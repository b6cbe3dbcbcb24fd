//! What is drawn, coarsely: small cells that an obstacle reaches and those that it covers. They tell of most places whether they
//! are free, and leave few to a look at the obstacles themselves.

use crate::geometry::{Rect, Segment};
use crate::mark::Obstacle;
use assur_math::math::Vec2;

/// Side of a cell, mm.
const CELL: f64 = 0.5;
/// The most cells along a side.
const MOST: f64 = 2000.0;
/// What is nearer than this to the edge of a cell, in sides, may be on either side of it.
const EDGE: f64 = 1e-6;

/// Cells over a box, a bit for each.
#[derive(Debug)]
pub struct Raster {
    origin: Vec2,
    /// Cells of a millimetre.
    per_mm: f64,
    columns: usize,
    rows: usize,
    /// Cells in which an obstacle may be: 64 columns of all rows, then the next.
    reached: Vec<u64>,
    /// Cells with nothing but an obstacle in them.
    covered: Vec<u64>,
}

/// Some of them: columns and rows from the first to the last.
#[derive(Clone, Copy, Debug)]
pub struct Cells {
    from: usize,
    to: usize,
    top: usize,
    /// The row below the last.
    below: usize,
}

/// A stroke with its ends in the order of y, in cells, and half the side of the square that goes along it.
struct Along {
    a: Vec2,
    b: Vec2,
    slope: f64,
    half: f64,
}

impl Along {
    fn of(a: Vec2, b: Vec2, half: f64) -> Self {
        let (a, b) = if a.y <= b.y { (a, b) } else { (b, a) };
        Self { a, b, slope: if a.y < b.y { (b.x - a.x) / (b.y - a.y) } else { 0.0 }, half }
    }

    /// From where to where it is anywhere between two heights.
    fn between(&self, low: f64, high: f64) -> Option<(f64, f64)> {
        let (low, high) = (self.a.y.max(low - self.half), self.b.y.min(high + self.half));
        if low > high {
            return None;
        }
        let (left, right) = (self.a.x.min(self.b.x), self.a.x.max(self.b.x));
        if self.a.y == self.b.y {
            return Some((left - self.half, right + self.half));
        }
        let at = |y: f64| (self.a.x + (y - self.a.y) * self.slope).clamp(left, right);
        let (p, q) = (at(low), at(high));
        Some((p.min(q) - self.half, p.max(q) + self.half))
    }

    /// From where to where it is at both of two heights.
    fn through(&self, low: f64, high: f64) -> Option<(f64, f64)> {
        let (p, q) = (self.between(low, low)?, self.between(high, high)?);
        Some((p.0.max(q.0), p.1.min(q.1)))
    }
}

impl Raster {
    /// Nothing over a box.
    pub fn over(bounds: &Rect) -> Self {
        let size = bounds.size();
        let per_mm = 1.0 / CELL.max(size.x.max(size.y) / MOST);
        let count = |length: f64| whole(length * per_mm) + 1;
        let (columns, rows) = (count(size.x), count(size.y));
        let none = || vec![0; columns.div_ceil(64) * rows];
        Self { origin: bounds.min, per_mm, columns, rows, reached: none(), covered: none() }
    }

    /// Adds an obstacle with what is kept free around it.
    pub fn add(&mut self, obstacle: &Obstacle, apart: f64) {
        match obstacle {
            Obstacle::Stroke(Segment { a, b }, half) => {
                self.fill(
                    &Along::of(self.place(*a), self.place(*b), (half + apart) * self.per_mm),
                    |_, _| true,
                );
            }
            Obstacle::Disc(centre, radius) => {
                let (at, radius) = (self.place(*centre), (radius + apart) * self.per_mm);
                let inside = |x: f64, y: f64| {
                    let reach = |c: f64, at: f64| (c - at).abs().max((c + 1.0 - at).abs());
                    let (x, y) = (reach(x, at.x), reach(y, at.y));
                    x * x + y * y < (radius - EDGE) * (radius - EDGE)
                };
                self.fill(&Along::of(at, at, radius), inside);
            }
        }
    }

    /// The cells of a box.
    pub fn cells(&self, bounds: &Rect) -> Cells {
        let (low, high) = (self.place(bounds.min), self.place(bounds.max));
        let column = |x: f64| whole(x).min(self.columns - 1);
        let row = |y: f64| whole(y).min(self.rows - 1);
        Cells { from: column(low.x), to: column(high.x), top: row(low.y), below: row(high.y) + 1 }
    }

    /// Whether they are clear of all obstacles, for sure.
    pub fn are_clear(&self, cells: &Cells) -> bool {
        self.none_of(&self.reached, cells)
    }

    /// Whether they are on an obstacle, for sure.
    pub fn are_taken(&self, cells: &Cells) -> bool {
        !self.none_of(&self.covered, cells)
    }

    fn place(&self, p: Vec2) -> Vec2 {
        (p - self.origin) * self.per_mm
    }

    /// Marks the cells of a square that goes along a stroke; covered are those of which it is said, too.
    fn fill(&mut self, along: &Along, covers: impl Fn(f64, f64) -> bool) {
        let reach = along.half + EDGE;
        let last = whole(along.b.y + reach).min(self.rows - 1);
        for row in whole(along.a.y - reach)..=last {
            let y = row as f64;
            if let Some((from, to)) = along.between(y - EDGE, y + 1.0 + EDGE) {
                let (from, to) = (whole(from - EDGE), whole(to + EDGE).min(self.columns - 1));
                set(&mut self.reached, (row, self.rows), from, to);
            }
            if let Some((from, to)) = along.through(y - EDGE, y + 1.0 + EDGE) {
                let (mut from, to) = (whole((from + EDGE).ceil()), whole(to - EDGE).min(self.columns));
                while from < to && !covers(from as f64, y) {
                    from += 1;
                }
                let end = (from..to).find(|x| !covers(*x as f64, y)).unwrap_or(to);
                if from < end {
                    set(&mut self.covered, (row, self.rows), from, end - 1);
                }
            }
        }
    }

    fn none_of(&self, all: &[u64], cells: &Cells) -> bool {
        let (first, last) = (cells.from / 64, cells.to / 64);
        let in_word = |word: usize| {
            let rows = all.get(word * self.rows + cells.top..word * self.rows + cells.below);
            rows.into_iter().flatten().fold(0, |any, row| any | row) & mask(word, cells.from, cells.to)
        };
        in_word(first) == 0 && (first == last || (first + 1..last + 1).all(|word| in_word(word) == 0))
    }
}

/// The bits of a word from one column to another.
const fn mask(word: usize, from: usize, to: usize) -> u64 {
    let start = word * 64;
    let low = if from > start { u64::MAX << (from - start) } else { u64::MAX };
    let high = if to < start + 63 { u64::MAX >> (63 + start - to) } else { u64::MAX };
    low & high
}

/// Sets the bits of a row, one of so many, from one column to another.
fn set(cells: &mut [u64], (row, rows): (usize, usize), from: usize, to: usize) {
    if from <= to {
        for word in from / 64..=to / 64 {
            cells[word * rows + row] |= mask(word, from, to);
        }
    }
}

/// The whole number below; below zero it is zero.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
const fn whole(x: f64) -> usize {
    x as u32 as usize
}
