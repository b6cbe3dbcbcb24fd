//! Errors of gear pairs.

use assur_text::source::Span;
use miette::Diagnostic;
use thiserror::Error;

/// Errors and warnings of gear pairs.
#[derive(Clone, Debug, Error, Diagnostic)]
pub enum GearError {
    /// The geometry of a mesh is asked for, but its wheels are not fully described.
    #[error("{message}")]
    #[diagnostic(code("mech::gear::incomplete"), help("{help}"))]
    Incomplete {
        message: String,
        help: String,
        #[label(primary, "asked here")]
        span: Span,
        #[label("the mesh")]
        mesh: Span,
    },
    /// With these shifts there is no working pressure angle.
    #[error(
        "the teeth of `{mesh}` do not reach each other: the involute of the working pressure angle would be {involute}, less than zero"
    )]
    #[diagnostic(
        code("mech::gear::no_mesh"),
        help(
            "make the sum of the shifts greater (in an internal pair the shift of the ring minus that of the pinion)"
        )
    )]
    NoMesh {
        mesh: String,
        /// The value it would have.
        involute: String,
        #[label("shifted too far")]
        span: Span,
    },
    /// The rack cuts into the flank.
    #[error(
        "wheel `{wheel}` is undercut: its profile shift is {shift}, the least without undercut is {least}"
    )]
    #[diagnostic(
        code("mech::gear::undercut"),
        severity(warning),
        help("write `shift {proposed}` or give it more teeth: {teeth} are enough without a shift")
    )]
    Undercut {
        wheel: String,
        shift: String,
        least: String,
        /// Both shifts as they may be written.
        proposed: String,
        /// A sufficient number of teeth.
        teeth: String,
        #[label("in this mesh")]
        span: Span,
    },
    /// Teeth that interfere, or cannot be made.
    #[error("{message}")]
    #[diagnostic(code("mech::gear::interference"), help("{help}"))]
    Interference {
        /// The interfering parts, with the numbers.
        message: String,
        help: String,
        #[label("these teeth interfere")]
        span: Span,
    },
    /// The tooth comes to a point.
    #[error(
        "the teeth of wheel `{wheel}` come to a point: on the tip circle their thickness would be {thickness}"
    )]
    #[diagnostic(code("mech::gear::pointed"), help("use a smaller profile shift, or a smaller addendum"))]
    Pointed {
        wheel: String,
        thickness: String,
        #[label("in this mesh")]
        span: Span,
    },
    /// A pair of teeth parts before the next one meets.
    #[error("the contact ratio of `{mesh}` is {ratio}: a pair of teeth parts before the next one meets")]
    #[diagnostic(
        code("mech::gear::contact_ratio"),
        severity(warning),
        help("use more teeth, a smaller pressure angle, or smaller shifts: it should be 1.2 or more")
    )]
    ContactRatio {
        mesh: String,
        ratio: String,
        #[label("does not run smoothly")]
        span: Span,
    },
}

impl assur_text::diagnostic::Problem for GearError {}
