//! Groups with friction: equilibrium with the friction that the solver found, then the law of friction with these reactions.

use crate::course::Derivation;
use crate::document::{Inline, Line, text};
use crate::motion::of;
use crate::words::FrictionMessage;
use assur_formula::{Expr, Name, Unit};
use assur_math::math::SAME;
use assur_model::model::{LinkId, MoreFriction, PairId};
use assur_position::plan::{ForceStep, FrictionElement, FrictionGroup, FrictionLaw};
use assur_position::position::Origin;

impl Derivation<'_> {
    pub(super) fn force_friction(&mut self, index: usize, plain: &ForceStep, group: &FrictionGroup) -> bool {
        let elements: Vec<(usize, FrictionElement)> =
            group.elements.iter().map(|&e| (e, self.scene.model.plan.friction[e])).collect();
        let steps = self.state().friction_steps(self.scene.model.plan, index);
        let direct = steps.is_empty() && group.laws.is_empty();
        let moves = elements.iter().any(|(slot, _)| self.state().forces.senses[*slot] != 0.0);
        if moves {
            self.say(
                if direct { FrictionMessage::FrictionDirect } else { FrictionMessage::FrictionSenses },
                &[],
            );
        }
        let rates: Vec<Option<Expr>> = elements.iter().map(|(slot, e)| self.sense_of(*slot, e)).collect();
        self.iteration(&elements, &steps);
        let acts = |course: &Self, slot: usize| course.friction_in(slot) != 0.0;
        let is_known = |(slot, element): &(usize, FrictionElement)| {
            acts(self, *slot) && !self.is_to_find(*slot, element)
        };
        if elements.iter().any(is_known) {
            self.say(FrictionMessage::FrictionFirst, &[]);
        }
        let slides = rates.iter().any(Option::is_some);
        for ((slot, element), rate) in elements.iter().zip(rates) {
            if acts(self, *slot) {
                let effort = self.rub(*slot, element);
                self.rubbing.extend(rate.map(|rate| (*slot, effort, rate)));
            }
        }
        let derived = self.force_step(index, plain);
        if derived && (slides || moves && self.state().motion.grips.is_empty()) {
            self.say(FrictionMessage::FrictionLaws, &[]);
            for (slot, element) in &elements {
                self.law_of_friction(*slot, element);
            }
        }
        derived
    }

    /// The friction of an element; what holds nothing but rounding is nothing.
    pub(super) fn friction_in(&self, slot: usize) -> f64 {
        let forces = &self.state().forces;
        let turns = self.scene.model.plan.friction[slot].kind.turns();
        let size = if turns { self.tiny / SAME } else { 1.0 } * self.greatest_force();
        let held = forces.senses[slot] == 0.0 && forces.frictions[slot].abs() <= super::NOTHING * size;
        if held { 0.0 } else { forces.frictions[slot] }
    }

    /// The letters of the friction in a pair.
    pub(super) fn friction_name(&self, element: &FrictionElement) -> Name {
        let pair = self.scene.mechanism().pair(element.pair);
        let letter = if element.kind.turns() { "M" } else { "F" };
        let several = pair.kind.links().len() > 2;
        let more = if several { self.label(element.body) } else { String::new() };
        Name::new(letter, &format!("f{}{more}", pair.name))
    }

    /// The sense of a pair, by the relative velocity that decides it; none where nothing moves.
    fn sense_of(&mut self, slot: usize, element: &FrictionElement) -> Option<Expr> {
        let (effort, sense) = (self.friction_in(slot), self.state().forces.senses[slot]);
        let pair: Line = vec![text(self.scene.mechanism().pair(element.pair).name.clone())];
        if sense == 0.0 || effort == 0.0 {
            if effort == 0.0 {
                self.say(FrictionMessage::PairStill, &[pair]);
            } else {
                let found_here = self.is_to_find(slot, element);
                let message =
                    if found_here { FrictionMessage::PairHeldByBalance } else { FrictionMessage::PairHeld };
                self.say(message, &[pair, of(&self.friction_name(element))]);
            }
            return None;
        }
        let rate = self.relative_rate(element);
        let value = vec![Inline::Math(assur_formula::letters(&rate))];
        let [on, from] = [element.body, element.base].map(|b| vec![text(self.label(b))]);
        let (friction, positive) = (of(&self.friction_name(element)), sense > 0.0);
        if rate.value() == 0.0 {
            let message = if positive {
                FrictionMessage::PairBeginsPositive
            } else {
                FrictionMessage::PairBeginsNegative
            };
            self.say(message, &[pair, on, friction]);
            return Some(rate);
        }
        let nameless = element.base == 0 && self.scene.mechanism().link(LinkId::GROUND).number.is_none();
        if nameless {
            let message = if positive {
                FrictionMessage::PairOnGroundPositive
            } else {
                FrictionMessage::PairOnGroundNegative
            };
            self.say(message, &[pair, on, value, friction]);
        } else {
            let message = if positive {
                FrictionMessage::PairMovesPositive
            } else {
                FrictionMessage::PairMovesNegative
            };
            self.say(message, &[pair, on, from, value, friction]);
        }
        Some(rate)
    }

    /// The friction of a pair as a known load on both bodies.
    fn rub(&mut self, slot: usize, element: &FrictionElement) -> Expr {
        let name = self.friction_name(element);
        let turns = element.kind.turns();
        let unit = if turns { Unit::Torque } else { Unit::Force };
        let leaf = match self.friction_to_find(slot, element, unit) {
            Some(sought) => sought,
            None => {
                if self.state().forces.senses[slot] == 0.0 {
                    // the equation of motion of a coordinate has it
                    self.solutions.insert(name.clone());
                }
                self.stated(name.clone(), self.state().forces.frictions[slot], unit)
            }
        };
        self.put_friction(slot, element, &leaf);
        leaf
    }

    /// The friction of a contact that parts, in proportion to what the contact bears.
    pub(super) fn friction_of_parting(&mut self, pair: PairId, pressing: &Expr) {
        let elements = self.scene.model.plan.friction.iter().enumerate();
        let own = elements.filter(|(_, element)| element.pair == pair && element.stop.is_some());
        for (slot, element) in own.map(|(slot, element)| (slot, *element)).collect::<Vec<_>>() {
            if self.friction_in(slot) == 0.0 {
                continue;
            }
            let rate = self.sense_of(slot, &element);
            let (name, sense) = (self.friction_name(&element), self.state().forces.senses[slot]);
            let effort = self.state().forces.frictions[slot];
            let unit = if element.kind.turns() { Unit::Torque } else { Unit::Force };
            let leaf = match self.by_law(&element, pressing.clone()) {
                Some(right) if sense != 0.0 => {
                    self.equate(name, effort, unit, if sense > 0.0 { -right } else { right })
                }
                _ => {
                    self.solutions.insert(name.clone());
                    self.stated(name, effort, unit)
                }
            };
            self.put_friction(slot, &element, &leaf);
            self.rubbing.extend(rate.map(|rate| (slot, leaf.clone(), rate)));
        }
    }

    fn put_friction(&mut self, slot: usize, element: &FrictionElement, leaf: &Expr) {
        let (name, turns) = (self.friction_name(element), element.kind.turns());
        for action in self.scene.view().actions_from(Origin::Friction(slot)) {
            if turns {
                self.put_couple(&action, leaf);
                continue;
            }
            let angle = match &element.kind {
                FrictionLaw::Guide { guide, .. } | FrictionLaw::BothEnds { guide, .. } => self.way(guide).0,
                _ => self.tangent(element, action.force * (1.0 / self.state().forces.frictions[slot])),
            };
            let parts = [leaf.clone() * angle.cos(), leaf.clone() * angle.sin()];
            self.put_force(&action, &name, &parts, &[crate::course::cell(leaf), vec![text("–")]]);
        }
    }

    /// M_f = ∓ρ R, F_f = ∓f N with the reactions found.
    fn law_of_friction(&mut self, slot: usize, element: &FrictionElement) {
        let (effort, sense) = (self.state().forces.frictions[slot], self.state().forces.senses[slot]);
        if sense == 0.0 {
            return;
        }
        let Some(size) = self.pressed(element) else { return };
        let Some(right) = self.by_law(element, size) else { return };
        let unit = if element.kind.turns() { Unit::Torque } else { Unit::Force };
        let right = if sense > 0.0 { -right } else { right };
        let name = self.friction_name(element);
        self.confirm(name, effort, unit, right);
    }

    /// The friction that goes with what presses; none where both ends of a guide do.
    fn by_law(&mut self, element: &FrictionElement, size: Expr) -> Option<Expr> {
        let pair = self.scene.mechanism().pair(element.pair).name.clone();
        Some(match &element.kind {
            FrictionLaw::Circle { radius } => {
                self.times_reaction(element, Name::new("ρ", &pair), *radius, Unit::Length) * size
            }
            FrictionLaw::Guide { coefficient, .. } | FrictionLaw::Contact { coefficient, .. } => {
                self.times_reaction(element, Name::new("f", &pair), *coefficient, Unit::One) * size.abs()
            }
            FrictionLaw::Rolling { arm } => {
                self.times_reaction(element, Name::new("δ", &pair), *arm, Unit::Length) * size.abs()
            }
            FrictionLaw::BothEnds { .. } => return None,
        })
    }

    /// What the reaction in a pair is multiplied by: a value of the file, or f/sin β of a groove, k f of a fit with its values.
    fn times_reaction(&mut self, element: &FrictionElement, mut name: Name, value: f64, unit: Unit) -> Expr {
        let mechanism = self.scene.mechanism();
        let Some((_, stated)) = mechanism.stated_friction.iter().find(|(pair, _)| *pair == element.pair)
        else {
            return self.given(name, value, unit);
        };
        let pair = &mechanism.pair(element.pair).name;
        let given = |letter: &str, value: f64, unit| self.given(Name::new(letter, pair), value, unit);
        let friction = given("f", stated.coefficient, Unit::One);
        let right = match stated.more {
            MoreFriction::Groove(half) => friction / given("β", half.to_degrees(), Unit::Angle).sin(),
            MoreFriction::Fit { factor, radius } => {
                let equivalent = given("k", factor, Unit::One) * friction;
                radius.map_or(equivalent.clone(), |radius| equivalent * given("r", radius, Unit::Length))
            }
        };
        if unit == Unit::One {
            name.letter.push('′');
        }
        self.equate(name, value, unit, right)
    }

    /// The reaction that presses in a pair; in a hinge of several links that of all others on its own link.
    fn pressed(&mut self, element: &FrictionElement) -> Option<Expr> {
        let Some((from, to)) = element.pin else {
            let reaction = self.free.reactions.get(element.slot).cloned().flatten()?;
            return self.found.get(&reaction).cloned();
        };
        let mut parts = [Expr::ZERO, Expr::ZERO];
        for (slot, sign) in &self.scene.model.plan.pin_slots[from..to] {
            let reaction = self.free.reactions[*slot].clone()?;
            let found =
                ["x", "y"].map(|axis| self.found.get(&reaction.and(axis)).cloned().unwrap_or(Expr::ZERO));
            // it may be written as the force on the other link
            let force = self.state().forces.reactions[*slot].force * *sign;
            let opposite = found[0].value() * force.x + found[1].value() * force.y < 0.0;
            for (sum, part) in parts.iter_mut().zip(found) {
                *sum = sum.clone() + if opposite { -part } else { part };
            }
        }
        let pair = self.scene.mechanism().pair(element.pair).name.clone();
        let name = Name::new("R", &format!("{pair},{}", self.label(element.body)));
        Some(self.length_of(name, Unit::Force, &parts))
    }
}
