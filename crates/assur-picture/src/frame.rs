//! From the ground's axes to paper.

use assur_drawing::{Rect, Scale};
use assur_math::math::Vec2;

/// Where the ground's axes lie on paper.
#[derive(Clone, Copy, Debug)]
pub struct Frame {
    /// Length per millimetre, m; none where nothing has an extent.
    pub scale: Option<Scale>,
    /// The point of the ground at the origin of the paper, m.
    pub origin: Vec2,
    /// The factor of the scale.
    factor: f64,
}

impl Frame {
    /// The smallest scale factor with which a box of the ground, m, fits into a size, mm.
    #[must_use]
    pub fn fitting(bounds: &Rect, size: Vec2) -> Self {
        let extent = bounds.size();
        let across = Scale::fitting(extent.x, size.x);
        let up = Scale::fitting(extent.y, size.y);
        let scale = match (across, up) {
            (Some(a), Some(b)) => Some(if a.factor() >= b.factor() { a } else { b }),
            (a, b) => a.or(b),
        };
        let origin = if bounds.is_nothing() { Vec2::zero() } else { bounds.centre() };
        Self::new(scale, origin)
    }

    /// With a scale and an origin.
    #[must_use]
    pub fn new(scale: Option<Scale>, origin: Vec2) -> Self {
        Self { scale, origin, factor: scale.map_or(1.0, |s| s.factor()) }
    }

    /// A point of the ground on paper, mm.
    #[must_use]
    pub fn point(&self, at: Vec2) -> Vec2 {
        let d = at - self.origin;
        Vec2::new(d.x / self.factor, -d.y / self.factor)
    }

    /// A length on paper, mm.
    #[must_use]
    pub fn length(&self, l: f64) -> f64 {
        l / self.factor
    }
}

impl Frame {
    /// A length of the ground that is one millimetre of paper, m.
    #[must_use]
    pub const fn unit(&self) -> f64 {
        self.factor
    }
}
