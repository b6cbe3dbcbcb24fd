//! Every example.

use crate::made::{Tally, of_position, of_solved, solved};
use crate::reader::{Read, mathml};
use assur::internals::Solved;
use assur::internals::model::FindKind;
use assur::internals::source::Source;
use assur::internals::worked::{Block, Document, Inline, Language, Worked, design, html, question};
use std::path::Path;
use std::sync::OnceLock;

/// An example with its solution; none where it has errors.
pub struct Example {
    pub name: String,
    pub text: String,
    pub solved: Option<(Source, Solved)>,
}

/// All of them, solved once for all tests.
pub fn examples() -> &'static [Example] {
    static ALL: OnceLock<Vec<Example>> = OnceLock::new();
    ALL.get_or_init(|| {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
        let files = crate::folder::files(&root, "mech").into_iter();
        let texts = files.map(|path| {
            let name = path.strip_prefix(&root).unwrap_or(&path).display().to_string();
            let text = std::fs::read_to_string(&path).expect("an example");
            let solved = solved(&name, &text);
            Example { name, text, solved }
        });
        texts.collect()
    })
}

#[test]
fn every_printed_equation_balances() {
    let mut tally = Tally::default();
    for Example { name, solved, .. } in examples() {
        let Some((source, solved)) = solved else { continue };
        if let Some((made, condition)) = of_solved(source, solved) {
            tally.judge(name, &made, condition);
        }
    }
    tally.finish();
    assert!(tally.solutions > 190 && tally.equations > 5000, "{tally:?}");
}

#[test]
fn other_positions_balance_too() {
    let mut tally = Tally::default();
    let mut alone = std::collections::BTreeSet::new();
    for Example { name, solved, .. } in examples() {
        let Some((source, solved)) = solved else { continue };
        let poses = &solved.solution.poses;
        for part in [1, 2, 3].into_iter().filter(|_| poses.len() > 3) {
            let pose = &poses[poses.len() * part / 4].name;
            if let Some((made, condition)) = of_position(source, solved, Some(pose)) {
                alone.extend(without_step(&made).map(|letters| format!("{name}: {letters} at {pose}")));
                tally.judge(&format!("{name} at {pose}"), &made, condition);
            }
        }
    }
    tally.finish();
    assert!(alone.is_empty(), "{alone:#?}");
    // of the sled two reactions are determined beside what friction and its stop share: they have no step of their own
    assert!(tally.solutions > 150 && tally.reactions[1] <= 2 && tally.loads[1] == 0, "{tally:?}");
}

#[test]
fn what_needs_no_position_balances_too() {
    let mut tally = Tally::default();
    for Example { name, solved, .. } in examples() {
        let Some((_, solved)) = solved else { continue };
        let page = design(solved.compiled.model(), &solved.solution, Language::English);
        if page.blocks.is_empty() {
            continue;
        }
        let document = Document { blocks: page.blocks, ..Document::default() };
        let equations = page.equations.into_iter().map(|(_, equation)| equation).collect();
        let disagreements = page.disagreements;
        tally.judge(name, &Worked { document, equations, disagreements, ..Worked::default() }, 1.0);
    }
    tally.finish();
    assert!(tally.solutions > 20 && tally.equations > 300, "{tally:?}");
}

#[test]
fn every_law_of_a_cam_has_its_formula() {
    let stages = ["poly4567", "modified_sine", "modified_trapezoid", "cycloidal", "harmonic", "parabolic"];
    let stages = stages.iter().enumerate().map(|(i, law)| match i % 2 {
        0 => format!("rise 60 deg through 20 mm {law}; "),
        _ => format!("fall 60 deg {law}; "),
    });
    let cam = "cam plate { base_radius 50 mm; follower translating roller { radius 10 mm }; turning ccw; ";
    let text = format!("mech 1\nmechanism \"Laws\"\n{cam}{}}}\n", stages.collect::<String>());
    let (_, solved) = solved("laws", &text).expect("solved");
    let page = design(solved.compiled.model(), &solved.solution, Language::English);
    assert_eq!(page.disagreements, Vec::<String>::new());
    // s and s′ of every formula of every law, apart from those where the cam is extreme
    let letters = page.equations.iter().filter(|(_, e)| e.left.name.letter.starts_with('s'));
    assert_eq!(
        letters.filter(|(_, e)| !e.left.name.sub.contains(['α', 'ρ'])).count(),
        2 * (1 + 2 + 3 + 1 + 1 + 2)
    );
}

#[test]
fn every_group_and_every_load_has_its_steps() {
    let (mut wrong, mut stated, mut alone) = (Vec::new(), Vec::new(), Vec::new());
    for Example { name, solved, .. } in examples() {
        let Some((source, solved)) = solved else { continue };
        let Some((made, _)) = of_solved(source, solved) else { continue };
        let (model, counts) = (solved.compiled.model(), made.counts);
        let groups = model.structure.motion.iter().filter(|g| !g.bodies.is_empty()).count();
        if counts.motion.iter().sum::<usize>() != groups {
            wrong.push(format!("{name}: {:?} of {groups} groups of motion", counts.motion));
        }
        let locked = solved.solution.poses.iter().filter_map(|p| p.outcome.as_ref().ok());
        let locked = locked.take(1).any(|s| s.state.forces.locked);
        let forces = if model.plan.has_forces() && !locked { model.plan.forces.len() } else { 0 };
        if counts.forces.iter().sum::<usize>() + counts.held != forces {
            wrong.push(format!("{name}: {:?} of {forces} groups of forces", counts.forces));
        }
        stated.extend(
            [
                ("group of motion", counts.motion[1]),
                ("group of forces", counts.forces[1]),
                ("reaction", counts.reactions[1]),
                ("resultant of loads", counts.loads[1]),
            ]
            .into_iter()
            .filter(|(_, n)| *n > 0)
            .map(|(what, n)| format!("{name}: {what} × {n}")),
        );
        alone.extend(without_step(&made).map(|letters| format!("{name}: {letters}")));
        wrong.extend(without_result(name, (source, solved), &made));
    }
    println!("stated and not derived: {stated:#?}");
    assert!(wrong.is_empty(), "{wrong:#?}");
    assert!(stated.is_empty(), "{stated:#?}");
    assert_eq!(alone, Vec::<String>::new());
}

/// Values on the page that no equation gives, but those that are of a whole run, or of a unit rate of one free coordinate, and jerks,
/// which the page states as solved.
fn without_step(made: &Worked) -> impl Iterator<Item = String> {
    made.stated.iter().map(|name| (name, format!("{}{}", name.letter, name.sub))).filter_map(
        move |(name, plain)| {
            let of_run = ["T1", "T2", "W", "Wt", "αr", "ar"].contains(&&*plain) || name.letter == "k";
            let is_jerk = matches!(name.letter.as_str(), "ζ" | "j");
            let kept = !of_run && !is_jerk;
            kept.then(|| format!("{}_{}", name.letter, name.sub))
        },
    )
}

/// Requests and reactions that the table of results does not have.
fn without_result(name: &str, (source, solved): (&Source, &Solved), made: &Worked) -> Vec<String> {
    let mechanism = &solved.compiled.mechanism;
    let tables = made.document.blocks.iter().filter_map(|block| match block {
        Block::Table(table) => Some(table),
        _ => None,
    });
    let named: Vec<&Vec<Inline>> = tables.flat_map(|t| t.rows.iter().filter_map(|row| row.first())).collect();
    let values =
        mechanism.finds.iter().filter(|find| matches!(&find.kind, FindKind::Value { poseless: false, .. }));
    let missing =
        values.filter(|find| !named.contains(&&question(mechanism, &source.text, find, Language::English)));
    missing.map(|find| format!("{name}: no result of {}", find.name)).collect()
}

#[test]
fn a_changed_digit_is_caught() {
    let text = std::fs::read_to_string("examples/kinetostatics/six-bar.mech").expect("the example");
    let (source, solved) = solved("six-bar", &text).expect("solved");
    let page = html(&of_solved(&source, &solved).expect("a solution").0.document);
    let (mut changed, mut caught) = (0, 0);
    for infix in mathml::equations(&page) {
        let Ok(read) = Read::of(&infix) else { continue };
        for side in &read.sides {
            let places: Vec<usize> = side.match_indices(|c: char| c.is_ascii_digit()).map(|m| m.0).collect();
            // the first digits of every number that is not a power
            for at in places {
                let before = side[..at].chars().next_back().unwrap_or(' ');
                let starts = !(before.is_ascii_digit() || before == '.' || side[..at].ends_with("^("));
                if !starts {
                    continue;
                }
                let digit = side.as_bytes()[at] - b'0';
                let other = char::from(b'0' + (digit + 3) % 10);
                let mutated = format!("{}{other}{}", &side[..at], &side[at + 1..]);
                changed += 1;
                let mutated = Read { sides: vec![mutated], ..read.clone() };
                caught += usize::from(mutated.judge().is_err());
            }
        }
    }
    println!("{caught} of {changed}");
    assert!(changed > 100 && 100 * caught >= 95 * changed, "{caught} of {changed}");
}
