//! Distances of axes: of placed wheels, and of planets that mesh on both sides.

use crate::expr::context::Context;
use crate::statements::written::{braces, end_text};
use crate::trains::bevel::as_bevel;
use crate::trains::carrier::centre_on;
use crate::values::format_value::{digits, format_value, format_value_like};
use assur_model::model::{Bearing, LinkId, Pair, PairKind, TransmissionKind, Wheel};
use assur_syntax::document::{Joint, WheelSize};
use assur_text::diagnostic::{Diagnosis, Fix, Help};
use assur_text::source::{Edit, Span};
use assur_text::units::Dimension;
use indexmap::IndexMap;

/// A distance may differ from what the sizes ask for by this part.
const AGREES: f64 = 1e-6;

/// The arm that a mesh asks of a planet.
#[derive(Clone)]
pub(crate) struct Arm {
    length: f64,
    /// That of a mesh that is internal where this one is not, or the other way round.
    turned: f64,
    mesh: String,
    span: Span,
    /// What to write to turn it.
    help: String,
    /// The wheel that meshes with the planet.
    other: Wheel,
    /// The mesh is internal.
    internal: bool,
    /// The size of that wheel over the size of the planet's.
    ratio: f64,
    /// The mesh as one of bevel wheels.
    bevel: (String, Edit),
}

/// Arms of planets as their meshes ask for them, by shaft.
pub(crate) type Arms = IndexMap<LinkId, Vec<Arm>>;

/// Reports placed wheels whose distance is not that of their sizes.
pub(crate) fn distance(
    cx: &mut Context<'_>,
    wheels: [&Wheel; 2],
    carrier: LinkId,
    internal: bool,
    span: Span,
) -> Option<()> {
    let [a, b] = wheels;
    let (Some(p), Some(q)) = (centre_on(cx, a, carrier), centre_on(cx, b, carrier)) else { return Some(()) };
    let assumed = |w: &Wheel| {
        cx.builder.mech.open_sizes.iter().any(|s| s.wheel == w.name || s.teeth && w.teeth.is_some())
    };
    if assumed(a) || assumed(b) {
        return Some(());
    }
    let distance = (q - p).norm();
    let due = if internal { (a.radius - b.radius).abs() } else { a.radius + b.radius };
    if (distance - due).abs() <= AGREES * due {
        return Some(());
    }
    let length = |x| format_value(x, Dimension::LENGTH);
    let rule = if internal { "the difference of their radii" } else { "the sum of their radii" };
    cx.error(
        Diagnosis::error(
            "mech::train::centre_distance",
            format!(
                "the axes of `{}` and `{}` are {} apart, but {rule} is {}",
                a.name,
                b.name,
                length(distance),
                length(due)
            ),
        )
        .primary(span, "cannot touch")
        .help(format!(
            "move one of the axes, or change a size: {rule} must equal the distance \
             of the axes"
        )),
    );
    None
}

/// Notes the arm that a mesh asks of a planet, and warns of one that does not agree with another mesh.
pub(crate) fn arm(
    cx: &mut Context<'_>,
    arms: &mut Arms,
    planet: &Wheel,
    other: &Wheel,
    internal: bool,
    joint: &Joint,
) {
    let scaled = |w: &Wheel| cx.builder.mech.open_sizes.iter().any(|s| s.wheel == w.name && !s.teeth);
    if scaled(planet) || scaled(other) {
        return;
    }
    let (inner, outer) = ((other.radius - planet.radius).abs(), other.radius + planet.radius);
    let (length, turned) = if internal { (inner, outer) } else { (outer, inner) };
    let line =
        format!("mesh {}: {} - {}", joint.name.node, end_text(&joint.ends[0]), end_text(&joint.ends[1]));
    let help = if internal {
        format!("leave `internal` out: `{}` is not an internal mesh", joint.name.node)
    } else {
        let more = braces(&joint.properties, &["internal"]);
        format!("write `{line}{more}` for a ring with inner teeth")
    };
    let (mesh, span) = (joint.name.node.clone(), joint.name.span);
    let ratio = other.radius / planet.radius;
    let asked = Arm {
        length,
        turned,
        mesh,
        span,
        help,
        other: other.clone(),
        internal,
        ratio,
        bevel: as_bevel(joint, "bevel"),
    };
    let agree = |a: f64, b: f64| (a - b).abs() <= AGREES * b;
    let before = arms.entry(planet.link).or_default();
    let alike = before.iter().find(|a| {
        let outer = !a.internal && !internal && a.other.link != other.link;
        outer && agree(a.ratio, asked.ratio)
    });
    let alike = alike.cloned();
    let odd = before.iter().find(|a| !agree(a.length, length)).cloned();
    before.push(asked.clone());
    if let Some(first) = alike {
        turn_alike(cx, planet.link, first, &asked, joint);
    }
    let Some(first) = odd else { return };
    let modules = cx.builder.mech.open_sizes.iter().any(|s| s.teeth);
    // without a module an arm is a sum of teeth
    let text = |arm: f64| match modules {
        true => format!("{} teeth", digits(2.0 * arm)),
        false => format_value(arm, Dimension::LENGTH),
    };
    let help: Help = if agree(asked.turned, first.length) {
        format!("{}; then both arms are {}", asked.help, text(first.length)).into()
    } else if agree(first.turned, length) {
        format!("{}; then both arms are {}", first.help, text(length)).into()
    } else {
        // a ring is made to fit before a sun
        let ends = if first.internal {
            [(&first, length), (&asked, first.length)]
        } else {
            [(&asked, first.length), (&first, length)]
        };
        let fits = ends.into_iter().find_map(|(arm, due)| fitting(cx, arm, planet, due, &text(due)));
        fits.unwrap_or_else(|| {
            "make the arms equal: with coaxial wheels sun and planet add, ring and planet subtract; the speeds are the \
             same in both cases"
                .into()
        })
    };
    let one = text(first.length);
    let two = text(length);
    let error = Diagnosis::warning(
        "mech::train::planet_distance",
        format!(
            "planet `{}` cannot mesh on both sides: `{}` needs an arm of {one}, `{}` \
             needs {two}",
            cx.builder.mech.link(planet.link).name,
            first.mesh,
            asked.mesh
        ),
    )
    .label(first.span, format!("an arm of {one}"))
    .primary(asked.span, format!("an arm of {two}"))
    .help(help);
    cx.error(error);
}

/// Two wheels that mesh alike with a planet, which a differential cannot have.
fn turn_alike(cx: &mut Context<'_>, planet: LinkId, first: Arm, asked: &Arm, joint: &Joint) {
    let name = |link: LinkId| cx.builder.mech.link(link).name.clone();
    let shaft = name(planet);
    let (line, edit) = first.bevel;
    let (far, other_edit) = as_bevel(joint, "bevel far");
    let bevel = format!("write `{line}` and `{far}`");
    let edits = vec![edit, other_edit];
    let (span, first) = (first.span, name(first.other.link));
    let second = name(asked.other.link);
    cx.error(
        Diagnosis::advice(
            "mech::train::turn_alike",
            format!(
                "`{first}` and `{second}` turn in the same direction at the same speed: both mesh with planet `{shaft}` \
                 from outside, at the ratio {} seen from its carrier",
                digits(-1.0 / asked.ratio).replacen('-', "−", 1)
            ),
        )
        .label(span, format!("turns `{first}`"))
        .primary(asked.span, format!("turns `{second}` in the same sense"))
        .help(format!(
            "for bevel wheels {bevel}: then side wheels turn in opposite senses, seen from the carrier; with parallel \
             axes give it a second planet that meshes with `{shaft}`, and let `{second}` mesh with that one"
        ))
        .fixes([Fix { title: bevel, edits, certain: false }]),
    );
}

/// The size with which a wheel that meshes with a planet asks for an arm.
fn fitting(cx: &Context<'_>, arm: &Arm, planet: &Wheel, due: f64, then: &str) -> Option<Help> {
    let Wheel { name, radius: now, .. } = &arm.other;
    let radius = match (arm.internal, *now > planet.radius) {
        (false, _) => due - planet.radius,
        (true, true) => due + planet.radius,
        (true, false) => planet.radius - due,
    };
    let (word, value, size) = match cx.values.sizes.declared.get(name)?.member.size.as_ref()? {
        WheelSize::Teeth(size) => ("teeth", arm.other.teeth? * radius / now, size),
        WheelSize::Radius(size) => ("radius", radius, size),
        WheelSize::Diameter(size) => ("diameter", 2.0 * radius, size),
    };
    let value = match word {
        "teeth" if (value - value.round()).abs() > AGREES => return None,
        "teeth" => format!("{}", value.round()),
        _ => format_value_like(&cx.names, value, Dimension::LENGTH, size),
    };
    let words = format!(
        "write `wheel {name} {word} {value}`: then both arms are {then}; with coaxial wheels sun and planet add, ring and \
         planet subtract; the speeds are found in both cases"
    );
    (radius > 0.0).then(|| Help::write(size.span, &[value]).in_words(words))
}

/// Whether a wheel turns on a carrier that moves.
pub(crate) fn is_planet(cx: &Context<'_>, wheel: &Wheel, carrier: LinkId) -> bool {
    let on = |p: &Pair| match &p.kind {
        // a shaft stands second, what carries it first
        PairKind::Revolute(pins) if p.bearing.is_some() => {
            pins.first().is_some_and(|p| p.link == carrier)
                && pins.last().is_some_and(|p| p.link == wheel.link)
        }
        PairKind::Revolute(pins) => {
            let has = |link| pins.iter().any(|p| p.link == link);
            has(wheel.link) && has(carrier) && !has(LinkId::GROUND)
        }
        _ => false,
    };
    carrier != LinkId::GROUND && wheel.link != LinkId::GROUND && cx.builder.mech.pairs.iter().any(on)
}

/// A planet without a position: its carrier, and the distance of its axis from the carrier's where a mesh gives it.
pub(crate) struct Carried {
    pub(crate) carrier: LinkId,
    pub(crate) arm: Option<f64>,
}

/// What carries a shaft whose place on its carrier is left open; `None` of any other link.
pub(crate) fn carried(cx: &Context<'_>, planet: LinkId) -> Option<Carried> {
    let carrier = cx.builder.mech.pairs.iter().find_map(|p| match &p.kind {
        PairKind::Revolute(pins) if p.bearing == Some(Bearing::Open) => {
            let [base, own] = pins.as_slice() else { return None };
            (own.link == planet && base.link != LinkId::GROUND).then_some(base.link)
        }
        _ => None,
    })?;
    // the axis of a carrier is its origin where it is a shaft of the ground
    let turns = cx.builder.mech.pairs.iter().any(|p| match &p.kind {
        PairKind::Revolute(pins) if p.bearing.is_some() => {
            pins.first().is_some_and(|p| p.link == LinkId::GROUND)
                && pins.last().is_some_and(|p| p.link == carrier)
        }
        _ => false,
    });
    let arm = cx.builder.mech.pairs.iter().find_map(|p| {
        let PairKind::Transmission(t) = &p.kind else { return None };
        t.bevel.is_none().then_some(())?;
        let wheel = |i: usize| cx.wheel(t.ends.get(i)?);
        let (TransmissionKind::Mesh, Some(a), Some(b)) = (t.kind, wheel(0), wheel(1)) else { return None };
        let (own, other) = if a.link == planet { (a, b) } else { (b, a) };
        if own.link != planet || is_planet(cx, &other, carrier) {
            return None;
        }
        // both coefficients have one sign where the mesh is an outer one
        let terms = &t.laws.first()?.terms;
        let outer = terms[0].1 * terms[1].1 > 0.0;
        Some(if outer { other.radius + own.radius } else { (other.radius - own.radius).abs() })
    });
    Some(Carried { carrier, arm: arm.filter(|_| turns) })
}
