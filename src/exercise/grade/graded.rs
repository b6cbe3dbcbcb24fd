//! All answers marked, chosen and added up.

use super::mark::{GradedRow, Mark, NotCounted, Part, Sum};
use super::marker::Marker;
use super::owed::{Assignment, Owed};
use super::rows::find;
use super::rules::{Rules, Submissions};
use super::sheet::{Quantity, Sheet};
use super::warning::LeftOut;
use crate::exercise::table::Fault;
use indexmap::IndexMap;

/// All answers.
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
    /// Whether a column says who answered.
    pub persons: bool,
}

impl Graded {
    /// The sum of all marks.
    #[must_use]
    pub fn total(&self) -> Sum {
        Sum::of(self.rows.iter().flat_map(|row| &row.marks))
    }

    /// The sum of the marks for a quantity.
    #[must_use]
    pub fn total_of(&self, quantity: usize) -> Sum {
        Sum::of(self.rows.iter().flat_map(|row| &row.marks).filter(|m| m.quantity == quantity))
    }

    /// What each student has, in the order of the answers; nothing where no column says who answered.
    #[must_use]
    pub fn students(&self) -> Vec<Part> {
        if self.persons { self.parts(|row| row.person.as_ref()) } else { Vec::new() }
    }

    /// What the answers to each problem come to; nothing where there is one.
    #[must_use]
    pub fn problems(&self) -> Vec<Part> {
        let parts = self.parts(|row| row.names[0].as_ref());
        if parts.len() > 1 { parts } else { Vec::new() }
    }

    fn parts<'a>(&'a self, name: impl Fn(&'a GradedRow) -> Option<&'a String>) -> Vec<Part> {
        let mut parts: IndexMap<Option<&String>, Vec<&GradedRow>> = IndexMap::new();
        self.rows.iter().for_each(|row| parts.entry(name(row)).or_default().push(row));
        let part = |(name, rows): (Option<&String>, Vec<&GradedRow>)| Part {
            name: name.cloned(),
            rows: rows.len(),
            sum: Sum::of(rows.iter().flat_map(|row| &row.marks)),
        };
        parts.into_iter().map(part).collect()
    }

    /// The mean of the students' parts of their points; `None` where there are no students or no points.
    #[must_use]
    pub fn mean(&self) -> Option<f64> {
        let parts: Vec<f64> = self.students().iter().filter_map(|student| student.sum.part()).collect();
        let count = u32::try_from(parts.len()).ok().filter(|n| *n > 0)?;
        Some(parts.iter().sum::<f64>() / f64::from(count))
    }

    /// Whether every answer that counts is right, and every line is marked.
    #[must_use]
    pub fn is_all_right(&self) -> bool {
        let total = self.total();
        total.right == total.total && self.left_out.iter().all(|fault| LeftOut::is_column(&fault.1))
    }
}

/// Marks answers by a key.
///
/// # Errors
/// No row of the answers is one of the key: why the first is not.
pub fn grade(key: &Sheet, answers: &Sheet, rules: &Rules) -> Result<Graded, Fault> {
    let grading = Grading::new(key, answers, rules);
    let mut left_out = answers.left_out.clone();
    let mut students: IndexMap<Option<String>, IndexMap<usize, Vec<GradedRow>>> = IndexMap::new();
    if key.persons && answers.persons {
        for row in key.rows.iter().filter(|row| row.person.is_some()) {
            students.entry(row.person.clone()).or_default();
        }
    }
    let mut unknown = Vec::new();
    for (i, row) in answers.rows.iter().enumerate() {
        match find(key, answers, row) {
            Ok(found) => {
                let rows = students.entry(row.person.clone()).or_default().entry(found).or_default();
                rows.push(grading.answered(i, found));
            }
            Err(fault) => {
                if row.person.is_some() {
                    students.entry(row.person.clone()).or_default();
                }
                unknown.push(fault);
            }
        }
    }
    if unknown.len() == answers.rows.len()
        && let Some(first) = unknown.first()
    {
        return Err(first.clone());
    }
    left_out.append(&mut unknown);
    let (mut rows, mut not_counted, mut unanswered) = (Vec::new(), Vec::new(), Vec::new());
    for (person, submissions) in students {
        let answered: Vec<usize> = submissions.keys().copied().collect();
        for lines in submissions.into_values() {
            let (counted, others) = choose(lines, rules.submissions);
            rows.extend(counted);
            not_counted.extend(others);
        }
        for row in grading.not_handed_in(person.as_ref(), &answered) {
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
    fn answered(&self, row: usize, found: usize) -> GradedRow {
        let (row, in_key) = (&self.answers.rows[row], &self.key.rows[found]);
        let marker = self.marker(found);
        let mark =
            |(quantity, place): (usize, &usize)| marker.mark(quantity, *place, row.entries.get(quantity));
        GradedRow {
            line: Some(row.line),
            names: std::array::from_fn(|i| in_key.names[i].clone().or_else(|| row.names[i].clone())),
            person: row.person.clone(),
            marks: self.places.iter().enumerate().filter_map(mark).collect(),
        }
    }

    /// The rows that a student was to hand in and did not, as far as they have points.
    fn not_handed_in(&self, person: Option<&String>, answered: &[usize]) -> Vec<GradedRow> {
        let points = &self.rules.points;
        let assignment = Assignment { key: self.key, points, persons: self.answers.persons };
        let owed = assignment.missing(person, answered);
        let rows = owed.iter().flat_map(|owed| owed.rows.iter().map(move |row| (owed, *row)));
        rows.map(|(owed, row)| self.missing(person, owed, row)).filter(|row| !row.marks.is_empty()).collect()
    }

    fn missing(&self, person: Option<&String>, owed: &Owed, index: usize) -> GradedRow {
        let names = &self.key.rows[index].names;
        // the key of another variant is not this student's
        let names = if owed.known { names.clone() } else { [names[0].clone(), None, None, names[3].clone()] };
        let rules = Rules { only_answered: false, ..self.rules.clone() };
        let marker = Marker { key: self.key, index, rules: &rules };
        let mark = |(quantity, place): (usize, &usize)| -> Option<Mark> {
            let mark = marker.mark(quantity, *place, None)?;
            Some(Mark { key: mark.key.filter(|_| owed.known), ..mark })
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
