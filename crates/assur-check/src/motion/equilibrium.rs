//! Equilibrium: coordinates at which no effort is needed. For the structure each is a drive: one freedom whose position is known.

use crate::expr::context::Context;
use crate::expr::positive::Want;
use crate::expr::results::Call;
use crate::motion::drive::{Moves, once, target, value};
use crate::statements::written::text;
use crate::values::format_value::format_value;
use crate::values::typed::{Type, Typed};
use assur_math::math::Vec2;
use assur_model::model::{At, Drive, DriveTarget, Expr, LinkId, ModePart, Positions, Query, Sought};
use assur_syntax::document::{self, Balanced, ExprKind, Statement};
use assur_text::diagnostic::Diagnosis;
use assur_text::language::Function;
use assur_text::source::Span;
use assur_text::units::Dimension;

const CODE: &str = "mech::equilibrium::not_here";

/// Enters all equilibria into the mechanism.
pub(crate) fn equilibria(cx: &mut Context<'_>) {
    let doc = cx.doc;
    let several = count(cx) > 1;
    for statement in &doc.statements {
        let Statement::Equilibrium(all) = &statement.node else { continue };
        for one in all {
            if let Some(drive) = equilibrium(cx, one, several) {
                cx.builder.mech.drives.push(drive);
            }
        }
    }
}

fn equilibrium(cx: &mut Context<'_>, one: &Balanced, several: bool) -> Option<Drive> {
    let (name, span) = (text(&one.target), one.target.span());
    let (target, moves) = target(cx, &one.target, "an equilibrium")?;
    if moves == Moves::Freely {
        let message =
            format!("an equilibrium is the value of an angle or a coordinate, and `{name}` is a point");
        let help = match target {
            Some(DriveTarget::Point(link, _)) if !is_held(cx, link) => slides(cx, one),
            _ => format!("name its link, `equilibrium {}`, or a pair", one.target.head.node),
        };
        refuse(cx, message, span, help);
        return None;
    }
    let is_once = target.is_none_or(|target| once(cx, target, &name, span));
    let want = Want(moves.dimension(0));
    let what = format!("the place of the equilibrium of `{name}`");
    let sought = match &one.sought {
        document::Sought::Near(near) => Some(Sought::Near(cx.scalar_constant(near, &want, &what)?)),
        document::Sought::Between(from, to) => {
            let (from, to) = (cx.scalar_constant(from, &want, &what), cx.scalar_constant(to, &want, &what));
            Some(Sought::Between(from?, to?))
        }
        document::Sought::Anywhere => Some(Sought::Anywhere),
    };
    let example = if moves == Moves::Sliding { "100 mm" } else { "60 deg" };
    if several && !matches!(sought, Some(Sought::Near(_))) {
        let message = format!("of several equilibria each needs a value near it, and `{name}` has none");
        refuse(cx, message, span, format!("write `{name} near {example}`, with your own value"));
        return None;
    }
    let simulates = cx.names.simulates;
    let speed = match &one.rate {
        Some(rate) if !simulates => {
            let want = Want(moves.dimension(0));
            let place = cx.quietly(|cx| cx.scalar_constant(&rate.value, &want, "").is_some());
            let near = crate::statements::written::written(&rate.value).filter(|_| place);
            let (message, help) = match near {
                Some(value) => (
                    format!("the position of `{name}` is found: `at` is for a speed"),
                    format!("write `{name} near {value}`"),
                ),
                None => (
                    format!("`{name}` is at rest: a speed is for the begin of a motion"),
                    "leave the speed out, or add `simulate 0 s .. 2 s`".to_owned(),
                ),
            };
            refuse(cx, message, rate.value.span, help);
            return None;
        }
        Some(rate) => Some(value(cx, rate, moves, 1, &name)?),
        None => simulates.then(|| Expr::number(0.0)),
    };
    let start = match sought {
        Some(Sought::Near(x) | Sought::Between(x, _)) => x,
        _ => 0.0,
    };
    let target = target?;
    is_once.then(|| Drive {
        name,
        span,
        target,
        positions: Positions::List(vec![Expr::number(start)]),
        written: None,
        speed,
        acceleration: None,
        sense: None,
        free: simulates,
        sought,
        of_time: false,
    })
}

/// Reports what has no meaning beside an equilibrium. Only once everything else is in the mechanism.
pub(crate) fn allowed(cx: &mut Context<'_>) {
    let mech = &cx.builder.mech;
    let Some(sought) = mech.drives.iter().find(|drive| drive.sought.is_some()).map(|d| d.name.clone()) else {
        return;
    };
    let mut wrong: Vec<(String, Span, String)> = Vec::new();
    if let Some(balance) = mech.balances.first() {
        let message =
            format!("at the equilibrium of `{sought}` no effort is needed, and `{}` is one", balance.name);
        wrong.push((
            message,
            balance.span,
            "leave the balance out, or write a `drive` for a position that it holds".to_owned(),
        ));
    }
    for load in &mech.loads {
        let of_time = load.expressions().any(of_time);
        let against = load.is_against_motion();
        if against || of_time {
            let depends = if against { "on the motion" } else { "on time" };
            let message = format!("a load that depends {depends} has no equilibrium");
            wrong.push((message, load.span, "leave the load out".to_owned()));
        }
    }
    for pair in mech.pairs.iter().filter(|pair| pair.friction.is_some()) {
        let message =
            format!("friction in `{}` holds the mechanism anywhere between two positions", pair.name);
        let help = format!(
            "leave the friction out, or find the two positions with `drive {sought} = … moving forward` and `moving back`"
        );
        wrong.push((message, pair.span, help));
    }
    for drive in mech.drives.iter().filter(|drive| drive.sought.is_none() && !drive.free) {
        if drive.speed.is_some() || drive.of_time {
            let message = format!("at an equilibrium `{}` rests, and has no speed", drive.name);
            wrong.push((message, drive.span, "leave its speed out".to_owned()));
        }
    }
    let named = mech.poses.iter().map(|pose| pose.span);
    let expected = mech.expects.iter().filter(|e| matches!(e.at, Some(At::Drives(_)))).map(|e| e.span);
    for span in named.chain(expected) {
        let message = "a position in addition to the sweep is not solved with an equilibrium yet".to_owned();
        wrong.push((message, span, "write the value of the drive into the sweep".to_owned()));
    }
    for (message, span, help) in wrong {
        refuse(cx, message, span, help);
    }
}

/// How many coordinates are sought in equilibrium.
fn count(cx: &Context<'_>) -> usize {
    let statements = cx.doc.statements.iter().map(|s| match &s.node {
        Statement::Equilibrium(all) => all.len(),
        _ => 0,
    });
    statements.sum()
}

fn of_time(expr: &Expr) -> bool {
    let mut found = false;
    expr.queries(&mut |query| found |= matches!(query, Query::Time));
    found
}

/// Whether a pair holds the link.
fn is_held(cx: &Context<'_>, link: LinkId) -> bool {
    cx.builder.mech.pairs.iter().any(|pair| pair.kind.links().contains(&link))
}

/// The two slides that give a point of a free link its coordinates.
fn slides(cx: &mut Context<'_>, one: &Balanced) -> String {
    let (name, link) = (text(&one.target), &one.target.head.node);
    let want = Want(Dimension::LENGTH);
    let near = match &one.sought {
        document::Sought::Near(near) if matches!(near.kind, ExprKind::Vector(..)) => {
            cx.vector_constant(near, &want, "the place of the equilibrium")
        }
        _ => None,
    };
    let near = near.unwrap_or_else(Vec2::zero);
    let [x, y] = [near.x, near.y].map(|value| format_value(value, Dimension::LENGTH));
    format!(
        "give the point two slides. In `ground` add `O (0, 0); line x_axis through O along 0 deg`, and write
  link {link}_x {{ O (0, 0); line y_axis through O along 90 deg }}
  prismatic x: {link}_x.O - ground.x_axis
  prismatic y: {name} - {link}_x.y_axis
  equilibrium x near {x}, y near {y}"
    )
}

fn refuse(cx: &mut Context<'_>, message: String, span: Span, help: String) {
    cx.error(Diagnosis::error(CODE, message).label(span, "does not fit here").help(help));
}

impl Context<'_> {
    /// `stable()`
    pub(crate) fn stable(&mut self, call: Call<'_>) -> Option<Typed> {
        self.arguments(call, 0, 0)?;
        self.coordinates_sought(call)?;
        Some(Typed::new(Expr::Query(Query::Stable), Type::Bool))
    }

    /// `natural_frequency(1)`, `damping_ratio(1)`, `damped_frequency(1)`
    pub(crate) fn vibration(&mut self, call: Call<'_>, function: Function) -> Option<Typed> {
        let (part, dimension) = match function {
            Function::DampingRatio => (ModePart::Ratio, Dimension::NUMBER),
            Function::DampedFrequency => (ModePart::Damped, Dimension::ANGULAR_VELOCITY),
            _ => (ModePart::Natural, Dimension::ANGULAR_VELOCITY),
        };
        let args = self.arguments(call, 1, 1)?;
        let coordinates = self.coordinates_sought(call)?;
        let which = match &args[0].kind {
            ExprKind::Number(n) if n.unit.is_none() => (1..=coordinates).find(|k| *k as f64 == n.value),
            _ => None,
        };
        let Some(which) = which else {
            let most = match coordinates {
                1 => "the number 1, as there is one coordinate in equilibrium,".to_owned(),
                _ => format!("a whole number up to {coordinates}, the number of coordinates in equilibrium,"),
            };
            self.wrong_argument(call, &most, args[0].span);
            return None;
        };
        self.builder.mech.vibrates = true;
        Some(Typed::new(Expr::Query(Query::Vibration(which - 1, part)), Type::number(dimension)))
    }

    /// How many coordinates are sought; reports that there is none.
    fn coordinates_sought(&mut self, call: Call<'_>) -> Option<usize> {
        let count = count(self);
        if count > 0 {
            return Some(count);
        }
        let drive = self.doc.statements.iter().find_map(|s| match &s.node {
            Statement::Drive(drive) => Some(text(&drive.target)),
            _ => None,
        });
        let drive = drive.unwrap_or_else(|| "bar".to_owned());
        let help = format!("write `equilibrium {drive} near …` in place of its `drive`");
        refuse(self, "no equilibrium is sought".to_owned(), call.span, help);
        None
    }
}
