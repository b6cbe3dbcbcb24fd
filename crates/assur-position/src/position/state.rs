//! Everything that changes from position to position.

use super::kinematics::Motion;
use super::scratch::Scratch;
use super::statics::Forces;
use crate::math::Scalar;
use crate::plan::Plan;

/// Assemblies nearer than this, relative to the mechanism's extent, are one.
pub const SAME: f64 = 1e-9;
/// At and below this condition velocities and forces do not exist.
pub const DEAD: f64 = 1e-12;

/// The assembly of a group: kept over a sweep.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Branch {
    /// Sign of the root, ±1.
    pub root: f64,
    /// On which side of a line a round profile lies, per prismatic joint, ±1.
    pub sides: [f64; 2],
    /// The same for a general group, one bit per round profile; of a cam that its follower turns the number of the flank.
    pub general_sides: u32,
}

impl Branch {
    pub const FIRST: Self = Self { root: 1.0, sides: [1.0, 1.0], general_sides: 0 };
}

/// The state of one position, or of several side by side.
#[derive(Clone, Debug, Default)]
pub struct State<S = f64> {
    /// The assemblies of the groups of motion: what is chosen, and kept over a sweep.
    pub branches: Vec<Branch>,
    /// How the bodies move.
    pub motion: Motion<S>,
    pub forces: Forces<S>,
    /// Memory for the steps that have no closed form.
    pub scratch: Scratch,
    /// The same with other forces that are as possible, where pairs share by friction what one of them could hold.
    pub other: Option<Box<Self>>,
}

impl<S: Scalar + Default> State<S> {
    /// A state for the closed forms of a plan, at rest.
    #[must_use]
    pub fn closed(plan: &Plan) -> Self {
        Self {
            branches: vec![Branch::FIRST; plan.motion.len()],
            motion: Motion::at_rest(plan),
            forces: Forces::none(plan),
            scratch: Scratch::default(),
            other: None,
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
        Self { scratch: Scratch::of(plan), ..self }
    }

    /// A copy without that memory, and with these forces alone.
    pub fn answer(&self) -> Self {
        let (branches, motion, forces) = (self.branches.clone(), self.motion.clone(), self.forces.clone());
        Self { branches, motion, forces, scratch: Scratch::default(), other: None }
    }

    /// The same copy in the memory of another state.
    pub fn answer_in(&self, other: &mut Self) {
        other.other = None;
        other.branches.clone_from(&self.branches);
        other.motion.copy(&self.motion);
        other.forces.copy(&self.forces);
    }

    /// Takes over what motion starts from, of a state of the same plan: where the bodies are and how they are assembled.
    pub fn start_from(&mut self, other: &Self) {
        self.branches.clone_from(&other.branches);
        self.motion.start_from(&other.motion);
    }
}
