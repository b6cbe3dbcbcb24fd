//! Mass substitution by two points, as questions about one position.

use super::pose_answers::PoseAnswers;
use crate::force::mass_substitution::{in_points, with_centre_of_oscillation};
use crate::math::Vec2;
use crate::model::{LinkId, SubstitutionPart, Value};

const NOT_A_NUMBER: Value = Value::Scalar(f64::NAN);

/// Two masses and where they are, in the link's frame.
struct Masses {
    m_1: f64,
    m_2: f64,
    p_1: Vec2,
    p_2: Vec2,
    l_2: f64,
    /// Moment of inertia left over: that of the link less that of the two masses, kg m².
    dJ: f64,
}

pub(super) fn of_static(
    view: &PoseAnswers<'_>,
    link: LinkId,
    p_1: Vec2,
    p_2: Vec2,
    part: SubstitutionPart,
) -> Value {
    let Some(m) = view.mechanism.link(link).mass else { return NOT_A_NUMBER };
    let s = in_points(m.mass, m.inertia, p_1 - m.centre, p_2 - m.centre);
    let l_2 = (p_2 - m.centre).norm();
    Masses { m_1: s.m_1, m_2: s.m_2, p_1, p_2, l_2, dJ: s.dJ }.part(view, link, part)
}

pub(super) fn of_dynamic(view: &PoseAnswers<'_>, link: LinkId, p: Vec2, part: SubstitutionPart) -> Value {
    let Some(m) = view.mechanism.link(link).mass else { return NOT_A_NUMBER };
    let d = with_centre_of_oscillation(m.mass, m.inertia, p - m.centre);
    Masses { m_1: d.m_1, m_2: d.m_2, p_1: p, p_2: m.centre + d.r_2, l_2: d.l_2, dJ: 0.0 }
        .part(view, link, part)
}

impl Masses {
    fn part(&self, view: &PoseAnswers<'_>, link: LinkId, part: SubstitutionPart) -> Value {
        let body = view.body(link);
        match part {
            SubstitutionPart::M1 => Value::Scalar(self.m_1),
            SubstitutionPart::M2 => Value::Scalar(self.m_2),
            SubstitutionPart::P2 => Value::Vector(self.p_2),
            SubstitutionPart::L2 => Value::Scalar(self.l_2),
            SubstitutionPart::A2 => Value::Vector(body.acceleration(self.p_2)),
            SubstitutionPart::F1 => Value::Vector(body.acceleration(self.p_1) * -self.m_1),
            SubstitutionPart::F2 => Value::Vector(body.acceleration(self.p_2) * -self.m_2),
            SubstitutionPart::DJ => Value::Scalar(self.dJ),
        }
    }
}
