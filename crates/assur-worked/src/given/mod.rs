//! What a reader gets: the data of a file in words, a line per statement, with figures and units as the file has them.

mod curve;
mod letters;
mod numbers;
mod positions;
mod value;

pub(crate) use numbers::digits;
pub use positions::drive_letter;

use crate::asked_formula::passing_in_words;
use crate::course::plain;
use crate::document::{Block, Inline, Line, text};
use crate::forces::quantity_name;
use crate::words::{Language, Message, say, word, words_of};
use assur_formula::{Name, name_node};
use assur_math::element::gear::STANDARD_RACK;
use assur_model::model::Mechanism;
use assur_picture::Scene;
use assur_syntax::document::{Document, Expr, ExprKind, JointKind, Statement, parts};
use assur_syntax::given::{Datum, Given, GivenLine, GivenValue, Shown};
use assur_text::units::significant;
use letters::Letters;
use std::collections::BTreeSet;
use value::Values;

/// A file, and where the values are that its text does not give.
#[derive(Clone, Copy)]
pub struct Data<'a> {
    pub document: &'a Document,
    pub mechanism: &'a Mechanism,
    /// A position, for the letters of loads.
    pub scene: Option<Scene<'a>>,
    /// Values in the table of variants, by name.
    pub in_table: &'a dyn Fn(&str) -> bool,
    /// Values that replace those of the file, by name.
    pub replaced: &'a dyn Fn(&str) -> bool,
    /// There is a figure, which shows what is drawn to scale.
    pub figure: bool,
    /// Curves have their plots, too.
    pub plots: bool,
    /// Headings name the positions.
    pub headings: bool,
    /// Where the drives are, if that is not as the file has it.
    pub position: Option<&'a [(Name, String)]>,
}

/// The data of a file, as blocks.
#[must_use]
pub fn blocks(data: Data<'_>, language: Language) -> Vec<Block> {
    Telling::of(data, language).blocks()
}

/// The same after a heading, with the letters that they have.
pub fn with_heading(data: Data<'_>, language: Language) -> (Vec<Block>, BTreeSet<Name>) {
    let mut telling = Telling::of(data, language);
    let mut blocks = telling.blocks();
    if !blocks.is_empty() {
        blocks.insert(0, Block::Paragraph(vec![Inline::Strong(plain(&say(language, Message::Given, &[])))]));
    }
    (blocks, telling.values.named)
}

/// The same, of a file without positions.
#[must_use]
pub fn given(data: Data<'_>, language: Language) -> Vec<Block> {
    with_heading(data, language).0
}

/// The lines that are being written.
struct Telling<'a> {
    data: Data<'a>,
    language: Language,
    given: Given<'a>,
    letters: Letters<'a>,
    values: Values<'a>,
}

impl<'a> Telling<'a> {
    fn of(data: Data<'a>, language: Language) -> Self {
        let given = Given::of(data.document);
        let letters = Letters::of(data, &given);
        let values = Values::of(data, language, given.definitions.clone());
        Self { data, language, given, letters, values }
    }

    fn blocks(&mut self) -> Vec<Block> {
        let lines = self.given.lines.clone();
        let mut blocks = Vec::new();
        for line in &lines {
            let words = self.line(line);
            if !words.is_empty() {
                blocks.push(Block::Paragraph(words));
            }
            let curves = line.data.iter().filter_map(|datum| match datum.value {
                GivenValue::Curve(curve) => Some(curve),
                _ => None,
            });
            for curve in curves {
                blocks.extend(curve::tables(curve));
                let plot = curve::plot(curve, self.data.mechanism, self.language).filter(|_| self.data.plots);
                blocks.extend(plot.map(|plot| Block::Figures(vec![plot])));
            }
        }
        let positions = self.positions(&lines);
        let rest = self.definitions();
        blocks.extend((!rest.is_empty()).then_some(Block::Paragraph(rest)));
        blocks.extend((!positions.is_empty()).then_some(Block::Paragraph(positions)));
        blocks
    }

    /// The data of a statement after its subject; nothing where it has none that is shown.
    fn line(&mut self, line: &GivenLine<'a>) -> Line {
        let mut cells: Vec<Line> = Vec::new();
        let shown: Vec<_> = line.data.iter().filter(|datum| self.is_shown(datum)).collect();
        for datum in shown {
            let words = self.datum(line, datum);
            match cells.last_mut() {
                Some(last) if datum.kind.after => {
                    let [before, behind] = match self.language {
                        _ if begins_with_comma(&words) => ["", ""],
                        Language::Chinese => ["（", "）"],
                        Language::English | Language::Russian => [" ", ""],
                    };
                    last.push(text(before));
                    last.extend(words);
                    last.push(text(behind));
                }
                _ => cells.push(words),
            }
        }
        cells.extend(self.standard_rack(line));
        if cells.is_empty() {
            return Vec::new();
        }
        let [colon, semicolon] = self.signs();
        let mut shown = match line.subject {
            "" => Vec::new(),
            subject => {
                let names: Vec<Line> = self.subject(line).into_iter().map(|name| vec![text(name)]).collect();
                let mut words = words_of(self.language, "given subjects", subject, &names);
                words.push(text(colon));
                words
            }
        };
        for (i, cell) in cells.into_iter().enumerate() {
            shown.extend((i > 0).then(|| text(semicolon)));
            shown.extend(cell);
        }
        if line.subject.is_empty() { capital(shown) } else { shown }
    }

    /// The sizes of the standard rack, which a mesh has where its statement is silent and its geometry is asked for.
    fn standard_rack(&self, line: &GivenLine<'_>) -> Vec<Line> {
        let statement = self.data.document.statements.get(line.statement).map(|s| &s.node);
        let Some(Statement::Joint(mesh)) = statement.filter(|s| asks_for_teeth(self.data.document, s)) else {
            return Vec::new();
        };
        let is_written = |kind: &str| mesh.properties.iter().any(|own| own.name.node == kind);
        let [angle, addendum, clearance] = STANDARD_RACK;
        let all = [
            ("pressure_angle", "α", format!("{}°", significant(angle.to_degrees(), 6))),
            ("addendum", "h", significant(addendum, 6)),
            ("clearance", "c", significant(clearance, 6)),
        ];
        let missing = all.into_iter().filter(|(kind, ..)| !is_written(kind));
        let words = missing.map(|(kind, letter, figures)| {
            let figures = text(format!("\u{a0}=\u{a0}{figures}"));
            let value = vec![Inline::Math(name_node(&Name::new(letter, ""))), figures];
            words_of(self.language, "given", kind, &[value])
        });
        words.collect()
    }

    const fn signs(&self) -> [&'static str; 2] {
        match self.language {
            Language::Chinese => ["：", "；"],
            Language::English | Language::Russian => [": ", "; "],
        }
    }

    /// The names of a subject: of a link with its number, of pairs of one kind their word.
    fn subject(&self, line: &GivenLine<'_>) -> Vec<String> {
        match (line.subject, line.names.as_slice()) {
            ("link", [name, number]) if !number.is_empty() => vec![format!("{name} ({number})")],
            ("all", [kind]) => vec![word(self.language, "given words", kind)],
            (_, names) => names.to_vec(),
        }
    }

    fn is_shown(&self, datum: &Datum<'_>) -> bool {
        match datum.shown {
            Shown::Text => !matches!(datum.kind.key, "given" | "let"),
            Shown::Figure => !self.data.figure && datum.kind.key != "assemble",
            Shown::Heading | Shown::Question | Shown::Method | Shown::Key => false,
        }
    }

    /// A datum in words.
    fn datum(&mut self, line: &GivenLine<'a>, datum: &Datum<'a>) -> Line {
        let translated =
            matches!(datum.kind.key, "cam.turning" | "follower" | "law" | "drive.sense" | "freewheel.turn");
        let name = |name: &String| {
            let words =
                if translated { word(self.language, "given words", name) } else { name.replace('-', "−") };
            vec![text(words)]
        };
        let names: Vec<Line> = datum.names.iter().map(name).collect();
        let mut parts = vec![self.value(line, datum)];
        if let (GivenValue::Several(values), "point.from") = (&datum.value, datum.kind.key) {
            // each distance after its point
            let [own, first, second] = [0, 1, 2].map(|i| names.get(i).cloned().unwrap_or_default());
            let [near, far] = [0, 1].map(|i| values.get(i).map_or_else(Vec::new, |v| self.values.line(v)));
            parts.extend([own, first, near, second, far]);
        } else {
            parts.extend(names);
        }
        words_of(self.language, "given", datum.kind.key, &parts)
    }

    /// The letter of a datum with its value, or its value alone.
    fn value(&mut self, line: &GivenLine<'a>, datum: &Datum<'a>) -> Line {
        let letter = self.letters.get(line, datum);
        match &datum.value {
            GivenValue::Flag | GivenValue::Curve(_) | GivenValue::Positions(_) => Vec::new(),
            GivenValue::Passing(passing) => {
                passing_in_words(self.language, passing, &mut |expr| self.values.line(expr))
            }
            GivenValue::One(value, sense) => {
                let in_frame = line.data.iter().any(|datum| datum.kind.key == "in.frame");
                self.values.is_free = in_frame || !matches!(datum.kind.key, "force" | "distributed");
                let mut words = self.values.with_letter(letter, datum.own.is_some(), value);
                if let Some(sense) = sense {
                    let key = match sense {
                        assur_syntax::document::Turn::Ccw => "ccw",
                        assur_syntax::document::Turn::Cw => "cw",
                    };
                    words.push(text(format!(" {}", word(self.language, "given words", key))));
                }
                words
            }
            GivenValue::Several(values) => {
                let lines: Vec<Line> = values.iter().map(|value| self.values.line(value)).collect();
                let words = match datum.kind.key {
                    "simulate" | "distributed" => words_of(self.language, "given words", "from.to", &lines),
                    _ => lines.join(&text("; ")),
                };
                match letter {
                    Some(letter) => {
                        self.values.named.insert(letter.clone());
                        [vec![Inline::Math(name_node(&letter)), text("\u{a0}=\u{a0}")], words].concat()
                    }
                    None => words,
                }
            }
        }
    }

    /// Definitions that formulas or questions use, and no line has with its value yet.
    fn definitions(&mut self) -> Line {
        let mut shown = Vec::new();
        let statements = self.data.document.statements.iter().filter_map(|s| match &s.node {
            Statement::Given(value) | Statement::Let(value) => Some(value),
            _ => None,
        });
        for definition in statements {
            let name = definition.name.node.as_str();
            if !self.given.used.contains(name)
                || self.values.seen.contains(name)
                || (self.data.in_table)(name)
            {
                continue;
            }
            self.values.seen.insert(name);
            let letter = quantity_name(name);
            let value = self.values.of_definition(name, &definition.value);
            shown.extend((!shown.is_empty()).then(|| text("; ")));
            shown.push(Inline::Math(name_node(&letter)));
            shown.push(text("\u{a0}=\u{a0}"));
            shown.extend(value);
            self.values.named.insert(letter);
        }
        shown
    }
}

fn begins_with_comma(words: &Line) -> bool {
    matches!(words.first(), Some(Inline::Text(words)) if words.starts_with([',', '，']))
}

/// With a capital at its beginning.
fn capital(mut line: Line) -> Line {
    if let Some(Inline::Text(words)) = line.first_mut() {
        let mut chars = words.chars();
        let first: String = chars.next().into_iter().flat_map(char::to_uppercase).collect();
        *words = first + chars.as_str();
    }
    line
}

/// Whether the geometry of the teeth of a mesh is asked for.
fn asks_for_teeth(document: &Document, mesh: &Statement) -> bool {
    let Statement::Joint(mesh) = mesh else { return false };
    let is_own = |expr: &Expr| matches!(&expr.kind, ExprKind::Name(name) if *name == mesh.name.node);
    let of_teeth = ["table", "contact_ratio", "tooth_force", "sliding_velocity"];
    let asks = |part: &Expr| match &part.kind {
        ExprKind::Call { function, args } if of_teeth.contains(&function.node.as_str()) => {
            args.first().is_some_and(|arg| is_own(&arg.value))
        }
        _ => false,
    };
    let finds = document.statements.iter().filter_map(|s| match &s.node {
        Statement::Find(find) => Some(&find.items),
        _ => None,
    });
    let mut asked = false;
    for item in finds.flatten() {
        parts(&item.value, &mut |part| asked |= asks(part));
    }
    mesh.kind.node == JointKind::Mesh && asked
}
