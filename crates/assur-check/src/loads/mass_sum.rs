//! Several masses on one link: m = Σ m_i, r_S = Σ m_i r_i / m, J_S = Σ (J_i + m_i |r_i − r_S|²).

use super::mass::{Stated, StatedInertia, amount_of_mass, own_inertia, steiner, written};
use super::mass_shape;
use crate::expr::context::Context;
use crate::expr::positive::not_negative;
use crate::expr::property::given_twice;
use crate::statements::walk::same;
use crate::values::format_value::{format_value, format_value_like};
use assur_math::math::Vec2;
use assur_model::model::{LinkId, MassPart, MassProperties};
use assur_text::diagnostic::{Diagnosis, Fix};
use assur_text::source::{Edit, Span};
use assur_text::units::Dimension;

/// The whole mass of a link and its parts. What has no place of its own, as a slider of a train, needs no points.
pub(super) fn several(
    cx: &mut Context<'_>,
    link: LinkId,
    stated: &[Stated<'_>],
    inertia: Option<StatedInertia<'_>>,
    placed: bool,
) -> Option<(MassProperties, Vec<MassPart>)> {
    twice(cx, link, stated);
    let parts: Vec<_> = stated.iter().map(|one| part(cx, link, one, placed)).collect();
    let parts = parts.into_iter().collect::<Option<Vec<MassPart>>>()?;
    let sum = MassProperties::of_parts(&parts);
    let (mass, centre) = (whole_mass(cx, link, stated, sum.mass)?, sum.centre);
    let shape = |one: &Stated<'_>| one.at.shape.as_ref().map(|shape| shape.kind.span);
    let about_centre = match (inertia, stated.iter().find_map(shape)) {
        (None, _) => whole_inertia(cx, link, stated, sum.inertia)?,
        (Some(whole), Some(of_shape)) => {
            of_a_shape(cx, link, whole.span, of_shape);
            return None;
        }
        (Some(whole), None) if placed && whole.about.is_none() => {
            of_which(cx, link, stated, &parts, whole);
            return None;
        }
        (Some(whole), None) => {
            if let Some(own) = stated.iter().find_map(own_inertia) {
                let name = cx.builder.mech.link(link).name.clone();
                cx.error(given_twice(&format!("the inertia of `{name}`"), whole.span, own.span));
                return None;
            }
            let at = stated.iter().zip(&parts).map(|(s, p)| (s.span, p.own.mass, p.own.centre));
            steiner(cx, link, whole, &at.collect::<Vec<_>>(), (mass, centre))?
        }
    };
    Some((MassProperties { mass, centre, inertia: about_centre }, parts))
}

/// One of the masses.
fn part(cx: &mut Context<'_>, link: LinkId, stated: &Stated<'_>, placed: bool) -> Option<MassPart> {
    if let Some(shape) = stated.at.shape.as_ref().filter(|_| placed) {
        if let Some(own) = own_inertia(stated) {
            of_a_shape(cx, link, own.span, shape.kind.span);
        }
        return mass_shape::part(cx, link, stated, shape);
    }
    let mass = amount_of_mass(cx, link, stated);
    let what = format!("the inertia of a mass of `{}`", cx.builder.mech.link(link).name);
    let inertia = match &stated.at.inertia {
        Some(value) => not_negative(cx, value, Dimension::INERTIA, &what),
        None => Some(0.0),
    };
    let centre = match &stated.at.at {
        Some(at) => cx.point(link, at),
        None if placed => {
            without_point(cx, link, stated, mass?);
            None
        }
        None => Some(Vec2::zero()),
    };
    let own = MassProperties { mass: mass?, centre: centre?, inertia: inertia? };
    Some(MassPart { own, shape: None, plane: 0.0 })
}

/// Reports an inertia beside a shape, from which it follows.
fn of_a_shape(cx: &mut Context<'_>, link: LinkId, inertia: Span, shape: Span) {
    let name = cx.builder.mech.link(link).name.clone();
    cx.error(
        Diagnosis::error(
            "mech::geometry::stated_twice",
            format!("the inertia of `{name}` is given twice: a mass with a shape has its own"),
        )
        .primary(inertia, "given again here")
        .label(shape, "follows from the shape")
        .help("leave out the inertia, or give the mass its point: `mass 3 kg at S inertia 0.16 kg*m^2`"),
    );
}

/// The sum of the masses, which holes must leave greater than zero.
fn whole_mass(cx: &mut Context<'_>, link: LinkId, stated: &[Stated<'_>], sum: f64) -> Option<f64> {
    let what = format!("the mass of `{}`", cx.builder.mech.link(link).name);
    left(cx, stated, (sum > 0.0).then_some(sum), &what, &format_value(sum, Dimension::MASS))
}

/// The sum of the moments of inertia, which holes must not make negative.
fn whole_inertia(cx: &mut Context<'_>, link: LinkId, stated: &[Stated<'_>], sum: f64) -> Option<f64> {
    let what = format!("the inertia of `{}` about its mass centre", cx.builder.mech.link(link).name);
    left(cx, stated, (sum >= 0.0).then_some(sum), &what, &format_value(sum, Dimension::INERTIA))
}

/// Reports holes that leave nothing.
fn left(
    cx: &mut Context<'_>,
    stated: &[Stated<'_>],
    sum: Option<f64>,
    what: &str,
    found: &str,
) -> Option<f64> {
    if sum.is_none() {
        let masses = stated.iter().map(|one| one.span);
        cx.error(
            Diagnosis::error(
                "mech::geometry::mass_shape",
                format!("{what} is {found}: its holes leave nothing"),
            )
            .each(masses, "counts")
            .help("a hole has the density of the body around it, with a minus, and lies within it"),
        );
    }
    sum
}

/// Reports one of several masses without its point.
fn without_point(cx: &mut Context<'_>, link: LinkId, stated: &Stated<'_>, mass: f64) {
    let member = written(cx, stated, mass);
    let point = cx.point_meant(link).unwrap_or("S").to_owned();
    let own = super::mass::written_inertia(cx, stated);
    let link = cx.builder.mech.link(link).name.clone();
    cx.error(
        Diagnosis::error(
            "mech::geometry::mass_without_place",
            format!("`{link}` has several masses, and this one does not say where it is"),
        )
        .primary(stated.span, "the point is missing")
        .help(format!("give each mass its point: `{member} at {point}{own}`"))
        .fixes(Fix::quoted(&format!("write `{member} at {point}{own}`"), stated.span)),
    );
}

/// Reports an inertia that belongs to none of several masses.
fn of_which(
    cx: &mut Context<'_>,
    link: LinkId,
    stated: &[Stated<'_>],
    parts: &[MassPart],
    whole: StatedInertia<'_>,
) {
    let name = cx.builder.mech.link(link).name.clone();
    let what = format!("the inertia of `{name}`");
    let Some(value) = not_negative(cx, whole.value, Dimension::INERTIA, &what) else { return };
    let (Some(first), Some(part)) = (stated.first(), parts.first()) else { return };
    let Some(point) = first.at.at.as_ref().map(|at| at.node.clone()) else { return };
    let inertia = format_value_like(&cx.names, value, Dimension::INERTIA, whole.value);
    // the first point whose moment of inertia of the masses alone is not greater
    let enough = |at: Vec2| {
        parts.iter().map(|p| p.own.mass * (at - p.own.centre).dot(at - p.own.centre)).sum::<f64>() <= value
    };
    let points = &cx.builder.mech.link(link).points;
    let about = points.iter().find(|p| enough(p.at)).map(|p| p.name.clone());
    let with_first = format!("{} at {point} inertia {inertia}", written(cx, first, part.own.mass));
    let of_whole = format!("inertia {inertia} about {}", about.as_ref().unwrap_or(&point));
    let count = stated.len();
    let mut fixes = Vec::new();
    if first.at.inertia.is_none() {
        let edits = vec![Edit::new(first.span, with_first.as_str()), Edit::new(whole.span, "")];
        fixes.push(Fix { title: format!("write `{with_first}`"), edits, certain: false });
    }
    if about.is_some() {
        fixes.extend(Fix::quoted(&format!("write `{of_whole}`"), whole.span));
    }
    cx.error(
        Diagnosis::error(
            "mech::geometry::inertia_of_which",
            format!("the inertia of `{name}` does not say which of the {count} masses it belongs to"),
        )
        .primary(whole.span, "of one mass, or of the whole link?")
        .label(first.span, "the first mass")
        .help(format!("write `{with_first}` with its own mass, or `{of_whole}` for the whole link"))
        .fixes(fixes),
    );
}

/// Warns of a mass that is written twice.
fn twice(cx: &mut Context<'_>, link: LinkId, stated: &[Stated<'_>]) {
    let alike = |a: &Stated<'_>, b: &Stated<'_>| {
        let inertia = match (&a.at.inertia, &b.at.inertia) {
            (Some(a), Some(b)) => same(a, b),
            (a, b) => a.is_none() && b.is_none(),
        };
        let shape = match (&a.at.shape, &b.at.shape) {
            (Some(a), Some(b)) => mass_shape::alike(a, b),
            (a, b) => a.is_none() && b.is_none(),
        };
        let point = |s: &Stated<'_>| s.at.at.as_ref().map(|at| at.node.clone());
        a.weight == b.weight && inertia && shape && same(&a.at.value, &b.at.value) && point(a) == point(b)
    };
    for (i, again) in stated.iter().enumerate() {
        let Some(first) = stated[..i].iter().find(|first| alike(first, again)) else { continue };
        let name = cx.builder.mech.link(link).name.clone();
        cx.error(
            Diagnosis::warning(
                "mech::geometry::counts_twice",
                format!("the same mass of `{name}` is written twice and counts twice"),
            )
            .label(again.span, "written again here")
            .label(first.span, "first written here")
            .help("leave one of them out, or keep both if there are two")
            .left_out("the second one", again.span),
        );
    }
}
