//! The equations of a mechanism: each is written once, with its derivatives by time, for every number. Its gradient is what
//! unit rates of its bodies make of its rate.

use super::body::BodyState;
use super::jet::{Jet, Moving};
use super::kinematics::{DriveInput, Motion};
use super::precise::Edge;
use crate::element::cam::Follower;
use crate::math::{Angular, V2};
use crate::plan::equation::{Coordinate, Equation, GuideRow};
use crate::plan::step::unit;
use crate::plan::{CamStep, GenevaStep, Plan};

/// Where bodies are and how they move, and what else equations read.
pub struct At<'a, S> {
    pub plan: &'a Plan,
    pub bodies: &'a [BodyState<S>],
    pub inputs: &'a [DriveInput<S>],
    /// The same position, for what is chosen in it: on which side of a line a profile is, in which slot a pin.
    pub chosen: &'a Motion,
}

impl<S: Edge + Angular> At<'_, S> {
    /// The left side of an equation with its derivatives by time.
    #[must_use]
    pub fn jet(&self, equation: &Equation) -> Jet<S> {
        match equation {
            Equation::Together { a, b, axis } => {
                let [a, b] = [a, b].map(|pin| Moving::point(&self.bodies[pin.body], pin.at));
                b.less(a).dot(Moving::turning(V2::of(*axis), [S::zero(); 3]))
            }
            Equation::Turned { a, b, drive } => {
                let [from, to] = [a, b].map(|(_, direction)| unit::<S>(*direction));
                match drive.map(|drive| &self.inputs[drive]) {
                    None => self.turned((a.0, from), (b.0, to), [S::zero(); 3]),
                    Some(input) => self.turned((a.0, input.place.turned(from)), (b.0, to), input.rates()),
                }
            }
            Equation::Beside(row, offset) => {
                let [line, point] = [row.line, row.point]
                    .map(|pin| (&self.chosen.bodies[pin.body], pin.at))
                    .map(|(body, at)| body.position(at));
                let along = row.along.turned(self.chosen.bodies[row.line.body].u);
                let side = if along.cross(point - line) < 0.0 { -offset } else { *offset };
                self.row(row).less(Jet::constant(S::of(side)))
            }
            Equation::Driven(row, drive) => {
                let input = &self.inputs[*drive];
                self.row(row).less(Jet::of(input.value, input.rates()))
            }
            Equation::Law(terms, constant) => {
                let constant = Jet::constant(S::of(-constant));
                terms.iter().fold(constant, |sum, (of, c)| sum.plus(self.coordinate(of).times(S::of(*c))))
            }
            Equation::Cam(cam) => self.follower(&self.plan.cams[*cam]),
            Equation::Geneva(wheel) => self.geneva(&self.plan.genevas[*wheel]),
        }
    }

    /// Direction b is direction a turned so fast.
    fn turned(&self, a: (usize, V2<S>), b: (usize, V2<S>), rates: [S; 3]) -> Jet<S> {
        let body = &self.bodies[a.0];
        let carried = body.turning();
        let target = Moving::turning(a.1.turned(body.u), std::array::from_fn(|i| carried[i] + rates[i]));
        target.cross(Moving::axis(&self.bodies[b.0], b.1))
    }

    fn row(&self, row: &GuideRow) -> Jet<S> {
        let along = unit::<S>(row.along);
        self.on_line(row, if row.across { along.perp() } else { along })
    }

    /// A point measured along a direction of the body of the line.
    fn on_line(&self, row: &GuideRow, direction: V2<S>) -> Jet<S> {
        let guide = &self.bodies[row.line.body];
        let apart =
            Moving::point(&self.bodies[row.point.body], row.point.at).less(Moving::point(guide, row.line.at));
        apart.dot(Moving::axis(guide, direction))
    }

    fn coordinate(&self, coordinate: &Coordinate) -> Jet<S> {
        match coordinate {
            Coordinate::Slide(row) => self.row(row),
            Coordinate::Turn(slot) => {
                let (body, near) = (&self.bodies[*slot], self.chosen.bodies[*slot].turned);
                let sine = S::direction(near).cross(body.u);
                // the next term of the arc is the fifth power
                let left = sine + sine * sine * sine / S::of(6.0);
                Jet::of(S::of(near) + left, body.turning())
            }
        }
    }

    /// The follower of a designed cam has the lift of its law.
    fn follower(&self, step: &CamStep) -> Jet<S> {
        let contact = &step.contact;
        let [frame, disk, follower] =
            [contact.frame, contact.disk, contact.follower].map(|link| &self.bodies[link.index()]);
        let sense = step.sense::<S>();
        let (e, lift) = step.lift(self.bodies);
        let (of_frame, of_disk) = (frame.turning(), disk.turning());
        let lift = Jet::through(lift, std::array::from_fn(|i| sense * (of_frame[i] - of_disk[i])));
        let lift = lift.plus(Jet::constant(step.start()));
        match step.cam.follower {
            Follower::Translating { .. } => {
                let apart =
                    Moving::point(follower, contact.point).less(Moving::point(frame, contact.frame_centre));
                apart.dot(Moving::turning(e, of_frame)).less(lift)
            }
            Follower::Oscillating { with_cam, .. } => {
                let side = step.side::<S>(with_cam);
                let (sin, cos) = lift.0[0].sine_cosine();
                let target = V2::new(-cos, -side * sin).turned(e);
                let rates = lift.rates();
                let rates = std::array::from_fn(|i| of_frame[i] + side * rates[i]);
                Moving::turning(target, rates).cross(Moving::axis(follower, unit(contact.direction)))
            }
        }
    }

    /// What the pin, or the arc, demands of a Geneva wheel. Whether the pin is in a slot, and in which, is chosen.
    fn geneva(&self, step: &GenevaStep) -> Jet<S> {
        let pair = &step.pair;
        if let Some(slot) = step.slot(self.chosen) {
            let row = GuideRow {
                point: crate::plan::Anchor { body: pair.crank.index(), at: pair.pin },
                line: crate::plan::Anchor { body: pair.wheel.index(), at: pair.hub },
                along: pair.slot,
                across: true,
            };
            return self.on_line(&row, slot.perp());
        }
        let [frame, wheel] = [pair.frame, pair.wheel].map(|link| &self.chosen.bodies[link.index()]);
        let back = -pair.towards.turned(frame.u);
        let turned = pair.slot.turned(wheel.u).turned_back(back).angle();
        let rest = step.halves::<S>((2.0 * turned / pair.law.pitch()).round());
        let from = rest.turned(-unit::<S>(pair.towards));
        self.turned((pair.frame.index(), from), (pair.wheel.index(), unit(pair.slot)), [S::zero(); 3])
    }
}
