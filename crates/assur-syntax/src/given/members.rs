//! The data in braces: members of bodies and cams, properties.

use super::datum::{Datum, GivenLine, GivenValue, Shown, datum, flag, one};
use super::kinds::GivenKind;
use crate::document::{
    Across, At, Body, Cam, CamMember, Expr, ExprKind, LineDirection, MassShape, Member, Phase, PhaseKind,
    PointMember, Property, ShapeKind, Turn, WheelMember, WheelSize,
};

/// The members of a link, the ground, a shaft or a slider, whose masses are indexed by this label.
pub(super) fn body<'d>(line: &mut GivenLine<'d>, members: &'d Body, label: &str) {
    let points = members.iter().filter_map(|member| match &member.node {
        Member::Mass(At { at, .. }) | Member::Weight(At { at, .. }) => Some(at.as_ref()),
        _ => None,
    });
    let masses: Vec<_> = points.collect();
    for member in members {
        match &member.node {
            Member::Point(point) => self::point(line, point),
            Member::PointFrom(from) => {
                let value = GivenValue::Several(vec![&from.first_distance, &from.second_distance]);
                let names = [&from.name, &from.first, &from.second].map(|name| name.node.as_str());
                line.add(datum("point.from", value).map(|datum| datum.called(&names)));
            }
            Member::Line(own) => match &own.direction {
                LineDirection::Along(angle) => {
                    let is_shown = line.subject == "ground" && is_right_angle(angle);
                    let shown = if is_shown { Shown::Figure } else { Shown::Text };
                    let names = [own.name.node.as_str(), &own.through.node];
                    line.add(one("line.along", angle).map(|d| d.called(&names).of(names[0]).shown(shown)));
                }
                LineDirection::To(_) => {}
            },
            Member::Circle(own) => {
                let names = [own.name.node.as_str(), &own.centre.node];
                line.add(one("circle.radius", &own.radius).map(|datum| datum.called(&names).of(names[0])));
            }
            Member::Profile(own) => line.join(&own.of.node),
            Member::Mass(own) => mass(line, "mass", own, label, masses.len() > 1),
            Member::Weight(own) => mass(line, "weight", own, label, masses.len() > 1),
            Member::Inertia(own) => {
                let centre = own.about.as_ref().or_else(|| masses.iter().copied().flatten().next());
                let index = centre.map_or(label, |point| &point.node);
                line.add(one("inertia", &own.value).map(|datum| datum.of(index)));
            }
            Member::Plane(at) => line.add(one("plane", at).map(|datum| datum.of(label))),
            Member::Wheel(own) => wheel(line, own),
            Member::Bad(_) => {}
        }
    }
}

fn point<'d>(line: &mut GivenLine<'d>, own: &'d PointMember) {
    let key = if matches!(own.at.kind, ExprKind::Polar(..)) { "point.polar" } else { "point" };
    let shown = if is_origin(&own.at) { Shown::Figure } else { Shown::Text };
    line.add(one(key, &own.at).map(|datum| datum.called(&[&own.name.node]).shown(shown)));
}

/// Whether a place is `(0, 0)`.
fn is_origin(at: &Expr) -> bool {
    let is_zero = |part: &Expr| matches!(&part.kind, ExprKind::Number(number) if number.value.abs() == 0.0);
    matches!(&at.kind, ExprKind::Vector(x, y) if is_zero(x) && is_zero(y))
}

/// Whether an expression is a multiple of 90°, which a figure shows exactly.
pub(super) fn is_right_angle(value: &Expr) -> bool {
    match &value.kind {
        ExprKind::Number(number) => {
            number.unit.as_ref().is_some_and(|unit| unit.node == "deg") && number.value % 90.0 == 0.0
        }
        ExprKind::Unary(_, value) => is_right_angle(value),
        _ => false,
    }
}

fn mass<'d>(line: &mut GivenLine<'d>, key: &str, own: &'d At, label: &str, several: bool) {
    let point = own.at.as_ref().map(|at| at.node.as_str());
    let index = match point {
        Some(point) if several => format!("{label},{point}"),
        _ => label.to_owned(),
    };
    // of a shape across which something is given, the mass is one per volume
    let is_density = own.shape.as_ref().is_some_and(|shape| shape.across.is_some());
    let key = if is_density { "mass.density" } else { key };
    line.add(one(key, &own.value).map(|datum| datum.of(index)));
    point.into_iter().for_each(|point| line.add(flag("mass.at").map(|datum| datum.called(&[point]))));
    own.shape.iter().for_each(|shape| self::shape(line, shape));
    let about = point.unwrap_or(label);
    own.inertia.iter().for_each(|value| line.add(one("inertia", value).map(|datum| datum.of(about))));
    own.plane.iter().for_each(|value| line.add(one("plane", value).map(|datum| datum.of(about))));
}

fn shape<'d>(line: &mut GivenLine<'d>, own: &'d MassShape) {
    let points: Vec<&str> = own.points.iter().map(|point| point.node.as_str()).collect();
    let key = match own.kind.node {
        ShapeKind::Rod => "rod",
        ShapeKind::Disc => "disc",
        ShapeKind::Ring => "ring",
        ShapeKind::Sphere => "sphere",
        ShapeKind::Plate => "plate",
    };
    let names = match own.kind.node {
        ShapeKind::Rod | ShapeKind::Plate => points.concat(),
        ShapeKind::Disc | ShapeKind::Ring | ShapeKind::Sphere => points.join(", "),
    };
    let value = own.radius.as_ref().map_or(GivenValue::Flag, |radius| GivenValue::One(radius, None));
    line.add(datum(key, value).map(|datum| datum.called(&[&*names])));
    own.inner.iter().for_each(|value| line.add(one("inner", value)));
    if let Some((across, value)) = &own.across {
        line.add(one(
            match across.node {
                Across::Thickness => "thickness",
                Across::Section => "section",
            },
            value,
        ));
    }
}

fn wheel<'d>(line: &mut GivenLine<'d>, own: &'d WheelMember) {
    let name = own.name.node.as_str();
    // the ground joins nothing
    if line.subject != "ground" {
        line.join(name);
    }
    let (key, value) = match &own.size {
        Some(WheelSize::Radius(value)) => ("wheel.radius", Some(value)),
        Some(WheelSize::Diameter(value)) => ("wheel.diameter", Some(value)),
        Some(WheelSize::Teeth(value)) => ("wheel.teeth", Some(value)),
        None => ("", None),
    };
    let of = |key: &str, value: &'d Expr| one(key, value).map(|datum| datum.called(&[name]).of(name));
    value.into_iter().for_each(|value| line.add(of(key, value)));
    own.module.iter().for_each(|value| line.add(of("wheel.module", value)));
}

/// The design of a cam.
pub(super) fn cam<'d>(line: &mut GivenLine<'d>, own: &'d Cam) {
    line.named(&[&own.name.node]);
    line.join(&own.name.node);
    let mut stage = 0;
    for member in &own.members {
        match &member.node {
            CamMember::Turning(turn) => {
                let word = match turn.node {
                    Turn::Ccw => "ccw",
                    Turn::Cw => "cw",
                };
                line.add(flag("cam.turning").map(|datum| datum.called(&[word])));
            }
            CamMember::Follower(follower) => {
                let names = [follower.motion.node.as_str(), &follower.shape.node];
                line.add(flag("follower").map(|datum| datum.called(&names)));
                properties(line, "follower", &own.name.node, &follower.properties);
            }
            CamMember::Phase(phase) => {
                stage += 1;
                self::phase(line, phase, &stage.to_string());
            }
            CamMember::Lift(curve) => {
                stage += 1;
                line.join(&curve.node);
                line.add(flag("lift").map(|datum| datum.called(&[&curve.node])));
            }
            CamMember::Property(own_property) => {
                properties(line, "cam", &own.name.node, std::slice::from_ref(own_property));
            }
            CamMember::Bad(_) => {}
        }
    }
}

fn phase<'d>(line: &mut GivenLine<'d>, own: &'d Phase, stage: &str) {
    let key = match own.kind.node {
        PhaseKind::Rise => "rise",
        PhaseKind::Dwell => "dwell",
        PhaseKind::Fall => "fall",
    };
    line.add(one(key, &own.angle).map(|datum| datum.of(stage)));
    own.through.iter().for_each(|value| line.add(one("through", value).map(|datum| datum.of(stage))));
    own.law.iter().for_each(|law| line.add(flag("law").map(|datum| datum.called(&[law.node.word()]))));
}

/// The properties in the braces of a block of this word, indexed by this name.
pub(super) fn properties<'d>(line: &mut GivenLine<'d>, block: &str, index: &str, all: &'d [Property]) {
    let has_wrap = all.iter().any(|property| property.name.node == "wrap");
    for property in all {
        let name = property.name.node.as_str();
        let block = if has_wrap && name == "load" { "band" } else { block };
        let datum = self::property(block, name, &property.values);
        line.add(datum.map(|datum| datum.of(index)));
        if let ("bevel" | "freewheel", [Expr { kind: ExprKind::Name(word), .. }]) =
            (name, property.values.as_slice())
        {
            let more = if name == "bevel" { "bevel.far" } else { "freewheel.turn" };
            line.add(flag(more).map(|datum| datum.called(&[word])));
        }
        properties(line, name, index, &property.properties);
    }
}

/// A property: one of its words is a flag of its own.
fn property<'d>(block: &str, name: &str, values: &'d [Expr]) -> Option<Datum<'d>> {
    let kind = GivenKind::of_property(block, name)?;
    match values {
        [Expr { kind: ExprKind::Name(word), .. }]
            if GivenKind::named(&format!("{name}.{word}")).is_some() =>
        {
            flag(&format!("{name}.{word}"))
        }
        [] | [Expr { kind: ExprKind::Name(_), .. }] if matches!(name, "bevel" | "freewheel") => {
            flag(kind.key)
        }
        [] => flag(kind.key),
        [value] => one(kind.key, value),
        values => datum(kind.key, GivenValue::Several(values.iter().collect())),
    }
}
