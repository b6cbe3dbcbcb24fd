//! Every program and fragment of the language's own page reads without a word of complaint.

mod folder;

use assur::internals::diagnostic::{Style, render};
use assur::internals::source::Source;
use assur::internals::syntax::document::{Member, Statement};
use libtest_mimic::{Arguments, Failed, Trial};
use std::path::Path;

fn main() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/language");
    let trials = folder::files(&root, "mech")
        .into_iter()
        .map(|path| {
            let name = path.strip_prefix(&root).unwrap_or(&path).display().to_string();
            Trial::test(name, move || reads(&path))
        })
        .collect();
    libtest_mimic::run(&Arguments::from_args(), trials).exit();
}

fn reads(path: &Path) -> Result<(), Failed> {
    let text = std::fs::read_to_string(path)?;
    for text in [text.clone(), text.replace('\n', "\r\n")] {
        let source = Source::new("text.mech", text);
        let (document, problems) = assur::internals::syntax::parse(&source);
        if !problems.is_empty() {
            return Err(render(&problems, &source, Style::PLAIN).into());
        }
        for statement in &document.statements {
            let bad = match &statement.node {
                Statement::Bad(_) => true,
                Statement::Link(link) => link.body.iter().any(|m| matches!(m.node, Member::Bad(_))),
                _ => false,
            };
            if bad {
                return Err(format!("not read: {:?}", statement.span).into());
            }
        }
        // Fragments do not stand alone; whole programs also check.
        if path.parent().and_then(Path::file_name).is_some_and(|folder| folder == "language") {
            let (mechanism, problems) =
                assur::internals::check_source(&source, &assur::internals::check::Overrides::none());
            if mechanism.is_none() || !problems.is_empty() {
                return Err(render(&problems, &source, Style::PLAIN).into());
            }
        }
    }
    Ok(())
}
