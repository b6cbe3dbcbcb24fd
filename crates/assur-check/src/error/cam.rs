//! Errors of cams, and of their use as a pair.

use assur_text::source::Span;
use miette::Diagnostic;
use thiserror::Error;

/// Errors and warnings of cams.
#[derive(Clone, Debug, Error, Diagnostic)]
pub enum CamError {
    /// The phases take more than a turn.
    #[error("the phases of cam `{name}` take {total}, {over} more than one turn")]
    #[diagnostic(code("mech::cam::turn_exceeded"), help("make one of them shorter by {over}"))]
    TurnExceeded {
        name: String,
        /// Sum of the angles.
        total: String,
        over: String,
        #[label("{total} in all")]
        span: Span,
        #[label(primary, "does not fit into the turn")]
        last: Span,
    },
    /// The follower does not come back.
    #[error("after one turn the follower of cam `{name}` is {left} higher than before")]
    #[diagnostic(
        code("mech::cam::does_not_return"),
        help(
            "let it fall by {left} more ({rises} up, {falls} down), or leave out `through` in the last fall"
        )
    )]
    DoesNotReturn {
        name: String,
        left: String,
        /// Sum of the rises.
        rises: String,
        /// Sum of the falls.
        falls: String,
        #[label("after this phase")]
        span: Span,
    },
    /// The follower would fall below the base circle.
    #[error("the follower of cam `{name}` falls by {by} from {from} above the base circle")]
    #[diagnostic(
        code("mech::cam::below_base"),
        help(
            "begin with a rise, and let it fall by no more than it rose: the base circle is the least radius"
        )
    )]
    BelowBase {
        name: String,
        /// The start of the fall.
        from: String,
        /// How far it falls.
        by: String,
        #[label("falls by {by}")]
        span: Span,
    },
    /// The follower does not reach the base circle.
    #[error("{message}")]
    #[diagnostic(code("mech::cam::base_radius"), help("{help}"))]
    BaseRadius {
        /// The sizes that do not fit.
        message: String,
        /// The radii that fit.
        help: String,
        #[label("does not fit the follower")]
        span: Span,
    },
    /// A table that cannot be the lift.
    #[error("{message}")]
    #[diagnostic(code("mech::cam::table"), help("{help}"))]
    Table {
        message: String,
        help: String,
        /// The curve's name, or the phase.
        #[label(primary, "here")]
        span: Span,
    },
    /// The spline through a table swings below the base circle.
    #[error("between its rows the lift of cam `{name}` goes {least} below the base circle, at {at}")]
    #[diagnostic(
        code("mech::cam::swing"),
        severity(Warning),
        help(
            "a spline swings where its rows turn sharply: write stretches at rest as `dwell` between two tables, or add rows"
        )
    )]
    Swing {
        name: String,
        at: String,
        least: String,
        #[label("the motion")]
        span: Span,
    },
    /// The profile cuts itself.
    #[error("the profile of cam `{name}` is undercut at {at}: {bend}")]
    #[diagnostic(code("mech::cam::undercut"), help("{help}"))]
    Undercut {
        name: String,
        at: String,
        bend: String,
        /// A base radius that is enough.
        help: String,
        #[label("the follower cannot follow this law")]
        span: Span,
    },
    /// The profile comes to a point.
    #[error("the profile of cam `{name}` comes to a point at {at}: {bend}")]
    #[diagnostic(code("mech::cam::pointed"), severity(warning), help("{help}"))]
    Pointed {
        name: String,
        at: String,
        bend: String,
        /// A better base radius.
        help: String,
        #[label("pointed")]
        span: Span,
    },
    /// The velocity of the follower jumps.
    #[error("at {at} the follower of cam `{name}` jumps from a velocity of {before} to {behind}")]
    #[diagnostic(
        code("mech::cam::shock"),
        severity(warning),
        help(
            "use a law that starts and ends at rest, such as `cycloidal`: the acceleration is unbounded there"
        )
    )]
    Shock {
        name: String,
        at: String,
        before: String,
        behind: String,
        #[label("the velocity jumps at {at}")]
        span: Span,
    },
    /// The follower in the mechanism is not the follower of the design.
    #[error("`{pair}`: {message}")]
    #[diagnostic(code("mech::cam::other_follower"), help("{help}"))]
    OtherFollower {
        pair: String,
        /// The difference, with both numbers.
        message: String,
        help: String,
        #[label(primary, "touches here")]
        span: Span,
        #[label("designed here")]
        cam: Span,
    },
}

impl assur_text::diagnostic::Problem for CamError {}
