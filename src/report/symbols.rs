//! Symbols of the textbook from the numbers of links: R12, ω2.

use assur_model::model::{Expr, Find, FindKind, LinkId, Mechanism, Query};
use std::collections::HashMap;

/// The symbols of a mechanism.
pub struct Symbols<'a> {
    mechanism: &'a Mechanism,
    /// The number of the ground where it has none of its own: 0 unless a link has that.
    ground: Option<&'static str>,
    /// What is asked for without a name, by its text. A name of its own has no brackets.
    unnamed: HashMap<&'a str, &'a Find>,
}

impl<'a> Symbols<'a> {
    /// Looks at all links and questions once.
    #[must_use]
    pub fn of(mechanism: &'a Mechanism) -> Self {
        let taken = mechanism.links.iter().any(|l| l.number.as_deref() == Some("0"));
        let mut unnamed = HashMap::new();
        for find in mechanism.finds.iter().filter(|f| f.name.contains('(')) {
            unnamed.entry(find.name.as_str()).or_insert(find);
        }
        Self { mechanism, ground: (!taken).then_some("0"), unnamed }
    }

    /// `R12`: the reaction of link 1 on link 2; `None` where one of them has no number.
    #[must_use]
    pub fn reaction(&self, from: LinkId, on: LinkId) -> Option<String> {
        let (from, on) = (self.number(from)?, self.number(on)?);
        let between = if from.len() + on.len() > 2 { "," } else { "" };
        Some(format!("R{from}{between}{on}"))
    }

    /// `ω2 = omega(rod)` where that is asked for without a name and the link has a number; the name alone elsewhere.
    pub(super) fn label(&self, name: &str) -> String {
        let symbol = self.unnamed.get(name).and_then(|find| match &find.kind {
            FindKind::Value { expr, .. } => self.quantity(expr),
            FindKind::Reactions | FindKind::Table(_) => None,
        });
        symbol.map_or_else(|| name.to_owned(), |symbol| format!("{symbol} = {name}"))
    }

    fn quantity(&self, expr: &Expr) -> Option<String> {
        let Expr::Query(query) = expr else { return None };
        let (letter, link) = match query {
            Query::Angle(link) => ("φ", *link),
            Query::Omega(link) => ("ω", *link),
            Query::Alpha(link) => ("α", *link),
            _ => return None,
        };
        Some(format!("{letter}{}", self.number(link)?))
    }

    fn number(&self, link: LinkId) -> Option<&str> {
        let ground = self.ground.filter(|_| link == LinkId::GROUND);
        self.mechanism.link(link).number.as_deref().or(ground)
    }
}
