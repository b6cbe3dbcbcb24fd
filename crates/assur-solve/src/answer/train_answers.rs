//! What transmissions do, seen from the language.

use super::pose_answers::{NAN_VECTOR, PoseAnswers};
use crate::math::Vec2;
use crate::model::{
    Expr, FrictionLimit, LinkId, Load, LoadKind, PairId, PairKind, Query, Transmission, Value,
};
use crate::plan::{LawSite, PlannedLaw};

impl PoseAnswers<'_> {
    /// The laws of a transmission with their slots.
    fn laws(&self, pair: PairId) -> impl Iterator<Item = (usize, &PlannedLaw)> + '_ {
        self.plan.laws.iter().enumerate().filter(move |(_, l)| l.pair == pair)
    }

    fn transmission(&self, pair: PairId) -> Option<&Transmission> {
        match &self.mechanism.pair(pair).kind {
            PairKind::Transmission(t) => Some(t),
            _ => None,
        }
    }

    /// Force of a law along the pitch circles or the rope, N; what the driven side gets.
    fn pull(&self, slot: usize, law: &PlannedLaw) -> f64 {
        let [one, other] = self.state.on_sides(law, slot);
        // as the second side drives the first gets less
        law.force * if other.abs() < one.abs() || one.is_nan() { other } else { one }
    }

    /// Tangential force of a transmission, N, ≥ 0; NaN where there is none, or it is not determined.
    #[must_use]
    pub fn tangential_force(&self, pair: PairId) -> f64 {
        self.scalar(&Expr::Query(Query::TangentialForce(pair, None)))
    }

    fn force_of_laws(&self, pair: PairId) -> f64 {
        self.laws(pair).next().map_or(f64::NAN, |(slot, law)| self.pull(slot, law).abs())
    }

    /// Tangential force on a link of a transmission, N, ≥ 0: its torque over the radius of its wheel. The side that drives
    /// has what is lost as well.
    pub(super) fn force_on(&self, pair: PairId, on: Option<LinkId>) -> f64 {
        let Some(link) = on else { return self.force_of_laws(pair) };
        let of_side = |(slot, law): (usize, &PlannedLaw)| {
            let t = self.transmission(pair)?;
            let side = t.links.iter().position(|l| *l == link)?;
            let on_sides = self.state.on_sides(law, slot);
            // the law of a belt that slips has the first wheel's coefficient less the slip
            let kept = if side == 0 { 1.0 - t.slip } else { 1.0 };
            Some((law.force * on_sides.get(side)? * kept).abs())
        };
        self.laws(pair).next().and_then(of_side).unwrap_or(f64::NAN)
    }

    /// Force along the line of action, N, ≥ 0; NaN where the pressure angle is not known.
    pub(super) fn tooth_force(&self, pair: PairId, on: Option<LinkId>) -> f64 {
        let angle = self.transmission(pair).and_then(|t| t.pressure_angle);
        angle.map_or(f64::NAN, |a| self.force_on(pair, on) / libm::cos(a))
    }

    /// Pull in one part of a rope at one of its ends, N, or what the driven side gets; negative where it would have to push.
    #[must_use]
    pub fn tension(&self, pair: PairId, part: usize, end: Option<usize>) -> f64 {
        self.scalar(&Expr::Query(Query::Tension(pair, part, end)))
    }

    pub(super) fn pull_at(&self, pair: PairId, part: usize, end: Option<usize>) -> f64 {
        self.laws(pair).nth(part).map_or(f64::NAN, |(slot, law)| match end {
            Some(end) => law.force * self.state.on_sides(law, slot)[end],
            None => self.pull(slot, law),
        })
    }

    /// Pulls in the tight and in the slack side of a belt, N: about its pretension, or the least with which it does not slip.
    pub(super) fn belt_pulls(&self, pair: PairId) -> [f64; 2] {
        let force = self.tangential_force(pair);
        match self.grip(pair) {
            Some(FrictionLimit::Belt { pretension: Some(at_rest), .. }) => {
                [at_rest + force / 2.0, at_rest - force / 2.0]
            }
            Some(FrictionLimit::Belt { ratio, pretension: None, .. }) => {
                let slack = force / (ratio - 1.0);
                [slack + force, slack]
            }
            Some(FrictionLimit::Clutch(_)) | None => [f64::NAN; 2],
        }
    }

    /// The greatest torque of a clutch, N m, or tangential force of a belt, N; NaN where it has none.
    pub(super) fn capacity(&self, pair: PairId) -> f64 {
        self.grip(pair).map_or(f64::NAN, FrictionLimit::capacity)
    }

    /// Whether a clutch slips that may, or a clutch or a belt must transmit more than its capacity. What is at the limit but for
    /// rounding still grips.
    #[must_use]
    pub fn slips(&self, pair: PairId) -> bool {
        match self.load_of_clutch(pair) {
            Some(load) => self.part_against(load).part != Vec2::zero() || self.runs_free(pair),
            None => self.tangential_force(pair) > self.capacity(pair) * (1.0 + 1e-9),
        }
    }

    /// Whether the second side of a freewheel turns ahead of the first.
    pub(super) fn runs_free(&self, pair: PairId) -> bool {
        let rate = self.state.coordinate_rate(&self.model(), pair);
        self.against_rate(rate).x * self.mechanism.pair(pair).kind.freewheel() < 0.0
    }

    /// The load that a clutch is which slips, by its place.
    #[must_use]
    pub fn load_of_clutch(&self, pair: PairId) -> Option<usize> {
        self.mechanism.pair(pair).kind.slipping()?;
        let is_own = |load: &Load| matches!(load.kind, LoadKind::InPair { pair: own, .. } if own == pair);
        self.mechanism.loads.iter().position(is_own)
    }

    fn grip(&self, pair: PairId) -> Option<FrictionLimit> {
        self.transmission(pair).and_then(|t| t.grip)
    }

    /// Torque of a transmission on a link about its axis, N m.
    pub(super) fn transmission_moment(&self, pair: PairId, link: LinkId) -> f64 {
        if let Some(load) = self.load_of_clutch(pair) {
            let Value::Scalar(on_second) = self.load(load) else { return f64::NAN };
            let second = self.mechanism.pair(pair).kind.slipping().is_some_and(|[_, side]| side == link);
            return if second { on_second } else { -on_second };
        }
        let mut sum = 0.0;
        for (slot, law) in self.laws(pair) {
            for (term, (site, _)) in law.terms.iter().enumerate() {
                if *site == LawSite::Turn(link.index()) {
                    sum += match law.efficiency {
                        None => self.state.law_force(law, slot, term),
                        Some(_) => law.with_losses(term, self.state.on_sides(law, slot)),
                    };
                }
            }
        }
        sum
    }

    /// Force of a mesh on a link, N; NaN where the places of the wheels are not known.
    pub(super) fn mesh_force(&self, pair: PairId, link: LinkId) -> Vec2 {
        let Some((slot, law)) = self.laws(pair).next() else { return NAN_VECTOR };
        let Some(meeting) = &law.meeting else { return NAN_VECTOR };
        let (_, force) = self.state.meeting_force(law, slot, meeting);
        if meeting.links[0] == link {
            force
        } else if meeting.links[1] == link {
            -force
        } else {
            NAN_VECTOR
        }
    }

    /// The pitch point of a mesh, m.
    #[must_use]
    pub fn pitch_point(&self, pair: PairId) -> Option<Vec2> {
        let (slot, law) = self.laws(pair).next()?;
        law.meeting.as_ref().map(|m| self.state.meeting_force(law, slot, m).0)
    }
}
