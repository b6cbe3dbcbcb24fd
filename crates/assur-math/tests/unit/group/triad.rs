//! A link on three legs.

use super::testing::{Body, Random, close, equilibrium, rate, rate_of_direction, second_rate};
use assur_math::group::general::{Constraint, General, Line, Point, Pose, assemblies};
use assur_math::group::triad::*;
use assur_math::math::Vec2;

/// A leg on a body in motion: on its origin, or on a line through it in a direction of its frame.
struct Leg {
    body: Body,
    /// Length of a link, or direction of the line.
    kind: Result<f64, Vec2>,
}

impl Leg {
    fn end(&self, t: f64) -> End {
        let p = self.body.origin(t);
        match self.kind {
            Ok(length) => End::Hinge { p, length },
            Err(d) => End::Guide { p, n: d.turned(self.body.direction(t)).perp() },
        }
    }
}

struct Scene {
    plate: Plate,
    legs: [Leg; 3],
    pose: Pose,
}

impl Scene {
    /// A triad that is far from its dead positions, with so many guides.
    fn random(random: &mut Random, guides: usize) -> Self {
        loop {
            let pins = [random.vector(1.0), random.vector(1.0), random.vector(1.0)];
            let (plate, _) = Plate::new(pins);
            let pose = Pose { p: random.vector(1.0), u: random.direction() };
            let legs = [0, 1, 2].map(|i| {
                let body = Body::random(random);
                let r = pose.p + plate.arms[i].turned(pose.u) - body.origin(0.0);
                let along = (r / r.norm()).turned_back(body.direction(0.0));
                Leg { body, kind: if i + guides < 3 { Ok(r.norm()) } else { Err(along) } }
            });
            let scene = Self { plate, legs, pose };
            let short = scene.legs.iter().any(|l| l.kind.is_ok_and(|length| length < 0.4));
            if plate.length > 0.3 && !short && scene.group().conditioning.abs() > 0.2 {
                return scene;
            }
        }
    }

    fn ends(&self, t: f64) -> [End; 3] {
        [0, 1, 2].map(|i| self.legs[i].end(t))
    }

    fn group(&self) -> Triad<f64> {
        self.plate.group(&self.ends(0.0), &self.pose)
    }

    fn at(&self, t: f64) -> Pose {
        let found = self.plate.follow(&self.ends(0.0), &self.ends(t), &self.pose, 0.0);
        let found = found.expect("a position near one that closes");
        assert!(found.certified);
        found.pose
    }

    /// The same legs as constraints, with those of length as distances.
    fn general(&self) -> (General, Vec<Pose>) {
        let (mut constraints, mut poses) = (Vec::new(), vec![self.pose]);
        for (i, leg) in self.legs.iter().enumerate() {
            let pin = Point { body: 0, r: self.plate.arms[i] };
            poses.push(Pose { p: leg.body.origin(0.0), u: leg.body.direction(0.0) });
            let law = |value| assur_math::group::general::Law { value, ..Default::default() };
            constraints.push(match leg.kind {
                Ok(length) => Constraint::Distance {
                    a: pin,
                    b: Point { body: i + 1, r: Vec2::zero() },
                    law: law(length),
                },
                Err(d) => {
                    let line = Line { body: i + 1, r: Vec2::zero(), d };
                    Constraint::Offset { point: pin, line, law: law(0.0) }
                }
            });
        }
        (General::new(1, 4, constraints).expect("three constraints"), poses)
    }
}

fn residual(ends: &[End; 3], plate: &Plate, pose: &Pose) -> f64 {
    let one = |i: usize| {
        let a = pose.point(plate.arms[i]);
        match ends[i] {
            End::Hinge { p, length } => (a - p).norm() - length,
            End::Guide { p, n } => n.dot(a - p),
        }
    };
    (0..3).map(|i| one(i).abs()).fold(0.0, f64::max)
}

#[test]
fn all_modes_close_and_none_is_missed() {
    let mut random = Random::new(70);
    let mut counts = [0; 7];
    for i in 0..400 {
        let scene = Scene::random(&mut random, i % 3);
        let ends = scene.ends(0.0);
        let found = modes(&scene.plate, &ends);
        assert!(found.len() <= 6 && found.len().is_multiple_of(2), "{} modes", found.len());
        counts[found.len()] += 1;
        for mode in &found {
            assert!(residual(&ends, &scene.plate, &mode.pose) < 1e-13, "{mode:?}");
            assert!((mode.pose.u.norm() - 1.0).abs() < 1e-14);
        }
        let includes = |pose: &Pose| found.iter().any(|m| scene.plate.apart(&m.pose, pose) < 1e-9);
        assert!(includes(&scene.pose), "the assembly it was made of is missing");
        let (mut general, poses) = scene.general();
        for other in assemblies(&mut general, &poses, 60) {
            assert!(includes(&other[0]), "{other:?} is missing");
        }
    }
    assert!(counts[2] > 0 && counts[4] > 0 && counts[6] > 0, "{counts:?}");
}

#[test]
fn modes_come_in_pairs_of_opposite_sign() {
    // the degree of the map from poses to legs is zero
    let mut random = Random::new(71);
    for _ in 0..200 {
        let scene = Scene::random(&mut random, 0);
        let ends = scene.ends(0.0);
        let signs = modes(&scene.plate, &ends).into_iter();
        let sum: f64 = signs.map(|m| scene.plate.group(&ends, &m.pose).conditioning.signum()).sum();
        assert_eq!(sum, 0.0);
    }
}

#[test]
fn what_cannot_close_has_no_modes() {
    let (plate, _) = Plate::new([Vec2::new(0.0, 0.0), Vec2::new(1.0, 0.0), Vec2::new(0.0, 1.0)]);
    let at = |x: f64, y: f64| End::Hinge { p: Vec2::new(x, y), length: 1.0 };
    assert!(modes(&plate, &[at(0.0, 0.0), at(9.0, 0.0), at(0.0, 9.0)]).is_empty());
    assert!(!modes(&plate, &[at(0.0, 1.0), at(1.5, 0.0), at(0.0, 2.0)]).is_empty());
}

#[test]
fn a_mode_that_is_dead_is_found() {
    // all legs meet in the origin: the plate can turn about it a little, and two assemblies are one
    let pins = [Vec2::direction(0.3), Vec2::direction(2.5), Vec2::direction(4.0)];
    let (plate, mean) = Plate::new(pins);
    let reach = [2.0, 2.5, 1.8];
    let ends = [0, 1, 2].map(|i| End::Hinge { p: pins[i] * reach[i], length: reach[i] - 1.0 });
    let found = modes(&plate, &ends);
    let stands = Pose { p: mean, u: Vec2::new(1.0, 0.0) };
    assert!(plate.group(&ends, &stands).conditioning.abs() < 1e-15);
    let near = found.iter().find(|m| plate.apart(&m.pose, &stands) < 1e-6);
    assert!(near.is_some_and(|m| m.h > 0.5), "{found:?}");
}

#[test]
fn velocity_and_acceleration_are_derivatives_of_position() {
    let mut random = Random::new(72);
    let mut compared = 0;
    for i in 0..300 {
        let scene = Scene::random(&mut random, i % 4);
        let group = scene.group();
        let pins = [0, 1, 2].map(|i| scene.pose.p + group.arms[i]);
        let motion = |i: usize| match scene.legs[i].kind {
            Ok(_) => scene.legs[i].body.motion_at(scene.legs[i].body.origin(0.0)),
            Err(_) => scene.legs[i].body.motion_at(pins[i]),
        };
        let base = [motion(0), motion(1), motion(2)];
        let (v, omega) = group.velocity([0, 1, 2].map(|i| group.d[i].dot(base[i].0)));
        let extra = [0, 1, 2].map(|i| {
            let relative = v + group.arms[i].perp() * omega - base[i].0;
            match scene.legs[i].kind {
                Ok(length) => -relative.dot(relative) / length,
                Err(_) => -2.0 * scene.legs[i].body.omega * group.d[i].cross(relative),
            }
        });
        let (a, alpha) = group.acceleration(omega, [0, 1, 2].map(|i| group.d[i].dot(base[i].1) + extra[i]));
        let scale = v.norm() + omega.abs() + 1.0;
        let second = a.norm() + alpha.abs() + scale * scale;
        if scale > 10.0 || second > 200.0 {
            // a dead position is too near in time for differences
            continue;
        }
        compared += 1;
        close((v - rate(|t| scene.at(t).p)).norm(), 0.0, 1e-7, scale);
        close(omega, rate_of_direction(|t| scene.at(t).u), 1e-7, scale);
        let scale = second;
        close((a - second_rate(|t| scene.at(t).p)).norm(), 0.0, 1e-4, scale);
        close(alpha, scene.pose.u.cross(second_rate(|t| scene.at(t).u)), 1e-4, scale);
    }
    assert!(compared > 150, "{compared}");
}

#[test]
fn reactions_balance_plate_and_legs() {
    let mut random = Random::new(73);
    for _ in 0..200 {
        let scene = Scene::random(&mut random, 0);
        let group = scene.group();
        let (F, M) = random.wrench();
        let legs = [random.wrench(), random.wrench(), random.wrench()];
        let length = |i: usize| scene.legs[i].kind.expect("a link");
        let known = [0, 1, 2].map(|i| group.d[i].perp() * (legs[i].1 / length(i)));
        let got = group.reactions(F, M, known);
        // unknowns: force on the plate, force on the leg at its outer revolute, leg by leg; rows: the plate (x, y, about
        // G), the legs (x, y, about O)
        let mut rows = vec![vec![0.0; 12]; 12];
        let mut loads = vec![F.x, F.y, M];
        for i in 0..3 {
            let (arm, r) = (group.arms[i], group.d[i] * length(i));
            rows[0][4 * i] = 1.0;
            rows[1][4 * i + 1] = 1.0;
            (rows[2][4 * i], rows[2][4 * i + 1]) = (-arm.y, arm.x);
            let leg = 3 + 3 * i;
            (rows[leg][4 * i], rows[leg][4 * i + 2]) = (-1.0, 1.0);
            (rows[leg + 1][4 * i + 1], rows[leg + 1][4 * i + 3]) = (-1.0, 1.0);
            (rows[leg + 2][4 * i], rows[leg + 2][4 * i + 1]) = (r.y, -r.x);
            loads.extend([legs[i].0.x, legs[i].0.y, legs[i].1]);
        }
        let rows: Vec<&[f64]> = rows.iter().map(Vec::as_slice).collect();
        let want = equilibrium(&rows, &loads);
        let scale = want.iter().fold(100.0, |most: f64, x| most.max(x.abs()));
        for i in 0..3 {
            close(got[i].x, want[4 * i], 1e-12, scale);
            close(got[i].y, want[4 * i + 1], 1e-12, scale);
        }
    }
}

/// The plate of the tests of ways: unit pins about its frame's origin, one leg's outer revolute moves.
fn line(x: f64) -> (Plate, [End; 3], Pose) {
    let pins = [Vec2::new(-1.0, 0.0), Vec2::new(1.0, 0.0), Vec2::new(0.0, 1.0)];
    let (plate, mean) = Plate::new(pins);
    let hinge = |p: Vec2, length: f64| End::Hinge { p, length };
    let ends = [
        hinge(pins[0] + Vec2::new(0.0, -1.0), 1.0),
        hinge(pins[1] + Vec2::new(0.3, -1.0), libm::hypot(0.3, 1.0)),
        hinge(pins[2] + Vec2::new(x, 0.0), 1.5),
    ];
    (plate, ends, Pose { p: mean, u: Vec2::new(1.0, 0.0) })
}

#[test]
fn long_ways_lead_where_short_ones_lead() {
    let (plate, from, start) = line(1.5);
    let mut pose = start;
    let mut last = from;
    for k in 1..=400 {
        let (_, next, _) = line(1.5 - f64::from(k) * 0.001);
        let found = plate.follow(&last, &next, &pose, 0.0).expect("it closes");
        assert!(found.certified && found.h < 1e-6);
        (pose, last) = (found.pose, next);
    }
    let direct = plate.follow(&from, &last, &start, 0.0).expect("it closes");
    assert!(direct.certified && plate.apart(&direct.pose, &pose) < 1e-13);
}

#[test]
fn a_motion_that_turns_back_is_open() {
    let (plate, from, start) = line(1.5);
    let (mut last, mut pose, mut x) = (from, start, 1.5);
    let open = loop {
        x += 0.01;
        let (_, next, _) = line(x);
        assert!(x < 9.0, "it must end");
        match plate.follow(&last, &next, &pose, 0.0) {
            Some(found) => (pose, last) = (found.pose, next),
            None => break next,
        }
    };
    // the last one was near to dead, and no assembly is near beyond
    assert!(plate.group(&last, &pose).conditioning.abs() < 0.3);
    let beyond = modes(&plate, &open);
    assert!(beyond.iter().all(|m| plate.apart(&m.pose, &pose) > 0.3), "{beyond:?}");
}

#[test]
fn the_figure_does_not_hang_on_axes_and_lengths() {
    let mut random = Random::new(74);
    for _ in 0..50 {
        let scene = Scene::random(&mut random, 0);
        let group = scene.group();
        let turned = random.direction();
        let d = group.d.map(|d| d.turned(turned));
        let other = Triad::new(d, group.arms.map(|a| a.turned(turned) * 1e-6), scene.plate.length * 1e-6);
        close(other.conditioning, group.conditioning, 1e-14, 1.0);
        assert!(group.conditioning.abs() <= 1.0 + 1e-15);
    }
}
