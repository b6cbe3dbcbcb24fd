//! How the links of a pair with friction move against each other: the rate that decides the sense of friction.

use crate::angle::Angle;
use crate::course::Derivation;
use crate::document::text;
use crate::words::FrictionMessage;
use assur_formula::{Expr, Name, Unit};
use assur_math::math::{SAME, Vec2};
use assur_model::model::ProfileShape;
use assur_model::structure::BodyOrigin;
use assur_position::plan::{FrictionElement, FrictionLaw, Guide};

impl Derivation<'_> {
    /// The velocity of the element's body against its base, in the sense in which its friction counts.
    pub(super) fn relative_rate(&mut self, element: &FrictionElement) -> Expr {
        let speed = self.state().sliding_speed(element);
        let index = format!("{},{}", self.label(element.body), self.label(element.base));
        let right = match &element.kind {
            FrictionLaw::Circle { .. } | FrictionLaw::Rolling { .. } => {
                let [of, against] = [element.body, element.base].map(|body| self.turning(body));
                return self.component(Name::new("ω", &index), speed, Unit::AngularVelocity, of - against);
            }
            FrictionLaw::Guide { guide, .. } | FrictionLaw::BothEnds { guide, .. } => {
                Some(self.sliding_along(element, guide, speed))
            }
            FrictionLaw::Contact { .. } => self.sliding_in_contact(element),
        };
        let name = Name::new("v", &index);
        match right.filter(|right| (right.value() - speed).abs() <= SAME * right.scale()) {
            Some(right) => self.component(name, speed, Unit::Velocity, right),
            None => self.stated(name, speed, Unit::Velocity),
        }
    }

    fn turning(&self, body: usize) -> Expr {
        self.bodies[body].as_ref().map_or(Expr::ZERO, |b| b.rates[0].clone())
    }

    /// The velocity along a guide: found with the motion, or the difference of the slider and what is under it.
    fn sliding_along(&mut self, element: &FrictionElement, guide: &Guide, speed: f64) -> Expr {
        let slides = element.body == guide.slider || element.through == guide.slider;
        let carrier = if guide.slider == guide.body { guide.base } else { guide.body };
        let point = self.point_name(guide.slider, guide.point);
        let indices =
            [format!("{point},{}", self.label(carrier)), self.against_slider(&point, carrier, guide.slider)];
        for found in
            indices.map(|index| self.found.get(&Name::new("v", &index)).cloned()).into_iter().flatten()
        {
            for right in [found.clone(), -found] {
                if (right.value() - speed).abs() <= SAME * speed.abs() {
                    return right;
                }
            }
        }
        let [x, y] = self.velocity(guide.slider, guide.point);
        let here = self.position(guide.slider, guide.point);
        let [u, w] = self.under(1, carrier, &point, &here);
        let along = self.way(guide).0.along(&[x - u, y - w]);
        if slides { along } else { -along }
    }

    /// The velocity along the tangent where a round profile touches.
    pub(crate) fn sliding_in_contact(&mut self, element: &FrictionElement) -> Option<Expr> {
        let (_, along) = self.state().friction_line(element)?;
        let tangent = self.tangent(element, along);
        let (name, here) = self.touching(element)?;
        let [x, y] = self.under(1, element.body, &name, &here);
        let [u, w] = self.under(1, element.base, &name, &here);
        Some(tangent.along(&[x - u, y - w]))
    }

    /// The letters and the place of a point of a body that has no name in the file, where a contact with friction touches.
    pub(crate) fn touched(&mut self, body: usize, at: Vec2) -> Option<(String, [Expr; 2])> {
        let plan = self.scene.model.plan;
        let place = self.moved(body).position(at);
        let touches = |element: &&FrictionElement| {
            matches!(element.kind, FrictionLaw::Contact { .. })
                && [element.through, element.base].contains(&body)
                && self
                    .state()
                    .friction_line(element)
                    .is_some_and(|(touched, _)| (touched - place).norm() <= self.tiny)
        };
        let element = *plan.friction.iter().find(touches)?;
        // how a body moves is known at its reference: there the contact follows from it
        let is_reference =
            self.bodies[body].as_ref().is_some_and(|known| (known.reference - at).norm() <= self.tiny);
        if is_reference || self.known_name(body, at).is_some() {
            return None;
        }
        self.touching(&element)
    }

    /// Where a round profile touches: its radius from its centre, across the tangent.
    fn touching(&mut self, element: &FrictionElement) -> Option<(String, [Expr; 2])> {
        let (place, along) = self.state().friction_line(element)?;
        let FrictionLaw::Contact { first, second, .. } = element.kind else { return None };
        let (body, at, radius) = [(element.body, first), (element.base, second)].into_iter().find_map(
            |(body, shape)| match shape {
                ProfileShape::Point(at) => Some((body, at, 0.0)),
                ProfileShape::Circle(at, radius) => Some((body, at, radius)),
                ProfileShape::Line(..) | ProfileShape::Rim(_) => None,
            },
        )?;
        let pair = self.scene.mechanism().pair(element.pair).name.clone();
        let tangent = self.tangent(element, along);
        let left = along.cross(place - self.moved(body).position(at));
        let normal = Angle { quarters: tangent.quarters + if left > 0.0 { 1 } else { 3 }, ..tangent };
        let r = self.given(Name::new("r", &pair), radius, Unit::Length);
        let [x, y] = self.position(body, at);
        let name = self.touching_name(element.pair);
        if radius > 0.0 && !self.found.contains_key(&Name::new("x", &name)) {
            self.say(FrictionMessage::ContactPoint, &[vec![text(name.clone())], vec![text(pair)]]);
        }
        let here = [
            self.component(Name::new("x", &name), place.x, Unit::Length, x + r.clone() * normal.cos()),
            self.component(Name::new("y", &name), place.y, Unit::Length, y + r * normal.sin()),
        ];
        Some((name, here))
    }

    /// The direction of the line of a contact, in the sense in which its friction counts.
    fn along_line(&mut self, element: &FrictionElement, along: Vec2) -> Option<Angle> {
        let FrictionLaw::Contact { first, second, .. } = element.kind else { return None };
        let sides = [(element.body, first), (element.base, second)];
        let (body, own) = sides.into_iter().find_map(|(body, shape)| match shape {
            ProfileShape::Line(_, own) => Some((body, own)),
            _ => None,
        })?;
        let here = own.turned(self.moved(body).u);
        if here.cross(along).abs() > SAME {
            return None;
        }
        let own = if here.dot(along) < 0.0 { -own } else { own };
        let pair = self.scene.mechanism().pair(element.pair).name.clone();
        let own = self.direction_given(own, || Name::new("γ", &pair));
        Some(self.bodies[body].as_ref().map_or(own.clone(), |known| known.angle.plus(&own)))
    }

    /// The direction of the tangent of a contact: that of the block which stands for it, or across it.
    pub(super) fn tangent(&mut self, element: &FrictionElement, along: Vec2) -> Angle {
        let bodies = &self.structure().replaced.bodies;
        let blocks = (0..bodies.len()).filter(|i| bodies[*i].origin == BodyOrigin::Imaginary(element.pair));
        for block in blocks {
            let Some(known) = &self.bodies[block] else { continue };
            let turn = Angle::whole_degrees(along.turned_back(self.moved(block).u));
            if let Ok(Angle { part: None, quarters }) = turn {
                return known.angle.plus(&Angle { part: None, quarters });
            }
        }
        if let Some(angle) = self.along_line(element, along) {
            return angle;
        }
        let pair = self.scene.mechanism().pair(element.pair).name.clone();
        let degrees = libm::atan2(along.y, along.x).to_degrees();
        Angle::of(self.stated(Name::new("τ", &pair), degrees, Unit::Angle))
    }
}
