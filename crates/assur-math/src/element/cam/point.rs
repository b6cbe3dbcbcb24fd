//! Pitch curve, working profile, pressure angle and curvature at one cam angle φ.
//!
//! Seen from the frame, x from the cam's centre towards the follower (along the way of a translating one, towards the
//! pivot of an oscillating one), for a cam that turns clockwise; for one that turns counter-clockwise y is mirrored.
//! Seen from such a cam the frame turns counter-clockwise by φ, so that a point q(φ) of the frame runs along e^{iφ} q
//! with the derivatives e^{iφ} (q′ + i q) and e^{iφ} (q″ + 2 i q′ − q).
//!
//! Knife edge and roller: the pitch curve is that of the tip
//! - q = (d₀ + s, e), d₀² = r₀² − e² (translating),
//! - q = (a − L cos ψ, ±L sin ψ), ψ = ψ₀ + s, L² + a² − 2 a L cos ψ₀ = r₀² (oscillating, + with the cam),
//!
//! its outward normal n = −i P′/|P′|, the profile P − r n, the curvature κ = P′ × P″/|P′|³.
//!
//! Flat face: the profile is the envelope of a line with normal angle χ(φ) at distance h from the centre,
//! W = e^{iχ} (h + i dh/dχ), its radius of curvature h + d²h/dχ²;
//! - χ = φ, h = r₀ + s (translating),
//! - χ = φ ± (π/2 − ψ), h = a sin ψ − f, ψ₀ = asin((r₀ + f)/a) (oscillating, + with the cam).

use super::{Cam, Jet, Part};
use crate::math::Vec2;

/// What belongs to one cam angle. Vectors in the axes of the frame, origin in the cam's centre, x towards the follower.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CamPoint {
    /// Lift and its derivatives by the cam angle: m or rad, per rad, rad², rad³.
    pub lift: Jet,
    /// Knife edge or centre of the roller; for a flat face the place of contact, m.
    pub tip: Vec2,
    /// Place of contact, m.
    pub contact: Vec2,
    /// Unit common normal into the follower.
    pub normal: Vec2,
    /// Between the normal and the way of the follower's point, 0 to π/2.
    pub pressure_angle: f64,
    /// Curvature of the pitch curve, positive where it is convex, 1/m; for a flat face that of the profile.
    pub curvature: f64,
    /// How fast the contact runs along the pitch curve (face: the normal turns) against the cam's turn, in the sense in
    /// which the curve is walked; not positive where it loops back: m or 1.
    pub advance: f64,
}

/// A number that belongs to every cam angle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// Lift (0) or one of its derivatives (1 to 3) by the cam angle.
    Lift(u8),
    PressureAngle,
    /// Radius of curvature of the pitch curve (for a flat face of the profile), negative where it is hollow.
    CurvatureRadius,
}

impl CamPoint {
    /// The value of a quantity here.
    #[must_use]
    pub fn value(&self, quantity: Quantity) -> f64 {
        match quantity {
            Quantity::Lift(n) => self.lift[usize::from(n.min(3))],
            Quantity::PressureAngle => self.pressure_angle,
            Quantity::CurvatureRadius => 1.0 / self.curvature,
        }
    }

    fn mirrored(mut self) -> Self {
        for v in [&mut self.tip, &mut self.contact, &mut self.normal] {
            v.y = -v.y;
        }
        self
    }
}

impl Cam {
    /// All that belongs to a cam angle, rad.
    #[must_use]
    pub fn at(&self, phi: f64) -> CamPoint {
        self.with_lift(self.program.at(phi))
    }

    /// The same by the formula of a part, which goes on beyond its ends.
    #[must_use]
    pub fn beyond(&self, part: &Part, phi: f64) -> CamPoint {
        self.with_lift(self.program.beyond(part, phi))
    }

    /// The same for a lift and its derivatives.
    #[must_use]
    pub fn with_lift(&self, lift: Jet) -> CamPoint {
        let point = match self.follower {
            Follower::Translating { shape: Shape::Flat, .. } => self.translating_face(lift),
            Follower::Translating { shape, offset } => self.translating_tip(lift, shape, offset),
            Follower::Oscillating { shape: Shape::Flat, pivot_distance, with_cam, offset, .. } => {
                self.oscillating_face(lift, pivot_distance, with_cam, offset)
            }
            Follower::Oscillating { shape, arm, pivot_distance, with_cam, .. } => {
                self.oscillating_tip(lift, shape, arm, pivot_distance, with_cam)
            }
        };
        if self.ccw { point.mirrored() } else { point }
    }

    /// A vector of the frame's axes in those of the cam, which coincide at φ = 0.
    #[must_use]
    pub fn in_cam(&self, v: Vec2, phi: f64) -> Vec2 {
        v.turned(Vec2::direction(if self.ccw { -phi } else { phi }))
    }

    fn translating_tip(&self, lift: Jet, shape: Shape, offset: f64) -> CamPoint {
        let [s, v, a, _] = lift;
        let q = [Vec2::new(self.start + s, offset), Vec2::new(v, 0.0), Vec2::new(a, 0.0)];
        tip(lift, q, Vec2::new(1.0, 0.0), shape.radius())
    }

    fn oscillating_tip(&self, lift: Jet, shape: Shape, arm: f64, distance: f64, with_cam: bool) -> CamPoint {
        let [s, v, a, _] = lift;
        let (sin, cos) = libm::sincos(self.start + s);
        let side = if with_cam { 1.0 } else { -1.0 };
        let along = Vec2::new(sin, side * cos);
        let back = Vec2::new(cos, -side * sin);
        let q = [
            Vec2::new(distance - arm * cos, side * arm * sin),
            along * (arm * v),
            along * (arm * a) + back * (arm * v * v),
        ];
        tip(lift, q, along, shape.radius())
    }

    fn translating_face(&self, lift: Jet) -> CamPoint {
        let [s, v, a, _] = lift;
        let h = self.start + s;
        let contact = Vec2::new(h, v);
        CamPoint {
            lift,
            tip: contact,
            contact,
            normal: Vec2::new(1.0, 0.0),
            pressure_angle: 0.0,
            curvature: 1.0 / (h + a),
            advance: 1.0,
        }
    }

    fn oscillating_face(&self, lift: Jet, distance: f64, with_cam: bool, offset: f64) -> CamPoint {
        let [s, v, a, _] = lift;
        let (sin, cos) = libm::sincos(self.start + s);
        let side = if with_cam { 1.0 } else { -1.0 };
        let normal = Vec2::new(sin, side * cos);
        let h = [distance * sin - offset, distance * cos * v, distance * (cos * a - sin * v * v)];
        let (chi_1, chi_2) = (1.0 - side * v, -side * a);
        let slope = h[1] / chi_1;
        let bend = (h[2] * chi_1 - h[1] * chi_2) / (chi_1 * chi_1 * chi_1);
        let contact = normal * h[0] + normal.perp() * slope;
        let way = (contact - Vec2::new(distance, 0.0)).perp();
        CamPoint {
            lift,
            tip: contact,
            contact,
            normal,
            pressure_angle: between(normal, way),
            curvature: 1.0 / (h[0] + bend),
            advance: chi_1,
        }
    }
}

/// Pitch curve of a tip with its derivatives in the frame, and the way the follower moves it.
fn tip(lift: Jet, [q, q_1, q_2]: [Vec2; 3], way: Vec2, radius: f64) -> CamPoint {
    let first = q_1 + q.perp();
    let second = q_2 + q_1.perp() * 2.0 - q;
    let speed = libm::hypot(first.x, first.y);
    let normal = -(first / speed).perp();
    CamPoint {
        lift,
        tip: q,
        contact: q - normal * radius,
        normal,
        pressure_angle: between(normal, way),
        curvature: first.cross(second) / (speed * speed * speed),
        advance: q.cross(first) / libm::hypot(q.x, q.y),
    }
}

/// The acute angle between two lines.
fn between(a: Vec2, b: Vec2) -> f64 {
    libm::atan2(a.cross(b).abs(), a.dot(b).abs())
}

// What a cam moves.

/// The end of a follower that touches the cam.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    Knife,
    /// A roller of this radius, m.
    Roller(f64),
    /// A flat face; that of a translating follower stands across its way.
    Flat,
}

/// A follower. Angles in rad, lengths in m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Follower {
    /// It moves along a line.
    Translating {
        shape: Shape,
        /// Distance of the line of the knife edge or roller centre from the cam's centre; positive on that side on which
        /// it lessens the pressure angle of the rise.
        offset: f64,
    },
    /// It turns about a pivot.
    Oscillating {
        shape: Shape,
        /// Distance of the knife edge or roller centre from the pivot; of no meaning for a flat face.
        arm: f64,
        /// Distance of the pivot from the cam's centre.
        pivot_distance: f64,
        /// The rise turns the follower in the sense of the cam.
        with_cam: bool,
        /// Distance of a flat face from the pivot, positive towards the cam.
        offset: f64,
    },
}

impl Follower {
    #[must_use]
    pub const fn shape(&self) -> Shape {
        match self {
            Self::Translating { shape, .. } | Self::Oscillating { shape, .. } => *shape,
        }
    }

    /// Whether its lift is an angle.
    #[must_use]
    pub const fn oscillates(&self) -> bool {
        matches!(self, Self::Oscillating { .. })
    }
}

impl Shape {
    /// Radius of the roller, m; zero for a knife edge and a face.
    #[must_use]
    pub const fn radius(self) -> f64 {
        match self {
            Self::Roller(r) => r,
            Self::Knife | Self::Flat => 0.0,
        }
    }
}
