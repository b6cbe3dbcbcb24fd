//! Cams as pairs in a mechanism: velocities and accelerations against differences of positions over time, forces against
//! the equilibrium and power of all bodies, which the solver looks at by equations of its own.

use super::random::{Random, random_cam};
use assur::internals::check::Overrides;
use assur::internals::element::cam::{Cam, Follower, Law, Shape};
use assur::internals::math::Vec2;
use assur::internals::model::LinkId;
use assur::internals::solve::BodyState;
use assur::internals::source::Source;
use std::fmt::Write;

/// Moments on both sides of the one looked at.
const SIDE: usize = 4;
const STEP: f64 = 1.5e-3;

fn law(law: Law) -> &'static str {
    match law {
        Law::Dwell => "",
        Law::Uniform => "uniform",
        Law::Parabolic => "parabolic",
        Law::Harmonic => "harmonic",
        Law::Cycloidal => "cycloidal",
        Law::Poly345 => "poly345",
        Law::Poly4567 => "poly4567",
        Law::ModifiedTrapezoid => "modified_trapezoid",
        Law::ModifiedSine => "modified_sine",
        Law::Spline(_) => "along",
    }
}

/// The statement that designs a cam.
fn design(cam: &Cam) -> String {
    let mut text = format!("cam plate {{\n  base_radius {:?} m\n", cam.base_radius);
    let _ = writeln!(text, "  turning {}", if cam.ccw { "ccw" } else { "cw" });
    let (motion, unit) =
        if cam.follower.oscillates() { ("oscillating", "rad") } else { ("translating", "m") };
    let (shape, radius) = match cam.follower.shape() {
        Shape::Knife => ("knife", String::new()),
        Shape::Roller(r) => ("roller", format!("radius {r:?} m; ")),
        Shape::Flat => ("flat", String::new()),
    };
    let rest = match cam.follower {
        Follower::Translating { shape: Shape::Flat, .. } => String::new(),
        Follower::Translating { offset, .. } => format!("offset {offset:?} m"),
        Follower::Oscillating { shape, arm, pivot_distance, with_cam, offset } => {
            let arm =
                if shape == Shape::Flat { format!("offset {offset:?} m") } else { format!("arm {arm:?} m") };
            format!(
                "{arm}; pivot_distance {pivot_distance:?} m; {}",
                if with_cam { "with_cam" } else { "against_cam" }
            )
        }
    };
    let _ = writeln!(text, "  follower {motion} {shape} {{ {radius}{rest} }}");
    let pieces: Vec<_> =
        cam.program.phases().iter().filter(|p| matches!(p.law, Law::Spline(_))).copied().collect();
    if let Some(last) = pieces.last() {
        let end = last.start + last.angle;
        let whole = end > std::f64::consts::TAU - 1e-9;
        let mut curve =
            format!("curve law smooth{} {{\n  phi [rad], s [{unit}]\n", if whole { " periodic" } else { "" });
        for piece in &pieces {
            let _ = writeln!(curve, "  {:?}, {:?}", piece.start, piece.from);
        }
        let _ = writeln!(curve, "  {end:?}, {:?}\n}}", pieces[0].from);
        return curve + &text + "  lift along law\n}\n";
    }
    for phase in cam.program.phases().iter().filter(|p| p.change != 0.0 || p.start > 0.0) {
        let (angle, way) = (phase.angle, phase.change.abs());
        let _ = match phase.change {
            0.0 if phase.start + phase.angle > std::f64::consts::TAU - 1e-9 => Ok(()),
            0.0 => writeln!(text, "  dwell {angle:?} rad"),
            up if up > 0.0 => {
                writeln!(text, "  rise {angle:?} rad through {way:?} {unit} {}", law(phase.law))
            }
            _ => writeln!(text, "  fall {angle:?} rad through {way:?} {unit} {}", law(phase.law)),
        };
    }
    text + "}\n"
}

fn at(angle: f64, length: f64) -> Vec2 {
    Vec2::new(length * angle.cos(), length * angle.sin())
}

fn point(name: &str, p: Vec2) -> String {
    format!("{name} ({:?} m, {:?} m)", p.x, p.y)
}

/// A mechanism with this cam at a random place of a frame, of which the ground is one, or one that turns itself.
pub struct Build {
    pub text: String,
    /// Direction from the cam's centre towards the follower in the frame.
    pub towards: f64,
    pub moving: bool,
    pub omega: f64,
    pub frame_omega: f64,
}

pub fn build(random: &mut Random, cam: &Cam, friction: f64) -> Build {
    let moving = random.unit() < 0.4;
    let towards = random.between(-3.0, 3.0);
    let centre = Vec2::new(random.between(-0.1, 0.1), random.between(-0.1, 0.1));
    let hub = Vec2::new(random.between(-0.02, 0.02), random.between(-0.02, 0.02));
    let e = at(towards, 1.0);
    let left = Vec2::new(-e.y, e.x);
    let (mut base, mut lever, mut pair) = (vec![point("O", centre)], Vec::new(), String::new());
    let profile = match cam.follower.shape() {
        Shape::Knife => "T",
        Shape::Roller(_) => "roller",
        Shape::Flat => "face",
    };
    let sense = if cam.ccw { -1.0 } else { 1.0 };
    let tip = match cam.follower {
        Follower::Translating { shape, offset } => {
            // the guide passes anywhere, the tip stands beside it
            let beside = random.between(-0.03, 0.03);
            let aside = if shape == Shape::Flat { random.between(-0.02, 0.02) } else { sense * offset };
            base.push(point("G", centre + left * beside + e * random.between(-0.05, 0.05)));
            base.push(format!("line guide through G along {towards:?} rad"));
            let q = Vec2::new(random.between(-0.02, 0.02), random.between(-0.02, 0.02));
            lever.push(point("Q", q));
            pair += "prismatic Q: lever.Q - base.guide\n";
            if shape == Shape::Flat {
                lever.push("line face through T along 90 deg".to_owned());
            }
            q + Vec2::new(random.between(-0.05, 0.05), aside - beside)
        }
        Follower::Oscillating { shape, arm, pivot_distance, with_cam, offset } => {
            base.push(point("P", centre + e * pivot_distance));
            let p = Vec2::new(random.between(-0.02, 0.02), random.between(-0.02, 0.02));
            lever.push(point("P", p));
            pair += "revolute P: base - lever\n";
            let gamma = random.between(-3.0, 3.0);
            let side = if with_cam { sense } else { -sense };
            if shape == Shape::Flat {
                lever.push(format!("line face through T along {gamma:?} rad"));
                // away from the cam: the arm's direction turned by −90° for a lever above a cam that turns clockwise
                let normal = at(gamma - side * std::f64::consts::FRAC_PI_2, 1.0);
                p - normal * offset + at(gamma, random.between(0.0, 0.05))
            } else {
                p + at(gamma, arm)
            }
        }
    };
    lever.push(point("T", tip));
    if let Shape::Roller(r) = cam.follower.shape() {
        lever.push(format!("circle roller centre T radius {r:?} m"));
    }
    let mass = |random: &mut Random| {
        let s = point("S", Vec2::new(random.between(-0.05, 0.05), random.between(-0.05, 0.05)));
        format!(
            "{s}; mass {:?} kg at S; inertia {:?} kg*m^2",
            random.between(0.5, 3.0),
            random.between(0.001, 0.02)
        )
    };
    let frame = if moving { "base" } else { "ground" };
    let mut text = design(cam);
    if moving {
        base.push("A (0, 0)".to_owned());
        let _ = writeln!(
            text,
            "ground {{ A ({:?} m, 0.03 m) }}\nlink base {{ {} }}",
            random.between(-0.1, 0.1),
            base.join("; ")
        );
        text += "revolute A: ground - base\n";
    } else {
        let _ = writeln!(text, "ground {{ {} }}", base.join("; "));
    }
    let weight = mass(random);
    let _ = writeln!(text, "link disk {{ {}; {weight}; profile rim of plate centre O }}", point("O", hub));
    let weight = mass(random);
    let _ = writeln!(text, "link lever {{ {}; {weight} }}", lever.join("; "));
    let _ = writeln!(text, "revolute O: {frame} - disk");
    text += &pair.replace("base", frame);
    let (one, two) = if random.unit() < 0.5 {
        ("disk.rim".to_owned(), format!("lever.{profile}"))
    } else {
        (format!("lever.{profile}"), "disk.rim".to_owned())
    };
    let rough = if friction > 0.0 { format!(" {{ friction {friction} }}") } else { String::new() };
    let _ = writeln!(text, "contact K: {one} - {two}{rough}");
    text += "force on lever at T = (30 N, -50 N)\ntorque on lever = 4 N*m\n";
    let (omega, frame_omega) = (sense * -random.between(1.0, 4.0), random.between(-1.5, 1.5));
    Build { text, towards, moving, omega, frame_omega }
}

struct Found {
    lever: Vec<BodyState>,
    residuals: assur::internals::solve::Residuals,
    normal: f64,
}

/// The mechanism at nine moments about the one at which the cam has turned by `phi`.
fn solve(build: &Build, cam: &Cam, phi: f64, alpha: f64) -> Found {
    let frame_angle = 0.4;
    let count = 2 * SIDE + 1;
    let time = |k: usize| (k as f64 - SIDE as f64) * STEP;
    let sense = if cam.ccw { 1.0 } else { -1.0 };
    // the frame's direction towards the follower, seen from the cam, stands at −sense φ
    let start = build.towards + if build.moving { frame_angle } else { 0.0 } + sense * phi;
    let turned = |k: usize| start + build.omega * time(k) + 0.5 * alpha * time(k) * time(k);
    let list = |of: &dyn Fn(usize) -> f64| {
        (0..count).map(|k| format!("{:?} rad", of(k))).collect::<Vec<_>>().join(", ")
    };
    let mut text = build.text.clone();
    let _ = writeln!(
        text,
        "drive disk = {} at {:?} rad/s accelerating {alpha:?} rad/s^2",
        list(&turned),
        build.omega
    );
    if build.moving {
        let turned = |k: usize| frame_angle + build.frame_omega * time(k);
        let _ = writeln!(text, "drive base = {} at {:?} rad/s", list(&turned), build.frame_omega);
    }
    text += "find reactions, normal(K, lever)\n";
    let (solved, problems) =
        assur::internals::solve_source(&Source::new("cam.mech", &text), &Overrides::none());
    let Some(solved) = solved else { panic!("{text}\n{:?}", problems) };
    let links = &solved.compiled.mechanism.links;
    let lever = links.iter().position(|l| l.name == "lever").unwrap();
    let outcomes =
        solved.solution.poses.iter().map(|p| p.outcome.as_ref().unwrap_or_else(|e| panic!("{text}\n{e:?}")));
    let outcomes: Vec<_> = outcomes.collect();
    let model = solved.compiled.model();
    crate::jerks::hold(&model, &outcomes[SIDE].state, || text.clone());
    let view = solved.solution.view(&model, outcomes[SIDE]);
    let pair = assur::internals::model::PairId::at(
        model.mechanism.pairs.iter().position(|p| p.name == "K").unwrap(),
    );
    let query = assur::internals::model::Query::Normal(pair, LinkId::at(lever));
    let assur::internals::model::Value::Scalar(normal) = view.query(&query) else { panic!("a number") };
    Found {
        lever: outcomes.iter().map(|s| s.state.motion.bodies[lever]).collect(),
        residuals: outcomes[SIDE].residuals,
        normal,
    }
}

/// First and second derivative in the middle, by differences of eighth order.
fn derivatives(of: impl Fn(usize) -> f64) -> (f64, f64) {
    const FIRST: [f64; 4] = [4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0];
    const SECOND: [f64; 5] = [-205.0 / 72.0, 8.0 / 5.0, -1.0 / 5.0, 8.0 / 315.0, -1.0 / 560.0];
    let (mut first, mut second) = (0.0, SECOND[0] * of(SIDE));
    for k in 1..=SIDE {
        first += FIRST[k - 1] * (of(SIDE + k) - of(SIDE - k));
        second += SECOND[k] * (of(SIDE + k) + of(SIDE - k));
    }
    (first / STEP, second / (STEP * STEP))
}

#[test]
fn followers_move_as_their_positions_say() {
    let mut random = Random(11);
    for case in 0..60 {
        let cam = random_cam(&mut random, case % 5);
        let build = build(&mut random, &cam, if case % 3 == 0 { 0.1 } else { 0.0 });
        let phi = super::smooth_angle(&mut random, &cam, 0.05);
        let alpha = random.between(-4.0, 4.0);
        let found = solve(&build, &cam, phi, alpha);
        let (lever, middle) = (&found.lever, found.lever[SIDE]);
        let told = || format!("{}\n{:?}", build.text, cam);
        for (p, v, a) in [
            (&(|b: &BodyState| b.p.x) as &dyn Fn(&BodyState) -> f64, middle.v.x, middle.a.x),
            (&|b: &BodyState| b.p.y, middle.v.y, middle.a.y),
        ] {
            let (first, second) = derivatives(|k| p(&lever[k]));
            assert!((first - v).abs() < 1e-11 + 1e-10 * v.abs(), "{first} {v}\n{}", told());
            assert!((second - a).abs() < 1e-8 + 1e-8 * a.abs(), "{second} {a}\n{}", told());
        }
        // u = (cos θ, sin θ): u × u̇ = ω, u × ü = α
        let (x_1, x_2) = derivatives(|k| lever[k].u.x);
        let (y_1, y_2) = derivatives(|k| lever[k].u.y);
        let (omega, angular) = (middle.u.cross(Vec2::new(x_1, y_1)), middle.u.cross(Vec2::new(x_2, y_2)));
        assert!((omega - middle.omega).abs() < 1e-10, "{omega} {}\n{}", middle.omega, told());
        assert!((angular - middle.alpha).abs() < 1e-7, "{angular} {}\n{}", middle.alpha, told());
        let residuals = found.residuals;
        assert!(residuals.closure < 1e-13, "{residuals:?}\n{}", told());
        if found.normal.is_finite() {
            assert!(residuals.equilibrium.is_some_and(|r| r < 1e-13), "{residuals:?}\n{}", told());
            assert!(residuals.power.is_some_and(|r| r < 1e-13), "{residuals:?}\n{}", told());
        }
    }
}

/// The lift at the cam angle, whatever the place of the mechanism: the angle of the lever against the line of centres.
#[test]
fn followers_stand_where_the_law_says() {
    let mut random = Random(12);
    for case in 0..20 {
        let cam = random_cam(&mut random, 4);
        let build = build(&mut random, &cam, 0.0);
        let phi = super::smooth_angle(&mut random, &cam, 0.05);
        let found = solve(&build, &cam, phi, 0.0);
        let rest = solve(&build, &cam, -0.05, 0.0);
        let lift = (cam.program.at(phi)[0] - cam.program.at(-0.05)[0]).abs();
        let turned = rest.lever[SIDE].u.cross(found.lever[SIDE].u).asin().abs();
        assert!((turned - lift).abs() < 1e-12, "case {case}: {turned} {lift}");
    }
}
