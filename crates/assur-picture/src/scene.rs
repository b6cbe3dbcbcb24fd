//! What a picture is made from: one position of a solved problem, and the positions before and behind it.

use crate::diagram::{Panel, printed};
use crate::error;
use crate::machine::arrangement::Arrangement;
use assur_drawing::{Drawing, Label, Style, Text};
use assur_math::math::Vec2;
use assur_model::model::{Bearing, Display, GenevaPair, LinkId, Load, LoadKind, Mechanism, PairId, PairKind};
use assur_model::structure::{BodyId, BodyOrigin};
use assur_solve::answer::PoseAnswers;
use assur_solve::solve::{BodyState, DriveValue, Model, MotionScales, Pose, Solution, Solved, State};
use assur_text::diagnostic::Diagnosis;

/// A solved problem, with the position at which it is shown; none where nothing has one.
#[derive(Clone, Copy)]
pub struct Subject<'s, 'a> {
    pub mechanism: &'a Mechanism,
    pub solution: &'a Solution,
    /// The name of the file.
    pub file: &'a str,
    pub scene: Option<&'s Scene<'a>>,
}

impl<'s, 'a> From<&'s Scene<'a>> for Subject<'s, 'a> {
    fn from(scene: &'s Scene<'a>) -> Self {
        Self {
            mechanism: scene.model.mechanism,
            solution: scene.solution,
            file: scene.file,
            scene: Some(scene),
        }
    }
}

impl<'a> Subject<'_, 'a> {
    /// A problem without a position.
    #[must_use]
    pub const fn without_position(mechanism: &'a Mechanism, solution: &'a Solution, file: &'a str) -> Self {
        Self { mechanism, solution, file, scene: None }
    }

    /// The title of the problem, or the name of its file.
    #[must_use]
    pub fn title(&self) -> &'a str {
        if self.mechanism.title.is_empty() { self.file } else { &self.mechanism.title }
    }

    /// The begin of the ids of a picture.
    #[must_use]
    pub fn id(&self, kind: &str) -> String {
        let stem = self.file.rsplit(['/', '\\']).next().unwrap_or_default().trim_end_matches(".mech");
        self.scene
            .map_or_else(|| format!("{kind}-{stem}"), |scene| format!("{kind}-{stem}-{}", scene.pose.name))
    }
}

/// One position of a solved problem.
#[derive(Clone, Copy)]
pub struct Scene<'a> {
    /// The mechanism with its structure and its plan.
    pub model: Model<'a>,
    pub solution: &'a Solution,
    /// The one that is shown.
    pub pose: &'a Pose,
    pub solved: &'a Solved,
    /// The name of the file.
    pub file: &'a str,
    pub text: &'a str,
    /// What the quantities of all positions are large against.
    pub greatest: MotionScales,
    /// Positions in small steps over the way of the drive, where paths or other poses are wanted.
    pub turn: &'a [Pose],
    /// The ways of the pairs, where many positions of one scene are drawn; else they are looked up in all positions.
    pub ways: &'a [(f64, f64)],
    /// Some shaft has no place.
    pub is_open: bool,
    /// What was laid out, where the file leaves places open.
    pub laid: Option<&'a Arrangement>,
    /// By how much the first drive is beyond the value of the position: whole turns.
    pub carried: f64,
}

impl<'a> Scene<'a> {
    /// The first position that is solved, or that of a name.
    ///
    /// # Errors
    /// There is none.
    pub fn of(
        model: Model<'a>,
        solution: &'a Solution,
        (file, text): (&'a str, &'a str),
        name: Option<&str>,
    ) -> Result<Self, Diagnosis> {
        let wanted = |pose: &&Pose| name.is_none_or(|name| pose.name == name);
        let found = solution.poses.iter().filter(wanted).find_map(|pose| {
            let solved = pose.outcome.as_ref().ok()?;
            let all = solution.poses.iter().filter_map(|pose| pose.outcome.as_ref().ok());
            let greatest = MotionScales::of(&model, all);
            let is_open = model.mechanism.pairs.iter().any(|p| p.bearing == Some(Bearing::Open));
            let (laid, carried) = (None, 0.0);
            Some(Self {
                model,
                solution,
                pose,
                solved,
                file,
                text,
                greatest,
                turn: &[],
                ways: &[],
                is_open,
                laid,
                carried,
            })
        });
        let subject = Subject::without_position(model.mechanism, solution, file);
        found.ok_or_else(|| error::no_position(&subject, name))
    }

    #[must_use]
    pub const fn mechanism(&self) -> &'a Mechanism {
        self.model.mechanism
    }

    /// What its numbers run over: the instant of a motion under loads, else the value of the first drive.
    #[must_use]
    pub fn along(&self) -> Option<f64> {
        if self.mechanism().simulation.is_some() {
            return Some(self.solved.state.motion.time);
        }
        match self.pose.drives.first() {
            Some(DriveValue::Scalar(x)) => Some(*x),
            _ => None,
        }
    }

    /// The position, seen from the language.
    #[must_use]
    pub fn view(&self) -> PoseAnswers<'a> {
        self.solved.view(&self.model, &self.solution.statics)
    }

    /// All positions of the sweep, and of the way around it where that is known, that are solved.
    pub fn states(&self) -> impl Iterator<Item = &'a State> {
        self.solution.poses.iter().chain(self.turn).filter_map(|p| p.outcome.as_ref().ok()).map(|s| &s.state)
    }

    #[must_use]
    pub fn body(&self, link: LinkId) -> &'a BodyState {
        &self.solved.state.motion.bodies[link.index()]
    }

    /// How far a link has turned since another position, whole turns included, rad.
    #[must_use]
    pub fn turned_since(&self, first: &Self, link: LinkId) -> f64 {
        let angle = |scene: &Self| scene.solved.angles.get(link.index()).copied();
        match (angle(self), angle(first)) {
            (Some(here), Some(there)) => here - there,
            _ => self.body(link).u.angle() - first.body(link).u.angle(),
        }
    }

    /// A point of a link in ground axes, m.
    #[must_use]
    pub fn at(&self, link: LinkId, point: Vec2) -> Vec2 {
        self.body(link).position(point)
    }

    /// Whether a link has a place: shafts may have none, and what stands on them has none either.
    #[must_use]
    pub fn is_placed(&self, link: LinkId) -> bool {
        link == LinkId::GROUND
            || !self.is_open
            || !self
                .mechanism()
                .pairs
                .iter()
                .any(|p| p.bearing == Some(Bearing::Open) && owner(&p.kind) == link)
    }

    /// A force or a speed of a slider without a place, of which its coordinate alone is known, along the way on which it was laid out.
    #[must_use]
    pub fn as_laid(&self, link: LinkId, vector: Vec2) -> Vec2 {
        let own = self.mechanism().pairs.iter().filter(|pair| pair.bearing == Some(Bearing::Placed));
        let along = own.filter_map(|pair| match &pair.kind {
            PairKind::Prismatic(g) if g.slider == link => Some(g.along),
            _ => None,
        });
        along.take(1).fold(vector, |vector, along| vector.turned(along))
    }

    /// Whether it is the barrel or the rod of a cylinder.
    #[must_use]
    pub fn is_in_cylinder(&self, link: LinkId) -> bool {
        let is = |kind: &PairKind| matches!(kind, PairKind::Cylinder { barrel, rod, .. } if *barrel == link || *rod == link);
        self.mechanism().pairs.iter().any(|p| is(&p.kind))
    }

    /// The coordinates that a pair takes on, m: least and greatest of all positions; of a cylinder its length.
    #[must_use]
    pub fn way(&self, pair: PairId) -> (f64, f64) {
        if let Some(way) = self.ways.get(pair.index()) {
            return *way;
        }
        let here = self.coordinate(pair, &self.solved.state);
        self.states().fold((here, here), |(least, greatest), state| {
            let s = self.coordinate(pair, state);
            (least.min(s), greatest.max(s))
        })
    }

    /// Whether something slides in a pair: the pin of a Geneva wheel does not while it is between two slots.
    #[must_use]
    pub fn slides(&self, pair: PairId) -> bool {
        let mut wheels = self.model.plan.genevas.iter();
        wheels.find(|step| step.pair.pair == pair).is_none_or(|step| self.solved.state.is_in_slot(step))
    }

    /// The Geneva wheel of a pair.
    #[must_use]
    pub fn geneva(&self, pair: PairId) -> Option<&'a GenevaPair> {
        self.mechanism().genevas.iter().find(|g| g.pair == pair)
    }

    /// The ways of all pairs.
    #[must_use]
    pub(crate) fn all_ways(&self) -> Vec<(f64, f64)> {
        (0..self.mechanism().pairs.len()).map(|i| self.way(PairId::at(i))).collect()
    }

    fn coordinate(&self, pair: PairId, state: &State) -> f64 {
        let bodies = &state.motion.bodies;
        let g = match &self.mechanism().pair(pair).kind {
            PairKind::Prismatic(g) | PairKind::Slot(g) => g,
            PairKind::Cylinder { from, to, .. } => {
                let [a, b] = [from, to].map(|pin| bodies[pin.link.index()].position(pin.at));
                return (b - a).norm();
            }
            _ => return 0.0,
        };
        let guide = &bodies[g.guide.index()];
        (bodies[g.slider.index()].position(g.point) - guide.position(g.through)).dot(g.along.turned(guide.u))
    }

    /// The number of a link as written, or its name.
    #[must_use]
    pub fn link_label(&self, link: LinkId) -> &'a str {
        let link = self.mechanism().link(link);
        link.number.as_deref().unwrap_or(&link.name)
    }

    /// The name of a load, or that of the value that it has: `Fr` of `force on ram at F = Fr against motion`; else a letter with its link.
    #[must_use]
    pub fn load_words(&self, load: &Load) -> Option<String> {
        if let LoadKind::InPair { pair, against_motion: true, .. } = load.kind {
            return Some(format!("M_{}", self.mechanism().pair(pair).name));
        }
        self.written_words(load).or_else(|| {
            let letter = if load.is_vector() { 'F' } else { 'M' };
            let link = load.link()?;
            let loads = self.mechanism().loads.iter();
            let alike = |l: &&Load| l.link() == Some(link) && l.is_vector() == load.is_vector();
            let nameless: Vec<_> =
                loads.filter(|l| alike(l) && self.written_words(l).is_none()).map(|l| l.span).collect();
            // of several on a link each has a letter
            let which = nameless.iter().position(|span| *span == load.span).filter(|_| nameless.len() > 1);
            let more = which.and_then(|i| ('a'..='z').nth(i)).map(String::from).unwrap_or_default();
            Some(format!("{letter}_{}{more}", self.link_label(link)))
        })
    }

    /// The name that the file has for a load or for its value.
    fn written_words(&self, load: &Load) -> Option<String> {
        load.name.clone().or_else(|| {
            let statement = self.text.get(load.span.start..load.span.end)?;
            let value = statement.split_once('=')?.1.trim_start();
            let in_name = |c: char| c.is_alphanumeric() || c == '_' || c == '\'';
            let end = value.find(|c: char| !in_name(c)).unwrap_or(value.len());
            let rest = value[end..].trim_start();
            let alone = rest.is_empty() || rest.starts_with(char::is_alphabetic) || rest.starts_with('@');
            (alone && value.starts_with(char::is_alphabetic)).then(|| value[..end].to_owned())
        })
    }

    /// The same as a label.
    #[must_use]
    pub fn load_name(&self, load: &Load) -> Option<Text> {
        self.load_words(load).map(|name| Text::name(&name))
    }

    /// A letter with the number or the name of a link as its index.
    #[must_use]
    pub fn indexed(&self, letter: &str, link: LinkId) -> Text {
        Text::italic(letter).lowered(self.link_label(link))
    }
}

/// The link that a pair of a shaft or a slider brings along.
fn owner(kind: &PairKind) -> LinkId {
    match kind {
        PairKind::Revolute(pins) => pins.last().map_or(LinkId::GROUND, |p| p.link),
        PairKind::Prismatic(g) => g.slider,
        _ => LinkId::GROUND,
    }
}

// Letters of reactions: the same for a force in every picture and in the steps of a solution.

/// The index of the force of one body on another, from their numbers or names: `12`, `ground,crank`.
#[must_use]
pub fn reaction_index(from: &str, on: &str) -> String {
    let apart = if from.chars().count() > 1 || on.chars().count() > 1 { "," } else { "" };
    format!("{from}{apart}{on}")
}

impl<'a> Scene<'a> {
    /// The number of a body as written, or its name; of a body that stands for a pair the pair's.
    #[must_use]
    pub fn body_label(&self, body: usize) -> &'a str {
        match self.model.structure.replaced.bodies[body].origin {
            BodyOrigin::Link(link) => self.link_label(link),
            BodyOrigin::Imaginary(pair) => &self.mechanism().pair(pair).name,
        }
    }

    /// The letter of the force in a pair on one of its links: of what touches it there, which stands for another link in a cylinder
    /// and where a contact is replaced.
    #[must_use]
    pub fn reaction_name(&self, pair: PairId, from: LinkId, on: LinkId) -> Text {
        let replaced = &self.model.structure.replaced;
        let own = BodyId(on.index());
        let joints = replaced.joints_of(pair).map(|joint| replaced.joint(joint).bodies());
        let others = joints.filter(|bodies| bodies.contains(&own)).flatten().filter(|body| *body != own);
        let others: Vec<BodyId> = others.collect();
        let direct = others.is_empty() || (from != on && others.contains(&BodyId(from.index())));
        let from = if direct { self.link_label(from) } else { self.body_label(others[0].0) };
        Text::italic("R").lowered(&reaction_index(from, self.link_label(on)))
    }
}

// The events of a motion under loads in its diagrams.

/// Instants of an event that are marked, and those in the description.
const MOST_MARKED: usize = 40;
const MOST_DESCRIBED: usize = 8;
/// So many instants of one event have its name.
const FIRST: usize = 4;
/// Size of a name; from name to name, mm.
const LETTERS: f64 = 3.0;
const APART: f64 = 1.5;
/// Marks that are nearer have one name together, mm.
const TOGETHER: f64 = 0.3;

/// Lines at the instants of events, with their names above the first panel.
pub fn marked_events(
    scene: &Scene<'_>,
    drawing: &mut Drawing,
    panel: &Panel,
    (along, events): (&Display, &[Vec<f64>]),
    named: bool,
) {
    let named_events = scene.mechanism().events.iter().map(|event| event.name.as_deref().unwrap_or("until"));
    let mut marks: Vec<(f64, Vec<String>)> = Vec::new();
    for (name, times) in named_events.zip(events) {
        let places = times.iter().take(MOST_MARKED).map(|t| panel.at(printed(along, *t), panel.y.to).x);
        // the first have their names, and one name stands for the others
        let rest = times.len().saturating_sub(FIRST);
        let text = |i: usize| match i {
            _ if i < FIRST || rest == 1 => vec![name.to_owned()],
            FIRST => vec![format!("{name} ×{rest}")],
            _ => Vec::new(),
        };
        let names = places.enumerate().map(|(i, x)| (x, text(i)));
        marks.extend(names);
        if named && !times.is_empty() {
            let shown = times.iter().take(MOST_DESCRIBED).map(|t| scene.place_text(along, *t));
            let more = if times.len() > MOST_DESCRIBED { ", …" } else { "" };
            drawing.description += &format!("{name} at {}{more}. ", shown.collect::<Vec<_>>().join(", "));
        }
    }
    marks.sort_by(|a, b| a.0.total_cmp(&b.0));
    marks.dedup_by(|next, before| {
        let same = next.0 - before.0 < TOGETHER;
        if same {
            before.1.append(&mut next.1);
        }
        same
    });
    drawing.begin("events", "");
    for (x, _) in &marks {
        drawing.line(Style::Dashed, Vec2::new(*x, panel.bottom()), Vec2::new(*x, panel.top));
    }
    let (mut right, mut listed) = (f64::NEG_INFINITY, Vec::new());
    for (x, names) in marks.iter().filter(|mark| named && !mark.1.is_empty()) {
        let text = Text::upright(&names.join(", "));
        let half = 0.5 * text.bounds(LETTERS).size().x;
        let is_new = names.iter().any(|name| !listed.contains(name));
        if x - half < right + APART && !is_new {
            continue;
        }
        listed.extend(names.iter().cloned());
        right = x + half;
        let at = Vec2::new(*x, panel.top);
        drawing.label(Label::at(text, LETTERS, at, 0.6).towards(Vec2::new(0.0, -1.0)).ranked(1));
    }
    drawing.end();
}
