//! The programs below examples/hard against references of 50 digits: the error of every quantity keeps c ε/σ^k, σ as
//! it is reported.
//!
//! The references come from tests/reference/hard/catalogue.py.

use assur::internals::check::Overrides;
use assur::internals::model::{FindKind, Value};
use assur::internals::source::Source;
use std::path::Path;

/// c in the bound c ε/σ^k.
pub const BOUND: f64 = 64.0;

/// A row of the references.
#[derive(Clone, Debug)]
pub struct Row {
    pub file: String,
    pub settings: String,
    pub pose: usize,
    pub quantity: String,
    pub value: [f64; 2],
    pub scale: f64,
    pub power: i32,
}

/// How near a row is met.
#[derive(Clone, Debug)]
pub struct Met {
    pub row: Row,
    /// Relative to the row's scale; absent where there is no number.
    pub error: Option<f64>,
    pub condition: f64,
}

/// One solved program.
#[derive(Clone, Debug)]
pub struct Ran {
    pub file: String,
    pub settings: String,
    /// Codes of what the user is told.
    pub told: Vec<String>,
    pub met: Vec<Met>,
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

pub fn rows() -> Vec<Row> {
    let path = root().join("tests/reference/hard/catalogue.csv");
    let text = std::fs::read_to_string(path).expect("the references");
    let number = |x: &str| x.parse::<f64>().expect("a number");
    let rows = text.lines().skip(1).map(|line| {
        let cells: Vec<&str> = line.split(',').collect();
        let [file, settings, pose, quantity, high, low, scale, power] = cells.as_slice() else {
            panic!("eight cells: {line}");
        };
        Row {
            file: (*file).to_owned(),
            settings: (*settings).to_owned(),
            pose: pose.parse().expect("a pose"),
            quantity: (*quantity).to_owned(),
            value: [number(high), number(low)],
            scale: number(scale),
            power: power.parse().expect("a power"),
        }
    });
    rows.collect()
}

/// Solves every program of the catalogue with each of its settings.
pub fn runs() -> Vec<Ran> {
    let mut groups: Vec<Vec<Row>> = Vec::new();
    for row in rows().into_iter().filter(|r| r.file != "chain") {
        match groups.last_mut() {
            Some(last) if last[0].file == row.file && last[0].settings == row.settings => last.push(row),
            _ => groups.push(vec![row]),
        }
    }
    groups.into_iter().map(ran).collect()
}

fn ran(rows: Vec<Row>) -> Ran {
    let (file, settings) = (rows[0].file.clone(), rows[0].settings.clone());
    let name = format!("examples/hard/{file}.mech");
    let source = Source::new(&name, std::fs::read_to_string(root().join(&name)).expect("an example"));
    let pairs = settings.split_whitespace().filter_map(|s| s.split_once('='));
    let values = pairs.map(|(name, value)| (name.to_owned(), value.to_owned())).collect();
    let (solved, problems) =
        assur::internals::solve_source(&source, &Overrides { values, ..Overrides::none() });
    let told = problems.views(&source).iter().filter_map(|v| v.code.clone()).collect();
    let met = rows.into_iter().map(|row| {
        let solution = solved.as_ref().map(|s| (&s.compiled, &s.solution));
        let at = solution.and_then(|(c, s)| Some((c, s, s.poses.get(row.pose)?.outcome.as_ref().ok()?)));
        let Some((compiled, solution, at)) = at else { return Met { row, error: None, condition: 0.0 } };
        let find = compiled.mechanism.finds.iter().find(|f| f.name == row.quantity);
        let Some(FindKind::Value { expr, .. }) = find.map(|f| &f.kind) else { panic!("{row:?}") };
        let model = compiled.model();
        let error = match solution.view(&model, at).value(expr) {
            Value::Scalar(x) if x.is_finite() => Some(((x - row.value[0]) - row.value[1]).abs() / row.scale),
            _ => None,
        };
        Met { row, error, condition: at.condition }
    });
    Ran { file, settings, told, met: met.collect() }
}

impl Met {
    /// The error in units of ε/σ^k.
    pub fn share(&self) -> Option<f64> {
        Some(self.error? * self.condition.powi(self.row.power) / f64::EPSILON)
    }
}

#[test]
fn every_error_keeps_its_bound() {
    let mut wrong = Vec::new();
    for ran in runs() {
        for met in &ran.met {
            match met.share() {
                Some(share) if share <= BOUND => {}
                // no number: then a diagnostic says why
                None if !ran.told.is_empty() => {}
                share => wrong.push(format!(
                    "{} {} pose {} {}: error {:?}, condition {:.1e}, share {share:?}, told {:?}",
                    ran.file,
                    ran.settings,
                    met.row.pose,
                    met.row.quantity,
                    met.error,
                    met.condition,
                    ran.told
                )),
            }
        }
    }
    assert!(wrong.is_empty(), "{} beyond {BOUND} ε/σ^k\n{}", wrong.len(), wrong.join("\n"));
}

/// Fewer than seven digits are warned of, and as many as are said are there.
#[test]
fn lost_digits_are_told() {
    let mut wrong = Vec::new();
    for ran in runs() {
        let worst = ran.met.iter().filter_map(|m| m.error).fold(0.0, f64::max);
        let warned = ran.told.iter().any(|code| code == "mech::solve::ill_conditioned");
        if worst > 1e-7 && !warned {
            wrong.push(format!("{} {}: error {worst:.1e}, told {:?}", ran.file, ran.settings, ran.told));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
