//! Every formula in LaTeX parses, read by a parser that is not of this repository.

use crate::examples::{Example, examples};
use crate::made::solved;
use crate::reader::{Read, mathml};
use assur::internals::handout::document;
use assur::internals::model::FindKind;
use assur::internals::picture::Scene;
use assur::internals::syntax::parse;
use assur::internals::worked::{Block, Inline, Language, Table, html, markdown, worked};
use pulldown_latex::{Parser, Storage};

/// The formulas of a text in Markdown, between dollars; escaped dollars are text.
fn formulas(text: &str) -> Vec<String> {
    let text = text.replace("\\$", "").replace("$$", "$");
    text.split('$').skip(1).step_by(2).filter(|f| !f.is_empty()).map(str::to_owned).collect()
}

/// What a parser has against a formula.
fn fault(formula: &str) -> Option<String> {
    let storage = Storage::new();
    let parsed = Parser::new(formula, &storage).find_map(Result::err).map(|error| error.to_string());
    parsed.or_else(|| double_script(formula))
}

/// A raised sign behind an index, of a letter that is primed already: an error in TeX, which the parser lets pass.
fn double_script(formula: &str) -> Option<String> {
    let is_primed = |at: usize| formula[..at].ends_with('\'') && formula[at..].starts_with("_{");
    let places = formula.match_indices("_{").map(|m| m.0).filter(|at| is_primed(*at));
    let behind = |at: usize| {
        let mut depth = 0_usize;
        let end = formula[at + 1..].find(|c| {
            depth = if c == '{' { depth + 1 } else { depth - usize::from(c == '}') };
            depth == 0
        });
        end.is_some_and(|end| formula[at + 1 + end + 1..].starts_with('^'))
    };
    places.into_iter().find(|at| behind(*at)).map(|at| format!("two raised signs at {at}"))
}

#[test]
fn every_formula_in_latex_parses() {
    assert!(fault("a'_{1}^{2}").is_some() && fault("\\frac{1}{").is_some() && fault("\\nosuch{1}").is_some());
    let (mut wrong, mut count) = (Vec::new(), 0);
    for Example { name, solved, .. } in examples() {
        let Some((source, solved)) = solved else { continue };
        let file = (source.name.as_str(), source.text.as_str());
        let Ok(scene) = Scene::of(solved.compiled.model(), &solved.solution, file, None) else { continue };
        for language in [Language::English, Language::Russian] {
            let (text, _) = markdown(&worked(scene, language, &[]).document, "x");
            for formula in formulas(&text) {
                count += 1;
                wrong.extend(fault(&formula).map(|fault| format!("{name}: {formula}\n{fault}")));
            }
        }
    }
    println!("{count} formulas");
    assert!(count > 30_000, "{count}");
    assert!(wrong.is_empty(), "{} of {count}: {:#?}", wrong.len(), &wrong[..wrong.len().min(20)]);
}

#[test]
fn what_a_file_asks_for_by_formulas_is_derived_and_balances() {
    let (mut wrong, mut derived) = (Vec::new(), 0);
    for Example { name, text, solved } in examples() {
        let Some((source, solved)) = solved else { continue };
        let (read, _) = parse(source);
        let Ok(page) = document(source, &read, solved, Language::English, (None, &[])) else { continue };
        let page = html(&page);
        derived += usize::from(page.contains("own formulas with these results"));
        for infix in mathml::equations(&page) {
            if let Ok(equation) = Read::of(&infix)
                && let Err(fault) = equation.judge()
                && !equation.approximate
            {
                wrong.push(format!("{name}: {fault:?}"));
            }
        }
        if name == "friction/jib-crane.mech" {
            assert!(text.contains("find M = M_A + M_B + M_T") && page.contains("own formulas"), "{page}");
        }
    }
    assert!(wrong.is_empty() && derived > 0, "{derived} {wrong:#?}");
}

/// Questions of a whole run or a whole cycle, whatever the position that is shown.
const OF_RUNS: [&str; 4] = ["time", "count", "work", "friction_work"];

/// The table of results.
fn results(blocks: &[Block]) -> Option<&Table> {
    // that of a motion comes after its extremes
    let mut tables = blocks.iter().rev().filter_map(|b| if let Block::Table(t) = b { Some(t) } else { None });
    tables.find(|table| table.headers.first().is_some_and(|h| words(h) == "Quantity"))
}

/// The words with which a cell begins.
fn words(line: &[Inline]) -> &str {
    if let Some(Inline::Text(words)) = line.first() { words } else { "" }
}

#[test]
fn answers_have_the_letters_of_their_steps() {
    let (mut without, mut with) = (Vec::new(), 0);
    for Example { name, solved, .. } in examples() {
        let Some((source, solved)) = solved else { continue };
        let (read, _) = parse(source);
        let Ok(page) = document(source, &read, solved, Language::English, (None, &[])) else { continue };
        let Some(table) = results(&page.blocks) else { continue };
        let lettered = table.headers.len() == 4;
        let finds = &solved.compiled.mechanism.finds;
        let asked = finds.iter().filter(|find| matches!(find.kind, FindKind::Value { .. }));
        // the questions come first, in their order, then all reactions
        for (find, row) in asked.zip(&table.rows) {
            let asked = &find.name;
            let has = lettered && !row[1].is_empty();
            with += usize::from(has);
            let of_position = matches!(find.kind, FindKind::Value { poseless: false, .. });
            let of_run = OF_RUNS.iter().any(|word| asked.starts_with(&format!("{word}(")));
            let value = words(&row[row.len() - 2]);
            let is_truth = ["true", "false"].contains(&value);
            if of_position && !of_run && !has && !is_truth && value != "0" && !value.starts_with("(0, 0)") {
                without.push(format!("{name}: {asked}"));
            }
        }
    }
    println!("{with} answers with letters");
    assert!(with > 700, "{with}");
    assert_eq!(without, Vec::<String>::new());
}

/// A slotted bar with loads by expressions, and a cam with friction, asked for by functions of all kinds.
const ASKED: [&str; 2] = [
    r#"mech 1
mechanism "Requests"
gravity 9.81 m/s^2
ground { A (0, 0); C (0, 300 mm) }
link crank A-B 100 mm { S (30 mm, 0); mass 1 kg at S; inertia 0.01 kg*m^2 }
link bar { C (0, 0); line slot through C along 0 deg; T (400 mm, 0); mass 2 kg at T; inertia 0.02 kg*m^2 }
link block { B (0, 0) }
revolute A: ground - crank
revolute C: ground - bar
revolute B: crank - block
prismatic s: block.B - bar.slot
assemble s > 0 mm
drive crank = 40 deg at 60 rpm
torque L on bar = 2 N*m*sin(angle(bar)) + 0.5 N*m*s*omega(bar)
force F on bar at T = (10 N, -5 N*cos(angle(crank)))
balance torque M on crank
find coriolis(s), distance(B, C), instant_centre(bar, crank), energy(), power(L), power(F), power(M), omega(bar), mag(reaction(C)), dir(reaction(A, crank)), relative_velocity(s)
find kinetic_energy(), potential_energy(), mag(velocity(T)), dir(velocity(T)), mag(acceleration(T))
"#,
    r#"mech 1
mechanism "Slip"
ground { A (0, 0); line way through A along 90 deg; G (0, 100 mm) }
link cam { A (0, 0); K (15 mm, 0); circle rim centre K radius 40 mm }
link tappet { P (0, 0); line face through P along 90 deg; mass 1 kg at P }
revolute A: ground - cam
prismatic G: tappet.P - ground.way
contact K: cam.rim - tappet.face { friction 0.1 }
gravity 9.81 m/s^2
assemble tappet.P near (0 mm, 100 mm)
drive cam = 40 deg at 120 rpm
balance torque M on cam
find slip_speed(K), pressure_angle(K), mag(reaction(K)), reaction(K, tappet), normal(K, tappet), friction(K, tappet), power(M), displacement(G), relative_acceleration(G)
"#,
];

#[test]
fn questions_by_functions_are_derived() {
    for text in ASKED {
        let (source, solved) = solved("asked", text).expect("solved");
        let (read, _) = parse(&source);
        let page = document(&source, &read, &solved, Language::English, (None, &[])).expect("a page");
        let written = html(&page);
        for infix in mathml::equations(&written) {
            if let Ok(equation) = Read::of(&infix) {
                assert!(equation.approximate || equation.judge().is_ok(), "{infix}");
            }
        }
        let table = results(&page.blocks).expect("results");
        let bare = table.rows.iter().filter(|row| row[1].is_empty() && words(&row[2]) != "0");
        let bare: Vec<&str> = bare.map(|row| words(&row[0])).collect();
        assert_eq!(bare, Vec::<&str>::new());
    }
}

/// A couple in the table of results has the sign of its letter in the steps.
#[test]
fn couples_have_the_signs_of_their_steps() {
    let number = |word: &str| word.replace('−', "-").parse::<f64>().ok();
    let mut count = 0;
    for file in [
        "shaper/shaper-a",
        "dyads/rpr",
        "welds/bent-pendulum",
        "welds/clamped-beam-with-post",
        "kinetostatics/six-bar",
        "crank-slider",
    ] {
        let path = format!("{}/examples/{file}.mech", env!("CARGO_MANIFEST_DIR"));
        let out = std::process::Command::new(env!("CARGO_BIN_EXE_assur")).args(["report", &path]).output();
        let page = String::from_utf8(out.expect("the program runs").stdout).expect("text");
        for row in page.lines().filter(|line| line.trim_start().starts_with("couple in ")) {
            let words: Vec<&str> = row.split_whitespace().collect();
            let [.., letter, value, unit] = words.as_slice() else { continue };
            let size = if *unit == "kN·m" { 1e3 } else { 1.0 };
            let Some(value) = number(value).filter(|_| letter.contains("M_")) else { continue };
            let value = size * value;
            let (sign, name) = letter.strip_prefix('−').map_or((1.0, *letter), |name| (-1.0, name));
            let begin = format!("    {name} = ");
            let step = page.lines().skip_while(|line| !line.starts_with(&begin));
            let right = step.map(|line| line.rsplit(" = ").next().unwrap_or_default());
            let found = right
                .filter(|right| right.ends_with("N·m"))
                .find_map(|right| number(right.split(' ').next()?));
            let found = found.unwrap_or_else(|| panic!("{file}: no step of {name}"));
            assert!(
                (sign * found - value).abs() <= 0.02 * value.abs(),
                "{file}: {row}, and {name} = {found}"
            );
            count += 1;
        }
    }
    assert!(count >= 2, "{count} couples");
}
