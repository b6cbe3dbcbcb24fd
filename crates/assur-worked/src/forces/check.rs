//! The check by virtual power, and the residuals.

use super::is_load;
use crate::course::Derivation;
use crate::document::text;
use crate::words::Message;
use assur_formula::{Expr, Name, Unit};
use assur_model::structure::EffortKind;
use assur_position::position::Origin;

impl Derivation<'_> {
    /// ΣP = 0: all loads, inertia forces and efforts with the velocities of their points. Whether there is such a sum.
    pub fn check(&mut self) -> bool {
        let power = self.power();
        let checked = power.is_some();
        if let Some(sum) = power {
            self.say(Message::VirtualPower, &[]);
            let scale = sum.scale();
            if sum.value().abs() <= 1e-7 * scale {
                self.equate(Name::new("ΣP", ""), 0.0, Unit::Power, sum);
            } else {
                self.say(Message::PowerOpen, &[]);
            }
        }
        let residuals = self.scene.solved.residuals;
        let figure = |x: Option<f64>| match x {
            None => vec![text("–")],
            Some(x) => {
                vec![text(if x == 0.0 { "0".to_owned() } else { assur_formula::with_digits(x, 2).text() })]
            }
        };
        let condition = vec![text(assur_formula::with_digits(self.scene.solved.condition, 3).text())];
        let parts = [
            figure(Some(residuals.closure)),
            figure(residuals.equilibrium),
            figure(residuals.power),
            condition,
        ];
        self.say(Message::Residuals, &parts);
        checked
    }

    /// The sum of the powers; none where a power is not derived here.
    fn power(&mut self) -> Option<Expr> {
        let level = self.scene.model.plan.effects.level;
        if level < assur_model::model::Level::Velocities
            || self.counts.forces[1] + self.counts.held > 0
            || self.counts.loads[1] > 0
        {
            return None;
        }
        let mut terms = Vec::new();
        for slot in 0..self.structure().efforts.len() {
            terms.push(self.power_of_effort(slot)?);
        }
        terms.extend(self.powers_on(&self.moving(), |from| is_load(from, true)));
        terms.extend(self.lost.iter().map(|p| -p.clone()));
        let sum = Expr::sum(terms);
        (!sum.is_zero()).then_some(sum)
    }

    /// The powers of what acts on some bodies, as far as it comes from what is wanted.
    pub(crate) fn powers_on(
        &mut self,
        bodies: &[usize],
        wanted: impl Fn(Option<Origin>) -> bool,
    ) -> Vec<Expr> {
        let mut terms = Vec::new();
        for &body in bodies {
            for force in self.free.forces[body].clone().into_iter().filter(|f| wanted(f.from)) {
                let [vx, vy] = self.velocity(body, force.at);
                let [fx, fy] = force.parts;
                terms.push(fx * vx + fy * vy);
            }
            let omega = self.bodies[body].as_ref().map_or(Expr::ZERO, |b| b.rates[0].clone());
            let couples = self.free.couples[body].iter().filter(|c| wanted(c.from));
            terms.extend(couples.map(|c| c.value.clone() * omega.clone()));
        }
        terms
    }

    /// All bodies that move.
    pub(crate) fn moving(&self) -> Vec<usize> {
        (1..self.bodies.len()).collect()
    }

    pub(super) fn power_of_effort(&mut self, slot: usize) -> Option<Expr> {
        let is_force = self.is_force(slot);
        let value = self.found.get(&self.effort_name(slot, is_force)).cloned().unwrap_or(Expr::ZERO);
        self.power_of(slot, value)
    }

    /// The power of a value of an effort.
    pub(crate) fn power_of(&mut self, slot: usize, value: Expr) -> Option<Expr> {
        let places: Vec<EffortKind> = self.structure().efforts[slot].places().collect();
        let mut sum = Expr::ZERO;
        for kind in places {
            sum = sum + value.clone() * self.rate_of_effort(slot, kind)?;
        }
        Some(sum)
    }

    /// The rate that belongs to an effort at one of its places.
    pub(super) fn rate_of_effort(&mut self, slot: usize, kind: EffortKind) -> Option<Expr> {
        let rate = |course: &Self, body: usize| {
            course.bodies[body].as_ref().map_or(Expr::ZERO, |b| b.rates[0].clone())
        };
        match kind {
            EffortKind::Angle(body) => Some(rate(self, body.0)),
            EffortKind::RelativeAngle { first, second, .. } => {
                Some(rate(self, second.0) - rate(self, first.0))
            }
            EffortKind::Line(body) => {
                let (at, angle, _) = self.line_of_effort(slot, body.0);
                let v = self.velocity(body.0, at);
                Some(angle.along(&v))
            }
            EffortKind::Coordinate(joint) => {
                let (slider, point, guide, angle) = self.guide_of_coordinate(joint)?;
                let [vx, vy] = self.velocity(slider.0, point);
                let moved = self.moved(guide.0);
                let at = (self.moved(slider.0).position(point) - moved.p).turned_back(moved.u);
                let [wx, wy] =
                    if guide.0 == 0 { [Expr::ZERO, Expr::ZERO] } else { self.velocity(guide.0, at) };
                Some(angle.along(&[vx - wx, vy - wy]))
            }
            EffortKind::Point(_) | EffortKind::Place(..) => None,
        }
    }

    /// Whether an effort is a force, and not a torque.
    pub(crate) fn is_force(&self, slot: usize) -> bool {
        matches!(self.structure().efforts[slot].kind, EffortKind::Line(_) | EffortKind::Coordinate(_))
    }
}
