//! What the machine is: links, pairs, transmissions, machine elements.

use super::{Body, Expr, Name, Path, Turn};
use assur_text::language::{CamLaw, JointKind};
use assur_text::source::{Span, Spanned};

/// `ground 0 { … }`
#[derive(Clone, Debug, PartialEq)]
pub struct Ground {
    /// The number used in printed symbols.
    pub number: Option<Spanned<String>>,
    /// Its points, lines and wheels.
    pub body: Body,
}

/// `link 1 crank A-B r { … }`
#[derive(Clone, Debug, PartialEq)]
pub struct Link {
    /// The number used in printed symbols.
    pub number: Option<Spanned<String>>,
    pub name: Name,
    /// `A-B r`
    pub bar: Option<Bar>,
    pub body: Body,
}

/// `A-B r`: short for `{ A (0, 0); B (r, 0) }`.
#[derive(Clone, Debug, PartialEq)]
pub struct Bar {
    /// The point at the origin.
    pub from: Name,
    /// The point on the x axis.
    pub to: Name,
    pub length: Expr,
}

/// `shaft P on H { wheel p teeth 18 }`
#[derive(Clone, Debug, PartialEq)]
pub struct Shaft {
    pub name: Name,
    /// The carrier it turns on.
    pub on: Option<Name>,
    pub body: Body,
}

/// `slider A`
#[derive(Clone, Debug, PartialEq)]
pub struct Slider {
    pub name: Name,
    pub body: Body,
}

/// A pair or a transmission between links.
#[derive(Clone, Debug, PartialEq)]
pub struct Joint {
    pub kind: Spanned<JointKind>,
    pub name: Name,
    /// What it joins, in the order written; two or more.
    pub ends: Vec<End>,
    /// The contents of its braces.
    pub properties: Vec<Property>,
}

/// One end of a joint.
#[derive(Clone, Debug, PartialEq)]
pub enum End {
    /// `crank`, `piston.C`, `ground.guide`, `w1`
    At(Path),
    /// `over(C)`: an idler, declared here.
    Over(Name),
    /// `under(P)`: a movable pulley on slider P.
    Under(Name),
}

impl End {
    /// The place of what is named.
    #[must_use]
    pub fn span(&self) -> Span {
        match self {
            Self::At(path) => path.span(),
            Self::Over(name) | Self::Under(name) => name.span,
        }
    }
}

/// `friction 0.1`, `contacts -20 mm, 25 mm`, `with_cam`, `rim { … }`
#[derive(Clone, Debug, PartialEq)]
pub struct Property {
    /// Empty where the property could not be read.
    pub name: Name,
    /// Its values; none for a word that stands alone.
    pub values: Vec<Expr>,
    /// The properties in its own braces.
    pub properties: Vec<Property>,
    pub span: Span,
}

/// `spring k: BDE.D - ground.C { … }`, `spring t in B { … }`
#[derive(Clone, Debug, PartialEq)]
pub struct Spring {
    pub name: Name,
    pub site: SpringSite,
    /// Stiffness, free length or angle, damping.
    pub properties: Vec<Property>,
}

/// What a spring joins.
#[derive(Clone, Debug, PartialEq)]
pub enum SpringSite {
    Points(Path, Path),
    /// The two links of a revolute pair.
    Pair(Name),
}

/// `group rod_piston: rod, piston`
#[derive(Clone, Debug, PartialEq)]
pub struct Group {
    pub name: Name,
    pub links: Vec<Name>,
}

/// `cam plate { … }`
#[derive(Clone, Debug, PartialEq)]
pub struct Cam {
    pub name: Name,
    /// The contents of its braces.
    pub members: Vec<Spanned<CamMember>>,
}

/// The description of a cam.
#[derive(Clone, Debug, PartialEq)]
pub enum CamMember {
    /// `turning cw`
    Turning(Spanned<Turn>),
    /// `follower oscillating roller { … }`
    Follower(Follower),
    /// `rise 60 deg through 18 deg parabolic`
    Phase(Box<Phase>),
    /// `lift along law`: the curve
    Lift(Name),
    /// `base_radius 50 mm`, and what else may come
    Property(Property),
    /// A part that could not be read; already reported.
    Bad(super::Bad),
}

/// `follower oscillating roller { … }`
#[derive(Clone, Debug, PartialEq)]
pub struct Follower {
    /// `oscillating` or `translating`
    pub motion: Name,
    /// `roller`, `knife` or `flat`
    pub shape: Name,
    /// The contents of its braces.
    pub properties: Vec<Property>,
}

/// A part of the cam's turn.
#[derive(Clone, Debug, PartialEq)]
pub struct Phase {
    pub kind: Spanned<PhaseKind>,
    /// The angle the cam turns.
    pub angle: Expr,
    /// How far the follower goes.
    pub through: Option<Expr>,
    pub law: Option<Spanned<CamLaw>>,
}

/// The parts of a cam's turn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PhaseKind {
    /// The follower goes out.
    Rise,
    Dwell,
    Fall,
}

/// `brake M on drum { … }`
#[derive(Clone, Debug, PartialEq)]
pub struct Brake {
    /// The name of its torque.
    pub name: Name,
    /// The link or shaft that it brakes.
    pub on: Name,
    /// The contents of its braces.
    pub properties: Vec<Property>,
}

/// `counterweight X on rotor { radius 100 mm; plane 100 mm }`
#[derive(Clone, Debug, PartialEq)]
pub struct Counterweight {
    pub name: Name,
    /// The link that it balances.
    pub on: Name,
    /// The contents of its braces.
    pub properties: Vec<Property>,
}

/// `flywheel J on O1 for Mb { … }`
#[derive(Clone, Debug, PartialEq)]
pub struct Flywheel {
    /// Its name, also that of the moment of inertia found.
    pub name: Name,
    /// The shaft or link it sits on.
    pub on: Name,
    /// The torque whose work it evens out.
    pub torque: Option<Name>,
    /// The contents of its braces.
    pub properties: Vec<Property>,
}
