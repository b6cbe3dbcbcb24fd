//! What two runs differ by, kind by kind: the error of the coarser one.

use super::equations::Equations;
use super::run::Run;
use crate::position::{BodyState, extent};

/// Kinds of results whose errors are judged apart.
const KINDS: [&str; 8] = [
    "positions",
    "directions",
    "velocities",
    "angular velocities",
    "accelerations",
    "angular accelerations",
    "forces",
    "moments",
];

/// The worst difference.
pub(super) struct Compared {
    /// Relative to the greatest magnitude of its kind.
    pub error: f64,
    /// Its kind.
    pub worst: &'static str,
}

impl Compared {
    /// Compares two runs at the instants that both have reached.
    pub fn of(equations: &mut Equations<'_, '_>, coarse_run: &Run, fine_run: &Run) -> Self {
        let (coarse, fine) = (&coarse_run.records, &fine_run.records);
        let mut kinds = coarse_run.kinds.clone();
        let mut bodies: Vec<BodyState> = Vec::new();
        let mut forces: Vec<Efforts> = Vec::new();
        let both = coarse.count.min(fine.count);
        for index in 0..both {
            equations.place(
                coarse.times[index],
                coarse.state(index),
                coarse.accelerations(index),
                coarse.stand(index),
            );
            bodies.clone_from(&equations.trial.motion.bodies);
            forces.clear();
            forces.extend(efforts(equations));
            equations.place(
                fine.times[index],
                fine.state(index),
                fine.accelerations(index),
                fine.stand(index),
            );
            kinds.bodies(&bodies, &equations.trial.motion.bodies);
            kinds.forces(forces.iter().copied().zip(efforts(equations)));
        }
        // what only one of them reached is not known
        let events = coarse_run.events.iter().zip(&fine_run.events);
        let differ = coarse.count != fine.count || events.clone().any(|(a, b)| a.len() != b.len());
        // where both come to a halt, they do so at instants that differ a little
        let missing = differ && !(coarse_run.stopped.is_some() && fine_run.stopped.is_some());
        let mut worst = kinds.worst(extent(equations.model), missing);
        let length = fine_run.end - equations.from;
        for (a, b) in events.flat_map(|(a, b)| a.iter().zip(b)) {
            worst.look((a - b).abs() / length, "instants of events");
        }
        for (a, b) in coarse_run.functions.iter().zip(&fine_run.functions) {
            let difference = (a.0 - b.0).abs();
            worst.look(if difference == 0.0 { 0.0 } else { difference / b.1 }, "functions over the run");
        }
        worst
    }
}

impl Compared {
    fn look(&mut self, error: f64, kind: &'static str) {
        if error > self.error {
            (self.error, self.worst) = (error, kind);
        }
    }
}

/// Both components of a reaction and its couple.
type Efforts = (f64, f64, f64);

/// Reactions, where they are asked for.
fn efforts<'e>(equations: &'e Equations<'_, '_>) -> impl Iterator<Item = Efforts> + 'e {
    let asked = equations.model.plan.effects.forces;
    let reactions = equations.trial.forces.reactions.iter().filter(move |_| asked);
    reactions.map(|r| (r.force.x, r.force.y, r.couple))
}

/// The greatest difference and the greatest magnitude of each kind.
#[derive(Clone, Debug, Default)]
pub(super) struct Kinds {
    difference: [f64; 8],
    magnitude: [f64; 8],
}

impl Kinds {
    fn look(&mut self, kind: usize, difference: f64, magnitude: f64) {
        // what is not a number is the worst there is
        let difference = if difference.is_nan() { f64::INFINITY } else { difference };
        self.difference[kind] = self.difference[kind].max(difference);
        self.magnitude[kind] = self.magnitude[kind].max(magnitude);
    }

    /// The magnitudes at the end of a step: what is small at every instant that is printed may be small beside the motion.
    pub fn measure(&mut self, equations: &Equations<'_, '_>) {
        let bodies = &equations.trial.motion.bodies;
        self.bodies(bodies, bodies);
        self.forces(efforts(equations).zip(efforts(equations)));
    }

    fn bodies(&mut self, coarse: &[BodyState], fine: &[BodyState]) {
        for (a, b) in coarse.iter().zip(fine) {
            self.look(0, (a.p - b.p).norm(), 0.0);
            self.look(1, (a.u - b.u).norm(), 1.0);
            self.look(2, (a.v - b.v).norm(), b.v.norm());
            self.look(3, (a.omega - b.omega).abs(), b.omega.abs());
            self.look(4, (a.a - b.a).norm(), b.a.norm());
            self.look(5, (a.alpha - b.alpha).abs(), b.alpha.abs());
        }
    }

    /// The same efforts of both runs.
    fn forces(&mut self, both: impl Iterator<Item = (Efforts, Efforts)>) {
        for (a, b) in both {
            self.look(6, libm::hypot(a.0 - b.0, a.1 - b.1), libm::hypot(b.0, b.1));
            self.look(7, (a.2 - b.2).abs(), b.2.abs());
        }
    }

    fn worst(&self, extent: f64, missing: bool) -> Compared {
        let mut worst = Compared { error: if missing { f64::INFINITY } else { 0.0 }, worst: KINDS[0] };
        for (kind, name) in KINDS.into_iter().enumerate() {
            let scale = if kind == 0 { extent.max(self.magnitude[0]) } else { self.magnitude[kind] };
            let error = if self.difference[kind] == 0.0 { 0.0 } else { self.difference[kind] / scale };
            if error > worst.error {
                worst = Compared { error, worst: name };
            }
        }
        worst
    }
}
