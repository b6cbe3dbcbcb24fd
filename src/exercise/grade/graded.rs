//! All answers marked, chosen and added up.

use super::mark::{GradedRow, Mark, NotCounted, Part, Sum};
use super::marker::Marker;
use super::rows::{Assignment, MissingAnswer};
use super::rules::{Rules, Submissions};
use super::sheet::{Quantity, Sheet, SheetRow};
use crate::exercise::table::{Fault, TableError};
use indexmap::{IndexMap, IndexSet};
use std::collections::BTreeSet;
use std::sync::Arc;

#[derive(Clone, Debug)]
pub struct Graded {
    /// The rules by which they are marked.
    pub rules: Rules,
    /// The quantities: those that are answered, in the units of the answers, then those of the key alone.
    pub quantities: Vec<Quantity>,
    /// Quantities with points that no column answers.
    pub unasked: Vec<String>,
    /// Rows that count, student by student; those that were not handed in have no line.
    pub rows: Vec<GradedRow>,
    /// Rows that do not count because the student handed in another.
    pub not_counted: Vec<NotCounted>,
    /// Rows of the key that were to be answered and were not, in words.
    pub unanswered: Vec<String>,
    /// Columns and lines of the answers that are not marked.
    pub left_out: Vec<Fault>,
    /// How many more lines are not marked.
    pub more_left_out: usize,
    /// Whether a column says who answered.
    pub persons: bool,
}

impl Graded {
    /// The sum of all marks.
    #[must_use]
    pub fn total(&self) -> Sum {
        Sum::of(self.rows.iter().flat_map(|row| &row.marks))
    }

    /// The quantity that a mark is of.
    #[must_use]
    pub fn quantity(&self, mark: &Mark) -> &Quantity {
        &self.quantities[mark.quantity as usize]
    }

    /// The sum of the marks for a quantity.
    #[must_use]
    pub fn total_of(&self, quantity: usize) -> Sum {
        Sum::of(self.rows.iter().flat_map(|row| &row.marks).filter(|m| m.quantity as usize == quantity))
    }

    /// What each student has, in the order of the answers; nothing where no column says who answered.
    pub fn students(&self) -> impl Iterator<Item = Part<'_>> {
        let rows = if self.persons { self.rows.as_slice() } else { &[] };
        rows.chunk_by(|a, b| a.person == b.person).map(|rows| Part {
            name: rows.first().and_then(|row| row.person.as_deref()),
            rows: rows.len(),
            sum: Sum::of(rows.iter().flat_map(|row| &row.marks)),
        })
    }

    /// What the answers to each problem come to; nothing where there is one.
    #[must_use]
    pub fn problems(&self) -> Vec<Part<'_>> {
        let mut parts: IndexMap<Option<&str>, Part<'_>> = IndexMap::new();
        for row in &self.rows {
            let name = row.names.each[0].as_deref();
            let part = parts.entry(name).or_insert(Part { name, rows: 0, sum: Sum::default() });
            part.rows += 1;
            part.sum.add(&row.marks);
        }
        if parts.len() > 1 { parts.into_values().collect() } else { Vec::new() }
    }

    /// The mean of the students' parts of their points; `None` where there are no students or no points.
    #[must_use]
    pub fn mean(&self) -> Option<f64> {
        let parts = self.students().filter_map(|student| student.sum.part());
        let (sum, count) =
            parts.fold((0.0, 0_u32), |(sum, count), part| (sum + part, count.saturating_add(1)));
        (count > 0).then(|| sum / f64::from(count))
    }

    /// Whether every answer that counts is right, and every line is marked.
    #[must_use]
    pub fn is_all_right(&self) -> bool {
        let total = self.total();
        total.right == total.total
            && self.more_left_out == 0
            && self.left_out.iter().all(|fault| is_column(&fault.1))
    }
}

/// A row of answers with its student, by the order of their first answers, and its row of the key.
struct Answered {
    student: usize,
    in_key: usize,
    row: GradedRow,
}

/// Marks answers by a key.
///
/// # Errors
/// No row of the answers is one of the key: why the first is not.
pub fn grade(key: &Sheet, mut answers: Sheet, rules: &Rules) -> Result<Graded, Fault> {
    let rows = std::mem::take(&mut answers.rows);
    if rows.iter().all(|row| row.in_key.is_none())
        && let Some(first) = answers.unknown.first()
    {
        return Err(first.clone());
    }
    let mut left_out = std::mem::take(&mut answers.left_out);
    left_out.append(&mut answers.unknown);
    let grading = Grading::new(key, &answers, rules);
    let mut students: IndexSet<Option<Arc<str>>> = IndexSet::new();
    if key.persons && answers.persons {
        students.extend(key.rows.iter().filter(|row| row.person.is_some()).map(|row| row.person.clone()));
    }
    let mut answered = Vec::with_capacity(rows.len());
    for row in rows {
        let Some(in_key) = row.in_key else {
            students.extend(row.person.is_some().then_some(row.person));
            continue;
        };
        let student = students.insert_full(row.person.clone()).0;
        answered.push(Answered { student, in_key, row: grading.answered(row, in_key) });
    }
    if !answered.is_sorted_by_key(|answered| answered.student) {
        answered.sort_by_key(|answered| answered.student);
    }
    let (mut rows, mut not_counted, mut unanswered) =
        (Vec::with_capacity(answered.len()), Vec::new(), Vec::new());
    let mut answered = answered.into_iter().peekable();
    for (student, person) in students.into_iter().enumerate() {
        let mut submissions: IndexMap<usize, Vec<GradedRow>> = IndexMap::new();
        while let Some(next) = answered.next_if(|next| next.student == student) {
            match submissions.get_mut(&next.in_key) {
                Some(lines) => lines.push(next.row),
                None => drop(submissions.insert(next.in_key, vec![next.row])),
            }
        }
        let handed_in: BTreeSet<usize> = submissions.keys().copied().collect();
        for lines in submissions.into_values() {
            let (counted, others) = choose(lines, rules.submissions);
            rows.extend(counted);
            not_counted.extend(others);
        }
        for row in grading.not_handed_in(person.as_ref(), &handed_in) {
            unanswered.push(row.words());
            rows.extend((!rules.only_answered).then_some(row));
        }
    }
    Ok(Graded {
        rules: rules.clone(),
        unasked: grading.unasked(),
        quantities: grading.quantities,
        rows,
        not_counted,
        unanswered,
        left_out,
        more_left_out: answers.more_left_out,
        persons: answers.persons,
    })
}

/// The line that counts, and those that do not.
fn choose(mut lines: Vec<GradedRow>, which: Submissions) -> (Option<GradedRow>, Vec<NotCounted>) {
    let points = |i: &usize| lines[*i].sum().points;
    let chosen = match which {
        Submissions::First => Some(0),
        Submissions::Last => lines.len().checked_sub(1),
        Submissions::Best => (0..lines.len()).max_by(|a, b| points(a).total_cmp(&points(b))),
    };
    let Some(chosen) = chosen.filter(|i| *i < lines.len()).map(|i| lines.remove(i)) else {
        return (None, Vec::new());
    };
    let counted = chosen.line.unwrap_or(0);
    (Some(chosen), lines.into_iter().map(|row| NotCounted { row, counted }).collect())
}

/// A key with answers to be marked.
struct Grading<'a> {
    key: &'a Sheet,
    answers: &'a Sheet,
    rules: &'a Rules,
    quantities: Vec<Quantity>,
    /// For each quantity its place in the key.
    places: Vec<usize>,
}

impl<'a> Grading<'a> {
    fn new(key: &'a Sheet, answers: &'a Sheet, rules: &'a Rules) -> Self {
        let mut quantities = answers.quantities.clone();
        // the columns of the answers are among those of the key
        let mut places: Vec<usize> =
            quantities.iter().filter_map(|q| key.place(&q.name, q.unit.dimension)).collect();
        for (place, quantity) in key.quantities.iter().enumerate() {
            if !places.contains(&place) {
                places.push(place);
                quantities.push(quantity.clone());
            }
        }
        Self { key, answers, rules, quantities, places }
    }

    fn marker(&self, index: usize) -> Marker<'a> {
        Marker { key: self.key, index, rules: self.rules }
    }

    /// A row of the answers.
    fn answered(&self, row: SheetRow, in_key: usize) -> GradedRow {
        let marker = self.marker(in_key);
        let mark =
            |(quantity, place): (usize, &usize)| marker.mark(quantity, *place, row.entries.get(quantity));
        let marks = self.places.iter().enumerate().filter_map(mark).collect();
        GradedRow { line: Some(row.line), names: row.names, person: row.person, marks }
    }

    /// The rows that a student was to hand in and did not, as far as they have points.
    fn not_handed_in(&self, person: Option<&Arc<str>>, answered: &BTreeSet<usize>) -> Vec<GradedRow> {
        let points = &self.rules.points;
        let assignment = Assignment { key: self.key, points, persons: self.answers.persons };
        let owed = assignment.missing(person, answered);
        let rows = owed.iter().flat_map(|owed| owed.rows.iter().map(move |row| (owed, *row)));
        rows.map(|(owed, row)| self.missing(person, owed, row)).filter(|row| !row.marks.is_empty()).collect()
    }

    fn missing(&self, person: Option<&Arc<str>>, owed: &MissingAnswer, index: usize) -> GradedRow {
        let names = &self.key.rows[index].names;
        // the key of another variant is not this student's
        let names = if owed.known { Arc::clone(names) } else { names.of_problem() };
        let rules = Rules { only_answered: false, ..self.rules.clone() };
        let marker = Marker { key: self.key, index, rules: &rules };
        let mark = |(quantity, place): (usize, &usize)| -> Option<Mark> {
            let mark = marker.mark(quantity, *place, None)?;
            Some(Mark { key: mark.key.get().filter(|_| owed.known).into(), ..mark })
        };
        let marks = self.places.iter().enumerate().filter_map(mark).collect();
        GradedRow { line: None, names, person: person.cloned(), marks }
    }

    /// Quantities of the key that no column answers, and that have points somewhere.
    fn unasked(&self) -> Vec<String> {
        let asked = |place: usize| {
            let has = |row| self.rules.points.of(self.key, row, place) > 0.0;
            self.key.rows.iter().any(has)
        };
        let others = self.places.iter().zip(&self.quantities).skip(self.answers.quantities.len());
        others.filter(|(place, _)| asked(**place)).map(|(_, quantity)| quantity.name.clone()).collect()
    }
}

// What is left out of the marking.

/// Whether it is a column, not a line.
fn is_column(error: &TableError) -> bool {
    matches!(error, TableError::Header { .. } | TableError::UnknownColumn { .. })
}

/// What is wrong, with the line: `line 7: the key has no row 99`.
#[must_use]
pub fn left_out_words(error: &TableError) -> String {
    match error {
        TableError::UnknownColumn { .. } => format!("header: {error}"),
        _ => error.to_string(),
    }
}
