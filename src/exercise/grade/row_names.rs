//! What names a row.

use super::sheet::{NAMES, SheetRow};
use std::collections::BTreeMap;
use std::sync::Arc;

/// More characters of the name of a file, a row, a variant or a position are not shown.
const LONGEST: usize = 60;

/// What names a row: most lines of answers share the names of their row of the key.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct RowNames {
    /// In the order of [`NAMES`]; `None` where nothing stands there.
    pub each: [Option<String>; 4],
    /// The file without folder and ending, where that names no other file.
    short: Option<String>,
}

impl RowNames {
    pub(super) fn of(each: [Option<String>; 4]) -> Arc<Self> {
        let short = each[0].as_deref().map(stem);
        Arc::new(Self { each, short })
    }

    /// With the names of others where these have none.
    pub(super) fn and(self: &Arc<Self>, others: [Option<String>; 4]) -> Arc<Self> {
        if self.each.iter().zip(&others).all(|(own, other)| own.is_some() || other.is_none()) {
            return Arc::clone(self);
        }
        let mut others = others;
        let all = Self::of(std::array::from_fn(|i| self.each[i].clone().or_else(|| others[i].take())));
        Arc::new(Self {
            short: self.short.clone().or_else(|| all.short.clone()),
            ..Arc::unwrap_or_clone(all)
        })
    }

    /// Of the problem and the position alone: which row it is, is not known.
    pub(super) fn of_problem(&self) -> Arc<Self> {
        let each = [self.each[0].clone(), None, None, self.each[3].clone()];
        Arc::new(Self { each, short: self.short.clone() })
    }

    /// Names files by their paths where two of the rows have the same name without folder and ending.
    pub(super) fn shorten(rows: &mut [SheetRow]) {
        let mut paths: BTreeMap<String, Option<String>> = BTreeMap::new();
        for names in rows.iter().map(|row| &row.names) {
            let (Some(path), Some(short)) = (&names.each[0], &names.short) else { continue };
            let known = paths.entry(short.clone()).or_insert_with(|| Some(path.clone()));
            if known.as_ref() != Some(path) {
                *known = None;
            }
        }
        for row in rows {
            let is_ambiguous = |short: &String| paths.get(short).is_some_and(Option::is_none);
            if row.names.short.as_ref().is_some_and(is_ambiguous) {
                let names = Arc::make_mut(&mut row.names);
                names.short.clone_from(&names.each[0]);
            }
        }
    }

    /// In words, the file shortly: `engine`, `row 3`, `pose 1`.
    #[must_use]
    pub fn words(&self) -> Vec<String> {
        let others = NAMES.iter().zip(&self.each).skip(1);
        let others = others.filter_map(|(what, name)| Some(format!("{what} {}", cut(name.as_deref()?))));
        self.short.as_deref().map(cut).into_iter().chain(others).collect()
    }
}

/// A file without folder and ending.
fn stem(path: &str) -> String {
    let name = path.rsplit(['/', '\\']).next().unwrap_or(path);
    let stem = name.strip_suffix(".mech").unwrap_or(name);
    if stem.is_empty() { path.to_owned() } else { stem.to_owned() }
}

/// The names of a row as they are written: `file a/engine.mech`, `row 3`.
pub(super) fn as_written(names: &[Option<String>; 4]) -> Vec<String> {
    let shown = NAMES.iter().zip(names).filter_map(|(what, name)| Some((*what, name.as_deref()?)));
    shown.map(|(what, name)| format!("{what} {name}")).collect()
}

/// A text of others, cut where it is long.
#[must_use]
pub fn cut(text: &str) -> String {
    match text.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_owned(),
    }
}
