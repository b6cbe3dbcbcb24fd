//! Which unit a value is printed in.

use crate::values::store::Values;
use crate::values::unit_use::{display_in, suits};
use assur_model::model::Display;
use assur_text::units::{Dimension, Unit};

impl Values<'_> {
    /// The unit the file uses most for a dimension.
    fn favourite(&self, dimension: Dimension) -> Option<&Unit> {
        let suited = self.units.values().filter(|(unit, _)| suits(unit, dimension));
        // Of equally frequent ones the first.
        suited.rev().max_by_key(|(_, n)| *n).map(|(unit, _)| unit)
    }

    /// How a value of this dimension is printed where nobody says.
    pub fn display(&self, dimension: Dimension) -> Display {
        let si = || Unit::si(if dimension.is_number() { Dimension::NUMBER } else { dimension });
        display_in(&self.favourite(dimension).cloned().unwrap_or_else(si))
    }

    /// The unit to propose where one is missing.
    pub fn usual_unit(&self, dimension: Dimension) -> String {
        if let Some(unit) = self.favourite(dimension) {
            return unit.text.clone();
        }
        match dimension {
            Dimension::LENGTH => "mm".into(),
            Dimension::ANGLE => "deg".into(),
            d => d.si_text(),
        }
    }

    /// The favourite units of all dimensions the file has units for.
    pub fn displays(&self) -> Vec<Display> {
        let mut all = Vec::new();
        for (unit, _) in self.units.values() {
            let display = self.display(unit.dimension);
            if !all.contains(&display) {
                all.push(display);
            }
        }
        all
    }
}
