//! Machine elements as designed, and tables of what they are.

use super::{Display, LinkId, PairId};
use crate::element::cam::Cam;
use crate::element::geneva::Geneva;
use crate::math::Vec2;
use crate::source::Span;

/// A designed plate cam.
#[derive(Clone, Debug)]
pub struct PlateCam {
    pub name: String,
    /// Place of the name.
    pub span: Span,
    pub cam: Cam,
    /// Its speed, rad/s, > 0, where given: rates of the follower by time depend on it.
    pub speed: Option<f64>,
}

/// A contact of a designed cam with the follower it was designed for. Cam and follower are joined to the same frame.
#[derive(Clone, Debug)]
pub struct CamContact {
    pub pair: PairId,
    /// The cam: index into [`super::Mechanism::cams`].
    pub cam: usize,
    /// The link that is the cam.
    pub disk: LinkId,
    /// Its centre in its frame, m.
    pub centre: Vec2,
    /// The link on which cam and follower stand.
    pub frame: LinkId,
    /// The cam's centre in the frame's axes, m.
    pub frame_centre: Vec2,
    /// Unit direction from the cam's centre towards the follower, in the frame's axes: along the way of a translating
    /// one, towards the pivot of an oscillating one.
    pub towards: Vec2,
    pub follower: LinkId,
    /// The roller, where it is a link of its own, and the pair on which it turns.
    pub roller: Option<(LinkId, PairId)>,
    /// The point of the follower that the design places, in its frame, m: knife edge, centre of the roller, a point of a
    /// translating face, the pivot of an oscillating follower.
    pub point: Vec2,
    /// For a translating follower the distance of that point to the left of the line from the cam's centre along
    /// `towards`, m.
    pub beside: f64,
    /// For a translating follower the direction of its frame that lies along `towards`, for an oscillating one the
    /// direction of its frame from the pivot along its arm or face.
    pub direction: Vec2,
    /// The face in the follower's frame: a point, m, and a unit direction; `None` for knife edge and roller.
    pub face: Option<(Vec2, Vec2)>,
    /// The knife edge or the centre of the roller in the follower's frame, m; zero for a face.
    pub tip: Vec2,
}

/// A table of numbers that needs no pose.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    /// One entry per column (per row where `upright`).
    pub entries: Vec<TableEntry>,
    /// Few values with many names: the entries are printed below each other.
    pub upright: bool,
}

/// One kind of number in a table.
#[derive(Clone, Debug, PartialEq)]
pub struct TableEntry {
    pub name: String,
    /// How it is printed.
    pub display: Display,
    /// Its values, SI; not a number where there is none.
    pub values: Vec<f64>,
}

/// A pin in the slots of a Geneva wheel. Crank and wheel are hinged to the same frame.
#[derive(Clone, Copy, Debug)]
pub struct GenevaPair {
    /// The pair: a slot.
    pub pair: PairId,
    /// The law of the wheel.
    pub law: Geneva,
    /// The link with the pin.
    pub crank: LinkId,
    /// The pin in the crank's frame, m.
    pub pin: Vec2,
    /// The crank's centre in its frame, m.
    pub crank_centre: Vec2,
    /// Unit direction from that centre to the pin, in the crank's frame.
    pub arm: Vec2,
    /// The link with the slots.
    pub wheel: LinkId,
    /// Its centre in its frame, m.
    pub hub: Vec2,
    /// Unit direction of the named slot from that centre outwards, in the wheel's frame.
    pub slot: Vec2,
    /// The link on which both turn.
    pub frame: LinkId,
    /// The wheel's centre in the frame's axes, m.
    pub frame_hub: Vec2,
    /// Unit direction from the crank's centre to the wheel's, in the frame's axes.
    pub towards: Vec2,
}
