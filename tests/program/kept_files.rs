//! No file is lost: outputs that are inputs, links, permissions, limits of the system, and names that are no markup.

#![cfg(unix)]
#![allow(clippy::unwrap_used)] // a test that cannot write its files has failed

use crate::run::{self, Folder, Said, assur};
use std::fmt::Write;
use std::os::unix::fs::{MetadataExt, PermissionsExt, symlink};
use std::process::Command;

const PUMP: &str = r#"mech 1
mechanism "Pump"
given r = 100 mm
ground { A (0, 0); line guide through A along 0 deg }
link crank  A-B r
link rod    B-C 350 mm
link piston { C (0, 0) }
revolute  A: ground - crank
revolute  B: crank - rod
revolute  C: rod - piston
prismatic D: piston.C - ground.guide
drive crank = 0 deg .. 360 deg in 12 steps at 1500 rpm
assemble C ahead of B
find x = displacement(D) as mm
variants {
  r [mm]
  90
  110
}
"#;
const UNFORMATTED: &str = "mech 1\nmechanism    \"x\"\n";

fn pump() -> Folder {
    Folder::new("kept").with("g.mech", PUMP).with("rows.csv", "r [mm]\n90\n110\n")
}

/// Ways to name a file that is there: its name, another path to it, a link, a second name.
fn names_of(folder: &Folder, name: &str, ending: &str) -> Vec<String> {
    let (link, second) = (format!("link{ending}"), format!("second{ending}"));
    for made in [&link, &second] {
        let _ = std::fs::remove_file(folder.path(made));
    }
    symlink(name, folder.path(&link)).unwrap();
    std::fs::hard_link(folder.path(name), folder.path(&second)).unwrap();
    vec![name.to_owned(), format!("./{name}"), folder.path(name), link, second]
}

#[test]
fn no_output_takes_the_place_of_an_input() {
    let pictures: &[&[&str]] = &[
        &["draw", "g.mech", "scheme", "-o"],
        &["draw", "g.mech", "scheme", "--format", "svg", "-o"],
        &["report", "g.mech", "--format", "html", "-o"],
        &["report", "g.mech", "--sheet", "--format", "typst", "-o"],
        &["accuracy", "g.mech", "--plot"],
        &["batch", "g.mech", "--out"],
        &["batch", "g.mech", "--variants", "rows.csv", "--out"],
        &["batch", "g.mech", "--variants", "rows.csv", "--key"],
    ];
    let folder = pump();
    for (input, endings) in [("g.mech", [".svg", ".html", ".mech"]), ("rows.csv", [".csv", ".svg", ".typ"])] {
        let text = folder.read(input);
        for (args, ending) in pictures.iter().flat_map(|args| endings.map(|ending| (args, ending))) {
            if !args.contains(&input) {
                continue;
            }
            for name in names_of(&folder, input, ending) {
                let all = [args, &[name.as_str()][..]].concat();
                let said = assur(&folder, &all);
                assert_eq!(folder.read(input), text, "{all:?}");
                assert!(said.status == 2, "{all:?}: {} {}", said.status, said.stderr);
                assert!(!said.stderr.contains("os error"), "{all:?}: {}", said.stderr);
            }
        }
    }
}

#[test]
fn answers_and_their_key_are_two_files() {
    let folder = pump();
    let said = assur(&folder, &["batch", "g.mech", "--out", "a.csv", "--key", "./a.csv"]);
    assert!(said.status == 2 && said.stderr.contains("both an input and the output"), "{}", said.stderr);
}

#[test]
fn links_under_names_that_are_made_up_are_replaced() {
    let runs: [&[&str]; 3] = [
        &["draw", "g.mech", "--all", "-o", "out"],
        &["report", "g.mech", "-o", "out/r.md"],
        &["report", "g.mech", "--sheet", "--per-row", "-o", "out/s.html"],
    ];
    for args in runs {
        let folder = pump().with("kept", "keep\n");
        std::fs::create_dir(folder.path("out")).unwrap();
        assert!(assur(&folder, args).status < 2, "{args:?}");
        // the page itself has a name that was given
        let given = |name: &String| name == "r.md";
        let entries = std::fs::read_dir(folder.path("out")).unwrap().flatten();
        let made: Vec<String> = entries.map(|e| e.file_name().to_string_lossy().into_owned()).collect();
        let made: Vec<String> = made.into_iter().filter(|name| !given(name)).collect();
        assert!(made.len() >= 2, "{args:?}: {made:?}");
        for name in &made {
            let path = folder.path(&format!("out/{name}"));
            std::fs::remove_file(&path).unwrap();
            symlink(folder.path("kept"), &path).unwrap();
        }
        assert!(assur(&folder, args).status < 2, "{args:?}");
        assert_eq!(folder.read("kept"), "keep\n", "{args:?}");
        for name in &made {
            let found = std::fs::symlink_metadata(folder.path(&format!("out/{name}"))).unwrap();
            assert!(found.is_file(), "{args:?}: {name}");
        }
    }
}

#[test]
fn a_link_that_is_named_stays_one() {
    let folder = pump().with("kept.svg", "old");
    symlink("kept.svg", folder.path("link.svg")).unwrap();
    assert_eq!(assur(&folder, &["draw", "g.mech", "scheme", "-o", "link.svg"]).status, 0);
    assert!(std::fs::symlink_metadata(folder.path("link.svg")).unwrap().is_symlink());
    assert!(folder.read("kept.svg").starts_with("<svg"));
}

#[test]
fn an_edited_file_keeps_its_permissions_and_names() {
    for mode in [0o666, 0o640, 0o600, 0o755] {
        let folder = Folder::new("mode").with("a.mech", UNFORMATTED).with("b.mech", UNFORMATTED);
        let set = |name: &str| {
            std::fs::set_permissions(folder.path(name), std::fs::Permissions::from_mode(mode)).unwrap();
        };
        set("a.mech");
        set("b.mech");
        std::fs::hard_link(folder.path("b.mech"), folder.path("c.mech")).unwrap();
        assert_eq!(assur(&folder, &["fmt", "a.mech", "b.mech"]).status, 0);
        assert_eq!(folder.read("a.mech"), folder.read("b.mech"));
        assert_eq!(folder.read("c.mech"), folder.read("b.mech"));
        assert_ne!(folder.read("a.mech"), UNFORMATTED);
        for name in ["a.mech", "b.mech", "c.mech"] {
            let found = std::fs::metadata(folder.path(name)).unwrap();
            assert_eq!(found.mode() & 0o777, mode, "{name}");
        }
    }
}

/// Runs the program where a file may not grow.
fn limited(folder: &Folder, args: &str) -> Said {
    let program = env!("CARGO_BIN_EXE_assur");
    let mut shell = Command::new("bash");
    shell.current_dir(folder.path("")).args(["-c", &format!("ulimit -f 0; exec {program} {args}")]);
    let out = shell.output().unwrap();
    Said {
        status: out.status.code().unwrap_or(-1),
        stdout: String::from_utf8(out.stdout).unwrap(),
        stderr: String::from_utf8(out.stderr).unwrap(),
    }
}

#[test]
fn a_file_that_may_not_grow_is_an_error_of_writing_it() {
    let folder = pump().with("f.mech", UNFORMATTED);
    let before = folder.names();
    for args in
        ["fmt f.mech", "draw g.mech scheme -o x.svg", "report g.mech -o x.html", "batch g.mech --out x.csv"]
    {
        let said = limited(&folder, args);
        assert!(
            said.status == 2 && said.stderr.contains("cannot be written"),
            "{args}: {} {}",
            said.status,
            said.stderr
        );
        assert!(!said.stderr.contains(".tmp"), "{args}: {}", said.stderr);
        assert_eq!(folder.names(), before, "{args}");
    }
    assert!(limited(&folder, "fmt f.mech").stderr.contains("1 file: 1 not written"));
    assert_eq!(folder.read("f.mech"), UNFORMATTED);
}

#[test]
fn a_key_without_all_rows_is_a_part() {
    let mut rows = "r [mm]\n".to_owned();
    (0..50_000).for_each(|i| writeln!(rows, "{}", 90.0 + f64::from(i % 1000) / 100.0).unwrap());
    let folder = pump().with("many.csv", &rows);
    let args = ["batch", "g.mech", "--variants", "many.csv", "--key", "key.csv", "--format", "csv"];
    let stderr = run::with_closed_output(&folder, &args);
    assert!(stderr.contains("key.csv.part"), "{stderr}");
    assert!(!folder.names().contains(&"key.csv".to_owned()));
}

#[test]
fn a_folder_that_is_not_there_is_named() {
    let folder = pump();
    let runs: [&[&str]; 4] = [
        &["draw", "g.mech", "scheme", "-o", "none/x.svg"],
        &["report", "g.mech", "-o", "none/x.html"],
        &["batch", "g.mech", "--out", "none/x.csv"],
        &["new", "none/x.mech"],
    ];
    for args in runs {
        let said = assur(&folder, args);
        assert!(
            said.status == 2 && said.stderr.contains("there is no folder `none`"),
            "{args:?}: {}",
            said.stderr
        );
    }
    let said = assur(&folder.with("text", "x"), &["draw", "g.mech", "--all", "-o", "text"]);
    assert!(said.stderr.contains("`text` is a file, not a folder"), "{}", said.stderr);
}

#[test]
fn a_text_without_end_is_refused() {
    for args in [["solve", "/dev/zero"], ["check", "/dev/zero"], ["fmt", "/dev/zero"]] {
        let said = assur(&pump(), &args);
        assert!(said.status == 2 && said.stderr.contains("longer than 100 MB"), "{args:?}: {}", said.stderr);
    }
    let folder = pump().with("k.csv", "row,x [mm]\n1,2\n");
    for args in [
        ["grade", "/dev/zero", "k.csv"],
        ["grade", "k.csv", "/dev/zero"],
        ["batch", "g.mech", "--variants=/dev/zero"],
        ["course", "moodle", "--variants=/dev/zero"],
    ] {
        let args = [&args[..], if args[0] == "course" { &["g.mech"] } else { &[] }].concat();
        let said = assur(&folder, &args);
        let refused = ["longer than 100 MB", "is not a file"].iter().any(|says| said.stderr.contains(says));
        assert!(said.status == 2 && refused, "{args:?}: {}", said.stderr);
    }
    let said = assur(&pump(), &["preview", "/dev/zero"]);
    assert!(said.status == 2 && said.stderr.contains("follows one file"), "{}", said.stderr);
}

#[test]
fn a_name_is_never_markup() {
    let name = "a\" onload=\"alert(1)\" <bad>&'\n.mech";
    let folder = Folder::new("markup").with(name, PUMP);
    let runs: [&[&str]; 5] = [
        &["draw", "scheme", name, "--format", "svg"],
        &["draw", "animation", name, "--format", "svg"],
        &["draw", "animation", name, "--format", "html"],
        &["draw", "--all", name, "--format", "html"],
        &["report", name, "--format", "html"],
    ];
    for args in runs {
        let said = assur(&folder, args);
        assert!(said.status == 0 && said.stdout.contains("<svg"), "{args:?}: {}", said.stderr);
        assert!(!said.stdout.contains("onload=\"alert") && !said.stdout.contains("<bad>"), "{args:?}");
    }
}

/// What is there stays where there is nothing to write in its place, or not all of it.
#[test]
fn what_is_there_is_replaced_by_something_complete_alone() {
    let broken = PUMP.replace("revolute  B: crank - rod", "revolute  B: crank - - rod");
    let names = ["old.csv", "old.html", "old.svg", "old.xml", "old"];
    let fresh = || {
        let folder =
            pump().with("bad.mech", &broken).with("none.csv", "r [mm]\n").with("open.csv", "r [mm]\nwide\n");
        std::fs::create_dir(folder.path("empty")).unwrap();
        names.into_iter().fold(folder, |folder, name| folder.with(name, "old\n"))
    };
    let runs: &[(&[&str], &[&str])] = &[
        (&["batch", "IN", "--key", "old.csv"], &["old.csv.part"]),
        (&["batch", "IN", "--out", "old.csv"], &["old.csv.part"]),
        (
            &["batch", "IN", "--out", "old", "--format", "json", "--key", "old.csv"],
            &["old.csv.part", "old.part"],
        ),
        (&["report", "IN", "-o", "old.html"], &[]),
        (&["report", "IN", "--sheet", "-o", "old.html"], &[]),
        (&["report", "IN", "-o", "made"], &["made"]),
        (&["draw", "IN", "scheme", "-o", "old.svg"], &[]),
        (&["draw", "IN", "scheme", "-o", "old.html"], &["old.html.part"]),
        (&["draw", "IN", "scheme", "-o", "made"], &["made"]),
        (&["course", "moodle", "IN", "--pose", "1", "-o", "old.xml"], &["old.xml.part"]),
        (&["course", "prairielearn", "IN", "--pose", "1", "-o", "made"], &["made"]),
        (&["accuracy", "IN", "--plot", "old.svg"], &[]),
    ];
    for (args, parts) in runs {
        // without a problem, with one that has errors, and with one beside a file that is not there
        for inputs in [&["missing.mech"][..], &["empty"], &["bad.mech"], &["missing.mech", "g.mech"]] {
            let folder = fresh();
            let before = folder.names();
            let all: Vec<&str> =
                args.iter().flat_map(|arg| if *arg == "IN" { inputs.to_vec() } else { vec![*arg] }).collect();
            let said = assur(&folder, &all);
            assert!(said.status > 0, "{all:?}");
            for name in names {
                assert_eq!(folder.read(name), "old\n", "{all:?}: {}", said.stderr);
            }
            let new: Vec<String> = folder.names().into_iter().filter(|name| !before.contains(name)).collect();
            let parts: &[&str] = if inputs.len() > 1 { parts } else { &[] };
            assert_eq!(new, parts, "{all:?}: {}", said.stderr);
            let kept = parts.iter().filter(|name| name.ends_with(".part"));
            assert!(kept.clone().all(|name| said.stderr.contains(*name)), "{all:?}: {}", said.stderr);
        }
    }
    // a table without rows, and a key without a row
    let folder = fresh();
    for out in ["--out", "--key"] {
        let said = assur(&folder, &["batch", "g.mech", "--variants", "none.csv", out, "old.csv"]);
        assert!(said.status == 1 && folder.read("old.csv") == "old\n", "{out}: {}", said.stderr);
    }
    let said = assur(&folder, &["batch", "g.mech", "--variants", "open.csv", "--key", "old.csv"]);
    assert!(said.status == 1 && folder.read("old.csv") == "old\n", "{}", said.stderr);
}

/// A file of questions is there as a whole or not at all.
#[cfg(unix)]
#[test]
fn a_course_that_is_stopped_leaves_nothing() {
    let rows: String = (0..400).map(|i| format!("  {}\n", 90.0 + f64::from(i) / 300.0)).collect();
    let folder = Folder::new("course-stopped")
        .with("a.mech", &PUMP.replace("  90\n  110\n", &rows))
        .with("out/q.xml", "q");
    let child = run::start(&folder, &["course", "moodle", "a.mech", "--pose", "1", "-o", "out/q.xml"]);
    let names = || std::fs::read_dir(folder.path("out")).unwrap().count();
    let start = std::time::Instant::now();
    // the questions come one by one, beside the file
    while names() < 2 && start.elapsed().as_secs() < 20 {
        std::thread::sleep(std::time::Duration::from_millis(1));
    }
    let sent = Command::new("kill").args(["-TERM", &child.id().to_string()]).status();
    assert!(sent.is_ok_and(|status| status.success()));
    let said = run::end(child);
    assert_eq!((said.status, names(), folder.read("out/q.xml").as_str()), (143, 1, "q"), "{}", said.stderr);
    assert!(said.stderr.ends_with("interrupted: 0 of 1 files written\n"), "{}", said.stderr);
}

/// A signal leaves no temporary file and no half file, and what is written is counted.
#[test]
fn a_signal_leaves_no_temporary_file() {
    let mut rows = PUMP.replace("  90\n  110\n}\n", "");
    (0..3000).for_each(|i| writeln!(rows, "  {}", 90.0 + f64::from(i) / 300.0).unwrap());
    rows += "}\n";
    let many =
        |count: usize| (0..count).fold(Folder::new("signal"), |f, i| f.with(&format!("in/{i}.mech"), PUMP));
    for (signal, status) in [("TERM", 143), ("HUP", 129), ("INT", 130)] {
        if signal == "HUP" && run::ignores_hangup() {
            continue;
        }
        let runs: [(&[&str], Folder, &str); 4] = [
            (
                &["report", "a.mech", "--sheet", "--per-row", "-o", "out/s.html"],
                many(0).with("a.mech", &rows),
                " of 3000 files written",
            ),
            (&["draw", "in", "--all", "-o", "out"], many(60), " files written"),
            (&["report", "in", "-o", "out"], many(60), " of 60 files written"),
            (
                &["course", "prairielearn", "in", "--pose", "1", "-o", "out"],
                many(400),
                " of 400 files written",
            ),
        ];
        for (args, folder, words) in runs {
            std::fs::create_dir(folder.path("out")).unwrap();
            let child = run::start(&folder, args);
            let names = || -> Vec<String> {
                let entries = std::fs::read_dir(folder.path("out")).unwrap().flatten();
                entries.map(|entry| entry.file_name().to_string_lossy().into_owned()).collect()
            };
            let start = std::time::Instant::now();
            while names().len() < 20 && start.elapsed().as_secs() < 20 {
                std::thread::sleep(std::time::Duration::from_millis(1));
            }
            let id = child.id().to_string();
            let sent = Command::new("kill").args([&format!("-{signal}"), &id]).status();
            assert!(sent.is_ok_and(|status| status.success()), "{args:?}");
            let said = run::end(child);
            assert_eq!(said.status, status, "{args:?} {signal}: {}", said.stderr);
            assert!(names().iter().all(|name| !name.contains(".tmp")), "{args:?} {signal}: {:?}", names());
            let line = said.stderr.lines().last().unwrap_or_default();
            assert!(line.starts_with("interrupted: ") && line.ends_with(words), "{args:?} {signal}: {line}");
        }
    }
}
