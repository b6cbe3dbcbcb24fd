//! How large numbers are in a run: what is zero differs from it by rounding of that.

use super::equations::Equations;
use crate::model::Value;
use crate::plan::LoadStep;

/// Rounding of a number, of its size.
const ROUNDING: f64 = 1e-14;

/// What is large in a run so far.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Sizes {
    /// The extent, m.
    length: f64,
    /// All masses, kg.
    mass: f64,
    /// The greatest angular velocity, or what would make the greatest velocity or acceleration over the extent, rad/s.
    fastest: f64,
}

impl Sizes {
    pub fn new(equations: &Equations<'_, '_>) -> Self {
        let masses = equations.model.plan.loads.iter().map(|load| match load {
            LoadStep::Mass { mass, .. } => *mass,
            _ => 0.0,
        });
        Self { length: equations.extent(), mass: masses.sum(), fastest: 0.0 }
    }

    /// Looks at what the loads of the state that was evaluated last would do, each alone.
    pub fn look_at_loads(&mut self, equations: &Equations<'_, '_>) {
        if self.length == 0.0 {
            *self = Self::new(equations);
        }
        let (length, speed) = (self.length, self.length * self.fastest);
        let known = equations.model.plan.loads.iter().map(|load| match load {
            LoadStep::Mass { weight, .. } => weight.norm(),
            LoadStep::Force { force, .. } => force.norm(),
            LoadStep::Torque { torque, .. } => torque.abs() / length,
            LoadStep::Spring { stiffness, free_length, damping, .. } => {
                stiffness * (length + free_length) + damping.unwrap_or(0.0) * speed
            }
            LoadStep::Evaluated(_) => 0.0,
        });
        let evaluated = equations.evaluated.iter().map(|(_, value)| match value {
            Value::Vector(force) => force.norm(),
            // a torque or a force
            Value::Scalar(effort) => effort.abs().max(effort.abs() / length),
            Value::Bool(_) => 0.0,
        });
        let force = known.sum::<f64>() + evaluated.sum::<f64>();
        let order = equations.order();
        for coordinate in 0..order {
            let mass = equations.reduced.mass()[coordinate * (order + 1)];
            let alone = (0..order).map(|i| if i == coordinate { 1.0 } else { 0.0 });
            let speed = equations.reduced.greatest_speed(length, alone);
            let speeding = force * length * speed * speed / mass;
            if speeding.is_finite() {
                self.fastest = self.fastest.max(speeding.sqrt());
            }
        }
    }

    /// Looks at the state that was evaluated last.
    pub fn look(&mut self, equations: &Equations<'_, '_>) {
        if self.length == 0.0 {
            *self = Self::new(equations);
        }
        for body in &equations.trial.motion.bodies {
            let turning = body.omega.abs().max(body.v.norm() / self.length);
            let speeding = body.alpha.abs().max(body.a.norm() / self.length);
            self.fastest = self.fastest.max(turning).max(speeding.sqrt());
        }
    }

    /// Rounding of a number with these exponents of length, mass and time; nothing where its size is not known.
    pub fn rounding(&self, [length, mass, time]: [i8; 3]) -> f64 {
        let size = power(self.length, length) * power(self.mass, mass) * power(self.fastest, -time);
        if size.is_finite() { ROUNDING * size } else { 0.0 }
    }
}

impl Sizes {
    /// Rounding of the moment of a force.
    pub fn of_force(&self, force: f64) -> f64 {
        ROUNDING * force * self.length
    }
}

fn power(base: f64, exponent: i8) -> f64 {
    let all = (0..exponent.unsigned_abs()).fold(1.0, |product, _| product * base);
    if exponent < 0 { 1.0 / all } else { all }
}
