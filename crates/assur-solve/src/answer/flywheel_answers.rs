//! What is asked of a flywheel.

use super::pose_answers::PoseAnswers;
use crate::model::{Flywheel, FlywheelPart, FlywheelTorque, LinkId, Mechanism, Rim};
use crate::position::BodyState;
use crate::structure::EffortSource;
use std::f64::consts::PI;

impl PoseAnswers<'_> {
    /// Something of a flywheel; NaN where it has none.
    #[must_use]
    pub fn flywheel(&self, which: usize, part: FlywheelPart) -> f64 {
        let Some(wheel) = self.mechanism.flywheels.get(which) else { return f64::NAN };
        let ideal = self.statics.ideal_flywheels.get(which).filter(|_| self.ideal);
        let found = ideal.or_else(|| self.statics.flywheels.get(which));
        let inertia = || found.map_or(f64::NAN, |f| f.inertia);
        let shaft = || wheel.ratio * self.body(wheel.on).omega;
        match part {
            FlywheelPart::Inertia => inertia(),
            FlywheelPart::Fluctuation => found.map_or(f64::NAN, |f| f.fluctuation),
            FlywheelPart::RimWidth => wheel.rim.map_or(f64::NAN, |rim| width(&rim, inertia())),
            FlywheelPart::RimHeight => {
                wheel.rim.map_or(f64::NAN, |rim| rim.height_to_width * width(&rim, inertia()))
            }
            FlywheelPart::RimMass => {
                wheel.rim.map_or(f64::NAN, |rim| 4.0 * inertia() / (rim.diameter * rim.diameter))
            }
            FlywheelPart::Torque => self.evened_power(wheel) / shaft(),
            FlywheelPart::LinksInertia => reduced_inertia(self.mechanism, |link| *self.body(link), shaft()),
            FlywheelPart::Work => {
                let value = self.state.motion.inputs.first().map_or(f64::NAN, |i| i.value);
                found.map_or(f64::NAN, |f| f.work(value))
            }
        }
    }

    /// Power of the effort that a flywheel evens out, W.
    fn evened_power(&self, wheel: &Flywheel) -> f64 {
        match wheel.torque {
            Some(FlywheelTorque::Balance(id)) => self.effort_power(EffortSource::Balance(id)),
            Some(FlywheelTorque::Load(id)) => self.load_power(id.index()),
            None => self.power_of_efforts(),
        }
    }
}

/// Axial width of a rim: all of its mass m = ρ π D b h, h = c b, sits on the diameter D, so that J = m D²/4 and
/// b² = 4 J/(c π D³ ρ); with the weight density γ = ρ g this is the textbooks' b² = 4 g J/(c π D³ γ).
fn width(rim: &Rim, inertia: f64) -> f64 {
    let cube = rim.diameter * rim.diameter * rim.diameter;
    (4.0 * inertia / (rim.height_to_width * PI * cube * rim.density)).sqrt()
}

/// Moment of inertia of all moving links reduced to a link's shaft: Σ (m v² + J ω²)/ω_shaft².
fn reduced_inertia(mechanism: &Mechanism, body: impl Fn(LinkId) -> BodyState, shaft: f64) -> f64 {
    let energies = mechanism.links.iter().enumerate().skip(1).filter_map(|(i, link)| {
        let (mass, body) = (link.mass.as_ref()?, body(LinkId::at(i)));
        let v = body.velocity(mass.centre);
        Some(mass.mass * v.dot(v) + mass.inertia * body.omega * body.omega)
    });
    energies.sum::<f64>() / (shaft * shaft)
}
