//! Cams as mathematics: the shaper's two cams against their key, and profiles against constructions that know nothing of
//! the formulas: circles and lines that are cut with their neighbours.
#![allow(clippy::unwrap_used, clippy::expect_used, reason = "tests")]
#![allow(clippy::disallowed_methods, reason = "an independent computation")]
#![allow(clippy::excessive_precision, reason = "the digits of the reference")]

mod mechanism;
mod random;
mod shaper;
mod turned;

use assur::internals::element::cam::{Cam, CamPoint, Follower, Law, Program, Quantity, Shape};
use assur::internals::math::Vec2;
use random::{Random, random_cam};
use std::f64::consts::TAU;

fn deg(x: f64) -> f64 {
    x.to_radians()
}

fn rise_dwell_fall(rise: f64, dwell: f64, fall: f64, h: f64, laws: [Law; 2]) -> Program {
    Program::new(&[(rise, h, laws[0]), (dwell, 0.0, Law::Dwell), (fall, -h, laws[1])])
}

fn near(got: f64, expected: f64, relative: f64) {
    assert!((got - expected).abs() <= relative * expected.abs(), "{got} instead of {expected}");
}

/// Where the follower's tip (a point and the normal of its face, away from the cam) stands in the axes of the cam: the
/// frame is turned back by the angle of the cam, nothing is taken from the formulas of the profile.
fn tip_in_cam(cam: &Cam, phi: f64, lift: f64) -> (Vec2, Vec2) {
    // seen from a cam that turns clockwise the frame turns counter-clockwise
    let back = if cam.ccw { -phi } else { phi };
    let turned =
        |v: Vec2| Vec2::new(v.x * back.cos() - v.y * back.sin(), v.x * back.sin() + v.y * back.cos());
    let side = if cam.ccw { -1.0 } else { 1.0 };
    let base = cam.base_radius;
    let (point, normal) = match cam.follower {
        Follower::Translating { shape: Shape::Flat, .. } => {
            (Vec2::new(base + lift, 0.0), Vec2::new(1.0, 0.0))
        }
        Follower::Translating { offset, .. } => {
            let reach = (base * base - offset * offset).sqrt() + lift;
            (Vec2::new(reach, side * offset), Vec2::new(1.0, 0.0))
        }
        Follower::Oscillating { shape, arm, pivot_distance: a, with_cam, offset } => {
            let side = if with_cam { side } else { -side };
            let start = if shape == Shape::Flat {
                ((base + offset) / a).asin()
            } else {
                ((a * a + arm * arm - base * base) / (2.0 * a * arm)).acos()
            };
            let (sin, cos) = (start + lift).sin_cos();
            let along = Vec2::new(-cos, side * sin);
            let normal = Vec2::new(sin, side * cos);
            let face = Vec2::new(a, 0.0) - normal * offset;
            (if shape == Shape::Flat { face } else { Vec2::new(a, 0.0) + along * arm }, normal)
        }
    };
    (turned(point), turned(normal))
}

/// Ends of the parts over which the motion is smooth.
fn joints(cam: &Cam) -> Vec<f64> {
    cam.program.parts().flat_map(|p| [p.from, p.to]).collect()
}

/// A cam angle with room for differences on both sides.
fn smooth_angle(random: &mut Random, cam: &Cam, room: f64) -> f64 {
    loop {
        let phi = random.between(room, TAU - room);
        if joints(cam).iter().all(|j| (j - phi).abs() > room) {
            return phi;
        }
    }
}

/// Limit of an even function of h at 0: Richardson's extrapolation over halved steps.
fn limit(mut h: f64, f: impl Fn(f64) -> f64) -> f64 {
    const ROWS: usize = 6;
    let mut table = [0.0; ROWS];
    for row in 0..ROWS {
        let mut next = [0.0; ROWS];
        next[0] = f(h);
        for k in 1..=row {
            let weight = 4.0_f64.powi(k as i32);
            next[k] = (weight * next[k - 1] - table[k - 1]) / (weight - 1.0);
        }
        table = next;
        h *= 0.5;
    }
    table[ROWS - 1]
}

/// The middle of the two places where circles of radius r about `a` and `b` cross, on the side of `towards`.
fn crossing(a: Vec2, b: Vec2, r: f64, towards: Vec2) -> Vec2 {
    let (middle, half) = ((a + b) * 0.5, (b - a) * 0.5);
    let up = Vec2::new(-half.y, half.x) * ((r * r - half.dot(half)).sqrt() / half.norm());
    let (one, two) = (middle + up, middle - up);
    if (one - towards).norm() < (two - towards).norm() { one } else { two }
}

/// Where two lines cross, each by a point and its normal.
fn lines_cross((p, n): (Vec2, Vec2), (q, m): (Vec2, Vec2)) -> Vec2 {
    let (c, d) = (p.dot(n), q.dot(m));
    let det = n.x * m.y - n.y * m.x;
    Vec2::new((c * m.y - d * n.y) / det, (n.x * d - m.x * c) / det)
}

/// The envelope of the roller's circles (of the faces), cut with their neighbours and extrapolated, is the profile.
#[test]
fn profile_is_the_envelope_of_the_follower() {
    let mut random = Random(1);
    let mut worst = 0.0_f64;
    for case in 0..400 {
        let kind = [0, 2, 3, 4][case % 4];
        let cam = random_cam(&mut random, kind);
        let room = 0.02;
        let phi = smooth_angle(&mut random, &cam, room);
        let at = |phi: f64| tip_in_cam(&cam, phi, cam.program.at(phi)[0]);
        let point = cam.at(phi);
        let profile = cam.in_cam(point.contact, phi);
        let cut = |h: f64| {
            let (a, b) = (at(phi - h), at(phi + h));
            match cam.follower.shape() {
                Shape::Flat => lines_cross(a, b),
                // the crossing nearer to the cam's centre
                shape => crossing(a.0, b.0, shape.radius(), Vec2::zero()),
            }
        };
        // a dwell under a face: the lines cut on a circle as well
        let envelope = Vec2::new(limit(0.8 * room, |h| cut(h).x), limit(0.8 * room, |h| cut(h).y));
        worst = worst.max((envelope - profile).norm() / cam.base_radius);
        assert!(
            (envelope - profile).norm() < 1e-9 * cam.base_radius,
            "{cam:?} at {phi}: {envelope:?} instead of {profile:?}"
        );
    }
    assert!(worst > 0.0, "two constructions never agree to the last bit");
}

/// The pitch curve's radius is that of the circle through three neighbours; the pressure angle is that between the line
/// from tip to contact and the way of the tip, by differences.
#[test]
fn curvature_and_pressure_angle_are_those_of_neighbours() {
    let mut random = Random(2);
    for case in 0..400 {
        let kind = [0, 1, 4][case % 3];
        let cam = random_cam(&mut random, kind);
        let room = 0.03;
        let phi = smooth_angle(&mut random, &cam, room);
        let at = |phi: f64| tip_in_cam(&cam, phi, cam.program.at(phi)[0]).0;
        let point = cam.at(phi);
        let curvature = limit(0.8 * room, |h| {
            let (a, b, c) = (at(phi - h), at(phi), at(phi + h));
            let area = (b - a).cross(c - a);
            2.0 * area / ((b - a).norm() * (c - b).norm() * (c - a).norm())
        });
        let sign = if cam.ccw { -1.0 } else { 1.0 };
        let off = (sign * curvature - point.curvature).abs();
        assert!(off < 1e-8 / cam.base_radius, "{cam:?} at {phi}: {curvature} {}", point.curvature);
        // the tangent by differences in the axes of the cam, the way of the tip in those of the frame
        let tangent = Vec2::new(
            limit(0.8 * room, |h| (at(phi + h).x - at(phi - h).x) / (2.0 * h)),
            limit(0.8 * room, |h| (at(phi + h).y - at(phi - h).y) / (2.0 * h)),
        );
        let lift = cam.program.at(phi)[0];
        let way = |h: f64| tip_in_cam(&cam, phi, lift + h).0 - tip_in_cam(&cam, phi, lift - h).0;
        let scale = if kind == 4 { 1.0 } else { cam.base_radius };
        let way = Vec2::new(
            limit(0.02 * scale, |h| way(h).x / (2.0 * h)),
            limit(0.02 * scale, |h| way(h).y / (2.0 * h)),
        );
        // between normal and way: the complement of that between tangent and way
        let sine = tangent.dot(way).abs() / (tangent.norm() * way.norm());
        assert!((sine - point.pressure_angle.sin()).abs() < 1e-9, "{cam:?} at {phi}");
    }
}

/// Radius of curvature under a face, from neighbouring points of the profile.
#[test]
fn curvature_under_a_face_is_that_of_the_profile() {
    let mut random = Random(3);
    for case in 0..200 {
        let cam = random_cam(&mut random, 2 + case % 2);
        let room = 0.03;
        let phi = smooth_angle(&mut random, &cam, room);
        let at = |phi: f64| {
            let p: CamPoint = cam.at(phi);
            cam.in_cam(p.contact, phi)
        };
        let curvature = limit(0.8 * room, |h| {
            let (a, b, c) = (at(phi - h), at(phi), at(phi + h));
            2.0 * (b - a).cross(c - a) / ((b - a).norm() * (c - b).norm() * (c - a).norm())
        });
        let sign = if cam.ccw { -1.0 } else { 1.0 };
        let (got, expected) = (1.0 / (sign * curvature), 1.0 / cam.at(phi).curvature);
        assert!((got - expected).abs() < 1e-7 * cam.base_radius, "{cam:?} at {phi}: {got} {expected}");
    }
}

/// No roller and no face anywhere reaches into a profile without fault, at any other angle of the cam.
#[test]
fn a_sound_profile_is_never_cut() {
    let mut random = Random(4);
    for case in 0..80 {
        let cam = random_cam(&mut random, [0, 2, 3, 4][case % 4]);
        let roller = cam.follower.shape().radius();
        for i in 0..60 {
            let phi = TAU * f64::from(i) / 60.0;
            let profile = cam.in_cam(cam.at(phi).contact, phi);
            for j in 0..720 {
                let other = TAU * f64::from(j) / 720.0;
                let (tip, normal) = tip_in_cam(&cam, other, cam.program.at(other)[0]);
                let gap = match cam.follower.shape() {
                    Shape::Flat => (tip - profile).dot(normal),
                    _ => (tip - profile).norm() - roller,
                };
                assert!(gap > -1e-9 * cam.base_radius, "{cam:?}: {gap} between {phi} and {other}");
            }
        }
    }
}

/// Extremes found are those of a fine grid, and not below it.
#[test]
fn extremes_are_not_below_any_sample() {
    let mut random = Random(5);
    for case in 0..100 {
        let cam = random_cam(&mut random, case % 5);
        for quantity in [Quantity::Lift(1), Quantity::Lift(2), Quantity::PressureAngle] {
            let (phi, most) = cam.extreme(quantity, true);
            let grid = (0..5000).map(|i| cam.at(TAU * f64::from(i) / 5000.0).value(quantity));
            let sampled = grid.fold(f64::NEG_INFINITY, f64::max);
            assert!(most >= sampled - 1e-12 * sampled.abs(), "{quantity:?} {most} {sampled}");
            assert!(most <= sampled + 1e-2 * sampled.abs() + 1e-12, "{quantity:?} {most} {sampled}");
            assert!((0.0..=TAU + 1e-12).contains(&phi));
        }
        let (_, least) = cam.extreme(Quantity::CurvatureRadius, false);
        let grid = (0..5000).map(|i| cam.at(TAU * f64::from(i) / 5000.0).curvature);
        let sharpest = grid.fold(f64::NEG_INFINITY, f64::max);
        assert!(least <= 1.0 / sharpest * (1.0 + 1e-12), "{least} {}", 1.0 / sharpest);
    }
}

/// On the smallest base circle the greatest pressure angle is the allowed one.
#[test]
fn smallest_base_circle_reaches_the_allowed_angle() {
    let mut random = Random(6);
    let mut found = 0;
    for case in 0..60 {
        let cam = random_cam(&mut random, [0, 1, 4][case % 3]);
        let allowed = random.between(0.35, 0.7);
        let Some(radius) = cam.smallest_base_radius(allowed) else { continue };
        let Ok(least) = cam.on_base(radius) else { continue };
        let (_, most) = least.extreme(Quantity::PressureAngle, true);
        assert!(most <= allowed + 1e-9, "{most} {allowed}");
        if let Ok(smaller) = cam.on_base(radius * 0.999) {
            let (_, more) = smaller.extreme(Quantity::PressureAngle, true);
            assert!(more > allowed, "{cam:?} {more} {allowed} {radius}");
            found += 1;
        }
    }
    assert!(found > 20, "{found}");
}

#[test]
fn what_cannot_stand_or_follow_is_found() {
    use assur::internals::element::cam::{Fault, Misfit};
    let program = |h: f64| rise_dwell_fall(1.0, 0.1, 1.0, h, [Law::Cycloidal; 2]);
    let roller = |r: f64| Follower::Translating { shape: Shape::Roller(r), offset: 0.0 };
    let cam = Cam::new(0.03, true, roller(0.02), program(0.04)).unwrap();
    let Some(Fault::Undercut { radius, .. }) = cam.fault() else { panic!("{:?}", cam.fault()) };
    assert!(radius < 0.02);
    let enough = cam.enough_base_radius().unwrap();
    assert_eq!(cam.on_base(enough).unwrap().fault(), None);
    assert!(cam.on_base(enough * 0.999).unwrap().fault().is_some());
    let flat = Follower::Translating { shape: Shape::Flat, offset: 0.0 };
    // r₀ + s + s″ < 0 somewhere: the greatest deceleration of a cycloidal rise is 2π h/β²
    let face = Cam::new(0.05, true, flat, program(0.02)).unwrap();
    assert!(matches!(face.fault(), Some(Fault::Undercut { .. })), "{:?}", face.fault());
    let offset = Follower::Translating { shape: Shape::Knife, offset: 0.05 };
    assert_eq!(Cam::new(0.05, true, offset, program(0.01)), Err(Misfit::Offset));
    let far = Follower::Oscillating {
        shape: Shape::Knife,
        arm: 0.1,
        pivot_distance: 0.2,
        with_cam: true,
        offset: 0.0,
    };
    assert!(matches!(Cam::new(0.05, true, far, program(0.1)), Err(Misfit::Triangle { .. })));
    assert!(matches!(Cam::new(0.15, true, far, program(4.0)), Err(Misfit::TooHigh { .. })));
}
