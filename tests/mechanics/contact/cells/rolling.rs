//! Discs that roll and slide on a slope or a belt, cams under followers and levers, pucks in the plane.

use super::Column;
use super::build::{
    Asked, BEGINS, Body, GRAVITY, Loaded, Place, Scene, along, drive_law, first_rate, fixed, line, part,
    rounded, scalar, turned,
};
use crate::support::random::Random;
use std::f64::consts::FRAC_PI_2;
use std::fmt::Write;

/// How a circle touches a line: from its left side.
struct Touch {
    centre: Place,
    radius: f64,
    on: Place,
    line: f64,
    /// -1 where the circle is on the right side
    side: f64,
}

/// A contact that can only press, with its slip as an element.
fn touch(scene: &mut Scene, touch: &Touch, friction: f64, at_rest: f64) {
    let Touch { centre, radius, on, line, side } = *touch;
    let height = along(centre, on, line + FRAC_PI_2);
    let normal = scene.constrain(scalar(&[centre, on], move |q| side * (height.value)(q) - radius));
    scene.system.constraints[normal].bond = true;
    let way = along(centre, on, line);
    let slip =
        scalar(&[centre, on], move |q| (way.value)(q) + side * radius * (centre.angle(q) - on.angle(q)));
    scene.rub(slip, vec![part(friction, &[normal])], 0.0, at_rest);
}

pub fn scene(random: &mut Random, column: Column) -> Scene {
    let mut scene = Scene::default();
    let friction = rounded(random.within(0.1, 0.5));
    let at_rest = rounded(friction * if random.chance(0.5) { 1.0 } else { random.within(1.2, 1.8) });
    let words = format!("{{ friction {friction}; static_friction {at_rest} }}");
    let contact = Contact { friction, ratio: at_rest / friction, words };
    match column {
        Column::Driven => cam(&mut scene, random, &contact),
        Column::Loop => lever(&mut scene, random, &contact),
        _ => disc(&mut scene, random, column, &contact),
    }
    scene
}

struct Contact {
    friction: f64,
    ratio: f64,
    words: String,
}

fn round(scene: &mut Scene, name: &str, mass: f64, radius: f64, inertia: f64, at: [f64; 2]) -> Body {
    line!(
        scene,
        "link {name} {{ C (0, 0); circle rim centre C radius {radius} m; mass {mass} kg at C; inertia {inertia} kg*m^2 }}"
    );
    scene.body(mass, inertia, [0.0; 2], [at[0], at[1], 0.0])
}

fn disc(scene: &mut Scene, random: &mut Random, column: Column, contact: &Contact) {
    let begins = BEGINS[random.below(5)];
    let slope = if random.chance(0.4) { 0.0 } else { rounded(random.within(-25.0, 25.0)) };
    let angle = slope.to_radians();
    scene.ground = format!("line way through O along {slope} deg; ");
    let [mass, radius] = [rounded(random.within(1.0, 6.0)), rounded(random.within(0.1, 0.3))];
    let inertia = rounded(mass * radius * radius * random.within(0.3, 0.9));
    let mut ground = ("ground.way", fixed([0.0; 2]), angle);
    if column == Column::Plate {
        scene.text +=
            "link plate { P (0, 0); line lane through P along 0 deg }\nprismatic D: plate.P - ground.way\n";
        let plate = scene.body(0.0, 0.0, [0.0; 2], [0.0, 0.0, angle]);
        let p = plate.point([0.0, 0.0]);
        scene.guide(p, ground.1, angle);
        let law = drive_law(scene, random, begins, 0.1, "m");
        scene.drive("D", along(p, ground.1, angle), law);
        ground = ("plate.lane", p, 0.0);
    }
    let (sin, cos) = angle.sin_cos();
    let at = [-radius * sin, radius * cos];
    let c = round(scene, "disc", mass, radius, inertia, at).point([0.0, 0.0]);
    line!(scene, "contact K: disc.rim - {} {}", ground.0, contact.words);
    touch(
        scene,
        &Touch { centre: c, radius, on: ground.1, line: ground.2, side: 1.0 },
        contact.friction,
        contact.ratio,
    );
    let rate = first_rate(random, begins, 2.0);
    let spin = if random.chance(0.5) { 0.0 } else { rounded(random.within(-10.0, 10.0)) };
    line!(scene, "start disc.C = ({} m, {} m) at ({} m/s, {} m/s)", at[0], at[1], rate * cos, rate * sin);
    let x = scalar(&[c], move |q| c.of(q)[0]);
    scene.asked.push(("position(disc.C).x".into(), Asked::Value(x.clone())));
    scene.asked.push(("velocity(disc.C).x".into(), Asked::Rate(x)));
    scene.starts.push((along(c, fixed([0.0; 2]), angle), 0.0, rate));
    scene.start_link("disc", turned(c, fixed([0.0; 2])), [0.0, spin]);
    let size = contact.friction * mass * GRAVITY * radius * random.within(0.3, 4.0);
    let how = Loaded { unit: "N*m", coordinate: "angle(disc)", length: "rad" };
    scene.load(random, &turned(c, fixed([0.0; 2])), size, &how, |name, value, ending| {
        format!("torque {name} on disc = {value}{ending}\n")
    });
}

/// A puck that a load of constant size brakes: its direction turns, and it does not come to rest.
pub fn puck(random: &mut Random) -> Scene {
    let mut scene = Scene::default();
    let (mass, size) = (rounded(random.within(1.0, 3.0)), rounded(random.within(1.0, 5.0)));
    line!(scene, "link puck {{ A (0, 0); mass {mass} kg at A; inertia 0.1 kg*m^2 }}");
    let a = scene.body(mass, 0.1, [0.0; 2], [0.0; 3]).point([0.0, 0.0]);
    let places = [0, 1].map(|i| scalar(&[a], move |q| a.of(q)[i]));
    line!(scene, "force R on puck at A = {size} N against motion");
    scene.system.drags.push((places.clone(), size));
    let rates = [rounded(random.signed(4.0, 7.0)), rounded(random.within(-3.0, 3.0))];
    line!(scene, "start puck.A = (0, 0) at ({} m/s, {} m/s)", rates[0], rates[1]);
    for ((of, rate), axis) in places.iter().zip(rates).zip(["x", "y"]) {
        scene.asked.push((format!("position(puck.A).{axis}"), Asked::Value(of.clone())));
        scene.asked.push((format!("velocity(puck.A).{axis}"), Asked::Rate(of.clone())));
        scene.starts.push((of.clone(), 0.0, rate));
    }
    scene.start_link("puck", turned(a, fixed([0.0; 2])), [0.0, rounded(random.within(-3.0, 3.0))]);
    let how = Loaded { unit: "N", coordinate: "position(puck.A).y", length: "m" };
    scene.load(random, &places[1], size, &how, |name, value, ending| {
        format!("force {name} on puck at A = {value} up{ending}\n")
    });
    scene
}

/// A disc that turns about a point beside its centre.
fn eccentric(scene: &mut Scene, random: &mut Random, angle: f64) -> (Body, [f64; 2], f64) {
    let [off, radius] = [rounded(random.within(0.01, 0.03)), rounded(random.within(0.05, 0.09))];
    let (mass, inertia) = (rounded(random.within(0.5, 2.0)), rounded(random.within(0.01, 0.05)));
    line!(
        scene,
        "link cam {{ A (0, 0); C ({off} m, 0); circle rim centre C radius {radius} m; mass {mass} kg at C; inertia {inertia} kg*m^2 }}\nrevolute A: ground.O - cam.A"
    );
    let cam = scene.body(mass, inertia, [off, 0.0], [0.0, 0.0, angle]);
    scene.hinge(cam.point([0.0, 0.0]), fixed([0.0; 2]));
    (cam, [off, 0.0], radius)
}

/// A driven cam lifts a follower with a flat face.
fn cam(scene: &mut Scene, random: &mut Random, contact: &Contact) {
    let begins = BEGINS[random.below(5)];
    let (cam, centre, radius) = eccentric(scene, random, 0.0);
    let mass = rounded(random.within(0.5, 3.0));
    scene.ground = "line way through O along 90 deg; ".into();
    line!(
        scene,
        "link follower {{ F (0, 0); line face through F along -90 deg; mass {mass} kg at F; inertia 0.01 kg*m^2 }}"
    );
    let follower = scene.body(mass, 0.01, [0.0; 2], [0.0, radius, FRAC_PI_2]);
    let (f, c) = (follower.point([0.0, 0.0]), cam.point(centre));
    scene.guide(f, fixed([0.0; 2]), FRAC_PI_2);
    line!(
        scene,
        "prismatic P: follower.F - ground.way\ncontact K: cam.rim - follower.face {}\nassemble P > 0",
        contact.words
    );
    touch(
        scene,
        &Touch { centre: c, radius, on: f, line: -FRAC_PI_2, side: -1.0 },
        contact.friction,
        contact.ratio,
    );
    let law = drive_law(scene, random, begins, 1.0, "rad");
    scene.drive("A", turned(c, fixed([0.0; 2])), law);
    scene.system.elements.iter_mut().for_each(|element| element.driven = true);
    let size = mass * GRAVITY * random.within(0.2, 0.5);
    let how = Loaded { unit: "N*m", coordinate: "angle(cam)", length: "rad" };
    scene.load(random, &turned(c, fixed([0.0; 2])), size * radius, &how, |name, value, ending| {
        format!("torque {name} on cam = {value}{ending}\n")
    });
}

/// A lever lies on a cam that turns freely.
fn lever(scene: &mut Scene, random: &mut Random, contact: &Contact) {
    let (begins, angle) = (BEGINS[random.below(3)], rounded(random.within(-3.0, 3.0)));
    let (cam, centre, radius) = eccentric(scene, random, angle);
    let c = cam.point(centre);
    let [x, y] = c.of(&scene.guess);
    let (pivot, arm) = (rounded(random.within(0.2, 0.3)), rounded(random.within(0.15, 0.4)));
    let (mass, inertia) = (rounded(random.within(1.0, 4.0)), rounded(random.within(0.02, 0.1)));
    scene.ground = format!("D (-{pivot} m, 0); ");
    let to = [x + pivot, y];
    let lies = to[1].atan2(to[0]) + (radius / to[0].hypot(to[1])).asin();
    line!(
        scene,
        "link lever {{ D (0, 0); S ({arm} m, 0); line face through D along 0 deg; mass {mass} kg at S; inertia {inertia} kg*m^2 }}\nrevolute D: ground - lever\ncontact K: cam.rim - lever.face {}",
        contact.words
    );
    let body = scene.body(mass, inertia, [arm, 0.0], [-pivot, 0.0, lies]);
    let d = body.point([0.0, 0.0]);
    scene.hinge(d, fixed([-pivot, 0.0]));
    let s = body.point([arm, 0.0]).of(&scene.guess);
    line!(scene, "assemble lever.S near ({} m, {} m)", rounded(s[0]), rounded(s[1]));
    touch(scene, &Touch { centre: c, radius, on: d, line: 0.0, side: -1.0 }, contact.friction, contact.ratio);
    scene.start_link("cam", turned(c, fixed([0.0; 2])), [angle, first_rate(random, begins, 6.0)]);
    let size = contact.friction * mass * GRAVITY * radius * random.within(0.3, 2.0);
    let how = Loaded { unit: "N*m", coordinate: "angle(cam)", length: "rad" };
    scene.load(random, &turned(c, fixed([0.0; 2])), size, &how, |name, value, ending| {
        format!("torque {name} on cam = {value}{ending}\n")
    });
}
