//! Every program below `examples/`: its answer key holds, and one snapshot beside it shows all stages.
//!
//! A snapshot that turns from solved to failed, or back, is refused until it is deleted by hand.

mod folder;

use assur::internals::check::Overrides;
use assur::internals::diagnostic::Problems;
use assur::internals::report::document::{Block, Report};
use assur::internals::report::text::Look;
use assur::internals::report::{self, AccuracyShown, PrintedDigits};
use assur::internals::source::Source;
use assur::internals::{Compiled, Solved};
use libtest_mimic::{Arguments, Failed, Trial};
use std::path::{Path, PathBuf};

/// Tables are not broken in snapshots.
const WIDE: Look = Look { colour: false, width: usize::MAX, fill: false };

fn main() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let trial = |path: PathBuf| {
        let name = path.strip_prefix(&root).unwrap_or(&path).display().to_string();
        Trial::test(name.clone(), move || holds(&path, &name))
    };
    let trials = folder::files(&root, "mech").into_iter().map(trial).collect();
    libtest_mimic::run(&Arguments::from_args(), trials).exit();
}

fn holds(path: &Path, name: &str) -> Result<(), Failed> {
    let source = Source::new(name.replace('\\', "/"), std::fs::read_to_string(path)?);
    let (compiled, mut problems) = assur::internals::compile(&source, &Overrides::none());
    let mut stages = compiled.as_ref().map(|c| structure(&source, c)).unwrap_or_default();
    if let Some(compiled) = &compiled {
        effects_agree(&source, compiled, &stages)?;
    }
    let (solved, found) = match compiled.filter(|_| !problems.has_errors()) {
        Some(compiled) => assur::internals::pipeline::solve(compiled),
        None => return stands(path, &shown(FAILED, &stages, &problems, &source)),
    };
    problems.append(found);
    match solved {
        Ok(solved) if !problems.has_errors() => {
            answer_key(&solved, &source)?;
            rows_hold(&source)?;
            let answers = solved.answers(PrintedDigits::STABLE);
            let answers = report::of_answers(&source.name, &answers, AccuracyShown::EveryPose);
            // the structure stands in full already
            stages.sections.extend(answers.sections.into_iter().filter(|s| s.heading != "Structure"));
            stands(path, &shown(SOLVED, &stages, &problems, &source))
        }
        _ => stands(path, &shown(FAILED, &stages, &problems, &source)),
    }
}

const SOLVED: &str = "outcome: solved";
const FAILED: &str = "outcome: failed";

fn structure(source: &Source, compiled: &Compiled) -> Report {
    let report = report::of_structure(source, &compiled.model(), None);
    Report { notes: Vec::new(), ..report }
}

/// JSON has the effects of the table, by the same names in the same order.
fn effects_agree(source: &Source, compiled: &Compiled, stages: &Report) -> Result<(), Failed> {
    let json = report::json::render(&source.name, Some(&compiled.model()), None, &[]);
    let json: serde_json::Value = serde_json::from_str(&json)?;
    let names: Vec<&str> =
        json["effects"].as_array().into_iter().flatten().filter_map(serde_json::Value::as_str).collect();
    let facts = stages.sections.iter().flat_map(|s| &s.blocks).filter_map(|block| match block {
        Block::Facts(facts) => facts.iter().find(|f| f.0 == "effects"),
        _ => None,
    });
    let table = facts.map(|f| f.1.as_str()).next().unwrap_or("positions only");
    let listed = if names.is_empty() { "positions only".to_owned() } else { names.join(", ") };
    if listed == table { Ok(()) } else { Err(format!("effects: {table}, in JSON {listed}").into()) }
}

fn shown(outcome: &str, stages: &Report, problems: &Problems, source: &Source) -> String {
    format!("{outcome}\n{}{}", report::text::render(stages, WIDE), list(problems, source))
}

/// Diagnostics by code and line: their words have tests of their own.
fn list(problems: &Problems, source: &Source) -> String {
    let views = problems.views(source);
    let line = |v: &assur::internals::diagnostic::DiagnosticView| {
        let at = v.spans.first().map(|s| format!(", line {}", s.start.line)).unwrap_or_default();
        format!("  {} {}{at}\n", v.severity, v.code.as_deref().unwrap_or("without code"))
    };
    let lines: String = views.iter().map(line).collect();
    if lines.is_empty() { lines } else { format!("\nDiagnostics\n{lines}") }
}

/// Every row of a table of variants is solved, and meets its expectations.
fn rows_hold(source: &Source) -> Result<(), Failed> {
    let (document, _) = assur::internals::syntax::parse(source);
    let document = std::sync::Arc::new(document);
    let overrides = Overrides::none();
    let rows = match assur::internals::pipeline::FileVariants::of(&document, &overrides) {
        None => return Ok(()),
        Some(rows) => rows.map_err(|_| "the table of variants has an error")?,
    };
    for row in rows.solve(true) {
        if row.problems.has_errors() || row.solved.is_none() {
            let shown = assur::internals::diagnostic::render(
                &row.problems,
                source,
                assur::internals::diagnostic::Style::PLAIN,
            );
            return Err(format!("row {}: {shown}", row.number).into());
        }
    }
    Ok(())
}

fn answer_key(solved: &Solved, source: &Source) -> Result<(), Failed> {
    let mut mismatches = Problems::new();
    mismatches.extend(assur::internals::exercise::mismatches(&solved.outcomes));
    if mismatches.is_empty() {
        return Ok(());
    }
    Err(assur::internals::diagnostic::render(&mismatches, source, assur::internals::diagnostic::Style::PLAIN)
        .into())
}

/// Compares with the snapshot beside the file.
fn stands(path: &Path, text: &str) -> Result<(), Failed> {
    let snapshot = path.with_extension("snap");
    let before = std::fs::read_to_string(&snapshot).unwrap_or_default();
    let now = text.lines().next().unwrap_or_default();
    for other in [SOLVED, FAILED] {
        if other != now && before.lines().any(|line| line == other) {
            let shown = snapshot.display();
            return Err(format!(
                "{shown} says `{other}`, now it is `{now}`: delete it by hand to accept\n{text}"
            )
            .into());
        }
    }
    let folder = path.parent().ok_or("a folder")?;
    let name = path.file_stem().and_then(|n| n.to_str()).ok_or("a name")?;
    let same = std::panic::catch_unwind(|| {
        insta::with_settings!({
            snapshot_path => folder,
            prepend_module_to_snapshot => false,
            omit_expression => true,
        }, {
            insta::assert_snapshot!(name, text);
        });
    });
    same.map_err(|_| "the snapshot beside the file differs".into())
}
