//! Single mistakes in otherwise good files: one cause gives one message, which leads to the fix, and a fix that is offered
//! works when it is pasted.

use assur::check::Overrides;
use assur::diagnostic::{DiagnosticView, Problems};
use assur::exercise::table::{Lines, Table, TableError};
use assur::source::Source;
use std::path::{Path, PathBuf};

fn cases() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cases")
}

fn errors(problems: &Problems, source: &Source) -> Vec<DiagnosticView> {
    problems.views(source).into_iter().filter(|d| d.severity == "error").collect()
}

/// The errors of a text.
fn checked(text: &str) -> Vec<DiagnosticView> {
    let source = Source::new("text.mech", text);
    errors(&assur::check_source(&source, &Overrides::none()).1, &source)
}

/// The errors of reading a text.
fn read(text: &str) -> Vec<DiagnosticView> {
    let source = Source::new("text.mech", text);
    errors(&assur::syntax::parse(&source).1, &source)
}

/// The texts that a help offers to paste: lines behind `write:` or `write one of`, which replace the line of the mistake,
/// and words in backticks behind `write`, which replace what is marked.
fn pasted(text: &str, problem: &DiagnosticView) -> Vec<String> {
    let (Some(help), Some(at)) = (&problem.help, problem.spans.first()) else { return Vec::new() };
    let line_start = text[..at.start.byte].rfind('\n').map_or(0, |i| i + 1);
    let with_lines = |new: &str| {
        let count = new.lines().count().max(1);
        let end =
            text[line_start..].match_indices('\n').nth(count - 1).map_or(text.len(), |(i, _)| line_start + i);
        format!("{}{new}{}", &text[..line_start], &text[end..])
    };
    if let Some(lines) = help.strip_prefix("write: ") {
        return vec![with_lines(lines.split("\nand so for ").next().unwrap_or(lines))];
    }
    if let Some(lines) = help.strip_prefix("write one of\n") {
        return lines.lines().map(|line| with_lines(line.trim())).collect();
    }
    let words = words(help).unwrap_or_default();
    let replaced = |new: &&str| {
        let name = new.split(" = ").next().unwrap_or_default();
        let defined = new.contains(" = ").then(|| text[line_start..].find(name)).flatten();
        let start = defined.map_or(at.start.byte, |i| line_start + i);
        format!("{}{new}{}", &text[..start], &text[at.end.byte..])
    };
    words.iter().map(replaced).collect()
}

/// `` write `a` or `b` ``, up to the end or a colon
fn words(help: &str) -> Option<Vec<&str>> {
    let mut rest = help.strip_prefix("write ")?;
    let mut words = Vec::new();
    loop {
        let (word, behind) = rest.strip_prefix('`')?.split_once('`')?;
        words.push(word);
        match behind.strip_prefix(" or ") {
            Some(more) => rest = more,
            None if behind.is_empty() || behind.starts_with(": ") => return Some(words),
            None => return None,
        }
    }
}

/// How many errors remain where a fix lays open what it hid: a name used again, a point that is missing.
fn revealed(name: &str) -> usize {
    usize::from(["let_at", "f3"].contains(&name))
}

/// The files with the number of errors, the code of the first, and what its message or help says.
const CASES: &[(&str, usize, &str, &[&str])] = &[
    ("messages/name-with-hyphen", 1, "syntax::other_word", &["write: link 1 left_arm  A-B 900 mm"]),
    ("messages/name-with-space", 1, "syntax::other_word", &["write: link 3 right_arm D-C 950 mm"]),
    ("messages/column-without-unit", 1, "unit::missing", &["write `P [kN]`"]),
    ("messages/column-in-capitals", 1, "name::wrong_kind", &["write `r`"]),
    ("messages/008-typo-unit", 1, "unit::unknown", &["write `mm`"]),
    ("messages/016-hinge-for-revolute", 1, "syntax::misspelt_word", &["write: revolute A: ground - crank"]),
    (
        "messages/017-slider-keyword",
        1,
        "syntax::misspelt_word",
        &["write: prismatic D: piston.C - ground.guide"],
    ),
    ("messages/025-comment-hash", 1, "syntax::comment_sign", &["write: gravity 9.81 m/s^2  // down"]),
    ("messages/026-comment-c", 1, "syntax::comment_sign", &["write: gravity 9.81 m/s^2  // weight"]),
    (
        "messages/027-semicolon-missing",
        1,
        "syntax::two_statements",
        &["S2 (60 mm, 15 mm); mass 1.2 kg at S2;"],
    ),
    ("messages/035-square-brackets", 1, "syntax::other_word", &["{ E (l_DE, 0) }"]),
    ("messages/038-missing-unit-force", 1, "unit::missing", &["write `given P5 = 1000 N`"]),
    ("messages/047-grad", 1, "unit::unknown", &["write `deg` or `gon`"]),
    ("messages/050-inertia-unit", 1, "unit::unknown", &["write `kg*m^2`"]),
    ("messages/053-speed-deg-s", 1, "unit::hertz", &["write `60 rpm` or `1 rad/s`"]),
    ("messages/065-cyrillic-A", 1, "name::look_alike", &["write `A`", "Cyrillic here"]),
    ("messages/074-zwsp", 1, "syntax::invisible_character", &["write: link 1 crank A-B r"]),
    (
        "messages/077-ru-decimal-and-semicolon",
        1,
        "syntax::decimal_comma",
        &["write: ground { A (0, 0); D (120.5 mm, 10.0 mm) }"],
    ),
    ("messages/106-friction-no-radius", 1, "geometry::incomplete", &["radius 20 mm"]),
    ("messages/153-flywheel-unit", 1, "unit::mismatch", &["write `1/60`"]),
    (
        "messages/157-find-semicolon",
        1,
        "syntax::unknown_statement",
        &["write: find angle(rocker) as deg, omega(rocker), alpha(rocker), Mb, reactions"],
    ),
    ("messages/163-implicit-mult", 1, "unit::unknown", &["write `0.5*l_BC`"]),
    ("messages/173-point-no-coords", 1, "syntax::point_without_coordinates", &["coordinates", "D ("]),
    ("messages/186-german-u", 1, "unit::unknown", &["write `rpm`"]),
    ("messages/mesh-intern", 1, "geometry::unknown_property", &["`internal`"]),
    ("messages/per-min", 1, "unit::hertz", &["write `1500 rpm` or `25 rad/s`"]),
    ("messages/t0", 3, "unit::missing", &["write `given l = 350 mm`"]),
    ("messages/t5", 3, "syntax::misspelt_word", &["wheel p teeth zp"]),
    ("messages/t9", 3, "unit::missing", &["write `90 deg`"]),
    ("spellings/at", 1, "syntax::reserved_name", &["write: find at_1 = alpha(rod)"]),
    ("spellings/in", 1, "syntax::reserved_name", &["write: find in_1 = alpha(rod)"]),
    ("spellings/let_at", 1, "syntax::reserved_name", &["write: let at_1 = 3"]),
    ("spellings/f1", 1, "syntax::other_word", &["60 N*m cw"]),
    ("spellings/f3", 1, "syntax::other_word", &["100 N @ 270 deg"]),
    ("spellings/f5", 1, "unit::unknown", &["write `N*m`"]),
    ("spellings/f8", 1, "unit::missing", &["write `270 deg`"]),
    ("spellings/f13", 1, "unit::unknown", &["write `N*m`"]),
    ("spellings/f14", 1, "syntax::other_word", &["force F on crank at B = 5 kN @ 0 deg"]),
    ("spellings/f16", 1, "syntax::missing_word", &["expect Mb = 80 deg at crank = 60 deg"]),
    ("spellings/f18", 1, "syntax::other_word", &["find position(C) - position(D)"]),
    ("spellings/f9", 1, "syntax::misplaced_member", &["link coupler B-C 400 mm { mass 3 kg at"]),
    ("spellings/grav", 1, "syntax::unexpected", &["write: gravity 9.81 m/s^2"]),
    ("spellings/plot", 1, "syntax::other_word", &["0 deg .. 360 deg in 36 steps at 1500 rpm"]),
    ("spellings/plot2", 1, "syntax::unknown_statement", &["nothing is drawn", "find velocity(C).x"]),
    ("spellings/res", 1, "syntax::other_word", &["3 kN @ 180 deg"]),
    ("spellings/rpmless", 1, "unit::missing", &["write `45 deg`"]),
    ("spellings/tf", 1, "geometry::unknown_property", &["`efficiency`"]),
    ("spellings/two3", 1, "syntax::needless_sign", &["write: balance force F in c1"]),
    ("spellings/v5", 1, "unit::mismatch", &["write `m/s^2`"]),
    ("spellings/v15", 1, "syntax::other_word", &["find displacement(D) as mm"]),
    ("spellings/v16", 1, "unit::missing", &["write `-13.4 m/s`"]),
    ("spellings/v17", 1, "syntax::other_word", &["-13.4 m/s within 1%"]),
    ("spellings/v18", 1, "syntax::other_word", &["expect velocity(C).x = -13.4 m/s"]),
    ("spellings/v22", 1, "syntax::other_word", &["157 rad/s cw"]),
    ("spellings/v23", 1, "unit::hertz", &["write `25 rev/s` or `25 rad/s`"]),
    ("spellings/vel2", 1, "syntax::without_brackets", &["find velocity(C)"]),
];

/// The files with a statement that the rest depends on: the number of errors is that of reading.
const OF_READING: &[(&str, usize, &str, &[&str])] = &[
    ("messages/009-typo-drive", 1, "syntax::misspelt_word", &["write: drive crank"]),
    ("messages/010-typo-steps", 1, "syntax::misspelt_word", &["in 8 steps at 60 rpm"]),
    ("messages/159-range-to", 1, "syntax::other_word", &["-40 deg .. 40 deg in 8 steps at 60 rpm"]),
    ("messages/160-range-colon", 1, "syntax::other_word", &["-40 deg .. 40 deg in 8 steps at 60 rpm"]),
    ("messages/171-steps-missing", 1, "syntax::missing_word", &["500 mm .. 580 mm in 12 steps at 60 mm/s"]),
    ("messages/t2", 3, "syntax::comma_between", &["mass 1.2 kg at S2; inertia"]),
    ("messages/t11", 3, "syntax::needless_sign", &["write: link 2 leg1  P-A 190mm"]),
];

fn file(name: &str) -> String {
    std::fs::read_to_string(cases().join(format!("{name}.mech"))).expect("a text")
}

fn says(found: &[DiagnosticView], code: &str, words: &[&str], case: &str) {
    let code = format!("mech::{code}");
    let first = found.iter().find(|d| d.code.as_ref() == Some(&code));
    let first = first.unwrap_or_else(|| panic!("{case}: {code} is not among {found:#?}"));
    let said = format!("{} {}", first.message, first.help.as_deref().unwrap_or_default());
    for word in words {
        assert!(said.contains(word), "{case}: {word} is not in: {said}");
    }
}

/// Pastes every fix alone. Says how many there were.
fn paste(
    text: &str,
    found: &[DiagnosticView],
    look: impl Fn(&str) -> Vec<DiagnosticView>,
    name: &str,
) -> usize {
    let mut count = 0;
    for problem in found {
        for new in pasted(text, problem) {
            let left = look(&new);
            let most = found.len() - 1 + revealed(name);
            assert!(left.len() <= most, "{name}: {:?}\n{new}\n{left:#?}", problem.help);
            count += 1;
        }
    }
    count
}

#[test]
fn one_message_that_leads_to_the_fix() {
    for (case, count, code, words) in CASES {
        let text = file(case);
        let found = checked(&text);
        assert_eq!(found.len(), *count, "{case}: {found:#?}");
        says(&found, code, words, case);
        let name = case.rsplit('/').next().unwrap_or_default();
        let pastes = paste(&text, &found, checked, name);
        let offered = words.iter().any(|w| w.starts_with("write"));
        assert!(pastes > 0 || !offered, "{case}: {found:#?}");
    }
}

#[test]
fn one_message_of_reading() {
    for (case, count, code, words) in OF_READING {
        let text = file(case);
        let found = read(&text);
        assert_eq!(found.len(), *count, "{case}: {found:#?}");
        says(&found, code, words, case);
        assert!(paste(&text, &found, read, case) > 0, "{case}");
        for new in pasted(&text, &found[0]).iter().filter(|_| *count == 1 && !case.contains("steps-missing"))
        {
            assert!(checked(new).is_empty(), "{case}: {new}");
        }
    }
}

#[test]
fn every_case_is_covered() {
    for folder in ["messages", "spellings"] {
        for entry in std::fs::read_dir(cases().join(folder)).expect("a folder").flatten() {
            let path = entry.path();
            let name = format!("{folder}/{}", path.file_stem().and_then(|n| n.to_str()).unwrap_or_default());
            let mech = path.extension().is_some_and(|e| e == "mech");
            let known =
                CASES.iter().chain(OF_READING).any(|c| c.0 == name) || ACCEPTED.contains(&name.as_str());
            let elsewhere = || OTHERS.iter().any(|text| text.contains(&format!("\"{name}\"")));
            assert!(known || !mech || elsewhere(), "{name} is in no table");
        }
    }
}

/// The tests of cases that are found while checking and solving, or that are read as they are meant.
const OTHERS: [&str; 2] = [include_str!("meaning_cases.rs"), include_str!("first_attempts.rs")];

/// Units that people write and that are read: `60 N m`, `60 N.m`, `5 kp`.
const ACCEPTED: &[&str] = &["spellings/f6", "spellings/f7", "spellings/f12"];

#[test]
fn units_that_people_write() {
    for case in ACCEPTED {
        assert!(checked(&file(case)).is_empty(), "{case}");
    }
}

/// A good file, of which a line is replaced.
const GOOD: &str = r#"mechanism "Four-bar"
given r = 40 mm
given n = 120 rpm
gravity 9.81 m/s^2
ground { A (0, 0); D (120 mm, 10 mm) }
link crank A-B r
link coupler B-C 110 mm { S (60 mm, 15 mm); mass 1.2 kg at S; inertia 0.002 kg*m^2 }
link rocker D-C 90 mm
revolute A: ground - crank
revolute B: crank - coupler
revolute C: coupler - rocker
revolute D: ground - rocker
drive crank = 30 deg at n
assemble C left of B-D
torque load on rocker = 8 N*m cw
force F on coupler at S = 20 N @ 270 deg
balance torque Mb on crank
find Mb, w = omega(rocker)
expect w = 1 rad/s within 5 %
"#;

/// A line, the same with a mistake, and what the help says.
const LINES: &[(&str, &str, &str)] = &[
    ("given r = 40 mm", "given r = 40", "`given r = 40 mm`"),
    ("given r = 40 mm", "given r = 1,420 mm", "write one of\n  given r = 1.420 mm\n  given r = 1420 mm"),
    ("given r = 40 mm", "given r = 5 in", "write: given r = 5 inch"),
    ("given r = 40 mm", "given r = 40 [mm]", "write: given r = 40 mm"),
    ("given r = 40 mm", "given r = 40 milimeter", "write `mm`"),
    ("given r = 40 mm", "set r = 40 mm", "write: given r = 40 mm"),
    ("given r = 40 mm", "r = 40 mm", "write: given r = 40 mm"),
    ("given r = 40 mm", "given r = 40 mm  # crank", "write: given r = 40 mm  // crank"),
    ("given r = 40 mm", "given r = 40 /* crank */ mm", "write: given r = 40 mm  // crank"),
    ("given n = 120 rpm", "given n = 120", "`given n = 120 rpm`"),
    ("given n = 120 rpm", "given n = 120 1/min", "write `given n = 120 rpm` or `given n = 2 rad/s`"),
    ("given n = 120 rpm", "given n = 120 min^-1", "`given n = 120 rpm`"),
    ("given n = 120 rpm", "given n = 2 Hz", "write `given n = 2 rev/s` or `given n = 2 rad/s`"),
    ("given n = 120 rpm", "given n = 12 rad/sec", "write `rad/s`"),
    ("given n = 120 rpm", "given n = 120 U/min", "write `rpm`"),
    ("gravity 9.81 m/s^2", "gravity 9.81 m/sec^2", "write `m/s^2`"),
    ("gravity 9.81 m/s^2", "gravity 9.81 m/s2", "write `m/s^2`"),
    ("gravity 9.81 m/s^2", "gravity 9,81 m/s^2", "write: gravity 9.81 m/s^2"),
    ("gravity 9.81 m/s^2", "/* w */ gravity 9.81 m/s^2", "write: gravity 9.81 m/s^2  // w"),
    (
        "ground { A (0, 0); D (120 mm, 10 mm) }",
        "ground { A (0, 0); D (120 mm; 10 mm) }",
        "write: ground { A (0, 0); D (120 mm, 10 mm) }",
    ),
    (
        "ground { A (0, 0); D (120 mm, 10 mm) }",
        "ground { A (0, 0) D (120 mm, 10 mm) }",
        "write: ground { A (0, 0); D (120 mm, 10 mm) }",
    ),
    (
        "ground { A (0, 0); D (120 mm, 10 mm) }",
        "ground { A [0, 0]; D (120 mm, 10 mm) }",
        "write: ground { A (0, 0); D (120 mm, 10 mm) }",
    ),
    (
        "ground { A (0, 0); D (120 mm, 10 mm) }",
        "frame { A (0, 0); D (120 mm, 10 mm) }",
        "write: ground { A (0, 0); D (120 mm, 10 mm) }",
    ),
    ("link crank A-B r", "bar crank A-B r", "write: link crank A-B r"),
    ("link crank A-B r", "link crank A-B 2 r", "write `2*r`"),
    ("link crank A-B r", "link cra\u{200B}nk A-B r", "write: link crank A-B r"),
    ("link crank A-B r", "link crank\u{200B} A-B r", "write: link crank A-B r"),
    ("link crank A-B r", "link crank A-B 2 cos(0)*r/2", "write: link crank A-B 2*cos(0)*r/2"),
    ("link crank A-B r", "link crank A-B 40 mm mm", "write: link crank A-B 40 mm"),
    ("given r = 40 mm", "given r = 1'500 mm", "write: given r = 1500 mm"),
    ("given r = 40 mm", "given r = 1.500,5 mm", "write: given r = 1500.5 mm"),
    ("given r = 40 mm", "r := 40 mm", "write: given r = 40 mm"),
    ("given n = 120 rpm", "given n = 120 min-1", "write `120 rpm` or `2 rad/s`"),
    ("given n = 120 rpm", "given n = 120 /min", "write `120 rpm` or `2 rad/s`"),
    ("gravity 9.81 m/s^2", "gravity 9.81 m/s^2 % weight", "write: gravity 9.81 m/s^2 // weight"),
    ("link crank A-B r", "crank A-B r", "write: link crank A-B r"),
    ("link crank A-B r", "link crank A-B length r", "write: link crank A-B r"),
    ("revolute A: ground - crank", "revolute joint A: ground - crank", "write: revolute A: ground - crank"),
    ("drive crank = 30 deg at n", "drive crank = 30 deg with n", "write: drive crank = 30 deg at n"),
    ("assemble C left of B-D", "assemble C is left of B-D", "write: assemble C left of B-D"),
    ("torque load on rocker = 8 N*m cw", "torque load on rocker = 8 N-m cw", "write `8 N*m`"),
    ("torque load on rocker = 8 N*m cw", "torque load on rocker = 8 lb*ft cw", "write `8 lbf*ft`"),
    (
        "torque load on rocker = 8 N*m cw",
        "torque load rocker = 8 N*m cw",
        "write: torque load on rocker = 8 N*m cw",
    ),
    (
        "force F on coupler at S = 20 N @ 270 deg",
        "force F on coupler at S = 20 N at 270 deg",
        "write: force F on coupler at S = 20 N @ 270 deg",
    ),
    (
        "force F on coupler at S = 20 N @ 270 deg",
        "force F on S of coupler = 20 N @ 270 deg",
        "write: force F on coupler at S = 20 N @ 270 deg",
    ),
    (
        "ground { A (0, 0); D (120 mm, 10 mm) }",
        "ground { A (0, 0); D (120, 10) mm }",
        "write: ground { A (0, 0); D (120 mm, 10 mm) }",
    ),
    (
        "ground { A (0, 0); D (120 mm, 10 mm) }",
        "ground { A (0, 0); point D (120 mm, 10 mm) }",
        "write: ground { A (0, 0); D (120 mm, 10 mm) }",
    ),
    (
        "ground { A (0, 0); D (120 mm, 10 mm) }",
        "ground { A (0, 0); D 120 mm, 10 mm }",
        "write: ground { A (0, 0); D (120 mm, 10 mm) }",
    ),
    (
        "find Mb, w = omega(rocker)",
        "find Mb, w = omega(rocker) [rpm]",
        "write: find Mb, w = omega(rocker) as rpm",
    ),
    ("expect w = 1 rad/s within 5 %", "expect w = 1 rad/s (5 %)", "write: expect w = 1 rad/s within 5 %"),
    (
        "expect w = 1 rad/s within 5 %",
        "expect w is 1 rad/s within 5 %",
        "write: expect w = 1 rad/s within 5 %",
    ),
    ("link crank A-B r", "link crank A-B r r", "write: link crank A-B r"),
    ("link crank A-B r", "link crank A-B r²/r", "write: link crank A-B r^2/r"),
    (
        "link coupler B-C 110 mm { S (60 mm, 15 mm); mass 1.2 kg at S; inertia 0.002 kg*m^2 }",
        "link coupler B-C 110 mm { S (60 mm, 15 mm) mass 1.2 kg at S inertia 0.002 kg*m^2 }",
        "{ S (60 mm, 15 mm); mass 1.2 kg at S; inertia 0.002 kg*m^2 }",
    ),
    (
        "link coupler B-C 110 mm { S (60 mm, 15 mm); mass 1.2 kg at S; inertia 0.002 kg*m^2 }",
        "link coupler B-C 110 mm { S (60 mm, 15 mm); mass 1.2 kg at S; inertia 0.002 kg*m2 }",
        "write `kg*m^2`",
    ),
    ("revolute A: ground - crank", "pin A: ground - crank", "write: revolute A: ground - crank"),
    ("revolute A: ground - crank", "A: ground - crank", "write: revolute A: ground - crank"),
    ("revolute A: ground - crank", "revolute A: ground - crank -", "write: revolute A: ground - crank"),
    ("drive crank = 30 deg at n", "drive crank = 30 at n", "write `30 deg`"),
    ("drive crank = 30 deg at n", "drive crank = 22,5 deg at n", "write: drive crank = 22.5 deg at n"),
    ("drive crank = 30 deg at n", "drive crank = 30 grad at n", "write `deg` or `gon`"),
    ("drive crank = 30 deg at n", "drive crank = 30 deg at 3 Hz", "write `3 rev/s` or `3 rad/s`"),
    ("drive crank = 30 deg at n", "drive crank = 30 deg at 90", "write `90 rpm`"),
    ("drive crank = 30 deg at n", "motor crank = 30 deg at n", "write: drive crank = 30 deg at n"),
    ("torque load on rocker = 8 N*m cw", "torque load on rocker = 8 Nm cw", "write `N*m`"),
    (
        "torque load on rocker = 8 N*m cw",
        "moment load on rocker = 8 N*m cw",
        "write: torque load on rocker = 8 N*m cw",
    ),
    (
        "force F on coupler at S = 20 N @ 270 deg",
        "force F on coupler.S = 20 N @ 270 deg",
        "write: force F on coupler at S = 20 N @ 270 deg",
    ),
    (
        "force F on coupler at S = 20 N @ 270 deg",
        "force F on coupler at S = 20 N down",
        "write: force F on coupler at S = 20 N @ 270 deg",
    ),
    (
        "force F on coupler at S = 20 N @ 270 deg",
        "force F on coupler at S = 20 N to the right",
        "write: force F on coupler at S = 20 N @ 0 deg",
    ),
    ("find Mb, w = omega(rocker)", "find Mb; w = omega(rocker)", "write: find Mb, w = omega(rocker)"),
    ("find Mb, w = omega(rocker)", "print Mb, w = omega(rocker)", "write: find Mb, w = omega(rocker)"),
    (
        "find Mb, w = omega(rocker)",
        "find Mb, w = omega(rocker) in rpm",
        "write: find Mb, w = omega(rocker) as rpm",
    ),
    ("expect w = 1 rad/s within 5 %", "expect w = 1 rad/s +- 5 %", "write: expect w = 1 rad/s within 5 %"),
    ("expect w = 1 rad/s within 5 %", "expect w = 1 rad/s +/- 5 %", "write: expect w = 1 rad/s within 5 %"),
    (
        "expect w = 1 rad/s within 5 %",
        "expect w ~ 1 rad/s within 5 %",
        "write: expect w = 1 rad/s within 5 %",
    ),
    (
        "expect w = 1 rad/s within 5 %",
        "expect w = 1 rad/s at 30 deg",
        "write: expect w = 1 rad/s at crank = 30 deg",
    ),
    ("link crank A-B r", "link crank A-B 0.5 x r", "write: link crank A-B 0.5 * r"),
    ("link crank A-B r", "link crank r A-B", "write: link crank A-B r"),
    (
        "link crank A-B r",
        "link crank A-B r { mass 1 kg at A; torque T on crank = 1 N*m }",
        "write: link crank A-B r { mass 1 kg at A }; torque T on crank = 1 N*m",
    ),
    ("given n = 120 rpm", "gegeben n = 120 rpm", "write: given n = 120 rpm"),
    ("link rocker D-C 90 mm", "stab rocker D-C 90 mm", "write: link rocker D-C 90 mm"),
    ("given n = 120 rpm", "given n = 120 об/мин", "write `rev/min`"),
    ("revolute A: ground - crank", "revolute A: ground -> crank", "write: revolute A: ground - crank"),
    ("revolute A: ground - crank", "revolute 1A: ground - crank", "write: revolute A: ground - crank"),
    ("drive crank = 30 deg at n", "drive crank = 30 deg speed n", "write: drive crank = 30 deg at n"),
    ("drive crank = 30 deg at n", "drive crank at n = 30 deg", "write: drive crank = 30 deg at n"),
    ("assemble C left of B-D", "assemble C to the left of B-D", "write: assemble C left of B-D"),
    ("drive crank = 30 deg at n", "drive crank 30 deg at n", "write: drive crank = 30 deg at n"),
    ("drive crank = 30 deg at n", "drive crank = 30 deg at a speed of n", "write: drive crank = 30 deg at n"),
    ("drive crank = 30 deg at n", "drive crank = 30 deg at speed n", "write: drive crank = 30 deg at n"),
    ("link rocker D-C 90 mm", "link rocker from D to C 90 mm", "write: link rocker D-C 90 mm"),
    ("link rocker D-C 90 mm", "link rocker DC 90 mm", "write: link rocker D-C 90 mm"),
    (
        "expect w = 1 rad/s within 5 %",
        "expect w = 1 rad/s at crank = 30 deg within 5 %",
        "write: expect w = 1 rad/s within 5 % at crank = 30 deg",
    ),
    (
        "force F on coupler at S = 20 N @ 270 deg",
        "force F on coupler at S = 20 N at an angle of 270 deg",
        "write: force F on coupler at S = 20 N @ 270 deg",
    ),
    (
        "torque load on rocker = 8 N*m cw",
        "torque load on rocker = 8 N*m opposite to motion",
        "write: torque load on rocker = 8 N*m against motion",
    ),
    (
        "torque load on rocker = 8 N*m cw",
        "torque load on rocker = 8 N*m opposite motion",
        "write: torque load on rocker = 8 N*m against motion",
    ),
    (
        "torque load on rocker = 8 N*m cw",
        "torque load on rocker = 8 N*m cw if omega(rocker) > 0 rad/s",
        "= 8 N*m cw when omega(rocker) > 0 rad/s",
    ),
    (
        "ground { A (0, 0); D (120 mm, 10 mm) }",
        "ground { A (0, 0); D (120 mm, 10 mm); line g along 0 deg }",
        "write one of\n  ground { A (0, 0); D (120 mm, 10 mm); line g through A along 0 deg }",
    ),
    (
        "ground { A (0, 0); D (120 mm, 10 mm) }",
        "ground { A (0, 0); D (120 mm, 10 mm); circle c centre A diameter 50 mm }",
        "circle c centre A radius 25 mm }",
    ),
    ("find Mb, w = omega(rocker)", "find Mb w = omega(rocker)", "write: find Mb, w = omega(rocker)"),
    ("mechanism \"Four-bar\"", "mechanism “Four-bar”", "write: mechanism \"Four-bar\""),
    ("mechanism \"Four-bar\"", "mechanism „Four-bar“", "write: mechanism \"Four-bar\""),
];

#[test]
fn a_line_with_a_mistake() {
    assert!(checked(GOOD).is_empty());
    for (good, bad, wanted) in LINES {
        assert!(GOOD.contains(good), "{good}");
        let text = GOOD.replacen(good, bad, 1);
        let found = checked(&text);
        assert_eq!(found.len(), 1, "{bad}: {found:#?}");
        let help = found[0].help.as_deref().unwrap_or_default();
        assert!(help.contains(wanted), "{bad}: {help}");
        assert!(paste(&text, &found, checked, bad) > 0, "{bad}: {help}");
    }
}

/// Units that are read as they are written.
#[test]
fn units_of_many_countries() {
    for (unit, si) in [
        ("bar", 1e5),
        ("psi", 6_894.757_293_168_36),
        ("hp", 745.699_871_582_270_2),
        ("PS", 735.498_75),
        ("kp", 9.806_65),
        ("gon", std::f64::consts::PI / 200.0),
        ("ft", 0.3048),
        ("inch", 0.0254),
        ("um", 1e-6),
        ("N m", 1.0),
        ("N.m", 1.0),
        ("kg m^2", 1.0),
        ("kg·m²", 1.0),
        ("kN m", 1e3),
        ("N.mm", 1e-3),
    ] {
        let found = assur::units::lookup(unit).unwrap_or_else(|e| panic!("{unit}: {e}")).factor;
        assert!((found / si - 1.0).abs() < 1e-14, "{unit}: {found}");
        let read = checked(&format!("given x = 5 {unit}\nfind y = 2*x\n"));
        assert!(read.is_empty(), "{unit}: {read:#?}");
    }
}

/// The message and help of a table beside the crank-slider.
fn table_says(name: &str, text: &[u8]) -> (String, Option<String>) {
    let said = |error: &TableError| {
        use miette::Diagnostic;
        (error.to_string(), error.help().map(|h| h.to_string()))
    };
    let mut table = match Table::open(name, text).expect("it is read") {
        Ok(table) => table,
        Err((_, error)) => return said(&error),
    };
    let document = assur::syntax::parse(&Source::new("text.mech", SLIDER)).0;
    let (columns, problems) = assur::check::columns(&document, &Overrides::none(), &table.columns);
    let Some(columns) = columns else {
        let found = errors(&problems, &table.header);
        assert_eq!(found.len(), 1, "{name}: {found:#?}");
        return (found[0].message.clone(), found[0].help.clone());
    };
    let (columns, mut lines) = (columns.into(), Lines::default());
    table.lines(10, &mut lines).expect("it is read");
    let row = lines.get(0).map(|line| line.read(name, &columns, table.separator).map(|_| ()));
    match (row, table.without_rows()) {
        (Some(Err((_, error))), _) | (_, Some((_, error))) => said(&error),
        _ => ("it is right".to_owned(), None),
    }
}

const SLIDER: &str = "given r = 80 mm\ngiven l = 300 mm\ngiven n = 500 rpm\ngiven phi = 10 deg\ngiven P = 100 N\nfind r, l, n, phi, P\n";

#[test]
fn tables() {
    for (name, wanted) in [
        ("badunit", &["`milli` is not a unit", "write `mm`"][..]),
        ("deccomma", &["6 cells", "decimals with a point, as in `80.5`"]),
        ("cell_too_many", &["6 cells", "leave `7` out, or name a column for it"]),
        ("other_separator", &["semicolons, those of the rows by commas", "write: r [mm],l [mm],n [rpm]"]),
        ("noheader", &["the first line names the columns"]),
        ("paren", &["in parentheses", "write: r [mm],l [mm],n [rpm],phi [deg],P [N]"]),
        ("thousands", &["`1,500`", "write `1.500` or `1500`"]),
    ] {
        let text = std::fs::read(cases().join(format!("messages/{name}.csv"))).expect("a table");
        let (message, help) = table_says(name, &text);
        let help = help.unwrap_or_default();
        for word in wanted {
            assert!(message.contains(word) || help.contains(word), "{name}: {message}; {help}");
        }
        if let Some(header) = help.strip_prefix("write: ") {
            let rows = String::from_utf8(text).expect("a text");
            let pasted = format!("{header}\n{}", rows.split_once('\n').expect("rows").1);
            assert_eq!(table_says(name, pasted.as_bytes()).0, "it is right");
        }
    }
    let (message, _) = table_says("header only", b"r [mm],l [mm]\n");
    assert_eq!(message, "the table has no rows");
}

#[test]
fn values_from_outside() {
    for (name, value, wanted) in [
        ("r", "0,12m", "write `--set r=0.12m`"),
        ("r", "1,200mm", "write `--set r=1.200mm` or `--set r=1200mm`"),
        ("r", "120", "write `--set r=120mm`"),
        ("n", "1500", "write `--set n=1500rpm`"),
        ("n", "1500 1/min", "write `--set n=1500rpm` or `--set n=25rad/s`"),
        ("P", "5 kNN", "write `--set P=5kN`"),
    ] {
        let source = Source::new("text.mech", SLIDER);
        let set = |value: &str| {
            let overrides = Overrides::set(vec![(name.to_owned(), value.to_owned())]);
            errors(&assur::check_source(&source, &overrides).1, &source)
        };
        let found = set(value);
        assert_eq!(found.len(), 1, "{name}={value}: {found:#?}");
        let help = found[0].help.as_deref().unwrap_or_default();
        assert_eq!(help, wanted, "{name}={value}");
        for line in words(help).expect("lines") {
            let value = line.split_once('=').expect("a value").1;
            assert!(set(value).is_empty(), "{line}");
        }
    }
}

/// The wrong files of a stage's codes.
fn wrong_files(stage: &str) -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/errors").join(stage);
    let folders = std::fs::read_dir(root).expect("a folder").flatten();
    let files = folders.flat_map(|f| std::fs::read_dir(f.path()).into_iter().flatten().flatten());
    files.map(|f| f.path()).filter(|p| p.extension().is_some_and(|e| e == "mech")).collect()
}

/// In the files of all codes of reading, a fix removes its own message and adds no other.
#[test]
fn every_fix_of_reading_fixes() {
    let mut count = 0;
    for path in wrong_files("syntax") {
        let text = std::fs::read_to_string(&path).expect("a text");
        let found = read(&text);
        for problem in &found {
            for new in pasted(&text, problem) {
                let left = read(&new);
                let same = |d: &DiagnosticView| d.spans == problem.spans && d.help == problem.help;
                assert!(!left.iter().any(same), "{}: {:?}", path.display(), problem.help);
                assert!(left.len() <= found.len(), "{}: {new}\n{left:#?}", path.display());
                count += 1;
            }
        }
    }
    assert!(count > 50, "{count}");
}
