//! Lines along which friction acts, in the position found; on which side of a line a profile lies is that of the state.

use super::motion::Motion;
use super::unit;
use crate::math::{Double, Scalar, V2};
use crate::model::ProfileShape;
use crate::plan::{FrictionElement, FrictionLaw};
use crate::position::{BodyState, State};

type D = Double;

/// Where an effort of friction acts, and along which direction; nothing inside for a torque. `None` where it does not exist.
pub(super) fn friction_line(
    element: &FrictionElement,
    state: &State,
    motion: &Motion<'_>,
) -> Option<Option<(V2<D>, V2<D>)>> {
    match &element.kind {
        FrictionLaw::Circle { .. } | FrictionLaw::Rolling { .. } => Some(None),
        FrictionLaw::Guide { guide, .. } | FrictionLaw::BothEnds { guide, .. } => {
            let slider = &motion.bodies[guide.slider];
            Some(Some((slider.position(guide.point), unit(guide.direction).turned(slider.u))))
        }
        FrictionLaw::Contact { first, second, internal, .. } => {
            let sides = [(element.body, *first), (element.base, *second)];
            let (_, like) = state.touch(sides[0], sides[1], *internal)?;
            let (p, normal) = touch(motion, sides, *internal)?;
            let normal = if normal.dot(V2::of(like)).lt(D::zero()) { -normal } else { normal };
            Some(Some((p, normal.perp())))
        }
    }
}

/// A profile in ground axes.
enum Seen {
    Round(V2<D>, D),
    Straight(V2<D>, V2<D>),
    Cam(usize),
}

fn seen(body: &BodyState<D>, shape: ProfileShape) -> Seen {
    match shape {
        ProfileShape::Point(p) => Seen::Round(body.position(p), D::zero()),
        ProfileShape::Circle(c, r) => Seen::Round(body.position(c), D::of(r)),
        ProfileShape::Line(p, d) => Seen::Straight(body.position(p), unit(d).turned(body.u)),
        ProfileShape::Rim(contact) => Seen::Cam(contact),
    }
}

/// Place of a contact and a unit normal, of either sense.
fn touch(motion: &Motion<'_>, sides: [(usize, ProfileShape); 2], internal: bool) -> Option<(V2<D>, V2<D>)> {
    let [one, two] = sides.map(|(body, shape)| seen(&motion.bodies[body], shape));
    match (one, two) {
        (Seen::Cam(index), _) | (_, Seen::Cam(index)) => {
            let step = motion.model.plan.cams.iter().find(|step| step.index == index)?;
            let touch = super::cam::touch(step, &motion.bodies);
            Some((touch.place, touch.normal))
        }
        (Seen::Round(c_1, r_1), Seen::Round(c_2, r_2)) => {
            let apart = c_1 - c_2;
            let normal = apart / apart.norm();
            // within the greater circle its rim lies beyond the centre of the smaller
            let p = match (internal, r_1.lt(r_2)) {
                (false, _) | (true, true) => c_2 + normal * r_2,
                (true, false) => c_1 - normal * r_1,
            };
            Some((p, normal))
        }
        (Seen::Round(c, _), Seen::Straight(p, d)) | (Seen::Straight(p, d), Seen::Round(c, _)) => {
            let normal = d.perp();
            Some((c - normal * normal.dot(c - p), normal))
        }
        (Seen::Straight(..), Seen::Straight(..)) => None,
    }
}
