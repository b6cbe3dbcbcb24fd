//! One free crank: slider-cranks whose guide rubs, four-bars whose hinges or rockers do.

use super::super::oracle::Scalar;
use super::Kind;
use super::build::{
    BEGINS, Begins, Body, GRAVITY, Loaded, Place, Scene, along, first_rate, fixed, line, part, rounded,
    scalar, turned,
};
use crate::support::random::Random;
use std::f64::consts::FRAC_PI_2;
use std::fmt::Write;

/// A bar from one point to another, with its mass centre on the line between them: both points and the centre.
fn bar(scene: &mut Scene, random: &mut Random, words: [&str; 2], from: [f64; 2], to: [f64; 2]) -> [Place; 3] {
    let (x, y) = (to[0] - from[0], to[1] - from[1]);
    let length = x.hypot(y);
    let (mass, centre) = (rounded(random.within(0.3, 2.0)), rounded(length * random.within(0.2, 0.8)));
    let inertia = rounded(random.within(0.005, 0.05));
    let [name, ends] = words;
    line!(
        scene,
        "link {name} {ends} {} m {{ S ({centre} m, 0); mass {mass} kg at S; inertia {inertia} kg*m^2 }}",
        rounded(length)
    );
    let body = scene.body(mass, inertia, [centre, 0.0], [from[0], from[1], y.atan2(x)]);
    [body.point([0.0, 0.0]), body.point([rounded(length), 0.0]), body.point([centre, 0.0])]
}

pub fn scene(random: &mut Random, kind: Kind, seed: u64) -> Scene {
    let mut scene = Scene::default();
    let begins = BEGINS[random.below(6)];
    let coupler = kind == Kind::Against && seed % 3 == 1;
    // a point that moves in the plane does not come to rest
    let rate = if coupler { rounded(random.signed(12.0, 20.0)) } else { first_rate(random, begins, 8.0) };
    let angle = rounded(random.within(-3.0, 3.0));
    let radius = rounded(random.within(0.06, 0.1));
    let b = [radius * angle.cos(), radius * angle.sin()];
    let crank = bar(&mut scene, random, ["crank", "A-B"], [0.0, 0.0], b);
    scene.hinge(crank[0], fixed([0.0; 2]));
    let (effort, arm) = if coupler || matches!(kind, Kind::Circle | Kind::Brake) {
        four_bar(&mut scene, random, kind, crank[1], b)
    } else {
        (slider_crank(&mut scene, random, kind, crank[1], b), radius)
    };
    if kind == Kind::Stop {
        let sense = random.sign();
        let gap = if begins == Begins::Stop { 0.0 } else { rounded(random.within(0.1, 1.0)) };
        let restitution = [0.0, rounded(random.within(0.2, 0.8)), 1.0][random.below(3)];
        scene.stop(
            "A",
            "rad",
            turned(crank[0], fixed([0.0; 2])),
            [sense, rounded(angle - sense * gap), restitution],
        );
    }
    if kind == Kind::Guide && seed % 3 == 2 {
        // both hold the crank, and what each of them bears is not determined
        let capacity = rounded(effort * arm * random.within(0.1, 1.0));
        line!(scene, "brake T on crank {{ capacity {capacity} N*m }}");
        scene.rub(turned(crank[0], fixed([0.0; 2])), Vec::new(), capacity, 1.0);
    }
    scene.start_link("crank", turned(crank[0], fixed([0.0; 2])), [angle, rate]);
    let size =
        effort * arm * if random.chance(0.4) { random.within(0.3, 0.9) } else { random.within(1.5, 6.0) };
    let how = Loaded { unit: "N*m", coordinate: "angle(crank)", length: "rad" };
    scene.load(random, &turned(crank[0], fixed([0.0; 2])), size, &how, |name, value, ending| {
        format!("torque {name} on crank = {value}{ending}\n")
    });
    scene
}

fn slider_crank(scene: &mut Scene, random: &mut Random, kind: Kind, pin: Place, b: [f64; 2]) -> f64 {
    scene.ground = "A (0, 0); line way through O along 0 deg; ".into();
    let length = rounded(random.within(0.25, 0.35));
    let x = b[0] + (length * length - b[1] * b[1]).sqrt();
    let rod = bar(scene, random, ["rod", "B-C"], b, [x, 0.0]);
    let (mass, offset) = (rounded(random.within(1.0, 4.0)), rounded(random.signed(0.01, 0.08)));
    let centre = if kind == Kind::BothEnds { [offset, -offset / 2.0] } else { [0.0, 0.0] };
    line!(
        scene,
        "link piston {{ C (0, 0); S ({} m, {} m); mass {mass} kg at S; inertia 0.02 kg*m^2 }}",
        centre[0],
        centre[1]
    );
    let piston: Body = scene.body(mass, 0.02, centre, [x, 0.0, 0.0]);
    let (c, origin) = (piston.point([0.0, 0.0]), fixed([0.0; 2]));
    scene.hinge(rod[0], pin);
    scene.hinge(c, rod[1]);
    scene.text += "revolute A: ground - crank\nrevolute B: crank - rod\nrevolute C: rod - piston\nassemble C ahead of A\n";
    let f = rounded(random.within(0.1, 0.4));
    match kind {
        Kind::BothEnds => {
            let ends = [-rounded(random.within(0.05, 0.1)), rounded(random.within(0.05, 0.1))];
            line!(
                scene,
                "prismatic D: piston.C - ground.way {{ friction {f}; contacts {} m, {} m }}",
                ends[0],
                ends[1]
            );
            let normals = ends.map(|end| scene.constrain(along(piston.point([end, 0.0]), origin, FRAC_PI_2)));
            scene.rub(along(c, origin, 0.0), normals.map(|normal| part(f, &[normal])).into(), 0.0, 1.0);
        }
        Kind::Against => {
            scene.guide(c, origin, 0.0);
            let size = rounded(random.within(2.0, 15.0));
            line!(
                scene,
                "prismatic D: piston.C - ground.way\nforce R on piston at C = {size} N against motion"
            );
            scene.rub(along(c, origin, 0.0), Vec::new(), size, 1.0);
            return size;
        }
        _ => {
            let normal = scene.guide(c, origin, 0.0);
            let at_rest = rounded(f * random.within(1.2, 2.0));
            let rest =
                if kind == Kind::Static { format!("; static_friction {at_rest}") } else { String::new() };
            line!(scene, "prismatic D: piston.C - ground.way {{ friction {f}{rest} }}");
            let ratio = if kind == Kind::Static { at_rest / f } else { 1.0 };
            scene.rub(along(c, origin, 0.0), vec![part(f, &[normal])], 0.0, ratio);
        }
    }
    f * mass * GRAVITY
}

/// With a circle in one of its hinges, a brake on its rocker, or a force against the motion of its coupler.
fn four_bar(scene: &mut Scene, random: &mut Random, kind: Kind, pin: Place, b: [f64; 2]) -> (f64, f64) {
    scene.ground = "A (0, 0); D (0.26 m, 0); ".into();
    let (coupler, rocker) = (rounded(random.within(0.23, 0.26)), rounded(random.within(0.15, 0.18)));
    // C to the left of the way from B to D
    let (x, y) = (0.26 - b[0], -b[1]);
    let distance = x.hypot(y);
    let part_way = (coupler * coupler - rocker * rocker + distance * distance) / (2.0 * distance);
    let height = (coupler * coupler - part_way * part_way).sqrt();
    let c = [b[0] + (part_way * x - height * y) / distance, b[1] + (part_way * y + height * x) / distance];
    let coupler = bar(scene, random, ["coupler", "B-C"], b, c);
    let rocker = bar(scene, random, ["rocker", "D-C"], [0.26, 0.0], c);
    let d = fixed([0.26, 0.0]);
    let forces =
        [scene.hinge(coupler[0], pin), scene.hinge(rocker[1], coupler[1]), scene.hinge(rocker[0], d)];
    let turns: [Scalar; 3] = [
        turned(coupler[0], pin),
        turned(rocker[0], coupler[0]),
        scalar(&[rocker[0]], move |q| rocker[0].angle(q)),
    ];
    let (radius, at) = (rounded(random.within(0.003, 0.012)), random.below(3));
    let circle = |i: usize| {
        if kind == Kind::Circle && i == at {
            format!(" {{ friction_circle {radius} m }}")
        } else {
            String::new()
        }
    };
    line!(
        scene,
        "revolute A: ground - crank\nrevolute B: crank - coupler{}\nrevolute C: coupler - rocker{}\nrevolute D: ground - rocker{}\nassemble C left of B-D",
        circle(0),
        circle(1),
        circle(2)
    );
    if kind == Kind::Circle {
        scene.rub(turns[at].clone(), vec![part(radius, &forces[at])], 0.0, 1.0);
        return (20.0, radius);
    }
    if kind == Kind::Against {
        let (size, end) = (rounded(random.within(0.3, 2.0)), coupler[2]);
        line!(scene, "force R on coupler at S = {size} N against motion");
        scene.system.drags.push(([0, 1].map(|i| scalar(&[end], move |q| end.of(q)[i])), size));
        return (size, 0.2);
    }
    let size = rounded(random.within(0.5, 4.0));
    line!(scene, "brake T on rocker {{ capacity {size} N*m }}");
    scene.rub(turns[2].clone(), Vec::new(), size, 1.0);
    (size, 0.7)
}
