//! Values in the title and the problem's text: `A crank of {r}`.

use crate::names::declared::{Names, QuantityKind};
use crate::values::definition::{Definitions, Settled};
use crate::values::fold;
use crate::values::format_value::format_value_like;
use assur_text::source::{Span, Spanned};

/// The text with the value in place of every `{name}` of a `given` or a constant `let`, in the unit it is written in. Other
/// braces stay as they are. The names are noted as used at the place of the text.
pub fn filled(text: &str, at: Span, names: &mut Names<'_>, definitions: &Definitions) -> String {
    with_names(text, |name| value(name, at, names, definitions))
}

/// A text with other words in place of some of its `{name}`.
pub fn with_names(text: &str, mut words: impl FnMut(&str) -> Option<String>) -> String {
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some((before, after)) = rest.split_once('{') {
        out.push_str(before);
        let found = after.split_once('}').and_then(|(name, behind)| Some((words(name.trim())?, behind)));
        match found {
            Some((words, behind)) => {
                out.push_str(&words);
                rest = behind;
            }
            None => {
                out.push('{');
                rest = after;
            }
        }
    }
    out + rest
}

/// All definitions that are constant numbers, with their values.
pub fn constants(names: &Names<'_>, definitions: &Definitions) -> Vec<(String, String)> {
    let all = definitions.order.iter();
    all.filter_map(|name| Some((name.clone(), constant(name, names, definitions)?))).collect()
}

fn value(name: &str, at: Span, names: &mut Names<'_>, definitions: &Definitions) -> Option<String> {
    if let QuantityKind::Given(_) | QuantityKind::Let(_) = names.quantities.get(name)?.what {
        names.note_quantity(&Spanned::new(name.to_owned(), at));
    }
    constant(name, names, definitions)
}

fn constant(name: &str, names: &Names<'_>, definitions: &Definitions) -> Option<String> {
    let (QuantityKind::Given(like) | QuantityKind::Let(like)) = names.quantities.get(name)?.what else {
        return None;
    };
    let Settled::Constant(t) = definitions.settled(name)? else { return None };
    let value = fold::scalar(&t.expr)?;
    Some(format_value_like(names, value, t.ty.dimension(), like))
}
