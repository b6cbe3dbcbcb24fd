//! Runs over the same motion, each finer than the one before, until the accuracy wanted is kept.

use super::compare::{Compared, Kinds};
use super::pass::{EVALUATIONS, Pass};
use super::report::Method;
use super::run::Run;
use super::trace::Fraction;
use crate::solve::failure::Halt;

/// The tolerance of the second run over that of the first.
const FINER: f64 = 0.1;
/// The tolerance of the first run over the wanted accuracy: errors of smooth motions are far below their tolerance.
const LOOSER: f64 = 10.0;
/// A finer run is to leave so much of it: errors do not fall quite as tolerances do.
const AIM: f64 = 0.25;
/// The tolerance of a finer run over that of the run before, at most and at least.
const STEP: (f64, f64) = (0.03, 0.1);
/// A looser tolerance makes steps so long that what two runs differ by says nothing of their error.
const LOOSEST: f64 = 1e-5;
/// Where less accuracy is wanted the loosest run is finer than it would have to be, and steps that are not much shorter are fine enough.
const FEW_DIGITS: f64 = 5e-5;
/// Below this relative tolerance the digits of the numbers end.
const FINEST: f64 = 2e-15;
/// At this tolerance rounding may be greater than what the method leaves.
const ROUNDING: f64 = 1e-11;
/// After so many finer runs there in vain it is: one may be worse than the run before by chance.
const IN_VAIN: usize = 2;
/// After so many evaluations no finer run is tried that rounding would make useless.
const MUCH: usize = 500_000;

/// Runs in parts of the steps of the run before.
#[derive(Clone, Copy)]
struct Shorter {
    part: Fraction,
    /// The tolerance over that of the run before: smooth steps keep a finer one, and where they are not smooth they are to be shorter.
    tolerance: f64,
    /// Another such run is begun where the error is to be less by a factor between these.
    least: f64,
    worth: f64,
}

/// Of methods whose error falls by their order; `loosely` where the run before is the loosest, and finer by far than is wanted.
const fn shorter(method: Method, loosely: bool) -> Option<Shorter> {
    let halves = Shorter { part: Fraction::Half, tolerance: 1.0 / 64.0, least: 1.0 / 64.0, worth: 0.1 };
    match method {
        Method::Dop853 if loosely => Some(Shorter { part: Fraction::TwoThirds, tolerance: 0.5, ..halves }),
        Method::Dop853 => Some(halves),
        Method::Radau => Some(Shorter { tolerance: 0.1, least: 1.0 / 16.0, worth: 0.3, ..halves }),
        Method::Energy => None,
    }
}

/// A run with what is known of its error.
pub(super) struct Found {
    pub run: Run,
    /// The greatest magnitudes of each kind.
    pub kinds: Kinds,
    pub compared: Compared,
}

/// Runs until the accuracy wanted is kept, or until no finer run helps; `compare` says what is known of the error of the second of
/// two runs. Returns what is printed, and the evaluations of all runs.
pub(super) fn until_kept(
    mut run: impl FnMut(Pass<'_>) -> Run,
    mut compare: impl FnMut((&Run, &Run), &Kinds) -> Compared,
    within: f64,
    alone: Option<f64>,
) -> (Found, usize) {
    let mut pass = alone.map_or(Pass::coarse((LOOSER * within).min(LOOSEST)), Pass::in_long_steps);
    let mut runs = vec![run(pass)];
    let mut spent = runs[0].counts.evaluations;
    let works = std::mem::take(&mut runs[0].trace.works);
    if alone.is_none() && runs[0].method != Method::Energy && works.iter().any(|(much, _)| *much > 0.0) {
        // only now it is known what is much for them
        runs[0] = run(Pass { works: &works, ..pass });
        spent += runs[0].counts.evaluations;
    }
    let mut kinds = runs[0].kinds.clone();
    let mut wanted = FINER;
    let mut best: Option<(usize, Compared)> = None;
    let mut in_vain = 0;
    loop {
        let coarse = runs.len() - 1;
        let ended = match runs[coarse].stopped {
            Some((_, Halt::Interrupted)) => true,
            // a finer run takes more
            Some((_, Halt::TooManySteps { .. })) => best.is_none(),
            _ => alone.is_some(),
        };
        if ended {
            let compared = Compared { error: 1.0, ..Compared::UNKNOWN };
            return (Found { run: runs.swap_remove(coarse), kinds: Kinds::default(), compared }, spent);
        }
        let hopeless = matches!(runs[coarse].stopped, Some((_, Halt::TooManySteps { .. })));
        if hopeless || spent + runs[coarse].counts.evaluations > EVALUATIONS {
            break;
        }
        // how many rebounds there are depends on the tolerance, which halves make finer
        let loosely = coarse == 0 && within > FEW_DIGITS && runs[0].closed.is_empty();
        let shorter = shorter(runs[coarse].method, loosely);
        let factor = shorter.map_or(wanted.clamp(STEP.0, STEP.1), |shorter| shorter.tolerance);
        let finer = (pass.tolerance * factor).max(FINEST);
        pass.most = EVALUATIONS.saturating_sub(spent);
        let next = pass.finer(finer, &runs[coarse].trace, shorter.map(|shorter| shorter.part));
        let found = run(next);
        pass = Pass { before: None, works: &[], ..next };
        runs.push(found);
        let fine = &runs[coarse + 1];
        spent += fine.counts.evaluations;
        let compared = compare((&runs[coarse], fine), &kinds);
        if let Some((_, found)) = best.as_mut().filter(|best| best.0 == coarse) {
            // the finer run of the pair before is the coarser one of this
            found.error = found.error.max(compared.difference);
        }
        let error = compared.error;
        let interrupted = matches!(fine.stopped, Some((_, Halt::Interrupted)));
        if error <= within || interrupted {
            return (Found { run: runs.swap_remove(coarse + 1), kinds, compared }, spent);
        }
        let is_rounding = compared.is_rounding;
        if best.as_ref().is_none_or(|(_, best)| error < best.error) {
            best = error.is_finite().then_some((coarse + 1, compared)).or(best);
        } else if pass.tolerance <= ROUNDING {
            in_vain += 1;
        }
        // errors of steps have grown at least so much, and so does rounding
        let rounding = error / runs[coarse + 1].tolerance * f64::EPSILON;
        if spent > MUCH && rounding > within {
            break;
        }
        if is_rounding || in_vain == IN_VAIN || STEP.1 * FINER * runs[coarse].tolerance < 0.99 * FINEST {
            break;
        }
        wanted = AIM * within / error;
        let goes_on =
            shorter.map_or(wanted >= STEP.0, |shorter| (shorter.least..=shorter.worth).contains(&wanted));
        if goes_on {
            continue;
        }
        // of runs that do not agree at all nothing is known
        let less = if error.is_finite() { wanted } else { FINER };
        pass = Pass::coarse((pass.tolerance * less / factor).max(FINEST / FINER));
        wanted = FINER;
        if spent + fine.counts.evaluations > EVALUATIONS {
            break;
        }
        let most = EVALUATIONS.saturating_sub(spent);
        let found = run(Pass { works: &fine.trace.works, most, ..pass });
        runs.push(found);
        spent += runs[coarse + 2].counts.evaluations;
        kinds.clone_from(&runs[coarse + 2].kinds);
    }
    let (index, compared) = best.unwrap_or((runs.len() - 1, Compared::UNKNOWN));
    // where two runs do not agree at all, all of what there is
    let compared = Compared { error: compared.error.min(1.0), ..compared };
    let run = missed(runs.swap_remove(index), within, &compared);
    (Found { run, kinds, compared }, spent)
}

/// A run that is not as accurate as is wanted, if it is not.
fn missed(run: Run, within: f64, compared: &Compared) -> Run {
    let halt = Halt::Accuracy { wanted: within, reached: compared.error };
    let missed = (compared.error > within).then_some((run.end, halt));
    Run { stopped: run.stopped.or(missed), ..run }
}
