//! Links with their points, lines and circles.

use crate::math::Vec2;
use crate::source::Span;

/// A rigid link. Its frame is its own: points, lines and circles are given in it.
#[derive(Clone, Debug, Default)]
pub struct Link {
    /// Name; `ground` for the ground, `c1.barrel` and `c1.rod` for the two links of a cylinder.
    pub name: String,
    /// The number of the textbook, where written.
    pub number: Option<String>,
    /// Place of the name.
    pub span: Span,
    pub points: Vec<Point>,
    pub lines: Vec<Line>,
    pub circles: Vec<Circle>,
    /// Profiles of designed cams.
    pub cam_profiles: Vec<CamProfile>,
    /// Mass properties of the whole link, where declared.
    pub mass: Option<MassProperties>,
    /// Its masses, where there are several or one has a shape or a plane.
    pub mass_parts: Vec<MassPart>,
}

/// Points nearer to a line than this part of their distance from the origin are on it.
const SAME: f64 = 1e-9;

impl Link {
    /// The line across which it is cut, in its frame: a point, m, and the unit direction. Its x axis; where no two points lie on that
    /// and all lie on another line, that line from its first point on. `None` where neither is so.
    #[must_use]
    pub fn axis(&self) -> Option<(Vec2, Vec2)> {
        let size = self.points.iter().map(|point| point.at.norm()).fold(0.0, f64::max);
        let near = |distance: f64| distance.abs() <= SAME * size;
        let mut on_x = self.points.iter().filter(|point| near(point.at.y)).map(|point| point.at.x);
        let first_on_x = on_x.next();
        if self.points.len() < 2 || on_x.any(|x| first_on_x.is_some_and(|first| !near(x - first))) {
            return Some((Vec2::zero(), Vec2::new(1.0, 0.0)));
        }
        let from = self.points[0].at;
        let ways = self.points.iter().map(|point| point.at - from);
        let longest = ways.clone().fold(Vec2::zero(), |a, b| if b.norm() > a.norm() { b } else { a });
        let along = longest.unit()?;
        ways.clone().all(|way| near(along.cross(way))).then_some((from, along))
    }

    /// A point of its frame along and across the line of its cuts, m.
    #[must_use]
    pub fn on_axis(&self, at: Vec2) -> Vec2 {
        let (from, along) = self.axis().unwrap_or((Vec2::zero(), Vec2::new(1.0, 0.0)));
        (at - from).turned_back(along)
    }

    /// Where its points begin and end on the line of its cuts, m; equal of a link of one point.
    #[must_use]
    pub fn extent(&self) -> [f64; 2] {
        let xs = || self.points.iter().map(|point| self.on_axis(point.at).x);
        let ends = [xs().fold(f64::INFINITY, f64::min), xs().fold(f64::NEG_INFINITY, f64::max)];
        if ends[0] <= ends[1] { ends } else { [0.0; 2] }
    }
}

/// Mass of a link.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MassProperties {
    /// Mass, kg, > 0 (zero where only an inertia is declared).
    pub mass: f64,
    /// Mass centre in the link's frame, m.
    pub centre: Vec2,
    /// Moment of inertia about the mass centre, kg m², ≥ 0.
    pub inertia: f64,
}

impl MassProperties {
    /// Several masses of a link as one: Σ m, Σ m r / m, Σ (J + m |r − r_S|²).
    #[must_use]
    pub fn of_parts(parts: &[MassPart]) -> Self {
        let mass = parts.iter().map(|p| p.own.mass).sum();
        let centre = parts.iter().fold(Vec2::zero(), |sum, p| sum + p.own.centre * p.own.mass) / mass;
        let about = |p: &Self| p.inertia + p.mass * (p.centre - centre).dot(p.centre - centre);
        let inertia = parts.iter().map(|p| about(&p.own)).sum();
        Self { mass, centre, inertia }
    }
}

/// One of the masses of a link.
#[derive(Clone, Debug, PartialEq)]
pub struct MassPart {
    /// Its own, about its own centre. A hole has a mass below zero.
    pub own: MassProperties,
    /// How it is spread; of a mass at a point nothing.
    pub shape: Option<MassShape>,
    /// Its place along the axis, m.
    pub plane: f64,
}

/// A counterweight as it was found.
#[derive(Clone, Debug)]
pub struct Counterweight {
    pub name: String,
    pub mass: f64,
    /// Its distance from the hinge, m.
    pub radius: f64,
    /// Its direction from the hinge in the link's frame, rad.
    pub angle: f64,
}

/// How a mass is spread, evenly; a disc, a ring and a sphere about the centre of the part.
#[derive(Clone, Debug, PartialEq)]
pub enum MassShape {
    /// Along the line between two points of the link.
    Rod {
        from: Vec2,
        to: Vec2,
    },
    /// Between an inner radius, which may be zero, and an outer one.
    Disc {
        radius: f64,
        inner: f64,
    },
    /// Along a circle.
    Ring {
        radius: f64,
    },
    Sphere {
        radius: f64,
    },
    /// Over a polygon; its corners in order.
    Plate {
        corners: Vec<Vec2>,
    },
}

/// A point of a link.
#[derive(Clone, Debug)]
pub struct Point {
    pub name: String,
    /// Place of the name.
    pub span: Span,
    /// Coordinates in the link's frame, m.
    pub at: Vec2,
}

/// A directed, unbounded line of a link.
#[derive(Clone, Debug)]
pub struct Line {
    pub name: String,
    /// Place of the name.
    pub span: Span,
    /// Its `through` point in the link's frame, m: the zero of the coordinate along it.
    pub through: Vec2,
    /// Unit direction in the link's frame.
    pub along: Vec2,
}

/// A circle of a link.
#[derive(Clone, Debug)]
pub struct Circle {
    pub name: String,
    /// Place of the name.
    pub span: Span,
    /// Centre in the link's frame, m.
    pub centre: Vec2,
    /// Radius, m, > 0.
    pub radius: f64,
}

/// The profile of a designed cam on a link. The axes of the cam are those of the link.
#[derive(Clone, Debug)]
pub struct CamProfile {
    pub name: String,
    /// The cam: index into [`super::Mechanism::cams`].
    pub cam: usize,
    /// Its centre in the link's frame, m.
    pub centre: Vec2,
}
