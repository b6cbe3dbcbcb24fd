//! Sizes of wheels: radius, diameter, teeth with their module. What the file leaves open is assumed, and noted as a scale
//! that no answer may depend on.

use crate::expr::{
    context::{Context, not_constant},
    positive::{Want, positive_value},
};
use crate::links::link::place as place_text;
use crate::values::{
    fold,
    format_value::format_value,
    order::{circular, way_round},
    store::DeclaredWheel,
};
use assur_model::model::{LinkId, OpenSize, Wheel};
use assur_syntax::document::{
    Body, End, Expr, ExprKind, JointKind, Member, Name, Statement, WheelMember, WheelSize,
};
use assur_text::diagnostic::Diagnosis;
use assur_text::source::Span;
use assur_text::units::Dimension;
use miette::LabeledSpan;

/// What is assumed of a size that is left open, and what instead to see what depends on it.
const ASSUMED: [f64; 2] = [1.0, 1.75];
/// A number of teeth may miss a whole number by this.
const WHOLE: f64 = 1e-6;

/// Reads all wheels, and enters them into the mechanism.
pub(crate) fn wheels(cx: &mut Context<'_>) {
    declare(cx);
    families(cx);
    let names: Vec<String> = cx.values.sizes.declared.keys().cloned().collect();
    for name in names {
        let Some(&declared) = cx.values.sizes.declared.get(&name) else { continue };
        let radius = radius(cx, &name);
        let teeth = teeth(cx, declared.member);
        let centre = centre(cx, declared);
        if let (Some(radius), Some(teeth), Some(centre)) = (radius, teeth, centre) {
            let (span, link) = (declared.member.name.span, declared.link);
            let open = cx.values.sizes.open.contains(&name);
            cx.builder.mech.wheels.push(Wheel { name, span, link, centre, radius, open, teeth });
        }
    }
}

fn declare(cx: &mut Context<'_>) {
    let doc = cx.doc;
    let mut ground = false;
    for statement in &doc.statements {
        let (link, body, shaft): (_, &Body, _) = match &statement.node {
            Statement::Ground(g) if !std::mem::replace(&mut ground, true) => {
                (Some(LinkId::GROUND), &g.body, false)
            }
            Statement::Link(l) => (cx.own_link(&l.name), &l.body, false),
            Statement::Shaft(s) => (cx.own_link(&s.name), &s.body, true),
            _ => continue,
        };
        let Some(link) = link else { continue };
        for member in body {
            if let Member::Wheel(member) = &member.node
                && cx.is_own(&member.name)
            {
                let family = cx.values.sizes.declared.len();
                let declared = DeclaredWheel { member, link, shaft, family };
                cx.values.sizes.declared.insert(member.name.node.clone(), declared);
                // a wheel is named in place of its link
                cx.names.links.entry(member.name.node.clone()).or_insert(link);
            }
        }
    }
}

/// Wheels that mesh, or share a chain, have one module.
fn families(cx: &mut Context<'_>) {
    let doc = cx.doc;
    for statement in &doc.statements {
        let Statement::Joint(joint) = &statement.node else { continue };
        if !matches!(joint.kind.node, JointKind::Mesh | JointKind::Chain) {
            continue;
        }
        let ends: Vec<usize> = joint
            .ends
            .iter()
            .filter_map(|end| match end {
                End::At(path) if path.tail.is_none() => cx.values.sizes.declared.get(&path.head.node),
                _ => None,
            })
            .map(|d| d.family)
            .collect();
        let Some(&first) = ends.first() else { continue };
        for declared in cx.values.sizes.declared.values_mut() {
            if ends.contains(&declared.family) {
                declared.family = first;
            }
        }
    }
}

/// The axis in the frame of the wheel's link; of a shaft only where it is placed.
fn centre(cx: &mut Context<'_>, declared: DeclaredWheel<'_>) -> Option<Option<assur_math::math::Vec2>> {
    let DeclaredWheel { member, link, shaft, .. } = declared;
    if shaft {
        let pair = cx.find_pair(&cx.builder.mech.link(link).name)?;
        let placed = cx.builder.mech.pair(pair).bearing == Some(assur_model::model::Bearing::Placed);
        return Some(placed.then(assur_math::math::Vec2::zero));
    }
    match &member.at {
        Some(at) => cx.point(link, at).map(Some),
        None if link == LinkId::GROUND => Some(None),
        None => {
            let name = &member.name.node;
            let points = cx.builder.mech.link(link).points.first();
            let (point, at) = points.map_or(("O".to_owned(), String::new()), |p| {
                (p.name.clone(), format!(", at {} in the link", place_text(p.at)))
            });
            cx.error(
                Diagnosis::error(
                    "mech::geometry::incomplete",
                    format!("wheel `{name}` has no position on `{}`", cx.builder.mech.link(link).name),
                )
                .label(member.name.span, "the point is missing")
                .help(format!("name the point of its axis: `wheel {name} … at {point}`{at}")),
            );
            None
        }
    }
}

/// The number of teeth, where it is known. `None` where it has an error.
fn teeth(cx: &mut Context<'_>, member: &WheelMember) -> Option<Option<f64>> {
    let name = &member.name.node;
    match (&member.size, &member.module) {
        (Some(WheelSize::Teeth(teeth)), _) => {
            let number =
                size(cx, teeth, Dimension::NUMBER, &format!("the number of teeth of wheel `{name}`"))?;
            whole(cx, number, name, teeth).map(Some)
        }
        (Some(WheelSize::Radius(_) | WheelSize::Diameter(_)), Some(written)) => {
            let radius = radius(cx, name)?;
            let module = module(cx, member)?;
            let teeth = 2.0 * radius / module;
            if (teeth - teeth.round()).abs() <= WHOLE && teeth >= 1.0 {
                return Some(Some(teeth.round()));
            }
            let length = |x| format_value(x, Dimension::LENGTH);
            cx.error(
                Diagnosis::error(
                    "mech::train::sizes",
                    format!(
                        "wheel `{name}` would have {} teeth: its diameter is {}, its module {}",
                        crate::values::format_value::digits(teeth),
                        length(2.0 * radius),
                        length(module)
                    ),
                )
                .labels(vec![label("no whole number of teeth", written.span)])
                .help(format!(
                    "write `teeth {} module {}`, or another module: the diameter is a whole \
                     number of modules",
                    teeth.round().max(1.0),
                    length(module)
                )),
            );
            None
        }
        _ => Some(None),
    }
}

/// Teeth are a whole number.
fn whole(cx: &mut Context<'_>, number: f64, wheel: &str, written: &Expr) -> Option<f64> {
    if (number - number.round()).abs() <= WHOLE && number >= 1.0 {
        return Some(number.round());
    }
    if !cx.problems.reported.insert(("teeth", wheel.to_owned())) {
        return None;
    }
    let (below, above) = (number.floor().max(1.0), number.ceil().max(1.0));
    let line = |n: f64| match &written.kind {
        ExprKind::Number(_) => format!("`teeth {n}`"),
        ExprKind::Name(name) if cx.given_as_written(name).is_some() => format!("`given {name} = {n}`"),
        _ => format!("{n} teeth"),
    };
    let choices = if below == above { line(above) } else { format!("{} or {}", line(below), line(above)) };
    cx.error(
        Diagnosis::error(
            "mech::train::sizes",
            format!("wheel `{wheel}` has {} teeth", crate::values::format_value::digits(number)),
        )
        .labels(vec![label("not a whole number", written.span)])
        .help(format!("write {choices}: the number of teeth is a whole number")),
    );
    None
}

pub(crate) fn label(text: impl Into<String>, span: Span) -> LabeledSpan {
    LabeledSpan::new_with_span(Some(text.into()), span)
}

fn module(cx: &mut Context<'_>, member: &WheelMember) -> Option<f64> {
    let written = member.module.as_ref()?;
    size(cx, written, Dimension::LENGTH, &format!("the module of wheel `{}`", member.name.node))
}

/// The radius of a wheel, read now if it has not been yet. `None` where it has an error.
fn radius(cx: &mut Context<'_>, name: &str) -> Option<f64> {
    if let Some(known) = cx.values.sizes.radii.get(name).copied() {
        if cx.values.sizes.open.contains(name) {
            depends_on_open(cx);
        }
        return known;
    }
    let declared = *cx.values.sizes.declared.get(name)?;
    if cx.values.sizes.reading.iter().any(|n| n == name) {
        cycle(cx, name);
        return None;
    }
    cx.values.sizes.reading.push(name.to_owned());
    let member = declared.member;
    let found = match &member.size {
        Some(WheelSize::Radius(r)) => {
            size(cx, r, Dimension::LENGTH, &format!("the radius of wheel `{name}`"))
        }
        Some(WheelSize::Diameter(d)) => {
            let what = format!("the diameter of wheel `{name}`");
            size(cx, d, Dimension::LENGTH, &what).map(|d| d / 2.0)
        }
        Some(WheelSize::Teeth(_)) => {
            teeth(cx, member).and_then(|z| Some(z? * family_module(cx, declared)? / 2.0))
        }
        None => match &member.module {
            Some(_) => {
                module(cx, member);
                Some(assumed(cx, member, false))
            }
            None => Some(assumed(cx, member, false)),
        },
    };
    cx.values.sizes.reading.pop();
    // a cycle is reported once, and all in it have no size
    let found = if cx.values.sizes.radii.get(name) == Some(&None) { None } else { found };
    cx.values.sizes.radii.insert(name.to_owned(), found);
    found
}

/// The module of the wheels that mesh with each other: one of them says it, or nobody.
fn family_module(cx: &mut Context<'_>, declared: DeclaredWheel<'_>) -> Option<f64> {
    if declared.member.module.is_some() {
        return module(cx, declared.member);
    }
    let family: Vec<&WheelMember> = {
        let all = cx.values.sizes.declared.values();
        all.filter(|d| d.family == declared.family).map(|d| d.member).collect()
    };
    match family.iter().find(|m| m.module.is_some()) {
        Some(member) => module(cx, member),
        None => {
            let by_teeth = |m: &&&WheelMember| matches!(m.size, Some(WheelSize::Teeth(_)));
            let first = family.iter().find(by_teeth).copied().unwrap_or(declared.member);
            Some(assumed(cx, first, true))
        }
    }
}

/// The wheels that are being read depend on a size that is left open.
fn depends_on_open(cx: &mut Context<'_>) {
    let sizes = &mut cx.values.sizes;
    sizes.open.extend(sizes.reading.iter().cloned());
}

/// The assumed size, if the file gives none.
fn assumed(cx: &mut Context<'_>, member: &WheelMember, teeth: bool) -> f64 {
    let name = &member.name.node;
    depends_on_open(cx);
    if !cx.builder.mech.open_sizes.iter().any(|s| s.wheel == *name) {
        cx.builder.mech.open_sizes.push(OpenSize { wheel: name.clone(), span: member.name.span, teeth });
    }
    ASSUMED[usize::from(cx.values.outside.other_size == Some(name.as_str()))]
}

fn cycle(cx: &mut Context<'_>, again: &str) {
    let from = cx.values.sizes.reading.iter().position(|n| n == again).unwrap_or(0);
    let names: Vec<String> = cx.values.sizes.reading[from..].to_vec();
    let place =
        |name: &String| cx.values.sizes.declared.get(name).map_or_else(Span::default, |d| d.member.name.span);
    let others = names.iter().skip(1).map(|n| label("depends on the next one", place(n))).collect();
    let span = names.first().map_or_else(Span::default, place);
    let chain = way_round(&names);
    for name in &names {
        cx.values.sizes.radii.insert(name.clone(), None);
    }
    cx.error(circular(again, &chain, span, others));
}

/// A size: made of numbers, `given`, `let` and radii of other wheels.
fn size(cx: &mut Context<'_>, expr: &Expr, dimension: Dimension, what: &str) -> Option<f64> {
    if let Some((span, result)) = cx.values.definitions.first_result_beside(&cx.names, expr, "radius") {
        cx.error(not_constant(what, &result, span));
        return None;
    }
    // the module of a wheel is that of all that mesh with it
    let place = format!("{} {}", expr.span.start, expr.span.end);
    if cx.problems.reported.contains(&("size", place.clone())) {
        return None;
    }
    let found = read_size(cx, expr, dimension, what);
    if found.is_none() {
        cx.problems.reported.insert(("size", place));
    }
    found
}

fn read_size(cx: &mut Context<'_>, expr: &Expr, dimension: Dimension, what: &str) -> Option<f64> {
    let typed = cx.read(expr).filter(|t| !t.pending)?;
    let value = fold::scalar(&cx.fit(typed, Want(dimension).0, what, expr)?.expr)?;
    positive_value(cx, value, expr, dimension, what)
}

impl Context<'_> {
    /// The radius of the wheel of that name; `None` where there is none, or where it has an error.
    pub(crate) fn wheel_radius(&mut self, name: &Name) -> Option<f64> {
        radius(self, &name.node)
    }
}
