//! Questions about the forces inside a link.

use super::LinkId;

/// One of the forces that two parts of a link exchange at a cut across its x axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum InternalPart {
    /// Along the axis, N; tension is positive.
    Normal,
    /// Across the axis, N: the sum of what acts before the cut.
    Shear,
    /// N m; positive where the link sags.
    Moment,
}

impl InternalPart {
    pub const ALL: [Self; 3] = [Self::Normal, Self::Shear, Self::Moment];

    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Normal => "N",
            Self::Shear => "Q",
            Self::Moment => "M",
        }
    }
}

/// An extreme along a link.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct AlongLink {
    /// The greatest value; else the least.
    pub greatest: bool,
    /// Its place on the axis; else the value.
    pub place: bool,
}

/// A question about the forces inside a link.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Internal {
    pub link: LinkId,
    pub part: InternalPart,
    pub at: Cut,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cut {
    /// At this place on the axis, m.
    At(f64),
    Extreme(AlongLink),
}
