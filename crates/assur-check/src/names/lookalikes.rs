//! Names that cannot be told apart by eye.

use crate::names::{
    declared::Names,
    suggestion::{not_declared, suggestion},
};
use crate::output::{hinges::Builder, problems::Problems};
use assur_syntax::document::{Document, Name, Statement};
use assur_syntax::skeleton;
use assur_text::diagnostic::{Diagnosis, Problem};
use assur_text::source::Span;
use indexmap::IndexMap;

/// Reports names of one list that only look alike.
pub(crate) fn look_alikes(cx: &mut Scope<'_, '_>) {
    let names = &cx.names;
    let inside =
        names.inside.iter().flat_map(|i| i.points.keys().chain(i.lines.keys()).chain(i.circles.keys()));
    let mut all = names.quantities.keys().chain(names.things.keys()).chain(inside);
    if all.all(|name| name.is_ascii()) {
        // Two names look alike only if one has a letter of another script.
        return;
    }
    let quantities = names.quantities.iter().map(|(n, d)| (n.clone(), d.span)).collect::<Vec<_>>();
    let things = names.things.iter().map(|(n, d)| (n.clone(), d.span));
    let inside = names.inside.iter().flat_map(|i| i.points.iter().chain(&i.lines).chain(&i.circles));
    let inside = inside.map(|(n, span)| (n.clone(), *span));
    // a pair's name stands for points of that name
    let things = things.chain(inside).collect::<Vec<_>>();
    for list in [quantities, things] {
        compare(cx, &list);
    }
}

fn compare(cx: &mut Scope<'_, '_>, list: &[(String, Span)]) {
    let mut seen: IndexMap<String, Vec<(&str, Span)>> = IndexMap::new();
    for (name, span) in list {
        let lookalikes = seen.entry(skeleton(name)).or_default();
        if lookalikes.iter().any(|(n, _)| n == name) {
            continue;
        }
        if let Some(&(first, first_span)) = lookalikes.first() {
            // of a Latin name and another, the other is the slip
            let (odd, odd_span, other, other_span) = if name.is_ascii() {
                (first, first_span, name.as_str(), *span)
            } else {
                (name.as_str(), *span, first, first_span)
            };
            let help = format!("write `{other}`: {}", difference(odd, other, "here", "there"));
            cx.error(
                Diagnosis::error("mech::name::look_alike", format!("two different names look like `{odd}`"))
                    .primary(odd_span, "looks like the other one")
                    .label(other_span, "the other one")
                    .help(help),
            );
            // What is not found because of this is no second mistake.
            cx.names.bad.extend([first.to_owned(), name.clone()]);
        }
        lookalikes.push((name, *span));
    }
}

pub(crate) fn difference(first: &str, second: &str, at_first: &str, at_second: &str) -> String {
    let differs = first.chars().zip(second.chars()).find(|(a, b)| a != b);
    match differs {
        Some((a, b)) => {
            format!("the letter `{a}` is {} {at_first} and {} {at_second}", script(a), script(b))
        }
        None => "they are written with different letters".to_owned(),
    }
}

/// The script of a letter, in words.
fn script(c: char) -> &'static str {
    match c {
        '\u{370}'..='\u{3FF}' | '\u{1F00}'..='\u{1FFF}' => "Greek",
        '\u{400}'..='\u{52F}' => "Cyrillic",
        c if c.is_ascii_digit() => "a digit",
        _ => "Latin",
    }
}

// What stands at the head of the file, and what it leaves out.

/// Enters the title, the problem's text and `ignore` into the mechanism.
pub(crate) fn head(cx: &mut Scope<'_, '_>) {
    let doc = cx.doc;
    cx.builder.mech.title = doc.title().map_or_else(String::new, |t| t.node.clone());
    cx.builder.mech.notes = doc.notes.iter().map(|n| n.node.clone()).collect();
    for statement in &doc.statements {
        if let Statement::Ignore(name) = &statement.node {
            ignore(cx, name);
        }
    }
}

fn ignore(cx: &mut Scope<'_, '_>, name: &Name) {
    if name.node == "inertia" {
        cx.builder.mech.ignore_inertia = true;
        return;
    }
    let help = suggestion(&name.node, name.span, &["inertia"], "effects that can be ignored");
    let (name, span) = (name.node.clone(), name.span);
    cx.error(not_declared("effect", &name, None, span, help));
}

// What declaring works on.

/// A document, and where its names, its links and what is wrong with them go.
pub struct Scope<'s, 'a> {
    pub doc: &'a Document,
    /// All names declared in the document.
    pub names: &'s mut Names<'a>,
    /// The mechanism that is being made.
    pub builder: &'s mut Builder,
    /// All that was found wrong.
    pub problems: &'s mut Problems,
}

impl Scope<'_, '_> {
    /// Reports an error or a warning.
    pub fn error(&mut self, problem: impl Problem) {
        self.problems.error(problem);
    }
}
