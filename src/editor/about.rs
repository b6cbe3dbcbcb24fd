//! What a name is: its declaration, what belongs to it, what it comes to.

use super::names::Declaration;
use super::symbols::SymbolKind;
use super::{Analysis, Hover, Results};
use crate::pipeline::Compiled;
use crate::report::groups_in_order;
use assur_model::model::{LinkId, PairId, PairKind, PointRef, Query, Value};
use assur_text::language::PAIRS;
use assur_text::source::Span;
use assur_text::units::Dimension;

/// Lines of a declaration that are shown.
const LINES: usize = 6;
/// Digits of a mass.
const DIGITS: usize = 6;

impl Analysis {
    /// What is declared under the name at a byte; with the answers, where the text is solved.
    pub(super) fn about(&self, byte: usize, results: Option<&Results>) -> Option<Hover> {
        let name = self.names.at(byte)?;
        let all = self.names.declarations(name);
        let pages = all.iter().map(|declared| self.page(declared, results)).collect::<Vec<_>>();
        (!pages.is_empty()).then(|| Hover { at: name, text: pages.join("\n\n---\n\n") })
    }

    fn page(&self, declared: &Declaration, results: Option<&Results>) -> String {
        let mut facts = Vec::new();
        match declared.kind {
            SymbolKind::Link => facts.extend(self.link_facts(declared)),
            SymbolKind::Point => facts.extend(self.point_facts(declared, results)),
            SymbolKind::Pair => facts.extend(self.pair_facts(declared, results)),
            _ => {
                let value = self.quantity(&declared.name, results);
                facts.extend(value.map(|value| format!("`{}` = {value}", declared.name)));
            }
        }
        let code = format!("```mech\n{}\n```\n", self.shown(declared.whole));
        code + &facts.join("  \n")
    }

    /// The first lines of a declaration.
    fn shown(&self, whole: Span) -> String {
        let written = self.source.text.get(whole.start..whole.end).unwrap_or_default();
        let mut lines = written.lines().take(LINES).collect::<Vec<_>>();
        if written.lines().nth(LINES).is_some() {
            lines.push("…");
        }
        lines.join("\n")
    }

    /// What a quantity comes to.
    pub(super) fn quantity(&self, name: &str, results: Option<&Results>) -> Option<String> {
        let constant = self.constants.iter().find(|(known, _)| known == name).map(|(_, value)| value.clone());
        constant.or_else(|| results?.value(name))
    }

    fn link_facts(&self, declared: &Declaration) -> Vec<String> {
        let inside = |kind| {
            let all = self
                .names
                .declared()
                .filter(move |d| d.owner.as_deref() == Some(declared.name.as_str()) && d.kind == kind);
            all.map(|d| format!("`{}`", d.name)).collect::<Vec<_>>().join(", ")
        };
        let parts = [
            ("points", SymbolKind::Point),
            ("lines and circles", SymbolKind::Shape),
            ("wheels", SymbolKind::Wheel),
        ];
        let listed =
            parts.into_iter().map(|(what, kind)| (what, inside(kind))).filter(|(_, all)| !all.is_empty());
        let mut facts = listed.map(|(what, all)| format!("{what} {all}")).collect::<Vec<_>>();
        if let Some(compiled) = &self.compiled {
            facts.extend(mass(compiled, &declared.name));
            let groups = groups_in_order(&compiled.model());
            let own = groups.into_iter().find(|(links, _)| links.contains(&declared.name));
            facts.extend(own.map(|(links, kind)| format!("structural group {} ({kind})", links.join(", "))));
        }
        facts
    }

    fn point_facts(&self, declared: &Declaration, results: Option<&Results>) -> Option<String> {
        let link = declared.owner.as_deref()?;
        let mechanism = &self.compiled.as_ref()?.mechanism;
        let index = mechanism.links.iter().position(|l| l.name == link)?;
        let point = mechanism.links[index].points.iter().find(|p| p.name == declared.name)?;
        let query = Query::Position(PointRef::Fixed(LinkId::at(index), point.at));
        let at = results?.query(&query, Dimension::LENGTH)?;
        Some(format!("`position({link}.{})` = {at}", declared.name))
    }

    fn pair_facts(&self, declared: &Declaration, results: Option<&Results>) -> Vec<String> {
        let name = &declared.name;
        let Some(mechanism) = self.compiled.as_ref().map(|compiled| &compiled.mechanism) else {
            return Vec::new();
        };
        let Some(index) = mechanism.pairs.iter().position(|p| p.name == *name) else { return Vec::new() };
        let kind = &mechanism.pairs[index].kind;
        let links = kind.links().iter().map(|l| format!("`{}`", mechanism.link(*l).name)).collect::<Vec<_>>();
        let means = self.shown(declared.whole).split(' ').next().and_then(meaning);
        let means = means.map_or_else(String::new, |means| format!("{means}; "));
        let mut facts = vec![format!("{means}joins {}", links.join(" and "))];
        let dimension = match kind {
            PairKind::Revolute(pins) if pins.len() == 2 => Some(Dimension::ANGLE),
            PairKind::Prismatic(_) | PairKind::Slot(_) | PairKind::Cylinder { .. } => Some(Dimension::LENGTH),
            _ => None,
        };
        let Some(results) = results else { return facts };
        let coordinate = dimension.and_then(|d| results.query(&Query::Displacement(PairId::at(index)), d));
        facts.extend(coordinate.map(|value| format!("`displacement({name})` = {value}")));
        for function in ["reaction", "moment"] {
            let own = format!("{function}({name}");
            let asked = results
                .beginning(&own)
                .filter(|(whole, _)| whole.get(own.len()..).is_some_and(|rest| rest.starts_with([',', ')'])));
            facts.extend(asked.map(|(whole, value)| format!("`{whole}` = {value}")));
        }
        facts
    }
}

/// What the word of a pair means.
fn meaning(word: &str) -> Option<&'static str> {
    PAIRS.iter().find(|row| row.word == word).map(|row| row.means)
}

fn mass(compiled: &Compiled, link: &str) -> Option<String> {
    let mechanism = &compiled.mechanism;
    let mass = mechanism.links.iter().find(|l| l.name == link)?.mass?;
    let text = |x, dimension| mechanism.display_of(dimension).text(Value::Scalar(x), DIGITS);
    let inertia = text(mass.inertia, Dimension::INERTIA);
    Some(format!("mass {}, moment of inertia {inertia}", text(mass.mass, Dimension::MASS)))
}
