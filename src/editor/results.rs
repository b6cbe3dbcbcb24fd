//! What a text comes to: its answers at all positions.

use super::Analysis;
use super::lenses::in_words;
use crate::exercise::{Outcome, mismatches};
use crate::pipeline::{Compiled, Sink, Solved, compile_document, is_long, solve, solve_each};
use crate::report::rows::AnswerColumns;
use crate::report::{Answers, PrintedDigits};
use assur_check::Overrides;
use assur_model::model::{Display, Query, Value};
use assur_solve::solve::{IntegrationOptions, Pose, PoseAnswers, Progress};
use assur_syntax::document::Statement;
use assur_text::diagnostic::Problems;
use assur_text::source::Span;
use assur_text::units::Dimension;
use indexmap::IndexMap;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Digits of a value.
const DIGITS: usize = 6;

/// Asked at every position: whether to go on.
pub type GoesOn<'g> = dyn Fn() -> bool + Sync + 'g;

/// The values of one answer, one per position.
#[derive(Clone, Debug)]
struct Series {
    display: Display,
    values: Vec<Option<Value>>,
}

#[derive(Debug)]
pub struct Results {
    /// Its positions; nothing where there is none.
    pub(super) solved: Option<Solved>,
    series: IndexMap<String, Series>,
    /// The position of which values are shown, by its index; of all where there is no such position.
    pose: AtomicUsize,
    /// What is wrong with it, failed expectations among it.
    pub problems: Problems,
}

impl Analysis {
    /// Solves the text; nothing where it cannot be, has very many positions, or is not to go on.
    #[must_use]
    pub fn solve(&self, goes_on: &GoesOn<'_>) -> Option<Results> {
        let is_short = self.compiled.as_ref().is_some_and(|compiled| !is_long(&compiled.model()));
        if is_short { self.solve_however_long(goes_on) } else { None }
    }

    /// As [`Analysis::solve`]; of very many positions the problem is how many there are.
    #[must_use]
    pub fn solve_however_long(&self, goes_on: &GoesOn<'_>) -> Option<Results> {
        if self.compiled.is_none() || self.problems.has_errors() {
            return None;
        }
        let none = Overrides::none();
        let (compiled, _) = compile_document(&self.source, &self.document, Problems::new(), &none);
        let compiled = compiled?;
        let (solved, problems) =
            if is_long(&compiled.model()) { solve(compiled) } else { solve_while(compiled, goes_on) };
        // the keys of variants are those of their rows
        let with_rows = self.document.statements.iter().any(|s| matches!(s.node, Statement::Variants(_)));
        goes_on().then(|| Results::of(solved.ok(), problems, with_rows))
    }
}

/// Solves a text, position after position, as long as it is to go on.
pub fn solve_while(compiled: Compiled, goes_on: &GoesOn<'_>) -> (Result<Solved, Compiled>, Problems) {
    solve_each(compiled, &mut Watched { goes_on, watch: &|_, _| goes_on() })
}

/// Keeps the positions as long as it is to go on.
struct Watched<'g> {
    goes_on: &'g GoesOn<'g>,
    watch: &'g Progress<'g>,
}

impl Sink for Watched<'_> {
    fn add(&mut self, _: &Answers<'_>, _: &Pose) -> bool {
        (self.goes_on)()
    }

    fn conduct(&self) -> IntegrationOptions<'_> {
        IntegrationOptions { watch: Some(self.watch), ..IntegrationOptions::default() }
    }
}

impl Results {
    fn of(mut solved: Option<Solved>, mut problems: Problems, with_rows: bool) -> Self {
        if with_rows && solved.is_some() {
            problems = Problems::new();
            solved.iter_mut().for_each(|solved| solved.outcomes.clear());
        }
        problems.extend(solved.iter().flat_map(|solved| mismatches(&solved.outcomes)));
        let series = solved.as_ref().map(series).unwrap_or_default();
        Self { solved, series, pose: AtomicUsize::new(usize::MAX), problems }
    }

    /// Shows values of the position at a part of the way, from 0 to 1; of all positions without one.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, clippy::cast_precision_loss)] // a part of a count
    pub fn look_at(&self, part: Option<f64>) {
        let last = self.positions().saturating_sub(1);
        let index = part.map(|part| (part.clamp(0.0, 1.0) * last as f64).round() as usize);
        self.pose.store(index.unwrap_or(usize::MAX), Ordering::Relaxed);
    }

    /// A series as it is shown: at the position that is looked at, with its name, or over all.
    fn shown(&self, series: &Series) -> Option<String> {
        let index = self.pose.load(Ordering::Relaxed);
        let at = || {
            let solved = self.solved.as_ref().filter(|_| series.values.len() > 1)?;
            let name = &solved.answers(PrintedDigits::READABLE).poses().nth(index)?.name;
            let pose = if name.starts_with(|c: char| c.is_ascii_digit()) { "pose " } else { "" };
            Some(format!("{} ({pose}{name})", series.display.text((*series.values.get(index)?)?, DIGITS)))
        };
        at().or_else(|| series.text())
    }

    /// Whether there is a solution.
    #[must_use]
    pub const fn is_solved(&self) -> bool {
        self.solved.is_some()
    }

    /// How many positions are asked for.
    #[must_use]
    pub fn positions(&self) -> usize {
        self.solved.as_ref().map_or(0, |solved| views(solved).count())
    }

    /// An answer or a definition by its name: its value, or its range over all positions.
    #[must_use]
    pub fn value(&self, name: &str) -> Option<String> {
        self.shown(self.series.get(name)?)
    }

    /// The names of the answers that begin so, each with its value.
    pub fn beginning<'r>(&'r self, with: &'r str) -> impl Iterator<Item = (&'r str, String)> {
        let found = self.series.iter().filter(move |(name, _)| name.starts_with(with));
        found.filter_map(|(name, series)| Some((name.as_str(), self.shown(series)?)))
    }

    /// What a query gives, or its range over all positions.
    #[must_use]
    pub fn query(&self, query: &Query, dimension: Dimension) -> Option<String> {
        let solved = self.solved.as_ref()?;
        let display = solved.compiled.mechanism.display_of(dimension);
        let values = views(solved).map(|view| view.map(|view| view.query(query))).collect();
        self.shown(&Series { display, values })
    }

    /// `✓`, or the answer that an expectation of a statement fails by.
    #[must_use]
    pub fn outcome(&self, statement: Span) -> Option<String> {
        let solved = self.solved.as_ref()?;
        let own = || solved.outcomes.iter().filter(|o| o.span == statement);
        let failed = own().filter(|o| !o.passed).collect::<Vec<&Outcome>>();
        match (own().count(), failed.as_slice()) {
            (0, _) => None,
            (_, []) => Some("✓".to_owned()),
            (1, [only]) => Some(format!("✗ {}", only.display.text(only.got, DIGITS))),
            (all, [first, ..]) => {
                let got = first.display.text(first.got, DIGITS);
                Some(format!("✗ {} of {all}: {got}{}", failed.len(), first.place))
            }
        }
    }

    /// `3 of 3 expectations met`
    #[must_use]
    pub fn outcomes_in_words(&self) -> String {
        self.solved.as_ref().map_or_else(|| "no solution".to_owned(), |solved| in_words(&solved.outcomes))
    }
}

/// The positions that are asked for, as answers see them; nothing for one without a solution.
fn views(solved: &Solved) -> impl Iterator<Item = Option<PoseAnswers<'_>>> {
    let answers = solved.answers(PrintedDigits::READABLE);
    let model = answers.model;
    answers.poses().map(move |pose| {
        let found = pose.outcome.as_ref().ok()?;
        Some(solved.solution.view(&model, found))
    })
}

fn series(solved: &Solved) -> IndexMap<String, Series> {
    let answers = solved.answers(PrintedDigits::READABLE);
    let columns = AnswerColumns::of_file(&answers.model);
    let whole = columns.whole(&answers);
    let rows = answers.poses().map(|pose| columns.values(&answers, Some(pose), &whole)).collect::<Vec<_>>();
    let none = columns.values(&answers, None, &whole);
    let mut found = IndexMap::new();
    for (index, (name, display)) in columns.names().zip(columns.displays()).enumerate() {
        let of_poses = rows.iter().map(|row| row.get(index).copied().flatten()).collect::<Vec<_>>();
        let values = if rows.is_empty() { vec![none[index]] } else { of_poses };
        found.insert(name, Series { display: display.clone(), values });
    }
    for (index, quantity) in solved.compiled.mechanism.quantities.iter().enumerate() {
        let values = views(solved).map(|view| view?.quantities.get(index).copied()).collect();
        let series = Series { display: quantity.display.clone(), values };
        found.entry(quantity.name.clone()).or_insert(series);
    }
    found
}

impl Series {
    /// `12 N`, `3 … 12 N`, `true at 4 of 13`; nothing where there is no value.
    fn text(&self) -> Option<String> {
        let known = self.values.iter().flatten().copied().collect::<Vec<_>>();
        let (first, rest) = known.split_first()?;
        if rest.iter().all(|value| value == first) {
            return Some(self.display.text(*first, DIGITS));
        }
        let numbers = known.iter().filter_map(|value| match value {
            Value::Scalar(x) => Some(*x),
            Value::Vector(v) => Some(v.norm()),
            Value::Bool(_) => None,
        });
        let numbers = numbers.collect::<Vec<_>>();
        if numbers.is_empty() {
            let count = known.iter().filter(|value| **value == Value::Bool(true)).count();
            return Some(format!("true at {count} of {}", known.len()));
        }
        let least = numbers.iter().copied().fold(f64::INFINITY, f64::min);
        let most = numbers.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let [least, most] =
            [least, most].map(|x| if x.abs() < 1e-12 * most.abs().max(least.abs()) { 0.0 } else { x });
        let from = self.display.figures(Value::Scalar(least), DIGITS);
        let range = format!("{from} … {}", self.display.text(Value::Scalar(most), DIGITS));
        Some(if matches!(first, Value::Vector(_)) { format!("magnitude {range}") } else { range })
    }
}
