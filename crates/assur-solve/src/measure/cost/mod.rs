//! What a plan costs per position, measured on the spot.
//!
//! Two rows of plans are run over the same places: one grows by a step at a time, the other by an effect at a time,
//! both from the empty plan to the whole. Every plan is run again and again, in turn with the others, and its least time
//! is kept; a step, or an effect, costs what the plan with it takes longer than the plan without it.

mod incremental_plans;
mod of_motion;
mod sample_positions;

use crate::answer::balanced;
use crate::measure::clock::Clock;
use crate::model::{LoadId, Value};
use crate::position::{Model, State, residuals};
use crate::solve::{Failure, PoseAnswers, Rates, Sweep, WholeCycle, cycles, refusals, statics};
use incremental_plans::Trial;
pub use of_motion::MotionCost;
pub use sample_positions::Over;
use sample_positions::Place;

/// Measuring ends after so long, s, but not before [`FEWEST`] rounds.
const LONGEST: f64 = 0.25;
/// Every plan is run at least so often.
const FEWEST: usize = 5;
/// And at most so often.
const MOST: usize = 500;
/// A round of one plan takes at least so many positions.
const POSITIONS: usize = 64;

/// Times per position, s.
#[derive(Clone, Debug)]
pub struct Costs {
    /// How many places the plan was run at.
    pub places: usize,
    pub over: Over,
    pub total: f64,
    /// The effects of the plan by name, positions first.
    pub effects: Vec<(&'static str, f64)>,
    /// The steps of motion.
    pub motion: Vec<f64>,
    /// The steps of loads.
    pub loads: Vec<f64>,
    /// The steps of forces.
    pub forces: Vec<f64>,
    /// What is done at every position beside the plan: the residuals, and the quantities of the file where there are any.
    pub beside: Vec<(&'static str, f64)>,
    /// The motion under loads, where the file follows one.
    pub motion_under_loads: Option<MotionCost>,
}

/// Runs the plan of a file over its positions; where there is one alone, over a turn of its drive. `None` where the file
/// has no mechanism.
///
/// # Errors
/// As [`crate::solve::solve`]: no assembly or several at the first position, constructs not supported yet.
pub fn costs(model: &Model<'_>, clock: Clock) -> Result<Option<Costs>, Vec<Failure>> {
    let refused = refusals(model);
    if !refused.is_empty() {
        return Err(refused);
    }
    if model.mechanism.links.len() < 2 {
        return Ok(None);
    }
    let mut statics = statics(model).map_err(|cause| vec![cause.into()])?;
    let sweep = Sweep::of(model, &statics);
    // functions over a motion under loads follow from the motion, which is not solved here
    if model.mechanism.simulation.is_none() {
        cycles(model, &mut statics, &sweep).map_err(|cause| vec![cause.into()])?;
    }
    let rates = Rates::of(model, &statics);
    let (over, places) =
        sample_positions::places(model, &statics, &rates).map_err(|cause| vec![cause.into()])?;
    let steps = incremental_plans::steps(model.plan);
    let effects = incremental_plans::effects(model);
    let beside = incremental_plans::beside(model);
    let all: Vec<&Trial> = steps.iter().chain(effects.iter().map(|(_, t)| t)).collect();
    let all: Vec<&Trial> = all.into_iter().chain(beside.iter().map(|(_, t)| t)).collect();
    let mut least = Bench::new(model, &statics, &places).least(&all, clock);

    let beside_times = least.split_off(steps.len() + effects.len());
    let mut effect_times = least.split_off(steps.len());
    let whole = least[steps.len() - 1].min(effect_times[effects.len() - 1]);
    let by_step = differences(&mut least, whole);
    let by_effect = differences(&mut effect_times, whole);
    let (motion, rest) = by_step.split_at(model.plan.motion.len());
    let (loads, forces) = rest.split_at(if model.plan.effects.loaded() { model.plan.loads.len() } else { 0 });
    let names = effects.iter().skip(1).map(|(name, _)| *name);
    Ok(Some(Costs {
        places: places.len(),
        over,
        total: by_step.iter().sum(),
        effects: names.zip(by_effect).collect(),
        motion: motion.to_vec(),
        loads: loads.to_vec(),
        forces: forces.to_vec(),
        beside: beside.iter().zip(&beside_times).map(|(b, t)| (b.0, (t - whole).max(0.0))).collect(),
        motion_under_loads: of_motion::of_motion(model, &statics, clock),
    }))
}

/// What each plan of a row takes longer than the one before. A plan takes no longer than one that does more: what a
/// disturbed clock says against it is set right, so that the differences add up to the whole.
fn differences(least: &mut [f64], whole: f64) -> Vec<f64> {
    let mut bound = whole;
    for time in least.iter_mut().rev() {
        bound = bound.min(*time);
        *time = bound;
    }
    least.windows(2).map(|pair| pair[1] - pair[0]).collect()
}

/// One state, run through all places again and again.
struct Bench<'a> {
    model: &'a Model<'a>,
    statics: &'a WholeCycle,
    places: &'a [Place],
    /// Some groups start from where their bodies stand.
    goes_on: bool,
    state: State,
    evaluated: Vec<(LoadId, Value)>,
}

impl<'a> Bench<'a> {
    fn new(model: &'a Model<'a>, statics: &'a WholeCycle, places: &'a [Place]) -> Self {
        let state = places.first().map_or_else(|| State::new(model.plan), |place| place.state.clone());
        let goes_on = model.plan.goes_on();
        Self { model, statics, places, goes_on, state, evaluated: Vec::new() }
    }

    /// The least time of every plan per position, s.
    fn least(&mut self, trials: &[&Trial], clock: Clock) -> Vec<f64> {
        let mut least = vec![f64::INFINITY; trials.len()];
        let repeats = POSITIONS.div_ceil(self.places.len().max(1));
        #[allow(clippy::cast_precision_loss)] // a few hundred
        let positions = (repeats * self.places.len()) as f64;
        let begin = clock();
        for round in 0..MOST {
            if round >= FEWEST && clock() - begin > LONGEST {
                break;
            }
            for (trial, least) in trials.iter().zip(&mut least) {
                let start = clock();
                for _ in 0..repeats {
                    self.run(trial);
                }
                *least = least.min((clock() - start) / positions);
            }
        }
        least
    }

    fn run(&mut self, trial: &Trial) {
        let model = Model { plan: &trial.plan, ..*self.model };
        for place in self.places {
            let state = &mut self.state;
            state.motion.inputs.copy_from_slice(&place.state.motion.inputs);
            state.branches.copy_from_slice(&place.state.branches);
            if self.goes_on {
                state.motion.bodies.copy_from_slice(&place.state.motion.bodies);
            }
            state.run_planned_motion(&trial.plan);
            if trial.plan.effects.loaded() {
                balanced(&model, self.statics, state, &place.angles, &mut self.evaluated, true);
            }
            if trial.residuals {
                std::hint::black_box(residuals(&model, state));
            }
            if trial.quantities {
                let view = PoseAnswers::new(&model, state, &place.angles, self.statics);
                std::hint::black_box(view.all_quantities());
            }
            std::hint::black_box(&self.state);
        }
    }
}
