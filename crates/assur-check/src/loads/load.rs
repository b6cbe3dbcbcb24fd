//! Applied loads.

use super::pin::LoadedPin;
use crate::expr::{context::Context, positive::Want, property::read};
use crate::motion::drive::{Moves, coordinate, negated, on_moving};
use crate::names::{declared::ThingKind, suggestion::wrong_kind};
use crate::output::behind;
use crate::statements::written::written;
use crate::trains::friction_torque::friction_torque;
use crate::values::format_value::format_value;
use crate::values::typed::Type;
use assur_model::model::{self, Expr, Level, LinkId, LoadKind, PairId, PairKind, Place, Query};
use assur_syntax::document::{self, Brake, Load, Name, Site, Statement, Turn};
use assur_text::diagnostic::Diagnosis;
use assur_text::language::{BRAKE, JointKind};
use assur_text::source::Span;
use assur_text::units::Dimension;
use std::f64::consts::PI;

/// Enters all loads into the mechanism.
pub(crate) fn loads(cx: &mut Context<'_>) {
    let doc = cx.doc;
    for statement in &doc.statements {
        let load = match &statement.node {
            Statement::Load(l) => load(cx, l, statement.span),
            Statement::Brake(b) => brake(cx, b, statement.span),
            _ => None,
        };
        cx.builder.mech.loads.extend(load);
    }
}

fn load(cx: &mut Context<'_>, load: &Load, span: Span) -> Option<model::Load> {
    let (mut pin, mut spread) = (None, None);
    if let (Some(last), false) = (&load.last, matches!(load.site, Site::Segment { .. })) {
        let message = "a load that changes from end to end has no ends".to_owned();
        form(cx, message, "write the two points: `on beam from A to B`", last.span);
        return None;
    }
    let kind = match &load.site {
        Site::Pair(pair) => in_pair(cx, load, pair),
        Site::Pin(name) => {
            pin = LoadedPin::of(cx, name, load.kind.node);
            if load.against_motion.is_some() {
                pin = pin.and_then(|pin| pin.moves(cx, name, "nothing acts against its motion"));
            }
            pin.and_then(|pin| force_at(cx, load, Some(pin.on), Some(Place::Local(pin.at))))
        }
        Site::Segment { link, from, to } => {
            super::spread::along(cx, load, (link, from, to)).map(|(kind, over)| {
                spread = Some(over);
                kind
            })
        }
        Site::Link { link, at } => match load.kind.node {
            document::LoadKind::Force => force(cx, load, link, at.as_ref()),
            document::LoadKind::Torque => torque(cx, load, link, at.as_ref()),
        },
    };
    let when = match &load.when {
        Some(when) => {
            let condition = cx.condition(when, "the condition of a load");
            condition.filter(|t| no_forces(cx, t, "the condition", when.span)).map(Some)
        }
        None => Some(None),
    };
    let name = load.name.as_ref().map(|n| n.node.clone());
    Some(model::Load { name, span, kind: kind?, pin: pin.map(|pin| pin.pair), spread, when: when? })
}

/// A value that depends on no force.
fn value(cx: &mut Context<'_>, load: &Load, vector: bool, dimension: Dimension) -> Option<Expr> {
    value_of(cx, load, &load.value.value, vector, dimension)
}

/// The same of one of the values of a load.
pub(super) fn value_of(
    cx: &mut Context<'_>,
    load: &Load,
    source: &document::Expr,
    vector: bool,
    dimension: Dimension,
) -> Option<Expr> {
    let what = described(load);
    let want = Want(dimension);
    let value = if vector { cx.vector(source, &want, &what)? } else { cx.scalar(source, &want, &what)? };
    no_forces(cx, &value, &what, source.span).then_some(value)
}

pub(super) fn described(load: &Load) -> String {
    let word = kind_word(load.kind.node);
    match &load.name {
        Some(name) => format!("the {word} `{}`", name.node),
        None => format!("the {word}"),
    }
}

const fn kind_word(kind: document::LoadKind) -> &'static str {
    match kind {
        document::LoadKind::Force => "force",
        document::LoadKind::Torque => "torque",
    }
}

/// The pair of a slider on a rope, if the name is that of one.
pub(crate) fn slider(cx: &Context<'_>, name: &Name) -> Option<PairId> {
    let is_slider = cx.names.things.get(&name.node).is_some_and(|d| d.what == ThingKind::Slider);
    cx.find_pair(&name.node).filter(|_| is_slider)
}

/// Reports a force on a shaft whose place is left open: it has no arm.
pub(crate) fn of_open_shaft(cx: &mut Context<'_>, name: &Name, what: &str) -> Option<()> {
    if cx.find_link(&name.node).is_none_or(|link| cx.builder.mech.is_placed(link)) {
        return Some(());
    }
    if cx.names.bad.contains(&name.node) {
        return None;
    }
    let message = format!("the position of `{}` is not given, so {what} on it has no lever arm", name.node);
    form(
        cx,
        message,
        "write a torque, as in `torque on I = 10 N*m`, or attach the load to a rope",
        name.span,
    );
    None
}

/// A slider moves along one line: a force on it has no place and no direction, but a sign.
fn on_slider(
    cx: &mut Context<'_>,
    load: &Load,
    link: &Name,
    at: Option<&document::Place>,
) -> Option<LoadKind> {
    let on = cx.link(link)?;
    if let Some(sense) = &load.value.sense {
        let message = "a force has no sense of rotation".into();
        form(cx, message, "write a minus before the value instead", sense.span);
        return None;
    }
    if let Some(at) = at {
        let span = match at {
            document::Place::Point(name) => name.span,
            document::Place::Ground(expr) => expr.span,
        };
        form(cx, "a load on a slider needs no point".into(), "leave `at` out", span);
        return None;
    }
    let source = &load.value.value;
    if cx.is_vector(source)? {
        let help = "write the component along its line: `100 N`, positive in the direction in which the \
                    rope is paid out";
        form(cx, "the direction of a slider is not given".into(), help, source.span);
        return None;
    }
    let value = value(cx, load, false, Dimension::FORCE)?;
    let at = Place::Local(assur_math::math::Vec2::zero());
    if load.against_motion.is_some() {
        return Some(LoadKind::ForceAgainstMotion { on, at, value });
    }
    let value = crate::values::fold::pair(value, Expr::number(0.0));
    Some(LoadKind::Force { on, at, value, frame: None })
}

fn force(cx: &mut Context<'_>, load: &Load, link: &Name, at: Option<&document::Place>) -> Option<LoadKind> {
    if slider(cx, link).is_some() {
        return on_slider(cx, load, link, at);
    }
    if let Some(line) = as_torque(cx, load, link)
        .filter(|_| cx.find_link(&link.node).is_some_and(|l| !cx.builder.mech.is_placed(l)))
    {
        form(
            cx,
            "the value of this force is a torque".to_owned(),
            &format!("write `{line}`"),
            load.value.value.span,
        );
        return None;
    }
    of_open_shaft(cx, link, "a force")?;
    let on = moving(cx, link, "a force");
    let place = match at {
        Some(at) => on.and_then(|on| place(cx, on, at)),
        None => {
            if let Some(line) = as_torque(cx, load, link) {
                let help = format!("a torque needs no point: write `{line}`");
                cx.error(
                    Diagnosis::error(
                        "mech::geometry::force_without_place",
                        format!("a force on `{}` has no point, and its value is a torque", link.node),
                    )
                    .label(load.value.value.span, "a torque")
                    .help(help),
                );
                return None;
            }
            let example = example(cx, Some(on?), &link.node);
            let name = load.name.as_ref().map_or_else(String::new, |n| format!("{} ", n.node));
            let value = match written(&load.value.value) {
                Some(value) if cx.is_vector(&load.value.value)? || load.against_motion.is_some() => value,
                Some(value) => format!("{value} @ 270 deg"),
                None => "1000 N @ 270 deg".into(),
            };
            no_place(cx, "a force", link, format!("force {name}on {example} = {value}"));
            return None;
        }
    };
    force_at(cx, load, on, place)
}

/// A force where its link and its place on it are read; `None` of what has an error.
fn force_at(cx: &mut Context<'_>, load: &Load, on: Option<LinkId>, place: Option<Place>) -> Option<LoadKind> {
    if let Some(sense) = &load.value.sense {
        let message = "a force has no sense of rotation".into();
        form(cx, message, "give its direction: `1000 N @ 180 deg`", sense.span);
        return None;
    }
    let Some(against) = load.against_motion else {
        let value = force_value(cx, load, on);
        let frame = frame(cx, load.frame.as_ref());
        return Some(LoadKind::Force { on: on?, at: place?, value: value?, frame: frame? });
    };
    if cx.is_vector(&load.value.value)? {
        let message = "both `against motion` and the value give a direction".into();
        form(cx, message, "write a magnitude: `1400 N against motion`", load.value.value.span);
        return None;
    }
    if let Some(frame) = &load.frame {
        let message = "a force against the motion cannot turn with a link".into();
        form(cx, message, "leave `in` out", frame.span.to(against));
        return None;
    }
    let value = value(cx, load, false, Dimension::FORCE);
    Some(LoadKind::ForceAgainstMotion { on: on?, at: place?, value: value? })
}

/// The vector of a force; reports a magnitude that has no direction.
fn force_value(cx: &mut Context<'_>, load: &Load, on: Option<LinkId>) -> Option<Expr> {
    let source = &load.value.value;
    if cx.is_vector(source)? {
        return value(cx, load, true, Dimension::FORCE);
    }
    value(cx, load, false, Dimension::FORCE)?;
    let message = format!("{} has no direction", described(load));
    let help = directed(cx, source, on);
    form(cx, message, &help, source.span);
    None
}

/// A force with a direction: along the guide of its link, or down.
fn directed(cx: &Context<'_>, source: &document::Expr, on: Option<LinkId>) -> String {
    let value = written(source).unwrap_or_else(|| "1000 N".into());
    let guide = cx.builder.mech.pairs.iter().find_map(|p| match &p.kind {
        PairKind::Prismatic(g) if Some(g.slider) == on && g.guide == LinkId::GROUND => Some((p, g.along)),
        _ => None,
    });
    let Some((pair, along)) = guide else {
        return format!(
            "write the direction after the value: `{value} @ 270 deg` is down; or write `(Fx, Fy)`"
        );
    };
    let angle = along.angle();
    let back = if angle > 0.0 { angle - PI } else { angle + PI };
    let [along, back] = [angle, back].map(|a| format_value(a, Dimension::ANGLE));
    let pair = &pair.name;
    format!(
        "write the direction: `{value} @ {along}` is along the guide `{pair}`, `{value} @ \
         {back}` against it"
    )
}

/// A torque has no place.
pub(crate) fn whole_link(cx: &mut Context<'_>, at: Option<&document::Place>, line: &str) -> Option<()> {
    let span = match at {
        None => return Some(()),
        Some(document::Place::Point(name)) => name.span,
        Some(document::Place::Ground(expr)) => expr.span,
    };
    form(
        cx,
        "a torque acts on a whole link".into(),
        &format!("name a point of the link, or none: `{line}`"),
        span,
    );
    None
}

fn torque(cx: &mut Context<'_>, load: &Load, link: &Name, at: Option<&document::Place>) -> Option<LoadKind> {
    let on = moving(cx, link, "a torque");
    let name = load.name.as_ref().map_or_else(String::new, |n| format!("{} ", n.node));
    let line = format!("torque {name}on {} = {}", link.node, torque_text(load));
    let at = match at {
        Some(document::Place::Point(point)) => Some(cx.point(on?, point)?),
        other => {
            whole_link(cx, other, &line)?;
            None
        }
    };
    if let Some(frame) = &load.frame {
        form(cx, "a torque has no direction in the plane".into(), "leave `in` out", frame.span);
        return None;
    }
    let value = value(cx, load, false, Dimension::TORQUE);
    if let (Some(_), Some(sense)) = (load.against_motion, &load.value.sense) {
        let message = "the torque has two senses: that of `cw` or `ccw`, and `against motion`".into();
        form(cx, message, "keep one of them", sense.span);
        return None;
    }
    let value = turned(value?, load);
    Some(LoadKind::Torque { on: on?, at, value, against_motion: load.against_motion.is_some() })
}

/// The value of a torque as written, with what comes after it.
fn torque_text(load: &Load) -> String {
    let value = written(&load.value.value).unwrap_or_else(|| "…".into());
    let sense = match load.value.sense.as_ref().map(|s| s.node) {
        Some(Turn::Cw) => " cw",
        Some(Turn::Ccw) => " ccw",
        None => "",
    };
    let against = if load.against_motion.is_some() { " against motion" } else { "" };
    let when = if load.when.is_some() { " when …" } else { "" };
    format!("{value}{sense}{against}{when}")
}

fn turned(value: Expr, load: &Load) -> Expr {
    match &load.value.sense {
        Some(sense) if sense.node == Turn::Cw => negated(value),
        _ => value,
    }
}

/// The line that means the same as a load in a pair against its motion.
fn between(cx: &Context<'_>, load: &Load, (pair, moves): (PairId, Moves)) -> String {
    let mechanism = &cx.builder.mech;
    let links = mechanism.pair(pair).kind.links();
    let name = load.name.as_ref().map_or_else(|| "F".to_owned(), |name| name.node.clone());
    let value = written(&load.value.value).unwrap_or_else(|| "…".into());
    let moving: Vec<&str> = links
        .iter()
        .filter(|id| **id != LinkId::GROUND)
        .map(|id| mechanism.link(*id).name.as_str())
        .collect();
    match (moves, moving.as_slice()) {
        (Moves::Turning, [link]) => format!("write `torque {name} on {link} = {value} against motion`"),
        (Moves::Turning, [a, b]) => {
            format!("write `clutch {name}: {a} - {b} {{ capacity {value}; slipping }}`")
        }
        (_, [link]) => format!("write `force {name} on {link} at … = {value} against motion`"),
        _ => "friction between two sliders is `friction` of their pair; no other load between them is against motion"
            .to_owned(),
    }
}

fn in_pair(cx: &mut Context<'_>, load: &Load, pair: &Name) -> Option<LoadKind> {
    let pair = effort(
        cx,
        load.kind.node,
        load.kind.span,
        (&format!("{} … in {}", kind_word(load.kind.node), pair.node), pair),
    );
    if let Some(against) = load.against_motion {
        let message = "a load in a pair acts along its coordinate".into();
        let help = between(cx, load, pair?);
        form(cx, message, &help, against);
        return None;
    }
    if let Some(frame) = &load.frame {
        form(cx, "a load in a pair acts along its coordinate".into(), "leave `in` out", frame.span);
        return None;
    }
    let (pair, moves) = pair?;
    let dimension = if moves == Moves::Turning { Dimension::TORQUE } else { Dimension::FORCE };
    let value = value(cx, load, false, dimension)?;
    match &load.value.sense {
        Some(sense) if moves != Moves::Turning => {
            let message = "a force has no sense of rotation".into();
            form(cx, message, "write a minus before the value instead", sense.span);
            None
        }
        _ => Some(LoadKind::InPair { pair, value: turned(value, load), against_motion: false }),
    }
}

/// The pair in which an effort acts: a force where it slides, a torque where it turns.
pub(crate) fn effort(
    cx: &mut Context<'_>,
    kind: document::LoadKind,
    kind_span: Span,
    (own, name): (&str, &Name),
) -> Option<(PairId, Moves)> {
    let (pair, moves) = coordinate(cx, name)?;
    let fits = if moves == Moves::Turning { document::LoadKind::Torque } else { document::LoadKind::Force };
    if fits == kind {
        return Some((pair, moves));
    }
    let is = if moves == Moves::Turning { "a revolute pair" } else { "a pair that slides" };
    let given = format!("a {}", kind_word(kind));
    cx.error(
        Diagnosis::error(
            "mech::geometry::wrong_effort",
            format!("`{}` is {is}: a {} acts between its links, not {given}", name.node, kind_word(fits)),
        )
        .primary(name.span, is)
        .label(kind_span, &given)
        .help(format!("write `{}`", own.replacen(kind_word(kind), kind_word(fits), 1))),
    );
    None
}

/// A link that loads can act on.
pub(crate) fn moving(cx: &mut Context<'_>, name: &Name, what: &str) -> Option<LinkId> {
    named_pair(cx, name)?;
    let link = cx.link(name)?;
    on_moving(cx, link, name.span, what).map(|()| link)
}

/// Reports a pair where a link is due: a load between its links is written with another word.
fn named_pair(cx: &mut Context<'_>, name: &Name) -> Option<()> {
    use JointKind::{Cylinder, Prismatic, Revolute, Slot};
    let Some(declared) = cx.names.things.get(&name.node) else { return Some(()) };
    let ThingKind::Joint(Cylinder | Prismatic | Revolute | Slot) = declared.what else { return Some(()) };
    cx.names.note_thing(name);
    let (is, declared) = (cx.names.things[&name.node].what.phrase(), Some(cx.names.things[&name.node].span));
    let help = format!("what acts between its links is `in {0}`, not `on {0}`", name.node);
    cx.error(wrong_kind(&name.node, &is, "a link", name.span, declared, Some(help)));
    None
}

/// The line of a force whose value is a torque, as that of a torque.
fn as_torque(cx: &mut Context<'_>, load: &Load, link: &Name) -> Option<String> {
    let value = &load.value.value;
    let read = cx.quietly(|cx| cx.read(value))?;
    let name = load.name.as_ref().map_or_else(String::new, |n| format!("{} ", n.node));
    let sense = load.value.sense.as_ref().map_or("", |s| if s.node == Turn::Cw { " cw" } else { " ccw" });
    let is_torque = matches!(read.ty, Type::Number(_)) && read.ty.dimension() == Dimension::TORQUE;
    let line = format!("torque {name}on {} = {}{sense}", link.node, written(value)?);
    is_torque.then_some(line)
}

/// The point of a link at which a force acts.
pub(crate) fn place(cx: &mut Context<'_>, link: LinkId, at: &document::Place) -> Option<Place> {
    match at {
        document::Place::Point(name) => cx.point(link, name).map(Place::Local),
        document::Place::Ground(expr) => {
            let what = "the point of a force";
            let place = cx.vector(expr, &Want::LENGTH, what)?;
            no_forces(cx, &place, what, expr.span).then_some(Place::Ground(place))
        }
    }
}

/// The link whose axes a direction is given in. `Some(None)` where nothing is written.
pub(crate) fn frame(cx: &mut Context<'_>, frame: Option<&Name>) -> Option<Option<LinkId>> {
    match frame {
        None => Some(None),
        Some(name) => cx.link(name).map(|link| (link != LinkId::GROUND).then_some(link)),
    }
}

/// Reports a force without a point.
pub(crate) fn no_place(cx: &mut Context<'_>, what: &str, link: &Name, example: String) {
    cx.error(
        Diagnosis::error(
            "mech::geometry::force_without_place",
            format!("{what} on `{}` has no point", link.node),
        )
        .label(link.span, "the point is missing")
        .help(format!("give the point at which it acts: `{example}`")),
    );
}

/// `LINK at POINT` with a point that the link has.
pub(crate) fn example(cx: &Context<'_>, link: Option<LinkId>, name: &str) -> String {
    let point = link.and_then(|link| cx.point_meant(link)).unwrap_or("S");
    format!("{name} at {point}")
}

/// Reports words that do not belong together.
pub(crate) fn form(cx: &mut Context<'_>, message: String, help: &str, span: Span) {
    cx.error(
        Diagnosis::error("mech::geometry::load_form", message).label(span, "does not fit here").help(help),
    );
}

/// Whether an expression depends on nothing that is found from the loads; reports one that does.
pub(crate) fn no_forces(cx: &mut Context<'_>, expr: &Expr, what: &str, span: Span) -> bool {
    let simulates = cx.names.simulates;
    let of_motion = |query: &Query| match query {
        Query::Cycle(_) => Some("a function over the whole motion"),
        _ if query.facts().level == Level::Accelerations => Some("an acceleration"),
        _ => None,
    };
    let mut on = None;
    behind::queries(&cx.builder.mech, expr, &mut |query| {
        on = on.or(query.facts().from_loads).or(of_motion(query).filter(|_| simulates));
    });
    if let Some(on) = on {
        let help = if simulates {
            "use only given values, the instant, positions and velocities in a load of a motion and its condition: \
             accelerations and forces are found from the loads; instead of a load in proportion to an acceleration \
             give the link more mass or inertia"
        } else {
            "use only given values, positions, velocities and accelerations in a load and its condition: forces are \
             found from the loads"
        };
        cx.error(
            Diagnosis::error("mech::geometry::depends_on_forces", format!("{what} must not depend on {on}"))
                .label(span, on)
                .help(help),
        );
    }
    on.is_none()
}

// Brakes: torques of friction against the motion.

/// The load that a brake is.
pub(crate) fn brake(cx: &mut Context<'_>, brake: &Brake, span: Span) -> Option<model::Load> {
    let on = moving(cx, &brake.on, "a brake");
    let properties = read(cx, "a brake", &brake.properties, BRAKE)?;
    let value = Expr::number(friction_torque(cx, &brake.name, &properties)?);
    let kind = LoadKind::Torque { on: on?, at: None, value, against_motion: true };
    Some(model::Load { name: Some(brake.name.node.clone()), span, kind, pin: None, spread: None, when: None })
}
