//! What to say of conditions that do not match freedoms.

use miette::LabeledSpan;

use super::count::Count;
use super::effort::{Effort, EffortSource};
use super::error::{StructureError, counted, label, listed, with_lines};
use super::floating::{MOST_LABELS, names};
use super::incidence::{Defect, Part};
use super::joint::{JointKind, Replaced};
use super::remedy::{
    Adds, links, missing_efforts, missing_meshes, missing_pairs, needless_efforts, needless_parts,
};
use super::repeated::repeated;
use super::trial::Trial;
use crate::model::Mechanism;
use crate::source::Span;

/// Motion: conditions of pairs and drives against freedoms of links.
pub(super) fn of_motion(trial: Trial<'_>, count: &Count, defect: &Defect) -> StructureError {
    if defect.fit.surplus > 0
        && let Some(error) = repeated(trial, count, defect)
    {
        return error;
    }
    let formula = count.formula();
    let drives = match count.drives {
        0 => "but no drive is declared".to_owned(),
        1 => "but 1 drive is declared".to_owned(),
        n => format!("but {n} drives are declared"),
    };
    let mut labels = loose_labels(trial, &defect.under, "can still move");
    labels.extend(held_labels(trial, &defect.over, |n| format!("takes {}", counted(n, "freedom"))));
    match (defect.fit.missing, defect.fit.surplus) {
        (_, 0) => {
            StructureError::Underconstrained { formula, drives, help: to_add(trial, count, defect), labels }
        }
        (0, _) => {
            StructureError::Overconstrained { formula, drives, help: to_leave_out(trial, defect), labels }
        }
        _ => {
            let fits = count.mobility == i64::try_from(count.drives).unwrap_or(i64::MAX);
            let drives = if fits {
                format!("{}: the totals agree, the parts do not", drives.replacen("but", "and", 1))
            } else {
                drives
            };
            let help = format!("{};\n{}", to_leave_out(trial, defect), to_add(trial, count, defect));
            StructureError::Unbalanced { formula, drives, help, labels }
        }
    }
}

/// Forces: unknown reactions and efforts against equations of equilibrium.
pub(super) fn of_forces(trial: Trial<'_>, count: &Count, defect: &Defect) -> StructureError {
    let (unknown, formula) = (trial.efforts.len(), count.formula());
    let needed = usize::try_from(count.mobility).unwrap_or(0);
    let declared = format!("{unknown} {} declared", if unknown == 1 { "is" } else { "are" });
    let why = match (unknown == needed, needed) {
        (true, _) => format!(
            "mobility F = {formula} asks for {}, and {declared}, but not where {} needed",
            counted(needed, "unknown effort"),
            if needed == 1 { "it is" } else { "they are" }
        ),
        (false, 0) => format!("mobility F = {formula} leaves none for an unknown effort, but {declared}"),
        (false, n) => {
            format!("mobility F = {formula} asks for {}, but {declared}", counted(n, "unknown effort"))
        }
    };
    let mut labels = loose_labels(trial, &defect.under, "nothing holds this link");
    labels.extend(held_labels(trial, &defect.over, |n| counted(n, "unknown")));
    let mut help = Vec::new();
    if defect.fit.surplus > 0 {
        let needless = needless_efforts(trial, defect);
        let known = "if it is known, declare it as a load: `force … = 100 N` or `torque … = 1 N*m`";
        help.push(match needless.as_slice() {
            [] => format!("{}: leave out one of them", sum(trial, &defect.over, "equation")),
            [one] => format!("{}: leave out {one}; {known}", sum(trial, &defect.over, "equation")),
            more => {
                format!("{}: leave out {}; {known}", sum(trial, &defect.over, "equation"), listed(more, "or"))
            }
        });
    }
    if defect.fit.missing > 0 {
        let lines = missing_efforts(trial, defect, Adds::Balances);
        let loose = names(trial.mechanism, links(trial.replaced, &defect.under));
        help.push(with_lines(&format!("{loose} would move under the loads; add {}", one_of(&lines)), &lines));
    }
    StructureError::Efforts { why, help: help.join(";\n"), labels }
}

/// `` `a` and `b` have 6 freedoms and lose 7 ``.
fn sum(trial: Trial<'_>, part: &Part, what: &str) -> String {
    let names = names(trial.mechanism, links(trial.replaced, part));
    let has = if links(trial.replaced, part).count() == 1 { "has" } else { "have" };
    let (free, taken) = (part.freedoms, part.taken());
    if what == "equation" {
        format!("{names} {has} {free} equations of equilibrium for {taken} unknowns")
    } else {
        let lose = if has == "has" { "loses" } else { "lose" };
        format!("{names} {has} {} and {lose} {taken} at the places marked", counted(free, "freedom"))
    }
}

fn to_leave_out(trial: Trial<'_>, defect: &Defect) -> String {
    let over = &defect.over;
    let sum = sum(trial, over, "freedom");
    let drives = needless_efforts(trial, defect);
    let own: usize = over.pairs.iter().map(|p| p.1).sum();
    if over.freedoms > own && !drives.is_empty() {
        return format!("{sum}; leave out {}{}", listed(&drives, "or"), again(defect));
    }
    let parts = needless_parts(trial, defect);
    match (drives.as_slice(), parts.as_slice()) {
        // with the only drive gone nothing moves any more
        ([drive], parts) if over.freedoms == own => {
            let structure = format!("without {drive} this is a structure, and its reactions can be found");
            match parts {
                [] => format!("{sum}; {structure}"),
                parts => format!("{sum}; {structure}; to let it move, {}", listed(parts, "or")),
            }
        }
        ([], []) => {
            format!("{sum}; take a pair away, or write `slot` or `contact` in place of a lower pair")
        }
        (drives, parts) => {
            let drives = drives.iter().map(|d| format!("leave out {d}"));
            let all: Vec<String> = parts.iter().cloned().chain(drives).collect();
            format!("{sum}; {}{}", listed(&all, "or"), again(defect))
        }
    }
}

fn again(defect: &Defect) -> &'static str {
    if defect.fit.surplus > 1 { ", and then once more" } else { "" }
}

fn to_add(trial: Trial<'_>, count: &Count, defect: &Defect) -> String {
    let loose = names(trial.mechanism, links(trial.replaced, &defect.under));
    let missing = defect.fit.missing;
    let drives = missing_efforts(trial, defect, Adds::Drives);
    let pairs = missing_pairs(trial, defect, count.drives > 0 || missing > 2);
    let mut text = if count.redundant > 0 && is_chain(trial.replaced, &defect.under) {
        "links joined by prismatic pairs alone keep their angles, so that in a closed chain one pair holds an angle \
         already held and a link can still slide: three prismatic pairs make no structural group; "
            .to_owned()
    } else {
        format!("{loose} can still move in {}; ", ways(missing))
    };
    let meshes = missing_meshes(trial, defect);
    if !meshes.is_empty() {
        text += &with_lines(&format!("nothing runs between wheels; add {}", one_of(&meshes)), &meshes);
        text += "\nor ";
    }
    if !pairs.is_empty() {
        text += &with_lines(&format!("a pair may be missing; add {}", one_of(&pairs)), &pairs);
        text += "\nor ";
    }
    text + &match (drives.as_slice(), missing) {
        ([], _) => "add a pair that holds them".to_owned(),
        (lines, 1) => with_lines(&format!("say what drives it: add {}", one_of(lines)), lines),
        (lines, _) => {
            with_lines(&format!("say what drives it: add {}", counted(lines.len(), "drive")), lines)
        }
    }
}

fn one_of(lines: &[String]) -> &'static str {
    match lines {
        [] => "a `balance` there",
        [_] => "the line",
        _ => "one of",
    }
}

fn ways(n: usize) -> String {
    if n == 1 { "one way".to_owned() } else { format!("{n} ways") }
}

/// Links of the part are joined by prismatic pairs that close a chain.
fn is_chain(replaced: &Replaced, part: &Part) -> bool {
    let touches = |j: &&super::joint::Joint| j.bodies().iter().any(|b| part.bodies.contains(b));
    let mut joints = replaced.joints.iter().filter(touches).peekable();
    joints.peek().is_some() && joints.all(|j| matches!(j.kind, JointKind::Prismatic { .. }))
}

fn loose_labels(trial: Trial<'_>, part: &Part, text: &str) -> Vec<LabeledSpan> {
    let spans = links(trial.replaced, part).map(|l| trial.mechanism.link(l).span);
    spans.filter(|s| *s != Span::default()).take(MOST_LABELS).map(|s| label(text, s)).collect()
}

fn held_labels(trial: Trial<'_>, part: &Part, text: impl Fn(usize) -> String) -> Vec<LabeledSpan> {
    let pairs = part.pairs.iter().map(|&(pair, n)| label(text(n), trial.mechanism.pair(pair).span));
    let efforts = part.efforts.iter().map(|&e| label(text(1), place(trial.mechanism, &trial.efforts[e])));
    // what was added last is most often what is too much
    efforts.chain(pairs).take(MOST_LABELS).collect()
}

fn place(mechanism: &Mechanism, effort: &Effort) -> Span {
    match effort.source {
        EffortSource::Drive(id) => mechanism.drives[id.index()].span,
        EffortSource::Balance(id) => mechanism.balances[id.index()].span,
    }
}
