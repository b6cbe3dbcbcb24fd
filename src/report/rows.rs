//! What a file asks for, in its order: the columns of tables of answers, of keys, of sheets and of questions in courses. What stands in
//! a column is found once.

use super::answers::{Answers, pose_header, with_unit};
use super::columns::EffortEntry;
use super::csv;
use super::places::AnswerLine;
use super::reactions::moment;
use super::simulation;
use crate::exercise::turns;
use assur_math::math::Vec2;
use assur_model::model::{
    Bearing, Display, Drive, DriveTarget, FindKind, LinkId, Mechanism, PairId, PairKind, Value,
};
use assur_solve::solve::{
    DriveValue, JointReaction, Model, MotionScales, Pose, PoseAnswers, State, unplaced_reactions,
};
use assur_text::units::{Dimension, lookup, push_significant, significant};

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
    /// The file asks for it: it is in keys and on sheets, unlike drives and their own efforts.
    pub asked: bool,
}

/// The columns of the answers of a file: drives, what `find` asks for in its order, efforts of drives that no balance replaces.
#[derive(Clone, Debug, Default)]
pub struct AnswerColumns {
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
        let driven = mechanism.drives.iter().enumerate().filter(|_| mechanism.simulation.is_none());
        let of_drive = |(i, drive): (usize, &Drive)| Answer {
            name: drive.name.clone(),
            content: Content::Drive(i),
            vector: matches!(drive.target, DriveTarget::Point(..)),
            display: mechanism.drive_display(drive.target),
            asked: false,
        };
        let mut answers: Vec<Answer> = driven.map(of_drive).collect();
        let (all, own) = Self::unasked_efforts(model);
        for (index, find) in mechanism.finds.iter().enumerate() {
            match &find.kind {
                FindKind::Value { expr, display, poseless } => answers.push(Answer {
                    name: find.name.clone(),
                    content: Content::Find { index, poseless: *poseless },
                    vector: mechanism.is_vector(expr, vectors),
                    display: display.clone(),
                    asked: true,
                }),
                FindKind::Reactions => {
                    answers.extend(all.iter().cloned());
                    if !model.plan.reactions.is_empty() {
                        all_reactions(model, of_transmissions, &mut answers);
                    }
                }
                FindKind::Table(_) => {}
            }
        }
        answers.extend(own);
        // without transmissions and open bearings nothing is left open
        let open = mechanism.pairs.iter().any(|pair| pair.bearing == Some(Bearing::Open));
        let pose = pose_header(mechanism);
        let events = simulation::names_events(mechanism);
        let moves = mechanism.simulation.is_some();
        Self { pose, moves, events, answers, placed: !open && model.plan.laws.is_empty() }
    }

    /// The efforts that no item of `find` names: those that `find reactions` asks for, and else the drives' own, which nobody asks for.
    fn unasked_efforts(model: &Model<'_>) -> (Vec<Answer>, Vec<Answer>) {
        let solution = assur_solve::solve::Solution::default();
        let precision = super::PrintedDigits::READABLE;
        let blank = Answers { model: *model, solution: &solution, outcomes: &[], reached: None, precision };
        let asked = blank.wants_reactions();
        let is_named =
            |effort: &EffortEntry| model.mechanism.finds.iter().any(|find| effort.is_named(&find.name));
        let efforts = blank.efforts().into_iter().enumerate();
        let wanted = efforts.filter(|(_, effort)| (asked || effort.of_drive) && !is_named(effort));
        let of = |(slot, effort): (usize, EffortEntry)| {
            let EffortEntry { name, display, .. } = effort;
            Answer { name, content: Content::Effort(slot), vector: false, display, asked }
        };
        let efforts = wanted.map(of).collect();
        if asked { (efforts, Vec::new()) } else { (Vec::new(), efforts) }
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

    /// The events that happen at the instant of a line, where a column says so.
    #[must_use]
    pub fn events_of(&self, answers: &Answers<'_>, line: &AnswerLine<'_>) -> Option<String> {
        let at = |pose| simulation::events_at(answers, pose);
        self.events.then(|| line.pose.map_or_else(String::new, at))
    }

    /// The answers of a key, or all.
    fn shown(&self, key: bool) -> impl Iterator<Item = &Answer> {
        self.answers.iter().filter(move |answer| answer.asked || !key)
    }

    /// The headers: names with units in brackets, `.x` and `.y` for the components of vectors. Without the drives for an
    /// answer key.
    #[must_use]
    pub fn headers(&self, key: bool) -> Vec<String> {
        self.shown(key).flat_map(|a| a.columns().map(|name| with_unit(&name, &a.display.unit))).collect()
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
        let cells = self.shown(true).map(|answer| match (is_counted(answer), answer.vector) {
            (true, _) => ",counted",
            (false, true) => ",,",
            (false, false) => ",",
        });
        self.shown(true).any(is_counted).then(|| cells.collect())
    }

    /// The answers that need no pose, by column; nothing where there is none, which serves as well.
    #[must_use]
    pub fn whole(&self, answers: &Answers<'_>) -> Vec<Option<Value>> {
        if !self.answers.iter().any(Answer::is_whole) {
            return Vec::new();
        }
        let value = |answer: &Answer| match answer.content {
            Content::Find { index, poseless: true } => self.without_pose(answers, index),
            _ => None,
        };
        self.answers.iter().map(value).collect()
    }

    /// Writes the answers of a line, each with a comma before it; a text in bytes. What needs no pose is known, and empty where the line
    /// does not have it. With what its quantities are large against what is rounding is 0.
    pub fn write(
        &self,
        answers: &Answers<'_>,
        (pose, whole): (Option<&Pose>, &[Option<Value>]),
        (digits, key, greatest): (usize, bool, Option<&MotionScales>),
        out: &mut Vec<u8>,
    ) {
        let part = if key { ROUNDING } else { answers.precision.noise };
        self.each_value(key, answers, (pose, whole), |answer, value| {
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

    /// The answers of a line, SI, with what needs no pose known; `None` where one does not exist.
    #[must_use]
    pub fn values(
        &self,
        answers: &Answers<'_>,
        pose: Option<&Pose>,
        whole: &[Option<Value>],
    ) -> Vec<Option<Value>> {
        let mut values = Vec::with_capacity(self.answers.len());
        self.each_value(false, answers, (pose, whole), |_, value| values.push(value));
        values
    }

    pub(super) fn each_value(
        &self,
        key: bool,
        answers: &Answers<'_>,
        (pose, whole): (Option<&Pose>, &[Option<Value>]),
        mut each: impl FnMut(&Answer, Option<Value>),
    ) {
        let solved = pose.and_then(|pose| pose.outcome.as_ref().ok());
        let view = solved.map(|solved| answers.solution.view(&answers.model, solved));
        let asked =
            || self.answers.iter().any(|a| matches!(a.content, Content::Reaction(..) | Content::Moment(..)));
        let unplaced = if !self.placed && asked() { unplaced_reactions(&answers.model) } else { Vec::new() };
        let pressing = |pair: PairId| {
            let known = !answers.model.plan.reactions.is_empty()
                && solved.is_some_and(|s| !s.state.forces.locked)
                && !unplaced.get(pair.index()).copied().unwrap_or(false);
            view.as_ref().filter(|_| known)
        };
        let value = |(i, answer): (usize, &Answer)| match &answer.content {
            Content::Drive(i) => pose.and_then(|pose| pose.drives.get(*i)).and_then(DriveValue::value),
            Content::Find { index, poseless: false } => view.as_ref().and_then(|view| view.found(*index)),
            Content::Find { poseless: true, .. } => whole.get(i).copied().flatten(),
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
        for (i, answer) in self.answers.iter().enumerate().filter(|(_, a)| a.asked || !key) {
            each(answer, value((i, answer)));
        }
    }

    /// Writes no answers: a comma each.
    pub fn write_none(&self, key: bool, out: &mut String) {
        for answer in self.shown(key) {
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
            answers.push(Answer { name: name("reaction"), content, vector: true, display, asked: true });
            if couple {
                let display = mechanism.display_of(Dimension::TORQUE);
                let content = Content::Moment(id, on, if determined { joints() } else { None });
                answers.push(Answer { name: name("moment"), content, vector: false, display, asked: true });
            }
        }
    }
}

impl Answer {
    /// It needs no pose: it is asked for once.
    pub(super) const fn is_whole(&self) -> bool {
        matches!(self.content, Content::Find { poseless: true, .. })
    }

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

    /// Its cells with all digits; empty where there is no value.
    pub(super) fn cells(&self, value: Option<Value>) -> Vec<String> {
        let number =
            |x: f64| if x.is_finite() { significant(self.display.of_si(x), FULL) } else { String::new() };
        match (value, self.vector) {
            (Some(Value::Vector(v)), true) => vec![number(v.x), number(v.y)],
            (Some(Value::Scalar(x)), false) => vec![number(x)],
            (Some(Value::Bool(truth)), false) => vec![truth.to_string()],
            (_, vector) => vec![String::new(); 1 + usize::from(vector)],
        }
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
