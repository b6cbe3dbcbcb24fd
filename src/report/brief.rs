//! A solved file in a few lines, for several files one below the other.

use super::answers::Answers;
use super::columns::Quantity;
use super::document::Section;
use super::reactions::reactions;
use super::results::figures;
use super::symbols::Symbols;
use assur_model::model::{FindKind, Value};
use assur_solve::solve::{MotionScales, Pose};
use assur_text::units::Dimension;
use unicode_width::UnicodeWidthStr;

/// Lines of answers at the most; the other answers are counted.
const LINES: usize = 3;

/// Title, counts and answers of a file; of a sweep the least and the greatest of each answer.
#[must_use]
pub fn brief(file: &str, answers: &Answers<'_>, width: usize) -> Section {
    let mut section = Section::new(super::title(file, &answers.model));
    let poses: Vec<&Pose> = answers.poses().collect();
    let counts = counts(answers, &poses);
    if !counts.is_empty() {
        section.text(counts.join(", "));
    }
    if let Some(reached) = answers.reached {
        section.text(super::tradeoff::reached(reached));
    }
    let (scale, symbols) = (answers.greatest(), Symbols::of(answers.model.mechanism));
    let all = answers.all_quantities(&poses);
    let mut items: Vec<String> = all.into_iter().map(|q| item(answers, &symbols, scale, &q)).collect();
    items.extend(greatest_reaction(answers, &poses));
    let finds = &answers.model.mechanism.finds;
    let tables = finds.iter().filter(|find| matches!(find.kind, FindKind::Table(_)));
    items.extend(tables.map(|find| format!("table {}", find.name)));
    lines(&items, width).into_iter().for_each(|line| section.text(line));
    section
}

/// `F = 1, 12 poses, 3 of 3 expectations met`
fn counts(answers: &Answers<'_>, poses: &[&Pose]) -> Vec<String> {
    let mut counts = Vec::new();
    if super::has_mechanism(&answers.model) {
        counts.push(format!("F = {}", answers.model.structure.count.mobility));
    }
    if poses.len() > 1 {
        counts.push(format!("{} poses", poses.len()));
    }
    let open = poses.iter().filter(|p| p.outcome.is_err()).count();
    counts.extend((open > 0).then(|| format!("{open} without solution")));
    let (all, met) = (answers.outcomes.len(), answers.outcomes.iter().filter(|o| o.passed).count());
    counts.extend((all > 0).then(|| match all {
        1 => format!("{met} of 1 expectation met"),
        _ => format!("{met} of {all} expectations met"),
    }));
    counts
}

/// `Mb = 472.5 N*m`, or `x_C = 335.41 … 450 mm`; of a vector that varies its magnitude.
fn item(answers: &Answers<'_>, symbols: &Symbols<'_>, scale: MotionScales, quantity: &Quantity) -> String {
    let name = symbols.label(&quantity.name);
    let unit = &quantity.display.unit;
    let text = |value: Value| figures(answers, scale, &quantity.display, Some(value));
    let with_unit = |text: String| if unit.is_empty() { text } else { format!("{text} {unit}") };
    let known: Vec<Value> = quantity.values.iter().flatten().copied().collect();
    let truths: Vec<bool> =
        known.iter().filter_map(|v| if let Value::Bool(truth) = v { Some(*truth) } else { None }).collect();
    match known.as_slice() {
        [] => format!("{name} = {}", quantity.missing),
        [Value::Bool(truth)] => format!("{name} = {truth}"),
        [value] => format!("{name} = {}", with_unit(text(*value))),
        _ if !truths.is_empty() => {
            format!("{name} true at {} of {} poses", truths.iter().filter(|t| **t).count(), truths.len())
        }
        [first, ..] => {
            let name = if matches!(first, Value::Vector(_)) { format!("|{name}|") } else { name };
            let numbers = || known.iter().filter_map(number);
            let (least, most) =
                (numbers().fold(f64::INFINITY, f64::min), numbers().fold(f64::NEG_INFINITY, f64::max));
            let [least, most] = [least, most].map(|x| text(Value::Scalar(x)));
            let range = if least == most { least } else { format!("{least} … {most}") };
            format!("{name} = {}", with_unit(range))
        }
    }
}

/// A number, or the magnitude of a vector.
fn number(value: &Value) -> Option<f64> {
    match value {
        Value::Scalar(x) => Some(*x),
        Value::Vector(v) => Some(libm::hypot(v.x, v.y)),
        Value::Bool(_) => None,
    }
}

/// Of all reactions, where they are asked for, the greatest of all poses.
fn greatest_reaction(answers: &Answers<'_>, poses: &[&Pose]) -> Option<String> {
    if !answers.wants_reactions() {
        return None;
    }
    let mechanism = answers.model.mechanism;
    let solved = poses.iter().filter_map(|p| p.outcome.as_ref().ok());
    let all = solved.flat_map(|solved| reactions(answers, solved)).map(|e| (e.force.norm(), e.pair));
    let (force, pair) = all.reduce(|most, next| if next.0 > most.0 { next } else { most })?;
    let display = mechanism.display_of(Dimension::FORCE);
    let text = display.text(Value::Scalar(force), answers.precision.digits);
    Some(format!("greatest reaction {text} in {}", mechanism.pair(pair).name))
}

/// Items one after another in lines of a width.
fn lines(items: &[String], width: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for (i, item) in items.iter().enumerate() {
        let full = lines.len() == LINES;
        match lines.last_mut() {
            Some(line) if line.width() + item.width() + 4 <= width => {
                line.push_str(", ");
                line.push_str(item);
            }
            _ if full => {
                lines.push(format!("and {} more", items.len() - i));
                break;
            }
            _ => lines.push(item.clone()),
        }
    }
    lines
}
