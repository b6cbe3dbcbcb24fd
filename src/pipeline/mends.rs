//! Edits that do what an error of the structure proposes: another line in place of a pair, a pair left out, or both halves of a moved one.
//! Each is confirmed: the changed text is checked, and all is determined in it.

use super::compile::Text;
use assur_check as check;
use assur_model::model::Mechanism;
use assur_model::structure;
use assur_syntax as syntax;
use assur_syntax::document::{Document, Joint, Statement};
use assur_text::diagnostic::{Diagnosis, Fix};
use assur_text::source::{Edit, Source, Span};
use miette::Diagnostic;

/// Texts that are longer are not checked again for each edit.
const MOST_STATEMENTS: usize = 300;
/// Edits tried.
const MOST_TRIED: usize = 4;

/// The error with the lines that its help proposes as edits.
pub(super) fn with_lines(error: Diagnosis) -> Diagnosis {
    if error.is("mech::determinacy::underconstrained") { error.added() } else { error }
}

/// The error with the edits that its help proposes.
pub(super) fn with_fixes(error: Diagnosis, mechanism: &Mechanism, text: Text<'_>) -> Diagnosis {
    if text.document.statements.len() <= MOST_STATEMENTS {
        let error = super::closing::that_closes(in_full(error, text), text);
        let error = super::lost::or_lost(error, mechanism, text);
        with_lines(of_surplus(error, text))
    } else {
        with_lines(error)
    }
}

/// The error with the whole line that its help wants another angle in.
fn in_full(error: Diagnosis, text: Text<'_>) -> Diagnosis {
    let help = help_of(&error);
    let full = || {
        let (angle, rest) = help.strip_prefix("write `angle ")?.split_once("` in `")?;
        let (name, rest) = rest.split_once('`')?;
        let what = format!("prismatic {name}");
        let (span, joint) = joint(text.document, &what)?;
        let line = with_angle(text, span, joint, angle)?;
        Some((format!("write `{line}`{rest}"), Fix::quoted(&format!("write `{line}`"), span)))
    };
    match if error.is("mech::determinacy::not_parallel") { full() } else { None } {
        Some((help, fixes)) => error.help(help).fixes(fixes.into_iter().filter(|fix| passes(fix, text))),
        None => error,
    }
}

/// The statement as it is written, with this angle.
fn with_angle(text: Text<'_>, span: Span, joint: &Joint, angle: &str) -> Option<String> {
    let written = text.source.text.get(span.start..span.end)?;
    let property = format!("angle {angle}");
    let old = joint.properties.iter().find(|own| own.name.node == "angle");
    let line = match old {
        Some(old) => {
            let (before, after) = (old.span.start - span.start, old.span.end - span.start);
            format!("{}{property}{}", written.get(..before)?, written.get(after..)?)
        }
        None => match written.rsplit_once('}') {
            Some((before, after)) => format!("{}; {property} }}{after}", before.trim_end()),
            None => format!("{written} {{ {property} }}"),
        },
    };
    (!line.contains(['\n', '`']) && !line.contains("//")).then_some(line)
}

fn help_of(error: &Diagnosis) -> String {
    Diagnostic::help(error).map(|help| help.to_string()).unwrap_or_default()
}

fn of_surplus(error: Diagnosis, text: Text<'_>) -> Diagnosis {
    let of_surplus = ["mech::determinacy::unbalanced", "mech::determinacy::overconstrained"];
    if !of_surplus.iter().any(|code| error.is(code)) {
        return error;
    }
    let help = help_of(&error);
    let mut fixes = swaps(&help, text.document);
    let is_clear = fixes.len() == 1 && !help.contains("leave out") && !help.contains("add ");
    if fixes.is_empty() {
        fixes.extend(left_out(&help, text.document));
    }
    fixes.truncate(MOST_TRIED);
    fixes.retain(|fix| passes(fix, text));
    fixes.iter_mut().for_each(|fix| fix.certain = is_clear);
    error.fixes(fixes)
}

/// ``write `…` in place of `revolute C` ``
fn swaps(help: &str, document: &Document) -> Vec<Fix> {
    let flat = help.replace('\n', " ");
    let ways = flat.split("write `").skip(1);
    let fix = |way: &str| {
        let (line, rest) = way.split_once('`')?;
        let wrong = rest.strip_prefix(" in place of `")?.split('`').next()?;
        let (_, joint) = joint(document, wrong)?;
        let at = Span::new(joint.kind.span.start, joint.ends.last()?.span().end);
        Some(Fix { title: format!("write `{line}`"), edits: vec![Edit::new(at, line)], certain: false })
    };
    ways.filter_map(fix).collect()
}

/// ``leave out `revolute Z` ``, and the lines that are to be added too.
fn left_out(help: &str, document: &Document) -> Option<Fix> {
    let what = help.split("leave out `").nth(1)?.split('`').next()?;
    let (at, _) = joint(document, what)?;
    let mut fix = Fix::left_out(&format!("`{what}`"), at);
    let added = help.split_once(";\n").and_then(|(_, rest)| Fix::added(rest).into_iter().next());
    if let Some(added) = added {
        fix.title = format!("{} and {}", fix.title, added.title);
        fix.edits.extend(added.edits);
    }
    Some(fix)
}

/// The statement of a pair that is named by its kind and its name.
fn joint<'a>(document: &'a Document, named: &str) -> Option<(Span, &'a Joint)> {
    let (kind, name) = named.split_once(' ')?;
    document.statements.iter().find_map(|statement| match &statement.node {
        Statement::Joint(joint) if joint.name.node == name && joint.kind.node.word() == kind => {
            Some((statement.span, joint))
        }
        _ => None,
    })
}

/// Whether nothing is wrong with the text after it.
fn passes(fix: &Fix, text: Text<'_>) -> bool {
    let changed = Source { text: fix.apply(&text.source.text), ..text.source.clone() };
    let (document, read) = syntax::parse(&changed);
    if read.has_errors() {
        return false;
    }
    let (mechanism, checked) = check::check(&document, text.overrides);
    !checked.has_errors() && mechanism.is_some_and(|mechanism| structure::structure(&mechanism).is_ok())
}
