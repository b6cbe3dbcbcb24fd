//! Runs over the same motion, each finer than the one before, until the accuracy wanted is kept.

use super::compare::{Compared, Kinds};
use super::pass::Pass;
use super::run::Run;
use crate::solve::failure::Halt;

/// The tolerance of the second run over that of the first.
const FINER: f64 = 0.1;
/// The tolerance of the first run over the wanted accuracy: errors of smooth motions are far below their tolerance.
const LOOSER: f64 = 10.0;
/// What two runs differ by is an estimate: so much of the accuracy it may take.
const SURE: f64 = 0.5;
/// A finer run is to leave so much of it: errors do not fall quite as tolerances do.
const AIM: f64 = 0.25;
/// The tolerance of a finer run over that of the run before, at most and at least.
const STEP: (f64, f64) = (0.03, 0.1);
/// A looser tolerance makes steps so long that what two runs differ by says nothing of their error.
const LOOSEST: f64 = 1e-5;
/// Below this relative tolerance the digits of the numbers end.
const FINEST: f64 = 2e-15;
/// At this tolerance rounding may be greater than what the method leaves.
const ROUNDING: f64 = 1e-11;
/// After so many finer runs there in vain it is: one may be worse than the run before by chance.
const IN_VAIN: usize = 2;
/// Evaluations of all runs: no finer run is begun that would take more.
const MOST: usize = 12_000_000;

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
    mut run: impl FnMut(Pass) -> Run,
    mut compare: impl FnMut((&Run, &Run), &Kinds) -> Compared,
    within: f64,
    alone: Option<f64>,
) -> (Found, usize) {
    let mut pass = alone.map_or(Pass::coarse((LOOSER * within).min(LOOSEST)), Pass::only);
    let mut runs = vec![run(pass)];
    let mut spent = runs[0].counts.evaluations;
    let mut kinds = runs[0].kinds.clone();
    let mut finer = FINER * pass.tolerance;
    let mut best: Option<(usize, Compared)> = None;
    let mut in_vain = 0;
    loop {
        let coarse = runs.len() - 1;
        let ended = match runs[coarse].stopped {
            Some((_, Halt::Interrupted)) => true,
            // a finer run takes more
            Some((_, Halt::TooManySteps)) => best.is_none(),
            _ => alone.is_some(),
        };
        if ended {
            let compared = Compared { error: 1.0, ..Compared::UNKNOWN };
            return (Found { run: runs.swap_remove(coarse), kinds: Kinds::default(), compared }, spent);
        }
        let hopeless = matches!(runs[coarse].stopped, Some((_, Halt::TooManySteps)));
        if hopeless || spent + runs[coarse].counts.evaluations > MOST {
            break;
        }
        pass = pass.finer(finer);
        runs.push(run(pass));
        let fine = &runs[coarse + 1];
        spent += fine.counts.evaluations;
        let compared = compare((&runs[coarse], fine), &kinds);
        let error = compared.error;
        let interrupted = matches!(fine.stopped, Some((_, Halt::Interrupted)));
        if error <= SURE * within || interrupted {
            return (Found { run: runs.swap_remove(coarse + 1), kinds, compared }, spent);
        }
        let is_rounding = compared.is_rounding;
        if best.as_ref().is_none_or(|(_, best)| error < best.error) {
            best = error.is_finite().then_some((coarse + 1, compared)).or(best);
        } else if pass.tolerance <= ROUNDING {
            in_vain += 1;
        }
        if is_rounding || in_vain == IN_VAIN || STEP.1 * pass.tolerance < 0.99 * FINEST {
            break;
        }
        let wanted = AIM * within / error;
        if wanted >= STEP.0 {
            finer = (pass.tolerance * wanted.min(STEP.1)).max(FINEST);
            continue;
        }
        // of runs that do not agree at all nothing is known
        let factor = if error.is_finite() { wanted } else { FINER };
        pass = Pass::coarse((pass.tolerance * factor / FINER).max(FINEST / FINER));
        finer = FINER * pass.tolerance;
        if spent + fine.counts.evaluations > MOST {
            break;
        }
        runs.push(run(pass));
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
