//! Nothing is lost silently: what cannot be written, what is long, what is hostile.

#![allow(clippy::unwrap_used)] // a test that cannot read its files has failed

use crate::run::{self, Folder, Said, assur};
use std::fmt::Write;
use std::path::Path;

const ENGINE: &str = r#"mechanism "Crank-slider"
given r = 100 mm
ground { A (0, 0); line guide through A along 0 deg }
link crank A-B r
link rod   B-C 350 mm
link piston { C (0, 0); mass 2 kg at C }
revolute  A: ground - crank
revolute  B: crank - rod
revolute  C: rod - piston
prismatic D: piston.C - ground.guide
drive crank = 0 deg, 90 deg at 100 rad/s
assemble C ahead of B
balance torque Mb on crank
find x_C = position(C).x as mm, Mb, reactions
expect x_C = 450 mm within 1e-9 at pose 1
"#;

const CAM: &str = r#"cam plate {
  base_radius 50 mm
  turning ccw
  follower translating roller { radius 10 mm }
  rise 90 deg through 20 mm cycloidal
  fall 90 deg cycloidal
}
"#;

fn engine(steps: usize) -> String {
    ENGINE.replace("0 deg, 90 deg", &format!("0 deg .. 359 deg in {steps} steps"))
}

fn hostile(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cases/hostile").join(name);
    std::fs::read_to_string(path).unwrap()
}

/// Every command with something to print.
const COMMANDS: [&[&str]; 16] = [
    &["check", "a.mech"],
    &["check", "--plan", "--modes", "a.mech"],
    &["solve", "a.mech"],
    &["solve", "a.mech", "--format", "json"],
    &["solve", "a.mech", "--format", "jsonl"],
    &["solve", "a.mech", "--format", "csv"],
    &["solve", "a.mech", "--format", "markdown"],
    &["solve", "long.mech", "--format", "csv"],
    &["test", "a.mech"],
    &["accuracy", "a.mech", "--for", "1e-3"],
    &["explain", "--all"],
    &["explain", "assembly::ambiguous"],
    &["batch", "a.mech"],
    &["grade", "key.csv", "key.csv"],
    &["profile", "cam.mech"],
    &["--help"],
];

fn files() -> Folder {
    Folder::new("output")
        .with("a.mech", ENGINE)
        .with("long.mech", &engine(30_000))
        .with("cam.mech", CAM)
        .with("key.csv", "row,x [mm]\n1,2.5\n")
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_told_by_every_command() {
    let folder = files();
    for args in COMMANDS {
        let said = run::into_file(&folder, args, "/dev/full", false);
        assert_eq!(said.status, 2, "{args:?}: {}", said.stderr);
        let told = said.stderr.contains("standard output cannot be written: No space left");
        assert!(told || args == ["--help"], "{args:?}: {}", said.stderr);
    }
}

#[cfg(target_os = "linux")]
#[test]
fn diagnostics_that_cannot_be_written_are_told_by_the_status() {
    let folder = files().with("bad.mech", "given r = s\n");
    let said = run::into_file(&folder, &["check", "bad.mech"], "/dev/full", true);
    assert_eq!(said.status, 2);
}

#[test]
fn a_closed_pipe_is_quiet_and_no_success() {
    let folder = files();
    for args in COMMANDS {
        let said = run::into_closed_pipe(&folder, args);
        let quiet = said.stderr.is_empty() || args[0] == "batch";
        assert!(said.status == 2 && quiet, "{args:?}: {} {}", said.status, said.stderr);
    }
    folder.write_bytes("a.mech", ENGINE.replace("450 mm", "451 mm").as_bytes());
    let said = run::into_closed_pipe(&folder, &["test", "a.mech"]);
    assert_eq!(said.status, 2);
    assert!(said.stderr.contains("mech::expect::mismatch"), "{}", said.stderr);
}

#[cfg(unix)]
#[test]
fn a_signal_leaves_whole_rows_and_no_temporary_file() {
    let mut table = "r [mm]\n".to_owned();
    (0..400_000).for_each(|i| writeln!(table, "{}", 90 + i % 20).unwrap());
    for (signal, status) in [("-TERM", 143), ("-HUP", 129), ("-INT", 130)] {
        if signal == "-HUP" && run::ignores_hangup() {
            continue;
        }
        let folder = Folder::new("signal").with("a.mech", ENGINE).with("t.csv", &table);
        let args = ["batch", "a.mech", "--variants", "t.csv", "--out", "o.csv", "--key", "k.csv"];
        let child = run::start(&folder, &args);
        std::thread::sleep(std::time::Duration::from_millis(800));
        let id = child.id().to_string();
        assert!(std::process::Command::new("kill").args([signal, &id]).status().unwrap().success());
        let said = run::end(child);
        assert_eq!(said.status, status, "{signal}: {}", said.stderr);
        let names = folder.names();
        let parts = ["a.mech", "k.csv.part", "o.csv.part", "t.csv"];
        assert!(names == parts || names == ["a.mech", "t.csv"], "{signal}: {names:?}");
        if names == parts {
            assert!(folder.read("o.csv.part").ends_with("\r\n"), "{signal}");
        }
    }
}

#[test]
fn a_wrong_value_from_outside_is_a_wrong_command_line() {
    let folder = files();
    for command in ["check", "solve", "test", "batch", "accuracy"] {
        for (set, says) in
            [("q=1mm", "no `given` of that name"), ("r=3kg", "a mass"), ("r=abc", "not a number")]
        {
            let said = assur(&folder, &[command, "a.mech", "--set", set]);
            assert_eq!(said.status, 2, "{command} {set}: {}", said.stderr);
            // `test` has a line for every file
            assert!(said.stdout.is_empty() || command == "test", "{command} {set}: {}", said.stdout);
            assert!(said.stderr.contains(says), "{command} {set}: {}", said.stderr);
        }
    }
    let said = assur(&folder, &["profile", "cam.mech", "--set", "q=1mm"]);
    assert_eq!(said.status, 2, "{}", said.stderr);
}

/// A folder whose path is too long for the system is not readable by anyone.
#[cfg(target_os = "linux")]
#[test]
fn folders_that_cannot_be_read_are_told() {
    let folder = files();
    let name = "d".repeat(250);
    let [outer, inner] = ["outer", &name].map(|name| std::path::PathBuf::from(folder.path(name)));
    std::fs::create_dir(&inner).unwrap();
    // from the innermost outwards: no path on the way is too long
    for _ in 1..18 {
        std::fs::create_dir(&outer).unwrap();
        std::fs::rename(&inner, outer.join(&name)).unwrap();
        std::fs::rename(&outer, &inner).unwrap();
    }
    for command in ["check", "batch"] {
        let said = assur(&folder, &[command, "."]);
        assert_eq!(said.status, 1, "{command}: {}", said.stderr);
        // the long path breaks the lines
        let words = said.stderr.replace('│', " ").split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(words.contains("File name too long"), "{command}: {}", said.stderr);
        assert!(!said.stdout.is_empty(), "{command}: the other files are answered");
    }
}

/// No command of a terminal, no change of direction.
fn is_plain(text: &str) -> bool {
    let turns = |c| matches!(c, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    text.chars().all(|c| !turns(c) && (!c.is_control() || matches!(c, '\n' | '\r' | '\t')))
}

#[test]
fn terminals_are_not_commanded_by_files() {
    let folder = files();
    for name in ["esc-title.mech", "esc-notes.mech", "esc-name.mech", "inj3.csv", "ans2.csv"] {
        folder.write_bytes(name, hostile(name).as_bytes());
    }
    let odd = "odd\u{1b}[2J\u{202e}.mech";
    folder.write_bytes(odd, ENGINE.replace("r = 100", "r = x").as_bytes());
    let key = "file,variant,Mb [N*m]\n=cmd.mech,=1+1,3\n";
    folder.write_bytes("k.csv", key.as_bytes());
    let variants = ["batch", "a.mech", "--variants", "inj3.csv", "--color", "never"];
    let mut all: Vec<Said> = vec![assur(&folder, &variants)];
    for file in ["esc-title.mech", "esc-notes.mech", "esc-name.mech", odd] {
        for command in [&["check", "--modes"][..], &["solve"], &["test"], &["batch"]] {
            all.push(assur(&folder, &[command, &[file, "--color", "never"]].concat()));
        }
        all.push(assur(&folder, &["solve", file, "--format", "markdown"]));
        all.push(assur(&folder, &["solve", file, "--format", "json"]));
        all.push(assur(&folder, &["solve", file, "--format", "jsonl"]));
    }
    for format in ["table", "csv", "json"] {
        all.push(assur(&folder, &["grade", "k.csv", "ans2.csv", "--format", format]));
        all.push(assur(&folder, &["batch", "a.mech", "--variants", "inj3.csv", "--format", "csv"]));
    }
    for said in &all {
        assert!(is_plain(&said.stdout), "{:?}", said.stdout);
        assert!(is_plain(&said.stderr), "{:?}", said.stderr);
        assert!((0..=2).contains(&said.status), "{}", said.status);
    }
    assert!(all[1].stdout.starts_with("Engine\\u{1b}[2J\\u{1b}]0;owned\\u{7}"), "{}", all[1].stdout);
    assert!(all[0].stdout.contains("\\u{1b}[2Jx"), "{}", all[0].stdout);
}

#[test]
fn spreadsheets_run_no_cell() {
    let folder = files().with("k.csv", "file,variant,Mb [N*m]\n=cmd.mech,=1+1,3\n=cmd.mech,@SUM(1),4\n");
    folder.write_bytes("inj2.csv", hostile("inj2.csv").as_bytes());
    folder.write_bytes("ans.csv", hostile("ans.csv").as_bytes());
    let args = ["batch", "a.mech", "--variants", "inj2.csv", "--format", "csv", "--key", "key.csv"];
    let said = assur(&folder, &args);
    assert_eq!(said.status, 0, "{}", said.stderr);
    assert_eq!(run::column(&said.stdout, "variant"), ["'=1+1", "'=1+1", "'@SUM(1)", "'@SUM(1)"]);
    assert_eq!(run::column(&said.stdout, "crank [deg]"), ["0", "90", "0", "90"]);
    assert!(run::column(&said.stdout, "Mb [N*m]").iter().any(|x| x.starts_with('-')), "numbers stay");
    assert_eq!(run::column(&folder.read("key.csv"), "variant")[0], "'=1+1");
    let said = assur(&folder, &["grade", "k.csv", "ans.csv", "--format", "csv"]);
    assert_eq!(
        said.status, 0,
        "names with and without an apostrophe are one: {}{}",
        said.stdout, said.stderr
    );
    assert_eq!(run::column(&said.stdout, "student")[..2], ["'=1+2", "'@x"]);
    assert_eq!(run::column(&said.stdout, "file")[..2], ["'=cmd.mech", "'=cmd.mech"]);
    let said = assur(&folder, &["grade", "key.csv", "key.csv"]);
    assert!(said.status == 0 && said.stdout.contains(" right"), "{}{}", said.stdout, said.stderr);
}

#[test]
fn long_lines_are_cut_around_the_mark() {
    let blanks = " ".repeat(65_600);
    let list: String = (0..9000).map(|i| format!("{i} deg, ")).collect();
    let columns: String = (0..12_000).map(|i| format!(",x{i} [mm]")).collect();
    let head = "ground { A (0, 0) }\nlink l A-B 1 m\nrevolute A: ground - l\n";
    let folder = files()
        .with("col65k.mech", &format!("let a = {blanks}foo\n"))
        .with("list.mech", &format!("{head}drive l = {list}3 dg\nfind angle(l)\n"))
        .with("wide.csv", &format!("r [mm]{columns}\n1\n"));
    for args in [
        &["check", "col65k.mech"][..],
        &["test", "list.mech"],
        &["batch", "col65k.mech"],
        &["batch", "a.mech", "--variants", "wide.csv"],
    ] {
        let said = assur(&folder, args);
        assert_eq!(said.status, 1, "{args:?}: {}", said.stderr);
        assert!(said.stderr.contains('…') && said.stderr.contains("╰──"), "{args:?}: {}", said.stderr);
        let longest = said.stderr.lines().map(|l| l.chars().count()).max().unwrap();
        assert!(longest < 300, "{args:?}: {longest}");
    }
}

#[test]
fn diagnostics_are_limited_in_number() {
    let mut text = "given r = 1 mm\n".to_owned();
    (0..2000).for_each(|i| writeln!(text, "let a{i} = b{i} + r").unwrap());
    let folder = Folder::new("many").with("a.mech", &text);
    let count = |said: &Said| said.stderr.matches("mech::name::unknown").count();
    let said = assur(&folder, &["check", "a.mech"]);
    assert_eq!((said.status, count(&said)), (1, 50));
    assert!(said.stderr.ends_with("\nand 1,950 more\n"), "{}", said.stderr);
    assert!(said.stderr.contains("a.mech:2:") && said.stderr.contains("a.mech:51:"), "the first by place");
    let said = assur(&folder, &["check", "a.mech", "--max-errors", "3"]);
    assert!(count(&said) == 3 && said.stderr.ends_with("\nand 1,997 more\n"), "{}", said.stderr);
    let said = assur(&folder, &["check", "a.mech", "--max-errors", "10000"]);
    assert_eq!((count(&said), said.stderr.contains(" more\n")), (2000, false));
}

#[test]
fn more_positions_than_can_be_kept_are_told() {
    let folder = files();
    for name in ["steps1e6.mech", "steps1e6-few.mech", "hang-113626.mech"] {
        folder.write_bytes(name, hostile(name).as_bytes());
        for args in [&["solve", name][..], &["solve", name, "--format", "json"], &["batch", name]] {
            let said = assur(&folder, args);
            assert_eq!(said.status, 1, "{args:?}: {}", said.stderr);
            for part in ["1000001 positions", "20000", "--format csv", "jsonl"] {
                let told = said.stdout.clone() + &said.stderr;
                assert!(told.contains(part), "{args:?}: {part} in {told}");
            }
        }
    }
    // expectations at a pose are met all the same
    let text = engine(30_000) + "expect mag(reaction(A, crank)) > 0 N at pose 30001\n";
    folder.write_bytes("a.mech", text.as_bytes());
    let said = assur(&folder, &["test", "a.mech"]);
    assert_eq!((said.status, said.stdout.as_str()), (0, "a.mech: 2 expectations met\n"), "{}", said.stderr);
}

#[test]
fn long_sweeps_are_printed_one_position_after_another() {
    let folder = files();
    let said = assur(&folder, &["solve", "long.mech", "--format", "csv"]);
    assert_eq!((said.status, said.stderr.as_str()), (0, ""));
    let short = assur(&folder, &["solve", "a.mech", "--format", "csv"]);
    let lines: Vec<&str> = said.stdout.split_terminator("\r\n").collect();
    assert_eq!((lines.len(), lines[0]), (30_002, short.stdout.lines().next().unwrap()));
    assert_eq!(lines[1], short.stdout.lines().nth(1).unwrap());
    let said = assur(&folder, &["solve", "long.mech", "--format", "jsonl"]);
    assert_eq!((said.status, said.stdout.lines().count()), (0, 30_001));
}

#[test]
fn a_sweep_that_never_closes_has_no_lines() {
    let text = engine(30_000).replace("350 mm", "50 mm").replace("r = 100 mm", "r = 300 mm");
    let text = text.replace("0 deg .. 359 deg", "80 deg .. 100 deg");
    let folder = Folder::new("open").with("a.mech", &text);
    for format in ["csv", "jsonl"] {
        let said = assur(&folder, &["solve", "a.mech", "--format", format]);
        assert_eq!((said.status, said.stdout.as_str()), (1, ""), "{format}");
        assert_eq!(said.stderr.matches("does_not_close").count(), 1, "{format}: {}", said.stderr);
    }
}

#[test]
fn groups_that_stand_nowhere_are_found_out_soon() {
    let folder = Folder::new("slow").with("a.mech", &hostile("slow-137508.mech"));
    let started = std::time::Instant::now();
    let said = assur(&folder, &["solve", "a.mech"]);
    assert_eq!(said.status, 1);
    assert!(said.stderr.contains("as with two parallel guides"), "{}", said.stderr);
    assert!(started.elapsed().as_secs() < 5, "{:?}", started.elapsed());
}
