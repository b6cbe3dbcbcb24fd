//! The laws of friction that the properties of a pair state.

use crate::expr::context::Context;
use crate::expr::property::{Read, Value, find};
use crate::values::format_value::digits;
use assur_model::model::{Friction, MoreFriction, StatedFriction};
use assur_syntax::document::{Joint, JointKind};
use assur_text::diagnostic::Diagnosis;
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

/// A law, and the coefficient that is given for it where it has a greater one.
pub(crate) type Law = (Friction, Option<StatedFriction>);

/// The law of a pair; `None` where it states none. A groove that is wrong is reported.
pub(crate) fn law(cx: &mut Context<'_>, joint: &Joint, properties: &[Read]) -> Option<Law> {
    let number = |name| find(properties, name).map(Read::number);
    let factor = find(properties, "fit").map_or(1.0, |p| match p.value {
        Value::Word(word) => factor_of_fit(word),
        _ => p.number(),
    });
    let coefficient = number("friction");
    let stated = |more| Some(StatedFriction { coefficient: coefficient?, more });
    let of_fit = |radius| {
        stated(MoreFriction::Fit { factor, radius }).filter(|it| factor != 1.0 && it.coefficient > 0.0)
    };
    if joint.kind.node == JointKind::Revolute {
        let radius = number("radius").unwrap_or(0.0);
        let circle = number("friction_circle")
            .or_else(|| Some(number("equivalent_friction")? * radius))
            .or_else(|| Some(factor * coefficient? * radius))?;
        return Some((Friction::Circle(circle), of_fit(Some(radius))));
    }
    let rolling = number("rolling").filter(|_| joint.kind.node == JointKind::Contact);
    let coefficient = coefficient.or_else(|| rolling.map(|_| 0.0))?;
    if let Some(arm) = rolling {
        return Some((Friction::Rolling { coefficient, arm }, None));
    }
    let (equivalent, stated) = match find(properties, "groove") {
        None => (coefficient, None),
        Some(Read { value: Value::Word(_), .. }) => (factor * coefficient, of_fit(None)),
        Some(groove) => {
            half_angle(cx, groove)?;
            (coefficient / libm::sin(groove.number()), stated(MoreFriction::Groove(groove.number())))
        }
    };
    let both_ends = find(properties, "contacts").is_some();
    let law = if both_ends { Friction::BothEnds(equivalent) } else { Friction::Coefficient(equivalent) };
    Some((law, stated))
}

/// The law of a pair at rest, where it has one of its own.
pub(crate) fn at_rest(
    cx: &mut Context<'_>,
    properties: &[Read],
    friction: Option<Friction>,
) -> Option<Friction> {
    let (still, moving) = (find(properties, "static_friction")?, find(properties, "friction")?);
    let (most, least) = (still.number(), moving.number());
    if most < least || least == 0.0 {
        let wants = format!("at least the coefficient of `friction`, {}", digits(least));
        let (wants, example) = if least == 0.0 {
            (
                "a value where `friction` is more than 0".to_owned(),
                "friction 0.3; static_friction 0.4".to_owned(),
            )
        } else {
            (wants, format!("static_friction {}", digits(least)))
        };
        let (name, got, span) = ("static_friction".to_owned(), digits(most), still.span);
        cx.error(
            Diagnosis::error("mech::geometry::property_value", format!("`{name}` takes {wants}"))
                .label(span, got)
                .help(format!("write `{example}`"))
                .quoted(span),
        );
        return None;
    }
    friction.filter(|_| most > least).map(|friction| friction.at_rest(most / least))
}

/// Half the angle of a V-groove is at most a right angle, which is a flat guide.
fn half_angle(cx: &mut Context<'_>, groove: &Read) -> Option<()> {
    if groove.number() <= FRAC_PI_2 {
        return Some(());
    }
    cx.error(
        Diagnosis::error(
            "mech::geometry::property_value",
            "`groove` takes half the angle between the faces, up to 90 deg",
        )
        .label(groove.span, "more")
        .help("write `groove 35 deg`")
        .quoted(groove.span),
    );
    None
}
