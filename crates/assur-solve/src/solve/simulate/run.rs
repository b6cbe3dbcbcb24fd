//! One run of the integrator at one tolerance.

use super::compare::Kinds;
use super::equations::Equations;
use super::going::{Ended, Going, SHORTER};
use super::records::{Recorder, Records};
use super::report::{Energy, Method};
use super::rubbing::{Mode, rubs, wakes};
use super::setup::{Outputs, allowed};
use super::watch::Watch;
use crate::math::ode::{Counts, Dop853, Integrator, Radau, System, Undefined};
use crate::solve::failure::Halt;

/// Steps of a run at least, where something may end a rest.
const AT_REST: f64 = 200.0;

/// A run.
pub(super) struct Run {
    pub method: Method,
    pub records: Records,
    pub counts: Counts,
    pub energy: Energy,
    pub worst_condition: (f64, f64),
    /// Instants of every event, s.
    pub events: Vec<Vec<f64>>,
    /// The greatest magnitudes of each kind, where they are measured.
    pub kinds: Kinds,
    /// Functions over the run, each with the greatest magnitude in play.
    pub functions: Vec<(f64, f64)>,
    /// When the coordinate comes to rest by friction, and when it leaves again, s.
    pub rests: Vec<(f64, Option<f64>)>,
    /// The event that ended it.
    pub ended_by: Option<usize>,
    /// Why it ended early, and when, s.
    pub stopped: Option<(f64, Halt)>,
    /// The last instant that was reached, s.
    pub end: f64,
}

/// Integrates from the first of the instants, s, to the last.
pub(super) fn run(
    equations: &mut Equations<'_, '_>,
    tolerance: f64,
    outputs: &Outputs,
    (first, last): (f64, f64),
    measures: bool,
) -> Run {
    let y = equations.start();
    // of several coordinates each load acts against the motion there is
    if equations.order() == 1 && rubs(equations) {
        equations.mode = Some(Mode::Resting);
    }
    let allowed = allowed(equations, tolerance, last - first);
    let mechanism = equations.model.mechanism;
    if let Err(halt) = begin(equations, first, &y) {
        return Run::halted(first, halt);
    }
    let mut going = Going {
        recorder: Recorder::new(equations),
        watch: Watch::new(mechanism, y.len(), (first, last)),
        outputs,
        next: 0,
        last,
        begin: first,
        worst_condition: (1.0, first),
        ended_by: None,
        rests: if equations.mode == Some(Mode::Resting) { vec![(first, None)] } else { Vec::new() },
        wakes: wakes(mechanism),
        kinds: Kinds::default(),
        measures,
        longest: None,
    };
    let mut method = Dop853::new(allowed.clone());
    if going.wakes && equations.mode.is_some() {
        // at rest nothing bounds the steps; two runs of equal steps would say nothing of their error
        let steps = if measures { SHORTER * AT_REST } else { AT_REST };
        going.longest = Some((last - first) / steps);
        method.progress_mut().longest = going.longest;
    }
    let mut ended = match method.start(equations, first, &y, last) {
        Ok(()) => going.integrate(equations, &mut method, false),
        Err(Undefined) => {
            equations.accepted(first, &y);
            Ended::Halted(equations.halt())
        }
    };
    let (mut counts, mut end, mut name) = (method.counts(), method.t(), Method::Dop853);
    if matches!(ended, Ended::Stiff) {
        let mut implicit = Radau::new(&allowed);
        if !measures {
            going.longest = Some(SHORTER * outputs.longest_gap(last - first));
            implicit.progress_mut().longest = going.longest;
        }
        ended = match implicit.start(equations, method.t(), method.y(), last) {
            Ok(()) => going.integrate(equations, &mut implicit, true),
            Err(Undefined) => Ended::Halted(equations.halt()),
        };
        counts = sum(counts, implicit.counts());
        (end, name) = (implicit.t(), Method::Radau);
    }
    let stopped = match ended {
        Ended::Halted(halt) => Some((end, halt)),
        Ended::Done | Ended::Stiff => None,
    };
    let functions = going.watch.functions(end);
    let Going { watch, recorder, kinds, worst_condition, ended_by, rests, .. } = going;
    let events = watch.times;
    let (records, energy) = recorder.end();
    Run {
        method: name,
        records,
        counts,
        energy,
        worst_condition,
        events,
        kinds,
        functions,
        rests,
        ended_by,
        stopped,
        end,
    }
}

const fn sum(a: Counts, b: Counts) -> Counts {
    Counts {
        evaluations: a.evaluations + b.evaluations,
        steps: a.steps + b.steps,
        rejected: a.rejected + b.rejected,
        shortened: a.shortened + b.shortened,
    }
}

/// Chooses how a coordinate that rubs begins.
fn begin(equations: &mut Equations<'_, '_>, first: f64, y: &[f64]) -> Result<(), Halt> {
    if equations.mode.is_none() {
        let unsolved = equations.model.plan.effects.loses();
        return if unsolved { Err(Halt::RubsOnDriven) } else { Ok(()) };
    }
    if !equations.rests_together(first, y) {
        return Err(Halt::RubsOnDriven);
    }
    equations.choose_mode(first, y)
}

impl Run {
    /// A run that does not begin.
    fn halted(first: f64, halt: Halt) -> Self {
        Self {
            method: Method::Dop853,
            records: Records::default(),
            counts: Counts::default(),
            energy: Energy::default(),
            worst_condition: (1.0, first),
            events: Vec::new(),
            kinds: Kinds::default(),
            functions: Vec::new(),
            rests: Vec::new(),
            ended_by: None,
            stopped: Some((first, halt)),
            end: first,
        }
    }
}
