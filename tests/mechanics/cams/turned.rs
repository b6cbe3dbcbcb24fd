//! Cams that their followers turn: the same cam is driven by itself first, then by its follower at the values found, with
//! the effort found as a load. Rates and reactions must be the same and the follower needs no effort; the reference of 30
//! digits agrees.

use super::mechanism::{Build, build};
use super::random::{Random, random_cam};
use assur::internals::check::Overrides;
use assur::internals::element::cam::{Cam, Follower, Program, Reached};
use assur::internals::math::Vec2;
use assur::internals::solve::{BodyState, Reference, Residuals};
use assur::internals::source::Source;
use assur::internals::structure::{EffortKind, JointKind};
use std::f64::consts::TAU;

const FRAME_ANGLE: f64 = 0.4;

struct Found {
    disk: BodyState,
    lever: BodyState,
    /// Effort on a body, or along a guide, by the name of what is driven.
    efforts: Vec<(String, f64)>,
    /// Coordinates of the driven slider: value, rate, second rate.
    slide: [f64; 3],
    /// Reactions by pair, kind of joint and bodies, the first one that with the lesser number.
    reactions: Vec<(String, Vec2)>,
    residuals: Residuals,
    condition: f64,
    exact: Reference,
    of_reference: Vec<(f64, f64)>,
}

fn solve(text: &str) -> Option<Found> {
    let text =
        format!("{text}find reactions, displacement(O), relative_velocity(O), relative_acceleration(O)\n");
    let (solved, problems) =
        assur::internals::solve_source(&Source::new("cam.mech", &text), &Overrides::none());
    let solved = solved.unwrap_or_else(|| panic!("{text}\n{problems:?}"));
    let model = solved.compiled.model();
    let at = solved.solution.poses[0].outcome.as_ref().unwrap_or_else(|e| panic!("{text}\n{e:?}"));
    if at.state.forces.locked {
        return None;
    }
    let exact = solved.solution.reference(&model, at).unwrap_or_else(|| panic!("{text}\nno reference"));
    let link = |name: &str| model.mechanism.links.iter().position(|l| l.name == name).unwrap();
    let bodies = &at.state.motion.bodies;
    let replaced = &model.structure.replaced;
    let mut efforts = Vec::new();
    let mut of_reference = Vec::new();
    for (slot, effort) in model.structure.efforts.iter().enumerate() {
        let on = match effort.kind {
            EffortKind::Angle(body) => model.mechanism.links[body.0].name.clone(),
            EffortKind::Coordinate(joint) => model.mechanism.pair(replaced.joint(joint).pair).name.clone(),
            _ => panic!("another effort"),
        };
        efforts.push((on, at.state.forces.efforts[slot]));
        of_reference.push((at.state.forces.efforts[slot], exact.efforts[slot].high));
    }
    let mut reactions = Vec::new();
    for (slot, joint) in model.plan.reactions.iter().enumerate() {
        let reaction = at.state.forces.reactions[slot];
        let kept = replaced.joint(joint.joint);
        let sign = if joint.body.0 < joint.base.0 { 1.0 } else { -1.0 };
        let kind = if matches!(kept.kind, JointKind::Prismatic { .. }) { "guide" } else { "hinge" };
        let name = format!("{} {kind}", model.mechanism.pair(kept.pair).name);
        reactions.push((name, reaction.force * sign));
        for (x, y) in [
            (reaction.force.x, exact.reactions[slot].force.x.high),
            (reaction.force.y, exact.reactions[slot].force.y.high),
        ] {
            of_reference.push((x, y));
        }
    }
    reactions.sort_by(|a, b| a.0.cmp(&b.0));
    crate::jerks::hold(&model, &at.state, || text.to_owned());
    let slide = model.structure.replaced.joints.iter().find_map(|j| match &j.kind {
        JointKind::Prismatic { slider, point, guide, through, along, .. }
            if model.mechanism.pair(j.pair).name == "Q" =>
        {
            let (s, g) = (&bodies[slider.0], &bodies[guide.0]);
            let d = along.turned(g.u);
            let p = s.position(*point);
            let r = p - g.p;
            let v = s.velocity(*point) - g.v - r.perp() * g.omega;
            let base = g.a + r.perp() * g.alpha - r * (g.omega * g.omega) + v.perp() * (2.0 * g.omega);
            Some([(p - g.position(*through)).dot(d), v.dot(d), (s.acceleration(*point) - base).dot(d)])
        }
        _ => None,
    });
    Some(Found {
        disk: bodies[link("disk")],
        lever: bodies[link("lever")],
        efforts,
        slide: slide.unwrap_or_default(),
        reactions,
        residuals: at.residuals,
        condition: at.condition,
        exact,
        of_reference,
    })
}

/// The cam driven by itself at a cam angle, and the same driven by its follower.
fn both(build: &Build, cam: &Cam, phi: f64, alpha: f64) -> Option<(Found, Found, String)> {
    let sense = if cam.ccw { 1.0 } else { -1.0 };
    let start = build.towards + if build.moving { FRAME_ANGLE } else { 0.0 } + sense * phi;
    let mut text = build.text.clone();
    if build.moving {
        text += &format!("drive base = {FRAME_ANGLE:?} rad at {:?} rad/s\n", build.frame_omega);
    }
    let forward = format!(
        "{text}drive disk = {start:?} rad at {:?} rad/s accelerating {alpha:?} rad/s^2\n",
        build.omega
    );
    let forward = solve(&forward)?;
    let torque = forward.efforts.iter().find(|e| e.0 == "disk").unwrap().1;
    let near = forward.disk.position(Vec2::new(0.1, 0.07));
    text = text.replace("link disk { ", "link disk { Z (0.1 m, 0.07 m); ");
    text +=
        &format!("torque on disk = {torque:?} N*m\nassemble disk.Z near ({:?} m, {:?} m)\n", near.x, near.y);
    text += &match cam.follower {
        Follower::Translating { .. } => {
            let [s, v, a] = forward.slide;
            format!("drive Q = {s:?} m at {v:?} m/s accelerating {a:?} m/s^2\n")
        }
        Follower::Oscillating { .. } => {
            let lever = &forward.lever;
            let angle = lever.u.y.atan2(lever.u.x);
            format!(
                "drive lever = {angle:?} rad at {:?} rad/s accelerating {:?} rad/s^2\n",
                lever.omega, lever.alpha
            )
        }
    };
    let backward = solve(&text)?;
    Some((forward, backward, text))
}

#[test]
fn followers_turn_their_cams_as_the_cams_move_them() {
    let mut random = Random(21);
    let mut compared = 0;
    for case in 0..150 {
        let cam = random_cam(&mut random, case % 5);
        let rough = case % 3 == 0;
        let build = build(&mut random, &cam, if rough { 0.05 } else { 0.0 });
        let phi = super::smooth_angle(&mut random, &cam, 0.05);
        let alpha = random.between(-4.0, 4.0);
        let slope = cam.program.at(phi)[1].abs();
        // in a dwell nothing is determined, next to it little
        if slope < 0.05 * cam.program.greatest_lift() {
            continue;
        }
        let Some((forward, backward, text)) = both(&build, &cam, phi, alpha) else { continue };
        // where the normal passes the centre within the angle of friction a torque on the cam has several balances
        if rough && backward.condition < 0.1 {
            continue;
        }
        compared += 1;
        let told = || format!("case {case}, φ = {phi}\n{text}\n{cam:?}");
        let loss = 1e-12 / backward.condition.powi(3);
        let close = |a: f64, b: f64, size: f64| (a - b).abs() <= loss * size.max(b.abs()).max(1.0);
        let (one, two) = (&backward.disk, &forward.disk);
        assert!((one.u - two.u).norm() < loss && (one.p - two.p).norm() < loss, "{}", told());
        assert!(close(one.omega, two.omega, 1.0), "{} {}\n{}", one.omega, two.omega, told());
        assert!(close(one.alpha, two.alpha, 100.0), "{} {}\n{}", one.alpha, two.alpha, told());
        let most = forward.reactions.iter().map(|r| r.1.norm()).fold(0.0, f64::max);
        assert_eq!(forward.reactions.len(), backward.reactions.len(), "{}", told());
        for (a, b) in backward.reactions.iter().zip(&forward.reactions) {
            assert_eq!(a.0, b.0, "{}", told());
            // what passes through the block has either sense, by which body the group counts it on
            let apart = (a.1 - b.1).norm().min((a.1 + b.1).norm());
            assert!(apart < 100.0 * loss * most, "{a:?} {b:?}\n{}", told());
        }
        let left = backward.efforts.iter().find(|e| ["Q", "lever"].contains(&e.0.as_str())).unwrap();
        assert!(left.1.abs() < 100.0 * loss * most, "{left:?}\n{}", told());
        let residuals = backward.residuals;
        assert!(residuals.closure < 1e-13, "{residuals:?}\n{}", told());
        assert!(residuals.equilibrium.is_some_and(|r| r < 1e-13), "{residuals:?}\n{}", told());
        assert!(residuals.power.is_some_and(|r| r < 1e-12), "{residuals:?}\n{}", told());
        assert!(backward.exact.closure < 1e-28 && backward.exact.equilibrium < 1e-27, "{}", told());
        for (x, y) in &backward.of_reference {
            assert!((x - y).abs() < loss * most, "{x} {y}\n{}", told());
        }
    }
    assert!(compared > 80, "{compared}");
}

/// Every cam angle that reaches a lift is on a flank that finds it again.
fn finds_all(program: &Program, phi: f64, case: usize) {
    let [lift, slope, ..] = program.at(phi);
    let greatest = program.greatest_lift();
    if slope.abs() < 1e-4 * greatest {
        return;
    }
    let found = program.flanks().into_iter().filter_map(|flank| {
        match flank.reached(program, lift, 1e-15 * greatest) {
            Reached::At(angle) => {
                assert!((program.at(angle)[0] - lift).abs() < 1e-13 * greatest, "case {case}");
                assert_eq!(flank.rises(), flank.lifts[1] > flank.lifts[0], "case {case}");
                Some(angle)
            }
            Reached::Dwell | Reached::Beyond => None,
        }
    });
    let found: Vec<f64> = found.collect();
    let nearest = found.iter().map(|a| ((a - phi) / TAU - ((a - phi) / TAU).round()).abs() * TAU);
    let nearest = nearest.fold(f64::INFINITY, f64::min);
    assert!(nearest < 1e-14 * greatest / slope.abs() + 1e-14, "case {case}: {phi} not among {found:?}");
}

#[test]
fn flanks_reach_every_lift() {
    let mut random = Random(22);
    for case in 0..300 {
        let cam = random_cam(&mut random, case % 5);
        let flanks = cam.program.flanks();
        assert!(flanks.len() >= 2, "case {case}");
        for two in flanks.windows(2) {
            assert!(two[0].rises() != two[1].rises(), "case {case}: neighbours turn");
        }
        for _ in 0..20 {
            finds_all(&cam.program, random.between(0.0, TAU), case);
        }
        let beyond = 1.01 * cam.program.greatest_lift();
        assert!(
            flanks.iter().all(|f| f.reached(&cam.program, beyond, 0.0) == Reached::Beyond),
            "case {case}"
        );
    }
}
