//! Linear equations that are solved together, as a table.

use crate::document::{Inline, Line, Table, text};
use assur_formula::{Expr, Name, name_node, with_digits};
use std::collections::BTreeMap;

/// The most unknowns of which a matrix is printed.
const LARGEST: usize = 12;
/// A coefficient below this part of the largest is rounding.
const ROUNDING: f64 = 1e-11;

/// Linear equations, each a sum that is zero.
pub struct System<'a> {
    /// The unknowns.
    pub unknowns: &'a [Name],
    /// Quantities that depend on unknowns, by what they are.
    pub defined: BTreeMap<Name, Expr>,
}

impl System<'_> {
    /// The equations in which an unknown is.
    pub fn kept(&self, sums: Vec<(Name, Expr)>) -> Vec<(Name, Expr)> {
        let has = |sum: &Expr| self.factors(sum).0.iter().any(|x| *x != 0.0);
        sums.into_iter().filter(|(_, sum)| has(sum)).collect()
    }

    /// The coefficients of the unknowns, and what is known on the other side; none of many unknowns.
    pub fn table(&self, sums: &[(Name, Expr)]) -> Option<Table> {
        if self.unknowns.len() > LARGEST {
            return None;
        }
        let letters = |name: &Name| vec![Inline::Math(name_node(name))];
        let mut headers = vec![vec![text("")]];
        headers.extend(self.unknowns.iter().map(letters));
        headers.push(vec![text("=")]);
        let row = |(name, sum): &(Name, Expr)| {
            let (factors, rest) = self.factors(sum);
            let mut cells = vec![letters(name)];
            cells.extend(factors.iter().map(|x| figure(*x)));
            cells.push(figure(-rest));
            cells
        };
        let rows = sums.iter().map(row).collect();
        Some(Table { headers, rows, numbers: (1..self.unknowns.len() + 2).collect() })
    }

    /// The coefficients of an equation, and the rest of it.
    fn factors(&self, sum: &Expr) -> (Vec<f64>, f64) {
        let rest = self.value(sum, None);
        let mut factors: Vec<f64> = self.unknowns.iter().map(|u| self.value(sum, Some(u)) - rest).collect();
        let large = factors.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        // a difference of two numbers that are large against it has rounding in it
        let noise = ROUNDING * large + 64.0 * f64::EPSILON * sum.scale().min(f64::MAX);
        factors.iter_mut().filter(|x| x.abs() <= noise).for_each(|x| *x = 0.0);
        let rest = if rest.abs() <= ROUNDING * sum.scale() { 0.0 } else { rest };
        (factors, rest)
    }

    /// The value of an equation where one unknown is one and the others are nothing.
    fn value(&self, sum: &Expr, one: Option<&Name>) -> f64 {
        sum.value_of(&|q| {
            if self.unknowns.contains(&q.name) {
                return f64::from(u8::from(one == Some(&q.name)));
            }
            self.defined.get(&q.name).map_or(q.value, |right| self.value(right, one))
        })
    }
}

fn figure(x: f64) -> Line {
    let whole = x.abs() == 1.0;
    vec![text(with_digits(x, if whole { 1 } else { 5 }).text())]
}
