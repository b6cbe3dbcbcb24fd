//! The rules of marking: tolerance, what is missing, submissions, points, credit.

use super::common_mistake::{CommonMistake, SLIPS};
use super::sheet::{Sheet, SheetRow};
use assur_text::diagnostic::did_you_mean;

const WITHIN: f64 = 0.03;

/// Sums of more points are no numbers that anybody reads.
pub(super) const MOST_POINTS: f64 = 1e9;

/// How answers are marked.
#[derive(Clone, Debug)]
pub struct Rules {
    /// The greatest relative difference allowed.
    pub within: f64,
    /// Answers that are missing are left out of the totals; else they are wrong.
    pub only_answered: bool,
    /// Which counts where a student answers a row more than once.
    pub submissions: Submissions,
    /// Points of the quantities.
    pub points: Points,
    /// Parts of the points for slips.
    pub credit: Credit,
}

impl Default for Rules {
    fn default() -> Self {
        Self {
            within: WITHIN,
            only_answered: false,
            submissions: Submissions::Last,
            points: Points::default(),
            credit: Credit::default(),
        }
    }
}

/// Which counts of several submissions of one student for one row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Submissions {
    First,
    /// The line with the most points, the later of two that are equal.
    Best,
    Last,
}

impl Submissions {
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::First => "first",
            Self::Best => "best",
            Self::Last => "last",
        }
    }
}

/// Points of quantities, given in addition to those of the key.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Points(Vec<(String, f64)>);

/// The name for all quantities that have no points of their own.
const OTHERS: &str = "*";

impl Points {
    /// Reads `Mb=2, reaction(B, rod).x=0.5, *=0`.
    ///
    /// # Errors
    /// What to write.
    pub fn read(text: &str) -> Result<Self, String> {
        let wrong = || "write NAME=POINTS, as in Mb=2,F_A=1, with 1e9 points at most".to_owned();
        let one = |item| pair(item).filter(|(_, points)| *points >= 0.0).ok_or_else(wrong);
        let all = items(text).map(one).collect::<Result<Vec<_>, _>>()?;
        Ok(Self(named_once(all)))
    }

    /// These and others, which go before.
    #[must_use]
    pub fn and(self, others: Self) -> Self {
        Self(named_once(self.0.into_iter().chain(others.0)))
    }

    /// A name that is not one of the key's quantities, and what may be meant.
    #[must_use]
    pub fn unknown(&self, key: &Sheet) -> Option<(&str, String)> {
        let names: Vec<&str> = key.quantities.iter().map(|q| q.name.as_str()).collect();
        self.unknown_in(&names)
    }

    /// A name that is none of these, and what may be meant.
    #[must_use]
    pub fn unknown_in(&self, names: &[&str]) -> Option<(&str, String)> {
        let names = || names.iter().copied();
        let (name, _) = self.0.iter().find(|(name, _)| name != OTHERS && names().all(|n| n != name))?;
        let help = match did_you_mean(name, names()).first() {
            Some(near) => format!("did you mean `{near}`?"),
            None => {
                format!("the key has {}", names().map(|n| format!("`{n}`")).collect::<Vec<_>>().join(", "))
            }
        };
        Some((name, help))
    }

    /// The points of a quantity in a row of the key: those given by name, else by `*`, else in the key, else 1.
    pub(crate) fn of(&self, key: &Sheet, row: &SheetRow, place: usize) -> f64 {
        let named = |wanted: &str| self.0.iter().find(|(name, _)| name == wanted).map(|(_, points)| *points);
        let of_file = |file: Option<&String>| key.points.iter().find(|p| p.file.as_ref() == file);
        let in_key =
            || of_file(row.names.each[0].as_ref()).or_else(|| of_file(None)).map(|p| p.points[place]);
        named(&key.quantities[place].name).or_else(|| named(OTHERS)).or_else(in_key).unwrap_or(1.0)
    }
}

/// Parts of the points that answers with a slip get.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Credit(Vec<(String, f64)>);

impl Credit {
    /// Reads `sign=0.5, unit=25%`.
    ///
    /// # Errors
    /// What to write.
    pub fn read(text: &str) -> Result<Self, String> {
        let one = |item: &str| {
            let (name, part) = pair(item).ok_or("write SLIP=PART, as in sign=0.5,unit=0.25")?;
            if !SLIPS.contains(&name.as_str()) {
                return Err(format!("`{name}` is not a slip; these are: {}", SLIPS.join(", ")));
            }
            if !(0.0..=1.0).contains(&part) {
                return Err(format!("the credit for `{name}` is a part from 0 to 1"));
            }
            Ok((name, part))
        };
        let all = items(text).map(one).collect::<Result<Vec<_>, String>>()?;
        Ok(Self(named_once(all)))
    }

    /// These and others, which go before.
    #[must_use]
    pub fn and(self, others: Self) -> Self {
        Self(named_once(self.0.into_iter().chain(others.0)))
    }

    /// The part of the points for a slip; two slips at once get the product.
    pub(crate) fn of(&self, slip: &CommonMistake) -> f64 {
        let of = |wanted: &str| self.0.iter().find(|(name, _)| name == wanted).map_or(0.0, |(_, part)| *part);
        of(slip.name()) * if slip.has_other_sign() { of("sign") } else { 1.0 }
    }

    /// Each slip with its part.
    pub fn parts(&self) -> impl Iterator<Item = (&str, f64)> {
        self.0.iter().map(|(name, part)| (name.as_str(), *part))
    }
}

/// Each name once: what is said last counts.
fn named_once(all: impl IntoIterator<Item = (String, f64)>) -> Vec<(String, f64)> {
    let mut once: Vec<(String, f64)> = Vec::new();
    for (name, number) in all {
        match once.iter_mut().find(|(known, _)| *known == name) {
            Some((_, known)) => *known = number,
            None => once.push((name, number)),
        }
    }
    once
}

/// The items of a list: commas within parentheses are part of a name.
fn items(text: &str) -> impl Iterator<Item = &str> {
    let mut depth = 0_i32;
    text.split(move |c| {
        depth += i32::from(c == '(') - i32::from(c == ')');
        c == ',' && depth == 0
    })
}

/// `Mb = 2`, `sign = 50 %`
fn pair(item: &str) -> Option<(String, f64)> {
    let (name, number) = item.rsplit_once('=')?;
    let (number, part) = match number.trim().strip_suffix('%') {
        Some(number) => (number.trim(), 0.01),
        None => (number.trim(), 1.0),
    };
    let value = number.parse::<f64>().ok().filter(|x| x.abs() <= MOST_POINTS)?;
    (!name.trim().is_empty()).then(|| (name.trim().to_owned(), value * part))
}
