//! A pose in JSON.

use miette::Diagnostic;
use serde::Serialize;

use super::super::answers::Answers;
use super::super::reactions::{ReactionEntry, reactions};
use super::entries::{Entries, Number, Pair, Reading};
use super::train::{PartView, ShaftView, SliderView, are_elements, elements, transmissions};
use assur_math::math::Vec2;
use assur_model::model::{Axis, DriveTarget, Link, LinkId};
use assur_position::plan::{Effects, Level};
use assur_solve::message::failure;
use assur_solve::solve::{BodyState, DriveValue, Pose, Solved};
use assur_text::diagnostic::Diagnosis;

#[derive(Serialize)]
pub(super) struct PoseView<'a> {
    name: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    time: Option<Number>,
    drives: Entries<Reading>,
    #[serde(skip_serializing_if = "Option::is_none")]
    error: Option<ErrorView>,
    #[serde(skip_serializing_if = "Entries::is_empty")]
    links: Entries<LinkView>,
    #[serde(skip_serializing_if = "Entries::is_empty")]
    points: Entries<PointView>,
    #[serde(skip_serializing_if = "Entries::is_empty")]
    shafts: Entries<ShaftView>,
    #[serde(skip_serializing_if = "Entries::is_empty")]
    sliders: Entries<SliderView>,
    #[serde(skip_serializing_if = "Entries::is_empty")]
    reactions: Entries<Vec<ReactionView<'a>>>,
    #[serde(skip_serializing_if = "Entries::is_empty")]
    transmissions: Entries<Vec<PartView>>,
    #[serde(skip_serializing_if = "Entries::is_empty")]
    balances: Entries<Number>,
    #[serde(skip_serializing_if = "Entries::is_empty")]
    quantities: Entries<Reading>,
    #[serde(skip_serializing_if = "Option::is_none")]
    residuals: Option<ResidualsView>,
    #[serde(skip_serializing_if = "Option::is_none")]
    condition: Option<Number>,
}

/// Why a pose has no solution.
#[derive(Serialize)]
struct ErrorView {
    #[serde(skip_serializing_if = "Option::is_none")]
    code: Option<String>,
    message: String,
}

#[derive(Serialize)]
struct LinkView {
    #[serde(skip_serializing_if = "Option::is_none")]
    angle: Option<Number>,
    #[serde(skip_serializing_if = "Option::is_none")]
    omega: Option<Number>,
    #[serde(skip_serializing_if = "Option::is_none")]
    alpha: Option<Number>,
    #[serde(skip_serializing_if = "Option::is_none")]
    inertia_force: Option<Pair>,
    #[serde(skip_serializing_if = "Option::is_none")]
    inertia_torque: Option<Number>,
}

#[derive(Serialize)]
struct PointView {
    #[serde(skip_serializing_if = "Option::is_none")]
    position: Option<Pair>,
    #[serde(skip_serializing_if = "Option::is_none")]
    velocity: Option<Pair>,
    #[serde(skip_serializing_if = "Option::is_none")]
    acceleration: Option<Pair>,
}

#[derive(Serialize)]
struct ReactionView<'a> {
    from: &'a str,
    on: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    force: Option<Pair>,
    #[serde(skip_serializing_if = "Option::is_none")]
    moment: Option<Number>,
    #[serde(skip_serializing_if = "Option::is_none")]
    at: Option<Pair>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    contacts: Vec<ContactView>,
}

#[derive(Serialize)]
struct ContactView {
    at: Pair,
    normal: Number,
}

#[derive(Serialize)]
struct ResidualsView {
    #[serde(skip_serializing_if = "Option::is_none")]
    equilibrium: Option<Number>,
    #[serde(skip_serializing_if = "Option::is_none")]
    power: Option<Number>,
}

/// The instant of a motion under loads, s.
fn time(answers: &Answers<'_>, pose: &Pose) -> Option<Number> {
    let solved = pose.outcome.as_ref().ok().filter(|_| answers.model.mechanism.simulation.is_some())?;
    Number::of(solved.state.motion.time)
}

impl<'a> PoseView<'a> {
    /// What was asked for at a pose; with `find reactions` all of it.
    pub fn of(answers: &Answers<'a>, pose: &'a Pose) -> Self {
        let drives = answers.model.mechanism.drives.iter().zip(&pose.drives);
        let value = |v: &DriveValue| v.value().and_then(Reading::of);
        let mut view = Self {
            name: &pose.name,
            time: time(answers, pose),
            drives: Entries(drives.filter_map(|(d, v)| Some((d.name.clone(), value(v)?))).collect()),
            error: None,
            links: Entries(Vec::new()),
            points: Entries(Vec::new()),
            shafts: Entries(Vec::new()),
            sliders: Entries(Vec::new()),
            reactions: Entries(Vec::new()),
            transmissions: Entries(Vec::new()),
            balances: Entries(Vec::new()),
            quantities: Entries(Vec::new()),
            residuals: None,
            condition: None,
        };
        match &pose.outcome {
            Err(why) => view.error = Some(ErrorView::of(&failure(&answers.model, why))),
            Ok(solved) => view.fill(answers, pose, solved),
        }
        view
    }

    fn fill(&mut self, answers: &Answers<'a>, pose: &Pose, solved: &Solved) {
        if answers.wants_reactions() {
            self.links.0 = links(answers, solved);
            self.points.0 = points(answers, solved);
            (self.shafts.0, self.sliders.0) = elements(answers, solved);
            self.reactions.0 = all_reactions(answers, solved);
            self.transmissions.0 = transmissions(answers, solved);
            let efforts = answers.efforts().into_iter();
            self.balances.0 = efforts
                .filter_map(|e| Some((e.name.clone(), Number::of(e.value(answers, solved)?)?)))
                .collect();
        }
        let quantity = |expr| answers.value(expr, pose).and_then(Reading::of);
        self.quantities.0 =
            answers.finds(false).filter_map(|(f, e, _)| Some((f.name.clone(), quantity(e)?))).collect();
        let residuals = solved.residuals;
        if residuals.equilibrium.is_some() || residuals.power.is_some() {
            self.residuals = Some(ResidualsView {
                equilibrium: residuals.equilibrium.and_then(Number::of),
                power: residuals.power.and_then(Number::of),
            });
        }
        self.condition = Number::of(solved.condition);
    }
}

impl ErrorView {
    fn of(error: &Diagnosis) -> Self {
        Self { code: error.code().map(|c| c.to_string()), message: error.to_string() }
    }
}

/// The moving links whose rotation is known: not those driven at a point only, and no free rollers.
pub(super) fn turning_links<'a>(answers: &Answers<'a>) -> impl Iterator<Item = (LinkId, &'a Link)> + use<'a> {
    let model = answers.model;
    let mut left_out = are_elements(model.mechanism);
    for drive in &model.mechanism.drives {
        if let DriveTarget::Point(link, _) = drive.target {
            left_out[link.index()] = true;
        }
    }
    model.structure.passive.iter().for_each(|link| left_out[link.index()] = true);
    let links = model.mechanism.links.iter().enumerate().skip(1).map(|(i, l)| (LinkId::at(i), l));
    links.filter(move |(id, _)| !left_out[id.index()])
}

fn links(answers: &Answers<'_>, solved: &Solved) -> Vec<(String, LinkView)> {
    let effects = answers.model.plan.effects;
    let view = answers.solution.view(&answers.model, solved);
    let link = |(id, link): (LinkId, &Link)| {
        let body = view.body(id);
        let inertia = link.mass.filter(|_| effects.inertia);
        let force = |centre: Vec2, mass: f64| body.acceleration(centre) * -mass;
        let entry = LinkView {
            angle: solved.angles.get(id.index()).copied().and_then(Number::of),
            omega: from(effects, Level::Velocities).then_some(body.omega).and_then(Number::of),
            alpha: from(effects, Level::Accelerations).then_some(body.alpha).and_then(Number::of),
            inertia_force: inertia.and_then(|m| Pair::of(force(m.centre, m.mass))),
            inertia_torque: inertia.and_then(|m| Number::of(-m.inertia * body.alpha)),
        };
        (link.name.clone(), entry)
    };
    turning_links(answers).map(link).collect()
}

fn from(effects: Effects, level: Level) -> bool {
    effects.rates() >= level
}

fn points(answers: &Answers<'_>, solved: &Solved) -> Vec<(String, PointView)> {
    let effects = answers.model.plan.effects;
    let view = answers.solution.view(&answers.model, solved);
    let point = |body: &BodyState, at: Vec2| PointView {
        position: Pair::of(body.position(at)),
        velocity: from(effects, Level::Velocities).then(|| body.velocity(at)).and_then(Pair::of),
        acceleration: from(effects, Level::Accelerations).then(|| body.acceleration(at)).and_then(Pair::of),
    };
    all_points(answers).map(|(name, id, at)| (name, point(view.body(id), at))).collect()
}

/// The points whose motion is listed, by name, with their links and places.
pub(super) fn all_points<'a>(
    answers: &Answers<'a>,
) -> impl Iterator<Item = (String, LinkId, Vec2)> + use<'a> {
    let name = |link: &Link, point: &str| format!("{}.{point}", link.name);
    let on_links = turning_links(answers)
        .flat_map(move |(id, link)| link.points.iter().map(move |p| (name(link, &p.name), id, p.at)));
    let passive = &answers.model.structure.passive;
    let driven = answers.model.mechanism.drives.iter().filter_map(move |drive| match drive.target {
        DriveTarget::Point(id, at) => Some((drive.name.clone(), id, at)),
        DriveTarget::Place(id, at, Axis::X) if passive.contains(&id) => {
            Some((drive.written_name().to_owned(), id, at))
        }
        _ => None,
    });
    on_links.chain(driven)
}

fn all_reactions<'a>(answers: &Answers<'a>, solved: &Solved) -> Vec<(String, Vec<ReactionView<'a>>)> {
    let mechanism = answers.model.mechanism;
    let mut all: Vec<(String, Vec<ReactionView<'_>>)> = Vec::new();
    for entry in reactions(answers, solved) {
        let name = &mechanism.pair(entry.pair).name;
        let view = ReactionView::of(answers, &entry);
        match all.last_mut() {
            Some((last, entries)) if last == name => entries.push(view),
            _ => all.push((name.clone(), vec![view])),
        }
    }
    all
}

impl<'a> ReactionView<'a> {
    fn of(answers: &Answers<'a>, entry: &ReactionEntry) -> Self {
        let contacts = entry.contacts.iter();
        let contact = |at, normal| Some(ContactView { at: Pair::of(at)?, normal: Number::of(normal)? });
        Self {
            from: &answers.model.mechanism.link(entry.from).name,
            on: &answers.model.mechanism.link(entry.on).name,
            force: Pair::of(entry.force),
            moment: entry.moment.and_then(Number::of),
            at: entry.at.and_then(Pair::of),
            contacts: contacts.filter_map(|c| contact(c.at, c.normal)).collect(),
        }
    }
}
