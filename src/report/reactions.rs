//! The reactions of a pose: one entry per pair of links.

use super::answers::{Answers, NONE, with_unit};
use super::document::{Column, Report, Section, Table};
use super::symbols::Symbols;
use assur_math::math::Vec2;
use assur_model::model::{Display, LinkId, Mechanism, PairId, PairKind, Profile, ProfileShape, Query, Value};
use assur_solve::solve::{Model, PoseAnswers, Solved, unplaced_reactions};
use assur_text::units::Dimension;

/// The reaction between two links of a pair, SI.
#[derive(Clone, Debug, PartialEq)]
pub struct ReactionEntry {
    pub pair: PairId,
    /// The link it comes from: the first as written.
    pub from: LinkId,
    /// The link it acts on.
    pub on: LinkId,
    /// The force on `on`, N; NaN where it is not determined.
    pub force: Vec2,
    /// The couple on `on` about the pair's reference point, N m; `None` where it is not determined, or has no meaning.
    pub moment: Option<f64>,
    /// The hinge's centre, the place of contact, or where the resultant crosses the guide, m.
    pub at: Option<Vec2>,
    /// Forces at the two contact points of a guide.
    pub contacts: Vec<ContactEntry>,
}

impl ReactionEntry {
    /// Whether its force is determined.
    pub fn is_known(&self) -> bool {
        !self.force.x.is_nan() && !self.force.y.is_nan()
    }
}

/// The force at a contact point of a guide, on the sliding link.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactEntry {
    /// Where, m.
    pub at: Vec2,
    /// Along the guide's left normal, N.
    pub normal: f64,
}

/// All reactions of a pose, pair by pair as declared. Empty where forces are not solved, and where friction locks.
#[must_use]
pub fn reactions(answers: &Answers<'_>, solved: &Solved) -> Vec<ReactionEntry> {
    if answers.model.plan.reactions.is_empty() || solved.state.forces.locked {
        return Vec::new();
    }
    let view = answers.solution.view(&answers.model, solved);
    let unplaced = unplaced_reactions(&answers.model);
    let mut entries = Vec::new();
    for (i, pair) in answers.model.mechanism.pairs.iter().enumerate() {
        if unplaced[i] {
            continue;
        }
        let links = pair.kind.links();
        let Some((&from, others)) = links.split_first() else { continue };
        entries.extend(others.iter().map(|&on| entry(&view, PairId::at(i), from, on)));
    }
    entries
}

/// The couple of a pair on a link, N m; `None` where it is not determined, or has no meaning.
pub(super) fn moment(view: &PoseAnswers<'_>, pair: PairId, on: LinkId) -> Option<f64> {
    match &view.mechanism.pair(pair).kind {
        PairKind::Revolute(_)
        | PairKind::Transmission(_)
        | PairKind::Prismatic(_)
        | PairKind::Weld { .. } => number(view, &Query::Moment(pair, on)),
        PairKind::Cylinder { .. } | PairKind::Slot(_) | PairKind::Contact { .. } => None,
    }
}

fn number(view: &PoseAnswers<'_>, query: &Query) -> Option<f64> {
    match view.query(query) {
        Value::Scalar(x) if x.is_finite() => Some(x),
        _ => None,
    }
}

fn entry(view: &PoseAnswers<'_>, pair: PairId, from: LinkId, on: LinkId) -> ReactionEntry {
    let kind = &view.mechanism.pair(pair).kind;
    let at = match kind {
        PairKind::Contact { .. } => view.contact_normal(pair).map(|c| c.0),
        PairKind::Transmission(_) => view.pitch_point(pair),
        PairKind::Prismatic(guide) => view.crossing(pair, on, guide),
        kind => meets_at(kind).map(|(link, at)| view.body(link).position(at)),
    };
    let contacts = match kind {
        PairKind::Prismatic(guide) => {
            view.contacts(pair, guide).map(|(at, normal)| ContactEntry { at, normal }).collect()
        }
        _ => Vec::new(),
    };
    let (force, moment) = (view.reaction(pair, on), moment(view, pair, on));
    ReactionEntry { pair, from, on, force, moment, at, contacts }
}

/// Whether the couple of a pair is reported at all positions: one that is determined is a number.
pub(super) fn has_moment(model: &Model<'_>, pair: PairId) -> bool {
    let undetermined = model.structure.undetermined_couples.binary_search(&pair).is_ok();
    match &model.mechanism.pair(pair).kind {
        PairKind::Revolute(_)
        | PairKind::Transmission(_)
        | PairKind::Prismatic(_)
        | PairKind::Weld { .. } => !undetermined,
        PairKind::Cylinder { .. } | PairKind::Slot(_) | PairKind::Contact { .. } => false,
    }
}

/// The point of a link at which the links of a pair meet at all positions.
pub(super) fn meets_at(kind: &PairKind) -> Option<(LinkId, Vec2)> {
    match kind {
        PairKind::Revolute(pins) | PairKind::Weld { pins, .. } => pins.first().map(|p| (p.link, p.at)),
        PairKind::Cylinder { to, .. } => Some((to.link, to.at)),
        PairKind::Slot(g) => Some((g.slider, g.point)),
        PairKind::Contact { .. } | PairKind::Transmission(_) | PairKind::Prismatic(_) => None,
    }
}

/// Reactions of more poses have a table per pair.
const FEW: usize = 3;

/// The reactions, and the table of forces at the contact points of guides.
pub(super) fn sections(answers: &Answers<'_>, report: &mut Report) {
    if !answers.wants_reactions() {
        return;
    }
    let poses: Vec<_> = answers
        .poses()
        .filter_map(|p| Some((p.name.as_str(), reactions(answers, p.outcome.as_ref().ok()?))))
        .collect();
    let forces = Forces::of(answers, &poses);
    let mut section = Section::new("Reactions");
    if poses.len() > FEW {
        forces.of_pairs(&poses).into_iter().for_each(|pair| report.section(pair));
    } else {
        section.table(forces.of_all(&poses));
    }
    section.table(normals(answers, &poses));
    if !answers.model.plan.reactions.is_empty() {
        section.list(remarks(answers.model.mechanism, answers));
    }
    section.list(locked(answers));
    report.section(section);
}

type Poses<'a> = [(&'a str, Vec<ReactionEntry>)];

fn heads(answers: &Answers<'_>, poses: &Poses<'_>) -> Vec<Column> {
    let pose = (poses.len() > 1).then(|| Column::words(answers.pose_header()));
    pose.into_iter().chain([Column::words("pair"), Column::words("from → on")]).collect()
}

fn names(mechanism: &Mechanism, poses: &Poses<'_>, pose: &str, entry: &ReactionEntry) -> Vec<String> {
    let links = format!("{} → {}", mechanism.link(entry.from).name, mechanism.link(entry.on).name);
    let pose = (poses.len() > 1).then(|| pose.to_owned());
    pose.into_iter().chain([mechanism.pair(entry.pair).name.clone(), links]).collect()
}

/// Forces and moments in figures.
struct Forces<'a> {
    answers: &'a Answers<'a>,
    force: Display,
    moment: Display,
    /// The greatest of all, in the units of the displays.
    greatest: [f64; 2],
}

impl<'a> Forces<'a> {
    fn of(answers: &'a Answers<'a>, poses: &Poses<'_>) -> Self {
        let mechanism = answers.model.mechanism;
        let [force, moment] = [Dimension::FORCE, Dimension::TORQUE].map(|d| mechanism.display_of(d));
        let all = || poses.iter().flat_map(|p| &p.1);
        let forces = all().map(|e| e.force.norm()).fold(0.0, f64::max);
        let moments = all().filter_map(|e| e.moment).map(f64::abs).fold(0.0, f64::max);
        let greatest = [force.of_si(forces), moment.of_si(moments)];
        Self { answers, force, moment, greatest }
    }

    fn columns(&self) -> impl Iterator<Item = Column> {
        let forces = ["Fx", "Fy", "|F|"].map(|name| with_unit(name, &self.force.unit));
        forces.into_iter().chain([with_unit("moment", &self.moment.unit)]).map(Column::numbers)
    }

    fn cells(&self, entry: &ReactionEntry) -> Vec<String> {
        let (mechanism, precision) = (self.answers.model.mechanism, self.answers.precision);
        let in_unit = self.force.of_si_vector(entry.force);
        let numbers = [in_unit.x, in_unit.y, libm::hypot(in_unit.x, in_unit.y)];
        let is_known = entry.is_known();
        let figure = |x| if is_known { precision.figures(x, self.greatest[0]) } else { NONE.to_owned() };
        let mut cells = numbers.map(figure).to_vec();
        cells.push(match (&mechanism.pair(entry.pair).kind, entry.moment) {
            (_, Some(m)) => precision.figures(self.moment.of_si(m), self.greatest[1]),
            (PairKind::Prismatic(_), None) if is_known => "not determined".to_owned(),
            _ => NONE.to_owned(),
        });
        cells
    }

    /// One table: a row per pose and pair.
    fn of_all(&self, poses: &Poses<'_>) -> Table {
        let mechanism = self.answers.model.mechanism;
        let symbols = Symbols::of(mechanism);
        let symbol = |entry: &ReactionEntry| symbols.reaction(entry.from, entry.on);
        let with_symbols = poses.iter().flat_map(|p| &p.1).any(|entry| symbol(entry).is_some());
        let mut columns = heads(self.answers, poses);
        columns.extend(with_symbols.then(|| Column::words("symbol")));
        let keys = columns.len();
        columns.extend(self.columns());
        let mut table = Table::new(columns, keys);
        for (pose, entries) in poses {
            for entry in entries {
                let mut cells = names(mechanism, poses, pose, entry);
                cells.extend(with_symbols.then(|| symbol(entry).unwrap_or_default()));
                cells.extend(self.cells(entry));
                table.row(cells);
            }
        }
        table
    }

    /// A section per pair: a row per pose.
    fn of_pairs(&self, poses: &Poses<'_>) -> Vec<Section> {
        let mechanism = self.answers.model.mechanism;
        let symbols = Symbols::of(mechanism);
        // a locked pose has no reactions, all others have the same
        let pattern = poses.iter().map(|p| &p.1).find(|entries| !entries.is_empty());
        let of_pair = |(i, entry): (usize, &ReactionEntry)| {
            let mut table = Table::new(
                std::iter::once(Column::words(self.answers.pose_header())).chain(self.columns()).collect(),
                1,
            );
            for (pose, entries) in poses {
                let cells = entries.get(i).map(|entry| self.cells(entry));
                cells.into_iter().for_each(|c| table.row([vec![(*pose).to_owned()], c].concat()));
            }
            let symbol = symbols.reaction(entry.from, entry.on);
            let symbol = symbol.map_or_else(String::new, |symbol| format!(", {symbol}"));
            let [from, on] = [entry.from, entry.on].map(|link| &mechanism.link(link).name);
            let name = &mechanism.pair(entry.pair).name;
            let mut section = Section::new(format!("Reaction in {name}: {from} → {on}{symbol}"));
            section.table(table);
            section
        };
        pattern.into_iter().flatten().enumerate().map(of_pair).collect()
    }
}

fn normals(answers: &Answers<'_>, poses: &Poses<'_>) -> Table {
    let (mechanism, precision) = (answers.model.mechanism, answers.precision);
    let force = mechanism.display_of(Dimension::FORCE);
    let length = mechanism.display_of(Dimension::LENGTH);
    let mut columns = heads(answers, poses);
    columns[usize::from(poses.len() > 1) + 1] = Column::words("contact point");
    let keys = columns.len();
    for (name, unit) in [("normal force", &force.unit), ("x", &length.unit), ("y", &length.unit)] {
        columns.push(Column::numbers(with_unit(name, unit)));
    }
    let mut table = Table::new(columns, keys);
    let all = || poses.iter().flat_map(|p| &p.1);
    let contacts = || all().flat_map(|e| &e.contacts);
    let scale = force.of_si(contacts().map(|c| c.normal.abs()).fold(0.0, f64::max));
    let size = length.of_si(contacts().map(|c| c.at.norm()).fold(0.0, f64::max));
    for (pose, entries) in poses {
        for entry in entries {
            for (i, contact) in entry.contacts.iter().enumerate() {
                let mut cells = names(mechanism, poses, pose, entry);
                cells[keys - 1] = (i + 1).to_string();
                cells.push(precision.figures(force.of_si(contact.normal), scale));
                let at = length.of_si_vector(contact.at);
                cells.extend([at.x, at.y].map(|x| precision.figures(x, size)));
                table.row(cells);
            }
        }
    }
    table
}

fn remarks(mechanism: &Mechanism, answers: &Answers<'_>) -> Vec<String> {
    let mut remarks = Vec::new();
    let undetermined = answers.model.structure.undetermined_couples.iter();
    let names: Vec<&str> = undetermined.map(|p| mechanism.pair(*p).name.as_str()).collect();
    if !names.is_empty() {
        remarks.push(format!(
            "the couples in {} are not determined: the pairs close a chain of prismatic pairs",
            names.join(", ")
        ));
    }
    let unplaced = unplaced_reactions(&answers.model);
    let pairs = mechanism.pairs.iter().zip(unplaced);
    let bearing = |p: &assur_model::model::Pair| !matches!(p.kind, PairKind::Transmission(_));
    let open: Vec<&str> = pairs.filter(|(p, u)| *u && bearing(p)).map(|(p, _)| p.name.as_str()).collect();
    if !open.is_empty() {
        remarks.push(format!(
            "the reactions in {} cannot be found: an axis position is not given",
            open.join(", ")
        ));
    }
    remarks
}

/// Poses without reactions, and those at which they are not determined.
fn locked(answers: &Answers<'_>) -> Vec<String> {
    let at = |which: &dyn Fn(&Solved) -> bool| {
        let poses = answers.poses().filter(|p| p.outcome.as_ref().is_ok_and(which));
        let names: Vec<&str> = poses.map(|p| p.name.as_str()).collect();
        match names.as_slice() {
            [] => None,
            [name] => Some(format!("pose {name}")),
            [first, second] => Some(format!("poses {first} and {second}")),
            [first, .., last] => Some(format!("{} poses from {first} to {last}", names.len())),
        }
    };
    let locked = at(&|solved| solved.state.forces.locked)
        .map(|at| format!("no reactions at {at}: friction locks the mechanism"));
    let pairs = answers.model.mechanism.pairs.len();
    let open = |solved: &Solved| {
        let view = answers.solution.view(&answers.model, solved);
        (0..pairs).filter(|pair| view.shares_friction(PairId::at(*pair))).count()
    };
    let why = "how pairs share what friction holds is not determined";
    let none = at(&|solved| pairs > 0 && open(solved) == pairs);
    let none = none.map(|at| format!("no reactions at {at}: {why}"));
    let some = at(&|solved| (1..pairs).contains(&open(solved)));
    let some = some.map(|at| format!("some reactions are open at {at}: {why}"));
    locked.into_iter().chain(none).chain(some).collect()
}

// Pairs as an author writes them.

/// The ends of a pair: `piston.C - ground.guide`.
pub(super) fn pair_text(mechanism: &Mechanism, kind: &PairKind) -> String {
    let name = |link: LinkId| mechanism.link(link).name.as_str();
    match kind {
        PairKind::Revolute(pins) | PairKind::Weld { pins, .. } => {
            let alike = pins.windows(2).all(|two| two[0].name == two[1].name);
            let pins = pins.iter().map(|p| {
                if alike { name(p.link).to_owned() } else { format!("{}.{}", name(p.link), p.name) }
            });
            pins.collect::<Vec<_>>().join(" - ")
        }
        PairKind::Prismatic(g) | PairKind::Slot(g) => {
            let slider = format!("{}.{}", name(g.slider), g.point_name);
            let line = format!("{}.{}", name(g.guide), g.line_name);
            if g.guide_first { format!("{line} - {slider}") } else { format!("{slider} - {line}") }
        }
        PairKind::Contact { first, second, .. } => {
            format!("{} - {}", profile_text(mechanism, first), profile_text(mechanism, second))
        }
        PairKind::Cylinder { from, to, .. } => {
            format!("{}.{} - {}.{}", name(from.link), from.name, name(to.link), to.name)
        }
        PairKind::Transmission(t) => t.ends.join(" - "),
    }
}

/// `cam.rim`
pub(super) fn profile_text(mechanism: &Mechanism, profile: &Profile) -> String {
    format!("{}.{}", mechanism.link(profile.link).name, profile.name)
}

// Lower pairs in place of higher ones, as `check` shows them.

/// One row per higher pair.
pub(super) fn section(model: &Model<'_>, report: &mut Report) {
    let mut table = Table::of_words(&["pair", "joins", "replaced by"]);
    for pair in &model.mechanism.pairs {
        let by = match &pair.kind {
            PairKind::Slot(g) => format!(
                "an imaginary block hinged on `{}` that slides along `{}`",
                point(model, g.slider, &g.point_name),
                point(model, g.guide, &g.line_name)
            ),
            PairKind::Contact { first, second, internal, .. } => contact(model, first, second, *internal),
            PairKind::Revolute(_)
            | PairKind::Prismatic(_)
            | PairKind::Cylinder { .. }
            | PairKind::Weld { .. }
            | PairKind::Transmission(_) => continue,
        };
        table.row(vec![pair.name.clone(), pair_text(model.mechanism, &pair.kind), by]);
    }
    let mut section = Section::new("Equivalent linkages of higher pairs");
    section.table(table);
    report.section(section);
}

fn point(model: &Model<'_>, link: LinkId, name: &str) -> String {
    format!("{}.{name}", model.mechanism.link(link).name)
}

fn contact(model: &Model<'_>, first: &Profile, second: &Profile, internal: bool) -> String {
    let length = |x: f64| {
        let display = model.mechanism.display_of(Dimension::LENGTH);
        display.text(Value::Scalar(x), 6)
    };
    let radius = |p: &Profile| match p.shape {
        ProfileShape::Point(_) => Some(0.0),
        ProfileShape::Circle(_, r) => Some(r),
        ProfileShape::Line(..) | ProfileShape::Rim(_) => None,
    };
    let block = |round: &Profile, line: &Profile, r: f64| {
        let (round, line) = (profile_text(model.mechanism, round), profile_text(model.mechanism, line));
        let away = if r > 0.0 { format!(" at a distance of {}", length(r)) } else { String::new() };
        let centre = if r > 0.0 { "in the centre of" } else { "on" };
        format!("an imaginary block hinged {centre} `{round}` that slides along `{line}`{away}")
    };
    let cam = |p: &Profile| matches!(p.shape, ProfileShape::Rim(_));
    let rubbed = if cam(first) { Some((first, second)) } else { cam(second).then_some((second, first)) };
    if let Some((cam, follower)) = rubbed {
        let (cam, tip) = (profile_text(model.mechanism, cam), profile_text(model.mechanism, follower));
        return match follower.shape {
            ProfileShape::Line(..) => {
                format!("an imaginary block hinged on `{cam}` at the contact point that slides along `{tip}`")
            }
            _ => format!("an imaginary block hinged on `{tip}` that slides along the tangent of `{cam}`"),
        };
    }
    match (radius(first), radius(second)) {
        (Some(a), Some(b)) => {
            let distance = if internal { (a - b).abs() } else { a + b };
            format!("an imaginary rod of {} between the centres", length(distance))
        }
        (Some(r), None) => block(first, second, r),
        (None, Some(r)) => block(second, first, r),
        (None, None) => "nothing: two lines".to_owned(),
    }
}
