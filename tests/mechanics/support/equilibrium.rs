//! The independent path for forces: the equations of Newton and Euler for all links, with the reactions of all pairs as
//! they are declared and the unknown efforts, as one linear system. Moments are taken about the origin of the ground.

use crate::support::reference::{Body, Rates, Solver, number, rollers, vector};
use assur::internals::math::Vec2;
use assur::internals::model::{
    BalanceKind, DriveTarget, Expr, Guide, LinkId, LoadKind, Mechanism, PairId, PairKind, Place, Profile,
    ProfileShape, Query,
};
use nalgebra::{DMatrix, DVector};

/// Velocities below this, m/s and rad/s, are rounding.
const STILL: f64 = 1e-10;

/// Force and moment about the origin of the ground.
#[derive(Clone, Copy, Debug, Default)]
pub struct Wrench {
    pub force: Vec2,
    pub moment: f64,
}

impl Wrench {
    pub fn at(p: Vec2, force: Vec2) -> Self {
        Self { force, moment: p.cross(force) }
    }
    pub fn couple(moment: f64) -> Self {
        Self { force: Vec2::zero(), moment }
    }
    pub fn times(self, k: f64) -> Self {
        Self { force: self.force * k, moment: self.moment * k }
    }
    pub fn add(&mut self, o: Self) {
        self.force += o.force;
        self.moment += o.moment;
    }
    fn power(&self, body: &Body, omega: f64) -> f64 {
        let p = body.p.value();
        self.force.dot(body.p.rate()) + (self.moment - p.cross(self.force)) * omega
    }
}

/// What a pair does to one of its links.
#[derive(Clone, Copy, Debug)]
pub struct OnLink {
    pub pair: PairId,
    pub link: LinkId,
    pub force: Vec2,
    /// About the pair's reference point.
    pub couple: f64,
    /// The force (the couple) is determined by the equations.
    pub determined: (bool, bool),
}

pub struct Forces {
    pub reactions: Vec<OnLink>,
    pub efforts: Vec<f64>,
    pub effort_powers: Vec<f64>,
    /// Null where the unknowns do not balance every load.
    pub condition: f64,
    /// The greatest force and moment in play.
    pub most: (f64, f64),
    /// A load depends on the sign of something that is zero but for rounding.
    pub doubtful: bool,
    /// Sum of the powers of loads, inertia and efforts.
    pub power: f64,
}

/// An unknown and what a unit of it does.
struct Unknown {
    on: Vec<(LinkId, Wrench)>,
    gives: Vec<Gives>,
}

/// Part of a reaction per unit of an unknown.
struct Gives {
    pair: PairId,
    link: LinkId,
    force: Vec2,
    couple: f64,
}

struct System<'a> {
    mechanism: &'a Mechanism,
    bodies: &'a [Body],
    rates: &'a [Rates],
    unknowns: Vec<Unknown>,
    doubtful: bool,
}

/// `None` where even without efforts the pairs' reactions depend on each other in their forces.
pub fn equilibrium(mechanism: &Mechanism, bodies: &[Body], rates: &[Rates]) -> Option<Forces> {
    let mut system = System { mechanism, bodies, rates, unknowns: Vec::new(), doubtful: false };
    for (i, pair) in mechanism.pairs.iter().enumerate() {
        system.pair(PairId::at(i), &pair.kind);
    }
    for link in rollers(mechanism) {
        system.unknowns.push(Unknown { on: vec![(link, Wrench::couple(1.0))], gives: Vec::new() });
    }
    let first_effort = system.unknowns.len();
    let efforts = system.efforts();
    system.unknowns.extend(efforts.into_iter().map(|on| Unknown { on, gives: Vec::new() }));
    let applied = system.applied();
    system.solve(first_effort, &applied)
}

/// What acts on the links from outside: loads with inertia, and what a unit of each unknown effort does; the place and
/// normal of every contact.
pub struct Outside {
    pub applied: Vec<Wrench>,
    pub units: Vec<Vec<(LinkId, Wrench)>>,
    pub touching: Vec<Option<(Vec2, Vec2)>>,
    pub doubtful: bool,
}

impl Outside {
    pub fn new(mechanism: &Mechanism, bodies: &[Body], rates: &[Rates]) -> Self {
        let mut system = System { mechanism, bodies, rates, unknowns: Vec::new(), doubtful: false };
        let touching = mechanism.pairs.iter().map(|p| match &p.kind {
            PairKind::Contact { first, second, internal, .. } => Some(system.touch(first, second, *internal)),
            _ => None,
        });
        let (touching, units, applied) = (touching.collect(), system.efforts(), system.applied());
        Self { applied, units, touching, doubtful: system.doubtful }
    }
}

impl System<'_> {
    fn body(&self, link: LinkId) -> &Body {
        &self.bodies[link.index()]
    }

    fn at(&self, link: LinkId, local: Vec2) -> Vec2 {
        self.body(link).point(local).value()
    }

    /// A unit force of `base` on `link` along `n` at `p`.
    fn force(&mut self, pair: PairId, link: LinkId, base: LinkId, p: Vec2, n: Vec2) {
        let unit = Wrench::at(p, n);
        let give = |link, force| Gives { pair, link, force, couple: 0.0 };
        self.unknowns.push(Unknown {
            on: vec![(link, unit), (base, unit.times(-1.0))],
            gives: vec![give(link, n), give(base, -n)],
        });
    }

    fn hinge(&mut self, pair: PairId, link: LinkId, base: LinkId, p: Vec2) {
        self.force(pair, link, base, p, Vec2::new(1.0, 0.0));
        self.force(pair, link, base, p, Vec2::new(0.0, 1.0));
    }

    fn couple(&mut self, pair: PairId, link: LinkId, base: LinkId) {
        let give = |link, couple| Gives { pair, link, force: Vec2::zero(), couple };
        self.unknowns.push(Unknown {
            on: vec![(link, Wrench::couple(1.0)), (base, Wrench::couple(-1.0))],
            gives: vec![give(link, 1.0), give(base, -1.0)],
        });
    }

    fn normal_of(&self, g: &Guide) -> Vec2 {
        self.body(g.guide).axis(g.along).value().perp()
    }

    fn pair(&mut self, id: PairId, kind: &PairKind) {
        match kind {
            PairKind::Revolute(pins) => {
                for pin in &pins[1..] {
                    self.hinge(id, pin.link, pins[0].link, self.at(pin.link, pin.at));
                }
            }
            PairKind::Prismatic(g) => {
                self.force(id, g.slider, g.guide, self.at(g.slider, g.point), self.normal_of(g));
                self.couple(id, g.slider, g.guide);
            }
            PairKind::Slot(g) => {
                self.force(id, g.slider, g.guide, self.at(g.slider, g.point), self.normal_of(g));
            }
            PairKind::Contact { first, second, internal, .. } => {
                let (p, n) = self.touch(first, second, *internal);
                self.force(id, first.link, second.link, p, n);
            }
            PairKind::Cylinder { barrel, rod, from, to } => {
                let (tube, p) = (self.body(*barrel).p.value(), self.body(*rod).p.value());
                let n = self.body(*barrel).u.value().perp();
                self.hinge(id, *barrel, from.link, tube);
                self.hinge(id, *rod, to.link, p);
                self.force(id, *rod, *barrel, p, n);
                self.couple(id, *rod, *barrel);
            }
            PairKind::Weld { pins, .. } => {
                for pin in &pins[1..] {
                    self.hinge(id, pin.link, pins[0].link, self.at(pin.link, pin.at));
                    self.couple(id, pin.link, pins[0].link);
                }
            }
            PairKind::Transmission(_) => {}
        }
    }

    /// Place of a contact and its normal into the first link, from the gradient of the distance.
    fn touch(&self, first: &Profile, second: &Profile, internal: bool) -> (Vec2, Vec2) {
        let at = |p: &Profile, local| self.at(p.link, local);
        let axis = |p: &Profile, d| self.body(p.link).axis(d).value();
        match (first.shape, second.shape) {
            (ProfileShape::Line(q, d), round) => {
                let (c, r) = centre(round);
                let (p, n) = on_line(at(first, q), axis(first, d), at(second, c), r);
                (p, -n)
            }
            (round, ProfileShape::Line(q, d)) => {
                let (c, r) = centre(round);
                on_line(at(second, q), axis(second, d), at(first, c), r)
            }
            (one, two) => {
                let ((c, r), (e, s)) = (centre(one), centre(two));
                let (c, e) = (at(first, c), at(second, e));
                let n = (c - e) / (c - e).norm();
                // internal: the smaller circle lies in the greater one
                if internal && r > s {
                    (c - n * r, n)
                } else if internal {
                    (c + n * r, -n)
                } else {
                    (c - n * r, n)
                }
            }
        }
    }

    /// What a unit of each unknown effort does.
    fn efforts(&self) -> Vec<Vec<(LinkId, Wrench)>> {
        let m = self.mechanism;
        if m.balances.is_empty() {
            let of = |target: &DriveTarget| match target {
                DriveTarget::Link(link) => vec![(*link, Wrench::couple(1.0))],
                DriveTarget::Pair(pair) => self.in_pair(*pair),
                DriveTarget::Point(..) => Vec::new(),
                DriveTarget::Place(link, at, axis) => {
                    vec![(*link, Wrench::at(self.at(*link, *at), axis.unit()))]
                }
            };
            let drives = m.drives.iter().filter(|d| !matches!(d.target, DriveTarget::Point(..)));
            return drives.map(|d| of(&d.target)).collect();
        }
        let of = |kind: &BalanceKind| match kind {
            BalanceKind::Torque(link) => vec![(*link, Wrench::couple(1.0))],
            BalanceKind::Force { on, at, along, frame } => {
                let n = frame.map_or(*along, |f| self.body(f).axis(*along).value());
                vec![(*on, Wrench::at(self.place(*on, at), n))]
            }
            BalanceKind::InPair(pair) => self.in_pair(*pair),
            BalanceKind::Several(_) => panic!("a place is one place"),
        };
        m.balances.iter().map(|b| b.kind.places().iter().flat_map(of).collect()).collect()
    }

    fn place(&self, link: LinkId, place: &Place) -> Vec2 {
        match place {
            Place::Local(at) => self.at(link, *at),
            Place::Ground(expr) => vector(expr),
        }
    }

    /// A unit effort between the links of a pair.
    fn in_pair(&self, pair: PairId) -> Vec<(LinkId, Wrench)> {
        match &self.mechanism.pair(pair).kind {
            PairKind::Revolute(pins) => {
                vec![(pins[1].link, Wrench::couple(1.0)), (pins[0].link, Wrench::couple(-1.0))]
            }
            PairKind::Prismatic(g) | PairKind::Slot(g) => {
                let d = self.body(g.guide).axis(g.along).value();
                let unit = Wrench::at(self.at(g.slider, g.point), d);
                vec![(g.slider, unit), (g.guide, unit.times(-1.0))]
            }
            PairKind::Cylinder { barrel, rod, .. } => {
                let unit = Wrench::at(self.body(*rod).p.value(), self.body(*rod).u.value());
                vec![(*rod, unit), (*barrel, unit.times(-1.0))]
            }
            PairKind::Contact { .. } | PairKind::Weld { .. } | PairKind::Transmission(_) => Vec::new(),
        }
    }

    /// Loads and inertia on every link.
    fn applied(&mut self) -> Vec<Wrench> {
        let m = self.mechanism;
        let mut out = vec![Wrench::default(); m.links.len()];
        for (i, link) in m.links.iter().enumerate().skip(1) {
            let Some(mass) = link.mass else { continue };
            let s = self.bodies[i].point(mass.centre);
            let g = m.gravity.map_or(Vec2::zero(), |g| g.acceleration);
            out[i].add(Wrench::at(s.value(), (g - s.second()) * mass.mass));
            out[i].add(Wrench::couple(-mass.inertia * self.rates[i].alpha));
        }
        for load in &m.loads {
            if let Some(Expr::Compare(_, a, _)) = &load.when
                && let Expr::Query(Query::Omega(link)) = a.as_ref()
            {
                let omega = self.rates[link.index()].omega;
                self.doubtful |= omega.abs() < STILL;
                if omega <= 0.0 {
                    continue;
                }
            }
            self.apply(&load.kind, &mut out);
        }
        for spring in &m.springs {
            let ends = [spring.from, spring.to].map(|(link, at)| self.body(link).point(at));
            let r = ends[1].minus(ends[0]);
            let (length, unit) = (r.value().norm(), r.value() / r.value().norm());
            let tension =
                spring.stiffness * (length - spring.free_length) + spring.damping * r.rate().dot(unit);
            out[spring.from.0.index()].add(Wrench::at(ends[0].value(), unit * tension));
            out[spring.to.0.index()].add(Wrench::at(ends[1].value(), unit * -tension));
        }
        out
    }

    fn apply(&mut self, kind: &LoadKind, out: &mut [Wrench]) {
        match kind {
            LoadKind::Force { on, at, value, frame } => {
                let force = frame.map_or(vector(value), |f| self.body(f).axis(vector(value)).value());
                out[on.index()].add(Wrench::at(self.place(*on, at), force));
            }
            LoadKind::ForceAgainstMotion { on, at, value } => {
                let p = self.place(*on, at);
                let body = self.body(*on);
                let v = body.p.rate() + (p - body.p.value()).perp() * self.rates[on.index()].omega;
                // against nothing there is nothing
                if v.norm() > STILL {
                    out[on.index()].add(Wrench::at(p, v * (-number(value) / v.norm())));
                }
            }
            LoadKind::Torque { on, value, against_motion, .. } => {
                let omega = self.rates[on.index()].omega;
                let sign = match *against_motion {
                    false => 1.0,
                    true if omega.abs() < STILL => 0.0,
                    true => -omega.signum(),
                };
                out[on.index()].add(Wrench::couple(sign * number(value)));
            }
            LoadKind::InPair { pair, value, .. } => {
                for (link, unit) in self.in_pair(*pair) {
                    out[link.index()].add(unit.times(number(value)));
                }
            }
        }
    }

    fn solve(self, first_effort: usize, applied: &[Wrench]) -> Option<Forces> {
        // the equations of links driven at a point are not written
        let outer = |link: &LinkId| {
            self.mechanism.drives.iter().any(|d| matches!(d.target, DriveTarget::Point(l, _) if l == *link))
        };
        let links: Vec<LinkId> = (1..applied.len()).map(LinkId::at).filter(|l| !outer(l)).collect();
        let (rows, columns) = (3 * links.len(), self.unknowns.len());
        let mut matrix = DMatrix::<f64>::zeros(rows, columns);
        for (j, unknown) in self.unknowns.iter().enumerate() {
            for (link, w) in &unknown.on {
                let Some(row) = links.iter().position(|l| l == link) else { continue };
                for (k, x) in [w.force.x, w.force.y, w.moment].into_iter().enumerate() {
                    matrix[(3 * row + k, j)] += x;
                }
            }
        }
        let loads =
            links.iter().map(|l| applied[l.index()]).flat_map(|w| [-w.force.x, -w.force.y, -w.moment]);
        let right = DVector::from_iterator(rows, loads);
        let solver = Solver::of_any_rank(matrix);
        let balanced = solver.rank() == rows;
        let determined = solver.determined(columns);
        let x = if balanced { solver.solve(&right)? } else { DVector::zeros(columns) };
        let mut reactions = self.nothing();
        for ((unknown, value), known) in self.unknowns.iter().zip(x.iter()).zip(&determined) {
            for part in &unknown.gives {
                let on = reactions.iter_mut().find(|r| r.pair == part.pair && r.link == part.link)?;
                on.force += part.force * *value;
                on.couple += part.couple * *value;
                on.determined.0 &= *known || part.couple != 0.0;
                on.determined.1 &= *known || part.couple == 0.0;
            }
        }
        let efforts: Vec<f64> = x.iter().skip(first_effort).copied().collect();
        let power = |on: &[(LinkId, Wrench)]| -> f64 {
            on.iter().map(|(l, w)| w.power(self.body(*l), self.rates[l.index()].omega)).sum()
        };
        let effort_powers: Vec<f64> =
            self.unknowns[first_effort..].iter().zip(&efforts).map(|(u, x)| power(&u.on) * x).collect();
        let loads = applied.iter().enumerate().map(|(i, w)| power(&[(LinkId::at(i), *w)]));
        // what the joints of links driven at a point put in is not counted
        let alone = links.len() + 1 < applied.len();
        let sum = if alone { 0.0 } else { loads.chain(effort_powers.iter().copied()).sum() };
        let (mut force, mut moment) = (f64::MIN_POSITIVE, f64::MIN_POSITIVE);
        for w in applied {
            force = force.max(w.force.norm());
            moment = moment.max(w.moment.abs());
        }
        for r in &reactions {
            force = force.max(r.force.norm());
            moment = moment.max(r.couple.abs());
        }
        for x in &efforts {
            force = force.max(x.abs());
        }
        let condition = if balanced { solver.condition() } else { 0.0 };
        let most = (force.max(moment), force.max(moment));
        Some(Forces {
            reactions,
            efforts,
            effort_powers,
            condition,
            most,
            doubtful: self.doubtful,
            power: sum,
        })
    }

    /// No force on every link of every pair.
    fn nothing(&self) -> Vec<OnLink> {
        let mut out = Vec::new();
        for (i, pair) in self.mechanism.pairs.iter().enumerate() {
            let mut links = pair.kind.links();
            if let PairKind::Cylinder { barrel, rod, .. } = &pair.kind {
                links.extend([*barrel, *rod]);
            }
            out.extend(links.into_iter().map(|link| OnLink {
                pair: PairId::at(i),
                link,
                force: Vec2::zero(),
                couple: 0.0,
                determined: (true, true),
            }));
        }
        out
    }
}

fn centre(shape: ProfileShape) -> (Vec2, f64) {
    match shape {
        ProfileShape::Point(c) => (c, 0.0),
        ProfileShape::Circle(c, r) => (c, r),
        ProfileShape::Line(p, _) => (p, f64::NAN),
        // cams are tested by themselves
        ProfileShape::Rim(_) => (Vec2::zero(), f64::NAN),
    }
}

/// Where a circle touches a line, and the normal towards its centre (the left one for a point).
fn on_line(q: Vec2, d: Vec2, c: Vec2, radius: f64) -> (Vec2, Vec2) {
    let n = d.perp();
    let n = if radius > 0.0 && n.dot(c - q) < 0.0 { -n } else { n };
    (c - n * radius, n)
}
