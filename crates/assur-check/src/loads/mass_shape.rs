//! Masses from shapes: a rod, a disc, a ring, a sphere or a plate, each the same throughout.

use super::mass::{Stated, over_gravity};
use crate::expr::context::Context;
use crate::expr::positive::positive;
use crate::statements::walk::same;
use assur_math::math::Vec2;
use assur_model::model::{self, LinkId, MassPart, MassProperties};
use assur_syntax::document::{Across, MassShape, ShapeKind};
use assur_text::diagnostic::Diagnosis;
use assur_text::source::Span;
use assur_text::units::Dimension;
use std::f64::consts::PI;

/// A plate whose area is less than this part of the square of its circumference has none.
const NO_AREA: f64 = 1e-12;

/// What follows from the shape alone.
struct Spread {
    shape: model::MassShape,
    centre: Vec2,
    /// J/m about the centre, m².
    gyration: f64,
    /// Its length, area or volume.
    size: f64,
}

/// A mass of a link that has a shape.
pub(super) fn part(
    cx: &mut Context<'_>,
    link: LinkId,
    stated: &Stated<'_>,
    shape: &MassShape,
) -> Option<MassPart> {
    let points: Vec<_> = shape.points.iter().map(|name| cx.point(link, name)).collect();
    let points = points.into_iter().collect::<Option<Vec<_>>>();
    let spread = match shape.kind.node {
        ShapeKind::Rod => rod(cx, shape, &points?),
        ShapeKind::Plate => plate(cx, shape, points?),
        kind => round(cx, shape, kind, *points?.first()?),
    };
    let mass = amount(cx, link, stated, shape, spread.as_ref().map(|s| s.size));
    let (spread, mass) = (spread?, mass?);
    let own = MassProperties { mass, centre: spread.centre, inertia: mass * spread.gyration };
    Some(MassPart { own, shape: Some(spread.shape), plane: 0.0 })
}

/// Whether two shapes are written with the same points and numbers.
pub(super) fn alike(a: &MassShape, b: &MassShape) -> bool {
    let names = |shape: &MassShape| shape.points.iter().map(|name| name.node.clone()).collect::<Vec<_>>();
    let values = |shape: &MassShape| shape.values().count();
    let equal = a.values().zip(b.values()).all(|(a, b)| same(a, b));
    a.kind.node == b.kind.node && names(a) == names(b) && values(a) == values(b) && equal
}

fn rod(cx: &mut Context<'_>, shape: &MassShape, points: &[Vec2]) -> Option<Spread> {
    let &[from, to] = points else { return None };
    let size = (to - from).norm();
    if size > 0.0 {
        let (centre, gyration) = ((from + to) * 0.5, size * size / 12.0);
        return Some(Spread { shape: model::MassShape::Rod { from, to }, centre, gyration, size });
    }
    wrong(
        cx,
        shape.kind.span,
        "the rod has no length",
        "its ends are at the same place",
        "name two points that are apart",
    )
}

/// A disc, a ring or a sphere.
fn round(cx: &mut Context<'_>, shape: &MassShape, kind: ShapeKind, centre: Vec2) -> Option<Spread> {
    let name = word(kind);
    let stated = shape.radius.as_ref()?;
    let radius = positive(cx, stated, Dimension::LENGTH, &format!("the radius of the {name}"))?;
    let square = radius * radius;
    let inner = match &shape.inner {
        None => 0.0,
        Some(inner) if kind != ShapeKind::Disc => {
            let help = "leave it out; a hollow sphere is two: `mass 6 kg sphere …` and `mass -2 kg sphere …`";
            return wrong(cx, inner.span, &format!("a {name} has no inner radius"), "only of a disc", help);
        }
        Some(inner) => {
            let value = positive(cx, inner, Dimension::LENGTH, "the inner radius of the disc")?;
            if value >= radius {
                let what = "the inner radius of the disc is not less than its radius";
                return wrong(
                    cx,
                    inner.span,
                    what,
                    "too large",
                    "write a smaller inner radius, or leave it out",
                );
            }
            value
        }
    };
    let (shape, gyration, size) = match kind {
        ShapeKind::Disc => {
            let inner_square = inner * inner;
            let size = PI * (square - inner_square);
            (model::MassShape::Disc { radius, inner }, (square + inner_square) / 2.0, size)
        }
        ShapeKind::Ring => (model::MassShape::Ring { radius }, square, 2.0 * PI * radius),
        _ => (model::MassShape::Sphere { radius }, 0.4 * square, 4.0 / 3.0 * PI * square * radius),
    };
    Some(Spread { shape, centre, gyration, size })
}

/// A polygon, by Green's sums over its sides.
fn plate(cx: &mut Context<'_>, shape: &MassShape, corners: Vec<Vec2>) -> Option<Spread> {
    let (first, around) = (*corners.first()?, corners.iter().skip(1).chain(corners.first()));
    let sides: Vec<(Vec2, Vec2)> = corners.iter().copied().zip(around.copied()).collect();
    let (mut twice, mut turned, mut moment, mut polar) = (0.0, 0.0, Vec2::zero(), 0.0);
    for (a, b) in sides.iter().map(|(a, b)| (*a - first, *b - first)) {
        let cross = a.cross(b);
        twice += cross;
        turned += cross.abs();
        moment += (a + b) * cross;
        polar += (a.dot(a) + a.dot(b) + b.dot(b)) * cross;
    }
    let length: f64 = sides.iter().map(|(a, b)| (*b - *a).norm()).sum();
    if turned <= NO_AREA * length * length {
        let help = "name at least three corners that are not on one line";
        return wrong(cx, shape.kind.span, "the plate has no area", "nothing lies between its corners", help);
    }
    if crosses_itself(&sides) {
        let help = "name the corners in the order in which they follow each other along the edge";
        return wrong(cx, shape.kind.span, "the edge of the plate crosses itself", "in this order", help);
    }
    let centre = moment / (3.0 * twice);
    let gyration = polar / (6.0 * twice) - centre.dot(centre);
    let (centre, size) = (first + centre, twice.abs() / 2.0);
    Some(Spread { shape: model::MassShape::Plate { corners }, centre, gyration, size })
}

/// Whether two sides of a polygon meet elsewhere than at the corner that they share.
fn crosses_itself(sides: &[(Vec2, Vec2)]) -> bool {
    let count = sides.len();
    let beside = |i: usize, j: usize| (i + 1) % count == j || (j + 1) % count == i;
    let over = |(a, b): (Vec2, Vec2), p: Vec2| (b - a).cross(p - a);
    let apart = |one, (c, d): (Vec2, Vec2)| over(one, c) * over(one, d) > 0.0;
    let overlap = |[a, b, c, d]: [f64; 4]| a.min(b) <= c.max(d) && c.min(d) <= a.max(b);
    let meet = |one: (Vec2, Vec2), other: (Vec2, Vec2)| {
        let boxes = overlap([one.0.x, one.1.x, other.0.x, other.1.x])
            && overlap([one.0.y, one.1.y, other.0.y, other.1.y]);
        boxes && !apart(one, other) && !apart(other, one)
    };
    // the next side turns back along this one
    let back = |one: (Vec2, Vec2), next: (Vec2, Vec2)| {
        let (a, b) = (one.1 - one.0, next.1 - next.0);
        a.cross(b) == 0.0 && a.dot(b) < 0.0
    };
    let mut pairs = (0..count).flat_map(|j| (0..j).map(move |i| (i, j)));
    pairs.any(|(i, j)| if beside(i, j) { back(sides[i], sides[j]) } else { meet(sides[i], sides[j]) })
}

/// The mass: as given, or from a mass per length, area or volume. A hole has one below zero.
fn amount(
    cx: &mut Context<'_>,
    link: LinkId,
    stated: &Stated<'_>,
    shape: &MassShape,
    size: Option<f64>,
) -> Option<f64> {
    let (kind, name) = (shape.kind.node, word(shape.kind.node));
    let (power, across, example) = match kind {
        ShapeKind::Rod | ShapeKind::Ring => (1, Across::Section, "section 300 mm^2"),
        ShapeKind::Disc | ShapeKind::Plate => (2, Across::Thickness, "thickness 20 mm"),
        ShapeKind::Sphere => (3, Across::Thickness, ""),
    };
    let (whole, quantity) =
        if stated.weight { (Dimension::FORCE, "weight") } else { (Dimension::MASS, "mass") };
    let per = |power| whole.over(Dimension::LENGTH.powi(power));
    let wants = [whole, per(power), per(3)];
    let unit = if stated.weight { "N" } else { "kg" };
    let units = match power {
        3 => format!("{unit} or {unit}/m^3"),
        1 => format!("{unit}, {unit}/m or {unit}/m^3"),
        _ => format!("{unit}, {unit}/m^2 or {unit}/m^3"),
    };
    let what = format!("the {quantity} of a {name}, in {units},");
    let (value, has) = cx.scalar_of_one(&stated.at.value, &wants, &what)?;
    if value == 0.0 || !value.is_finite() {
        let help = format!("write its {quantity}, or leave it out");
        return wrong(
            cx,
            stated.at.value.span,
            &format!("the {name} has no {quantity}"),
            "not a mass",
            &help,
        );
    }
    let by_volume = has == per(3) && power < 3;
    let depth = match &shape.across {
        None if by_volume => {
            let what =
                format!("a {quantity} per volume needs the {} of the {name}", example.split(' ').next()?);
            let help =
                format!("add `{example}` with its own value, or write the {quantity} of the whole {name}");
            return wrong(cx, stated.at.value.span, &what, "per volume", &help);
        }
        None => 1.0,
        Some((stated, value)) if by_volume && stated.node == across => {
            let dimension = Dimension::LENGTH.powi(3 - power);
            positive(cx, value, dimension, &format!("the {} of the {name}", across_word(across)))?
        }
        Some((stated, value)) => {
            return needless(cx, stated.node, stated.span.to(value.span), name, by_volume.then_some(example));
        }
    };
    let value = if stated.weight { over_gravity(cx, link, stated, value, has)? } else { value };
    Some(if has == whole { value } else { value * depth * size? })
}

/// Reports a thickness or a section that has no effect or is not that of the shape.
fn needless(
    cx: &mut Context<'_>,
    across: Across,
    span: Span,
    name: &str,
    instead: Option<&str>,
) -> Option<f64> {
    let word = across_word(across);
    let (what, help) = match instead {
        Some(example) => (format!("a {name} has no {word}"), format!("write `{example}` with its own value")),
        None => (
            format!("the {word} of the {name} has no effect: it goes with a mass per volume"),
            format!("leave out the {word}, or write a mass per volume, as `7850 kg/m^3`"),
        ),
    };
    wrong(cx, span, &what, "not needed here", &help)
}

const fn across_word(across: Across) -> &'static str {
    match across {
        Across::Thickness => "thickness",
        Across::Section => "section",
    }
}

const fn word(kind: ShapeKind) -> &'static str {
    match kind {
        ShapeKind::Rod => "rod",
        ShapeKind::Disc => "disc",
        ShapeKind::Ring => "ring",
        ShapeKind::Sphere => "sphere",
        ShapeKind::Plate => "plate",
    }
}

fn wrong<T>(cx: &mut Context<'_>, at: Span, what: &str, label: &str, help: &str) -> Option<T> {
    cx.error(Diagnosis::error("mech::geometry::mass_shape", what).label(at, label).help(help));
    None
}
