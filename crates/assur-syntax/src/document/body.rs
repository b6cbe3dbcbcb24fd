//! What stands in the braces of a link, the ground, a shaft or a slider.

use super::{Bad, Expr, Name};
use assur_text::source::Spanned;

/// The members of a body in the order written.
pub type Body = Vec<Spanned<Member>>;

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
    /// `mass 2.5 kg at S2`, `mass 3 kg at S inertia 0.16 kg*m^2`, `mass 3 kg rod A to B`
    Mass(At),
    /// `weight 21 N at C`
    Weight(At),
    /// `inertia 0.2 kg*m^2 about C`
    Inertia(About),
    /// `plane 250 mm`: the place of all masses along the axis
    Plane(Expr),
    /// `wheel z2 teeth 42 module 16 mm at O2`
    Wheel(WheelMember),
    /// A part that could not be read; already reported.
    Bad(Bad),
}

/// A point by its coordinates in the link's frame.
#[derive(Clone, Debug, PartialEq)]
pub struct PointMember {
    pub name: Name,
    pub at: Expr,
}

/// A point by its distances from two others.
#[derive(Clone, Debug, PartialEq)]
pub struct PointFrom {
    pub name: Name,
    /// The distance from the first point.
    pub first_distance: Expr,
    pub first: Name,
    /// The distance from the second point.
    pub second_distance: Expr,
    pub second: Name,
    /// On which side it lies, seen from the first point towards the second.
    pub side: Spanned<super::Side>,
}

#[derive(Clone, Debug, PartialEq)]
pub struct LineMember {
    pub name: Name,
    pub through: Name,
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

#[derive(Clone, Debug, PartialEq)]
pub struct CircleMember {
    pub name: Name,
    /// Its centre, a point of the link.
    pub centre: Name,
    pub radius: Expr,
}

/// The profile of a designed cam.
#[derive(Clone, Debug, PartialEq)]
pub struct ProfileMember {
    pub name: Name,
    pub of: Name,
    /// The point of the link about which the cam turns.
    pub centre: Name,
}

/// A mass or a weight, and the point where it sits.
#[derive(Clone, Debug, PartialEq)]
pub struct At {
    pub value: Expr,
    pub at: Option<Name>,
    /// How it is spread, where it is at no point.
    pub shape: Option<Box<MassShape>>,
    /// Its moment of inertia about that point.
    pub inertia: Option<Expr>,
    /// Its place along the axis.
    pub plane: Option<Expr>,
}

/// How a mass is spread.
#[derive(Clone, Debug, PartialEq)]
pub struct MassShape {
    pub kind: Spanned<ShapeKind>,
    /// The ends of a rod, the corners of a plate, else the centre.
    pub points: Vec<Name>,
    pub radius: Option<Expr>,
    pub inner: Option<Expr>,
    /// What a mass per volume is taken over, across the shape.
    pub across: Option<(Spanned<Across>, Expr)>,
}

impl MassShape {
    /// Its numbers.
    pub fn values(&self) -> impl Iterator<Item = &Expr> {
        self.radius.iter().chain(&self.inner).chain(self.across.as_ref().map(|(_, value)| value))
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ShapeKind {
    Rod,
    Disc,
    Ring,
    Sphere,
    Plate,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Across {
    /// `thickness 20 mm`
    Thickness,
    /// `section 300 mm^2`
    Section,
}

/// A moment of inertia.
#[derive(Clone, Debug, PartialEq)]
pub struct About {
    pub value: Expr,
    /// About which point; the mass centre where nothing is said.
    pub about: Option<Name>,
}

#[derive(Clone, Debug, PartialEq)]
pub struct WheelMember {
    pub name: Name,
    /// Its size, where it is given.
    pub size: Option<WheelSize>,
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
