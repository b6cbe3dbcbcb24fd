//! Scenes with their right numbers, by closed forms or by integration from event to event to 1e-9, without the program.

#![allow(clippy::unwrap_used)] // a test that cannot read its text has failed

use assur::Problem;
use serde_json::Value;
use std::fs;
use std::path::Path;

/// Of the number, or of one.
const TOLERANCE: f64 = 1e-6;

/// A number of a solution, or why there is none.
fn answer(solution: &Value, quantity: &str, time: Option<f64>) -> Option<f64> {
    let (quantity, size) = quantity.strip_prefix("mag ").map_or((quantity, false), |of| (of, true));
    let of = |value: &Value| {
        let parts = || value.as_array()?.iter().map(Value::as_f64).collect::<Option<Vec<f64>>>();
        if size { parts().map(|parts| parts[0].hypot(parts[1])) } else { value.as_f64() }
    };
    let whole = || of(&solution["cycle"][quantity]);
    let Some(time) = time else {
        let last = || solution["poses"].as_array()?.last().map(|pose| &pose["quantities"][quantity]);
        return whole().or_else(|| of(last()?));
    };
    let poses = solution["poses"].as_array()?;
    let pose = poses.iter().find(|pose| pose["time"].as_f64().is_some_and(|t| (t - time).abs() < 1e-9))?;
    of(&pose["quantities"][quantity])
}

#[test]
fn scenes_have_their_right_numbers() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/mechanics/contact");
    let rows: Value = serde_json::from_str(&fs::read_to_string(folder.join("scenes.json")).unwrap()).unwrap();
    let mut failures = Vec::new();
    for row in rows.as_array().unwrap() {
        let (scene, quantity) = (row["scene"].as_str().unwrap(), row["quantity"].as_str().unwrap());
        let text = fs::read_to_string(folder.join(format!("scenes/{scene}.mech"))).unwrap();
        let solution: Value = serde_json::from_str(&Problem::new(scene, text).solve_json()).unwrap();
        let right = row["right"].as_f64().unwrap();
        let got = answer(&solution, quantity, row["time"].as_f64());
        if got.is_some_and(|got| (got - right).abs() <= TOLERANCE * right.abs().max(1.0)) {
            continue;
        }
        failures.push(format!("{scene}: {quantity} is {got:?}, not {right}"));
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}
