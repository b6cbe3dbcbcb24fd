//! Answers of many rows of variants, one line per row and pose: what stands in a column is found once.

use super::answers::{Answers, pose_header, with_unit};
use super::csv;
use super::reactions::moment;
use super::simulation;
use crate::exercise::turns;
use assur_math::math::Vec2;
use assur_model::model::{
    Bearing, Display, DriveTarget, FindKind, LinkId, Mechanism, PairId, PairKind, Value,
};
use assur_solve::solve::{
    DriveValue, JointReaction, Model, MotionScales, Pose, PoseAnswers, State, unplaced_reactions,
};
use assur_text::units::{Dimension, lookup, push_significant};

/// Digits that survive the way from SI into the author's unit: 30 deg stay 30 deg.
pub const FULL: usize = 15;
/// In a key an answer is 0 below this part of what is large for it.
pub(super) const ROUNDING: f64 = 1e-12;

/// What a column shows, or two for a vector.
#[derive(Clone, Debug)]
pub(super) enum Content {
    Drive(usize),
    Find {
        index: usize,
        poseless: bool,
    },
    Effort(usize),
    /// With its joints, where they alone make it up.
    Reaction(PairId, LinkId, Option<JointReaction>),
    Moment(PairId, LinkId, Option<JointReaction>),
}

#[derive(Clone, Debug)]
pub(super) struct Answer {
    pub name: String,
    pub content: Content,
    pub vector: bool,
    pub display: Display,
}

/// The columns of the answers of a file: drives, quantities, what needs no pose, reactions where they are asked for.
#[derive(Clone, Debug, Default)]
pub struct AnswerColumns {
    pub(super) drives: usize,
    /// Heads the column of poses, or of instants.
    pose: String,
    /// They are of a motion under loads.
    moves: bool,
    /// A column says which events happen at an instant.
    events: bool,
    pub(super) answers: Vec<Answer>,
    /// Every reaction among them has a place, whatever the values of the givens.
    pub(super) placed: bool,
}

impl AnswerColumns {
    /// Those of a file, whatever the values of its givens.
    #[must_use]
    pub fn of(model: &Model<'_>) -> Self {
        let mut columns = Self::with_moments(model, false).each_once();
        // with other values a reaction may be made up of others, as where nothing rubs any more
        for answer in &mut columns.answers {
            if let Content::Reaction(_, _, joints) | Content::Moment(_, _, joints) = &mut answer.content {
                *joints = None;
            }
        }
        columns
    }

    /// With the moments of transmissions, or without.
    fn with_moments(model: &Model<'_>, of_transmissions: bool) -> Self {
        let mechanism = model.mechanism;
        let vectors = &mechanism.vector_quantities();
        let mut answers = Vec::new();
        let driven = mechanism.drives.iter().enumerate().filter(|_| mechanism.simulation.is_none());
        for (i, drive) in driven {
            answers.push(Answer {
                name: drive.name.clone(),
                content: Content::Drive(i),
                vector: matches!(drive.target, DriveTarget::Point(..)),
                display: mechanism.drive_display(drive.target),
            });
        }
        let drives = answers.len();
        let finds = |without_pose: bool| {
            mechanism.finds.iter().enumerate().filter_map(move |(index, find)| match &find.kind {
                FindKind::Value { expr, display, poseless } if *poseless == without_pose => Some(Answer {
                    name: find.name.clone(),
                    content: Content::Find { index, poseless: *poseless },
                    vector: mechanism.is_vector(expr, vectors),
                    display: display.clone(),
                }),
                _ => None,
            })
        };
        answers.extend(finds(false));
        let solution = assur_solve::solve::Solution::default();
        let precision = super::PrintedDigits::READABLE;
        let blank = Answers { model: *model, solution: &solution, outcomes: &[], reached: None, precision };
        for (slot, effort) in blank.efforts().into_iter().enumerate() {
            let wanted = effort.of_drive || blank.wants_reactions();
            if wanted && !answers[drives..].iter().any(|a| effort.is_named(&a.name)) {
                let (name, display) = (effort.name, effort.display);
                answers.push(Answer { name, content: Content::Effort(slot), vector: false, display });
            }
        }
        answers.extend(finds(true));
        if blank.wants_reactions() && !model.plan.reactions.is_empty() {
            all_reactions(model, of_transmissions, &mut answers);
        }
        // without transmissions and open bearings nothing is left open
        let open = mechanism.pairs.iter().any(|pair| pair.bearing == Some(Bearing::Open));
        let pose = pose_header(mechanism);
        let events = simulation::names_events(mechanism);
        let moves = mechanism.simulation.is_some();
        Self { drives, pose, moves, events, answers, placed: !open && model.plan.laws.is_empty() }
    }

    /// Those of one file alone: without the reactions that depend on a place that the file leaves open.
    #[must_use]
    pub fn of_file(model: &Model<'_>) -> Self {
        let unplaced = unplaced_reactions(model);
        let mut columns = Self::with_moments(model, true);
        columns.answers.retain(|answer| match answer.content {
            Content::Reaction(pair, ..) | Content::Moment(pair, ..) => !unplaced[pair.index()],
            _ => true,
        });
        Self { placed: true, ..columns }
    }

    /// What heads the column of poses, or of instants.
    #[must_use]
    pub fn pose_header(&self) -> &str {
        &self.pose
    }

    /// Whether they are of a motion under loads.
    #[must_use]
    pub const fn moves(&self) -> bool {
        self.moves
    }

    /// Whether a column says which events happen at an instant.
    #[must_use]
    pub const fn names_events(&self) -> bool {
        self.events
    }

    /// The events that happen at the instant of a pose, where a column says so.
    #[must_use]
    pub fn events_at(&self, answers: &Answers<'_>, pose: &Pose) -> Option<String> {
        self.events.then(|| simulation::events_at(answers, pose))
    }

    /// The headers: names with units in brackets, `.x` and `.y` for the components of vectors. Without the drives for an
    /// answer key.
    #[must_use]
    pub fn headers(&self, key: bool) -> Vec<String> {
        let shown = &self.answers[if key { self.drives } else { 0 }..];
        shown.iter().flat_map(|a| a.columns().map(|name| with_unit(&name, &a.display.unit))).collect()
    }

    /// The cells of a key that say of which angles whole turns count, each with a comma before it; `None` where of none.
    #[must_use]
    pub fn counted_turns(&self, mechanism: &Mechanism) -> Option<String> {
        let is_counted = |answer: &Answer| {
            let Content::Find { index, .. } = answer.content else { return false };
            let FindKind::Value { expr, .. } = &mechanism.finds[index].kind else { return false };
            let is_angle = lookup(&answer.display.unit).is_ok_and(|unit| unit.dimension == Dimension::ANGLE);
            is_angle && !turns::is_direction(mechanism, expr)
        };
        let shown = &self.answers[self.drives..];
        let cells = shown.iter().map(|answer| match (is_counted(answer), answer.vector) {
            (true, _) => ",counted",
            (false, true) => ",,",
            (false, false) => ",",
        });
        shown.iter().any(is_counted).then(|| cells.collect())
    }

    /// Writes the answers at a pose, each with a comma before it; empty where there is none.
    pub fn write(&self, answers: &Answers<'_>, pose: &Pose, digits: usize, key: bool, out: &mut String) {
        let mut line = Vec::new();
        let greatest = key.then(|| answers.greatest());
        self.write_beside(answers, pose, &self.whole(answers), (digits, key, greatest.as_ref()), &mut line);
        out.push_str(std::str::from_utf8(&line).unwrap_or_default());
    }

    /// The answers that need no pose where there are any; else nothing, which serves as well.
    #[must_use]
    pub fn whole_if_any(&self, answers: &Answers<'_>) -> Vec<Option<Value>> {
        let any = self.answers.iter().any(|a| matches!(a.content, Content::Find { poseless: true, .. }));
        if any { self.whole(answers) } else { Vec::new() }
    }

    /// The answers that need no pose, by column.
    #[must_use]
    pub fn whole(&self, answers: &Answers<'_>) -> Vec<Option<Value>> {
        let value = |answer: &Answer| match answer.content {
            Content::Find { index, poseless: true } => self.without_pose(answers, index),
            _ => None,
        };
        self.answers.iter().map(value).collect()
    }

    /// As [`AnswerColumns::write`], with what needs no pose known; a text in bytes. A key has no drives. With what its quantities are
    /// large against what is rounding is 0.
    pub fn write_beside(
        &self,
        answers: &Answers<'_>,
        pose: &Pose,
        whole: &[Option<Value>],
        (digits, key, greatest): (usize, bool, Option<&MotionScales>),
        out: &mut Vec<u8>,
    ) {
        let from = if key { self.drives } else { 0 };
        let part = if key { ROUNDING } else { answers.precision.noise };
        self.each_value(from, answers, pose, whole, |answer, value| {
            let value = greatest.map_or(value, |greatest| answer.cleared(value, greatest, part));
            answer.write(value, digits, out);
        });
    }

    /// The names of the answers, drives first.
    pub fn names(&self) -> impl Iterator<Item = String> {
        self.answers.iter().map(|a| a.name.clone())
    }

    /// How each is printed.
    pub fn displays(&self) -> impl Iterator<Item = &Display> {
        self.answers.iter().map(|a| &a.display)
    }

    /// The answers at a pose, SI, with what needs no pose known; `None` where one does not exist.
    #[must_use]
    pub fn values(&self, answers: &Answers<'_>, pose: &Pose, whole: &[Option<Value>]) -> Vec<Option<Value>> {
        let mut values = Vec::with_capacity(self.answers.len());
        self.each_value(0, answers, pose, whole, |_, value| values.push(value));
        values
    }

    pub(super) fn each_value(
        &self,
        from: usize,
        answers: &Answers<'_>,
        pose: &Pose,
        whole: &[Option<Value>],
        mut each: impl FnMut(&Answer, Option<Value>),
    ) {
        let shown = &self.answers[from..];
        let solved = pose.outcome.as_ref().ok();
        let view = solved.map(|solved| answers.solution.view(&answers.model, solved));
        let asked = || shown.iter().any(|a| matches!(a.content, Content::Reaction(..) | Content::Moment(..)));
        let unplaced = if !self.placed && asked() { unplaced_reactions(&answers.model) } else { Vec::new() };
        let pressing = |pair: PairId| {
            let known = !answers.model.plan.reactions.is_empty()
                && solved.is_some_and(|s| !s.state.forces.locked)
                && !unplaced.get(pair.index()).copied().unwrap_or(false);
            view.as_ref().filter(|_| known)
        };
        let value = |(i, answer): (usize, &Answer)| match &answer.content {
            Content::Drive(i) => pose.drives.get(*i).and_then(DriveValue::value),
            Content::Find { index, poseless: false } => view.as_ref().and_then(|view| view.found(*index)),
            Content::Find { poseless: true, .. } => whole.get(from + i).copied().flatten(),
            Content::Effort(slot) => {
                view.as_ref().map(|view| view.effort(*slot)).filter(|x| x.is_finite()).map(Value::Scalar)
            }
            Content::Reaction(pair, on, joints) => pressing(*pair).map(|view| {
                Value::Vector(match joints {
                    Some(joints) => joints.force(view.state),
                    None => view.reaction(*pair, *on),
                })
            }),
            Content::Moment(pair, on, joints) => pressing(*pair)
                .and_then(|view| match joints {
                    Some(joints) => Some(joints.couple(view.state)).filter(|x| x.is_finite()),
                    None => moment(view, *pair, *on),
                })
                .map(Value::Scalar),
        };
        for (i, answer) in shown.iter().enumerate() {
            each(answer, value((i, answer)));
        }
    }

    /// Writes what needs no pose, for a file that has none.
    pub fn write_without_pose(&self, answers: &Answers<'_>, digits: usize, key: bool, out: &mut String) {
        let mut line = Vec::new();
        for answer in &self.answers[if key { self.drives } else { 0 }..] {
            let value = match answer.content {
                Content::Find { index, poseless: true } => self.without_pose(answers, index),
                _ => None,
            };
            answer.write(value, digits, &mut line);
        }
        out.push_str(std::str::from_utf8(&line).unwrap_or_default());
    }

    /// Writes no answers: a comma each.
    pub fn write_none(&self, key: bool, out: &mut String) {
        for answer in &self.answers[if key { self.drives } else { 0 }..] {
            out.push_str(if answer.vector { ",," } else { "," });
        }
    }

    fn without_pose(&self, answers: &Answers<'_>, index: usize) -> Option<Value> {
        let plan = answers.model.plan;
        let state = State::new(plan);
        let angles = vec![0.0; plan.bodies];
        let view = PoseAnswers::new(&answers.model, &state, &angles, &answers.solution.statics);
        let quantities = view.all_quantities();
        PoseAnswers { quantities: &quantities, ..view }.found(index)
    }
}

fn all_reactions(model: &Model<'_>, of_transmissions: bool, answers: &mut Vec<Answer>) {
    let mechanism = model.mechanism;
    let state = State::closed(model.plan);
    let view = PoseAnswers::bare(model, &state);
    for (i, pair) in mechanism.pairs.iter().enumerate() {
        let id = PairId::at(i);
        let links = pair.kind.links();
        let determined = model.structure.undetermined_couples.binary_search(&id).is_err();
        let couple = match pair.kind {
            PairKind::Revolute(_) | PairKind::Weld { .. } => true,
            PairKind::Prismatic(_) => determined,
            PairKind::Transmission(_) => of_transmissions,
            _ => false,
        };
        for &on in links.iter().skip(1) {
            let name = |what: &str| format!("{what}({}, {})", pair.name, mechanism.link(on).name);
            let display = mechanism.display_of(Dimension::FORCE);
            let joints = || JointReaction::of(&view, id, on);
            let content = Content::Reaction(id, on, joints());
            answers.push(Answer { name: name("reaction"), content, vector: true, display });
            if couple {
                let display = mechanism.display_of(Dimension::TORQUE);
                let content = Content::Moment(id, on, if determined { joints() } else { None });
                answers.push(Answer { name: name("moment"), content, vector: false, display });
            }
        }
    }
}

impl Answer {
    /// The names of its columns: `.x` and `.y` for the components of a vector.
    pub(super) fn columns(&self) -> impl Iterator<Item = String> {
        let parts: &[&str] = if self.vector { &[".x", ".y"] } else { &[""] };
        parts.iter().map(|part| format!("{}{part}", self.name))
    }

    /// Without what is rounding.
    pub(super) fn cleared(&self, value: Option<Value>, greatest: &MotionScales, part: f64) -> Option<Value> {
        let large = greatest.in_si(self.display.dimension);
        let clear = |x: f64| if x.abs() <= part * large { 0.0 } else { x };
        Some(match value? {
            Value::Scalar(x) => Value::Scalar(clear(x)),
            Value::Vector(v) => Value::Vector(Vec2::new(clear(v.x), clear(v.y))),
            truth @ Value::Bool(_) => truth,
        })
    }

    #[inline]
    fn write(&self, value: Option<Value>, digits: usize, out: &mut Vec<u8>) {
        let number = |x: f64, out: &mut Vec<u8>| {
            out.push(b',');
            if x.is_finite() {
                push_significant(out, self.display.of_si(x), digits);
            }
        };
        match (value, self.vector) {
            (Some(Value::Vector(Vec2 { x, y })), true) => {
                number(x, out);
                number(y, out);
            }
            (Some(Value::Scalar(x)), false) => number(x, out),
            (Some(Value::Bool(truth)), false) => {
                out.extend_from_slice(if truth { b",true" } else { b",false" });
            }
            (_, true) => out.extend_from_slice(b",,"),
            (_, false) => out.push(b','),
        }
    }
}

/// Writes a text as a cell, in quotes where it needs them.
pub fn write_text(text: &str, out: &mut String) {
    out.push_str(&csv::field(text));
}
