//! Sheets and keys for classes: the cases of tests/cases/use3/sheets, and at random.

use crate::run::{Folder, assur};
use proptest::prelude::*;

const TRAIN: &str = include_str!("../cases/use3/sheets/train-by-teeth.mech");
const SENSE: &str = include_str!("../cases/use3/sheets/sense-of-motion.mech");
const ROWS: &str = include_str!("../cases/use3/sheets/rows-with-variants.mech");
const KEY: &str = include_str!("../cases/use3/sheets/key-titled-by-last-row.mech");

fn report(text: &str, more: &[&str]) -> String {
    let folder = Folder::new("sheet").with("a.mech", text);
    let out = assur(&folder, &[&["report", "a.mech"], more].concat());
    // a sheet may lack something
    let is_clean = out.stderr.is_empty() || out.stderr.starts_with("mech::sheet::");
    assert!(out.status == 0 && is_clean, "{}", out.stderr);
    out.stdout
}

/// The same where the program may warn.
fn report_warned(text: &str, more: &[&str]) -> String {
    let folder = Folder::new("sheet").with("a.mech", text);
    let out = assur(&folder, &[&["report", "a.mech"], more].concat());
    assert_eq!(out.status, 0, "{}", out.stderr);
    out.stdout
}

/// What stands between two headings.
fn part<'t>(page: &'t str, from: &str, to: &str) -> &'t str {
    let after = page.split_once(&format!("\n{from}\n")).map_or("", |(_, after)| after);
    after.split_once(&format!("\n{to}\n")).map_or(after, |(before, _)| before)
}

#[test]
fn a_train_by_teeth_has_no_radii() {
    let sheet = report(TRAIN, &["--sheet"]);
    let given = part(&sheet, "Given", "Find");
    for value in ["z_s = 24", "z_p = 30", "z_r = 84", "40 N·m", "n_sun = 900 rpm"] {
        assert!(given.contains(value), "{value}: {given}");
    }
    let page = report(TRAIN, &[]);
    for (what, text) in [("sheet", given), ("solution", page.as_str())] {
        for nobody_gave in ["r_p", "r_r", "z_a", " 15 m", " 42 m", "F_b"] {
            assert!(!text.contains(nobody_gave), "{what}: {nobody_gave}: {text}");
        }
    }
    assert!(page.contains("= −180.00 N·m"), "{page}");
}

#[test]
fn a_sense_of_motion_is_no_speed() {
    let sheet = report(SENSE, &["--sheet"]);
    let given = part(&sheet, "Given", "Find");
    assert!(!given.contains("v_B") && given.contains('α') && given.contains("15°"), "{given}");
    let page = report(SENSE, &[]);
    assert!(page.contains("Only the sense of the motion is given: v_B is taken as one unit"), "{page}");
    for (language, words) in [("ru", "Задано только направление движения"), ("zh", "只给出运动方向")]
    {
        assert!(report(SENSE, &["--lang", language]).contains(words));
    }
}

#[test]
fn an_acceleration_that_follows_from_the_loads_is_not_given() {
    let text = include_str!("../../examples/simulation/brake.mech");
    let sheet = report(text, &["--sheet"]);
    assert!(!part(&sheet, "Given", "Find").contains("rad/s²"), "{sheet}");
}

#[test]
fn every_variant_has_its_name_on_its_sheet() {
    let text = ROWS.replace("Slider-crank with", "Variant {variant}: slider-crank with");
    let folder = Folder::new("sheet-rows").with("a.mech", &text);
    let out = assur(&folder, &["report", "a.mech", "--sheet", "--per-row", "-o", "s.txt"]);
    assert_eq!((out.status, out.stderr.as_str()), (0, ""));
    let names: Vec<String> = (1..=8).map(|i| format!("s-{i}-A{i}.txt")).collect();
    assert_eq!(folder.names()[1..], names);
    let page = folder.read("s-2-A2.txt");
    assert!(page.starts_with("Variant A2: slider-crank with a crank of 90 mm\n"), "{page}");
    assert!(page.contains("Group ________ Variant 2 (A2)\n"), "{page}");
    assert_eq!(page.matches("550 rpm").count(), 2, "in the text and under Given, once each: {page}");
}

#[test]
fn a_sheet_for_all_says_whose_values_it_has() {
    let sheet = report(ROWS, &["--sheet"]);
    assert!(sheet.starts_with("Slider-crank with a crank of r\n"), "{sheet}");
    for words in [
        "A crank of r = 80 mm turns at n = 500 rpm",
        "The scheme is drawn for variant 1 (A1).",
        "The values in the text are those of variant 1 (A1).",
        "1. v – velocity of C, x component, m/s\n2. a – acceleration of C, x component, m/s²\n",
    ] {
        assert!(sheet.contains(words), "{words}: {sheet}");
    }
    assert!(!sheet.contains("velocity(C)") && !sheet.contains("0.08 m"), "{sheet}");
    let russian = report(ROWS, &["--sheet", "--lang", "ru"]);
    assert!(russian.contains("скорость точки C, проекция на ось x"), "{russian}");
    assert!(russian.contains("Схема построена для варианта 1 (A1)."), "{russian}");
    assert!(report(ROWS, &["--sheet", "--lang", "zh"]).contains("点 C 的速度的 x 分量"));
}

/// Where a slider presses on its guide and where a load of the ground acts on a link depends on the position: nobody gave these arms.
#[test]
fn places_of_the_position_are_not_given() {
    let text = include_str!("../../examples/slotted/edge-reactions.mech");
    let sheet = report(text, &["--sheet"]);
    let given = part(&sheet, "Given", "Find");
    let words = given.split_whitespace().collect::<Vec<_>>().join(" ");
    for value in ["F_3 = (120 N; −60 N) at (80 mm; 200 mm)", "l_BD = 300 mm", "A (−l_21; 0)"] {
        assert!(words.contains(value), "{value}: {given}");
    }
    assert!(!given.contains("P1") && !given.contains("P2"), "{given}");
    assert!(report(text, &[]).contains("l_CP1"), "the solution computes with it");
    for wedges in [
        include_str!("../../examples/friction/wedges-forward.mech"),
        include_str!("../../examples/determinacy/three-wedges.mech"),
    ] {
        let sheet = report(wedges, &["--sheet"]);
        let given = part(&sheet, "Given", "Find");
        assert!(given.contains("Ground: ") && !given.contains("l_LP"), "{given}");
    }
}

/// Formulas are set as formulas, functions of the language in words.
#[test]
fn questions_are_words_or_formulas() {
    let text = SENSE.split("\nfind").next().unwrap_or_default();
    let dense = |words: &str| words.split_whitespace().collect::<String>();
    let asked = |find: &str, lang: &str| {
        dense(&report(&format!("{text}\nfind {find}\n"), &["--sheet", "--lang", lang]))
    };
    for (find, words) in [
        ("m = 2*velocity(B).x/G", "m – (2·v_Bx)/G"),
        ("P = (velocity(B).x + 3 m/s)*G as W", "P – (v_Bx + 3 m/s)·G, W"),
        ("u = sqrt(f) - f^2", "u – √(f) − f²"),
        ("ac = critical(al)", "a_c – value of α at which the mechanism locks itself, °"),
        (
            "T = journal_torque(load = G, radius = 20 mm, friction = f)",
            "T – friction torque of the journal: load G, radius 20 mm, coefficient of friction f, N·m",
        ),
    ] {
        let page = asked(find, "en");
        assert!(page.contains(&dense(words)), "{words}: {page}");
    }
    for (lang, words) in
        [("ru", "значение α, при котором наступает самоторможение"), ("zh", "发生自锁时 α 的值")]
    {
        assert!(asked("ac = critical(al)", lang).contains(&dense(words)), "{lang}");
    }
}

#[test]
fn a_key_is_titled_for_all_rows() {
    let key = report(KEY, &["--key"]);
    assert!(key.starts_with("Slider-crank with a crank of r\n"), "{key}");
    let named = KEY.replace("Slider-crank with", "Variants {variant}: slider-crank with");
    let key = report(&named, &["--key"]);
    assert!(key.starts_with("Variants A1–A8: slider-crank with a crank of r\n"), "{key}");
}

#[test]
fn folders_of_problems_become_folders_of_sheets() {
    let folder = Folder::new("sheet-folder").with("set/a.mech", ROWS).with("set/b.mech", TRAIN);
    folder.write_bytes("set/more/a.mech", SENSE.as_bytes());
    let out = assur(&folder, &["report", "set", "--sheet", "-o", "pages"]);
    assert_eq!((out.status, out.stdout.as_str(), out.stderr.as_str()), (0, "", ""));
    let names = |at: &str| {
        let entries = std::fs::read_dir(folder.path(at)).unwrap().flatten();
        let mut names: Vec<_> = entries.map(|e| e.file_name().to_string_lossy().into_owned()).collect();
        names.sort();
        names
    };
    assert_eq!(names("pages"), ["b.html", "set-a.html", "set-more-a.html"]);
    assert!(folder.read("pages/set-more-a.html").contains("A block on a slope"));
    let out = assur(&folder, &["report", "set/*.mech", "--key", "-o", "keys", "--format", "text"]);
    assert_eq!((out.status, out.stderr.as_str()), (0, ""));
    assert_eq!(names("keys"), ["a-key.txt", "b-key.txt"]);
    let out = assur(&folder, &["report", "set/a.mech", "--sheet", "--per-row", "-o", "rows"]);
    assert_eq!((out.status, out.stderr.as_str()), (0, ""));
    assert_eq!(names("rows").len(), 8);
    assert_eq!(names("rows")[1], "a-2-A2.html");
    // a chapter on one page, each sheet on new paper
    let out = assur(&folder, &["report", "set", "--sheet", "-o", "chapter.html"]);
    assert_eq!((out.status, out.stdout.as_str(), out.stderr.as_str()), (0, "", ""));
    let page = folder.read("chapter.html");
    assert_eq!((page.matches("<main class=\"sheet\">").count(), page.matches("<html").count()), (3, 1));
    assert!(page.contains(".sheet+.sheet{break-before:page"), "{page}");
    let ids: Vec<&str> =
        page.split("<figure id=\"").skip(1).filter_map(|rest| rest.split('"').next()).collect();
    assert_eq!(ids.len(), ids.iter().collect::<std::collections::BTreeSet<_>>().len(), "{ids:?}");
    let out = assur(&folder, &["report", "set", "--sheet", "-o", "chapter.md"]);
    assert_eq!(out.status, 2, "pictures of several have no place");
    let out = assur(&folder, &["report", "set", "--sheet", "-o", "set/a.mech/x"]);
    assert_eq!(out.status, 2);
}

/// A block on a guide: loads `F` along it and `G` down, held by H; more lines behind.
fn block(guide: &str, loads: &str, more: &str) -> String {
    format!(
        "mech 1\nmechanism \"A block\"\n// A block is pushed along a guide. Find the holding force.\nground {{ O (0, 0); line way through O along 0 deg }}\nlink block {{ B (0, 0) }}\nprismatic P: block.B - ground.way{guide}\ndrive P = 0 mm at 0.1 m/s\n{loads}balance force H on block at B along 0 deg\nfind H as N, N = normal(P, block) as N\n{more}"
    )
}

fn words(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

fn given(text: &str) -> String {
    let sheet = report(text, &["--sheet"]);
    words(part(&sheet, "Given", "Find").split("\nVariants\n").next().unwrap_or_default())
}

const LOADS: &str = "force F on block at B = 120 N @ 0 deg\nforce G on block at B = 80 N @ 270 deg\n";

/// H is −120 N and N is 80 N, as large as the loads.
#[test]
fn no_datum_is_left_out_for_its_number() {
    let given_here = given(&block("", LOADS, ""));
    assert!(given_here.contains("F = 120 N") && given_here.contains("G = 80 N"), "{given_here}");
    // two of one number, and one that is in no equation
    let text = block(
        "",
        &LOADS.replace("120 N", "p").replace("80 N", "q"),
        "given p = 80 N\ngiven q = 80 N\ngiven u = 80 N\nfind T = 2*u as N\n",
    );
    let given_here = given(&text);
    for name in ["p", "q", "u"] {
        assert!(given_here.contains(&format!("{name} = ")), "{name}: {given_here}");
    }
    // the text may say what the file gives, and numbers of other kinds
    for (sentence, is_kept) in [
        ("A force of 120 N pushes. ", true),
        ("It makes 80 strokes of 80 mm. ", true),
        ("The pressure N is 80.1 N. ", false),
        ("The answer is 0.0802 kN. ", false),
    ] {
        let text = block("", LOADS, "").replace("// A block is", &format!("// {sentence}A block is"));
        let text = if is_kept { text } else { text.replace("= 80 N", "= (0.08 kN + 0.1 N)") };
        let sheet = report(&text, &["--sheet"]);
        assert_eq!(words(&sheet).contains(sentence.trim()), is_kept, "{sentence}");
    }
    // where several positions have one number as an answer, all stay
    let roof = include_str!("../../examples/trusses/roof-of-seven-bars.mech");
    assert!(given(roof).contains("H = 4 kN to the right"), "{}", given(roof));
    let swing = report(include_str!("../../examples/simulation/given-swing.mech"), &["--sheet"]);
    assert!(part(&swing, "Answers", "Solution").contains("\n    2\n"), "{swing}");
}

/// A table has its plot beside it: a curve through its points.
#[test]
fn a_table_is_plotted() {
    let text = "curve t linear {\n  q [deg], k\n  0, 0\n  30, 1\n  180, 0\n}
ground { O (0, 0) }\nlink crank { O (0, 0) }\nrevolute O: ground - crank\ndrive crank = 0 deg .. 180 deg in 3 steps
find T = 10 N*m*t(angle(crank))\n";
    let sheet = report(text, &["--sheet", "--format", "html"]);
    let plot = sheet.split_once("id=\"table-t").expect("a plot").1.split_once("</svg>").unwrap().0;
    // a dot for each point
    assert_eq!(plot.matches("<circle").count(), 3, "{plot}");
    for tick in [">0<", ">180<", ">1.00<"] {
        assert!(plot.contains(tick), "{tick}: {plot}");
    }
}

/// What is asked for is not given: a dead position, an equilibrium, a mass centre, the end of the period.
#[test]
fn what_is_asked_is_not_given() {
    for (text, answer) in [
        (include_str!("../../examples/drives/dead-positions.mech"), "198.2"),
        (include_str!("../../examples/equilibrium/bar-on-a-spring.mech"), "62.9"),
        (include_str!("../../examples/masses/disc-with-a-hole.mech"), "0.0061"),
        (include_str!("../../examples/simulation/press-in-its-steady-turn.mech"), "0.357"),
    ] {
        let sheet = report(text, &["--sheet"]);
        assert!(!sheet.contains(answer), "{answer}: {sheet}");
    }
}

/// The names that count are those of statements, whatever words a sentence has.
#[test]
fn words_of_the_text_are_no_statements() {
    let rows = "given Q = 60 N\ngiven f = 0.1\ngiven key = 3 N\nexpect H = key within 500 N\nvariants {\n  variant, Q [N], f, key [N]\n  A1, 60, 0.1, 3\n  A2, 70, 0.2, 4\n}\n";
    let loads = LOADS.replace("120 N", "Q").replace("80 N", "700 N");
    for sentence in
        ["There are three variants.", "expect the key of the variants {", "given Q and f: find H."]
    {
        let text = block(" { friction f }", &loads, rows).replace("Find the holding force.", sentence);
        let sheet = words(&report_warned(&text, &["--sheet"]));
        assert!(sheet.contains("Variant Q, N f A1 60 0.1 A2 70 0.2"), "{sheet}");
    }
}

/// What differs follows from the columns, whichever row it differs in, and is given by its formula.
#[test]
fn what_follows_from_a_column_is_no_number() {
    let loads = LOADS.replace("120 N", "2*Q").replace("80 N", "(700 N + d)");
    let rows = |rows: &str| {
        format!(
            "given Q = 60 N\ngiven a = 10 N\ngiven b = 5 N\nlet d = a - b\nvariants {{\n  Q [N], a [N], b [N]\n{rows}}}\n"
        )
    };
    let same = "  60, 10, 5\n".repeat(4);
    let fifth = given(&block("", &loads, &rows(&format!("{same}  90, 10, 5\n"))));
    // a − b is 5 N in every row but one
    let cancels = given(&block("", &loads, &rows("  60, 10, 5\n  60, 12, 7\n  60, 11, 6\n  60, 10, 6\n")));
    let none = given(&block("", &loads, &rows(&same)));
    for given in [fifth, cancels, none] {
        for words in ["F = 2·Q to the right", "G = (700 N + d) downwards", "d = a − b"] {
            assert!(given.contains(words), "{words}: {given}");
        }
    }
}

/// The coefficient is that of the file, beside what makes it more.
#[test]
fn friction_is_given_as_the_file_has_it() {
    for (friction, data, not) in [
        ("friction 0.1; groove 30 deg", &["f_P = 0.1;", "β_P = 30°"][..], "0.2"),
        ("friction 0.15; groove 45 deg", &["f_P = 0.15;", "β_P = 45°"], "0.212"),
        (
            "groove round; friction 0.1; fit even",
            &["half-round groove;", "f_P = 0.1;", "pressure even over the contact"],
            "0.157",
        ),
        ("groove round; friction 0.1; fit 1.2", &["f_P = 0.1;", "k_P = 1.2"], "0.12"),
        ("groove round; friction 0.1", &["f_P = 0.1"], "k_P"),
        ("friction 0.1", &["f_P = 0.1"], "β"),
    ] {
        let text = block(&format!(" {{ {friction} }}"), LOADS, "");
        let given_here = given(&text.replace("120 N", "900 N").replace("80 N", "1000 N"));
        assert!(data.iter().all(|datum| given_here.contains(datum)), "{friction}: {given_here}");
        assert!(!given_here.contains(not), "{friction}: {given_here}");
    }
    let page = report(&block(" { friction 0.1; groove 30 deg }", LOADS, ""), &[]);
    assert!(page.contains("sin β_P") && page.contains("0.2"), "{page}");
    let belt = include_str!("../../examples/trains/belt-with-friction.mech");
    assert!(!given(belt).contains("0.9213"), "{}", given(belt));
}

/// What the sheets of the cases give, line by line.
#[test]
fn data_are_told_as_the_file_has_them() {
    for (text, lines) in [
        (
            include_str!("../cases/use4/sheets/sheet-brake.mech"),
            &[
                "Brake b on drum: pull on the slack end F = 50 N; coefficient of friction f_b = 0.3; radius of friction r = 150 mm; angle of contact α = 240°",
                "Drive drum: speed n_drum = 300 rpm",
            ][..],
        ),
        (
            include_str!("../cases/use4/sheets/sheet-cam.mech"),
            &[
                "base radius r_0 = 40 mm; speed n = 240 rpm; turning counterclockwise; translating roller follower; roller radius r_r = 10 mm; offset e = 12 mm; rise Φ_1 = 120° through h_1 = 30 mm cycloidal; dwell Φ_2 = 60°; fall Φ_3 = 120° harmonic; dwell Φ_4 = 60°",
            ],
        ),
        (
            include_str!("../cases/use4/sheets/sheet-gear-pair.mech"),
            &["z_1 = 20; module m = 2 mm", "z_2 = 50", "Drive I: speed n_I = 600 rpm"],
        ),
        (
            include_str!("../cases/use4/sheets/sheet-screw.mech"),
            &[
                "lead h = 5 mm; mean diameter d = 19.5 mm; coefficient of friction f_k = 0.12; angle of the flank β = 15°",
                "force Q = 20 kN against the motion",
            ],
        ),
        (
            include_str!("../cases/use4/sheets/sheet-v-groove.mech"),
            &["f_P = 0.1; half-angle of the V-groove β_P = 30°"],
        ),
        (
            include_str!("../cases/use4/sheets/sheet-half-cylinder.mech"),
            &["half-round groove; coefficient of friction f_P = 0.1; pressure even over the contact"],
        ),
        (
            include_str!("../cases/use4/sheets/sheet-lacks-inertia-and-damper.mech"),
            &[
                "J_S = 0.2 kg·m²",
                "c_c = 100 N/m; length without force l_0,c = 0.3 m; damping k_c = 40 N·s/m",
                "Ground: D (0.6 m; −0.3 m)",
            ],
        ),
        (
            include_str!("../cases/use4/sheets/sheet-loses-given.mech"),
            &["force F = 120 N to the right at B", "force Q = 80 N downwards at B"],
        ),
        (
            include_str!("../cases/use4/sheets/sheet-without-curve-and-speed.mech"),
            &[
                "Table of t, straight between the points, repeated periodically",
                "k 0 1 0 0 −0.15 0 −0.2 0",
                "torque T = M_max·t(φ_crank)",
                "n_crank = 300 rpm",
                "coefficient of fluctuation d",
                "Positions: φ_crank = 0° to 720° in 8 steps",
            ],
        ),
        (
            include_str!("../cases/use4/sheets/homework.mech"),
            &[
                "length r Link rod: length l; S (l/3; 0); mass m_rod = 1.8 kg at S",
                "force P = p downwards at C",
                "Position: φ_crank = φ",
            ],
        ),
        (
            include_str!("../cases/use4/sheets/sheet-fifth-row.mech"),
            &["F = 2·Q to the right", "G = 700 N downwards"],
        ),
    ] {
        let given = given(text);
        for words in lines {
            assert!(given.contains(words), "{words}: {given}");
        }
    }
    let boom = given(include_str!("../cases/use4/sheets/sheet-noise-and-names.mech"));
    assert!(boom.contains("Position: s_c = 800 mm") && !boom.contains("e−") && !boom.contains("′"), "{boom}");
}

/// Headings of positions have the drives, a line of events their condition.
#[test]
fn positions_and_events_are_told() {
    let yoke = words(&report_warned(
        include_str!("../cases/use4/sheets/sheet-positions-and-event-poses.mech"),
        &["--sheet"],
    ));
    for words in ["Event top: M > 3 N·m", "(φ_crank = 30°)", "(φ_crank = 300°)"] {
        assert!(yoke.contains(words), "{words}: {yoke}");
    }
    let turn = report(include_str!("../cases/use4/sheets/grade-any-turn.mech"), &["--sheet"]);
    assert!(turn.contains("The motion ends when ω_rotor = 0 rad/s"), "{turn}");
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(crate::share::part(10)) })]

    /// Planetary trains by teeth: only the numbers of teeth are given, and no radius is on any page.
    #[test]
    fn trains_by_teeth_have_no_radii(sun in 12_u32..60, planet in 12_u32..60, torque in 1_u32..90, ring_turns: bool) {
        let ring = sun + 2 * planet;
        let text = if ring_turns {
            TRAIN.replace("ground { wheel r teeth 84 }", "shaft ring { wheel r teeth 84 }\nground { }")
                .replace("drive sun at 900 rpm", "drive sun at 900 rpm\ndrive ring at 100 rpm")
                .replace("balance torque Mc on carrier", "balance torque Mc on carrier\nbalance torque Mr on ring")
        } else {
            TRAIN.to_owned()
        };
        let text = text.replace("teeth 24", &format!("teeth {sun}")).replace("teeth 30", &format!("teeth {planet}"));
        let text = text.replace("teeth 84", &format!("teeth {ring}")).replace("= 40 N*m", &format!("= {torque} N*m"));
        let sheet = report(&text, &["--sheet"]);
        let page = report(&text, &[]);
        for text in [part(&sheet, "Given", "Find"), &page] {
            prop_assert!(!text.contains("r_p") && !text.contains("r_r") && !text.contains("r_s"), "{}", text);
            prop_assert!(!text.split_whitespace().any(|word| word == "m"), "{}", text);
        }
        prop_assert!(part(&sheet, "Given", "Find").contains(&format!(" {ring}")), "{}", sheet);
    }

    /// Tables of variants: each page has the number, the name and the values of its row, and no other row's.
    #[test]
    fn pages_of_rows_have_their_names(names in prop::collection::btree_set("[A-Z][a-z0-9_]{0,9}", 2..6), first in 60_u32..200) {
        let names: Vec<&String> = names.iter().collect();
        let row = |(i, name): (usize, &&String)| format!("  {name}, {}, 500, 900, 2, 3, 40\n", first + 3 * i as u32);
        let rows: String = names.iter().enumerate().map(row).collect();
        let head = "  variant, r [mm], l [mm], n [rpm], m [kg], P [kN], phi [deg]\n";
        let text = format!("{}variants {{\n{head}{rows}}}\n", ROWS.split("variants {").next().unwrap());
        let text = text.replace("Slider-crank with", "<{variant}> & slider-crank with");
        let folder = Folder::new("sheet-random").with("a.mech", &text);
        let out = assur(&folder, &["report", "a.mech", "--sheet", "--per-row", "-o", "s.html"]);
        prop_assert_eq!((out.status, out.stderr.as_str()), (0, ""));
        for (i, name) in names.iter().enumerate() {
            let page = folder.read(&format!("s-{}-{name}.html", i + 1));
            let title = format!("&lt;{name}&gt; &amp; slider-crank with a crank of {} mm", first + 3 * i as u32);
            prop_assert!(page.contains(&title), "{}", title);
            let head = format!("Variant {} ({name})", i + 1);
            prop_assert!(page.contains(&head), "{}", head);
            prop_assert!(!page.contains('{') || !page.contains("variant}"), "{}", name);
        }
    }
}
