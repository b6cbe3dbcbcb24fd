//! Transmissions: their laws, and what they pull.

use super::answers::{Answers, with_unit};
use super::document::{Column, Report, Section, Table};
use super::reactions::pair_text;
use assur_model::model::{Law, LinkId, Mechanism, PairId, PairKind, Rate, Transmission, TransmissionKind};
use assur_model::structure::{BodyId, Group, GroupKind};
use assur_position::plan::{TrainMember, TrainMotion, TrainSource};
use assur_solve::solve::{Model, Pose, PoseAnswers, Solved};
use assur_text::units::{Dimension, significant};

const DIGITS: usize = 6;

/// What kind of group it is; a train of one transmission by its word.
pub(super) fn kind_name(model: &Model<'_>, group: &Group) -> &'static str {
    if let (GroupKind::Train, [law], [_]) = (group.kind, group.laws.as_slice(), group.bodies.as_slice())
        && let PairKind::Transmission(t) =
            &model.mechanism.pair(model.structure.replaced.joint(*law).pair).kind
    {
        return t.kind.word();
    }
    group.kind_name()
}

/// One row per transmission: its links and its law.
pub(super) fn laws(model: &Model<'_>, report: &mut Report) {
    let mut table = Table::of_words(&["transmission", "kind", "joins", "law"]);
    for pair in &model.mechanism.pairs {
        let PairKind::Transmission(t) = &pair.kind else { continue };
        let law = if t.freewheel != 0.0 {
            let sense = if t.freewheel > 0.0 { "counterclockwise" } else { "clockwise" };
            format!("the second side may turn ahead of the first {sense}")
        } else if t.slipping().is_some() {
            "slips until both sides have one speed".to_owned()
        } else if model.mechanism.open_sizes.is_empty() {
            let each = t.laws.iter().map(|l| law_text(model.mechanism, &l.terms) + &phase_text(l));
            each.collect::<Vec<_>>().join("; ")
        } else {
            "depends on sizes that are not given".to_owned()
        };
        let joins = pair_text(model.mechanism, &pair.kind);
        table.row(vec![pair.name.clone(), t.kind.word().to_owned(), joins, law]);
    }
    let mut section = Section::new("Transmissions");
    section.table(table);
    report.section(section);
}

/// `, phase 180 deg` of a law whose angles are not zero together.
fn phase_text(law: &Law) -> String {
    match law.terms.get(1) {
        Some((_, second)) if law.constant != 0.0 => {
            format!(", phase {} deg", significant((law.constant / second).to_degrees(), DIGITS))
        }
        _ => String::new(),
    }
}

fn law_text(mechanism: &Mechanism, terms: &[(Rate, f64)]) -> String {
    let name = |rate: &Rate| match rate {
        Rate::Turn(link) => format!("ω({})", mechanism.link(*link).name),
        Rate::Slide(pair) => format!("v({})", mechanism.pair(*pair).name),
    };
    let terms = terms.iter().filter(|(rate, _)| *rate != Rate::Turn(LinkId::GROUND));
    format!("{} = 0", sum(terms.map(|(rate, c)| (*c, name(rate)))))
}

/// `2 ω(I) − 0.5 v(A)`
fn sum(terms: impl Iterator<Item = (f64, String)>) -> String {
    let mut text = String::new();
    for (c, name) in terms {
        let sign = match (text.is_empty(), c < 0.0) {
            (true, false) => "",
            (true, true) => "−",
            (false, false) => " + ",
            (false, true) => " − ",
        };
        let size = if c.abs() == 1.0 { String::new() } else { format!("{} ", significant(c.abs(), DIGITS)) };
        text += &format!("{sign}{size}{name}");
    }
    if text.is_empty() { "0".to_owned() } else { text }
}

/// How a train group moves: `ω(II) = −0.833333 ω(I)`.
pub(super) fn motion_in_words(model: &Model<'_>, train: &TrainMotion) -> String {
    if !model.mechanism.open_sizes.is_empty() {
        return "linear in the rates solved before".to_owned();
    }
    let body = |slot: usize| model.structure.replaced.body_name(model.mechanism, BodyId(slot));
    let source = |s: &TrainSource| match s {
        TrainSource::Turn { body: slot, .. } => format!("ω({})", body(*slot)),
        TrainSource::Slide(slide) => format!("v({})", body(slide.body)),
        TrainSource::Drive(drive) => format!("rate of {}", model.mechanism.drives[*drive].name),
        TrainSource::Constant => String::new(),
    };
    let width = train.sources.len();
    let each = train.members.iter().enumerate().map(|(i, member)| {
        let (name, sign) = match member {
            TrainMember::Turn { body: slot, .. } => (format!("ω({})", body(*slot)), 1.0),
            TrainMember::Shift(slide) => (format!("v({})", body(slide.body)), slide.sense),
        };
        let row = train.coefficients[i * width..][..width].iter().map(|c| c * sign).zip(&train.sources);
        let moving = row.filter(|(c, from)| *c != 0.0 && **from != TrainSource::Constant);
        let terms = moving.map(|(c, from)| (c, source(from)));
        format!("{name} = {}", sum(terms))
    });
    each.collect::<Vec<_>>().join(", ")
}

/// Forces and torques of a transmission at a pose, SI.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Pull {
    pub pair: PairId,
    /// The part of a rope.
    pub part: usize,
    /// Pull of a rope, tangential force of any other, N.
    pub force: f64,
    /// Torques on the links that turn, N m.
    pub torques: Vec<(LinkId, f64)>,
}

/// All transmissions of a pose whose forces are known.
pub(super) fn pulls(answers: &Answers<'_>, solved: &Solved) -> Vec<Pull> {
    if answers.model.plan.forces.is_empty() || solved.state.forces.locked {
        return Vec::new();
    }
    let view = answers.solution.view(&answers.model, solved);
    let laws = answers.model.plan.laws.iter().enumerate();
    let known = laws.filter(|(i, _)| !answers.solution.open.laws.contains(i));
    known.filter_map(|(_, law)| pull(&view, law.pair, law.index)).collect()
}

fn pull(view: &PoseAnswers<'_>, pair: PairId, part: usize) -> Option<Pull> {
    let PairKind::Transmission(t) = &view.mechanism.pair(pair).kind else { return None };
    let rope = t.kind == TransmissionKind::Rope;
    let force = if rope { view.tension(pair, part, None) } else { view.tangential_force(pair) };
    Some(Pull { pair, part, force, torques: torques(view, pair, t) })
}

fn torques(view: &PoseAnswers<'_>, pair: PairId, t: &Transmission) -> Vec<(LinkId, f64)> {
    let mut links: Vec<LinkId> = Vec::new();
    for link in t.laws.iter().flat_map(|l| &l.terms).filter_map(|(rate, _)| rate.turning()) {
        if link != LinkId::GROUND && !links.contains(&link) {
            links.push(link);
        }
    }
    links.into_iter().map(|l| (l, view.moment(pair, l))).collect()
}

/// Forces and torques of all transmissions, where all reactions are asked for.
pub(super) fn section(answers: &Answers<'_>, report: &mut Report) {
    if !answers.wants_reactions() {
        return;
    }
    let poses: Vec<(&Pose, Vec<Pull>)> = answers
        .poses()
        .filter_map(|p| Some((p, pulls(answers, p.outcome.as_ref().ok()?))))
        .filter(|(_, pulls)| !pulls.is_empty())
        .collect();
    let mechanism = answers.model.mechanism;
    let (force, torque) = (mechanism.display_of(Dimension::FORCE), mechanism.display_of(Dimension::TORQUE));
    let pose = (poses.len() > 1).then(|| Column::words(answers.pose_header()));
    let mut columns: Vec<Column> =
        pose.into_iter().chain(["transmission", "kind"].map(Column::words)).collect();
    let keys = columns.len();
    columns.push(Column::numbers(with_unit("force", &force.unit)));
    columns.push(Column::words(with_unit("torques", &torque.unit)));
    let mut table = Table::new(columns, keys);
    let all = || poses.iter().flat_map(|(_, p)| p);
    let greatest = force.of_si(all().map(|p| p.force.abs()).fold(0.0, f64::max));
    let most = torque.of_si(all().flat_map(|p| &p.torques).map(|t| t.1.abs()).fold(0.0, f64::max));
    for (pose, pulls) in &poses {
        for pull in pulls {
            let pair = mechanism.pair(pull.pair);
            let PairKind::Transmission(t) = &pair.kind else { continue };
            let mut cells: Vec<String> = (poses.len() > 1).then(|| pose.name.clone()).into_iter().collect();
            let part = if t.laws.len() > 1 { format!(", part {}", pull.part + 1) } else { String::new() };
            cells.push(pair.name.clone() + &part);
            cells.push(t.kind.word().to_owned());
            cells.push(answers.precision.figures(force.of_si(pull.force), greatest));
            let torques = pull.torques.iter().map(|(link, x)| {
                format!(
                    "{} {}",
                    mechanism.link(*link).name,
                    answers.precision.figures(torque.of_si(*x), most)
                )
            });
            cells.push(torques.collect::<Vec<_>>().join(", "));
            table.row(cells);
        }
    }
    let mut section = Section::new("Transmissions: pull of ropes, tangential force of wheels, torques");
    section.table(table);
    report.section(section);
}
