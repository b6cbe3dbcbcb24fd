//! Forces of trains: multipliers of their laws, efforts, reactions of their members.

use super::state::State;
use crate::math::Vec2;
use crate::plan::{LawSite, Plan, PlannedLaw, TrainEffort, TrainForces, TrainSupport};

/// Memory of a train group of forces.
#[derive(Clone, Debug, Default)]
pub struct TrainWork {
    /// The system with its right side.
    rows: Vec<f64>,
    /// Loads on the members' coordinates.
    loads: Vec<f64>,
    /// Forces that members get from those that stand on them.
    carried: Vec<(Vec2, f64)>,
    /// The unknowns.
    found: Vec<f64>,
    /// Unknowns of a case that is tried.
    trial: Vec<f64>,
}

/// More transmissions with losses than this in one group are not tried in all senses.
const MOST_SENSES: usize = 10;
/// Powers below this part of the greatest are nothing.
const NOTHING: f64 = 1e-9;

impl TrainWork {
    pub(super) fn new(train: &TrainForces) -> Self {
        let (n, unknowns) = (train.members.len(), train.laws.len() + train.efforts.len());
        Self {
            rows: vec![0.0; n * (unknowns + 1)],
            loads: vec![0.0; n],
            carried: vec![(Vec2::zero(), 0.0); n],
            found: vec![0.0; unknowns],
            trial: vec![0.0; unknowns],
        }
    }
}

impl State {
    /// Finds the multipliers and efforts of a train from the loads on its members, and the reactions of their pairs.
    pub(super) fn force_train(&mut self, plan: &Plan, index: usize, losses: bool) -> f64 {
        let train = &plan.train_forces[index];
        if train.inverse.is_empty() {
            return 0.0;
        }
        let Some(mut work) = self.train_work.get_mut(index).map(std::mem::take) else { return 0.0 };
        self.train_loads(train, &mut work);
        let n = train.members.len();
        for i in 0..n {
            let row = &train.inverse[i * n..][..n];
            work.found[i] = -row.iter().zip(&work.loads).map(|(a, q)| a * q).sum::<f64>();
        }
        for &law in &train.laws {
            self.law_forces[law].sides = [1.0, 1.0];
        }
        // no sense of the flow of power fits: the efforts cannot hold the loads
        let fits = !losses || self.with_losses(plan, train, &mut work);
        for (unknown, &law) in work.found.iter().zip(&train.laws) {
            self.law_forces[law].multiplier = *unknown;
        }
        self.train_reactions(plan, train, &work);
        self.train_work[index] = work;
        if fits { 1.0 } else { 0.0 }
    }

    /// Loads on the members' coordinates: moments about their hinges, forces along their guides.
    fn train_loads(&self, train: &TrainForces, work: &mut TrainWork) {
        work.carried.fill((Vec2::zero(), 0.0));
        for (i, member) in train.members.iter().enumerate().rev() {
            let (more, moment) = work.carried[i];
            match member {
                TrainSupport::Turn(hinge, carrier) => {
                    let body = &self.bodies[hinge.body];
                    let (p, force, about) = self.load_at(hinge.body, &hinge.pin);
                    let lever = (body.p - p).cross(more);
                    work.loads[i] = about + moment + lever;
                    if let Some(carrier) = carrier
                        && let Some(TrainSupport::Turn(base, _)) = train.members.get(*carrier)
                    {
                        // reduced to the origin of the carrier
                        let r = p - self.bodies[base.body].p;
                        work.carried[*carrier].0 += force + more;
                        work.carried[*carrier].1 += r.cross(force + more);
                    }
                }
                TrainSupport::Shift(way, sign) => {
                    let force = self.wrenches[way.body].force + more;
                    work.loads[i] = sign * force.dot(self.direction(way));
                }
            }
        }
    }

    /// Finds the senses in which power flows through transmissions with losses. Whether there are such.
    fn with_losses(&mut self, plan: &Plan, train: &TrainForces, work: &mut TrainWork) -> bool {
        let moving = |state: &Self, slot: usize| {
            let law = &plan.laws[slot];
            law.efficiency.is_some() && state.side_rates(law).iter().any(|r| *r != 0.0)
        };
        let lossy = train.laws.iter().filter(|l| moving(self, **l)).count();
        if lossy == 0 {
            return true;
        }
        let lossy = lossy.min(MOST_SENSES);
        for senses in 0..1_usize << lossy {
            let mut bit = 0;
            for &slot in &train.laws {
                if moving(self, slot) && bit < lossy {
                    let [there, back] = plan.laws[slot].efficiency.unwrap_or([1.0, 1.0]);
                    let backwards = senses >> bit & 1 == 1;
                    self.law_forces[slot].sides = if backwards { [back, 1.0] } else { [1.0, there] };
                    bit += 1;
                }
            }
            if self.unknowns(plan, train, work) && self.flows(plan, train, work, senses, lossy) {
                work.found.copy_from_slice(&work.trial);
                return true;
            }
        }
        false
    }

    /// Rates of the two sides from the carrier.
    fn side_rates(&self, law: &PlannedLaw) -> [f64; 2] {
        let rate = |i: usize| law.terms.get(i).map_or(0.0, |t| self.site_rate(&t.0));
        let carrier = rate(2);
        [rate(0) - carrier, rate(1) - carrier]
    }

    /// Whether power flows through every transmission in the sense that is tried.
    fn flows(&self, plan: &Plan, train: &TrainForces, work: &TrainWork, senses: usize, lossy: usize) -> bool {
        let mut bit = 0;
        for (&slot, multiplier) in train.laws.iter().zip(&work.trial) {
            let law = &plan.laws[slot];
            let rates = self.side_rates(law);
            if law.efficiency.is_none() || rates == [0.0, 0.0] || bit >= lossy {
                continue;
            }
            let side = usize::from(senses >> bit & 1 == 1);
            bit += 1;
            // power into the transmission from the side that drives
            let power = -multiplier * self.law_forces[slot].sides[side] * law.terms[side].1 * rates[side];
            let size = (multiplier * law.terms[side].1 * rates[side]).abs();
            if power < -NOTHING * size {
                return false;
            }
        }
        true
    }

    /// Solves the system with the sides as they are set.
    fn unknowns(&self, plan: &Plan, train: &TrainForces, work: &mut TrainWork) -> bool {
        let n = train.members.len();
        let width = n + 1;
        for i in 0..n {
            work.rows[i * width..][..n].copy_from_slice(&train.matrix[i * n..][..n]);
            work.rows[i * width + n] = -work.loads[i];
        }
        for (column, &slot) in train.laws.iter().enumerate() {
            let law = &plan.laws[slot];
            if law.efficiency.is_none() {
                continue;
            }
            let [a, b] = self.law_forces[slot].sides;
            for (i, member) in train.members.iter().enumerate() {
                let term = law.terms.iter().position(|(site, _)| acts_on(site, member));
                let (c_1, c_2) = (a * law.terms[0].1, b * law.terms[1].1);
                let value = match term {
                    Some(0) => c_1,
                    Some(1) => c_2,
                    Some(_) => -(c_1 + c_2),
                    None => continue,
                };
                work.rows[i * width + column] = value;
            }
        }
        eliminate(&mut work.rows, n) && {
            (0..n).for_each(|i| work.trial[i] = work.rows[i * width + n]);
            true
        }
    }

    /// Puts multipliers and efforts on the bodies, and finds what holds the members.
    fn train_reactions(&mut self, plan: &Plan, train: &TrainForces, work: &TrainWork) {
        for &slot in &train.laws {
            let law = &plan.laws[slot];
            let mut wrenches = std::mem::take(&mut self.wrenches);
            self.forces_of_law(law, slot, &mut |body, p, force, couple| {
                let r = p - self.bodies[body].p;
                wrenches[body].force += force;
                wrenches[body].moment += r.cross(force) + couple;
            });
            self.wrenches = wrenches;
        }
        for (effort, value) in train.efforts.iter().zip(&work.found[train.laws.len()..]) {
            match effort {
                TrainEffort::Torque(slot, body, base) => {
                    self.efforts[*slot] = *value;
                    self.wrenches[*body].moment += value;
                    self.wrenches[*base].moment -= value;
                }
                TrainEffort::Along(slot, way) => {
                    self.efforts[*slot] = *value;
                    let (p, force) =
                        (self.bodies[way.slider].position(way.point), self.direction(way) * *value);
                    let other = if way.slider == way.body { way.base } else { way.body };
                    self.carry(other, p, force);
                    self.carry(way.slider, p, -force);
                }
            }
        }
        for member in train.members.iter().rev() {
            match member {
                TrainSupport::Turn(hinge, _) => {
                    let (p, force, _) = self.load_at(hinge.body, &hinge.pin);
                    self.hinge_reaction(hinge, p, -force);
                }
                TrainSupport::Shift(way, _) => {
                    let p = self.bodies[way.slider].position(way.point);
                    let d = self.direction(way);
                    let (force, moment) = self.load_about(way.body, p);
                    self.carried_way(way, p, d.perp() * -force.dot(d.perp()), -moment);
                }
            }
        }
    }
}

/// Whether a law's site is the coordinate of a member.
fn acts_on(site: &LawSite, member: &TrainSupport) -> bool {
    match (site, member) {
        (LawSite::Turn(body), TrainSupport::Turn(hinge, _)) => *body == hinge.body,
        (LawSite::Slide(a), TrainSupport::Shift(b, _)) => {
            a.slider == b.slider && [a.body, a.base].contains(&b.body) && [a.body, a.base].contains(&b.base)
        }
        _ => false,
    }
}

/// Gauss and Jordan with partial pivoting on n rows of n + 1 numbers; `false` where the matrix is singular.
fn eliminate(rows: &mut [f64], n: usize) -> bool {
    let width = n + 1;
    for k in 0..n {
        let size = |i: usize| rows[i * width + k].abs();
        let pivot = (k..n).fold(k, |best, i| if size(i) > size(best) { i } else { best });
        if size(pivot) == 0.0 || size(pivot).is_nan() {
            return false;
        }
        (0..width).for_each(|j| rows.swap(k * width + j, pivot * width + j));
        let diagonal = rows[k * width + k];
        (0..width).for_each(|j| rows[k * width + j] /= diagonal);
        for i in (0..n).filter(|&i| i != k) {
            let factor = rows[i * width + k];
            if factor != 0.0 {
                (0..width).for_each(|j| rows[i * width + j] -= factor * rows[k * width + j]);
            }
        }
    }
    true
}
