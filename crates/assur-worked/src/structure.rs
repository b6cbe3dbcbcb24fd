//! Structure: pairs, mobility, groups, the formula of structure.

use crate::course::Derivation;
use crate::document::{Block, Line, Table, letter, text};
use crate::words::{Language, Letters, Message, say};
use assur_formula::{Figures, Lines, Name, Node, name_node};
use assur_model::model::PairKind;
use assur_model::structure::{BodyOrigin, Group, GroupKind};

impl Derivation<'_> {
    /// The class of a group, by its number.
    fn class_of(&self, number: &str) -> String {
        crate::course::plain(&say(
            self.language,
            Message::ClassOf,
            &[vec![text(numeral(self.language, number))]],
        ))
    }

    /// The section on structure.
    pub fn structure_section(&mut self) {
        let heading = self.words(Message::Structure);
        self.heading(2, heading);
        self.pairs();
        self.say(Message::MobilityIs, &[]);
        self.mobility();
        self.replacements();
        self.groups();
        self.formula();
    }

    fn pairs(&mut self) {
        let mechanism = self.scene.mechanism();
        let headers =
            [Message::Pair, Message::Links, Message::Kind, Message::Class].map(|m| vec![text(self.words(m))]);
        let mut table = Table { headers: headers.into(), ..Table::default() };
        for pair in &mechanism.pairs {
            let (kind, class) = match &pair.kind {
                PairKind::Revolute(_) => (Message::Revolute, Message::Lower),
                PairKind::Prismatic(_) => (Message::Prismatic, Message::Lower),
                PairKind::Slot(_) => (Message::Slot, Message::Higher),
                PairKind::Contact { .. } => (Message::Contact, Message::Higher),
                PairKind::Cylinder { .. } => (Message::Cylinder, Message::Lower),
                PairKind::Weld { .. } => (Message::Weld, Message::NoPair),
                PairKind::Transmission(_) => (Message::Transmission, Message::Higher),
            };
            let links: Vec<&str> = pair.kind.links().iter().map(|l| self.scene.link_label(*l)).collect();
            let count = pair.kind.lower().max(pair.kind.higher());
            let class = self.words(class);
            let class = if pair.kind.slipping().is_some() { "–".to_owned() } else { class };
            let class = if count > 1 { format!("{class} × {count}") } else { class };
            table.rows.push(vec![
                vec![text(&*pair.name)],
                vec![text(links.join("–"))],
                vec![text(self.words(kind))],
                vec![text(class)],
            ]);
        }
        self.table(table);
    }

    /// F = 3n − 2P_L − P_H in letters and in numbers.
    fn mobility(&mut self) {
        let count = self.structure().count;
        let Letters { mobility, lower, higher, .. } = self.language.letters();
        let number = |n: usize| Node::Number(Figures::whole(i64::try_from(n).unwrap_or(i64::MAX)));
        let letter = |a: &str, b: &str| name_node(&Name::new(a, b));
        let row = |parts: Vec<Node>| Node::Row(parts);
        let mut letters = vec![
            number(3),
            Node::Times,
            letter("n", ""),
            Node::Operator("−"),
            number(2),
            Node::Times,
            letter(lower.0, lower.1),
            Node::Operator("−"),
            letter(higher.0, higher.1),
        ];
        let mut numbers = vec![
            number(3),
            Node::Dot,
            number(count.n),
            Node::Operator("−"),
            number(2),
            Node::Dot,
            number(count.lower),
            Node::Operator("−"),
            number(count.higher),
        ];
        for (sign, symbol, n) in [("−", "P", count.passive), ("+", "R", count.redundant)] {
            if n > 0 {
                letters.extend([
                    Node::Operator(sign),
                    letter(symbol, if symbol == "P" { "passive" } else { "" }),
                ]);
                numbers.extend([Node::Operator(sign), number(n)]);
            }
        }
        let result = Node::Number(Figures::whole(count.mobility));
        let equals = || Node::Operator("=");
        let whole = row([vec![equals()], letters, vec![equals()], numbers, vec![equals(), result]].concat());
        self.blocks.push(Block::Equation(Lines { left: letter(mobility, ""), rows: vec![(whole, false)] }));
    }

    fn replacements(&mut self) {
        let mechanism = self.scene.mechanism();
        let replaced = self.structure().replaced.bodies.iter().filter_map(|b| match b.origin {
            BodyOrigin::Imaginary(pair) => Some(mechanism.pair(pair).name.clone()),
            BodyOrigin::Link(_) => None,
        });
        let names: Vec<String> = replaced.collect();
        if !names.is_empty() {
            self.say(Message::Replaced, &[vec![text(names.join(", "))]]);
        }
        let passive: Vec<&str> = self.structure().passive.iter().map(|l| self.scene.link_label(*l)).collect();
        if !passive.is_empty() {
            self.say(Message::Passive, &[vec![text(passive.join(", "))]]);
        }
    }

    /// The kind of a group in words.
    pub fn group_kind(&self, group: &Group) -> String {
        let message = match group.kind {
            GroupKind::Dyad(dyad) => return dyad.name().to_owned(),
            GroupKind::Driven => Message::Driven,
            GroupKind::Free => Message::FreeLink,
            GroupKind::DrivenLegs(_) => Message::DrivenLegs,
            GroupKind::Translation => Message::Between,
            GroupKind::Train => Message::Train,
            GroupKind::Triad => Message::Triad,
            GroupKind::General => Message::General,
        };
        self.words(message)
    }

    fn groups(&mut self) {
        let headers =
            [Message::Group, Message::Links, Message::OuterPairs, Message::InnerPairs, Message::Kind];
        let mut headers: Vec<Line> = headers.map(|m| vec![text(self.words(m))]).into();
        let lower = self.language.letters().lower;
        let [n, p] = [Name::new("n", ""), Name::new(lower.0, lower.1)].map(|name| letter(&name));
        headers.push(vec![text("3"), n, text(" − 2"), p]);
        let mut table = Table { headers, ..Table::default() };
        for (i, group) in self.structure().motion.iter().enumerate() {
            let labels: Vec<String> = group.bodies.iter().map(|b| self.label(b.0)).collect();
            let pairs = |inner: bool| {
                let own = group.joints.iter().filter(|j| j.inner == inner);
                let names = own.map(|j| {
                    let pair = self.structure().replaced.joint(j.joint).pair;
                    self.scene.mechanism().pair(pair).name.clone()
                });
                let names: Vec<String> = names.collect();
                if names.is_empty() { "–".to_owned() } else { names.join(", ") }
            };
            let (n, p) = (group.bodies.len(), group.joints.len());
            let figure = |x: usize| i64::try_from(x).unwrap_or(0);
            let laws = figure(group.laws.len());
            let rest = 3 * figure(n) - 2 * figure(p) - laws;
            let less = if laws > 0 { format!(" − {laws}") } else { String::new() };
            let driven = if group.efforts.is_empty() {
                self.class_of(group.class_name()) + ", "
            } else {
                String::new()
            };
            table.rows.push(vec![
                vec![text(format!("{}", i + 1))],
                vec![text(labels.join(", "))],
                vec![text(pairs(false))],
                vec![text(pairs(true))],
                vec![text(format!("{driven}{}", self.group_kind(group)))],
                vec![text(format!("3·{n} − 2·{p}{less} = {rest}").replace(' ', "\u{a0}"))],
            ]);
        }
        self.table(table);
    }

    /// I(6, 1) → II(2, 3) → II(4, 5)
    fn formula(&mut self) {
        let written = |groups: &[Group], numbered: bool| {
            let mut dependent = 0;
            let parts = groups.iter().map(|group| {
                let labels: Vec<String> = group.bodies.iter().map(|b| self.label(b.0)).collect();
                let ground = if group.efforts.is_empty() { String::new() } else { self.label(0) + ", " };
                dependent += usize::from(group.efforts.is_empty());
                let number =
                    if numbered && group.efforts.is_empty() { subscript(dependent) } else { String::new() };
                format!(
                    "{}{number}({ground}{})",
                    numeral(self.language, group.class_name()),
                    labels.join(", ")
                )
            });
            parts.collect::<Vec<_>>().join(" → ")
        };
        let structure = self.structure();
        let class = structure.motion.iter().max_by_key(|g| g.class).map_or("I", Group::class_name);
        let motion = written(&structure.motion, true);
        let forces = written(&structure.forces, false);
        let line: Line = vec![crate::document::Inline::Strong(motion)];
        let class = numeral(self.language, class);
        self.say(Message::Formula, &[line, vec![text(class)]]);
        let sorted = |groups: &[Group]| {
            let mut bodies: Vec<Vec<usize>> =
                groups.iter().map(|g| g.bodies.iter().map(|b| b.0).collect()).collect();
            bodies.iter_mut().for_each(|b| b.sort_unstable());
            bodies.sort();
            bodies
        };
        if !structure.forces.is_empty() && sorted(&structure.motion) != sorted(&structure.forces) {
            self.say(Message::ForceOrder, &[vec![crate::document::Inline::Strong(forces)]]);
        }
    }
}

/// A number in lowered figures.
fn subscript(number: usize) -> String {
    number
        .to_string()
        .bytes()
        .map(|digit| char::from_u32(0x2080 + u32::from(digit - b'0')).unwrap_or('?'))
        .collect()
}

/// The number of a class: in Chinese one sign.
fn numeral(language: Language, number: &str) -> String {
    const SIGNS: [(&str, &str); 6] =
        [("I", "Ⅰ"), ("II", "Ⅱ"), ("III", "Ⅲ"), ("IV", "Ⅳ"), ("V", "Ⅴ"), ("VI", "Ⅵ")];
    let sign = SIGNS.iter().find(|(own, _)| language == Language::Chinese && *own == number);
    sign.map_or(number, |(_, sign)| sign).to_owned()
}
