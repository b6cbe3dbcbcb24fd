//! A spline through a table of lifts: the slopes at its rows, and the terms of a piece between two rows.
//!
//! With the slopes σ₁, σ₂ by the cam's angle at the ends of a piece that takes the angle Φ and changes the lift by h, the terms of its
//! way a u + b u² + c u³ are a = Φ σ₁, b = 3 h − Φ (2 σ₁ + σ₂), c = Φ (σ₁ + σ₂) − 2 h. Where two pieces meet their second derivatives are
//! equal: (σ₀ + 2 σ₁)/Φ₀ + (2 σ₁ + σ₂)/Φ₁ = 3 (h₀/Φ₀² + h₁/Φ₁²). At an end of a table that does not go on the slope is nothing.

use assur_formula::{Expr, Name, Quantity, Unit};
use assur_math::element::cam::{Law, Phase};
use assur_math::math::SAME;
use std::sync::Arc;

/// A quantity of a spline; without a formula it is part of the same system of equations.
#[derive(Clone, Debug)]
pub struct Term {
    pub name: Name,
    pub value: f64,
    pub unit: Unit,
    /// What it follows from.
    pub right: Option<Expr>,
}

/// A spline through a table of lifts, as letters have it.
pub struct Spline<'a> {
    /// The stages of the cam.
    pub phases: &'a [Phase],
    /// The lift is an angle.
    pub turns: bool,
    /// The letters of a quantity of a stage, by the number of the stage.
    pub name: &'a dyn Fn(&str, usize) -> Name,
    /// A value of the file.
    pub given: &'a dyn Fn(Name, f64, Unit) -> Expr,
}

/// The terms of a piece; none where a law is no spline.
const fn terms(phase: &Phase) -> Option<[f64; 3]> {
    if let Law::Spline(terms) = phase.law { Some(terms) } else { None }
}

impl Spline<'_> {
    /// The row at which a stage begins; the last ends where the first begins.
    const fn row(&self, at: usize) -> usize {
        if at == self.phases.len() { 0 } else { at }
    }

    /// The slope at a row, by the cam's angle in rad.
    pub fn slope(&self, row: usize) -> f64 {
        let count = self.phases.len();
        let (behind, before) = (&self.phases[row % count], &self.phases[(row + count - 1) % count]);
        match (terms(behind), terms(before)) {
            (Some([a, ..]), _) => a / behind.angle,
            (None, Some([a, b, c])) => {
                let slope = a + 2.0 * b + 3.0 * c;
                if slope.abs() <= SAME * (a.abs() + b.abs() + c.abs()) { 0.0 } else { slope / before.angle }
            }
            (None, None) => 0.0,
        }
    }

    /// The stages that meet at a row with equal second derivatives.
    fn meeting(&self, row: usize) -> Option<[usize; 2]> {
        let before = if row == 0 { self.phases.len() - 1 } else { row - 1 };
        let (one, two) = (&self.phases[before], &self.phases[row]);
        let ([_, b, c], [_, d, _]) = (terms(one)?, terms(two)?);
        let bends = [(2.0 * b + 6.0 * c) / one.angle.powi(2), 2.0 * d / two.angle.powi(2)];
        let size = (2.0 * b.abs() + 6.0 * c.abs()) / one.angle.powi(2);
        ((bends[0] - bends[1]).abs() <= SAME * size.max(bends[1].abs())).then_some([before, row])
    }

    fn slope_unit(&self) -> Unit {
        if self.turns { Unit::One } else { Unit::Length }
    }

    /// The letters of the slope at a row; nothing where the table ends there.
    fn slope_at(&self, row: usize) -> Expr {
        let (name, value, unit) = ((self.name)("σ", row + 1), self.slope(row), self.slope_unit());
        if value == 0.0 {
            return Expr::ZERO;
        }
        Expr::Leaf(Arc::new(Quantity { name, value, unit, scale: value.abs(), given: false, rounding: 0.0 }))
    }

    fn angle(&self, stage: usize) -> Expr {
        (self.given)((self.name)("Φ", stage + 1), self.phases[stage].angle.to_degrees(), Unit::Angle)
    }

    fn change(&self, stage: usize) -> Expr {
        let change = self.phases[stage].change;
        let (value, unit) =
            if self.turns { (change.to_degrees(), Unit::Angle) } else { (change, Unit::Length) };
        (self.given)((self.name)("h", stage + 1), value, unit)
    }

    /// What the slope at a row follows from: its neighbours, and the changes of the lift on both sides.
    fn slope_by_neighbours(&self, row: usize) -> Option<Expr> {
        let [one, two] = self.meeting(row)?;
        let int = Expr::Int;
        let (before, after) = (self.slope_at(one), self.slope_at(self.row(two + 1)));
        let [h_1, h_2] = [one, two].map(|stage| self.change(stage));
        let [phi_1, phi_2] = [one, two].map(|stage| self.angle(stage));
        let rises = |changes: Expr, by: Expr| match self.turns {
            true => int(3) * changes / by,
            false => int(540) * changes / (Expr::Pi * by),
        };
        let apart = self.phases[one].angle - self.phases[two].angle;
        if apart.abs() <= SAME * self.phases[one].angle {
            return Some((rises(h_1 + h_2, phi_2) - before - after) / int(4));
        }
        let sum = rises(h_1 * phi_2.clone(), phi_1.clone()) + rises(h_2 * phi_1.clone(), phi_2.clone())
            - phi_2.clone() * before
            - phi_1.clone() * after;
        Some(sum / (int(2) * (phi_1 + phi_2)))
    }

    /// The slope at a row with what it follows from; none where the table ends there.
    pub fn slope_term(&self, row: usize) -> Option<Term> {
        let right = self.slope_by_neighbours(row)?;
        let (name, value) = ((self.name)("σ", row + 1), self.slope(row));
        Some(Term { name, value, unit: self.slope_unit(), right: Some(right) })
    }

    /// The slopes beyond the ends of a piece, from which those at its ends follow.
    pub fn slopes_around(&self, stage: usize) -> Vec<Term> {
        let ends = [stage, self.row(stage + 1)];
        let mut around: Vec<usize> = Vec::new();
        for row in ends {
            let Some([one, two]) = self.meeting(row) else { continue };
            for other in [one, self.row(two + 1)] {
                if !ends.contains(&other) && !around.contains(&other) && self.slope(other) != 0.0 {
                    around.push(other);
                }
            }
        }
        let unit = self.slope_unit();
        let term =
            |row: usize| Term { name: (self.name)("σ", row + 1), value: self.slope(row), unit, right: None };
        around.into_iter().map(term).collect()
    }

    /// The slopes at both ends of a piece.
    pub fn slopes_of(&self, stage: usize) -> Vec<Term> {
        [stage, self.row(stage + 1)].into_iter().filter_map(|row| self.slope_term(row)).collect()
    }

    /// The terms a, b, c of a piece.
    pub fn terms_of(&self, stage: usize) -> Vec<Term> {
        let Some(values) = terms(&self.phases[stage]) else { return Vec::new() };
        let int = Expr::Int;
        let (begin, end) = (self.slope_at(stage), self.slope_at(self.row(stage + 1)));
        let (h, phi) = (self.change(stage), self.angle(stage));
        let way = |slopes: Expr| match self.turns {
            true => phi.clone() * slopes,
            false => Expr::Pi * phi.clone() * slopes / int(180),
        };
        let right = [
            way(begin.clone()),
            int(3) * h.clone() - way(int(2) * begin.clone() + end.clone()),
            way(begin + end) - int(2) * h,
        ];
        let (scale, unit) = if self.turns { (1_f64.to_degrees(), Unit::Angle) } else { (1.0, Unit::Length) };
        let of = |((letter, value), right)| {
            let name = (self.name)(letter, stage + 1);
            Term { name, value: scale * value, unit, right: Some(right) }
        };
        ["a", "b", "c"].into_iter().zip(values).zip(right).map(of).collect()
    }
}
