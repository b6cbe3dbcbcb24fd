//! Impulses of an impact, of everything that touches at once.
//!
//! With the slopes u = ∂g/∂q of a coordinate g that hits its stop an impulse P along it changes the rates by M⁻¹ u P. Of what is hit
//! the rate becomes −e times what it was (Newton), and what else is closed is not passed:
//!
//! ```text
//! q̇⁺ = q̇⁻ + M⁻¹(UᵀP + WᵀT),   ġ⁺ ≥ wanted,  P ≥ 0,  one of the two equal,   T ∈ −f P Sign(W q̇⁺),
//! ```
//!
//! the last of contacts with friction, whose profiles slide with W q̇ (J. J. Moreau, Unilateral contact and dry friction in finite
//! freedom dynamics, 1988). Friction of pairs that cannot part does not act in an impact.

use super::dissipative::DissipativeElement;
use super::equations::Equations;
use super::stop::ROUNDING;
use crate::math::Lu;
use crate::plan::FrictionElement;
use crate::solve::failure::Halt;

/// So many stops at most take part in an impact.
const MOST: usize = 8;

/// Impulses by stop, N s or N m s.
pub(super) type Impulses = Vec<(usize, f64)>;

/// What an impulse acts along: the coordinate of a stop, or the tangent of its contact.
struct Row {
    slopes: Vec<f64>,
    /// M⁻¹ of them.
    column: Vec<f64>,
    /// Its rate before.
    before: f64,
}

/// What takes part in an impact.
struct Impact {
    stops: Vec<usize>,
    normals: Vec<Row>,
    wanted: Vec<f64>,
    /// Of contacts with friction: their tangents with the coefficient, and the place of the stop.
    tangents: Vec<(Row, f64, usize)>,
}

/// What the tangent of a contact does in an impact: sticks, or slides in a sense.
type Slide = f64;

impl Impact {
    fn rows(&self) -> impl Iterator<Item = &Row> {
        self.normals.iter().chain(self.tangents.iter().map(|tangent| &tangent.0))
    }

    /// The impulses of all rows, if those of a part of the stops are all there are, and contacts slide so.
    fn impulses(&self, part: &[usize], slides: &[Slide]) -> Option<Vec<f64>> {
        let rows: Vec<&Row> = self.rows().collect();
        let count = self.normals.len();
        let acts = |k: usize| part.contains(&self.tangents[k].2);
        let sticks = (0..slides.len()).filter(|&k| slides[k] == 0.0 && acts(k)).map(|k| count + k);
        let unknown: Vec<usize> = part.iter().copied().chain(sticks).collect();
        // what slides acts with its normal impulse
        let along = |by: usize| {
            let mut column = rows[by].column.clone();
            for (k, (tangent, friction, stop)) in self.tangents.iter().enumerate() {
                if *stop == by && slides[k] != 0.0 {
                    let part = -slides[k] * friction;
                    column.iter_mut().zip(&tangent.column).for_each(|(c, t)| *c += part * t);
                }
            }
            column
        };
        let columns: Vec<Vec<f64>> = unknown.iter().map(|&by| along(by)).collect();
        let wanted = |of: usize| if of < count { self.wanted[of] } else { 0.0 };
        let mut factors = Lu::new(unknown.len());
        let mut found: Vec<f64> = unknown.iter().map(|&of| wanted(of) - rows[of].before).collect();
        for (row, &of) in unknown.iter().enumerate() {
            for (column, by) in columns.iter().enumerate() {
                *factors.at_mut(row, column) = dot(&rows[of].slopes, by);
            }
        }
        if !factors.factor() {
            return None;
        }
        factors.solve(&mut found);
        let mut impulses = vec![0.0; rows.len()];
        unknown.iter().zip(&found).for_each(|(&i, impulse)| impulses[i] = *impulse);
        for (k, (_, friction, stop)) in self.tangents.iter().enumerate() {
            if slides[k] != 0.0 && acts(k) {
                impulses[count + k] = -slides[k] * friction * impulses[*stop];
            }
        }
        self.fits(&impulses, slides).then_some(impulses)
    }

    /// Whether nothing pulls or is passed, what sticks does so by its friction, and what slides does so in its sense.
    fn fits(&self, impulses: &[f64], slides: &[Slide]) -> bool {
        let count = self.normals.len();
        let after = |row: &Row| {
            let terms = self.rows().zip(impulses).map(|(by, impulse)| dot(&row.slopes, &by.column) * impulse);
            terms.fold((row.before, row.before.abs()), |(s, m), x| (s + x, m.max(x.abs())))
        };
        let normals = self.normals.iter().enumerate().all(|(i, row)| {
            let (rate, greatest) = after(row);
            impulses[i] >= 0.0 && rate - self.wanted[i] >= -ROUNDING * greatest
        });
        let tangents = self.tangents.iter().enumerate().all(|(k, (row, friction, stop))| {
            let (rate, greatest) = after(row);
            match slides[k] {
                0.0 => impulses[count + k].abs() <= friction * impulses[*stop] * (1.0 + ROUNDING),
                sense => sense * rate >= -ROUNDING * greatest,
            }
        });
        normals && tangents
    }

    /// The ways in which tangents may slide: all of them stick, go on, turn.
    fn ways(&self) -> Vec<Vec<Slide>> {
        let mut all = vec![Vec::new()];
        for (row, ..) in &self.tangents {
            let on = if row.before < 0.0 { -1.0 } else { 1.0 };
            let next = |way: &Vec<Slide>| [0.0, on, -on].map(|s| way.iter().copied().chain([s]).collect());
            all = all.iter().flat_map(next).collect();
        }
        all
    }
}

impl Equations<'_, '_> {
    /// Changes the rates so that stops that are hit have these rates, and closed ones that stand are not passed; the unknown work loses
    /// what the impact takes. Returns the impulses by stop, N s or N m s.
    ///
    /// # Errors
    /// Nothing is moved by an impulse, or there are no such impulses.
    pub fn reflect(
        &mut self,
        hit: &[(usize, f64)],
        standing: &[usize],
        y: &mut [f64],
    ) -> Result<Impulses, Halt> {
        let n = self.order();
        let impact = self.impact(hit, standing, y);
        let count = impact.stops.len();
        let compliance = impact.normals.iter().map(|row| dot(&row.slopes, &row.column));
        if compliance.into_iter().any(|own| own.is_nan() || own <= 0.0) {
            return Err(Halt::NoInertia);
        }
        // those that are hit first, then with more and more of the others
        let mut parts: Vec<usize> = if count <= MOST { (1..1_usize << count).collect() } else { Vec::new() };
        let all_hit = (1_usize << hit.len()) - 1;
        parts.sort_by_key(|part| ((part & all_hit) != all_hit, part.count_ones()));
        let list = |part: &usize| (0..count).filter(|i| part >> i & 1 == 1).collect::<Vec<_>>();
        let ways = impact.ways();
        let found = parts.iter().find_map(|part| {
            let part = list(part);
            ways.iter().find_map(|way| impact.impulses(&part, way))
        });
        let Some(impulses) = found else { return Err(Halt::StopsAtOnce { stops: impact.stops }) };
        for (row, impulse) in impact.rows().zip(&impulses) {
            y[n..2 * n].iter_mut().zip(&row.column).for_each(|(rate, c)| *rate += c * impulse);
            let changes = impact.rows().zip(&impulses).map(|(by, p)| dot(&row.slopes, &by.column) * p);
            let after = row.before + changes.sum::<f64>();
            y[2 * n] += 0.5 * impulse * (row.before + after);
        }
        if let ([row], [stop], 1) = (&impact.normals[..], &impact.stops[..], n) {
            let after = row.before + dot(&row.slopes, &row.column) * impulses[0];
            if after.abs() <= f64::EPSILON * row.before.abs() && self.given_rate(*stop) == 0.0 {
                y[1] = 0.0;
            }
        }
        Ok(impact.stops.into_iter().zip(impulses).collect())
    }

    /// What takes part, where everything was evaluated.
    fn impact(&mut self, hit: &[(usize, f64)], standing: &[usize], y: &[f64]) -> Impact {
        let stops: Vec<usize> = hit.iter().map(|(stop, _)| *stop).chain(standing.iter().copied()).collect();
        let mut normals = Vec::with_capacity(stops.len());
        let mut tangents = Vec::new();
        for (place, &stop) in stops.iter().enumerate() {
            let before = self.rate(stop, y).0;
            let slopes = self.slopes(stop);
            normals.push(self.row(slopes, before));
            let plan = self.model.plan;
            let own = |element: &FrictionElement| element.stop == Some(stop) && !element.kind.turns();
            if let Some(index) = plan.friction.iter().position(own) {
                let mut slopes = Vec::new();
                self.slopes_of_element(index, &mut slopes);
                let before = DissipativeElement::of(plan, index).speed(&self.trial);
                tangents.push((self.row(slopes, before), plan.friction[index].kind.factor(), place));
            }
        }
        let wanted = hit.iter().map(|(_, rate)| *rate).chain(standing.iter().map(|_| 0.0)).collect();
        Impact { stops, normals, wanted, tangents }
    }

    fn row(&mut self, slopes: Vec<f64>, before: f64) -> Row {
        let mut column = slopes.clone();
        self.reduced.solve(&mut column);
        Row { slopes, column, before }
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
