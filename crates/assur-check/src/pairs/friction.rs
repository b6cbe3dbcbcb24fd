//! The laws of friction that the properties of a pair state.

use crate::error::{FrictionError, PairError};
use crate::expr::context::Context;
use crate::expr::property::{Read, Value, find};
use crate::pairs::property::AMOUNTS;
use assur_model::model::Friction;
use assur_syntax::document::{Joint, JointKind, Property, Statement};
use miette::LabeledSpan;
use std::f64::consts::{FRAC_PI_2, PI};

/// Factor k of the equivalent coefficient k f of a round fit: contact along a line, even pressure all around, pressure as
/// after wear, p ∝ cos.
pub(crate) fn factor_of_fit(word: &str) -> f64 {
    match word {
        "even" => FRAC_PI_2,
        "worn" => 4.0 / PI,
        _ => 1.0,
    }
}

/// The law of a pair; `None` where it states none. A groove that is wrong is reported.
pub(crate) fn law(cx: &mut Context<'_>, joint: &Joint, properties: &[Read]) -> Option<Friction> {
    let number = |name| find(properties, name).map(Read::number);
    let fit = find(properties, "fit").map_or(1.0, |p| match p.value {
        Value::Word(word) => factor_of_fit(word),
        _ => p.number(),
    });
    if joint.kind.node == JointKind::Revolute {
        let radius = number("radius").unwrap_or(0.0);
        return number("friction_circle")
            .or_else(|| Some(number("equivalent_friction")? * radius))
            .or_else(|| Some(fit * number("friction")? * radius))
            .map(Friction::Circle);
    }
    let coefficient = number("friction")?;
    let equivalent = match find(properties, "groove") {
        None => coefficient,
        Some(Read { value: Value::Word(_), .. }) => fit * coefficient,
        Some(groove) => {
            half_angle(cx, groove)?;
            coefficient / libm::sin(groove.number())
        }
    };
    let both_ends = find(properties, "contacts").is_some();
    Some(if both_ends { Friction::BothEnds(equivalent) } else { Friction::Coefficient(equivalent) })
}

/// Half the angle of a V-groove is at most a right angle, which is a flat guide.
fn half_angle(cx: &mut Context<'_>, groove: &Read) -> Option<()> {
    if groove.number() <= FRAC_PI_2 {
        return Some(());
    }
    cx.error(PairError::PropertyValue {
        name: "groove".into(),
        wants: "half the angle between the faces, up to 90 deg".into(),
        got: "more".into(),
        example: "groove 35 deg".into(),
        span: groove.span,
    });
    None
}

/// Warns of friction that has no direction: the drive has neither a speed nor a sense.
pub(crate) fn no_motion(cx: &mut Context<'_>) {
    let still =
        |d: &assur_model::model::Drive| d.speed.is_none() && d.acceleration.is_none() && d.sense.is_none();
    let rubs = cx.mech.pairs.iter().any(|p| p.friction.is_some_and(|f| f.is_some()));
    let drives = &cx.mech.drives;
    if !rubs || drives.is_empty() || !drives.iter().all(still) {
        return;
    }
    let amount = |p: &&Property| AMOUNTS.contains(&p.name.node.as_str());
    let mut labels = Vec::new();
    for statement in &cx.doc.statements {
        let properties = match &statement.node {
            Statement::Joint(joint) => &joint.properties,
            Statement::All(all) => &all.properties,
            _ => continue,
        };
        for property in properties.iter().filter(amount) {
            let span = property.span;
            let text = if labels.is_empty() { "against which motion?" } else { "and here" };
            labels.push(LabeledSpan::at(span.start..span.end, text));
        }
    }
    let drive = &drives[0];
    let sense = match crate::motion::drive::moves(cx, drive.target) {
        crate::motion::drive::Moves::Turning => "turning ccw",
        _ => "moving forward",
    };
    let (drive, sense) = (drive.name.clone(), sense.to_owned());
    cx.error(FrictionError::NoMotion { drive, sense, labels });
}
