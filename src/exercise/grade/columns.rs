//! What the columns of a sheet are: names of rows, who answered, quantities.

use super::sheet::{NAMES, Quantity, Sheet};
use crate::exercise::table::{Columns, TableError};
use assur_syntax::document::Column;
use assur_text::diagnostic::did_you_mean;
use assur_text::source::{Source, Span, Spanned};
use assur_text::units::{Dimension, Unit, lookup};

/// Other words for the names of rows.
const ALSO: [(&str, usize); 1] = [("problem", 0)];
/// What names who answered: the first that is there counts.
const PERSONS: [&str; 2] = ["student", "name"];

/// So many columns that the key does not have are reported one by one.
const FEW: usize = 5;
/// So much of a header is shown with more of them.
const SHOWN: usize = 160;

/// What a column is.
pub(super) enum Role {
    /// A name of rows, in the order of [`NAMES`].
    Name(usize),
    Person,
    /// A quantity, and the unit of this column: a key of several files may have it in several units.
    Quantity(usize, Unit),
    /// Nothing: it is reported and left out.
    LeftOut,
}

impl Sheet {
    /// What the columns are. Columns of answers that the key does not have are left out.
    pub(super) fn roles(
        &mut self,
        mut columns: Columns,
        key: Option<&Self>,
    ) -> Result<Vec<Role>, TableError> {
        if let Some([only]) = key.map(|key| key.quantities.as_slice()) {
            of_one_question(&mut columns, only);
        }
        let is_person = |c: &Column, word: &str| c.unit.is_none() && c.name.node.to_lowercase() == word;
        let named = |word: &&str| columns.iter().flatten().any(|c| is_person(c, word));
        let person = PERSONS.into_iter().find(named);
        let mut taken: Vec<(String, Span)> = Vec::new();
        let (mut roles, mut extra) = (Vec::new(), Vec::new());
        for column in columns {
            let role = column.and_then(|column| {
                let role = match person.filter(|word| is_person(&column, word)) {
                    Some(_) => Role::Person,
                    None => self.role(&column, key, person)?,
                };
                if matches!(role, Role::Name(_) | Role::Person) {
                    once(&column, &role, &mut taken)?;
                }
                Ok(role)
            });
            roles.push(match (role, key) {
                (Err(error), Some(key)) if is_extra(&error, &self.header.text, key) => {
                    extra.push(error);
                    Role::LeftOut
                }
                (role, _) => role?,
            });
        }
        self.leave_out(extra);
        self.persons = person.is_some();
        let unknown = |error: &TableError| matches!(error, TableError::UnknownColumn { .. });
        match self.left_out.iter().find(|(_, error)| unknown(error)) {
            // nothing could be marked
            Some((_, error)) if self.quantities.is_empty() => Err((**error).clone()),
            _ => Ok(roles),
        }
    }

    /// Reports columns that the key does not have: each of a few, many as one.
    fn leave_out(&mut self, extra: Vec<TableError>) {
        if extra.len() <= FEW {
            let each = extra.into_iter().map(|error| (self.header.clone(), Box::new(error)));
            self.left_out.extend(each);
            return;
        }
        let names = extra.iter().filter_map(|error| match error {
            TableError::UnknownColumn { name, .. } => Some(name.as_str()),
            _ => None,
        });
        let names = names.take(FEW).collect::<Vec<_>>().join("`, `");
        let end = (0..=SHOWN).rev().find(|at| self.header.text.is_char_boundary(*at)).unwrap_or(0);
        let text = self.header.text.get(..end).unwrap_or(&self.header.text).to_owned();
        let error = TableError::UnknownColumn {
            name: format!("{names}`, `…"),
            help: format!("{} columns are not of the key: leave them out", extra.len()),
            span: Span::new(0, text.len()),
        };
        self.left_out.push((Source::line(&self.header.name, text, 1), Box::new(error)));
    }

    fn role(
        &mut self,
        column: &Column,
        key: Option<&Self>,
        person: Option<&str>,
    ) -> Result<Role, TableError> {
        let name = &column.name.node;
        let word = name.to_lowercase();
        let also = || ALSO.iter().find(|(other, _)| *other == word).map(|(_, i)| *i);
        if column.unit.is_none()
            && let Some(i) = NAMES.iter().position(|n| *n == word).or_else(also)
        {
            self.named[i] = true;
            return Ok(Role::Name(i));
        }
        if let Some(key) = key {
            known(column, key, person)?;
        }
        let unit = match &column.unit {
            Some(word) => lookup(&word.node).map_err(|e| TableError::Unit {
                why: e.to_string(),
                help: e.help(),
                span: word.span,
            })?,
            None => Unit::si(Dimension::NUMBER),
        };
        if let Some(key) = key {
            fits(column, &unit, key)?;
        }
        let again = column.name.span;
        if let Some(i) = self.place(name, unit.dimension) {
            let first = &self.quantities[i];
            if first.unit.text == unit.text {
                return Err(TableError::Twice { name: name.clone(), first: first.span, again });
            }
            return Ok(Role::Quantity(i, unit));
        }
        self.quantities.push(Quantity { name: name.clone(), unit: unit.clone(), span: again });
        Ok(Role::Quantity(self.quantities.len() - 1, unit))
    }
}

/// Where one question is asked, the only column that names no row is for it, or the one called so, in its unit.
fn of_one_question(columns: &mut Columns, only: &Quantity) {
    const ANSWER: &str = "answer";
    let word = |column: &Column| column.name.node.to_lowercase();
    let names_row = |column: &Column| {
        let word = word(column);
        let known = || NAMES.into_iter().chain(PERSONS).chain(ALSO.map(|(other, _)| other));
        column.unit.is_none() && known().any(|known| known == word)
    };
    if columns.iter().flatten().any(|column| column.name.node == only.name && column.unit.is_some()) {
        return;
    }
    let mut others: Vec<&mut Column> = columns.iter_mut().flatten().filter(|c| !names_row(c)).collect();
    if others.len() > 1 {
        others.retain(|column| word(column) == ANSWER);
    }
    let [column] = others.as_mut_slice() else { return };
    column.name.node.clone_from(&only.name);
    if column.unit.is_none() && !only.unit.text.is_empty() {
        column.unit = Some(Spanned::new(only.unit.text.clone(), column.name.span));
    }
}

/// Two columns cannot both say who answered, or which row it is.
fn once(column: &Column, role: &Role, taken: &mut Vec<(String, Span)>) -> Result<(), TableError> {
    let what = match role {
        Role::Name(i) => NAMES[*i].to_owned(),
        _ => column.name.node.to_lowercase(),
    };
    let again = column.name.span;
    match taken.iter().find(|(word, _)| *word == what) {
        Some((_, first)) => Err(TableError::Twice { name: what, first: *first, again }),
        None => {
            taken.push((what, again));
            Ok(())
        }
    }
}

/// Whether a column that cannot be used is none of the key's quantities: the others are marked without it.
fn is_extra(error: &TableError, header: &str, key: &Sheet) -> bool {
    match error {
        TableError::UnknownColumn { .. } => true,
        TableError::Header { span, .. } => {
            let text = header.get(span.start..span.end).unwrap_or_default().trim_matches('"');
            let name = text.split(" [").next().unwrap_or_default();
            let name = name.split(" (").next().unwrap_or_default().trim();
            key.quantities.iter().all(|q| q.name != name)
        }
        _ => false,
    }
}

/// Whether the key has a quantity of that name.
fn known(column: &Column, key: &Sheet, person: Option<&str>) -> Result<(), TableError> {
    let name = &column.name.node;
    if key.quantities.iter().any(|q| q.name == *name) {
        return Ok(());
    }
    let near = did_you_mean(name, key.quantities.iter().map(|q| q.name.as_str()));
    let all = || key.quantities.iter().map(|q| format!("`{}`", q.name)).collect::<Vec<_>>().join(", ");
    let is_person = PERSONS.contains(&name.to_lowercase().as_str());
    let help = match (near.first(), person) {
        (_, Some(person)) if is_person => format!("`{person}` names who answered"),
        (Some(near), _) => format!("did you mean `{near}`?"),
        (None, _) => format!("the key has {}; rows are named by row, variant, file, pose", all()),
    };
    Err(TableError::UnknownColumn { name: name.clone(), help, span: column.name.span })
}

/// Whether the key has that quantity in units of that kind.
fn fits(column: &Column, unit: &Unit, key: &Sheet) -> Result<(), TableError> {
    let name = &column.name.node;
    if key.place(name, unit.dimension).is_some() {
        return Ok(());
    }
    let same = key.quantities.iter().find(|q| q.name == *name);
    let wanted = same.map_or("", |quantity| quantity.unit.text.as_str());
    let (why, help) = match (&column.unit, wanted.is_empty()) {
        (None, _) => (format!("`{name}` has no unit"), format!("write `{name} [{wanted}]`")),
        (Some(_), true) => (format!("`{name}` is a plain number"), format!("write `{name}`")),
        (Some(_), false) => {
            (format!("`{name}` is given in {wanted} by the key"), format!("write `{name} [{wanted}]`"))
        }
    };
    let span = column.unit.as_ref().map_or(column.name.span, |u| u.span);
    Err(TableError::Unit { why, help: Some(help), span })
}
