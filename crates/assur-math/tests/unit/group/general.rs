//! Newton's method on any group.

use super::testing::{Body, Random, close, rate, rate_of_direction, second_rate};
use assur_math::group::general::*;
use assur_math::group::{rpr, rrp, rrr};
use assur_math::math::Vec2;

fn point(body: usize, x: f64, y: f64) -> Point {
    Point { body, r: Vec2::new(x, y) }
}

fn pose_of(body: &Body, t: f64) -> Pose {
    Pose { p: body.origin(t), u: body.direction(t) }
}

fn velocity_of(body: &Body) -> Velocity {
    Velocity { v: body.motion_at(body.origin(0.0)).0, omega: body.omega }
}

fn acceleration_of(body: &Body) -> Acceleration {
    // The origin's own acceleration: no arm, no centripetal part.
    Acceleration { a: body.motion_at(body.origin(0.0)).1, alpha: body.alpha }
}

/// A group with its known bodies in motion, at a position found.
struct Scene {
    group: General,
    known: Vec<Body>,
    poses: Vec<Pose>,
    /// Sets the drives of the group to a time.
    drives: fn(&mut General, f64),
}

impl Scene {
    /// The poses at another time, from those at time 0.
    fn at(&self, t: f64) -> Vec<Pose> {
        let mut group = self.group.clone();
        (self.drives)(&mut group, t);
        let mut poses = self.poses.clone();
        for (pose, body) in poses[group.moving..].iter_mut().zip(&self.known) {
            *pose = pose_of(body, t);
        }
        group.position(&mut poses, 1e-12).expect("a position near one that closes");
        poses
    }

    fn motion(&mut self) -> (Vec<Velocity>, Vec<Acceleration>) {
        self.group.factor(&self.poses).expect("a regular position");
        let mut velocities = vec![Velocity::default(); self.group.moving];
        velocities.extend(self.known.iter().map(velocity_of));
        self.group.velocity(&self.poses, &mut velocities);
        let mut accelerations = vec![Acceleration::default(); self.group.moving];
        accelerations.extend(self.known.iter().map(acceleration_of));
        self.group.acceleration(&self.poses, &velocities, &mut accelerations);
        (velocities, accelerations)
    }

    fn check_derivatives(&mut self) {
        let (velocities, accelerations) = self.motion();
        for i in 0..self.group.moving {
            let (v, a) = (velocities[i], accelerations[i]);
            let scale = v.v.norm() + v.omega.abs() + 1.0;
            close((v.v - rate(|t| self.at(t)[i].p)).norm(), 0.0, 1e-6, scale);
            close(v.omega, rate_of_direction(|t| self.at(t)[i].u), 1e-6, scale);
            let scale = a.a.norm() + a.alpha.abs() + scale * scale;
            close((a.a - second_rate(|t| self.at(t)[i].p)).norm(), 0.0, 1e-3, scale);
            let alpha = self.poses[i].u.cross(second_rate(|t| self.at(t)[i].u));
            close(a.alpha, alpha, 1e-3, scale);
        }
    }

    /// Every body of the group is in balance, and known bodies get the loads back in sum.
    fn check_reactions(&mut self, random: &mut Random) {
        self.group.factor(&self.poses).expect("a regular position");
        let moving = self.group.moving;
        let loads: Vec<Load> = (0..moving).map(|_| random.wrench()).map(|(F, M)| Load { F, M }).collect();
        let mut lambda = vec![0.0; 3 * moving];
        self.group.reactions(&loads, &mut lambda);
        let scale = lambda.iter().fold(100.0, |most: f64, x| most.max(x.abs()));
        let mut total = (Vec2::zero(), 0.0);
        for i in 0..self.poses.len() {
            let got = self.group.exerted_on(&self.poses, i, &lambda);
            if let Some(load) = loads.get(i) {
                close((got.F + load.F).norm(), 0.0, 1e-11, scale);
                close(got.M + load.M, 0.0, 1e-11, scale);
                total.0 += load.F;
                total.1 += load.M + self.poses[i].p.cross(load.F);
            } else {
                total.0 -= got.F;
                total.1 -= got.M + self.poses[i].p.cross(got.F);
            }
        }
        close(total.0.norm() + total.1.abs(), 0.0, 1e-11, 100.0 * scale);
    }
}

/// A dyad of revolutes: bodies 0 and 1 on the origins of bodies 2 and 3.
fn dyad(l_1: f64, l_2: f64) -> General {
    let joints = vec![
        Constraint::Revolute { a: point(0, 0.0, 0.0), b: point(2, 0.0, 0.0) },
        Constraint::Revolute { a: point(0, l_1, 0.0), b: point(1, l_2, 0.0) },
        Constraint::Revolute { a: point(1, 0.0, 0.0), b: point(3, 0.0, 0.0) },
    ];
    General::new(2, 4, joints).expect("three constraints per body")
}

fn near(random: &mut Random, p: Vec2, r: Vec2) -> Pose {
    let u = r.unit().expect("a link");
    Pose { p: p + random.vector(0.1), u: u.turned(Vec2::direction(random.within(-0.2, 0.2))) }
}

#[test]
fn finds_what_the_dyad_of_revolutes_finds() {
    let mut random = Random::new(30);
    for _ in 0..100 {
        let known = vec![Body::random(&mut random), Body::random(&mut random)];
        let (p_A, p_B) = (known[0].origin(0.0), known[1].origin(0.0));
        let span = (p_B - p_A).norm();
        let (l_1, l_2) = (span * random.within(0.6, 0.9), span * random.within(0.6, 0.9));
        let p = rrr::position(p_A, p_B, l_1, l_2, random.sign());
        let mut group = dyad(l_1, l_2);
        let mut poses = vec![near(&mut random, p_A, p.r_1), near(&mut random, p_B, p.r_2)];
        poses.extend(known.iter().map(|body| pose_of(body, 0.0)));
        let sigma = group.position(&mut poses, 1e-12).expect("closes");
        assert!(sigma > 1e-3 && sigma <= 1.0);
        close((poses[0].u - p.r_1 / l_1).norm() + (poses[1].u - p.r_2 / l_2).norm(), 0.0, 1e-13, 1.0);

        let mut scene = Scene { group, known, poses, drives: |_, _| () };
        let (velocities, accelerations) = scene.motion();
        let closed = rrr::Rrr::new(p.r_1, p.r_2);
        let ((v_A, a_A), (v_B, a_B)) = (scene.known[0].motion_at(p_A), scene.known[1].motion_at(p_B));
        let (omega_1, omega_2) = closed.velocity(v_A, v_B);
        let (alpha_1, alpha_2) = closed.acceleration(omega_1, omega_2, a_A, a_B);
        let size = omega_1.abs() + omega_2.abs() + 1.0;
        close(velocities[0].omega, omega_1, 1e-12, size);
        close(velocities[1].omega, omega_2, 1e-12, size);
        close(accelerations[0].alpha, alpha_1, 1e-12, size * size + alpha_1.abs() + alpha_2.abs());
        close(accelerations[1].alpha, alpha_2, 1e-12, size * size + alpha_1.abs() + alpha_2.abs());

        let ((F_1, M_1), (F_2, M_2)) = (random.wrench(), random.wrench());
        let mut lambda = [0.0; 6];
        scene.group.reactions(&[Load { F: F_1, M: M_1 }, Load { F: F_2, M: M_2 }], &mut lambda);
        let want = closed.reactions(F_1, M_1, F_2, M_2);
        let all = [want.f_A, -want.f_C, want.f_B];
        for (got, want) in lambda.chunks_exact(2).zip(all) {
            close((Vec2::new(got[0], got[1]) - want).norm(), 0.0, 1e-11, want.norm() + 100.0);
        }
    }
}

#[test]
fn finds_what_the_dyads_with_a_slider_find() {
    let mut random = Random::new(31);
    for _ in 0..100 {
        let guide = Body::random(&mut random);
        let (p_A, l, h) = (random.vector(1.0), random.within(1.0, 2.0), random.within(-0.4, 0.4));
        let Pose { p: p_Q, u: d } = pose_of(&guide, 0.0);
        let h = h + d.cross(p_A - p_Q);
        let want = rrp::position(p_A, l, p_Q, d, h, random.sign());
        let x = Vec2::new(1.0, 0.0);
        let line = Line { body: 3, r: Vec2::zero(), d: x };
        let joints = vec![
            Constraint::Revolute { a: point(0, 0.0, 0.0), b: Point { body: 2, r: p_A } },
            Constraint::Revolute { a: point(0, l, 0.0), b: point(1, 0.0, 0.0) },
            Constraint::Offset { point: point(1, 0.0, 0.0), line, law: Law { value: h, ..Law::default() } },
            Constraint::parallel(3, x, 1, x),
        ];
        let mut group = General::new(2, 4, joints).expect("three constraints per body");
        let ground = Pose { p: Vec2::zero(), u: x };
        let start = [near(&mut random, p_A, want.r_1), near(&mut random, want.p_C, d)];
        let mut poses = vec![start[0], start[1], ground, Pose { p: p_Q, u: d }];
        group.position(&mut poses, 1e-12).expect("closes");
        close((poses[1].p - want.p_C).norm() + (poses[1].u - d).norm(), 0.0, 1e-12, 1.0);

        // The oscillating guide: a pin at p_A on a line that turns about the origin of the guide.
        let want = rpr::position(p_Q, p_A, 0.1, 1.0);
        let line = Line { body: 0, r: Vec2::zero(), d: x };
        let joints = vec![
            Constraint::Revolute { a: point(0, 0.0, 0.0), b: point(2, 0.0, 0.0) },
            Constraint::Offset {
                point: Point { body: 1, r: p_A },
                line,
                law: Law { value: 0.1, ..Law::default() },
            },
        ];
        let mut group = General::new(1, 3, joints).expect("three constraints per body");
        let mut poses = vec![near(&mut random, p_Q, want.e), ground, Pose { p: p_Q, u: d }];
        group.position(&mut poses, 1e-12).expect("closes");
        close((poses[0].u - want.e).norm(), 0.0, 1e-12, 1.0 / want.conditioning.abs());
    }
}

/// A ternary link, body 0, on three links, bodies 1 to 3, each hung on the origin of a known body.
fn triad(random: &mut Random) -> Scene {
    let known: Vec<Body> = (0..3).map(|_| Body::random(random)).collect();
    let middle = Pose { p: random.vector(1.0), u: random.direction() };
    let mut poses = vec![middle];
    let mut joints = Vec::new();
    for (i, body) in known.iter().enumerate() {
        let r = random.vector(1.0);
        let leg = middle.point(r) - body.origin(0.0);
        let l = leg.norm();
        poses.push(Pose { p: body.origin(0.0), u: leg / l });
        joints.push(Constraint::Revolute { a: point(i + 1, 0.0, 0.0), b: point(i + 4, 0.0, 0.0) });
        joints.push(Constraint::Revolute { a: point(i + 1, l, 0.0), b: Point { body: 0, r } });
    }
    poses.extend(known.iter().map(|body| pose_of(body, 0.0)));
    let group = General::new(4, 7, joints).expect("three constraints per body");
    Scene { group, known, poses, drives: |_, _| () }
}

fn well_conditioned(scene: &mut Scene) -> bool {
    scene.group.factor(&scene.poses).is_ok_and(|sigma| sigma > 2e-2)
}

#[test]
fn a_triad_moves_and_balances() {
    let mut random = Random::new(32);
    let scenes = (0..100).map(|_| triad(&mut random)).collect::<Vec<_>>();
    let mut checked = 0;
    for mut scene in scenes {
        if well_conditioned(&mut scene) {
            scene.check_derivatives();
            scene.check_reactions(&mut random);
            checked += 1;
        }
    }
    assert!(checked > 20, "only {checked}");
}

/// Body 0 is driven along and about a turning line, body 1 depends on a pin and on a cylinder to body 0.
fn driven(random: &mut Random) -> Scene {
    let known = vec![Body::random(random), Body::random(random)];
    let line = Line { body: 2, r: random.vector(1.0), d: random.direction() };
    let (tip, eye) = (Point { body: 0, r: random.vector(1.0) }, Point { body: 1, r: random.vector(1.0) });
    let joints = vec![
        Constraint::Offset { point: tip, line, law: law(0.0, 0) },
        Constraint::Coordinate { point: tip, line, law: law(0.0, 1) },
        angle_drive(0.0),
        Constraint::Revolute { a: point(1, 0.0, 0.0), b: point(3, 0.2, -0.1) },
        Constraint::Distance { a: eye, b: point(0, 0.0, 0.0), law: law(0.0, 2) },
    ];
    let group = General::new(2, 4, joints).expect("three constraints per body");
    let mut poses = vec![Pose { p: Vec2::zero(), u: Vec2::new(1.0, 0.0) }; 2];
    poses.extend(known.iter().map(|body| pose_of(body, 0.0)));
    Scene {
        group,
        known,
        poses,
        drives: |group, t| {
            for (i, k) in [(0, 0), (1, 1), (4, 2)] {
                match &mut group.constraints[i] {
                    Constraint::Offset { law: given, .. }
                    | Constraint::Coordinate { law: given, .. }
                    | Constraint::Distance { law: given, .. } => *given = law(t, k),
                    _ => (),
                }
            }
            group.constraints[2] = angle_drive(t);
        },
    }
}

fn law(t: f64, k: usize) -> Law {
    let (value, rate, second) = [(0.3, -0.5, 0.8), (0.7, 0.9, -0.6), (1.5, 0.4, 0.5)][k];
    Law { value: value + rate * t + second * (t * t / 2.0), rate: rate + second * t, second }
}

fn angle_drive(t: f64) -> Constraint {
    let angle = Vec2::direction(2.0 + 1.5 * t + 0.35 * t * t);
    Constraint::Angle { a: 2, b: 0, angle, rate: 1.5 + 0.7 * t, second: 0.7 }
}

#[test]
fn drives_of_every_kind() {
    let mut random = Random::new(33);
    let mut checked = 0;
    for _ in 0..100 {
        let mut scene = driven(&mut random);
        let mut poses = scene.poses.clone();
        if scene.group.position(&mut poses, 1e-12).is_ok_and(|sigma| sigma > 3e-2) {
            scene.poses = poses;
            scene.check_derivatives();
            scene.check_reactions(&mut random);
            checked += 1;
        }
    }
    assert!(checked > 20, "only {checked}");
}

#[test]
fn a_prediction_is_good_to_second_order() {
    let mut random = Random::new(34);
    let mut scene = triad(&mut random);
    let (velocities, accelerations) = scene.motion();
    let error = |dt: f64| {
        let exact = scene.at(dt)[0];
        let guess = scene.poses[0].predicted(&velocities[0], &accelerations[0], dt);
        (exact.p - guess.p).norm() + (exact.u - guess.u).norm()
    };
    assert!(error(1e-3) < 0.3 * error(2e-3) * 0.5, "{:e} {:e}", error(1e-3), error(2e-3));
}

#[test]
fn two_assemblies_of_a_dyad() {
    let mut group = dyad(2.0, 2.5);
    let x = Vec2::new(1.0, 0.0);
    let poses = [0.0, 3.0, 0.0, 3.0].map(|at| Pose { p: Vec2::new(at, 0.0), u: x });
    let found = assemblies(&mut group, &poses, 40);
    assert_eq!(found.len(), 2);
    let branches = found.iter().map(|own| {
        let all: Vec<Pose> = own.iter().chain(&poses[2..]).copied().collect();
        group.factor(&all).map(|_| group.branch())
    });
    assert_eq!(branches.filter_map(Result::ok).sum::<f64>(), 0.0);
}

#[test]
fn starts_where_the_bodies_are_meant_to_stand() {
    let mut group = dyad(2.0, 2.5);
    let x = Vec2::new(1.0, 0.0);
    let poses = [0.0, 3.0, 0.0, 3.0].map(|at| Pose { p: Vec2::new(at, 0.0), u: x });
    let all = assemblies(&mut group, &poses, 40);
    for wanted in &all {
        let near = |pose: &Pose| pose.moved(Vec2::new(0.01, -0.02), 0.03);
        let meant = InitialGuess { poses: wanted.iter().map(near).collect(), whole: true };
        // one start alone, and as one more among others
        let found = assemblies_near(&mut group, &poses, 0, Some(&meant));
        assert!(found.len() == 1 && (found[0][0].u - wanted[0].u).norm() < 1e-9, "{found:?}");
        assert_eq!(assemblies_near(&mut group, &poses, 40, Some(&meant)).len(), all.len());
    }
}

/// Assemblies of a triad, counted otherwise: the third link's length as leg 1 turns, the rest a dyad.
fn count_by_scanning(scene: &Scene) -> usize {
    let r: Vec<Vec2> = (0..3)
        .map(|i| match scene.group.constraints[2 * i + 1] {
            Constraint::Revolute { b, .. } => b.r,
            _ => unreachable!("built so"),
        })
        .collect();
    let base: Vec<Vec2> = (4..7).map(|i| scene.poses[i].p).collect();
    let length = |i: usize| (scene.poses[0].point(r[i]) - base[i]).norm();
    let (l, side) = ([length(0), length(1), length(2)], (r[1] - r[0]).norm());
    let mut crossings = 0;
    for branch in [1.0, -1.0] {
        let mut last = f64::NAN;
        for k in 0..=40_000 {
            let p_1 = base[0] + Vec2::direction(f64::from(k) * std::f64::consts::TAU / 40_000.0) * l[0];
            let dyad = rrr::position(p_1, base[1], side, l[1], branch);
            let u = dyad.r_1.turned_back(r[1] - r[0]) / (side * side);
            let excess = (p_1 + (r[2] - r[0]).turned(u) - base[2]).norm() - l[2];
            let excess = if dyad.closure >= 0.0 { excess } else { f64::NAN };
            crossings += usize::from(excess * last < 0.0);
            last = excess;
        }
    }
    crossings
}

#[test]
fn all_assemblies_of_triads() {
    let mut random = Random::new(35);
    for _ in 0..12 {
        let mut scene = triad(&mut random);
        let want = count_by_scanning(&scene);
        let found = assemblies(&mut scene.group, &scene.poses, 300);
        assert_eq!(found.len(), want);
        assert_eq!(want % 2, 0);
    }
}

#[test]
fn what_does_not_close_says_by_how_much() {
    let mut group = dyad(1.0, 1.0);
    let x = Vec2::new(1.0, 0.0);
    let mut start = [0.0, 3.0, 0.0, 3.0].map(|at| Pose { p: Vec2::new(at, 0.3), u: x });
    start[1].u = Vec2::new(0.6, 0.8);
    let mut poses = start;
    let Err(Failure::NotClosed { gap }) = group.position(&mut poses, 1e-12) else {
        panic!("it cannot close")
    };
    close(gap, 1.0, 1e-3, 1.0);
    assert_eq!(poses, start);
}

#[test]
fn a_redundant_group_is_singular() {
    // Two parallel cranks of one length and a coupler: the third crank does not fix it.
    let x = Vec2::new(1.0, 0.0);
    let mut joints = Vec::new();
    for i in 0..3 {
        joints.push(Constraint::Revolute { a: point(i + 1, 0.0, 0.0), b: point(4, i as f64, 0.0) });
        joints.push(Constraint::Revolute { a: point(i + 1, 1.0, 0.0), b: point(0, i as f64, 0.0) });
    }
    let mut group = General::new(4, 5, joints).expect("three constraints per body");
    let up = Vec2::new(0.0, 1.0);
    let mut poses = vec![Pose { p: up, u: x }];
    poses.extend((0..3).map(|i| Pose { p: Vec2::new(f64::from(i), 0.0), u: up }));
    poses.push(Pose { p: Vec2::zero(), u: x });
    assert_eq!(group.factor(&poses), Err(Failure::Singular));
    assert_eq!(group.position(&mut poses, 1e-12), Err(Failure::Singular));
}

#[test]
fn the_shape_must_be_square() {
    let joint = Constraint::Revolute { a: point(0, 0.0, 0.0), b: point(1, 0.0, 0.0) };
    let shape = Failure::Shape { rows: 2, unknowns: 3 };
    assert_eq!(General::new(1, 2, vec![joint]).err(), Some(shape));
    assert!(General::new(1, 1, vec![joint, Constraint::parallel(0, Vec2::zero(), 5, Vec2::zero())]).is_err());
}

#[test]
fn a_position_is_certified_until_rounding_hides_it() {
    // two links of length 1, the pins 2 cos φ apart: σ falls with φ
    let at = |x: f64| Pose { p: Vec2::new(x, 0.0), u: Vec2::new(1.0, 0.0) };
    for (phi, certain) in [(1.0, true), (1e-2, true), (1e-4, true), (1e-6, true), (3e-9, false)] {
        let mut group = dyad(1.0, 1.0);
        let (one, two) = (Vec2::direction(phi), Vec2::direction(std::f64::consts::PI - phi));
        let far = 2.0 * libm::cos(phi);
        let mut poses = vec![at(0.0), at(far), at(0.0), at(far)];
        (poses[0].u, poses[1].u) = (one, two);
        if group.position(&mut poses, 1e-12).is_ok() {
            assert_eq!(group.certificate() <= 0.5, certain, "{phi}: {}", group.certificate());
        } else {
            assert!(!certain, "{phi}");
        }
    }
}

#[test]
fn a_certified_position_is_as_near_as_the_certificate_says() {
    // h bounds the distance of the solution of the disturbed equations: 2η = 2h / βλ
    let mut random = Random::new(75);
    for _ in 0..100 {
        let known = [Body::random(&mut random), Body::random(&mut random)];
        let (p_A, p_B) = (known[0].origin(0.0), known[1].origin(0.0));
        let span = (p_B - p_A).norm();
        let (l_1, l_2) = (span * random.within(0.6, 0.9), span * random.within(0.6, 0.9));
        let p = rrr::position(p_A, p_B, l_1, l_2, random.sign());
        let mut group = dyad(l_1, l_2);
        let mut poses = vec![near(&mut random, p_A, p.r_1), near(&mut random, p_B, p.r_2)];
        poses.extend(known.iter().map(|body| pose_of(body, 0.0)));
        group.position(&mut poses, 1e-12).expect("it closes");
        assert!(group.certificate() < 1e-9, "{}", group.certificate());
    }
}
