//! Forces: loads of the links, then the groups, the last of motion first, then the balance.

mod check;
mod cuts;
mod driven;
mod free_body;
mod friction;
mod holding;
mod inertia;
mod inside;
mod joints;
mod loads;
mod lost;
mod planets;
mod prp;
mod reduced;
mod reduced_motion;
mod rpp;
mod rpr;
mod rrp;
mod rrr;
mod rubbing;
mod run;
mod several;
mod several_masses;
mod stated;
mod substitution;
mod sums;
mod together;
mod train;
mod train_held;
mod train_losses;
mod train_supports;
mod translation;
mod weld;

pub use free_body::FreeBodies;
use free_body::{Couple, Force, is_load};
pub use holding::Hold;
pub use loads::quantity_name;

use crate::course::Derivation;
use crate::document::{Figure, Line, Term, text};
use crate::words::{FrictionMessage, Message};
use assur_model::structure::Group;
use assur_position::plan::ForceStep;

/// A reaction below this part of the greatest is rounding.
const NOTHING: f64 = 1e-10;

/// Free body and polygon of a group, or of its links.
fn of_group(labels: &[String], figures: &[Figure]) -> Vec<Figure> {
    let own = |f: &&Figure| f.name.split(' ').all(|l| labels.iter().any(|label| label == l));
    figures.iter().filter(own).cloned().collect()
}

impl Derivation<'_> {
    /// All groups of forces, in the order of solution.
    pub fn forces(&mut self, figures: &[Figure]) {
        let plan = self.scene.model.plan;
        if self.truss() {
            self.counts.forces[0] += plan.forces.len();
            return;
        }
        for (index, step) in plan.forces.iter().enumerate() {
            let group = &self.structure().forces[index];
            let labels: Vec<String> = group.bodies.iter().map(|b| self.label(b.0)).collect();
            let message = if group.efforts.is_empty() { Message::GroupOf } else { Message::LinkOf };
            let line: Line = vec![text(labels.join(", "))];
            let words = crate::course::plain(&crate::words::say(self.language, message, &[line]));
            self.heading(3, words);
            if self.shares(group) {
                self.say(FrictionMessage::FrictionSharesHere, &[]);
                self.counts.held += 1;
                continue;
            }
            let links = group.bodies.iter().flat_map(|b| self.structure().replaced.links_of(*b));
            let parts: Vec<String> = links.map(|link| self.label(link.index())).collect();
            let shown = of_group(if parts.len() > labels.len() { &parts } else { &labels }, figures);
            let (freed, polygons): (Vec<Figure>, Vec<Figure>) = shown
                .iter()
                .cloned()
                .partition(|f| f.caption == self.caption(Message::Freed, &f.name.replace(' ', ", ")));
            self.cite(Message::SeeFreed, &freed);
            self.figures(freed);
            self.polygon = polygons.first().map(|f| f.caption.clone());
            let derived = self.with_parts(group, |course| course.force_step(index, step));
            self.counts.forces[usize::from(!derived)] += 1;
            self.figures(polygons);
        }
        self.welds();
        self.cuts();
        self.count_reactions();
    }

    /// Whether the forces of a group depend on how pairs share what friction holds.
    fn shares(&self, group: &Group) -> bool {
        group.bodies.iter().any(|body| self.scene.view().shares_friction_on(body.0))
    }

    /// Whether the forces of all groups do.
    pub fn all_shares(&self) -> bool {
        self.structure().forces.iter().all(|group| self.shares(group))
    }

    /// Which reactions have a step; one that is nothing needs none, and one whose place is open has none.
    fn count_reactions(&mut self) {
        let plan = self.scene.model.plan;
        let found = &self.state().forces.reactions;
        let large = self.greatest_force();
        for (slot, joint) in plan.reactions.iter().enumerate() {
            let pair = self.structure().replaced.joint(joint.joint).pair;
            let open = self.unplaced[pair.index()] || self.scene.view().shares_friction(pair);
            if open || found[slot].force.norm() <= NOTHING * large {
                continue;
            }
            let derived = self.free.reactions[slot].is_some();
            self.counts.reactions[usize::from(!derived)] += 1;
        }
    }

    /// Whether there are no loads, and all reactions and efforts are nothing.
    pub fn nothing_acts(&self) -> bool {
        let forces = &self.state().forces;
        let free = &self.free;
        if !(free.forces.iter().all(Vec::is_empty) && free.couples.iter().all(Vec::is_empty)) {
            return false;
        }
        let couples = forces.reactions.iter().map(|r| r.couple.abs());
        let laws = forces.law_forces.iter().map(|law| law.multiplier.abs());
        let all = couples.chain(laws).chain(forces.efforts.iter().map(|x| x.abs()));
        self.greatest_force() == 0.0 && all.fold(0.0, f64::max) == 0.0
    }

    /// The greatest of all reactions and loads.
    fn greatest_force(&self) -> f64 {
        let forces = &self.state().forces;
        let loads = forces.applied.iter().map(|w| w.force.norm());
        forces.reactions.iter().map(|r| r.force.norm()).chain(loads).fold(0.0, f64::max)
    }

    /// The sum of all forces on a group, as an equation and as a polygon.
    fn polygon_closes(&mut self, terms: Vec<Term>) {
        self.say(Message::PolygonCloses, &[]);
        self.closed(terms);
        if let Some(caption) = self.polygon.clone() {
            self.cite_as(Message::SeePolygon, caption);
        }
    }

    fn force_step(&mut self, index: usize, step: &ForceStep) -> bool {
        match step {
            ForceStep::Turn { hinge, effort, value } => self.balance_turn(index, hinge, effort, *value),
            ForceStep::Shift { guide, effort, value } => self.balance_shift(index, guide, effort, *value),
            ForceStep::Rrr { outer, inner, .. } if !inner.on_rim => self.force_rrr(outer, inner),
            ForceStep::Rrp { outer, inner, guide, .. } if !inner.on_rim => {
                self.force_rrp(outer, inner, guide)
            }
            ForceStep::Rpr { outer, guide } => self.force_rpr(outer, guide),
            ForceStep::Prp { ways, inner } if !inner.on_rim => self.force_prp(ways, inner),
            ForceStep::Rpp { outer, inner, guide } => self.force_rpp(outer, inner, guide),
            ForceStep::Translation { ways } => self.force_translation(ways),
            ForceStep::Train { train } => return self.force_train(index, *train),
            ForceStep::Friction { plain, group } => return self.force_friction(index, plain, group),
            ForceStep::Sequence(steps) => return self.force_sequence(steps),
            ForceStep::Rrr { .. }
            | ForceStep::Rrp { .. }
            | ForceStep::Prp { .. }
            | ForceStep::DrivenLegs { .. }
            | ForceStep::Triad(_)
            | ForceStep::General { .. } => {
                let bodies: Vec<usize> = self.structure().forces[index].bodies.iter().map(|b| b.0).collect();
                bodies.into_iter().for_each(|body| self.complete(body));
                return self.force_together(index);
            }
        }
        true
    }

    /// Groups that friction ties together, one after another with friction as a known load.
    fn force_sequence(&mut self, steps: &[ForceStep]) -> bool {
        let mut derived = true;
        for (index, step) in steps.iter().enumerate() {
            let labels: Vec<String> =
                self.structure().forces[index].bodies.iter().map(|b| self.label(b.0)).collect();
            let words = crate::words::say(self.language, Message::GroupOf, &[vec![text(labels.join(", "))]]);
            self.heading(4, crate::course::plain(&words));
            derived &= self.force_step(index, step);
        }
        derived
    }
}
