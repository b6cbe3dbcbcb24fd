//! What a label asks for.

use crate::geometry::Rect;
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

// Colours by what they are for, after Okabe and Ito, in light, dark, print and black and white.

/// What a colour is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Role {
    Ink,
    Paper,
    /// Axes, paths, other poses.
    Grey,
    Blue,
    Vermilion,
    Green,
    Tint,
    BlueTint,
    VermilionTint,
}

/// Which colours a document has.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Theme {
    /// Light, dark where the reader wants it, darker inks in print.
    #[default]
    Auto,
    Light,
    Dark,
    Mono,
}

/// A colour for each role.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Palette(pub [&'static str; 9]);

impl Palette {
    pub const LIGHT: Self =
        Self(["#111", "#fff", "#6b7280", "#0072b2", "#b84a00", "#0b6e4f", "#f0f0f0", "#dfeef6", "#fae7db"]);
    /// On a dark screen.
    pub const DARK: Self = Self([
        "#ececec", "#16181c", "#9aa3af", "#56b4e9", "#f0a35e", "#4ecb9f", "#26292e", "#1f3442", "#40301f",
    ]);
    pub const PRINT: Self =
        Self(["#000", "#fff", "#666", "#005b8f", "#a84300", "#075239", "#f0f0f0", "#dfeef6", "#fae7db"]);
    pub const MONO: Self =
        Self(["#000", "#fff", "#555", "#000", "#000", "#000", "#f0f0f0", "#e8e8e8", "#d8d8d8"]);

    /// The colours of a theme where nothing says what the reader prefers.
    #[must_use]
    pub const fn on_screen(theme: Theme) -> Self {
        match theme {
            Theme::Auto | Theme::Light => Self::LIGHT,
            Theme::Dark => Self::DARK,
            Theme::Mono => Self::MONO,
        }
    }

    /// The colour of a role, as red, green and blue.
    #[must_use]
    pub fn rgb(&self, role: Role) -> [u8; 3] {
        let digits = self.of(role).trim_start_matches('#');
        let (each, twice) = if digits.len() == 3 { (1, 0x11) } else { (2, 1) };
        [0, 1, 2].map(|i| {
            let part = digits.get(i * each..(i + 1) * each).unwrap_or_default();
            u8::from_str_radix(part, 16).unwrap_or_default() * twice
        })
    }

    /// The colour of a role.
    #[must_use]
    pub const fn of(&self, role: Role) -> &'static str {
        self.0[role as usize]
    }
}
