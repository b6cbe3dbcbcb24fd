//! The equation of motion of one free coordinate: its reduced mass from what all links move per unit of it, the derivative of that
//! mass, the reduced load, and the acceleration which they give.

use super::is_load;
use crate::course::Derivation;
use crate::document::letter;
use crate::words::RunMessage;
use assur_formula::{Expr, Name, Sign, Unit};
use assur_math::math::SAME;
use assur_model::model::{DriveTarget, MassProperties, PairId};
use assur_model::structure::{EffortKind, JointKind};
use assur_position::position::Origin;
use assur_solve::solve::SimulationReport;

/// A speed below this part of the greatest is none.
const STILL: f64 = 1e-9;

/// The free coordinate: its rate and its acceleration, and whether it is an angle.
struct Coordinate {
    rate: Expr,
    acceleration: Expr,
    turns: bool,
}

/// What moves per unit of the coordinate, and its derivative by the coordinate.
struct Transfer {
    first: Expr,
    second: Expr,
}

/// A mass, or a moment of inertia, with what moves it.
struct Moved {
    mass: Expr,
    by: Vec<Transfer>,
}

impl Derivation<'_> {
    /// The equation of motion of the one free coordinate at this instant.
    pub(super) fn reduced_motion(&mut self, report: &SimulationReport, energy: &Expr) {
        let [drive] = report.coordinates.as_slice() else { return };
        let Some(coordinate) = self.coordinate_of(*drive) else { return };
        let (letter, unit) = if coordinate.turns { ("J", Unit::Inertia) } else { ("m", Unit::Mass) };
        let before = self.blocks.len();
        self.say(RunMessage::Transfers, &[]);
        let moved = self.all_moved(&coordinate);
        if self.blocks.len() == before + 1 {
            self.blocks.truncate(before);
        }
        self.say(RunMessage::Reduced, &[]);
        let right = Expr::sum(moved.iter().flat_map(|own| {
            own.by.iter().map(|transfer| own.mass.clone() * transfer.first.clone().squared())
        }));
        let value = 2.0 * energy.value() / (coordinate.rate.value() * coordinate.rate.value());
        let mass = self.equate(Name::new(letter, "r"), value, unit, right);
        let kinetic = mass.clone() * coordinate.rate.clone().squared() / Expr::Int(2);
        self.say(RunMessage::EnergyReduced, &[]);
        self.confirm(Name::new("T", ""), energy.value(), Unit::Work, kinetic.clone());
        self.work_until(report, kinetic);
        self.equation_of_motion(&coordinate, mass, &moved);
    }

    /// The coordinate, where it alone moves the links, and moves them.
    fn coordinate_of(&mut self, drive: usize) -> Option<Coordinate> {
        let drives = &self.scene.mechanism().drives;
        let target = drives.get(drive).filter(|_| drives.len() == 1)?.target;
        let (rate, turns) = self.rate_of_drive(target)?;
        let fastest = self.state().motion.bodies.iter().map(|b| b.omega.abs().max(b.v.norm()));
        if rate.value().abs() <= STILL * fastest.fold(0.0, f64::max) {
            return None;
        }
        let value = self.state().motion.inputs[drive].acceleration;
        let own = match target {
            DriveTarget::Link(link) => {
                self.bodies[self.body_of(link.index())].as_ref().map(|b| b.rates[1].clone())
            }
            _ => None,
        };
        let own = own.filter(|own| (own.value() - value).abs() <= SAME * own.scale().max(value.abs()));
        let (letter, unit) =
            if turns { ("α", Unit::AngularAcceleration) } else { ("a", Unit::Acceleration) };
        let acceleration = match own {
            Some(own) => own,
            None => {
                self.say(RunMessage::AccelerationHere, &[]);
                self.stated(Name::new(letter, "r"), value, unit)
            }
        };
        Some(Coordinate { rate, acceleration, turns })
    }

    /// All masses and moments of inertia with their transfer functions.
    fn all_moved(&mut self, coordinate: &Coordinate) -> Vec<Moved> {
        let links: Vec<(usize, MassProperties)> = (self.scene.mechanism().links.iter().enumerate().skip(1))
            .filter_map(|(i, link)| Some((i, link.mass?)))
            .collect();
        let mut all = Vec::new();
        for (i, own) in links {
            if own.mass > 0.0 {
                let (v, a) = (self.velocity(i, own.centre), self.acceleration(i, own.centre));
                let point = self.point_name(i, own.centre);
                let mut by = Vec::new();
                for ((letter, v), a) in ["x", "y"].into_iter().zip(v).zip(a) {
                    by.extend(self.transfer_function(letter, &point, coordinate, (v, a)));
                }
                let name = Name::new("m", &self.label(i));
                let mass = self.found.get(&name).cloned();
                let mass = mass.unwrap_or_else(|| self.given(name, own.mass, Unit::Mass));
                all.push(Moved { mass, by });
            }
            let rates = self.bodies[self.body_of(i)].as_ref().map(|body| body.rates.clone());
            let Some([omega, alpha]) = rates.filter(|_| own.inertia > 0.0) else { continue };
            let by =
                self.transfer_function("u", &self.label(i), coordinate, (omega, alpha)).into_iter().collect();
            let point = self.point_name(i, own.centre);
            all.push(Moved { mass: self.given(Name::new("J", &point), own.inertia, Unit::Inertia), by });
        }
        all.retain(|moved| !moved.by.is_empty());
        all
    }

    /// The velocity over the rate of the coordinate, and its derivative; none of what does not move.
    fn transfer_function(
        &mut self,
        letter: &str,
        index: &str,
        coordinate: &Coordinate,
        (velocity, acceleration): (Expr, Expr),
    ) -> Option<Transfer> {
        let Coordinate { rate, acceleration: own, turns } = coordinate;
        if velocity.is_zero() {
            return None;
        }
        for (same, sign) in [(rate.clone(), 1), (-rate.clone(), -1)] {
            if velocity == same {
                return Some(Transfer { first: Expr::Int(sign), second: Expr::ZERO });
            }
        }
        let is_angle = letter == "u";
        let (once, twice) = match (is_angle, turns) {
            (true, true) => (Unit::One, Unit::One),
            (false, true) => (Unit::Length, Unit::Length),
            (true, false) => (Unit::PerLength, Unit::PerArea),
            (false, false) => (Unit::One, Unit::PerLength),
        };
        let primes = if is_angle { ["", "′"] } else { ["′", "″"] };
        let [first, second] = primes.map(|primes| Name::new(&format!("{letter}{primes}"), index));
        let right = velocity / rate.clone();
        let first = self.equate(first, right.value(), once, right);
        let right = (acceleration - first.clone() * own.clone()) / rate.clone().squared();
        let second =
            if is_nothing(&right) { Expr::ZERO } else { self.equate(second, right.value(), twice, right) };
        Some(Transfer { first, second })
    }

    /// What the loads have done since the first instant has become kinetic energy.
    fn work_until(&mut self, report: &SimulationReport, kinetic: Expr) {
        let (work, Some(energy)) = (self.state().motion.work, report.energy) else { return };
        let off = (kinetic.value() - energy.begin - work).abs();
        if !work.is_finite() || off > SAME.max(report.error) * (kinetic.value().abs() + work.abs()) {
            return;
        }
        let name = Name::new("W", "t");
        self.say(RunMessage::WorkHere, &[vec![letter(&name)]]);
        let begin = self.stated(Name::new("T", "1"), energy.begin, Unit::Work);
        let work = self.stated(name, work, Unit::Work);
        let right = kinetic - begin - work;
        let value = right.value();
        self.confirm(Name::new("Δ", "T"), value, Unit::Work, right);
    }

    /// α = (M_r − ½ J_r′ ω²) / J_r; where something else acts than is known here, the loads alone.
    fn equation_of_motion(&mut self, coordinate: &Coordinate, mass: Expr, moved: &[Moved]) {
        let is_wanted = |from| is_load(from, true) && from != Some(Origin::Inertia);
        let power = Expr::sum(self.powers_on(&self.moving(), is_wanted));
        let (letters, units) = if coordinate.turns {
            (["M", "J′"], [Unit::Torque, Unit::Inertia])
        } else {
            (["F", "m′"], [Unit::Force, Unit::MassPerLength])
        };
        let load = if power.is_zero() {
            Expr::ZERO
        } else {
            self.say(RunMessage::ReducedLoad, &[]);
            let right = over(power, &coordinate.rate);
            let value = right.value();
            self.equate(Name::new(letters[0], "r"), value, units[0], right)
        };
        let slope = Expr::sum(moved.iter().flat_map(|own| {
            let twice = Expr::Int(2) * own.mass.clone();
            own.by.iter().map(move |by| twice.clone() * by.first.clone() * by.second.clone())
        }));
        let half = slope.clone() * coordinate.rate.clone().squared() / Expr::Int(2);
        let whole = (load.clone() - half) / mass.clone();
        let (found, known) = (whole.value(), coordinate.acceleration.value());
        if (found - known).abs() > SAME * whole.scale().max(known.abs()) {
            return;
        }
        let mut left = load;
        if !slope.is_zero() {
            self.say(RunMessage::Slope, &[]);
            let (value, constant) = (slope.value(), is_nothing(&slope));
            let slope = self.equate(Name::new(letters[1], "r"), value, units[1], slope);
            if !constant {
                left = left - slope * coordinate.rate.clone().squared() / Expr::Int(2);
            }
        }
        self.say(RunMessage::ReducedMotion, &[]);
        let name = match &coordinate.acceleration {
            Expr::Leaf(q) => q.name.clone(),
            _ => Name::new(if coordinate.turns { "α" } else { "a" }, "r"),
        };
        let unit = if coordinate.turns { Unit::AngularAcceleration } else { Unit::Acceleration };
        self.confirm(name, known, unit, left / mass);
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
}

/// How many joints stand for a pair.
fn joint_count(course: &Derivation<'_>, pair: PairId) -> usize {
    course.structure().replaced.joints_of(pair).count()
}

/// Whether it is nothing but rounding.
fn is_nothing(sum: &Expr) -> bool {
    sum.value().abs() <= SAME * sum.scale()
}

/// A power over a rate: terms with the rate as a factor leave it out.
fn over(power: Expr, rate: &Expr) -> Expr {
    match power {
        Expr::Sum(terms) => Expr::sum(terms.into_iter().map(|(sign, term)| match sign {
            Sign::Plus => over(term, rate),
            Sign::Minus => -over(term, rate),
        })),
        Expr::Neg(term) => -over(*term, rate),
        Expr::Product(mut factors) => match factors.iter().position(|factor| factor == rate) {
            Some(at) => {
                factors.remove(at);
                factors.into_iter().fold(Expr::Int(1), |product, factor| product * factor)
            }
            None => Expr::Product(factors) / rate.clone(),
        },
        other if other == *rate => Expr::Int(1),
        other => other / rate.clone(),
    }
}
