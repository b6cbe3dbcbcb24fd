//! Names in the title and in the problem's text.

use crate::expr::context::Context;
use crate::names::declared::QuantityKind;
use crate::values::definition::Settled;
use assur_text::diagnostic::{Diagnosis, Help, did_you_mean};
use assur_text::source::Span;
use std::collections::BTreeSet;

/// A name in braces and its place in the file.
struct InText {
    name: String,
    at: Span,
}

/// The names in braces in the title and the text. `\frac{a}` and `x_{1}` are formulas.
fn in_texts(cx: &Context<'_>) -> Vec<InText> {
    let title = cx.doc.title().map(|title| (title.node.as_str(), title.span));
    let notes = cx.doc.notes.iter().map(|note| (note.node.as_str(), note.span));
    let mut found = Vec::new();
    for (text, at) in title.into_iter().chain(notes) {
        for (open, _) in text.match_indices('{') {
            let before = text[..open].chars().next_back();
            let formula = before.is_some_and(|c| c.is_alphanumeric() || "\\_^}$".contains(c));
            let Some((name, behind)) = text[open + 1..].split_once('}') else { continue };
            let formula = formula || behind.starts_with(['_', '^', '{']);
            let name = name.trim();
            let letters = |c: char| c.is_alphanumeric() || matches!(c, '_' | '\'');
            if !formula && name.starts_with(char::is_alphabetic) && name.chars().all(letters) {
                found.push(InText { name: name.to_owned(), at });
            }
        }
    }
    found
}

/// The names that texts of the file have in braces.
pub(super) fn named_in_texts(cx: &Context<'_>) -> BTreeSet<String> {
    in_texts(cx).into_iter().map(|found| found.name).collect()
}

/// Notes names in braces that stand for no constant, and are printed as they are.
pub(super) fn texts(cx: &mut Context<'_>) {
    for InText { name, at } in in_texts(cx) {
        let constant = matches!(cx.values.definitions.settled(&name), Some(Settled::Constant(_)));
        if constant || name == "variant" || !cx.problems.reported.insert(("text", name.clone())) {
            continue;
        }
        let kind = cx.names.quantities.get(&name).map(|d| d.what);
        let is_constant =
            |kind: QuantityKind<'_>| matches!(kind, QuantityKind::Given(_) | QuantityKind::Let(_));
        let all =
            cx.names.quantities.iter().filter(|(_, d)| is_constant(d.what)).map(|(name, _)| name.as_str());
        let near = did_you_mean(&name, all);
        let why = if kind.is_some() { "is not a constant" } else { "is not declared" };
        let help = match near.first() {
            Some(near) => Help::from(format!("did you mean `{{{near}}}`?")),
            None => "write the name of a `given` or of a constant `let` in the braces".into(),
        };
        let message = format!("`{{{name}}}` is printed as it is: `{name}` {why}");
        cx.error(Diagnosis::advice("mech::name::not_in_text", message).label(at, "in this text").help(help));
    }
}
