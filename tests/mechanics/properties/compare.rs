//! One solved position against the independent path.

use crate::support::draft::Draft;
use crate::support::reference::Reference;
use crate::support::run::{Run, scalar, vector};
use assur::internals::math::Vec2;
use assur::internals::model::{BalanceId, DriveId, LinkId, PairId, PairKind, PointRef, Query};
use assur::internals::solve::PoseAnswers;

/// Errors are told in units of this, relative to the largest magnitude in play, over a power of the condition figure.
pub const TOLERANCE: f64 = 1e-12;

/// The worst error of each kind, in units of the tolerance.
#[derive(Clone, Debug, Default)]
pub struct Worst {
    pub errors: Vec<(&'static str, f64, String)>,
}

impl Worst {
    /// Notes an error over its scale.
    pub fn note(&mut self, kind: &'static str, error: f64, scale: f64, what: impl FnOnce() -> String) {
        let share = if error == 0.0 { 0.0 } else { error / (scale * TOLERANCE) };
        let share = if share.is_nan() { f64::INFINITY } else { share };
        match self.errors.iter_mut().find(|e| e.0 == kind) {
            Some(e) if share > e.1 => (e.1, e.2) = (share, what()),
            Some(_) => {}
            None => self.errors.push((kind, share, what())),
        }
    }

    pub fn merge(&mut self, other: Self) {
        for (kind, share, what) in other.errors {
            match self.errors.iter_mut().find(|e| e.0 == kind) {
                Some(e) if share > e.1 => (e.1, e.2) = (share, what),
                Some(_) => {}
                None => self.errors.push((kind, share, what)),
            }
        }
    }

    /// Those beyond the tolerance.
    pub fn failures(&self) -> Vec<String> {
        let beyond = self.errors.iter().filter(|e| e.1 > 1.0);
        beyond.map(|(kind, share, what)| format!("{kind}: {share:.3e} tolerances, {what}")).collect()
    }
}

/// What one comparison leans on.
struct Comparison<'a> {
    draft: &'a Draft,
    reference: &'a Reference,
    view: PoseAnswers<'a>,
    sigma: f64,
    worst: Worst,
}

/// Compares the first position of a run.
pub fn compare(draft: &Draft, reference: &Reference, run: &Run) -> Result<Worst, String> {
    let solved = run.solved(0)?;
    let mut comparison = Comparison {
        draft,
        reference,
        view: run.view(0)?,
        sigma: solved.condition.clamp(1e-6, 1.0),
        worst: Worst::default(),
    };
    comparison.motion();
    comparison.coordinates();
    if reference.forces.as_ref().is_some_and(|f| !f.doubtful && f.condition > 0.0) {
        comparison.reactions();
        comparison.efforts();
    }
    let sigma = comparison.sigma;
    let residuals = &solved.residuals;
    let mut note = |kind, x: f64| comparison.worst.note(kind, x, 10.0 / sigma, String::new);
    note("closure residual", residuals.closure);
    note("equilibrium residual", residuals.equilibrium.unwrap_or(0.0));
    note("power residual", residuals.power.unwrap_or(0.0));
    Ok(comparison.worst)
}

impl Comparison<'_> {
    fn most(&self, of: impl Fn(&crate::support::reference::Rates) -> f64) -> f64 {
        self.reference.rates.iter().map(of).fold(1.0, f64::max)
    }

    fn note(&mut self, kind: &'static str, got: f64, want: f64, scale: f64, what: impl FnOnce() -> String) {
        self.worst.note(kind, (got - want).abs(), scale, || format!("{} got {got} want {want}", what()));
    }

    fn note_vector(
        &mut self,
        kind: &'static str,
        got: Vec2,
        want: Vec2,
        scale: f64,
        what: impl FnOnce() -> String,
    ) {
        self.worst.note(kind, (got - want).norm(), scale, || format!("{} got {got:?} want {want:?}", what()));
    }

    fn motion(&mut self) {
        let (speed, sigma) = (self.most(|r| r.v.norm().max(r.omega.abs())), self.sigma);
        let most = self.most(|r| r.a.norm().max(r.alpha.abs()).max(r.omega * r.omega));
        let acceleration = most.max(speed * speed);
        let size = self.draft.frames.iter().map(|f| f.p.norm()).fold(1.0, f64::max);
        for (i, frame) in self.draft.frames.clone().iter().enumerate().skip(1) {
            let (link, rates, body) = (LinkId::at(i), self.reference.rates[i], self.reference.bodies[i]);
            let local = Vec2::new(0.3, -0.2);
            let point = PointRef::Fixed(link, local);
            let there = body.point(local);
            let view = self.view;
            let name = || format!("link {i}");
            let position = vector(&view, &Query::Position(point));
            self.note_vector("position", position, there.value(), size / sigma, name);
            let direction = vector(&view, &Query::LinkDirection(link));
            self.note_vector("direction", direction, frame.u, size / sigma, name);
            let scale = speed / sigma.powi(2);
            self.note_vector("velocity", vector(&view, &Query::Velocity(point)), there.rate(), scale, name);
            self.note("omega", scalar(&view, &Query::Omega(link)), rates.omega, scale, name);
            let scale = acceleration / sigma.powi(3);
            let got = vector(&view, &Query::Acceleration(point));
            self.note_vector("acceleration", got, there.second(), scale, name);
            self.note("alpha", scalar(&view, &Query::Alpha(link)), rates.alpha, scale, name);
        }
    }

    fn coordinates(&mut self) {
        let sigma = self.sigma;
        let speed = self.most(|r| r.v.norm().max(r.omega.abs()));
        let most = self.most(|r| r.a.norm().max(r.alpha.abs())).max(speed * speed);
        for (i, pair) in self.draft.mechanism.pairs.clone().iter().enumerate() {
            let (id, view) = (PairId::at(i), self.view);
            let name = || format!("pair {i}");
            let body =
                |link: LinkId| (&self.reference.bodies[link.index()], self.reference.rates[link.index()]);
            let want = match &pair.kind {
                PairKind::Revolute(pins) if pins.len() == 2 => {
                    let ((_, a), (_, b)) = (body(pins[0].link), body(pins[1].link));
                    Some((b.omega - a.omega, b.alpha - a.alpha, Vec2::zero()))
                }
                PairKind::Prismatic(g) | PairKind::Slot(g) => {
                    let ((s, _), (c, rates)) = (body(g.slider), body(g.guide));
                    let from = s.point(g.point).minus(c.point(g.through));
                    let coordinate = from.dot(c.axis(g.along));
                    let got = scalar(&view, &Query::Displacement(id));
                    self.note("coordinate", got, coordinate.value, 3.0 / sigma, name);
                    let d = c.axis(g.along).value();
                    let coriolis = d.perp() * (2.0 * rates.omega * coordinate.rate);
                    Some((coordinate.rate, coordinate.second, coriolis))
                }
                PairKind::Cylinder { .. }
                | PairKind::Contact { .. }
                | PairKind::Revolute(_)
                | PairKind::Weld { .. }
                | PairKind::Transmission(_) => None,
            };
            let Some((rate, second, coriolis)) = want else { continue };
            let got = scalar(&view, &Query::RelativeVelocity(id));
            self.note("coordinate rate", got, rate, 4.0 * speed / sigma.powi(2), name);
            let scale = 4.0 * most / sigma.powi(3);
            let got = scalar(&view, &Query::RelativeAcceleration(id));
            self.note("coordinate second rate", got, second, scale, name);
            if !matches!(pair.kind, PairKind::Revolute(_)) {
                self.note_vector("coriolis", vector(&view, &Query::Coriolis(id)), coriolis, scale, name);
            }
        }
    }

    fn reactions(&mut self) {
        let reference = self.reference;
        let Some(forces) = &reference.forces else { return };
        let view = self.view;
        let (scale, scale_moment) = (forces.most.0 / self.sigma.powi(3), forces.most.1 / self.sigma.powi(3));
        for on in &forces.reactions {
            let name = || format!("pair {} on link {}", on.pair.0, on.link.0);
            let pair = self.draft.mechanism.pair(on.pair);
            if let PairKind::Cylinder { barrel, rod, .. } = pair.kind
                && (on.link == barrel || on.link == rod)
            {
                continue;
            }
            if on.determined.0 {
                let got = vector(&view, &Query::Reaction(on.pair, on.link));
                self.note_vector("reaction", got, on.force, scale, name);
            }
            let PairKind::Prismatic(g) = &pair.kind else { continue };
            let moment = scalar(&view, &Query::Moment(on.pair, on.link));
            if on.determined.1 {
                self.note("couple", moment, on.couple, scale_moment, name);
            } else if !moment.is_nan() {
                self.worst.note("couple said determined", 1.0, 1.0, name);
            }
            if let (Some([a, b]), true) =
                (g.contacts, on.determined.0 && on.determined.1 && on.link == g.slider)
            {
                let n = [1, 2].map(|k| scalar(&view, &Query::ContactForce(on.pair, k)));
                let normal =
                    self.reference.bodies[g.guide.index()].axis(g.along).value().perp().dot(on.force);
                let scale = scale.max(scale_moment) / (b - a).abs();
                self.note("contact forces", n[0] + n[1], normal, scale, name);
                self.note("contact forces", n[0] * a + n[1] * b, on.couple, scale, name);
            }
        }
    }

    fn efforts(&mut self) {
        let reference = self.reference;
        let Some(forces) = &reference.forces else { return };
        let scale = forces.most.0.max(forces.most.1) / self.sigma.powi(3);
        let balanced = !self.draft.mechanism.balances.is_empty();
        let view = self.view;
        for (i, (effort, power)) in forces.efforts.iter().zip(&forces.effort_powers).enumerate() {
            let (value, its_power) = if balanced {
                (Query::Balance(BalanceId::at(i)), Query::BalancePower(BalanceId::at(i)))
            } else {
                (Query::Effort(DriveId::at(i)), Query::EffortPower(DriveId::at(i)))
            };
            let name = || format!("effort {i}");
            self.note("effort", scalar(&view, &value), *effort, scale, name);
            let speed = self.most(|r| r.v.norm().max(r.omega.abs()));
            self.note("effort power", scalar(&view, &its_power), *power, scale * speed, name);
        }
        let speed = self.most(|r| r.v.norm().max(r.omega.abs()));
        self.worst.note("power of the reference", forces.power.abs(), scale * speed, String::new);
    }
}
