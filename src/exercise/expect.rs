//! Every `expect` of a file against its solution.

use super::error::ExpectError;
use super::turns;
use super::undefined::{is_settled, not_happened, truth, why_undefined, without_cycle};
use assur_model::model::{
    At, Comparison, Display, DriveId, Expect, Expr, Find, FindKind, Occasion, Query, Relation, Tolerance,
    Value,
};
use assur_solve::message::failure;
use assur_solve::solve::{DriveValue, Model, Pose, PoseAnswers, PoseOrigin, Solution, State, compare};
use assur_text::diagnostic::Problems;
use assur_text::source::Span;
use assur_text::units::Dimension;

/// The outcome of one expectation at one pose.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// The left side, as written.
    pub text: String,
    /// The pose's name; `None` where no pose is needed.
    pub pose: Option<String>,
    /// The pose in words, as ` at pose 3`; empty where there is no other.
    pub place: String,
    /// The comparison; `None` for an equality and for a condition.
    pub comparison: Option<Comparison>,
    /// The expected value, the bound of a comparison, or `true` for a condition; SI.
    pub expected: Value,
    /// The computed value, SI.
    pub got: Value,
    /// The greatest difference allowed, SI; `None` for comparisons and conditions.
    pub within: Option<f64>,
    pub passed: bool,
    /// Compared modulo a turn.
    pub turns_free: bool,
    /// Place of the statement.
    pub span: Span,
    /// How it is printed.
    pub display: Display,
}

/// Holds the solution against the answer key: one outcome per expectation and pose, in the order of the file.
///
/// What could not be evaluated joins `problems`: each of them is an error of the file. A value that differs from the
/// expected one is not among them, see [`super::mismatches`]. Of a motion that has failed the cause is there already: what
/// `find` misses then is not said.
#[must_use]
pub fn evaluate(model: &Model<'_>, solution: &Solution, problems: &mut Problems) -> Vec<Outcome> {
    let mut key = Key { model, solution, outcomes: Vec::new(), errors: Vec::new() };
    for (index, expect) in model.mechanism.expects.iter().enumerate() {
        if let Err(error) = key.expect(index, expect) {
            key.errors.push(error);
        }
    }
    let has_failed = solution.simulation.is_some() && problems.has_errors();
    let missing = if has_failed { Vec::new() } else { key.answers() };
    problems.extend(ExpectError::of_failed_poses(key.errors));
    problems.extend(missing);
    key.outcomes
}

struct Key<'a> {
    model: &'a Model<'a>,
    solution: &'a Solution,
    outcomes: Vec<Outcome>,
    errors: Vec<ExpectError>,
}

impl<'a> Key<'a> {
    /// The functions and instants that `find` asks for and that do not exist, as far as no expectation names them.
    fn answers(&self) -> Vec<ExpectError> {
        let (model, solution) = (self.model, self.solution);
        let expected = |name: &str| model.mechanism.expects.iter().any(|expect| expect.text == name);
        let answer = |find: &Find| {
            let FindKind::Value { expr, .. } = &find.kind else { return None };
            let why = without_cycle(model, solution, expr).filter(|_| !expected(&find.name))?;
            let mut of_event = false;
            expr.queries(&mut |query| {
                of_event |= matches!(query, Query::EventTime(..) | Query::EventDrive(..))
            });
            let help = match &model.mechanism.simulation {
                None if of_event => "let the drive go on for longer, or ask for what the condition compares",
                Some(_) if is_settled(model, solution, expr) => {
                    "change the value that the event compares, or the loads: a longer motion comes no nearer to it"
                }
                Some(_) => {
                    "let `simulate` end later, or ask for a part of the motion that exists and in which the quantity is defined: \
                     `max(…, after = …, before = …)`"
                }
                None => {
                    "look at the poses there, or ask over a shorter sweep on which the quantity is defined"
                }
            };
            Some(ExpectError::NoAnswer { text: find.name.clone(), why, span: find.span, help })
        };
        model.mechanism.finds.iter().filter_map(answer).collect()
    }

    fn expect(&mut self, index: usize, expect: &Expect) -> Result<(), ExpectError> {
        if expect.poseless {
            return self.without_pose(expect);
        }
        let poses = self.poses(index, expect)?;
        let mut failed = None;
        for (case, pose) in poses.into_iter().enumerate() {
            match &pose.outcome {
                Ok(solved) => {
                    let view = self.solution.view(self.model, solved);
                    let outcome = self.outcome(expect, case, Some(pose), &view)?;
                    self.outcomes.push(outcome);
                }
                Err(why) => {
                    let pose_failed = || ExpectError::pose_failed(expect, &failure(self.model, why));
                    failed = failed.or_else(|| Some(pose_failed()));
                }
            }
        }
        failed.map_or(Ok(()), Err)
    }

    /// Values that depend on no pose are asked of a mechanism at rest.
    fn without_pose(&mut self, expect: &Expect) -> Result<(), ExpectError> {
        let plan = self.model.plan;
        let state = State::new(plan);
        let angles = vec![0.0; plan.bodies];
        let view = PoseAnswers::new(self.model, &state, &angles, &self.solution.statics);
        let quantities = view.all_quantities();
        let view = PoseAnswers { quantities: &quantities, ..view };
        let outcome = self.outcome(expect, 0, None, &view)?;
        self.outcomes.push(outcome);
        Ok(())
    }

    /// The poses it holds for: those it names, the file's one, or all of a sweep for a list.
    fn poses(&self, index: usize, expect: &Expect) -> Result<Vec<&'a Pose>, ExpectError> {
        let poses = &self.solution.poses;
        let values = values(expect);
        let sweep = || poses.iter().filter(|p| matches!(p.origin, PoseOrigin::Sweep(_))).collect::<Vec<_>>();
        let found = match &expect.at {
            Some(At::Pose(name, span)) => {
                let own = |p: &&Pose| !matches!(p.origin, PoseOrigin::Expected(_));
                match poses.iter().filter(own).find(|p| p.name == *name) {
                    Some(pose) => vec![pose],
                    None => return Err(ExpectError::unknown_pose(name, *span, poses)),
                }
            }
            Some(At::Drives(_) | At::Time(_) | At::Occasion(_)) => {
                poses.iter().filter(|p| p.origin == PoseOrigin::Expected(index)).collect()
            }
            None => sweep(),
        };
        // those of a long sweep are not kept
        let count = if expect.at.is_none() { self.solution.positions.max(found.len()) } else { found.len() };
        if let (0, Some(At::Occasion(Occasion::Event(event, which)))) = (count, &expect.at) {
            let why = not_happened(self.model, self.solution, *event, *which);
            return Err(ExpectError::no_value(expect, String::new(), why));
        }
        match (count, values) {
            (0, _) => Err(ExpectError::no_solution(expect)),
            (poses, values) if poses == values => Ok(found),
            (_, 1) => Err(ExpectError::needs_pose(expect, count)),
            (poses, values) => Err(ExpectError::list_length(expect, values, poses)),
        }
    }

    /// A pose's own name; the drive values in words where an `expect` adds it.
    fn name(&self, pose: &Pose) -> String {
        let PoseOrigin::Expected(index) = pose.origin else { return pose.name.clone() };
        let mechanism = self.model.mechanism;
        let all: Vec<DriveId> = match (&mechanism.expects[index].at, &self.solution.statics.swept) {
            (Some(At::Drives(list)), _) => list.iter().map(|(id, _)| *id).collect(),
            (Some(At::Occasion(_)), Some(swept)) => vec![DriveId::at(swept.drive)],
            (Some(At::Time(_) | At::Occasion(_)), _) => return self.instant(pose),
            (Some(At::Pose(..)) | None, _) => return pose.name.clone(),
        };
        let texts = all.into_iter().map(|id| {
            let drive = &mechanism.drives[id.index()];
            let display = mechanism.drive_display(drive.target);
            let value = pose.drives.get(id.index()).and_then(DriveValue::value);
            let text = value.map(|v| display.text(v, 6)).unwrap_or_default();
            format!("{} = {text}", drive.name)
        });
        texts.collect::<Vec<_>>().join(", ")
    }

    /// The pose, after a sentence.
    fn place(&self, pose: &Pose) -> String {
        match pose.origin {
            PoseOrigin::Expected(_) => format!(" at {}", self.name(pose)),
            _ if self.model.mechanism.simulation.is_some() => format!(" at {}", self.instant(pose)),
            _ if self.solution.poses.len().max(self.solution.positions) == 1 => String::new(),
            _ => format!(" at pose {}", pose.name),
        }
    }

    /// `time = 0.5 s`
    fn instant(&self, pose: &Pose) -> String {
        format!("time = {} {}", pose.name, self.model.mechanism.display_of(Dimension::TIME).unit)
    }

    fn outcome(
        &self,
        expect: &Expect,
        case: usize,
        pose: Option<&Pose>,
        view: &PoseAnswers<'_>,
    ) -> Result<Outcome, ExpectError> {
        let place = pose.map_or_else(String::new, |p| self.place(p));
        let value = |expr: &Expr| -> Result<Value, ExpectError> {
            let found = match view.value(expr) {
                Value::Bool(_) => truth(view, expr).map(Value::Bool),
                value => Some(value).filter(Value::is_defined),
            };
            if let Some(value) = found {
                return Ok(value);
            }
            let locked = || "friction locks the mechanism, so no effort moves it".to_owned();
            let why = why_undefined(self.model, expr)
                .or_else(|| without_cycle(self.model, self.solution, expr))
                .or_else(|| view.state.forces.locked.then(locked));
            Err(ExpectError::no_value(expect, place.clone(), why))
        };
        let got = value(&expect.expr)?;
        let mut outcome = Outcome {
            text: expect.text.clone(),
            pose: pose.map(|p| self.name(p)),
            place: place.clone(),
            comparison: None,
            expected: Value::Bool(true),
            got,
            within: None,
            passed: got == Value::Bool(true),
            turns_free: false,
            span: expect.span,
            display: expect.display.clone(),
        };
        match &expect.relation {
            Relation::Condition => {}
            Relation::Compare(how, expr) => {
                outcome.expected = value(expr)?;
                outcome.comparison = Some(*how);
                outcome.passed = match (got, outcome.expected) {
                    (Value::Scalar(a), Value::Scalar(b)) => compare(*how, a, b),
                    _ => false,
                };
            }
            Relation::Equal(list) => {
                let Some(expr) = list.get(case) else { return Ok(outcome) };
                outcome.expected = equal::shaped_like(got, value(expr)?);
                outcome.turns_free = expect.angle
                    && turns::are_free(outcome.expected.magnitude(), expect.display.factor)
                    && turns::is_direction(self.model.mechanism, &expect.expr);
                let within = match &expect.tolerance {
                    Tolerance::Relative(r) => {
                        r * turns::scale(outcome.turns_free, outcome.expected.magnitude())
                    }
                    Tolerance::Absolute(a) => *a,
                    Tolerance::Written(each) => each.get(case).copied().unwrap_or(0.0),
                    Tolerance::None => 0.0,
                };
                outcome.within = Some(within);
                outcome.passed = is_within(outcome.difference().magnitude(), within);
            }
        }
        Ok(outcome)
    }
}

/// How many values stand on the right side.
fn values(expect: &Expect) -> usize {
    match &expect.relation {
        Relation::Equal(list) => list.len(),
        Relation::Compare(..) | Relation::Condition => 1,
    }
}

impl Outcome {
    /// The computed minus the expected value, SI; without whole turns for directions. A condition has none.
    #[must_use]
    pub fn difference(&self) -> Value {
        equal::difference(self.got, self.expected, self.turns_free)
    }

    /// The expectation, as `= 26 N*m`, `> 40 deg`; empty for a condition.
    #[must_use]
    pub fn expectation(&self, digits: usize) -> String {
        bound(self.comparison, &self.display, self.expected, digits)
    }
}

// How values are compared.

/// Rounding of the tolerance itself does not decide: 1.73 and 1.72 differ by 0.01.
const SLACK: f64 = 1.0 + 1e-9;

/// Whether a difference is allowed.
pub fn is_within(difference: f64, within: f64) -> bool {
    difference <= within * SLACK
}

/// The expectation, as `= 26 N*m` or `> 40 deg`; empty for a condition.
pub(super) fn bound(
    comparison: Option<Comparison>,
    display: &Display,
    expected: Value,
    digits: usize,
) -> String {
    if matches!(expected, Value::Bool(_)) {
        return String::new();
    }
    let sign = match comparison {
        None => "=",
        Some(Comparison::Less) => "<",
        Some(Comparison::LessEqual) => "<=",
        Some(Comparison::Greater) => ">",
        Some(Comparison::GreaterEqual) => ">=",
    };
    format!("{sign} {}", display.text(expected, digits))
}

/// Differences between a value and the one expected.
pub mod equal {
    use crate::exercise::turns;
    use assur_math::math::Vec2;
    use assur_model::model::Value;

    /// A literal 0 fits any shape.
    pub fn shaped_like(shape: Value, value: Value) -> Value {
        match (shape, value) {
            (Value::Vector(_), Value::Scalar(0.0)) => Value::Vector(Vec2::zero()),
            _ => value,
        }
    }

    /// The first less the second; NaN where their types differ.
    pub fn difference(got: Value, expected: Value, turns_free: bool) -> Value {
        match (got, expected) {
            (Value::Scalar(a), Value::Scalar(b)) => Value::Scalar(turns::difference(turns_free, a, b)),
            (Value::Vector(a), Value::Vector(b)) => Value::Vector(a - b),
            (Value::Bool(a), Value::Bool(b)) => Value::Scalar(if a == b { 0.0 } else { 1.0 }),
            _ => Value::Scalar(f64::NAN),
        }
    }
}
