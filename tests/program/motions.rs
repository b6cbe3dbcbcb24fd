//! Motions under loads as run from a shell: rows of a batch, a signal on the way.

#![allow(clippy::unwrap_used)] // a test that cannot run the program has failed

use crate::run::{self, Folder, Said, assur};

/// A pendulum with a spring; every row of a batch has its own length and stiffness.
const SWING: &str = r#"mech 1
given l = 1 m
given k = 5 N*m/rad
gravity 9.81 m/s^2
ground { A (0, 0) }
link bar A-P l { mass 1 kg at P; inertia 0.1 kg*m^2 }
revolute A: ground - bar
torque in A = -k*angle(bar)
start bar = 0 deg
simulate 1 s within 1e-7
event lowest: omega(bar) = 0 rad/s
find angle(bar) as deg, energy()
"#;

/// Two rods that swing for longer than anybody waits.
const LONG: &str = r#"mech 1
gravity 9.81 m/s^2
ground { A (0, 0) }
link one A-B 1 m { mass 1 kg at B; inertia 0 kg*m^2 }
link two B-C 1 m { mass 1 kg at C; inertia 0 kg*m^2 }
revolute A: ground - one
revolute B: one - two
start one = 0 deg
start two = 0 deg
simulate 20000 s in 20000 steps within 1e-3
find angle(one), angle(two)
"#;

fn table(rows: usize) -> String {
    let row = |i: usize| format!("{},{}\n", 500 + i, (i * 7) % 40);
    "l [mm],k [N*m/rad]\n".to_owned() + &(0..rows).map(row).collect::<String>()
}

#[test]
fn a_thousand_motions_come_out_alike_on_any_number_of_threads() {
    let folder = Folder::new("motions").with("a.mech", SWING).with("t.csv", &table(1000));
    let batch = |threads: &str| {
        let args = ["batch", "a.mech", "--variants", "t.csv", "--format", "csv", "--threads", threads];
        let out = assur(&folder, &args);
        assert_eq!(out.status, 0, "{}", out.stderr);
        out.stdout
    };
    let one = batch("1");
    assert_eq!(one, batch("8"));
    let mut lines = one.lines();
    assert_eq!(
        lines.next(),
        Some("row,l [mm],k [N*m/rad],time [s],event,angle(bar) [deg],energy() [N*m],error")
    );
    // a row is the file with its values
    let of_row = |wanted: &str| -> Vec<String> {
        let cells = one.lines().map(|line| line.splitn(4, ',').collect::<Vec<_>>());
        let rows = cells.filter(|cells| cells[0] == wanted);
        rows.map(|cells| cells[3].trim_end_matches(',').to_owned()).collect()
    };
    assert!(one.lines().filter(|line| line.contains(",lowest,")).count() > 500, "{one}");
    for row in [1, 500, 987] {
        let (l, k) = (format!("l={}mm", 499 + row), format!("k={}N*m/rad", ((row - 1) * 7) % 40));
        let out = assur(&folder, &["solve", "a.mech", "--format", "csv", "--set", &l, "--set", &k]);
        let alone: Vec<&str> = out.stdout.lines().skip(1).collect();
        assert_eq!(of_row(&row.to_string()), alone, "row {row}");
    }
}

#[cfg(unix)]
fn interrupted(folder: &Folder, args: &[&str], seconds: u64) -> Said {
    let child = run::start(folder, args);
    std::thread::sleep(std::time::Duration::from_secs(seconds));
    let id = child.id().to_string();
    assert!(std::process::Command::new("kill").args(["-INT", &id]).status().is_ok_and(|s| s.success()));
    run::end(child)
}

#[cfg(unix)]
#[test]
fn a_motion_that_is_stopped_shows_what_it_did() {
    let folder = Folder::new("stopped").with("a.mech", LONG);
    for format in ["csv", "table", "jsonl"] {
        let lines = |seconds: u64| {
            let said = interrupted(&folder, &["solve", "a.mech", "--format", format], seconds);
            assert_eq!(said.status, 130, "{}", said.stderr);
            assert!(said.stderr.contains("the motion was stopped at"), "{}", said.stderr);
            // no bar where nobody looks
            assert!(!said.stderr.contains("run 1") && !said.stderr.contains('\r'), "{}", said.stderr);
            said.stdout.lines().count()
        };
        // a busy machine comes less far
        let counts = [1, 4, 16].into_iter().map(lines).find(|&count| count > 100);
        assert!(counts.is_some_and(|count| count < 20_000), "{format}: {counts:?} lines");
    }
}

#[cfg(unix)]
#[test]
fn a_batch_of_motions_that_is_stopped_keeps_whole_rows() {
    let swing = SWING.replace("simulate 1 s", "simulate 300 s");
    let folder = Folder::new("stopped-rows").with("a.mech", &swing).with("t.csv", &table(20_000));
    let said = interrupted(&folder, &["batch", "a.mech", "--variants", "t.csv", "--out", "b.csv"], 2);
    assert_eq!(said.status, 130, "{}", said.stderr);
    assert!(said.stderr.contains("interrupted after"), "{}", said.stderr);
    let part = folder.read("b.csv.part");
    assert!(part.ends_with("\r\n") && !part.contains("stopped"), "{part}");
}

/// Numbers that are known to fewer digits than asked for are printed with an error, and no line is empty.
#[test]
fn a_missed_accuracy_leaves_no_line_without_numbers() {
    let text = LONG.replace("20000 s in 20000 steps within 1e-3", "12 s in 4 steps within 1e-11");
    // upright, where every digit that is missing grows
    let text = text.replace("one = 0 deg", "one = 90 deg").replace("two = 0 deg", "two = 90.001 deg");
    let folder = Folder::new("missed").with("a.mech", &text);
    let out = assur(&folder, &["solve", "a.mech", "--format", "csv"]);
    assert!(out.stderr.contains("mech::simulate::tolerance"), "{}", out.stderr);
    let lines: Vec<&str> = out.stdout.lines().collect();
    assert_eq!(lines.len(), 6, "{}", out.stdout);
    assert!(lines.iter().all(|line| line.split(',').all(|cell| !cell.is_empty())), "{}", out.stdout);
    let out = assur(&folder, &["solve", "a.mech"]);
    assert!(out.stdout.contains("wanted was 1e-11"), "{}", out.stdout);
}

/// An engine that friction stops; then more pairs hold than it takes.
const STOPS: &str = r#"mech 1
gravity 9.81 m/s^2
ground { A (0, 0); line guide through A along 0 deg }
link crank  A-B 60 mm { mass 2 kg at A; inertia 0.03 kg*m^2 }
link rod    B-C 210 mm { S (70 mm, 0); mass 0.9 kg at S; inertia 0.006 kg*m^2 }
link piston { C (0, 0); mass 0.7 kg at C }
revolute  A: ground - crank { friction_circle 30 mm }
revolute  B: crank - rod { friction_circle 4 mm }
revolute  C: rod - piston { friction_circle 2 mm }
prismatic D: piston.C - ground.guide { friction 0.4 }
assemble C ahead of B
start crank = 30 deg at 4 rad/s
simulate 1 s in 2 steps within 1e-6
find omega(crank), reaction(A, crank)
find reactions
"#;

#[test]
fn no_form_has_numbers_for_what_friction_shares() {
    let folder = Folder::new("shared").with("a.mech", STOPS);
    let said = "how pairs share what friction holds is not determined";
    for format in ["table", "json", "jsonl", "csv", "markdown", "latex", "typst"] {
        let out = assur(&folder, &["solve", "a.mech", "--format", format]).stdout;
        assert!(!out.contains("NaN") && !out.contains("null"), "{format}: {out}");
        assert!(format != "table" || out.contains(said), "{out}");
    }
    let report = assur(&folder, &["report", "a.mech", "--pose", "1"]);
    assert!(report.stdout.contains("neither are the reactions"), "{}", report.stdout);
    assert!(!report.stdout.contains("NaN"), "{}", report.stdout);
    let drawn = assur(&folder, &["draw", "a.mech", "forces", "--pose", "1"]);
    assert!(drawn.status == 1 && drawn.stderr.contains("mech::picture::no_forces"), "{}", drawn.stderr);
}

/// Errors of steps grow so that rounding alone is greater than what is wanted: finer runs are not tried for seconds.
#[test]
fn what_rounding_makes_vain_is_refused_early() {
    let text = include_str!("../../examples/simulation/triad.mech")
        .replace("stiffness 300 N", "stiffness 300000000 N");
    let text: String =
        text.lines().filter(|line| !line.starts_with("expect")).map(|line| format!("{line}\n")).collect();
    let folder = Folder::new("vain").with("a.mech", &text);
    let out = assur(&folder, &["solve", "a.mech"]);
    assert!(out.status == 1 && out.stderr.contains("wanted was 1e-11"), "{}", out.stderr);
    let words: Vec<&str> = out.stdout.split_whitespace().collect();
    let spent = words.windows(2).find(|pair| pair[1] == "evaluations").unwrap()[0];
    assert!(spent.parse::<usize>().unwrap() < 1_000_000, "{spent}");
}
