//! The loads of the file on the links; what is left of the solver's sum is stated as a resultant.

use super::holding::stop_of;
use super::{Couple, Force, is_load};
use crate::asked_formula::written_in_letters;
use crate::course::{Derivation, cell, joined};
use crate::document::text;
use crate::expressions::length;
use crate::motion::of;
use crate::words::{FrictionMessage, Message};
use assur_formula::{Expr, Name, Unit};
use assur_math::math::Vec2;
use assur_model::model::{self, Load, LoadId, LoadKind, PairId, Query, SpringId, Value};
use assur_model::structure::BodyId;
use assur_position::position::Action;
use assur_solve::solve::Wrench;

/// What is left of a sum, over its largest term, where all is listed.
const LEFT: f64 = 1e-10;

impl Derivation<'_> {
    /// Forces and torques of the file.
    pub fn loads(&mut self) {
        let mechanism = self.scene.mechanism();
        for (i, load) in mechanism.loads.iter().enumerate() {
            let (name, id) = (self.load_letters(i, load), LoadId::at(i));
            match self.scene.view().load_action(id) {
                Some(action) if action.force.norm() > 0.0 || action.couple != 0.0 => {
                    self.load(id, load, &name, &action);
                    self.counts.loads[0] += 1;
                }
                // an open stop is nothing
                _ if stop_of(load).is_some() => {}
                Some(_) if load.when.is_some() || !matches!(load.value(), model::Expr::Constant(_)) => {
                    self.say(Message::LoadRests, &[of(&name)]);
                }
                _ => {}
            }
        }
        for (i, spring) in mechanism.springs.iter().enumerate() {
            self.spring(SpringId::at(i), spring);
        }
    }

    /// The letters of a load, by its number.
    pub(crate) fn load_letters(&self, i: usize, load: &Load) -> Name {
        self.scene.load_words(load).map_or_else(
            || Name::new(if load.is_vector() { "F" } else { "M" }, &(i + 1).to_string()),
            |words| quantity_name(&words),
        )
    }

    /// The magnitude of a load: a value of the file, or what an expression of the file comes to at this position.
    pub(super) fn size_of(&mut self, load: &Load, name: Name, size: f64, unit: Unit) -> Expr {
        if let Some(resultant) = self.resultant(load, &name, size) {
            return resultant;
        }
        if matches!(load.value(), model::Expr::Constant(_)) {
            return self.given(name, size, unit);
        }
        let statement = self.scene.text.get(load.span.start..load.span.end).unwrap_or_default();
        let written = statement.split_once('=').map_or(statement, |(_, value)| value);
        let words = written.split_whitespace().collect::<Vec<_>>().join(" ");
        let letters = written_in_letters(self.scene.mechanism(), &words, self.language);
        self.say(Message::LoadHere, &[of(&name), letters.unwrap_or_else(|| vec![text(words)])]);
        match self.size_in_letters(load.value(), size) {
            // what varies is nothing here
            Some(right) if right.is_constant() => self.given(name, size, unit),
            Some(right) => self.equate(name, size, unit, right),
            None => self.stated(name, size, unit),
        }
    }

    /// The resultant of a load per length, (q1 + q2) l/2 of the values at both ends.
    fn resultant(&mut self, load: &Load, name: &Name, size: f64) -> Option<Expr> {
        let (spread, on) = (load.spread?, load.link()?.index());
        let ends = [spread.from, spread.to].map(|at| self.point_name(on, at));
        self.say(Message::LoadResultant, &[of(name), vec![text(&*ends[0])], vec![text(&*ends[1])]]);
        let length = (spread.to - spread.from).norm();
        let [first, last] = [1.0 - spread.share, spread.share].map(|share| share * size * 2.0 / length);
        let length = self.given(Name::new("l", &joined(&ends[0], &ends[1])), length, Unit::Length);
        let sum = if spread.share == 0.5 {
            self.given(Name::new("q", "0"), first, Unit::Stiffness) * length
        } else {
            let [first, last] = [(first, &ends[0]), (last, &ends[1])]
                .map(|(q, end)| self.given(Name::new("q", end), q, Unit::Stiffness));
            (first + last) * length / Expr::Int(2)
        };
        Some(self.equate(name.clone(), size, Unit::Force, sum))
    }

    /// The torque of a clutch that slips: its capacity, or what holds it.
    fn torque_of_clutch(&mut self, load: &Load, pair: PairId, name: &Name, size: f64) -> Expr {
        let clutch = self.scene.mechanism().pair(pair);
        let words = [vec![text(&*clutch.name)], of(name)];
        if !self.scene.view().slips(pair) {
            self.say(FrictionMessage::PairHeld, &words);
            return self.given(name.clone(), size, Unit::Torque);
        }
        let sides = clutch.kind.links().into_iter().map(|link| vec![text(self.scene.link_label(link))]);
        let words: Vec<_> = words.into_iter().chain(sides).collect();
        self.say(FrictionMessage::ClutchSlips, &words);
        match self.size_in_letters(load.value(), size) {
            Some(right) if !right.is_constant() => self.equate(name.clone(), size, Unit::Torque, right),
            _ => self.given(name.clone(), size, Unit::Torque),
        }
    }

    /// What the file has for a load, in the letters of the steps before.
    fn size_in_letters(&mut self, value: &model::Expr, size: f64) -> Option<Expr> {
        let right = match value {
            model::Expr::Polar(size, _) => self.in_letters(size),
            other => self.in_letters(other).or_else(|| self.vector_in_letters(other).map(length)),
        }?;
        let all = [right.clone(), -right];
        let near = |right: &Expr| (right.value() - size).abs() <= LEFT * right.scale().max(size);
        all.into_iter().find(near)
    }

    /// A load of the file: a force or a couple on a link, or between the two links of a pair.
    fn load(&mut self, id: LoadId, load: &Load, name: &Name, action: &Action) {
        let is_force = action.force.norm() > 0.0;
        let unit = if is_force { Unit::Force } else { Unit::Torque };
        match &load.kind {
            LoadKind::InPair { pair, .. } => {
                let effort = match self.scene.view().query(&Query::Load(id)) {
                    Value::Scalar(effort) => effort,
                    _ => action.couple,
                };
                // of a designed cam the normal force, not what belongs to the gap
                let effort = if is_force { action.force.norm().copysign(effort) } else { effort };
                let torsion = if is_force { None } else { self.torsion(load, *pair, effort) };
                let value = match torsion {
                    Some(value) => value,
                    None if stop_of(load).is_some() => self.stop_effort(*pair, action, effort, unit),
                    None => {
                        let size = match load.is_against_motion() {
                            true => self.torque_of_clutch(load, *pair, name, effort.abs()),
                            false => self.size_of(load, name.clone(), effort.abs(), unit),
                        };
                        if effort < 0.0 { -size } else { size }
                    }
                };
                if is_force {
                    self.along_guide(action, effort, name, &value);
                    self.friction_of_parting(*pair, &value);
                } else {
                    self.put_couple(action, &value);
                }
            }
            _ if is_force => {
                let size = self.size_of(load, name.clone(), action.force.norm(), unit);
                self.force(action, &size, load.is_against_motion());
            }
            _ => {
                let size = self.size_of(load, name.clone(), action.couple.abs(), unit);
                self.put_couple(action, &if action.couple < 0.0 { -size } else { size });
            }
        }
    }

    fn force(&mut self, action: &Action, size: &Expr, against: bool) {
        let Expr::Leaf(q) = size else { return };
        let name = q.name.clone();
        let (body, force) = (action.on, action.force);
        let moved = self.moved(body);
        let at = (action.at - moved.p).turned_back(moved.u);
        let direction = self.direction_given(clear(force), || Name::new("β", &name.sub_or_letter()));
        let mut parts = [size.clone() * direction.cos(), size.clone() * direction.sin()];
        let mut words = vec![text(arrow(clear(force)))];
        if against {
            words = crate::document::against("v", &self.point_name(body, at));
            if direction.part.is_some() {
                parts = self.against(body, at, size, &name, force);
            }
        } else if direction.part.is_some() {
            let [x, y] = parts;
            parts = [
                self.equate(name.and("x"), force.x, Unit::Force, x),
                self.equate(name.and("y"), force.y, Unit::Force, y),
            ];
        }
        self.put_force(action, &name, &parts, &[cell(size), words]);
    }

    /// The components of a force against the velocity of its point.
    fn against(&mut self, body: usize, at: Vec2, size: &Expr, name: &Name, force: Vec2) -> [Expr; 2] {
        let [x, y] = self.velocity(body, at);
        let point = self.point_name(body, at);
        let moved = self.moved(body).velocity(at);
        let speed = self.equate(
            Name::new("v", &point),
            moved.norm(),
            Unit::Velocity,
            (x.clone().squared() + y.clone().squared()).root(),
        );
        // a velocity that turns has a magnitude with a sign
        let speed = if (speed.value() - moved.norm()).abs() > LEFT * moved.norm() { -speed } else { speed };
        [
            self.equate(name.and("x"), force.x, Unit::Force, -(size.clone() * x / speed.clone())),
            self.equate(name.and("y"), force.y, Unit::Force, -(size.clone() * y / speed)),
        ]
    }

    /// What is left of the solver's loads on a body: force and moment about its origin, and what these are large against. Friction
    /// is not among them.
    fn left_of(&self, body: usize, sum: Wrench) -> ((Vec2, f64), f64, f64) {
        let p = self.moved(body).p;
        let (mut force, mut moment) = (sum.force, sum.moment);
        let mut size = force.norm();
        for listed in self.free.forces[body].iter().filter(|f| is_load(f.from, false)) {
            let f = Vec2::new(listed.parts[0].value(), listed.parts[1].value());
            let at = self.moved(body).position(listed.at);
            force -= f;
            moment -= (at - p).cross(f);
            size = size.max(f.norm());
        }
        let mut couples = sum.moment.abs().max(size * self.tiny * 1e9);
        for couple in self.free.couples[body].iter().filter(|c| is_load(c.from, false)) {
            moment -= couple.value.value();
            couples = couples.max(couple.value.value().abs());
        }
        ((force, moment), size, couples)
    }

    /// The loads that the solver has on a body with its parts.
    fn applied_on(&self, body: usize) -> Wrench {
        let applied = &self.state().forces.applied;
        let mut sum = applied[body];
        for part in self.structure().replaced.links_of(BodyId(body)).into_iter().skip(1) {
            let Wrench { force, moment } = applied[part.index()];
            sum.force += force;
            sum.moment += moment + (self.moved(part.index()).p - self.moved(body).p).cross(force);
        }
        sum
    }

    /// The loads that the solver has on a body beyond those that are listed.
    pub(super) fn complete(&mut self, body: usize) {
        if body == 0 || body >= self.state().forces.applied.len() {
            return;
        }
        let sum = self.applied_on(body);
        let ((mut force, mut moment), size, couples) = self.left_of(body, sum);
        let label = self.label(body);
        if force.norm() <= LEFT * size {
            force = Vec2::zero();
        }
        if moment.abs() <= LEFT * couples {
            moment = 0.0;
        }
        if force.norm() > 0.0 || moment != 0.0 {
            self.say(Message::RestOfLoads, &[vec![text(&*label)]]);
            let name = Name::new("Q", &label);
            let force = clear(force);
            if force.norm() > 0.0 {
                let parts = [(force.x, "x"), (force.y, "y")].map(|(value, axis)| {
                    if value == 0.0 { Expr::ZERO } else { self.stated(name.and(axis), value, Unit::Force) }
                });
                let known = [vec![text(self.words(Message::Found))], vec![text("–")]];
                self.free.forces[body].push(Force { name, at: Vec2::zero(), parts, known, from: None });
            }
            if moment != 0.0 {
                let name = Name::new("M", &format!("Q{label}"));
                let value = self.stated(name, moment, Unit::Torque);
                self.free.couples[body].push(Couple { value, from: None });
            }
            self.counts.loads[1] += 1;
        }
    }
}

/// Without the part that is rounding.
fn clear(v: Vec2) -> Vec2 {
    let size = 1e-12 * v.norm();
    let of = |x: f64| if x.abs() <= size { 0.0 } else { x };
    Vec2::new(of(v.x), of(v.y))
}

fn arrow(v: Vec2) -> String {
    match (v.x, v.y) {
        (x, 0.0) => if x > 0.0 { "→" } else { "←" }.to_owned(),
        (0.0, y) => if y > 0.0 { "↑" } else { "↓" }.to_owned(),
        (x, y) => format!("{}°", assur_formula::with_decimals(libm::atan2(y, x).to_degrees(), 2).text()),
    }
}

/// The letters of a name of the file: `Fr` → F with the index r, `F_r` the same.
pub fn quantity_name(words: &str) -> Name {
    const GREEK: [(&str, &str); 13] = [
        ("phi", "φ"),
        ("omega", "ω"),
        ("alpha", "α"),
        ("beta", "β"),
        ("gamma", "γ"),
        ("mu", "μ"),
        ("psi", "ψ"),
        ("theta", "θ"),
        ("delta", "δ"),
        ("eta", "η"),
        ("rho", "ρ"),
        ("lambda", "λ"),
        ("epsilon", "ε"),
    ];
    /// Two letters of a Greek one, alone or with a number.
    const SHORT: [(&str, &str); 5] = [("al", "α"), ("be", "β"), ("ga", "γ"), ("th", "θ"), ("om", "ω")];
    let is_short = |word: &str| {
        let rest = words.strip_prefix(word).map(|rest| rest.strip_prefix('_').unwrap_or(rest));
        rest.is_some_and(|rest| rest.chars().all(|c| c.is_ascii_digit()))
    };
    // a longer word that begins so is a word
    let is_letter = |word: &str| {
        words
            .strip_prefix(word)
            .is_some_and(|rest| !rest.starts_with(|c: char| c.is_alphabetic()) || rest.len() <= 2)
    };
    let short = SHORT.iter().find(|(word, _)| is_short(word));
    if let Some((word, letter)) = GREEK.iter().find(|(word, _)| is_letter(word)).or(short) {
        return Name::new(letter, words[word.len()..].trim_start_matches('_'));
    }
    if let Some((letter, sub)) = words.split_once('_') {
        return Name::new(letter, sub);
    }
    let mut chars = words.chars();
    let first = chars.next().map(String::from).unwrap_or_default();
    let rest = chars.as_str();
    // `Fr`, `M1`, `Mb`; a word is left whole
    let capital = words.starts_with(char::is_uppercase) && rest.chars().count() <= 3;
    let counted = rest.chars().next().is_some_and(|c| c.is_ascii_digit());
    if capital || counted || words.chars().count() <= 2 {
        Name::new(&first, rest)
    } else {
        Name::new(words, "")
    }
}
