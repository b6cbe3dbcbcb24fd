//! The torque that a flywheel evens out, reduced to its shaft: the power of the effort over the speed of the shaft.

use crate::course::Derivation;
use crate::words::DesignMessage;
use assur_formula::{Expr, Name, Unit};
use assur_model::model::{Flywheel, FlywheelPart, FlywheelTorque, Query, Value};
use assur_model::structure::{EffortKind, EffortSource};
use assur_position::position::Origin;

impl Derivation<'_> {
    /// The reduced torque of a flywheel at this position.
    pub(crate) fn reduced_torque(&mut self, which: usize) {
        let mechanism = self.scene.mechanism();
        let Some(wheel) = mechanism.flywheels.get(which) else { return };
        let Value::Scalar(torque) = self.scene.view().query(&Query::Flywheel(which, FlywheelPart::Torque))
        else {
            return;
        };
        let solution = self.scene.solution;
        let work = solution.statics.flywheels.get(which).map_or(0.0, |found| found.fluctuation);
        if torque.abs() <= super::NOTHING * work {
            return;
        }
        let several =
            if mechanism.flywheels.len() > 1 { format!("r,{}", wheel.name) } else { "r".to_owned() };
        let Some(right) = self.evened(wheel).filter(|right| !right.is_zero()) else {
            return;
        };
        self.say(DesignMessage::ReducedTorque, &[]);
        self.equate(Name::new("M", &several), torque, Unit::Torque, right);
    }

    fn evened(&mut self, wheel: &Flywheel) -> Option<Expr> {
        let ratio = if wheel.ratio == 1.0 {
            Expr::Int(1)
        } else {
            self.given(Name::new("i", &wheel.name), wheel.ratio, Unit::One)
        };
        let efforts = &self.structure().efforts;
        let evened: Vec<usize> = match wheel.torque {
            Some(FlywheelTorque::Load(id)) => {
                let power = self.power_from(Origin::Load(id));
                return self.over_speed(power, ratio, wheel);
            }
            Some(FlywheelTorque::Balance(id)) => {
                (0..efforts.len()).filter(|slot| efforts[*slot].source == EffortSource::Balance(id)).collect()
            }
            None => (0..efforts.len()).collect(),
        };
        let on_shaft = |slot: &usize| {
            let mut places = efforts[*slot].places();
            let own =
                places.all(|kind| matches!(kind, EffortKind::Angle(body) if body.0 == wheel.on.index()));
            own && efforts[*slot].places().count() == 1
        };
        if let [slot] = evened[..]
            && on_shaft(&slot)
        {
            let found = self.found.get(&self.effort_name(slot, false)).cloned()?;
            return Some(found / ratio);
        }
        let mut power = Expr::ZERO;
        for slot in evened {
            power = power + self.power_of_effort(slot)?;
        }
        self.over_speed(power, ratio, wheel)
    }

    fn over_speed(&self, power: Expr, ratio: Expr, wheel: &Flywheel) -> Option<Expr> {
        let speed = self.bodies.get(wheel.on.index())?.as_ref()?.rates[0].clone();
        (!speed.is_zero()).then(|| power / (ratio * speed))
    }
}
