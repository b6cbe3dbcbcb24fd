//! Positions of a file as lines of JSON. What stands between the numbers is the same at most positions: it is found from one of
//! them, and the lines of the others are filled in. A position that has other entries is written as a whole.

use serde::Serialize;
use std::io;

use super::{Answers, escaped, render_position};
use crate::report::lines::PoseLines;
use crate::report::reactions::{has_moment, meets_at};
use assur_model::model::{FindKind, LinkId, PairId, PairKind, PointRef, Query};
use assur_position::plan::Level;
use assur_solve::solve::{
    Model, Pose, PoseExtras, PoseOutputs, Solved, Source, read_numbers, unplaced_reactions,
};
use assur_text::units::Template;

/// Positions at which the pieces are looked for.
const TRIES: usize = 8;

#[derive(Clone, Debug)]
pub struct JsonLines {
    file: String,
    filled: Option<Filled>,
    /// Positions that were looked at.
    seen: usize,
}

/// What is around the name of a position, and where the numbers behind come from.
#[derive(Clone, Debug)]
struct Filled {
    before: String,
    behind: Template,
    sources: Vec<Source>,
}

impl JsonLines {
    /// For the positions of a file.
    #[must_use]
    pub const fn of(file: String) -> Self {
        Self { file, filled: None, seen: 0 }
    }
}

impl PoseLines for JsonLines {
    fn begin(&mut self, answers: &Answers<'_>, pose: Option<&Pose>) {
        self.seen += 1;
        // one position alone is not worth it
        if self.filled.is_none() && (2..=TRIES).contains(&self.seen) {
            self.filled = pose.and_then(|pose| Filled::of(&self.file, answers, pose));
        }
    }

    fn reads(&self, _: &Model<'_>) -> PoseOutputs {
        PoseOutputs::ALL
    }

    fn add(&self, answers: &Answers<'_>, pose: &Pose, row: &mut Vec<f64>, out: &mut Vec<u8>) {
        if !self.filled.as_ref().is_some_and(|filled| filled.write(answers, pose, row, out)) {
            out.extend_from_slice(render_position(&self.file, None, answers, Some(pose)).as_bytes());
        }
        out.push(b'\n');
    }

    fn add_without_pose(&self, answers: &Answers<'_>, out: &mut Vec<u8>) {
        out.extend_from_slice(render_position(&self.file, None, answers, None).as_bytes());
        out.push(b'\n');
    }
}

impl Filled {
    /// From a position, if its numbers are those of the sources.
    fn of(file: &str, answers: &Answers<'_>, pose: &Pose) -> Option<Self> {
        let solved = pose.outcome.as_ref().ok()?;
        let (mut text, mut written) = (Vec::new(), Vec::new());
        let marks = Marks(&mut written);
        let view = super::position_view(file, None, answers, Some(pose));
        view.serialize(&mut serde_json::Serializer::with_formatter(&mut text, marks)).ok()?;
        let text = String::from_utf8(text).ok()?;
        let sources = sources(answers);
        let mut numbers = Vec::new();
        let complete = read_numbers(
            &sources,
            &answers.solution.view(&answers.model, solved),
            &beside(pose, solved),
            &mut numbers,
        );
        // zero has no sign
        let same = |(a, b): (&f64, &f64)| (a + 0.0).to_bits() == (b + 0.0).to_bits();
        if !complete || numbers.len() > written.len() || !numbers.iter().zip(&written).all(same) {
            return None;
        }
        let name = format!("\"pose\":{{\"name\":\"{}\"", pose.name);
        let (head, behind) = text.split_once(&name).filter(|(head, _)| !head.contains(MARK))?;
        let before = escaped(format!("{head}\"pose\":{{\"name\":\""));
        let pieces: Vec<String> =
            format!("\"{behind}").split(MARK).map(|piece| escaped(piece.to_owned())).collect();
        // those behind the sources need no position
        let behind = Template::of(&pieces, &written[numbers.len()..]);
        Some(Self { before, behind, sources })
    }

    /// Writes the line of a position without its end; `false` where its entries differ.
    fn write(&self, answers: &Answers<'_>, pose: &Pose, row: &mut Vec<f64>, out: &mut Vec<u8>) -> bool {
        let Ok(solved) = &pose.outcome else { return false };
        row.clear();
        let view = answers.solution.view(&answers.model, solved);
        let simple = pose.name.bytes().all(|b| b.is_ascii_alphanumeric());
        if !simple
            || solved.state.forces.locked
            || !read_numbers(&self.sources, &view, &beside(pose, solved), row)
        {
            return false;
        }
        out.extend_from_slice(self.before.as_bytes());
        out.extend_from_slice(pose.name.as_bytes());
        self.behind.fill(row, out);
        true
    }
}

fn beside<'a>(pose: &'a Pose, solved: &'a Solved) -> PoseExtras<'a> {
    PoseExtras { drives: &pose.drives, residuals: &solved.residuals, condition: solved.condition }
}

/// Stands for a number: no JSON has this character.
const MARK: char = '\0';

/// Writes marks, and keeps the numbers.
struct Marks<'a>(&'a mut Vec<f64>);

impl serde_json::ser::Formatter for Marks<'_> {
    fn write_f64<W: ?Sized + io::Write>(&mut self, writer: &mut W, value: f64) -> io::Result<()> {
        self.0.push(value);
        writer.write_all(&[0])
    }
}

/// Where the numbers of a position come from, in the order of its entries.
fn sources(answers: &Answers<'_>) -> Vec<Source> {
    let model = &answers.model;
    let mut all: Vec<Source> = (0..model.mechanism.drives.len()).map(Source::Drive).collect();
    if answers.wants_reactions() {
        links(answers, &mut all);
        reactions(answers, &mut all);
        all.extend(answers.effort_slots().map(Source::Effort));
    }
    let is_found = |kind: &FindKind| matches!(kind, FindKind::Value { poseless: false, .. });
    let finds = model.mechanism.finds.iter().enumerate().filter(|(_, find)| is_found(&find.kind));
    all.extend(finds.map(|(index, _)| Source::Find(index)));
    if model.plan.effects.forces && !model.plan.forces.is_empty() {
        all.push(Source::Equilibrium);
        if model.plan.effects.level >= Level::Velocities {
            all.push(Source::Power);
        }
    }
    all.push(Source::Condition);
    all
}

fn links(answers: &Answers<'_>, all: &mut Vec<Source>) {
    let effects = answers.model.plan.effects;
    let from = |level| effects.rates() >= level;
    let mut add = |wanted: bool, query| all.extend(wanted.then_some(Source::Query(query)));
    for (id, link) in super::pose::turning_links(answers) {
        add(true, Query::Angle(id));
        add(from(Level::Velocities), Query::Omega(id));
        add(from(Level::Accelerations), Query::Alpha(id));
        let has_inertia = link.mass.is_some() && effects.inertia;
        add(has_inertia, Query::InertiaForce(id));
        add(has_inertia, Query::InertiaTorque(id));
    }
    for (_, id, at) in super::pose::all_points(answers) {
        let point = PointRef::Fixed(id, at);
        add(true, Query::Position(point));
        add(from(Level::Velocities), Query::Velocity(point));
        add(from(Level::Accelerations), Query::Acceleration(point));
    }
}

fn reactions(answers: &Answers<'_>, all: &mut Vec<Source>) {
    let model = &answers.model;
    if model.plan.reactions.is_empty() {
        return;
    }
    let unplaced = unplaced_reactions(model);
    for (i, pair) in model.mechanism.pairs.iter().enumerate().filter(|(i, _)| !unplaced[*i]) {
        let id = PairId::at(i);
        for &on in pair.kind.links().iter().skip(1) {
            all.push(Source::Query(Query::Reaction(id, on)));
            all.extend(has_moment(model, id).then_some(Source::Query(Query::Moment(id, on))));
            all.extend(place(&pair.kind, id, on));
            if let PairKind::Prismatic(guide) = &pair.kind
                && guide.contacts.is_some()
            {
                all.push(Source::Contacts(id, guide.clone()));
            }
        }
    }
}

fn place(kind: &PairKind, pair: PairId, on: LinkId) -> Option<Source> {
    match kind {
        PairKind::Prismatic(guide) => Some(Source::Crossing(pair, on, guide.clone())),
        kind => meets_at(kind).map(|(link, at)| Source::Query(Query::Position(PointRef::Fixed(link, at)))),
    }
}
