//! Wheels, and what runs between wheels and sliders: laws between rates with constant coefficients.

use super::{LinkId, PairId};
use crate::element::gear::GearPair;
use crate::math::Vec2;
use crate::source::Span;
use assur_text::language::JointKind;

/// A wheel of a link.
#[derive(Clone, Debug)]
pub struct Wheel {
    pub name: String,
    /// Place of the name.
    pub span: Span,
    /// The link it belongs to.
    pub link: LinkId,
    /// Its axis in the link's frame, m; `None` on a shaft whose place is left open.
    pub centre: Option<Vec2>,
    /// Radius, of a gear wheel that of its pitch circle, m. Where it is not given it is assumed, see [`OpenSize`].
    pub radius: f64,
    /// The radius depends on a size that is assumed: by teeth alone only ratios of radii are known.
    pub open: bool,
    pub teeth: Option<f64>,
}

/// Two wheels with teeth in mesh whose geometry is known.
#[derive(Clone, Debug)]
pub struct Gears {
    /// The name of the mesh.
    pub mesh: String,
    /// Their names, the pinion's first.
    pub wheels: [String; 2],
    pub pair: GearPair,
}

/// A size that the file leaves open and that is assumed: no answer may depend on it.
#[derive(Clone, Debug, PartialEq)]
pub struct OpenSize {
    pub wheel: String,
    pub span: Span,
    /// The number of teeth is known, and the module is not.
    pub teeth: bool,
}

/// A variable of a law.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rate {
    /// Angular velocity of a link.
    Turn(LinkId),
    /// Rate of a prismatic pair's coordinate.
    Slide(PairId),
}

/// Σ coefficient × rate = 0, and Σ coefficient × coordinate = `constant`. The generalized force on each rate is the multiplier times its coefficient.
#[derive(Clone, Debug, PartialEq)]
pub struct Law {
    /// The rates with their coefficients, m for rad/s and 1 for m/s (or both over a common length). Of a law with an
    /// efficiency the two sides come first, the carrier that they are counted from third.
    pub terms: Vec<(Rate, f64)>,
    /// What the coordinates add up to: nothing where all are zero together.
    pub constant: f64,
    /// The tangential force, or the pull of the rope, is the multiplier times this.
    pub force: f64,
    /// Part of the power that gets through, from the first side to the second and back.
    pub efficiency: Option<[f64; 2]>,
}

/// Whether a side of a law counts from the carrier. A second side that does not turns relative to it already, as a bevel planet: the
/// carrier's coefficient is that of the first side alone.
#[must_use]
pub fn counts_from_carrier<T>(terms: &[(T, f64)], side: usize) -> bool {
    matches!(terms, [first, _, carrier] if side == 0 || carrier.1 != -first.1)
}

/// A transmission between wheels, shafts and sliders.
#[derive(Clone, Debug, PartialEq)]
pub struct Transmission {
    pub kind: TransmissionKind,
    /// The ends, as written: `w1`, `over(C)`.
    pub ends: Vec<String>,
    /// The links joined, in the order written.
    pub links: Vec<LinkId>,
    /// Its laws: one; of a rope one for each part between wheels that it does not slip on; none of a clutch that slips.
    pub laws: Vec<Law>,
    /// The two wheels that meet, where the places of their axes and the pressure angle are known.
    pub meeting: Option<Meeting>,
    /// Wheels whose axes meet.
    pub bevel: Option<Bevel>,
    /// Pressure angle, rad.
    pub pressure_angle: Option<f64>,
    /// What friction alone can transmit.
    pub grip: Option<FrictionLimit>,
    /// The part of the speed that a belt loses, with its first wheel driving.
    pub slip: f64,
    /// The sense, ±1, in which the second side of a clutch may turn ahead of the first; 0 where it may not.
    pub freewheel: f64,
}

/// On which side of its planet a bevel wheel is: those on both sides turn in opposite senses, seen from the carrier.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bevel {
    Near,
    Far,
}

/// What a transmission by friction can transmit before it slips.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FrictionLimit {
    Belt {
        /// Angle of contact on the smaller pulley, rad.
        wrap: f64,
        /// Ratio of the pulls T₁/T₂ at which it slips.
        ratio: f64,
        /// Half the angle of its V-groove, rad.
        groove: Option<f64>,
        /// Pull on both sides at rest, N.
        pretension: Option<f64>,
    },
    /// The greatest torque of a clutch, N m; NaN where it depends on the instant.
    Clutch(f64),
}

impl FrictionLimit {
    /// The greatest torque of a clutch, N m, or the greatest tangential force of a belt at its pretension T₀,
    /// 2 T₀ (m − 1)/(m + 1) with the ratio m of the pulls at which it slips, N; NaN without a pretension.
    #[must_use]
    pub fn capacity(self) -> f64 {
        match self {
            Self::Belt { ratio, pretension: Some(at_rest), .. } => {
                2.0 * at_rest * ((ratio - 1.0) / (ratio + 1.0))
            }
            Self::Belt { pretension: None, .. } => f64::NAN,
            Self::Clutch(torque) => torque,
        }
    }
}

/// The kinds of transmission.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TransmissionKind {
    Mesh,
    Rope,
    Belt,
    Chain,
    /// A gear wheel on a toothed line.
    Rack,
    /// A worm and its wheel.
    Worm,
    /// A spindle and its nut.
    Screw,
    /// A clutch between two shafts.
    Clutch,
}

/// Two wheels whose teeth meet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Meeting {
    pub links: [LinkId; 2],
    /// The axes in the frames of the links, m.
    pub centres: [Vec2; 2],
    /// Pitch radii, m.
    pub radii: [f64; 2],
    /// One wheel lies within the other.
    pub internal: bool,
    /// Tangent of the pressure angle.
    pub tangent: f64,
}

impl Transmission {
    /// The two sides of a clutch that slips: friction alone joins them, by a load against their relative motion.
    #[must_use]
    pub fn slipping(&self) -> Option<[LinkId; 2]> {
        let slips = self.kind == TransmissionKind::Clutch && self.laws.is_empty();
        self.links.as_slice().try_into().ok().filter(|_| slips)
    }

    /// The planet of a mesh of bevel wheels, and its carrier.
    #[must_use]
    pub fn bevel_planet(&self) -> Option<(LinkId, LinkId)> {
        self.bevel?;
        let [_, planet, carrier] = self.laws.first()?.terms.as_slice() else { return None };
        Some((planet.0.turning()?, carrier.0.turning()?))
    }
}

impl TransmissionKind {
    /// The kind of its statement.
    #[must_use]
    pub const fn statement(self) -> JointKind {
        match self {
            Self::Mesh => JointKind::Mesh,
            Self::Rope => JointKind::Rope,
            Self::Belt => JointKind::Belt,
            Self::Chain => JointKind::Chain,
            Self::Rack => JointKind::Rack,
            Self::Worm => JointKind::Worm,
            Self::Screw => JointKind::Screw,
            Self::Clutch => JointKind::Clutch,
        }
    }

    #[must_use]
    pub const fn word(self) -> &'static str {
        self.statement().word()
    }

    /// Its kind, with its article.
    #[must_use]
    pub const fn phrase(self) -> &'static str {
        match self {
            Self::Mesh => "a mesh",
            Self::Rope => "a rope",
            Self::Belt => "a belt",
            Self::Chain => "a chain",
            Self::Rack => "a rack",
            Self::Worm => "a worm",
            Self::Screw => "a screw",
            Self::Clutch => "a clutch",
        }
    }
}

impl Rate {
    /// The link that turns.
    #[must_use]
    pub const fn turning(self) -> Option<LinkId> {
        match self {
            Self::Turn(link) => Some(link),
            Self::Slide(_) => None,
        }
    }
}
