//! What can be wrong with a pair of gears.

use assur_text::source::Span;
use miette::Diagnostic;
use thiserror::Error;

/// Errors and warnings of gear pairs.
#[derive(Clone, Debug, Error, Diagnostic)]
pub enum GearError {
    /// The geometry of a mesh is asked of wheels that do not say enough.
    #[error("{message}")]
    #[diagnostic(code("mech::gear::incomplete"), help("{help}"))]
    Incomplete {
        /// What is missing.
        message: String,
        /// What to write.
        help: String,
        /// Where it is asked.
        #[label(primary, "asked here")]
        span: Span,
        /// The mesh.
        #[label("the mesh")]
        mesh: Span,
    },
    /// The shifts leave no working pressure angle.
    #[error(
        "the teeth of `{mesh}` do not reach each other: with these shifts the involute of the working pressure angle would be {involute}"
    )]
    #[diagnostic(
        code("mech::gear::no_mesh"),
        help(
            "it must not be negative: make the sum of the shifts (of an internal pair the ring's less the pinion's) greater"
        )
    )]
    NoMesh {
        /// The mesh.
        mesh: String,
        /// What it would be.
        involute: String,
        /// Where it is declared.
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
        help("write `shift {proposed}` or give it more teeth: {teeth} are enough without shift")
    )]
    Undercut {
        /// The wheel.
        wheel: String,
        /// Its shift.
        shift: String,
        /// The least one.
        least: String,
        /// Both shifts as they may be written.
        proposed: String,
        /// Number of teeth that is enough.
        teeth: String,
        /// The mesh.
        #[label("in this mesh")]
        span: Span,
    },
    /// Teeth that cannot run together, or cannot be made.
    #[error("{message}")]
    #[diagnostic(code("mech::gear::interference"), help("{help}"))]
    Interference {
        /// What meets what, with the numbers.
        message: String,
        /// What to change.
        help: String,
        /// The mesh.
        #[label("these teeth do not run together")]
        span: Span,
    },
    /// The tooth comes to a point.
    #[error(
        "the teeth of wheel `{wheel}` come to a point: on the tip circle their thickness would be {thickness}"
    )]
    #[diagnostic(code("mech::gear::pointed"), help("take a smaller profile shift, or a smaller addendum"))]
    Pointed {
        /// The wheel.
        wheel: String,
        /// Its thickness.
        thickness: String,
        /// The mesh.
        #[label("in this mesh")]
        span: Span,
    },
    /// A pair of teeth parts before the next one meets.
    #[error("the contact ratio of `{mesh}` is {ratio}: a pair of teeth parts before the next one meets")]
    #[diagnostic(
        code("mech::gear::contact_ratio"),
        severity(warning),
        help("it should be 1.2 or more: take more teeth, a smaller pressure angle, or smaller shifts")
    )]
    ContactRatio {
        /// The mesh.
        mesh: String,
        /// Its contact ratio.
        ratio: String,
        /// Where it is declared.
        #[label("does not run smoothly")]
        span: Span,
    },
}
