//! The document: what a `.mech` text says, statement by statement, with the place of every part.
//!
//! Nothing here is checked for meaning: names are not resolved, units are written text, and a property list may hold
//! anything. A statement or member that could not be read is kept as `Bad` with the names it seems to declare, so
//! that later stages do not report those names as unknown.

mod body;
mod expr;
mod machine;
mod motion;
mod question;
mod simulation;

pub use assur_text::language::{CamLaw, JointKind};
pub use body::{About, Across, At, MassShape, PointFrom, ShapeKind, WheelSize};
pub use body::{
    Body, CircleMember, LineDirection, LineMember, Member, PointMember, ProfileMember, WheelMember,
};
pub use expr::{Arg, BinaryOp, CompareOp, Expr, ExprKind, Number, UnaryOp};
pub use expr::{children, parts};
pub use machine::{
    Bar, Brake, Cam, CamMember, Counterweight, End, Flywheel, Follower, Ground, Group, Joint, Link,
};
pub use machine::{Phase, PhaseKind, Property, Shaft, Slider, Spring, SpringSite};
pub use motion::{
    Assemble, AssembleClause, Balance, Direction, Drive, DrivePosition, DriveRange, Load, LoadKind, Steps,
};
pub use motion::{Order, Place, Pose, Sensed, Setting, Side, Site, Turn, Way};
pub use question::{
    Cell, Column, Curve, CurveBetween, CurveBeyond, Expect, ExpectAt, Find, FindItem, Row, Variants,
};
pub use simulation::{Balanced, Sought};
pub use simulation::{Event, Passing, PassingSense, Simulate, Start, Steady, Stop, TimeCourse, Until};

use assur_text::source::{Span, Spanned};

/// A name as written, in NFC, and its place.
pub type Name = Spanned<String>;

/// A name, or a part of a named thing: `crank`, `piston.C`, `ground.guide`.
#[derive(Clone, Debug, PartialEq)]
pub struct Path {
    /// The name before the dot.
    pub head: Name,
    /// The name after the dot, if there is one.
    pub tail: Option<Name>,
}

impl Path {
    /// The place of the whole path.
    #[must_use]
    pub fn span(&self) -> Span {
        self.tail.as_ref().map_or(self.head.span, |tail| self.head.span.to(tail.span))
    }
}

/// The contents of a text.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Document {
    /// The statements in the order written.
    pub statements: Vec<Spanned<Statement>>,
    /// The comment lines directly below the title: the problem's text, without the slashes.
    pub notes: Vec<Spanned<String>>,
    /// Comments and blank lines, which carry no meaning but must survive formatting.
    pub trivia: Trivia,
}

/// Comments and blank lines of a text.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Trivia {
    /// Every comment from its slashes to the end of its line, trailing blanks left out.
    pub comments: Vec<Span>,
    /// The first byte of every line that holds nothing but blanks.
    pub blank_lines: Vec<usize>,
}

#[derive(Clone, Debug, PartialEq)]
pub enum Statement {
    /// `mech 1`
    Edition(Spanned<String>),
    /// `mechanism "…"`: the title without its quotes.
    Title(Spanned<String>),
    /// `given r = 100 mm`
    Given(Definition),
    /// `let l = 3.5 * r`
    Let(Definition),
    /// `gravity 9.81 m/s^2`: a magnitude, or a vector.
    Gravity(Expr),
    /// `ground { … }`
    Ground(Ground),
    /// `link crank A-B 100 mm { … }`
    Link(Link),
    /// `shaft P on H { … }`
    Shaft(Shaft),
    /// `slider A`
    Slider(Slider),
    /// A pair, or a transmission: `revolute B: crank - rod { … }`
    Joint(Joint),
    /// `spring k: BDE.D - ground.C { … }`
    Spring(Spring),
    /// `group rod_piston: rod, piston`
    Group(Group),
    /// `drive crank = 45 deg at 1500 rpm`
    Drive(Drive),
    /// `pose 4' at crank = 90 deg`
    Pose(Pose),
    /// `assemble C ahead of B`
    Assemble(Assemble),
    /// `balance torque Mb on crank`
    Balance(Balance),
    /// `force P on ram at E = 1000 N @ 180 deg`
    Load(Box<Load>),
    /// `brake M on drum { … }`
    Brake(Brake),
    /// `cam plate { … }`
    Cam(Cam),
    /// `counterweight X on rotor { radius 100 mm; plane 100 mm }`
    Counterweight(Counterweight),
    /// `flywheel J on O1 for Mb { … }`
    Flywheel(Flywheel),
    /// `all revolute { friction_circle 5 mm }`
    All(AllJoints),
    /// `find reactions, Mb as kN*m`
    Find(Find),
    /// `expect Mb = 26 N*m within 1 %`
    Expect(Box<Expect>),
    /// `variants { … }`
    Variants(Variants),
    /// `curve p periodic { … }`
    Curve(Curve),
    /// `start OF = -0.0617 rad at 0 rad/s`
    Start(Start),
    Equilibrium(Vec<Balanced>),
    /// `simulate 0 s .. 0.03 s within 1e-9`
    Simulate(Simulate),
    /// `event top: omega(bar) = 0 rad/s falling`
    Event(Event),
    /// `until angle(crank) = 360 deg`
    Until(Until),
    /// `stop G > 0 mm { restitution 0.7 }`
    Stop(Stop),
    /// `ignore inertia`
    Ignore(Name),
    /// A part that could not be read; already reported.
    Bad(Bad),
}

/// A statement or member that could not be read.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Bad {
    /// The names that stand in it, in NFC: one of them may be what it was meant to declare.
    pub names: Vec<String>,
}

/// `NAME = EXPRESSION` after `given` or `let`.
#[derive(Clone, Debug, PartialEq)]
pub struct Definition {
    pub name: Name,
    pub value: Expr,
}

/// Properties for every joint of one kind.
#[derive(Clone, Debug, PartialEq)]
pub struct AllJoints {
    pub kind: Spanned<JointKind>,
    /// What holds for each of them that does not say otherwise.
    pub properties: Vec<Property>,
}

impl Document {
    /// The title, where there is one.
    #[must_use]
    pub fn title(&self) -> Option<&Spanned<String>> {
        self.statements.iter().find_map(|s| match &s.node {
            Statement::Title(title) => Some(title),
            _ => None,
        })
    }
}
