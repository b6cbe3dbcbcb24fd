//! What a label asks for.

use crate::geometry::Rect;
use crate::palette::Role;
use crate::text::Text;
use assur_math::math::Vec2;

/// What a label is about.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Anchor {
    /// A point with the radius of its mark.
    Point(Vec2, f64),
    /// A line: beside it, at a quarter to three quarters of its length.
    Line(Vec2, Vec2),
}

/// A label that looks for a place.
#[derive(Clone, Debug, PartialEq)]
pub struct Label {
    pub text: Text,
    /// Size of its letters, mm.
    pub size: f64,
    pub role: Role,
    /// What it is about.
    pub anchor: Anchor,
    /// The direction in which it is best, y down; above right where there is none.
    pub towards: Option<Vec2>,
    /// Lower ranks choose first.
    pub rank: u8,
    /// Radius of the circle around it: the number of a link.
    pub ring: Option<f64>,
    /// The group it belongs to.
    pub group: usize,
}

impl Label {
    /// A label at a point.
    #[must_use]
    pub const fn at(text: Text, size: f64, point: Vec2, radius: f64) -> Self {
        let anchor = Anchor::Point(point, radius);
        Self { text, size, role: Role::Ink, anchor, towards: None, rank: 4, ring: None, group: 0 }
    }

    /// A label beside a line.
    #[must_use]
    pub const fn along(text: Text, size: f64, from: Vec2, to: Vec2) -> Self {
        let anchor = Anchor::Line(from, to);
        Self { text, size, role: Role::Ink, anchor, towards: None, rank: 4, ring: None, group: 0 }
    }

    #[must_use]
    pub const fn coloured(mut self, role: Role) -> Self {
        self.role = role;
        self
    }

    /// Best in a direction.
    #[must_use]
    pub const fn towards(mut self, direction: Vec2) -> Self {
        self.towards = Some(direction);
        self
    }

    #[must_use]
    pub const fn ranked(mut self, rank: u8) -> Self {
        self.rank = rank;
        self
    }

    #[must_use]
    pub const fn ringed(mut self, radius: f64) -> Self {
        self.ring = Some(radius);
        self
    }

    /// Its box about the middle of it.
    #[must_use]
    pub fn half(&self) -> Vec2 {
        let text = self.text.bounds(self.size).size() * 0.5;
        match self.ring {
            Some(r) => Vec2::new(r.max(text.x + 0.6), r.max(text.y)),
            None => text,
        }
    }

    /// Where the base line of its text begins if its box is there.
    #[must_use]
    pub fn baseline(&self, bounds: &Rect) -> Vec2 {
        bounds.centre() - self.text.bounds(self.size).centre()
    }
}
