//! Planets without a place: all of a shaft are evenly spaced about the axis of their carrier, so that their mass centre stays on it, and the
//! carrier has m a² more of inertia.

use crate::course::Derivation;
use crate::document::text;
use crate::words::Message;
use assur_formula::{Expr, Name, Unit};
use assur_math::math::SAME;
use assur_model::model::{Bearing, LinkId, PairKind, TransmissionKind, Wheel};

/// The digits of a value that the file gives.
const DIGITS: i32 = 12;

impl Derivation<'_> {
    /// The carrier of planets that are one shaft without a place.
    pub(crate) fn carrier_of_planets(&self, body: usize) -> Option<usize> {
        let link = self.link(body)?;
        let pairs = self.scene.mechanism().pairs.iter().filter(|pair| pair.bearing == Some(Bearing::Open));
        let carriers = pairs.filter_map(|pair| match &pair.kind {
            PairKind::Revolute(pins) if pins.last()?.link == link => Some(pins.first()?.link),
            _ => None,
        });
        let mut moving = carriers.filter(|carrier| *carrier != LinkId::GROUND);
        moving.next().map(LinkId::index)
    }

    /// The moment of inertia of a carrier with that of the masses of its planets; none where it has no such planets.
    pub(super) fn with_planets(&mut self, carrier: usize, whole: f64) -> Option<Expr> {
        let mechanism = self.scene.mechanism();
        let links = mechanism.links.iter().enumerate().skip(1);
        let planets: Vec<(usize, f64)> = links
            .filter_map(|(i, link)| Some((LinkId::at(i).index(), link.mass?.mass)))
            .filter(|(body, mass)| *mass > 0.0 && self.carrier_of_planets(*body) == Some(carrier))
            .collect();
        let (mut own, mut sum) = (whole, Expr::ZERO);
        for (body, mass) in &planets {
            let arm = self.arm_of_planets(*body)?;
            own -= mass * arm.value().powi(2);
            let mass = self.given(Name::new("m", &self.label(*body)), *mass, Unit::Mass);
            sum = sum + mass * arm.squared();
        }
        if planets.is_empty() {
            return None;
        }
        let label = self.label(carrier);
        let name = Name::new("J", &label);
        let alone = self.given(name.and(",0"), rounded(own, whole), Unit::Inertia);
        let right = alone + sum;
        if (right.value() - whole).abs() > SAME * whole {
            return None;
        }
        let words: Vec<String> = planets.iter().map(|(body, _)| self.label(*body)).collect();
        self.say(Message::PlanetsEven, &[vec![text(words.join(", "))], vec![text(label)]]);
        Some(self.equate(name, whole, Unit::Inertia, right))
    }

    /// The distance of planets from the axis of their carrier, by the radii of a mesh.
    fn arm_of_planets(&self, body: usize) -> Option<Expr> {
        let mechanism = self.scene.mechanism();
        let link = self.link(body)?;
        mechanism.pairs.iter().find_map(|pair| {
            let PairKind::Transmission(mesh) = &pair.kind else { return None };
            let wheels: Vec<&Wheel> =
                mesh.ends.iter().filter_map(|end| mechanism.wheels.iter().find(|w| w.name == *end)).collect();
            let [a, b] = wheels.as_slice() else { return None };
            let (own, other) = if a.link == link { (a, b) } else { (b, a) };
            // of two planets on each other neither has the carrier's axis
            let central = self.carrier_of_planets(other.link.index()).is_none();
            if own.link != link || !central || mesh.kind != TransmissionKind::Mesh {
                return None;
            }
            let [one, two, ..] = mesh.laws.first()?.terms.as_slice() else { return None };
            // both coefficients have one sign where the mesh is an outer one
            let outer = one.1 * two.1 > 0.0;
            let [r, own] = [other, own].map(|w| self.given(Name::new("r", &w.name), w.radius, Unit::Length));
            Some(match (outer, r.value() > own.value()) {
                (true, _) => r + own,
                (false, true) => r - own,
                (false, false) => own - r,
            })
        })
    }
}

/// A difference with the digits of what the file gives.
fn rounded(x: f64, whole: f64) -> f64 {
    if x.abs() <= SAME * whole {
        return 0.0;
    }
    format!("{x:.*e}", usize::try_from(DIGITS - 1).unwrap_or_default()).parse().unwrap_or(x)
}
