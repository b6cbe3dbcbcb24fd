//! The bodies at the inputs that are set: by the plan, or on the way over a change point.

use super::chart::Given;
use super::coordinates::measured;
use super::equations::Equations;
use super::multi_crossing::MultiCrossing;
use super::records::BodyPose;
use super::singular_crossing::SingularCrossing;
use crate::answer::PoseAnswers;
use crate::math::Vec2;
use crate::position::Branch;

impl Equations<'_, '_> {
    /// Motion at given accelerations of the free coordinates, as in a solution, and forces where they are planned.
    pub fn place(&mut self, t: f64, y: &[f64], accelerations: &[f64], stand: Option<&[BodyPose]>) {
        if let Some(stand) = stand {
            BodyPose::put(stand, &mut self.trial.motion.bodies);
        }
        self.set_inputs(t, y);
        for (&drive, a) in self.reduced.free().iter().zip(accelerations) {
            self.trial.motion.inputs[drive].acceleration = *a;
        }
        // where nothing is free there is no coordinate
        self.move_bodies(y.first().copied().unwrap_or_default());
        if self.model.plan.effects.forces {
            self.evaluate_loads(t);
            self.trial.run_loads_and_forces(self.model, &self.evaluated);
        }
    }

    /// Motion and velocities for unit rates at the inputs that are set, the first coordinate at `q`.
    pub fn reduce(&mut self, q: f64) {
        if let Some(passage) = &mut self.passage {
            if !passage.run(self.model.plan, &mut self.reduced, &mut self.trial) {
                self.trial.motion.open = Some(passage.group());
            }
            return;
        }
        let Some(bridge) = &mut self.bridge else {
            return self.reduced.run_motion(self.model.plan, &mut self.trial);
        };
        if bridge.covers(q) {
            bridge.put(q, &mut self.trial.motion);
            self.reduced.take_unit(&mut self.trial);
        } else {
            self.trial.branches.copy_from_slice(bridge.branches(q));
            self.reduced.run_motion(self.model.plan, &mut self.trial);
        }
    }

    /// The bodies at a value of the one coordinate, and their velocities for a unit rate.
    pub fn reduce_at_unit_rate(&mut self, q: f64) {
        let drive = self.reduced.free()[0];
        let input = &mut self.trial.motion.inputs[drive];
        (input.value, input.place) = (q, Vec2::direction(q));
        (input.rate, input.acceleration) = (0.0, 0.0);
        if let Some(bridge) = &mut self.bridge {
            if bridge.covers(q) {
                bridge.put(q, &mut self.trial.motion);
                return self.reduced.take_unit_velocities(&self.trial);
            }
            self.trial.branches.copy_from_slice(bridge.branches(q));
        }
        self.reduced.run_at_unit_rate(self.model.plan, &mut self.trial);
    }

    /// Motion at the inputs that are set, the first coordinate at `q`.
    fn move_bodies(&mut self, q: f64) {
        if self.passage.is_some() {
            let inputs = &self.trial.motion.inputs;
            let accelerations: Vec<f64> =
                self.reduced.free().iter().map(|&drive| inputs[drive].acceleration).collect();
            self.reduce(q);
            return self.reduced.accelerate(&mut self.trial, &accelerations);
        }
        if let Some(bridge) = &self.bridge {
            self.trial.branches.copy_from_slice(bridge.branches(q));
        }
        self.trial.run_motion::<2>(self.model.plan);
        if let Some(bridge) = self.bridge.as_mut().filter(|bridge| bridge.covers(q)) {
            bridge.put(q, &mut self.trial.motion);
            let input = self.trial.motion.inputs[self.reduced.free()[0]];
            for body in &mut self.trial.motion.bodies {
                let (v, omega) = (body.v, body.omega);
                (body.v, body.omega) = (v * input.rate, omega * input.rate);
                body.a = body.a * (input.rate * input.rate) + v * input.acceleration;
                body.alpha = body.alpha * (input.rate * input.rate) + omega * input.acceleration;
            }
        }
    }

    /// Goes over a change point, if there is one ahead of where the present step begins.
    pub fn cross(&mut self, y: &[f64]) -> bool {
        if !self.reduced.is_alone() {
            let plan = self.model.plan;
            let rubs = self.rubs();
            if rubs || plan.goes_on() || self.passage.is_some() {
                return false;
            }
            let (t, here, _) = self.here();
            let mut here = here.clone();
            self.inputs_at(t, y, &mut here.motion);
            self.passage = MultiCrossing::near(plan, &self.reduced, &here, self.extent()).map(Box::new);
            if let Some(passage) = &self.passage {
                self.rough = std::array::from_fn(|kind| self.rough[kind].max(passage.rough[kind]));
            }
            return self.passage.is_some();
        }
        if self.bridge.is_none() {
            let sense = if y[1] == 0.0 { 0.0 } else { y[1].signum() };
            self.bridge = SingularCrossing::near(self, y[0], sense).map(Box::new);
            if let Some(bridge) = &self.bridge {
                self.rough = std::array::from_fn(|kind| self.rough[kind].max(bridge.rough[kind]));
            }
            return self.bridge.is_some();
        }
        false
    }

    /// The assemblies of the last evaluation in the coordinates written, where a change point has been passed.
    pub fn assemblies(&self) -> Option<Box<[Branch]>> {
        let changed = self.chart.is_none() && self.trial.branches != self.begins;
        changed.then(|| self.trial.branches.as_slice().into())
    }

    /// The position with these accelerations of the free coordinates, in a chart, as the mechanism as it is written has it, and
    /// the coordinates written there with their rates and accelerations.
    pub fn given(&mut self, (t, y): (f64, &[f64]), accelerations: &[f64]) -> Option<(Given, Vec<f64>)> {
        let on_bridge = self.bridge.as_ref().is_some_and(|bridge| bridge.covers(y[0]))
            || self.passage.as_ref().is_some_and(|passage| passage.is_on());
        if self.chart.is_none() && !on_bridge {
            return None;
        }
        self.place(t, y, accelerations, None);
        let Some(chart) = self.chart else {
            let numbers = y[..2 * self.order()].iter().chain(accelerations).copied().collect();
            let bodies = self.trial.motion.bodies.clone();
            return Some((Given { bodies, condition: self.condition(), ..Given::default() }, numbers));
        };
        let view = PoseAnswers::new(self.model, &self.trial, &self.angles, self.statics);
        let coordinates = self.written.iter().filter_map(|target| measured(&view, *target));
        let coordinates: Vec<_> = coordinates.collect();
        let values = coordinates.iter().map(|c| c.0);
        let rates = coordinates.iter().map(|c| c.1);
        let numbers = values.chain(rates).chain(coordinates.iter().map(|c| c.2)).collect();
        Some((chart.given(&mut self.trial), numbers))
    }
}
