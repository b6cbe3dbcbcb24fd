//! Transmissions that rest by their losses: what holds their first side acts back on its carrier.

use super::Couple;
use crate::course::Derivation;
use crate::document::text;
use crate::motion::of;
use crate::words::FrictionMessage;
use assur_formula::{Name, Unit};
use assur_position::plan::LawSite;
use assur_position::position::Origin;

impl Derivation<'_> {
    /// Puts what holds these laws on the links.
    pub(super) fn hold_laws(&mut self, laws: &[usize]) {
        for &slot in laws {
            let law = self.scene.model.plan.laws[slot].clone();
            let grip = law.grip.and_then(|grip| self.state().motion.grips.get(grip)).copied();
            let Some(grip) = grip.filter(|grip| grip.sense == 0.0 && grip.effort != 0.0) else { continue };
            let pair = self.scene.mechanism().pair(law.pair).name.clone();
            let turns = matches!(law.terms[0].0, LawSite::Turn(_));
            let (letter, unit) = if turns { ("M", Unit::Torque) } else { ("F", Unit::Force) };
            let name = Name::new(letter, &format!("f{pair}"));
            self.say(FrictionMessage::PairHeld, &[vec![text(pair)], of(&name)]);
            let effort = self.given(name.clone(), grip.effort, unit);
            for (term, sign) in [(0, 1), (2, -1)] {
                let value = if sign > 0 { effort.clone() } else { -effort.clone() };
                match law.terms.get(term) {
                    Some((LawSite::Turn(body), _)) if *body != 0 => {
                        self.free.couples[*body].push(Couple { value, from: Some(Origin::Law(slot)) });
                    }
                    Some((LawSite::Slide(guide), _)) => self.along_slide(slot, &name, guide, &value),
                    _ => {}
                }
            }
        }
    }
}
