//! Drives.

use crate::expr::context::Context;
use crate::expr::positive::Want;
use crate::expr::property::given_twice;
use crate::links::lookup::is_linkage_pair;
use crate::motion::{place, step_size};
use crate::names::declared::ThingKind;
use crate::pairs::pair::link_point;
use crate::statements::written::{text, written};
use crate::values::format_value::{digits, format_value};
use crate::values::typed::{Dim, Type};
use assur_math::math::Vec2;
use assur_model::model;
use assur_model::model::{BinaryOp, DriveTarget, Expr, LinkId, PairId, PairKind, Positions, Value};
use assur_syntax::document::{
    Direction, Drive, DrivePosition, DriveRange, ExprKind, Name, Path, Sensed, Statement, Steps, Turn, Way,
};
use assur_text::diagnostic::{Diagnosis, Fix, Help};
use assur_text::source::{Span, Spanned};
use assur_text::units::Dimension;
use std::f64::consts::TAU;

/// The most steps a drive may take.
pub(crate) const MOST_STEPS: usize = 1_000_000;
/// What a range may miss a whole turn by, rad.
const WHOLE_TURN: f64 = 1e-9;

/// How a driven thing moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Moves {
    Turning,
    Sliding,
    Freely,
}

impl Moves {
    /// The dimension of position (0), speed (1) or acceleration (2).
    pub(crate) const fn dimension(self, order: usize) -> Dimension {
        match (self, order) {
            (Self::Turning, 0) => Dimension::ANGLE,
            (Self::Turning, 1) => Dimension::ANGULAR_VELOCITY,
            (Self::Turning, _) => Dimension::ANGULAR_ACCELERATION,
            (_, 0) => Dimension::LENGTH,
            (_, 1) => Dimension::VELOCITY,
            _ => Dimension::ACCELERATION,
        }
    }
}

/// Enters all drives into the mechanism.
pub(crate) fn drives(cx: &mut Context<'_>) {
    let doc = cx.doc;
    for statement in &doc.statements {
        if let Statement::Drive(d) = &statement.node
            && let Some(drive) = drive(cx, d, statement.span)
        {
            let drives =
                if place::is_place(cx, &d.target) { place::coordinates(&drive) } else { vec![drive] };
            cx.builder.mech.drives.extend(drives);
        }
    }
    same_count(cx);
}

fn drive(cx: &mut Context<'_>, drive: &Drive, span: Span) -> Option<model::Drive> {
    let (target, moves) = target(cx, &drive.target, "a drive")?;
    let name = text(&drive.target);
    if crate::motion::drive_kind::is_other(cx, drive, (target, moves), &name) {
        return None;
    }
    let once = target.is_none_or(|target| once(cx, target, &name, span));
    let positions = positions(cx, (drive, span), moves, &name);
    let speed = rate(cx, drive.rate.as_ref(), moves, 1, &name);
    let acceleration = rate(cx, drive.acceleration.as_ref(), moves, 2, &name);
    let sense = sense(cx, drive, moves);
    if let (None, Some(acceleration)) = (&drive.rate, &drive.acceleration) {
        let zero = zero(moves, 1);
        cx.error(
            Diagnosis::error(
                "mech::geometry::acceleration_without_speed",
                format!("`{name}` accelerates, but has no speed"),
            )
            .label(acceleration.value.span, "acceleration without speed")
            .help(format!("give the present speed too; from rest: `at {zero} accelerating …`")),
        );
        return None;
    }
    let (positions, mut speed, acceleration, sense) = (positions?, speed?, acceleration?, sense?);
    let of_time = crate::motion::simulation::follows_time(&positions);
    if of_time {
        crate::motion::simulation::own_rates(cx, drive, &name);
        // it moves, at rates that are derivatives
        speed = Some(match moves {
            Moves::Freely => Expr::Constant(Value::Vector(Vec2::zero())),
            _ => Expr::number(0.0),
        });
    }
    if matches!(positions, Positions::None) && !has_wheels(cx) {
        let example = match moves {
            Moves::Turning => "45 deg",
            Moves::Sliding => "100 mm",
            Moves::Freely => "(200 mm, 300 mm)",
        };
        cx.error(
            Diagnosis::error(
                "mech::geometry::drive_without_position",
                format!("`{name}` is driven, but its position is not given"),
            )
            .label(span, "the position is missing")
            .help(format!(
                "give a position, several, or a range: `drive {name} = {example}`; only trains of \
                 wheels and ropes move by rates alone"
            ))
            .fixes(Fix::quoted(&format!("write `drive {name} = {example}`"), span)),
        );
        return None;
    }
    let target = target?;
    let written = crate::motion::drive_kind::written_position(drive);
    once.then_some(model::Drive {
        name,
        span,
        target,
        positions,
        written,
        speed,
        acceleration,
        sense,
        free: false,
        sought: None,
        of_time,
    })
}

/// Zero, as position (0) or speed (1).
pub(crate) fn zero(moves: Moves, order: usize) -> String {
    if moves == Moves::Freely { "(0, 0)".into() } else { format_value(0.0, moves.dimension(order)) }
}

/// What is driven, and how it moves; no target where a slider has an error.
pub(crate) fn target(cx: &mut Context<'_>, path: &Path, what: &str) -> Option<(Option<DriveTarget>, Moves)> {
    if path.tail.is_some() {
        let (link, at) = link_point(cx, path, what)?;
        on_moving(cx, link, path.span(), what)?;
        return Some((Some(DriveTarget::Point(link, at)), Moves::Freely));
    }
    let name = &path.head;
    cx.names.note_thing(name);
    match cx.names.things.get(&name.node).map(|d| d.what) {
        Some(ThingKind::Slider) => Some((cx.find_pair(&name.node).map(DriveTarget::Pair), Moves::Sliding)),
        Some(ThingKind::Joint(kind)) if is_linkage_pair(kind) => {
            let (pair, moves) = coordinate(cx, name)?;
            Some((Some(DriveTarget::Pair(pair)), moves))
        }
        _ if cx.find_link(&name.node).is_some() => {
            let link = cx.link(name)?;
            on_moving(cx, link, name.span, what)?;
            Some((Some(DriveTarget::Link(link)), Moves::Turning))
        }
        _ => {
            cx.no_thing(name, "link or pair", "a link or a pair", |kind| match kind {
                ThingKind::Joint(kind) => is_linkage_pair(kind),
                kind => matches!(kind, ThingKind::Link | ThingKind::Shaft | ThingKind::Slider),
            });
            None
        }
    }
}

/// Whether the file has wheels, shafts or ropes, whose rates are found without positions.
pub(super) fn has_wheels(cx: &Context<'_>) -> bool {
    let kinds = cx.names.things.values().map(|d| d.what);
    kinds.into_iter().any(|kind| match kind {
        ThingKind::Joint(kind) => !is_linkage_pair(kind),
        kind => matches!(kind, ThingKind::Wheel | ThingKind::Shaft | ThingKind::Slider),
    })
}

/// Reports what stands on the ground.
pub(crate) fn on_moving(cx: &mut Context<'_>, link: LinkId, span: Span, what: &str) -> Option<()> {
    if link != LinkId::GROUND {
        return Some(());
    }
    let links = cx
        .builder
        .mech
        .links
        .iter()
        .skip(1)
        .filter(|link| !link.name.contains('.'))
        .map(|link| format!("`{}`", link.name))
        .take(8);
    let links = links.collect::<Vec<_>>().join(", ");
    let help = if links.is_empty() {
        "name a moving link".to_owned()
    } else {
        format!("name a moving link: {links}")
    };
    cx.error(
        Diagnosis::error(
            "mech::geometry::on_ground",
            format!("{what} on the ground has no effect: the ground is fixed"),
        )
        .label(span, "the ground")
        .help(help),
    );
    None
}

/// A pair with a coordinate, and how that changes. Reports a pair that has none.
pub(crate) fn coordinate(cx: &mut Context<'_>, name: &Name) -> Option<(PairId, Moves)> {
    let pair = cx.pair(name)?;
    let (is, help) = match &cx.builder.mech.pair(pair).kind {
        PairKind::Revolute(pins) if pins.len() == 2 => return Some((pair, Moves::Turning)),
        PairKind::Prismatic(_) | PairKind::Slot(_) | PairKind::Cylinder { .. } => {
            return Some((pair, Moves::Sliding));
        }
        PairKind::Revolute(pins) => {
            let links = pins.iter().map(|p| p.link).filter(|l| *l != LinkId::GROUND);
            let links = links.map(|l| format!("`{}`", cx.builder.mech.link(l).name));
            let links = links.collect::<Vec<_>>().join(", ");
            (format!("one pin in {} links", pins.len()), format!("name one of the links {links}"))
        }
        PairKind::Contact { .. } => ("a contact".into(), "name one of the two links".into()),
        PairKind::Weld { .. } => ("a weld".into(), "name one of its links: nothing moves in a weld".into()),
        PairKind::Transmission(t) => (t.kind.phrase().into(), "name one of the shafts or sliders".into()),
    };
    cx.error(no_coordinate(&name.node, &is, help, name.span));
    None
}

/// How the target of a drive moves.
pub(crate) fn moves(cx: &Context<'_>, target: DriveTarget) -> Moves {
    match target {
        DriveTarget::Link(_) => Moves::Turning,
        DriveTarget::Point(..) => Moves::Freely,
        DriveTarget::Place(..) => Moves::Sliding,
        DriveTarget::Pair(pair) => match cx.builder.mech.pair(pair).kind {
            PairKind::Revolute(_) => Moves::Turning,
            _ => Moves::Sliding,
        },
    }
}

pub(super) fn once(cx: &mut Context<'_>, target: DriveTarget, name: &str, span: Span) -> bool {
    let first = cx.builder.mech.drives.iter().find(|d| place::is_given(d, target));
    let Some(first) = first.map(|d| d.span) else { return true };
    let of = |place: Span| {
        let holds = |s: &&Spanned<Statement>| s.span.start <= place.start && place.end <= s.span.end;
        cx.doc.statements.iter().find(holds)
    };
    let both = [first, span].map(of);
    let is = |kind: fn(&Statement) -> bool| both.into_iter().flatten().find(|s| kind(&s.node));
    let drive = is(|s| matches!(s, Statement::Drive(_)));
    let equilibrium = is(|s| matches!(s, Statement::Equilibrium(_))).is_some();
    let message = Diagnosis::error("mech::geometry::driven_twice", format!("`{name}` is driven twice"))
        .primary(span, "driven again here")
        .label(first, "already driven here");
    let message = match drive {
        Some(drive) if is(|s| !matches!(s, Statement::Drive(_))).is_some() => {
            let why = match equilibrium {
                true => "`equilibrium` finds its position",
                false => "after a `start` the loads move it",
            };
            let what = format!("`drive {name}`");
            message.help(format!("leave out {what}: {why}")).left_out(&what, drive.span)
        }
        Some(_) => message
            .help(format!("write several positions in one drive: `drive {name} = 10 deg, 55 deg, 80 deg`")),
        None => message.help(
            "keep one of them: `equilibrium` is where it stays at rest, `start` is where a motion begins",
        ),
    };
    cx.error(message);
    false
}

fn positions(
    cx: &mut Context<'_>,
    (drive, span): (&Drive, Span),
    moves: Moves,
    name: &str,
) -> Option<Positions> {
    match &drive.position {
        None => Some(Positions::None),
        Some(DrivePosition::Values(values)) if values.len() == 1 => {
            if moves == Moves::Freely {
                number_for_point(cx, drive, &values[0])?;
            }
            timed(cx, &values[0], moves, name).map(|value| Positions::List(vec![value]))
        }
        Some(DrivePosition::Values(values)) if units_left_out(cx, values, moves, name) => None,
        Some(DrivePosition::Values(values)) => {
            let values = values.iter().map(|v| value(cx, v, moves, 0, name)).collect::<Vec<_>>();
            values.into_iter().collect::<Option<Vec<_>>>().map(Positions::List)
        }
        Some(DrivePosition::Range(course)) => range(cx, (drive, course, span), moves, name),
    }
}

/// Reports `10, 55, 80 deg`, once: the unit behind the last number is that of all.
fn units_left_out(cx: &mut Context<'_>, values: &[Sensed], moves: Moves, name: &str) -> bool {
    let number = |v: &Sensed| match &v.value.kind {
        ExprKind::Number(n) => Some((n.text.clone(), n.unit.as_ref().map(|u| u.node.clone()))),
        _ => None,
    };
    let Some(numbers) = values.iter().map(number).collect::<Option<Vec<_>>>() else { return false };
    let [before @ .., (_, Some(unit))] = numbers.as_slice() else { return false };
    if before.len() < 2 || moves == Moves::Freely || before.iter().any(|(_, unit)| unit.is_some()) {
        return false;
    }
    let all = numbers.iter().map(|(text, _)| format!("{text} {unit}")).collect::<Vec<_>>().join(", ");
    let span = values[0].value.span.to(values[values.len() - 1].value.span);
    let message = format!("each position of `{name}` needs its unit");
    cx.error(
        Diagnosis::error("mech::unit::missing", message)
            .primary(span, "numbers without a unit")
            .help(Help::write(span, &[all])),
    );
    true
}

/// Reports numbers of a driven point, once: it has two coordinates.
fn number_for_point(cx: &mut Context<'_>, drive: &Drive, position: &Sensed) -> Option<()> {
    let is_number = |cx: &mut Context<'_>, sensed: &Sensed| {
        let read = cx.quietly(|cx| cx.read(&sensed.value));
        read.is_some_and(|t| matches!(t.ty, Type::Number(Dim::Of(_)) if !t.pending))
    };
    if !is_number(cx, position) {
        return Some(());
    }
    let path = text(&drive.target);
    let value = written(&position.value).unwrap_or_else(|| "…".to_owned());
    cx.problems.reported.insert(("vector", path.clone()));
    let mut line = format!("drive {path} = ({value}, 0 m)");
    if let Some(rate) = &drive.rate {
        let value = written(&rate.value).unwrap_or_else(|| "…".to_owned());
        let both = if is_number(cx, rate) { format!("({value}, 0 m/s)") } else { value };
        line.push_str(&format!(" at {both}"));
    }
    cx.error(
        Diagnosis::error(
            "mech::unit::shape",
            format!("the position of `{path}` should be a vector, but this is a number"),
        )
        .primary(position.value.span, "a number")
        .help(format!("a point has two coordinates: write `{line}`, with its own second one")),
    );
    None
}

/// A position that may depend on the instant where the file follows a motion.
fn timed(cx: &mut Context<'_>, sensed: &Sensed, moves: Moves, name: &str) -> Option<Expr> {
    if sensed.sense.is_some() || crate::motion::simulation::statement(cx).is_none() {
        return value(cx, sensed, moves, 0, name);
    }
    let what = format!("the position of `{name}`");
    let want = Want(moves.dimension(0));
    let found = match moves {
        Moves::Freely => cx.timed_vector(&sensed.value, &want, &what)?,
        _ => cx.timed_scalar(&sensed.value, &want, &what)?,
    };
    crate::motion::simulation::differentiable(cx, &found, sensed.value.span).then_some(found)
}

fn range(
    cx: &mut Context<'_>,
    (drive, course, span): (&Drive, &DriveRange, Span),
    moves: Moves,
    name: &str,
) -> Option<Positions> {
    let what = format!("the position of `{name}`");
    let from = plain(cx, &course.from, moves, 0, &what);
    let to = plain(cx, &course.to, moves, 0, &what);
    if let (Some(from), Some(to)) = (&from, &to)
        && step_size::is_empty(from, to)
    {
        let line = crate::motion::drive_kind::at_one_position(drive, &course.from, name);
        cx.error(
            Diagnosis::error(
                "mech::geometry::empty_range",
                format!("the range of `{name}` has no length: it ends where it begins"),
            )
            .label(span, "one position, in several steps")
            .help(format!("write `{line}`, or another end of the range"))
            .fixes(Fix::quoted(&format!("write `{line}`"), span)),
        );
        return None;
    }
    let steps = match &course.steps {
        Steps::In(count) => cx.scalar_constant(count, &Want::NUMBER, "the number of steps")?,
        Steps::Of(each) => step_size::count(cx, (from.as_ref()?, to.as_ref()?), each, moves)?,
    };
    #[allow(clippy::cast_precision_loss)] // a million is exact
    let whole = steps.fract() == 0.0 && (1.0..=MOST_STEPS as f64).contains(&steps);
    if !whole {
        let value = digits(steps);
        cx.error(wrong_steps(&value, MOST_STEPS, course.steps.expr().span));
        return None;
    }
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // whole, from 1 to a million
    Some(Positions::Range { from: from?, to: to?, steps: steps as usize })
}

/// A value with the sense after it. `order` 0 is a position, 1 a speed, 2 an acceleration.
pub(crate) fn value(
    cx: &mut Context<'_>,
    sensed: &Sensed,
    moves: Moves,
    order: usize,
    name: &str,
) -> Option<Expr> {
    let what = format!("the {} of `{name}`", ["position", "speed", "acceleration"][order.min(2)]);
    if order > 0 && cx.problems.reported.contains(&("vector", name.to_owned())) {
        return None;
    }
    let value = plain(cx, &sensed.value, moves, order, &what);
    let Some(sense) = &sensed.sense else { return value };
    if moves == Moves::Turning {
        return value.map(|v| if sense.node == Turn::Cw { negated(v) } else { v });
    }
    wrong_turn(cx, sense, name);
    None
}

fn plain(
    cx: &mut Context<'_>,
    value: &assur_syntax::document::Expr,
    moves: Moves,
    order: usize,
    what: &str,
) -> Option<Expr> {
    let want = Want(moves.dimension(order));
    match moves {
        Moves::Freely => cx.poseless_vector(value, &want, what),
        _ => cx.poseless_scalar(value, &want, what),
    }
}

/// Minus; of a constant at once.
pub(crate) fn negated(expr: Expr) -> Expr {
    match expr {
        Expr::Constant(Value::Scalar(x)) => Expr::number(-x),
        other => Expr::Negate(Box::new(other)),
    }
}

fn wrong_turn(cx: &mut Context<'_>, sense: &Spanned<Turn>, name: &str) {
    cx.error(
        Diagnosis::error(
            "mech::geometry::wrong_sense",
            format!("`{name}` does not turn, so it has no sense of rotation"),
        )
        .label(sense.span, "does not fit here")
        .help("write a minus before the value instead")
        .quoted(sense.span),
    );
}

/// `Some(None)` where nothing is written.
fn rate(
    cx: &mut Context<'_>,
    rate: Option<&Sensed>,
    moves: Moves,
    order: usize,
    name: &str,
) -> Option<Option<Expr>> {
    match rate {
        None => Some(None),
        Some(rate) => value(cx, rate, moves, order, name).map(Some),
    }
}

/// The sense of a drive without speed, +1 or −1. `Some(None)` where nothing is written.
fn sense(cx: &mut Context<'_>, drive: &Drive, moves: Moves) -> Option<Option<f64>> {
    let Some(direction) = &drive.direction else { return Some(None) };
    let name = text(&drive.target);
    let (message, help) = match (direction.node, moves) {
        _ if drive.rate.is_some() => (
            format!("the direction of `{name}` is given twice: its speed already has a sign"),
            "leave the sense out, and write `cw` after a negative speed: `at 1500 rpm cw`",
        ),
        (Direction::Turning(turn), Moves::Turning) => {
            return Some(Some(if turn == Turn::Ccw { 1.0 } else { -1.0 }));
        }
        (Direction::Moving(way), Moves::Sliding) => {
            return Some(Some(if way == Way::Forward { 1.0 } else { -1.0 }));
        }
        (_, Moves::Turning) => (format!("`{name}` turns"), "write `turning ccw` or `turning cw`"),
        (_, Moves::Sliding) => (format!("`{name}` slides"), "write `moving forward` or `moving back`"),
        (_, Moves::Freely) => {
            (format!("`{name}` is a point"), "give its velocity as a vector: `at (1 m/s, 0)`")
        }
    };
    cx.error(
        Diagnosis::error("mech::geometry::wrong_sense", message)
            .label(direction.span, "does not fit here")
            .help(help)
            .quoted(direction.span),
    );
    None
}

/// How many positions a drive goes through, where that is known before anything is solved. Over a whole turn of a drive
/// that turns the last position of a range is the first again, and is left out.
pub(crate) fn count(positions: &Positions, moves: Moves) -> Option<usize> {
    match positions {
        Positions::None => Some(1),
        Positions::List(values) => Some(values.len()),
        Positions::Numbers(values) => Some(values.len()),
        Positions::Range { from, to, steps } => {
            if moves != Moves::Turning {
                return Some(steps + 1);
            }
            let turns = difference(from, to)? / TAU;
            let whole = turns.round() != 0.0 && (turns - turns.round()).abs() * TAU <= WHOLE_TURN;
            Some(if whole { *steps } else { steps + 1 })
        }
    }
}

/// `to − from` where it is a number.
pub(super) fn difference(from: &Expr, to: &Expr) -> Option<f64> {
    let number = |e: &Expr| if let Expr::Constant(Value::Scalar(x)) = e { Some(*x) } else { None };
    match to {
        Expr::Binary(BinaryOp::Add, a, b) if **a == *from => number(b),
        Expr::Binary(BinaryOp::Sub, a, b) if **a == *from => number(b).map(|x| -x),
        _ => Some(number(to)? - number(from)?),
    }
}

/// Drives that go through several positions go through equally many.
fn same_count(cx: &mut Context<'_>) {
    let counted = cx.builder.mech.drives.iter().filter_map(|d| {
        let count = count(&d.positions, moves(cx, d.target))?;
        (count > 1).then_some((count, d.span))
    });
    let counted = counted.collect::<Vec<_>>();
    let Some(&(first_count, first)) = counted.first() else { return };
    for &(count, span) in &counted[1..] {
        if count != first_count {
            cx.error(
                Diagnosis::error(
                    "mech::geometry::positions_differ",
                    format!(
                        "the drives go through different numbers of positions: {first_count} and {count}"
                    ),
                )
                .label(first, format!("{first_count} positions"))
                .primary(span, format!("{count} positions"))
                .help(
                    "give both the same number of positions, or one of them a single position: drives move \
                     together, pose by pose",
                ),
            );
        }
    }
}

/// Reports a second value for one thing.
pub(crate) fn stated_twice(cx: &mut Context<'_>, name: &str, again: Span, first: Span) {
    cx.error(given_twice(&format!("`{name}`"), again, first));
}

/// A wrong number of steps.
pub fn wrong_steps(value: &str, most: usize, span: Span) -> Diagnosis {
    Diagnosis::error(
        "mech::geometry::steps",
        format!("the number of steps must be a whole number from 1 to {most}; got {value}"),
    )
    .label(span, value)
    .help("write for example `0 deg .. 360 deg in 12 steps`, one pose every 30 deg")
}

/// A thing that has no coordinate to drive or to compare.
pub fn no_coordinate(name: &str, is: &str, help: impl Into<Help>, span: Span) -> Diagnosis {
    Diagnosis::error("mech::geometry::no_coordinate", format!("`{name}` is {is} and has no coordinate"))
        .label(span, "no coordinate")
        .help(help)
}
