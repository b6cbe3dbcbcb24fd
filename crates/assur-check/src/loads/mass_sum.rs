//! Several masses on one link: m = Σ m_i, r_S = Σ m_i r_i / m, J_S = Σ (J_i + m_i |r_i − r_S|²).

use super::mass::{Stated, StatedInertia, amount_of_mass, own_inertia, steiner, written};
use crate::expr::context::Context;
use crate::expr::positive::not_negative;
use crate::expr::property::given_twice;
use crate::statements::walk::same;
use crate::values::format_value::format_value_like;
use assur_math::math::Vec2;
use assur_model::model::{LinkId, MassProperties};
use assur_text::diagnostic::{Diagnosis, Fix};
use assur_text::source::Edit;
use assur_text::units::Dimension;

/// The whole mass of a link and its parts. What has no place of its own, as a slider of a train, needs no points.
pub(super) fn several(
    cx: &mut Context<'_>,
    link: LinkId,
    stated: &[Stated<'_>],
    inertia: Option<StatedInertia<'_>>,
    placed: bool,
) -> Option<(MassProperties, Vec<MassProperties>)> {
    twice(cx, link, stated);
    let parts: Vec<_> = stated.iter().map(|one| part(cx, link, one, placed)).collect();
    let parts = parts.into_iter().collect::<Option<Vec<MassProperties>>>()?;
    let mass: f64 = parts.iter().map(|p| p.mass).sum();
    let centre = parts.iter().fold(Vec2::zero(), |sum, p| sum + p.centre * p.mass) / mass;
    let from_centre = |p: &MassProperties| p.mass * (p.centre - centre).dot(p.centre - centre);
    let about_centre = match inertia {
        None => parts.iter().map(|p| p.inertia + from_centre(p)).sum(),
        Some(whole) if placed && whole.about.is_none() => {
            of_which(cx, link, stated, &parts, whole);
            return None;
        }
        Some(whole) => {
            if let Some(own) = stated.iter().find_map(own_inertia) {
                let name = cx.builder.mech.link(link).name.clone();
                cx.error(given_twice(&format!("the inertia of `{name}`"), whole.span, own.span));
                return None;
            }
            let at: Vec<_> = stated.iter().zip(&parts).map(|(s, p)| (s.span, p.mass, p.centre)).collect();
            steiner(cx, link, whole, &at, (mass, centre))?
        }
    };
    Some((MassProperties { mass, centre, inertia: about_centre }, parts))
}

/// One of the masses.
fn part(cx: &mut Context<'_>, link: LinkId, stated: &Stated<'_>, placed: bool) -> Option<MassProperties> {
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
    Some(MassProperties { mass: mass?, centre: centre?, inertia: inertia? })
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
    parts: &[MassProperties],
    whole: StatedInertia<'_>,
) {
    let name = cx.builder.mech.link(link).name.clone();
    let what = format!("the inertia of `{name}`");
    let Some(value) = not_negative(cx, whole.value, Dimension::INERTIA, &what) else { return };
    let (Some(first), Some(part)) = (stated.first(), parts.first()) else { return };
    let Some(point) = first.at.at.as_ref().map(|at| at.node.clone()) else { return };
    let inertia = format_value_like(&cx.names, value, Dimension::INERTIA, whole.value);
    // the first point whose moment of inertia of the masses alone is not greater
    let enough =
        |at: Vec2| parts.iter().map(|p| p.mass * (at - p.centre).dot(at - p.centre)).sum::<f64>() <= value;
    let points = &cx.builder.mech.link(link).points;
    let about = points.iter().find(|p| enough(p.at)).map(|p| p.name.clone());
    let with_first = format!("{} at {point} inertia {inertia}", written(cx, first, part.mass));
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
        let point = |s: &Stated<'_>| s.at.at.as_ref().map(|at| at.node.clone());
        a.weight == b.weight && inertia && same(&a.at.value, &b.at.value) && point(a) == point(b)
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
