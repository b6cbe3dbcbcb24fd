//! Impulses of an impact.
//!
//! With the slopes j = ∂g/∂q of a coordinate g that hits its stop an impulse Λ along it changes the rates by M⁻¹ j Λ, and ġ becomes
//! −e ġ: Λ = −(1 + e) ġ / (j M⁻¹ j). Other stops that are closed take part where they would be passed: of all of them
//!
//! ġ⁺ = ġ + J M⁻¹ Jᵀ Λ ≥ wanted,  Λ ≥ 0,  one of the two equal,
//!
//! which has one solution where the stops do not depend on each other (J. J. Moreau, Unilateral contact and dry friction in finite
//! freedom dynamics, 1988).

use super::equations::Equations;
use super::stop::ROUNDING;
use crate::math::Lu;
use crate::solve::failure::Halt;

/// So many stops at most take part in an impact.
const MOST: usize = 8;
/// Stops whose impulses change each other's rates by less than this part do not know of each other.
const APART: f64 = 1e-10;

/// What takes part in an impact.
struct Impact {
    stops: Vec<usize>,
    slopes: Vec<Vec<f64>>,
    /// M⁻¹ of them.
    each: Vec<Vec<f64>>,
    before: Vec<f64>,
    wanted: Vec<f64>,
}

impl Impact {
    /// How an impulse at one changes the rate of another.
    fn change(&self, of: usize, by: usize) -> f64 {
        self.slopes[of].iter().zip(&self.each[by]).map(|(a, b)| a * b).sum()
    }

    /// The impulses, if those of a part of the stops are all there are.
    fn impulses(&self, part: &[usize]) -> Option<Vec<f64>> {
        let mut factors = Lu::new(part.len());
        let mut found: Vec<f64> = part.iter().map(|&i| self.wanted[i] - self.before[i]).collect();
        for (row, &i) in part.iter().enumerate() {
            for (column, &j) in part.iter().enumerate() {
                *factors.at_mut(row, column) = self.change(i, j);
            }
        }
        if !factors.factor() {
            return None;
        }
        factors.solve(&mut found);
        let mut impulses = vec![0.0; self.stops.len()];
        part.iter().zip(&found).for_each(|(&i, impulse)| impulses[i] = *impulse);
        let fits = (0..self.stops.len()).all(|i| {
            let terms = (0..self.stops.len()).map(|j| self.change(i, j) * impulses[j]);
            let (sum, greatest) = terms.fold((0.0, 0.0_f64), |(s, m), x| (s + x, m.max(x.abs())));
            impulses[i] >= 0.0 && self.before[i] + sum - self.wanted[i] >= -ROUNDING * greatest
        });
        fits.then_some(impulses)
    }
}

impl Equations<'_, '_> {
    /// Whether stops can be hit at once: their impulses do not know of each other, or nothing rebounds.
    pub fn may_be_hit_at_once(&mut self, stops: &[usize]) -> bool {
        let impact = self.impact(&stops.iter().map(|stop| (*stop, 0.0)).collect::<Vec<_>>(), &[]);
        let knows = |i: usize, j: usize| {
            let own = impact.change(i, i) * impact.change(j, j);
            impact.change(i, j).abs() > APART * own.sqrt()
        };
        let pairs = (0..stops.len()).flat_map(|i| (0..i).map(move |j| (i, j)));
        stops.iter().all(|stop| self.stop(*stop).restitution == 0.0)
            || !pairs.into_iter().any(|(i, j)| knows(i, j))
    }

    /// Changes the rates so that stops that are hit have these rates, and closed ones that stand are not passed; the unknown work loses
    /// what the impact takes.
    ///
    /// # Errors
    /// Nothing is moved by an impulse, or there are no such impulses.
    pub fn reflect(&mut self, hit: &[(usize, f64)], standing: &[usize], y: &mut [f64]) -> Result<(), Halt> {
        let n = self.order();
        let mut impact = self.impact(hit, standing);
        for (i, stop) in impact.stops.iter().enumerate() {
            impact.before[i] = self.rate(*stop, y).0;
        }
        let count = impact.stops.len();
        let compliance = (0..count).map(|i| impact.change(i, i));
        if compliance.into_iter().any(|own| own.is_nan() || own <= 0.0) {
            return Err(Halt::NoInertia);
        }
        // those that are hit first, then with more and more of the others
        let mut parts: Vec<usize> = if count <= MOST { (1..1_usize << count).collect() } else { Vec::new() };
        let all_hit = (1_usize << hit.len()) - 1;
        parts.sort_by_key(|part| ((part & all_hit) != all_hit, part.count_ones()));
        let list = |part: &usize| (0..count).filter(|i| part >> i & 1 == 1).collect::<Vec<_>>();
        let found = parts.iter().find_map(|part| impact.impulses(&list(part)));
        let Some(impulses) = found else { return Err(Halt::StopsAtOnce { stops: impact.stops }) };
        for (i, impulse) in impulses.iter().enumerate() {
            for (rate, each) in y[n..2 * n].iter_mut().zip(&impact.each[i]) {
                *rate += each * impulse;
            }
            let after = impact.before[i] + (0..count).map(|j| impact.change(i, j) * impulses[j]).sum::<f64>();
            y[2 * n] += 0.5 * impulse * (impact.before[i] + after);
            let stops = n == 1 && after.abs() <= f64::EPSILON * impact.before[i].abs();
            if stops && self.given_rate(impact.stops[i]) == 0.0 {
                y[1] = 0.0;
            }
        }
        Ok(())
    }

    /// What takes part, where everything was evaluated.
    fn impact(&mut self, hit: &[(usize, f64)], standing: &[usize]) -> Impact {
        let stops: Vec<usize> = hit.iter().map(|(stop, _)| *stop).chain(standing.iter().copied()).collect();
        let slopes: Vec<Vec<f64>> = stops.iter().map(|stop| self.slopes(*stop)).collect();
        let each = slopes.iter().map(|slopes| {
            let mut each = slopes.clone();
            self.reduced.solve(&mut each);
            each
        });
        let each = each.collect();
        let wanted = hit.iter().map(|(_, rate)| *rate).chain(standing.iter().map(|_| 0.0)).collect();
        Impact { before: vec![0.0; stops.len()], stops, slopes, each, wanted }
    }
}
