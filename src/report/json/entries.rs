//! Values and maps of JSON.

use super::super::{
    mobility::{GroupCount, link_names, welded},
    train::kind_name,
};
use crate::report::{
    answers::Answers,
    cycle::{all_flywheels, named},
};
use assur_math::math::Vec2;
use assur_model::model::{FlywheelPart, PairId, Value};
use assur_model::structure::{BodyId, Group, GroupKind};
use assur_position::plan::Precision;
use assur_solve::measure::accuracy::{AchievedAccuracy, Source};
use assur_solve::solve::{CycleAnswer, Model, PoseAnswers, State};
use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};

/// A finite number; zero has no sign.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub(super) struct Number(f64);

impl Number {
    /// `None` for what is not finite.
    pub fn of(x: f64) -> Option<Self> {
        x.is_finite().then_some(Self(x + 0.0))
    }
}

/// A vector of finite numbers.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub(super) struct Pair([Number; 2]);

impl Pair {
    /// `None` for what is not finite.
    pub fn of(v: Vec2) -> Option<Self> {
        Some(Self([Number::of(v.x)?, Number::of(v.y)?]))
    }
}

/// A value of the language.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub(super) enum Reading {
    Number(Number),
    Pair(Pair),
    Bool(bool),
}

impl Reading {
    /// `None` for what is not finite.
    pub fn of(value: Value) -> Option<Self> {
        match value {
            Value::Scalar(x) => Number::of(x).map(Self::Number),
            Value::Vector(v) => Pair::of(v).map(Self::Pair),
            Value::Bool(truth) => Some(Self::Bool(truth)),
        }
    }
}

/// A map in the order of its entries.
#[derive(Clone, Debug)]
pub(super) struct Entries<T>(pub Vec<(String, T)>);

impl<T> Entries<T> {
    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

impl<T: Serialize> Serialize for Entries<T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.0.len()))?;
        for (key, value) in &self.0 {
            map.serialize_entry(key, value)?;
        }
        map.end()
    }
}

// The accuracy wanted and reached.

#[derive(Serialize)]
pub(super) struct ReachedView {
    within: Option<Number>,
    #[serde(skip_serializing_if = "Option::is_none")]
    error: Option<Number>,
    reference: &'static str,
    numbers: &'static str,
    friction: Option<Number>,
    general_groups: Option<Number>,
    triads: Option<Number>,
    samples: Option<Number>,
    switching_points: Option<Number>,
}

impl ReachedView {
    pub(super) fn of(reached: &AchievedAccuracy) -> Self {
        let settings = &reached.settings;
        Self {
            within: Number::of(reached.within),
            error: Number::of(reached.error),
            reference: match reached.source {
                Source::DoubleDouble => "double-double",
                Source::Full => "condition",
            },
            numbers: match settings.scalar {
                Precision::F64 => "f64",
                Precision::DoubleDouble => "double-double",
            },
            friction: Number::of(settings.friction),
            general_groups: Number::of(settings.newton),
            triads: Number::of(settings.triad),
            samples: Number::of(settings.samples),
            switching_points: Number::of(settings.root),
        }
    }
}

// The structure in JSON.

#[derive(Serialize)]
pub(super) struct StructureView<'a> {
    mobility: i64,
    links: usize,
    lower_pairs: usize,
    higher_pairs: usize,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    welded: Vec<WeldedView<'a>>,
    groups: Vec<GroupView<'a>>,
}

/// Links that are one body.
#[derive(Serialize)]
struct WeldedView<'a> {
    links: Vec<&'a str>,
    welds: Vec<&'a str>,
}

#[derive(Serialize)]
struct GroupView<'a> {
    #[serde(skip_serializing_if = "Option::is_none")]
    name: Option<&'a str>,
    links: Vec<String>,
    class: &'static str,
    kind: &'static str,
    n: usize,
    pl: usize,
    ph: usize,
}

impl<'a> StructureView<'a> {
    /// The numbers of the mechanism and its structural groups; links that are driven alone form none.
    pub fn of(model: &Model<'a>) -> Self {
        let count = &model.structure.count;
        let groups = model.structure.motion.iter().filter(|g| g.kind != GroupKind::Driven);
        Self {
            mobility: count.mobility,
            links: count.n,
            lower_pairs: count.lower,
            higher_pairs: count.higher,
            welded: welded(model).map(|(body, welds)| WeldedView::of(model, body, &welds)).collect(),
            groups: groups.map(|g| GroupView::of(model, g)).collect(),
        }
    }
}

impl<'a> WeldedView<'a> {
    fn of(model: &Model<'a>, body: BodyId, welds: &[PairId]) -> Self {
        let links = model.structure.replaced.links_of(body).into_iter();
        Self {
            links: links.map(|link| model.mechanism.link(link).name.as_str()).collect(),
            welds: welds.iter().map(|weld| model.mechanism.pair(*weld).name.as_str()).collect(),
        }
    }
}

impl<'a> GroupView<'a> {
    fn of(model: &Model<'a>, group: &'a Group) -> Self {
        let count = GroupCount::of(model.structure, group);
        Self {
            name: group.name.as_deref(),
            links: link_names(model, group),
            class: group.class_name(),
            kind: kind_name(model, group),
            n: count.n,
            pl: count.lower,
            ph: count.higher,
        }
    }
}

// Flywheels and the accuracy of functions over the sweep.

#[derive(Serialize)]
pub(super) struct FlywheelView {
    #[serde(skip_serializing_if = "Option::is_none")]
    inertia: Option<Number>,
    #[serde(skip_serializing_if = "Option::is_none")]
    fluctuation: Option<Number>,
    #[serde(skip_serializing_if = "Option::is_none")]
    mean_torque: Option<Number>,
    #[serde(skip_serializing_if = "Option::is_none")]
    speed: Option<Number>,
    #[serde(skip_serializing_if = "Option::is_none")]
    least_at: Option<Number>,
    #[serde(skip_serializing_if = "Option::is_none")]
    greatest_at: Option<Number>,
    #[serde(skip_serializing_if = "Option::is_none")]
    links_inertia: Option<Number>,
    #[serde(skip_serializing_if = "Option::is_none")]
    rim: Option<RimView>,
}

#[derive(Serialize)]
struct RimView {
    width: Number,
    height: Number,
    mass: Number,
}

#[derive(Serialize)]
pub(super) struct AccuracyView {
    error: Number,
    positions: usize,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    splits: Vec<Number>,
}

/// The flywheels by their names.
pub(super) fn flywheels(answers: &Answers<'_>) -> Entries<FlywheelView> {
    let plan = answers.model.plan;
    let state = State::new(plan);
    let angles = vec![0.0; plan.bodies];
    let view = PoseAnswers::new(&answers.model, &state, &angles, &answers.solution.statics);
    let all = all_flywheels(answers).enumerate().map(|(index, (wheel, found))| {
        let part = |part| Number::of(view.flywheel(index, part));
        let rim = || {
            Some(RimView {
                width: part(FlywheelPart::RimWidth)?,
                height: part(FlywheelPart::RimHeight)?,
                mass: part(FlywheelPart::RimMass)?,
            })
        };
        let entry = FlywheelView {
            inertia: Number::of(found.inertia),
            fluctuation: Number::of(found.fluctuation),
            mean_torque: Number::of(found.mean_torque),
            speed: Number::of(found.speed),
            least_at: Number::of(found.extremes[0]),
            greatest_at: Number::of(found.extremes[1]),
            links_inertia: Number::of(found.links[0]),
            rim: wheel.rim.and_then(|_| rim()),
        };
        (wheel.name.clone(), entry)
    });
    Entries(all.collect())
}

/// The effort of functions over the sweep, by the names of the questions.
pub(super) fn accuracy(answers: &Answers<'_>) -> Entries<AccuracyView> {
    let entry = |(name, cycle): (&str, &CycleAnswer)| {
        let error = Number::of(cycle.error).filter(|_| cycle.value.is_finite())?;
        let splits = cycle.splits.iter().filter_map(|x| Number::of(*x)).collect();
        Some((name.to_owned(), AccuracyView { error, positions: cycle.samples, splits }))
    };
    let mut all: Vec<(String, AccuracyView)> = Vec::new();
    for (name, view) in named(answers).into_iter().filter_map(entry) {
        if !all.iter().any(|(n, _)| *n == name) {
            all.push((name, view));
        }
    }
    Entries(all)
}
