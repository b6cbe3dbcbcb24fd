//! The command line: exit status, streams, formats, names of files.

use crate::run::{self, Folder, assur};

const GOOD: &str = r#"mech 1
mechanism "Crank-slider"
given r = 100 mm
ground { A (0, 0); line guide through A along 0 deg }
link crank A-B r
link rod   B-C 350 mm
link piston { C (0, 0) }
revolute  A: ground - crank
revolute  B: crank - rod
revolute  C: rod - piston
prismatic D: piston.C - ground.guide
drive crank = 0 deg, 90 deg at 100 rad/s
assemble C ahead of B
find x_C = position(C).x as mm, v_C = velocity(C)
expect x_C = 450 mm within 1e-9 at pose 1
"#;

/// A name that nobody declares.
const BAD: &str = "mechanism \"Bad\"\nlink crank A-B rr\n";

fn failing() -> String {
    GOOD.replace("450 mm", "451 mm")
}

#[test]
fn a_good_file_is_fine() {
    let folder = Folder::new("good").with("a.mech", GOOD);
    for command in ["check", "solve", "test"] {
        let out = assur(&folder, &[command, "a.mech"]);
        assert_eq!((out.status, out.stderr.as_str()), (0, ""), "{command}");
        assert!(!out.stdout.is_empty(), "{command}");
    }
}

#[test]
fn a_wrong_file_is_told_on_standard_error() {
    let folder = Folder::new("wrong").with("a.mech", BAD).with("empty.mech", "");
    for command in ["check", "solve", "test"] {
        let out = assur(&folder, &[command, "a.mech"]);
        assert_eq!(out.status, 1, "{command}");
        assert!(out.stderr.contains("a.mech:2:") && out.stderr.contains("rr"), "{command}: {}", out.stderr);
        let empty = assur(&folder, &[command, "empty.mech"]);
        assert_eq!(empty.status, 1, "{command}");
        assert!(empty.stderr.contains("mech::syntax::empty_file"), "{command}: {}", empty.stderr);
    }
    assert_eq!(assur(&folder, &["solve", "a.mech"]).stdout, "");
}

#[test]
fn what_cannot_be_used_ends_with_2() {
    let folder = Folder::new("unusable").with("latin1.mech", "").with("empty/readme.txt", "no program");
    folder.write_bytes("latin1.mech", b"mechanism \"Kurbel \xfc\"\n");
    for (name, says) in [
        ("missing.mech", "there is no file or folder `missing.mech`"),
        ("latin1.mech", "byte 19 cannot be read"),
        ("empty", "no .mech file in the folder `empty`"),
        ("*.nothing", "no file matches `*.nothing`"),
        ("[a", "not a pattern"),
    ] {
        let out = assur(&folder, &["check", name]);
        assert_eq!((out.status, out.stdout.as_str()), (2, ""), "{name}");
        assert!(out.stderr.contains(says), "{name}: {}", out.stderr);
    }
    for args in
        [&["solve"][..], &["sulve", "a"], &["solve", "a", "--format", "xml"], &["solve", "a", "--set", "r"]]
    {
        let out = assur(&folder, args);
        assert_eq!((out.status, out.stdout.as_str()), (2, ""), "{args:?}");
        assert!(!out.stderr.is_empty(), "{args:?}");
    }
}

#[test]
fn one_bad_file_does_not_spoil_the_others() {
    let folder = Folder::new("among").with("a.mech", GOOD).with("b.mech", BAD).with("c.mech", GOOD);
    let out = assur(&folder, &["solve", ".", "--format", "json"]);
    assert_eq!(out.status, 1);
    let lines: Vec<serde_json::Value> =
        out.stdout.lines().map(|l| serde_json::from_str(l).unwrap()).collect();
    let files: Vec<&str> = lines.iter().filter_map(|v| v["file"].as_str()).collect();
    assert_eq!(files, ["a.mech", "b.mech", "c.mech"]);
    assert_eq!(lines[2]["poses"][0]["quantities"]["x_C"], 0.45);
    assert!(lines[1].get("poses").is_none());
    assert!(!lines[1]["diagnostics"].as_array().unwrap().is_empty());
    let out = assur(&folder, &["test", "a.mech", "nowhere.mech", "c.mech"]);
    assert_eq!(out.status, 2);
    assert_eq!(
        out.stdout,
        "a.mech: 1 expectation met\nc.mech: 1 expectation met\n\
         total: 3 files, 2 expectations met, 0 failed, 1 file not tested\n"
    );
}

#[test]
fn folders_globs_and_standard_input() {
    let folder = Folder::new("names")
        .with("a.mech", GOOD)
        .with("notes.txt", "no program")
        .with("deep/b.mech", GOOD)
        .with("deep/er/c.mech", GOOD);
    let tested = |names: &[&str]| {
        let args: Vec<&str> = ["test"].iter().chain(names).copied().collect();
        let out = assur(&folder, &args);
        let files = out.stdout.lines().filter_map(|l| l.split_once(':')).map(|l| l.0.replace('\\', "/"));
        files.filter(|name| name != "total").collect::<Vec<_>>()
    };
    assert_eq!(tested(&["."]), ["a.mech", "deep/b.mech", "deep/er/c.mech"]);
    assert_eq!(tested(&["deep"]), ["deep/b.mech", "deep/er/c.mech"]);
    assert_eq!(tested(&["**/*.mech"]), ["a.mech", "deep/b.mech", "deep/er/c.mech"]);
    assert_eq!(tested(&["./*.mech"]), ["a.mech"]);
    assert_eq!(tested(&["deep/*.mech", "a.mech", "deep/b.mech"]), ["deep/b.mech", "a.mech"]);
    assert_eq!(tested(&["deep/**/{c,d}.mech"]), ["deep/er/c.mech"]);
    let out = run::with_input(&folder, &["test", "-"], GOOD);
    assert_eq!((out.status, out.stdout.as_str()), (0, "-: 1 expectation met\n"));
}

#[test]
fn table_is_for_reading() {
    let folder = Folder::new("table").with("a.mech", GOOD);
    let out = assur(&folder, &["solve", "a.mech"]);
    assert_eq!(out.stdout, assur(&folder, &["solve", "a.mech", "--format", "table"]).stdout);
    let (answers, accuracy) = out.stdout.split_once("Accuracy").unwrap();
    let worst = accuracy.lines().nth(1).unwrap();
    assert!(worst.starts_with("  worst of 2 poses: closure "), "{accuracy}");
    assert!(worst.ends_with(", condition 0.958 at pose 2") && accuracy.lines().count() == 2, "{accuracy}");
    let full = assur(&folder, &["solve", "a.mech", "--accuracy"]).stdout;
    let (before, table) = full.split_once("Accuracy").unwrap();
    assert!(before == answers && table.lines().count() == 5, "{full}");
    assert!(table.lines().nth(4).unwrap().ends_with("  0.958"), "{table}");
    insta::assert_snapshot!(answers, @r"
    Crank-slider (a.mech)

    Structure
      mobility  F = 3·3 − 2·4 = 1
      groups    crank (I, driven); rod, piston (II, RRP)
      effects   velocities

    Answers
      pose  crank [deg]  x_C [mm]  v_C.x [m/s]  v_C.y [m/s]
      ────  ───────────  ────────  ───────────  ───────────
      1               0    450               0            0
      2              90    335.41          -10            0

    Expectations
      1 of 1 expectation met
    ");
}

#[test]
fn reactions_of_many_poses_have_a_table_per_pair() {
    let text = |poses: &str| {
        let text = GOOD.replace("find x_C", "balance torque M on crank\nfind reactions, x_C");
        text.replace("0 deg, 90 deg", poses).replace("C (0, 0) }", "C (0, 0); mass 2 kg at C }")
    };
    let folder = Folder::new("reactions").with("a.mech", &text("0 deg, 90 deg, 180 deg"));
    let few = assur(&folder, &["solve", "a.mech"]).stdout;
    assert!(few.contains("\nReactions\n  pose  pair  from → on") && !few.contains("Reaction in"), "{few}");
    folder.write_bytes("a.mech", text("0 deg, 90 deg, 180 deg, 270 deg").as_bytes());
    let many = assur(&folder, &["solve", "a.mech"]).stdout;
    let (_, slide) =
        many.split_once("\nReaction in D: piston → ground\n").unwrap_or_else(|| panic!("{many}"));
    let rows: Vec<&str> = slide.lines().take_while(|line| !line.is_empty()).collect();
    assert!(rows.len() == 6 && rows[2].starts_with("  1     ") && rows[5].starts_with("  4     "), "{slide}");
    assert_eq!(many.matches("\nReaction in ").count(), 4, "{many}");
    // along the guide there is nothing but rounding errors
    assert!(rows[2..].iter().all(|row| row.split_whitespace().nth(1) == Some("0")), "{slide}");
}

#[test]
fn several_files_have_a_few_lines_each() {
    let rows = "given r = 1 mm\nlet y = 2*r\nfind y\nvariants {\n  r [mm]\n  1\n  2\n}\n";
    let folder = Folder::new("brief").with("a.mech", GOOD).with("b.mech", rows);
    folder.write_bytes("c.mech", GOOD.replace("0 deg, 90 deg", "90 deg").replace("at pose 1", "").as_bytes());
    let out = assur(&folder, &["solve", "."]);
    assert_eq!((out.status, out.stderr.as_str()), (0, ""));
    insta::assert_snapshot!(out.stdout, @r"
    Crank-slider (a.mech)
      F = 1, 2 poses, 1 of 1 expectation met
      x_C = 335.41 … 450 mm, |v_C| = 0 … 10 m/s

    b.mech
      row 1 of 2
      y = 2 mm

    Crank-slider (c.mech)
      F = 1, 0 of 1 expectation met
      x_C = 335.41 mm, v_C = (-10, 0) m/s

    `assur solve FILE` prints one file in full.
    ");
    let full = assur(&folder, &["solve", ".", "--accuracy"]).stdout;
    assert!(full.matches("\nStructure\n").count() == 2 && !full.contains("in full"), "{full}");
}

#[test]
fn the_page_of_the_readme_is_what_the_program_prints() {
    let readme = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/README.md")).unwrap();
    let (_, rest) = readme.split_once("```mech\n").unwrap();
    let (file, rest) = rest.split_once("```\n\n```text\n").unwrap();
    let (page, _) = rest.split_once("```\n").unwrap();
    let out = assur(&Folder::new("readme").with("engine.mech", file), &["solve", "engine.mech"]);
    assert_eq!((out.status, out.stderr.as_str()), (0, ""));
    assert_eq!(out.stdout, page);
}

#[test]
fn markdown_is_for_pasting() {
    let folder = Folder::new("markdown").with("a.mech", GOOD);
    let out = assur(&folder, &["solve", "a.mech", "--format", "markdown"]);
    assert!(out.stdout.starts_with("# Crank-slider (a.mech)\n\n## Structure\n"), "{}", out.stdout);
    assert!(out.stdout.contains("| pose | crank \\[deg\\] | x\\_C \\[mm\\] |"), "{}", out.stdout);
    assert!(out.stdout.contains("| 2 | 90 | 335.41 | -10 | 0 |"), "{}", out.stdout);
}

#[test]
fn csv_has_one_row_per_pose() {
    let folder = Folder::new("csv").with("a.mech", GOOD).with("b.mech", GOOD);
    let out = assur(&folder, &["solve", "a.mech", "--format", "csv"]);
    let lines: Vec<&str> = out.stdout.split("\r\n").collect();
    assert_eq!(lines[0], "pose,crank [deg],x_C [mm],v_C.x [m/s],v_C.y [m/s]");
    let numbers = |line: &str| line.split(',').map(|n| n.parse::<f64>().unwrap()).collect::<Vec<_>>();
    for (line, wanted) in
        [(1, [1.0, 0.0, 450.0, 0.0, 0.0]), (2, [2.0, 90.0, 335.410_196_624_968, -10.0, 0.0])]
    {
        let got = numbers(lines[line]);
        assert!(got.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 1e-9), "{got:?}");
    }
    assert_eq!(lines[3..], [""]);
    let both = assur(&folder, &["solve", ".", "--format", "csv"]);
    let of = |file: &str| {
        let lines = out.stdout.split_terminator("\r\n").enumerate();
        lines.map(|(i, l)| format!("{},{l}\r\n", if i == 0 { "file" } else { file })).collect::<String>()
    };
    assert_eq!(both.stdout, format!("{}\r\n{}", of("a.mech"), of("b.mech")));
}

#[test]
fn csv_of_several_files_names_the_file() {
    let rows = "given r = 1 mm\nlet y = 2*r\nfind y\nvariants {\n  r [mm]\n  1\n  2\n}\n";
    let long = GOOD.replace("0 deg, 90 deg", "0 deg .. 359 deg in 30000 steps");
    let folder =
        Folder::new("csv_files").with("rows.mech", rows).with("a.mech", GOOD).with("b,c.mech", &long);
    let csv = |names: &[&str]| {
        let args = [&["solve", "--format", "csv"], names].concat();
        let out = assur(&folder, &args);
        assert_eq!((out.status, out.stderr.as_str()), (0, ""), "{names:?}");
        out.stdout
    };
    let both = csv(&["rows.mech", "b,c.mech"]);
    let (table, sweep) = both.split_once("\r\n\r\n").unwrap();
    assert_eq!(table, "file,row,r [mm],pose,y [mm]\r\nrows.mech,1,1,,2\r\nrows.mech,2,2,,4");
    assert!(sweep.starts_with("file,pose,crank [deg],x_C [mm],"), "{}", &sweep[..80]);
    assert!(sweep.lines().skip(1).all(|l| l.starts_with("\"b,c.mech\",")) && sweep.lines().count() == 30_002);
    assert!(csv(&["rows.mech"]).starts_with("row,r [mm],"), "one file needs no name");
}

#[test]
fn json_is_one_line_in_si() {
    let folder = Folder::new("json").with("a.mech", GOOD);
    let out = assur(&folder, &["solve", "a.mech", "--format", "json"]);
    assert_eq!(out.stdout.lines().count(), 1);
    insta::assert_snapshot!(run::rounded(&out.stdout), @r#"{"schema":"assur.solution/1","file":"a.mech","mechanism":"Crank-slider","structure":{"mobility":1,"links":3,"lower_pairs":4,"higher_pairs":0,"groups":[{"links":["rod","piston"],"class":"II","kind":"RRP","n":2,"pl":3,"ph":0}]},"effects":["velocities"],"poses":[{"name":"1","drives":{"crank":0.0},"quantities":{"x_C":0.45,"v_C":[0.0,0.0]},"condition":1.0},{"name":"2","drives":{"crank":1.570796},"quantities":{"x_C":0.33541,"v_C":[-10.0,0.0]},"condition":0.958315}],"expectations":[{"text":"x_C","pose":"1","expected":0.45,"got":0.45,"within":0.0,"passed":true}],"diagnostics":[]}"#);
}

#[test]
fn values_are_set_from_outside() {
    let folder = Folder::new("set").with("a.mech", GOOD);
    let solved = |setting: &str| assur(&folder, &["solve", "a.mech", "--format", "csv", "--set", setting]);
    assert!(solved("r=120mm").stdout.contains("\r\n1,0,470,"), "{}", solved("r=120mm").stdout);
    assert!(solved("r = 0.12 m").stdout.contains("\r\n1,0,470,"));
    for wrong in ["r=120", "r=120 kg", "radius=120mm"] {
        let out = solved(wrong);
        assert_eq!((out.status, out.stdout.as_str()), (2, ""), "{wrong}");
        assert!(out.stderr.contains("mech::"), "{wrong}: {}", out.stderr);
    }
}

#[test]
fn failed_expectations_fail_the_test_alone() {
    let folder = Folder::new("expect").with("a.mech", &failing());
    let solved = assur(&folder, &["solve", "a.mech"]);
    assert_eq!((solved.status, solved.stderr.as_str()), (0, ""));
    assert!(solved.stdout.contains("1 of 1 FAIL"), "{}", solved.stdout);
    let tested = assur(&folder, &["test", "a.mech"]);
    assert_eq!((tested.status, tested.stdout.as_str()), (1, "a.mech: 0 expectations met, 1 failed\n"));
    insta::assert_snapshot!(tested.stderr, @r"
    mech::expect::mismatch

      × expected x_C = 451 mm at pose 1, got 450 mm
        ╭─[a.mech:15:1]
     14 │ find x_C = position(C).x as mm, v_C = velocity(C)
     15 │ expect x_C = 451 mm within 1e-9 at pose 1
        · ────────────────────┬────────────────────
        ·                     ╰── off by 1 mm, allowed 4.51e-7 mm
        ╰────
    ");
}

#[test]
fn a_test_of_several_files_ends_with_a_total() {
    let rows = "given r = 1 mm\nlet y = 2*r\nexpect y = key within 1e-9\n\
                variants {\n  r [mm], key [mm]\n  1, 2\n  2, 4\n  3, 7\n}\n";
    let folder = Folder::new("total").with("a.mech", GOOD).with("b.mech", rows).with("c.mech", &failing());
    let last = |args: &[&str]| {
        let out = assur(&folder, args);
        (out.status, out.stdout.lines().last().unwrap_or_default().to_owned())
    };
    let all = "total: 3 files, 3 rows, 3 expectations met, 2 failed".to_owned();
    assert_eq!(last(&["test", "."]), (1, all));
    folder.write_bytes("d.mech", BAD.as_bytes());
    let with_error = "total: 4 files, 3 rows, 3 expectations met, 2 failed, 1 not solved, 1 error".to_owned();
    assert_eq!(last(&["test", "."]), (1, with_error));
    assert_eq!(last(&["test", "a.mech"]), (0, "a.mech: 1 expectation met".to_owned()));
}

#[test]
fn colours_are_for_terminals() {
    let folder = Folder::new("colour").with("a.mech", GOOD).with("b.mech", BAD);
    let coloured = |args: &[&str]| {
        let out = assur(&folder, args);
        (out.stdout.contains('\u{1b}'), out.stderr.contains('\u{1b}'))
    };
    assert_eq!(coloured(&["solve", "."]), (false, false));
    assert_eq!(coloured(&["solve", ".", "--color", "never"]), (false, false));
    assert_eq!(coloured(&["solve", ".", "--color", "always"]), (true, true));
    assert_eq!(coloured(&["--color=always", "solve", "."]), (true, true));
    assert_eq!(coloured(&["solve", ".", "--color", "always", "--format", "json"]), (false, true));
}

#[test]
fn explanations() {
    let folder = Folder::new("explain");
    let all = assur(&folder, &["explain", "--all"]);
    assert_eq!(all.status, 0);
    for code in all.stdout.lines() {
        let page = assur(&folder, &["explain", code.trim_start_matches("mech::")]);
        assert_eq!(page.status, 0, "{code}");
        assert!(page.stdout.starts_with(&format!("# {code}\n")), "{code}: {}", page.stdout);
    }
    let unknown = assur(&folder, &["explain", "mech::no::such"]);
    assert_eq!((unknown.status, unknown.stdout.as_str()), (2, ""));
    assert!(unknown.stderr.contains("no diagnostic `mech::no::such`"), "{}", unknown.stderr);
    assert_eq!(assur(&folder, &["explain"]).status, 2);
}

/// The lines with single blanks; in a row with an error and its digits the time before them is left out.
fn plain_rows(tables: &str) -> String {
    let line = |line: &str| {
        let mut words: Vec<&str> = line.split_whitespace().collect();
        words.iter_mut().filter(|w| w.starts_with('─')).for_each(|w| *w = "─");
        if let [.., time, error, digits] = &mut words[..]
            && error.contains("e-")
            && [&**time, error, digits].iter().all(|word| word.parse::<f64>().is_ok())
        {
            *time = "µs";
        }
        format!("{}{}\n", if line.starts_with(' ') { " " } else { "" }, words.join(" "))
    };
    tables.lines().map(line).collect()
}

/// Times decide nothing: they are left out, and with them the widths of their columns.
#[test]
fn accuracy_is_measured() {
    let folder = Folder::new("accuracy").with("a.mech", GOOD);
    let out = assur(&folder, &["accuracy", "a.mech", "--for", "1e-6", "--plot", "a.svg"]);
    assert_eq!((out.status, out.stderr.as_str()), (0, ""));
    let (tables, recommended) = out.stdout.split_once("For an error of 1e-6").unwrap();
    assert!(recommended.contains("scalar: ") && recommended.contains("of a whole solve"), "{recommended}");
    let sets = ["no AVX2", "Neon", "AVX2", "AVX-512"];
    let tables =
        sets.iter().fold(tables.to_owned(), |text, set| text.replace(&format!(" with {set}."), " with …."));
    if cfg!(feature = "lanes") {
        insta::assert_snapshot!(plain_rows(&tables), @r"
            Crank-slider (a.mech)

            Measured
             2 positions, compared with the same positions in double-double, whose own error is about 2e-31.
             Errors are the greatest over all positions: positions relative to 0.35 m, velocities relative to 35 m/s.
             Times are the best of repeated runs, on one thread; lanes are 8 wide with ….

            Scalar: the number type of every position
             numbers µs per position error digits
             ─ ─ ─ ─
             f32 µs 5e-8 7.3
             f64 in lanes µs 2e-16 15.8
             f64 µs 2e-16 15.8
             double-double µs 3e-31 30.6

            Settings without effect here
             - friction: none in this problem
             - general groups: none in this problem
             - triads: none in this problem
             - samples: no functions over the cycle
            ");
    } else {
        insta::assert_snapshot!(plain_rows(&tables), @r"
            Crank-slider (a.mech)

            Measured
             2 positions, compared with the same positions in double-double, whose own error is about 2e-31.
             Errors are the greatest over all positions: positions relative to 0.35 m, velocities relative to 35 m/s.
             Times are the best of repeated runs, on one thread.

            Scalar: the number type of every position
             numbers µs per position error digits
             ─ ─ ─ ─
             f64 µs 2e-16 15.8
             double-double µs 3e-31 30.6

            Settings without effect here
             - f32, lanes: built without the feature `lanes`
             - friction: none in this problem
             - general groups: none in this problem
             - triads: none in this problem
             - samples: no functions over the cycle
            ");
    }
    let svg = folder.read("a.svg");
    assert!(svg.starts_with("<svg") && svg.contains("time, µs") && svg.contains(">double-double<"), "{svg}");
    let out = assur(&folder, &["accuracy", "a.mech", "--format", "json", "--set", "r=120mm"]);
    let value: serde_json::Value = serde_json::from_str(&out.stdout).unwrap();
    assert_eq!(
        (&value["schema"], &value["reference"]),
        (&"assur.accuracy/1".into(), &"double-double".into())
    );
    let rows = value["knobs"][0]["settings"].as_array().unwrap();
    let names: Vec<&str> = rows.iter().filter_map(|r| r["setting"].as_str()).collect();
    let all = ["f32", "f64 in lanes", "f64", "double-double"];
    assert_eq!(names, if cfg!(feature = "lanes") { &all[..] } else { &all[2..] });
    assert!(rows.iter().all(|r| r["microseconds"].as_f64().unwrap() > 0.0));
}

#[test]
fn accuracy_that_cannot_be_had_is_an_error() {
    let folder = Folder::new("beyond").with("a.mech", GOOD).with("b.mech", GOOD);
    let out = assur(&folder, &["solve", "a.mech", "--within", "1e-18"]);
    assert_eq!(out.status, 1);
    assert!(out.stderr.contains("mech::accuracy::out_of_reach"), "{}", out.stderr);
    assert!(out.stdout.contains("335.41") && out.stdout.contains("double-double"), "{}", out.stdout);
    for args in [&["solve", "a.mech", "--within", "2"][..], &["accuracy", "a.mech", "--for", "0"]] {
        assert_eq!(assur(&folder, args).status, 2, "{args:?}");
    }
    let out = assur(&folder, &["accuracy", "a.mech", "b.mech", "--plot", "p.svg"]);
    assert_eq!((out.status, out.stdout.as_str()), (2, ""));
    assert!(out.stderr.contains("p.svg") && !folder.names().contains(&"p.svg".to_owned()), "{}", out.stderr);
    let out = assur(&folder, &["accuracy", "a.mech", "--set", "nothing=1mm"]);
    assert_eq!(out.status, 2);
}

#[test]
fn what_was_chosen_for_an_accuracy_is_said() {
    let folder = Folder::new("within").with("a.mech", GOOD);
    let out = assur(&folder, &["solve", "a.mech", "--within", "1e-6"]);
    assert_eq!((out.status, out.stderr.as_str()), (0, ""));
    assert!(out.stdout.contains("within 1e-6: "), "{}", out.stdout);
    let out = assur(&folder, &["solve", "a.mech", "--within", "1e-6", "--format", "json"]);
    let value: serde_json::Value = serde_json::from_str(&out.stdout).unwrap();
    let said = &value["accuracy"];
    assert_eq!((&said["within"], &said["numbers"]), (&1e-6.into(), &"f64".into()));
    assert!(said["error"].as_f64().unwrap() < 1e-14, "{said}");
    let plain = assur(&folder, &["solve", "a.mech", "--format", "json"]);
    let plain: serde_json::Value = serde_json::from_str(&plain.stdout).unwrap();
    assert!(plain.get("accuracy").is_none(), "{plain}");
    let out = assur(&folder, &["batch", "a.mech", "--within", "1e-9", "--format", "jsonl"]);
    let value: serde_json::Value = serde_json::from_str(&out.stdout).unwrap();
    assert_eq!(value["accuracy"]["within"], 1e-9);
    assert!(out.stderr.contains("within 1e-9: greatest error of all rows "), "{}", out.stderr);
}

#[test]
fn help_and_version_go_to_standard_output() {
    let folder = Folder::new("help");
    for args in [&["--help"][..], &["-h"], &["help"], &["--version"], &["solve", "--help"]] {
        let out = assur(&folder, args);
        assert_eq!((out.status, out.stderr.as_str()), (0, ""), "{args:?}");
        assert!(out.stdout.contains("assur"), "{args:?}: {}", out.stdout);
    }
    let help = assur(&folder, &["--help"]).stdout;
    for part in ["check", "solve", "test", "batch", "accuracy", "explain", "Exit status"] {
        assert!(help.contains(part), "{part}");
    }
}

#[test]
fn a_reader_that_goes_away_is_no_error() {
    let folder = Folder::new("pipe");
    for i in 0..40 {
        folder.write_bytes(&format!("{i}.mech"), GOOD.as_bytes());
    }
    let stderr = run::with_closed_output(&folder, &["solve", "."]);
    assert_eq!(stderr, "");
    let stderr = run::with_closed_output(&folder, &["explain", "--all"]);
    assert_eq!(stderr, "");
}

const CAM: &str = r#"cam plate {
  base_radius 50 mm
  turning ccw
  follower translating roller { radius 10 mm }
  rise 90 deg through 20 mm cycloidal
  fall 90 deg cycloidal
}
"#;

#[test]
fn a_profile_is_printed_in_every_format() {
    let two = format!("{CAM}{}", CAM.replace("plate", "other"));
    let folder = Folder::new("profile").with("a.mech", CAM).with("two.mech", &two).with("none.mech", GOOD);
    let csv = assur(&folder, &["profile", "a.mech", "--steps", "4"]);
    assert_eq!((csv.status, csv.stdout.lines().count()), (0, 5), "{}", csv.stderr);
    assert!(csv.stdout.starts_with("cam angle [deg],s [mm],s' [mm],"), "{}", csv.stdout);
    // at the end of the rise the profile stands 60 mm from the centre, a quarter turn against the cam
    let row = csv.stdout.lines().nth(2).unwrap_or_default();
    let cells: Vec<f64> = row.split(',').map(|c| c.parse().unwrap_or(f64::NAN)).collect();
    assert_eq!(&cells[..2], &[90.0, 20.0], "{row}");
    assert!(cells[7].abs() < 1e-12 && (cells[8] + 60.0).abs() < 1e-12, "{row}");
    let dxf = assur(&folder, &["profile", "a.mech", "--steps", "12", "--format", "dxf"]);
    assert_eq!((dxf.status, dxf.stderr.as_str()), (0, ""));
    let lines: Vec<&str> = dxf.stdout.lines().collect();
    assert_eq!(lines.len() % 2, 0, "codes and values");
    assert_eq!(lines.iter().filter(|l| **l == "VERTEX").count(), 24, "profile and pitch curve");
    assert!(lines.windows(2).any(|l| l[0].trim() == "40" && l[1] == "50.000000000"), "the base circle");
    assert_eq!(lines[lines.len() - 1], "EOF");
    let unclear = assur(&folder, &["profile", "two.mech"]);
    assert_eq!(unclear.status, 1);
    assert!(unclear.stderr.contains("`plate`, `other`"), "{}", unclear.stderr);
    assert_eq!(assur(&folder, &["profile", "two.mech", "--cam", "other"]).status, 0);
    assert_eq!(assur(&folder, &["profile", "none.mech"]).status, 1);
}

#[test]
fn tables_are_printed_in_every_format() {
    let text = format!("{CAM}find profile(plate) in 4 steps\n");
    let folder = Folder::new("tables").with("a.mech", &text);
    for format in ["table", "markdown", "json"] {
        let out = assur(&folder, &["solve", "a.mech", "--format", format]);
        assert_eq!(out.status, 0, "{}", out.stderr);
        assert!(out.stdout.contains("profile(plate)") && out.stdout.contains("pitch.x"), "{format}");
    }
}

/// The lines of the plan and its cost, without the times, which differ from run to run.
fn without_times(report: &str) -> String {
    let is_time = |word: &str| word.contains('.') && word.parse::<f64>().is_ok();
    let lines = report.lines().skip_while(|line| !line.starts_with("Plan"));
    let shown = lines.filter(|line| !line.contains('─')).map(|line| {
        let words: Vec<&str> = line.split_whitespace().collect();
        let shown = words.iter().enumerate().map(|(i, word)| match words.get(i + 1) {
            Some(&"%") => "#",
            _ if is_time(word) => "#.#",
            _ => word,
        });
        shown.collect::<Vec<_>>().join(" ")
    });
    shown.collect::<Vec<_>>().join("\n")
}

#[test]
fn a_plan_has_what_is_asked_for_and_says_what_is_not() {
    let text = GOOD.replace(", v_C = velocity(C)", "").replace("C (0, 0) }", "C (0, 0); mass 2 kg at C }");
    let folder = Folder::new("plan").with("a.mech", &text);
    let out = assur(&folder, &["check", "--plan", "a.mech"]);
    assert_eq!((out.status, out.stderr.as_str()), (0, ""));
    insta::assert_snapshot!(without_times(&out.stdout), @r"
    Plan
    step what how time [ns] share
    1 motion of crank prescribed by drive crank #.# # %
    2 motion of rod, piston closed form, dyad RRP #.# # %

    Cost per position
    effect time [ns] share
    positions #.# # %
    the plan #.# # %
    residuals #.# ns in addition to the plan
    quantities #.# ns in addition to the plan
    not asked for velocities, accelerations, inertia, reactions
    measured best of repeated runs at 2 of the file's positions
    ");
}

#[test]
fn a_plan_says_what_its_steps_and_effects_cost() {
    let loads = "gravity 9.81 m/s^2\nspring k: ground.A - rod.C { stiffness 4 kN/m; free_length 80 mm }\n\
                 force P on piston at C = (-100 N, 0) when displacement(D) > 0.4 m\nbalance torque Mb on crank\n";
    let text = GOOD
        .replace("C (0, 0) }", "C (0, 0); mass 2 kg at C }")
        .replace("ground.guide", "ground.guide { friction 0.1 }")
        .replace("0 deg, 90 deg at", "30 deg at")
        .replace("at pose 1", "")
        .replace("450 mm", "430 mm")
        + loads
        + "find Mb\n";
    let open = GOOD.replace("350 mm", "50 mm").replace("0 deg, 90 deg", "90 deg");
    let folder = Folder::new("costs").with("a.mech", &text).with("open.mech", &open);
    let out = assur(&folder, &["check", "--plan", "a.mech"]);
    assert_eq!((out.status, out.stderr.as_str()), (0, ""));
    insta::assert_snapshot!(without_times(&out.stdout), @r"
    Plan
    step what how time [ns] share
    1 motion of crank prescribed by drive crank #.# # %
    2 motion of rod, piston closed form, dyad RRP #.# # %
    3 weight and inertia force of piston at its mass centre #.# # %
    4 force P on piston evaluated at every pose #.# # %
    5 spring k from its length #.# # %
    6 reactions on rod, piston closed form, dyad RRP, friction by Newton's method #.# # %
    7 reactions on crank equilibrium, with balance Mb #.# # %

    Cost per position
    effect time [ns] share
    positions #.# # %
    velocities #.# # %
    accelerations #.# # %
    gravity #.# # %
    inertia #.# # %
    springs #.# # %
    loads #.# # %
    reactions #.# # %
    friction #.# # %
    the plan #.# # %
    residuals #.# ns in addition to the plan
    quantities #.# ns in addition to the plan
    measured best of repeated runs at 64 positions over one turn of crank
    ");
    // shares add up to the whole
    let shares = out.stdout.lines().skip_while(|l| !l.starts_with("Cost")).filter_map(|line| {
        let (before, _) = line.split_once(" %")?;
        let name = line.split_whitespace().next()?;
        (!["the", "of", "beside"].contains(&name)).then(|| before.rsplit(' ').next()?.parse::<i32>().ok())?
    });
    let sum: i32 = shares.sum();
    assert!((95..=105).contains(&sum), "{}", out.stdout);
    // what does not close has no positions to be run at
    let out = assur(&folder, &["check", "--plan", "open.mech"]);
    assert_eq!(out.status, 1);
    assert!(out.stderr.contains("mech::assembly::does_not_close"), "{}", out.stderr);
    assert!(out.stdout.contains("Plan") && !out.stdout.contains("time [ns]"), "{}", out.stdout);
}

#[test]
fn rows_show_the_value_that_is_set_for_all() {
    let text = "given r = 100 mm\nlet y = r/2\nvariants {\n  r [mm]\n  100\n  120\n}\nfind y\n";
    let folder = Folder::new("set_rows").with("a.mech", text);
    let out = assur(&folder, &["solve", "a.mech", "--set", "r=50mm"]);
    assert_eq!((out.status, out.stderr.as_str()), (0, ""));
    assert!(out.stdout.contains("r = 50 mm") && !out.stdout.contains("r = 100 mm"), "{}", out.stdout);
    let out = assur(&folder, &["batch", "a.mech", "--set", "r=50mm"]);
    assert!(out.stdout.contains("  1        50      25\n  2        50      25\n"), "{}", out.stdout);
}

#[test]
fn locking_that_is_expected_is_no_news() {
    let text = "ground { O (0, 0); line plane through O along 5 deg }\nlink body { B (0, 0) }\n\
                prismatic P: body.B - ground.plane { friction 0.1 }\ndrive P = 0 mm, 1 mm moving back\n\
                force on body at B = 1000 N @ 270 deg\nbalance force F on body at B along 0 deg\n\
                find locked()\n";
    let folder = Folder::new("locked").with("a.mech", text);
    let stderr = |more: &str| {
        folder.write_bytes("a.mech", format!("{text}{more}").as_bytes());
        let out = assur(&folder, &["solve", "a.mech"]);
        assert_eq!(out.status, 0, "{}", out.stderr);
        out.stderr
    };
    let both = stderr("");
    assert!(both.contains("at pose 1") && both.contains("1 more pose"), "{both}");
    let other = stderr("expect locked() at pose 1\n");
    assert!(other.contains("at pose 2") && !other.contains("more pose"), "{other}");
    let none =
        stderr("expect locked() at pose 1\nlet l = locked() and efficiency() < 0\nexpect l at pose 2\n");
    assert_eq!(none, "");
    assert!(stderr("expect not locked() at pose 1\n").contains("1 more pose"));
}

#[test]
fn a_critical_value_that_does_not_exist_is_said_to_be_none() {
    let text = "given x = 3 mm\nground { O (0, 0); line plane through O along 20 deg }\nlink body { B (x, 0) }\n\
                prismatic P: body.B - ground.plane { friction 0.1 }\ndrive P = 0 mm moving forward\n\
                force on body at B = 1000 N @ 270 deg\nbalance force F on body at B along 0 deg\n\
                find critical(x)\n";
    let out = assur(&Folder::new("critical").with("a.mech", text), &["solve", "a.mech"]);
    assert_eq!(out.status, 0);
    assert!(out.stdout.contains("none in reach"), "{}", out.stdout);
}

#[test]
fn latex_is_a_part_of_a_document() {
    let folder = Folder::new("latex").with("a.mech", &GOOD.replace("Crank-slider", "50 % & {x}_1"));
    let out = assur(&folder, &["solve", "a.mech", "--accuracy", "--format", "latex"]);
    assert_eq!((out.status, out.stderr.as_str()), (0, ""));
    assert!(out.stdout.starts_with("\\section*{50 \\% \\& \\{x\\}\\_1 (a.mech)}\n"), "{}", out.stdout);
    let count = |what: &str| out.stdout.matches(what).count();
    assert!(count("\\begin{tabular}") > 1 && count("\\begin{tabular}") == count("\\end{tabular}"));
    assert!(out.stdout.contains(" & ") && out.stdout.contains("\\subsection*{Answers}"), "{}", out.stdout);
    assert!(out.stdout.is_ascii(), "{:?}", out.stdout.chars().filter(|c| !c.is_ascii()).collect::<String>());
}
