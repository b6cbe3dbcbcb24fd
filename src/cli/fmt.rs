//! `assur fmt`

use std::cell::Cell;

use super::args::Fmt;
use super::error::CliError;
use super::files::{Input, expand, replace};
use super::reply::{Printer, Reply, Status, complaint, for_each_input};
use super::screen::Screen;
use assur_text::source::{Edit, Source, edited};
use similar::TextDiff;

/// Lines around a change in a diff.
const AROUND: usize = 3;

/// How many files were seen, and what became of them.
#[derive(Default)]
struct Tally {
    changed: Cell<usize>,
    same: Cell<usize>,
    left: Cell<usize>,
    unwritten: Cell<usize>,
}

/// Puts files in the one style.
pub fn run(args: &Fmt, screen: &Screen) -> Status {
    let inputs = expand(&args.files);
    if args.range.is_some() && inputs.len() > 1 {
        screen.complain(&complaint(CliError::OneRange, screen));
        return Status::Unusable;
    }
    let tally = Tally::default();
    let from_stdin = inputs.iter().flatten().any(|input| *input == Input::Stdin);
    let status = for_each_input(inputs, &mut Printer::new(screen, ""), |source, _| {
        let named = named(args, source);
        match assur_format::edits(&named) {
            Ok(edits) => {
                let edits = in_range(args, &source.text, edits);
                formatted(args, source, &named, &edits, &tally, screen)
            }
            Err(problems) => {
                count(&tally.left);
                Reply::new(String::new(), &problems, &named, screen)
            }
        }
    });
    if !from_stdin {
        screen.complain(&summary(args, &tally));
    }
    status
}

/// A text under the name that is wanted for standard input.
fn named(args: &Fmt, source: &Source) -> Source {
    let name = args.stdin_filename.as_ref().filter(|_| source.name == "-");
    Source::new(name.unwrap_or(&source.name), source.text.clone())
}

/// The edits that touch the lines that are wanted.
fn in_range(args: &Fmt, text: &str, edits: Vec<Edit>) -> Vec<Edit> {
    match &args.range {
        Some(lines) => assur_format::touching(text, edits, lines.clone()),
        None => edits,
    }
}

/// The reply about a text that reads.
fn formatted(
    args: &Fmt,
    source: &Source,
    named: &Source,
    edits: &[Edit],
    tally: &Tally,
    screen: &Screen,
) -> Reply {
    let is_stdin = source.name == "-";
    if edits.is_empty() && (args.check || !is_stdin) {
        count(&tally.same);
        return Reply::default();
    }
    let text = edited(&source.text, edits);
    if args.check {
        count(&tally.changed);
        let diagnostics = format!("{} is not formatted\n", named.name);
        return Reply { results: diff(named, &text), diagnostics, status: Status::Wrong };
    }
    if is_stdin {
        return Reply { results: text, ..Reply::default() };
    }
    match replace(&source.name, &text) {
        Ok(()) => {
            count(&tally.changed);
            Reply::default()
        }
        Err(error) => {
            count(&tally.unwritten);
            Reply { diagnostics: complaint(error, screen), status: Status::Unusable, ..Reply::default() }
        }
    }
}

fn diff(source: &Source, text: &str) -> String {
    let name = &source.name;
    let (before, after) = (format!("a/{name}"), format!("b/{name}"));
    let diff = TextDiff::from_lines(source.text.as_str(), text);
    diff.unified_diff().context_radius(AROUND).header(&before, &after).to_string()
}

fn count(of: &Cell<usize>) {
    of.set(of.get() + 1);
}

/// `166 files: 3 formatted, 163 unchanged`
fn summary(args: &Fmt, tally: &Tally) -> String {
    let (changed, same) = (tally.changed.get(), tally.same.get());
    let (left, unwritten) = (tally.left.get(), tally.unwritten.get());
    let all = changed + same + left + unwritten;
    if all == 0 {
        return String::new();
    }
    let files = if all == 1 { "1 file".to_owned() } else { format!("{all} files") };
    let done = if args.check { "not formatted" } else { "formatted" };
    let kept = if args.check { "already formatted" } else { "unchanged" };
    let mut parts = Vec::new();
    for (count, what) in
        [(changed, done), (same, kept), (left, "with errors, not changed"), (unwritten, "not written")]
    {
        parts.extend((count > 0).then(|| format!("{count} {what}")));
    }
    format!("{files}: {}\n", parts.join(", "))
}
