//! What can be wrong with a cam, and with its use as a pair.

use assur_text::source::Span;
use miette::Diagnostic;
use thiserror::Error;

/// Errors and warnings of cams.
#[derive(Clone, Debug, Error, Diagnostic)]
pub enum CamError {
    /// The phases take more than a turn.
    #[error("the phases of cam `{name}` take {total}, {over} more than a turn")]
    #[diagnostic(code("mech::cam::turn_exceeded"), help("make one of them shorter by {over}"))]
    TurnExceeded {
        /// The cam.
        name: String,
        /// Sum of the angles.
        total: String,
        /// What is too much.
        over: String,
        /// The cam's name.
        #[label("{total} in all")]
        span: Span,
        /// The last phase.
        #[label(primary, "does not fit any more")]
        last: Span,
    },
    /// The follower does not come back.
    #[error("after one turn the follower of cam `{name}` stands {left} higher than before")]
    #[diagnostic(
        code("mech::cam::does_not_return"),
        help(
            "rises and falls must be equal ({rises} up, {falls} down): let it fall by {left} more, or leave out `through` in the last fall"
        )
    )]
    DoesNotReturn {
        /// The cam.
        name: String,
        /// How far it stands off.
        left: String,
        /// Sum of the rises.
        rises: String,
        /// Sum of the falls.
        falls: String,
        /// The last phase.
        #[label("behind this")]
        span: Span,
    },
    /// The follower would fall below the base circle.
    #[error("the follower of cam `{name}` falls by {by} from {from} above the base circle")]
    #[diagnostic(
        code("mech::cam::below_base"),
        help("the base circle is the least radius: begin with a rise, and fall by no more than it rose")
    )]
    BelowBase {
        /// The cam.
        name: String,
        /// Where the fall begins.
        from: String,
        /// How far it falls.
        by: String,
        /// The phase.
        #[label("falls by {by}")]
        span: Span,
    },
    /// The follower does not stand on the base circle.
    #[error("{message}")]
    #[diagnostic(code("mech::cam::base_radius"), help("{help}"))]
    BaseRadius {
        /// What does not fit.
        message: String,
        /// Which radii do.
        help: String,
        /// The base radius.
        #[label("does not fit the follower")]
        span: Span,
    },
    /// The profile cuts itself.
    #[error("the profile of cam `{name}` is undercut at {at}: {bend}")]
    #[diagnostic(code("mech::cam::undercut"), help("{help}"))]
    Undercut {
        /// The cam.
        name: String,
        /// The cam angle.
        at: String,
        /// The radii.
        bend: String,
        /// What is enough.
        help: String,
        /// The cam's name.
        #[label("its follower cannot follow the law")]
        span: Span,
    },
    /// The profile comes to a point.
    #[error("the profile of cam `{name}` comes to a point at {at}: {bend}")]
    #[diagnostic(code("mech::cam::pointed"), severity(warning), help("{help}"))]
    Pointed {
        /// The cam.
        name: String,
        /// The cam angle.
        at: String,
        /// The radii.
        bend: String,
        /// What is better.
        help: String,
        /// The cam's name.
        #[label("pointed")]
        span: Span,
    },
    /// The velocity of the follower jumps.
    #[error("at {at} the follower of cam `{name}` changes its velocity from {before} to {behind} at once")]
    #[diagnostic(
        code("mech::cam::shock"),
        severity(warning),
        help("its acceleration has no bound there: take a law that starts and ends at rest, as `cycloidal`")
    )]
    Shock {
        /// The cam.
        name: String,
        /// The cam angle.
        at: String,
        /// Velocity before.
        before: String,
        /// Velocity behind.
        behind: String,
        /// The cam's name.
        #[label("its law jumps at {at}")]
        span: Span,
    },
    /// The follower in the mechanism is not the one the cam was designed for.
    #[error("`{pair}`: {message}")]
    #[diagnostic(code("mech::cam::other_follower"), help("{help}"))]
    OtherFollower {
        /// The contact.
        pair: String,
        /// What differs, with both numbers.
        message: String,
        /// What to write.
        help: String,
        /// The contact.
        #[label(primary, "touches here")]
        span: Span,
        /// The cam.
        #[label("designed here")]
        cam: Span,
    },
}
