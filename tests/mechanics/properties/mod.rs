//! Random mechanisms against an independent path: constraints of all pairs for the motion, the equations of Newton and
//! Euler of all links for the forces.

mod compare;
mod degenerate;
mod derivatives;
mod grouping;
mod invariance;
mod lanes;
mod rubbing;
mod sweeps;
mod triads;

use crate::share::{first, least};
use crate::support::draft::Draft;
use crate::support::reference::Reference;
use crate::support::run::Run;
use crate::support::{digits, generate};
use compare::{Worst, compare};

/// Runs `check` on many random mechanisms and tells all that fails, the smallest mechanisms first. `ASSUR_SEED=17` runs
/// one of them and prints it.
fn for_all(seeds: std::ops::Range<u64>, check: impl Fn(&Draft, &Reference, &Run) -> Result<Worst, String>) {
    for_all_of(generate::mechanism, seeds, check);
}

fn for_all_of(
    make: impl Fn(u64) -> Draft,
    seeds: std::ops::Range<u64>,
    check: impl Fn(&Draft, &Reference, &Run) -> Result<Worst, String>,
) {
    let (mut worst, mut failures) = (Worst::default(), Vec::new());
    let one: Option<u64> = std::env::var("ASSUR_SEED").ok().and_then(|s| s.parse().ok());
    for seed in one.map_or_else(|| first(seeds), |s| s..s + 1) {
        let draft = make(seed);
        let mut fail =
            |what: String| failures.push((draft.frames.len(), format!("seed {seed}: {what:.400}")));
        let Some(reference) = Reference::new(&draft.mechanism, &draft.frames) else {
            fail(format!("the reference is singular: {:?}", draft.made));
            continue;
        };
        let run = match Run::new(&draft.mechanism) {
            Ok(run) => run,
            Err(e) => {
                fail(e);
                continue;
            }
        };
        if one.is_some() {
            println!("{:#?}\n{:#?}\n{:#?}", draft.mechanism, draft.frames, run.structure);
        }
        match check(&draft, &reference, &run) {
            Ok(w) => {
                w.failures().into_iter().for_each(&mut fail);
                worst.merge(w);
            }
            Err(e) => fail(e),
        }
    }
    for e in &worst.errors {
        println!("{:28} {:9.1e} {}", e.0, e.1, e.2);
    }
    failures.sort();
    let told: Vec<&str> = failures.iter().take(40).map(|f| f.1.as_str()).collect();
    assert!(failures.is_empty(), "{} failures\n{}", failures.len(), told.join("\n"));
}

#[test]
fn mechanisms_agree_with_constraints_and_newton_euler() {
    for_all(0..2500, compare);
}

#[test]
fn groups_given_alone_agree_too() {
    for_all_of(generate::alone, 6000..6400, compare);
}

#[test]
fn groups_are_those_the_mechanism_was_made_of() {
    for_all(0..1000, |draft, _, run| match grouping::wrong_groups(draft, &run.structure) {
        wrong if wrong.is_empty() => Ok(Worst::default()),
        wrong => Err(wrong.join("; ")),
    });
}

#[test]
fn answers_do_not_hang_on_frames_scales_names_and_order() {
    for_all(3000..3400, |draft, reference, run| invariance::invariance(draft, run, reference));
}

#[test]
fn rates_are_the_differences_of_what_they_are_rates_of() {
    for_all(4000..4300, |draft, _, run| derivatives::derivatives(draft, run));
}

#[test]
fn every_kind_of_group_is_made_often() {
    let mut made = std::collections::BTreeMap::new();
    let (mut compared, mut far) = (0, 0);
    for seed in first(0..2500) {
        let draft = generate::mechanism(seed);
        let reference = Reference::new(&draft.mechanism, &draft.frames);
        let forces = reference.as_ref().and_then(|r| r.forces.as_ref());
        let whole = forces.is_some_and(|f| !f.doubtful && f.condition > 0.0);
        compared += usize::from(whole);
        far += usize::from(whole && !draft.mechanism.balances.is_empty());
        for group in &draft.made {
            *made.entry(group.kind).or_insert(0) += 1;
        }
    }
    assert!(compared > least(2000) && far > least(1000), "{compared} compared, {far} with balances");
    assert!(made.len() == 10 && made.values().all(|&n| n > least(150)), "{made:?}");
}

#[test]
fn friction_obeys_its_laws() {
    let (free, undecided) = (std::cell::Cell::new(0), std::cell::Cell::new(0));
    for_all(5000..5600, |draft, reference, _| {
        let mut draft = draft.clone();
        rubbing::roughen(&mut draft);
        let run = Run::new(&draft.mechanism)?;
        if !run.structure.undetermined_couples.is_empty() {
            return Ok(Worst::default());
        }
        let verified = match rubbing::verified(&draft, reference, &run) {
            // more combinations than are searched: refused, which is no wrong answer
            Err(e) if e.contains("Undecided") => {
                undecided.set(undecided.get() + 1);
                None
            }
            found => found?,
        };
        free.set(free.get() + usize::from(verified.is_some()));
        Ok(verified.unwrap_or_default())
    });
    assert!(
        free.get() > least(300) && undecided.get() <= 3,
        "{} moved, {} undecided",
        free.get(),
        undecided.get()
    );
}

#[test]
fn answers_agree_with_thirty_digits() {
    let (mut positions, mut closed, mut losses) = (0, 0, [0.0_f64; 4]);
    for seed in first(7000..8500) {
        let Ok(run) = Run::new(&generate::mechanism(seed).mechanism) else { continue };
        let (Ok(solved), Ok(solution)) = (run.solved(0), &run.solution) else { continue };
        let model = run.model();
        let exact =
            solution.reference(&model, solved).unwrap_or_else(|| panic!("seed {seed} has no reference"));
        assert!(exact.closure < 1e-29 && exact.equilibrium < 1e-27, "seed {seed}: {exact:?}");
        let sigma = solved.condition;
        let [p, v, a] = digits::motion_errors(solved, &exact);
        let f = digits::force_error(&model, solved, &exact);
        for (i, (error, power)) in [(p, 1), (v, 2), (a, 3), (f, 3)].into_iter().enumerate() {
            let c = error * sigma.powi(power) / f64::EPSILON;
            assert!(c <= 64.0, "seed {seed}: {error:e} of kind {i}, condition {sigma:e}");
            losses[i] = losses[i].max(c);
        }
        positions += 1;
        // the angles of two guides of one body agree to rounding only: which of them holds is taken differently
        let twice_guided = |m: &assur::internals::plan::MotionStep| {
            matches!(m, assur::internals::plan::MotionStep::Translation { .. })
        };
        if run.plan.motion.iter().any(twice_guided) {
            continue;
        }
        let Some(precise) = assur::internals::solve::precise(&run.plan, &solved.state) else { continue };
        let errors = digits::closed_form_errors(&precise, &exact);
        for (error, power) in errors.into_iter().zip([1, 2, 3, 3]) {
            let bound = 1e-28 / sigma.powi(power);
            assert!(error <= bound, "seed {seed}: {errors:?}, condition {sigma:e}");
        }
        closed += 1;
    }
    println!("{positions} positions, {closed} in closed form, c = {losses:?}");
    assert!(positions > least(1000) && closed > least(250), "{positions} positions, {closed} in closed form");
}
