//! Transmissions that lose power: driven, with two shafts, on a driven carrier, with a clutch and a brake, in a geared five-bar.

use super::super::oracle::{Element, Part, Scalar};
use super::Column;
use super::build::{
    Asked, BEGINS, GRAVITY, Loaded, Place, Scene, drive_law, first_rate, fixed, line, linear, rounded,
    scalar, single, turned,
};
use crate::support::random::Random;
use std::fmt::Write;
use std::rc::Rc;

/// Efficiencies in both directions as a friction on the first side: coefficients of |λ| and of λ.
fn loss(there: f64, back: f64) -> [f64; 2] {
    let (a, b) = (1.0 / there - 1.0, 1.0 - back);
    [f64::midpoint(a, b), (b - a) / 2.0]
}

/// A law between scalars, `first + ratio second = 0`, that loses power on the side of the first.
fn law(scene: &mut Scene, first: Scalar, ratio: f64, second: &Scalar, [even, odd]: [f64; 2]) {
    let on: Vec<usize> = first.on.iter().chain(&second.on).copied().collect();
    let (a, b) = (first.value.clone(), second.value.clone());
    let force = scene.constrain(linear(&on, move |q| a(q) + ratio * b(q)));
    let part = Part { even, odd, of: vec![force] };
    scene.system.elements.push(Element {
        of: first,
        parts: vec![part],
        capacity: Rc::new(|_| 0.0),
        at_rest: 1.0,
        driven: false,
    });
}

pub fn scene(random: &mut Random, column: Column) -> Scene {
    let mut scene = Scene::default();
    match column {
        Column::Driven | Column::One => two_sides(&mut scene, random, column == Column::Driven),
        Column::Plate => on_a_carrier(&mut scene, random),
        Column::Two => with_a_clutch(&mut scene, random),
        Column::Loop => five_bar(&mut scene, random),
    }
    scene
}

fn torque(scene: &mut Scene, random: &mut Random, of: &Scalar, name: &str, size: f64) {
    let coordinate = format!("angle({name})");
    let how = Loaded { unit: "N*m", coordinate: &coordinate, length: "rad" };
    scene.load(random, of, size, &how, |load, value, ending| {
        format!("torque {load} on {name} = {value}{ending}\n")
    });
}

/// A shaft with a wheel; gives its coordinate and the teeth.
fn shaft(scene: &mut Scene, random: &mut Random, name: &str) -> (usize, f64) {
    let inertia = rounded(random.within(0.05, 0.8));
    let teeth = 16 + random.below(50);
    let module = if name == "a" { " module 3 mm" } else { "" };
    line!(scene, "shaft {name} {{ wheel w{name} teeth {teeth}{module}; inertia {inertia} kg*m^2 }}");
    (scene.coordinate(inertia, 0.0), teeth as f64)
}

fn two_sides(scene: &mut Scene, random: &mut Random, driven: bool) {
    let begins = BEGINS[random.below(5)];
    let eta = rounded(random.within(0.7, 0.97));
    let both = loss(eta, eta);
    let mut size = 5.0;
    let (a, b, ratio, lost) = match random.below(5) {
        0 | 1 => {
            let ((a, first), (b, second)) = (shaft(scene, random, "a"), shaft(scene, random, "b"));
            line!(scene, "mesh m: wa - wb {{ efficiency {eta} }}");
            (a, b, second / first, both)
        }
        2 => {
            // self-locking in every other case
            let eta = rounded(random.within(0.3, 0.8));
            line!(scene, "shaft a {{ inertia 0.02 kg*m^2 }}");
            let a = scene.coordinate(0.02, 0.0);
            let (b, teeth) = shaft(scene, random, "b");
            line!(scene, "worm m: a - wb {{ starts 2; efficiency {eta} }}");
            scene.text = scene.text.replacen(
                &format!("wheel wb teeth {teeth}"),
                &format!("wheel wb teeth {teeth} module 4 mm"),
                1,
            );
            (a, b, -teeth / 2.0, loss(eta, 2.0 - 1.0 / eta))
        }
        3 => {
            let eta = rounded(random.within(0.3, 0.8));
            let mass = rounded(random.within(5.0, 40.0));
            line!(
                scene,
                "shaft a {{ inertia 0.01 kg*m^2 }}\nslider b {{ mass {mass} kg }}\nscrew m: a - b {{ lead 0.02 m; efficiency {eta} }}"
            );
            let (a, b) = (scene.coordinate(0.01, 0.0), scene.coordinate(mass, mass * GRAVITY));
            size = 1.0;
            (a, b, -std::f64::consts::TAU / 0.02, loss(eta, 2.0 - 1.0 / eta))
        }
        _ => {
            let ((a, first), (b, second)) = (shaft(scene, random, "a"), shaft(scene, random, "b"));
            line!(scene, "chain m: wa - wb {{ efficiency {eta} }}");
            (a, b, -second / first, both)
        }
    };
    law(scene, single(a), ratio, &single(b), lost);
    if driven {
        let law = drive_law(scene, random, begins, 1.0, "rad");
        scene.drive("a", single(a), law);
        scene.system.elements.iter_mut().for_each(|element| element.driven = true);
    } else {
        scene.start_link("a", single(a), [0.0, first_rate(random, begins, 20.0)]);
    }
    if !scene.text.contains("slider b") && random.chance(0.6) {
        let constant = rounded(random.within(-10.0, 10.0));
        line!(scene, "torque L on b = {constant} N*m");
        scene.system.loads.push((single(b), Rc::new(move |_, _, _| constant)));
    }
    let size = size * random.within(0.3, 3.0);
    torque(scene, random, &single(a), "a", size);
}

/// A free sun wheel in mesh with a planet on a driven carrier.
fn on_a_carrier(scene: &mut Scene, random: &mut Random) {
    let begins = BEGINS[random.below(5)];
    let eta = rounded(random.within(0.7, 0.97));
    let (a, sun) = shaft(scene, random, "a");
    let h = scene.coordinate(0.0, 0.0);
    let (teeth, inertia) = (16 + random.below(30), rounded(random.within(0.05, 0.5)));
    line!(
        scene,
        "shaft H\nshaft p on H {{ wheel wp teeth {teeth}; inertia {inertia} kg*m^2 }}\nmesh m: wa - wp {{ efficiency {eta} }}"
    );
    let p = scene.coordinate(inertia, 0.0);
    let seen = |i: usize| linear(&[i, h], move |q| q[i] - q[h]);
    law(scene, seen(a), teeth as f64 / sun, &seen(p), loss(eta, eta));
    let drive = drive_law(scene, random, begins, 1.0, "rad");
    scene.drive("H", single(h), drive);
    scene.start_link("a", single(a), [0.0, first_rate(random, begins, 10.0)]);
    if random.chance(0.6) {
        let constant = rounded(random.within(-5.0, 5.0));
        line!(scene, "torque L on p = {constant} N*m");
        scene.system.loads.push((single(p), Rc::new(move |_, _, _| constant)));
    }
    let size = random.within(0.5, 6.0);
    torque(scene, random, &single(a), "a", size);
}

/// A motor that a clutch couples to a lossy mesh with a brake.
fn with_a_clutch(scene: &mut Scene, random: &mut Random) {
    let eta = rounded(random.within(0.8, 0.97));
    let inertia = rounded(random.within(0.1, 0.5));
    line!(scene, "shaft m {{ inertia {inertia} kg*m^2 }}");
    let m = scene.coordinate(inertia, 0.0);
    let ((a, first), (b, second)) = (shaft(scene, random, "a"), shaft(scene, random, "b"));
    let capacity = rounded(random.within(5.0, 40.0));
    let ramp = random.chance(0.5);
    line!(
        scene,
        "clutch k: m - a {{ capacity {capacity} N*m{}; slipping }}",
        if ramp { "/s*time" } else { "" }
    );
    line!(scene, "mesh g: wa - wb {{ efficiency {eta} }}");
    let slip = linear(&[m, a], move |q| q[m] - q[a]);
    scene.rub(slip, Vec::new(), 0.0, 1.0);
    if let Some(clutch) = scene.system.elements.last_mut() {
        clutch.capacity = Rc::new(move |t| if ramp { capacity * t } else { capacity });
    }
    law(scene, single(a), second / first, &single(b), loss(eta, eta));
    if random.chance(0.7) {
        let brake = rounded(random.within(1.0, 15.0));
        line!(scene, "brake L on b {{ capacity {brake} N*m }}");
        scene.rub(single(b), Vec::new(), brake, 1.0);
    }
    scene.start_link("m", single(m), [0.0, rounded(random.within(-40.0, 40.0))]);
    let rate = if random.chance(0.5) { 0.0 } else { rounded(random.within(-20.0, 20.0)) };
    scene.start_link("a", single(a), [0.0, rate]);
    let size = random.within(2.0, 30.0);
    torque(scene, random, &single(m), "m", size);
}

/// Two cranks in mesh, whose rods meet.
fn five_bar(scene: &mut Scene, random: &mut Random) {
    let (eta, begins) = (rounded(random.within(0.7, 0.97)), BEGINS[random.below(3)]);
    let (radius, length, apart) =
        (rounded(random.within(0.03, 0.045)), rounded(random.within(0.14, 0.17)), 0.12);
    let angle = rounded(random.within(-3.0, 3.0));
    scene.ground = format!("A (0, 0); D ({apart} m, 0); ");
    let pi = std::f64::consts::PI;
    let pins = [[0.0, 0.0], [apart, 0.0]];
    let turns = [angle, pi - angle];
    let mut ends: Vec<Place> = Vec::new();
    for ((name, pin), turn) in [("first A-B", pins[0]), ("second D-E", pins[1])].into_iter().zip(turns) {
        let (mass, inertia) = (rounded(random.within(0.5, 2.0)), rounded(random.within(0.01, 0.1)));
        let (name, points) = name.split_at(name.len() - 3);
        let at =
            if points == "A-B" { "wheel z1 teeth 30 module 4 mm at A" } else { "wheel z2 teeth 30 at D" };
        line!(
            scene,
            "link {name}{points} {radius} m {{ {at}; S (0.01 m, 0); mass {mass} kg at S; inertia {inertia} kg*m^2 }}"
        );
        let body = scene.body(mass, inertia, [0.01, 0.0], [pin[0], pin[1], turn]);
        scene.hinge(body.point([0.0, 0.0]), fixed(pin));
        ends.push(body.point([0.0, 0.0]));
        ends.push(body.point([radius, 0.0]));
    }
    let [b, e] = [ends[1].of(&scene.guess), ends[3].of(&scene.guess)];
    let half = (e[0] - b[0]) / 2.0;
    // C to the left of the way from B to E
    let height = half.signum() * (length * length - half * half).sqrt();
    let c = [b[0] + half, b[1] + height];
    let mut rods: Vec<Place> = Vec::new();
    for (name, from, pin) in [("c B-C", b, ends[1]), ("d E-C", e, ends[3])] {
        let (mass, inertia) = (rounded(random.within(0.3, 1.0)), rounded(random.within(0.005, 0.02)));
        line!(
            scene,
            "link {name} {length} m {{ S (0.07 m, 0); mass {mass} kg at S; inertia {inertia} kg*m^2 }}"
        );
        let body = scene.body(
            mass,
            inertia,
            [0.07, 0.0],
            [from[0], from[1], (c[1] - from[1]).atan2(c[0] - from[0])],
        );
        scene.hinge(body.point([0.0, 0.0]), pin);
        rods.push(body.point([length, 0.0]));
    }
    scene.hinge(rods[0], rods[1]);
    line!(
        scene,
        "revolute A: ground - first\nrevolute D: ground - second\nrevolute B: first - c\nrevolute E: second - d\nrevolute C: c - d\nmesh k: z1 - z2 {{ phase 180 deg; efficiency {eta} }}\nassemble C left of B-E"
    );
    let origin = fixed([0.0; 2]);
    let second = turned(ends[2], origin);
    let moved = linear(&second.on.clone(), move |q| (second.value)(q) - pi);
    law(scene, turned(ends[0], origin), 1.0, &moved, loss(eta, eta));
    scene.start_link("first", turned(ends[0], origin), [angle, first_rate(random, begins, 8.0)]);
    let rod = rods[0];
    let y = scalar(&[rod], move |q| rod.of(q)[1]);
    scene.asked.push(("position(c.C).y".into(), Asked::Value(y)));
    let size = random.within(0.5, 5.0);
    torque(scene, random, &turned(ends[0], origin), "first", size);
}
