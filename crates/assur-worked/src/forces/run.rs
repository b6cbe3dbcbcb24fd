//! A motion under given loads: kinetic energy, reduced mass and reduced load at the instant that is shown, the balance of energy
//! of the run, its events.

use crate::course::Derivation;
use crate::document::text;
use crate::words::RunMessage;
use assur_formula::{Expr, Name, Unit, with_digits};
use assur_solve::solve::{Method, SimulationReport};

impl Derivation<'_> {
    /// The section of a motion under loads.
    pub fn run(&mut self) {
        let Some(report) = self.scene.solution.simulation.as_ref() else { return self.events() };
        let heading = self.words(RunMessage::AtInstant);
        self.heading(2, heading);
        let energy = self.kinetic_energy();
        if let Some(energy) = energy {
            self.reduced_motion(report, &energy);
            self.reduced_masses(report, &energy);
        }
        self.balance_of_energy(report);
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
}
