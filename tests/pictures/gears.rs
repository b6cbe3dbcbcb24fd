//! Wheels in mesh: circles, flanks and points against the numbers of the table.

use crate::drawn::{faults, sheets, solved};
use crate::every_example::examples;
use assur::internals::drawing::{Shape, Sheet, Style};
use assur::internals::math::Vec2;
use assur::internals::model::Gears;
use assur::internals::picture::Kind;

/// How far a circle, a point or a flank may be off, mm of paper.
const NEAR: f64 = 0.01;

/// The circles of the hinges: the axes.
fn axes(sheet: &Sheet) -> [Vec2; 2] {
    let hinges = sheet.drawing.marks.iter().filter(|mark| mark.style == Style::Hinge);
    let centres: Vec<Vec2> = hinges
        .filter_map(|mark| match mark.shape {
            Shape::Circle { centre, .. } => Some(centre),
            _ => None,
        })
        .collect();
    [centres[0], centres[1]]
}

/// The nearest segment of an outline to a point.
fn nearest(points: &[Vec2], at: Vec2) -> (f64, Vec2) {
    let apart = |ends: &[Vec2]| {
        let (way, to) = (ends[1] - ends[0], at - ends[0]);
        let share = (to.dot(way) / way.dot(way)).clamp(0.0, 1.0);
        ((to - way * share).norm(), way.unit().unwrap_or_default())
    };
    points.windows(2).map(apart).min_by(|a, b| a.0.total_cmp(&b.0)).expect("an outline")
}

fn wrong(gears: &Gears, sheet: &Sheet) -> Vec<String> {
    let mut wrong: Vec<String> = faults(sheet);
    let (pair, axes) = (&gears.pair, axes(sheet));
    let unit = pair.a / (axes[1] - axes[0]).norm();
    let marks = || sheet.drawing.marks.iter();
    for (gear, axis) in pair.gears.iter().zip(axes) {
        for wanted in [gear.da, gear.d, gear.dw, gear.db, gear.df].map(|d| 0.5 * d / unit) {
            let has = marks().any(|mark| match mark.shape {
                Shape::Arc { centre, radius, .. } => {
                    (centre - axis).norm() < NEAR && (radius - wanted).abs() < NEAR
                }
                _ => false,
            });
            if !has {
                wrong.push(format!("no circle of {wanted} mm"));
            }
        }
    }
    let outlines: Vec<&Vec<Vec2>> = marks()
        .filter_map(|mark| match &mark.shape {
            Shape::Lines { points, .. } if mark.style == Style::Medium => Some(points),
            _ => None,
        })
        .collect();
    let pitch = axes[0] + Vec2::new(0.5 * pair.gears[0].dw / unit, 0.0);
    let line = Vec2::direction(pair.alpha_w - std::f64::consts::FRAC_PI_2);
    let [to, from] = [pair.gears[0].approach, -pair.gears[1].approach];
    // flanks touch where the line of action is cut, a base pitch apart, and their normal is that line: through the pitch point
    for step in -3..=3 {
        let along = f64::from(step) * pair.pb;
        if along < from || along > to {
            continue;
        }
        for points in &outlines {
            let (apart, way) = nearest(points, pitch + line * (along / unit));
            // at the tip the corner is as near
            let is_flank = (along - from).min(to - along) > 0.05 * pair.pb;
            if apart > NEAR || is_flank && way.dot(line).abs() > 0.06 {
                wrong.push(format!("step {step}: {apart} mm off, {} across", way.dot(line)));
            }
        }
    }
    wrong
}

fn checked(name: &str, text: &str, count: &mut usize) -> Vec<String> {
    let Some((source, solved)) = solved(name, text) else { return vec![format!("{name}: not solved")] };
    let sheets = sheets(&source, &solved, Kind::Gears);
    let all = &solved.compiled.mechanism.gears;
    assert_eq!(all.len(), sheets.len(), "{name}");
    *count += sheets.len();
    let found = all.iter().zip(&sheets).flat_map(|(gears, sheet)| wrong(gears, sheet));
    found.map(|fault| format!("{name}: {fault}")).collect()
}

#[test]
fn gears_have_the_circles_of_their_table_and_touch_on_the_line_of_action() {
    let (mut wrong, mut count) = (Vec::new(), 0);
    for (name, text) in examples().into_iter().filter(|(_, text)| text.contains("mesh ")) {
        wrong.extend(checked(&name, &text, &mut count));
    }
    for (z, other, properties) in [
        (17, 17, ""),
        (18, 120, "{ shift 0.3, -0.3 }"),
        (24, 31, "{ pressure_angle 15 deg }"),
        (40, 130, "{ internal; shift 0.3, 0.6 }"),
        (25, 80, "{ internal; shift 0.2, 0.6 }"),
        (80, 25, "{ internal; shift 0.6, 0.2 }"),
    ] {
        let text = format!(
            "shaft I {{ wheel a teeth {z} module 3 mm }}\nshaft II {{ wheel b teeth {other} }}\n\
             mesh k: a - b {properties}\nfind contact_ratio(k)\n"
        );
        wrong.extend(checked(&format!("{z}/{other} {properties}"), &text, &mut count));
    }
    assert!(count > 20, "{count} meshes");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn the_reaction_of_a_journal_is_against_its_turn() {
    let text = "find M = journal_torque(load = 5 kN, radius = 20 mm, friction = 0.12) as N*m\n";
    let (source, solved) = solved("journal", text).expect("solved");
    let sheet = sheets(&source, &solved, Kind::Elements).remove(0);
    let mut marks = sheet.drawing.marks.iter();
    let found = marks.find_map(|mark| match mark.shape {
        Shape::Arrow(from, to) if mark.style == Style::Unknown => Some((from, to)),
        _ => None,
    });
    let (from, to) = found.expect("the reaction");
    let mut marks = sheet.drawing.marks.iter();
    let circle = marks.find_map(|mark| match mark.shape {
        Shape::Circle { radius, .. } if mark.style == Style::FrictionCircle => Some(radius),
        _ => None,
    });
    // y of paper goes down, and the shaft turns counter-clockwise
    let arm = from.cross((to - from).unit().expect("a direction"));
    assert!((arm - circle.expect("the circle of friction")).abs() < NEAR, "{arm}");
}
