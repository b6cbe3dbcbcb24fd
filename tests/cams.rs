//! Cams as mathematics: the shaper's two cams against their key, and profiles against constructions that know nothing of
//! the formulas: circles and lines that are cut with their neighbours.
#![allow(clippy::unwrap_used, clippy::expect_used, reason = "tests")]
#![allow(clippy::disallowed_methods, reason = "an independent computation")]
#![allow(clippy::excessive_precision, reason = "the digits of the reference")]

#[path = "cams/mechanism.rs"]
mod mechanism;
#[path = "cams/random.rs"]
mod random;

use assur::element::cam::{Cam, CamPoint, Follower, Law, Program, Quantity, Shape};
use assur::math::Vec2;
use random::{Random, random_cam};
use std::f64::consts::TAU;

fn deg(x: f64) -> f64 {
    x.to_radians()
}

fn rise_dwell_fall(rise: f64, dwell: f64, fall: f64, h: f64, laws: [Law; 2]) -> Program {
    Program::new(&[(rise, h, laws[0]), (dwell, 0.0, Law::Dwell), (fall, -h, laws[1])])
}

struct ShaperCam {
    lift: f64,
    arm: f64,
    pivot: f64,
    turn: f64,
    start: f64,
    far: f64,
    pressure: [f64; 2],
    at: f64,
    curvature: f64,
    curvature_at: f64,
    points: [(f64, [f64; 4]); 9],
}

/// Exact values of the exercises s004-cam-1 and s004-cam-2; the radii of curvature are those of
/// tests/reference/cams/shaper_cams.py, the exercises' own being differences.
fn shaper_cams() -> [ShaperCam; 2] {
    [
        ShaperCam {
            lift: 18.0,
            arm: 0.13,
            pivot: 0.14,
            turn: 60.0,
            start: 20.922239682576617,
            far: 0.09044790729444421,
            pressure: [44.79541810888772, 51.13672681296346],
            at: 30.0,
            curvature: 0.03124342801547574,
            curvature_at: 47.0,
            points: [
                (0.0, [0.018571428571428572, 0.04642307659791978, 0.013, 0.03249615361854384]),
                (
                    15.0,
                    [0.006549737116325452, 0.054714083315901565, -0.003596013777007825, 0.04366583735509733],
                ),
                (
                    30.0,
                    [-0.008756323745391153, 0.06982356749052603, -0.01931052966953251, 0.059164827541037655],
                ),
                (
                    45.0,
                    [-0.029634295671249648, 0.08016631900920602, -0.03119103976010351, 0.06524731945019341],
                ),
                (60.0, [-0.05130211591526479, 0.07449105205701628, -0.04279410548420156, 0.0621373579331957]),
                (
                    75.0,
                    [-0.06849870944387404, 0.058217149142343154, -0.055862734872718575, 0.05013431878181274],
                ),
                (
                    90.0,
                    [-0.07442034300350443, 0.033409134785194895, -0.05947882432601637, 0.03473239576107053],
                ),
                (
                    120.0,
                    [
                        -0.05173279805724141,
                        -0.007466619187495038,
                        -0.03939066528250914,
                        0.0010581540394523899,
                    ],
                ),
                (180.0, [-0.018571428571428572, -0.04642307659791978, -0.013, -0.03249615361854384]),
            ],
        },
        ShaperCam {
            lift: 15.0,
            arm: 0.12,
            pivot: 0.136,
            turn: 70.0,
            start: 21.369486968571422,
            far: 0.08132622615974205,
            pressure: [37.57776919906117, 38.55324929308166],
            at: 35.0,
            curvature: 0.03614110528855766,
            curvature_at: 114.75,
            points: [
                (0.0, [0.02425, 0.043725707541445225, 0.016975, 0.03060799527901166]),
                (
                    15.0,
                    [0.012461168283663523, 0.05137535478830828, 0.0037884729433086744, 0.0391367128892499],
                ),
                (
                    30.0,
                    [-0.0020426377566941517, 0.06146807012807481, -0.01028079046063626, 0.048932806268604946],
                ),
                (
                    45.0,
                    [-0.021008438233722736, 0.07028161085152124, -0.023808782685062986, 0.05554532668780317],
                ),
                (60.0, [-0.04141767403907359, 0.06850702238006, -0.03613976806016787, 0.05446623506318096]),
                (
                    75.0,
                    [-0.058543183395397554, 0.05645042727312488, -0.04774534126749537, 0.04603857799545567],
                ),
                (
                    90.0,
                    [-0.07012226907353097, 0.03861998469922424, -0.05591710398930176, 0.033801967998361174],
                ),
                (
                    120.0,
                    [-0.06146807012807481, -0.0020426377566941517, -0.0496391197144878, 0.007181023778341685],
                ),
                (180.0, [-0.02425, -0.043725707541445225, -0.016975, -0.03060799527901166]),
            ],
        },
    ]
}

fn shaper_cam(key: &ShaperCam, with_cam: bool) -> Cam {
    let turn = deg(key.turn);
    let program = rise_dwell_fall(turn, deg(10.0), turn, deg(key.lift), [Law::Parabolic; 2]);
    let (shape, arm, pivot_distance) = (Shape::Roller(0.015), key.arm, key.pivot);
    let follower = Follower::Oscillating { shape, arm, pivot_distance, with_cam, offset: 0.0 };
    Cam::new(0.05, false, follower, program).unwrap()
}

#[test]
fn shaper_cams_are_those_of_the_key() {
    for key in shaper_cams() {
        let cam = shaper_cam(&key, true);
        near(cam.start().to_degrees(), key.start, 1e-12);
        let top = cam.at(deg(key.turn + 5.0));
        near(top.tip.norm(), key.far, 1e-12);
        for (phi, [x, y, w_x, w_y]) in key.points {
            let phi = deg(phi);
            let point = cam.at(phi);
            let (pitch, profile) = (cam.in_cam(point.tip, phi), cam.in_cam(point.contact, phi));
            let off = [pitch.x - x, pitch.y - y, profile.x - w_x, profile.y - w_y];
            assert!(off.iter().all(|o| o.abs() < 1e-13), "{off:?} at {phi}");
        }
        near(1.0 / cam.at(deg(key.curvature_at)).curvature, key.curvature, 1e-12);
        for (with_cam, pressure) in [(true, key.pressure[0]), (false, key.pressure[1])] {
            // the key looks at the rise alone
            let turn = deg(key.turn);
            let cam = shaper_cam(&key, with_cam);
            let at = cam.at(deg(key.at)).pressure_angle.to_degrees();
            near(at, pressure, 1e-12);
            let rise = (0..=600).map(|i| cam.at(turn * f64::from(i) / 600.0).pressure_angle.to_degrees());
            assert!(rise.fold(0.0, f64::max) <= pressure + 1e-12);
        }
    }
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
    use assur::element::cam::{Fault, Misfit};
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
