//! Which position of a row a cell belongs to: what a row has once is read from any of its lines.

use super::rows::FoundRow;
use super::sheet::{Entry, Sheet, SheetRow, keep};
use crate::exercise::table::Fault;
use indexmap::IndexMap;
use std::collections::HashMap;
use std::mem::take;
use std::sync::Arc;

/// Two numbers for one question that differ by more than this part are two answers.
const SAME: f64 = 0.03;

/// Where a quantity of a row of a problem is asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Home {
    Nowhere,
    /// In that line of the key.
    One(usize),
    /// The number of lines of the key that have it.
    Each(usize),
}

/// The lines of a key that are positions of one row, for rows with several.
#[derive(Clone, Debug, Default)]
pub(super) struct Positions {
    /// Of each line the row that it belongs to; none where it is the only one.
    row: Vec<Option<usize>>,
    /// Of each row the homes of its quantities.
    homes: Vec<Box<[Home]>>,
}

impl Positions {
    /// Those of a key. What a row has once is then known in each of its lines.
    pub fn of(lines: &mut [SheetRow]) -> Self {
        let mut rows: IndexMap<_, Vec<usize>> = IndexMap::new();
        for (i, line) in lines.iter().enumerate() {
            let [file, row, variant, _] = line.names.each.clone();
            rows.entry((file, row, variant, line.person.clone())).or_default().push(i);
        }
        let mut positions = Self { row: vec![None; lines.len()], homes: Vec::new() };
        for of in rows.into_values().filter(|of| of.len() > 1) {
            let quantities = lines[of[0]].entries.len();
            let homes: Box<[Home]> = (0..quantities).map(|place| home(lines, &of, place)).collect();
            for i in of {
                positions.row[i] = Some(positions.homes.len());
                for (place, home) in homes.iter().enumerate() {
                    if let Home::One(from) = *home {
                        lines[i].entries[place] = lines[from].entries[place].clone();
                    }
                }
            }
            positions.homes.push(homes);
        }
        positions
    }

    pub fn home(&self, line: usize, place: usize) -> Home {
        match self.row.get(line) {
            Some(Some(row)) => self.homes[*row][place],
            _ => Home::One(line),
        }
    }

    /// Whether a quantity is asked in this line of the key.
    pub fn is_asked(&self, line: usize, place: usize) -> bool {
        !matches!(self.home(line, place), Home::One(home) if home != line)
    }

    /// Whether all of these lines are positions of one row.
    pub fn are_one_row(&self, lines: &[usize]) -> bool {
        let row = |line: &usize| self.row.get(*line).copied().flatten();
        lines.first().and_then(row).is_some_and(|one| lines.iter().all(|line| row(line) == Some(one)))
    }
}

fn home(lines: &[SheetRow], of: &[usize], place: usize) -> Home {
    let mut found = of.iter().filter(|i| lines[**i].entries[place] != Entry::Empty);
    match (found.next(), found.count()) {
        (None, _) => Home::Nowhere,
        (Some(one), 0) => Home::One(*one),
        (Some(_), more) => Home::Each(more.saturating_add(1)),
    }
}

/// The last row of answers of each student for each line of the key, and whether it has only what is read from any line.
pub(super) type Latest = HashMap<(Option<Arc<str>>, usize), (usize, bool)>;

/// A line of answers with its line of the key, and the message for one that is not marked.
pub(super) struct Placed<'a> {
    pub row: SheetRow,
    pub found: FoundRow,
    pub fault: &'a dyn Fn(String, String) -> Fault,
}

impl Sheet {
    /// Puts the cells of a line of answers where they belong.
    pub(super) fn put(&mut self, key: &Self, latest: &mut Latest, placed: Placed<'_>) {
        let Placed { mut row, found, fault } = placed;
        if key.positions.homes.is_empty() {
            self.rows.push(row);
            return;
        }
        let mut moved: IndexMap<usize, Box<[Entry]>> = IndexMap::new();
        let mut open = None;
        for (quantity, entry) in row.entries.iter_mut().enumerate().filter(|(_, e)| **e != Entry::Empty) {
            let of = &self.quantities[quantity];
            let Some(place) = key.place(&of.name, of.unit.dimension) else { continue };
            match key.positions.home(found.index, place) {
                Home::One(home) if home != found.index => {
                    let empty = || vec![Entry::Empty; self.quantities.len()].into_boxed_slice();
                    moved.entry(home).or_insert_with(empty)[quantity] = take(entry);
                }
                Home::Each(count) if found.any_position => {
                    *entry = Entry::Empty;
                    open = open.or_else(|| Some((of.name.clone(), count)));
                }
                _ => {}
            }
        }
        if let Some((name, count)) = &open {
            let why = format!("`{name}` has {count} positions, and nothing says which one this is");
            let help = if self.named[3] { "write the pose into this row" } else { "add a column `pose`" };
            keep(&mut self.unknown, fault(why, help.to_owned()), &mut self.more_left_out);
        }
        let is_left = row.entries.iter().any(|entry| *entry != Entry::Empty);
        let others = moved.into_iter().map(|(home, entries)| {
            let names = Arc::clone(&key.rows[home].names);
            SheetRow { names, entries, in_key: Some(home), person: row.person.clone(), ..row }
        });
        let others: Vec<SheetRow> = others.collect();
        if is_left || others.is_empty() && open.is_none() {
            self.join(latest, row, (found.any_position, found.any_position), fault);
        } else if others.is_empty() {
            self.rows.push(SheetRow { entries: Box::default(), in_key: None, ..row });
        }
        for other in others {
            self.join(latest, other, (true, found.any_position), fault);
        }
    }

    /// Adds a row of answers, or its cells to those of the same place. A `part` of a row has only what is read from any line;
    /// what differs in it is an answer that is handed in `again`, or a slip.
    fn join(
        &mut self,
        latest: &mut Latest,
        mut row: SheetRow,
        (part, again): (bool, bool),
        fault: &dyn Fn(String, String) -> Fault,
    ) {
        let at = (row.person.clone(), row.in_key.unwrap_or_default());
        let known = latest.get(&at).copied().filter(|(_, was_part)| part || *was_part);
        let Some((index, was_part)) = known else {
            latest.insert(at, (self.rows.len(), part));
            self.rows.push(row);
            return;
        };
        let both = self.rows[index].entries.iter().zip(&row.entries);
        let differ = both.clone().position(|(old, new)| !is_same(old, new));
        if differ.is_some() && again {
            for (old, new) in self.rows[index].entries.iter().zip(&mut row.entries) {
                if *new == Entry::Empty {
                    new.clone_from(old);
                }
            }
            latest.insert(at, (self.rows.len(), was_part));
            self.rows.push(row);
            return;
        }
        if let Some(quantity) = differ {
            let name = &self.quantities[quantity].name;
            let why = format!("`{name}` is answered otherwise in line {}", self.rows[index].line);
            let help = "it is asked once: the first answer counts".to_owned();
            keep(&mut self.left_out, fault(why, help), &mut self.more_left_out);
        }
        for (old, new) in self.rows[index].entries.iter_mut().zip(row.entries) {
            if *old == Entry::Empty {
                *old = new;
            }
        }
        latest.insert(at, (index, was_part && part));
    }
}

/// Whether two cells do not contradict each other.
fn is_same(one: &Entry, other: &Entry) -> bool {
    match (one, other) {
        (Entry::Empty, _) | (_, Entry::Empty) => true,
        (Entry::Number(a), Entry::Number(b)) => (a - b).abs() <= SAME * a.abs().max(b.abs()),
        (one, other) => one == other,
    }
}
