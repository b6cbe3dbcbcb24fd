//! Trains: one equation per member in the forces of its transmissions and the unknown efforts. One with a single
//! unknown gives it; of two with the same two one is eliminated; what is left is stated.

use super::Force;
use crate::course::Derivation;
use crate::document::{Line, text};
use crate::letters::teeth_name;
use crate::motion::{of, pin};
use crate::words::Message;
use assur_formula::{Expr, Name, Unit, quantity};
use assur_model::model::{PairKind, TransmissionKind, Wheel};
use assur_position::plan::{Hinge, TrainEffort, TrainSupport};
use assur_position::position::Origin;

/// An equation: load + Σ factor × unknown = 0.
struct Row {
    label: String,
    /// The letters of its sum.
    sum: Name,
    load: Expr,
    terms: Vec<(usize, Expr)>,
}

/// An unknown: letters, value, unit.
type Unknown = (Name, f64, Unit);

impl Row {
    /// The left side, with the unknowns that are still sought.
    fn whole(&self, unknowns: &[Unknown], found: &[Option<Expr>]) -> Expr {
        let terms = self.terms.iter().map(|(u, factor)| {
            let (name, value, unit) = unknowns[*u].clone();
            factor.clone() * found[*u].clone().unwrap_or_else(|| quantity(name, value, unit))
        });
        Expr::sum(std::iter::once(self.load.clone()).chain(terms))
    }
}

impl Derivation<'_> {
    pub(super) fn force_train(&mut self, index: usize, train: usize) -> bool {
        let plan = self.scene.model.plan;
        let Some(of_train) = plan.train_forces.get(train) else { return false };
        if of_train.inverse.is_empty() {
            self.stated_forces(index);
            return false;
        }
        let members = of_train.members.clone();
        let laws = of_train.laws.clone();
        members.iter().for_each(|member| self.complete(body_of(member)));
        self.say_once(Message::TrainForces);
        self.directions(&laws);
        self.hold_laws(&laws);
        let before = self.free.forces.clone();
        let unknowns = self.unknowns_of(train);
        let mut rows = self.rows_of(train);
        let mut found: Vec<Option<Expr>> = vec![None; unknowns.len()];
        loop {
            let open = |row: &Row| row.terms.iter().filter(|(u, _)| found[*u].is_none()).count();
            if let Some(at) = rows.iter().position(|row| open(row) == 1) {
                let row = rows.remove(at);
                self.single(&row, &unknowns, &mut found);
            } else if let Some(pair) = two_rows(&rows, &found) {
                let second = rows.remove(pair[1]);
                self.pair(&rows[pair[0]], &second, &unknowns, &mut found);
            } else {
                break;
            }
        }
        for (i, (name, value, unit)) in unknowns.into_iter().enumerate() {
            if found[i].is_none() {
                found[i] = Some(self.stated(name, value, unit));
            }
        }
        // what the wheels of a carrier put on it goes through their bearings now
        self.free.forces = before;
        for (slot, force) in laws.into_iter().zip(&found) {
            if let Some(force) = force {
                self.pass_on(slot, force, &members);
            }
        }
        let inside: Vec<usize> = members.iter().map(body_of).collect();
        for effort in &of_train.efforts {
            let (TrainEffort::Torque(slot, ..) | TrainEffort::Along(slot, _)) = effort;
            self.effort_on_others(*slot, &inside);
        }
        self.supports(&members);
        true
    }

    /// The forces of the laws at the wheels, then the efforts.
    fn unknowns_of(&self, train: usize) -> Vec<Unknown> {
        let plan = self.scene.model.plan;
        let of_train = &plan.train_forces[train];
        let laws = of_train.laws.iter().map(|&slot| {
            let multiplier = self.state().forces.law_forces[slot].multiplier;
            let (name, unit) = self.law_name(slot);
            (name, multiplier * scale_of(plan.laws[slot].force), unit)
        });
        let efforts = of_train.efforts.iter().map(|effort| {
            let (slot, force) = match effort {
                TrainEffort::Torque(slot, ..) => (*slot, false),
                TrainEffort::Along(slot, _) => (*slot, true),
            };
            let unit = if force { Unit::Force } else { Unit::Torque };
            (self.effort_name(slot, force), self.state().forces.efforts[slot], unit)
        });
        laws.chain(efforts).collect()
    }

    /// The letters of the force of a law; of a worm and of a clutch it is a torque.
    pub(crate) fn law_name(&self, slot: usize) -> (Name, Unit) {
        let plan = self.scene.model.plan;
        let law = &plan.laws[slot];
        let pair = &self.scene.mechanism().pair(law.pair).name;
        let several = plan.laws.iter().filter(|l| l.pair == law.pair).count() > 1;
        let more = if several { format!(",{}", law.index + 1) } else { String::new() };
        let by_teeth = self.counts_teeth(pair);
        let clutch = self.kind_of(pair) == Some(TransmissionKind::Clutch);
        let (letter, unit) = if by_teeth || clutch { ("M", Unit::Torque) } else { ("F", Unit::Force) };
        (Name::new(letter, &format!("{pair}{more}")), unit)
    }

    /// Whether numbers of teeth stand for radii: of a worm, and where the file leaves the size of a wheel open.
    fn counts_teeth(&self, pair: &str) -> bool {
        let mechanism = self.scene.mechanism();
        let Some(found) = mechanism.pairs.iter().find(|p| p.name == pair) else { return false };
        let PairKind::Transmission(t) = &found.kind else { return false };
        let wheels = || mechanism.wheels.iter().filter(|w| t.ends.contains(&w.name));
        let by_teeth = wheels().count() == 2 && wheels().all(|w| w.teeth.is_some() && w.open);
        t.kind == TransmissionKind::Worm || by_teeth
    }

    fn kind_of(&self, pair: &str) -> Option<TransmissionKind> {
        let found = self.scene.mechanism().pairs.iter().find(|p| p.name == pair)?;
        match &found.kind {
            PairKind::Transmission(t) => Some(t.kind),
            _ => None,
        }
    }

    fn rows_of(&mut self, train: usize) -> Vec<Row> {
        let plan = self.scene.model.plan;
        let of_train = &plan.train_forces[train];
        let n = of_train.members.len();
        let mut rows = Vec::new();
        for (i, member) in of_train.members.iter().enumerate().rev() {
            let body = body_of(member);
            let label = self.label(body);
            let load = match member {
                TrainSupport::Turn(hinge, carrier) => {
                    let load = self.moment_about(body, pin(&hinge.pin));
                    if let Some(carrier) = *carrier {
                        self.on_carrier(hinge, body_of(&of_train.members[carrier]));
                    }
                    load
                }
                TrainSupport::Shift(guide, sign) => {
                    let sums = self.sum_of(&[body]);
                    let along = self.way(guide).0.along(&sums);
                    if *sign < 0.0 { -along } else { along }
                }
            };
            let row = &of_train.matrix[i * n..][..n];
            let turns = matches!(member, TrainSupport::Turn(..));
            let mut terms = Vec::new();
            for (k, c) in row.iter().enumerate().filter(|(_, c)| **c != 0.0) {
                let law = of_train.laws.get(k).map(|&slot| &plan.laws[slot]);
                let factor = match law {
                    Some(law) => self.coefficient(of_train.laws[k], law, member, *c, turns),
                    None if *c < 0.0 => Expr::Int(-1),
                    None => Expr::Int(1),
                };
                terms.push((k, factor));
            }
            let sum = Name::new(if turns { "ΣM" } else { "ΣF" }, &label);
            rows.push(Row { label, sum, load, terms });
        }
        rows.reverse();
        rows
    }

    /// The arm of a force of a transmission about an axis: the radius of a wheel where it is one.
    pub(super) fn lever(&self, value: f64, pair: &str, label: &str, turns: bool) -> Expr {
        let size = value.abs();
        let wheels = &self.scene.mechanism().wheels;
        let kind = self.kind_of(pair);
        let factor = if self.counts_teeth(pair) {
            let own = |w: &&Wheel| {
                w.teeth.is_some_and(|z| (0.5 * z - size).abs() <= 1e-12 * size)
                    && self.label(w.link.index()) == label
            };
            let teeth = |name: &str| self.given(teeth_name(name), 2.0 * size, Unit::One) / Expr::Int(2);
            match wheels.iter().find(own) {
                Some(wheel) => teeth(&wheel.name),
                None => self.centre_distance(pair, size).unwrap_or_else(|| teeth(pair)),
            }
        } else if (size - 1.0).abs() < 1e-12 && (!turns || kind == Some(TransmissionKind::Clutch)) {
            Expr::Int(1)
        } else {
            let wheel = wheels
                .iter()
                .find(|w| (w.radius - size).abs() <= 1e-12 * size && self.label(w.link.index()) == label);
            match wheel {
                Some(wheel) => self.given(Name::new("r", &wheel.name), size, Unit::Length),
                None => self.centre_distance(pair, size).unwrap_or_else(|| {
                    self.given(Name::new("r", &format!("{pair},{label}")), size, Unit::Length)
                }),
            }
        };
        if value < 0.0 { -factor } else { factor }
    }

    /// The arm of a carrier: the sum of the radii of two wheels, or their difference.
    fn centre_distance(&self, pair: &str, size: f64) -> Option<Expr> {
        let mechanism = self.scene.mechanism();
        let PairKind::Transmission(t) = &mechanism.pairs.iter().find(|p| p.name == pair)?.kind else {
            return None;
        };
        let wheels: Vec<&Wheel> =
            t.ends.iter().filter_map(|end| mechanism.wheels.iter().find(|w| w.name == *end)).collect();
        let [a, b] = wheels.as_slice() else { return None };
        let (large, small) = if a.radius >= b.radius { (a, b) } else { (b, a) };
        let radius = |w: &Wheel| match w.teeth.filter(|_| w.open) {
            Some(teeth) => self.given(teeth_name(&w.name), teeth, Unit::One),
            None => self.given(Name::new("r", &w.name), w.radius, Unit::Length),
        };
        let half = |sum: Expr| if a.open && a.teeth.is_some() { sum / Expr::Int(2) } else { sum };
        let is = |x: f64| (x - size).abs() <= 1e-12 * size;
        if is(a.radius + b.radius) {
            return Some(half(radius(a) + radius(b)));
        }
        if is(large.radius - small.radius) {
            return Some(half(radius(large) - radius(small)));
        }
        // a bevel planet counts from its carrier: the lever there is that of the other wheel
        wheels.iter().find(|w| t.bevel.is_some() && is(w.radius)).map(|w| half(radius(w)))
    }

    /// The forces on a wheel act on the link that carries its axis.
    fn on_carrier(&mut self, hinge: &Hinge, carrier: usize) {
        let wheel = hinge.body;
        let parts = self.sum_of(&[wheel]);
        if parts.iter().all(Expr::is_zero) {
            return;
        }
        let place = self.moved(wheel).position(pin(&hinge.pin));
        let moved = self.moved(carrier);
        let at = (place - moved.p).turned_back(moved.u);
        let name = Name::new("Q", &self.label(wheel));
        let known = [Vec::new(), Vec::new()];
        let from = Some(Origin::Reaction(hinge.slot));
        self.free.forces[carrier].push(Force { name, at, parts, known, from });
    }

    fn rest(&self, row: &Row, found: &[Option<Expr>]) -> Expr {
        let known = row.terms.iter().filter_map(|(u, factor)| Some(factor.clone() * found[*u].clone()?));
        Expr::sum(std::iter::once(row.load.clone()).chain(known))
    }

    fn single(&mut self, row: &Row, unknowns: &[Unknown], found: &mut [Option<Expr>]) {
        let Some((u, factor)) = row.terms.iter().find(|(u, _)| found[*u].is_none()).cloned() else { return };
        let rest = self.rest(row, found);
        let (name, value, unit) = unknowns[u].clone();
        let label: Line = vec![text(&*row.label)];
        self.say(Message::MemberGives, &[label, of(&name)]);
        let at = self.blocks.len();
        let own = self.solved_for(name, value, unit, rest, factor);
        found[u] = Some(own);
        self.balanced(at, &row.sum, &row.whole(unknowns, found));
    }

    fn pair(&mut self, one: &Row, two: &Row, unknowns: &[Unknown], found: &mut [Option<Expr>]) {
        let open: Vec<usize> = one.terms.iter().map(|t| t.0).filter(|u| found[*u].is_none()).collect();
        let [first, second] = open.as_slice() else { return };
        let factor =
            |row: &Row, u: usize| row.terms.iter().find(|t| t.0 == u).map_or(Expr::ZERO, |t| t.1.clone());
        let (a, b) = (factor(one, *first), factor(two, *first));
        let [f, g] = if a == b {
            [Expr::Int(1), Expr::Int(1)]
        } else if a == -b.clone() {
            [Expr::Int(1), Expr::Int(-1)]
        } else {
            [b, a]
        };
        let rest = f.clone() * self.rest(one, found) - g.clone() * self.rest(two, found);
        let own = f * factor(one, *second) - g * factor(two, *second);
        let (name, value, unit) = unknowns[*second].clone();
        let labels: Line = vec![text(format!("{}, {}", one.label, two.label))];
        self.say(Message::MembersGive, &[labels, of(&unknowns[*first].0), of(&name)]);
        let at = self.blocks.len();
        found[*second] = Some(self.solved_for(name, value, unit, rest, own));
        for row in [two, one] {
            self.balanced(at, &row.sum, &row.whole(unknowns, found));
        }
    }

    /// −rest / factor; where nothing loads it, it is nothing.
    fn solved_for(&mut self, name: Name, value: f64, unit: Unit, rest: Expr, factor: Expr) -> Expr {
        let found = self.equate_or_nothing(&name, value, unit, -(rest / factor));
        if found.is_zero() {
            self.found.insert(name, Expr::ZERO);
        }
        found
    }
}

/// A force of one newton of a law in units of its multiplier.
pub(super) fn scale_of(force: f64) -> f64 {
    if force == 0.0 { 1.0 } else { force }
}

pub(super) const fn body_of(member: &TrainSupport) -> usize {
    match member {
        TrainSupport::Turn(hinge, _) => hinge.body,
        TrainSupport::Shift(guide, _) => guide.body,
    }
}

/// Two equations with the same two unknowns.
fn two_rows(rows: &[Row], found: &[Option<Expr>]) -> Option<[usize; 2]> {
    let open = |row: &Row| {
        let mut open: Vec<usize> = row.terms.iter().map(|t| t.0).filter(|u| found[*u].is_none()).collect();
        open.sort_unstable();
        open
    };
    for (i, one) in rows.iter().enumerate() {
        for (j, two) in rows.iter().enumerate().skip(i + 1) {
            let sought = open(one);
            if sought.len() == 2 && sought == open(two) {
                return Some([i, j]);
            }
        }
    }
    None
}
