//! What masses and loads do along a free coordinate: power of inertia forces and loads at the velocities of a unit rate.

use super::body::BodyState;
use super::reduced::Column;
use crate::force::spring::spring;
use crate::math::Vec2;
use crate::plan::{Anchor, Arm, LoadStep, MotionStep, Plan};

/// Sums along a free coordinate.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Along {
    /// Σ m v² + J ω².
    pub mass: f64,
    /// Σ m a·v + J α ω, with the accelerations that there are.
    pub inertia: f64,
    /// Power of the loads that are numbers.
    pub loads: f64,
}

/// The mass of a body.
#[derive(Clone, Copy, Debug)]
struct Heavy {
    body: usize,
    /// In the body's frame, m.
    centre: Vec2,
    /// kg.
    mass: f64,
    /// About the centre, kg m²; about the origin of a body that turns about it.
    moment_of_inertia: f64,
    /// N.
    weight: Vec2,
    moves: bool,
    /// The origin rests, and there is no weight.
    turns: bool,
}

impl Heavy {
    /// Adds what it does at the velocity of the body's origin and the angular velocity of a unit rate.
    #[inline(always)]
    fn add<const LEVEL: u8>(&self, body: &BodyState, v: Vec2, omega: f64, sum: &mut Along) {
        sum.mass += self.moment_of_inertia * omega * omega;
        if LEVEL > 1 && self.moves {
            sum.inertia += self.moment_of_inertia * body.alpha * omega;
        }
        if self.turns {
            return;
        }
        let r = self.centre.turned(body.u);
        let v = v + r.perp() * omega;
        sum.mass += self.mass * v.dot(v);
        if LEVEL > 1 && self.moves {
            let a = body.a + r.perp() * body.alpha - r * (body.omega * body.omega);
            sum.inertia += self.mass * a.dot(v);
        }
        sum.loads += self.weight.dot(v);
    }
}

/// The masses of a plan, and its other loads that are numbers.
#[derive(Clone, Debug)]
pub(super) struct Loads {
    /// In the order in which steps of motion place them.
    masses: Vec<Heavy>,
    /// After how many masses a step of motion has placed its own.
    placed: Vec<usize>,
    others: Vec<LoadStep>,
}

impl Loads {
    pub fn of(plan: &Plan) -> Self {
        let (mut masses, mut others) = (Vec::new(), Vec::new());
        for load in &plan.loads {
            match load {
                &LoadStep::Mass { body, centre, mass, moment_of_inertia, weight, inertia, .. } => {
                    let (after, turns) = placing(plan, body);
                    let centre = centre.unwrap_or_default();
                    let turns = turns && weight == Vec2::zero();
                    let about = if turns { mass * centre.dot(centre) } else { 0.0 };
                    let moment_of_inertia = moment_of_inertia + about;
                    let heavy =
                        Heavy { body, centre, mass, moment_of_inertia, weight, moves: inertia, turns };
                    masses.push((after, heavy));
                }
                LoadStep::Evaluated(_) => {}
                other => others.push(other.clone()),
            }
        }
        masses.sort_by_key(|(after, _)| *after);
        let steps = 0..plan.motion.len();
        let placed = steps.map(|step| masses.partition_point(|(after, _)| *after <= step)).collect();
        Self { masses: masses.into_iter().map(|(_, heavy)| heavy).collect(), placed, others }
    }

    /// The sums of all masses for the velocities of a unit rate.
    pub fn of_masses(&self, bodies: &[BodyState], column: &[Column]) -> Along {
        let mut sum = Along::default();
        for heavy in &self.masses {
            let Column { v, omega } = column[heavy.body];
            heavy.add::<2>(&bodies[heavy.body], v, omega, &mut sum);
        }
        sum
    }

    /// Adds the masses that a step of motion has placed, of bodies that move at the unit rate; for a `LEVEL` of 1
    /// without accelerations.
    #[inline]
    pub fn add_placed<const LEVEL: u8>(&self, step: usize, bodies: &[BodyState], sum: &mut Along) {
        let begin = step.checked_sub(1).map_or(0, |before| self.placed[before]);
        for heavy in &self.masses[begin..self.placed[step]] {
            let body = &bodies[heavy.body];
            heavy.add::<LEVEL>(body, body.v, body.omega, sum);
        }
    }

    /// The sums of all masses, of bodies that move at the unit rate.
    pub fn at_unit_rate<const LEVEL: u8>(&self, bodies: &[BodyState]) -> Along {
        let mut sum = Along::default();
        (0..self.placed.len()).for_each(|step| self.add_placed::<LEVEL>(step, bodies, &mut sum));
        sum
    }

    /// The power of the loads that are no masses for the velocities of a unit rate.
    pub fn of_others(&self, bodies: &[BodyState], column: &[Column]) -> f64 {
        self.others.iter().map(|load| power(load, bodies, |body| column[body])).sum()
    }

    /// The mass that goes with the velocities of unit rates of two coordinates.
    pub fn mass_between(&self, bodies: &[BodyState], columns: [&[Column]; 2]) -> f64 {
        let of = |heavy: &Heavy| {
            let [omega_v, omega_w] = columns.map(|column| column[heavy.body].omega);
            let turned = heavy.moment_of_inertia * omega_v * omega_w;
            if heavy.turns {
                return turned;
            }
            let body = &bodies[heavy.body];
            let [v, w] = columns.map(|column| velocity(column[heavy.body], body, heavy.centre));
            heavy.mass * v.dot(w) + turned
        };
        self.masses.iter().map(of).sum()
    }
}

/// The step of motion that places a body, as far as it stands here, else the last; and whether the body's origin is a revolute on
/// the ground.
fn placing(plan: &Plan, body: usize) -> (usize, bool) {
    let on_ground = |base: &Anchor, pin: &Arm| base.body == 0 && pin.is_none();
    let by = |step: &MotionStep| match step {
        MotionStep::Turn { body: turned, base, pin, .. } => (*turned == body).then(|| on_ground(base, pin)),
        MotionStep::Rrr { legs, .. } => {
            let leg = legs.iter().find(|leg| leg.body == body)?;
            Some(on_ground(&leg.base, &leg.pin))
        }
        MotionStep::Shift { slide, .. } => (slide.body == body).then_some(false),
        MotionStep::Free { body: free, .. } => (*free == body).then_some(false),
        MotionStep::Rrp { leg, slide, .. } if leg.body == body => Some(on_ground(&leg.base, &leg.pin)),
        MotionStep::Rrp { slide, .. } => (slide.body == body).then_some(false),
        _ => None,
    };
    let steps = plan.motion.iter().enumerate();
    let found = steps.filter_map(|(index, step)| by(step).map(|turns| (index, turns))).next();
    found.unwrap_or((plan.motion.len().saturating_sub(1), false))
}

/// The power of a load that is a number, inertia forces left out, of bodies with these velocities. Dampers act by the velocities that
/// the bodies have.
pub(super) fn power(load: &LoadStep, bodies: &[BodyState], moves: impl Fn(usize) -> Column) -> f64 {
    let velocity = |body: usize, at: Vec2| velocity(moves(body), &bodies[body], at);
    match load {
        LoadStep::Mass { weight, .. } if *weight == Vec2::zero() => 0.0,
        LoadStep::Mass { body, centre, weight, .. } => {
            weight.dot(velocity(*body, centre.unwrap_or_default()))
        }
        LoadStep::Force { body, at, force, frame, .. } => {
            let force = frame.map_or(*force, |f| force.turned(bodies[f].u));
            force.dot(velocity(*body, *at))
        }
        LoadStep::Torque { body, torque, .. } => torque * moves(*body).omega,
        LoadStep::Spring { ends: [one, two], stiffness, free_length, damping, .. } => {
            let [b_1, b_2] = [one, two].map(|end| &bodies[end.body]);
            let r = b_2.position(two.at) - b_1.position(one.at);
            let (v, damping) = damping.map_or((Vec2::zero(), 0.0), |damping| {
                (b_2.velocity(two.at) - b_1.velocity(one.at), damping)
            });
            let got = spring(r, v, *stiffness, *free_length, damping);
            got.f_1.dot(velocity(one.body, one.at) - velocity(two.body, two.at))
        }
        LoadStep::Evaluated(_) => 0.0,
    }
}

/// Velocity of a point of a body that moves so.
fn velocity(Column { v, omega }: Column, body: &BodyState, at: Vec2) -> Vec2 {
    v + at.turned(body.u).perp() * omega
}
