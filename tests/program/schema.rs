//! What `solve --format json` prints is held to `docs/json-schema/solution-1.json`, for every example and for wrong files;
//! what `accuracy --format json` prints to `accuracy-1.json`, what `grade --format json` prints to `grade-2.json`;
//! `report-1.json` is held in `formats`.

#![allow(clippy::unwrap_used)] // a test that cannot read its files has failed

mod validate;

use serde_json::Value;
use std::path::Path;
use validate::validate;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn schema() -> Value {
    schema_of("solution-1.json")
}

fn schema_of(name: &str) -> Value {
    let text = std::fs::read_to_string(root().join("docs/json-schema").join(name)).unwrap();
    serde_json::from_str(&text).unwrap()
}

fn json_of(folder: &str) -> String {
    printed(&["solve", folder, "--format", "json"])
}

fn printed(args: &[&str]) -> String {
    let out = std::process::Command::new(env!("CARGO_BIN_EXE_assur"))
        .current_dir(root())
        .args(args)
        .output()
        .unwrap();
    String::from_utf8(out.stdout).unwrap()
}

fn holds(folder: &str) -> usize {
    let schema = schema();
    let json = json_of(folder);
    for line in json.lines() {
        let value: Value = serde_json::from_str(line).unwrap();
        let mut wrong = Vec::new();
        validate(&schema, &schema, &value, "", &mut wrong);
        assert!(wrong.is_empty(), "{}: {}", value["file"], wrong.join("\n"));
    }
    // a file with variants has a line per row
    let mut names: Vec<String> =
        json.lines().map(|l| l.split("\"file\":").nth(1).unwrap().to_owned()).collect();
    names.iter_mut().for_each(|name| name.truncate(name.find("\",").unwrap()));
    names.dedup();
    names.len()
}

#[test]
fn every_example_fits() {
    let all = crate::folder::files(&root().join("examples"), "mech");
    assert_eq!(holds("examples"), all.len(), "every file has its lines");
}

#[test]
fn wrong_files_fit() {
    let all = crate::folder::files(&root().join("tests/errors"), "mech");
    assert_eq!(holds("tests/errors"), all.len(), "every file has its lines");
}

/// Reactions of a locked position do not exist and are left out; those of the other positions stand.
#[test]
fn a_locked_pose_fits_and_has_no_reactions() {
    let file = "tests/errors/friction/no_effort/reactions.mech";
    assert_eq!(holds(file), 1);
    let value: Value = serde_json::from_str(&json_of(file)).unwrap();
    let [moves, locked] = value["poses"].as_array().unwrap().as_slice() else { panic!("two poses") };
    assert_eq!(moves["reactions"].as_object().unwrap().len(), 4);
    // X (1 - f tan β) = 1000 N, sin β = sin 20° / 1.3
    let rod = moves["reactions"]["C"][0]["force"][0].as_f64().unwrap();
    assert!((rod + 1692.188).abs() < 1e-3, "{rod}");
    for absent in ["reactions", "balances", "residuals", "error"] {
        assert!(locked.get(absent).is_none(), "{absent} in {locked}");
    }
    let told: Vec<&str> =
        value["diagnostics"].as_array().unwrap().iter().filter_map(|d| d["code"].as_str()).collect();
    assert_eq!(
        told,
        ["mech::friction::locked", "mech::geometry::unusual_value", "mech::friction::no_effort"]
    );
}

/// One object per position, of which the poses are those of `solution-1.json`.
#[test]
fn positions_one_after_another_fit() {
    let (schema, whole) = (schema_of("position-1.json"), schema());
    for (name, part) in schema["$defs"].as_object().unwrap() {
        assert_eq!(*part, whole["$defs"][name], "{name} is one thing in both");
    }
    for (folder, least) in [("examples", 600), ("examples/exercise-set", 75), ("tests/errors/solve", 1)] {
        let lines = printed(&["solve", folder, "--format", "jsonl"]);
        for line in lines.lines() {
            let value: Value = serde_json::from_str(line).unwrap();
            let mut wrong = Vec::new();
            validate(&schema, &schema, &value, "", &mut wrong);
            assert!(wrong.is_empty(), "{}: {}", value["file"], wrong.join("\n"));
        }
        assert!(lines.lines().count() >= least, "{folder}: {}", lines.lines().count());
    }
}

#[test]
fn marks_fit() {
    let key = "examples/exercise-set/key.csv";
    let value: Value = serde_json::from_str(&printed(&["grade", key, key, "--format", "json"])).unwrap();
    fits_schema("grade-2.json", &value);
    assert_eq!(value["right"], value["total"]);
    for part in ["diagnostic", "place"] {
        assert_eq!(
            schema_of("grade-2.json")["$defs"][part],
            schema()["$defs"][part],
            "{part} is one thing in both"
        );
    }
}

/// Every kind of setting is in one of these.
#[test]
fn what_accuracy_costs_fits() {
    let schema = schema_of("accuracy-1.json");
    let files = [
        "accuracy/four-bar",
        "accuracy/crank-slider-with-friction",
        "cycle/crank-slider",
        "simulation/flap-in-oil",
    ];
    for file in files.into_iter().chain(["general/class-iii-triad", "general/class-iv-group"]) {
        let file = format!("examples/{file}.mech");
        let value = serde_json::from_str(&printed(&["accuracy", &file, "--format", "json"])).unwrap();
        let mut wrong = Vec::new();
        validate(&schema, &schema, &value, "", &mut wrong);
        assert!(wrong.is_empty(), "{file}: {}", wrong.join("\n"));
    }
}

/// With `--within` the settings taken stand in every object.
#[test]
fn accuracy_that_is_kept_fits() {
    let schema = schema();
    let json = printed(&["solve", "examples/friction", "--format", "json", "--within", "1e-6"]);
    for line in json.lines() {
        let value: Value = serde_json::from_str(line).unwrap();
        let mut wrong = Vec::new();
        validate(&schema, &schema, &value, "", &mut wrong);
        assert!(wrong.is_empty() && value["accuracy"]["within"] == 1e-6, "{}: {wrong:?}", value["file"]);
    }
    assert!(json.lines().count() > 10);
}

/// Whether a value fits a schema.
pub fn fits_schema(name: &str, value: &Value) {
    let schema = schema_of(name);
    let mut wrong = Vec::new();
    validate(&schema, &schema, value, "", &mut wrong);
    assert!(wrong.is_empty(), "{name}: {}", wrong.join("\n"));
}

#[test]
fn the_validator_finds_what_does_not_fit() {
    let schema = schema();
    let check = |text: &str| {
        let mut wrong = Vec::new();
        validate(&schema, &schema, &serde_json::from_str(text).unwrap(), "", &mut wrong);
        wrong.join("; ")
    };
    assert_eq!(check(r#"{"schema": "assur.solution/1", "file": "a.mech", "diagnostics": []}"#), "");
    let wrong =
        check(r#"{"schema": "other", "file": 1, "poses": [{"name": "1", "drives": {"a": [1]}, "x": 0}]}"#);
    for part in ["/schema", "/file", "/poses/0/drives/a", "/poses/0/x", "diagnostics is missing"] {
        assert!(wrong.contains(part), "{part} in {wrong}");
    }
}
