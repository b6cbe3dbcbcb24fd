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
