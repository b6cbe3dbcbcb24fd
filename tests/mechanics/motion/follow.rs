//! Runs of random mechanisms against an integration of all bodies at once, energy, and the same mechanism seen otherwise.

use super::newton_euler::{Bodies, followed, last};
use super::{freed, many};
use crate::support::change::Change;
use crate::support::draft::{Draft, Frame};
use crate::support::reference::{Rates, Reference, Solver};
use crate::support::run::{Run, scalar, vector};
use assur::internals::math::Vec2;
use assur::internals::math::ode::{Extrapolation, Integrator, Step, System, Tolerance, Undefined};
use assur::internals::model::{Expr, LinkId, LoadKind, PointRef, Query};
use assur::internals::solve::Method;

/// A random mechanism of few links whose loads are smooth.
fn smooth(seed: u64, links: usize) -> Option<Draft> {
    let mut draft = freed(seed);
    draft.mechanism.loads.retain(|load| {
        let against = matches!(
            load.kind,
            LoadKind::ForceAgainstMotion { .. } | LoadKind::Torque { against_motion: true, .. }
        );
        load.when.is_none() && !against
    });
    (draft.frames.len() <= links + 1).then_some(draft)
}

/// Places, angles and their rates of all bodies.
struct AllBodies {
    bodies: Bodies,
}

fn unpacked(y: &[f64]) -> (Vec<Frame>, Vec<Rates>) {
    let (q, v) = y.split_at(y.len() / 2);
    let mut frames = vec![Frame::GROUND];
    frames.extend(q.chunks_exact(3).map(|q| Frame { p: Vec2::new(q[0], q[1]), u: Vec2::direction(q[2]) }));
    let mut rates = vec![Rates::default()];
    rates.extend(v.chunks_exact(3).map(|v| Rates {
        v: Vec2::new(v[0], v[1]),
        omega: v[2],
        ..Rates::default()
    }));
    (frames, rates)
}

impl System<f64> for AllBodies {
    fn rates(&mut self, t: f64, y: &[f64], dy: &mut [f64]) -> Result<(), Undefined> {
        let (frames, rates) = unpacked(y);
        let (found, _) = self.bodies.accelerations(&frames, &rates, t).ok_or(Undefined)?;
        let half = y.len() / 2;
        dy[..half].copy_from_slice(&y[half..]);
        for (out, r) in dy[half..].chunks_exact_mut(3).zip(&found[1..]) {
            out.copy_from_slice(&[r.a.x, r.a.y, r.alpha]);
        }
        Ok(())
    }
}

impl AllBodies {
    /// The nearest places that close, and velocities that go with them.
    fn project(&self, t: f64, y: &mut [f64]) -> Option<()> {
        let half = y.len() / 2;
        for _ in 0..2 {
            let (frames, rates) = unpacked(y);
            let solver = Solver::of_any_rank(self.bodies.jacobian(&frames, t));
            let step = solver.solve(&self.bodies.missing(&frames, &rates, t).0)?;
            y[..half].iter_mut().zip(&step).for_each(|(y, s)| *y -= s);
        }
        let (frames, rates) = unpacked(y);
        let solver = Solver::of_any_rank(self.bodies.jacobian(&frames, t));
        let step = solver.solve(&self.bodies.missing(&frames, &rates, t).1)?;
        y[half..].iter_mut().zip(&step).for_each(|(y, s)| *y -= s);
        Some(())
    }

    /// Where all bodies are at the end.
    fn integrate(&mut self, mut y: Vec<f64>, end: f64) -> Option<Vec<f64>> {
        let mut method = Extrapolation::new(Tolerance::uniform(y.len(), 1e-12, 1e-12));
        method.start(self, 0.0, &y, end).ok()?;
        loop {
            let step = method.step(self).ok()?;
            y.copy_from_slice(method.y());
            self.project(method.t(), &mut y)?;
            if step == Step::Last {
                return Some(y);
            }
            if method.counts().evaluations > 30_000 {
                return None;
            }
            method.restart(self, &y, end).ok()?;
        }
    }
}

/// The greatest difference of a run from the integration of all bodies, and the method; `None` where one of them stops on the way.
fn differs(draft: &Draft) -> Option<(f64, Method)> {
    let reference = Reference::new(&draft.mechanism, &draft.frames)?;
    let mut mechanism = draft.mechanism.clone();
    followed(&mut mechanism, 1.0, None, 1e-10);
    let run = Run::new(&mechanism).ok()?;
    let end = last(&run)?;
    let method = run.solution.as_ref().ok()?.simulation.as_ref()?.method;
    let q = draft.frames[1..].iter().flat_map(|f| [f.p.x, f.p.y, f.u.angle()]);
    let v = reference.rates[1..].iter().flat_map(|r| [r.v.x, r.v.y, r.omega]);
    let mut all = AllBodies { bodies: Bodies::new(&draft.mechanism)? };
    let (frames, rates) = unpacked(&all.integrate(q.chain(v).collect(), 1.0)?);
    let view = run.view(end).ok()?;
    let speed = rates.iter().map(|r| r.v.norm().max(r.omega.abs())).fold(1.0, f64::max);
    let mut most = 0.0_f64;
    for (i, (frame, rates)) in frames.iter().zip(&rates).enumerate().skip(1) {
        let link = LinkId::at(i);
        if draft.rollers.contains(&link) {
            continue;
        }
        let point = PointRef::Fixed(link, Vec2::zero());
        let place = (vector(&view, &Query::Position(point)) - frame.p).norm();
        let turn = (vector(&view, &Query::LinkDirection(link)) - frame.u).norm();
        let v = (vector(&view, &Query::Velocity(point)) - rates.v).norm();
        let omega = (scalar(&view, &Query::Omega(link)) - rates.omega).abs();
        let worst = place.max(turn).max(v.max(omega) / speed);
        most = if worst.is_nan() { f64::INFINITY } else { most.max(worst) };
    }
    Some((most, method))
}

#[test]
fn a_second_is_that_of_all_bodies_at_once() {
    let (mut compared, mut tried, mut worst, mut failures) = (0, 0, (0.0, 0), Vec::new());
    for seed in 30_000.. {
        if compared >= many(20) {
            break;
        }
        let Some(draft) = smooth(seed, 4) else { continue };
        tried += 1;
        let Some((error, _)) = differs(&draft) else { continue };
        compared += 1;
        if error > worst.0 {
            worst = (error, seed);
        }
        if error > 1e-8 {
            failures.push(format!("seed {seed}: {error:e}"));
        }
    }
    println!("{compared} of {tried} went on for a second, worst {worst:?}");
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

/// Motions of one coordinate that are found from the energy alone.
#[test]
fn the_energy_tells_what_all_bodies_do() {
    let (mut compared, mut worst, mut failures) = (0, (0.0, 0), Vec::new());
    for seed in 60_000.. {
        if compared >= many(15) {
            break;
        }
        let Some(mut draft) = smooth(seed, 6) else { continue };
        let m = &mut draft.mechanism;
        m.springs.iter_mut().for_each(|s| s.damping = 0.0);
        m.loads.retain(|load| load.expressions().all(|e| matches!(e, Expr::Constant(_))));
        if m.drives.len() != 1 {
            continue;
        }
        let Some((error, Method::Energy)) = differs(&draft) else { continue };
        compared += 1;
        if error > worst.0 {
            worst = (error, seed);
        }
        if error > 1e-8 {
            failures.push(format!("seed {seed}: {error:e}"));
        }
    }
    println!("{compared} went on for a second, worst {worst:?}");
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

/// Within 1e-9, kinetic and potential energy of weights and springs stay what they are, where nothing else acts.
#[test]
fn energy_stays() {
    let (mut went, mut worst) = (0, (0.0, 0));
    for seed in 40_000.. {
        if went >= many(60) {
            break;
        }
        let mut draft = freed(seed);
        let m = &mut draft.mechanism;
        m.loads.clear();
        m.springs.iter_mut().for_each(|s| s.damping = 0.0);
        if m.drives.iter().any(|d| !d.free) {
            continue;
        }
        followed(m, 0.5, Some(4), 1e-9);
        let Ok(run) = Run::new(m) else { continue };
        let Some(end) = last(&run) else { continue };
        let energy = |pose: usize| {
            let view = run.view(pose).expect("it went on");
            (scalar(&view, &Query::KineticEnergy), scalar(&view, &Query::PotentialEnergy))
        };
        let (kinetic, potential) = energy(0);
        let all: Vec<(f64, f64)> = (0..=end).map(energy).collect();
        let scale = all.iter().map(|e| e.0.max((e.1 - potential).abs())).fold(0.0, f64::max);
        let missing = all.iter().map(|e| (e.0 + e.1 - kinetic - potential).abs()).fold(0.0, f64::max);
        if scale < 1e-9 {
            // it rests
            continue;
        }
        let missing = if missing.is_nan() { f64::INFINITY } else { missing / scale };
        went += 1;
        if missing > worst.0 {
            worst = (missing, seed);
        }
    }
    println!("{went} went on, worst {worst:?}");
    // where an instant lies within a long step, the polynomial there is a little less accurate than the step
    assert!(worst.0 < 1e-8, "{worst:?}");
}

/// The same motion, turned, mirrored, scaled and written down in another order.
#[test]
fn a_motion_does_not_hang_on_frames_scales_and_order() {
    let (mut compared, mut worst) = (0, (0.0, 0, ""));
    for seed in 50_000.. {
        if compared >= many(30) {
            break;
        }
        let Some(mut draft) = smooth(seed, 8) else { continue };
        followed(&mut draft.mechanism, 0.3, None, 1e-10);
        let Ok(run) = Run::new(&draft.mechanism) else { continue };
        let Some(end) = last(&run) else { continue };
        let one = run.view(end).expect("it went on");
        compared += 1;
        let none = Change::none(&draft.mechanism);
        let random = &mut draft.random;
        let turned = Change { turn: random.within(-3.0, 3.0), shift: random.vector(2.0), ..none.clone() };
        let mirrored = Change { mirror: -1.0, ..none.clone() };
        let scaled =
            Change { length: random.within(0.01, 30.0), mass: random.within(0.001, 50.0), ..none.clone() };
        let pairs = random.shuffled(none.pairs.len());
        let reordered = Change { pairs, rename: true, ..none };
        for (kind, change) in
            [("turned", turned), ("mirrored", mirrored), ("scaled", scaled), ("reordered", reordered)]
        {
            let other = Run::new(&change.apply(&draft.mechanism)).expect("it is the same mechanism");
            let end = last(&other).unwrap_or_else(|| panic!("seed {seed}, {kind}: it goes on as well"));
            let two = other.view(end).expect("it went on");
            for link in (1..draft.frames.len()).map(LinkId::at).filter(|l| !draft.rollers.contains(l)) {
                let (local, new) = (Vec2::new(0.3, -0.2), change.link(link));
                let at = vector(&one, &Query::Position(PointRef::Fixed(link, local)));
                let there = vector(&two, &Query::Position(PointRef::Fixed(new, change.point(link, local))));
                let apart = (change.place(at) - there).norm() / change.length;
                let apart = if apart.is_nan() { f64::INFINITY } else { apart };
                if apart > worst.0 {
                    worst = (apart, seed, kind);
                }
            }
        }
    }
    println!("{compared} compared, worst {worst:?}");
    assert!(worst.0 < 1e-8, "{worst:?}");
}
