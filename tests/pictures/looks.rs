//! Links look like what they are: plates, wedges, springs beside guides, pitch circles with names.

use crate::drawn::{faults, sheets, solved};
use assur::internals::drawing::{Mark, Shape, Sheet, Style};
use assur::internals::math::Vec2;
use assur::internals::picture::Kind;

fn scheme(text: &str) -> Sheet {
    let (source, solved) = solved("looks.mech", &format!("mech 1\n{text}\n")).expect("a solution");
    let sheet = sheets(&source, &solved, Kind::Scheme).remove(0);
    assert_eq!(faults(&sheet), Vec::<String>::new());
    sheet
}

fn of<'a>(sheet: &'a Sheet, class: &'a str, name: &'a str) -> impl Iterator<Item = &'a Mark> {
    let groups = &sheet.drawing.groups;
    sheet.drawing.marks.iter().filter(move |m| groups[m.group].class == class && groups[m.group].name == name)
}

fn plate(sheet: &Sheet, link: &str) -> Option<Vec<Vec2>> {
    of(sheet, "link", link).find_map(|m| match &m.shape {
        Shape::Lines { points, closed: true } if m.style == Style::Plate => Some(points.clone()),
        _ => None,
    })
}

fn labels(sheet: &Sheet) -> Vec<String> {
    sheet.placed.iter().map(|p| p.label.text.plain()).collect()
}

#[test]
fn a_foot_is_a_plate_and_a_rotor_with_masses_is_none() {
    let leg = "ground { O (0, 0) }\nlink thigh O-K 0.4 m\n\
               link foot { K (0, 0); toe (0.18 m, -0.08 m); heel (-0.06 m, -0.08 m) }\n\
               revolute O: ground - thigh\nrevolute K: thigh - foot\n\
               drive thigh = -70 deg at 1 rad/s\ndrive foot = 10 deg at 0 rad/s";
    assert_eq!(plate(&scheme(leg), "foot").expect("a plate").len(), 3);
    let rotor = "ground { O (0, 0) }\nlink rotor { O (0, 0); A (0.2 m, 0); B (0, 0.1 m); mass 2 kg at A; mass 3 kg at B }\n\
                 revolute O: ground - rotor\ndrive rotor = 0 deg at 10 rad/s";
    assert_eq!(plate(&scheme(rotor), "rotor"), None);
}

#[test]
fn corners_of_wedges_are_on_their_lines() {
    let mut count = 0;
    for (a, b, push) in [(60.0, 30.0, 0.0), (45.0, 20.0, 5.0), (70.0, 50.0, -10.0), (35.0, 15.0, 8.0)] {
        let text = format!(
            "ground {{ O (0, 0); U (-200 mm, 0); W (200 mm, 0); line floor through O along 0 deg; line left through U along 270 deg; line right through W along 90 deg }}\n\
             link w1 {{ U (0, 0); line down through U along 270 deg; line face through U along {a} deg }}\n\
             link w2 {{ O (0, 0); L (-100 mm, 50 mm); R (100 mm, 50 mm); line base through O along 0 deg; line f12 through L along {a} deg; line f23 through R along -{b} deg }}\n\
             link w3 {{ W (0, 0); line up through W along 90 deg; line face through W along -{b} deg }}\n\
             prismatic A: w1.down - ground.left\nprismatic B: w1.face - w2.f12\nprismatic C: w2.base - ground.floor\n\
             prismatic D: w3.face - w2.f23\nprismatic E: w3.up - ground.right\ndrive A = {push} mm\n\
             force on w1 at U = 1000 N @ 270 deg\nbalance force Q on w3 at W along 270 deg"
        );
        let sheet = scheme(&text);
        for (link, lines) in [("w1", vec![270.0, a]), ("w2", vec![0.0, a, -b]), ("w3", vec![90.0, -b])] {
            let corners = plate(&sheet, link).expect("a plate");
            let sides = (0..corners.len()).map(|i| corners[(i + 1) % corners.len()] - corners[i]);
            let sides: Vec<Vec2> = sides.filter_map(Vec2::unit).collect();
            for line in lines {
                // y of paper is down
                let along = Vec2::new(
                    libm::cos(line * std::f64::consts::PI / 180.0),
                    -libm::sin(line * std::f64::consts::PI / 180.0),
                );
                assert!(sides.iter().any(|s| s.cross(along).abs() < 1e-9), "{link} along {line}: {sides:?}");
                count += 1;
            }
        }
        // the first and the second wedge share a face
        let (first, second) = (plate(&sheet, "w1").expect("a plate"), plate(&sheet, "w2").expect("a plate"));
        let near = |p: &Vec2| {
            (0..second.len()).any(|i| {
                let (c, d) = (second[i], second[(i + 1) % second.len()]);
                (d - c).unit().is_some_and(|u| u.cross(*p - c).abs() < 1e-6)
            })
        };
        assert!(first.iter().filter(|p| near(p)).count() >= 2, "{first:?} {second:?}");
    }
    assert_eq!(count, 28);
}

#[test]
fn a_spring_is_beside_the_guide_of_its_rod() {
    let text = std::fs::read_to_string(
        std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/contacts/follower-leaves.mech"),
    );
    let (source, solved) = solved("follower-leaves.mech", &text.expect("an example")).expect("a solution");
    let sheet = sheets(&source, &solved, Kind::Scheme).remove(0);
    let xs = of(&sheet, "spring", "k").flat_map(|m| match &m.shape {
        Shape::Lines { points, .. } => points.clone(),
        _ => Vec::new(),
    });
    let xs: Vec<f64> = xs.map(|p| p.x).collect();
    let rod = of(&sheet, "pair", "V").find_map(|m| match m.shape {
        Shape::Line(a, _) if m.style == Style::Link => Some(a.x),
        _ => None,
    });
    let rod = rod.expect("a rod");
    assert!(!xs.is_empty() && xs.iter().all(|x| (x - rod).abs() > 3.0), "{rod}: {xs:?}");
}

#[test]
fn wheels_of_cranks_and_ends_of_cylinders_have_names() {
    let gears = "ground { A (0, 0); B (100 mm, 0) }\nlink a { A (0, 0); P (20 mm, 0); wheel z1 teeth 20 module 4 mm at A }\n\
                 link b { B (0, 0); Q (20 mm, 0); wheel z2 teeth 30 module 4 mm at B }\n\
                 revolute A: ground - a\nrevolute B: ground - b\nmesh m: z1 - z2\ndrive a = 30 deg at 1 rad/s";
    let sheet = scheme(gears);
    assert!(
        labels(&sheet).contains(&"z_1".to_owned()) && labels(&sheet).contains(&"z_2".to_owned()),
        "{:?}",
        labels(&sheet)
    );
    assert!(of(&sheet, "wheel", "z1").any(|m| m.style == Style::Medium));
    let boom = "ground { O (0, 0); G (0.6 m, -0.3 m) }\nlink boom { O (0, 0); K (2.2 m, 0.5 m) }\nrevolute O: ground - boom\n\
                cylinder c: ground.G - boom.K\ndrive c = 2.25 m at 0.1 m/s\nassemble K near (1.5 m, 1.7 m)";
    assert!(labels(&scheme(boom)).contains(&"G".to_owned()));
}
