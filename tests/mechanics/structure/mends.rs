//! The edits that a help offers for what is held too often or in the wrong place: each gives a text without an error of the structure.

use assur::internals::check::Overrides;
use assur::internals::diagnostic::Fix;
use assur::internals::source::Source;
use std::path::Path;

const BOTH_HALVES: &str = "ground { A (0, 0); D (3 m, 0); L (4 m, 4 m) }
link crank A-B 0.8 m
link coupler B-C 2.5 m { E (1 m, 1 m) }
link rocker D-C 2 m
link wheel L-N 1 m
revolute A: ground - crank
revolute B: crank - coupler
revolute C: coupler - rocker
revolute D: ground - rocker
revolute Z: coupler.E - rocker.D
revolute L: ground - wheel
drive crank = 40 deg
";

fn fixes(text: &str) -> Vec<Fix> {
    let source = Source::new("mends", text);
    let (_, problems) = assur::internals::compile(&source, &Overrides::none());
    let of_structure = ["unbalanced", "overconstrained"].map(|code| format!("mech::determinacy::{code}"));
    if of_structure.iter().any(|code| problems.has(code)) { problems.fixes() } else { Vec::new() }
}

fn is_sound(text: &str) -> bool {
    let (compiled, _) = assur::internals::compile(&Source::new("mended", text), &Overrides::none());
    compiled.is_some()
}

#[test]
fn every_edit_mends() {
    let tests = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests");
    let folders = ["errors/determinacy/unbalanced", "errors/determinacy/overconstrained", "cases/structure"];
    let (mut tried, mut certain) = (0, 0);
    for path in folders.iter().flat_map(|folder| std::fs::read_dir(tests.join(folder)).expect(folder)) {
        let path = path.expect("a file").path();
        if path.extension().is_none_or(|ext| ext != "mech") {
            continue;
        }
        let text = std::fs::read_to_string(&path).expect("text");
        for fix in fixes(&text) {
            let mended = fix.apply(&text);
            assert!(is_sound(&mended), "{}: {}\n{mended}", path.display(), fix.title);
            tried += 1;
            certain += usize::from(fix.certain);
        }
    }
    assert!(tried >= 15 && certain >= 3, "{tried} edits, {certain} of them certain");
}

#[test]
fn both_halves_are_one_edit() {
    let fixes = fixes(BOTH_HALVES);
    let [fix] = fixes.as_slice() else { panic!("{fixes:?}") };
    assert_eq!(fix.title, "leave out `revolute Z` and add `drive wheel = 45 deg`");
    assert!(!fix.certain && is_sound(&fix.apply(BOTH_HALVES)), "{}", fix.apply(BOTH_HALVES));
}

/// What a machine lacks, by the first words of its line, is offered so that the text solves with it.
#[test]
fn what_is_lost_solves_with_the_lines_offered() {
    let boom = |at: f64, under: f64, name: &str| {
        format!(
            "ground {{ A (0, 0); G ({at} m, {under} m) }}
link boom {{ A (0, 0); K (0.8 m, 0.1 m); E (2 m, 0.1 m) }}
revolute A: ground - boom
{name}
find position(boom.E)
"
        )
    };
    let hoist = |radius: f64, line: &str| {
        format!(
            "shaft I {{ wheel w1 radius 0.2 m; wheel w2 radius 0.5 m }}
shaft II {{ wheel w3 radius {radius} m; wheel w4 radius 0.3 m }}
slider A
slider B
rope a: A - w1
mesh k: w2 - w3
drive A at 2 m/s
{line}
"
        )
    };
    let mut texts = Vec::new();
    for i in 0..6 {
        let (at, under) = (0.3 + 0.2 * f64::from(i), -0.1 - 0.1 * f64::from(i));
        texts.push((boom(at, under, ""), "cylinder c: ground.G - boom.K"));
        texts.push((boom(at, under, "find positions"), "cylinder c: ground.G - boom.K"));
        texts.push((boom(at, under, "drive lift = 900 mm"), "cylinder lift: ground.G - boom.K"));
        texts.push((hoist(0.3 + 0.1 * at, "find velocity(B)"), "rope r: B - w4"));
        texts.push((hoist(0.3 + 0.1 * at, "find tension(b, B)\nforce Q on B = 1 kN"), "rope b: B - w4"));
    }
    for (text, line) in texts {
        let source = Source::new("lost", &text);
        let (_, problems) = assur::internals::compile(&source, &Overrides::none());
        let fixes = problems.fixes();
        let fix =
            fixes.iter().find(|fix| fix.title.contains(line)).unwrap_or_else(|| panic!("{line}: {fixes:?}"));
        let mended = fix.apply(&text);
        let solved = assur::solve(&mended);
        assert!(solved.is_ok(), "{mended}");
        assert_eq!(problems.errors(), 1, "{text}");
    }
}
