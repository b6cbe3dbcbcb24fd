//! Carts on a way: driven, alone, on a driven plate, on another cart.

use super::build::GRAVITY;
use super::build::{
    BEGINS, Begins, Loaded, Place, Scene, along, drive_law, first_rate, fixed, line, part, rounded,
};
use super::{Column, Kind};
use crate::support::random::Random;
use std::fmt::Write;

/// A cart and what it rubs on.
struct Cart<'a> {
    name: &'a str,
    guide: &'a str,
    /// the line as it is named in the file, its place and its angle on its body
    way: (&'a str, Place, f64),
    begins: Begins,
    driven: bool,
    kind: Kind,
}

/// Adds a cart that rubs in its guide, and gives it with the effort that friction bears.
fn cart(scene: &mut Scene, random: &mut Random, cart: &Cart, slope: f64) -> (Place, f64) {
    let Cart { name, guide, way: (way, on, angle), begins, driven, kind } = *cart;
    let (mass, inertia) = (rounded(random.within(1.0, 4.0)), rounded(random.within(0.02, 0.2)));
    let centre = match kind {
        Kind::BothEnds => [rounded(random.signed(0.02, 0.25)), rounded(random.signed(0.02, 0.15))],
        _ => [0.0, 0.0],
    };
    line!(
        scene,
        "link {name} {{ A (0, 0); S ({} m, {} m); line top through A along 0 deg; mass {mass} kg at S; inertia {inertia} kg*m^2 }}",
        centre[0],
        centre[1]
    );
    let body = scene.body(mass, inertia, centre, [0.0, 0.0, slope]);
    let a = body.point([0.0, 0.0]);
    let f = rounded(random.within(0.1, 0.45));
    let mut effort = f * mass * GRAVITY;
    let rubs = |scene: &mut Scene, parts, at_rest| scene.rub(along(a, on, angle), parts, 0.0, at_rest);
    match kind {
        Kind::Guide | Kind::Static | Kind::Stop => {
            let normal = scene.guide(a, on, angle);
            let at_rest = rounded(f * random.within(1.2, 2.0));
            let rest =
                if kind == Kind::Static { format!("; static_friction {at_rest}") } else { String::new() };
            line!(scene, "prismatic {guide}: {name}.A - {way} {{ friction {f}{rest} }}");
            rubs(scene, vec![part(f, &[normal])], if rest.is_empty() { 1.0 } else { at_rest / f });
        }
        Kind::BothEnds => {
            let ends = [-rounded(random.within(0.05, 0.2)), rounded(random.within(0.05, 0.2))];
            line!(
                scene,
                "prismatic {guide}: {name}.A - {way} {{ friction {f}; contacts {} m, {} m }}",
                ends[0],
                ends[1]
            );
            let quarter = std::f64::consts::FRAC_PI_2;
            let normals = ends.map(|end| scene.constrain(along(body.point([end, 0.0]), on, angle + quarter)));
            rubs(scene, normals.map(|normal| part(f, &[normal])).into(), 1.0);
        }
        _ => {
            scene.guide(a, on, angle);
            effort = rounded(random.within(2.0, 12.0));
            line!(scene, "prismatic {guide}: {name}.A - {way}");
            line!(scene, "force R{name} on {name} at A = {effort} N against motion");
            scene.rub(along(a, fixed([0.0; 2]), slope), Vec::new(), effort, 1.0);
        }
    }
    if kind == Kind::Stop && driven {
        // every law of a drive passes it
        line!(scene, "stop {guide} < {} m", rounded(random.within(0.02, 0.08)));
        scene.refused = true;
    } else if kind == Kind::Stop {
        let rate = first_rate(random, begins, 1.0);
        let sense = random.sign();
        let gap = if begins == Begins::Stop { 0.0 } else { rounded(random.within(0.01, 0.12)) };
        let restitution = [0.0, rounded(random.within(0.2, 0.8)), 1.0][random.below(3)];
        scene.stop(guide, "m", along(a, on, angle), [sense, -sense * gap, restitution]);
        scene.start_guide(guide, along(a, on, angle), [0.0, rate]);
    } else if !driven {
        scene.start_guide(guide, along(a, on, angle), [0.0, first_rate(random, begins, 1.0)]);
    }
    (a, effort)
}

pub fn scene(random: &mut Random, kind: Kind, column: Column) -> Scene {
    let mut scene = Scene::default();
    let slope = if random.chance(0.5) { 0.0 } else { rounded(random.within(-25.0, 25.0)) };
    scene.ground = format!("line way through O along {slope} deg; ");
    let (angle, origin) = (slope.to_radians(), fixed([0.0; 2]));
    let mut begins = BEGINS[random.below(if kind == Kind::Stop { 6 } else { 5 })];
    let ground = ("ground.way", origin, angle);
    let moved = match column {
        Column::Driven => {
            let driven = Cart { name: "a", guide: "G", way: ground, begins, driven: true, kind };
            let moved = cart(&mut scene, random, &driven, angle);
            let law = drive_law(&mut scene, random, begins, 0.1, "m");
            scene.drive("G", along(moved.0, origin, angle), law);
            scene.system.elements.iter_mut().for_each(|element| element.driven = true);
            if random.chance(0.4) {
                scene.text += "link fan { Q (0, 0); mass 1 kg at Q; inertia 1 kg*m^2 }\nrevolute Q: ground - fan\nstart fan = 0 rad at 1 rad/s\n";
            }
            moved
        }
        Column::One => cart(
            &mut scene,
            random,
            &Cart { name: "a", guide: "G", way: ground, begins, driven: false, kind },
            angle,
        ),
        Column::Plate => {
            scene.text += "link plate { P (0, 0); line lane through P along 0 deg }\nprismatic D: plate.P - ground.way\n";
            let plate = scene.body(0.0, 0.0, [0.0, 0.0], [0.0, 0.0, angle]);
            let p = plate.point([0.0, 0.0]);
            scene.guide(p, origin, angle);
            let law = drive_law(&mut scene, random, begins, 0.1, "m");
            scene.drive("D", along(p, origin, angle), law);
            let way = ("plate.lane", p, 0.0);
            cart(&mut scene, random, &Cart { name: "a", guide: "G", way, begins, driven: false, kind }, angle)
        }
        _ => {
            if matches!(begins, Begins::Reversal | Begins::Dwell) {
                begins = Begins::Rest;
            }
            let under = if kind == Kind::Stop { Kind::Guide } else { kind };
            let lower =
                Cart { name: "b", guide: "H", way: ground, begins: Begins::Rest, driven: false, kind: under };
            let way = ("b.top", cart(&mut scene, random, &lower, angle).0, 0.0);
            cart(&mut scene, random, &Cart { name: "a", guide: "G", way, begins, driven: false, kind }, angle)
        }
    };
    let (a, effort) = moved;
    let size = effort * if random.chance(0.4) { random.within(0.3, 0.9) } else { random.within(1.2, 4.0) };
    let how = Loaded { unit: "N", coordinate: "displacement(G)", length: "m" };
    // the load is along the way, the coordinate of a field is that of the guide
    let field =
        if column == Column::Two || column == Column::Plate { "position(a.A).x" } else { how.coordinate };
    if field == how.coordinate || slope == 0.0 {
        let how = Loaded { coordinate: field, ..how };
        scene.load(random, &along(a, origin, angle), size, &how, |name, value, ending| {
            format!("force {name} on a at A = {value} @ {slope} deg{ending}\n")
        });
    }
    scene
}
