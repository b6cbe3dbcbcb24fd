//! Results that no step needs and that the file asks for: energies, forces of transmissions, pulls of belts, powers, relative motion.

use crate::angle::Angle;
use crate::course::{Derivation, joined};
use crate::expressions::length;
use crate::motion::{end, pin};
use assur_formula::{Expr, Function, Name, Unit};
use assur_math::math::{SAME, Vec2};
use assur_model::model::{
    FlywheelPart, FrictionLimit, LinkId, PairId, PairKind, PointRef, ProfileShape, Query, SpringId,
    Transmission, Value,
};
use assur_model::structure::BodyOrigin;
use assur_position::plan::{FrictionElement, FrictionLaw, MotionStep};
use assur_position::position::Origin;
use assur_solve::answer::FollowerWay;

impl Derivation<'_> {
    /// What a question comes to, from what the steps have found; none where it is of another kind.
    pub(crate) fn derived(&mut self, query: &Query) -> Option<Expr> {
        match query {
            Query::KineticEnergy => {
                let Value::Scalar(x) = self.scene.view().query(query) else { return None };
                let known = self.with_value([Name::new("T", "")].into_iter(), x);
                Some(known.unwrap_or_else(|| self.energy_of_links()))
            }
            Query::PotentialEnergy => Some(self.potential_energy()),
            Query::TorsionEnergy(spring, pair) => self.torsion_energy(*spring, *pair),
            Query::Turning(link, other) => {
                Some(self.rate_of_body(link.index(), 0) - self.rate_of_body(other.index(), 0))
            }
            Query::CurvatureRadius(PointRef::Fixed(link, at)) => {
                let (v, bend) = self.bend(link.index(), *at);
                Some(Expr::Power(Box::new(length(v)), 3) / bend)
            }
            Query::Sliding(pair) => self.sliding(*pair),
            Query::TangentialForce(pair, on) => self.force_of_mesh(*pair, *on),
            Query::ToothForce(pair, on) => {
                let tangential = self.force_of_mesh(*pair, *on)?;
                let degrees = self.transmission(*pair)?.pressure_angle?.to_degrees();
                let words = self.scene.mechanism().pair(*pair).name.clone();
                Some(tangential / self.given(Name::new("α", &words), degrees, Unit::Angle).cos())
            }
            Query::Tension(pair, part, end) => {
                let slot = self.laws_of(*pair).nth(*part)?;
                let found = self.found.get(&self.law_name(slot).0).cloned()?;
                Some(end.map_or(Expr::Int(1), |end| self.side(slot, end)) * found)
            }
            Query::TightSide(pair) => self.pulls(*pair).map(|[tight, _]| tight),
            Query::SlackSide(pair) => self.pulls(*pair).map(|[_, slack]| slack),
            Query::Capacity(pair) => self.capacity(*pair),
            Query::LineOffset(pair) => {
                let coordinate = self.result(&assur_model::model::Expr::Query(Query::Displacement(*pair)))?;
                let Value::Scalar(x) = self.scene.view().query(query) else { return None };
                let normal =
                    self.reactions_of(*pair).iter().find_map(|name| self.found.get(name).cloned())?;
                let couple = self.couples_of(*pair).iter().find_map(|name| self.found.get(name).cloned())?;
                let offset = couple / normal;
                let both = [coordinate.clone() + offset.clone(), coordinate - offset];
                both.into_iter().find(|sum| (sum.value() - x).abs() <= SAME * sum.scale())
            }
            Query::Load(id) => {
                let Value::Scalar(x) = self.scene.view().query(query) else { return None };
                let couples = self.free.couples.iter().flatten();
                let own = couples.filter(|couple| couple.from == Some(Origin::Load(*id)));
                let mut own = own.map(|couple| couple.value.clone());
                own.find_map(|value| [value.clone(), -value].into_iter().find(|value| value.value() == x))
            }
            Query::Flywheel(which, FlywheelPart::LinksInertia) => {
                let shaft = self.scene.mechanism().flywheels.get(*which)?.on;
                let energy = self.energy_of_links();
                Some(Expr::Int(2) * energy / self.rate_of_body(shaft.index(), 0).squared())
            }
            Query::LoadPower(id) => Some(self.power_from(Origin::Load(*id))),
            Query::SpringPower(i) => Some(self.power_from(Origin::Spring(SpringId::at(*i)))),
            _ => None,
        }
    }

    /// Velocity of a point, and v × a.
    fn bend(&mut self, body: usize, at: Vec2) -> ([Expr; 2], Expr) {
        let ([x, y], [a_x, a_y]) = (self.velocity(body, at), self.acceleration(body, at));
        let bend = x.clone() * a_y - y.clone() * a_x;
        ([x, y], bend)
    }

    /// Where the path of a point has its centre of curvature.
    pub(crate) fn centre_of_curvature(&mut self, body: usize, at: Vec2) -> [Expr; 2] {
        let [x, y] = self.position(body, at);
        let ([v_x, v_y], bend) = self.bend(body, at);
        let squared = v_x.clone().squared() + v_y.clone().squared();
        [x - v_y * squared.clone() / bend.clone(), y + v_x * squared / bend]
    }

    /// Σ G y of weights from y = 0, and ½ c Δl² of springs.
    fn potential_energy(&mut self) -> Expr {
        let mechanism = self.scene.mechanism();
        let mut sum = Expr::ZERO;
        let gravity = mechanism.gravity.map(|gravity| gravity.acceleration).filter(|g| g.norm() > 0.0);
        for (i, link) in mechanism.links.iter().enumerate().skip(1) {
            let (Some(mass), Some(g)) = (link.mass.filter(|m| m.mass > 0.0), gravity) else { continue };
            let place = self.position(i, mass.centre);
            let down = self.direction_given(g, || Name::new("γ", "g"));
            let own = self.given(Name::new("m", &self.label(i)), mass.mass, Unit::Mass);
            let g = self.given(Name::new("g", ""), g.norm(), Unit::Acceleration);
            sum = sum - own * g * down.along(&place);
        }
        for spring in mechanism.springs.iter().filter(|spring| spring.stiffness != 0.0) {
            let [one, two] = [spring.from, spring.to].map(|(link, at)| self.position(link.index(), at));
            let [x, y] = one;
            let d = [two[0].clone() - x, two[1].clone() - y];
            let own = length(self.distance_parts(&Name::new("l", &spring.name), &d));
            let free =
                self.given(Name::new("l", &format!("0,{}", spring.name)), spring.free_length, Unit::Length);
            let stiffness = self.given(Name::new("c", &spring.name), spring.stiffness, Unit::Stiffness);
            sum = sum + stiffness * (own - free).squared() / Expr::Int(2);
        }
        sum
    }

    /// The length that a step has, as a vector of one part; else both parts.
    fn distance_parts(&self, name: &Name, d: &[Expr; 2]) -> [Expr; 2] {
        let value = d[0].value().hypot(d[1].value());
        match self.with_value([name.clone()].into_iter(), value) {
            Some(known) => [known, Expr::ZERO],
            None => d.clone(),
        }
    }

    fn torsion_energy(&mut self, spring: usize, pair: PairId) -> Option<Expr> {
        let own = self.scene.mechanism().torsion_springs.get(spring)?;
        let words = self.scene.mechanism().pair(pair).name.clone();
        let (stiffness, free) = (own.stiffness, own.free_angle.to_degrees());
        let angle = self.degrees_in_letters(&assur_model::model::Expr::Query(Query::Displacement(pair)))?;
        let c = self.given(Name::new("c", &words), stiffness, Unit::TorsionStiffness);
        let free = self.given(Name::new("φ", &format!("0,{words}")), free, Unit::Angle);
        Some(c * (Expr::Pi * (angle - free) / Expr::Int(180)).squared() / Expr::Int(2))
    }

    /// The sliding velocity of a pair: of a contact along the tangent.
    fn sliding(&mut self, pair: PairId) -> Option<Expr> {
        let PairKind::Contact { first, second, internal, .. } = &self.scene.mechanism().pair(pair).kind
        else {
            return self.scalar_symbol(&Query::RelativeVelocity(pair));
        };
        if [first, second].iter().all(|p| matches!(p.shape, ProfileShape::Line(..) | ProfileShape::Rim(_))) {
            return None;
        }
        let (body, base) = (first.link.index(), second.link.index());
        let kind = FrictionLaw::Contact {
            coefficient: 0.0,
            first: first.shape,
            second: second.shape,
            internal: *internal,
            presses: 0.0,
        };
        let element =
            FrictionElement { pair, body, base, through: body, slot: 0, kind, pin: None, stop: None };
        self.sliding_in_contact(&element)
    }

    /// The angle between the two links of a dyad with three hinges, degrees.
    pub(crate) fn transmission_angle(&mut self, group: usize) -> Option<Expr> {
        let view = self.scene.view();
        let Value::Scalar(x) = view.query(&Query::TransmissionAngle(group)) else { return None };
        let name = self.scene.mechanism().groups.get(group)?.name.clone();
        let motion = &self.structure().motion;
        let index = motion.iter().position(|group| group.name.as_ref() == Some(&name))?;
        let MotionStep::Rrr { legs, .. } = self.scene.model.plan.motion.get(index)? else { return None };
        let [one, two] = motion[index].bodies.as_slice() else { return None };
        let [one, two] = [(one, &legs[0]), (two, &legs[1])]
            .map(|(body, leg)| self.line_of(body.0, pin(&leg.pin), end(leg)).1);
        folded(&one.minus(&two), x)
    }

    /// The angle between the common normal of a contact and the way of the follower's point, degrees.
    pub(crate) fn pressure_angle(&mut self, pair: PairId) -> Option<Expr> {
        let view = self.scene.view();
        let Value::Scalar(x) = view.query(&Query::PressureAngle(pair)) else { return None };
        let (follower, way) = view.way_of_follower(pair)?;
        let follower = follower.index();
        let bodies = &self.structure().replaced.bodies;
        let block = (0..bodies.len()).find(|i| bodies[*i].origin == BodyOrigin::Imaginary(pair))?;
        let normal = self.bodies[block].as_ref()?.angle.clone();
        let own = match way {
            FollowerWay::Along(along) => {
                self.direction_given(along, || Name::new("λ", &self.label(follower)))
            }
            FollowerWay::About { hinge, point } => {
                let index = [hinge, point].map(|at| self.point_name(follower, at));
                let arm =
                    self.direction_given(point - hinge, || Name::new("γ", &joined(&index[0], &index[1])));
                Angle { quarters: arm.quarters + 1, ..arm }
            }
        };
        let way = self.bodies[follower].as_ref()?.angle.plus(&own);
        // the direction of the block is the tangent
        let between = normal.minus(&way);
        folded(&between, x)
    }

    pub(crate) fn transmission(&self, pair: PairId) -> Option<&Transmission> {
        match &self.scene.mechanism().pair(pair).kind {
            PairKind::Transmission(transmission) => Some(transmission),
            _ => None,
        }
    }

    fn laws_of(&self, pair: PairId) -> impl Iterator<Item = usize> + '_ {
        let laws = self.scene.model.plan.laws.iter().enumerate();
        laws.filter(move |(_, law)| law.pair == pair).map(|(slot, _)| slot)
    }

    /// The tangential force of a transmission: on a link, or what the driven side gets.
    fn force_of_mesh(&mut self, pair: PairId, on: Option<LinkId>) -> Option<Expr> {
        let slot = self.laws_of(pair).next()?;
        let found = self.found.get(&self.law_name(slot).0).cloned()?;
        let sides = self.state().forces.law_forces[slot].sides;
        let transmission = self.transmission(pair)?;
        let side = match on {
            Some(link) => transmission.links.iter().position(|own| *own == link)?,
            None => usize::from(sides[1].abs() < sides[0].abs()),
        };
        let kept = if side == 0 && on.is_some() { transmission.slip } else { 0.0 };
        let kept = if kept == 0.0 {
            Expr::Int(1)
        } else {
            let words = self.scene.mechanism().pair(pair).name.clone();
            Expr::Int(1) - self.given(Name::new("s", &words), kept, Unit::One)
        };
        let size = if found.value() < 0.0 { -found } else { found };
        Some(size * self.side(slot, side) * kept)
    }

    /// The pulls in both sides of a belt.
    fn pulls(&mut self, pair: PairId) -> Option<[Expr; 2]> {
        let force = self.force_of_mesh(pair, None)?;
        let words = self.scene.mechanism().pair(pair).name.clone();
        match self.transmission(pair)?.grip? {
            FrictionLimit::Belt { pretension: Some(at_rest), .. } => {
                let half = force / Expr::Int(2);
                let at_rest = self.given(Name::new("F", &format!("0,{words}")), at_rest, Unit::Force);
                Some([at_rest.clone() + half.clone(), at_rest - half])
            }
            FrictionLimit::Belt { ratio, wrap, groove, pretension: None } => {
                let q = self.ratio_of_pulls(&words, ratio, wrap, groove);
                let slack = force.clone() / (q - Expr::Int(1));
                Some([slack.clone() + force, slack])
            }
            FrictionLimit::Clutch(_) => None,
        }
    }

    /// The ratio of the pulls at which a belt slips: e^(f β), with the friction of a groove over the sine of its half angle.
    fn ratio_of_pulls(&mut self, words: &str, ratio: f64, wrap: f64, groove: Option<f64>) -> Expr {
        let sine = groove.map_or(1.0, libm::sin);
        let mut friction = self.given(Name::new("f", words), sine * libm::log(ratio) / wrap, Unit::One);
        if let Some(half) = groove {
            friction = friction / self.given(Name::new("γ", words), half.to_degrees(), Unit::Angle).sin();
        }
        let angle = self.given(Name::new("β", words), wrap.to_degrees(), Unit::Angle);
        let right = (Expr::Pi * friction * angle / Expr::Int(180)).of(Function::Exp);
        self.equate(Name::new("q", words), ratio, Unit::One, right)
    }

    fn capacity(&mut self, pair: PairId) -> Option<Expr> {
        let words = self.scene.mechanism().pair(pair).name.clone();
        match self.transmission(pair)?.grip? {
            FrictionLimit::Belt { ratio, wrap, groove, pretension: Some(at_rest) } => {
                let q = self.ratio_of_pulls(&words, ratio, wrap, groove);
                let at_rest = self.given(Name::new("F", &format!("0,{words}")), at_rest, Unit::Force);
                Some(Expr::Int(2) * at_rest * (q.clone() - Expr::Int(1)) / (q + Expr::Int(1)))
            }
            FrictionLimit::Belt { .. } | FrictionLimit::Clutch(_) => None,
        }
    }

    /// The power of what comes from this, on all links on which it acts.
    pub(crate) fn power_from(&mut self, from: Origin) -> Expr {
        Expr::sum(self.powers_on(&self.moving(), |own| own == Some(from)))
    }
}

/// Of the directions that differ by quarter turns, with both signs, the one that is asked for, rad; without whole turns where it can be.
fn folded(between: &Angle, asked: f64) -> Option<Expr> {
    let all = [0, 360, -360].into_iter().flat_map(|more| {
        (0..4).flat_map(move |quarters| {
            let sum = between.plus(&Angle { part: None, quarters }).whole() + Expr::Degrees(more);
            [sum.clone(), -sum]
        })
    });
    all.into_iter().find(|right| (right.value() - asked.to_degrees()).abs() <= SAME * 360.0)
}
