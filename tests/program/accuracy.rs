//! `assur accuracy`, and `--within`, as run from a shell.

use crate::cli::GOOD;
use crate::run::{Folder, assur};

/// The lines with single blanks; in a row with an error and its digits the time before them is left out.
fn plain_rows(tables: &str) -> String {
    let line = |line: &str| {
        // the mark of a time that scatters
        let mut words: Vec<&str> = line.split_whitespace().filter(|word| *word != "~").collect();
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
    let out = assur(&folder, &["accuracy", "a.mech", "--for", "1e-6", "--plot", "a.svg", "--details"]);
    assert_eq!((out.status, out.stderr.as_str()), (0, ""));
    let (answer, tables) = out.stdout.split_once("Measured\n").unwrap();
    let short = assur(&folder, &["accuracy", "a.mech", "--for", "1e-6"]).stdout;
    assert!(short.lines().count() <= 10 && short.lines().all(|line| line.chars().count() <= 110), "{short}");
    for part in [
        "f64, as the file is",
        "Recommended for 1e-6: the file as it is; fewer digits would save nothing.",
        "A position, ns: positions ",
    ] {
        assert!(answer.contains(part) && short.contains(part), "{part}: {answer}");
    }
    let tables = format!("Measured\n{tables}");
    insta::assert_snapshot!(plain_rows(&tables), @r"
        Measured
         2 positions, compared with the same positions in double-double, whose own error is about 2e-31.
         Errors are the greatest over all positions: positions relative to 0.35 m, velocities relative to 35 m/s.
         Times are the best of repeated runs, on one thread.

        Scalar: the number type of every position
         numbers µs per position error digits
         ─ ─ ─ ─
         f64 µs 2e-16 15.8
         double-double µs 2e-31 30.7

        Settings without effect here
         - friction: none in this problem
         - general groups: none in this problem
         - triads: none in this problem
         - samples: no functions over the cycle
        ");
    let svg = folder.read("a.svg");
    assert!(
        svg.starts_with("<svg")
            && svg.contains("What accuracy and effects cost")
            && svg.contains("double-double"),
        "{svg}"
    );
    let out = assur(&folder, &["accuracy", "a.mech", "--format", "json", "--set", "r=120mm"]);
    let value: serde_json::Value = serde_json::from_str(&out.stdout).unwrap();
    assert_eq!(
        (&value["schema"], &value["reference"]),
        (&"assur.accuracy/1".into(), &"double-double".into())
    );
    assert_eq!(value["summary"]["rows"][0]["file"], true, "{}", value["summary"]);
    let rows = value["knobs"][0]["settings"].as_array().unwrap();
    let names: Vec<&str> = rows.iter().filter_map(|r| r["setting"].as_str()).collect();
    assert_eq!(names, ["f64", "double-double"]);
    assert!(rows.iter().all(|r| r["microseconds"].as_f64().unwrap() > 0.0));
}

/// A truss, which has no drive.
#[test]
fn a_position_without_a_drive_has_its_time() {
    let text = "ground { A (0, 0); B (2 m, 0) }\nlink ab A-C 2 m\nlink cb B-C 2 m\nrevolute A: ground - ab\n\
                revolute B: ground - cb\nrevolute C: ab - cb\nassemble C left of A-B\n\
                force P on ab at C = 8 kN down\nfind axial(ab)\n";
    let folder = Folder::new("accuracy-of-a-truss").with("a.mech", text);
    let out = assur(&folder, &["accuracy", "a.mech", "--details"]);
    assert!(out.status == 0 && !out.stdout.contains("inf "), "{}", out.stdout);
    let out = assur(&folder, &["accuracy", "a.mech", "--format", "json"]).stdout;
    let value: serde_json::Value = serde_json::from_str(&out).unwrap();
    let time = value["summary"]["rows"][0]["microseconds"].as_f64();
    assert!(time.is_some_and(|time| time > 0.0 && time < 1e6), "{out}");
}

const FALLING: &str = r#"mech 1
mechanism "A bar that falls"
gravity 9.81 m/s^2
ground { A (0, 0) }
link bar A-P 1 m { mass 1 kg at P; inertia 0 kg*m^2 }
revolute A: ground - bar
start bar = 0 deg
simulate 1 s in 4 steps
find angle(bar), omega(bar)
"#;

#[test]
fn the_accuracy_of_a_motion_is_measured() {
    let folder = Folder::new("accuracy-of-runs").with("a.mech", FALLING);
    let short = assur(&folder, &["accuracy", "a.mech", "--for", "1e-6"]).stdout;
    assert!(short.lines().count() <= 10 && short.contains("▸") && short.contains("--within 1e-"), "{short}");
    let out = assur(&folder, &["accuracy", "a.mech", "--for", "1e-6", "--plot", "a.svg", "--details"]);
    assert_eq!((out.status, out.stderr.as_str()), (0, ""));
    for part in [
        "As `solve` does it: energy",
        "DOP853",
        "Radau IIA of order 5",
        "in all runs",
        "reported",
        "an evaluation",
        "measured",
        "Recommended for ",
    ] {
        assert!(out.stdout.contains(part), "{part}: {}", out.stdout);
    }
    let svg = folder.read("a.svg");
    assert!(
        svg.starts_with("<svg") && svg.contains("time of the whole run, ") && svg.contains(">Radau IIA<"),
        "{svg}"
    );
    // what is offered can be written
    let out = assur(&folder, &["solve", "a.mech", "--within", "1e-8", "--method", "dop853", "--accuracy"]);
    assert_eq!((out.status, out.stderr.as_str()), (0, ""));
    assert!(
        out.stdout.contains("integrated by DOP853") && out.stdout.contains("an error of 1e-8 took "),
        "{}",
        out.stdout
    );
    let by = |args: &[&str]| assur(&folder, &[&["solve", "a.mech", "--format", "csv"], args].concat()).stdout;
    assert_ne!(by(&[]), by(&["--method", "radau"]));
    let out = assur(&folder, &["accuracy", "a.mech", "--format", "json"]);
    let value: serde_json::Value = serde_json::from_str(&out.stdout).unwrap();
    let knob = &value["knobs"][0];
    assert_eq!((&value["positions"], &knob["name"], &knob["per"]), (&5.into(), &"run".into(), &"run".into()));
    assert_eq!(value["reference"], "double-double");
    let row = &knob["settings"][0];
    assert!(
        row["steps"].as_u64() > Some(0) && row["errors"]["angular velocities"].as_f64() > Some(0.0),
        "{row}"
    );
    let out = assur(&folder, &["accuracy", "a.mech", "--for", "1e-18"]);
    assert_eq!(out.status, 1);
    assert!(out.stderr.contains("mech::accuracy::out_of_reach"), "{}", out.stderr);
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

/// A structure without a drive stands in one position, which takes its time.
#[test]
fn the_time_of_a_file_without_a_drive_is_measured() {
    let truss = "ground { A (0, 0); B (2 m, 0) }\nlink ab A-C 2 m\nlink cb B-C 2 m\nrevolute A: ground - ab\n\
                 revolute B: ground - cb\nrevolute C: ab - cb\nassemble C left of A-B\n\
                 force P on ab at C = 8 kN down\nfind axial(ab)\n";
    let folder = Folder::new("no-drive").with("a.mech", truss);
    let out = assur(&folder, &["accuracy", "a.mech", "--format", "json"]);
    assert_eq!((out.status, out.stderr.as_str()), (0, ""));
    let value: serde_json::Value = serde_json::from_str(&out.stdout).unwrap();
    let settings = value["knobs"][0]["settings"].as_array().unwrap();
    let found: Vec<f64> =
        settings.iter().map(|row| row["microseconds"].as_f64().unwrap_or(f64::NAN)).collect();
    assert!(found.len() == 2 && found.iter().all(|time| (1e-4..1e4).contains(time)), "{}", out.stdout);
}
