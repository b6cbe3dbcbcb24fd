//! A motion under given loads: kinetic energy, reduced mass and reduced load at the instant that is shown, the balance of energy
//! of the run, its events.

use super::is_load;
use crate::course::Derivation;
use crate::document::{Table, text};
use crate::words::RunMessage;
use assur_formula::{Expr, Name, Unit, with_digits};
use assur_model::model::{DriveTarget, PairId};
use assur_model::structure::{EffortKind, JointKind};
use assur_position::position::Origin;
use assur_solve::solve::{Method, SimulationReport};

/// A speed below this part of the greatest is none.
const STILL: f64 = 1e-9;

impl Derivation<'_> {
    /// The section of a motion under loads.
    pub fn run(&mut self) {
        let Some(report) = self.scene.solution.simulation.as_ref() else { return self.events() };
        let heading = self.words(RunMessage::Run);
        self.heading(2, heading);
        let energy = self.kinetic_energy();
        if let Some(energy) = energy {
            self.reduced(report, &energy);
            self.reduced_masses(report, &energy);
        }
        self.balance_of_energy(report);
        self.events();
        let method = match report.method {
            Method::Dop853 => "DOP853".to_owned(),
            Method::Energy => self.words(RunMessage::ByEnergy),
            Method::Radau => "Radau IIA".to_owned(),
        };
        let parts = [
            method,
            report.steps.to_string(),
            report.printed.to_string(),
            with_digits(report.error, 2).text(),
        ];
        self.say(RunMessage::RunMethod, &parts.map(|part| vec![text(part)]));
    }

    /// T = Σ ½ m v² + ½ J ω²
    fn kinetic_energy(&mut self) -> Option<Expr> {
        let before = self.blocks.len();
        self.say(RunMessage::EnergyHere, &[]);
        let value = self.state().kinetic_energy(self.scene.mechanism());
        let right = self.energy_of_links();
        if right.is_zero() {
            self.blocks.truncate(before);
            return None;
        }
        Some(self.equate(Name::new("T", ""), value, Unit::Work, right))
    }

    /// Σ ½ m v² + ½ J ω², each term by itself: a line breaks between them.
    pub(crate) fn energy_of_links(&mut self) -> Expr {
        let mut sum = Expr::ZERO;
        for (i, link) in self.scene.mechanism().links.iter().enumerate().skip(1) {
            let Some(mass) = link.mass else { continue };
            let label = self.label(i);
            if mass.mass > 0.0 {
                let [x, y] = self.velocity(i, mass.centre);
                let name = Name::new("m", &label);
                let own = self.found.get(&name).cloned();
                let own = own.unwrap_or_else(|| self.given(name, mass.mass, Unit::Mass));
                let square = x.squared() + y.squared();
                sum = sum + own * square / Expr::Int(2);
            }
            let omega = self.bodies[i].as_ref().map_or(Expr::ZERO, |b| b.rates[0].clone());
            if mass.inertia > 0.0 && !omega.is_zero() {
                let point = self.point_name(i, mass.centre);
                sum = sum
                    + self.given(Name::new("J", &point), mass.inertia, Unit::Inertia) * omega.squared()
                        / Expr::Int(2);
            }
        }
        sum
    }

    /// Mass and load reduced to the one free coordinate.
    fn reduced(&mut self, report: &SimulationReport, energy: &Expr) {
        let [drive] = report.coordinates.as_slice() else { return };
        let Some(target) = self.scene.mechanism().drives.get(*drive).map(|d| d.target) else { return };
        let alone = self.scene.mechanism().drives.len() == 1;
        let Some((rate, turns)) = self.rate_of_drive(target).filter(|_| alone) else { return };
        let moved = self.state().motion.bodies.iter().map(|b| b.omega.abs().max(b.v.norm()));
        if rate.value().abs() <= STILL * moved.fold(0.0, f64::max) {
            return;
        }
        self.say(RunMessage::Reduced, &[]);
        let (letter, unit, loads) = if turns {
            ("J", Unit::Inertia, ("M", Unit::Torque))
        } else {
            ("m", Unit::Mass, ("F", Unit::Force))
        };
        let right = Expr::Int(2) * energy.clone() / rate.clone().squared();
        let value = right.value();
        let mass = self.equate(Name::new(letter, "r"), value, unit, right);
        let is_wanted = |from| is_load(from, true) && from != Some(Origin::Inertia);
        let power = Expr::sum(self.powers_on(&self.moving(), is_wanted));
        if power.is_zero() {
            return;
        }
        let right = power / rate.clone();
        let value = right.value();
        let load = self.equate(Name::new(loads.0, "r"), value, loads.1, right);
        let input = self.state().motion.inputs[*drive];
        let (letter, unit) =
            if turns { ("α", Unit::AngularAcceleration) } else { ("a", Unit::Acceleration) };
        self.say(RunMessage::ReducedMotion, &[]);
        let acceleration = self.stated(Name::new(letter, "r"), input.acceleration, unit);
        let right = load - mass * acceleration;
        let value = right.value();
        self.equate(Name::new(loads.0, "Δ"), value, loads.1, right);
    }

    /// The rate of a free coordinate, and whether it is an angle.
    pub(super) fn rate_of_drive(&mut self, target: DriveTarget) -> Option<(Expr, bool)> {
        match target {
            DriveTarget::Link(link) => {
                let kind = EffortKind::Angle(self.structure().replaced.body_of(link));
                Some((self.rate_of_effort(0, kind)?, true))
            }
            DriveTarget::Pair(pair) => self.rate_of_pair(pair),
            DriveTarget::Point(..) | DriveTarget::Place(..) => None,
        }
    }

    fn rate_of_pair(&mut self, pair: PairId) -> Option<(Expr, bool)> {
        let joints: Vec<_> = self.structure().replaced.joints_of(pair).collect();
        for joint in joints {
            match &self.structure().replaced.joint(joint).kind {
                JointKind::Prismatic { .. } => {
                    return Some((self.rate_of_effort(0, EffortKind::Coordinate(joint))?, false));
                }
                JointKind::Revolute(members) if joint_count(self, pair) == 1 => {
                    let [first, second] = members.as_slice() else { return None };
                    let kind = EffortKind::RelativeAngle { joint, first: first.0, second: second.0 };
                    return Some((self.rate_of_effort(0, kind)?, true));
                }
                JointKind::Revolute(_) | JointKind::Weld { .. } | JointKind::Law(_) => {}
            }
        }
        None
    }

    /// Kinetic energy at both ends, and the work between them.
    fn balance_of_energy(&mut self, report: &SimulationReport) {
        let Some(energy) = report.energy else { return };
        self.say(RunMessage::EnergyOfRun, &[]);
        let begin = self.stated(Name::new("T", "1"), energy.begin, Unit::Work);
        let end = self.stated(Name::new("T", "2"), energy.end, Unit::Work);
        let work = self.stated(Name::new("W", ""), energy.work, Unit::Work);
        let right = end - begin - work;
        let value = right.value();
        self.confirm(Name::new("Δ", "T"), value, Unit::Work, right);
    }

    /// Where every event of a motion or of a sweep happens.
    fn events(&mut self) {
        let (mechanism, statics) = (self.scene.mechanism(), &self.scene.solution.statics);
        let along = statics.along(mechanism);
        let (said, place) = match &statics.swept {
            None => (RunMessage::EventsOfRun, self.words(RunMessage::Instants)),
            Some(swept) => {
                let name = &mechanism.drives[swept.drive].name;
                (RunMessage::EventsOfSweep, format!("{name}, {}", along.unit))
            }
        };
        let mut rows = Vec::new();
        for (event, places) in mechanism.events.iter().zip(&statics.events) {
            let shown = |at: &f64| {
                with_digits(if statics.swept.is_some() { along.of_si(*at) } else { *at }, 6).text()
            };
            let shown: Vec<String> = places.iter().take(8).map(shown).collect();
            let written = if shown.is_empty() { "–".to_owned() } else { shown.join(", ") };
            rows.push(vec![
                vec![text(event.name.clone().unwrap_or_else(|| "until".to_owned()))],
                vec![text(written)],
            ]);
        }
        let headers = [self.words(RunMessage::Event), place].map(|head| vec![text(head)]).to_vec();
        if !rows.is_empty() {
            self.say(said, &[]);
            self.table(Table { headers, rows, numbers: Vec::new() });
        }
    }
}

/// How many joints stand for a pair.
fn joint_count(course: &Derivation<'_>, pair: PairId) -> usize {
    course.structure().replaced.joints_of(pair).count()
}
