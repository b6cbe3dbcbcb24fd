//! The equations of Newton and Euler of all bodies at once, with the laws of friction, by Newton's method from the forces
//! of the state.

use super::loads;
use super::motion::Motion;
use super::unknowns::{Kind, Unknown, unknowns};
use crate::math::{Double, Factors, Scalar, V2};
use crate::model::{LoadId, Value};
use crate::plan::{FrictionElement, FrictionLaw};
use crate::position::{Model, Reaction, State, Wrench};

type D = Double;

/// Steps of Newton's method.
const STEPS: usize = 25;
/// Where steps do not come to rest at the last digits, what they may be as a part of the forces.
const RESTLESS: f64 = 1e-18;
/// What bodies may lack of equilibrium, relative to the forces in play.
const BALANCED: f64 = 1e-27;

/// What acts on the bodies.
#[derive(Default)]
pub(super) struct Forces {
    pub applied: Vec<Wrench<D>>,
    pub reactions: Vec<Reaction<D>>,
    pub efforts: Vec<D>,
    pub frictions: Vec<D>,
    pub multipliers: Vec<D>,
    /// Worst equilibrium of a body over the greatest force or moment in play.
    pub equilibrium: f64,
}

/// The linear part of the system, lengths counted in sizes.
struct System<'a> {
    unknowns: Vec<Unknown>,
    elements: &'a [FrictionElement],
    weights: Vec<f64>,
    pin_slots: &'a [(usize, f64)],
    /// First row of each body; `None` of those whose equilibrium is not asked.
    rows: Vec<Option<usize>>,
    count: usize,
    size: D,
}

/// Forces of the position found; `None` where the equations do not determine them.
pub(super) fn forces(
    model: &Model<'_>,
    state: &State,
    motion: &Motion<'_>,
    evaluated: &[(LoadId, Value)],
) -> Option<Forces> {
    let plan = model.plan;
    let applied = loads::applied(model, &motion.bodies, evaluated);
    let mut count = 0;
    let rows = model.structure.replaced.bodies.iter().map(|body| {
        count += if body.known { 0 } else { 3 };
        (!body.known).then(|| count - 3)
    });
    let system = System {
        unknowns: unknowns(model, state, motion)?,
        elements: &plan.friction,
        weights: plan
            .friction
            .iter()
            .zip(&state.forces.senses)
            .map(|(e, sense)| sense * e.kind.factor())
            .collect(),
        pin_slots: &plan.pin_slots,
        rows: rows.collect(),
        count,
        size: D::of(motion.size),
    };
    if system.unknowns.len() != system.count + system.elements.len() {
        return None;
    }
    let values = system.solve(&applied, system.start(state))?;
    let mut forces = system.kept(model, &values);
    forces.equilibrium = system.equilibrium(&applied, &values);
    let turned =
        forces.multipliers.iter().zip(&state.forces.law_forces).zip(&plan.laws).any(|((x, law), planned)| {
            planned.meeting.is_some_and(|m| m.tangent != 0.0) && x.high * law.multiplier < 0.0
        });
    forces.applied = applied;
    (!turned && forces.equilibrium <= BALANCED).then_some(forces)
}

impl System<'_> {
    /// The forces of the state.
    fn start(&self, state: &State) -> Vec<D> {
        let of = |unknown: &Unknown| match unknown.kind {
            Kind::Force(slot, along) => along.dot(V2::of(state.forces.reactions[slot].force)),
            Kind::Couple(slot) => D::of(state.forces.reactions[slot].couple) / self.size,
            Kind::Effort(slot) => D::of(state.forces.efforts[slot]),
            Kind::Multiplier(slot) => D::of(state.forces.law_forces[slot].multiplier),
            Kind::Friction(index) => D::of(state.forces.frictions[index]),
            Kind::Passive => D::zero(),
        };
        self.unknowns.iter().map(of).collect()
    }

    /// What a value is multiplied by: couples are counted as forces at the distance of the size.
    fn scale(&self, kind: Kind) -> D {
        if matches!(kind, Kind::Couple(_)) { self.size } else { D::one() }
    }

    /// Coefficients of the equations of equilibrium.
    fn equilibria(&self) -> Vec<Vec<D>> {
        let mut matrix = vec![vec![D::zero(); self.unknowns.len()]; self.count];
        for (column, unknown) in self.unknowns.iter().enumerate() {
            let scale = self.scale(unknown.kind);
            for &(body, force, moment) in &unknown.on {
                let Some(row) = self.rows[body] else { continue };
                for (i, x) in [force.x, force.y, moment / self.size].into_iter().enumerate() {
                    matrix[row + i][column] = matrix[row + i][column] + x * scale;
                }
            }
        }
        matrix
    }

    fn solve(&self, applied: &[Wrench<D>], mut values: Vec<D>) -> Option<Vec<D>> {
        let equilibria = self.equilibria();
        let mut factors = None;
        let mut last = f64::INFINITY;
        for _ in 0..STEPS {
            let mut matrix = equilibria.clone();
            let mut left: Vec<D> = equilibria.iter().map(|row| sum(row, &values)).collect();
            for (row, wrench) in self.rows.iter().zip(applied) {
                let Some(row) = *row else { continue };
                for (i, x) in
                    [wrench.force.x, wrench.force.y, wrench.moment / self.size].into_iter().enumerate()
                {
                    left[row + i] = left[row + i] + x;
                }
            }
            for index in 0..self.elements.len() {
                let (row, value) = self.law(index, &values);
                matrix.push(row);
                left.push(value);
            }
            if factors.is_none() || !self.elements.is_empty() {
                factors = Some(Factors::new(matrix)?);
            }
            let step = factors.as_ref()?.solve(&left);
            let most = step.iter().fold(0.0, |most: f64, x| most.max(x.high.abs()));
            let scale = values.iter().fold(f64::MIN_POSITIVE, |most: f64, x| most.max(x.high.abs()));
            if !most.is_finite() {
                return None;
            }
            values.iter_mut().zip(&step).for_each(|(x, dx)| *x = *x - *dx);
            if most <= RESTLESS * scale && most >= 0.5 * last || most == 0.0 {
                return Some(values);
            }
            last = most;
        }
        None
    }

    /// φ + w |λ| = 0 of an element: its gradient and what its left side is.
    fn law(&self, index: usize, values: &[D]) -> (Vec<D>, D) {
        let element = &self.elements[index];
        let weight = D::of(self.weights[index]);
        let mut row = vec![D::zero(); self.unknowns.len()];
        let mut left = D::zero();
        for (column, unknown) in self.unknowns.iter().enumerate() {
            if unknown.kind == Kind::Friction(index) {
                row[column] = row[column] + D::one();
                left = left + values[column];
            }
        }
        for measure in self.measures(element) {
            // each measure is a vector linear in the unknowns; its magnitude grows along itself
            let now = measure.iter().fold(V2::zero(), |sum, (column, v)| sum + *v * values[*column]);
            let size = now.norm();
            left = left + weight * size;
            if size.high > 0.0 {
                for (column, v) in measure {
                    row[column] = row[column] + weight * v.dot(now) / size;
                }
            }
        }
        (row, left)
    }

    /// The vectors whose magnitudes an element's law adds up, by column.
    fn measures(&self, element: &FrictionElement) -> Vec<Vec<(usize, V2<D>)>> {
        let force = |slot: usize, sign: f64| {
            self.unknowns.iter().enumerate().filter_map(move |(column, unknown)| match unknown.kind {
                Kind::Force(s, along) if s == slot => Some((column, along * D::of(sign))),
                _ => None,
            })
        };
        if let Some((from, to)) = element.pin {
            return vec![
                self.pin_slots[from..to].iter().flat_map(|(slot, sign)| force(*slot, *sign)).collect(),
            ];
        }
        let FrictionLaw::BothEnds { contacts: [a, b], .. } = element.kind else {
            return vec![force(element.slot, 1.0).collect()];
        };
        // N₁ (a − b) = M − N b and N₂ (a − b) = N a − M, N along the unit normal of the guide
        let (a, b) = (D::of(a), D::of(b));
        let end = |of_normal: D, of_couple: D| {
            let part = |(column, unknown): (usize, &Unknown)| {
                let x = match unknown.kind {
                    Kind::Force(slot, _) if slot == element.slot => of_normal,
                    Kind::Couple(slot) if slot == element.slot => of_couple * self.size,
                    _ => return None,
                };
                Some((column, V2::new(x / (a - b), D::zero())))
            };
            self.unknowns.iter().enumerate().filter_map(part).collect()
        };
        vec![end(-b, D::one()), end(a, -D::one())]
    }

    /// Worst lack of equilibrium over the greatest force, or moment, in play.
    fn equilibrium(&self, applied: &[Wrench<D>], values: &[D]) -> f64 {
        let mut sums = applied.to_vec();
        let (mut force, mut moment) = (f64::MIN_POSITIVE, f64::MIN_POSITIVE);
        let mut count = |f: V2<D>, m: D| {
            force = force.max(f.norm().high);
            moment = moment.max(m.high.abs());
        };
        applied.iter().for_each(|w| count(w.force, w.moment));
        for (unknown, value) in self.unknowns.iter().zip(values) {
            let value = *value * self.scale(unknown.kind);
            for &(body, f, m) in &unknown.on {
                let sum = &mut sums[body];
                sum.force += f * value;
                sum.moment = sum.moment + m * value;
                count(f * value, m * value);
            }
        }
        let asked = sums.iter().zip(&self.rows).filter(|(_, row)| row.is_some());
        asked.fold(0.0, |worst: f64, (sum, _)| {
            worst.max(sum.force.norm().high / force).max(sum.moment.high.abs() / moment)
        })
    }

    fn kept(&self, model: &Model<'_>, values: &[D]) -> Forces {
        let plan = model.plan;
        let mut forces = Forces {
            reactions: vec![Reaction::default(); plan.reactions.len()],
            efforts: vec![D::zero(); plan.efforts],
            frictions: vec![D::zero(); plan.friction.len()],
            multipliers: vec![D::zero(); plan.laws.len()],
            ..Forces::default()
        };
        for (unknown, value) in self.unknowns.iter().zip(values) {
            let value = *value * self.scale(unknown.kind);
            match unknown.kind {
                Kind::Force(slot, along) => forces.reactions[slot].force += along * value,
                Kind::Couple(slot) => forces.reactions[slot].couple = value,
                Kind::Effort(slot) => forces.efforts[slot] = value,
                Kind::Multiplier(slot) => forces.multipliers[slot] = value,
                Kind::Friction(index) => forces.frictions[index] = value,
                Kind::Passive => {}
            }
        }
        forces
    }
}

fn sum(row: &[D], values: &[D]) -> D {
    let terms = row.iter().zip(values).filter(|(a, _)| a.high != 0.0);
    terms.fold(D::zero(), |sum, (a, x)| sum + *a * *x)
}
