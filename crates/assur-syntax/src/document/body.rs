//! What stands in the braces of a link, the ground, a shaft or a slider.

use super::{Bad, Expr, Name};
use assur_text::source::Spanned;

/// The members of a body in the order written.
pub type Body = Vec<Spanned<Member>>;

/// One member.
#[derive(Clone, Debug, PartialEq)]
pub enum Member {
    /// `S2 (l/3, 0)`
    Point(PointMember),
    /// `D 80 mm from C 60 mm from E left`
    PointFrom(Box<PointFrom>),
    /// `line guide through A along 0 deg`
    Line(LineMember),
    /// `circle roller centre D radius 15 mm`
    Circle(CircleMember),
    /// `profile rim of plate centre O`
    Profile(ProfileMember),
    /// `mass 2.5 kg at S2`
    Mass(At),
    /// `weight 21 N at C`
    Weight(At),
    /// `inertia 0.2 kg*m^2 about C`
    Inertia(About),
    /// `wheel z2 teeth 42 module 16 mm at O2`
    Wheel(WheelMember),
    /// A part that could not be read; already reported.
    Bad(Bad),
}

/// A point by its coordinates in the link's frame.
#[derive(Clone, Debug, PartialEq)]
pub struct PointMember {
    /// Its name.
    pub name: Name,
    /// A vector.
    pub at: Expr,
}

/// A point by its distances from two others.
#[derive(Clone, Debug, PartialEq)]
pub struct PointFrom {
    /// Its name.
    pub name: Name,
    /// The distance from the first point.
    pub first_distance: Expr,
    /// The first point.
    pub first: Name,
    /// The distance from the second point.
    pub second_distance: Expr,
    /// The second point.
    pub second: Name,
    /// On which side it lies, seen from the first point towards the second.
    pub side: Spanned<super::Side>,
}

/// A directed line.
#[derive(Clone, Debug, PartialEq)]
pub struct LineMember {
    /// Its name.
    pub name: Name,
    /// Its origin.
    pub through: Name,
    /// Its direction.
    pub direction: LineDirection,
}

/// The direction of a line.
#[derive(Clone, Debug, PartialEq)]
pub enum LineDirection {
    /// `along 30 deg`
    Along(Expr),
    /// `to B`
    To(Name),
}

/// A circle.
#[derive(Clone, Debug, PartialEq)]
pub struct CircleMember {
    /// Its name.
    pub name: Name,
    /// Its centre, a point of the link.
    pub centre: Name,
    /// Its radius.
    pub radius: Expr,
}

/// The profile of a designed cam.
#[derive(Clone, Debug, PartialEq)]
pub struct ProfileMember {
    /// Its name.
    pub name: Name,
    /// The cam.
    pub of: Name,
    /// The point of the link about which the cam turns.
    pub centre: Name,
}

/// A mass or a weight, and the point where it sits.
#[derive(Clone, Debug, PartialEq)]
pub struct At {
    /// How much.
    pub value: Expr,
    /// The mass centre.
    pub at: Option<Name>,
}

/// A moment of inertia.
#[derive(Clone, Debug, PartialEq)]
pub struct About {
    /// How much.
    pub value: Expr,
    /// About which point; the mass centre where nothing is said.
    pub about: Option<Name>,
}

/// A wheel.
#[derive(Clone, Debug, PartialEq)]
pub struct WheelMember {
    /// Its name.
    pub name: Name,
    /// Its size, where it is given.
    pub size: Option<WheelSize>,
    /// Its module.
    pub module: Option<Expr>,
    /// Its centre, on a link.
    pub at: Option<Name>,
}

/// How a wheel's size is given.
#[derive(Clone, Debug, PartialEq)]
pub enum WheelSize {
    /// `radius 0.2 m`
    Radius(Expr),
    /// `diameter 0.4 m`
    Diameter(Expr),
    /// `teeth 42`
    Teeth(Expr),
}
