//! Marks as tables to read.

use super::super::document::{Block, Column, Report, Section, Table};
use super::{DIGITS, Figures, hint, is_key_zero, percent, word};
use crate::exercise::grade::{Graded, GradedRow, Mark, Part, Submissions, Sum, Verdict, cut, left_out_words};
use assur_text::units::significant;

/// Longer reasons are cut, characters.
const LONGEST: usize = 240;
/// Rows of one table; longer tables are printed in parts, so that no class is in memory as text.
const IN_PART: usize = 10_000;

/// Tables to read, as parts of one report in their order: what is not right, sums per row, student, problem and
/// quantity, what is not marked.
pub fn reports(graded: &Graded) -> impl Iterator<Item = Report> {
    let total = graded.total();
    let title =
        format!("{}, {} points, within {}", right(total), points(total), percent(graded.rules.within));
    let head = Report { title, notes: notes(graded), ..Report::default() };
    let sections = not_right(graded)
        .chain(per_row(graded))
        .chain(parts("Students", "student", graded.students()))
        .chain(parts("Problems", "problem", graded.problems().into_iter()))
        .chain([per_quantity(graded), not_answered(graded), not_counted(graded), not_marked(graded)]);
    let sections = sections.filter(|section| !section.blocks.is_empty());
    std::iter::once(head)
        .chain(sections.map(|section| Report { sections: vec![section], ..Report::default() }))
}

/// A table in parts, the first with the heading.
fn in_parts(
    heading: &'static str,
    table: Table,
    rows: impl Iterator<Item = Vec<String>>,
) -> impl Iterator<Item = Section> {
    let (mut rows, mut heading) = (rows.peekable(), Some(heading));
    std::iter::from_fn(move || {
        rows.peek()?;
        let mut part = table.clone();
        rows.by_ref().take(IN_PART).for_each(|row| part.row(row));
        let mut section = Section::new(heading.take().unwrap_or_default());
        section.table(part);
        Some(section)
    })
}

/// `2 of 4 right`
fn right(sum: Sum) -> String {
    format!("{} of {} right", sum.right, sum.total)
}

/// `2.5 of 4`
fn points(sum: Sum) -> String {
    format!("{} of {}", significant(sum.points, DIGITS), significant(sum.possible, DIGITS))
}

/// The class, and the rules that are not the usual ones.
fn notes(graded: &Graded) -> Vec<String> {
    let rules = &graded.rules;
    let class = graded.mean().map(|mean| {
        let count = graded.students().count();
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

fn not_right(graded: &Graded) -> impl Iterator<Item = Section> {
    let table = Table::new(
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
    let rows = graded.rows.iter().filter(|row| row.line.is_some());
    let marks = rows.flat_map(|row| row.marks.iter().map(move |mark| (row, mark)));
    let wrong = marks.filter(|(_, mark)| mark.verdict != Verdict::Right);
    in_parts("Not right", table, wrong.map(|(row, mark)| cells(graded, row, mark)))
}

fn cells(graded: &Graded, row: &GradedRow, mark: &Mark) -> Vec<String> {
    let quantity = graded.quantity(mark);
    let Figures { given, key, deviation } = Figures::of(graded, mark);
    let hint = hint(mark);
    let verdict = word(&mark.verdict);
    let verdict = if hint.is_empty() { verdict.to_owned() } else { format!("{verdict}: {hint}") };
    let off = if is_key_zero(mark) { deviation } else { mark.error.get().map(percent).unwrap_or_default() };
    let sum = Sum::of([mark]);
    let earned = if mark.counts { points(sum) } else { String::new() };
    let (name, unit) = (quantity.name.clone(), quantity.unit.text.clone());
    vec![row.words(), name, cut(&given), key, unit, off, earned, verdict]
}

fn per_row(graded: &Graded) -> impl Iterator<Item = Section> {
    let cells = |row: &GradedRow| {
        let sum = row.sum();
        vec![row.words(), format!("{} of {}", sum.right, sum.total), points(sum)]
    };
    in_parts("Rows", Table::of_words(&["row", "right", "points"]), graded.rows.iter().map(cells))
}

fn parts<'a>(
    heading: &'static str,
    what: &str,
    parts: impl Iterator<Item = Part<'a>>,
) -> impl Iterator<Item = Section> {
    let cells = |Part { name, rows, sum }: Part<'_>| {
        let share = sum.part().map(percent).unwrap_or_default();
        let right = format!("{} of {}", sum.right, sum.total);
        vec![name.unwrap_or_default().to_owned(), rows.to_string(), right, points(sum), share]
    };
    in_parts(heading, Table::of_words(&[what, "rows", "right", "points", "part"]), parts.map(cells))
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
    section.list(graded.unanswered.iter().map(|row| format!("{who}{row}")).collect());
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
        format!("line {line}, {}: {} points; line {counted} counts", row.words(), points(row.sum()))
    };
    section.list(graded.not_counted.iter().map(|aside| words(&aside.row, aside.counted)).collect());
    section
}

fn not_marked(graded: &Graded) -> Section {
    let mut section = Section::new("Not marked");
    let words = |error| {
        let words = left_out_words(error);
        words.chars().take(LONGEST).collect()
    };
    let more = (graded.more_left_out > 0).then(|| super::more_lines(graded.more_left_out));
    section.list(graded.left_out.iter().map(|(_, error)| words(error)).chain(more).collect());
    section
}
