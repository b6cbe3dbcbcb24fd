//! What is where: cells with the obstacles and lines in them, so that a box is tested against its neighbours alone.

use crate::geometry::{Rect, Segment};
use crate::mark::Obstacle;
use assur_math::math::Vec2;

/// Side of a cell, mm.
const CELL: f64 = 5.0;
/// The most cells along a side.
const MOST: usize = 400;

/// What rounding may move an edge by, mm.
const ROUNDING: f64 = 1e-9;
/// The end of a list.
const END: u32 = u32::MAX;

/// A grid over a box.
#[derive(Debug)]
pub struct Grid<T> {
    origin: Vec2,
    cell: f64,
    columns: usize,
    rows: usize,
    /// The first and the last entry of each cell.
    cells: Vec<[u32; 2]>,
    /// Items, each with the next entry of its cell.
    entries: Vec<[u32; 2]>,
    /// With the boxes that they lie in.
    items: Vec<(Rect, T)>,
}

impl<T> Grid<T> {
    /// An empty grid over a box.
    pub fn over(bounds: &Rect) -> Self {
        let size = bounds.size();
        let cell = CELL.max(size.x.max(size.y) / MOST as f64);
        let count = |length: f64| index(length / cell) + 1;
        let (columns, rows) = (count(size.x), count(size.y));
        let (cells, entries, items) = (vec![[END; 2]; columns * rows], Vec::new(), Vec::new());
        Self { origin: bounds.min, cell, columns, rows, cells, entries, items }
    }

    fn span(&self, bounds: &Rect) -> [usize; 4] {
        // below zero is zero
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let place = |x: f64, count: usize| ((x / self.cell) as usize).min(count - 1);
        let column = |x: f64| place(x - self.origin.x, self.columns);
        let row = |y: f64| place(y - self.origin.y, self.rows);
        [column(bounds.min.x), column(bounds.max.x), row(bounds.min.y), row(bounds.max.y)]
    }

    /// Adds an item that lies in a box.
    pub fn add(&mut self, item: T, bounds: &Rect) {
        let Ok(id) = u32::try_from(self.items.len()) else { return };
        self.items.push((bounds.grown(ROUNDING), item));
        let [left, right, top, bottom] = self.span(bounds);
        for row in top..=bottom {
            for column in left..=right {
                let Ok(entry) = u32::try_from(self.entries.len()) else { return };
                self.entries.push([id, END]);
                let [first, last] = &mut self.cells[row * self.columns + column];
                if *last == END {
                    *first = entry;
                } else {
                    self.entries[*last as usize][1] = entry;
                }
                *last = entry;
            }
        }
    }

    /// Whether any item whose box overlaps a box answers yes; each is asked once or more.
    pub fn any(&self, bounds: &Rect, mut asked: impl FnMut(&T) -> bool) -> bool {
        let [left, right, top, bottom] = self.span(bounds);
        for row in top..=bottom {
            for [first, _] in &self.cells[row * self.columns + left..=row * self.columns + right] {
                let mut entry = *first;
                while entry != END {
                    let [id, next] = self.entries[entry as usize];
                    let (around, item) = &self.items[id as usize];
                    if around.overlaps(bounds) && asked(item) {
                        return true;
                    }
                    entry = next;
                }
            }
        }
        false
    }
}

#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // of a grid with few cells; below zero is zero
fn index(x: f64) -> usize {
    x.clamp(0.0, 1e6) as usize
}

/// Whether a box, or the disc in it, touches an obstacle.
#[must_use]
pub fn touches(bounds: &Rect, round: bool, obstacle: &Obstacle, apart: f64) -> bool {
    match obstacle {
        Obstacle::Stroke(segment, half) if round => {
            segment.distance(bounds.centre()) < bounds.size().x * 0.5 + half + apart
        }
        Obstacle::Stroke(segment, half) => bounds.grown(half + apart).inside(segment).is_some(),
        Obstacle::Disc(centre, radius) if round => {
            (bounds.centre() - *centre).norm() < bounds.size().x * 0.5 + radius + apart
        }
        Obstacle::Disc(centre, radius) => (bounds.nearest(*centre) - *centre).norm() < radius + apart,
    }
}

/// The box in which an obstacle lies.
#[must_use]
pub fn bounds(obstacle: &Obstacle) -> Rect {
    match obstacle {
        Obstacle::Stroke(segment, half) => segment.bounds().grown(*half),
        Obstacle::Disc(centre, radius) => Rect::around(*centre, Vec2::new(*radius, *radius)),
    }
}

/// Strokes no longer than a few cells, so that a slanted line is not everywhere in its box.
pub fn pieces(segment: &Segment) -> impl Iterator<Item = Segment> + use<> {
    let (a, d) = (segment.a, segment.b - segment.a);
    let count = (index(d.norm() / (2.0 * CELL)) + 1).min(1000);
    (0..count).map(move |i| Segment {
        a: a + d * (i as f64 / count as f64),
        b: a + d * ((i + 1) as f64 / count as f64),
    })
}
