//! Marks as tables to read.

use super::super::document::{Block, Column, Report, Section, Table};
use super::{DIGITS, Figures, hint, is_key_zero, percent, word};
use crate::exercise::grade::{Graded, GradedRow, LeftOut, Mark, Part, Submissions, Sum, Verdict};
use assur_text::units::significant;

/// Longer texts of others are cut, characters.
const LONGEST: usize = 60;

/// Tables to read: what is not right, sums per row, student, problem and quantity, what is not marked.
#[must_use]
pub fn report(graded: &Graded) -> Report {
    let total = graded.total();
    let title =
        format!("{}, {} points, within {}", right(total), points(total), percent(graded.rules.within));
    let mut report = Report { title, notes: notes(graded), ..Report::default() };
    let sections = [
        not_right(graded),
        per_row(graded),
        parts("Students", "student", &graded.students()),
        parts("Problems", "problem", &graded.problems()),
        per_quantity(graded),
        not_answered(graded),
        not_counted(graded),
        not_marked(graded),
    ];
    sections.into_iter().for_each(|s| report.section(s));
    report
}

/// `2 of 4 right`
fn right(sum: Sum) -> String {
    format!("{} of {} right", sum.right, sum.total)
}

/// `2.5 of 4`
fn points(sum: Sum) -> String {
    format!("{} of {}", significant(sum.points, DIGITS), significant(sum.possible, DIGITS))
}

/// A text of others, cut where it is long.
fn cut(text: &str) -> String {
    match text.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_owned(),
    }
}

/// The class, and the rules that are not the usual ones.
fn notes(graded: &Graded) -> Vec<String> {
    let rules = &graded.rules;
    let class = graded.mean().map(|mean| {
        let count = graded.students().len();
        let s = if count == 1 { "" } else { "s" };
        format!("{count} student{s}, {} of the points on average.", percent(mean))
    });
    let missing = rules.only_answered.then(|| "Missing answers are left out of the totals.".to_owned());
    let submissions = (rules.submissions != Submissions::Last && !graded.not_counted.is_empty())
        .then(|| format!("The {} submission of a row counts.", rules.submissions.name()));
    let credit: Vec<String> = rules.credit.parts().map(|(slip, part)| format!("{slip} {part}")).collect();
    let credit = (!credit.is_empty()).then(|| format!("Credit for slips: {}.", credit.join(", ")));
    class.into_iter().chain(missing).chain(submissions).chain(credit).collect()
}

fn not_right(graded: &Graded) -> Section {
    let mut table = Table::new(
        vec![
            Column::words("row"),
            Column::words("quantity"),
            Column::right("given"),
            Column::right("key"),
            Column::words("unit"),
            Column::right("off by"),
            Column::right("points"),
            Column::words("verdict"),
        ],
        2,
    );
    // rows that were not handed in have a list of their own
    for row in graded.rows.iter().filter(|row| row.line.is_some()) {
        for mark in row.marks.iter().filter(|m| m.verdict != Verdict::Right) {
            table.row(cells(graded, row, mark));
        }
    }
    let mut section = Section::new("Not right");
    section.table(table);
    section
}

fn cells(graded: &Graded, row: &GradedRow, mark: &Mark) -> Vec<String> {
    let quantity = &graded.quantities[mark.quantity];
    let Figures { given, key, deviation } = Figures::of(graded, mark);
    let hint = hint(mark);
    let verdict = word(&mark.verdict);
    let verdict = if hint.is_empty() { verdict.to_owned() } else { format!("{verdict}: {hint}") };
    let off = if is_key_zero(mark) { deviation } else { mark.error.map(percent).unwrap_or_default() };
    let sum = Sum::of([mark]);
    let earned = if mark.counts { points(sum) } else { String::new() };
    let (name, unit) = (quantity.name.clone(), quantity.unit.text.clone());
    vec![cut(&row.words()), name, cut(&given), key, unit, off, earned, verdict]
}

fn per_row(graded: &Graded) -> Section {
    let mut table = Table::of_words(&["row", "right", "points"]);
    for row in &graded.rows {
        let sum = row.sum();
        table.row(vec![cut(&row.words()), format!("{} of {}", sum.right, sum.total), points(sum)]);
    }
    Section { heading: "Rows".to_owned(), blocks: vec![Block::Table(table)] }
}

fn parts(heading: &str, what: &str, parts: &[Part]) -> Section {
    let mut table = Table::of_words(&[what, "rows", "right", "points", "part"]);
    for part in parts {
        let sum = part.sum;
        let name = part.name.as_deref().map(cut).unwrap_or_default();
        let share = sum.part().map(percent).unwrap_or_default();
        let right = format!("{} of {}", sum.right, sum.total);
        table.row(vec![name, part.rows.to_string(), right, points(sum), share]);
    }
    let mut section = Section::new(heading);
    section.table(table);
    section
}

fn per_quantity(graded: &Graded) -> Section {
    let mut table = Table::of_words(&["quantity", "right", "points"]);
    for (i, quantity) in graded.quantities.iter().enumerate() {
        let sum = graded.total_of(i);
        if sum.total == 0 {
            continue;
        }
        table.row(vec![quantity.name.clone(), format!("{} of {}", sum.right, sum.total), points(sum)]);
    }
    Section { heading: "Quantities".to_owned(), blocks: vec![Block::Table(table)] }
}

fn not_answered(graded: &Graded) -> Section {
    let mut section = Section::new("Not answered");
    let who = if graded.persons { "" } else { "nobody answered " };
    section.list(graded.unanswered.iter().map(|row| format!("{who}{}", cut(row))).collect());
    if !graded.unasked.is_empty() {
        section.text(format!("No column answers {}.", graded.unasked.join(", ")));
    }
    if !section.blocks.is_empty() && !graded.rules.only_answered {
        section.text("These count as wrong. `--only-answered` leaves out what is missing.");
        if !graded.unasked.is_empty() {
            let asked = graded.quantities.first().map_or("Mb", |q| q.name.as_str());
            section.text(format!("`--points '{asked}=1,*=0'` asks for {asked} alone."));
        }
    }
    section
}

fn not_counted(graded: &Graded) -> Section {
    let mut section = Section::new("Not counted");
    let words = |row: &GradedRow, counted: usize| {
        let line = row.line.unwrap_or(0);
        format!("line {line}, {}: {} points; line {counted} counts", cut(&row.words()), points(row.sum()))
    };
    section.list(graded.not_counted.iter().map(|aside| words(&aside.row, aside.counted)).collect());
    section
}

fn not_marked(graded: &Graded) -> Section {
    let mut section = Section::new("Not marked");
    let words = |error| {
        let words = LeftOut::words(error);
        words.chars().take(4 * LONGEST).collect()
    };
    section.list(graded.left_out.iter().map(|(_, error)| words(error)).collect());
    section
}
