//! The letters of data: those of the author, else the usual ones, as the worked solution has them.

use super::{Data, numbers::first_unit};
use crate::forces::quantity_name;
use crate::letters::teeth_name;
use assur_formula::Name;
use assur_syntax::document::{Definition, Expr, ExprKind};
use assur_syntax::given::{Datum, Given, GivenLine, GivenValue, Shown};
use assur_text::units::{Dimension, lookup};
use std::collections::{BTreeMap, BTreeSet};

pub(super) struct Letters<'a> {
    data: Data<'a>,
    definitions: BTreeMap<&'a str, &'a Definition>,
    /// Letters that several things would have.
    shared: BTreeSet<Name>,
}

impl<'a> Letters<'a> {
    pub fn of(data: Data<'a>, given: &Given<'a>) -> Self {
        let mut letters = Self { data, definitions: given.definitions.clone(), shared: BTreeSet::new() };
        let mut taken: BTreeSet<Name> = given.used.iter().map(|name| quantity_name(name)).collect();
        taken.extend(data.mechanism.balances.iter().map(|own| quantity_name(&own.name)));
        taken.extend(data.mechanism.finds.iter().map(|own| quantity_name(&own.name)));
        let all = given.lines.iter().flat_map(|line| line.data.iter().map(move |datum| (line, datum)));
        let shown = all.filter(|(_, datum)| datum.shown == Shown::Text && !is_definition(datum, given));
        for (line, datum) in shown {
            if let Some(name) = letters.get(line, datum)
                && !taken.insert(name.clone())
            {
                letters.shared.insert(name);
            }
        }
        letters
    }

    /// The letter of a datum, where it has one.
    pub fn get(&self, line: &GivenLine<'a>, datum: &Datum<'a>) -> Option<Name> {
        if let Some(own) = datum.own {
            return Some(quantity_name(own));
        }
        let own = match datum.kind.key {
            "force" | "torque" => self.of_load(line, datum),
            "wheel.teeth" => Some(teeth_name(&datum.index)),
            _ => None,
        };
        let letter = self.by_unit(datum).unwrap_or(datum.kind.letter);
        if letter.is_empty() || own.is_some() {
            return own;
        }
        let (letter, begin) = letter.split_once('_').unwrap_or((letter, ""));
        let bare = Name::new(letter, begin);
        let is_indexed = datum.kind.indexed || self.shared.contains(&bare);
        let index = self.label(&datum.index);
        if !is_indexed || index.is_empty() {
            return Some(bare);
        }
        let name = Name::new(letter, &if begin.is_empty() { index } else { format!("{begin},{index}") });
        // points of one name on several links have the labels of these
        let link = line.names.first().filter(|_| line.subject == "link" && self.shared.contains(&name));
        Some(match link {
            Some(link) if !name.sub.ends_with(&self.label(link)) => {
                Name::new(&name.letter, &format!("{}{}", name.sub, self.label(link)))
            }
            _ => name,
        })
    }

    /// The number of a link, the point of a driven point, else the name itself.
    fn label(&self, name: &str) -> String {
        let number = self.data.mechanism.links.iter().find(|link| link.name == name);
        let number = number.and_then(|link| link.number.clone());
        number.unwrap_or_else(|| name.rsplit('.').next().unwrap_or(name).to_owned())
    }

    fn of_load(&self, line: &GivenLine<'a>, datum: &Datum<'a>) -> Option<Name> {
        let span = self.data.document.statements.get(line.statement)?.span;
        let own = |scene: &assur_picture::Scene<'a>| {
            let load = self.data.mechanism.loads.iter().find(|load| load.span == span)?;
            Some(quantity_name(&scene.load_words(load)?))
        };
        let usual = || Name::new(datum.kind.letter, &self.label(&datum.index));
        Some(self.data.scene.as_ref().and_then(own).unwrap_or_else(usual))
    }

    /// What a coordinate or a rate is called goes by its unit.
    fn by_unit(&self, datum: &Datum<'a>) -> Option<&'static str> {
        const RATES: [&str; 5] =
            ["drive.at", "drive.accelerating", "start", "start.rate", "equilibrium.rate"];
        let GivenValue::One(value, _) = &datum.value else { return None };
        if !RATES.contains(&datum.kind.key) {
            return None;
        }
        if is_point(value) {
            return Some("");
        }
        let unit = first_unit(value, &self.definitions)?;
        let turns = matches!(unit, "rpm" | "1/min" | "rev/min" | "rev/s");
        let dimension = lookup(unit).ok()?.dimension;
        let is = |other: Dimension| dimension.fits(other);
        Some(match datum.kind.key {
            "start" if is(Dimension::LENGTH) => "s",
            "start" => "φ",
            "drive.accelerating" if is(Dimension::ACCELERATION) => "a",
            "drive.accelerating" => "α",
            _ if turns => "n",
            _ if is(Dimension::VELOCITY) => "v",
            _ => "ω",
        })
    }
}

fn is_point(value: &Expr) -> bool {
    matches!(value.kind, ExprKind::Vector(..) | ExprKind::Polar(..))
}

/// Whether the value of a datum is a name, which has a letter of its own.
fn is_definition(datum: &Datum<'_>, given: &Given<'_>) -> bool {
    match &datum.value {
        GivenValue::One(Expr { kind: ExprKind::Name(name), .. }, _) => {
            datum.own.is_none() && given.definitions.contains_key(name.as_str())
        }
        _ => matches!(datum.kind.key, "given" | "let"),
    }
}
