//! Motion under loads against the equations of all bodies at once.

mod change_points;
mod coordinates;
mod follow;
mod impacts;
mod losing;
mod newton_euler;
mod rough_stops;
mod rubbing;
mod stops;
mod trains;

use crate::support::draft::Draft;
use crate::support::generate;
use crate::support::reference::{Rates, Reference};
use crate::support::run::{Run, scalar, vector};
use assur::internals::math::Vec2;
use assur::internals::model::{Expr, LinkId, PointRef, Query};
use nalgebra::DMatrix;
use newton_euler::{Bodies, followed};

/// `ASSUR_MOTIONS=5` tries five times as many random mechanisms.
fn times() -> Option<u64> {
    std::env::var("ASSUR_MOTIONS").ok().and_then(|s| s.parse().ok())
}

/// So many random mechanisms, or a fifth of them.
fn many(count: u64) -> u64 {
    times().map_or_else(|| crate::share::part(count), |times| times * count)
}

/// A random mechanism all of whose drives are free, or all but one.
pub fn freed(seed: u64) -> Draft {
    let mut draft = generate::mechanism(seed);
    let m = &mut draft.mechanism;
    m.balances.clear();
    let drives = m.drives.len();
    // against the motion of several coordinates nothing is solved yet
    m.loads.retain(|load| drives == 1 || !load.is_against_motion());
    let prescribed = if drives > 1 && draft.random.chance(0.3) { draft.random.below(drives) } else { drives };
    for (i, drive) in m.drives.iter_mut().enumerate().filter(|(i, _)| *i != prescribed) {
        drive.free = true;
        drive.acceleration = None;
        if draft.random.chance(0.2) && i == 0 {
            drive.speed = Some(Expr::number(0.0));
            // at rest it may hold
            m.loads.retain(|load| !load.is_against_motion());
        }
    }
    draft
}

/// The condition of the masses of the free coordinates, each in the unit in which its own is 1.
fn condition(draft: &Draft) -> Option<f64> {
    let mut mechanism = draft.mechanism.clone();
    let free: Vec<usize> = (0..mechanism.drives.len()).filter(|i| mechanism.drives[*i].free).collect();
    let mut columns: Vec<Vec<Rates>> = Vec::new();
    for &one in &free {
        for (i, drive) in mechanism.drives.iter_mut().enumerate() {
            drive.speed = Some(Expr::number(f64::from(u8::from(i == one))));
            drive.acceleration = None;
        }
        columns.push(Reference::new(&mechanism, &draft.frames)?.rates);
    }
    let of = |i: usize, j: usize| -> f64 {
        let both = columns[i].iter().zip(&columns[j]).zip(&draft.frames).zip(&mechanism.links);
        let each = both.map(|(((a, b), frame), link)| {
            let Some(m) = &link.mass else { return 0.0 };
            let arm = m.centre.turned(frame.u).perp();
            let (v, w) = (a.v + arm * a.omega, b.v + arm * b.omega);
            m.mass * v.dot(w) + m.inertia * a.omega * b.omega
        });
        each.sum()
    };
    let n = free.len();
    let scaled = DMatrix::from_fn(n, n, |i, j| of(i, j) / (of(i, i) * of(j, j)).sqrt());
    let least = scaled.symmetric_eigenvalues().min();
    (least > 1e-9).then_some(least)
}

/// What one mechanism misses, over the greatest acceleration and the condition.
fn missed(draft: &Draft) -> Result<Option<f64>, String> {
    let Some(reference) = Reference::new(&draft.mechanism, &draft.frames) else {
        return Ok(None);
    };
    let Some(mass) = condition(draft) else { return Ok(None) };
    let Some(mut bodies) = Bodies::new(&draft.mechanism) else { return Ok(None) };
    let Some((want, doubtful)) = bodies.accelerations(&draft.frames, &reference.rates, 0.0) else {
        return Ok(None);
    };
    if doubtful {
        return Ok(None);
    }
    let mut mechanism = draft.mechanism.clone();
    followed(&mut mechanism, 1e-4, None, 1e-3);
    let run = Run::new(&mechanism)?;
    Ok(Some(off(&run, draft, &want)? * mass))
}

/// What the first position of a run misses of these accelerations, over the greatest and the condition.
fn off(run: &Run, draft: &Draft, want: &[Rates]) -> Result<f64, String> {
    let (solved, view) = (run.solved(0)?, run.view(0)?);
    let greatest = |of: &dyn Fn(&Rates) -> f64| want.iter().map(of).fold(1.0, f64::max);
    let scale = greatest(&|r| r.a.norm().max(r.alpha.abs()).max(r.omega * r.omega).max(r.v.dot(r.v)));
    let mut most = 0.0_f64;
    for (i, rates) in want.iter().enumerate().skip(1) {
        let link = LinkId::at(i);
        if draft.rollers.contains(&link) {
            continue;
        }
        let got = vector(&view, &Query::Acceleration(PointRef::Fixed(link, Vec2::zero())));
        let alpha = scalar(&view, &Query::Alpha(link));
        let worst = (got - rates.a).norm().max((alpha - rates.alpha).abs());
        most = if worst.is_nan() { f64::INFINITY } else { most.max(worst) };
    }
    Ok(most / scale * solved.condition.powi(3))
}

/// 200 random mechanisms with one to three free coordinates at their first instant.
#[test]
fn accelerations_are_those_of_all_bodies_at_once() {
    let (mut compared, mut failures, mut worst) = (0, Vec::new(), (0.0, 0));
    let (mut several, mut opened) = (0, 0);
    for seed in 20_000.. {
        if compared >= many(200) {
            break;
        }
        let draft = freed(seed);
        if draft.mechanism.drives.len() == 1 && seed % 3 > 0 {
            continue;
        }
        match missed(&draft) {
            Ok(None) => {}
            Ok(Some(error)) => {
                compared += 1;
                several += u64::from(draft.mechanism.drives.iter().filter(|d| d.free).count() > 1);
                if error > worst.0 {
                    worst = (error, seed);
                }
                if error > 1e-11 {
                    failures.push(format!("seed {seed}: {error:e}"));
                }
            }
            // a contact that would have to pull at the first instant: there is no motion
            Err(e) if e.contains("Opens") => opened += 1,
            Err(e) => failures.push(format!("seed {seed}: {e:.300}")),
        }
    }
    println!("{compared} compared, {several} with several free coordinates, worst {worst:?}");
    assert!(failures.is_empty(), "{} failures\n{}", failures.len(), failures.join("\n"));
    // of the first fifth exactly a quarter has several
    let quarter = if crate::share::all() { compared + 1 } else { compared };
    assert!(several * 4 >= quarter, "{several} of {compared}");
    assert!(opened < compared, "{opened} open at once, {compared} compared");
}
