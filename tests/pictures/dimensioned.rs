//! Schemes with dimension lines and with the numbers of loads.

use crate::drawn::faults;
use crate::every_example::examples;
use assur::internals::Solved;
use assur::internals::check::Overrides;
use assur::internals::drawing::{Drawing, Shape, Sheet, Style};
use assur::internals::math::Vec2;
use assur::internals::model::Value;
use assur::internals::picture::{Dimension, Kind, Measured, Options, Scene, draw};
use assur::internals::pipeline::{dimensions, solve_document_drawn};
use assur::internals::source::Source;
use std::sync::Arc;

/// The scheme with all that it can show.
fn scheme(name: &str, text: &str) -> Option<(Solved, Sheet, Vec<Dimension>)> {
    let source = Source::new(name, text);
    let (document, found) = assur::internals::syntax::parse(&source);
    let document = Arc::new(document);
    let kinds = [Kind::Scheme, Kind::Forces];
    let solved = solve_document_drawn(&source, &document, found, &Overrides::none(), &kinds).0?;
    let mut options = Options::default();
    options.scheme.numbers = true;
    options.scheme.dimensions = dimensions(&document, &solved.compiled.mechanism);
    let file = (source.name.as_str(), source.text.as_str());
    let scene = Scene::of(solved.compiled.model(), &solved.solution, file, None).ok()?;
    let drawing = draw(Kind::Scheme, &scene, &options).ok()?.into_iter().next()?;
    let sheet = drawing.placed();
    Some((solved, sheet, options.scheme.dimensions))
}

/// `0.005` of `Length scale 0.005 m per mm`.
fn factor(sheet: &Sheet, of: &str) -> Option<f64> {
    sheet.drawing.description.split_once(of)?.1.split_whitespace().next()?.parse().ok()
}

/// The tips of the heads of a group.
fn tips(drawing: &Drawing, group: usize) -> Vec<Vec2> {
    let tip = |shape: &Shape| match shape {
        Shape::Lines { points, closed: true } => points.first().copied(),
        _ => None,
    };
    let own = drawing.marks.iter().filter(|mark| mark.group == group && mark.style == Style::Solid);
    own.filter_map(|mark| tip(&mark.shape)).collect()
}

#[test]
fn dimension_lines_are_as_long_as_their_values() {
    let (mut wrong, mut count) = (Vec::new(), 0);
    for (name, text) in examples() {
        let Some((solved, sheet, all)) = scheme(&name, &text) else { continue };
        wrong.extend(faults(&sheet).into_iter().take(3).map(|fault| format!("{name}: {fault}")));
        let Some(factor) = factor(&sheet, "Length scale ") else { continue };
        let groups = sheet.drawing.groups.iter().enumerate().filter(|(_, group)| group.class == "dimension");
        for ((i, group), dimension) in groups.zip(&all) {
            let value = solved.compiled.mechanism.values.iter().find(|value| value.name == group.name);
            let Some(Value::Scalar(wanted)) = value.map(|value| value.value) else {
                wrong.push(format!("{name}: {} has no value", group.name));
                continue;
            };
            let drawn = match (tips(&sheet.drawing, i).as_slice(), dimension.of) {
                ([a, b], Measured::Length { .. }) => (*b - *a).norm(),
                ([_], Measured::Radius { radius, .. }) => radius / factor,
                // too short for a line
                ([], _) if wanted.abs() / factor < 1.3 => continue,
                _ => f64::NAN,
            };
            count += 1;
            if (drawn - wanted.abs() / factor).abs() > 0.01 || drawn.is_nan() {
                wrong.push(format!("{name}: {} is {drawn} mm and not {}", group.name, wanted / factor));
            }
        }
    }
    assert!(count > 100, "dimensions are drawn: {count}");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn arrows_of_weights_and_forces_are_in_proportion() {
    let (mut wrong, mut count) = (Vec::new(), 0);
    for (name, text) in examples() {
        let Some((solved, sheet, _)) = scheme(&name, &text) else { continue };
        let (Some(factor), Some(gravity)) =
            (factor(&sheet, "Force scale "), solved.compiled.mechanism.gravity)
        else {
            continue;
        };
        for (i, group) in sheet.drawing.groups.iter().enumerate().filter(|(_, group)| group.class == "weight")
        {
            let link = solved.compiled.mechanism.links.iter().find(|link| link.name == group.name);
            let Some(mass) = link.and_then(|link| link.mass) else { continue };
            let wanted = mass.mass * gravity.acceleration.norm() / factor;
            let arrows = sheet.drawing.marks.iter().filter(|mark| mark.group == i);
            for mark in arrows {
                let Shape::Arrow(from, to) = mark.shape else { continue };
                count += 1;
                if ((to - from).norm() - wanted).abs() > 0.01 {
                    wrong.push(format!("{name}: the weight of {} is not {wanted} mm", group.name));
                }
            }
        }
    }
    assert!(count > 20, "weights are drawn: {count}");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
