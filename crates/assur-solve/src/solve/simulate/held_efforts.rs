//! What friction, losses and closed stops bear where they hold. What holds alone bears what is left of the loads. Where several share
//! it that depend on each other, a second way to share it tells what is determined: what both ways have.

use super::bearing::{Bearing, Spread};
use super::equations::Equations;
use super::sliding_sense::Slipping;

/// What elements bear on the second way that are left out on the first, of the greatest force.
const PART: f64 = 0.1;

impl Equations<'_, '_> {
    /// What bears the loads where everything was evaluated, as the mechanism as it is written has it.
    pub fn bearing(&self) -> Bearing {
        let motion = &self.trial.motion;
        let grips = if self.slipping.is_none() { &[][..] } else { &motion.grips };
        let grips = self.chart.map_or_else(|| grips.to_vec(), |chart| chart.grips(grips));
        Bearing { stops: motion.stops.clone(), grips, against: motion.against.clone() }
    }

    /// A second way to share what is held, where everything was evaluated at these unknowns; `None` where there is but one.
    pub fn spread(&mut self, at: (f64, &[f64])) -> Spread {
        let own = self.slipping.take()?;
        let held = (0..own.senses.len()).filter(|element| own.holds(*element)).count();
        let spread = (held > own.held.len()).then(|| {
            let mut second = own.clone();
            // what others keep from sliding needs not be at its limit
            second.senses.iter_mut().zip(&own.still).filter(|(_, still)| **still).for_each(|(s, _)| *s = 0.0);
            if second.undetermined {
                // some of those that are held bear all
                second.undetermined = false;
                self.take_independent(&mut second, at, 0);
                // where that fails nothing is known
                self.slipping_accelerations(&mut second).ok();
            }
            let first = (self.trial.clone(), self.evaluated.clone());
            self.lend(&mut second);
            let known = self.slipping_accelerations(&mut second).is_ok();
            self.slipping = Some(second);
            let bearing = self.bearing();
            if !known {
                self.trial.forget_forces();
            }
            let forces = &self.trial.forces;
            let forces = self.chart.map_or_else(|| forces.clone(), |chart| chart.forces(forces));
            (self.trial, self.evaluated) = first;
            Box::new((bearing, forces))
        });
        self.slipping = Some(own);
        spread
    }

    /// Lets those that are held and bear nothing bear something, in no relation to each other.
    fn lend(&self, slipping: &mut Slipping) {
        let borne = slipping.efforts.iter().zip(&slipping.scales).map(|(effort, scale)| effort.abs() / scale);
        let pressed = slipping.pressed.iter().map(|pressed| pressed.abs());
        let force = borne.chain(pressed).fold(self.greatest_force(), f64::max);
        let size = if force > 0.0 { PART * force } else { PART };
        let others =
            (0..slipping.senses.len()).filter(|e| slipping.senses[*e] == 0.0 && !slipping.held.contains(e));
        let efforts = others.zip(2_u32..).map(|(e, k)| (e, size * slipping.scales[e] * f64::from(k).sqrt()));
        slipping.given = efforts.collect();
    }
}
