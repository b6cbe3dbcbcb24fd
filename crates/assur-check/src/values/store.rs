//! All values: from outside, of definitions, of wheels and gears.

use crate::values::definition::Definitions;
use crate::values::outside::Outside;
use crate::values::overrides::Overrides;
use crate::values::sizes::Sizes;
use crate::values::unit_use::UnitUse;
use assur_math::element::gear::GearPair;
use assur_model::model::Curve;
use assur_text::units::Dimension;
use indexmap::IndexMap;
use std::sync::Arc;

/// The gear pairs that are known, by the names of their meshes; `None` for those with an error.
pub type Gears = IndexMap<String, Option<GearPair>>;

/// A curve that can be called.
#[derive(Clone)]
pub struct CheckedCurve {
    pub curve: Arc<Curve>,
    /// The dimension of its argument.
    pub argument: Dimension,
    /// The dimension of its values.
    pub value: Dimension,
}

/// Definitions and what they come to.
pub struct Values<'a> {
    pub outside: Outside<'a>,
    /// The units of the document's numbers, and how often each is used.
    pub units: UnitUse,
    /// What `given`, `let` and `find NAME =` are.
    pub definitions: Definitions,
    /// The sizes of wheels.
    pub sizes: Sizes<'a>,
    /// The gear pairs whose geometry was asked for.
    pub gears: Gears,
    /// The curves without an error, by their names.
    pub curves: IndexMap<String, CheckedCurve>,
}

impl<'a> Values<'a> {
    /// No value read yet.
    pub fn new(overrides: &'a Overrides, units: UnitUse) -> Self {
        Self {
            outside: Outside::new(overrides),
            units,
            definitions: Definitions::default(),
            sizes: Sizes::default(),
            gears: Gears::new(),
            curves: IndexMap::new(),
        }
    }
}
