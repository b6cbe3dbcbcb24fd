//! Symbols of the textbook from the numbers of links: R12, ω2.

use assur_model::model::{Expr, Find, FindKind, LinkId, Mechanism, Query};

/// `R12`: the reaction of link 1 on link 2; `None` where one of them has no number. The ground is 0 unless it says otherwise.
#[must_use]
pub fn reaction(mechanism: &Mechanism, from: LinkId, on: LinkId) -> Option<String> {
    let (from, on) = (number(mechanism, from)?, number(mechanism, on)?);
    let between = if from.len() + on.len() > 2 { "," } else { "" };
    Some(format!("R{from}{between}{on}"))
}

/// `ω2 = omega(rod)` where that is asked for without a name and the link has a number; the name alone elsewhere.
pub(super) fn label(mechanism: &Mechanism, name: &str) -> String {
    // a name of its own has no brackets
    let own_text = |find: &&Find| find.name == name && name.contains('(');
    let symbol = mechanism.finds.iter().find(own_text).and_then(|find| match &find.kind {
        FindKind::Value { expr, .. } => quantity(mechanism, expr),
        FindKind::Reactions | FindKind::Table(_) => None,
    });
    symbol.map_or_else(|| name.to_owned(), |symbol| format!("{symbol} = {name}"))
}

fn quantity(mechanism: &Mechanism, expr: &Expr) -> Option<String> {
    let Expr::Query(query) = expr else { return None };
    let (letter, link) = match query {
        Query::Angle(link) => ("φ", *link),
        Query::Omega(link) => ("ω", *link),
        Query::Alpha(link) => ("α", *link),
        _ => return None,
    };
    Some(format!("{letter}{}", number(mechanism, link)?))
}

fn number(mechanism: &Mechanism, link: LinkId) -> Option<&str> {
    let taken = || mechanism.links.iter().any(|l| l.number.as_deref() == Some("0"));
    let ground = (link == LinkId::GROUND && !taken()).then_some("0");
    mechanism.link(link).number.as_deref().or(ground)
}
