//! Places in closed chains of prismatic pairs at the written numbers. The angles of their bodies are known, so that each pair is a linear
//! condition on their origins. A condition that the others give already has to agree with them. Where it repeats them only because lines are
//! parallel, something else is left free.

use super::echelon::{Echelon, Number, row};
use super::effort::{Effort, EffortKind, EffortSource};
use super::joint::{BodyId, BodyOrigin, JointId, JointKind, Replaced};
use super::lines::{Edge, Placed, angle, chains, degrees, or_without};
use super::roller::listed;
use super::trial::Trial;
use super::uses::Uses;
use super::words::{drive_statement, drive_word, ends, free_name, is_taken, line, statement};
use crate::math::Vec2;
use crate::model::{Guide, LinkId, Mechanism, Pair, PairId, PairKind, Value};
use crate::units::Dimension;
use assur_text::diagnostic::Diagnosis;

/// Lengths that are nearer to each other are one, over the greatest.
const SAME: f64 = 1e-9;
/// Less is nothing but rounding, of coefficients that are at most 1: lines at a small angle are not parallel.
const ROUNDING: f64 = 1e-13;
/// Digits of lengths.
const DIGITS: usize = 12;

/// A linear condition on the origins of two bodies, in the axes of the first body of their chain.
struct Condition {
    owner: Owner,
    terms: Vec<(usize, f64)>,
    right: f64,
    /// Along what the places are compared.
    normal: Vec2,
    /// The same for lines at random angles.
    generic: Vec<(usize, Number)>,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Owner {
    Guide(PairId),
    Pin(PairId),
    Effort(usize),
}

/// A condition that others give already.
struct Repeated {
    owner: Owner,
    /// The pairs of the others.
    by: Vec<PairId>,
    /// What its place, seen in its guide, has to move by to agree.
    gap: Vec2,
    /// Only because lines are parallel.
    is_special: bool,
}

/// The conditions of a mechanism.
struct Chains<'a> {
    replaced: &'a Replaced,
    placed: Vec<Option<Placed>>,
    conditions: Vec<Condition>,
    size: f64,
}

/// The first pair that is held at two places.
pub(super) fn contradiction(trial: Trial<'_>) -> Option<Diagnosis> {
    let chains = Chains::of(trial.mechanism, trial.replaced, &[]);
    let repeated = chains.repeated().into_iter().find(|one| chains.is_told(one))?;
    Some(apart(trial, &chains, repeated.owner.pair()?, &repeated))
}

/// Whether nothing is to be said of places.
pub(super) fn agree(mechanism: &Mechanism, replaced: &Replaced, efforts: &[Effort]) -> bool {
    let chains = Chains::of(mechanism, replaced, efforts);
    !chains.repeated().iter().any(|one| one.is_special || chains.is_told(one))
}

/// What parallel lines leave free, where all is determined at other angles.
pub(super) fn parallel(trial: Trial<'_>) -> Option<Diagnosis> {
    let chains = Chains::of(trial.mechanism, trial.replaced, trial.efforts);
    let repeated = chains.repeated().into_iter().find(|one| one.is_special)?;
    Some(free(trial, &chains, &repeated))
}

impl<'a> Chains<'a> {
    fn of(mechanism: &Mechanism, replaced: &'a Replaced, efforts: &[Effort]) -> Self {
        let (edges, placed) = chains(mechanism, replaced);
        let mut this = Self { replaced, placed, conditions: Vec::new(), size: 0.0 };
        if edges.is_empty() {
            return this;
        }
        this.add_guides(&edges);
        this.add_pins();
        for (i, effort) in efforts.iter().enumerate() {
            if let Some(EffortKind::Coordinate(joint)) = effort.only() {
                this.conditions.extend(this.coordinate(joint, Owner::Effort(i)));
            }
        }
        this
    }

    fn add_guides(&mut self, edges: &[Edge]) {
        for edge in edges {
            let JointKind::Prismatic { slider, point, guide, through, along, offset, .. } =
                self.replaced.joint(edge.joint).kind
            else {
                continue;
            };
            // on which side a round profile lies is a matter of assembly
            if offset == 0.0 && !self.is_on_rim(slider) && !self.is_on_rim(guide) {
                let normal = self.turned(guide, along).perp();
                let random = random_direction(guide, through, along);
                let across = [-random[1], random[0]];
                let ends = [(slider, point), (guide, through)];
                self.conditions.extend(self.condition(Owner::Guide(edge.pair), normal, across, ends));
                self.size = self.size.max(point.norm()).max(through.norm());
            }
        }
    }

    fn add_pins(&mut self) {
        for joint in &self.replaced.joints {
            let JointKind::Revolute(members) = &joint.kind else { continue };
            if members.iter().any(|member| self.is_on_rim(member.0)) {
                continue;
            }
            for (i, second) in members.iter().enumerate().skip(1) {
                let Some(first) = members[..i].iter().find(|first| self.is_beside(first.0, second.0)) else {
                    continue;
                };
                let axes = [
                    (Vec2::new(1.0, 0.0), [Number::ONE, Number::ZERO]),
                    (Vec2::new(0.0, 1.0), [Number::ZERO, Number::ONE]),
                ];
                for (axis, generic) in axes {
                    let ends = [*first, *second];
                    self.conditions.extend(self.condition(Owner::Pin(joint.pair), axis, generic, ends));
                }
                self.size = self.size.max(first.1.norm()).max(second.1.norm());
            }
        }
    }

    /// The coordinate of a prismatic joint.
    fn coordinate(&self, joint: JointId, owner: Owner) -> Option<Condition> {
        let JointKind::Prismatic { slider, point, guide, through, along, .. } =
            self.replaced.joint(joint).kind
        else {
            return None;
        };
        let random = random_direction(guide, through, along);
        self.condition(owner, self.turned(guide, along), random, [(slider, point), (guide, through)])
    }

    /// Two places have one coordinate in a direction. `None` for bodies of two chains.
    fn condition(
        &self,
        owner: Owner,
        normal: Vec2,
        random: [Number; 2],
        ends: [(BodyId, Vec2); 2],
    ) -> Option<Condition> {
        let [(a, p), (b, q)] = ends;
        if !self.is_beside(a, b) {
            return None;
        }
        let is_free = |body: BodyId| self.placed[body.0].is_some_and(|placed| placed.root != body.0);
        let columns = |body: BodyId| is_free(body).then_some([2 * body.0, 2 * body.0 + 1]);
        let mut condition = Condition {
            owner,
            terms: Vec::new(),
            right: normal.dot(self.turned(b, q) - self.turned(a, p)),
            normal,
            generic: Vec::new(),
        };
        for (columns, sign, minus) in [(columns(a), 1.0, false), (columns(b), -1.0, true)] {
            let Some([x, y]) = columns else { continue };
            condition.terms.extend([(x, sign * normal.x), (y, sign * normal.y)]);
            let signed = |number: Number| if minus { -number } else { number };
            condition.generic.extend([(x, signed(random[0])), (y, signed(random[1]))]);
        }
        Some(condition)
    }

    fn is_beside(&self, a: BodyId, b: BodyId) -> bool {
        let root = |body: BodyId| self.placed[body.0].map(|placed| placed.root);
        a != b && root(a).is_some() && root(a) == root(b)
    }

    fn is_on_rim(&self, body: BodyId) -> bool {
        self.replaced.bodies[body.0].on_rim
    }

    /// The angle of a link, from the first body of its chain.
    fn angle(&self, link: LinkId) -> f64 {
        let body = self.placed[self.replaced.body_of(link).0].map_or(0.0, |placed| placed.angle);
        body + self.replaced.part(link).map_or(0.0, |part| part.angle)
    }

    /// A vector of a body in the axes of the first body of its chain.
    fn turned(&self, body: BodyId, vector: Vec2) -> Vec2 {
        vector.turned(unit(self.placed[body.0].map_or(0.0, |placed| placed.angle)))
    }

    /// The conditions that those before them give, in order.
    fn repeated(&self) -> Vec<Repeated> {
        let unknowns = 2 * self.replaced.bodies.len();
        let mut generic = Echelon::new(unknowns);
        let mut rows: Vec<Reduced> = Vec::new();
        let mut found = Vec::new();
        let mut index = 0;
        for owned in self.conditions.chunk_by(|a, b| a.owner == b.owner) {
            let (mut repeats, mut at_random) = (Vec::new(), 0);
            for condition in owned {
                at_random += usize::from(!generic.add(row(condition.generic.clone())));
                let reduced = Reduced::of(condition, index, &rows, unknowns);
                if reduced.pivot.is_some() {
                    rows.push(reduced);
                } else {
                    repeats.push((condition, reduced));
                }
                index += 1;
            }
            // which of the two conditions of a pin repeats depends on the axes
            let is_special = repeats.len() > at_random;
            found.extend(repeats.iter().map(|(of, reduced)| self.repeat(of, reduced, is_special)));
        }
        found
    }

    fn repeat(&self, condition: &Condition, reduced: &Reduced, is_special: bool) -> Repeated {
        let parts = reduced.sum.iter().map(|(i, factor)| (&self.conditions[*i], *factor));
        let others = parts.clone().filter(|(part, _)| part.owner != condition.owner);
        let mut by: Vec<PairId> = others.filter_map(|(part, _)| part.owner.pair()).collect();
        by.sort_unstable();
        by.dedup();
        let own = parts.filter(|(part, _)| part.owner == condition.owner);
        let normal = own.fold(Vec2::zero(), |sum, (part, factor)| sum + part.normal * factor);
        let gap = normal * (reduced.right / normal.dot(normal));
        Repeated { owner: condition.owner, by, gap, is_special }
    }

    /// Whether what is repeated disagrees: by parallel lines, or by two guides on one line. The structure says what is too many at any
    /// angles.
    fn is_told(&self, one: &Repeated) -> bool {
        let is_off = one.gap.norm() > SAME * self.size;
        match one.owner {
            Owner::Guide(_) => is_off && (one.is_special || one.by.len() == 1),
            Owner::Pin(_) => is_off && one.is_special,
            Owner::Effort(_) => false,
        }
    }
}

impl Owner {
    const fn pair(self) -> Option<PairId> {
        match self {
            Self::Guide(pair) | Self::Pin(pair) => Some(pair),
            Self::Effort(_) => None,
        }
    }
}

/// A condition less the multiples of those before it that it contains.
struct Reduced {
    terms: Vec<(usize, f64)>,
    right: f64,
    /// The column in which it is the greatest; none where nothing is left.
    pivot: Option<(usize, f64)>,
    /// Of which conditions it is the sum, with their factors.
    sum: Vec<(usize, f64)>,
}

impl Reduced {
    fn of(condition: &Condition, index: usize, rows: &[Self], unknowns: usize) -> Self {
        let mut values = vec![0.0; unknowns];
        let mut factors = vec![0.0; index + 1];
        condition.terms.iter().for_each(|(column, value)| values[*column] += value);
        factors[index] = 1.0;
        let mut right = condition.right;
        for row in rows {
            let Some((column, value)) = row.pivot else { continue };
            let factor = values[column] / value;
            if factor != 0.0 {
                row.terms.iter().for_each(|(column, value)| values[*column] -= factor * value);
                row.sum.iter().for_each(|(i, value)| factors[*i] -= factor * value);
                values[column] = 0.0;
                right -= factor * row.right;
            }
        }
        let kept = |values: Vec<f64>| -> Vec<(usize, f64)> {
            values.into_iter().enumerate().filter(|(_, value)| value.abs() > ROUNDING).collect()
        };
        let terms = kept(values);
        let pivot = terms.iter().copied().max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
        Self { terms, right, pivot, sum: kept(factors) }
    }
}

fn unit(angle: f64) -> Vec2 {
    Vec2::new(libm::cos(angle), libm::sin(angle))
}

/// The random direction of a line of a body, the same for all that slide on it.
fn random_direction(body: BodyId, through: Vec2, along: Vec2) -> [Number; 2] {
    let parts = [through.x, through.y, along.x, along.y].map(|x| (x + 0.0).to_bits());
    let seed = parts.iter().fold(body.0 as u64, |sum, bits| sum.rotate_left(21) ^ bits);
    [Number::random(seed), Number::random(seed.rotate_left(32))]
}

/// A pair whose places are parallel and not one, and the number that makes them one.
fn apart(trial: Trial<'_>, chains: &Chains<'_>, pair: PairId, repeated: &Repeated) -> Diagnosis {
    let mechanism = trial.mechanism;
    let length = |x: f64| mechanism.display_of(Dimension::LENGTH).text(Value::Scalar(x), DIGITS);
    let distance = length(repeated.gap.norm());
    let by: Vec<String> = repeated.by.iter().map(|p| format!("`{}`", mechanism.pair(*p).name)).collect();
    let of = |link: LinkId, name: &str| format!("`{name}` of `{}`", mechanism.link(link).name);
    let (what, label) = match &mechanism.pair(pair).kind {
        PairKind::Prismatic(g) | PairKind::Slot(g) => {
            let own = g.own_line.as_ref().unwrap_or(&g.point_name);
            let lies = format!("{} lies {distance} off {}", of(g.slider, own), of(g.guide, &g.line_name));
            (lies, "parallel, and not on each other")
        }
        kind => {
            let ends: Vec<String> = ends(kind).iter().map(|(link, name)| of(*link, name)).collect();
            (format!("{} stay {distance} apart", listed(&ends, "and")), "never at one place")
        }
    };
    let help = match moved(trial, chains, pair, repeated.gap) {
        Some(Moved { name, to, link, line: None }) => {
            format!("write `{name} ({}, {})` in `{link}`", length(to[0]), length(to[1]))
        }
        Some(Moved { name, to, link, line: Some(line) }) => {
            let at = format!("{name} ({}, {})", length(to[0]), length(to[1]));
            format!("others use the point: add `{at}` to `{link}`, and write `{line}`")
        }
        None => format!("move a point by {distance}"),
    };
    Diagnosis::error(
        "mech::determinacy::apart",
        format!("{} cannot hold: {what} (by {})", statement(mechanism, pair), listed(&by, "and")),
    )
    .label(mechanism.pair(pair).span, label)
    .help(or_without(trial, pair, help))
}

/// A point where it has to be for a pair to hold.
struct Moved {
    name: String,
    /// m
    to: [f64; 2],
    link: String,
    /// What else is to be written, where it is a new point.
    line: Option<String>,
}

/// A point that no other pair uses, or a new one in its place.
fn moved(trial: Trial<'_>, chains: &Chains<'_>, pair: PairId, gap: Vec2) -> Option<Moved> {
    let mechanism = trial.mechanism;
    let uses = Uses::of(mechanism, Some(pair));
    let ends = match &mechanism.pair(pair).kind {
        PairKind::Prismatic(g) | PairKind::Slot(g) => [(g.slider, g.point), (g.guide, g.through)],
        PairKind::Revolute(pins) => match pins.as_slice() {
            [a, b] => [(a.link, a.at), (b.link, b.at)],
            _ => return None,
        },
        _ => return None,
    };
    // the first end moves by the gap, or the second by its opposite
    let ends = [(ends[0], gap), (ends[1], gap * -1.0)].map(|((link, at), gap)| (link, at, gap));
    let place = |&(link, at, gap): &(LinkId, Vec2, Vec2)| {
        let to = at + gap.turned_back(unit(chains.angle(link)));
        [to.x, to.y].map(|x| if x.abs() < SAME * chains.size { 0.0 } else { x })
    };
    let mut likely = ends;
    // the first point of a link is its origin by the way it is written
    likely.sort_by_key(|(link, at, _)| (*at == Vec2::zero(), *link == LinkId::GROUND));
    let unused = likely.iter().find_map(|end| {
        let points = &mechanism.link(end.0).points;
        let point = points.iter().find(|point| point.at == end.1)?;
        let is_used = uses.count(end.0, &point.name) + uses.of_lines(end.0, point) > 0;
        (!is_used).then(|| Moved {
            name: point.name.clone(),
            to: place(end),
            link: mechanism.link(end.0).name.clone(),
            line: None,
        })
    });
    unused.or_else(|| new_point(mechanism, pair, place(&ends[0])))
}

/// A point of the first link of a pair beside the one that the pair joins.
fn new_point(mechanism: &Mechanism, pair: PairId, to: [f64; 2]) -> Option<Moved> {
    let Pair { name: own, kind, .. } = mechanism.pair(pair);
    let link = mechanism.link(*kind.links().first()?);
    let (_, old) = *ends(kind).first()?;
    let taken =
        |name: &str| is_taken(mechanism, name, None) || link.points.iter().any(|point| point.name == name);
    let name = free_name(&format!("{old}2"), taken);
    let at = Vec2::new(to[0], to[1]);
    let line = match kind.clone() {
        PairKind::Prismatic(guide) | PairKind::Slot(guide) if guide.own_line.is_some() => {
            let along = degrees(angle(guide.direction));
            format!("line {} through {name} along {along}", guide.own_line.unwrap_or_default())
        }
        PairKind::Prismatic(guide) => {
            let guide = Guide { point_name: name.clone(), point: at, ..guide };
            line(mechanism, own, &PairKind::Prismatic(guide))?
        }
        PairKind::Slot(guide) => {
            let guide = Guide { point_name: name.clone(), point: at, ..guide };
            line(mechanism, own, &PairKind::Slot(guide))?
        }
        PairKind::Revolute(mut pins) => {
            let first = pins.first_mut()?;
            (first.name, first.at) = (name.clone(), at);
            line(mechanism, own, &PairKind::Revolute(pins))?
        }
        _ => return None,
    };
    Some(Moved { name, to, link: link.name.clone(), line: Some(line) })
}

/// What parallel lines leave free.
fn free(trial: Trial<'_>, chains: &Chains<'_>, repeated: &Repeated) -> Diagnosis {
    let mechanism = trial.mechanism;
    let by: Vec<String> = repeated.by.iter().map(|p| statement(mechanism, *p)).collect();
    let by = listed(&by, "and");
    let holds = if repeated.by.len() == 1 { "holds" } else { "hold" };
    let turn = "give one of their lines another angle";
    match repeated.owner {
        Owner::Effort(effort) => {
            let EffortSource::Drive(id) = trial.efforts[effort].source else {
                return Diagnosis::error("mech::determinacy::parallel", "parallel lines leave a link free");
            };
            let drive = &mechanism.drives[id.index()];
            let (what, word, name) = (drive_statement(drive), drive_word(drive), drive.written_name());
            let other = other_coordinate(trial, chains, effort)
                .map_or_else(String::new, |pair| format!("write `{word} {pair}`, with its own value, or "));
            Diagnosis::error(
                "mech::determinacy::parallel",
                format!("{what} moves nothing: {by} {holds} `{name}` already, by parallel lines"),
            )
            .label(drive.span, "cannot change")
            .help(format!("{other}{turn}"))
        }
        Owner::Guide(pair) | Owner::Pin(pair) => Diagnosis::error(
            "mech::determinacy::parallel",
            format!(
                "{} holds only what {by} {holds} already, by parallel lines: something can still move",
                statement(mechanism, pair)
            ),
        )
        .label(mechanism.pair(pair).span, "parallel to others")
        .help(turn),
    }
}

/// A prismatic pair whose coordinate is free in place of the one of a drive.
fn other_coordinate(trial: Trial<'_>, chains: &Chains<'_>, effort: usize) -> Option<String> {
    let joints = trial.replaced.joints.iter().enumerate();
    let coordinates = joints.filter(|(_, joint)| {
        matches!(joint.kind, JointKind::Prismatic { slider, .. }
            if matches!(trial.replaced.bodies[slider.0].origin, BodyOrigin::Link(_)))
    });
    coordinates.into_iter().find_map(|(i, joint)| {
        let mut trial_efforts = trial.efforts.to_vec();
        trial_efforts[effort].kind = EffortKind::Coordinate(JointId(i));
        let with = Chains::of(trial.mechanism, chains.replaced, &trial_efforts);
        let is_free = with.repeated().iter().all(|one| !one.is_special);
        is_free.then(|| trial.mechanism.pair(joint.pair).name.clone())
    })
}
