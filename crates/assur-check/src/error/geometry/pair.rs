//! Errors of pairs, springs and groups.

use assur_text::diagnostic::{Fix, Help, Problem, Undeclared};
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
        link: String,
        what: String,
        /// Its name, that of the pair.
        name: String,
        /// The points of the link, and how to write them.
        help: String,
        /// The link in the pair.
        #[label(primary, "the {what} `{name}` of `{link}` is joined here")]
        span: Span,
        #[label("the name of the pair is also the name of the {what}s it joins")]
        pair: Span,
    },
    /// A pair joins other things than it can.
    #[error("{what} joins {wants}, not {got}")]
    #[diagnostic(code("mech::geometry::wrong_ends"), help("{help}"))]
    WrongEnds {
        /// The pair with its article.
        what: String,
        /// The things it can join.
        wants: String,
        /// The things it joins here.
        got: String,
        help: String,
        #[label("{got}")]
        span: Span,
    },
    /// One of the ends is twice the same link.
    #[error("{what} `{name}` joins `{link}` with itself")]
    #[diagnostic(code("mech::geometry::joined_with_itself"), help("{help}"))]
    JoinedWithItself {
        help: String,
        /// Pair, spring …
        what: String,
        name: String,
        link: String,
        #[label("`{link}` here")]
        first: Span,
        #[label(primary, "and here")]
        second: Span,
    },
    /// Two hinges at the same points of the same links.
    #[error("`{first_point}` and `{second_point}` are joined twice")]
    #[diagnostic(
        code("mech::geometry::joined_twice"),
        help(
            "remove `{name}`, or name other points: the two hinges coincide, so their reactions cannot be separated"
        )
    )]
    JoinedTwice {
        name: String,
        first_point: String,
        second_point: String,
        #[label(primary, "joined again here")]
        again: Span,
        #[label("already joined here")]
        first: Span,
    },
    /// A second prismatic pair, in the point form, fixes the angle of a link.
    #[error("the rotation of `{link}` is fixed twice, by `{first_name}` and by `{name}`")]
    #[diagnostic(
        code("mech::geometry::held_twice"),
        help(
            "give `{link}` a line of its own for this pair: `line {line} through {point} along 90 deg` in the link, and \
             `prismatic {name}: {link}.{line} - …`; a point on a line also fixes the angle of its link, and the x axis of a \
             link can follow one line only"
        )
    )]
    HeldTwice {
        link: String,
        first_name: String,
        name: String,
        /// A free name for a line.
        line: String,
        /// The point that slides.
        point: String,
        #[label(primary, "fixes it again")]
        again: Span,
        #[label("fixes the angle of `{link}`")]
        first: Span,
    },
    /// Two profiles that cannot touch in one point.
    #[error("{profiles} cannot form a contact")]
    #[diagnostic(code("mech::geometry::no_contact"), help("{help}"))]
    NoContact {
        profiles: String,
        help: String,
        #[label("a contact is a circle on a circle, a line or a point, or a point on a line")]
        span: Span,
    },
    /// A property the statement does not have.
    #[error("{what} has no property `{name}`")]
    #[diagnostic(code("mech::geometry::unknown_property"), help("{help}"))]
    UnknownProperty {
        /// The statement, with its article.
        what: String,
        name: String,
        /// Similar properties, or all that exist.
        help: Help,
        #[label("not known here")]
        span: Span,
    },
    /// A property with another number or sort of values than it takes.
    #[error("`{name}` takes {wants}")]
    #[diagnostic(code("mech::geometry::property_value"), help("write `{example}`"))]
    PropertyValue {
        name: String,
        /// The values it takes.
        wants: String,
        example: String,
        #[label("{got}")]
        span: Span,
        got: String,
    },
    /// A property that needs another one, or contradicts another one.
    #[error("{message}")]
    #[diagnostic(code("mech::geometry::incomplete"), help("{help}"))]
    Incomplete {
        /// The missing or contradicting property.
        message: String,
        help: String,
        #[label("{label}")]
        span: Span,
        /// The text of the label.
        label: String,
    },
    /// The two contacts of a slider at one point.
    #[error("the two contacts are both at {at}")]
    #[diagnostic(
        code("mech::geometry::contacts_coincide"),
        help("give the two ends of the sliding surface along the line, as in `contacts -20 mm, 25 mm`")
    )]
    ContactsCoincide {
        at: String,
        #[label("{at} and {at}")]
        span: Span,
    },
    /// A Geneva wheel that is none.
    #[error("{message}")]
    #[diagnostic(code("mech::geometry::geneva"), help("{help}"))]
    Geneva {
        message: String,
        help: String,
        /// The number of its slots.
        #[label(primary, "here")]
        span: Span,
    },
    /// A pin that does not enter along the slot.
    #[error(
        "the pin of `{name}` enters its slot with a shock: the wheel starts at {ratio} of the crank's speed"
    )]
    #[diagnostic(code("mech::geometry::geneva_shock"), severity(Warning), help("{help}"))]
    GenevaShock {
        name: String,
        /// The ratio of the angular velocities.
        ratio: String,
        /// The proportions without a shock.
        help: String,
        #[label("velocity jumps here")]
        span: Span,
    },
    /// A group that cannot be one.
    #[error("{message}")]
    #[diagnostic(code("mech::geometry::no_group"), help("name different moving links"))]
    NoGroup {
        message: String,
        #[label("not a link of a group")]
        span: Span,
    },
}

impl Problem for PairError {
    fn fixes(&self) -> Vec<Fix> {
        match self {
            Self::UnknownProperty { help, .. } => help.fixes().to_vec(),
            Self::PropertyValue { example, span, .. } => Fix::quoted(&format!("write `{example}`"), *span),
            Self::Geneva { help, span, .. } if help.starts_with("write `slots ") => Fix::quoted(help, *span),
            Self::Incomplete { help, span, .. } if help.starts_with("leave `") && help.ends_with("` out") => {
                let what = help.split('`').nth(1).unwrap_or_default();
                vec![Fix::left_out(&format!("`{what}`"), *span)]
            }
            _ => Vec::new(),
        }
    }

    fn undeclared(&self) -> Option<Undeclared<'_>> {
        match self {
            Self::NothingToJoin { link, what, name, span, pair, .. } if what == "point" => {
                Some(Undeclared { kind: "point", name, owner: Some(link), at: pair.to(*span) })
            }
            _ => None,
        }
    }
}
