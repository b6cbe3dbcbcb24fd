//! What two runs differ by, kind by kind: the error of the coarser one.

use super::equations::Equations;
use super::functions::OverRun;
use super::records::Records;
use crate::answer::{LEAST_CONDITION, ROUNDING, Sizes};
use crate::model::Level;
use crate::plan::Effects;
use crate::position::BodyState;

/// Kinds of results whose errors are judged apart.
pub const KINDS: [&str; 12] = [
    "positions",
    "directions",
    "velocities",
    "angular velocities",
    "accelerations",
    "angular accelerations",
    "forces",
    "moments",
    "instants of events",
    "functions over the run",
    "works",
    "the steady motion",
];
/// Those of them that bodies and reactions have.
pub const STATES: usize = 8;

/// Rounding of positions, directions, velocities, accelerations and forces grows by this power of the condition.
const GROWS: [i32; STATES] = [1, 1, 2, 2, 3, 3, 3, 3];

/// How often they are differentiated.
const ORDERS: [usize; STATES] = [0, 0, 1, 1, 2, 2, 2, 2];

/// Works differ by rounding of both runs.
const SAME: f64 = 2.0;

/// What a run has found.
#[derive(Clone, Copy)]
pub(in crate::solve) struct Outcome<'r> {
    pub records: &'r Records,
    /// Instants of every event, s.
    pub events: &'r [Vec<f64>],
    /// Functions over the run.
    pub functions: &'r [OverRun],
    /// The greatest magnitudes of each kind, where they are measured.
    pub kinds: &'r Kinds,
    pub halted: bool,
    /// When a contact parts or a rope slackens, s, if it ends so.
    pub opens: Option<f64>,
    /// The last instant that was reached, s.
    pub end: f64,
}

pub(super) struct Compared {
    /// Relative to the greatest magnitude of its kind.
    pub error: f64,
    /// What both runs differ by, before an error is made of it.
    pub difference: f64,
    pub worst: &'static str,
    /// The differences of every kind.
    pub each: [f64; KINDS.len()],
    /// It is rounding: no finer run has less.
    pub is_rounding: bool,
}

impl Compared {
    pub const UNKNOWN: Self = Self {
        error: f64::INFINITY,
        difference: f64::INFINITY,
        worst: KINDS[0],
        each: [1.0; KINDS.len()],
        is_rounding: false,
    };

    /// Compares two runs at the instants that both have reached, each kind over the greatest magnitudes that were measured.
    pub fn of(
        equations: &mut Equations<'_, '_>,
        coarse_run: Outcome<'_>,
        fine_run: Outcome<'_>,
        measured: &Kinds,
    ) -> Self {
        let (coarse, fine) = (coarse_run.records, fine_run.records);
        equations.sizes.clone_from(&measured.sizes);
        equations.rough =
            std::array::from_fn(|kind| coarse_run.kinds.rough[kind].max(fine_run.kinds.rough[kind]));
        let mut kinds = measured.clone();
        let mut bodies: Vec<BodyState> = Vec::new();
        let mut forces: Vec<Efforts> = Vec::new();
        let both = coarse.count.min(fine.count);
        for index in 0..both {
            equations.place_record(coarse, index);
            bodies.clone_from(&equations.trial.motion.bodies);
            forces.clear();
            forces.extend(efforts(equations));
            equations.place_record(fine, index);
            let nothing = Kinds::nothing(equations);
            kinds.bodies(&bodies, &equations.trial.motion.bodies, &nothing);
            kinds.forces(forces.iter().copied().zip(efforts(equations)), &nothing);
        }
        // what only one of them reached is not known
        let events = coarse_run.events.iter().zip(fine_run.events);
        let differ = coarse.count != fine.count || events.clone().any(|(a, b)| a.len() != b.len());
        // where both come to a halt, they do so at instants that differ a little
        let missing = differ && !(coarse_run.halted && fine_run.halted);
        let mut found = kinds.worst(equations.extent(), missing, equations.model.plan.effects);
        let length = fine_run.end - equations.from;
        for (a, b) in events.flat_map(|(a, b)| a.iter().zip(b)) {
            found.update_max((a - b).abs() / length, STATES);
        }
        if let (Some(a), Some(b)) = (coarse_run.opens, fine_run.opens) {
            found.update_max((a - b).abs() / length, STATES);
        }
        found.works(coarse, fine, both);
        for (a, b) in coarse_run.functions.iter().zip(fine_run.functions) {
            let difference = (a.value - b.value).abs();
            found.update_max(if difference <= b.rounding { 0.0 } else { difference / b.scale }, STATES + 1);
        }
        found
    }

    /// Works, each beside its greatest magnitude.
    fn works(&mut self, coarse: &Records, fine: &Records, both: usize) {
        let count = coarse.works.len() / coarse.count.max(1);
        for id in 0..count {
            let of = |records: &Records, index: usize| records.works(index)[id];
            let greatest = (0..both).map(|i| of(fine, i).abs()).fold(0.0, f64::max);
            let difference = (0..both).map(|i| (of(coarse, i) - of(fine, i)).abs()).fold(0.0, f64::max);
            let same = difference <= SAME * fine.nothing[id];
            self.update_max(if same { 0.0 } else { difference / greatest }, STATES + 2);
        }
    }

    /// With this part of the differences, and of works a part of that.
    pub fn reduced(&self, part: f64, of_works: f64) -> Self {
        let mut reduced = Self {
            error: if self.error.is_finite() { 0.0 } else { self.error },
            each: [0.0; KINDS.len()],
            ..*self
        };
        for (kind, error) in self.each.iter().enumerate() {
            let works = if kind == STATES + 2 { of_works } else { 1.0 };
            reduced.update_max(part * works * error, kind);
        }
        reduced
    }

    /// The error of a steady motion itself.
    pub fn steady(&mut self, error: f64) {
        self.update_max(error, STATES + 3);
    }

    fn update_max(&mut self, error: f64, kind: usize) {
        if error > self.error {
            (self.error, self.worst) = (error, KINDS[kind]);
        }
        self.each[kind] = self.each[kind].max(error);
    }
}

impl Equations<'_, '_> {
    /// The position of a record.
    fn place_record(&mut self, records: &Records, index: usize) {
        records.bearings[index].set(&mut self.trial.motion);
        if let Some(given) = &records.given[index] {
            given.put(&mut self.trial);
            return;
        }
        let assemblies = records.assemblies[index].as_deref().unwrap_or(self.begins);
        self.trial.branches.copy_from_slice(assemblies);
        let (state, accelerations) = (records.state(index), records.accelerations(index));
        self.place(records.times[index], state, accelerations, records.bodies_at(index));
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
pub(in crate::solve) struct Kinds {
    difference: [f64; STATES],
    magnitude: [f64; STATES],
    /// Some of it is more than rounding.
    beyond: [bool; STATES],
    /// What results of the run are made of.
    pub sizes: Sizes,
    /// What positions, velocities and accelerations on its way over change points are not known to, of the greatest.
    pub rough: [f64; 3],
}

impl Kinds {
    /// What is zero of each kind but for rounding in the state that was found last.
    fn nothing(equations: &mut Equations<'_, '_>) -> [f64; STATES] {
        equations.look_at_sizes();
        let sizes = &equations.sizes;
        let all = [
            sizes.length(),
            1.0,
            sizes.speed(),
            sizes.turning(),
            sizes.acceleration(),
            sizes.speeding(),
            sizes.all_force(),
            sizes.all_moment(),
        ];
        let conditions = equations.trial.motion.conditions.iter();
        let condition = conditions.fold(1.0_f64, |least, c| least.min(c.abs())).max(LEAST_CONDITION);
        std::array::from_fn(|kind| {
            let rounding = ROUNDING / condition.powi(GROWS[kind]);
            all[kind] * rounding.max(equations.rough[ORDERS[kind]])
        })
    }

    fn update_max(&mut self, kind: usize, difference: f64, magnitude: f64, nothing: &[f64; STATES]) {
        // what is not a number is the worst there is
        let difference = if difference.is_nan() { f64::INFINITY } else { difference };
        self.difference[kind] = self.difference[kind].max(difference);
        self.magnitude[kind] = self.magnitude[kind].max(magnitude);
        self.beyond[kind] |= magnitude.max(0.5 * difference) > nothing[kind];
    }

    /// The magnitudes at the end of a step: what is small at every instant that is printed may be small beside the motion.
    pub(super) fn measure(&mut self, equations: &mut Equations<'_, '_>) {
        let nothing = Self::nothing(equations);
        let bodies = &equations.trial.motion.bodies;
        self.bodies(bodies, bodies, &nothing);
        self.forces(efforts(equations).zip(efforts(equations)), &nothing);
    }

    /// What the equations have found of the run at the end of a part of it.
    pub(super) fn found(&mut self, equations: &Equations<'_, '_>) {
        self.sizes.clone_from(&equations.sizes);
        self.rough = std::array::from_fn(|kind| self.rough[kind].max(equations.rough[kind]));
    }

    fn bodies(&mut self, coarse: &[BodyState], fine: &[BodyState], nothing: &[f64; STATES]) {
        for (a, b) in coarse.iter().zip(fine) {
            self.update_max(0, (a.p - b.p).norm(), 0.0, nothing);
            self.update_max(1, (a.u - b.u).norm(), 1.0, nothing);
            self.update_max(2, (a.v - b.v).norm(), b.v.norm(), nothing);
            self.update_max(3, (a.omega - b.omega).abs(), b.omega.abs(), nothing);
            self.update_max(4, (a.a - b.a).norm(), b.a.norm(), nothing);
            self.update_max(5, (a.alpha - b.alpha).abs(), b.alpha.abs(), nothing);
        }
    }

    /// The same efforts of both runs.
    fn forces(&mut self, both: impl Iterator<Item = (Efforts, Efforts)>, nothing: &[f64; STATES]) {
        for (a, b) in both {
            self.update_max(6, libm::hypot(a.0 - b.0, a.1 - b.1), libm::hypot(b.0, b.1), nothing);
            self.update_max(7, (a.2 - b.2).abs(), b.2.abs(), nothing);
        }
    }

    /// Positions and velocities are the motion itself; accelerations and forces count where they are asked for.
    fn worst(&self, extent: f64, missing: bool, effects: Effects) -> Compared {
        let deep = effects.asks_forces || effects.asked >= Level::Accelerations;
        let asked = |kind: usize| ORDERS[kind] < 2 || if kind < 6 { deep } else { effects.asks_forces };
        let error = if missing { f64::INFINITY } else { 0.0 };
        let mut found = Compared { error, each: [0.0; KINDS.len()], ..Compared::UNKNOWN };
        for kind in 0..STATES {
            let scale = if kind == 0 { extent.max(self.magnitude[0]) } else { self.magnitude[kind] };
            let counts = asked(kind) && self.beyond[kind] && self.difference[kind] > 0.0;
            found.update_max(if counts { self.difference[kind] / scale } else { 0.0 }, kind);
        }
        found
    }
}
