//! Numbers of a position in SI and radians, as its JSON lists them: where each comes from is found once.

use super::pose_answers::PoseAnswers;
use crate::math::Vec2;
use crate::model::{Guide, LinkId, PairId, Query, Value};
use crate::position::{DriveValue, Residuals};

/// Where a number comes from, or the two of a vector.
#[derive(Clone, Debug)]
pub enum Source {
    /// The value of a drive.
    Drive(usize),
    Query(Query),
    /// Where the resultant of a guide's reaction on a link crosses it.
    Crossing(PairId, LinkId, Guide),
    /// The forces at the two contact points of a guide, each after its place.
    Contacts(PairId, Guide),
    Effort(usize),
    /// An item of `find`.
    Find(usize),
    /// The residual of the equilibrium.
    Equilibrium,
    /// The residual of the powers.
    Power,
    Condition,
}

/// A reaction below this part of the greatest force is none.
const NO_FORCE: f64 = 1e-12;

/// What a position has beside its state.
#[derive(Clone, Copy, Debug)]
pub struct PoseExtras<'a> {
    /// The values of the drives.
    pub drives: &'a [DriveValue],
    pub residuals: &'a Residuals,
    pub condition: f64,
}

/// Appends the numbers of a position. `false` where one does not exist there, or is a condition.
#[must_use]
pub fn read_numbers(
    sources: &[Source],
    view: &PoseAnswers<'_>,
    beside: &PoseExtras<'_>,
    out: &mut Vec<f64>,
) -> bool {
    let begin = out.len();
    for source in sources {
        if read(source, view, beside, out).is_none() {
            return false;
        }
    }
    out[begin..].iter().all(|x| x.is_finite())
}

fn read(source: &Source, view: &PoseAnswers<'_>, beside: &PoseExtras<'_>, out: &mut Vec<f64>) -> Option<()> {
    let vector = |v: Vec2, out: &mut Vec<f64>| out.extend([v.x, v.y]);
    match source {
        Source::Drive(i) => value(beside.drives.get(*i)?.value()?, out)?,
        Source::Query(query) => value(view.query(query), out)?,
        Source::Crossing(pair, on, guide) => vector(view.crossing(*pair, *on, guide)?, out),
        Source::Contacts(pair, guide) => {
            for (at, normal) in view.contacts(*pair, guide) {
                vector(at, out);
                out.push(normal);
            }
        }
        Source::Effort(slot) => out.push(view.effort(*slot)),
        Source::Find(index) => value(view.found(*index)?, out)?,
        Source::Equilibrium => out.push(beside.residuals.equilibrium?),
        Source::Power => out.push(beside.residuals.power?),
        Source::Condition => out.push(beside.condition),
    }
    Some(())
}

fn value(value: Value, out: &mut Vec<f64>) -> Option<()> {
    match value {
        Value::Scalar(x) => out.push(x),
        Value::Vector(v) => out.extend([v.x, v.y]),
        Value::Bool(_) => return None,
    }
    Some(())
}

impl PoseAnswers<'_> {
    /// Where the resultant of a guide's reaction on a link crosses the guide, m; a couple alone crosses it nowhere.
    #[must_use]
    pub fn crossing(&self, pair: PairId, on: LinkId, guide: &Guide) -> Option<Vec2> {
        let scale = self.state.forces.reactions.iter().map(|r| r.force.norm()).fold(0.0, f64::max);
        let coordinate = self.line_offset(pair);
        let crosses = coordinate.is_finite() && self.reaction(pair, on).norm() > NO_FORCE * scale;
        crosses.then(|| self.body(guide.guide).position(guide.through) + self.along(guide) * coordinate)
    }

    /// The places of the two contact points of a guide, m, with the force there along the guide's left normal on the sliding
    /// link, N, where it exists.
    pub fn contacts(&self, pair: PairId, guide: &Guide) -> impl Iterator<Item = (Vec2, f64)> + use<> {
        let both = guide.contacts.zip(self.contact_forces(pair));
        let point = self.body(guide.slider).position(guide.point);
        let along = self.along(guide);
        let each = both.into_iter().flat_map(|(places, normals)| places.into_iter().zip(normals));
        each.filter(|(_, normal)| normal.is_finite()).map(move |(s, normal)| (point + along * s, normal))
    }
}

/// An answer that is not a number does not exist.
#[inline]
#[must_use]
pub const fn finite(x: f64) -> f64 {
    if x.abs() < f64::INFINITY { x } else { f64::NAN }
}
