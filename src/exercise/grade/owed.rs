//! What a student was to hand in: which rows of the key.

use super::rules::Points;
use super::sheet::{Sheet, SheetRow};
use std::collections::BTreeSet;
use std::sync::Arc;

/// Rows of the key that a student was to answer and did not.
pub(super) struct Owed {
    pub rows: Vec<usize>,
    /// Whether these are the student's own rows; else nothing tells which variant is, and these stand for it.
    pub known: bool,
}

/// The key, and whether the answers are those of several students.
pub(super) struct Assignment<'a> {
    pub key: &'a Sheet,
    pub points: &'a Points,
    /// A column of the answers says who answered.
    pub persons: bool,
}

impl Assignment<'_> {
    /// What a student did not hand in. Where the key names students, a student's rows are those with the name; where the
    /// answers name no students, all of the key; else all positions of the variants that were answered, and one variant
    /// of every problem that was not.
    pub fn missing(&self, person: Option<&Arc<str>>, answered: &BTreeSet<usize>) -> Vec<Owed> {
        let all = 0..self.key.rows.len();
        let rows: Vec<usize> = match (self.key.persons, self.persons) {
            (true, true) => all.filter(|i| self.key.rows[*i].person.as_ref() == person).collect(),
            (_, false) => all.collect(),
            (false, true) => return self.of_variants(answered),
        };
        let rows = rows.into_iter().filter(|i| !answered.contains(i)).collect();
        vec![Owed { rows, known: true }]
    }

    fn of_variants(&self, answered: &BTreeSet<usize>) -> Vec<Owed> {
        let variant = |i: usize| &self.key.rows[i].names.each[..3];
        let is_own = |i: &usize| answered.iter().any(|a| variant(*a) == variant(*i));
        let of_own = (0..self.key.rows.len()).filter(|i| is_own(i) && !answered.contains(i)).collect();
        let mut owed = vec![Owed { rows: of_own, known: true }];
        let is_answered =
            |file: &Option<String>| answered.iter().any(|a| self.key.rows[*a].names.each[0] == *file);
        let mut left: Vec<&Option<String>> = Vec::new();
        for row in &self.key.rows {
            let file = &row.names.each[0];
            if !is_answered(file) && !left.contains(&file) {
                left.push(file);
                owed.push(self.variant_of(file, answered));
            }
        }
        owed
    }

    /// The variant of a problem that a student left out: the one that all answers to other problems are of, or the only
    /// one; else the one of the fewest points stands for it.
    fn variant_of(&self, file: &Option<String>, answered: &BTreeSet<usize>) -> Owed {
        let variant = |row: &SheetRow| row.names.each[1..3].to_vec();
        let mut variants: Vec<(Vec<Option<String>>, Vec<usize>)> = Vec::new();
        for (i, row) in self.key.rows.iter().enumerate().filter(|(_, row)| row.names.each[0] == *file) {
            let names = variant(row);
            match variants.iter_mut().find(|(known, _)| *known == names) {
                Some((_, rows)) => rows.push(i),
                None => variants.push((names, vec![i])),
            }
        }
        if let [(_, rows)] = variants.as_slice() {
            return Owed { rows: rows.clone(), known: true };
        }
        let mut own: Vec<_> = answered.iter().map(|a| variant(&self.key.rows[*a])).collect();
        own.sort();
        own.dedup();
        if let [own] = own.as_slice()
            && let Some((_, rows)) = variants.iter().find(|(names, _)| names == own)
        {
            return Owed { rows: rows.clone(), known: true };
        }
        let points = |rows: &[usize]| rows.iter().map(|i| self.points_of(*i)).sum::<f64>();
        let least = variants.into_iter().map(|(_, rows)| rows).min_by(|a, b| points(a).total_cmp(&points(b)));
        Owed { rows: least.unwrap_or_default(), known: false }
    }

    fn points_of(&self, index: usize) -> f64 {
        let row = &self.key.rows[index];
        let asked = (0..row.entries.len()).filter(|place| row.entries[*place] != super::entry::Entry::Empty);
        asked.map(|place| self.points.of(self.key, row, place)).sum()
    }
}
