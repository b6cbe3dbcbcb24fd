//! What a file asks for with its answers at a position: the columns of an answer key.

use super::answers::Answers;
use super::rows::AnswerColumns;
use assur_model::model::Value;
use assur_solve::solve::Pose;
use assur_worked::Asked;

impl AnswerColumns {
    /// The questions with their answers at a pose; those that need none where there is none.
    #[must_use]
    pub fn asked(&self, answers: &Answers<'_>, pose: Option<&Pose>) -> Vec<Asked> {
        let (whole, greatest) = (self.whole(answers), answers.greatest());
        let values = match pose {
            Some(pose) => self.values(answers, pose, &whole),
            None => whole,
        };
        let of = |(answer, value): (&super::rows::Answer, Option<Value>)| {
            let display = &answer.display;
            let value = if pose.is_some() { answer.cleared(value, &greatest) } else { value };
            let value = value.map(|value| match value {
                Value::Scalar(x) => Value::Scalar(display.of_si(x)),
                Value::Vector(v) => Value::Vector(display.of_si_vector(v)),
                truth @ Value::Bool(_) => truth,
            });
            Asked {
                name: answer.name.clone(),
                unit: display.unit.clone(),
                factor: display.factor,
                vector: answer.vector,
                whole: matches!(answer.content, super::rows::Content::Find { poseless: true, .. }),
                value,
            }
        };
        self.answers.iter().zip(values).skip(self.drives).map(of).collect()
    }
}
