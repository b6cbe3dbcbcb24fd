//! Where a file asks for its answers: what needs no position once, everything else at every position that the file names.

use super::answers::Answers;
use super::rows::{Answer, AnswerColumns, Content, ROUNDING};
use assur_model::model::{FindKind, Mechanism, Query, Value};
use assur_solve::solve::{Failure, Pose};
use assur_worked::SheetQuestion;

/// A line of answers: at a position, and with what needs none where that is asked for in this line.
#[derive(Clone, Copy, Debug)]
pub struct AnswerLine<'p> {
    pub pose: Option<&'p Pose>,
    pub whole: bool,
    /// It is where an event ends the motion, and when that is, is an answer.
    ends: bool,
}

/// The name of a position at which an event ends the motion.
const END: &str = "end";

impl<'p> AnswerLine<'p> {
    /// That of all answers at a position.
    #[must_use]
    pub const fn at(pose: Option<&'p Pose>) -> Self {
        Self { pose, whole: true, ends: false }
    }

    /// The name of its position; nothing where it has none.
    #[must_use]
    pub fn name(&self) -> &'p str {
        if self.ends { END } else { self.pose.map_or("", |pose| &pose.name) }
    }

    /// Of the answers that need no pose those that this line has.
    #[must_use]
    pub fn whole<'w>(&self, whole: &'w [Option<Value>]) -> &'w [Option<Value>] {
        if self.whole { whole } else { &[] }
    }
}

impl AnswerColumns {
    /// The lines of the answers of a file. What needs no position has a line of its own, the first one, where there are several
    /// positions. A `key` has no positions that only events add: where an event happens is an answer.
    pub fn lines<'p>(&self, answers: &Answers<'p>, key: bool) -> impl Iterator<Item = AnswerLine<'p>> {
        self.lines_at(answers, key, &[])
    }

    /// The same at positions of these names alone; at all where there are no names.
    pub fn lines_at<'p>(
        &self,
        answers: &Answers<'p>,
        key: bool,
        names: &[String],
    ) -> impl Iterator<Item = AnswerLine<'p>> {
        let is_wanted =
            |line: &AnswerLine<'_>| names.is_empty() || names.iter().any(|name| name == line.name());
        let positions = answers.asked_positions(key).filter(is_wanted);
        let count = positions.clone().take(2).count();
        let shown = |whole: bool| self.answers.iter().any(|a| (a.asked || !key) && a.is_whole() == whole);
        let at_positions = count > 0 && (count == 1 || self.asks_at_positions(key));
        let apart = count != 1 && (shown(true) || !at_positions);
        let first = apart.then_some(AnswerLine::at(None));
        let each = positions.filter(move |_| at_positions);
        first.into_iter().chain(each.map(move |line| AnswerLine { whole: count == 1, ..line }))
    }

    /// Why a line lacks answers: there is no solution at its position, or at one of all where these have no lines.
    #[must_use]
    pub fn failure_of<'a>(&self, answers: &Answers<'a>, line: &AnswerLine<'a>) -> Option<&'a Failure> {
        match line.pose {
            Some(pose) => pose.outcome.as_ref().err(),
            None if self.asks_at_positions(false) => None,
            None => answers.asked_for().find_map(|pose| pose.outcome.as_ref().err()),
        }
    }

    /// Whether something is asked for that depends on the position.
    #[must_use]
    pub fn asks_at_positions(&self, key: bool) -> bool {
        let mut shown = self.answers.iter().filter(|a| (a.asked || !key) && !a.is_whole());
        shown.any(|a| !matches!(a.content, Content::Drive(_)))
    }
}

impl AnswerColumns {
    /// The questions with their answers in a line.
    #[must_use]
    pub fn asked(&self, answers: &Answers<'_>, line: AnswerLine<'_>) -> Vec<SheetQuestion> {
        let (whole, greatest) = (self.whole(answers), answers.greatest());
        let values = self.values(answers, line.pose, line.whole(&whole));
        let of = |(answer, value): (&Answer, Option<Value>)| {
            let display = &answer.display;
            let value = answer.cleared(value, &greatest, ROUNDING).map(|value| match value {
                Value::Scalar(x) => Value::Scalar(display.of_si(x)),
                Value::Vector(v) => Value::Vector(display.of_si_vector(v)),
                truth @ Value::Bool(_) => truth,
            });
            SheetQuestion {
                name: answer.name.clone(),
                unit: display.unit.clone(),
                factor: display.factor,
                vector: answer.vector,
                whole: answer.is_whole(),
                value,
            }
        };
        self.answers.iter().zip(values).filter(|(answer, _)| answer.asked).map(of).collect()
    }
}

impl<'a> Answers<'a> {
    /// The positions that answers are asked for at; with those of events, unless for a key. The end of a motion has answers in any case.
    fn asked_positions(&self, key: bool) -> impl Iterator<Item = AnswerLine<'a>> + Clone + use<'a> {
        let (solution, mechanism) = (self.solution, self.model.mechanism);
        let all = self.asked_for();
        let line = move |pose: &'a Pose| {
            let mut ends = false;
            if key {
                let happens = !mechanism.events.is_empty();
                let events = if happens { solution.events_at(mechanism, pose) } else { Vec::new() };
                ends = !events.is_empty();
                if !pose.is_position() || events.iter().any(|name| *name != END) {
                    return None;
                }
            }
            Some(AnswerLine { ends, ..AnswerLine::at(Some(pose)) })
        };
        let positions = || all.clone().filter_map(line);
        // the last instant tells the period
        let tells = key && asks_period(mechanism);
        let count = if tells { positions().count() } else { 0 };
        let kept = if count > 1 { count - 1 } else { usize::MAX };
        positions().take(kept)
    }
}

fn asks_period(mechanism: &Mechanism) -> bool {
    let mut asked = false;
    for find in &mechanism.finds {
        if let FindKind::Value { expr, .. } = &find.kind {
            mechanism.each_query(expr, &mut |query| asked |= *query == Query::Period);
        }
    }
    asked
}
