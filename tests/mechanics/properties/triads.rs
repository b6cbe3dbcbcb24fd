//! Links on three legs: all their assemblies, and their motion over a turn.

use crate::support::generate;
use crate::support::machines::{self, list, turn};
use crate::support::run::Run;
use assur::internals::group::general::{
    Acceleration, Constraint, General, Load, Point, Pose, Velocity, assemblies,
};
use assur::internals::math::Vec2;
use assur::internals::plan::{MotionStep, TriadLeg};
use assur::internals::solve::{self, Model, State};

fn run(m: &assur::internals::model::Mechanism) -> Run {
    Run::new(m).expect("the structure is sound")
}

/// The link and its legs as one general group: the four bodies, then the ground.
fn general(run: &Run, state: &State) -> (General, Vec<Pose>, Vec<usize>) {
    let triad = run.plan.motion.iter().find_map(|step| match step {
        MotionStep::Triad { triad, .. } => Some(triad),
        _ => None,
    });
    let triad = triad.expect("a triad");
    let mut slots = vec![triad.body];
    let (mut constraints, mut bases) = (Vec::new(), Vec::new());
    for (i, leg) in triad.legs.iter().enumerate() {
        let TriadLeg::Link(leg) = leg else { panic!("a link") };
        slots.push(leg.body);
        bases.push(leg.base.body);
        let pin = leg.pin.unwrap_or(Vec2::zero());
        let foot = Point { body: i + 1, r: pin };
        constraints.push(Constraint::Revolute { a: foot, b: Point { body: i + 4, r: leg.base.at } });
        let head = Point { body: i + 1, r: pin + leg.direction * leg.length };
        let held = Point { body: 0, r: triad.plate.arms[i] + triad.mean };
        constraints.push(Constraint::Revolute { a: head, b: held });
    }
    slots.extend(bases);
    let pose = |slot: &usize| Pose { p: state.motion.bodies[*slot].p, u: state.motion.bodies[*slot].u };
    let poses = slots.iter().map(pose).collect();
    (General::new(4, 7, constraints).expect("three constraints per body"), poses, slots)
}

#[test]
fn a_turn_of_the_triad_agrees_with_the_general_solver() {
    let run = run(&machines::triad(turn(0.0, 36)));
    for i in 0..36 {
        let solved = run.solved(i).expect("closes");
        let state = &solved.state;
        assert!(state.motion.certificates.iter().all(|h| *h < 1e-9), "{:?}", state.motion.certificates);
        let (mut group, poses, slots) = general(&run, state);
        let mut found = poses.clone();
        group.position(&mut found, 1e-12).expect("closes");
        let velocity = |slot: &usize| Velocity {
            v: state.motion.bodies[*slot].v,
            omega: state.motion.bodies[*slot].omega,
        };
        let mut velocities: Vec<Velocity> = slots.iter().map(velocity).collect();
        group.velocity(&poses, &mut velocities);
        let acceleration = |slot: &usize| Acceleration {
            a: state.motion.bodies[*slot].a,
            alpha: state.motion.bodies[*slot].alpha,
        };
        let mut accelerations: Vec<Acceleration> = slots.iter().map(acceleration).collect();
        group.acceleration(&poses, &velocities, &mut accelerations);
        let loads: Vec<Load> = slots[..4]
            .iter()
            .map(|&slot| Load { F: state.forces.applied[slot].force, M: state.forces.applied[slot].moment })
            .collect();
        let mut lambda = vec![0.0; 12];
        group.reactions(&loads, &mut lambda);
        for (k, &slot) in slots[..4].iter().enumerate() {
            let body = &state.motion.bodies[slot];
            assert!((found[k].p - body.p).norm() + (found[k].u - body.u).norm() < 1e-13, "pose {i}");
            let v = velocities[k];
            assert!((v.v - body.v).norm() + (v.omega - body.omega).abs() < 1e-11, "pose {i}");
            let a = accelerations[k];
            assert!((a.a - body.a).norm() + (a.alpha - body.alpha).abs() < 1e-9, "pose {i}");
        }
        for (joint, reaction) in run.plan.reactions.iter().zip(&state.forces.reactions) {
            // the reactions of the group, leg by leg: at the base, at the link
            let Some(leg) = (1..4).find(|k| slots[*k] == joint.body.0 || slots[*k] == joint.base.0) else {
                continue;
            };
            let outer = ![joint.body.0, joint.base.0].contains(&slots[0]);
            let at = 4 * (leg - 1) + if outer { 0 } else { 2 };
            let on_leg = Vec2::new(lambda[at], lambda[at + 1]);
            let sign = if joint.body.0 == slots[leg] { 1.0 } else { -1.0 };
            let off = (reaction.force - on_leg * sign).norm();
            assert!(off < 1e-11 * (1.0 + on_leg.norm()), "pose {i}: {reaction:?} {on_leg:?}");
        }
    }
}

#[test]
fn coarse_and_fine_turns_of_the_triad_agree() {
    let (coarse, fine) = (run(&machines::triad(turn(0.3, 12))), run(&machines::triad(turn(0.3, 360))));
    for i in 0..12 {
        let (a, b) = (coarse.solved(i).expect("closes"), fine.solved(30 * i).expect("closes"));
        for (x, y) in a.state.motion.bodies.iter().zip(&b.state.motion.bodies) {
            assert!((x.p - y.p).norm() + (x.u - y.u).norm() < 1e-13, "pose {i}");
        }
    }
}

#[test]
fn the_list_of_assemblies_holds_all_that_the_search_finds() {
    let (mut listed, mut searched) = (0, 0);
    for seed in 6000..6150 {
        let draft = generate::alone(seed);
        let run = run(&draft.mechanism);
        let Ok(solved) = run.solved(0) else { continue };
        let triads = run.plan.motion.iter().filter(|s| matches!(s, MotionStep::Triad { .. })).count();
        let all_links = run.plan.motion.iter().all(|s| match s {
            MotionStep::Triad { triad, .. } => triad.legs.iter().all(|l| matches!(l, TriadLeg::Link(_))),
            _ => true,
        });
        if triads != 1 || !all_links {
            continue;
        }
        let model = Model { mechanism: &run.mechanism, structure: &run.structure, plan: &run.plan };
        let modes = solve::assemblies(&model).expect("it is solved");
        let group = modes.groups.iter().find(|g| run.structure.motion[g.group].kind_name() == "triad");
        let group = group.expect("it is listed");
        assert_eq!(group.assemblies.iter().filter(|m| m.chosen).count(), 1, "seed {seed}");
        assert!(group.assemblies.len() % 2 == 0, "seed {seed}");
        let (mut general, poses, _) = general(&run, &solved.state);
        let found = assemblies(&mut general, &poses, 150).len();
        assert!(
            found <= group.assemblies.len(),
            "seed {seed}: {found} found, {} listed",
            group.assemblies.len()
        );
        listed += group.assemblies.len();
        searched += found;
    }
    assert!(listed > 40 && searched > listed / 2, "{listed} listed, {searched} found");
}

#[test]
fn one_position_alone_is_listed_too() {
    let run = run(&machines::triad(list(&[1.0])));
    let modes = solve::assemblies(&run.model()).expect("it is solved");
    assert!(modes.problem.is_none() && modes.groups.len() == 1);
    assert!(modes.groups[0].assemblies.iter().all(|m| m.condition > 1e-3 && m.condition <= 1.0));
}
