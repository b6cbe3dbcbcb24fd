//! Forces inside a link: at a cut across the line of its cuts, and their extremes along it.
//!
//! All that acts on the link is a force at a place, or a force per length that changes linearly. So the normal and the shear force are
//! quadratic and the moment is cubic between two places where something begins, ends or acts.

use super::pose_answers::PoseAnswers;
use super::sizes::is_zero;
use crate::math::Vec2;
use crate::model::{
    AlongLink, Cut, Internal, InternalPart, LinkId, LoadId, LoadKind, MassPart, MassShape, PairId, Query,
};
use crate::plan::LoadStep;
use crate::position::{Action, Origin};

/// Places nearer than this part of the link's length are one.
const SAME: f64 = 1e-10;
/// What acts on a link adds up to less than this part of it.
const CLOSED: f64 = 1e-7;
/// A value that exceeds another by less than this part of the greatest is the same.
const LEVEL: f64 = 1e-12;

/// What acts on a link, along and across the line of its cuts.
#[derive(Clone, Copy, Debug)]
pub enum Acting {
    /// A force and a couple at a place.
    At { place: Vec2, force: Vec2, couple: f64 },
    /// A force per length along a segment: at both ends, N/m.
    Along { from: Vec2, to: Vec2, ends: [Vec2; 2] },
}

/// Normal force, shear force and moment at a cut.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Section {
    pub normal: f64,
    pub shear: f64,
    pub moment: f64,
}

/// A cut, and whether what acts at its place is before it.
#[derive(Clone, Copy)]
struct Place {
    x: f64,
    after: bool,
    /// Places nearer than this are one, m.
    near: f64,
}

impl Section {
    #[must_use]
    pub const fn part(&self, part: InternalPart) -> f64 {
        match part {
            InternalPart::Normal => self.normal,
            InternalPart::Shear => self.shear,
            InternalPart::Moment => self.moment,
        }
    }

    /// With this force and this moment about the cut before it.
    fn and(self, force: Vec2, moment: f64) -> Self {
        Self { normal: self.normal - force.x, shear: self.shear + force.y, moment: self.moment - moment }
    }
}

impl Acting {
    /// One that is spread across the axis acts at one place of it.
    fn of_segment(from: Vec2, to: Vec2, ends: [Vec2; 2], near: f64) -> Self {
        if (to.x - from.x).abs() > near {
            return Self::Along { from, to, ends };
        }
        let (force, couple) = sum_of(from, to, ends, 1.0);
        Self::At { place: from, force, couple }
    }

    /// Where it begins and ends on the axis.
    fn ends(&self) -> [f64; 2] {
        match self {
            Self::At { place, .. } => [place.x; 2],
            Self::Along { from, to, .. } => [from.x.min(to.x), from.x.max(to.x)],
        }
    }

    /// The section with what of it is before the cut.
    fn before(&self, section: Section, cut: Place) -> Section {
        let centre = Vec2::new(cut.x, 0.0);
        match *self {
            Self::At { place, force, couple } => {
                let limit = if cut.after { cut.x + cut.near } else { cut.x - cut.near };
                if place.x >= limit {
                    return section;
                }
                section.and(force, (place - centre).cross(force) + couple)
            }
            Self::Along { from, to, ends } => {
                let (from, to, ends) =
                    if from.x < to.x { (from, to, ends) } else { (to, from, [ends[1], ends[0]]) };
                let share = ((cut.x - from.x) / (to.x - from.x)).clamp(0.0, 1.0);
                let (force, couple) = sum_of(from, to, ends, share);
                section.and(force, (from - centre).cross(force) + couple)
            }
        }
    }
}

/// The force of the first part of a segment, and its moment about the begin.
fn sum_of(from: Vec2, to: Vec2, [first, last]: [Vec2; 2], share: f64) -> (Vec2, f64) {
    let (d, more) = (to - from, last - first);
    let length = d.norm();
    let force = (first + more * (share / 2.0)) * (share * length);
    let weighted = (first * 0.5 + more * (share / 3.0)) * (share * share * length);
    (force, d.cross(weighted))
}

impl PoseAnswers<'_> {
    /// The answer to a question about the forces inside a link; NaN where they are not determined.
    pub(super) fn internal(&self, asked: Internal) -> f64 {
        if !self.is_determined(asked.link) {
            return f64::NAN;
        }
        match asked.at {
            Cut::At(x) => self.section(asked.link, x).part(asked.part),
            Cut::Extreme(extreme) => self.along_link(asked.link, asked.part, extreme),
        }
    }

    /// The section of a link at a cut: at the place of a force just before it, at the begin of the link just behind it.
    #[must_use]
    pub fn section(&self, link: LinkId, x: f64) -> Section {
        let near = self.near(link);
        let [begin, _] = self.reach(link);
        self.cut(link, Place { x, after: x <= begin + near, near })
    }

    /// Where a link and what acts on it begin and end on its axis, m.
    #[must_use]
    pub fn reach(&self, link: LinkId) -> [f64; 2] {
        let [mut begin, mut end] = self.mechanism.link(link).extent();
        self.each_acting(link, &mut |acting| {
            let [first, last] = acting.ends();
            (begin, end) = (begin.min(first), end.max(last));
        });
        [begin, end]
    }

    /// Between which places of its axis the forces inside a link are polynomials.
    #[must_use]
    pub fn next_place(&self, link: LinkId, x: f64) -> f64 {
        let (near, [_, end]) = (self.near(link), self.reach(link));
        let mut next = end;
        self.each_acting(link, &mut |acting| {
            for place in acting.ends() {
                if place > x + near && place < next - near {
                    next = place;
                }
            }
        });
        next
    }

    /// The sections just behind the begin and just before the end of a piece, and those that cut it in three.
    #[must_use]
    pub fn piece(&self, link: LinkId, [from, to]: [f64; 2]) -> [Section; 4] {
        let near = self.near(link);
        let at = |share: f64, after| self.cut(link, Place { x: from + (to - from) * share, after, near });
        [at(0.0, true), at(1.0 / 3.0, true), at(2.0 / 3.0, true), at(1.0, false)]
    }

    fn near(&self, link: LinkId) -> f64 {
        let [begin, end] = self.mechanism.link(link).extent();
        SAME * (end - begin).max(begin.abs()).max(end.abs())
    }

    /// The sums of what acts before a cut; zero what is rounding beside it.
    fn cut(&self, link: LinkId, place: Place) -> Section {
        let (mut sum, mut force, mut moment) = (Section::default(), 0.0, 0.0);
        self.each_acting(link, &mut |acting| {
            let one = acting.before(Section::default(), place);
            sum = sum.and(Vec2::new(-one.normal, one.shear), -one.moment);
            force += one.normal.abs() + one.shear.abs();
            moment += one.moment.abs();
        });
        let clear = |x: f64, size: f64| if is_zero(x, size) { 0.0 } else { x };
        Section {
            normal: clear(sum.normal, force),
            shear: clear(sum.shear, force),
            moment: clear(sum.moment, moment),
        }
    }

    /// Whether what acts on a link is known, and is in equilibrium.
    fn is_determined(&self, link: LinkId) -> bool {
        let mut own = self.structure.undetermined_couples.iter();
        let of_link = |pair: &PairId| self.mechanism.pair(*pair).kind.links().contains(&link);
        if own.any(of_link) {
            return false;
        }
        let (near, [_, end]) = (self.near(link), self.reach(link));
        let (mut left, mut size) = (Section::default(), Section::default());
        self.each_acting(link, &mut |acting| {
            let one = acting.before(Section::default(), Place { x: end, after: true, near });
            left = left.and(Vec2::new(-one.normal, one.shear), -one.moment);
            size.shear += one.normal.abs() + one.shear.abs();
            size.moment += one.moment.abs();
        });
        let force = left.normal.abs().max(left.shear.abs());
        force <= CLOSED * size.shear && left.moment.abs() <= CLOSED * (size.moment + size.shear * near / SAME)
    }

    /// The greatest or least value along a link, or its first place.
    fn along_link(&self, link: LinkId, part: InternalPart, extreme: AlongLink) -> f64 {
        let [begin, end] = self.reach(link);
        let sign = if extreme.greatest { 1.0 } else { -1.0 };
        let (mut best, mut place, mut size) = (f64::NEG_INFINITY, begin, 0.0_f64);
        let mut from = begin;
        while from < end {
            let to = self.next_place(link, from);
            let values = self.piece(link, [from, to]).map(|section| section.part(part));
            values.iter().for_each(|value| size = size.max(value.abs()));
            let inside = turning_points(values).into_iter().flatten();
            let inside = inside.map(|share| from + (to - from) * share);
            let near = self.near(link);
            let inside = inside.map(|x| (x, self.cut(link, Place { x, after: true, near }).part(part)));
            for (x, value) in [(from, values[0])].into_iter().chain(inside).chain([(to, values[3])]) {
                if sign * value > best + LEVEL * size {
                    (best, place) = (sign * value, x);
                }
            }
            from = to;
        }
        if extreme.place { place } else { sign * best }
    }

    /// All that acts on a link, along and across the line of its cuts.
    pub(super) fn each_acting(&self, link: LinkId, visit: &mut dyn FnMut(Acting)) {
        let near = self.near(link);
        let roller = self.pin_of_roller(link);
        let mut act = |action: Action| {
            for action in [Some(action), action.opposite()].into_iter().flatten() {
                if action.on != link.index() || matches!(action.from, Origin::Weight | Origin::Inertia) {
                    continue;
                }
                let both = self.at_contacts(action).unwrap_or([Some(action), None]);
                let parts = both.into_iter().flatten();
                parts.for_each(|part| visit(self.acting(link, part, roller, near)));
            }
        };
        let value = |load: LoadId| self.query(&Query::Load(load));
        self.state.loads_act(&self.model(), &value, &mut act);
        self.state.acts(self.plan, &mut act);
        self.masses_act(link, near, visit);
    }

    /// The forces at the two places where a slider touches its guide.
    fn at_contacts(&self, action: Action) -> Option<[Option<Action>; 2]> {
        let Origin::Reaction(_) = action.from else { return None };
        let guide = self.guide(self.pair_of(action.from)?)?;
        let [a, b] = guide.contacts?;
        let (p, d) = (self.body(guide.slider).position(guide.point), self.along(&guide));
        let normal = d.perp().dot(action.force);
        let moment = action.couple + (action.at - p).cross(action.force);
        let first = (moment - normal * b) / (a - b);
        let at = |x: f64, n: f64| Some(Action { at: p + d * x, force: d.perp() * n, couple: 0.0, ..action });
        Some([at(a, first), at(b, normal - first)])
    }

    /// A vector of the ground along and across the line of the cuts.
    fn along_axis(&self, link: LinkId, vector: Vec2) -> Vec2 {
        let along = self.mechanism.link(link).axis().map_or(Vec2::new(1.0, 0.0), |axis| axis.1);
        vector.turned_back(self.body(link).u).turned_back(along)
    }

    /// The pair in which a cam presses on the roller of a follower, and the pin of the roller on it.
    fn pin_of_roller(&self, link: LinkId) -> Option<(PairId, Vec2)> {
        let contact = self.mechanism.cam_contacts.iter().find(|contact| contact.follower == link)?;
        let (_, hinge) = contact.roller?;
        Some((contact.pair, self.mechanism.link(link).on_axis(self.mechanism.point_in(hinge, link)?)))
    }

    fn acting(&self, link: LinkId, action: Action, roller: Option<(PairId, Vec2)>, near: f64) -> Acting {
        let (body, own) = (self.body(link), self.mechanism.link(link));
        let force = self.along_axis(link, action.force);
        let at = own.on_axis((action.at - body.p).turned_back(body.u));
        if let Origin::Load(id) = action.from
            && let LoadKind::Torque { at: Some(at), .. } = self.mechanism.loads[id.index()].kind
        {
            return Acting::At { place: own.on_axis(at), force, couple: action.couple };
        }
        if let Origin::Load(id) = action.from
            && let Some(spread) = self.mechanism.loads[id.index()].spread
        {
            return Acting::of_segment(
                own.on_axis(spread.from),
                own.on_axis(spread.to),
                spread.ends(force),
                near,
            );
        }
        if let Some((_, pin)) = roller.filter(|(pair, _)| self.pair_of(action.from) == Some(*pair)) {
            return Acting::At { place: pin, force, couple: action.couple + (at - pin).cross(force) };
        }
        Acting::At { place: at, force, couple: action.couple }
    }

    /// Weight and inertia of a link: a rod along itself, every other mass where it is.
    fn masses_act(&self, link: LinkId, near: f64, visit: &mut dyn FnMut(Acting)) {
        let step = self.plan.loads.iter().find_map(|step| match step {
            LoadStep::Mass { body, gravity, inertia, .. } if *body == link.index() => {
                Some((*gravity, *inertia))
            }
            _ => None,
        });
        let Some((gravity, inertia)) = step else { return };
        let body = self.body(link);
        let per_mass = |at: Vec2| {
            let moving = if inertia { body.acceleration(at) } else { Vec2::zero() };
            self.along_axis(link, gravity - moving)
        };
        let whole = self.mechanism.link(link);
        let mut one = |part: &MassPart| {
            let (own, turning) = (part.own, if inertia { body.alpha } else { 0.0 });
            visit(match part.shape {
                Some(MassShape::Rod { from, to }) => {
                    let density = own.mass / (to - from).norm();
                    let ends = [from, to].map(|at| per_mass(at) * density);
                    Acting::of_segment(whole.on_axis(from), whole.on_axis(to), ends, near)
                }
                _ => Acting::At {
                    place: whole.on_axis(own.centre),
                    force: per_mass(own.centre) * own.mass,
                    couple: -own.inertia * turning,
                },
            });
        };
        whole.mass_parts.iter().for_each(&mut one);
        if let (true, Some(own)) = (whole.mass_parts.is_empty(), whole.mass) {
            one(&MassPart { own, shape: None, plane: 0.0 });
        }
    }
}

/// Where a cubic through these values at 0, 1/3, 2/3 and 1 has no slope, between 0 and 1.
fn turning_points([y_0, y_1, y_2, y_3]: [f64; 4]) -> [Option<f64>; 2] {
    // y = y_0 + b s + c s² + d s³
    let (r, s, t) = (y_1 - y_0, y_2 - y_0, y_3 - y_0);
    let b = 9.0 * r - 4.5 * s + t;
    let c = -22.5 * r + 18.0 * s - 4.5 * t;
    let d = 13.5 * r - 13.5 * s + 4.5 * t;
    let size = [b, c, d].iter().fold(0.0, |m: f64, x| m.max(x.abs()));
    let inside = |x: f64| Some(x).filter(|x| *x > 0.0 && *x < 1.0);
    // b + 2 c s + 3 d s² = 0
    let square = c * c - 3.0 * b * d;
    if size == 0.0 || square < 0.0 {
        return [None; 2];
    }
    let q = -(c + square.sqrt().copysign(c));
    [if q == 0.0 { None } else { inside(b / q) }, if d == 0.0 { None } else { inside(q / (3.0 * d)) }]
}
