//! Which labels are where: cells with those that have a place in them.

use crate::geometry::Rect;
use assur_math::math::Vec2;

/// Side of a cell, mm.
const CELL: f64 = 8.0;
/// The most cells along a side.
const MOST: f64 = 200.0;

/// Cells over a box.
pub struct Seats {
    origin: Vec2,
    per_mm: f64,
    columns: usize,
    rows: usize,
    cells: Vec<Vec<usize>>,
}

impl Seats {
    /// None is taken.
    pub fn over(bounds: &Rect) -> Self {
        let size = bounds.size();
        let per_mm = 1.0 / CELL.max(size.x.max(size.y) / MOST);
        let (columns, rows) = (whole(size.x * per_mm) + 1, whole(size.y * per_mm) + 1);
        Self { origin: bounds.min, per_mm, columns, rows, cells: vec![Vec::new(); columns * rows] }
    }

    fn span(&self, bounds: &Rect) -> [usize; 4] {
        let (low, high) =
            ((bounds.min - self.origin) * self.per_mm, (bounds.max - self.origin) * self.per_mm);
        let column = |x: f64| whole(x).min(self.columns - 1);
        let row = |y: f64| whole(y).min(self.rows - 1);
        [column(low.x), column(high.x), row(low.y), row(high.y)]
    }

    /// A label takes a place, or leaves it.
    pub fn put(&mut self, label: usize, bounds: &Rect, inside: bool) {
        let [left, right, top, bottom] = self.span(bounds);
        for row in top..bottom + 1 {
            for cell in &mut self.cells[row * self.columns + left..row * self.columns + right + 1] {
                if inside {
                    cell.push(label);
                } else {
                    cell.retain(|other| *other != label);
                }
            }
        }
    }

    /// Whether one of the labels that may be in a box answers yes; each is asked once or more.
    pub fn any(&self, bounds: &Rect, mut asked: impl FnMut(usize) -> bool) -> bool {
        let [left, right, top, bottom] = self.span(bounds);
        (top..bottom + 1).any(|row| {
            let cells = &self.cells[row * self.columns + left..row * self.columns + right + 1];
            cells.iter().flatten().any(|label| asked(*label))
        })
    }
}

/// The whole number below; below zero it is zero.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
const fn whole(x: f64) -> usize {
    x as u32 as usize
}
