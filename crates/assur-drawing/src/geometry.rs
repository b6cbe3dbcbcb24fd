//! Boxes and segments on paper.

use assur_math::math::Vec2;

/// A box with its sides along the axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rect {
    /// Least x and y.
    pub min: Vec2,
    /// Greatest x and y.
    pub max: Vec2,
}

/// A straight part of a stroke.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Segment {
    pub a: Vec2,
    pub b: Vec2,
}

impl Rect {
    /// Nothing: the first thing added to it is all of it.
    pub const NOTHING: Self = Self {
        min: Vec2::new(f64::INFINITY, f64::INFINITY),
        max: Vec2::new(f64::NEG_INFINITY, f64::NEG_INFINITY),
    };

    /// The box around a point.
    #[must_use]
    pub fn around(centre: Vec2, half: Vec2) -> Self {
        Self { min: centre - half, max: centre + half }
    }

    /// Whether nothing was added to it.
    #[must_use]
    pub fn is_nothing(&self) -> bool {
        self.min.x > self.max.x || self.min.y > self.max.y
    }

    /// Takes a point in; one that is not finite has no place.
    pub fn add(&mut self, p: Vec2) {
        if p.x.is_finite() && p.y.is_finite() {
            let sooner = |a: f64, b: f64| if b < a { b } else { a };
            let later = |a: f64, b: f64| if b > a { b } else { a };
            self.min = Vec2::new(sooner(self.min.x, p.x), sooner(self.min.y, p.y));
            self.max = Vec2::new(later(self.max.x, p.x), later(self.max.y, p.y));
        }
    }

    /// Takes a box in.
    pub fn join(&mut self, other: &Self) {
        if !other.is_nothing() {
            self.add(other.min);
            self.add(other.max);
        }
    }

    /// Larger on all sides.
    #[must_use]
    pub fn grown(&self, by: f64) -> Self {
        let by = Vec2::new(by, by);
        Self { min: self.min - by, max: self.max + by }
    }

    /// The same box elsewhere.
    #[must_use]
    pub fn shifted(&self, by: Vec2) -> Self {
        Self { min: self.min + by, max: self.max + by }
    }

    #[must_use]
    pub fn size(&self) -> Vec2 {
        if self.is_nothing() { Vec2::zero() } else { self.max - self.min }
    }

    #[must_use]
    pub fn centre(&self) -> Vec2 {
        (self.min + self.max) * 0.5
    }

    /// Whether two boxes have an area in common.
    #[must_use]
    pub fn overlaps(&self, o: &Self) -> bool {
        self.min.x < o.max.x && o.min.x < self.max.x && self.min.y < o.max.y && o.min.y < self.max.y
    }

    /// Whether the other lies in it.
    #[must_use]
    pub fn contains(&self, o: &Self) -> bool {
        self.min.x <= o.min.x && self.min.y <= o.min.y && self.max.x >= o.max.x && self.max.y >= o.max.y
    }

    /// Whether a point lies in it.
    #[must_use]
    pub fn has(&self, p: Vec2) -> bool {
        self.min.x <= p.x && p.x <= self.max.x && self.min.y <= p.y && p.y <= self.max.y
    }

    /// The point of the box nearest to another.
    #[must_use]
    pub fn nearest(&self, p: Vec2) -> Vec2 {
        Vec2::new(p.x.clamp(self.min.x, self.max.x), p.y.clamp(self.min.y, self.max.y))
    }

    /// The length of a segment inside, after Liang and Barsky; `None` where it passes by.
    #[must_use]
    pub fn inside(&self, s: &Segment) -> Option<f64> {
        let d = s.b - s.a;
        let (mut from, mut to) = (0.0_f64, 1.0_f64);
        for (p, q) in [
            (-d.x, s.a.x - self.min.x),
            (d.x, self.max.x - s.a.x),
            (-d.y, s.a.y - self.min.y),
            (d.y, self.max.y - s.a.y),
        ] {
            if p == 0.0 {
                if q <= 0.0 {
                    return None;
                }
            } else if p < 0.0 {
                from = from.max(q / p);
            } else {
                to = to.min(q / p);
            }
        }
        (from < to).then(|| (to - from) * d.norm())
    }
}

impl Segment {
    /// Distance of a point from it.
    #[must_use]
    pub fn distance(&self, p: Vec2) -> f64 {
        let d = self.b - self.a;
        let squared = d.dot(d);
        let t = if squared > 0.0 { ((p - self.a).dot(d) / squared).clamp(0.0, 1.0) } else { 0.0 };
        (self.a + d * t - p).norm()
    }

    #[must_use]
    pub fn bounds(&self) -> Rect {
        let Self { a, b } = *self;
        if !(a.x + a.y + b.x + b.y).is_finite() {
            let mut rect = Rect::NOTHING;
            rect.add(a);
            rect.add(b);
            return rect;
        }
        let sorted = |a: f64, b: f64| if a < b { (a, b) } else { (b, a) };
        let (x, y) = (sorted(a.x, b.x), sorted(a.y, b.y));
        Rect { min: Vec2::new(x.0, y.0), max: Vec2::new(x.1, y.1) }
    }
}
