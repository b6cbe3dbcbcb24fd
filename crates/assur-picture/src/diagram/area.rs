//! Hatching of an area.

use assur_math::math::Vec2;

/// From line to line, mm.
const STEP: f64 = 2.0;

/// Lines at 45° within a polygon.
#[must_use]
pub fn hatched(polygon: &[Vec2]) -> Vec<(Vec2, Vec2)> {
    // of lines that rise to the right x + y is constant on paper
    let sum = |p: &Vec2| p.x + p.y;
    let least = polygon.iter().map(sum).fold(f64::INFINITY, f64::min);
    let greatest = polygon.iter().map(sum).fold(f64::NEG_INFINITY, f64::max);
    let mut lines = Vec::new();
    // on one raster for all areas
    let mut level = (least / STEP).ceil() * STEP + 0.5 * STEP;
    while level < greatest {
        let mut crossings = Vec::new();
        for (i, a) in polygon.iter().enumerate() {
            let b = &polygon[(i + 1) % polygon.len()];
            let (before, after) = (sum(a) - level, sum(b) - level);
            if (before < 0.0) != (after < 0.0) {
                crossings.push(*a + (*b - *a) * (before / (before - after)));
            }
        }
        crossings.sort_by(|a, b| a.x.total_cmp(&b.x));
        lines.extend(crossings.chunks_exact(2).map(|pair| (pair[0], pair[1])));
        level += STEP;
    }
    lines.retain(|(a, b)| (*a - *b).norm() > 0.2);
    lines
}
