//! What may be meant by a name that nothing has.

use crate::names::lookalikes::difference;
use assur_syntax::skeleton;
use assur_text::diagnostic::{Diagnosis, Help, Undeclared, did_you_mean};
use assur_text::source::{Span, Spanned};

/// Among more names than these none is looked for: every error would go through all.
const MOST_NAMES: usize = 2000;

/// `did you mean …?`, or else what there is.
pub fn suggestion(name: &str, at: Span, all: &[&str], kind: &str) -> Option<Help> {
    let quoted = |names: &[&str]| names.iter().map(|n| format!("`{n}`")).collect::<Vec<_>>();
    if all.len() > MOST_NAMES {
        return Some(format!("the {kind} are {}, …", quoted(&all[..8]).join(", ")).into());
    }
    // names of ASCII look like themselves alone
    let lookalike =
        |n: &&&str| **n != name && !(n.is_ascii() && name.is_ascii()) && skeleton(n) == skeleton(name);
    if let Some(lookalike) = all.iter().find(lookalike) {
        let how = difference(lookalike, name, "there", "here");
        let words = format!("`{lookalike}` is declared; it only looks the same: {how}");
        return Some(Help::write(at, &[(*lookalike).to_owned()]).in_words(words));
    }
    let near = did_you_mean(name, all.iter().copied());
    if !near.is_empty() {
        let near = near.iter().map(|&name| name.to_owned()).collect::<Vec<_>>();
        return Some(Help::did_you_mean(name, at, &near));
    }
    // `S2` where there is `S`
    let stem = name.trim_end_matches(|c: char| c.is_ascii_digit() || c == '\'' || c == '_');
    if let Some(stem) = all.iter().find(|known| **known == stem) {
        return Some(Help::write(at, &[(*stem).to_owned()]).in_words(format!("did you mean `{stem}`?")));
    }
    // `S` where there is `S2` alone
    let numbered =
        |known: &&&str| known.strip_prefix(name).is_some_and(|rest| rest.chars().all(|c| c.is_ascii_digit()));
    if let [only] = all.iter().filter(numbered).collect::<Vec<_>>()[..] {
        return Some(Help::write(at, &[(*only).to_owned()]).in_words(format!("did you mean `{only}`?")));
    }
    match all.len() {
        0 => None,
        1..=8 => Some(format!("the {kind} are {}", quoted(all).join(", ")).into()),
        _ => Some(format!("the {kind} are {}, …", quoted(&all[..8]).join(", ")).into()),
    }
}

/// Nothing of that name is declared.
pub fn not_declared(
    kind: &'static str,
    name: &str,
    owner: Option<String>,
    span: Span,
    help: Option<Help>,
) -> Diagnosis {
    Diagnosis::error("mech::name::unknown", format!("there is no {kind} `{name}`{}", place(owner.as_deref())))
        .primary(span, "not declared")
        .help_if(help)
        .undeclared(Undeclared { kind, name: name.to_owned(), owner, at: span })
}

/// The name is declared, but as something else.
pub fn wrong_kind(
    name: &str,
    is: &str,
    wanted: &str,
    span: Span,
    declared: Option<Span>,
    help: Option<String>,
) -> Diagnosis {
    Diagnosis::error("mech::name::wrong_kind", format!("`{name}` is {is}, not {wanted}"))
        .primary(span, format!("{wanted} is expected here"))
        .label(declared, "declared here")
        .help_if(help)
        .quoted(span)
}

/// Where a name was looked for: nothing, ` on the ground` or `` in link `crank` ``.
fn place(owner: Option<&str>) -> String {
    match owner {
        None => String::new(),
        Some("ground") => " on the ground".to_owned(),
        Some(link) => format!(" in link `{link}`"),
    }
}

/// A second declaration of a name.
pub fn duplicate(again: &Spanned<String>, first: Span, help: Option<String>) -> Diagnosis {
    Diagnosis::error("mech::name::duplicate", format!("`{}` is declared twice", again.node))
        .primary(again.span, "declared again here")
        .label((first != Span::default()).then_some(first), "first declared here")
        .help(help.unwrap_or_else(|| "give one of them another name".into()))
}
