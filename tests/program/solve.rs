//! `assur solve` as run from a shell: what is printed, in each form.

use crate::cli::GOOD;
use crate::profile::CAM;
use crate::run::{self, Folder, assur};

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
    assert!(before == answers && table.lines().count() == 6, "{full}");
    assert!(
        table.lines().nth(1).unwrap().ends_with("a digit less would save nothing: nothing is iterated"),
        "{table}"
    );
    assert!(table.lines().nth(5).unwrap().ends_with("  0.958"), "{table}");
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
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    let readme = std::fs::read_to_string(root.join("README.md")).unwrap();
    let (_, rest) = readme.split_once("```mech\n").unwrap();
    let (file, rest) = rest.split_once("```\n\n```text\n").unwrap();
    assert_eq!(file, std::fs::read_to_string(root.join("examples/press.mech")).unwrap());
    let (page, _) = rest.split_once("```\n").unwrap();
    let out = assur(&Folder::new("readme").with("press.mech", file), &["solve", "press.mech"]);
    assert_eq!((out.status, out.stderr.as_str()), (0, ""));
    // an excerpt, in the order of the page
    let mut lines = out.stdout.lines();
    for line in page.lines() {
        assert!(lines.any(|printed| printed == line), "`{line}` is not printed after the line before it");
    }
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
fn tables_are_printed_in_every_format() {
    let text = format!("{CAM}find profile(plate) in 4 steps\n");
    let folder = Folder::new("tables").with("a.mech", &text);
    for format in ["table", "markdown", "json"] {
        let out = assur(&folder, &["solve", "a.mech", "--format", format]);
        assert_eq!(out.status, 0, "{}", out.stderr);
        assert!(out.stdout.contains("profile(plate)") && out.stdout.contains("pitch.x"), "{format}");
    }
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
