//! What a solution has beside the position that is worked out: all positions, quantities of the cycle, cams, gears, flywheels,
//! expectations, as tables and plots.

use crate::pipeline::Solved;
use crate::report::document::{Align, Block as Printed, Section, Table as Rows};
use crate::report::{self, AccuracyShown, OF_CYCLE, OF_MOTION, PrintedDigits};
use assur_drawing::{Drawing, Theme};
use assur_formula::unit_words;
use assur_model::model::Mechanism;
use assur_picture::{Kind, Options, Scene, Subject};
use assur_text::source::Source;
use assur_worked::{
    Block, Figure, Inline, Language, Table, drawing_in, drawn_for_paper, localised, written_in_letters,
};

/// The most rows of a table that are printed; of longer ones some over all of it.
const ROWS: usize = 37;
/// Pictures of a sweep.
const PICTURES: [Kind; 4] = [Kind::Plot, Kind::Work, Kind::Cam, Kind::Train];

/// The sections, for behind the last of a solution; all of them where no position is worked out.
pub fn blocks(source: &Source, solved: &Solved, scene: Option<&Scene<'_>>, language: Language) -> Vec<Block> {
    let report =
        report::of_answers(&source.name, &solved.answers(PrintedDigits::READABLE), AccuracyShown::Worst);
    let one = solved.solution.poses.len() == 1;
    let kept = |section: &&Section| {
        let heading = section.heading.as_str();
        let of_position = ["Answers", "Reactions", "Friction"].iter().any(|h| heading.starts_with(h));
        let repeated = ["Structure", "Accuracy", "Events"].iter().any(|h| heading.starts_with(h));
        scene.is_none() || !(repeated || one && of_position)
    };
    let mut blocks: Vec<Block> = report.sections.iter().filter(kept).flat_map(|s| section(s, ROWS)).collect();
    // the table of results has what is of all positions
    blocks.retain(|block| scene.is_none() || !is_of_all(block));
    let published = super::published::section(&solved.outcomes);
    blocks.extend(published.iter().flat_map(|s| section(s, usize::MAX)));
    let blocks = localised(language, blocks.into_iter().map(|block| with_units(block, language)).collect());
    let mechanism = &solved.compiled.mechanism;
    let blocks = blocks.into_iter().map(|block| with_letters(block, mechanism, language));
    let mut blocks: Vec<Block> = blocks.collect();
    let subject = scene
        .map_or_else(|| Subject::without_position(mechanism, &solved.solution, &source.name), Subject::from);
    let designs: &[Kind] = if scene.is_none() { &[Kind::Gears, Kind::Elements] } else { &[] };
    for picture in PICTURES.iter().chain(designs).map(|kind| pictures(subject, *kind, language)) {
        if !picture.is_empty() {
            blocks.push(Block::Figures(picture));
        }
    }
    blocks
}

/// Whether a table has numbers of the whole cycle or motion.
fn is_of_all(block: &Block) -> bool {
    let Block::Table(table) = block else { return false };
    let first = table.headers.first().and_then(|head| head.first());
    matches!(first, Some(Inline::Text(words)) if [OF_MOTION, OF_CYCLE].contains(&words.as_str()))
}

/// Headers that name what is asked for, in letters.
fn with_letters(block: Block, mechanism: &Mechanism, language: Language) -> Block {
    let Block::Table(table) = block else { return block };
    let header = |line: Vec<Inline>| {
        let [Inline::Text(words)] = line.as_slice() else { return line };
        let (name, unit) =
            words.rsplit_once(" [").map_or((&**words, None), |(name, unit)| (name, Some(unit)));
        if !mechanism.finds.iter().any(|find| find.name == name) {
            return line;
        }
        let Some(mut letters) = written_in_letters(mechanism, name, language) else { return line };
        letters.extend(unit.map(|unit| Inline::Text(format!(" [{unit}"))));
        letters
    };
    Block::Table(Table { headers: table.headers.into_iter().map(header).collect(), ..table })
}

/// Units of a table as formulas have them.
fn with_units(block: Block, language: Language) -> Block {
    let line = |words: &dyn Fn(&str) -> String, line: Vec<Inline>| -> Vec<Inline> {
        let part = |part: Inline| match part {
            Inline::Text(own) => Inline::Text(words(&own)),
            part => part,
        };
        line.into_iter().map(part).collect()
    };
    let Block::Table(table) = block else { return block };
    let is_unit =
        |header: &Vec<Inline>| matches!(header.as_slice(), [Inline::Text(words)] if words == "unit");
    let units = table.headers.iter().position(is_unit);
    let cell = |(i, cell): (usize, Vec<Inline>)| {
        if Some(i) == units {
            line(&|unit| language.unit(&unit_words(unit)), cell)
        } else {
            line(&of_cell, cell)
        }
    };
    let rows = table.rows.into_iter().map(|row| row.into_iter().enumerate().map(cell).collect()).collect();
    let headers = table.headers.into_iter().map(|cell| line(&in_brackets, cell)).collect();
    Block::Table(Table { headers, rows, numbers: table.numbers })
}

/// `M [N*m]` → M [N·m]
fn in_brackets(header: &str) -> String {
    match header.rsplit_once(" [") {
        Some((name, unit)) => format!("{name} [{}", unit_words(unit)),
        None => header.to_owned(),
    }
}

/// A number with its unit: all that letters, `*`, `/` and powers make.
fn of_cell(words: &str) -> String {
    let is_unit = |unit: &str| {
        !unit.is_empty()
            && unit
                .split(['*', '/'])
                .all(|one| one.trim_end_matches("^2").trim_end_matches("^3").chars().all(char::is_alphabetic))
    };
    let is_number = |x: &str| x.starts_with(|c: char| c.is_ascii_digit() || "−(-".contains(c));
    match words.rsplit_once(' ') {
        Some((number, unit)) if is_number(number) && is_unit(unit) => {
            format!("{number} {}", unit_words(unit))
        }
        _ => words.to_owned(),
    }
}

fn section(section: &Section, most: usize) -> Vec<Block> {
    let text = |words: &str| vec![Inline::Text(words.to_owned())];
    let mut blocks = vec![Block::Heading(3, section.heading.clone())];
    for block in &section.blocks {
        match block {
            Printed::Text(words) => blocks.push(Block::Paragraph(text(words))),
            Printed::List(items) => blocks.extend(items.iter().map(|item| Block::Paragraph(text(item)))),
            Printed::Facts(facts) => {
                blocks.extend(
                    facts.iter().map(|(name, fact)| Block::Paragraph(text(&format!("{name}: {fact}")))),
                );
            }
            Printed::Table(rows) => blocks.push(Block::Table(table(rows, most))),
        }
    }
    blocks
}

/// A table without columns that have nothing, as that of events at the printed instants.
fn table(rows: &Rows, most: usize) -> Table {
    let empty = |i: usize| {
        !rows.rows.is_empty() && rows.rows.iter().all(|row| row.get(i).is_none_or(String::is_empty))
    };
    let kept: Vec<usize> = (0..rows.columns.len()).filter(|i| !empty(*i)).collect();
    let rows = &Rows {
        columns: kept.iter().map(|i| rows.columns[*i].clone()).collect(),
        rows: rows
            .rows
            .iter()
            .map(|row| kept.iter().filter_map(|i| row.get(*i).cloned()).collect())
            .collect(),
        keys: rows.keys,
    };
    let text = |words: &String| vec![Inline::Text(words.replace('-', "−"))];
    let plain = |words: &String| vec![Inline::Text(words.clone())];
    let numbers = rows.columns.iter().enumerate().filter(|(_, c)| c.align != Align::Left).map(|(i, _)| i);
    let numbers: Vec<usize> = numbers.collect();
    let step = rows.rows.len().div_ceil(most).max(1);
    let cells = |row: &Vec<String>| {
        row.iter().enumerate().map(|(i, c)| if numbers.contains(&i) { text(c) } else { plain(c) }).collect()
    };
    Table {
        headers: rows.columns.iter().map(|c| plain(&c.header)).collect(),
        rows: rows.rows.iter().step_by(step).map(cells).collect(),
        numbers,
    }
}

fn pictures(subject: Subject<'_, '_>, kind: Kind, language: Language) -> Vec<Figure> {
    let drawings = drawn_for_paper(kind, subject, &Options::default()).into_iter();
    let figure = |drawing: Drawing| {
        let drawing = drawing_in(language, subject.mechanism, drawing);
        let (name, caption) = (kind.name().to_owned(), drawing.title.clone());
        Figure { svg: drawing.placed().svg(Theme::Auto), name, caption }
    };
    drawings.map(figure).collect()
}
