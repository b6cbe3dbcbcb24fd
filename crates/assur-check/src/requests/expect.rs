//! `expect`: the answer key.

use crate::expr::{context::Context, positive::Want, read::comparison_of};
use crate::motion::simulation::{no_simulate, of_given_positions, without_meaning};
use crate::names::suggestion::suggestion;
use crate::requests::tolerance;
use crate::statements::{
    walk,
    written::{text, written},
};
use crate::values::{
    format_value::format_value,
    typed::{Dim, Type, Typed, phrase},
};
use assur_model::model::{At, Display, Expect, Occasion, Relation, Tolerance};
use assur_syntax::document::{self, ExpectAt, Expr, ExprKind, Name, Setting, Statement};
use assur_text::diagnostic::{Diagnosis, Help};
use assur_text::source::{Span, Spanned};
use assur_text::units::{Dimension, Kind};

/// Enters all expectations into the mechanism.
pub(crate) fn expects(cx: &mut Context<'_>) {
    for statement in &cx.doc.statements {
        if let Statement::Expect(expect) = &statement.node
            && let Some(expect) = one(cx, expect, statement.span)
        {
            cx.builder.mech.expects.push(expect);
        }
    }
}

/// What is compared, before its pose is looked at.
struct Claim {
    expr: assur_model::model::Expr,
    relation: Relation,
    tolerance: Tolerance,
    ty: Type,
    pending: bool,
}

fn one(cx: &mut Context<'_>, expect: &document::Expect, span: Span) -> Option<Expect> {
    let claim = if expect.values.is_empty() { condition(cx, expect) } else { equality(cx, expect) };
    let at = match &expect.at {
        Some(at) => place(cx, expect, at, span).map(Some),
        None => Some(None),
    };
    let (claim, at) = (claim?, at?);
    if claim.pending {
        return None;
    }
    let poseless = cx.values.definitions.is_poseless(&claim.expr)
        && match &claim.relation {
            Relation::Equal(values) => values.iter().all(|v| cx.values.definitions.is_poseless(v)),
            Relation::Compare(_, bound) => cx.values.definitions.is_poseless(bound),
            Relation::Condition => true,
        };
    if poseless {
        one_value(cx, expect, at.as_ref())?;
    } else {
        pose_is_clear(cx, expect, at.as_ref())?;
    }
    let d = claim.ty.dimension();
    let angle = matches!(claim.ty, Type::Number(_)) && d == Dimension::ANGLE;
    let display = match claim.ty {
        Type::Bool => Display { factor: 1.0, ..Display::default() },
        ty => cx.expect_display(&expect.text, ty),
    };
    let (text, Claim { expr, relation, tolerance, .. }) = (expect.text.clone(), claim);
    Some(Expect { text, span, expr, relation, tolerance, at, angle, display, poseless })
}

/// `expect locked()`, `expect a > b`
fn condition(cx: &mut Context<'_>, expect: &document::Expect) -> Option<Claim> {
    if let Some(within) = &expect.within {
        cx.error(
            Diagnosis::error("mech::expect::tolerance_of_truth", "a condition has no tolerance")
                .primary(within.span, "a condition is true or false")
                .help("leave out `within …`"),
        );
    }
    let t = cx.read(&expect.what)?;
    if t.ty != Type::Bool && !t.pending {
        let (text, is) = (expect.text.clone(), t.ty.phrase());
        cx.error(
            Diagnosis::error(
                "mech::expect::no_value",
                format!("`{text}` is {is}, and no expected value is given"),
            )
            .primary(expect.what.span, "not a condition")
            .help(format!("write `expect {text} = …`, or compare it: `expect {text} > …`")),
        );
        return None;
    }
    if let ExprKind::Compare(left, rest) = &expect.what.kind
        && let [(op, right)] = &rest[..]
        && !t.pending
    {
        // Read once more, in two parts; it is without mistakes.
        let (a, b) = (cx.read(left)?, cx.read(right)?);
        not_itself(cx, left, &a, right)?;
        let (left, right) = (a, b);
        let relation = Relation::Compare(comparison_of(op.node), right.expr);
        let ty = unified(left.ty, right.ty);
        return Some(Claim { expr: left.expr, relation, tolerance: Tolerance::None, ty, pending: false });
    }
    let (pending, ty) = (t.pending, Type::Bool);
    Some(Claim { expr: t.expr, relation: Relation::Condition, tolerance: Tolerance::None, ty, pending })
}

/// The type of both, the more definite one of an angle and a number that may be one.
fn unified(a: Type, b: Type) -> Type {
    match (a, b) {
        (Type::Number(x), Type::Number(y)) => x.unify(y).map_or(a, Type::Number),
        (Type::Vector(x), Type::Vector(y)) => x.unify(y).map_or(a, Type::Vector),
        _ => a,
    }
}

/// `expect Mb = 26 N*m within 1 %`
fn equality(cx: &mut Context<'_>, expect: &document::Expect) -> Option<Claim> {
    let what = cx.read(&expect.what);
    let values = expect.values.iter().map(|v| (cx.read(v), v)).collect::<Vec<_>>();
    let what = what?;
    if what.ty == Type::Bool {
        let (text, span) = (expect.text.clone(), expect.what.span);
        cx.error(
            Diagnosis::error(
                "mech::expect::truth",
                format!("`{text}` is a condition; it is either true or false"),
            )
            .primary(span, "a condition")
            .help("remove the right-hand side; to expect the opposite, write `not …`"),
        );
        return None;
    }
    let open = what.pending && what.ty == Type::Number(Dim::Any);
    let mut fitting = Vec::new();
    for (value, expr) in values {
        let fits = value.and_then(|v| {
            if open { Some(v) } else { fit_value(cx, v, &what, (&expect.text, &expect.what), expr) }
        });
        fitting.push(fits);
    }
    let values = fitting.into_iter().collect::<Option<Vec<_>>>()?;
    for value in &expect.values {
        not_itself(cx, &expect.what, &what, value)?;
    }
    let pending = what.pending || values.iter().any(|v| v.pending);
    let ty = values.iter().fold(what.ty, |ty, v| unified(ty, v.ty));
    let tolerance = if open { Tolerance::None } else { tolerance::tolerance(cx, expect, &values, ty)? };
    let values = values.into_iter().map(|v| v.expr).collect();
    Some(Claim { expr: what.expr, relation: Relation::Equal(values), tolerance, ty, pending })
}

/// Reports what is compared with itself: any value would pass.
fn not_itself(cx: &mut Context<'_>, what: &Expr, t: &Typed, value: &Expr) -> Option<()> {
    if t.pending || !walk::same(what, value) {
        return Some(());
    }
    cx.error(
        Diagnosis::error("mech::expect::any_value", "a value is compared with itself")
            .primary(what.span.to(value.span), "both sides are equal")
            .help("write the value that is expected, as in `expect Mb = 26 N*m`"),
    );
    None
}

fn fit_value(
    cx: &mut Context<'_>,
    value: Typed,
    what: &Typed,
    text: (&str, &Expr),
    expr: &Expr,
) -> Option<Typed> {
    let d = what.ty.dimension();
    match what.ty {
        Type::Vector(_) => match component_or_magnitude(&value, text, expr) {
            Some(help) => {
                cx.shape("the expected value", "a vector", value.ty, expr.span, Some(help));
                None
            }
            None => cx.fit_vector(value, d, "the expected value", expr),
        },
        Type::Number(Dim::Any) if what.value().is_some() => Some(value),
        _ => cx.fit(value, d, "the expected value", expr),
    }
}

/// What may be meant where a number is expected of a vector.
fn component_or_magnitude(value: &Typed, (text, what): (&str, &Expr), expr: &Expr) -> Option<String> {
    let number = matches!(value.ty, Type::Number(dim) if dim != Dim::Any && !value.pending);
    let value = written(expr).filter(|_| number)?;
    let simple = matches!(what.kind, ExprKind::Name(_) | ExprKind::Member(..) | ExprKind::Call { .. });
    let part = if simple { format!("{text}.x") } else { format!("({text}).x") };
    Some(format!("write `expect mag({text}) = {value}` or `expect {part} = {value}`"))
}

/// `at pose 4'`, `at crank = 90 deg`
fn place(cx: &mut Context<'_>, expect: &document::Expect, at: &ExpectAt, span: Span) -> Option<At> {
    match at {
        ExpectAt::Pose(name) if cx.names.simulates => {
            let simulate = crate::motion::simulation::statement(cx)?.1;
            let what = format!("the pose `{}`", name.node);
            let help = "ask for an instant: `at time = 0.5 s`".to_owned();
            cx.error(of_given_positions(&what, help, name.span, simulate));
            None
        }
        ExpectAt::Pose(name) => {
            pose(cx, name)?;
            Some(At::Pose(name.node.clone(), name.span))
        }
        ExpectAt::Event(name, which) => occasion(cx, name, which.as_ref()).map(At::Occasion),
        ExpectAt::Settings(settings) if cx.names.simulates => instant(cx, settings).map(At::Time),
        ExpectAt::Settings(settings) => {
            let what = format!("the pose for `{}`", expect.text);
            crate::motion::pose::settings(cx, settings, &what, span).map(At::Drives)
        }
    }
}

/// `at event top 2`, `at event end`
fn occasion(cx: &mut Context<'_>, name: &Name, which: Option<&Spanned<usize>>) -> Option<Occasion> {
    match (name.node.as_str(), which) {
        ("begin" | "end", None) if !cx.names.simulates && cx.builder.mech.events.is_empty() => {
            no_simulate(cx, "event", name.span);
            None
        }
        ("begin", None) if !cx.names.events.contains_key("begin") => Some(Occasion::Begin),
        ("end", None) if !cx.names.events.contains_key("end") => Some(Occasion::End),
        _ => {
            let event = cx.event(name)?;
            Some(Occasion::Event(event, which.map_or(1, |which| which.node.max(1))))
        }
    }
}

/// `at time = 0.5 s` of a motion under loads.
fn instant(cx: &mut Context<'_>, settings: &[Setting]) -> Option<f64> {
    let (simulate, run) = (crate::motion::simulation::statement(cx)?.1, cx.builder.mech.simulation.clone());
    let time = settings.iter().find(|s| text(&s.target) == "time");
    if let Some(other) = settings.iter().find(|s| text(&s.target) != "time") {
        let what = format!("a position of `{}`", text(&other.target));
        let help = "ask for an instant: `at time = 0.5 s`".to_owned();
        cx.error(of_given_positions(&what, help, other.target.span(), simulate));
        return None;
    }
    let time = &time?.value;
    if let Some(sense) = &time.sense {
        let (what, help) = ("a sense of rotation of an instant".to_owned(), "leave it out".to_owned());
        cx.error(without_meaning(&what, &help, sense.span));
        return None;
    }
    let value = cx.scalar_constant(&time.value, &Want(Dimension::TIME), "the instant")?;
    let run = run?;
    if value < run.from || value > run.to {
        let [time_text, from, to] = [value, run.from, run.to].map(|x| format_value(x, Dimension::TIME));
        let span = time.value.span;
        cx.error(
            Diagnosis::error(
                "mech::simulate::outside",
                format!("the motion is followed from {from} to {to}, and {time_text} is not in this time"),
            )
            .primary(span, "outside")
            .label(simulate, "followed here")
            .help("ask for an instant of the motion, or let `simulate` include it"),
        );
        return None;
    }
    Some(value)
}

/// Reports a pose that does not exist.
fn pose(cx: &mut Context<'_>, name: &Name) -> Option<()> {
    cx.names.note_pose(name);
    let count = sweep(cx).map_or(Some(1), |(count, ..)| count);
    let number = name.node.parse::<usize>().ok();
    let in_sweep = number.is_some_and(|n| n >= 1 && count.is_none_or(|count| n <= count));
    if in_sweep || cx.names.poses.contains_key(&name.node) {
        return Some(());
    }
    if cx.names.bad.contains(&name.node) {
        return None;
    }
    if count == Some(1) && may_sweep(cx) {
        return Some(()); // looked for once more among the poses that are solved
    }
    let all = cx.names.poses.keys().map(String::as_str).collect::<Vec<_>>();
    let near = suggestion(&name.node, name.span, &all, "named poses");
    let help = match (number, count) {
        (Some(_), Some(count)) if count > 1 => {
            Some(format!("the poses of the sweep are 1 to {count}").into())
        }
        (Some(_), Some(_)) => Some("the file has one pose: leave out `at pose …`".into()),
        _ => near,
    };
    cx.error(
        Diagnosis::error("mech::expect::unknown_pose", format!("there is no pose `{}`", name.node))
            .primary(name.span, "no such pose")
            .help_if(help),
    );
    None
}

/// Whether a drive that is missing, or that has an error, may have been a sweep.
fn may_sweep(cx: &Context<'_>) -> bool {
    let declared = cx.drive_statements().len();
    let bad = cx.doc.statements.iter().any(|s| matches!(s.node, Statement::Bad(_)));
    declared == 0 || cx.builder.mech.drives.len() < declared || bad
}

/// The first drive that goes through several positions: how many (where that is known), its name and place.
fn sweep(cx: &Context<'_>) -> Option<(Option<usize>, String, Span)> {
    cx.builder.mech.drives.iter().find_map(|d| {
        let count = crate::motion::drive::count(&d.positions, crate::motion::drive::moves(cx, d.target));
        (count != Some(1)).then(|| (count, d.name.clone(), d.span))
    })
}

/// Reports a list of values for what has one.
fn one_value(cx: &mut Context<'_>, expect: &document::Expect, at: Option<&At>) -> Option<()> {
    let [first, .., last] = &expect.values[..] else { return Some(()) };
    let (span, count) = (first.span.to(last.span), expect.values.len());
    if at.is_some() {
        cx.error(list_at_pose(span, count));
    } else {
        cx.error(
            Diagnosis::error(
                "mech::expect::count",
                format!("`{}` has one value for the whole motion, and {count} are expected", expect.text),
            )
            .primary(span, format!("{count} values"))
            .help("keep one of the values"),
        );
    }
    None
}

/// Reports an expectation that does not say for which pose it is.
fn pose_is_clear(cx: &mut Context<'_>, expect: &document::Expect, at: Option<&At>) -> Option<()> {
    let values = expect.values.len();
    let first = expect.values.first().map_or(expect.what.span, |v| v.span);
    let span = expect.values.last().map_or(first, |v| first.to(v.span));
    if at.is_some() {
        if values > 1 {
            cx.error(list_at_pose(span, values));
            return None;
        }
        return Some(());
    }
    if let Some(run) = cx.builder.mech.simulation.as_ref().filter(|run| run.instants() != values) {
        let (text, count, simulate) = (expect.text.clone(), run.instants(), run.span);
        let values = if values <= 1 { "one is".to_owned() } else { format!("{values} are") };
        cx.error(
            Diagnosis::error(
                "mech::simulate::which_instant",
                format!("`{text}` has a value at each of {count} instants, and {values} given here"),
            )
            .primary(span, "for which instant?")
            .label(simulate, "the instants")
            .help(format!("say for which instant it is, as in `at time = 0.5 s`, or give {count} values")),
        );
        return None;
    }
    // how many positions of events there are is not known yet
    let eventful = !cx.builder.mech.events.is_empty();
    let Some((count, drive, place)) =
        sweep(cx).map(|found| (found.0.filter(|_| !eventful), found.1, found.2))
    else {
        if values > 1 && !may_sweep(cx) {
            let help = "keep one value: a file without a sweep has one pose".to_owned();
            cx.error(wrong_count(values, "one pose", span, None, help));
            return None;
        }
        return Some(());
    };
    match count {
        _ if values <= 1 => {
            let number = count.map_or_else(|| "several".to_owned(), |n| n.to_string());
            let (text, count) = (expect.text.clone(), format!("{number} values, one per pose"));
            cx.error(
                Diagnosis::error(
                    "mech::expect::which_pose",
                    format!("`{text}` has {count}, but only one is expected"),
                )
                .primary(expect.what.span, "the pose is missing")
                .label(place, "this goes through several poses")
                .help(format!(
                    "add `at pose 1` or `at {drive} = …`, or list one value per pose, with commas"
                )),
            );
            None
        }
        Some(count) if count != values => {
            let (poses, sweep) = (format!("{count} poses"), Some(place));
            let help = crate::requests::expected_list::help(cx, count, values, place);
            cx.error(wrong_count(values, &poses, span, sweep, help));
            None
        }
        _ => Some(()),
    }
}

/// What a type is called in a message about tolerances.
pub(crate) fn words(ty: Type) -> String {
    match ty.dimension() {
        d if d.is_dimensionless() && d.kind == Kind::Free => "a plain number".into(),
        d => phrase(d),
    }
}

/// A list for one pose.
fn list_at_pose(span: Span, count: usize) -> Diagnosis {
    Diagnosis::error(
        "mech::expect::list_at_pose",
        "a list gives one value per pose and cannot be combined with `at …`",
    )
    .primary(span, format!("{count} values"))
    .help("keep one value, or leave out `at …`")
}

/// A list that is longer or shorter than the sweep.
fn wrong_count(
    values: usize,
    poses: &str,
    span: Span,
    sweep: Option<Span>,
    help: impl Into<Help>,
) -> Diagnosis {
    Diagnosis::error("mech::expect::count", format!("{values} values are expected, but the file has {poses}"))
        .primary(span, format!("{values} values"))
        .label(sweep, poses)
        .help(help)
}
