//! Friction against independent paths: random mechanisms by a damped fixed point on the equations of Newton and Euler of
//! all links, the crank-slider by its closed form.

#[path = "properties/change.rs"]
#[allow(dead_code)]
mod change;
#[path = "properties/draft.rs"]
#[allow(dead_code)]
mod draft;
#[path = "properties/equilibrium.rs"]
#[allow(dead_code)]
mod equilibrium;
#[path = "properties/generate.rs"]
#[allow(dead_code)]
mod generate;
#[path = "properties/groups.rs"]
#[allow(dead_code)]
mod groups;
#[path = "properties/jet.rs"]
#[allow(dead_code)]
mod jet;
#[path = "properties/loads.rs"]
#[allow(dead_code)]
mod loads;
#[path = "properties/machines.rs"]
mod machines;
#[path = "properties/random.rs"]
#[allow(dead_code)]
mod random;
#[path = "properties/reference.rs"]
#[allow(dead_code)]
mod reference;
#[path = "properties/run.rs"]
#[allow(dead_code)]
mod run;

use assur::check::Overrides;
use assur::math::Vec2;
use assur::model::{Expr, Friction, LinkId, Load, LoadKind, Mechanism, PairId, PairKind};
use assur::plan::ForceStep;
use assur::source::{Source, Span};
use draft::Draft;
use equilibrium::{Forces, equilibrium};
use reference::Reference;
use run::Run;

/// Velocities below this are none; positions where one is near it are left out.
const STILL: f64 = 1e-7;

/// Friction between two links of a pair.
#[derive(Debug)]
struct Rub {
    pair: PairId,
    on: LinkId,
    from: LinkId,
    turns: bool,
    factor: f64,
    speed: f64,
}

/// Every pair that can rub, with the relative velocity from the reference.
fn rubs(mechanism: &Mechanism, reference: &Reference) -> Vec<Rub> {
    let mut all = Vec::new();
    let omega = |l: LinkId| reference.rates[l.index()].omega;
    for (i, pair) in mechanism.pairs.iter().enumerate() {
        let pair_id = PairId::at(i);
        match (&pair.kind, pair.friction) {
            (PairKind::Revolute(pins), Some(Friction::Circle(factor))) => {
                let from = pins[0].link;
                all.extend(pins[1..].iter().map(|pin| {
                    let speed = omega(pin.link) - omega(from);
                    Rub { pair: pair_id, on: pin.link, from, turns: true, factor, speed }
                }));
            }
            (PairKind::Prismatic(g) | PairKind::Slot(g), Some(Friction::Coefficient(factor))) => {
                let (slider, guide) =
                    (&reference.bodies[g.slider.index()], &reference.bodies[g.guide.index()]);
                let p = slider.point(g.point).value();
                let along = guide.axis(g.along).value();
                let at = |link: LinkId| {
                    let body = reference.bodies[link.index()].p;
                    body.rate() + (p - body.value()).perp() * omega(link)
                };
                let speed = (at(g.slider) - at(g.guide)).dot(along);
                all.push(Rub { pair: pair_id, on: g.slider, from: g.guide, turns: false, factor, speed });
            }
            _ => {}
        }
    }
    all
}

fn load(kind: LoadKind) -> Load {
    Load { name: None, span: Span::default(), kind, when: None }
}

/// The mechanism with its friction as loads of these values.
fn loaded(mechanism: &Mechanism, rubs: &[Rub], efforts: &[f64]) -> Mechanism {
    let mut out = mechanism.clone();
    for (rub, &x) in rubs.iter().zip(efforts) {
        if rub.turns {
            for (on, value) in [(rub.on, x), (rub.from, -x)] {
                out.loads.push(load(LoadKind::Torque {
                    on,
                    value: Expr::number(value),
                    against_motion: false,
                }));
            }
        } else {
            out.loads.push(load(LoadKind::InPair { pair: rub.pair, value: Expr::number(x) }));
        }
    }
    out
}

fn laws(rubs: &[Rub], forces: &Forces) -> Vec<f64> {
    let force = |rub: &Rub| {
        let on = forces.reactions.iter().find(|r| r.pair == rub.pair && r.link == rub.on);
        on.map_or(f64::NAN, |r| r.force.norm())
    };
    rubs.iter().map(|rub| -rub.speed.signum() * rub.factor * force(rub)).collect()
}

/// Friction and forces by a damped fixed point from none; `None` where it does not settle.
fn fixed_point(mechanism: &Mechanism, reference: &Reference, rubs: &[Rub]) -> Option<(Vec<f64>, Forces)> {
    let mut x = vec![0.0; rubs.len()];
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
        x.iter_mut().zip(&next).for_each(|(x, next)| *x += 0.7 * (next - *x));
    }
    None
}

/// Friction in every revolute, prismatic pair and slot.
fn rubbing(draft: &Draft, factor: impl Fn(usize) -> f64) -> Mechanism {
    let mut mechanism = draft.mechanism.clone();
    for (i, pair) in mechanism.pairs.iter_mut().enumerate() {
        pair.friction = match &pair.kind {
            PairKind::Revolute(_) => Some(Friction::Circle(0.1 * factor(i))),
            PairKind::Prismatic(_) | PairKind::Slot(_) => Some(Friction::Coefficient(factor(i))),
            _ => None,
        };
    }
    mechanism
}

#[test]
fn random_mechanisms_agree_with_a_fixed_point_on_all_equations() {
    let (mut compared, mut wrong) = (0, Vec::new());
    for seed in 20_000..20_700 {
        let draft = generate::mechanism(seed);
        let mechanism = rubbing(&draft, |i| 0.01 + 0.01 * (i % 5) as f64);
        let Some(reference) = Reference::new(&mechanism, &draft.frames) else { continue };
        let fine = |f: &Forces| !f.doubtful && f.condition > 1e-3;
        let rubs = rubs(&mechanism, &reference);
        let Some(forces) = reference.forces.as_ref().filter(|f| fine(f)) else { continue };
        let determined = rubs.iter().all(|rub| {
            forces.reactions.iter().any(|r| r.pair == rub.pair && r.link == rub.on && r.determined.0)
        });
        if !determined || rubs.iter().any(|r| r.speed.abs() < STILL) {
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
        let found = view.rubbing();
        let scale = forces.most.0;
        for (rub, x) in rubs.iter().zip(&x) {
            let same = |r: &&assur::solve::Rubbing| {
                r.pair == rub.pair && [r.on, r.from].contains(&rub.on) && [r.on, r.from].contains(&rub.from)
            };
            let Some(r) = found.iter().find(same) else {
                let links = mechanism.pair(rub.pair).kind.links();
                let there: Vec<_> =
                    found.iter().filter(|r| r.pair == rub.pair).map(|r| (r.from, r.on)).collect();
                wrong.push(format!("seed {seed}: pair {rub:?} of {links:?} has {there:?}"));
                continue;
            };
            // each against its own relative motion, whatever its sense
            let (effort, x) = (r.effort * r.speed.signum(), x * rub.speed.signum());
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
        let off = (power - expected).abs();
        if expected.is_finite() && (off.is_nan() || off > 1e-9 * size / forces.condition.min(1.0)) {
            wrong.push(format!("seed {seed}: efforts give {power:e}, not {expected:e}"));
        }
    }
    let told = wrong.iter().take(20).map(String::as_str).collect::<Vec<_>>();
    assert!(wrong.is_empty(), "{} of {compared}\n{}", wrong.len(), told.join("\n"));
    assert!(compared > 150, "{compared} compared");
}

/// All forces of the first position, bit by bit.
fn bits(run: &Run) -> Option<Vec<u64>> {
    let solved = run.solved(0).ok()?;
    let reactions = solved.state.reactions.iter().flat_map(|r| [r.force.x, r.force.y, r.couple]);
    Some(reactions.chain(solved.state.efforts.iter().copied()).map(f64::to_bits).collect())
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
            let rubs = run.plan.forces.iter().any(|s| matches!(s, ForceStep::Rubbing { .. }));
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

#[test]
fn the_crank_slider_locks_where_its_closed_form_says() {
    let (mut free, mut locked) = (0, 0);
    for length in [1.05, 1.3, 2.0, 3.5] {
        for mu in [0.05, 0.3, 0.6, 1.0, 1.5] {
            let rho = 0.05 * mu;
            let text = format!(
                "ground {{ A (0, 0); line guide through A along 0 deg }}
link crank A-B 1 m
link rod B-C {length} m
link piston {{ C (0, 0) }}
revolute A: ground - crank
revolute B: crank - rod {{ friction_circle {rho} m }}
revolute C: rod - piston {{ friction_circle {rho} m }}
prismatic D: piston.C - ground.guide {{ friction {mu} }}
drive crank = 0.123 deg .. 360.123 deg in 720 steps at 1 rad/s
assemble C ahead of B
force on piston at C = 1000 N against motion
find efficiency(), locked()
"
            );
            let source = Source::new("grid.mech", text);
            let (solved, problems) = assur::solve_source(&source, &Overrides::none());
            let Some(solved) = solved else { panic!("{problems:?}") };
            let scene = solved.compiled.scene();
            assert_eq!(solved.solution.poses.len(), 720);
            for (i, pose) in solved.solution.poses.iter().enumerate() {
                let degrees = 0.123 + 0.5 * i as f64;
                let place = format!("l = {length}, f = {mu} at {degrees} deg");
                let pose = pose.outcome.as_ref().unwrap_or_else(|e| panic!("{place}: {e}"));
                let view = solved.solution.view(&scene, pose);
                let margin = moves(length, rho, mu, degrees.to_radians());
                assert!(margin.abs() > 1e-9, "{place}: on the limit");
                assert_eq!(view.efficiency() > 0.0, margin > 0.0, "{place}: margin {margin}");
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
    assert!(free > 5000 && locked > 500, "{free} free, {locked} locked");
}
