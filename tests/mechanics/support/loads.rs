//! Random masses, loads, springs and unknown efforts.

use crate::support::draft::Draft;
use assur::internals::math::Vec2;
use assur::internals::model::{
    Balance, BalanceKind, Comparison, Expr, Gravity, LinkId, Load, LoadKind, MassProperties, PairId,
    PairKind, Place, Query, Spring, Value,
};
use assur::internals::source::Span;

pub fn vector(v: Vec2) -> Expr {
    Expr::Constant(Value::Vector(v))
}

impl Draft {
    /// A link that something may act on: a torque would turn a free roller.
    fn moving(&mut self) -> LinkId {
        loop {
            let link = LinkId::at(1 + self.random.below(self.frames.len() - 1));
            let outer = self.outer.iter().any(|o| o.0 == link);
            if !outer && !self.rollers.contains(&link) {
                return link;
            }
        }
    }

    pub fn add_masses(&mut self) {
        for i in 1..self.frames.len() {
            if self.random.chance(0.15) {
                continue;
            }
            let mut centre = self.random.vector(0.4);
            if self.rollers.contains(&LinkId::at(i)) {
                // a roller that depends on its mass centre stays as it is
                for pair in &self.mechanism.pairs {
                    if let PairKind::Revolute(pins) = &pair.kind {
                        centre = pins.iter().find(|p| p.link.index() == i).map_or(centre, |p| p.at);
                    }
                }
            }
            let inertia = if self.random.chance(0.2) { 0.0 } else { self.random.within(0.05, 0.8) };
            let mass = self.random.within(0.3, 3.0);
            self.mechanism.links[i].mass = Some(MassProperties { mass, centre, inertia });
        }
        if self.random.chance(0.8) {
            let down = if self.random.chance(0.7) { Vec2::new(0.0, -1.0) } else { self.random.direction() };
            self.mechanism.gravity = Some(Gravity { acceleration: down * 9.81, span: Span::default() });
        }
    }

    /// Pairs of two links between which an effort can act, both of them in equilibrium.
    fn pairs_with_effort(&self) -> Vec<PairId> {
        let fits = |kind: &PairKind| match kind {
            PairKind::Revolute(pins) => {
                pins.len() == 2 && !pins.iter().any(|p| self.rollers.contains(&p.link))
            }
            PairKind::Contact { .. } | PairKind::Weld { .. } | PairKind::Transmission(_) => false,
            PairKind::Prismatic(_) | PairKind::Slot(_) | PairKind::Cylinder { .. } => true,
        };
        (0..self.mechanism.pairs.len())
            .map(PairId::at)
            .filter(|&p| fits(&self.mechanism.pair(p).kind))
            .collect()
    }

    fn place(&mut self, link: LinkId) -> Place {
        let at = self.spot();
        if self.random.chance(0.3) { Place::Ground(vector(at)) } else { Place::Local(self.local(link, at)) }
    }

    pub fn add_loads(&mut self) {
        for _ in 0..self.random.below(5) {
            let on = self.moving();
            let kind = match self.random.below(7) {
                0..=2 => LoadKind::Force {
                    on,
                    at: self.place(on),
                    value: vector(self.random.vector(20.0)),
                    frame: self.random.chance(0.4).then(|| self.moving()),
                },
                3 => LoadKind::ForceAgainstMotion {
                    on,
                    at: self.place(on),
                    value: Expr::number(self.random.within(1.0, 20.0)),
                },
                4 | 5 => LoadKind::Torque {
                    on,
                    at: None,
                    value: Expr::number(self.random.within(1.0, 10.0)),
                    against_motion: self.random.chance(0.3),
                },
                _ => {
                    let pairs = self.pairs_with_effort();
                    if pairs.is_empty() {
                        continue;
                    }
                    let pair = pairs[self.random.below(pairs.len())];
                    LoadKind::InPair {
                        pair,
                        value: Expr::number(self.random.within(-10.0, 10.0)),
                        against_motion: false,
                    }
                }
            };
            let when = self.random.chance(0.15).then(|| {
                let turns = Expr::Query(Query::Omega(on));
                Expr::Compare(Comparison::Greater, Box::new(turns), Box::new(Expr::number(0.0)))
            });
            self.mechanism.loads.push(Load {
                name: None,
                span: Span::default(),
                kind,
                pin: None,
                spread: None,
                when,
            });
        }
        for _ in 0..self.random.below(3) {
            let (a, b) = (LinkId::at(self.random.below(self.frames.len())), self.moving());
            if a == b || self.rollers.contains(&a) || self.outer.iter().any(|o| o.0 == a) {
                continue;
            }
            let (p, q) = (self.spot(), self.spot());
            self.mechanism.springs.push(Spring {
                name: format!("spring{}", self.mechanism.springs.len() + 1),
                span: Span::default(),
                from: (a, self.local(a, p)),
                to: (b, self.local(b, q)),
                stiffness: self.random.within(1.0, 50.0),
                free_length: self.random.within(0.0, 1.0),
                damping: if self.random.chance(0.5) { 0.0 } else { self.random.within(0.1, 3.0) },
            });
        }
    }

    /// One torque on this and another link, or one effort in all pairs that turn or that slide.
    fn at_several_places(&mut self, on: LinkId) -> BalanceKind {
        let other = self.moving();
        let (turning, sliding): (Vec<PairId>, Vec<PairId>) = self
            .pairs_with_effort()
            .into_iter()
            .partition(|p| matches!(self.mechanism.pair(*p).kind, PairKind::Revolute(_)));
        let pairs = if self.random.chance(0.5) { turning } else { sliding };
        match pairs.len() {
            0 | 1 if other == on => BalanceKind::Torque(on),
            0 | 1 => BalanceKind::Several(vec![BalanceKind::Torque(on), BalanceKind::Torque(other)]),
            n => {
                let kept = pairs.into_iter().take(2 + self.random.below(n - 1));
                BalanceKind::Several(kept.map(BalanceKind::InPair).collect())
            }
        }
    }

    /// As many unknown efforts as drives, anywhere; none leaves the drives' own efforts.
    pub fn add_balances(&mut self) {
        self.mechanism.balances.clear();
        for i in 0..self.mechanism.drives.len() {
            let on = self.moving();
            let kind = match self.random.below(7) {
                0..=2 => BalanceKind::Torque(on),
                6 => self.at_several_places(on),
                3 | 4 => BalanceKind::Force {
                    on,
                    at: self.place(on),
                    along: self.random.direction(),
                    frame: self.random.chance(0.4).then(|| self.moving()),
                },
                _ => {
                    let pairs = self.pairs_with_effort();
                    match pairs.len() {
                        0 => BalanceKind::Torque(on),
                        n => BalanceKind::InPair(pairs[self.random.below(n)]),
                    }
                }
            };
            self.mechanism.balances.push(Balance {
                name: format!("M{i}"),
                span: Span::default(),
                kind,
                pin: None,
            });
        }
    }
}
