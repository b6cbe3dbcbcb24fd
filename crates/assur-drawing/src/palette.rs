//! Colours by what they are for, after Okabe and Ito, in light, dark, print and black and white.

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

    /// The colour of a role.
    #[must_use]
    pub const fn of(&self, role: Role) -> &'static str {
        self.0[role as usize]
    }
}
