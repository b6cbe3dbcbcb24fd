//! Everything that changes from position to position, laid out once before the loop.

use super::consistent::{Consistent, Searched};
use super::friction::RubbingWork;
use super::general::Workspace;
use super::train::LawForce;
use super::train_forces::TrainWork;
use crate::group::general::General;
use crate::math::{Scalar, V2, Vec2};
use crate::plan::{Arm, ForceStep, Plan};

/// Motion of a body: its origin and direction with their derivatives, in ground axes.
#[derive(Clone, Copy, Debug)]
pub struct BodyState<S = f64> {
    /// Origin of its frame, m.
    pub p: V2<S>,
    /// Direction (cos, sin) of its x axis.
    pub u: V2<S>,
    /// Velocity of the origin, m/s.
    pub v: V2<S>,
    /// Angular velocity, rad/s.
    pub omega: S,
    /// Acceleration of the origin, m/s².
    pub a: V2<S>,
    /// Angular acceleration, rad/s².
    pub alpha: S,
    /// Angle of a body that a drive or a train turns, whole turns included, rad.
    pub way: S,
}

impl<S: Scalar> BodyState<S> {
    /// At rest in the ground's frame.
    #[must_use]
    pub fn rest() -> Self {
        let (zero, none) = (S::zero(), V2::zero());
        Self { p: none, u: V2::new(S::one(), zero), v: none, omega: zero, a: none, alpha: zero, way: zero }
    }

    /// Position of a point of the body, m.
    #[inline(always)]
    #[must_use]
    pub fn position(&self, at: Vec2) -> V2<S> {
        self.p + V2::of(at).turned(self.u)
    }

    /// Position of a pin, m, and its arm from the origin in ground axes where it has one.
    #[inline(always)]
    pub(super) fn pin(&self, pin: &Arm) -> (V2<S>, Option<V2<S>>) {
        match pin {
            None => (self.p, None),
            Some(at) => {
                let r = V2::of(*at).turned(self.u);
                (self.p + r, Some(r))
            }
        }
    }

    /// Velocity of a point of the body, m/s.
    #[inline(always)]
    #[must_use]
    pub fn velocity(&self, at: Vec2) -> V2<S> {
        self.v + V2::of(at).turned(self.u).perp() * self.omega
    }

    /// Acceleration of a point of the body, m/s².
    #[inline(always)]
    #[must_use]
    pub fn acceleration(&self, at: Vec2) -> V2<S> {
        let r = V2::of(at).turned(self.u);
        self.a + r.perp() * self.alpha - r * (self.omega * self.omega)
    }
}

/// What a drive says at one position.
#[derive(Clone, Copy, Debug, Default)]
pub struct DriveInput<S = f64> {
    /// Direction of a driven angle; place of a driven point, m.
    pub place: V2<S>,
    /// Driven coordinate, m or rad.
    pub value: S,
    /// Speed, rad/s or m/s.
    pub rate: S,
    /// Acceleration.
    pub acceleration: S,
    /// Velocity of a driven point, m/s.
    pub velocity: V2<S>,
    /// Acceleration of a driven point, m/s².
    pub point_acceleration: V2<S>,
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
pub struct Wrench<S = f64> {
    /// Force, N.
    pub force: V2<S>,
    /// Moment about the origin of the body's frame, N m.
    pub moment: S,
}

/// The reaction in a joint, on the joint's `body`.
#[derive(Clone, Copy, Debug, Default)]
pub struct Reaction<S = f64> {
    /// Force, N.
    pub force: V2<S>,
    /// Couple about the joint's reference point, N m.
    pub couple: S,
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

/// The state of one position, or of several side by side.
#[derive(Clone, Debug, Default)]
pub struct State<S = f64> {
    /// Bodies, the ground first.
    pub bodies: Vec<BodyState<S>>,
    /// Drives.
    pub inputs: Vec<DriveInput<S>>,
    /// Assemblies of the groups of motion.
    pub branches: Vec<Branch>,
    /// Signed condition figures of the groups of motion; of a single body that a drive moves it stays 1.
    pub sines: Vec<S>,
    /// Figures h of Newton and Kantorovich of the groups of motion that are solved by iteration: at most 1/2 where the
    /// position is certified.
    pub certificates: Vec<f64>,
    /// Where designed cams touch their followers, by contact: place, m, and unit common normal into the follower.
    pub touches: Vec<(Vec2, Vec2)>,
    /// The first group that does not close.
    pub open: Option<usize>,
    /// What the dyads RRR and RRP of motion leave for forces.
    pub(super) shared: Vec<Shared<S>>,
    /// Loads on the bodies before reactions are added, kept for the residuals.
    pub applied: Vec<Wrench<S>>,
    /// Loads, to which the steps of forces add the reactions found so far.
    pub wrenches: Vec<Wrench<S>>,
    /// Reactions by slot.
    pub reactions: Vec<Reaction<S>>,
    /// Unknown efforts.
    pub efforts: Vec<S>,
    /// Lines of unknown forces: point and unit direction in ground axes.
    pub lines: Vec<(V2<S>, V2<S>)>,
    /// Condition figures of the groups of forces.
    pub force_sines: Vec<S>,
    /// Efforts of friction, by element: torque or force on the element's body.
    pub frictions: Vec<f64>,
    /// Senses of the relative motions, by element: ±1, or 0 where there is none.
    pub senses: Vec<f64>,
    /// Friction admits no motion: reactions and efforts do not exist.
    pub locked: bool,
    /// How many states of the forces satisfy the laws of friction and of losses.
    pub consistent: Consistent,
    /// What searches for them have taken.
    pub searched: Searched,
    /// Loads before the first reaction was added, where there is friction.
    pub(super) loads_before: Vec<Wrench<S>>,
    /// What the laws of transmissions do.
    pub law_forces: Vec<LawForce>,
    /// Memory of the train groups of forces.
    pub train_work: Vec<TrainWork>,
    /// Memory of the groups with friction, by step of forces; nothing where nothing rubs.
    pub rubbing_work: Vec<Option<RubbingWork>>,
    /// Memory of the general groups of motion.
    pub motion_work: Vec<Option<Workspace>>,
    /// Memory of the general groups of forces.
    pub force_work: Vec<Option<Workspace>>,
}

impl<S: Scalar + Default> State<S> {
    /// A state for the closed forms of a plan, at rest.
    #[must_use]
    pub fn closed(plan: &Plan) -> Self {
        Self {
            bodies: vec![BodyState::rest(); plan.bodies],
            inputs: vec![DriveInput::default(); plan.drives],
            branches: vec![Branch::FIRST; plan.motion.len()],
            sines: vec![S::one(); plan.motion.len()],
            certificates: vec![0.0; plan.motion.len()],
            touches: vec![(Vec2::zero(), Vec2::new(1.0, 0.0)); plan.cam_contacts],
            open: None,
            shared: vec![Shared::default(); plan.motion.len()],
            applied: vec![Wrench::default(); plan.bodies],
            wrenches: vec![Wrench::default(); plan.bodies],
            reactions: vec![Reaction::default(); plan.reactions.len()],
            efforts: vec![S::zero(); plan.efforts],
            lines: vec![(V2::zero(), V2::new(S::one(), S::zero())); plan.efforts],
            force_sines: vec![S::one(); plan.forces.len()],
            frictions: vec![0.0; plan.friction.len()],
            senses: vec![0.0; plan.friction.len()],
            locked: false,
            consistent: Consistent::One,
            searched: Searched::default(),
            loads_before: Vec::new(),
            law_forces: vec![LawForce::default(); plan.laws.len()],
            train_work: Vec::new(),
            rubbing_work: Vec::new(),
            motion_work: Vec::new(),
            force_work: Vec::new(),
        }
    }
}

impl State {
    /// A state for a plan, at rest.
    #[must_use]
    pub fn new(plan: &Plan) -> Self {
        Self::closed(plan).ready(plan)
    }

    /// The state with memory laid out for the steps of a plan that have no closed form: a position of a solution has none.
    #[must_use]
    pub fn ready(self, plan: &Plan) -> Self {
        let memory = |equations: &Option<General>, bodies: &[usize], moving| {
            equations.as_ref().map(|e| Workspace::new(e, bodies.len(), moving))
        };
        let rubs = plan.forces.iter().any(|step| matches!(step, ForceStep::Rubbing { .. }));
        let rubbing = plan.forces.iter().map(|step| match step {
            ForceStep::Rubbing { group, .. } => Some(RubbingWork::new(group)),
            _ => None,
        });
        Self {
            train_work: plan.train_forces.iter().map(TrainWork::new).collect(),
            rubbing_work: if rubs { rubbing.collect() } else { Vec::new() },
            motion_work: plan.general.iter().map(|g| memory(&g.equations, &g.bodies, g.moving)).collect(),
            force_work: plan
                .balance_systems
                .iter()
                .map(|g| memory(&g.equations, &g.bodies, g.moving))
                .collect(),
            ..self
        }
    }

    /// A copy without that memory.
    pub(crate) fn answer(&self) -> Self {
        Self {
            bodies: self.bodies.clone(),
            inputs: self.inputs.clone(),
            branches: self.branches.clone(),
            sines: self.sines.clone(),
            certificates: self.certificates.clone(),
            touches: self.touches.clone(),
            open: self.open,
            shared: self.shared.clone(),
            applied: self.applied.clone(),
            wrenches: self.wrenches.clone(),
            reactions: self.reactions.clone(),
            efforts: self.efforts.clone(),
            lines: self.lines.clone(),
            force_sines: self.force_sines.clone(),
            frictions: self.frictions.clone(),
            senses: self.senses.clone(),
            locked: self.locked,
            consistent: self.consistent,
            law_forces: self.law_forces.clone(),
            ..Self::default()
        }
    }

    /// Puts all forces to nothing.
    pub(crate) fn without_forces(&mut self) {
        self.applied.fill(Wrench::default());
        self.wrenches.fill(Wrench::default());
        self.reactions.fill(Reaction::default());
        self.efforts.fill(0.0);
        self.force_sines.fill(1.0);
        self.frictions.fill(0.0);
        self.senses.fill(0.0);
        self.law_forces.fill(LawForce::default());
        self.locked = false;
        self.consistent = Consistent::One;
    }

    /// Takes over what motion starts from, of a state of the same plan: where the bodies are and how they are assembled.
    pub(crate) fn start_from(&mut self, other: &Self) {
        self.bodies.clone_from(&other.bodies);
        self.branches.clone_from(&other.branches);
        self.sines.clone_from(&other.sines);
        self.certificates.clone_from(&other.certificates);
        self.touches.clone_from(&other.touches);
        self.open = other.open;
    }
}
