//! Reactions of a dyad PRP: each slider along its guide gives the inner hinge, then the guides.

use crate::course::Derivation;
use crate::document::text;
use crate::motion::pin;
use crate::words::Message;
use assur_formula::{Expr, Name};
use assur_position::plan::{Guide, Inner};

impl Derivation<'_> {
    pub(super) fn force_prp(&mut self, ways: &[Guide; 2], inner: &Inner) {
        [ways[0].body, ways[1].body].into_iter().for_each(|b| self.complete(b));
        let bodies = [ways[0].body, ways[1].body];
        let pins = [inner.pin, pin(&inner.second_pin)];
        let both = [self.way(&ways[0]), self.way(&ways[1])];
        let sums = [self.sum_of(&bodies[..1]), self.sum_of(&bodies[1..])];
        self.say_once(Message::Determinate);
        let point = self.point_name(bodies[0], pins[0]);
        self.say(Message::EachAlongGuide, &[vec![text(point)]]);
        let (p, q) = (&both[0].0, &both[1].0);
        let sine = q.minus(p).sin();
        // f·d_1 = F_1·d_1, f·d_2 = −F_2·d_2
        let (one, two) = (p.along(&sums[0]), q.along(&sums[1]));
        let of = |n_1: Expr, n_2: Expr| -((two.clone() * n_1 + one.clone() * n_2) / sine.clone());
        let right = [of(-p.sin(), -q.sin()), of(p.cos(), q.cos())];
        let value = self.state().forces.reactions[inner.slot].force * inner.sign;
        let at = self.blocks.len();
        let f = self.reaction(bodies[0], bodies[1], value, right);
        for (i, sum) in [(1, two + q.along(&f)), (0, one - p.along(&f))] {
            let label = self.label(bodies[i]);
            self.balanced(at, &Name::new("ΣF", &format!("∥{label}")), &sum);
        }
        let name = self.reaction_name(bodies[0], bodies[1]);
        self.free.reactions[inner.slot] = Some(name);
        for (i, sign) in [(0, 1), (1, -1)] {
            self.say(Message::SumAcrossGuide, &[]);
            let across = both[i].0.across(&f);
            let loads = both[i].0.across(&sums[i]);
            let right = if sign > 0 { across - loads } else { -(across + loads) };
            let (normal, couple) = self.guide_reaction(&ways[i], right, both[i].1, pins[i]);
            self.carry_guide(&ways[i], &both[i].0.clone(), &normal, &couple, pins[i]);
        }
    }
}
