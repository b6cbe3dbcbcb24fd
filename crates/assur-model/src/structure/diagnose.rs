//! What to report of conditions that do not match freedoms.

use assur_text::diagnostic::{Diagnosis, Fix};
use miette::LabeledSpan;

use super::add_effort::{Adds, efforts_beside, missing_efforts};
use super::add_pair::{Missing, missing_meshes, missing_pairs, missing_weld};
use super::count::Count;
use super::defect::{Defect, Fit, Part};
use super::effort::{Effort, EffortSource};
use super::generic::Split;
use super::joint::{BodyId, JointKind, Replaced};
use super::leave_out::{Mend, Repair, Sort};
use super::place;
use super::repeated::repeated;
use super::ring::locked;
use super::roller::{MOST_LABELS, counted, label, listed, names, with_lines};
use super::trial::{Change, Trial};
use super::words::{is_at_rest, is_structure, line, links, one_of, statement};
use crate::math::Vec2;
use crate::model::{
    DriveTarget, Expr, FrictionLimit, LinkId, Mechanism, PairId, PairKind, TransmissionKind, Value,
};
use crate::source::Span;
use crate::units::significant;

const MOST_PARTS: usize = 3;

/// Motion: conditions of pairs and drives against freedoms of links.
pub(super) fn of_motion(trial: Trial<'_>, count: &Count, defect: &Defect) -> Diagnosis {
    if defect.fit.surplus > 0
        && let Some(error) = repeated(trial, count, defect)
    {
        return error;
    }
    let of_point = place::without_angle(trial, defect)
        .or_else(|| place::in_place_of_angle(trial, defect))
        .or_else(|| super::floating::moves_nothing(trial, defect));
    if let Some(error) = of_point {
        return error;
    }
    let formula = count.formula();
    let drives = declared(trial.mechanism, count);
    let mut labels = loose_labels(trial, &defect.loose, "can still move");
    labels.extend(held_labels(trial, &defect.over, |n| format!("takes {}", counted(n, "freedom"))));
    match (defect.fit.missing, defect.fit.surplus) {
        (_, 0) => Diagnosis::error(
            "mech::determinacy::underconstrained",
            format!("the mechanism is underconstrained: mobility F = {formula}, {drives}"),
        )
        .labels(labels)
        .help(to_add(trial, count, defect)),
        (0, _) => Diagnosis::error(
            "mech::determinacy::overconstrained",
            format!("the mechanism is overconstrained: mobility F = {formula}, {drives}"),
        )
        .labels(labels)
        .help(to_leave_out(trial, defect)),
        _ => {
            let fits = count.mobility == i64::try_from(count.drives).unwrap_or(i64::MAX);
            let drives = if fits {
                format!("{}: the totals agree, the parts do not", drives.replacen("but", "and", 1))
            } else {
                drives
            };
            let swapped = || super::swaps::swapped(trial, defect);
            let help = healing(trial, defect, true)
                .or_else(swapped)
                .or_else(|| healing(trial, defect, false))
                .unwrap_or_else(|| {
                    format!("{};\n{}", to_leave_out(trial, defect), to_add(trial, count, defect))
                });
            Diagnosis::error(
                "mech::determinacy::unbalanced",
                format!(
                    "one part is overconstrained while another can still move: mobility F = \
                     {formula}, {drives}"
                ),
            )
            .labels(labels)
            .help(help)
        }
    }
}

/// The totals agree, but a pin would bring two points of one link together.
pub(super) fn of_split(trial: Trial<'_>, split: Split) -> Diagnosis {
    let Trial { mechanism, replaced, .. } = trial;
    let pair = replaced.joint(split.joint).pair;
    let (what, why) = (statement(mechanism, pair), together_words(mechanism, replaced, split));
    let pairs = (0..mechanism.pairs.len()).map(|i| (PairId::at(i), 0)).collect();
    let over = vec![Part { pairs, ..Part::default() }];
    let swapped = super::swaps::swapped(trial, &Defect { over, loose: Vec::new(), fit: Fit::default() });
    Diagnosis::error("mech::determinacy::unbalanced", format!("{what} cannot hold: {why}"))
        .label(mechanism.pair(pair).span, "joins them, by other pins")
        .help(swapped.unwrap_or_else(|| format!("join other points by {what}")))
}

/// `` it would bring `rod.B` and `rod.C`, 250 mm apart, together ``
fn together_words(mechanism: &Mechanism, replaced: &Replaced, split: Split) -> String {
    let links = replaced.links_of(split.body);
    let name = |at: Vec2| {
        let mut points = links.iter().flat_map(|l| mechanism.link(*l).points.iter().map(move |p| (*l, p)));
        let found = points.find(|(l, p)| replaced.place(*l, p.at).1 == at);
        found
            .map_or_else(|| "a point".to_owned(), |(l, p)| format!("`{}.{}`", mechanism.link(l).name, p.name))
    };
    let [a, b] = split.points.map(name);
    let apart = significant(1e3 * (split.points[0] - split.points[1]).norm(), 6);
    format!("it would bring {a} and {b}, {apart} mm apart, together")
}

/// How many drives are declared, and starts where the motion follows from the loads.
fn declared(mechanism: &Mechanism, count: &Count) -> String {
    let starts = mechanism.drives.iter().filter(|d| d.free).count();
    let driven = count.drives.saturating_sub(starts);
    match (driven, starts) {
        (0, 0) if mechanism.simulation.is_some() => "but no start is declared".to_owned(),
        (0, 0) if count.mobility < 0 => "less than 0 without any drive".to_owned(),
        (0, 0) => "but no drive is declared".to_owned(),
        (1, 0) => "but 1 drive is declared".to_owned(),
        (n, 0) => format!("but {n} drives are declared"),
        (0, 1) => "but 1 start is declared".to_owned(),
        (0, n) => format!("but {n} starts are declared"),
        (d, s) => format!("but {} and {} are declared", counted(d, "drive"), counted(s, "start")),
    }
}

/// Forces: unknown reactions and efforts against equations of equilibrium.
pub(super) fn of_forces(trial: Trial<'_>, count: &Count, defect: &Defect) -> Diagnosis {
    let (unknown, formula) = (trial.efforts.len(), count.formula());
    let needed = usize::try_from(count.mobility).unwrap_or(0);
    let declared = format!("{unknown} {} declared", if unknown == 1 { "is" } else { "are" });
    let why = match (unknown == needed, needed) {
        (true, _) => format!(
            "mobility F = {formula} needs {}, and {declared}, but not where {} needed",
            counted(needed, "unknown effort"),
            if needed == 1 { "it is" } else { "they are" }
        ),
        (false, 0) => format!("mobility F = {formula} allows no unknown effort, but {declared}"),
        (false, n) => {
            format!("mobility F = {formula} needs {}, but {declared}", counted(n, "unknown effort"))
        }
    };
    let mut labels = loose_labels(trial, &defect.loose, "nothing holds this link");
    labels.extend(held_labels(trial, &defect.over, |n| counted(n, "unknown")));
    let mut help = Vec::new();
    for part in defect.over.iter().take(MOST_PARTS) {
        let needless = Repair { trial, defect, part }.efforts();
        let known = "if it is known, declare it as a load: `force … = 100 N` or `torque … = 1 N*m`";
        help.push(match needless.as_slice() {
            [] => format!("{}: leave out one of them", equations(trial, part)),
            some => format!("{}: leave out {}; {known}", equations(trial, part), one_of(some)),
        });
    }
    if defect.fit.missing > 0 {
        let lines = missing_efforts(trial, defect, Adds::Balances);
        let loose = names(trial.mechanism, links(trial.replaced, &defect.loose));
        let add =
            if lines.is_empty() { "a `balance` there" } else { add_words(&lines, defect.fit.missing == 1) };
        help.push(with_lines(&format!("{loose} would move under the loads; add {add}"), &lines));
    }
    let help = help.join(";\n");
    // where something is to be left out too, a line alone does not help
    let fixes = if help.contains("leave out") { Vec::new() } else { Fix::added(&help) };
    Diagnosis::error("mech::determinacy::efforts", format!("the forces are not determined: {why}"))
        .labels(labels)
        .fixes(fixes)
        .help(help)
}

/// `` `a` has 3 equations of equilibrium for 4 unknowns ``
fn equations(trial: Trial<'_>, part: &Part) -> String {
    let moving: Vec<BodyId> = moving(trial, part);
    let has = if moving.len() == 1 { "has" } else { "have" };
    let names = names(trial.mechanism, links(trial.replaced, &moving));
    if !is_rigid(part) {
        return format!("{} of the marked unknowns cannot be separated from the others", part.surplus);
    }
    format!("{names} {has} {} equations of equilibrium for {} unknowns", part.freedoms, part.taken())
}

/// Whether the count shows what is too much: not where joints at one place repeat each other and the part can move all the
/// same.
fn is_rigid(part: &Part) -> bool {
    part.taken() == part.freedoms + part.surplus
}

/// Without the ground and the links driven at a point.
fn moving(trial: Trial<'_>, part: &Part) -> Vec<BodyId> {
    part.bodies.iter().copied().filter(|b| !trial.replaced.bodies[b.0].known).collect()
}

/// `` `a` and `b` have 6 freedoms and lose 7 at the marked joints ``
fn sum(repair: Repair<'_>) -> String {
    let Repair { trial, part, .. } = repair;
    let moving = moving(trial, part);
    let names = names(trial.mechanism, links(trial.replaced, &moving));
    let (free, taken) = (counted(part.freedoms, "freedom"), part.taken());
    if let Some(why) = locked(trial.mechanism, part) {
        return why;
    }
    if let Some(split) = repair.split() {
        let pair = trial.replaced.joint(split.joint).pair;
        let why = together_words(trial.mechanism, trial.replaced, split);
        return format!("{} cannot hold: {why}", statement(trial.mechanism, pair));
    }
    if !is_rigid(part) {
        let surplus = counted(part.surplus, "condition");
        let why = if part.pairs.is_empty() { ": two drives or starts give one coordinate" } else { "" };
        return format!("{names} have {surplus} too many at the marked joints{why}");
    }
    if moving.len() == part.bodies.len() {
        return format!("{names} have {free} relative to each other and lose {taken} at the marked joints");
    }
    let (has, lose) = if moving.len() == 1 { ("has", "loses") } else { ("have", "lose") };
    format!("{names} {has} {free} and {lose} {taken} at the marked joints")
}

/// What makes all determined by being left out, though something can move with it.
fn healing(trial: Trial<'_>, defect: &Defect, by_statement: bool) -> Option<String> {
    let [part] = defect.over.as_slice() else { return None };
    let repair = Repair { trial, defect, part };
    repair.heals(by_statement).then(|| of_part(repair))
}

fn to_leave_out(trial: Trial<'_>, defect: &Defect) -> String {
    let parts = defect.over.iter().take(MOST_PARTS).map(|part| of_part(Repair { trial, defect, part }));
    let mut parts: Vec<String> = parts.collect();
    match defect.over.len().saturating_sub(MOST_PARTS) {
        0 => {}
        1 => parts.push("one more part is overconstrained".to_owned()),
        n => parts.push(format!("{n} more parts are overconstrained")),
    }
    parts.join(";\n")
}

/// Two shafts at speeds of their own, with a clutch between them that does not slip.
pub(super) fn slipping(trial: Trial<'_>, part: &Part) -> Option<String> {
    let mechanism = trial.mechanism;
    let ([(pair, _)], [_, _]) = (part.pairs.as_slice(), part.efforts.as_slice()) else { return None };
    let PairKind::Transmission(t) = &mechanism.pair(*pair).kind else { return None };
    let speed = |l: LinkId| match mechanism.drives.iter().find(|d| d.target == DriveTarget::Link(l))?.speed {
        Some(Expr::Constant(Value::Scalar(speed))) => Some(speed),
        Some(_) => None,
        None => Some(0.0),
    };
    let [first, second] = t.links.as_slice() else { return None };
    if t.kind != TransmissionKind::Clutch || speed(*first)? == speed(*second)? {
        return None;
    }
    let [a, b] = [first, second].map(|l| mechanism.link(*l).name.as_str());
    let (name, ends) = (&mechanism.pair(*pair).name, t.ends.join(" - "));
    let torque = t.grip.map_or(1.0, FrictionLimit::capacity);
    Some(format!(
        "the speeds of `{a}` and `{b}` differ: add `slipping` to the clutch, as in \
         `clutch {name}: {ends} {{ capacity {torque} N*m; slipping }}`"
    ))
}

/// How one overconstrained part becomes sound: changes that do it by themselves come first.
fn of_part(repair: Repair<'_>) -> String {
    let Repair { trial, part, .. } = repair;
    if let Some(text) = slipping(trial, part) {
        return text;
    }
    let sum = sum(repair);
    if let Some([first, second]) = repair.repeated() {
        let name = |p| &trial.mechanism.pair(p).name;
        return format!("`{}` repeats `{}`: leave out one of them", name(second), name(first));
    }
    let mut ways = Vec::new();
    let mut structure = None;
    for (sort, mends) in repair.sorted() {
        let texts = |mends: &[&Mend]| mends.iter().map(|m| m.text.clone()).collect::<Vec<_>>();
        match sort {
            Sort::Statement => {
                let least = mends.iter().map(|m| m.unmoved).min().unwrap_or(0);
                let (best, rest): (Vec<_>, Vec<_>) = mends.iter().partition(|m| m.unmoved == least);
                ways.push(format!("leave out {}", one_of(&texts(&best))));
                if !rest.is_empty() {
                    ways.push(format!("leave out {}, but then fewer links move", one_of(&texts(&rest))));
                }
            }
            Sort::Link => match texts(&mends.iter().collect::<Vec<_>>()).as_slice() {
                [one] => ways.push(format!("leave out link {one} with its pairs")),
                some => ways.push(format!("leave out one of the links {} with its pairs", one_of(some))),
            },
            Sort::Written => ways.extend(mends.iter().map(|m| format!("write {}", m.text))),
            Sort::OnlyDrive => structure = mends.into_iter().next().map(|m| m.text),
        }
    }
    if ways.is_empty() {
        ways.extend(loosened(repair).or_else(|| together(repair)));
    }
    let structure =
        structure.map(|drive| format!("without {drive} this is a structure, and its reactions can be found"));
    match (ways.as_slice(), structure) {
        ([], None) => format!("{sum}; leave out pairs of it until the numbers agree"),
        ([], Some(structure)) => format!("{sum}; {structure}"),
        (ways, None) => format!("{sum}; {}", ways.join(", or ")),
        (ways, Some(structure)) => format!("{sum}; {}; {structure}", ways.join(", or ")),
    }
}

/// Several pairs have to go.
fn together(repair: Repair<'_>) -> Option<String> {
    let (pairs, freedoms) = repair.together()?;
    let text = format!("leave out {}", listed(&pairs, "and"));
    Some(if freedoms == 0 { text } else { format!("{text}, after which {} needed", drives_more(freedoms)) })
}

fn drives_more(freedoms: usize) -> String {
    if freedoms == 1 { "one more drive is".to_owned() } else { format!("{freedoms} more drives are") }
}

/// Leaving out one pair takes more than is too much.
fn loosened(repair: Repair<'_>) -> Option<String> {
    let found = repair.loosening();
    let (_, freedoms) = found.first()?;
    let pairs: Vec<String> = found.iter().map(|f| f.0.clone()).collect();
    let more = drives_more(*freedoms);
    let one_link = match repair.part.bodies.as_slice() {
        [a, b] if repair.part.efforts.is_empty() => {
            let names = names(repair.trial.mechanism, links(repair.trial.replaced, &[*a, *b]));
            format!("{names} cannot move against each other: make them one link, or ")
        }
        _ => String::new(),
    };
    Some(format!("{one_link}leave out {}, after which {more} needed", one_of(&pairs)))
}

fn to_add(trial: Trial<'_>, count: &Count, defect: &Defect) -> String {
    let loose = names(trial.mechanism, links(trial.replaced, &defect.loose));
    let missing = defect.fit.missing;
    let drives = missing_efforts(trial, defect, Adds::Drives);
    let mut text = if count.redundant > 0 && is_chain(trial.replaced, &defect.loose) {
        "links joined only by prismatic pairs keep their angles, so in a closed chain one pair repeats a condition \
         and a link can still slide: three prismatic pairs make no structural group; "
            .to_owned()
    } else {
        format!("{loose} can still move with {}; ", counted(missing, "freedom"))
    };
    // a mesh takes one freedom
    let meshes = if missing == 1 { missing_meshes(trial, defect) } else { Vec::new() };
    if !meshes.is_empty() {
        let is_mesh = meshes.iter().all(|line| line.starts_with("mesh"));
        let idle = if is_mesh { "a wheel meshes with nothing" } else { "nothing runs on a wheel" };
        text += &with_lines(&format!("{idle}; add {}", add_words(&meshes, true)), &meshes);
        text += "\nor ";
    }
    if let Some((name, line)) = guide_of_slot(trial, defect) {
        text += &format!("in `slot {name}` its slider turns: write `{line}` if it should not");
        text += "\nor ";
    }
    let drive = if trial.mechanism.simulation.is_some() { "start" } else { "drive" };
    // a truss or a beam has no drive
    let is_at_rest = is_at_rest(trial.mechanism);
    let is_structure = count.drives == 0 && is_structure(trial.mechanism);
    let looks = count.drives > 0 || missing > 2 || is_at_rest;
    let pairs = looks.then(|| missing_pairs(trial, defect, &defect.loose)).flatten();
    let clamp = if is_at_rest && pairs.is_none() { clamp(trial, defect) } else { None };
    if let Some((line, pin)) = clamp {
        text += &format!("write `{line}` in place of {pin}\nor ");
    }
    if let Some(missing) = pairs {
        let is_enough = matches!(missing, Missing::OneOf(_));
        text += &pairs_to_add(trial, missing, &defect.loose);
        if !is_enough {
            text += &or_weld(trial, defect, &defect.loose);
        }
        if is_structure {
            return text;
        }
        text += "\nor ";
    }
    text + &match (drives.as_slice(), missing) {
        ([], _) => "add a pair that holds them".to_owned(),
        (lines, _) if lines.len() < missing => {
            format!("add pairs that hold them, or {missing} {drive}s, beginning with `{}`", lines[0])
        }
        (lines, 1) => with_lines(&format!("{drive} it: add {}", add_words(lines, true)), lines),
        (lines, _) => with_lines(&format!("{drive} them: add {}", add_words(lines, false)), lines),
    }
}

/// The only pin on the ground as a weld: what rests is clamped.
fn clamp(trial: Trial<'_>, defect: &Defect) -> Option<(String, String)> {
    let mechanism = trial.mechanism;
    let pairs = mechanism.pairs.iter().enumerate();
    let mut grounded = pairs.filter(|(_, pair)| pair.kind.links().contains(&LinkId::GROUND));
    let ((at, pair), None) = (grounded.next()?, grounded.next()) else { return None };
    let PairKind::Revolute(pins) = &pair.kind else { return None };
    let kind = PairKind::Weld { pins: pins.clone(), angle: 0.0 };
    let heals =
        defect.fit.missing == 1 && trial.after(&Change::writing(PairId::at(at), kind.clone())).is_sound();
    let line = line(mechanism, &pair.name, &kind).filter(|_| heals)?;
    Some((line, statement(mechanism, PairId::at(at))))
}

/// A slot that leaves its slider loose, where a prismatic pair in its place leaves nothing loose.
fn guide_of_slot(trial: Trial<'_>, defect: &Defect) -> Option<(String, String)> {
    let mechanism = trial.mechanism;
    mechanism.pairs.iter().enumerate().find_map(|(i, pair)| {
        let PairKind::Slot(g) = &pair.kind else { return None };
        let loose = defect.loose.contains(&trial.replaced.body_of(g.slider));
        let kind = PairKind::Prismatic(g.clone());
        let line = line(mechanism, &pair.name, &kind).filter(|_| loose)?;
        let fits = trial.after(&Change::writing(PairId::at(i), kind)).is_sound();
        fits.then(|| (pair.name.clone(), line))
    })
}

/// Pairs that may be missing, with drives for what they leave loose.
pub(super) fn pairs_to_add(trial: Trial<'_>, missing: Missing, among: &[BodyId]) -> String {
    match missing {
        Missing::OneOf(lines) => {
            with_lines(&format!("a pair may be missing; add {}", add_words(&lines, true)), &lines)
        }
        Missing::Together { mut lines, pairs, left } => {
            lines.extend(efforts_beside(trial, &pairs, left, among, Adds::Drives));
            with_lines(&format!("pairs may be missing; add {}", add_words(&lines, false)), &lines)
        }
    }
}

/// A weld in place of the pairs that are added.
pub(super) fn or_weld(trial: Trial<'_>, defect: &Defect, among: &[BodyId]) -> String {
    let line = missing_weld(trial, defect, among);
    line.map_or_else(String::new, |line| with_lines("\nor a weld: add the line", &[line]))
}

/// How many of the lines to add.
fn add_words(lines: &[String], alternatives: bool) -> &'static str {
    match (lines.len(), alternatives) {
        (0 | 1, _) => "the line",
        (_, true) => "one of",
        (2, false) => "both lines",
        (_, false) => "all these lines",
    }
}

/// The bodies are joined by prismatic pairs that close a chain.
fn is_chain(replaced: &Replaced, bodies: &[BodyId]) -> bool {
    let touches = |j: &&super::joint::Joint| j.bodies().iter().any(|b| bodies.contains(b));
    let mut joints = replaced.joints.iter().filter(touches).peekable();
    joints.peek().is_some() && joints.all(|j| matches!(j.kind, JointKind::Prismatic { .. }))
}

fn loose_labels(trial: Trial<'_>, loose: &[BodyId], text: &str) -> Vec<LabeledSpan> {
    let spans = links(trial.replaced, loose).map(|l| trial.mechanism.link(l).span);
    spans.filter(|s| *s != Span::default()).take(MOST_LABELS).map(|s| label(text, s)).collect()
}

fn held_labels(trial: Trial<'_>, parts: &[Part], text: impl Fn(usize) -> String) -> Vec<LabeledSpan> {
    let pairs = parts.iter().flat_map(|p| &p.pairs);
    let pairs = pairs.map(|&(pair, n)| label(text(n), trial.mechanism.pair(pair).span));
    let efforts = parts.iter().flat_map(|p| &p.efforts);
    let efforts = efforts.map(|&e| label(text(1), place(trial.mechanism, &trial.efforts[e])));
    // what was added last is most often what is too much
    let mut labels: Vec<LabeledSpan> = efforts.chain(pairs).collect();
    labels.dedup();
    labels.truncate(MOST_LABELS);
    labels
}

fn place(mechanism: &Mechanism, effort: &Effort) -> Span {
    match effort.source {
        EffortSource::Drive(id) => mechanism.drives[id.index()].span,
        EffortSource::Balance(id) => mechanism.balances[id.index()].span,
    }
}
