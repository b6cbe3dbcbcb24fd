//! `check` and `solve` have one verdict: what `check` refuses `solve` refuses, and what `solve` refuses before it solves anything
//! `check` refuses.

use assur::internals::check::Overrides;
use assur::internals::diagnostic::Problems;
use assur::internals::editor::Analysis;
use assur::internals::pipeline::{FileVariants, look_at};
use assur::internals::source::Source;
use assur::internals::syntax;
use std::path::Path;
use std::sync::Arc;

/// Stages and codes of what is found while a position, an assembly or a motion is looked for.
const WHILE_SOLVING: &[&str] =
    &["assembly", "solve", "simulate", "friction", "accuracy", "train", "cam", "expect", "curve"];
const LATER: &[&str] = &["mech::geometry::empty_range", "mech::request::too_many_positions"];

fn solved(source: &Source) -> Problems {
    let none = Overrides::none();
    let (document, mut found) = syntax::parse(source);
    let document = Arc::new(document);
    match FileVariants::of(&document, &none).filter(|_| !found.has_errors()) {
        Some(Ok(rows)) => rows.solve(false).for_each(|row| found.append(row.problems)),
        Some(Err(problems)) => return problems,
        None => return assur::internals::solve_source(source, &none).1,
    }
    found
}

#[test]
fn check_and_solve_agree() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests");
    let (mut count, mut wrong) = (0, Vec::new());
    let files = ["errors", "cases"].map(|folder| crate::folder::files(&root.join(folder), "mech"));
    for path in files.concat() {
        let Ok(text) = std::fs::read_to_string(&path) else { continue };
        let name = path.strip_prefix(&root).unwrap_or(&path).display().to_string();
        // hostile files and long motions are for tests of their own
        if name.starts_with("cases/hostile") || text.contains("simulate") || text.len() > 20_000 {
            continue;
        }
        let source = Source::new(&*name, text);
        let (checked, solved) = (look_at(&source, &Overrides::none()).1, solved(&source));
        let early =
            solved.views(&source).into_iter().filter(|d| d.severity == "error").filter_map(|d| d.code).find(
                |code| {
                    !LATER.contains(&code.as_str())
                        && !WHILE_SOLVING.contains(&code.split("::").nth(1).unwrap_or_default())
                },
            );
        if checked.has_errors() && !solved.has_errors() {
            wrong.push(format!("{name}: only `check` refuses it"));
        } else if let Some(code) = early.filter(|_| !checked.has_errors()) {
            wrong.push(format!("{name}: only `solve` refuses it: {code}"));
        }
        count += 1;
    }
    assert!(wrong.is_empty() && count > 400, "{count}\n{}", wrong.join("\n"));
}

/// A `given` that every row replaces is none of the file's mistakes.
#[test]
fn a_given_that_rows_replace() {
    let text = include_str!("../cases/use3/limits/given-that-rows-replace.mech");
    let verdict = |text: &str| {
        let source = Source::new("rows.mech", text);
        (look_at(&source, &Overrides::none()).1.has_errors(), solved(&source).has_errors())
    };
    assert_eq!(verdict(text), (false, false));
    assert_eq!(verdict(&text.replace("  30\n", "  -30\n")), (true, true));
    // the editor marks what `check` refuses, and no more
    let marked = |text: &str| Analysis::of(Source::new("rows.mech", text)).problems.has_errors();
    assert_eq!([marked(text), marked(&text.replace("  20\n", "  -20\n"))], [false, true]);
    assert_eq!(verdict(&text.replace("find position(A)", "find position(A), omega(a)")), (true, true));
}
