//! The command line: exit status, streams, names of files, values from outside.

use crate::run::{self, Folder, assur};

pub const GOOD: &str = r#"mech 1
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
pub const BAD: &str = "mechanism \"Bad\"\nlink crank A-B rr\n";

pub fn failing() -> String {
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
        ("latin1", "did you mean `latin1.mech`?"),
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

/// Links to nothing, pipes: the others are used, and the exit status says that an answer is missing.
#[cfg(unix)]
#[test]
fn a_folder_names_what_it_cannot_read() {
    let folder = Folder::new("unreadable").with("set/a.mech", GOOD).with("set/deep.mech/b.txt", "no program");
    std::os::unix::fs::symlink("nothing", folder.path("set/gone.mech")).unwrap();
    std::os::unix::fs::symlink("a.mech", folder.path("set/other.mech")).unwrap();
    let made = std::process::Command::new("mkfifo").arg(folder.path("set/pipe.mech")).status();
    assert!(made.unwrap().success());
    for args in [
        &["check"][..],
        &["solve"],
        &["test"],
        &["batch"],
        &["report"],
        &["draw", "-o", "d/"],
        &["course", "moodle"],
    ] {
        for set in ["set", "set/*.mech"] {
            let out = assur(&folder, &[args, &[set]].concat());
            assert_eq!(out.status, 1, "{args:?} {set}: {}", out.stderr);
            for says in ["`set/gone.mech` cannot be read", "`set/pipe.mech` cannot be read: it is not a file"]
            {
                assert_eq!(out.stderr.matches(says).count(), 1, "{args:?} {set}: {}", out.stderr);
            }
            assert!(!out.stderr.contains("deep"), "{args:?} {set}: {}", out.stderr);
        }
    }
    let tested = assur(&folder, &["test", "set"]).stdout;
    assert!(
        tested.starts_with("set/a.mech: 1 expectation met\nset/other.mech: 1 expectation met\n"),
        "{tested}"
    );
    // one that is named is an error of the command line
    assert_eq!(assur(&folder, &["check", "set/gone.mech"]).status, 2);
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
