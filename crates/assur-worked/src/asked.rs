//! What the file asks for of guides, drives and transmissions, where no step has it yet.

use crate::angle::Angle;
use crate::course::Course;
use crate::document::Block;
use crate::motion::Stage;
use crate::words::{Message, say};
use assur_formula::{Expr, Name, Unit};
use assur_model::model::{FindKind, Guide, PairId, PairKind, Query, Value};
use assur_model::structure::EffortSource;

/// What differs by less than this part of its terms is the same.
const SAME: f64 = 1e-9;

impl Course<'_> {
    /// The questions of the file.
    fn questions(&self) -> Vec<Query> {
        let mechanism = self.scene.mechanism();
        let mut all = Vec::new();
        for find in &mechanism.finds {
            let FindKind::Value { expr, poseless: false, .. } = &find.kind else { continue };
            crate::prune::queries(mechanism, expr, &mut |query| all.push(query.clone()));
        }
        all
    }

    /// Coordinates of sliders and their rates: of the slider's point, from where the line of the guide begins.
    pub(crate) fn asked_of_guides(&mut self, stage: Stage) {
        let before = self.blocks.len();
        for query in self.questions() {
            let pair = match (stage, &query) {
                (Stage::Positions, Query::Displacement(pair))
                | (Stage::Velocities, Query::RelativeVelocity(pair))
                | (Stage::Accelerations, Query::RelativeAcceleration(pair)) => *pair,
                _ => continue,
            };
            if let Value::Scalar(value) = self.scene.view().query(&query) {
                self.along_its_guide(stage, pair, value);
            }
        }
        self.introduce(before, Message::AskedOfGuides);
    }

    /// A sentence before what has been written since.
    fn introduce(&mut self, before: usize, message: Message) {
        if self.blocks.len() > before {
            let words = say(self.language, message, &[]);
            self.insert(before, vec![Block::Paragraph(words)]);
        }
    }

    fn along_its_guide(&mut self, stage: Stage, pair: PairId, value: f64) -> Option<()> {
        let (letters, unit): (&[&str], Unit) = match stage {
            Stage::Positions => (&["s", "x", "y"], Unit::Length),
            Stage::Velocities => (&["v"], Unit::Velocity),
            Stage::Accelerations => (&["a"], Unit::Acceleration),
        };
        let own = self.scene.mechanism().pair(pair);
        let PairKind::Prismatic(g) = &own.kind else { return None };
        if own.bearing.is_some() || value == 0.0 || self.on_guide_with(letters, pair, value).is_some() {
            return None;
        }
        let right = self.part_along(stage, g)?;
        if (right.value() - value).abs() <= SAME * right.scale() {
            let name = Name::new(letters[0], &own.name);
            self.asked.insert(name.clone());
            self.equate(name, value, unit, right);
        }
        Some(())
    }

    /// The part along a guide of where the slider is, how fast it moves or how it accelerates against the guide.
    fn part_along(&mut self, stage: Stage, g: &Guide) -> Option<Expr> {
        let (slider, carrier) = (g.slider.index(), g.guide.index());
        let own = self.direction_given(g.along, || Name::new("λ", &self.label(carrier)));
        let angle: Angle = self.bodies[carrier].as_ref()?.angle.plus(&own);
        self.bodies[slider].as_ref()?;
        let here = self.position(slider, g.point);
        let point = self.point_name(slider, g.point);
        let (of, against) = match stage {
            Stage::Positions => (here, self.position(carrier, g.through)),
            Stage::Velocities => (self.velocity(slider, g.point), self.under(1, carrier, &point, &here)),
            Stage::Accelerations => {
                (self.acceleration(slider, g.point), self.under(2, carrier, &point, &here))
            }
        };
        let ([x, y], [u, w]) = (of, against);
        Some(angle.along(&[x - u, y - w]))
    }

    /// Powers of drives and couples of transmissions on their shafts.
    pub(crate) fn asked_of_forces(&mut self) {
        let before = self.blocks.len();
        for query in self.questions() {
            let Value::Scalar(value) = self.scene.view().query(&query) else { continue };
            let found = match &query {
                Query::EffortPower(id) => self.power_asked_for(EffortSource::Drive(*id)),
                Query::BalancePower(id) => self.power_asked_for(EffortSource::Balance(*id)),
                Query::Moment(pair, link) => self.couple_asked_for(*pair, link.index()),
                _ => None,
            };
            let Some((name, unit, right)) = found else { continue };
            if value != 0.0 && (right.value() - value).abs() <= SAME * right.scale() {
                self.asked.insert(name.clone());
                self.equate(name, value, unit, right);
            }
        }
        self.introduce(before, Message::AskedOfForces);
    }

    fn power_asked_for(&mut self, source: EffortSource) -> Option<(Name, Unit, Expr)> {
        let slot = self.structure().efforts.iter().position(|effort| effort.source == source)?;
        let name = self.effort_name(slot, self.is_force(slot));
        let effort = self.found.get(&name).cloned()?;
        let right = self.power_of(slot, effort)?;
        Some((Name::new("P", &name.sub_or_letter()), Unit::Power, right))
    }

    fn couple_asked_for(&mut self, pair: PairId, body: usize) -> Option<(Name, Unit, Expr)> {
        let slot = self.scene.model.plan.laws.iter().position(|law| law.pair == pair)?;
        let right = self.couple_of_law(slot, body)?;
        let index = format!("{},{}", self.scene.mechanism().pair(pair).name, self.label(body));
        Some((Name::new("M", &index), Unit::Torque, right))
    }
}
