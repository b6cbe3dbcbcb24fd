//! Normal forces of a body between two guides; how they share the couple is not determined.

use super::sums::axes_of;
use crate::course::Derivation;
use crate::document::text;
use crate::words::Message;
use assur_formula::{Expr, Name, Unit};
use assur_position::plan::Guide;

impl Derivation<'_> {
    pub(super) fn force_translation(&mut self, ways: &[Guide; 2]) {
        let body = ways[0].body;
        self.complete(body);
        let sums = self.sum_of(&[body]);
        let both = [self.way(&ways[0]), self.way(&ways[1])];
        self.say(Message::CouplesOpen, &[]);
        // as the solver has it: both normal forces through the point of the first guide, which takes the whole couple
        let place = self.moved(ways[0].slider).position(ways[0].point);
        let moved = self.moved(body);
        let at = (place - moved.p).turned_back(moved.u);
        let sine = both[1].0.minus(&both[0].0).sin();
        let mut normals = Vec::new();
        for i in 0..2 {
            let other = &both[1 - i].0;
            let loads = other.along(&sums);
            let along = loads.clone() / sine.clone();
            let right = if i == 0 { -along } else { along };
            let value = both[i].1.perp().dot(self.state().forces.reactions[ways[i].slot].force);
            let name = self.reaction_name(ways[i].base, body);
            let at = self.blocks.len();
            let normal = self.equate(name, value, Unit::Force, right);
            let own = normal.clone() * sine.clone();
            let sum = if i == 0 { loads + own } else { loads - own };
            self.balanced(at, &Name::new("ΣF", axes_of(other)[0]), &sum);
            normals.push(normal);
        }
        let moment = self.moment_about(body, at);
        let couple = if moment.is_zero() {
            Expr::ZERO
        } else {
            self.say(Message::CoupleOnFirst, &[vec![text(self.point_name(body, at))]]);
            let name = Name::new("M", &self.reaction_name(ways[0].base, body).sub);
            let reaction = self.state().forces.reactions[ways[0].slot];
            let begun = self.blocks.len();
            let found = self.equate(name, reaction.couple, Unit::Torque, -moment.clone());
            self.balanced(begun, &Name::new("ΣM", &self.point_name(body, at)), &(moment + found.clone()));
            found
        };
        for (i, normal) in normals.iter().enumerate() {
            let couple = if i == 0 { couple.clone() } else { Expr::ZERO };
            self.carry_guide(&ways[i], &both[i].0.clone(), normal, &couple, at);
        }
    }
}
