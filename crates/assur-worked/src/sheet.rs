//! Exercise sheets without answers, and their keys.

use crate::asked_formula::letters;
use crate::course::{Derivation, plain};
use crate::document::{Block, Document, Inline, Line, Table, text};
use crate::forces::quantity_name;
use crate::given::Data;
use crate::questions::{is_formula, letters_of_all, questions};
use crate::words::{Language, Message, say};
use crate::worked::without_empty;
use assur_formula::{Name, Node, name_node};
use assur_model::model::{Find, FindKind, Mechanism, Query, Value};
use assur_picture::Scene;
use assur_text::source::Span;
use assur_text::units::{Dimension, lookup};
use std::f64::consts::FRAC_PI_4;

/// The table of all variants.
pub struct Variants {
    /// Its columns: names with their units.
    pub columns: Vec<(String, String)>,
    pub rows: Vec<Vec<String>>,
    /// The variant of the scheme.
    pub drawn_for: String,
    /// The text has values of that variant.
    pub in_text: bool,
}

/// A name of the file in letters, as in a text: `φ` for `phi`.
#[must_use]
pub fn in_letters(name: &str) -> String {
    assur_formula::text(&name_node(&quantity_name(name)))
}

/// A letter with its index, as in a text.
#[must_use]
pub fn letters_in_text(name: &Name) -> String {
    assur_formula::text(&name_node(name))
}

/// `φ_1 = 60°` of drives.
pub(crate) fn drive_words(drives: &[(Name, String)]) -> Line {
    let one = |(i, (letter, value)): (usize, &(Name, String))| {
        let between = if i == 0 { "" } else { ", " };
        [text(between), Inline::Math(name_node(letter)), text(format!("\u{a0}=\u{a0}{value}"))]
    };
    drives.iter().enumerate().flat_map(one).collect()
}

/// Digits of a key.
const DIGITS: usize = 4;
/// Answers next to each other.
const IN_PART: usize = 6;
/// A number of a text is one of the file where it is as near as this.
const ROUNDED: f64 = 1e-3;
/// A number of a text is an answer where it is as near as this.
const NEAR: f64 = 6e-3;

/// A question with its unit, and its values at a position in it.
#[derive(Clone, Debug, PartialEq)]
pub struct SheetQuestion {
    /// What `assur grade` reads it by.
    pub name: String,
    pub unit: String,
    /// SI value of one unit.
    pub factor: f64,
    /// It is a vector, with two columns.
    pub vector: bool,
    /// It is of no position.
    pub whole: bool,
    /// Its value in its unit, where there is one.
    pub value: Option<Value>,
}

/// A problem as an exercise.
pub struct Exercise<'a> {
    pub mechanism: &'a Mechanism,
    /// The name of its file.
    pub file: &'a str,
    pub text: &'a str,
    /// Its position, where it has one.
    pub scene: Option<Scene<'a>>,
    /// The position of the scheme, another one where positions are asked for.
    pub shown: Option<Scene<'a>>,
    pub asked: Vec<SheetQuestion>,
    /// Other numbers that are answers: expected ones, SI, each with its unit.
    pub hidden: Vec<(f64, String)>,
    /// Numbers that the file gives, SI.
    pub written: &'a [f64],
    /// What needs no position is asked for once, everything else at these positions, by name.
    pub positions: Vec<String>,
    /// Where the drives are at these positions; nothing where the table of variants has it.
    pub drives: Vec<Vec<(Name, String)>>,
    /// One of several positions is meant.
    pub is_one_of_several: bool,
    /// What its file says.
    pub document: &'a assur_syntax::document::Document,
    /// Values that the table of variants has, by name.
    pub in_table: &'a dyn Fn(&str) -> bool,
    /// Values that replace those of the file, by name.
    pub replaced: &'a dyn Fn(&str) -> bool,
    /// The number and the name of its variant, where it is of one.
    pub row: Option<String>,
}

/// The exercise sheet of a problem: statement, scheme, given values, variants, what to find, and an empty table.
#[must_use]
pub fn sheet(exercise: &Exercise<'_>, language: Language, variants: Option<Variants>) -> Document {
    let words = |message: Message| plain(&say(language, message, &[]));
    let heading = |message: Message| Block::Heading(2, words(message));
    let mut blocks = exercise.statement(language, variants.as_ref());
    blocks.push(heading(Message::Given));
    blocks.extend(exercise.given(language, true));
    if let Some(variants) = variants {
        blocks.push(heading(Message::Variants));
        blocks.extend(table_of(variants, language));
    }
    blocks.push(heading(Message::Find));
    blocks.push(Block::List(questions(exercise.mechanism, exercise.text, language)));
    blocks.push(heading(Message::Answers));
    blocks.extend(exercise.answers(language));
    let mut blocks = without_empty(blocks);
    blocks.push(Block::Room(words(Message::Solution)));
    let variant = vec![text(exercise.row.as_deref().unwrap_or("____"))];
    let head = plain(&say(language, Message::SheetHead, &[variant]));
    let mut sheet = document(exercise, language, blocks);
    sheet.fields = head.split("   ").map(str::to_owned).collect();
    // one picture needs no number
    sheet.labels.figure = "";
    sheet
}

/// The table of all variants, each with its number.
fn table_of(Variants { columns, mut rows, drawn_for, in_text }: Variants, language: Language) -> Vec<Block> {
    let header = |(name, unit): &(String, String)| match name.as_str() {
        "variant" => say(language, Message::Variant, &[]),
        name => with_unit(Inline::Math(name_node(&quantity_name(name))), unit),
    };
    let mut headers: Vec<Line> = columns.iter().map(header).collect();
    for cell in rows.iter_mut().flatten() {
        if cell.parse::<f64>().is_ok() {
            *cell = crate::given::digits(cell);
        }
    }
    if columns.iter().all(|(name, _)| name != "variant") {
        headers.insert(0, say(language, Message::Variant, &[]));
        rows.iter_mut().enumerate().for_each(|(i, row)| row.insert(0, (i + 1).to_string()));
    }
    let mut blocks = vec![Block::Table(Table { headers, ..table(Vec::new(), rows) })];
    let of_text = || Block::Remark(say(language, Message::TextOf, &[vec![text(drawn_for)]]));
    blocks.extend(in_text.then(of_text));
    blocks
}

/// Letters with a unit behind them.
fn with_unit(letters: Inline, unit: &str) -> Line {
    let mut line = vec![letters];
    if !unit.is_empty() {
        line.push(text(format!(", {}", printed_unit(unit).trim_start())));
    }
    line
}

/// The key of a problem: the answers of every row and position, with four digits. `rows` begin with the name of the row and of the position.
#[must_use]
pub fn key(
    exercise: &Exercise<'_>,
    language: Language,
    rows: &[([String; 2], Vec<SheetQuestion>)],
) -> Document {
    let mut blocks = vec![Block::Remark(say(language, Message::KeyHead, &[]))];
    let own = exercise.own_letters(language);
    let first = rows.first().into_iter().flat_map(|(_, asked)| asked);
    let headers: Vec<Line> = first.flat_map(|asked| exercise.headers(asked, &own, language)).collect();
    let mut positions = rows.iter().map(|(names, _)| &names[1]);
    let first = positions.next();
    let lead = if positions.all(|name| Some(name) == first) { 1 } else { 2 };
    let words = [say(language, Message::Variant, &[]), exercise.position_header(language)];
    let cells = |(names, asked): &([String; 2], Vec<SheetQuestion>)| {
        names.iter().take(lead).cloned().chain(asked.iter().flat_map(SheetQuestion::figures)).collect()
    };
    let rows: Vec<Vec<String>> = rows.iter().map(cells).collect();
    blocks.extend(in_parts(&words[..lead], &headers, &rows));
    document(exercise, language, blocks)
}

/// Empty cells under headers, beside the names of their rows, in several parts where there are many.
fn forms(lead: &[Line], headers: &[Line], rows: &[Vec<String>]) -> Vec<Block> {
    let part = |headers: &[Line]| {
        let empty = vec!["\u{2003}".to_owned(); headers.len()];
        let rows = rows.iter().map(|row| [row.as_slice(), &empty].concat()).collect();
        Block::Form(Table { headers: [lead, headers].concat(), ..table(Vec::new(), rows) })
    };
    headers.chunks(IN_PART).map(part).collect()
}

/// A wide table in parts, each with the columns that name its rows.
fn in_parts(lead: &[Line], headers: &[Line], rows: &[Vec<String>]) -> Vec<Block> {
    let first = lead.len();
    let part = |from: usize| {
        let to = (from + IN_PART).min(headers.len());
        let of = |row: &Vec<String>| {
            let cells = row.iter().take(first).chain(row.iter().skip(first + from).take(to - from));
            cells.cloned().collect()
        };
        let all = [lead, &headers[from..to]].concat();
        let numbers = (first..all.len()).collect::<Vec<_>>();
        Block::Table(Table { headers: all, numbers, ..table(Vec::new(), rows.iter().map(of).collect()) })
    };
    (0..headers.len()).step_by(IN_PART).map(part).collect()
}

pub(crate) fn document(exercise: &Exercise<'_>, language: Language, blocks: Vec<Block>) -> Document {
    let title = &exercise.mechanism.title;
    let comma = language.letters().comma;
    let blocks = blocks.into_iter().map(|b| if comma { b.with_commas() } else { b });
    Document {
        fields: Vec::new(),
        title: if title.is_empty() { exercise.file.to_owned() } else { title.clone() },
        language: language.code(),
        labels: language.labels(),
        blocks: blocks.collect(),
    }
}

fn table(headers: Vec<String>, rows: Vec<Vec<String>>) -> Table {
    let line = |words: String| -> Line { vec![text(words)] };
    Table {
        headers: headers.into_iter().map(line).collect(),
        rows: rows.into_iter().map(|row| row.into_iter().map(line).collect()).collect(),
        numbers: Vec::new(),
    }
}

/// What a question asks of the solution; nothing where it is a table.
fn asked_by(mechanism: &Mechanism, find: &Find) -> Option<Vec<Query>> {
    let FindKind::Value { expr, .. } = &find.kind else { return None };
    let mut all = Vec::new();
    mechanism.each_query(expr, &mut |query| all.push(*query));
    Some(all)
}

fn asks(mechanism: &Mechanism, is: impl Fn(&Query) -> bool) -> bool {
    mechanism.finds.iter().filter_map(|find| asked_by(mechanism, find)).flatten().any(|query| is(&query))
}

/// Whether a file asks where something is.
#[must_use]
pub fn asks_for_positions(mechanism: &Mechanism) -> bool {
    asks(mechanism, |query| {
        matches!(
            query,
            Query::Position(_) | Query::Angle(_) | Query::Displacement(_) | Query::LinkDirection(_)
        )
    })
}

/// Whether a file asks how something moves: a load against the motion shows its sense.
fn asks_for_motion(mechanism: &Mechanism) -> bool {
    let is = |query: &Query| {
        matches!(query, Query::Velocity(_) | Query::Omega(_) | Query::RelativeVelocity(_) | Query::Sliding(_))
    };
    asks_for_positions(mechanism) || asks(mechanism, is)
}

impl SheetQuestion {
    /// The numbers of its value.
    #[must_use]
    pub fn values(&self) -> Vec<f64> {
        match self.value {
            Some(Value::Scalar(x)) => vec![x],
            Some(Value::Vector(v)) => vec![v.x, v.y],
            Some(Value::Bool(_)) | None => Vec::new(),
        }
    }

    fn figures(&self) -> Vec<String> {
        if let Some(Value::Bool(truth)) = self.value {
            return vec![truth.to_string()];
        }
        let values = self.values();
        if values.iter().any(|x| !x.is_finite()) || values.is_empty() {
            return vec!["–".to_owned(); 1 + usize::from(self.vector)];
        }
        values.iter().map(|x| assur_formula::with_digits(*x, DIGITS).text()).collect()
    }
}

impl Exercise<'_> {
    /// The text and the scheme, without what they would give away.
    pub(crate) fn statement(&self, language: Language, variants: Option<&Variants>) -> Vec<Block> {
        let mut blocks = Vec::new();
        let notes = self.notes_without();
        if !notes.is_empty() {
            blocks.push(Block::Paragraph(vec![text(notes)]));
        }
        blocks.extend(self.scheme(language, variants));
        blocks
    }

    /// The text of the problem without the sentences that have an answer in them.
    fn notes_without(&self) -> String {
        let notes = typeset(&self.mechanism.notes.join(" "));
        let tells = |sentence: &&str| {
            numbers_in(sentence).into_iter().any(|(number, unit)| self.is_answer_in_words(number, unit))
        };
        let kept: Vec<&str> = notes.split_inclusive(". ").filter(|s| !tells(s)).map(str::trim).collect();
        kept.join(" ")
    }

    /// Whether the file gives a number, SI, to within a part of it.
    fn gives(&self, x: f64, near: f64) -> bool {
        let given = self.mechanism.values.iter().filter(|v| v.given).filter_map(|v| match v.value {
            Value::Scalar(x) => Some(x),
            _ => None,
        });
        let mut all = self.written.iter().copied().chain(given);
        all.any(|given| (given.abs() - x).abs() <= near * given.abs())
    }

    /// The numbers with units of a text that are none of the file's, and no answers, as they are written.
    #[must_use]
    pub fn numbers_in_words_alone(&self, words: &str) -> Vec<String> {
        let alone = |(number, unit): &(f64, &str)| {
            let Ok(own) = lookup(unit) else { return false };
            let x = own.to_si(*number);
            let is_part_of_turn = own.dimension == Dimension::ANGLE && is_whole(x / FRAC_PI_4);
            own.dimension != Dimension::NUMBER
                && !is_part_of_turn
                && !is_letter(unit)
                && !self.gives(x, ROUNDED)
                && !self.is_answer_in_words(*number, unit)
        };
        numbers_in(words).into_iter().filter(alone).map(|(number, unit)| format!("{number} {unit}")).collect()
    }

    /// The questions that are formulas without letters: their numbers and places.
    #[must_use]
    pub fn formulas_without_letters(&self, language: Language) -> Vec<(usize, Span)> {
        let own = self.own_letters(language);
        let finds = self.mechanism.finds.iter().zip(&own).enumerate();
        let is_formula = |find: &Find| {
            matches!(find.kind, FindKind::Value { .. })
                && is_formula(self.mechanism, self.text, find, language)
        };
        let without = finds.filter(|(_, (find, own))| own.is_none() && is_formula(find));
        without.map(|(i, (find, _))| (i + 1, find.span)).collect()
    }

    /// Whether a number of the text, with what is behind it, is an answer and no number that the file gives.
    fn is_answer_in_words(&self, number: f64, behind: &str) -> bool {
        let unit = lookup(behind).unwrap_or_else(|_| assur_text::units::Unit::si(Dimension::NUMBER));
        let x = unit.to_si(number);
        if self.gives(x, 1e-9) {
            return false;
        }
        let fits = |own: &str| match lookup(own) {
            Ok(own) => own.dimension.fits(unit.dimension),
            Err(_) => unit.dimension == Dimension::NUMBER,
        };
        let asked = self.asked.iter().filter(|a| fits(&a.unit)).flat_map(|a| {
            let values = a.values();
            let size = values.iter().map(|x| x * x).sum::<f64>().sqrt();
            values.into_iter().chain([size]).map(|x| x * a.factor)
        });
        let hidden = self.hidden.iter().filter(|(_, own)| fits(own)).map(|(x, _)| *x);
        asked.chain(hidden).any(|answer| is_within(answer, x))
    }

    /// What is asked where: at each of several positions, then what needs none; all together where there is one.
    pub(crate) fn places(&self) -> Vec<(Option<&String>, Vec<&SheetQuestion>)> {
        let several = self.positions.len() > 1;
        let asked =
            |whole: bool| self.asked.iter().filter(|a| !several || a.whole == whole).collect::<Vec<_>>();
        let at = self.positions.iter().filter(|_| several).map(|name| (Some(name), asked(false)));
        at.chain([(None, asked(true))]).filter(|(_, asked)| !asked.is_empty()).collect()
    }

    /// What the file gives, with a figure or without one.
    pub(crate) fn given(&self, language: Language, pictures: bool) -> Vec<Block> {
        let several = self.positions.len() > 1 && self.asked.iter().any(|asked| !asked.whole);
        let has_headings = self.drives.iter().any(|drives| !drives.is_empty());
        let data = Data {
            document: self.document,
            mechanism: self.mechanism,
            scene: self.scene,
            in_table: self.in_table,
            replaced: self.replaced,
            figure: pictures && self.drawn().is_some(),
            plots: pictures,
            headings: several && has_headings,
            position: self.drives.first().filter(|_| self.is_one_of_several).map(Vec::as_slice),
        };
        crate::given::blocks(data, language)
    }

    /// The position that is drawn: not where a scheme would show the places of counterweights, which are asked for.
    fn drawn(&self) -> Option<(Scene<'_>, Scene<'_>)> {
        self.scene.zip(self.shown).filter(|_| self.mechanism.counterweights.is_empty())
    }

    /// The scheme, where it tells nothing that is asked for.
    fn scheme(&self, language: Language, variants: Option<&Variants>) -> Vec<Block> {
        let Some((scene, shown)) = self.drawn() else { return Vec::new() };
        let elsewhere = shown.pose.name != scene.pose.name || shown.pose.drives != scene.pose.drives;
        let senses = !elsewhere && !asks_for_motion(self.mechanism);
        let mut scheme = Derivation::new(shown, language).blank_scheme(senses);
        if let Some(Variants { drawn_for, .. }) = variants {
            let caption = plain(&say(language, Message::DrawnFor, &[vec![text(drawn_for)]]));
            scheme.iter_mut().for_each(|figure| figure.caption.clone_from(&caption));
        }
        let mut blocks = vec![Block::Figures(scheme)];
        blocks.retain(|block| !matches!(block, Block::Figures(figures) if figures.is_empty()));
        if elsewhere {
            blocks.push(Block::Remark(say(language, Message::OtherPose, &[])));
        }
        blocks
    }

    /// What heads the names of positions: of a motion these are instants.
    fn position_header(&self, language: Language) -> Line {
        match self.mechanism.simulation {
            Some(_) => {
                let unit = &self.mechanism.display_of(Dimension::TIME).unit;
                with_unit(Inline::Math(name_node(&Name::new("t", ""))), unit)
            }
            None => say(language, Message::Position, &[]),
        }
    }

    /// What a position is called beside others: `Position 3`, `t = 0.2 s`.
    pub(crate) fn position_in_words(&self, name: &str, language: Language) -> String {
        match self.mechanism.simulation {
            Some(_) if name.parse::<f64>().is_ok() => {
                let unit = &self.mechanism.display_of(Dimension::TIME).unit;
                format!("t = {name}{}", printed_unit(unit))
            }
            _ => format!("{} {name}", plain(&say(language, Message::Position, &[]))),
        }
    }

    /// Cells for the answers, by position where there are several.
    fn answers(&self, language: Language) -> Vec<Block> {
        let own = self.own_letters(language);
        let headers = |asked: &[&SheetQuestion]| -> Vec<Line> {
            asked.iter().flat_map(|asked| self.headers(asked, &own, language)).collect()
        };
        let (at, whole): (Vec<_>, Vec<_>) =
            self.places().into_iter().partition(|(position, _)| position.is_some());
        let mut blocks = Vec::new();
        if let Some((_, asked)) = at.first() {
            let rows: Vec<Vec<String>> =
                at.iter().map(|(name, _)| name.iter().cloned().cloned().collect()).collect();
            blocks.extend(forms(&[self.position_header(language)], &headers(asked), &rows));
            blocks.iter_mut().for_each(|block| self.name_positions(block));
        }
        for (_, asked) in whole {
            blocks.extend(forms(&[], &headers(&asked), &[Vec::new()]));
        }
        blocks
    }

    /// Where the drives are, after the names of positions.
    fn name_positions(&self, block: &mut Block) {
        let Block::Form(table) = block else { return };
        for (row, drives) in table.rows.iter_mut().zip(&self.drives).filter(|(_, drives)| !drives.is_empty())
        {
            if let Some(name) = row.first_mut() {
                name.push(text(" ("));
                name.extend(drive_words(drives));
                name.push(text(")"));
            }
        }
    }

    /// The letters of a question with its unit, by component.
    fn headers(&self, asked: &SheetQuestion, own: &[Option<Node>], language: Language) -> Vec<Line> {
        let with_unit = |(_, letters, _): (String, Line, Option<usize>)| {
            letters.into_iter().flat_map(|letters| with_unit(letters, &asked.unit)).collect()
        };
        self.letters(asked, own, language).into_iter().map(with_unit).collect()
    }

    /// The letters of each item of `find`.
    pub(crate) fn own_letters(&self, language: Language) -> Vec<Option<Node>> {
        letters_of_all(self.mechanism, self.text, language)
    }

    /// The name of a question by component, with its letters, or its number where it has none, and its place. Items of `find` have their
    /// `own` letters.
    pub(crate) fn letters(
        &self,
        asked: &SheetQuestion,
        own: &[Option<Node>],
        language: Language,
    ) -> Vec<(String, Line, Option<usize>)> {
        let number = self.mechanism.finds.iter().position(|find| find.name == asked.name);
        let own = |part: &str| match number {
            Some(i) if !asked.vector => own[i].clone(),
            _ => letters(self.mechanism, &format!("{}{part}", asked.name), language),
        };
        let parts: &[&str] = if asked.vector { &[".x", ".y"] } else { &[""] };
        let of = |part: &&str| {
            let written = format!("{}{part}", asked.name);
            let words = || number.map_or_else(|| written.clone(), |i| format!("({}){part}", i + 1));
            let line = vec![own(part).map_or_else(|| text(words()), Inline::Math)];
            (written, line, number)
        };
        parts.iter().map(of).collect()
    }
}

/// A unit as it is printed, after a blank where it needs one.
#[must_use]
pub fn printed_unit(unit: &str) -> String {
    match unit {
        "" => String::new(),
        "deg" => "°".to_owned(),
        unit => format!(" {}", unit.replace('*', "·").replace("^2", "²").replace("^3", "³")),
    }
}

/// A text with units as they are printed: `N·m` for `N*m`.
fn typeset(words: &str) -> String {
    let letters: Vec<char> = words.chars().collect();
    let is_letter = |i: Option<usize>| i.and_then(|i| letters.get(i)).is_some_and(|c| c.is_alphabetic());
    let set = |(i, c): (usize, &char)| match c {
        '*' if is_letter(i.checked_sub(1)) && is_letter(Some(i + 1)) => '·',
        c => *c,
    };
    letters.iter().enumerate().map(set).collect()
}

fn is_whole(x: f64) -> bool {
    (x - x.round()).abs() < 1e-9
}

/// Whether a unit in a text is rather a letter of a formula, as in `√(2 h/g)`.
fn is_letter(unit: &str) -> bool {
    let first = unit.split(['/', '*']).next().unwrap_or_default();
    matches!(first, "h" | "t" | "g") || matches!(unit, "s/h" | "1/s")
}

/// The numbers of a text, each with the word behind it.
fn numbers_in(text: &str) -> Vec<(f64, &str)> {
    let words: Vec<&str> = text.split(|c: char| c.is_whitespace() || "(),;:=".contains(c)).collect();
    let next = words.iter().skip(1).copied().chain([""]);
    let found = words.iter().zip(next).filter_map(|(word, next)| {
        let word = word.trim_start_matches(|c: char| !c.is_ascii_digit()).trim_end_matches('.');
        let end = word.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(word.len());
        let unit = if end == word.len() { next.trim_end_matches('.') } else { &word[end..] };
        let number = word[..end].parse().ok().filter(|number| *number != 0.0)?;
        Some((number, unit))
    });
    found.collect()
}

/// Whether a number of a text is a value as it may be rounded.
fn is_within(value: f64, number: f64) -> bool {
    value != 0.0 && (value.abs() - number.abs()).abs() <= NEAR * value.abs()
}
