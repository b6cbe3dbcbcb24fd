//! Bars in hinges: driven, alone, on a driven cart, two of them; rotors with brakes and clutches; backlash.

use super::build::{
    BEGINS, Begins, GRAVITY, Loaded, Place, Scene, along, drive_law, first_rate, fixed, line, linear, part,
    rounded, single, turned,
};
use super::{Column, Kind};
use crate::support::random::Random;
use std::fmt::Write;
use std::rc::Rc;

/// A bar and the hinge in which it turns.
struct Bar<'a> {
    name: &'a str,
    hinge: &'a str,
    pivot: (&'a str, Place),
    begins: Begins,
    driven: bool,
    kind: Kind,
}

/// Adds a bar that rubs in its hinge, and gives its far end with the torque that is lost about.
fn bar(scene: &mut Scene, random: &mut Random, bar: &Bar) -> (Place, f64) {
    let Bar { name, hinge, pivot: (pivot, on), begins, driven, kind } = *bar;
    let (mass, length) = (rounded(random.within(0.5, 3.0)), rounded(random.within(0.2, 0.6)));
    let (centre, inertia) = (rounded(length * random.within(0.0, 0.7)), rounded(random.within(0.02, 0.3)));
    let angle = if driven { 0.0 } else { rounded(random.within(-2.0, 1.0)) };
    line!(
        scene,
        "link {name} {{ A (0, 0); E ({length} m, 0); S ({centre} m, 0); mass {mass} kg at S; inertia {inertia} kg*m^2 }}"
    );
    let at = on.of(&scene.guess);
    let body = scene.body(mass, inertia, [centre, 0.0], [at[0], at[1], angle]);
    let a = body.point([0.0, 0.0]);
    let forces = scene.hinge(a, on);
    let radius = rounded(random.within(0.005, 0.03));
    let lost = if kind == Kind::Brake { rounded(random.within(0.5, 3.0)) } else { radius * mass * GRAVITY };
    let circle =
        if kind == Kind::Circle { format!(" {{ friction_circle {radius} m }}") } else { String::new() };
    line!(scene, "revolute {hinge}: {pivot} - {name}.A{circle}");
    if kind == Kind::Circle {
        scene.rub(turned(a, on), vec![part(radius, &forces)], 0.0, 1.0);
    } else if kind == Kind::Brake {
        line!(scene, "brake T{name} on {name} {{ capacity {lost} N*m }}");
        scene.rub(turned(a, fixed([0.0; 2])), Vec::new(), lost, 1.0);
    }
    if kind == Kind::Stop {
        let sense = random.sign();
        let gap = if begins == Begins::Stop { 0.0 } else { rounded(random.within(0.1, 0.6)) };
        let restitution = [0.0, rounded(random.within(0.2, 0.8)), 1.0][random.below(3)];
        scene.stop(hinge, "rad", turned(a, on), [sense, rounded(angle - sense * gap), restitution]);
    }
    if !driven {
        scene.start_link(name, turned(a, fixed([0.0; 2])), [angle, first_rate(random, begins, 4.0)]);
    }
    (body.point([length, 0.0]), lost)
}

pub fn scene(random: &mut Random, kind: Kind, column: Column) -> Scene {
    let mut scene = Scene::default();
    if column == Column::Two && kind != Kind::Circle {
        coupled(&mut scene, random, kind);
        return scene;
    }
    let begins = BEGINS[random.below(if kind == Kind::Stop { 6 } else { 5 })];
    let origin = fixed([0.0; 2]);
    let ground = ("ground.O", origin);
    let (end, lost) = match column {
        Column::Driven => {
            let driven = Bar { name: "a", hinge: "J", pivot: ground, begins, driven: true, kind };
            let moved = bar(&mut scene, random, &driven);
            let law = drive_law(&mut scene, random, begins, 0.5, "rad");
            scene.drive("J", turned(moved.0, origin), law);
            scene.system.elements.iter_mut().for_each(|element| element.driven = true);
            moved
        }
        Column::Plate if kind == Kind::Brake => {
            scene.text += "link carrier { A (0, 0); B (0.2 m, 0) }\nrevolute D: ground.O - carrier.A\n";
            let carrier = scene.body(0.0, 0.0, [0.0, 0.0], [0.0; 3]);
            scene.hinge(carrier.point([0.0, 0.0]), origin);
            let law = drive_law(&mut scene, random, begins, 0.5, "rad");
            scene.drive("D", turned(carrier.point([0.0, 0.0]), origin), law);
            let pivot = ("carrier.B", carrier.point([0.2, 0.0]));
            bar(&mut scene, random, &Bar { name: "a", hinge: "J", pivot, begins, driven: false, kind })
        }
        Column::Plate => {
            scene.ground = "line way through O along 90 deg; ".into();
            scene.text += "link plate { P (0, 0) }\nprismatic D: plate.P - ground.way { angle -90 deg }\n";
            let quarter = std::f64::consts::FRAC_PI_2;
            let plate = scene.body(0.0, 0.0, [0.0, 0.0], [0.0; 3]);
            let p = plate.point([0.0, 0.0]);
            scene.guide(p, origin, 0.0);
            scene.system.constraints.pop();
            scene.constrain(along(p, origin, 0.0));
            let law = drive_law(&mut scene, random, begins, 0.05, "m");
            scene.drive("D", along(p, origin, quarter), law);
            bar(
                &mut scene,
                random,
                &Bar { name: "a", hinge: "J", pivot: ("plate.P", p), begins, driven: false, kind },
            )
        }
        _ => {
            let moved = bar(
                &mut scene,
                random,
                &Bar { name: "a", hinge: "J", pivot: ground, begins, driven: false, kind },
            );
            if column == Column::Two {
                let second =
                    Bar { name: "b", hinge: "K", pivot: ("a.E", moved.0), begins, driven: false, kind };
                bar(&mut scene, random, &second);
            }
            moved
        }
    };
    let size = lost * if random.chance(0.4) { random.within(0.3, 0.9) } else { random.within(1.2, 6.0) };
    let how = Loaded { unit: "N*m", coordinate: "angle(a)", length: "rad" };
    scene.load(random, &turned(end, origin), size, &how, |name, value, ending| {
        format!("torque {name} on a = {value}{ending}\n")
    });
    scene
}

/// Two rotors on one axis, which a clutch or backlash couples.
fn coupled(scene: &mut Scene, random: &mut Random, kind: Kind) {
    let inertias = [0, 1].map(|_| rounded(random.within(0.1, 0.8)));
    let [m, n] = inertias.map(|inertia| scene.coordinate(inertia, 0.0));
    let capacity = rounded(random.within(2.0, 8.0));
    let mut rates =
        [0, 1].map(|_| if random.chance(0.3) { 0.0 } else { rounded(random.within(-10.0, 10.0)) });
    let apart = linear(&[m, n], move |q| q[n] - q[m]);
    if kind == Kind::Brake {
        line!(
            scene,
            "shaft a {{ inertia {} kg*m^2 }}\nshaft b {{ inertia {} kg*m^2 }}",
            inertias[0],
            inertias[1]
        );
        let lost = rounded(random.within(1.0, 6.0));
        line!(
            scene,
            "clutch k: a - b {{ capacity {capacity} N*m; slipping }}\nbrake L on b {{ capacity {lost} N*m }}"
        );
        scene.rub(apart, Vec::new(), capacity, 1.0);
        scene.rub(single(n), Vec::new(), lost, 1.0);
    } else {
        for (name, inertia) in ["a", "b"].iter().zip(inertias) {
            line!(scene, "link {name} {{ O (0, 0); mass 1 kg at O; inertia {inertia} kg*m^2 }}");
        }
        scene.text += "revolute O: ground - a\nrevolute E: a.O - b.O\n";
        let play = [0, 1].map(|_| rounded(random.within(0.05, 0.3)));
        let restitution = if random.chance(0.5) { 0.0 } else { rounded(random.within(0.1, 1.0)) };
        scene.stop("E", "rad", apart.clone(), [1.0, -play[0], restitution]);
        if random.chance(0.6) {
            scene.stop("E", "rad", apart, [-1.0, play[1], restitution]);
        }
        rates = rates.map(|rate| rate / 4.0);
    }
    scene.start_link("a", single(m), [0.0, rates[0]]);
    scene.start_link("b", single(n), [0.0, rates[1]]);
    let size = capacity * random.within(0.3, 3.0);
    if random.chance(0.3) {
        // both move on without a force, until it comes
        let (size, late) = (rounded(size * random.sign()), rounded(random.within(0.3, 0.6)));
        line!(scene, "torque P1 on a = {size} N*m when time > {late} s");
        scene.system.breaks.push(late);
        scene
            .system
            .loads
            .push((single(m), Rc::new(move |_, within, _| if within > late { size } else { 0.0 })));
        return;
    }
    let how = Loaded { unit: "N*m", coordinate: "angle(a)", length: "rad" };
    scene.load(random, &single(m), size, &how, |name, value, ending| {
        format!("torque {name} on a = {value}{ending}\n")
    });
}
