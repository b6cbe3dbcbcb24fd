//! Plate cams: what stands in their braces, and whether a follower can follow it.

use crate::elements::{cam_fault, cam_program};
use crate::expr::context::Context;
use crate::expr::positive::positive;
use crate::expr::property::{Read, find, given_twice, read, read_beside};
use crate::names::declared::ThingKind;
use crate::names::suggestion::{not_declared, suggestion};
use crate::pairs::transmission::known;
use assur_math::element::cam::{Cam, Follower, Law, Shape};
use assur_model::model::{Curve, PlateCam};
use assur_syntax::document;
use assur_syntax::document::{CamLaw, CamMember, Member, Name, Phase, PhaseKind, Property, Statement, Turn};
use assur_text::diagnostic::{Diagnosis, Help};
use assur_text::language::{CAM, FOLLOWER, Place, words_of};
use assur_text::source::Span;
use assur_text::units::Dimension;
use std::sync::Arc;

/// Enters all designed cams into the mechanism.
pub(crate) fn cams(cx: &mut Context<'_>) {
    let doc = cx.doc;
    for statement in &doc.statements {
        let Statement::Cam(statement) = &statement.node else { continue };
        if let Some(cam) = cam(cx, statement)
            && cx.builder.mech.cams.iter().all(|c| c.name != cam.name)
        {
            cam_fault::follows(cx, &cam);
            cx.builder.mech.cams.push(cam);
        }
    }
    profiles(cx);
}

/// What stands in the braces, as far as it can be read.
struct Members<'a> {
    turning: Option<Turn>,
    follower: Option<&'a document::Follower>,
    properties: Vec<Property>,
    phases: Vec<(Move<'a>, Span)>,
    bad: bool,
}

/// A part of the follower's motion.
#[derive(Clone, Copy)]
enum Move<'a> {
    Phase(&'a Phase),
    Along(&'a Name),
}

fn cam(cx: &mut Context<'_>, cam: &document::Cam) -> Option<PlateCam> {
    let members = members(cx, cam);
    let others = words_of(Place::CamMember).collect::<Vec<_>>();
    let properties = read_beside(cx, "a cam", &members.properties, CAM, &others);
    let follower = members.follower.map(|f| follower_of(cx, f));
    let oscillates = members.follower.map(|f| f.motion.node == "oscillating");
    let way = match oscillates {
        Some(true) => Some(Dimension::ANGLE),
        Some(false) => Some(Dimension::LENGTH),
        None => None,
    };
    let given = phases(cx, &members.phases, way);
    if members.bad {
        return None;
    }
    let (name, span) = (&cam.name.node, cam.name.span);
    let properties = properties?;
    let base = find(&properties, "base_radius");
    let missing = match (base, members.turning, &follower) {
        (None, ..) => Some(("base_radius 50 mm", "the least radius of the pitch curve")),
        (_, None, _) => Some(("turning ccw", "its sense of rotation")),
        (_, _, None) => Some(("follower translating roller { radius 10 mm }", "its follower")),
        _ if members.phases.is_empty() => {
            Some(("rise 90 deg through 20 mm cycloidal", "the motion of its follower"))
        }
        _ => None,
    };
    if let Some((example, what)) = missing {
        return incomplete(
            cx,
            format!("cam `{name}` does not give {what}"),
            format!("add `{example}`"),
            span,
        );
    }
    let (base, follower, given) = (base?, follower??, given?);
    let program = cam_program::program(cx, name, span, &given, way?)?;
    let speed = find(&properties, "speed").map(Read::number);
    match Cam::new(base.number(), members.turning? == Turn::Ccw, follower, program) {
        Ok(cam) => Some(PlateCam { name: name.clone(), span, cam, speed }),
        Err(misfit) => {
            cam_fault::misfit(cx, name, base, follower, misfit);
            None
        }
    }
}

fn members<'a>(cx: &mut Context<'_>, cam: &'a document::Cam) -> Members<'a> {
    let mut found =
        Members { turning: None, follower: None, properties: Vec::new(), phases: Vec::new(), bad: false };
    let mut seen: [Option<Span>; 2] = [None; 2];
    for member in &cam.members {
        let once = match &member.node {
            CamMember::Turning(turn) => {
                found.turning = found.turning.or(Some(turn.node));
                Some((0, "the sense of the cam"))
            }
            CamMember::Follower(f) => {
                found.follower = found.follower.or(Some(f));
                Some((1, "the follower"))
            }
            CamMember::Property(p) => {
                found.properties.push(p.clone());
                None
            }
            CamMember::Phase(p) => {
                found.phases.push((Move::Phase(p), member.span));
                None
            }
            CamMember::Lift(curve) => {
                found.phases.push((Move::Along(curve), member.span));
                None
            }
            CamMember::Bad(_) => {
                found.bad = true;
                None
            }
        };
        let Some((which, what)) = once else { continue };
        match seen[which] {
            None => seen[which] = Some(member.span),
            Some(first) => {
                let what = what.to_owned();
                cx.error(given_twice(&what, member.span, first));
                found.bad = true;
            }
        }
    }
    found
}

fn incomplete<T>(cx: &mut Context<'_>, message: String, help: String, span: Span) -> Option<T> {
    cx.error(Diagnosis::error("mech::geometry::incomplete", message).label(span, "this cam").help(help));
    None
}

const MOTIONS: &[&str] = &["oscillating", "translating"];
const SHAPES: &[&str] = &["roller", "knife", "flat"];
/// What others call them.
const OTHER_SHAPES: &[(&str, &str)] = &[
    ("flat_faced", "flat"),
    ("flat_face", "flat"),
    ("mushroom", "flat"),
    ("pointed", "knife"),
    ("knife_edge", "knife"),
    ("point", "knife"),
    ("tip", "knife"),
];
const OTHER_MOTIONS: &[(&str, &str)] = &[
    ("rocking", "oscillating"),
    ("swinging", "oscillating"),
    ("rotating", "oscillating"),
    ("reciprocating", "translating"),
    ("sliding", "translating"),
    ("linear", "translating"),
];

/// Reports `follower roller translating`: the motion comes first.
fn swapped(cx: &mut Context<'_>, follower: &document::Follower) -> Option<()> {
    let (first, second) = (&follower.motion, &follower.shape);
    if !SHAPES.contains(&first.node.as_str()) || !MOTIONS.contains(&second.node.as_str()) {
        return Some(());
    }
    let at = first.span.to(second.span);
    let line = format!("follower {} {}", second.node, first.node);
    let words = format!("write `{line}`: how it moves, then its end");
    let help = Help::write(at, &[format!("{} {}", second.node, first.node)]).in_words(words).certain();
    cx.error(
        Diagnosis::error("mech::name::unknown", format!("there is no follower motion `{}`", first.node))
            .primary(at, "in the other order")
            .help(help),
    );
    None
}

fn follower_of(cx: &mut Context<'_>, follower: &document::Follower) -> Option<Follower> {
    swapped(cx, follower)?;
    let motion = one_of(cx, &follower.motion, "follower motion", MOTIONS);
    let shape = one_of(cx, &follower.shape, "follower", SHAPES);
    let properties = read(cx, "a follower", &follower.properties, FOLLOWER);
    let (motion, shape, properties) = (motion?, shape?, properties?);
    let oscillates = motion == "oscillating";
    let what = format!("{motion} {shape}");
    let wanted: &[&str] = match (oscillates, shape) {
        (true, "roller") => &["arm", "pivot_distance", "radius"],
        (true, "knife") => &["arm", "pivot_distance"],
        (true, _) => &["pivot_distance"],
        (false, "roller") => &["radius"],
        _ => &[],
    };
    let span = follower.motion.span.to(follower.shape.span);
    for name in wanted {
        if find(&properties, name).is_none() {
            let example = FOLLOWER.iter().find(|s| s.name == *name).map_or("", |s| s.example);
            let message = format!("a follower `{what}` needs `{name}`");
            return incomplete(cx, message, format!("add `{example}` to its braces"), span);
        }
    }
    let sense = [find(&properties, "with_cam"), find(&properties, "against_cam")];
    if oscillates && sense.iter().flatten().count() != 1 {
        let message = "the sense in which the oscillating follower rises is missing".to_owned();
        let help = "write one of `with_cam` (the rise turns it in the sense of the cam) and `against_cam`";
        return incomplete(cx, message, help.into(), span);
    }
    let too_much = properties.iter().find(|p| match p.name {
        "with_cam" | "against_cam" => !oscillates,
        "offset" => oscillates == (shape != "flat"),
        name => !wanted.contains(&name),
    });
    if let Some(property) = too_much {
        let message = format!("`{}` does not apply to a follower `{what}`", property.name);
        return incomplete(cx, message, "leave it out".into(), property.span);
    }
    let number = |name: &str| find(&properties, name).map_or(0.0, Read::number);
    let shape = match shape {
        "roller" => Shape::Roller(number("radius")),
        "knife" => Shape::Knife,
        _ => Shape::Flat,
    };
    Some(if oscillates {
        Follower::Oscillating {
            shape,
            arm: number("arm"),
            pivot_distance: number("pivot_distance"),
            with_cam: sense[0].is_some(),
            offset: number("offset"),
        }
    } else {
        Follower::Translating { shape, offset: number("offset") }
    })
}

fn one_of(
    cx: &mut Context<'_>,
    word: &Name,
    kind: &'static str,
    words: &[&'static str],
) -> Option<&'static str> {
    if let Some(known) = words.iter().find(|w| **w == word.node) {
        return Some(known);
    }
    let other = OTHER_SHAPES
        .iter()
        .chain(OTHER_MOTIONS)
        .find(|(other, ours)| *other == word.node && words.contains(ours));
    let help = match other {
        Some((_, ours)) => Some(Help::write(word.span, &[(*ours).to_owned()])),
        None => suggestion(&word.node, word.span, words, &format!("{kind}s")),
    };
    let (name, span) = (word.node.clone(), word.span);
    cx.error(not_declared(kind, &name, None, span, help));
    None
}

/// A phase as given: angle, way (`None` for a fall all the way down), law; and its place.
pub(crate) struct Given {
    pub kind: PhaseKind,
    pub angle: f64,
    pub way: Option<f64>,
    pub law: Law,
    pub span: Span,
}

/// A part of the motion as given.
pub(crate) enum Part {
    Phase(Given),
    Table(Arc<Curve>, Span),
}

fn phases(cx: &mut Context<'_>, phases: &[(Move<'_>, Span)], way: Option<Dimension>) -> Option<Vec<Part>> {
    let each = phases.iter().map(|(what, span)| match what {
        Move::Phase(p) => phase(cx, p, *span, way).map(Part::Phase),
        Move::Along(name) => cam_program::curve(cx, name, way?).map(|curve| Part::Table(curve, *span)),
    });
    let each = each.collect::<Vec<_>>();
    each.into_iter().collect()
}

fn phase(cx: &mut Context<'_>, phase: &Phase, span: Span, way: Option<Dimension>) -> Option<Given> {
    let angle = positive(cx, &phase.angle, Dimension::ANGLE, "the angle the cam turns");
    let through = match (&phase.through, way) {
        (Some(through), Some(way)) => positive(cx, through, way, "the lift of the follower").map(Some),
        (_, None) => None,
        (None, _) => Some(None),
    };
    let kind = phase.kind.node;
    let example = if way == Some(Dimension::ANGLE) { "18 deg" } else { "20 mm" };
    let wrong = match (kind, &phase.through, &phase.law) {
        (PhaseKind::Dwell, None, None) => None,
        (PhaseKind::Dwell, ..) => {
            Some(("a dwell has neither a lift nor a law", "write `dwell 10 deg`".to_owned()))
        }
        (PhaseKind::Rise, None, _) => {
            Some(("a rise needs a lift", format!("write `rise 60 deg through {example} cycloidal`")))
        }
        (_, _, None) => Some((
            "the law of the follower is missing",
            "add one of uniform, parabolic, harmonic, cycloidal, poly345, poly4567, modified_trapezoid, \
             modified_sine after it"
                .to_owned(),
        )),
        _ => None,
    };
    if let Some((message, help)) = wrong {
        return incomplete(cx, message.to_owned(), help, span);
    }
    let law = phase.law.as_ref().map_or(Law::Dwell, |l| law(l.node));
    Some(Given { kind, angle: angle?, way: through?, law, span })
}

const fn law(law: CamLaw) -> Law {
    match law {
        CamLaw::Uniform => Law::Uniform,
        CamLaw::Parabolic => Law::Parabolic,
        CamLaw::Harmonic => Law::Harmonic,
        CamLaw::Cycloidal => Law::Cycloidal,
        CamLaw::Poly345 => Law::Poly345,
        CamLaw::Poly4567 => Law::Poly4567,
        CamLaw::ModifiedTrapezoid => Law::ModifiedTrapezoid,
        CamLaw::ModifiedSine => Law::ModifiedSine,
    }
}

/// Cams that profiles of links refer to.
fn profiles(cx: &mut Context<'_>) {
    let doc = cx.doc;
    for statement in &doc.statements {
        let body = match &statement.node {
            Statement::Ground(ground) => &ground.body,
            Statement::Link(link) => &link.body,
            _ => continue,
        };
        for member in body {
            if let Member::Profile(profile) = &member.node {
                known(cx, &profile.of, "cam", &[ThingKind::Cam]);
            }
        }
    }
}
