//! Every picture of every example.

use crate::drawn::{faults, moving, sheets, solved};
use assur::internals::Solved;
use assur::internals::drawing::{Shape, Sheet, Style};
use assur::internals::math::Vec2;
use assur::internals::model::{LinkId, PairKind};
use assur::internals::picture::{KINDS, Kind};
use std::path::Path;

pub fn examples() -> Vec<(String, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let files = crate::folder::files(&root, "mech").into_iter();
    let texts = files.map(|path| {
        let name = path.strip_prefix(&root).unwrap_or(&path).display().to_string();
        (name, std::fs::read_to_string(&path).expect("an example"))
    });
    texts.collect()
}

#[test]
fn labels_are_apart_and_documents_well_formed() {
    let (mut wrong, mut count) = (Vec::new(), 0);
    for (name, text) in examples() {
        let Some((source, solved)) = solved(&name, &text) else {
            wrong.push(format!("{name}: not solved"));
            continue;
        };
        for kind in KINDS {
            for sheet in sheets(&source, &solved, kind, true) {
                count += 1;
                let found = faults(&sheet);
                wrong.extend(found.into_iter().take(3).map(|f| format!("{name}, {}: {f}", kind.name())));
            }
        }
    }
    assert!(count > 1000, "pictures are drawn: {count}");
    assert!(wrong.is_empty(), "{} faults\n{}", wrong.len(), wrong.join("\n"));
}

#[test]
fn paths_and_other_poses_are_drawn() {
    let (mut wrong, mut count) = (Vec::new(), 0);
    for (name, text) in examples() {
        let Some((source, solved)) = solved(&name, &text) else { continue };
        let Some(sheet) = moving(&source, &solved) else { continue };
        count += 1;
        wrong.extend(faults(&sheet).into_iter().take(3).map(|f| format!("{name}: {f}")));
    }
    assert!(count > 100, "paths are drawn: {count}");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The middle of the first circle of a pair.
fn circle(sheet: &Sheet, pair: &str) -> Option<Vec2> {
    let drawing = &sheet.drawing;
    drawing.marks.iter().find_map(|mark| match mark.shape {
        Shape::Circle { centre, .. } if mark.style == Style::Hinge => {
            let group = &drawing.groups[mark.group];
            (group.class == "pair" && group.name == pair).then_some(centre)
        }
        _ => None,
    })
}

/// Distances of hinges on paper are those of the solution over the scale factor.
fn misplaced(solved: &Solved, sheet: &Sheet, factor: f64) -> Vec<String> {
    let mechanism = &solved.compiled.mechanism;
    let state = solved.solution.poses.iter().find_map(|p| p.outcome.as_ref().ok()).map(|s| &s.state);
    let Some(state) = state else { return Vec::new() };
    let hinges = mechanism.pairs.iter().filter_map(|pair| {
        let PairKind::Revolute(pins) = &pair.kind else { return None };
        let pin = pins.iter().find(|p| p.link != LinkId::GROUND)?;
        let at = state.motion.bodies[pin.link.index()].position(pin.at);
        Some((pair.name.as_str(), at, circle(sheet, &pair.name)?))
    });
    let hinges: Vec<(&str, Vec2, Vec2)> = hinges.collect();
    let Some(&(_, first, first_paper)) = hinges.first() else { return Vec::new() };
    let off = |(name, at, paper): &(&str, Vec2, Vec2)| {
        let wanted = Vec2::new(at.x - first.x, first.y - at.y) / factor;
        let away = (*paper - first_paper - wanted).norm();
        (away > 0.01).then(|| format!("{name} is {away} mm off"))
    };
    hinges.iter().filter_map(off).collect()
}

#[test]
fn hinges_are_where_the_solution_says() {
    let (mut wrong, mut count) = (Vec::new(), 0);
    for (name, text) in examples() {
        let Some((source, solved)) = solved(&name, &text) else { continue };
        for sheet in sheets(&source, &solved, Kind::Scheme, false) {
            // as printed: `Length scale 0.005 m per mm.`
            let Some((_, said)) = sheet.drawing.description.split_once("Length scale ") else { continue };
            let Some(factor) = said.split(' ').next().and_then(|x| x.parse::<f64>().ok()) else { continue };
            count += 1;
            wrong.extend(misplaced(&solved, &sheet, factor).into_iter().map(|f| format!("{name}: {f}")));
        }
    }
    assert!(count > 80, "schemes to scale: {count}");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// `Scale 0.02 m/s per mm` of a description.
fn factor(sheet: &Sheet) -> Option<f64> {
    let said = sheet.drawing.description.split_once("Scale ")?.1;
    said.split(' ').next()?.parse().ok()
}

/// Ends of absolute vectors are velocities and accelerations of the hinges over the scale factor.
#[test]
fn plans_end_where_the_solution_says() {
    let (mut wrong, mut count) = (Vec::new(), 0);
    for (name, text) in examples() {
        let Some((source, solved)) = solved(&name, &text) else { continue };
        for (kind, letter) in [(Kind::Velocities, "v"), (Kind::Accelerations, "a")] {
            for sheet in sheets(&source, &solved, kind, false) {
                let Some(factor) = factor(&sheet) else { continue };
                for pair in &solved.compiled.mechanism.pairs {
                    let Some(end) = absolute(&sheet, &format!("{letter}_{}", pair.name)) else { continue };
                    let Some(wanted) = rate(&solved, &pair.kind, kind) else { continue };
                    count += 1;
                    let away = (end - Vec2::new(wanted.x, -wanted.y) / factor).norm();
                    if away > 0.01 {
                        wrong.push(format!("{name}: {letter}_{} is {away} mm off", pair.name));
                    }
                }
            }
        }
    }
    assert!(count > 200, "ends are compared: {count}");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The end of a vector from the pole.
fn absolute(sheet: &Sheet, name: &str) -> Option<Vec2> {
    let drawing = &sheet.drawing;
    drawing.marks.iter().find_map(|mark| match mark.shape {
        Shape::Arrow(from, to) if from == Vec2::zero() && drawing.groups[mark.group].name == name => Some(to),
        _ => None,
    })
}

fn rate(solved: &Solved, kind: &PairKind, of: Kind) -> Option<Vec2> {
    let PairKind::Revolute(pins) = kind else { return None };
    let pin = pins.iter().find(|p| p.link != LinkId::GROUND)?;
    let state = solved.solution.poses.iter().find_map(|p| p.outcome.as_ref().ok()).map(|s| &s.state)?;
    let body = &state.motion.bodies[pin.link.index()];
    Some(if of == Kind::Velocities { body.velocity(pin.at) } else { body.acceleration(pin.at) })
}

/// The sides of a polygon end where it began, and each begins where the one before ends.
#[test]
fn polygons_close() {
    let (mut wrong, mut count) = (Vec::new(), 0);
    for (name, text) in examples() {
        let Some((source, solved)) = solved(&name, &text) else { continue };
        let drawn = sheets(&source, &solved, Kind::Forces, true);
        for sheet in drawn.iter().filter(|s| s.drawing.id.starts_with("polygon")) {
            let sides = sheet.drawing.marks.iter().filter_map(|mark| match mark.shape {
                Shape::Arrow(a, b) | Shape::Line(a, b) => Some((a, b)),
                _ => None,
            });
            let sides: Vec<(Vec2, Vec2)> = sides.collect();
            let Some(&(first, mut end)) = sides.first() else { continue };
            count += 1;
            for (a, b) in &sides[1..] {
                if (end - first).norm() <= 0.02 {
                    break;
                }
                if (*a - end).norm() > 0.01 {
                    wrong.push(format!("{name}: a gap of {} mm", (*a - end).norm()));
                }
                end = *b;
            }
            if (end - first).norm() > 0.02 {
                wrong.push(format!("{name}: {} is open by {} mm", sheet.drawing.id, (end - first).norm()));
            }
        }
    }
    assert!(count > 150, "polygons are drawn: {count}");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The moments about the pole of the lever add up to nothing.
#[test]
fn levers_balance() {
    let (mut wrong, mut count) = (Vec::new(), 0);
    for (name, text) in examples() {
        let Some((source, solved)) = solved(&name, &text) else { continue };
        for sheet in sheets(&source, &solved, Kind::Lever, true) {
            let said = sheet.drawing.description.split_once("Their sum is ").map(|(_, said)| said);
            let share = said.and_then(|said| said.split(' ').next()?.parse::<f64>().ok());
            count += 1;
            if share.is_none_or(|share| share > 1e-9) {
                wrong.push(format!("{name}: {}", sheet.drawing.description));
            }
        }
    }
    assert!(count > 100, "levers are drawn: {count}");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The action line of every hinge touches its friction circle.
#[test]
fn action_lines_touch_friction_circles() {
    let (mut wrong, mut count) = (Vec::new(), 0);
    for (name, text) in examples() {
        let Some((source, solved)) = solved(&name, &text) else { continue };
        for sheet in sheets(&source, &solved, Kind::Friction, true) {
            let drawing = &sheet.drawing;
            for (i, group) in drawing.groups.iter().enumerate().filter(|(_, g)| g.class == "pair") {
                let own = || drawing.marks.iter().filter(move |m| m.group == i);
                let circle = own().find_map(|m| match m.shape {
                    Shape::Circle { centre, radius } if m.style == Style::FrictionCircle => {
                        Some((centre, radius))
                    }
                    _ => None,
                });
                let line = own().find_map(|m| match m.shape {
                    Shape::Line(a, b) if m.style == Style::Dashed => Some((a, b)),
                    _ => None,
                });
                let (Some((centre, radius)), Some((a, b))) = (circle, line) else { continue };
                count += 1;
                let away = ((b - a) / (b - a).norm()).cross(centre - a).abs();
                // a hinge that does not turn has a line through it
                if (away - radius).abs() > 0.01 && away > 0.01 {
                    wrong.push(format!("{name}: {} is {away} mm off a circle of {radius} mm", group.name));
                }
            }
        }
    }
    assert!(count > 30, "action lines are drawn: {count}");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
