//! What can be wrong with a pair, a spring or a group.

use assur_text::source::Span;
use miette::Diagnostic;
use thiserror::Error;

/// Errors of pairs, springs and groups.
#[derive(Clone, Debug, Error, Diagnostic)]
pub enum PairError {
    /// A link named without a point has none with the pair's name.
    #[error("`{link}` has no {what} `{name}`")]
    #[diagnostic(code("mech::geometry::nothing_to_join"), help("{help}"))]
    NothingToJoin {
        /// The link.
        link: String,
        /// What was looked for.
        what: String,
        /// Its name, that of the pair.
        name: String,
        /// What the link has, and how to write it.
        help: String,
        /// The link in the pair.
        #[label(primary, "the {what} `{name}` of `{link}` is joined here")]
        span: Span,
        /// The pair's name.
        #[label("the pair's name stands for the {what}s it joins")]
        pair: Span,
    },
    /// A pair joins other things than it can.
    #[error("{what} joins {wants}, not {got}")]
    #[diagnostic(code("mech::geometry::wrong_ends"), help("{help}"))]
    WrongEnds {
        /// The pair with its article.
        what: String,
        /// What it can join.
        wants: String,
        /// What it was given.
        got: String,
        /// What to write.
        help: String,
        /// The ends.
        #[label("{got}")]
        span: Span,
    },
    /// One of the ends is twice the same link.
    #[error("{what} `{name}` joins `{link}` with itself")]
    #[diagnostic(code("mech::geometry::joined_with_itself"), help("{help}"))]
    JoinedWithItself {
        /// What to write.
        help: String,
        /// Pair, spring …
        what: String,
        /// Its name.
        name: String,
        /// The link.
        link: String,
        /// The first end.
        #[label("`{link}` here")]
        first: Span,
        /// The second end.
        #[label(primary, "and here")]
        second: Span,
    },
    /// Two hinges at the same points of the same links.
    #[error("`{first_point}` and `{second_point}` are joined twice")]
    #[diagnostic(
        code("mech::geometry::joined_twice"),
        help(
            "one of the two hinges carries nothing that could be told from the other: remove `{name}`, or name other points"
        )
    )]
    JoinedTwice {
        /// The second pair.
        name: String,
        /// One point.
        first_point: String,
        /// The other point.
        second_point: String,
        /// The second pair.
        #[label(primary, "joined again here")]
        again: Span,
        /// The first pair.
        #[label("already joined here")]
        first: Span,
    },
    /// A second prismatic pair fixes the angle of a link by the point form.
    #[error("`{link}` is kept from turning twice: by `{first_name}` and by `{name}`")]
    #[diagnostic(
        code("mech::geometry::held_twice"),
        help(
            "a point on a line also fixes the link's angle to that line, and a link's x axis can be laid along one line only; \
             give `{link}` a line of its own for this pair: `line {line} through {point} along 90 deg` in the link, and \
             `prismatic {name}: {link}.{line} - …`"
        )
    )]
    HeldTwice {
        /// The sliding link.
        link: String,
        /// The first pair.
        first_name: String,
        /// The second pair.
        name: String,
        /// A free name for a line.
        line: String,
        /// The point that slides.
        point: String,
        /// The second pair.
        #[label(primary, "fixes it again")]
        again: Span,
        /// The first pair.
        #[label("fixes the angle of `{link}`")]
        first: Span,
    },
    /// Two profiles that can not touch in one point.
    #[error("{profiles} are no contact")]
    #[diagnostic(code("mech::geometry::no_contact"), help("{help}"))]
    NoContact {
        /// The two profiles.
        profiles: String,
        /// What to write instead.
        help: String,
        /// The ends.
        #[label("a contact is a circle on a circle, a line or a point, or a point on a line")]
        span: Span,
    },
    /// A property the statement does not have.
    #[error("{what} has no property `{name}`")]
    #[diagnostic(code("mech::geometry::unknown_property"), help("{help}"))]
    UnknownProperty {
        /// What it stands in, with its article.
        what: String,
        /// The property.
        name: String,
        /// What is near, or what there is.
        help: String,
        /// Its place.
        #[label("not known here")]
        span: Span,
    },
    /// A property with another number or sort of values than it takes.
    #[error("`{name}` takes {wants}")]
    #[diagnostic(code("mech::geometry::property_value"), help("write `{example}`"))]
    PropertyValue {
        /// The property.
        name: String,
        /// What it takes.
        wants: String,
        /// As it should look.
        example: String,
        /// Its place.
        #[label("{got}")]
        span: Span,
        /// What stands there.
        got: String,
    },
    /// A property that means nothing without another, or not beside another.
    #[error("{message}")]
    #[diagnostic(code("mech::geometry::incomplete"), help("{help}"))]
    Incomplete {
        /// What is missing or too much.
        message: String,
        /// What to write.
        help: String,
        /// Where.
        #[label("{label}")]
        span: Span,
        /// What is said of the place.
        label: String,
    },
    /// The two contacts of a slider at one place.
    #[error("the two contacts are both at {at}")]
    #[diagnostic(
        code("mech::geometry::contacts_coincide"),
        help("give the two ends of the sliding surface along the line, as in `contacts -20 mm, 25 mm`")
    )]
    ContactsCoincide {
        /// Their coordinate.
        at: String,
        /// Their place.
        #[label("{at} and {at}")]
        span: Span,
    },
    /// A group that can not be one.
    #[error("{message}")]
    #[diagnostic(
        code("mech::geometry::no_group"),
        help("a structural group consists of different moving links")
    )]
    NoGroup {
        /// What is wrong.
        message: String,
        /// The link.
        #[label("not here")]
        span: Span,
    },
}
