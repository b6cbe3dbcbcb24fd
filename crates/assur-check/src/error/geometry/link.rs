//! Errors of links, their points, lines and masses.

use assur_text::diagnostic::{Fix, Problem};
use assur_text::source::Span;
use miette::Diagnostic;
use thiserror::Error;

/// Errors of links, points, lines, circles and masses.
#[derive(Clone, Debug, Error, Diagnostic)]
pub enum LinkError {
    /// A size that must be greater than zero is not.
    #[error("{what} must be greater than zero; got {value}")]
    #[diagnostic(code("mech::geometry::not_positive"), help("{help}"))]
    NotPositive {
        /// The size, with its article.
        what: String,
        value: String,
        help: String,
        #[label("{value}")]
        span: Span,
    },
    /// A size that may be zero is negative.
    #[error("{what} must not be negative; got {value}")]
    #[diagnostic(code("mech::geometry::negative"), help("write it without the minus, or leave it out"))]
    Negative {
        /// The size, with its article.
        what: String,
        value: String,
        #[label("{value}")]
        span: Span,
    },
    /// Something that can be given once is given again.
    #[error("{what} is given twice")]
    #[diagnostic(code("mech::geometry::stated_twice"), help("keep one of the two"))]
    StatedTwice {
        what: String,
        #[label(primary, "given again here")]
        again: Span,
        #[label("first given here")]
        first: Span,
    },
    /// A mass for every part of a link.
    #[error("the mass of `{link}` is given twice")]
    #[diagnostic(
        code("mech::geometry::stated_twice"),
        help(
            "a link has one mass: write the sum of the masses at their common centre, and `inertia` about it; or give each \
             its own link"
        )
    )]
    SecondMass {
        link: String,
        #[label(primary, "given again here")]
        again: Span,
        #[label("first given here")]
        first: Span,
    },
    /// The triangle of a point given by two distances does not close.
    #[error("the triangle of point `{point}` does not close: {reason}, {by} too {too}")]
    #[diagnostic(
        code("mech::geometry::point_does_not_close"),
        help("change a side of the triangle {sides}: {correction}")
    )]
    PointDoesNotClose {
        point: String,
        /// The comparison, with numbers.
        reason: String,
        by: String,
        /// `short` or `long`.
        too: &'static str,
        sides: String,
        /// Bounds for one of them.
        correction: String,
        #[label(primary, "no such point")]
        span: Span,
        #[label("{first_distance}")]
        first: Span,
        first_distance: String,
        #[label("{second_distance}")]
        second: Span,
        second_distance: String,
    },
    /// A direction or a triangle needs two points, but they coincide.
    #[error("{what} needs two different points, but `{first_name}` and `{second_name}` coincide")]
    #[diagnostic(
        code("mech::geometry::same_place"),
        help("move one of them, or name another point: both are at {place} in the link's frame")
    )]
    SamePlace {
        /// The item that needs them.
        what: String,
        first_name: String,
        second_name: String,
        place: String,
        /// The span of the first.
        #[label("`{first_name}`")]
        first: Span,
        /// The span of the second.
        #[label(primary, "at the same position as `{first_name}`")]
        second: Span,
    },
    /// Points that are defined by each other.
    #[error("the points {chain} are defined by each other")]
    #[diagnostic(
        code("mech::geometry::circular_points"),
        help("give one of them by its coordinates: `{point} (60 mm, 20 mm)`")
    )]
    CircularPoints {
        /// The points in order.
        chain: String,
        point: String,
        #[label(collection, "depends on the next one")]
        spans: Vec<Span>,
    },
    /// A mass without mass centre on a link that turns.
    #[error("the mass of `{link}` needs a mass centre, because `{link}` turns")]
    #[diagnostic(
        code("mech::geometry::mass_without_place"),
        help("give the mass centre: `{member} at {point}`")
    )]
    MassWithoutPlace {
        link: String,
        member: String,
        /// A point of the link.
        point: String,
        #[label(primary, "the point is missing")]
        span: Span,
        /// The pair on which it turns.
        #[label("`{link}` turns on this pair")]
        pair: Option<Span>,
    },
    /// A weight without gravity.
    #[error("the weight of `{link}` needs `gravity`, which the file does not declare")]
    #[diagnostic(
        code("mech::geometry::weight_without_gravity"),
        help(
            "add `gravity 9.81 m/s^2`; or, if the weight itself must not act, write `given g = 9.81 m/s^2` and `mass {weight} / g`"
        )
    )]
    WeightWithoutGravity {
        link: String,
        weight: String,
        #[label("a weight is a mass times gravity")]
        span: Span,
    },
    /// The parallel axis theorem gives a negative moment of inertia.
    #[error(
        "the inertia about `{point}` is {inertia}, less than the {least} of the mass of {mass} at a distance of {distance}"
    )]
    #[diagnostic(
        code("mech::geometry::inertia_too_small"),
        help(
            "leave out `about {point}` if the value is about the mass centre; as written, about the mass centre it would be negative ({left})"
        )
    )]
    InertiaTooSmall {
        /// The point it is about.
        point: String,
        inertia: String,
        mass: String,
        /// From the mass centre to the point.
        distance: String,
        /// Mass times distance squared.
        least: String,
        /// The value about the mass centre.
        left: String,
        #[label(primary, "{inertia}")]
        span: Span,
        #[label("{mass}, {distance} from `{point}`")]
        mass_span: Span,
    },
    /// A mass without inertia on a link that turns.
    #[error("`{link}` turns and has a mass but no inertia: it is taken as a point mass")]
    #[diagnostic(
        code("mech::geometry::point_mass"),
        severity(Advice),
        help(
            "add `inertia 0.01 kg*m^2` with its own value, about the mass centre, if it is more than a point mass"
        )
    )]
    PointMass {
        link: String,
        #[label("the whole mass at one point")]
        span: Span,
    },
    /// An inertia without a mass.
    #[error(
        "`{link}` moves and has an inertia but no mass: its weight and the force of its mass are left out"
    )]
    #[diagnostic(
        code("mech::geometry::point_mass"),
        severity(Advice),
        help("add `mass 1 kg at {point}` with its own value")
    )]
    NoMass {
        link: String,
        /// Where a mass may be.
        point: String,
        #[label("without a mass")]
        span: Span,
    },
    /// A mass on the link that does not move.
    #[error("the ground is fixed, so its {what} has no effect")]
    #[diagnostic(
        code("mech::geometry::mass_on_ground"),
        severity(Warning),
        help("leave it out, or give it to the moving link")
    )]
    MassOnGround {
        link: String,
        /// `mass` or `inertia`.
        what: &'static str,
        #[label("on the ground")]
        span: Span,
    },
}

impl Problem for LinkError {
    fn fixes(&self) -> Vec<Fix> {
        match self {
            Self::MassOnGround { what, span, .. } => vec![Fix::left_out(&format!("this {what}"), *span)],
            Self::StatedTwice { again, .. } => vec![Fix::left_out("the second one", *again)],
            Self::MassWithoutPlace { member, point, span, .. } => {
                Fix::quoted(&format!("write `{member} at {point}`"), *span)
            }
            Self::WeightWithoutGravity { .. } => vec![Fix::line("gravity 9.81 m/s^2")],
            _ => Vec::new(),
        }
    }
}
