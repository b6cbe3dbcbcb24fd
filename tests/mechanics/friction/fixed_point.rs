//! Friction against independent paths: random mechanisms by a damped fixed point on the equations of Newton and Euler of
//! all links, the crank-slider by its closed form.

use super::pair_friction::{Kind, PairFriction, loaded, pair_frictions};
use crate::share::least;
use crate::support::draft::Draft;
use crate::support::equilibrium::{Forces, equilibrium};
use crate::support::generate;
use crate::support::reference::Reference;
use crate::support::run::Run;
use assur::internals::check::Overrides;
use assur::internals::math::Vec2;
use assur::internals::model::{Friction, Mechanism, PairKind};
use assur::internals::plan::ForceStep;
use assur::internals::solve::Model;
use assur::internals::source::Source;

/// Positions with a slower sliding velocity, other than none, are left out.
const SLOWEST: f64 = 1e-7;

pub fn laws(rubs: &[PairFriction], forces: &Forces) -> Vec<f64> {
    let force = |rub: &PairFriction| {
        let on = forces.reactions.iter().find(|r| r.pair == rub.pair && r.link == rub.on);
        on.map_or(f64::NAN, |r| r.force.norm())
    };
    rubs.iter().map(|rub| -rub.sense() * rub.factor * force(rub)).collect()
}

/// What of a step of a fixed point is taken: all as long as each leaves half of what was off, else seven tenths.
pub fn step(off: f64, before: &mut f64) -> f64 {
    let halves = off < 0.5 * *before;
    *before = off;
    if halves { 1.0 } else { 0.7 }
}

/// Friction and forces by a damped fixed point from none; `None` where it does not settle.
fn fixed_point(
    mechanism: &Mechanism,
    reference: &Reference,
    rubs: &[PairFriction],
) -> Option<(Vec<f64>, Forces)> {
    let (mut x, mut before) = (vec![0.0; rubs.len()], f64::INFINITY);
    for _ in 0..400 {
        let forces = equilibrium(&loaded(mechanism, rubs, &x), &reference.bodies, &reference.rates)?;
        let next = laws(rubs, &forces);
        let scale = next.iter().fold(f64::MIN_POSITIVE, |m, x| m.max(x.abs()));
        let off = next.iter().zip(&x).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        if off < 1e-13 * scale {
            return Some((x, forces));
        }
        if !off.is_finite() {
            return None;
        }
        let step = step(off, &mut before);
        x.iter_mut().zip(&next).for_each(|(x, next)| *x += step * (next - *x));
    }
    None
}

/// Friction in every revolute, prismatic pair, slot and contact, but those of links that turn freely.
pub fn rubbing(draft: &Draft, factor: impl Fn(usize) -> f64) -> Mechanism {
    let mut mechanism = draft.mechanism.clone();
    for (i, pair) in mechanism.pairs.iter_mut().enumerate() {
        if pair.kind.links().iter().any(|l| draft.rollers.contains(l)) {
            continue;
        }
        pair.friction = match &pair.kind {
            PairKind::Revolute(_) => Some(Friction::Circle(0.1 * factor(i))),
            PairKind::Prismatic(_) | PairKind::Slot(_) | PairKind::Contact { .. } => {
                Some(Friction::Coefficient(factor(i)))
            }
            PairKind::Cylinder { .. } | PairKind::Weld { .. } | PairKind::Transmission(_) => None,
        };
    }
    mechanism
}

#[test]
fn random_mechanisms_agree_with_a_fixed_point_on_all_equations() {
    let (mut compared, mut contacts, mut slots, mut wrong) = (0, 0, 0, Vec::new());
    for seed in crate::share::first(30_000..32_200) {
        let draft = generate::mechanism(seed);
        let mechanism = rubbing(&draft, |i| 0.01 + 0.01 * (i % 5) as f64);
        let Some(reference) = Reference::new(&mechanism, &draft.frames) else { continue };
        let fine = |f: &Forces| !f.doubtful && f.condition > 1e-3;
        let rubs = pair_frictions(&mechanism, &reference);
        let Some(forces) = reference.forces.as_ref().filter(|f| fine(f)) else { continue };
        let determined = rubs.iter().all(|rub| {
            forces.reactions.iter().any(|r| r.pair == rub.pair && r.link == rub.on && r.determined.0)
        });
        if !determined || rubs.iter().any(|r| r.is_slower(SLOWEST)) {
            continue;
        }
        let Some((x, forces)) = fixed_point(&mechanism, &reference, &rubs) else { continue };
        let run = match Run::new(&mechanism) {
            Ok(run) => run,
            Err(e) => {
                wrong.push(format!("seed {seed}: {e:.300}"));
                continue;
            }
        };
        let Ok(view) = run.view(0) else { continue };
        compared += 1;
        contacts += rubs.iter().filter(|r| matches!(r.kind, Kind::Contact(..))).count();
        slots += rubs.iter().filter(|r| matches!(mechanism.pair(r.pair).kind, PairKind::Slot(_))).count();
        let found = view.pair_frictions();
        let scale = forces.most.0;
        for (rub, x) in rubs.iter().zip(&x) {
            let Some(r) = found.iter().find(|r| rub.is_of(r)) else {
                let links = mechanism.pair(rub.pair).kind.links();
                let there: Vec<_> =
                    found.iter().filter(|r| r.pair == rub.pair).map(|r| (r.from, r.on)).collect();
                wrong.push(format!("seed {seed}: pair {rub:?} of {links:?} has {there:?}"));
                continue;
            };
            // each against its own relative motion, whatever its sense
            let (effort, x) = (r.effort * r.speed.signum(), x * rub.sense());
            let off = (effort - x).abs();
            if off.is_nan() || off > 1e-9 * scale / forces.condition.min(1.0) {
                wrong.push(format!(
                    "seed {seed}: pair {}: {effort:e}, not {x:e} of {scale:e}",
                    rub.pair.index()
                ));
            }
        }
        let (power, expected) = (view.power_of_efforts(), forces.effort_powers.iter().sum::<f64>());
        let size = forces.effort_powers.iter().map(|p| p.abs()).sum::<f64>();
        let fastest = reference.rates.iter().map(|r| r.v.norm().max(r.omega.abs())).fold(0.0, f64::max);
        // a force whose point stands still gives what rounding leaves
        let size = size.max(1e-6 * scale * fastest);
        let off = (power - expected).abs();
        if expected.is_finite() && (off.is_nan() || off > 1e-9 * size / forces.condition.min(1.0)) {
            wrong.push(format!("seed {seed}: efforts give {power:e}, not {expected:e}"));
        }
    }
    let told = wrong.iter().take(20).map(String::as_str).collect::<Vec<_>>();
    assert!(wrong.is_empty(), "{} of {compared}\n{}", wrong.len(), told.join("\n"));
    let counts = format!("{compared} compared, {contacts} contacts, {slots} slots");
    assert!(compared >= least(2000) && contacts > least(800) && slots > least(500), "{counts}");
}

#[test]
fn dyads_agree_with_the_laws_taken_one_by_one() {
    let (mut moved, mut locked, mut differ) = (0, 0, Vec::new());
    for seed in crate::share::first(22_000..22_400) {
        let draft = generate::mechanism(seed);
        let mechanism = rubbing(&draft, |i| 0.1 + 0.4 * (i % 5) as f64);
        let Ok(run) = Run::new(&mechanism) else { continue };
        let mut plan = run.plan.clone();
        let mut reduced = 0;
        for step in &mut plan.forces {
            let ForceStep::Friction { group, .. } = step else { continue };
            reduced += usize::from(group.reduced.take().is_some());
        }
        if reduced == 0 {
            continue;
        }
        let Ok(quick) = run.solved(0) else { continue };
        if quick.condition < 1e-3 {
            continue;
        }
        let model = Model { plan: &plan, ..run.model() };
        let Ok(solution) = assur::internals::solve::solve(&model) else { continue };
        let Some(Ok(slow)) = solution.poses.first().map(|p| &p.outcome) else { continue };
        if quick.state.forces.locked != slow.state.forces.locked {
            differ.push(format!(
                "seed {seed}: locked {} and {}",
                quick.state.forces.locked, slow.state.forces.locked
            ));
        } else if quick.state.forces.locked {
            locked += 1;
        } else {
            moved += 1;
            let scale = slow.state.forces.reactions.iter().map(|r| r.force.norm()).fold(0.0, f64::max);
            for (a, b) in quick.state.forces.frictions.iter().zip(&slow.state.forces.frictions) {
                if (a - b).abs() > 1e-9 * scale {
                    differ.push(format!("seed {seed}: {a:e} and {b:e} of {scale:e}"));
                }
            }
        }
    }
    assert!(differ.is_empty(), "{} differ of {moved} and {locked}\n{}", differ.len(), differ.join("\n"));
    assert!(moved > least(120) && locked > least(40), "{moved} moved, {locked} locked");
}

/// All forces of the first position, bit by bit.
fn bits(run: &Run) -> Option<Vec<u64>> {
    let solved = run.solved(0).ok()?;
    let reactions = solved.state.forces.reactions.iter().flat_map(|r| [r.force.x, r.force.y, r.couple]);
    Some(reactions.chain(solved.state.forces.efforts.iter().copied()).map(f64::to_bits).collect())
}

#[test]
fn zero_coefficients_change_no_bit_and_have_no_step() {
    for seed in 21_000..21_200 {
        let draft = generate::mechanism(seed);
        let (Ok(plain), Ok(zero)) = (Run::new(&draft.mechanism), Run::new(&rubbing(&draft, |_| 0.0))) else {
            continue;
        };
        assert_eq!(bits(&plain), bits(&zero), "seed {seed}");
        for run in [&plain, &zero] {
            let rubs = run.plan.forces.iter().any(|s| matches!(s, ForceStep::Friction { .. }));
            assert!(!rubs && run.plan.friction.is_empty() && !run.plan.effects.friction, "seed {seed}");
        }
    }
}

/// Whether a crank of length 1 can push a piston against a force: the rod's force lies along the common tangent of the
/// friction circles, σ away from the crank or towards it; it must overcome the guide's friction.
fn moves(length: f64, rho: f64, f: f64, angle: f64) -> f64 {
    let b = Vec2::new(libm::cos(angle), libm::sin(angle));
    let cos = (1.0 - (b.y / length).powi(2)).sqrt();
    let rod = Vec2::new(cos, -b.y / length);
    let omega = -b.x / (length * cos);
    let slides = -b.y + omega * b.y; // v_C = v_B + ω × BC
    let (s_b, s_c, s_d) = ((omega - 1.0).signum(), omega.signum(), slides.signum());
    let sigma = -s_d;
    let sine = sigma * rho * (s_b + s_c) / length;
    let e = rod * (1.0 - sine * sine).sqrt() + rod.perp() * sine;
    -sigma * s_d * e.x - f * e.y.abs()
}

/// Positions of the grid, deg: a turn in steps of half a degree, and on both sides of every limit of locking.
const GRID: usize = 721;

/// Crank angles near which the crank-slider begins to lock, deg, from those of the grid.
fn limits(grid: &[f64], margin: impl Fn(f64) -> f64) -> Vec<f64> {
    let changes = grid.windows(2).filter(|w| margin(w[0]) * margin(w[1]) < 0.0);
    let bisected = changes.map(|w| {
        let (mut from, mut to) = (w[0], w[1]);
        for _ in 0..60 {
            let middle = 0.5 * (from + to);
            if margin(middle) * margin(from) > 0.0 { from = middle } else { to = middle }
        }
        from
    });
    bisected.collect()
}

#[test]
fn the_crank_slider_locks_where_its_closed_form_says() {
    let (mut free, mut locked, mut near) = (0, 0, 0);
    for length in [1.05, 1.3, 2.0, 3.5] {
        for mu in [0.05, 0.3, 0.6, 1.0, 1.5] {
            let rho = 0.05 * mu;
            let margin = |degrees: f64| moves(length, rho, mu, degrees.to_radians());
            let mut angles: Vec<f64> = (0..GRID).map(|i| 0.123 + 0.5 * i as f64).collect();
            for limit in limits(&angles, margin) {
                for digits in 1..=8 {
                    let off = libm::pow(10.0, -f64::from(digits));
                    angles.extend([limit - off, limit + off]);
                    near += 2;
                }
            }
            angles.sort_by(f64::total_cmp);
            let list: Vec<String> = angles.iter().map(|a| format!("{a} deg")).collect();
            let text = format!(
                "ground {{ A (0, 0); line guide through A along 0 deg }}
link crank A-B 1 m
link rod B-C {length} m
link piston {{ C (0, 0) }}
revolute A: ground - crank
revolute B: crank - rod {{ friction_circle {rho} m }}
revolute C: rod - piston {{ friction_circle {rho} m }}
prismatic D: piston.C - ground.guide {{ friction {mu} }}
drive crank = {} at 1 rad/s
assemble C ahead of B
force on piston at C = 1000 N against motion
find efficiency(), locked()
",
                list.join(", ")
            );
            let source = Source::new("grid.mech", text);
            let (solved, problems) = assur::internals::solve_source(&source, &Overrides::none());
            let Some(solved) = solved else { panic!("{problems:?}") };
            let model = solved.compiled.model();
            assert_eq!(solved.solution.poses.len(), angles.len());
            for (pose, degrees) in solved.solution.poses.iter().zip(&angles) {
                let place = format!("l = {length}, f = {mu} at {degrees} deg");
                let pose = pose.outcome.as_ref().unwrap_or_else(|e| panic!("{place}: {e:?}"));
                let view = solved.solution.view(&model, pose);
                let margin = margin(*degrees);
                assert!(margin.abs() > 1e-11, "{place}: on the limit");
                assert_eq!(view.efficiency() > 0.0, margin > 0.0, "{place}: margin {margin}");
                let mut state = pose.state.clone().ready(model.plan);
                state.run_loads(&model, &[]);
                state.run_forces(model.plan);
                let steps: u32 = state.scratch.friction_work.iter().flatten().map(|w| w.steps()).sum();
                assert!((1..=5).contains(&steps), "{place}: {steps} steps");
                if margin > 0.0 {
                    free += 1;
                    let worst = pose.residuals.equilibrium.unwrap_or(f64::NAN);
                    assert!(worst <= 1e-12, "{place}: residual {worst}");
                } else {
                    locked += 1;
                }
            }
        }
    }
    assert!(free > 5000 && locked > 500 && near > 400, "{free} free, {locked} locked, {near} near a limit");
}
