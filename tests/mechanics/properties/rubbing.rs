//! Friction: what is answered is verified, not solved anew. With all reactions as they are told, friction among them,
//! every link is in equilibrium, and every pair obeys its law against the sense of its motion.

use super::compare::Worst;
use crate::support::draft::Draft;
use crate::support::equilibrium::{Outside, Wrench};
use crate::support::reference::{Body, Reference};
use crate::support::run::{Run, scalar, vector};
use assur::internals::math::Vec2;
use assur::internals::model::{BalanceId, DriveId, Friction, LinkId, PairId, PairKind, Query};
use assur::internals::solve::PoseAnswers;

/// Gives about half of the pairs friction.
pub fn roughen(draft: &mut Draft) {
    for i in 0..draft.mechanism.pairs.len() {
        let links = draft.mechanism.pairs[i].kind.links();
        let rolls = links.iter().any(|l| draft.rollers.contains(l));
        if draft.random.chance(0.4) || rolls {
            continue;
        }
        let coefficient = draft.random.within(0.02, 0.15);
        draft.mechanism.pairs[i].friction = match &draft.mechanism.pairs[i].kind {
            PairKind::Revolute(_) => Some(Friction::Circle(draft.random.within(0.002, 0.02))),
            PairKind::Prismatic(g) if g.contacts.is_some() && draft.random.chance(0.5) => {
                Some(Friction::BothEnds(coefficient))
            }
            PairKind::Prismatic(_) | PairKind::Slot(_) | PairKind::Contact { .. } => {
                Some(Friction::Coefficient(coefficient))
            }
            PairKind::Cylinder { .. } | PairKind::Weld { .. } | PairKind::Transmission(_) => None,
        };
    }
}

struct Check<'a> {
    draft: &'a Draft,
    reference: &'a Reference,
    outside: Outside,
    view: PoseAnswers<'a>,
    /// Scale of forces and torques.
    most: f64,
    worst: Worst,
}

/// `None` where the mechanism is locked, or what acts is not determined.
pub fn verified(draft: &Draft, reference: &Reference, run: &Run) -> Result<Option<Worst>, String> {
    let solved = run.solved(0)?;
    let outside = Outside::new(&draft.mechanism, &reference.bodies, &reference.rates);
    let all_known = run.structure.undetermined_couples.is_empty() && run.structure.force_defect.is_none();
    if solved.state.forces.locked || outside.doubtful || !all_known {
        return Ok(None);
    }
    let force =
        solved.state.forces.reactions.iter().map(|r| r.force.norm().max(r.couple.abs())).fold(1.0, f64::max);
    let sigma = solved.condition.clamp(1e-6, 1.0);
    let most = force / sigma.powi(3);
    let mut check = Check { draft, reference, outside, view: run.view(0)?, most, worst: Worst::default() };
    check.links();
    check.laws();
    check.powers(&draft.mechanism.pairs.iter().enumerate().map(|(i, _)| PairId::at(i)).collect::<Vec<_>>());
    Ok(Some(check.worst))
}

impl Check<'_> {
    fn body(&self, link: LinkId) -> &Body {
        &self.reference.bodies[link.index()]
    }

    /// Velocity of the point of a link at a place.
    fn velocity(&self, link: LinkId, p: Vec2) -> Vec2 {
        let body = self.body(link);
        body.p.rate() + (p - body.p.value()).perp() * self.reference.rates[link.index()].omega
    }

    fn reaction(&self, pair: usize, link: LinkId) -> Vec2 {
        vector(&self.view, &Query::Reaction(PairId::at(pair), link))
    }

    fn moment(&self, pair: usize, link: LinkId) -> f64 {
        scalar(&self.view, &Query::Moment(PairId::at(pair), link))
    }

    /// Every link is in equilibrium under loads, inertia, efforts and the reactions told.
    fn links(&mut self) {
        let m = &self.draft.mechanism;
        let mut sums = self.outside.applied.clone();
        for (i, unit) in self.outside.units.iter().enumerate() {
            let query = if m.balances.is_empty() {
                Query::Effort(DriveId::at(i))
            } else {
                Query::Balance(BalanceId::at(i))
            };
            let value = scalar(&self.view, &query);
            unit.iter().for_each(|(link, w)| sums[link.index()].add(w.times(value)));
        }
        // barrel and rod are one body: what they exchange is not told
        let mut owner: Vec<usize> = (0..sums.len()).collect();
        for (i, pair) in m.pairs.iter().enumerate() {
            let points: Vec<(LinkId, Vec2)> = match &pair.kind {
                PairKind::Revolute(pins) | PairKind::Weld { pins, .. } => {
                    pins.iter().map(|p| (p.link, self.body(p.link).point(p.at).value())).collect()
                }
                PairKind::Prismatic(g) | PairKind::Slot(g) => {
                    let p = self.body(g.slider).point(g.point).value();
                    vec![(g.slider, p), (g.guide, p)]
                }
                PairKind::Contact { first, second, .. } => {
                    let p = self.outside.touching[i].map_or(Vec2::zero(), |t| t.0);
                    vec![(first.link, p), (second.link, p)]
                }
                PairKind::Cylinder { barrel, rod, from, to } => {
                    owner[rod.index()] = barrel.index();
                    for (pin, own) in [(from, barrel), (to, rod)] {
                        let p = self.body(*own).p.value();
                        let force = self.reaction(i, pin.link);
                        sums[pin.link.index()].add(Wrench::at(p, force));
                        sums[own.index()].add(Wrench::at(p, -force));
                    }
                    continue;
                }
                PairKind::Transmission(_) => continue,
            };
            for (link, p) in points {
                sums[link.index()].add(Wrench::at(p, self.reaction(i, link)));
                let couple = match pair.kind {
                    PairKind::Revolute(_) | PairKind::Prismatic(_) | PairKind::Weld { .. } => {
                        self.moment(i, link)
                    }
                    _ => 0.0,
                };
                sums[link.index()].add(Wrench::couple(couple));
            }
        }
        for link in 1..sums.len() {
            if owner[link] != link {
                let rest = sums[link];
                sums[owner[link]].add(rest);
                sums[link] = Wrench::default();
            }
        }
        for (link, sum) in sums.iter().enumerate().skip(1) {
            let off = sum.force.norm().max(sum.moment.abs());
            self.worst.note("equilibrium with friction", off, 10.0 * self.most, || format!("link {link}"));
        }
    }

    fn law(&mut self, pair: usize, got: f64, speed: f64, measure: f64) {
        let still = speed.abs() < 1e-8;
        let want = if still { 0.0 } else { -speed.signum() * measure };
        let what = || {
            format!(
                "pair {pair} of {}: got {got} want {want}, speed {speed}",
                self.draft.mechanism.pairs[pair].kind.links().len()
            )
        };
        self.worst.note("law of friction", (got - want).abs(), self.most, what);
    }

    fn laws(&mut self) {
        let pairs = self.draft.mechanism.pairs.clone();
        for (i, pair) in pairs.iter().enumerate() {
            let id = PairId::at(i);
            match (&pair.kind, pair.friction) {
                (PairKind::Revolute(pins), friction) => {
                    let radius = if let Some(Friction::Circle(r)) = friction { r } else { 0.0 };
                    let omega = |link: LinkId| self.reference.rates[link.index()].omega;
                    for pin in &pins[1..] {
                        let speed = omega(pin.link) - omega(pins[0].link);
                        let measure = radius * self.reaction(i, pin.link).norm();
                        let got = self.moment(i, pin.link);
                        self.law(i, got, speed, measure);
                    }
                }
                (PairKind::Prismatic(g) | PairKind::Slot(g), friction) => {
                    let d = self.body(g.guide).axis(g.along).value();
                    let p = self.body(g.slider).point(g.point).value();
                    let speed = (self.velocity(g.slider, p) - self.velocity(g.guide, p)).dot(d);
                    let force = self.reaction(i, g.slider);
                    let normal = d.perp().dot(force);
                    let measure = match (friction, g.contacts) {
                        (Some(Friction::Coefficient(f)), _) => f * normal.abs(),
                        (Some(Friction::BothEnds(f)), Some([a, b])) => {
                            let couple = self.moment(i, g.slider);
                            let ends = [(couple - normal * b) / (a - b), (normal * a - couple) / (a - b)];
                            f * (ends[0].abs() + ends[1].abs())
                        }
                        _ => 0.0,
                    };
                    self.law(i, force.dot(d), speed, measure);
                    let told = scalar(&self.view, &Query::Friction(id, g.slider));
                    self.worst.note("friction told", (told - force.dot(d)).abs(), self.most, || {
                        format!("pair {i}")
                    });
                }
                (PairKind::Contact { first, second, .. }, friction) => {
                    let Some((p, n)) = self.outside.touching[i] else { continue };
                    let f = if let Some(Friction::Coefficient(f)) = friction { f } else { 0.0 };
                    let speed = (self.velocity(first.link, p) - self.velocity(second.link, p)).dot(n.perp());
                    let force = self.reaction(i, first.link);
                    self.law(i, force.dot(n.perp()), speed, f * force.dot(n).abs());
                }
                (PairKind::Cylinder { .. } | PairKind::Weld { .. } | PairKind::Transmission(_), _) => {}
            }
        }
    }

    /// What the efforts and loads put in, friction takes out.
    fn powers(&mut self, pairs: &[PairId]) {
        let lost: f64 = pairs
            .iter()
            .filter(|p| self.draft.mechanism.pair(**p).friction.is_some())
            .map(|p| scalar(&self.view, &Query::FrictionPower(*p)))
            .sum();
        let m = &self.draft.mechanism;
        let mut input = 0.0;
        for i in 0..self.outside.units.len() {
            input += if m.balances.is_empty() {
                scalar(&self.view, &Query::EffortPower(DriveId::at(i)))
            } else {
                scalar(&self.view, &Query::BalancePower(BalanceId::at(i)))
            };
        }
        for (link, w) in self.outside.applied.iter().enumerate() {
            let body = &self.reference.bodies[link];
            let p = body.p.value();
            input +=
                w.force.dot(body.p.rate()) + (w.moment - p.cross(w.force)) * self.reference.rates[link].omega;
        }
        let speed = self.reference.rates.iter().map(|r| r.v.norm().max(r.omega.abs())).fold(1.0, f64::max);
        let what = || format!("lost {lost} put in {input}");
        self.worst.note("power lost", (lost - input).abs(), 30.0 * self.most * speed, what);
    }
}
