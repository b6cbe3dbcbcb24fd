//! Groups without a closed form: every constraint of the solver as an equation.

use super::whole::{Row, Unknowns};
use crate::angle::Angle;
use crate::course::{Body, Derivation};
use crate::document::text;
use crate::words::Message;
use assur_formula::{Expr, Name, Unit};
use assur_math::group::general::{Constraint, Geared, General, Line, Point, Pose};
use assur_math::math::Vec2;
use assur_position::plan::GeneralMotion;
use assur_solve::solve::Iteration;
use std::collections::BTreeSet;

/// What is found of the bodies of a group: x, y of the origin, and the direction.
struct Placed<'a> {
    group: &'a GeneralMotion,
    origins: Vec<[Expr; 2]>,
    angles: Vec<Angle>,
}

impl Derivation<'_> {
    /// The positions of a general group. Whether it closes with what is written.
    pub(super) fn general_group(
        &mut self,
        branch: usize,
        group: &GeneralMotion,
        found: &Iteration,
        index: usize,
    ) -> bool {
        let Some(equations) = &group.equations else { return false };
        let own = &group.bodies[..group.moving];
        let count = (3 * own.len()).to_string();
        let kind = self.group_kind(&self.structure().motion[index]);
        self.say(Message::AllTogether, &[vec![text(kind)], vec![text(count)]]);
        let unknowns = own.iter().map(|slot| ["x", "y", "φ"].map(|l| Name::new(l, &self.label(*slot))));
        let unknowns: Vec<Unknowns> = unknowns.collect();
        let stands = own.iter().map(|slot| self.moved(*slot)).map(|m| Pose { p: m.p, u: m.u });
        let stands: Vec<Pose> = stands.collect();
        let rows = self.names_of_rows(group, equations);
        let values = self.newton(found, &unknowns, &rows, &stands);
        let origins = values.iter().map(|[x, y, _]| [x.clone(), y.clone()]).collect();
        let angles = values.iter().map(|[_, _, phi]| Angle::of(phi.clone())).collect();
        let placed = Placed { group, origins, angles };
        let left = self.rows_with(branch, equations, &placed);
        let left = rows.into_iter().zip(left).map(|(name, (unit, left))| (name, unit, left));
        let closes = self.left_with(left.collect::<Vec<Row>>());
        for (place, &slot) in own.iter().enumerate() {
            let reference = self.some_point(slot);
            let name = self.point_name(slot, reference);
            if !self.points[0].contains_key(&name) {
                let right = self.carried(&placed, place, reference);
                let value = self.moved(slot).position(reference);
                self.coordinates(&name, value, right);
            }
            let (angle, rates) = (placed.angles[place].clone(), [Expr::ZERO, Expr::ZERO]);
            self.bodies[slot] = Some(Body { reference, angle, rates });
        }
        closes
    }

    /// The names of the equations, in the order of the solver: Δ with what it is of.
    fn names_of_rows(&self, group: &GeneralMotion, equations: &General) -> Vec<Name> {
        let label = |place: usize| self.label(group.bodies[place]);
        let mut names = Vec::new();
        for constraint in &equations.constraints {
            match constraint {
                Constraint::Revolute { a, .. } | Constraint::Distance { a, .. } => {
                    let point = self.point_name(group.bodies[a.body], a.r);
                    let all = ["x", "y"].map(|axis| Name::new("Δ", &format!("{point}{axis}")));
                    names.extend(all.into_iter().take(constraint.rows()));
                }
                Constraint::Angle { a, b, .. } => {
                    names.push(Name::new("Δφ", &format!("{},{}", label(*b), label(*a))));
                }
                Constraint::Offset { point, line, .. } => {
                    names.push(
                        Name::new("Δ", &format!("{},{}", label(point.body), label(line.body))).marked("n"),
                    );
                }
                Constraint::Coordinate { point, line, .. } => {
                    names.push(
                        Name::new("Δ", &format!("{},{}", label(point.body), label(line.body))).marked("s"),
                    );
                }
            }
        }
        let laws = group.laws.iter().map(|slot| {
            let pair = self.scene.model.plan.laws[*slot].pair;
            Name::new("Δ", &self.scene.mechanism().pair(pair).name)
        });
        names.extend(laws);
        let mut taken = BTreeSet::new();
        for name in &mut names {
            while !taken.insert(name.clone()) {
                name.letter.push('′');
            }
        }
        names
    }

    /// What is left of every equation.
    fn rows_with(&mut self, branch: usize, equations: &General, placed: &Placed<'_>) -> Vec<(Unit, Expr)> {
        let group = placed.group;
        let inputs = &self.state().motion.inputs;
        let sides = self.state().branches[branch].general_sides;
        let mut rows = Vec::new();
        for (index, constraint) in equations.constraints.iter().enumerate() {
            let drive = group.driven.iter().find(|d| d.0 == index).map(|d| inputs[d.1]);
            match *constraint {
                Constraint::Revolute { a, b } | Constraint::Distance { a, b, .. } => {
                    let (a, b) = (self.carried(placed, a.body, a.r), self.carried(placed, b.body, b.r));
                    rows.extend(a.into_iter().zip(b).map(|(a, b)| (Unit::Length, a - b)));
                }
                Constraint::Angle { a, b, angle, .. } => {
                    let angle = drive.map_or(angle, |input| input.place);
                    rows.push((Unit::Angle, self.angle_left(placed, [a, b], angle, drive.is_some())));
                }
                Constraint::Offset { point, line, law } => {
                    let round = group.round.iter().position(|r| r.0 == index);
                    let value = match round {
                        Some(bit) if sides >> bit & 1 == 1 => -group.round[bit].1,
                        Some(bit) => group.round[bit].1,
                        None => law.value,
                    };
                    let h = Name::new("h", &self.label(group.bodies[point.body]));
                    let h = self.given(h, value, Unit::Length);
                    let (d, guide) = self.against_line(placed, point, line);
                    rows.push((Unit::Length, guide.across(&d) - h));
                }
                Constraint::Coordinate { point, line, law } => {
                    let value = drive.map_or(law.value, |input| input.value);
                    let s = Name::new("s", &self.label(group.bodies[point.body])).marked("∗");
                    let s = self.given(s, value, Unit::Length);
                    let (d, guide) = self.against_line(placed, point, line);
                    rows.push((Unit::Length, guide.along(&d) - s));
                }
            }
        }
        for (law, slot) in equations.laws.iter().zip(&group.laws) {
            let angles = law.terms.iter().all(|term| matches!(term.of, Geared::Turn { .. }));
            let (unit, scale) =
                if angles { (Unit::Angle, 180.0 / std::f64::consts::PI) } else { (Unit::Length, 1.0) };
            let pair = self.scene.model.plan.laws[*slot].pair;
            let pair = self.scene.mechanism().pair(pair).name.clone();
            let mut left = Expr::ZERO;
            for (k, term) in law.terms.iter().enumerate() {
                let name = Name::new("c", &format!("{pair}{}", k + 1));
                let factor = match term.coefficient {
                    c if c == c.round() && c.abs() < 1e6 => Expr::Int(c as i64),
                    c => self.given(name, c, if angles { Unit::One } else { Unit::Length }),
                };
                left = left + factor * self.geared(placed, &term.of, angles);
            }
            let constant = self.given(Name::new("c", &format!("{pair}0")), law.value * scale, unit);
            rows.push((unit, left - constant));
        }
        rows
    }

    /// A coordinate that a law speaks of: an angle with its whole turns, or a way along a line.
    fn geared(&mut self, placed: &Placed<'_>, of: &Geared, degrees: bool) -> Expr {
        match *of {
            Geared::Turn { body, .. } => {
                let slot = placed.group.bodies[body];
                let angle = self.angle_of(placed, body).whole();
                let turns = ((self.moved(slot).turned.to_degrees() - angle.value()) / 360.0).round();
                let angle = angle + Expr::Degrees(360 * turns as i64);
                if degrees { angle } else { Expr::Pi * angle / Expr::Int(180) }
            }
            Geared::Slide { point, line } => {
                let (d, guide) = self.against_line(placed, point, line);
                guide.along(&d)
            }
        }
    }

    /// φ_b − φ_a less what it has to be; whole turns are taken off.
    fn angle_left(&mut self, placed: &Placed<'_>, [a, b]: [usize; 2], angle: Vec2, driven: bool) -> Expr {
        let label = self.label(placed.group.bodies[b]);
        let name = if driven { Name::new("φ", &label).marked("∗") } else { Name::new("γ", &label) };
        let wanted = self.direction_given(angle, || name);
        let right = self.angle_of(placed, b).minus(&self.angle_of(placed, a)).minus(&wanted).whole();
        let turns = (right.value() / 360.0).round() as i64;
        right - Expr::Degrees(360 * turns)
    }

    fn angle_of(&self, placed: &Placed<'_>, place: usize) -> Angle {
        match placed.angles.get(place) {
            Some(angle) => angle.clone(),
            None => self.bodies[placed.group.bodies[place]].as_ref().map_or(Angle::ZERO, |b| b.angle.clone()),
        }
    }

    /// A point against the origin of a line, and the direction of that.
    fn against_line(&mut self, placed: &Placed<'_>, point: Point, line: Line) -> ([Expr; 2], Angle) {
        let p = self.carried(placed, point.body, point.r);
        let [x, y] = self.carried(placed, line.body, line.r);
        let label = self.label(placed.group.bodies[point.body]);
        let own = self.direction_given(line.d, || Name::new("λ", &label));
        let [px, py] = p;
        ([px - x, py - y], self.angle_of(placed, line.body).plus(&own))
    }

    /// A point of a body by the unknowns of that body alone.
    fn carried(&mut self, placed: &Placed<'_>, place: usize, at: Vec2) -> [Expr; 2] {
        let slot = placed.group.bodies[place];
        let Some([x, y]) = placed.origins.get(place).cloned() else { return self.position(slot, at) };
        if at.norm() <= self.tiny {
            return [x, y];
        }
        let (from, to) = (self.point_name(slot, Vec2::zero()), self.point_name(slot, at));
        let index = crate::course::joined(&from, &to);
        let length = self.length(&from, &to, at.norm());
        let own = self.direction_given(at, || Name::new("γ", &index));
        let angle = placed.angles[place].plus(&own);
        [x + length.clone() * angle.cos(), y + length * angle.sin()]
    }
}
