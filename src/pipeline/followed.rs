//! A motion followed position by position: each is handed out, and only those stay that are few or that an expectation
//! names.

use super::compile::Origin;
use super::critical::criticals;
use super::open_sizes::open_sizes;
use crate::report::{Answers, PrintedDigits};
use assur_model::model::{At, Mechanism, Positions, Relation};
use assur_solve::message::{self, failure};
use assur_solve::solve::{
    Block, Following, FreeSweep, IntegrationOptions, Model, Pose, PoseOrigin, PoseOutputs, Solution,
};
use assur_text::diagnostic::{Diagnosis, Problems};
use miette::LabeledSpan;

/// Positions that are kept at once.
const MOST: usize = 20_000;
/// The same, counted in bodies.
const MOST_BODIES: usize = 400_000;
/// So many are kept of the largest mechanism.
const FEWEST: usize = 360;
/// Failing positions are reported up to this number, and counted beyond.
const TOLD: usize = 1000;

/// Where positions go that are not kept. Each method says whether to go on.
pub trait Sink {
    fn add(&mut self, answers: &Answers<'_>, pose: &Pose) -> bool;

    /// How a motion under loads is integrated.
    fn conduct(&self) -> IntegrationOptions<'_> {
        IntegrationOptions::default()
    }

    /// Whether positions need not be kept, even if they are few.
    fn forgets(&self) -> bool {
        false
    }

    /// What of positions is read beside their answers.
    fn reads(&self, _: &Model<'_>) -> PoseOutputs {
        PoseOutputs::ALL
    }

    /// Calls `work` for all numbers below a count: on several threads if there are.
    fn each(&self, count: usize, work: &(dyn Fn(usize) + Sync)) {
        (0..count).for_each(work);
    }

    /// Takes positions of which none depends on another.
    fn add_sweep(&mut self, answers: &Answers<'_>, sweep: &FreeSweep<'_>) -> bool {
        let mut block = Block::default();
        (0..sweep.blocks()).all(|number| {
            sweep.solve(number, &mut block);
            block.poses().iter().all(|pose| self.add(answers, pose))
        })
    }
}

impl<F: FnMut(&Answers<'_>, &Pose) -> bool> Sink for F {
    fn add(&mut self, answers: &Answers<'_>, pose: &Pose) -> bool {
        self(answers, pose)
    }
}

/// The solution with all that is to be said of it; `None` where it was stopped; else what makes all positions meaningless.
pub type Followed = Result<Option<(Solution, Problems)>, Problems>;

/// How many positions of a mechanism are kept at once.
#[must_use]
pub fn most_positions(model: &Model<'_>) -> usize {
    (MOST_BODIES / model.plan.bodies.max(1)).clamp(FEWEST, MOST)
}

/// Whether a file has, or may have, more positions than are kept at once.
#[must_use]
pub fn is_long(model: &Model<'_>) -> bool {
    most_written(model) > most_positions(model)
}

/// How many positions a file has, or may have.
pub(super) fn most_written(model: &Model<'_>) -> usize {
    let mechanism = model.mechanism;
    let swept = mechanism.drives.iter().map(|d| match &d.positions {
        Positions::None => 1,
        Positions::List(list) => list.len(),
        Positions::Numbers(list) => list.len(),
        Positions::Range { steps, .. } => steps + 1,
    });
    let beside = mechanism.poses.len() + mechanism.expects.len();
    swept.max().unwrap_or(1) + beside
}

/// More positions than can be kept.
pub(super) fn too_many(model: &Model<'_>, positions: usize) -> Diagnosis {
    let most = most_positions(model);
    let many =
        format!("there are {positions} positions, but at most {most} of this mechanism can be kept at once");
    Diagnosis::error("mech::request::too_many_positions", many)
        .labels(model.mechanism.drives.iter().map(|d| LabeledSpan::underline(d.span)))
        .help(
            "print one position after another, with `assur solve FILE --format csv` or `--format jsonl`, or \
             take fewer steps",
        )
}

/// Solves all positions of a file. Without something that is done with each, all of them are kept, or it is an error that
/// they are too many. `None` where it was stopped. `conduct` holds where there is no sink with one of its own.
///
/// # Errors
/// What makes all positions meaningless.
pub fn followed(
    model: &Model<'_>,
    origin: Option<&Origin>,
    sink: Option<&mut dyn Sink>,
    conduct: &IntegrationOptions<'_>,
) -> Followed {
    let conduct = sink.as_ref().map_or(*conduct, |sink| sink.conduct());
    let critical = origin.map(|o| criticals(model, o, conduct.watch)).unwrap_or_default();
    let Some(mut following) = Following::conducted(model, critical, &conduct)
        .map_err(|all| Problems::of(message::failures(model, &all)))?
    else {
        return Ok(Some((Solution::default(), Problems::new())));
    };
    let (positions, most) = (following.positions(), most_positions(model));
    let few = positions <= most;
    let forgets = sink.as_ref().is_some_and(|sink| sink.forgets()) && model.mechanism.expects.is_empty();
    let keeps_all = few && !forgets;
    if !few && (sink.is_none() || names_all(model.mechanism, following.swept())) {
        return Err(Problems::of([too_many(model, positions)]));
    }
    let simulation = following.simulation().cloned();
    let mut head = Solution { statics: following.statics().clone(), simulation, ..Solution::default() };
    if let Some(origin) = origin {
        head.open = open_sizes(model, origin).map_err(Problems::of)?;
    }
    let (mut poses, mut problems) = (Vec::new(), Problems::new());
    let precision = PrintedDigits::READABLE;
    let answers = Answers { model: *model, solution: &head, outcomes: &[], reached: None, precision };
    let mut sink = sink;
    let (mut failed, mut ambiguous) = (0, false);
    loop {
        if let Some(sink) = sink.as_deref_mut().filter(|_| !keeps_all && model.mechanism.expects.is_empty()) {
            let goes_on = following.side_by_side(
                sink.reads(model),
                sink,
                |sink, count, work| sink.each(count, work),
                |sink, sweep| sink.add_sweep(&answers, sweep),
            );
            if goes_on == Some(false) {
                return Ok(None);
            }
        }
        let Some(pose) = following.next() else { break };
        let pose = pose.map_err(|why| Problems::of([failure(model, &why)]))?;
        if let Some(sink) = &mut sink
            && !matches!(pose.origin, PoseOrigin::Expected(_))
            && !sink.add(&answers, &pose)
        {
            return Ok(None);
        }
        // one line of `assemble` chooses for the whole sweep
        let again = pose.is_ambiguous() && std::mem::replace(&mut ambiguous, true);
        if let Some(why) = pose.failure().filter(|_| !again) {
            failed += 1;
            if failed <= TOLD || few {
                problems.push(failure(model, why));
            } else {
                problems.count_errors(1);
            }
        }
        if keeps_all || is_named(model.mechanism, &pose) {
            poses.push(pose);
        }
    }
    let mut solution = Solution { poses, ..following.end() };
    let mut said = Problems::new();
    said.extend(message::notes(model, &std::mem::take(&mut solution.notes)));
    said.count_warnings(std::mem::take(&mut solution.unlisted));
    said.append(problems);
    solution.open = head.open;
    Ok(Some((solution, said)))
}

/// Whether an expectation gives a value for every position of a sweep.
fn names_all(mechanism: &Mechanism, swept: usize) -> bool {
    let values = |relation: &Relation| match relation {
        Relation::Equal(list) => list.len(),
        Relation::Compare(..) | Relation::Condition => 1,
    };
    mechanism.expects.iter().any(|e| e.at.is_none() && !e.poseless && values(&e.relation) == swept)
}

/// Whether an expectation may speak of a pose.
fn is_named(mechanism: &Mechanism, pose: &Pose) -> bool {
    let names = |at: &Option<At>| matches!(at, Some(At::Pose(name, _)) if *name == pose.name);
    !matches!(pose.origin, PoseOrigin::Sweep(_)) || mechanism.expects.iter().any(|e| names(&e.at))
}
