//! The force along a link of two hinges.

use super::pose_answers::PoseAnswers;
use crate::math::Vec2;
use crate::model::{Bar, LinkId, LoadKind, PairId, Place, Value};

impl PoseAnswers<'_> {
    /// The force along a link with two hinges and nothing between them, N: tension is positive. NaN of any other link.
    #[must_use]
    pub fn axial(&self, link: LinkId) -> f64 {
        let found = self.mechanism.bars.iter().find(|bar| bar.link == link);
        found.and_then(|bar| self.along_bar(bar)).unwrap_or(f64::NAN)
    }

    /// What acts on the bar at its end, along it.
    fn along_bar(&self, bar: &Bar) -> Option<f64> {
        let at = |pair: PairId| self.mechanism.point_in(pair, bar.link);
        let [from, to] = [at(bar.from)?, at(bar.to)?];
        let u = (to - from).unit()?.turned(self.body(bar.link).u);
        let mut sum = Vec2::zero();
        for &pair in &bar.pairs {
            // a row of variants may have moved it
            (at(pair)? == to).then_some(())?;
            sum += self.reaction(pair, bar.link);
        }
        for load in &bar.loads {
            let LoadKind::Force { at: Place::Local(at), .. } = &self.mechanism.loads[load.index()].kind
            else {
                return None;
            };
            let Value::Vector(force) = self.load(load.index()) else { return None };
            (*at == to).then_some(())?;
            sum += force;
        }
        Some(sum.dot(u))
    }
}
