//! The sizes of wheels, as far as they have been read.

use assur_model::model::LinkId;
use assur_syntax::document::WheelMember;
use indexmap::IndexMap;
use std::collections::BTreeSet;

/// A wheel as declared.
#[derive(Clone, Copy, Debug)]
pub struct DeclaredWheel<'a> {
    pub member: &'a WheelMember,
    /// The link it sits on.
    pub link: LinkId,
    /// Whether that is a shaft.
    pub shaft: bool,
    /// Wheels with the same number mesh with each other, in a row: they have one module.
    pub family: usize,
}

/// The sizes of all wheels, as far as they have been read.
#[derive(Debug, Default)]
pub struct Sizes<'a> {
    /// All wheels, by name.
    pub declared: IndexMap<String, DeclaredWheel<'a>>,
    /// Radii that have been read; `None` with an error.
    pub radii: IndexMap<String, Option<f64>>,
    /// Those whose radius is being read, from the outermost on.
    pub reading: Vec<String>,
    /// Wheels whose radius depends on a size that the file leaves open.
    pub open: BTreeSet<String>,
}
