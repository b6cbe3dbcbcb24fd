//! What can be wrong with a link, its points, lines and masses.

use assur_text::source::Span;
use miette::Diagnostic;
use thiserror::Error;

/// Errors of links, points, lines, circles and masses.
#[derive(Clone, Debug, Error, Diagnostic)]
pub enum LinkError {
    /// A size that must be greater than zero is not.
    #[error("{what} must be greater than zero, it is {value}")]
    #[diagnostic(code("mech::geometry::not_positive"), help("{help}"))]
    NotPositive {
        /// What is too small, with its article.
        what: String,
        /// Its value.
        value: String,
        /// What to do.
        help: String,
        /// The value's place.
        #[label("{value}")]
        span: Span,
    },
    /// A size that may be zero is less.
    #[error("{what} must not be negative, it is {value}")]
    #[diagnostic(code("mech::geometry::negative"), help("write it without the minus, or leave it out"))]
    Negative {
        /// What is negative, with its article.
        what: String,
        /// Its value.
        value: String,
        /// The value's place.
        #[label("{value}")]
        span: Span,
    },
    /// Something that can be said once is said again.
    #[error("{what} is stated twice")]
    #[diagnostic(code("mech::geometry::stated_twice"), help("keep one of the two"))]
    StatedTwice {
        /// What.
        what: String,
        /// The second statement.
        #[label(primary, "stated again here")]
        again: Span,
        /// The first one.
        #[label("first stated here")]
        first: Span,
    },
    /// The triangle of a point given by two distances does not close.
    #[error("point `{point}` does not close: {reason}, {by} too {too}")]
    #[diagnostic(
        code("mech::geometry::point_does_not_close"),
        help("the three sides {sides} make no triangle; {mend}")
    )]
    PointDoesNotClose {
        /// The point.
        point: String,
        /// What was compared, with numbers.
        reason: String,
        /// The gap.
        by: String,
        /// `short` or `long`.
        too: &'static str,
        /// The three lengths.
        sides: String,
        /// Bounds for one of them.
        mend: String,
        /// The point's name.
        #[label(primary, "no such point")]
        span: Span,
        /// The first distance.
        #[label("{first_distance}")]
        first: Span,
        /// Its value.
        first_distance: String,
        /// The second distance.
        #[label("{second_distance}")]
        second: Span,
        /// Its value.
        second_distance: String,
    },
    /// A direction or a triangle is asked of two points that coincide.
    #[error("{what} needs two different points, but `{first_name}` and `{second_name}` are the same place")]
    #[diagnostic(
        code("mech::geometry::same_place"),
        help("both lie at {place} in the link's frame; move one of them or name another point")
    )]
    SamePlace {
        /// What needs them.
        what: String,
        /// One point.
        first_name: String,
        /// The other.
        second_name: String,
        /// Where they are.
        place: String,
        /// Where the first is named.
        #[label("`{first_name}`")]
        first: Span,
        /// Where the second is named.
        #[label(primary, "the same place as `{first_name}`")]
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
        /// One of them.
        point: String,
        /// Their names.
        #[label(collection, "needs the next one")]
        spans: Vec<Span>,
    },
    /// A mass without place on a link that turns.
    #[error("the mass of `{link}` has no place, but `{link}` turns")]
    #[diagnostic(
        code("mech::geometry::mass_without_place"),
        help("say where the mass centre is: `{member} at {point}`")
    )]
    MassWithoutPlace {
        /// The link.
        link: String,
        /// The member.
        member: String,
        /// A point of the link.
        point: String,
        /// The member.
        #[label(primary, "at which point?")]
        span: Span,
        /// What lets it turn.
        #[label("`{link}` turns on this pair")]
        pair: Option<Span>,
    },
    /// A weight where nothing falls.
    #[error("the weight of `{link}` needs `gravity`, which the file does not declare")]
    #[diagnostic(
        code("mech::geometry::weight_without_gravity"),
        help(
            "add `gravity 9.81 m/s^2`, or, where the weight itself must not act, `given g = 9.81 m/s^2` and `mass {weight} / g`"
        )
    )]
    WeightWithoutGravity {
        /// The link.
        link: String,
        /// The weight.
        weight: String,
        /// The member.
        #[label("a weight is a mass times gravity")]
        span: Span,
    },
    /// The parallel axis theorem gives a negative moment of inertia.
    #[error(
        "the inertia about `{point}` is {inertia}, but the mass of {mass} alone, {distance} away, has {least}"
    )]
    #[diagnostic(
        code("mech::geometry::inertia_too_small"),
        help(
            "about the mass centre it would be {left}, less than nothing; if it is already about the mass centre, leave `about {point}` out"
        )
    )]
    InertiaTooSmall {
        /// The point it is about.
        point: String,
        /// As given.
        inertia: String,
        /// The link's mass.
        mass: String,
        /// From the mass centre to the point.
        distance: String,
        /// Mass times distance squared.
        least: String,
        /// What would be left for the mass centre.
        left: String,
        /// The inertia's place.
        #[label(primary, "{inertia}")]
        span: Span,
        /// The mass's place.
        #[label("{mass}, {distance} from `{point}`")]
        mass_span: Span,
    },
    /// A mass without inertia on a link that turns.
    #[error("`{link}` turns and has a mass but no inertia: it is taken as a point mass")]
    #[diagnostic(
        code("mech::geometry::point_mass"),
        severity(Advice),
        help(
            "if it is more than a point, add `inertia 0.01 kg*m^2` with its own value, about the mass centre"
        )
    )]
    PointMass {
        /// The link.
        link: String,
        /// The mass.
        #[label("all of it at one point")]
        span: Span,
    },
    /// A mass on the link that does not move.
    #[error("the {what} of `{link}` has no effect: the ground does not move, and what holds it is not asked")]
    #[diagnostic(
        code("mech::geometry::mass_on_ground"),
        severity(Warning),
        help("leave it out, or state it on the link that moves")
    )]
    MassOnGround {
        /// The ground's name.
        link: String,
        /// `mass` or `inertia`.
        what: &'static str,
        /// The member.
        #[label("on the ground")]
        span: Span,
    },
}
