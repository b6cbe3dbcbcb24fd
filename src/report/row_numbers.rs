//! Answers of a position as a row of numbers, for streams of positions: in CSV, in columns of Arrow.

#[cfg(feature = "arrow")]
use super::answers::Answers;
#[cfg(feature = "arrow")]
use super::rows::Answer;
use super::rows::{AnswerColumns, Content};
#[cfg(feature = "arrow")]
use assur_model::model::Mechanism;
use assur_model::model::{FindKind, Value};
#[cfg(feature = "arrow")]
use assur_solve::solve::Pose;
use assur_solve::solve::{Model, NumberColumns, Shown};

impl AnswerColumns {
    /// Names and units of the columns, and whether each shows a condition.
    #[cfg(feature = "arrow")]
    #[must_use]
    pub fn fields(&self, mechanism: &Mechanism) -> Vec<(String, String, bool)> {
        let condition = |answer: &Answer| match answer.content {
            Content::Find { index, .. } => match &mechanism.finds[index].kind {
                FindKind::Value { expr, .. } => mechanism.is_condition(expr),
                FindKind::Reactions | FindKind::Table(_) => false,
            },
            _ => false,
        };
        let field = |answer: &Answer| {
            let (unit, condition) = (answer.display.unit.clone(), condition(answer));
            answer.columns().map(move |name| (name, unit.clone(), condition)).collect::<Vec<_>>()
        };
        self.answers.iter().flat_map(field).collect()
    }

    /// The cells of a position: numbers in the author's units, 1 and 0 for conditions, NaN where there is no answer.
    #[cfg(feature = "arrow")]
    pub fn write_cells(
        &self,
        answers: &Answers<'_>,
        pose: &Pose,
        whole: &[Option<Value>],
        out: &mut Vec<f64>,
    ) {
        out.clear();
        self.each_value(0, answers, pose, whole, |answer, value| match (value, answer.vector) {
            (Some(Value::Vector(v)), true) => out.extend([v.x, v.y].map(|x| answer.display.of_si(x))),
            (Some(Value::Scalar(x)), false) => out.push(answer.display.of_si(x)),
            (Some(Value::Bool(truth)), false) => out.push(f64::from(u8::from(truth))),
            (_, true) => out.extend([f64::NAN; 2]),
            (_, false) => out.push(f64::NAN),
        });
    }

    /// The same columns as numbers, with what needs no pose known. `None` where some depend on more than a state.
    #[must_use]
    pub fn numbers(&self, whole: &[Option<Value>]) -> Option<NumberColumns> {
        let mut columns = NumberColumns::default();
        for (i, answer) in self.answers.iter().enumerate() {
            let shown = match &answer.content {
                Content::Drive(i) => Shown::Drive(*i),
                Content::Find { index, poseless: false } => Shown::Find(*index),
                Content::Find { poseless: true, .. } => Shown::Known(whole.get(i).copied().flatten()),
                Content::Effort(slot) => Shown::Effort(*slot),
                Content::Reaction(_, _, joints) if self.placed => Shown::Force(joints.clone()?),
                Content::Moment(_, _, joints) if self.placed => Shown::Couple(joints.clone()?),
                Content::Reaction(..) | Content::Moment(..) => return None,
            };
            columns.push(shown, answer.vector, &answer.display);
        }
        Some(columns)
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
