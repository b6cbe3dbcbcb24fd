//! What is seen in a trial: answers, values of loads, angles that are carried on.

use super::equations::Equations;
use super::loads::sides;
use crate::answer::{LEAST_CONDITION, OF_FORCES, OF_MOTION, PoseAnswers, ROUNDING};
use crate::model::{DriveTarget, Expr, LoadId};
use crate::position::Model;
use std::f64::consts::TAU;

impl Equations<'_, '_> {
    /// Answers in the state that is observed.
    pub fn view(&self) -> PoseAnswers<'_> {
        let view = PoseAnswers::new(self.model, &self.trial, &self.angles, self.statics);
        PoseAnswers { switches: sides(self.held, &self.switches), sizes: &self.sizes, ..view }
    }

    /// The powers whose works are asked for, at rates of which the actual ones are this part.
    pub fn powers(&mut self, out: &mut [f64], part: f64) {
        for (id, power) in out.iter_mut().enumerate() {
            *power = part * self.value(&self.model.mechanism.works[id]);
        }
    }

    /// Looks at what results are made of in the state that is observed, and at what each of its loads would do alone.
    pub fn look_at_sizes(&mut self) {
        let mut sizes = std::mem::take(&mut self.sizes);
        self.named(|view| sizes.update_max(view));
        let (order, force, length) = (self.order(), sizes.applied(), sizes.length());
        for coordinate in 0..order {
            let mass = self.reduced.mass()[coordinate * (order + 1)];
            let alone = (0..order).map(|i| if i == coordinate { 1.0 } else { 0.0 });
            let speed = self.reduced.greatest_speed(length, alone);
            sizes.may_accelerate(force * length * speed * speed / mass);
        }
        sizes.doubt(self.rounding_of(1.0, OF_MOTION) / ROUNDING);
        self.sizes = sizes;
    }

    /// What an expression is zero but for rounding below, in the state that is observed; NaN where it has no value.
    pub fn nothing(&mut self, expr: &Expr, grows: i32) -> f64 {
        let sizes = std::mem::take(&mut self.sizes);
        let size = self.named(|view| view.size(expr, &sizes));
        self.sizes = sizes;
        self.rounding_of(size, grows)
    }

    /// Rounding of terms of a size, which grows by this power of the condition where the step begins and in the state observed.
    pub fn rounding_of(&self, size: f64, grows: i32) -> f64 {
        let rough = self.rough[if grows == OF_FORCES { 2 } else { 1 }];
        let condition = self.condition().min(self.trial_condition()).max(LEAST_CONDITION);
        size * rough.max(ROUNDING / condition.powi(grows))
    }

    /// The value of an expression in the state that is observed.
    pub fn value(&mut self, expr: &Expr) -> f64 {
        self.named(|view| view.scalar(expr))
    }

    /// What is seen with the quantities of the file in that state.
    fn named<R>(&mut self, look: impl FnOnce(&PoseAnswers<'_>) -> R) -> R {
        let memory = std::mem::take(&mut self.memory);
        let view = self.view();
        let quantities = view.all_quantities_in(memory);
        let found = look(&PoseAnswers { quantities: &quantities, ..view });
        self.memory = quantities;
        found
    }

    /// The values of the loads that depend on the state, on the sides of their corners where the step begins.
    pub fn evaluate_loads(&mut self, t: f64) {
        self.evaluated.clear();
        // open stops bear nothing
        let open = self.closed.is_empty();
        if !self.evaluates || open && self.of_stops.1 {
            return;
        }
        // conditions are not looked at where they are held
        if self.loads_need_angles || !self.held && self.conditions_need_angles {
            self.follow_angles(t);
        }
        self.evaluate_on_sides(self.held);
        if self.held && self.evaluated.iter().any(|(_, value)| !value.is_defined()) {
            // what holds on one side need not exist beyond it
            self.evaluate_on_sides(false);
        }
        if open {
            let of_stops = &self.of_stops.0;
            self.evaluated.retain(|(load, _)| !of_stops[load.index()]);
        }
    }

    fn evaluate_on_sides(&mut self, held: bool) {
        let switches = sides(held, &self.switches);
        let view = PoseAnswers::new(self.model, &self.trial, &self.angles, self.statics);
        let view = PoseAnswers { switches, sizes: &self.sizes, ..view };
        match self.quantities.take() {
            None => view.evaluated_loads(&mut self.evaluated),
            Some(memory) => {
                let quantities = view.all_quantities_in(memory);
                let view = PoseAnswers { quantities: &quantities, ..view };
                view.evaluated_loads(&mut self.evaluated);
                self.quantities = Some(quantities);
            }
        }
    }

    /// The greatest that a load against the motion may be where everything was evaluated.
    pub fn greatest_of_load(&self, load: LoadId) -> f64 {
        let view = self.view();
        match &self.quantities {
            None => view.magnitude(load.index()),
            Some(quantities) => PoseAnswers { quantities, ..view }.magnitude(load.index()),
        }
    }

    /// Angles of the bodies of the last evaluation, carried on from where the step began.
    pub fn follow_angles(&mut self, t: f64) {
        if !self.angles_of_walk() {
            self.angles_after(t);
        }
        for (&drive, effort) in self.reduced.free().iter().zip(driven_bodies(self.model, self.reduced.free()))
        {
            if let Some(body) = effort {
                self.angles[body] = self.trial.motion.inputs[drive].value;
            }
        }
        for &body in &self.model.plan.turning {
            self.angles[body] = self.trial.motion.bodies[body].turned;
        }
    }
}

impl Equations<'_, '_> {
    /// The angles at an instant after the one where the step began.
    fn angles_after(&mut self, t: f64) {
        let (began, accepted, angles) = &self.accepted;
        let h = t - began;
        let bodies = accepted.motion.bodies.iter().zip(&self.trial.motion.bodies);
        for ((angle, before), (old, new)) in self.angles.iter_mut().zip(angles).zip(bodies) {
            // the mean speed is near enough to tell the whole turns, the rest is read off the direction itself
            let estimate = before + 0.5 * h * (old.omega + new.omega);
            let principal = new.u.angle();
            *angle = principal + TAU * ((estimate - principal) / TAU).round();
        }
    }
}

/// The body whose angle each of these drives gives.
fn driven_bodies<'m>(model: &'m Model<'_>, drives: &'m [usize]) -> impl Iterator<Item = Option<usize>> + 'm {
    drives.iter().map(|&drive| match model.mechanism.drives[drive].target {
        DriveTarget::Link(link) => Some(link.index()),
        _ => None,
    })
}
