//! Free bodies: all that acts is there, under the letters of the worked solution.

use crate::drawn::{sheets, solved};
use assur::internals::drawing::{Shape, Sheet, Style};
use assur::internals::math::Vec2;
use assur::internals::picture::{Kind, Scene};
use assur::internals::source::Source;
use assur::internals::worked::{Language, text, worked};
use std::collections::BTreeSet;
use std::path::Path;

fn example(file: &str) -> (Source, assur::internals::Solved) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples").join(file);
    let text = std::fs::read_to_string(path).expect("an example");
    solved(file, &text).expect("a solution")
}

/// What is said of a free body: `R_23 632.66 N` → the name and the number.
fn said(sheet: &Sheet) -> Vec<(String, f64)> {
    let words: Vec<&str> = sheet.drawing.description.split(' ').map(|w| w.trim_end_matches(',')).collect();
    let number = |word: &str| word.replace('−', "-").parse::<f64>().ok();
    words.windows(2).filter_map(|two| Some((two[0].to_owned(), number(two[1])?))).collect()
}

/// `R_12` → `R_21`.
fn opposite(name: &str) -> String {
    let index = name.trim_start_matches("R_");
    match index.split_once(',') {
        Some((from, on)) => format!("R_{on},{from}"),
        None => format!("R_{}", index.chars().rev().collect::<String>()),
    }
}

#[test]
fn reactions_have_the_letters_of_the_worked_solution() {
    for file in [
        "friction/four-bar.mech",
        "contacts/geneva-turns.mech",
        "exercise-set/09-a-cylinder-lifts-a-boom.mech",
        "kinetostatics/six-bar.mech",
        "inertia/engine.mech",
    ] {
        let (source, solved) = example(file);
        let place = (source.name.as_str(), source.text.as_str());
        let scene = Scene::of(solved.compiled.model(), &solved.solution, place, None).expect("a position");
        let page = text(&worked(scene, Language::English, &[]).document);
        let ends = |rest: &str| rest.chars().next().is_none_or(|c| !c.is_alphanumeric() && c != ',');
        let mut names = BTreeSet::new();
        for sheet in sheets(&source, &solved, Kind::Forces) {
            let all = sheet.drawing.description.split([' ', ':']).filter(|word| word.starts_with("R_"));
            names.extend(all.map(str::to_owned));
        }
        assert!(!names.is_empty(), "{file}");
        let is_on_page = |name: &str| {
            page.match_indices(name).any(|(at, _)| {
                let rest = &page[at + name.len()..];
                ends(rest) || rest.starts_with(['x', 'y']) || rest.starts_with(",x") || rest.starts_with(",y")
            })
        };
        for name in names {
            // the page derives one of the two forces in a pair
            assert!(is_on_page(&name) || is_on_page(&opposite(&name)), "{file}: {name}");
        }
    }
}

/// A link with friction in both hinges: forces at the hinges and all couples add up to no moment.
#[test]
fn friction_couples_leave_no_moment() {
    let (source, solved) = example("friction/four-bar.mech");
    let sheets = sheets(&source, &solved, Kind::Forces);
    let own = |sheet: &&Sheet| sheet.drawing.description.starts_with("Forces on links 3:");
    let sheet = sheets.iter().find(own).expect("link 3 alone");
    let said = said(sheet);
    let value = |name: &str| said.iter().find(|s| s.0 == name).map(|s| s.1);
    let couples = ["M_3", "M_fC", "M_fD"].map(|name| value(name).expect(name));
    // 0.004 m/mm
    let moments = sheet.drawing.marks.iter().filter_map(|mark| {
        let Shape::Arrow(from, to) = mark.shape else { return None };
        let name = &sheet.drawing.groups[mark.group].name;
        let along: Vec2 = (to - from) / (to - from).norm();
        (mark.style != Style::Drive).then(|| -0.004 * from.cross(along) * value(name).expect(name))
    });
    let moments: Vec<f64> = moments.collect();
    assert_eq!(moments.len(), 2);
    let sum: f64 = moments.iter().sum::<f64>() + couples.iter().sum::<f64>();
    let largest = couples.iter().fold(0.0_f64, |most, m| most.max(m.abs()));
    assert!(sum.abs() < 2e-3 * largest, "{moments:?} {couples:?}");
}

/// The marks of the groups of a class and a name.
fn marks<'s>(sheet: &'s Sheet, class: &'s str, name: &'s str) -> impl Iterator<Item = &'s Shape> {
    let drawing = &sheet.drawing;
    let own = move |group: usize| drawing.groups[group].class == class && drawing.groups[group].name == name;
    drawing.marks.iter().filter(move |mark| own(mark.group)).map(|mark| &mark.shape)
}

/// What a lever says of a term.
fn power(sheet: &Sheet, name: &str) -> Option<f64> {
    let (_, terms) = sheet.drawing.description.split_once("Moments about the pole")?;
    let (_, rest) = terms.split_once(&format!(" {name} "))?;
    rest.split([',', ' ']).next()?.trim_end_matches('.').replace('−', "-").parse().ok()
}

#[test]
fn levers_have_friction_and_cylinders() {
    let (source, solved) = example("friction/six-bar.mech");
    let lever = sheets(&source, &solved, Kind::Lever).remove(0);
    // F_b = 747.59 N at 1.2 m/s under 60°
    let balance = power(&lever, "F_b").expect("the balance");
    let force: f64 = 747.5923987641834;
    assert!((balance - force * 1.2 * libm::sin(60.0_f64.to_radians())).abs() < 0.01, "{balance}");
    // a pair loses the power of its friction on both of its links, and has a couple on each that moves
    let place = (source.name.as_str(), source.text.as_str());
    let scene = Scene::of(solved.compiled.model(), &solved.solution, place, None).expect("a position");
    let lost = scene.view().pair_frictions();
    let name = |pair| &scene.mechanism().pair(pair).name;
    for (pair, ends) in [("A", 1), ("B", 2), ("C", 2), ("D", 1), ("E", 2), ("F", 1), ("H", 1)] {
        let lost: f64 = lost.iter().filter(|one| name(one.pair) == pair).map(|one| one.power).sum();
        let (term, arrow) = match pair {
            "H" => ("F_fH".to_owned(), "F_fH".to_owned()),
            _ => (format!("M_f{pair}"), format!("F_Mf{pair}")),
        };
        let told = power(&lever, &term).unwrap_or_else(|| panic!("{term}"));
        assert!((told + lost).abs() < 5e-5 * lost, "{term}: {told} for {lost} W");
        assert_eq!(marks(&lever, "vector", &arrow).count(), ends, "{arrow}");
    }
    for (source, solved) in [example("drives/excavator.mech"), case("digger.mech")] {
        let lever = sheets(&source, &solved, Kind::Lever).remove(0);
        // on what a cylinder moves, and on both of its ends where these move
        for (name, ends) in [("F_1", 2), ("F_2", 2)] {
            assert_eq!(marks(&lever, "vector", name).count(), ends, "{}: {name}", source.name);
        }
    }
}

fn case(file: &str) -> (Source, assur::internals::Solved) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cases/use3/pictures").join(file);
    let text = std::fs::read_to_string(path).expect("a case");
    solved(file, &text).expect("a solution")
}

#[test]
fn pins_of_cylinders_have_their_letters() {
    for (source, solved) in [example("drives/excavator.mech"), case("digger.mech")] {
        let sheets = sheets(&source, &solved, Kind::Forces);
        let freed: Vec<&Sheet> =
            sheets.iter().filter(|sheet| sheet.drawing.id.contains("free-body")).collect();
        for letter in ["K_1", "K_2", "K_3"] {
            let has = |sheet: &&&Sheet| sheet.placed.iter().any(|placed| placed.label.text.plain() == letter);
            assert!(freed.iter().filter(has).count() == 1, "{}: {letter}", source.name);
        }
        for pair in ["c1", "c2"] {
            let is_hinge = |shape: &&Shape| matches!(shape, Shape::Circle { .. });
            let hinges: usize =
                freed.iter().map(|sheet| marks(sheet, "pair", pair).filter(is_hinge).count()).sum();
            assert_eq!(hinges, if pair == "c1" { 1 } else { 2 }, "{}: {pair}", source.name);
        }
    }
}

#[test]
fn teeth_press_without_a_couple_and_wheels_are_drawn() {
    for (file, wheels) in [
        ("trains/geared-five-bar.mech", ["z1", "z2"]),
        ("trains/gears-on-bearings.mech", ["z1", "z2"]),
        ("trains/sun-drives-the-piston.mech", ["s", "planet"]),
    ] {
        let (source, solved) = example(file);
        let sheets = sheets(&source, &solved, Kind::Forces);
        for wheel in wheels {
            let circles = sheets.iter().flat_map(|sheet| marks(sheet, "wheel", wheel));
            assert_eq!(circles.count(), 1, "{file}: {wheel}");
        }
        let couples = |sheet: &Sheet| sheet.drawing.groups.iter().filter(|g| g.class == "couple").count();
        // that of the load and that of the drive or the balance
        assert!(sheets.iter().map(couples).sum::<usize>() <= 2, "{file}");
    }
}

#[test]
fn a_rack_touches_its_wheel() {
    let (source, solved) = example("trains/rack-and-pinion.mech");
    let sheet = sheets(&source, &solved, Kind::Train).remove(0);
    let wheel = marks(&sheet, "wheel", "z1").find_map(|shape| match shape {
        Shape::Circle { centre, radius } => Some((*centre, *radius)),
        _ => None,
    });
    let (centre, radius) = wheel.expect("the pitch circle");
    let line = marks(&sheet, "pair", "r").find_map(|shape| match shape {
        Shape::Line(a, b) => Some((*a, *b)),
        _ => None,
    });
    let (a, b) = line.expect("the pitch line");
    let away = ((b - a) / (b - a).norm()).cross(centre - a);
    assert!((away.abs() - radius).abs() < 1e-9, "{away} {radius}");
    // y of paper points down: the rack is below
    assert!(a.y > centre.y && (a.y - b.y).abs() < 1e-9);
}

#[test]
fn a_rod_slides_through_its_guide() {
    let (source, solved) = example("slotted/second-kind.mech");
    let sheet = sheets(&source, &solved, Kind::Scheme).remove(0);
    let drawing = &sheet.drawing;
    let blocks = drawing.marks.iter().filter(|mark| mark.style == Style::Block);
    let middles: Vec<Vec2> = blocks.map(|mark| mark.shape.bounds().centre()).collect();
    let hinge = |name: &str| {
        let circle = marks(&sheet, "pair", name).find_map(|shape| match shape {
            Shape::Circle { centre, .. } => Some(*centre),
            _ => None,
        });
        circle.expect("a hinge")
    };
    assert_eq!(middles.len(), 1);
    // B is 15 mm from A at 4 m per 1000 mm
    assert!((middles[0] - hinge("A")).norm() < 5.0 && (middles[0] - hinge("C")).norm() > 50.0);
}
