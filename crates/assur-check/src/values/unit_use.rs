//! The units a file uses, and how often.

use crate::statements::walk;
use crate::values::store::Values;
use assur_model::model::Display;
use assur_syntax::document::{Curve, Document, ExprKind, Statement};
use assur_text::units::{Dimension, Kind, Unit, lookup};
use indexmap::IndexMap;

/// The units of a file with the number of places where each is used, in the order of their first use.
pub type UnitUse = IndexMap<String, (Unit, usize)>;

/// Counts the units of a document's numbers.
pub fn count(doc: &Document) -> UnitUse {
    let mut used = UnitUse::new();
    let mut note = |word: &str| {
        if let Some((_, n)) = used.get_mut(word) {
            *n += 1;
        } else if let Ok(unit) = lookup(word) {
            used.insert(word.to_owned(), (unit, 1));
        }
    };
    for statement in &doc.statements {
        walk::expressions(&statement.node, &mut |expr| {
            walk::parts(expr, &mut |part| {
                if let ExprKind::Number(number) = &part.kind
                    && let Some(word) = &number.unit
                {
                    note(&word.node);
                }
            });
        });
        if let Statement::Variants(table) | Statement::Curve(Curve { table, .. }) = &statement.node {
            table.columns.iter().filter_map(|c| c.unit.as_ref()).for_each(|word| note(&word.node));
        }
    }
    used
}

/// Whether values of this dimension can be printed in that unit without surprise.
pub fn suits(unit: &Unit, dimension: Dimension) -> bool {
    let percent = unit.dimension == Dimension::NUMBER;
    // A torque and an energy have one dimension, but nobody reads a torque in joules.
    let energy = unit.text.contains('J');
    // A ratio of lengths fits an angle, and is a plain number to everyone.
    let ratio = dimension.is_dimensionless() && dimension.kind == Kind::Free;
    // The stiffness of a torsion spring has the dimension of a torque.
    let per_angle = ["/rad", "/deg"].iter().any(|angle| unit.text.contains(angle));
    // A torque that grows with time has the dimension of a power.
    let growth = dimension == Dimension::POWER && unit.text.contains(['*', '/']);
    unit.dimension.fits(dimension) && !(percent || energy || ratio || per_angle || growth)
}

/// The exponents and the kind as the model keeps them: 0 plain, 1 angle, 2 free.
fn exponents(d: Dimension) -> [i8; 4] {
    let kind = match d.kind {
        Kind::Plain => 0,
        Kind::Angle => 1,
        Kind::Free => 2,
    };
    [d.length, d.mass, d.time, kind]
}

/// How a value in this unit is printed.
pub fn display_in(unit: &Unit) -> Display {
    Display { unit: unit.text.clone(), factor: unit.factor, dimension: exponents(unit.dimension) }
}

// Which unit a value is printed in.

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
