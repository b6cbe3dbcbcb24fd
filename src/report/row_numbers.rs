//! Answers of a position as a row of numbers, for streams of positions: in CSV, in columns of Arrow, in columns in memory.

use super::answers::Answers;
use super::rows::{Answer, AnswerColumns, Content, ROUNDING};
use assur_model::model::{Display, FindKind, Mechanism, Value};
use assur_solve::solve::{Model, MotionScales, Pose};
use assur_text::units::{Dimension, Kind};

/// A column of numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct NumberField {
    /// Its name, with `.x` or `.y` for a component of a vector.
    pub name: String,
    /// The unit of its numbers.
    pub display: Display,
    /// It shows a condition: 1 is true, 0 false.
    pub condition: bool,
}

/// Reads positions as rows of numbers: in the units of its columns, 1 and 0 for conditions, NaN where there is no answer.
#[derive(Clone, Debug)]
pub struct NumberRows {
    columns: AnswerColumns,
    /// The answers that need no pose, once known.
    whole: Option<Vec<Option<Value>>>,
}

impl NumberRows {
    #[must_use]
    pub const fn of(columns: AnswerColumns) -> Self {
        Self { columns, whole: None }
    }

    /// Finds the answers that need no pose, once.
    pub fn begin(&mut self, answers: &Answers<'_>) {
        self.whole.get_or_insert_with(|| self.columns.whole(answers));
    }

    /// Writes a position, once it has [begun](NumberRows::begin).
    pub fn read(&self, answers: &Answers<'_>, pose: &Pose, row: &mut Vec<f64>) {
        let whole = self.whole.as_deref().unwrap_or_default();
        self.columns.write_row(answers, (Some(pose), whole), None, row);
    }

    /// Writes what needs no pose, for a file that has none.
    pub fn read_without_pose(&self, answers: &Answers<'_>, row: &mut Vec<f64>) {
        self.columns.write_row(answers, (None, &self.columns.whole(answers)), None, row);
    }

    /// Whether a column shows the angle of a link or of a hinge, or a quantity does that it may show.
    #[must_use]
    pub fn reads_angles(&self, model: &Model<'_>) -> bool {
        self.columns.reads_angles(model)
    }
}

impl AnswerColumns {
    /// The same in SI, angles in radians.
    #[must_use]
    pub fn in_si(mut self) -> Self {
        for answer in &mut self.answers {
            let [length, mass, time, angle] = answer.display.dimension;
            let kind = match answer.display.unit.as_str() {
                "" => Kind::Plain,
                _ if angle != 0 => Kind::Angle,
                _ => Kind::Free,
            };
            let unit = Dimension { length, mass, time, kind }.si_text();
            answer.display = Display { unit, factor: 1.0, ..answer.display.clone() };
        }
        self
    }

    /// Each name once: a reaction that is asked for by its own name, too, has one column.
    #[must_use]
    pub fn each_once(mut self) -> Self {
        let names: Vec<String> = self.names().collect();
        let mut places = 0..;
        self.answers.retain(|_| places.next().is_some_and(|i| !names[..i].contains(&names[i])));
        self
    }

    /// Those of a key: what is asked for.
    #[must_use]
    pub fn of_key(mut self) -> Self {
        self.answers.retain(|answer| answer.asked);
        self
    }

    /// The columns, two for a vector.
    #[must_use]
    pub fn fields(&self, mechanism: &Mechanism) -> Vec<NumberField> {
        let condition = |answer: &Answer| match answer.content {
            Content::Find { index, .. } => match &mechanism.finds[index].kind {
                FindKind::Value { expr, .. } => mechanism.is_condition(expr),
                FindKind::Reactions | FindKind::Table(_) => false,
            },
            _ => false,
        };
        let field = |answer: &Answer| {
            let (display, condition) = (&answer.display, condition(answer));
            let named = |name| NumberField { name, display: display.clone(), condition };
            answer.columns().map(named).collect::<Vec<_>>()
        };
        self.answers.iter().flat_map(field).collect()
    }

    /// The cells of a line: numbers in the units of the columns, 1 and 0 for conditions, NaN where there is no answer. What is
    /// rounding against what is `greatest` is 0, if that is given, as in an answer key.
    pub fn write_row(
        &self,
        answers: &Answers<'_>,
        places: (Option<&Pose>, &[Option<Value>]),
        greatest: Option<&MotionScales>,
        out: &mut Vec<f64>,
    ) {
        out.clear();
        self.each_value(false, answers, places, |answer, value| {
            let value = greatest.map_or(value, |greatest| answer.cleared(value, greatest, ROUNDING));
            answer.push_cells(value, out);
        });
    }

    /// Whether a column shows the angle of a link or of a hinge, or a quantity does that it may show.
    #[must_use]
    pub fn reads_angles(&self, model: &Model<'_>) -> bool {
        let mechanism = model.mechanism;
        let finds = mechanism.finds.iter().filter_map(|find| match &find.kind {
            FindKind::Value { expr, .. } => Some(expr),
            FindKind::Reactions | FindKind::Table(_) => None,
        });
        let mut reads = false;
        for expr in finds.chain(mechanism.quantities.iter().map(|q| &q.expr)) {
            expr.queries(&mut |query| reads |= query.facts().continuous.is_some());
        }
        reads
    }
}

impl Answer {
    fn push_cells(&self, value: Option<Value>, out: &mut Vec<f64>) {
        match (value, self.vector) {
            (Some(Value::Vector(v)), true) => out.extend([v.x, v.y].map(|x| self.display.of_si(x))),
            (Some(Value::Scalar(x)), false) => out.push(self.display.of_si(x)),
            (Some(Value::Bool(truth)), false) => out.push(f64::from(u8::from(truth))),
            (_, true) => out.extend([f64::NAN; 2]),
            (_, false) => out.push(f64::NAN),
        }
    }
}
