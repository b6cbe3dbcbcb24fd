//! The reduced masses of several free coordinates, from how the links move per unit rate of each.

use crate::course::Derivation;
use crate::words::RunMessage;
use assur_formula::{Expr, Name, Unit};
use assur_math::math::ROUNDING;
use assur_model::model::{DriveTarget, LinkId, MassProperties};
use assur_position::position::{Reduced, turns};
use assur_solve::solve::SimulationReport;

/// A free coordinate: its letters, and whether it is an angle.
struct Coordinate {
    label: String,
    turns: bool,
    target: DriveTarget,
}

/// How a link moves per unit rate of a coordinate.
struct Transfer {
    centre: [Expr; 2],
    turn: Expr,
}

/// A product; of one with itself the square.
fn times(a: &Expr, b: &Expr, same: bool) -> Expr {
    if same { a.clone().squared() } else { a.clone() * b.clone() }
}

impl Derivation<'_> {
    /// The masses of all pairs of coordinates, and the kinetic energy by them; where something is driven, nothing.
    pub(super) fn reduced_masses(&mut self, report: &SimulationReport, energy: &Expr) {
        let Some(coordinates) = self.coordinates_of(report) else { return };
        let plan = self.scene.model.plan;
        let Some(reduced) = Reduced::at(plan, &report.coordinates, self.state()) else { return };
        let mut rates = Vec::new();
        for coordinate in &coordinates {
            let Some((rate, _)) = self.rate_of_drive(coordinate.target) else { return };
            rates.push(rate);
        }
        self.say(RunMessage::ReducedSeveral, &[]);
        let links: Vec<(usize, MassProperties)> = (self.scene.mechanism().links.iter().enumerate().skip(1))
            .filter_map(|(i, link)| Some((i, link.mass?)))
            .collect();
        let mut transfers = Vec::new();
        for (i, coordinate) in coordinates.iter().enumerate() {
            let of_link = |(link, mass): &(usize, MassProperties)| {
                self.transfer(*link, mass, coordinate, reduced.unit_motion(i, *link))
            };
            transfers.push(links.iter().map(of_link).collect::<Vec<Transfer>>());
        }
        let mut sum = Expr::ZERO;
        let count = coordinates.len();
        for i in 0..count {
            for j in i..count {
                let mut right = Expr::ZERO;
                for ((link, mass), (a, b)) in links.iter().zip(transfers[i].iter().zip(&transfers[j])) {
                    let name = Name::new("m", &self.label(*link));
                    let own = self.found.get(&name).cloned();
                    let own = own.unwrap_or_else(|| self.given(name, mass.mass, Unit::Mass));
                    let moved =
                        times(&a.centre[0], &b.centre[0], i == j) + times(&a.centre[1], &b.centre[1], i == j);
                    let point = self.point_name(*link, mass.centre);
                    let inertia = self.given(Name::new("J", &point), mass.inertia, Unit::Inertia);
                    right = right + own * moved + inertia * times(&a.turn, &b.turn, i == j);
                }
                let index = format!("{},{}", coordinates[i].label, coordinates[j].label);
                let unit = match (coordinates[i].turns, coordinates[j].turns) {
                    (true, true) => Unit::Inertia,
                    (false, false) => Unit::Mass,
                    _ => Unit::MassLength,
                };
                let value = reduced.mass()[i * count + j];
                let mass = self.equate(Name::new("m", &index), value, unit, right);
                let both = mass * times(&rates[i], &rates[j], i == j);
                sum = sum + if i == j { both / Expr::Int(2) } else { both };
            }
        }
        if !sum.is_zero() {
            self.say(RunMessage::EnergyReduced, &[]);
            self.confirm(Name::new("T", ""), energy.value(), Unit::Work, sum);
        }
    }

    /// The coordinates, where there are several and nothing else moves the links.
    fn coordinates_of(&self, report: &SimulationReport) -> Option<Vec<Coordinate>> {
        let drives = &self.scene.mechanism().drives;
        if report.coordinates.len() < 2 || report.coordinates.len() != drives.len() {
            return None;
        }
        let of = |i: &usize| {
            let drive = drives.get(*i)?;
            let label = match drive.target {
                DriveTarget::Link(link) => self.label(link.index()),
                DriveTarget::Pair(pair) => self.scene.mechanism().pair(pair).name.clone(),
                DriveTarget::Point(..) | DriveTarget::Place(..) => return None,
            };
            Some(Coordinate { label, turns: turns(&self.scene.model, drive), target: drive.target })
        };
        report.coordinates.iter().map(of).collect()
    }

    fn transfer(
        &mut self,
        link: usize,
        mass: &MassProperties,
        coordinate: &Coordinate,
        (origin, turn): (assur_math::math::Vec2, f64),
    ) -> Transfer {
        let moved = self.moved(link);
        let centre = origin + mass.centre.turned(moved.u).perp() * turn;
        let (along, about) =
            if coordinate.turns { (Unit::Length, Unit::One) } else { (Unit::One, Unit::PerLength) };
        let point = self.point_name(link, mass.centre);
        let label = self.label(LinkId::at(link).index());
        let mut stated = |index: String, value: f64, large: f64, unit| {
            if value.abs() <= ROUNDING * large {
                return Expr::ZERO;
            }
            self.stated(Name::new("k", &format!("{index},{}", coordinate.label)), value, unit)
        };
        let large = centre.norm();
        Transfer {
            centre: [
                stated(format!("{point}x"), centre.x, large, along),
                stated(format!("{point}y"), centre.y, large, along),
            ],
            turn: if mass.inertia > 0.0 { stated(label, turn, turn.abs(), about) } else { Expr::ZERO },
        }
    }
}
