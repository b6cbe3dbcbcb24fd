//! Everything that changes from position to position, laid out once before the loop.

use super::friction::RubbingWork;
use super::general::Workspace;
use crate::math::Vec2;
use crate::plan::{ForceStep, Plan};

/// Motion of a body: its origin and direction with their derivatives, in ground axes.
#[derive(Clone, Copy, Debug)]
pub struct BodyState {
    /// Origin of its frame, m.
    pub p: Vec2,
    /// Direction (cos, sin) of its x axis.
    pub u: Vec2,
    /// Velocity of the origin, m/s.
    pub v: Vec2,
    /// Angular velocity, rad/s.
    pub omega: f64,
    /// Acceleration of the origin, m/s².
    pub a: Vec2,
    /// Angular acceleration, rad/s².
    pub alpha: f64,
}

impl BodyState {
    /// At rest in the ground's frame.
    pub const REST: Self = Self {
        p: Vec2::new(0.0, 0.0),
        u: Vec2::new(1.0, 0.0),
        v: Vec2::new(0.0, 0.0),
        omega: 0.0,
        a: Vec2::new(0.0, 0.0),
        alpha: 0.0,
    };

    /// Position of a point of the body, m.
    #[inline(always)]
    #[must_use]
    pub fn position(&self, at: Vec2) -> Vec2 {
        self.p + at.turned(self.u)
    }

    /// Velocity of a point of the body, m/s.
    #[inline(always)]
    #[must_use]
    pub fn velocity(&self, at: Vec2) -> Vec2 {
        self.v + at.turned(self.u).perp() * self.omega
    }

    /// Acceleration of a point of the body, m/s².
    #[inline(always)]
    #[must_use]
    pub fn acceleration(&self, at: Vec2) -> Vec2 {
        let r = at.turned(self.u);
        self.a + r.perp() * self.alpha - r * (self.omega * self.omega)
    }
}

/// What a drive says at one position.
#[derive(Clone, Copy, Debug, Default)]
pub struct DriveInput {
    /// Direction of a driven angle; place of a driven point, m.
    pub place: Vec2,
    /// Driven coordinate, m or rad.
    pub value: f64,
    /// Speed, rad/s or m/s.
    pub rate: f64,
    /// Acceleration.
    pub acceleration: f64,
    /// Velocity of a driven point, m/s.
    pub velocity: Vec2,
    /// Acceleration of a driven point, m/s².
    pub point_acceleration: Vec2,
}

/// The assembly of a group: kept over a sweep.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Branch {
    /// Sign of the root, ±1.
    pub root: f64,
    /// On which side of a line a round profile lies, per prismatic joint, ±1.
    pub sides: [f64; 2],
    /// The same for a general group, one bit per round profile.
    pub general_sides: u32,
}

impl Branch {
    /// The first assembly.
    pub const FIRST: Self = Self { root: 1.0, sides: [1.0, 1.0], general_sides: 0 };
}

/// A force and a moment on a body.
#[derive(Clone, Copy, Debug, Default)]
pub struct Wrench {
    /// Force, N.
    pub force: Vec2,
    /// Moment about the origin of the body's frame, N m.
    pub moment: f64,
}

/// The reaction in a joint, on the joint's `body`.
#[derive(Clone, Copy, Debug, Default)]
pub struct Reaction {
    /// Force, N.
    pub force: Vec2,
    /// Couple about the joint's reference point, N m.
    pub couple: f64,
}

/// The state of one position.
#[derive(Clone, Debug)]
pub struct State {
    /// Bodies, the ground first.
    pub bodies: Vec<BodyState>,
    /// Drives.
    pub inputs: Vec<DriveInput>,
    /// Assemblies of the groups of motion.
    pub branches: Vec<Branch>,
    /// Signed condition figures of the groups of motion.
    pub sines: Vec<f64>,
    /// Figures h of Newton and Kantorovich of the groups of motion that are solved by iteration: at most 1/2 where the
    /// position is certified.
    pub certificates: Vec<f64>,
    /// The first group that does not close.
    pub open: Option<usize>,
    /// Loads on the bodies before reactions are added, kept for the residuals.
    pub applied: Vec<Wrench>,
    /// Loads, to which the steps of forces add the reactions found so far.
    pub wrenches: Vec<Wrench>,
    /// Reactions by slot.
    pub reactions: Vec<Reaction>,
    /// Unknown efforts.
    pub efforts: Vec<f64>,
    /// Lines of unknown forces: point and unit direction in ground axes.
    pub lines: Vec<(Vec2, Vec2)>,
    /// Condition figures of the groups of forces.
    pub force_sines: Vec<f64>,
    /// Efforts of friction, by element: torque or force on the element's body.
    pub frictions: Vec<f64>,
    /// Senses of the relative motions, by element: ±1, or 0 where there is none.
    pub senses: Vec<f64>,
    /// Friction admits no motion: reactions and efforts do not exist.
    pub locked: bool,
    /// Memory of the groups with friction, by step of forces.
    pub rubbing_work: Vec<Option<RubbingWork>>,
    /// Memory of the general groups of motion.
    pub motion_work: Vec<Option<Workspace>>,
    /// Memory of the general groups of forces.
    pub force_work: Vec<Option<Workspace>>,
}

impl State {
    /// A state for a plan, at rest.
    #[must_use]
    pub fn new(plan: &Plan) -> Self {
        Self {
            bodies: vec![BodyState::REST; plan.bodies],
            inputs: vec![DriveInput::default(); plan.drives],
            branches: vec![Branch::FIRST; plan.motion.len()],
            sines: vec![1.0; plan.motion.len()],
            certificates: vec![0.0; plan.motion.len()],
            open: None,
            applied: vec![Wrench::default(); plan.bodies],
            wrenches: vec![Wrench::default(); plan.bodies],
            reactions: vec![Reaction::default(); plan.reactions.len()],
            efforts: vec![0.0; plan.efforts],
            lines: vec![(Vec2::zero(), Vec2::new(1.0, 0.0)); plan.efforts],
            force_sines: vec![1.0; plan.forces.len()],
            frictions: vec![0.0; plan.friction.len()],
            senses: vec![0.0; plan.friction.len()],
            locked: false,
            rubbing_work: plan
                .forces
                .iter()
                .map(|step| match step {
                    ForceStep::Rubbing { group, .. } => Some(RubbingWork::new(group)),
                    _ => None,
                })
                .collect(),
            motion_work: plan
                .general
                .iter()
                .map(|g| g.equations.as_ref().map(|e| Workspace::new(e, g.bodies.len(), g.moving)))
                .collect(),
            force_work: plan
                .balance_systems
                .iter()
                .map(|g| g.equations.as_ref().map(|e| Workspace::new(e, g.bodies.len(), g.moving)))
                .collect(),
        }
    }
}
