//! What is where: cells with the obstacles and lines in them, so that a box is tested against its neighbours alone.

use crate::geometry::{Rect, Segment};
use crate::mark::Obstacle;
use assur_math::math::Vec2;

/// Side of a cell, mm.
const CELL: f64 = 5.0;
/// The most cells along a side.
const MOST: usize = 400;

/// A grid over a box.
#[derive(Debug)]
pub struct Grid<T> {
    origin: Vec2,
    cell: f64,
    columns: usize,
    rows: usize,
    cells: Vec<Vec<u32>>,
    items: Vec<T>,
}

impl<T> Grid<T> {
    /// An empty grid over a box.
    pub fn over(bounds: &Rect) -> Self {
        let size = bounds.size();
        let cell = CELL.max(size.x.max(size.y) / MOST as f64);
        let count = |length: f64| index(length / cell) + 1;
        let (columns, rows) = (count(size.x), count(size.y));
        let cells = (0..columns * rows).map(|_| Vec::new()).collect();
        Self { origin: bounds.min, cell, columns, rows, cells, items: Vec::new() }
    }

    fn span(&self, bounds: &Rect) -> [usize; 4] {
        let column = |x: f64| index((x - self.origin.x) / self.cell).min(self.columns - 1);
        let row = |y: f64| index((y - self.origin.y) / self.cell).min(self.rows - 1);
        [column(bounds.min.x), column(bounds.max.x), row(bounds.min.y), row(bounds.max.y)]
    }

    /// An empty grid that knows items.
    pub fn knowing(items: Vec<T>, bounds: &Rect) -> Self {
        Self { items, ..Self::over(bounds) }
    }

    /// Adds an item that lies in a box.
    pub fn add(&mut self, item: T, bounds: &Rect) {
        let Ok(id) = u32::try_from(self.items.len()) else { return };
        self.items.push(item);
        let [left, right, top, bottom] = self.span(bounds);
        for row in top..=bottom {
            for column in left..=right {
                self.cells[row * self.columns + column].push(id);
            }
        }
    }

    /// Puts an item that is there into the cells of a box, or takes it out of them.
    pub fn put(&mut self, id: usize, bounds: &Rect, inside: bool) {
        let Ok(id) = u32::try_from(id) else { return };
        let [left, right, top, bottom] = self.span(bounds);
        for row in top..=bottom {
            for column in left..=right {
                let cell = &mut self.cells[row * self.columns + column];
                if inside {
                    cell.push(id);
                } else {
                    cell.retain(|other| *other != id);
                }
            }
        }
    }

    /// Whether any item near a box answers yes; each is asked once or more.
    pub fn any(&self, bounds: &Rect, mut asked: impl FnMut(&T) -> bool) -> bool {
        let [left, right, top, bottom] = self.span(bounds);
        for row in top..=bottom {
            for cell in &self.cells[row * self.columns + left..=row * self.columns + right] {
                for id in cell {
                    if asked(&self.items[*id as usize]) {
                        return true;
                    }
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
