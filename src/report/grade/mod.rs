//! Marks: tables to read, comma-separated values, JSON. All three say the same.

mod json;
mod records;
mod tables;

pub use json::{json, write_json};
pub use records::write_csv;
pub use tables::reports;

use crate::exercise::grade::{Graded, Mark, Verdict};
use assur_text::units::significant;

const DIGITS: usize = 6;

/// Lines that are not marked beyond those that are listed.
fn more_lines(count: usize) -> String {
    format!("and {count} more line{}", if count == 1 { "" } else { "s" })
}

/// `3 %`
fn percent(x: f64) -> String {
    format!("{} %", significant(100.0 * x, 3))
}

const fn word(verdict: &Verdict) -> &'static str {
    match verdict {
        Verdict::Right => "right",
        Verdict::Wrong(_) => "wrong",
        Verdict::Missing => "missing",
        Verdict::Unreadable(..) => "unreadable",
        Verdict::NotAsked(_) => "not asked",
    }
}

/// What explains a verdict; empty where nothing does.
fn hint(mark: &Mark) -> String {
    match &mark.verdict {
        Verdict::Wrong(slip) => {
            let slip = slip.as_deref().map(crate::exercise::grade::CommonMistake::words);
            let zero = is_key_zero(mark).then(|| "key is 0".to_owned());
            slip.into_iter().chain(zero).collect::<Vec<_>>().join("; ")
        }
        Verdict::Unreadable(unread) | Verdict::NotAsked(unread) => unread.why.clone(),
        Verdict::Right | Verdict::Missing => String::new(),
    }
}

fn slip_name(verdict: &Verdict) -> &'static str {
    match verdict {
        Verdict::Wrong(Some(slip)) => slip.name(),
        _ => "",
    }
}

/// A difference from zero is a part of nothing.
const fn is_key_zero(mark: &Mark) -> bool {
    mark.deviation.get().is_some() && mark.error.get().is_none()
}

/// What was written where it is not a number.
fn written(verdict: &Verdict) -> &str {
    match verdict {
        Verdict::Unreadable(unread) | Verdict::NotAsked(unread) => &unread.text,
        _ => "",
    }
}

/// An answer, the key and their difference, in the unit of the answers.
struct Figures {
    given: String,
    key: String,
    deviation: String,
}

impl Figures {
    fn of(graded: &Graded, mark: &Mark) -> Self {
        let unit = &graded.quantity(mark).unit;
        let figures = |x: Option<f64>| x.map(|x| significant(unit.from_si(x), DIGITS)).unwrap_or_default();
        let given = mark.given.get().map_or_else(|| written(&mark.verdict).to_owned(), |x| figures(Some(x)));
        Self { given, key: figures(mark.key.get()), deviation: figures(mark.deviation.get()) }
    }
}
