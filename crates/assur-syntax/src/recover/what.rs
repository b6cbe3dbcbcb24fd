//! The kind of part that was being read when a mistake was found.

use crate::grammar::Rule;

/// The kind of part being read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum What {
    Statement,
    /// A member of a link.
    Member,
    /// A property in braces.
    Property,
    /// A part of a cam.
    CamMember,
    /// The header of a table of variants.
    Header,
    /// A row of such a table.
    Row,
}

impl What {
    /// The rule that reads it alone.
    pub const fn rule(self) -> Rule {
        match self {
            Self::Statement => Rule::one_statement,
            Self::Member => Rule::one_member,
            Self::Property => Rule::one_property,
            Self::CamMember => Rule::one_cam_member,
            Self::Header => Rule::one_header,
            Self::Row => Rule::one_row,
        }
    }
}
