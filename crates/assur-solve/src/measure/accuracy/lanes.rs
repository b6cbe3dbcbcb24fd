//! The closed forms in `f32` and in lanes of `f64`.

use super::answer::{Answer, wide_body, wide_reaction};
use super::error::errors;
use super::setting::{NotApplicable, Row};
use super::study::Measured;
use crate::math::{Double, Scalar};
use crate::measure::clock::micros;
use crate::solve::{Batch, DriveColumns, DriveInput, Place, WIDTH};
use std::hint::black_box;

/// A batch has at least this number of positions, repeated where the file has fewer.
const FILL: usize = 16 * WIDTH;

impl Measured<'_, '_> {
    pub(super) fn in_lanes(&mut self, rows: &mut Vec<Row>, absent: &mut Vec<NotApplicable>) {
        let (micros, error) = self.closed::<f32>();
        rows.push(Row::scalar("f32", micros, error, false));
        if (1..self.again.len()).all(|i| self.again.branches(i) == self.again.branches(0)) {
            let (micros, error) = self.lanes();
            rows.push(Row::scalar("f64 in lanes", micros, error, false));
        } else {
            absent.push(NotApplicable { what: "lanes", why: "an assembly changes during the motion" });
        }
    }

    fn lanes(&mut self) -> (f64, f64) {
        let plan = self.model.plan;
        let (count, drives) = (self.again.len(), plan.drives.max(1));
        let filled = count.max(FILL).next_multiple_of(FILL);
        let inputs: Vec<DriveInput> = self.inputs.iter().copied().cycle().take(filled * drives).collect();
        let inputs = DriveColumns::of(&inputs, drives);
        let mut lanes = Batch::new(plan, self.again.run(plan, 0));
        let (mut got, exact) = (vec![Answer::default(); count], &self.exact);
        lanes.run(&inputs, |i, place| {
            if i < count {
                got[i] = of_place(&place, &exact[i]);
            }
        });
        let error = errors(self.model, &self.scales, got.iter().zip(exact));
        let all = micros(self.clock, || {
            lanes.run(&inputs, |_, place| {
                black_box(place.open());
            });
        });
        (all / filled as f64, error.greatest())
    }
}

/// Of one position of a batch.
fn of_place(place: &Place<'_>, like: &Answer) -> Answer {
    if place.open().is_some() {
        return Answer::default();
    }
    Answer {
        bodies: (0..like.bodies.len()).map(|i| wide_body(&place.body(i))).collect(),
        reactions: (0..like.reactions.len()).map(|i| wide_reaction(&place.reaction(i))).collect(),
        efforts: (0..like.efforts.len()).map(|i| Double::of(place.effort(i))).collect(),
        load: like.load,
    }
}
