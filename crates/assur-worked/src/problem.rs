//! The problem: text, scheme, given values; and what this version only states.

use crate::course::{Derivation, plain};
use crate::document::{Block, Figure, Inline, Line, Table, text};
use crate::given::{self, Data};
use crate::words::{Message, say};
use assur_formula::{Name, Quantity, Unit, name_node};
use assur_model::model::{PairKind, Positions};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

impl Derivation<'_> {
    /// Title, text, scheme.
    pub fn problem(&mut self, scheme: Vec<Figure>) {
        let notes = self.scene.mechanism().notes.join(" ");
        if !notes.is_empty() {
            self.blocks.push(Block::Paragraph(vec![text(notes)]));
        }
        self.figures(scheme);
    }

    /// What the file gives, and what else the equations use, each once, in the order of use.
    pub fn given_values(&self, data: Option<Data<'_>>) -> Vec<Block> {
        let (mut blocks, shown) =
            data.map_or_else(Default::default, |data| given::with_heading(data, self.language));
        let heading = if shown.is_empty() { Message::Given } else { Message::Quantity };
        let headers = [heading, Message::Value].map(|m| vec![text(self.words(m))]);
        blocks.extend(two_abreast(headers, self.given_rows(&shown)).into_iter().map(Block::Table));
        blocks.push(Block::Remark(say(self.language, Message::Conventions, &[])));
        blocks.extend(self.notation());
        let taken: Vec<Arc<Quantity>> =
            self.used_values().into_iter().filter(|q| self.is_assumed(q)).collect();
        if !taken.is_empty() {
            let one = |q: &Arc<Quantity>| {
                let value = format!(" = {} {}", q.figures(5).text(), q.unit.text());
                [text(", "), Inline::Math(name_node(&q.name)), text(value)]
            };
            let listed = taken.iter().flat_map(one).skip(1).collect();
            blocks.push(Block::Remark(say(self.language, Message::OpenSizes, &[listed])));
        }
        blocks.extend(self.only_stated().into_iter().map(|m| Block::Remark(say(self.language, m, &[]))));
        blocks
    }

    /// A radius that the file leaves open: nobody gave it.
    fn is_assumed(&self, q: &Quantity) -> bool {
        let wheel = q.name.sub.split(',').next().unwrap_or_default();
        let mechanism = self.scene.mechanism();
        let of_pair = || {
            mechanism.pairs.iter().filter(|p| p.name == wheel).any(|p| match &p.kind {
                PairKind::Transmission(t) => {
                    mechanism.wheels.iter().any(|w| w.open && t.ends.contains(&w.name))
                }
                _ => false,
            })
        };
        q.unit == Unit::Length
            && q.name.letter.trim_end_matches('′') == "r"
            && (mechanism.wheels.iter().any(|w| w.open && w.name == wheel) || of_pair())
    }

    /// The values of the file that the equations use, each once, in the order of use.
    fn used_values(&self) -> Vec<Arc<Quantity>> {
        let mut seen: BTreeMap<Name, ()> = BTreeMap::new();
        let mut values: Vec<Arc<Quantity>> = Vec::new();
        for (_, equation) in &self.equations {
            equation.right.visit(&mut |q| {
                if q.given && seen.insert(q.name.clone(), ()).is_none() {
                    values.push(Arc::clone(q));
                }
            });
        }
        values
    }

    /// The letters and figures of values that are not shown yet, in the units of equations.
    fn given_rows(&self, shown: &BTreeSet<Name>) -> Vec<[Line; 2]> {
        let row = |q: &Arc<Quantity>| {
            let unit = if q.unit == Unit::Angle { "°".to_owned() } else { format!(" {}", q.unit.text()) };
            let written = format!("{}{}", q.figures(5).text(), unit.trim_end());
            [vec![Inline::Math(name_node(&q.name))], vec![text(written)]]
        };
        let used = self.used_values().into_iter().filter(|q| !self.is_assumed(q) && !shown.contains(&q.name));
        used.map(|q| row(&q)).collect()
    }

    /// What the file has that this version states without deriving it, in one sentence each.
    pub fn only_stated(&self) -> Vec<Message> {
        let mechanism = self.scene.mechanism();
        let swept = mechanism.drives.iter().any(|d| match &d.positions {
            Positions::Range { .. } | Positions::Numbers(_) => true,
            Positions::List(values) => values.len() > 1,
            Positions::None => false,
        });
        let all = [(swept || !mechanism.cycles.is_empty(), Message::SweepStated)];
        all.into_iter().filter(|(there, _)| *there).map(|(_, m)| m).collect()
    }

    pub fn caption(&self, message: Message, part: &str) -> String {
        plain(&say(self.language, message, &[vec![text(part)]]))
    }
}

/// A table of values, two of them next to each other.
pub fn two_abreast(headers: [Line; 2], rows: Vec<[Line; 2]>) -> Option<Table> {
    let headers = [headers.clone(), headers].concat();
    let two = |two: &[[Line; 2]]| {
        let mut row = two.concat();
        row.resize(4, Vec::new());
        row
    };
    let rows: Vec<Vec<Line>> = rows.chunks(2).map(two).collect();
    (!rows.is_empty()).then_some(Table { headers, rows, ..Table::default() })
}
