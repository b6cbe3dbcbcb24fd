//! The mechanism as plain data: SI units, radians, typed ids. The result of `check`, before any
//! structure is found.

mod bar;
mod cam_part;
mod display;
mod element;
mod expr;
mod facts;
mod id;
mod internal;
mod link;
mod load;
mod motion;
mod numbers;
mod pair;
mod request;
mod simulation;
mod train;

pub use bar::Bar;
pub use cam_part::{CAM_PARTS, CamPart};
pub use display::Display;
pub use display::Spacing;
pub use element::{CamContact, GenevaPair, PlateCam, Table, TableEntry};
pub use element::{Curve, CurvePart, FormulaCall, FormulaFunction};
pub use element::{Flywheel, FlywheelPart, FlywheelTorque, Rim};
pub use expr::{
    Axis, BinaryOp, Comparison, Expr, Function, PointRef, Quantity, Query, SubstitutionPart, Value,
};
pub use facts::{About, Answer, Facts, Level};
pub use id::{BalanceId, DriveId, LinkId, LoadId, PairId, QuantityId, SpringId};
pub use internal::{AlongLink, Cut, Internal, InternalPart};
pub use link::{CamProfile, Circle, Counterweight, Line, Link, MassPart, MassProperties, MassShape, Point};
pub use load::{Balance, BalanceKind, Gravity, Load, LoadKind, Place, Spread, Spring, TorsionSpring};
pub use motion::{
    Drive, DriveTarget, Equilibrium, Hint, HintKind, LinkPoint, Mode, ModePart, NamedPose, Positions, Sought,
    SoughtWay,
};
pub use pair::{
    Bearing, Friction, Guide, MoreFriction, Pair, PairKind, Pin, Profile, ProfileShape, StatedFriction,
    UnilateralCondition,
};
pub use request::{At, Expect, Find, FindKind, Relation, Tolerance, Unsupported};
pub use simulation::{Bound, Cycle, CycleFunction, Harmonic, Part};
pub use simulation::{Event, Occasion, Simulation, Situation, Steady, Stop};
pub use train::{
    Bevel, FrictionLimit, Gears, Law, Meeting, OpenSize, Rate, Transmission, TransmissionKind, Wheel,
    counts_from_carrier,
};

use crate::math::Vec2;
use crate::source::Span;

/// A checked mechanism: every name resolved, every number in SI, every expression typed.
#[derive(Clone, Debug, Default)]
pub struct Mechanism {
    /// The title, empty if the file has none.
    pub title: String,
    /// The problem's text: the comment lines below the title.
    pub notes: Vec<String>,
    /// All links; the first is the ground.
    pub links: Vec<Link>,
    /// All pairs as declared; a pin in several links is one of them.
    pub pairs: Vec<Pair>,
    pub wheels: Vec<Wheel>,
    /// Wheels in mesh, as far as teeth and modules are given.
    pub gears: Vec<Gears>,
    /// Sizes that are not given, and assumed.
    pub open_sizes: Vec<OpenSize>,
    pub groups: Vec<GroupAssertion>,
    pub drives: Vec<Drive>,
    /// Motion under given loads, from the positions and speeds of the drives that are starts.
    pub simulation: Option<Simulation>,
    /// Its events and ends, or those of the sweep.
    pub events: Vec<Event>,
    /// Friction at rest, of pairs in which it is more than that of the motion.
    pub friction_at_rest: Vec<(PairId, Friction)>,
    /// Coefficients as they are given, where the law of the pair has a greater one.
    pub stated_friction: Vec<(PairId, StatedFriction)>,
    /// Powers whose work since the first instant is asked for.
    pub works: Vec<Expr>,
    /// What springs in pairs store, in the order of their statements.
    pub torsion_springs: Vec<TorsionSpring>,
    /// Bounds of coordinates in the motion.
    pub stops: Vec<Stop>,
    /// Starts that no statement gives: contacts that part are closed instead, at the first instant.
    pub touching: Vec<usize>,
    /// Poses in addition to those of the sweep.
    pub poses: Vec<NamedPose>,
    /// The positions of equilibrium, where they are sought and found: one per position of the sweep.
    pub equilibria: Vec<Equilibrium>,
    /// Small vibrations about them are asked for.
    pub vibrates: bool,
    /// The clauses of `assemble`.
    pub hints: Vec<Hint>,
    /// The acceleration of free fall, where declared.
    pub gravity: Option<Gravity>,
    /// Applied forces and torques.
    pub loads: Vec<Load>,
    pub springs: Vec<Spring>,
    pub balances: Vec<Balance>,
    pub cams: Vec<PlateCam>,
    /// Formulas of bearings, belts and screws.
    pub formulas: Vec<FormulaCall>,
    /// Their contacts with followers.
    pub cam_contacts: Vec<CamContact>,
    /// Pins in the slots of Geneva wheels.
    pub genevas: Vec<GenevaPair>,
    /// The file contains `ignore inertia`.
    pub ignore_inertia: bool,
    /// Quantities with one value per pose: `let` from results and named items of `find`.
    pub quantities: Vec<Quantity>,
    pub finds: Vec<Find>,
    /// The questions among them that `find powers` asks: from which one on, and up to which.
    pub powers: Option<(usize, usize)>,
    /// The expectations of the answer key.
    pub expects: Vec<Expect>,
    /// Whether anything names a curve: then every position is looked at for one that is left.
    pub has_curves: bool,
    /// Links of two hinges whose axial force is asked for.
    pub bars: Vec<Bar>,
    /// Functions over the sweep, each after those it depends on.
    pub cycles: Vec<Cycle>,
    /// Flywheels that are to be found.
    pub flywheels: Vec<Flywheel>,
    pub counterweights: Vec<Counterweight>,
    /// Constructs that are understood but cannot be solved yet.
    pub unsupported: Vec<Unsupported>,
    /// Givens whose critical value is asked for.
    pub criticals: Vec<String>,
    /// The unit the file uses most for a dimension, in which results without a unit of their own are printed.
    pub displays: Vec<Display>,
    /// Given and derived values that need no pose, in the order of the file: name, SI value, display.
    pub values: Vec<NamedValue>,
}

/// `group NAME: a, b`: these links are asserted to be one structural group.
#[derive(Clone, Debug)]
pub struct GroupAssertion {
    /// Name and its span.
    pub name: String,
    /// Span of the statement.
    pub span: Span,
    pub links: Vec<LinkId>,
}

/// A `given` or `let` with its value.
#[derive(Clone, Debug)]
pub struct NamedValue {
    pub name: String,
    pub value: Value,
    /// How to print it.
    pub display: Display,
    /// It is a `given`; a `let` is derived.
    pub given: bool,
}

impl Mechanism {
    /// The link with this id.
    #[must_use]
    pub fn link(&self, id: LinkId) -> &Link {
        &self.links[id.index()]
    }

    /// The first drive that goes through a range.
    #[must_use]
    pub fn swept_drive(&self) -> Option<usize> {
        self.drives.iter().position(|drive| matches!(drive.positions, Positions::Range { .. }))
    }

    /// Whether its answers need other solutions of the same text: with other values of a `given`, or with other sizes of
    /// wheels that are left open.
    #[must_use]
    pub fn asks_again(&self) -> bool {
        !self.criticals.is_empty() || !self.open_sizes.is_empty() || self.seeks_equilibrium()
    }

    /// Whether the position of a drive is to be found from the loads.
    #[must_use]
    pub fn seeks_equilibrium(&self) -> bool {
        self.drives.iter().any(|drive| drive.sought.is_some())
    }

    /// Whether a law moves the links of a pair, and not the joints that stand for it: a designed cam, or a Geneva wheel.
    #[must_use]
    pub fn is_by_law(&self, pair: PairId) -> bool {
        self.cam_contacts.iter().any(|c| c.pair == pair) || self.genevas.iter().any(|g| g.pair == pair)
    }

    /// Whether the file gives a place in the plane: none to a shaft without `at`, and to a slider on a rope.
    #[must_use]
    pub fn is_placed(&self, link: LinkId) -> bool {
        !self.pairs.iter().any(|p| {
            let moved = match &p.kind {
                PairKind::Revolute(pins) => pins.last().map(|pin| pin.link),
                PairKind::Prismatic(guide) => Some(guide.slider),
                _ => None,
            };
            p.bearing == Some(Bearing::Open) && moved == Some(link)
        })
    }

    /// The point of a link at which a pin or a slot holds it, m.
    #[must_use]
    pub fn point_in(&self, pair: PairId, link: LinkId) -> Option<Vec2> {
        match &self.pair(pair).kind {
            PairKind::Revolute(pins) => pins.iter().find(|pin| pin.link == link).map(|pin| pin.at),
            PairKind::Slot(slot) if slot.slider == link => Some(slot.point),
            _ => None,
        }
    }

    /// The pair with this id.
    #[must_use]
    pub fn pair(&self, id: PairId) -> &Pair {
        &self.pairs[id.index()]
    }
}
