//! Friction in motions of several free coordinates against the equations of all bodies at once, with friction as loads that
//! follow their laws by a damped fixed point.

use super::newton_euler::{Bodies, followed};
use super::{condition, freed, many, off};
use crate::friction::fixed_point::{laws, rubbing, step};
use crate::friction::pair_friction::{loaded, pair_frictions};
use crate::support::draft::Draft;
use crate::support::equilibrium::equilibrium;
use crate::support::reference::{Body, Rates, Reference};
use crate::support::run::Run;
use assur::internals::model::Mechanism;

/// Slower sliding may be rest.
const SLOWEST: f64 = 1e-6;
/// Rounds of the fixed point.
const ROUNDS: usize = 300;

/// Accelerations of all bodies under their loads and the friction that goes with these accelerations.
fn accelerations(mechanism: &Mechanism, draft: &Draft, reference: &Reference) -> Option<Vec<Rates>> {
    let rubs = pair_frictions(mechanism, reference);
    if rubs.iter().any(|rub| rub.speed.abs() < SLOWEST) {
        return None;
    }
    let (mut x, mut before) = (vec![0.0; rubs.len()], f64::INFINITY);
    for _ in 0..ROUNDS {
        let loaded = loaded(mechanism, &rubs, &x);
        let (rates, doubtful) = Bodies::new(&loaded)?.accelerations(&draft.frames, &reference.rates, 0.0)?;
        let bodies = draft.frames.iter().zip(&rates).map(|(f, r)| Body::moving(f.p, f.u, r));
        let forces = equilibrium(&loaded, &bodies.collect::<Vec<_>>(), &rates)?;
        let determined = rubs.iter().all(|rub| rub.determined(&forces));
        if doubtful || forces.doubtful || forces.condition < 1e-3 || !determined {
            return None;
        }
        let next = laws(&rubs, &forces);
        let scale = next.iter().fold(f64::MIN_POSITIVE, |m, x| m.max(x.abs()));
        let off = next.iter().zip(&x).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        if off < 1e-13 * scale {
            return Some(rates);
        }
        if !off.is_finite() {
            return None;
        }
        let step = step(off, &mut before);
        x.iter_mut().zip(&next).for_each(|(x, next)| *x += step * (next - *x));
    }
    None
}

/// What one mechanism misses, over the greatest acceleration and the conditions.
fn missed(draft: &Draft) -> Result<Option<f64>, String> {
    let mechanism = rubbing(draft, |i| 0.02 + 0.02 * f64::from(u8::try_from(i % 5).unwrap_or(0)));
    let Some(reference) = Reference::new(&mechanism, &draft.frames) else { return Ok(None) };
    let Some(mass) = condition(draft) else { return Ok(None) };
    let Some(want) = accelerations(&mechanism, draft, &reference) else { return Ok(None) };
    let mut mechanism = mechanism;
    followed(&mut mechanism, 1e-4, None, 1e-3);
    let run = Run::new(&mechanism)?;
    let (solved, off) = (run.solved(0)?, off(&run, draft, &want)?);
    if let Some(equilibrium) = solved.residuals.equilibrium.filter(|r| *r > 1e-10) {
        return Err(format!("equilibrium misses {equilibrium:e}"));
    }
    Ok(Some(off * mass))
}

/// 500 random mechanisms with two or three free coordinates in which every pair slides.
#[test]
fn friction_of_several_coordinates_is_that_of_all_bodies_at_once() {
    let (mut compared, mut opened, mut failures, mut worst) = (0, 0, Vec::new(), (0.0, 0));
    for seed in 60_000.. {
        if compared >= many(500) {
            break;
        }
        let draft = freed(seed);
        if draft.mechanism.drives.iter().filter(|d| d.free).count() < 2 {
            continue;
        }
        match missed(&draft) {
            Ok(None) => {}
            Ok(Some(error)) => {
                compared += 1;
                if error > worst.0 {
                    worst = (error, seed);
                }
                if error.is_nan() || error > 1e-9 {
                    failures.push(format!("seed {seed}: {error:e}"));
                }
            }
            // a contact that would have to pull at the first instant: there is no motion
            Err(e) if e.contains("Opens") => opened += 1,
            Err(e) => failures.push(format!("seed {seed}: {e:.300}")),
        }
    }
    println!("{compared} compared, {opened} open at once, worst {worst:?}");
    let told = failures.iter().take(20).map(String::as_str).collect::<Vec<_>>();
    assert!(failures.is_empty(), "{} failures\n{}", failures.len(), told.join("\n"));
    assert!(opened < compared, "{opened} open at once");
}
