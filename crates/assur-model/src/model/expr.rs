//! Typed expressions over results: what a `find`, an `expect`, a load or a condition computes at a pose.

use super::{
    BalanceId, Curve, CurvePart, Display, DriveId, FlywheelPart, LinkId, LoadId, PairId, QuantityId,
};
use crate::math::Vec2;
use crate::source::Span;
use std::sync::Arc;

/// A value in SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    Scalar(f64),
    /// A vector in ground axes.
    Vector(Vec2),
    Bool(bool),
}

impl Value {
    /// Whether it is a condition, or numbers that are finite.
    #[must_use]
    pub fn is_defined(&self) -> bool {
        match self {
            Self::Scalar(x) => x.is_finite(),
            Self::Vector(v) => v.x.is_finite() && v.y.is_finite(),
            Self::Bool(_) => true,
        }
    }

    /// Magnitude of a number or a vector; zero for a condition.
    #[must_use]
    pub fn magnitude(&self) -> f64 {
        match self {
            Self::Scalar(x) => x.abs(),
            Self::Vector(v) => libm::hypot(v.x, v.y),
            Self::Bool(_) => 0.0,
        }
    }
}

/// An expression whose types and dimensions are checked. Angles are in radians; `%` is folded into the numbers.
#[derive(Clone, Debug, PartialEq)]
pub enum Expr {
    Constant(Value),
    /// (x, y).
    Vector(Box<Expr>, Box<Expr>),
    /// magnitude @ angle.
    Polar(Box<Expr>, Box<Expr>),
    /// A component of a vector.
    Component(Box<Expr>, Axis),
    /// Minus; scalars and vectors.
    Negate(Box<Expr>),
    /// Two operands: scalars, or vectors where the operation makes sense.
    Binary(BinaryOp, Box<Expr>, Box<Expr>),
    /// Raised to a power.
    Power(Box<Expr>, Box<Expr>),
    Call(Function, Vec<Expr>),
    /// A comparison of two scalars.
    Compare(Comparison, Box<Expr>, Box<Expr>),
    And(Box<Expr>, Box<Expr>),
    Or(Box<Expr>, Box<Expr>),
    Not(Box<Expr>),
    /// Another quantity of this pose.
    Quantity(QuantityId),
    Query(Query),
    /// The same without friction.
    Frictionless(Box<Expr>),
    /// Something of a curve at an argument.
    Curve(Arc<Curve>, CurvePart, Box<Expr>),
}

/// Operations on two operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BinaryOp {
    /// Sum of equal types.
    Add,
    /// Difference of equal types.
    Sub,
    /// Product; one may be a vector.
    Mul,
    /// Quotient; the numerator may be a vector.
    Div,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Comparison {
    /// <
    Less,
    /// <=
    LessEqual,
    /// >
    Greater,
    /// >=
    GreaterEqual,
}

/// Components of a vector.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    X,
    Y,
}

impl Axis {
    pub const BOTH: [Self; 2] = [Self::X, Self::Y];

    /// Its unit vector.
    #[must_use]
    pub const fn unit(self) -> Vec2 {
        match self {
            Self::X => Vec2::new(1.0, 0.0),
            Self::Y => Vec2::new(0.0, 1.0),
        }
    }

    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::X => "x",
            Self::Y => "y",
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Function {
    Sqrt,
    /// Magnitude of a scalar.
    Abs,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Exp,
    Log,
    /// Angle of (x, y) from `atan2(y, x)`.
    Atan2,
    /// Magnitude of a vector (of a scalar: `Abs`).
    Mag,
    Dot,
    /// z of the vector product.
    Cross,
    /// A vector over its magnitude.
    Unit,
    /// Angle of a vector, (−π, π].
    Direction,
    /// The greatest of two or more numbers.
    Max,
    /// The least of two or more numbers.
    Min,
}

/// A point whose motion is asked: fixed in its link, or the point of the link that lies under another link's point now.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PointRef {
    /// A point of the link, in its frame, m.
    Fixed(LinkId, Vec2),
    /// The point of the first link that lies under this point of the second.
    Under(LinkId, (LinkId, Vec2)),
}

/// A result of a pose, in SI. `LinkId` after a pair is the link the force acts on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Query {
    /// Position of a point, a vector.
    Position(PointRef),
    /// Velocity of a point, a vector.
    Velocity(PointRef),
    /// Acceleration of a point, a vector.
    Acceleration(PointRef),
    /// Third derivative of a point's position, a vector.
    Jerk(PointRef),
    /// Radius of curvature of a point's path, positive where it bends to the left, m.
    CurvatureRadius(PointRef),
    /// Its centre of curvature, a vector, m.
    CurvatureCentre(PointRef),
    /// Angle of a link's x axis, continuous over a sweep.
    Angle(LinkId),
    /// The instant of a motion under loads, s.
    Time,
    /// The instant of an event, s: index into [`super::Mechanism::events`], and which time, counted from 1.
    EventTime(usize, usize),
    /// The value of the drive at an event of a sweep, rad or m, as [`Query::EventTime`].
    EventDrive(usize, usize),
    /// How often an event happens.
    EventCount(usize),
    /// After what time a steady motion comes again, s.
    Period,
    /// Whether a motion under loads is in a state at this instant.
    In(super::Situation),
    /// Force, N, or torque, N m, of a closed stop along its coordinate: index into [`super::Mechanism::stops`].
    StopEffort(usize),
    /// Force, N, or torque, N m, of the closed stops of a pair along its coordinate, or of a contact that parts.
    StopsEffort(PairId),
    /// Impulse, N s, or angular impulse, N m s, of the stops of a pair along its coordinate, in an impact at the instant.
    Impulse(PairId),
    /// Work since the first instant, J: index into [`super::Mechanism::works`].
    Work(usize),
    /// Power of a spring between two points, W: index into [`super::Mechanism::springs`].
    SpringPower(usize),
    /// Kinetic energy of all links, J.
    KineticEnergy,
    /// Potential energy of all weights, from y = 0, and springs between points, from their free lengths, J.
    PotentialEnergy,
    /// That of a spring in a pair, from its free angle: index into [`super::Mechanism::torsion_springs`].
    TorsionEnergy(usize, PairId),
    /// Angular velocity of a link.
    Omega(LinkId),
    /// Angular velocity of a link against another; not a number where they do not turn against each other.
    Turning(LinkId, LinkId),
    /// Angular acceleration of a link.
    Alpha(LinkId),
    /// Third derivative of a link's angle.
    AngularJerk(LinkId),
    /// Direction (cos, sin) of a link's x axis.
    LinkDirection(LinkId),
    /// Coordinate of a pair.
    Displacement(PairId),
    /// First derivative of the coordinate.
    RelativeVelocity(PairId),
    /// Sliding velocity in a prismatic pair, a slot or a contact.
    Sliding(PairId),
    /// Second derivative of the coordinate.
    RelativeAcceleration(PairId),
    /// Third derivative of the coordinate.
    RelativeJerk(PairId),
    /// Coriolis acceleration in a pair, a vector: 2 ω × v_rel with ω of the line's link.
    Coriolis(PairId),
    /// Force on a link in a pair, a vector.
    Reaction(PairId, LinkId),
    /// Force along a link of two hinges, N; tension is positive.
    Axial(LinkId),
    /// A force or a moment inside a link, or a place on it.
    Internal(super::Internal),
    /// Couple on a link in a pair about the pair's reference point.
    Moment(PairId, LinkId),
    /// Part of the force on the link along the line's left normal (contacts: along the common normal into the link).
    Normal(PairId, LinkId),
    /// Friction force on the link in a pair along the line (contacts: across the common normal).
    Friction(PairId, LinkId),
    /// Power lost in a pair by friction, W, ≥ 0.
    FrictionPower(PairId),
    /// Ideal over actual effort where the balance drives, actual over ideal where it resists.
    Efficiency,
    /// Whether an equilibrium is stable.
    Stable,
    /// Of a small vibration about an equilibrium, counted from 0.
    Vibration(usize, super::ModePart),
    /// Whether the efficiency is not positive, as a condition.
    Locked,
    /// Value of a given at which locking begins: index into [`super::Mechanism::criticals`].
    Critical(usize),
    /// Force at one of two contact points of a prismatic pair (1 or 2) along the left normal, on the sliding link.
    ContactForce(PairId, u8),
    /// The point at which the resultant crosses the guide, as a coordinate of the pair.
    LineOffset(PairId),
    /// −m a_S, a vector.
    InertiaForce(LinkId),
    /// −J α.
    InertiaTorque(LinkId),
    /// |M| / |F| of the inertia load.
    InertiaArm(LinkId),
    /// Replacement of a link's mass by masses at two points (link frame, m).
    StaticSubstitution(LinkId, Vec2, Vec2, SubstitutionPart),
    /// Dynamically equal replacement, one point given (link frame, m).
    DynamicSubstitution(LinkId, Vec2, SubstitutionPart),
    /// Transmission angle of an asserted group (index into `Mechanism::groups`).
    TransmissionAngle(usize),
    /// Pressure angle of a contact, slot or prismatic pair.
    PressureAngle(PairId),
    /// Value of an unknown effort.
    Balance(BalanceId),
    /// Effort of a drive where nothing is declared to balance.
    Effort(DriveId),
    /// An applied load: a vector for a force, a scalar for a torque or a force in a pair.
    Load(LoadId),
    /// Power of an unknown effort.
    BalancePower(BalanceId),
    /// Power of an applied load.
    LoadPower(LoadId),
    /// Power of a drive's effort.
    EffortPower(DriveId),
    /// Coordinate of a pair above its least value over the drive's turn.
    Travel(PairId),
    /// Difference of the greatest and the least coordinate. Needs no pose.
    Stroke(PairId),
    /// The longer way over the shorter. Needs no pose.
    TimeRatio(PairId),
    /// Tangential force of a mesh, rack, worm or screw, or the pull of a belt or chain, N, ≥ 0: what the driven side gets, or
    /// that on this link.
    TangentialForce(PairId, Option<LinkId>),
    /// Force along the line of action of a mesh or rack, N, ≥ 0: what the driven side gets, or that on this link.
    ToothForce(PairId, Option<LinkId>),
    /// Pull in a rope, N: that of this part of it, counted from 0, at its first end (0) or at its last (1); without an end
    /// what the driven side gets.
    Tension(PairId, usize, Option<usize>),
    /// Pull in the tight side of a belt, N.
    TightSide(PairId),
    /// Pull in its slack side, N.
    SlackSide(PairId),
    /// The greatest torque of a clutch, N m, or tangential force of a belt, N.
    Capacity(PairId),
    /// Whether a clutch or a belt slips.
    Slips(PairId),
    /// Drive value where the coordinate is least (1) or greatest (2), in [0, one turn). Needs no pose.
    Dead(PairId, u8),
    /// A function over the sweep: index into [`super::Mechanism::cycles`]. Needs no pose.
    Cycle(usize),
    /// Something of a flywheel: index into [`super::Mechanism::flywheels`].
    Flywheel(usize, FlywheelPart),
}

impl Query {
    /// The pair that is asked about.
    #[must_use]
    pub const fn pair(&self) -> Option<PairId> {
        match *self {
            Self::StopsEffort(pair)
            | Self::Impulse(pair)
            | Self::Displacement(pair)
            | Self::RelativeVelocity(pair)
            | Self::Sliding(pair)
            | Self::RelativeAcceleration(pair)
            | Self::RelativeJerk(pair)
            | Self::Coriolis(pair)
            | Self::Reaction(pair, _)
            | Self::Moment(pair, _)
            | Self::Normal(pair, _)
            | Self::Friction(pair, _)
            | Self::FrictionPower(pair)
            | Self::ContactForce(pair, _)
            | Self::LineOffset(pair)
            | Self::PressureAngle(pair)
            | Self::Travel(pair)
            | Self::Stroke(pair)
            | Self::TimeRatio(pair)
            | Self::Dead(pair, _) => Some(pair),
            _ => None,
        }
    }

    /// The point whose motion is asked.
    pub const fn point_mut(&mut self) -> Option<&mut PointRef> {
        match self {
            Self::Position(p) | Self::Velocity(p) | Self::Acceleration(p) | Self::Jerk(p) => Some(p),
            Self::CurvatureRadius(p) | Self::CurvatureCentre(p) => Some(p),
            _ => None,
        }
    }
}

/// Parts of a mass substitution.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SubstitutionPart {
    /// Mass at the first point, kg.
    M1,
    /// Mass at the second point, kg.
    M2,
    /// Second point in the link's frame, m (a vector).
    P2,
    /// Distance of the second point from the mass centre, m.
    L2,
    /// Acceleration of the second point (a vector).
    A2,
    /// Inertia force of the first mass (a vector).
    F1,
    /// Inertia force of the second mass (a vector).
    F2,
    /// Moment of inertia left over: that of the link less that of the two masses, kg m².
    DJ,
}

/// A quantity with one value per pose.
#[derive(Clone, Debug)]
pub struct Quantity {
    pub name: String,
    /// Place of the name.
    pub span: Span,
    pub expr: Expr,
    /// How it is printed.
    pub display: Display,
}

impl Expr {
    #[must_use]
    pub const fn number(x: f64) -> Self {
        Self::Constant(Value::Scalar(x))
    }

    /// Calls `visit` on every result the expression asks for.
    pub fn queries(&self, visit: &mut impl FnMut(&Query)) {
        self.parts(&mut |part| {
            if let Self::Query(q) = part {
                visit(q);
            }
        });
    }

    /// Calls `visit` on the expression and all its parts.
    pub fn parts(&self, visit: &mut impl FnMut(&Self)) {
        visit(self);
        self.children(&mut |part| part.parts(visit));
    }

    /// Calls `visit` on the parts of which the expression consists, not on theirs.
    pub fn children<'e>(&'e self, visit: &mut dyn FnMut(&'e Self)) {
        match self {
            Self::Constant(_) | Self::Quantity(_) | Self::Query(_) => {}
            Self::Component(a, _)
            | Self::Negate(a)
            | Self::Not(a)
            | Self::Frictionless(a)
            | Self::Curve(_, _, a) => visit(a),
            Self::Vector(a, b)
            | Self::Polar(a, b)
            | Self::Binary(_, a, b)
            | Self::Power(a, b)
            | Self::Compare(_, a, b)
            | Self::And(a, b)
            | Self::Or(a, b) => {
                visit(a);
                visit(b);
            }
            Self::Call(_, args) => args.iter().for_each(visit),
        }
    }

    /// The same expression with each of its parts that has no parts of its own replaced.
    #[must_use]
    pub fn map_leaves(&self, replace: &mut impl FnMut(&Self) -> Self) -> Self {
        let mut boxed = |e: &Self| Box::new(e.map_leaves(replace));
        match self {
            Self::Constant(_) | Self::Quantity(_) | Self::Query(_) => replace(self),
            Self::Component(a, axis) => Self::Component(boxed(a), *axis),
            Self::Negate(a) => Self::Negate(boxed(a)),
            Self::Not(a) => Self::Not(boxed(a)),
            Self::Frictionless(a) => Self::Frictionless(boxed(a)),
            Self::Curve(curve, part, a) => Self::Curve(curve.clone(), *part, boxed(a)),
            Self::Vector(a, b) => Self::Vector(boxed(a), boxed(b)),
            Self::Polar(a, b) => Self::Polar(boxed(a), boxed(b)),
            Self::Binary(op, a, b) => Self::Binary(*op, boxed(a), boxed(b)),
            Self::Power(a, b) => Self::Power(boxed(a), boxed(b)),
            Self::Compare(op, a, b) => Self::Compare(*op, boxed(a), boxed(b)),
            Self::And(a, b) => Self::And(boxed(a), boxed(b)),
            Self::Or(a, b) => Self::Or(boxed(a), boxed(b)),
            Self::Call(f, args) => Self::Call(*f, args.iter().map(|a| a.map_leaves(replace)).collect()),
        }
    }
}
