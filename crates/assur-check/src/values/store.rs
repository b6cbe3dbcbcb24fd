//! All values: from outside, of definitions, of wheels and gears.

use crate::values::{
    definition::Definitions,
    row::{ColumnUse, Row},
    typed::Typed,
    unit_use::UnitUse,
};
use assur_model::model::{Curve, Gears, LinkId};
use assur_syntax::document::WheelMember;
use assur_text::units::Dimension;
use indexmap::IndexMap;
use std::collections::BTreeSet;
use std::sync::Arc;

/// The gear pairs that are known, by the names of their meshes; `None` for those with an error.
pub type KnownGears = IndexMap<String, Option<Gears>>;

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
    pub gears: KnownGears,
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
            gears: KnownGears::new(),
            curves: IndexMap::new(),
        }
    }
}

// The sizes of wheels, as far as they have been read.

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

// Values from outside: set for all rows, in a row of variants, or assumed for a trial.

pub struct Outside<'a> {
    /// Values set from outside.
    pub overrides: &'a Overrides,
    /// The row of variants that is checked.
    pub row: Row,
    /// A `given` with the SI value it has instead of any other.
    pub fixed: Option<(&'a str, f64)>,
    /// What stands for names that have their values in the row alone, where that is no number.
    pub keys: IndexMap<String, Typed>,
    /// A wheel whose size is left open, of which another is assumed than usual.
    pub other_size: Option<&'a str>,
}

impl<'a> Outside<'a> {
    /// Those that replace values, with nothing assumed.
    pub fn new(overrides: &'a Overrides) -> Self {
        Self { overrides, row: overrides.row.clone(), fixed: None, keys: IndexMap::new(), other_size: None }
    }

    /// What the row of variants says of a name that has its values there alone.
    pub fn key(&self, name: &str) -> Option<Typed> {
        if let Some(key) = self.keys.get(name) {
            return Some(key.clone());
        }
        let (column, cell) = self.row.find(name).filter(|(c, _)| c.what == ColumnUse::Key)?;
        Some(Typed::constant(cell.value, column.dimension))
    }

    pub fn is_set(&self, name: &str) -> bool {
        self.overrides.values.iter().any(|(n, _)| n == name)
    }

    /// One unit in the last digit of a name in the row of variants, SI, where nothing replaces it.
    pub fn digit_in_row(&self, name: &str) -> Option<f64> {
        self.row.find(name).filter(|_| !self.is_set(name)).map(|(_, cell)| cell.digit)
    }
}

// Values from outside the file.

/// Values that replace those of `given` statements. A row of variants replaces what the file says, values set from
/// outside replace both.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Overrides {
    /// Name and value as text, as in `--set r=120mm`, in the order given; a later one wins.
    pub values: Vec<(String, String)>,
    /// The row of variants.
    pub row: Row,
}

impl Overrides {
    /// No value is replaced.
    #[must_use]
    pub fn none() -> Self {
        Self::default()
    }

    /// Values set from outside, as in `--set r=120mm`.
    #[must_use]
    pub fn set(values: Vec<(String, String)>) -> Self {
        Self { values, row: Row::default() }
    }

    /// Whether a value of the file is replaced.
    #[must_use]
    pub fn has(&self, name: &str) -> bool {
        self.values.iter().any(|(own, _)| own == name)
            || self.row.entries().any(|(column, _)| column.name == name)
    }
}
