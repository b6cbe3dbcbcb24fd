//! Single mistakes in otherwise good files: one cause gives one message, which leads to the fix, and a fix that is offered
//! works when it is pasted.

use crate::case::text;
use crate::paste::{checked, paste, pasted, read};
use assur::internals::diagnostic::DiagnosticView;

/// The files with the number of errors, the code of the first, and what its message or help says.
const CASES: &[(&str, usize, &str, &[&str])] = &[
    ("use3/messages/cascade-of-a-simulate-line", 1, "syntax::needless_sign", &["write: simulate 2 s"]),
    (
        "use3/messages/cascade-of-a-variants-header",
        1,
        "syntax::other_word",
        &["write: r [mm], px [mm], py [mm]"],
    ),
    (
        "use3/messages/torque-without-balance-name",
        1,
        "syntax::missing_word",
        &["write: balance torque Mb on crank"],
    ),
    ("use3/messages/wheel-misspelt-without-a-size", 1, "syntax::misspelt_word", &["write `wheel`"]),
    ("use3/messages/mass-at-unknown-point", 1, "name::unknown", &["did you mean `S`?"]),
    ("use3/messages/ground-point-missing", 1, "geometry::nothing_to_join", &["add `D (100 mm, 0)`"]),
    ("use3/messages/force-polar-comma", 1, "unit::mismatch", &["write `3 kN @ 180 deg`"]),
    (
        "use3/messages/find-with-question",
        1,
        "syntax::misspelt_word",
        &["write: find Mb, N = normal(D, piston)"],
    ),
    (
        "use3/messages/displacement-of-link",
        1,
        "name::wrong_kind",
        &["write `D`: the pair in which it slides"],
    ),
    ("use3/messages/stroke-of-link", 1, "name::wrong_kind", &["its pairs are `C`, `D`"]),
    ("use3/messages/sum-of-unlike", 1, "unit::operands", &["write `0.35 m`"]),
    ("use3/messages/length-without-a-unit", 1, "unit::missing", &["write `0.35 m`"]),
    ("use3/messages/drive-with-omega", 1, "syntax::other_word", &["write: drive crank = 45 deg at 1500 rpm"]),
    ("use3/messages/drive-ground", 1, "geometry::on_ground", &["name a moving link: `crank`"]),
    (
        "use3/messages/range-dash",
        1,
        "syntax::other_word",
        &["write: drive crank = 0 deg .. 360 deg in 12 steps at 60 rpm"],
    ),
    ("use3/messages/steps-as-dt", 1, "syntax::other_word", &["write: simulate 2 s in 40 steps"]),
    ("use3/messages/title-with-quotes", 1, "syntax::other_word", &["the 'quick' return"]),
    ("use3/messages/weld", 1, "syntax::misspelt_word", &["write: weld B: crank - rod"]),
    (
        "use3/messages/revolute-with-point-of-wrong-name",
        1,
        "name::unknown",
        &["as the point `B` of `crank`: write `crank.B`"],
    ),
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
    ("spellings/f3", 1, "name::unknown", &["the points of coupler are `B`, `C`"]),
    ("spellings/f5", 1, "unit::unknown", &["write `N*m`"]),
    ("spellings/f8", 1, "unit::missing", &["write `270 deg`"]),
    ("spellings/f13", 1, "unit::unknown", &["write `N*m`"]),
    ("spellings/f14", 1, "syntax::other_word", &["force F on crank at B = 5 kN @ 0 deg"]),
    ("spellings/f16", 1, "syntax::missing_word", &["expect Mb = 80 deg at crank = 60 deg"]),
    ("spellings/f18", 1, "syntax::other_word", &["find position(C) - position(D)"]),
    ("spellings/f9", 1, "syntax::misplaced_member", &["link coupler B-C 400 mm { mass 3 kg at"]),
    ("spellings/grav", 1, "syntax::unexpected", &["write: gravity 9.81 m/s^2"]),
    ("spellings/plot2", 1, "syntax::unknown_statement", &["nothing is drawn", "find velocity(C).x"]),
    ("spellings/rpmless", 1, "unit::missing", &["write `45 deg`"]),
    ("spellings/tf", 1, "geometry::unknown_property", &["did you mean `friction`?"]),
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

fn says(found: &[DiagnosticView], code: &str, words: &[&str], case: &str) {
    let code = format!("mech::{code}");
    let first = found.iter().find(|d| d.code.as_ref() == Some(&code));
    let first = first.unwrap_or_else(|| panic!("{case}: {code} is not among {found:#?}"));
    let said = format!("{} {}", first.message, first.help.as_deref().unwrap_or_default());
    for word in words {
        assert!(said.contains(word), "{case}: {word} is not in: {said}");
    }
}

#[test]
fn one_message_that_leads_to_the_fix() {
    for (case, count, code, words) in CASES {
        let text = text(case);
        let found = checked(&text);
        assert_eq!(found.len(), *count, "{case}: {found:#?}");
        says(&found, code, words, case);
        let name = case.rsplit('/').next().unwrap_or_default();
        let pastes = paste(&text, &found, checked, name);
        let offered = words.iter().any(|w| w.starts_with("write"));
        assert!(pastes > 0 || !offered, "{case}: {found:#?}");
    }
}

/// Of every two lines of the same kind the second gets the name of the first: the name that is missing then is no second mistake.
#[test]
fn a_name_declared_twice_is_one_message() {
    const KINDS: [&[&str]; 4] = [&["revolute", "prismatic"], &["link"], &["given"], &["let"]];
    let text = text("use3/messages/inertia-before-mass-missing-S").replace("at 1500 rpm", "");
    let name_of = |line: &str, begin: &str| {
        let rest = line.strip_prefix(begin)?.trim_start();
        let name = rest.split([' ', ':', '=']).next()?;
        Some((begin.len() + line[begin.len()..].find(name)?, name.to_owned()))
    };
    let mut count = 0;
    for kinds in KINDS {
        let found = |line: &str| kinds.iter().find_map(|begin| name_of(line, begin));
        let lines: Vec<&str> = text.lines().collect();
        let declared: Vec<usize> = (0..lines.len()).filter(|i| found(lines[*i]).is_some()).collect();
        for (a, first) in declared.iter().enumerate() {
            for second in &declared[a + 1..] {
                let (_, name) = found(lines[*first]).expect("a name");
                let (at, own) = found(lines[*second]).expect("a name");
                let line = format!("{}{name}{}", &lines[*second][..at], &lines[*second][at + own.len()..]);
                let mut changed = lines.clone();
                changed[*second] = &line;
                let all = checked(&changed.join("\n"));
                assert_eq!(all.len(), 1, "{own} as {name}: {all:#?}");
                says(&all, "name::duplicate", &["declared twice"], &own);
                count += 1;
            }
        }
    }
    assert!(count > 8, "{count}");
}

#[test]
fn one_message_of_reading() {
    for (case, count, code, words) in OF_READING {
        let text = text(case);
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
        for entry in std::fs::read_dir(crate::case::folder().join(folder)).expect("a folder").flatten() {
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
        assert!(checked(&text(case)).is_empty(), "{case}");
    }
}
