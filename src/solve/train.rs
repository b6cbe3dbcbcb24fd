//! Runs trains: rates and angles of their members, multipliers of their laws.

use super::motion::{Point, line, place, point, under};
use super::state::{BodyState, State};
use crate::math::Vec2;
use crate::plan::{
    LawSite, Plan, PlannedLaw, Slide, TrainEffort, TrainForces, TrainMember, TrainMotion, TrainSource,
    TrainSupport,
};

/// What a law does at one position.
#[derive(Clone, Copy, Debug, Default)]
pub struct LawForce {
    /// The multiplier of its coefficients.
    pub multiplier: f64,
    /// What is left of the forces on its two sides: 1 and 1 without losses.
    pub sides: [f64; 2],
}

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

/// Position, rate and second derivative of a coordinate.
#[derive(Clone, Copy, Default)]
struct Coordinate {
    value: f64,
    rate: f64,
    second: f64,
}

impl State {
    /// Moves the members of a train.
    pub(super) fn train<const LEVEL: u8>(&mut self, branch: usize, train: &TrainMotion) {
        self.sines[branch] = if train.regular { 1.0 } else { 0.0 };
        for source in &train.sources {
            if let TrainSource::Turn { body, followed: true } = source {
                let body = &mut self.bodies[*body];
                let turns = ((body.way - body.u.angle()) / std::f64::consts::TAU).round();
                body.way = body.u.angle() + std::f64::consts::TAU * turns;
            }
        }
        for (i, member) in train.members.iter().enumerate() {
            let row = &train.coefficients[i * train.sources.len()..][..train.sources.len()];
            let mut sum = Coordinate::default();
            for (source, c) in train.sources.iter().zip(row) {
                let known = self.coordinate(source);
                sum.value += c * known.value;
                sum.rate += c * known.rate;
                sum.second += c * known.second;
            }
            match member {
                TrainMember::Turn { body, base, pin } => {
                    let hinge = point::<f64, LEVEL>(&self.bodies, base);
                    let u = Vec2::direction(sum.value);
                    place::<f64, LEVEL>(&mut self.bodies[*body], pin, hinge, u, sum.rate, sum.second);
                    self.bodies[*body].way = sum.value;
                }
                TrainMember::Shift(slide) => {
                    let guide = line(&self.bodies, slide);
                    let p = guide.origin + guide.along * (slide.sense * sum.value);
                    let (rate, second) = (slide.sense * sum.rate, slide.sense * sum.second);
                    self.place_slider::<LEVEL>(slide, guide.along, &Some(slide.point), p, rate, second);
                }
            }
        }
    }

    fn coordinate(&self, source: &TrainSource) -> Coordinate {
        match source {
            TrainSource::Turn { body, .. } => {
                let body = &self.bodies[*body];
                Coordinate { value: body.way, rate: body.omega, second: body.alpha }
            }
            TrainSource::Drive(drive) => {
                let input = &self.inputs[*drive];
                Coordinate { value: input.value, rate: input.rate, second: input.acceleration }
            }
            TrainSource::Slide(slide) => self.slide_coordinate(slide),
        }
    }

    fn slide_coordinate(&self, slide: &Slide) -> Coordinate {
        let body = &self.bodies[slide.body];
        let guide = line(&self.bodies, slide);
        let p = body.position(slide.point);
        let beneath: Point<f64> = under::<f64, 2>(&self.bodies, slide.base, p);
        let along = |v: Vec2| v.dot(guide.along) * slide.sense;
        Coordinate {
            value: along(p - guide.origin),
            rate: along(body.velocity(slide.point) - beneath.v),
            second: along(body.acceleration(slide.point) - beneath.a),
        }
    }

    /// The rate that a law speaks of at one of its sites.
    pub(super) fn site_rate(&self, site: &LawSite) -> f64 {
        match site {
            LawSite::Turn(body) => self.bodies[*body].omega,
            LawSite::Slide(way) => {
                let (slider, guide) =
                    if way.slider == way.body { (way.body, way.base) } else { (way.base, way.body) };
                let body: &BodyState = &self.bodies[slider];
                let p = body.position(way.point);
                let beneath: Point<f64> = under::<f64, 1>(&self.bodies, guide, p);
                (body.velocity(way.point) - beneath.v).dot(self.direction(way))
            }
        }
    }

    /// The generalized force of a law at one of its sites.
    pub(super) fn law_force(&self, law: &PlannedLaw, slot: usize, term: usize) -> f64 {
        let force = &self.law_forces[slot];
        let side = |i: usize| force.multiplier * force.sides[i] * law.terms[i].1;
        match (law.efficiency, term) {
            (Some(_), 2) => -(side(0) + side(1)),
            (Some(_), _) => side(term),
            (None, _) => force.multiplier * law.terms[term].1,
        }
    }

    /// Calls `act` with every force of a law: body, place, force, couple.
    pub(super) fn forces_of_law(
        &self,
        law: &PlannedLaw,
        slot: usize,
        act: &mut dyn FnMut(usize, Vec2, Vec2, f64),
    ) {
        if let Some(meeting) = &law.meeting {
            self.forces_of_meeting(law, slot, meeting, act);
            return;
        }
        for (term, (site, _)) in law.terms.iter().enumerate() {
            let value = self.law_force(law, slot, term);
            match site {
                LawSite::Turn(body) => act(*body, self.bodies[*body].p, Vec2::zero(), value),
                LawSite::Slide(way) => {
                    let p = self.bodies[way.slider].position(way.point);
                    let force = self.direction(way) * value;
                    let other = if way.slider == way.body { way.base } else { way.body };
                    act(way.slider, p, force, 0.0);
                    act(other, p, -force, 0.0);
                }
            }
        }
    }

    /// The pitch point and the force on the first wheel.
    pub(super) fn meeting_force(
        &self,
        law: &PlannedLaw,
        slot: usize,
        meeting: &crate::model::Meeting,
    ) -> (Vec2, Vec2) {
        let centre = |i: usize| self.bodies[meeting.links[i].index()].position(meeting.centres[i]);
        let between = centre(1) - centre(0);
        let apart = between * (1.0 / between.norm());
        let [r_1, r_2] = meeting.radii;
        let towards = if meeting.internal && r_1 < r_2 { -apart } else { apart };
        // what is lost is lost in the bearings of the side that drives: the teeth carry what the other side gets
        let sides = self.law_forces[slot].sides;
        let through = sides[0].abs().min(sides[1].abs());
        let tangential = self.law_forces[slot].multiplier * through * law.force;
        // the first wheel is pressed inwards by an outer one, outwards as a ring
        let inwards = if meeting.internal && r_1 > r_2 { 1.0 } else { -1.0 };
        let radial = towards * (inwards * tangential.abs() * meeting.tangent);
        (centre(0) + towards * r_1, towards.perp() * tangential + radial)
    }

    fn forces_of_meeting(
        &self,
        law: &PlannedLaw,
        slot: usize,
        meeting: &crate::model::Meeting,
        act: &mut dyn FnMut(usize, Vec2, Vec2, f64),
    ) {
        let (p, force) = self.meeting_force(law, slot, meeting);
        let slots = meeting.links.map(|l| l.index());
        let mut rest = [0.0; 2];
        for (i, sign) in [(0, 1.0), (1, -1.0)] {
            let centre = self.bodies[slots[i]].position(meeting.centres[i]);
            rest[i] = -(p - centre).cross(force * sign);
        }
        for (term, (site, _)) in law.terms.iter().enumerate() {
            let LawSite::Turn(body) = site else { continue };
            if let Some(side) = slots.iter().position(|s| s == body) {
                rest[side] += self.law_force(law, slot, term);
            }
        }
        act(slots[0], p, force, rest[0]);
        act(slots[1], p, -force, rest[1]);
        // friction of a bearing acts back on what carries it
        if let Some((LawSite::Turn(carrier), _)) = law.terms.get(2) {
            act(*carrier, p, Vec2::zero(), -(rest[0] + rest[1]));
        }
    }

    /// Power that a law takes from what it acts on, W: nothing without losses.
    pub(super) fn law_power(&self, law: &PlannedLaw, slot: usize) -> f64 {
        let terms = law.terms.iter().enumerate();
        terms.map(|(i, (site, _))| self.law_force(law, slot, i) * self.site_rate(site)).sum()
    }

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
                    self.carry(other, p, force, 0.0);
                    self.carry(way.slider, p, -force, 0.0);
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
