//! What to ask for in a motion under loads. Accuracies of one method are compared by their evaluations, which no clock decides,
//! and methods by prices of an evaluation, where one has to be clearly faster: a machine under load chooses the same.

use super::price::{ALIKE, CLEARLY};
use super::runs::{MethodStudy, RunRow, RunStudy};

/// An accuracy by a method: places in the lists of a study.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Choice {
    pub method: usize,
    pub row: usize,
}

/// Of two errors the smaller one counts as smaller if it is no more than this part of the other: a tenth of a digit.
const SMALLER: f64 = 0.8;

impl RunRow {
    /// Digits that are right.
    #[must_use]
    pub fn digits(&self) -> f64 {
        -libm::log10(self.error.max(1e-40))
    }
}

impl MethodStudy {
    /// The loosest accuracy that keeps an error, unless a tighter one takes clearly fewer evaluations.
    fn loosest(&self, wanted: f64) -> Option<usize> {
        let kept = || (0..self.rows.len()).filter(|i| !self.rows[*i].missed && self.rows[*i].error <= wanted);
        let work = |i: usize| self.rows[i].evaluations as f64;
        let least = kept().map(work).fold(f64::INFINITY, f64::min);
        kept().find(|i| work(*i) <= ALIKE * least)
    }
}

impl RunStudy {
    /// The row of a choice.
    #[must_use]
    pub fn row(&self, choice: Choice) -> &RunRow {
        &self.methods[choice.method].rows[choice.row]
    }

    /// What the file asks for, as the solver chooses the method.
    #[must_use]
    pub fn own(&self) -> Option<Choice> {
        let rows = &self.methods.first()?.rows;
        let found = rows.iter().rposition(|row| row.within >= self.asked * 0.999)?;
        Some(Choice { method: 0, row: found })
    }

    /// The loosest accuracy that keeps the error wanted, by the solver's own choice of the method unless another is clearly faster.
    #[must_use]
    pub fn recommended(&self) -> Option<Choice> {
        let mut best: Option<Choice> = None;
        for (method, study) in self.methods.iter().enumerate() {
            let Some(row) = study.loosest(self.wanted) else { continue };
            let found = Choice { method, row };
            if best.is_none_or(|best| self.row(found).micros <= CLEARLY * self.row(best).micros) {
                best = Some(found);
            }
        }
        best
    }

    /// The accuracies of some methods that no other beats in error and time, from fast to accurate.
    #[must_use]
    pub fn front(&self, of: impl Fn(usize, &RunRow) -> bool) -> Vec<Choice> {
        let mut all: Vec<Choice> = Vec::new();
        for (method, study) in self.methods.iter().enumerate() {
            let rows = (0..study.rows.len()).filter(|row| of(method, &study.rows[*row]));
            all.extend(rows.map(|row| Choice { method, row }));
        }
        let key = |choice: &Choice| (self.row(*choice).micros, self.row(*choice).error);
        all.sort_by(|a, b| {
            let ((a, e), (b, f)) = (key(a), key(b));
            a.total_cmp(&b).then(e.total_cmp(&f))
        });
        let mut least = f64::INFINITY;
        all.retain(|choice| {
            let error = self.row(*choice).error;
            let smaller = error <= SMALLER * least;
            least = if smaller { error } else { least };
            smaller
        });
        all
    }

    /// The front in a limited number of rows, with the file's own and the one that is recommended, from few digits to many.
    #[must_use]
    pub fn in_short(&self, most: usize) -> Vec<Choice> {
        let front = self.front(|_, row| !row.missed);
        let mut chosen: Vec<Choice> = Vec::new();
        let mut take = |choice: Option<Choice>| {
            if let Some(choice) = choice.filter(|choice| !chosen.contains(choice) && chosen.len() < most) {
                chosen.push(choice);
            }
        };
        [self.own(), self.recommendation, front.first().copied(), front.last().copied()]
            .into_iter()
            .for_each(&mut take);
        take(front.get(front.len() / 2).copied());
        let digits = |choice: &Choice| self.row(*choice).digits();
        chosen.sort_by(|a, b| digits(a).total_cmp(&digits(b)));
        chosen
    }
}
