//! Sweeps: change points, whole turns, continuous angles, partial sweeps, dead positions, against closed formulas.

use crate::support::machines::{self, at, crank_slider, four_bar, list, turn};
use crate::support::random::Random;
use crate::support::run::{Run, scalar, vector};
use assur::internals::math::Vec2;
use assur::internals::message;
use assur::internals::model::{
    Display, Expr, Find, FindKind, HintKind, LinkId, Load, LoadKind, Mechanism, PairId, Place, PointRef,
    Positions, Query,
};
use assur::internals::solve::{Cause, Note};
use assur::internals::source::Span;
use std::f64::consts::{PI, TAU};

const CRANK: LinkId = LinkId::at(1);
const ROCKER: LinkId = LinkId::at(3);

fn run(m: &Mechanism) -> Run {
    Run::new(m).expect("the structure is sound")
}

fn angle(run: &Run, pose: usize, link: LinkId) -> f64 {
    scalar(&run.view(pose).expect("the position closes"), &Query::Angle(link))
}

fn range(from: f64, to: f64, steps: usize) -> Positions {
    Positions::Range { from: Expr::number(from), to: Expr::number(to), steps }
}

/// Without reactions and rates: at change points they do not exist.
fn positions_only(mut m: Mechanism) -> Mechanism {
    m.finds.clear();
    m
}

#[test]
fn a_parallelogram_stays_one_through_both_change_points() {
    for (lengths, to, steps) in [
        ([0.3, 0.5, 0.3, 0.5], 2.0 * TAU, 24),
        ([0.3, 0.5, 0.3, 0.5], 2.0 * TAU, 720),
        ([0.2, 0.7, 0.2, 0.7], -2.0 * TAU, 100),
        ([0.13, 0.37, 0.13, 0.37], TAU + 0.1, 37),
        // poses in the change points themselves
        ([0.3, 0.5, 0.3, 0.5], 2.0 * TAU, 48),
    ] {
        let start = if steps == 48 { PI / 6.0 } else { 1.0 };
        let m = positions_only(four_bar(lengths, true, range(start, start + to, steps)));
        let run = run(&m);
        let poses = run.solution.as_ref().expect("it closes").poses.len();
        for pose in 0..poses {
            let (a, b) = (angle(&run, pose, CRANK), angle(&run, pose, ROCKER));
            assert!((a - b).abs() < 1e-7, "{lengths:?} pose {pose}: crank {a} rocker {b}");
        }
    }
}

#[test]
fn an_antiparallelogram_stays_one() {
    let [r, l] = [0.3, 0.5];
    let start = 1.0;
    let m = positions_only(four_bar([r, l, r, l], false, range(start, start + TAU, 90)));
    let run = run(&m);
    let k = (l + r) / (l - r);
    for pose in 0..90 {
        let (a, b) = (angle(&run, pose, CRANK), angle(&run, pose, ROCKER));
        // tan(ψ/2) = −k tan(φ/2)
        let (sin, cos) = libm::sincos(a / 2.0);
        let want = 2.0 * libm::atan2(-k * sin, cos);
        let apart = (b - want + PI).rem_euclid(TAU) - PI;
        assert!(apart.abs() < 1e-7, "pose {pose}: crank {a} rocker {b} is not {want}");
    }
}

#[test]
fn equal_crank_and_rod_go_through_90_degrees() {
    for (from, to, steps) in [
        (0.2, PI, 36),
        (0.2, PI, 7),
        (0.2, TAU + 0.2, 360),
        (0.2, -TAU, 360),
        (0.0, PI, 36),
        (PI / 6.0, TAU, 24),
    ] {
        let m = positions_only(crank_slider(0.25, 0.25, 0.0, range(from, from + to, steps)));
        let run = run(&m);
        let poses = run.solution.as_ref().expect("it closes").poses.len();
        for pose in 0..poses {
            let view = run.view(pose).expect("the position closes");
            let x = vector(&view, &Query::Position(PointRef::Fixed(ROCKER, Vec2::zero()))).x;
            // the motion goes on: x = 2 r cos φ, negative beyond 90°
            let want = 0.5 * libm::cos(angle(&run, pose, CRANK));
            assert!((x - want).abs() < 1e-7, "steps {steps} pose {pose}: {x} is not {want}");
        }
    }
}

/// Lengths of a crank-rocker with margin.
fn grashof(random: &mut Random) -> [f64; 4] {
    loop {
        let lengths = [0.1, random.within(0.2, 0.6), random.within(0.2, 0.6), random.within(0.2, 0.6)];
        let [s, a, b, c] = lengths;
        let longest = a.max(b).max(c);
        if s + longest < (a + b + c - longest) - 0.02 {
            return lengths;
        }
    }
}

#[test]
fn coarse_and_fine_turns_agree() {
    let mut random = Random::new(5);
    for _ in 0..25 {
        let (lengths, left, from) = (grashof(&mut random), random.chance(0.5), random.within(-3.0, 3.0));
        let coarse = run(&four_bar(lengths, left, turn(from, 12)));
        let fine = run(&four_bar(lengths, left, turn(from, 360)));
        let count = |run: &Run| run.solution.as_ref().map_or(0, |s| s.poses.len());
        assert_eq!((count(&coarse), count(&fine)), (12, 360));
        for i in 0..12 {
            let (a, b) = (coarse.solved(i).expect("closes"), fine.solved(30 * i).expect("closes"));
            for (x, y) in a.state.motion.bodies.iter().zip(&b.state.motion.bodies) {
                assert!((x.p - y.p).norm() + (x.u - y.u).norm() < 1e-12, "{lengths:?} pose {i}");
                assert!((x.alpha - y.alpha).abs() < 1e-6);
            }
            for (x, y) in a.angles.iter().zip(&b.angles) {
                assert!((x - y).abs() < 1e-12, "{lengths:?} pose {i}: {x} {y}");
            }
            assert!(
                (a.state.forces.efforts[0] - b.state.forces.efforts[0]).abs()
                    < 1e-8 * a.state.forces.efforts[0].abs().max(1.0)
            );
        }
    }
}

#[test]
fn angles_are_continuous_over_turns() {
    let mut random = Random::new(6);
    for _ in 0..10 {
        let (lengths, from) = (grashof(&mut random), random.within(-10.0, 10.0));
        let to = from + random.sign() * 3.0 * TAU;
        let run = run(&four_bar(lengths, true, range(from, to, 300)));
        for pose in 1..300 {
            let (a, b) = (run.solved(pose - 1).expect("closes"), run.solved(pose).expect("closes"));
            for (link, (x, y)) in a.angles.iter().zip(&b.angles).enumerate() {
                assert!((x - y).abs() < 0.5, "link {link} jumps from {x} to {y}");
            }
            for (body, x) in b.state.motion.bodies.iter().zip(&b.angles) {
                assert!((body.u - Vec2::direction(*x)).norm() < 1e-12);
            }
        }
        let last = run.solved(299).expect("closes");
        assert!((last.angles[1] - (from + (to - from) * 299.0 / 300.0)).abs() < 1e-12);
        let turns = (last.angles[1] - from) / TAU;
        assert!(turns.abs() > 2.9);
    }
}

#[test]
fn a_partial_sweep_tells_its_range() {
    // a double rocker: the crank turns between the angles where coupler and rocker are in line
    let [r, l, q, frame] = [0.4, 0.2, 0.35, 0.3];
    let limit = libm::acos((r * r + frame * frame - (l + q) * (l + q)) / (2.0 * r * frame)).to_degrees();
    let steps = 180;
    let run = run(&four_bar([r, l, q, frame], true, range(0.5, 0.5 + PI, steps)));
    let solution = run.solution.as_ref().expect("it closes at first");
    let mut closed = 0;
    for (i, pose) in solution.poses.iter().enumerate() {
        let degrees = (0.5 + PI * i as f64 / steps as f64).to_degrees();
        let reached = degrees < limit;
        assert_eq!(
            pose.outcome.is_ok(),
            reached,
            "{degrees} deg, limit {limit}: {:?}",
            pose.outcome.as_ref().err()
        );
        closed += usize::from(reached);
    }
    let partial: Vec<Note> =
        solution.notes.iter().filter(|n| matches!(n, Note::PartialSweep { .. })).cloned().collect();
    let warned: Vec<String> = message::notes(&run.model(), &partial).map(|w| w.to_string()).collect();
    let (count, limit) = (format!("{closed} of {} positions", steps + 1), format!("{limit:.2}"));
    assert!(warned.len() == 1 && warned[0].contains(&count) && warned[0].contains(&limit), "{warned:?}");
}

fn ask(m: &mut Mechanism, queries: &[Query]) {
    for query in queries {
        let display = Display { unit: String::new(), factor: 1.0, dimension: [0; 4] };
        let kind = FindKind::Value { expr: Expr::Query(*query), display, poseless: true };
        m.finds.push(Find { name: format!("{query:?}"), span: Span::default(), kind });
    }
}

#[test]
fn dead_positions_of_crank_sliders_against_formulas() {
    let mut random = Random::new(7);
    for _ in 0..40 {
        let (r, l) = (random.within(0.05, 0.3), random.within(0.5, 1.5));
        let e = random.within(-0.15, 0.15);
        let mut m = crank_slider(r, l, e, list(&[0.3]));
        let d = PairId::at(3);
        let queries =
            [Query::Dead(d, 1), Query::Dead(d, 2), Query::Stroke(d), Query::TimeRatio(d), Query::Travel(d)];
        ask(&mut m, &queries);
        let run = run(&m);
        let view = run.view(0).expect("it closes");
        let (near, far) = (((l - r).powi(2) - e * e).sqrt(), ((l + r).powi(2) - e * e).sqrt());
        // the crank points away from the slider where the coordinate is least, towards it where it is greatest
        let least = (libm::atan2(e, near) + PI).rem_euclid(TAU);
        let greatest = libm::atan2(e, far).rem_euclid(TAU);
        let way = (least - greatest).rem_euclid(TAU);
        let ratio = way.max(TAU - way) / way.min(TAU - way);
        let x = r * libm::cos(0.3) + (l * l - (e - r * libm::sin(0.3)).powi(2)).sqrt();
        for (query, want) in queries.iter().zip([least, greatest, far - near, ratio, x - near]) {
            let got = scalar(&view, query);
            let apart = if matches!(query, Query::Dead(..)) {
                (got - want + PI).rem_euclid(TAU) - PI
            } else {
                got - want
            };
            assert!(apart.abs() < 1e-11, "{query:?} of r {r} l {l} e {e}: {got} is not {want}");
        }
    }
}

#[test]
fn a_full_turn_of_a_crank_slider_against_formulas() {
    let (r, l, e) = (0.1, 0.35, 0.02);
    let run = run(&crank_slider(r, l, e, turn(0.0, 36)));
    for pose in 0..36 {
        let view = run.view(pose).expect("closes");
        let (s, c) = libm::sincos(TAU * pose as f64 / 36.0);
        let (h, w) = (r * s - e, machines::SPEED);
        let root = (l * l - h * h).sqrt();
        let piston = PointRef::Fixed(ROCKER, Vec2::zero());
        let (x, v) = (r * c + root, -r * w * s - h * r * c * w / root);
        let a = -r * w * w * c
            - w * w * ((r * r * c * c - h * r * s) / root + h * h * r * r * c * c / root.powi(3));
        let near = |query: Query, want: Vec2, scale: f64| {
            let got = vector(&view, &query);
            assert!((got - want).norm() < 1e-13 * scale, "{query:?} at pose {pose}: {got:?} is not {want:?}");
        };
        near(Query::Position(piston), at(x, e), 1.0);
        near(Query::Velocity(piston), at(v, 0.0), 10.0);
        near(Query::Acceleration(piston), at(a, 0.0), 300.0);
    }
}

#[test]
fn a_load_against_motion_is_nothing_where_nothing_moves() {
    let plain = run(&crank_slider(0.1, 0.35, 0.0, list(&[0.0, PI, 3.0])));
    let mut m = crank_slider(0.1, 0.35, 0.0, list(&[0.0, PI, 3.0]));
    let kind = LoadKind::ForceAgainstMotion {
        on: ROCKER,
        at: Place::Local(Vec2::zero()),
        value: Expr::number(1000.0),
    };
    m.loads.push(Load { name: None, span: Span::default(), kind, pin: None, spread: None, when: None });
    let loaded = run(&m);
    let reaction = |run: &Run, pose: usize| {
        vector(&run.view(pose).expect("closes"), &Query::Reaction(PairId::at(1), LinkId::at(2)))
    };
    for (pose, still) in [(0, true), (1, true), (2, false)] {
        let apart = (reaction(&plain, pose) - reaction(&loaded, pose)).norm();
        assert_eq!(apart < 1e-9, still, "pose {pose}: {apart} N");
    }
}

#[test]
fn hints_choose_between_the_two_assemblies() {
    for left in [true, false] {
        let run = run(&four_bar([0.1, 0.35, 0.3, 0.4], left, list(&[1.0])));
        let view = run.view(0).expect("closes");
        let c = vector(&view, &Query::Position(PointRef::Fixed(LinkId::at(2), at(0.35, 0.0))));
        let b = Vec2::direction(1.0) * 0.1;
        assert_eq!((at(0.4, 0.0) - b).cross(c - b) > 0.0, left);
    }
    let mut m = four_bar([0.1, 0.35, 0.3, 0.4], true, list(&[1.0]));
    m.hints.clear();
    let causes = run(&m).solution.expect_err("nothing chooses").into_iter().map(|f| f.cause);
    assert!(matches!(causes.collect::<Vec<_>>()[..], [Cause::Ambiguous { count: 2, .. }]));
    machines::hint(&mut m, HintKind::Near { point: (ROCKER, at(0.3, 0.0)), place: at(0.3, -0.3) });
    assert!(run(&m).solved(0).is_ok());
}

#[test]
fn a_long_chain_is_assembled_by_the_places_of_its_points() {
    // a chain of parallelograms: every dyad has a second assembly
    let (n, r, l) = (20, 0.1, 0.3);
    let mut m = machines::ground();
    let crank = machines::bar(&mut m, "crank", r);
    machines::revolute(&mut m, "A", (LinkId::GROUND, at(0.0, 0.0)), (crank, at(0.0, 0.0)));
    let (phi, mut last) = (1.0, crank);
    for i in 1..=n {
        let coupler = machines::bar(&mut m, &format!("coupler{i}"), l);
        let rocker = machines::bar(&mut m, &format!("rocker{i}"), r);
        machines::revolute(&mut m, &format!("B{i}"), (last, at(r, 0.0)), (coupler, at(0.0, 0.0)));
        machines::revolute(&mut m, &format!("C{i}"), (coupler, at(l, 0.0)), (rocker, at(r, 0.0)));
        let foot = at(l * f64::from(i), 0.0);
        machines::revolute(&mut m, &format!("D{i}"), (LinkId::GROUND, foot), (rocker, at(0.0, 0.0)));
        // where the pin is, but for an error of the eye
        let place = foot + Vec2::direction(phi + 0.1) * r;
        machines::hint(&mut m, HintKind::Near { point: (rocker, at(r, 0.0)), place });
        last = rocker;
    }
    machines::drive(&mut m, crank, list(&[phi]));
    let run = run(&m);
    let view = run.view(0).expect("it closes");
    let end = scalar(&view, &Query::Angle(last));
    assert!((end - phi).abs() < 1e-12, "{end}");
}
