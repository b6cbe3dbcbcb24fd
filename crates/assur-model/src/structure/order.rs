//! What a person would have meant: the order of statements that may be too many. A pair with two letters at one pin, a name of no
//! point, or ends that other pairs use, is rather too many; so is what is written last.

use super::effort::{Effort, EffortSource};
use super::incidence::Incidence;
use super::trial::{Statement, Trial};
use super::uses::Uses;
use super::words::{ends, is_structure, pairs_of};
use crate::math::Vec2;
use crate::model::{
    Expr, Find, FindKind, LinkId, Load, LoadKind, Mechanism, PairId, PairKind, Place, PointRef, Query,
};

/// Signs that a pair is too many, each in points.
const TWO_LETTERS: i32 = 4;
const OTHER_NAME: i32 = 2;
const USED_ENDS: i32 = 2;
/// A drive of a machine that moves without it, and that of one that does not.
const DRIVE: i32 = 3;
const NEEDED_DRIVE: i32 = -2;

/// The likeliest first: by points, then by the place in the file.
pub(super) type Rank = (i32, std::cmp::Reverse<usize>);

pub(super) struct Order<'a> {
    trial: Trial<'a>,
    uses: Uses<'a>,
    drive: i32,
}

impl<'a> Order<'a> {
    pub(super) fn of(trial: Trial<'a>) -> Self {
        let pairs = Incidence::of_joints(trial.replaced).fit();
        let moves = pairs.surplus == 0 && pairs.missing > 0;
        let drive = match is_structure(trial.mechanism) {
            true => 3 * DRIVE,
            false if moves => DRIVE,
            false => NEEDED_DRIVE,
        };
        Self { trial, uses: Uses::of(trial.mechanism, None), drive }
    }

    pub(super) fn rank(&self, statement: Statement) -> Rank {
        let mechanism = self.trial.mechanism;
        let (points, at) = match statement {
            Statement::Pair(pair) => (self.points(pair), mechanism.pair(pair).span.start),
            Statement::Link(link) => (self.points_of_link(link), mechanism.link(link).span.start),
            Statement::Effort(effort) => (self.drive, place(mechanism, &self.trial.efforts[effort])),
        };
        (-points, std::cmp::Reverse(at))
    }

    fn points(&self, pair: PairId) -> i32 {
        let pair = self.trial.mechanism.pair(pair);
        let ends = ends(&pair.kind);
        if ends.is_empty() {
            return 0;
        }
        let is_pin = matches!(pair.kind, PairKind::Revolute(_) | PairKind::Weld { .. });
        let two_letters = is_pin && ends.iter().any(|end| end.1 != ends[0].1);
        // the hinge of a slider has the letter already
        let other_name = is_pin && ends.iter().all(|end| end.1 != pair.name);
        let used = ends.iter().all(|end| self.uses.count(end.0, end.1) > 1);
        [(two_letters, TWO_LETTERS), (other_name, OTHER_NAME), (used, USED_ENDS)]
            .iter()
            .map(|(is, points)| if *is { *points } else { 0 })
            .sum()
    }

    /// A link with two pairs may be an added bar: the mean of both.
    fn points_of_link(&self, link: LinkId) -> i32 {
        match pairs_of(self.trial.mechanism, link).as_slice() {
            [first, second] => i32::midpoint(self.points(*first), self.points(*second)),
            _ => 0,
        }
    }
}

fn place(mechanism: &Mechanism, effort: &Effort) -> usize {
    match effort.source {
        EffortSource::Drive(id) => mechanism.drives[id.index()].span.start,
        EffortSource::Balance(id) => mechanism.balances[id.index()].span.start,
    }
}

/// Links and pairs that questions, loads and other statements name: without them these would have errors.
#[derive(Default)]
pub(super) struct Named {
    links: Vec<LinkId>,
    pairs: Vec<PairId>,
    points: Vec<(LinkId, Vec2)>,
}

impl Named {
    pub(super) fn of(mechanism: &Mechanism) -> Self {
        let mut this = Self::one_by_one(mechanism);
        for find in &mechanism.finds {
            match &find.kind {
                FindKind::Value { expr, .. } => this.ask(expr),
                FindKind::Table(table) => table.questions().for_each(|expr| this.ask(expr)),
                FindKind::Reactions => {}
            }
        }
        this
    }

    /// Without what asks for all there is, as `find positions`.
    pub(super) fn one_by_one(mechanism: &Mechanism) -> Self {
        let mut this = Self::default();
        for of_item in mechanism.finds.chunk_by(|a, b| a.span == b.span) {
            if let [Find { kind: FindKind::Value { expr, .. }, .. }] = of_item {
                this.ask(expr);
            }
        }
        mechanism.quantities.iter().for_each(|quantity| this.ask(&quantity.expr));
        this.links.extend(mechanism.loads.iter().filter_map(Load::link));
        let at = |load: &Load| match &load.kind {
            LoadKind::Force { on, at: Place::Local(at), .. }
            | LoadKind::ForceAgainstMotion { on, at: Place::Local(at), .. } => Some((*on, *at)),
            _ => None,
        };
        this.points.extend(mechanism.loads.iter().filter_map(at));
        this.points.extend(mechanism.springs.iter().flat_map(|spring| [spring.from, spring.to]));
        this.links.extend(mechanism.springs.iter().flat_map(|spring| [spring.from.0, spring.to.0]));
        this.links.extend(mechanism.groups.iter().flat_map(|group| group.links.iter().copied()));
        this
    }

    pub(super) fn ask(&mut self, expr: &Expr) {
        let mut of_point = |at: PointRef| match at {
            PointRef::Fixed(link, at) => {
                self.links.push(link);
                self.points.push((link, at));
            }
            PointRef::Under(link, (other, at)) => {
                self.links.extend([link, other]);
                self.points.push((other, at));
            }
        };
        expr.queries(&mut |query| {
            let mut query = *query;
            query.point_mut().into_iter().for_each(|at| of_point(*at));
        });
        expr.queries(&mut |query| match query {
            Query::Angle(link)
            | Query::Omega(link)
            | Query::Alpha(link)
            | Query::LinkDirection(link)
            | Query::Axial(link) => self.links.push(*link),
            Query::Internal(inside) => self.links.push(inside.link),
            Query::Reaction(pair, link) | Query::Moment(pair, link) | Query::Normal(pair, link) => {
                self.links.push(*link);
                self.pairs.push(*pair);
            }
            Query::Displacement(pair)
            | Query::RelativeVelocity(pair)
            | Query::Sliding(pair)
            | Query::RelativeAcceleration(pair)
            | Query::Travel(pair)
            | Query::Stroke(pair)
            | Query::PressureAngle(pair) => self.pairs.push(*pair),
            _ => {}
        });
    }

    pub(super) fn has_point(&self, link: LinkId, at: Vec2) -> bool {
        self.points.contains(&(link, at))
    }

    pub(super) fn has(&self, statement: Statement) -> bool {
        match statement {
            Statement::Pair(pair) => self.pairs.contains(&pair),
            Statement::Link(link) => self.links.contains(&link),
            Statement::Effort(_) => false,
        }
    }
}
