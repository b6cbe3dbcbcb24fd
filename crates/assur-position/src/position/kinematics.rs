//! Motion at one position: what the drives say, and how the bodies move.

use super::against::Against;
use super::body::BodyState;
use super::grip::ContactMode;
use crate::element::cam::Part;
use crate::math::{Scalar, V2, Vec2};
use crate::plan::Plan;

/// What a drive says at one position.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DriveInput<S = f64> {
    /// Direction of a driven angle; place of a driven point, m.
    pub place: V2<S>,
    /// Driven coordinate, m or rad.
    pub value: S,
    /// Speed, rad/s or m/s.
    pub rate: S,
    pub acceleration: S,
    pub jerk: S,
    /// Velocity of a driven point, m/s.
    pub velocity: V2<S>,
    /// Acceleration of a driven point, m/s².
    pub point_acceleration: V2<S>,
    /// Jerk of a driven point, m/s³.
    pub point_jerk: V2<S>,
}

impl<S: Scalar> DriveInput<S> {
    /// The coordinate's derivatives.
    pub(super) const fn rates(&self) -> [S; 3] {
        [self.rate, self.acceleration, self.jerk]
    }

    /// A derivative, from the first on, of a driven point's place.
    #[must_use]
    pub const fn rate_of_point(&self, order: usize) -> V2<S> {
        match order {
            1 => self.velocity,
            2 => self.point_acceleration,
            _ => self.point_jerk,
        }
    }

    /// The same in other numbers.
    pub(super) fn map<T>(&self, f: impl Fn(S) -> T) -> DriveInput<T> {
        let of = |v: V2<S>| V2 { x: f(v.x), y: f(v.y) };
        DriveInput {
            place: of(self.place),
            value: f(self.value),
            rate: f(self.rate),
            acceleration: f(self.acceleration),
            jerk: f(self.jerk),
            velocity: of(self.velocity),
            point_acceleration: of(self.point_acceleration),
            point_jerk: of(self.point_jerk),
        }
    }
}

/// What a dyad RRR or RRP of motion leaves for forces.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Shared<S> {
    /// C − A, m.
    pub r_1: V2<S>,
    /// C − B, m, or the direction of the guide.
    pub second: V2<S>,
    /// The reciprocal of the group's determinant.
    pub inverse: S,
}

/// How the bodies move at one position, or at several side by side.
#[derive(Clone, Debug, Default)]
pub struct Motion<S = f64> {
    pub inputs: Vec<DriveInput<S>>,
    /// Bodies, the ground first.
    pub bodies: Vec<BodyState<S>>,
    /// Signed condition figures of the groups; of a single body that a drive moves it stays 1.
    pub conditions: Vec<S>,
    /// Figures h of Newton and Kantorovich of the groups that are solved by iteration: at most 1/2 where the position is
    /// certified.
    pub certificates: Vec<f64>,
    /// Where designed cams touch their followers, by contact: place, m, and unit common normal into the follower.
    pub touches: Vec<(Vec2, Vec2)>,
    /// The instant of a motion under loads, s.
    pub time: f64,
    /// The work of all loads since the first instant of such a motion, J.
    pub work: f64,
    /// Works that are asked for, since then, J.
    pub works: Vec<f64>,
    /// Efforts of closed stops along their coordinates, N or N m.
    pub stops: Vec<f64>,
    /// Impulses of stops along their coordinates, in an impact at this instant, N s or N m s.
    pub impulses: Vec<f64>,
    /// On which sides of lines contacts that part stand, by stop: 1 or -1, and 0 of all else.
    pub sides: Vec<f64>,
    /// How the elements of friction move there, where such a motion says it.
    pub grips: Vec<ContactMode>,
    /// How the loads against the motion act there, where such a motion says it: by load.
    pub against: Vec<Against>,
    /// The parts of laws by which designed cams are taken there, beyond their ends too, by contact.
    pub laws: Vec<Option<Part>>,
    /// The first group that does not close.
    pub open: Option<usize>,
    /// What the dyads RRR and RRP leave for forces.
    pub(super) shared: Vec<Shared<S>>,
}

impl<S: Scalar + Default> Motion<S> {
    pub(super) fn at_rest(plan: &Plan) -> Self {
        let groups = plan.motion.len();
        let mut bodies = vec![BodyState::rest(); plan.bodies];
        for step in &plan.genevas {
            // a wheel that has no place yet
            bodies[step.pair.wheel.index()].u = V2::zero();
        }
        Self {
            inputs: vec![DriveInput::default(); plan.drives],
            bodies,
            conditions: vec![S::one(); groups],
            certificates: vec![0.0; groups],
            touches: vec![(Vec2::zero(), Vec2::new(1.0, 0.0)); plan.cam_contacts],
            time: 0.0,
            work: 0.0,
            works: Vec::new(),
            stops: Vec::new(),
            impulses: Vec::new(),
            sides: Vec::new(),
            grips: Vec::new(),
            against: Vec::new(),
            laws: Vec::new(),
            open: None,
            shared: vec![Shared::default(); groups],
        }
    }
}

impl Motion {
    /// Takes over all of another one, in the memory that is there.
    pub(super) fn copy(&mut self, other: &Self) {
        let Self {
            inputs,
            bodies,
            conditions,
            certificates,
            touches,
            time,
            work,
            works,
            stops,
            impulses,
            sides,
            grips,
            against,
            laws,
            open,
            shared,
        } = other;
        self.inputs.clone_from(inputs);
        self.bodies.clone_from(bodies);
        self.conditions.clone_from(conditions);
        self.certificates.clone_from(certificates);
        self.touches.clone_from(touches);
        (self.time, self.work, self.open) = (*time, *work, *open);
        self.works.clone_from(works);
        self.stops.clone_from(stops);
        self.impulses.clone_from(impulses);
        self.sides.clone_from(sides);
        self.grips.clone_from(grips);
        self.against.clone_from(against);
        self.laws.clone_from(laws);
        self.shared.clone_from(shared);
    }

    /// Takes over what the next position starts from, of the same plan.
    pub(super) fn start_from(&mut self, other: &Self) {
        self.bodies.clone_from(&other.bodies);
        self.conditions.clone_from(&other.conditions);
        self.certificates.clone_from(&other.certificates);
        self.touches.clone_from(&other.touches);
        self.open = other.open;
    }
}
