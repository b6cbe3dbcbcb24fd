//! The iteration of friction as the solver took it; what friction takes: power pair by pair, efficiency, verdict.

use super::is_load;
use crate::course::Derivation;
use crate::document::{Inline, Line, Table, text};
use crate::words::{FrictionMessage, Message};
use assur_formula::{Expr, Name, Unit, name_node, with_digits};
use assur_model::model::{FindKind, Level, Query, Value};
use assur_model::structure::{BodyId, BodyRate};
use assur_position::plan::{FrictionElement, FrictionLaw};

/// The most pairs of which a table has what presses and the friction.
const WIDE: usize = 4;
/// The last step and the values of the solver are one.
const SAME: f64 = 1e-7;

impl Derivation<'_> {
    /// The steps of the solver's iteration: what presses in every pair, its friction, the greatest change.
    pub(super) fn iteration(&mut self, elements: &[(usize, FrictionElement)], steps: &[Vec<f64>]) {
        if steps.len() < 2 {
            return;
        }
        let senses = &self.state().forces.senses;
        let moving: Vec<usize> = (0..elements.len()).filter(|i| senses[elements[*i].0] != 0.0).collect();
        self.say_once(FrictionMessage::FrictionSteps);
        self.table(self.table_of_steps(elements, &moving, steps));
        let last = |i: &usize| {
            let (slot, element) = &elements[*i];
            let (own, found) =
                (element.kind.factor() * steps[steps.len() - 1][*i], self.state().forces.frictions[*slot]);
            (own - found.abs()).abs() <= SAME * own.max(found.abs())
        };
        if !moving.iter().all(last) {
            self.say(FrictionMessage::FrictionSearched, &[]);
        }
    }

    fn table_of_steps(
        &self,
        elements: &[(usize, FrictionElement)],
        moving: &[usize],
        steps: &[Vec<f64>],
    ) -> Table {
        // of many pairs what presses is enough
        let both = moving.len() <= WIDE;
        let mut headers: Vec<Line> = vec![vec![text(self.words(Message::Step))]];
        for &i in moving {
            let element = &elements[i].1;
            let unit = if element.kind.turns() { "N·m" } else { "N" };
            headers.push(vec![Inline::Math(name_node(&self.presses_name(element))), text(", N")]);
            if both {
                let friction = name_node(&self.friction_name(element));
                headers.push(vec![Inline::Math(friction), text(format!(", {unit}"))]);
            }
        }
        headers.push(vec![text(self.words(FrictionMessage::Change))]);
        let figure = |x: f64| vec![text(with_digits(x, 6).text())];
        let mut rows = Vec::new();
        for (k, step) in steps.iter().enumerate() {
            let mut row = vec![vec![text(k.to_string())]];
            for &i in moving {
                let (slot, element) = &elements[i];
                row.push(figure(step[i]));
                if both {
                    let sense = self.state().forces.senses[*slot];
                    row.push(figure(-sense * element.kind.factor() * step[i]));
                }
            }
            let most = moving.iter().map(|i| step[*i]).fold(0.0, f64::max);
            let change = k.checked_sub(1).map(|before| {
                let moved = moving.iter().map(|i| (step[*i] - steps[before][*i]).abs()).fold(0.0, f64::max);
                if most > 0.0 { moved / most } else { 0.0 }
            });
            row.push(vec![text(change.map_or("–".to_owned(), |c| with_digits(c, 2).text()))]);
            rows.push(row);
        }
        let numbers = (0..headers.len()).collect();
        Table { headers, rows, numbers }
    }

    /// The letters of what presses in a pair.
    fn presses_name(&self, element: &FrictionElement) -> Name {
        match element.kind {
            FrictionLaw::BothEnds { .. } => Name::new("N", &self.scene.mechanism().pair(element.pair).name),
            _ => self.reaction_name(element.base, element.body),
        }
    }

    /// The power lost in every pair and in all, the efficiency, and what follows.
    pub fn friction_balance(&mut self) {
        let lossy = self.state().forces.law_forces.iter().any(|law| law.sides != [1.0, 1.0]);
        if !self.scene.model.plan.effects.friction && !lossy {
            let moves = self.scene.model.plan.effects.level >= Level::Velocities;
            if moves && !self.scene.model.plan.laws.is_empty() {
                let before = self.blocks.len();
                let heading = self.words(Message::Powers);
                self.heading(3, heading);
                self.say(Message::TrainPowers, &[]);
                let said = self.blocks.len();
                self.lost_in_trains();
                if self.blocks.len() == said {
                    self.blocks.truncate(before);
                }
            }
            return;
        }
        let before = self.blocks.len();
        let heading = self.words(FrictionMessage::Losses);
        self.heading(3, heading);
        let mut sum = Vec::new();
        if lossy {
            self.say(Message::TrainPowers, &[]);
            sum = self.lost_in_trains();
            self.lost.clone_from(&sum);
        }
        if self.scene.model.plan.effects.friction {
            self.say(FrictionMessage::PairsLose, &[]);
        }
        let said = self.blocks.len();
        for (slot, element) in self.scene.model.plan.friction.iter().enumerate() {
            let found = self.rubbing.iter().find(|r| r.0 == slot).cloned();
            let speed = self.state().sliding_speed(element);
            if self.state().forces.senses[slot] == 0.0 {
                continue;
            }
            let value = -self.state().forces.frictions[slot] * speed;
            let name = Name::new("P", &self.friction_name(element).sub);
            sum.push(match found {
                Some((_, effort, rate)) => self.equate(name, value, Unit::Power, -(effort * rate)),
                None => self.stated(name, value, Unit::Power),
            });
        }
        let right = Expr::sum(sum);
        if matches!(right, Expr::Sum(_)) {
            let lost = right.value();
            self.equate(Name::new("P", "L"), lost, Unit::Power, right);
        }
        self.efficiency();
        self.criticals();
        if self.blocks.len() == said && !lossy {
            // nothing moves
            self.blocks.truncate(before);
        }
    }

    /// η from the powers of the efforts with and without friction.
    fn efficiency(&mut self) {
        let view = self.scene.view();
        let value = view.efficiency();
        if view.overcomes_friction_alone() {
            self.say(FrictionMessage::OnlyFriction, &[]);
            return;
        }
        // without an effort there is nothing to compare
        if (0..self.structure().efforts.len()).any(|slot| self.has_no_effort(slot)) {
            return;
        }
        let ideal = view.without_friction();
        let (mut with, mut without) = (Vec::new(), Vec::new());
        for slot in 0..self.structure().efforts.len() {
            let force = self.is_force(slot);
            let name = self.effort_name(slot, force);
            let now = self.found.get(&name).cloned();
            let index = if name.sub.is_empty() { "0".to_owned() } else { format!("{},0", name.sub) };
            let first = Name::new(&name.letter, &index);
            let unit = if force { Unit::Force } else { Unit::Torque };
            let Some(now) = now else { return };
            if slot == 0 {
                self.say(FrictionMessage::WithoutFriction, &[]);
            }
            let alone = self.ideal_effort(slot, &first, unit);
            let ideal = ideal.state.forces.efforts[slot];
            let first = alone.unwrap_or_else(|| self.stated(first, ideal, unit));
            let (Some(now), Some(first)) = (self.power_of(slot, now), self.power_of(slot, first)) else {
                return;
            };
            with.push(now);
            without.push(first);
        }
        let (with, without) = (Expr::sum(with), Expr::sum(without));
        if with.is_zero() || without.is_zero() || !value.is_finite() {
            return;
        }
        let p = self.equate(self.power_letters(""), view.power_of_efforts(), Unit::Power, with);
        let p_0 = self.equate(self.power_letters("0"), ideal.power_of_efforts(), Unit::Power, without);
        let drives = p_0.value() > 0.0;
        self.say(if drives { FrictionMessage::EffortsDrive } else { FrictionMessage::EffortsResist }, &[]);
        self.equate(Name::new("η", ""), value, Unit::One, if drives { p_0 / p } else { p / p_0 });
        self.say(if value > 0.0 { FrictionMessage::NotLocked } else { FrictionMessage::LocksItself }, &[]);
    }

    /// The letters of the power of the efforts; an effort may be called P.
    fn power_letters(&self, index: &str) -> Name {
        let efforts = 0..self.structure().efforts.len();
        let mut names = efforts.map(|slot| self.effort_name(slot, self.is_force(slot)));
        if names.any(|name| name == Name::new("P", "")) {
            Name::new("P", format!("Σ,{index}").trim_end_matches(','))
        } else {
            Name::new("P", index)
        }
    }

    /// An effort without friction, by the power of the loads on the links that hang together with it; none where another effort acts
    /// on them.
    fn ideal_effort(&mut self, slot: usize, name: &Name, unit: Unit) -> Option<Expr> {
        let effort = self.scene.view().without_friction().state.forces.efforts[slot];
        if self.counts.forces[1] + self.counts.held + self.counts.loads[1] > 0 {
            return None;
        }
        let several = self.structure().efforts.len() > 1;
        let chain = self.chain_of_effort(slot)?;
        let rate = self.power_of(slot, Expr::Int(1))?;
        let right = -Expr::sum(self.powers_on(&chain, |from| is_load(from, false)));
        let power = effort * rate.value();
        let near = |x: f64, y: f64| (x - y).abs() <= SAME * right.scale().max(y.abs());
        if rate.is_zero() || right.is_zero() || !near(right.value(), power) {
            return None;
        }
        let index = if several { format!("{},0", name.sub.trim_end_matches(",0")) } else { "0".to_owned() };
        let power = self.equate(self.power_letters(&index), power, Unit::Power, right);
        Some(self.equate(name.clone(), effort, unit, power / rate))
    }

    /// The bodies that hang together with an effort; none where another effort acts on them too.
    fn chain_of_effort(&self, slot: usize) -> Option<Vec<usize>> {
        let efforts = &self.structure().efforts;
        let replaced = &self.structure().replaced;
        let moving =
            |bodies: Vec<BodyId>| bodies.into_iter().map(|b| b.0).filter(|b| *b != 0).collect::<Vec<_>>();
        let of = |slot: usize| moving(efforts[slot].bodies(replaced));
        let mut chain = of(slot);
        loop {
            let before = chain.len();
            for joint in &replaced.joints {
                let mut bodies = moving(joint.bodies());
                for (rate, _) in joint.kind.law().into_iter().flatten() {
                    if let BodyRate::Slide(slide) = rate {
                        bodies.extend(moving(replaced.joint(*slide).bodies()));
                    }
                }
                if bodies.iter().any(|body| chain.contains(body)) {
                    chain.extend(bodies);
                }
            }
            chain.sort_unstable();
            chain.dedup();
            if chain.len() == before {
                break;
            }
        }
        let alone = (0..efforts.len())
            .filter(|other| *other != slot)
            .all(|other| of(other).iter().all(|body| !chain.contains(body)));
        alone.then_some(chain)
    }

    /// The values of the file at which locking begins.
    fn criticals(&mut self) {
        let mechanism = self.scene.mechanism();
        for (i, find) in mechanism.finds.iter().enumerate() {
            let FindKind::Value { expr, display, .. } = &find.kind else { continue };
            let mut which = None;
            mechanism.each_query(expr, &mut |query| {
                if let Query::Critical(index) = query {
                    which = mechanism.criticals.get(*index).cloned();
                }
            });
            let (Some(name), Some(value @ Value::Scalar(x))) = (which, self.scene.view().found(i)) else {
                continue;
            };
            if x.is_finite() {
                self.say(FrictionMessage::LocksFrom, &[vec![text(name)], vec![text(display.text(value, 5))]]);
            }
        }
    }

    /// What a position says where pairs share by friction what they hold.
    pub fn held_by_many(&mut self) {
        let heading = self.words(Message::Reactions);
        self.heading(2, heading);
        self.say(FrictionMessage::FrictionShares, &[]);
    }

    /// What a locked position says.
    pub fn locked(&mut self) {
        let heading = self.words(Message::Reactions);
        self.heading(2, heading);
        self.say(FrictionMessage::Locked, &[]);
        self.criticals();
    }
}
