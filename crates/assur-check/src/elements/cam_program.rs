//! The motion of a cam's follower over a turn, of its phases and tables.

use crate::elements::cam::{Given, Part};
use crate::expr::context::Context;
use crate::values::{format_value::format_value, typed::phrase};
use assur_math::element::cam::{Law, Program};
use assur_math::math::{Between, SAME};
use assur_model::model::Curve;
use assur_syntax::document::{Name, PhaseKind};
use assur_text::diagnostic::Diagnosis;
use assur_text::source::Span;
use assur_text::units::Dimension;
use std::f64::consts::TAU;
use std::sync::Arc;

/// A spline that swings below the base circle by less than this, of the greatest lift, does so within the digits of a table.
const SWING: f64 = 1e-3;

/// The curve of `lift along NAME`: a smooth one of the cam angle whose values are lifts.
pub(crate) fn curve(cx: &mut Context<'_>, name: &Name, way: Dimension) -> Option<Arc<Curve>> {
    cx.names.note_quantity(name);
    if !cx.is_curve(&name.node) {
        cx.no_curve_of_name(name);
        return None;
    }
    let checked = cx.values.curves.get(&name.node)?.clone();
    cx.builder.mech.has_curves = true;
    for (what, found, want) in
        [("arguments", checked.argument, Dimension::ANGLE), ("values", checked.value, way)]
    {
        if !found.fits(want) {
            let message = format!("its {what} should be {}, not {}", phrase(want), phrase(found));
            let help = format!(
                "the lift of a cam is a table of cam angle and lift: write `curve {} \
                 smooth {{ phi [deg], s [{}]`",
                name.node,
                if way == Dimension::ANGLE { "deg" } else { "mm" }
            );
            return refused(cx, name, message, help);
        }
    }
    if checked.curve.function.between() != Between::Spline {
        let message = "its second derivative jumps at every row, and so would the acceleration".to_owned();
        let help = format!(
            "write `curve {} smooth`, and `periodic` behind it for a table of a whole turn",
            name.node
        );
        return refused(cx, name, message, help);
    }
    Some(checked.curve)
}

fn refused<T>(cx: &mut Context<'_>, name: &Name, message: String, help: String) -> Option<T> {
    let message = format!("curve `{}` cannot be the lift of a cam: {message}", name.node);
    cx.error(Diagnosis::error("mech::cam::table", message).primary(name.span, "this curve").help(help));
    None
}

/// What is known of the motion so far.
struct Motion<'a> {
    name: &'a str,
    way: Dimension,
    scale: f64,
    lift: f64,
    moves: Vec<(f64, f64, Law)>,
}

/// The motion, if it fits into a turn and comes back to where it began.
pub(crate) fn program(
    cx: &mut Context<'_>,
    name: &str,
    span: Span,
    given: &[Part],
    way: Dimension,
) -> Option<Program> {
    let last = given.last()?;
    let total: f64 = given.iter().map(Part::angle).sum();
    if total > TAU * (1.0 + SAME) {
        let angle = |x: f64| format_value(x, Dimension::ANGLE);
        let (name, total, over) = (name.to_owned(), angle(total), angle(total - TAU));
        cx.error(
            Diagnosis::error(
                "mech::cam::turn_exceeded",
                format!("the phases of cam `{name}` take {total}, {over} more than one turn"),
            )
            .label(span, format!("{total} in all"))
            .primary(last.span(), "does not fit into the turn")
            .help(format!("make one of them shorter by {over}")),
        );
        return None;
    }
    let first = match given.first()? {
        Part::Table(curve, _) => curve.function.values().first().copied()?,
        Part::Phase(_) => 0.0,
    };
    let scale = given.iter().map(Part::greatest).fold(0.0, f64::max);
    let mut motion = Motion { name, way, scale, lift: first, moves: Vec::new() };
    for part in given {
        match part {
            Part::Phase(phase) => motion.phase(cx, phase)?,
            Part::Table(curve, span) => motion.table(cx, curve, *span)?,
        }
    }
    if (motion.lift - first).abs() > SAME * scale {
        not_back(cx, &motion, given, first);
        return None;
    }
    let program = Program::from_lift(first, &motion.moves);
    let (at, least) = program.least_lift();
    if least < -SWING * scale {
        let (at, least) = (format_value(at, Dimension::ANGLE), format_value(-least, way));
        cx.error(
            Diagnosis::warning(
                "mech::cam::swing",
                format!(
                    "between its rows the lift of cam `{name}` goes {least} below the base \
                     circle, at {at}"
                ),
            )
            .label(last.span(), "the motion")
            .help(
                "a spline swings where its rows turn sharply: write stretches at rest as \
                 `dwell` between two tables, or add rows",
            ),
        );
    }
    Some(program)
}

impl Part {
    fn angle(&self) -> f64 {
        match self {
            Self::Phase(phase) => phase.angle,
            Self::Table(curve, _) => curve.function.range().1 - curve.function.range().0,
        }
    }

    const fn span(&self) -> Span {
        match self {
            Self::Phase(phase) => phase.span,
            Self::Table(_, span) => *span,
        }
    }

    /// The greatest way or lift as written.
    fn greatest(&self) -> f64 {
        match self {
            Self::Phase(phase) => phase.way.unwrap_or(0.0),
            Self::Table(curve, _) => curve.function.values().iter().fold(0.0, |m, x| m.max(x.abs())),
        }
    }
}

impl Motion<'_> {
    fn phase(&mut self, cx: &mut Context<'_>, phase: &Given) -> Option<()> {
        let change = match (phase.kind, phase.way) {
            (PhaseKind::Dwell, _) => 0.0,
            (PhaseKind::Rise, way) => way.unwrap_or(0.0),
            (PhaseKind::Fall, way) => -way.unwrap_or(self.lift),
        };
        let low = SAME * self.scale;
        if self.lift + change < -low || phase.kind == PhaseKind::Fall && self.lift <= low {
            self.below(cx, -change, phase.span);
            return None;
        }
        self.lift += change;
        if self.lift.abs() <= low {
            self.lift = 0.0;
        }
        self.moves.push((phase.angle, change, phase.law));
        Some(())
    }

    fn table(&mut self, cx: &mut Context<'_>, curve: &Curve, span: Span) -> Option<()> {
        let values = curve.function.values();
        let (first, least) = (*values.first()?, values.iter().copied().fold(f64::INFINITY, f64::min));
        let shown = |x: f64| format_value(x, self.way);
        if (first - self.lift).abs() > SAME * self.scale {
            let message = format!(
                "curve `{}` begins with a lift of {}, but the follower of cam `{}` is at {} there",
                curve.name,
                shown(first),
                self.name,
                shown(self.lift)
            );
            let help = format!(
                "let the first row have the lift {}, or put a phase before it that leads there",
                shown(self.lift)
            );
            cx.error(Diagnosis::error("mech::cam::table", message).primary(span, "the first row").help(help));
            return None;
        }
        if least < -SAME * self.scale {
            let message = format!("the lift of curve `{}` goes down to {}", curve.name, shown(least));
            let help = format!("add {} to every lift: the base circle is the least radius", shown(-least));
            cx.error(Diagnosis::error("mech::cam::table", message).primary(span, "this curve").help(help));
            return None;
        }
        let low = SAME * self.scale;
        for (angle, change, terms) in curve.function.cubics() {
            self.moves.push((angle, change, Law::Spline(terms)));
        }
        let last = *values.last()?;
        self.lift = if last.abs() <= low { 0.0 } else { last };
        Some(())
    }

    fn below(&self, cx: &mut Context<'_>, by: f64, span: Span) {
        let (from, by) = (format_value(self.lift, self.way), format_value(by, self.way));
        cx.error(
            Diagnosis::error(
                "mech::cam::below_base",
                format!(
                    "the follower of cam `{}` falls by {by} from {from} above the base circle",
                    self.name
                ),
            )
            .label(span, format!("falls by {by}"))
            .help(
                "begin with a rise, and let it fall by no more than it rose: the base \
                 circle is the least radius",
            ),
        );
    }
}

/// Reports a follower that stands elsewhere after a turn.
fn not_back(cx: &mut Context<'_>, motion: &Motion<'_>, given: &[Part], first: f64) {
    let Some(last) = given.last() else { return };
    let (name, way, span) = (motion.name.to_owned(), motion.way, last.span());
    if given.iter().any(|part| matches!(part, Part::Table(..))) {
        let (first, found) = (format_value(first, way), format_value(motion.lift, way));
        let message = format!(
            "after one turn the follower of cam `{name}` has a lift of {found}, not \
             of {first}"
        );
        let help = format!("let the motion end with the lift it begins with, {first}");
        cx.error(Diagnosis::error("mech::cam::table", message).primary(span, "this cam").help(help));
        return;
    }
    let sum = |kind: PhaseKind| {
        let ways = given.iter().filter_map(|part| match part {
            Part::Phase(phase) if phase.kind == kind => phase.way,
            _ => None,
        });
        format_value(ways.sum(), way)
    };
    let (rises, falls) = (sum(PhaseKind::Rise), sum(PhaseKind::Fall));
    let left = format_value(motion.lift, way);
    cx.error(
        Diagnosis::error(
            "mech::cam::does_not_return",
            format!("after one turn the follower of cam `{name}` is {left} higher than before"),
        )
        .label(span, "after this phase")
        .help(format!(
            "let it fall by {left} more ({rises} up, {falls} down), or leave out \
             `through` in the last fall"
        )),
    );
}
