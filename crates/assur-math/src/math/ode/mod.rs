//! Initial value problems y' = f(t, y): the integrators, from the books of E. Hairer, S. P. Nørsett and G. Wanner,
//! Solving Ordinary Differential Equations I (2nd edition, 1993) and, with G. Wanner, II (2nd edition, 1996).
//!
//! A method is made once for n unknowns and their tolerances and takes no memory afterwards. A step goes from where the last
//! one ended; between both ends of the last step there is a polynomial, which costs evaluations only once it is asked for.
//!
//! ```text
//! method.start(&mut system, t, &y, end)?;
//! loop {
//!     let step = method.step(&mut system)?;
//!     method.prepare_dense(&mut system)?;      // where something is looked for within the step
//!     method.dense(t, &mut y);
//!     method.shorten(&mut system, t)?;         // ends the step there: then it was not the last one
//!     method.restart(&mut system, &y, end)?;   // where the state or the rates jump
//! }
//! ```

mod elimination;
mod energy;
pub mod event;
mod extrapolation;
mod progress;
mod tolerance;

pub mod dop853;
mod radau;

pub use dop853::{Control, Dop853};
pub use energy::Energy;
pub use extrapolation::Extrapolation;
pub use progress::{Counts, Progress};
pub use radau::Radau;
pub use tolerance::Tolerance;

use super::scalar::{eighth_root, epsilon, finite, nonzero, rough_root, wide};

pub use super::Real;

/// The rates have no value here.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the rates have no value here")]
pub struct Undefined;

/// What is to be integrated.
pub trait System<S> {
    /// y' at (t, y). Where a trial stage has no value the step is rejected and halved.
    ///
    /// # Errors
    /// There is no value.
    fn rates(&mut self, t: S, y: &[S], dy: &mut [S]) -> Result<(), Undefined>;

    /// ∂y'_i/∂y_j at (t, y) as element i·n + j, for implicit methods; false where it is not known.
    ///
    /// # Errors
    /// There is no value.
    fn jacobian(&mut self, _t: S, _y: &[S], _derivatives: &mut [S]) -> Result<bool, Undefined> {
        Ok(false)
    }

    /// Mass, force along the coordinate, rates of all further works by the coordinate and values that are watched, where a value of
    /// the one coordinate tells them; false where it does not.
    ///
    /// # Errors
    /// There is no value.
    fn along(&mut self, _q: S, _out: &mut [S]) -> Result<bool, Undefined> {
        Ok(false)
    }

    /// Called with every state from which a step begins, before its stages: what is kept beside the state belongs to it.
    fn accepted(&mut self, _t: S, _y: &[S]) {}
}

/// Where a step led to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Step {
    /// Somewhere before the end.
    Within,
    /// To the end, or there is nothing left to do.
    Last,
}

/// Why there is no step. The state is where the last accepted step ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Stopped {
    /// [`Progress::most_steps`] were tried since the start.
    #[error("too many steps")]
    TooManySteps,
    /// The tolerance is not reached with any step that moves t.
    #[error("the step became too small")]
    StepTooSmall,
    /// The rates have no value however short the step.
    #[error("the rates have no value beyond here")]
    Undefined,
    /// The step is done, but its length has been bounded by stability for a while: an implicit method is cheaper. Calling
    /// again goes on.
    #[error("the problem looks stiff")]
    Stiff,
}

/// What all methods offer.
pub trait Integrator<S: Real> {
    fn progress(&self) -> &Progress<S>;
    /// Where it stands, to set its bounds.
    fn progress_mut(&mut self) -> &mut Progress<S>;

    /// Begins at (t, y) and chooses the first step. Counts go on.
    ///
    /// # Errors
    /// The rates have no value at the beginning.
    fn start<F: System<S> + ?Sized>(
        &mut self,
        system: &mut F,
        t: S,
        y: &[S],
        end: S,
    ) -> Result<(), Undefined>;

    /// Goes on with the same step length from another state at the same t, as after an impact, or with other rates.
    ///
    /// # Errors
    /// The rates have no value there.
    fn restart<F: System<S> + ?Sized>(&mut self, system: &mut F, y: &[S], end: S) -> Result<(), Undefined> {
        self.progress_mut().place(system, None, y, end)
    }

    /// One accepted step, with as many trials as it takes.
    ///
    /// # Errors
    /// Why not.
    fn step<F: System<S> + ?Sized>(&mut self, system: &mut F) -> Result<Step, Stopped>;

    /// Ends the last step at t by a step of that length, which is not judged by its error.
    ///
    /// # Errors
    /// A stage has no value; then the state is where the last step began.
    fn shorten<F: System<S> + ?Sized>(&mut self, system: &mut F, t: S) -> Result<(), Undefined>;

    /// Makes [`Integrator::dense`] as accurate as the method offers; once per step.
    ///
    /// # Errors
    /// A stage has no value.
    fn prepare_dense<F: System<S> + ?Sized>(&mut self, system: &mut F) -> Result<(), Undefined>;

    /// y at t within the last step. Without [`Integrator::prepare_dense`] it is the cubic through values and rates at both
    /// ends, of order 3.
    fn dense(&self, t: S, y: &mut [S]);

    /// Whether a watched value of [`System::along`], by its place, is known not to come to zero within the last step.
    fn keeps_off(&self, _watched: usize) -> bool {
        false
    }

    /// Where the last step ended.
    fn t(&self) -> S {
        self.progress().t1
    }
    fn y(&self) -> &[S] {
        &self.progress().y1
    }
    fn rates(&self) -> &[S] {
        &self.progress().f1
    }
    /// Where the last step began.
    fn previous_t(&self) -> S {
        self.progress().t0
    }
    fn previous_y(&self) -> &[S] {
        &self.progress().y0
    }
    fn previous_rates(&self) -> &[S] {
        &self.progress().f0
    }
    /// What it cost so far.
    fn counts(&self) -> Counts {
        self.progress().counts
    }
}
