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

    /// The coefficients of the unknowns, and what is known on the other side.
    pub fn table(&self, sums: &[(Name, Expr)]) -> Table {
        let row = |(name, sum): &(Name, Expr)| {
            let (factors, rest) = self.factors(sum);
            (name.clone(), factors, -rest)
        };
        matrix(self.unknowns, &sums.iter().map(row).collect::<Vec<_>>())
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

/// Equations as a table: name, coefficients, right side. Of many unknowns only those are written that an equation has.
pub fn matrix(unknowns: &[Name], rows: &[(Name, Vec<f64>, f64)]) -> Table {
    let letters = |name: &Name| vec![Inline::Math(name_node(name))];
    let few = unknowns.len() <= LARGEST;
    let mut headers = vec![vec![text("")]];
    if few {
        headers.extend(unknowns.iter().map(letters));
    } else {
        headers.push(vec![text("")]);
    }
    headers.push(vec![text("=")]);
    let row = |(name, factors, right): &(Name, Vec<f64>, f64)| {
        let mut cells = vec![letters(name)];
        if few {
            cells.extend(factors.iter().map(|x| figure(*x)));
        } else {
            cells.push(terms(unknowns, factors));
        }
        cells.push(figure(*right));
        cells
    };
    let last = headers.len() - 1;
    let numbers = if few { (1..=last).collect() } else { vec![last] };
    Table { headers, rows: rows.iter().map(row).collect(), numbers }
}

/// The terms of an equation that are not nothing.
fn terms(unknowns: &[Name], factors: &[f64]) -> Line {
    let mut line = Line::new();
    for (name, x) in unknowns.iter().zip(factors).filter(|(_, x)| **x != 0.0) {
        let first = line.is_empty();
        let sign = match (*x < 0.0, first) {
            (true, true) => "−",
            (true, false) => " − ",
            (false, true) => "",
            (false, false) => " + ",
        };
        let size =
            if x.abs() == 1.0 { String::new() } else { format!("{} ", with_digits(x.abs(), 5).text()) };
        line.push(text(format!("{sign}{size}")));
        line.push(Inline::Math(name_node(name)));
    }
    line
}

fn figure(x: f64) -> Line {
    let whole = x.abs() == 1.0;
    vec![text(with_digits(x, if whole { 1 } else { 5 }).text())]
}
