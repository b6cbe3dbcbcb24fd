//! Whether what is too many is true without it: at a position that is found without it, the places that it joins are compared.

use assur_math::math::Vec2;
use assur_model::model::{
    Drive, DriveId, DriveTarget, Expr, Guide, Hint, HintKind, Law, LinkId, Mechanism, Pair, PairId, PairKind,
    Positions, Profile, ProfileShape, Rate, Value,
};
use assur_model::structure::{self, Spare};
use assur_position::plan;
use assur_position::position::{BodyState, extent};
use assur_solve::message::drive_text;
use assur_solve::solve::{self, Cause, Clause, Failure, MOST_CLAUSES, Model};
use assur_text::diagnostic::Diagnosis;
use assur_text::source::Span;
use assur_text::units::{Dimension, significant};
use miette::Diagnostic;
use std::f64::consts::TAU;

/// Larger mechanisms are not solved for a help.
const MOST_LINKS: usize = 60;
/// Positions solved for one help, those of several assemblies included.
const MOST_SOLVED: usize = 24;
/// Links of one group: the search for the assemblies of a larger one takes longer than a help may.
const MOST_TOGETHER: usize = 4;
/// A place fits, over the size of the mechanism; an angle, rad.
const FITS: f64 = 1e-9;
/// Other positions of the drives: by a part of a turn, or of the size.
const STEP: f64 = 0.03;
/// Digits of a gap.
const DIGITS: usize = 4;

/// By how much ends are not where a pair or a link wants them.
#[derive(Clone, Copy)]
struct Misfit {
    /// m
    apart: f64,
    /// rad
    turned: f64,
}

/// A position without what is too many.
struct Position {
    misfit: Misfit,
    size: f64,
    /// Values of the drives.
    at: String,
    /// The coordinates of which the law of a transmission speaks, rad or m.
    coordinates: Vec<f64>,
}

impl Position {
    fn fits(&self) -> bool {
        self.misfit.apart.abs() <= FITS * self.size && self.misfit.turned.abs() <= FITS
    }

    fn worst(&self) -> f64 {
        self.misfit.apart.abs() + self.misfit.turned.abs() * self.size
    }
}

/// Adds to the help of an error of the structure whether what is to be left out is true without it.
pub(super) fn tell(mechanism: &Mechanism, errors: &mut [Diagnosis]) {
    let [error] = errors else { return };
    if !error.is("mech::determinacy::overconstrained") || mechanism.links.len() > MOST_LINKS {
        return;
    }
    let help = Diagnostic::help(error).map(|help| help.to_string()).unwrap_or_default();
    if let Some(said) = structure::spare(mechanism).and_then(|spare| words(mechanism, spare)) {
        *error = error.clone().help(format!("{help};\n{said}"));
    }
}

fn words(mechanism: &Mechanism, spare: Spare) -> Option<String> {
    let name = match spare {
        Spare::Pair(pair) => {
            let pair = mechanism.pair(pair);
            format!("`{} {}`", pair.kind.word(), pair.name)
        }
        Spare::Link(link) => format!("`{}`", mechanism.link(link).name),
        Spare::Drive(drive) => format!("`drive {}`", mechanism.drives[drive.index()].written_name()),
    };
    let left = super::equilibrium::at_rest(&spare.taken_out(mechanism)?);
    let mut search = Search { mechanism, spare, solved: 0, is_whole: true, is_choice: false };
    let first = search.best(&moved(&left, 0.0)?).filter(|_| search.is_whole)?;
    let at = if first.at.is_empty() { String::new() } else { format!(" at {}", first.at) };
    let best = if search.is_choice { ", in the assembly where it fits best" } else { "" };
    if !first.fits() {
        return Some(match spare {
            Spare::Drive(drive) => format!("without {name} {}{best}", value(mechanism, drive, &first, &at)?),
            _ => format!("without {name} its ends are {}{best}", gap(mechanism, spare, &first, &at)),
        });
    }
    let steps = [STEP, -STEP].iter();
    let others: Vec<Position> = steps.filter_map(|step| search.best(&moved(&left, *step)?)).collect();
    let same = format!(
        "the motion is the same without {name}: it repeats what others hold, and no equation determines the forces in it"
    );
    if let Some(law) = law(mechanism, spare) {
        // which of several assemblies is meant is not known
        if search.is_choice {
            return None;
        }
        let uneven = others.iter().find_map(|other| uneven(mechanism, law, &first, other));
        return match uneven {
            Some(uneven) => Some(format!("without {name} {uneven}")),
            None => (!others.is_empty()).then_some(same),
        };
    }
    let (is, wanted) = match spare {
        Spare::Drive(_) => ("its value is", "what it asks for"),
        _ => ("its ends are", "where it wants them"),
    };
    Some(match others.as_slice() {
        _ if first.at.is_empty() => {
            format!("{name} fits as it is, but no equation determines the forces in it")
        }
        [] => format!("without {name} {is} {wanted}{at}"),
        others if others.iter().all(Position::fits) => same,
        _ => format!("without {name} {is} {wanted}{at}, but not at other positions"),
    })
}

/// The law of a transmission, where it has one.
fn law(mechanism: &Mechanism, spare: Spare) -> Option<&Law> {
    let Spare::Pair(pair) = spare else { return None };
    match &mechanism.pair(pair).kind {
        PairKind::Transmission(transmission) => match transmission.laws.as_slice() {
            [law] => Some(law),
            _ => None,
        },
        _ => None,
    }
}

/// ``from crank = 40 deg to 50.8 deg `b` turns by 9.1 deg, and it wants 10.8 deg``, where the law does not hold.
fn uneven(mechanism: &Mechanism, law: &Law, first: &Position, other: &Position) -> Option<String> {
    let went = |i: usize| {
        let by = other.coordinates[i] - first.coordinates[i];
        match law.terms[i].0 {
            Rate::Turn(_) => wrapped(by),
            Rate::Slide(_) => by,
        }
    };
    // the second side follows the first
    let (rate, coefficient) = law.terms.get(1)?;
    let sum: f64 = (0..law.terms.len()).filter(|i| *i != 1).map(|i| law.terms[i].1 * went(i)).sum();
    let wanted = -sum / coefficient;
    let (name, verb) = match rate {
        Rate::Turn(link) => (&mechanism.link(*link).name, "turns"),
        Rate::Slide(pair) => (&mechanism.pair(*pair).name, "goes"),
    };
    let text = |x: f64| match rate {
        Rate::Turn(_) => format!("{} deg", significant(x.to_degrees(), DIGITS)),
        Rate::Slide(_) => mechanism.display_of(Dimension::LENGTH).text(Value::Scalar(x), DIGITS),
    };
    ((went(1) - wanted).abs() > FITS * wanted.abs().max(1.0)).then(|| {
        format!(
            "`{name}` {verb} by {} from {} to {}, and it wants {}",
            text(went(1)),
            first.at,
            other.at,
            text(wanted)
        )
    })
}

/// An angle within half a turn.
fn wrapped(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).round()
}

/// `its value is 83.1 deg at crank = 40 deg, and it asks for 90 deg`
fn value(mechanism: &Mechanism, drive: DriveId, first: &Position, at: &str) -> Option<String> {
    let wanted = first_value(&mechanism.drives[drive.index()])?;
    let text = |x: f64| match mechanism.drives[drive.index()].target {
        DriveTarget::Link(_) => format!("{} deg", significant(x.to_degrees(), DIGITS)),
        _ => mechanism.display_of(Dimension::LENGTH).text(Value::Scalar(x), DIGITS),
    };
    let is = wanted + first.misfit.apart + first.misfit.turned;
    Some(format!("its value is {}{at}, and it asks for {}", text(is), text(wanted)))
}

/// The first position of a drive.
fn first_value(drive: &Drive) -> Option<f64> {
    let first = match &drive.positions {
        Positions::List(values) => values.first()?,
        Positions::Range { from, .. } => from,
        Positions::None | Positions::Numbers(_) => return None,
    };
    match first {
        Expr::Constant(Value::Scalar(value)) => Some(*value),
        _ => None,
    }
}

/// `1.31 m apart at crank = 40 deg, and it is 1.2 m long`
fn gap(mechanism: &Mechanism, spare: Spare, first: &Position, at: &str) -> String {
    let length = |x: f64| mechanism.display_of(Dimension::LENGTH).text(Value::Scalar(x.abs()), DIGITS);
    let Misfit { apart, turned } = first.misfit;
    let turned_words = format!("turned by {} deg", significant(turned.to_degrees(), DIGITS));
    let bar = match spare {
        Spare::Link(link) => bar(mechanism, link),
        Spare::Pair(_) | Spare::Drive(_) => None,
    };
    match bar {
        Some([one, other]) => {
            let long = (one.1 - other.1).norm();
            format!("{} apart{at}, and it is {} long", length(long + apart), length(long))
        }
        None if turned <= FITS => format!("{} apart{at}", length(apart)),
        None if apart.abs() <= FITS * first.size => format!("{turned_words}{at}"),
        None => format!("{} apart and {turned_words}{at}", length(apart)),
    }
}

/// The mechanism with its drives moved on, each at one value.
pub(super) fn moved(left: &Mechanism, step: f64) -> Option<Mechanism> {
    let mut moved = left.clone();
    let size = left.links.iter().flat_map(|link| &link.points).map(|p| p.at.norm()).fold(0.0, f64::max);
    for drive in &mut moved.drives {
        let value = first_value(drive)?;
        let is_angle = match drive.target {
            DriveTarget::Link(_) => true,
            DriveTarget::Pair(pair) => matches!(left.pair(pair).kind, PairKind::Revolute(_)),
            DriveTarget::Point(..) | DriveTarget::Place(..) => false,
        };
        let by = step * if is_angle { TAU } else { size };
        drive.positions = Positions::List(vec![Expr::number(value + by)]);
    }
    Some(moved)
}

/// Solves a mechanism without what is too many.
struct Search<'a> {
    /// With it.
    mechanism: &'a Mechanism,
    spare: Spare,
    solved: usize,
    /// All assemblies were solved.
    is_whole: bool,
    /// There are several, and the file chooses none.
    is_choice: bool,
}

impl Search<'_> {
    /// The assembly in which the ends fit best.
    fn best(&mut self, left: &Mechanism) -> Option<Position> {
        self.is_whole &= self.solved < MOST_SOLVED;
        if !self.is_whole {
            return None;
        }
        self.solved += 1;
        let clauses = match self.solve(left)? {
            Ok(position) => return Some(position),
            Err(clauses) => clauses,
        };
        self.is_choice = true;
        let hints: Vec<Hint> = clauses.iter().filter_map(|clause| hint(left, clause)).collect();
        self.is_whole &= hints.len() == clauses.len() && hints.len() < MOST_CLAUSES;
        let mut best: Option<Position> = None;
        for hint in hints {
            let mut chosen = left.clone();
            chosen.hints.push(hint);
            let found = self.best(&chosen);
            let better = |one: &Position| best.as_ref().is_none_or(|best| one.worst() < best.worst());
            if let Some(found) = found.filter(better) {
                best = Some(found);
            }
        }
        best
    }

    /// A position, or the clauses of which one has to be chosen.
    fn solve(&self, left: &Mechanism) -> Option<Result<Position, Vec<Clause>>> {
        let (structure, _) = structure::structure(left).ok()?;
        let largest = structure.motion.iter().map(|group| group.bodies.len()).max();
        if largest > Some(MOST_TOGETHER) && !is_as_written(left) {
            return None;
        }
        let plan = plan::plan(left, &structure);
        let model = Model { mechanism: left, structure: &structure, plan: &plan };
        let failure = match solve::solve(&model) {
            Ok(mut solution) => {
                let pose = solution.poses.pop()?;
                match pose.outcome {
                    Ok(solved) => {
                        let bodies = &solved.state.motion.bodies;
                        let misfit = misfit(self.mechanism, self.spare, bodies)?;
                        let coordinates = law(self.mechanism, self.spare)
                            .map(|law| coordinates(self.mechanism, law, bodies))
                            .unwrap_or_default();
                        let at = drive_text(&model, &pose.drives);
                        return Some(Ok(Position { misfit, size: extent(&model), at, coordinates }));
                    }
                    Err(failure) => failure,
                }
            }
            Err(mut failures) => failures.pop()?,
        };
        match failure {
            Failure { cause: Cause::Ambiguous { groups, .. }, .. } => Some(Err(groups.into_iter().next()?.1)),
            _ => None,
        }
    }
}

/// Each pin joins points of the same coordinates, as in a truss: it stands as it is written.
fn is_as_written(mechanism: &Mechanism) -> bool {
    mechanism.pairs.iter().all(|pair| match &pair.kind {
        PairKind::Revolute(pins) => pins.windows(2).all(|two| (two[0].at - two[1].at).norm() <= FITS),
        _ => true,
    })
}

/// A clause that chooses an assembly.
fn hint(mechanism: &Mechanism, clause: &Clause) -> Option<Hint> {
    let hinge = |pair: PairId| match &mechanism.pair(pair).kind {
        PairKind::Revolute(pins) => pins.first().map(|pin| (pin.link, pin.at)),
        PairKind::Prismatic(guide) | PairKind::Slot(guide) => Some((guide.slider, guide.point)),
        _ => None,
    };
    let kind = match *clause {
        Clause::Side { hinge: at, from, to, left } => {
            HintKind::Side { point: hinge(at)?, from: hinge(from)?, to: hinge(to)?, left }
        }
        Clause::Near { point, place } => {
            let at = mechanism.link(point.link).points.get(point.index)?.at;
            HintKind::Near { point: (point.link, at), place }
        }
        Clause::Sign { pair, positive } => HintKind::Coordinate { pair, bound: 0.0, greater: positive },
        Clause::Along { hinge: at, other, ahead } => {
            let links = mechanism.pair(at).kind.links();
            let is_guide = |pair: &Pair| {
                matches!(pair.kind, PairKind::Prismatic(_) | PairKind::Slot(_))
                    && pair.kind.links().iter().any(|link| *link != LinkId::GROUND && links.contains(link))
            };
            let pair = PairId::at(mechanism.pairs.iter().position(is_guide)?);
            HintKind::Along { point: hinge(at)?, other: hinge(other)?, pair, ahead }
        }
        Clause::Between { .. } => return None,
    };
    Some(Hint { span: Span::default(), kind })
}

/// A place on another link that a pin holds, and the pin's own.
type Held = ((LinkId, Vec2), Vec2);

/// The pins of a link.
fn pins(mechanism: &Mechanism, link: LinkId) -> impl Iterator<Item = Held> {
    mechanism.pairs.iter().filter_map(move |pair| match &pair.kind {
        PairKind::Revolute(pins) => {
            let own = pins.iter().find(|pin| pin.link == link)?;
            let other = pins.iter().find(|pin| pin.link != link)?;
            Some(((other.link, other.at), own.at))
        }
        _ => None,
    })
}

/// Both pins of a link that has no other pairs.
fn bar(mechanism: &Mechanism, link: LinkId) -> Option<[Held; 2]> {
    let pairs = mechanism.pairs.iter().filter(|pair| pair.kind.links().contains(&link)).count();
    <[Held; 2]>::try_from(pins(mechanism, link).collect::<Vec<_>>()).ok().filter(|_| pairs == 2)
}

/// The guide of a slider with one pin, at the point that slides, and what the pin holds.
fn slider(mechanism: &Mechanism, link: LinkId) -> Option<(Held, &Guide)> {
    let mut own = mechanism.pairs.iter().filter(|pair| pair.kind.links().contains(&link));
    let guide = own.clone().find_map(|pair| match &pair.kind {
        PairKind::Prismatic(guide) if guide.slider == link => Some(guide),
        _ => None,
    })?;
    let pin = pins(mechanism, link).next()?;
    (own.nth(2).is_none() && pin.1 == guide.point).then_some((pin, guide))
}

fn misfit(mechanism: &Mechanism, spare: Spare, bodies: &[BodyState]) -> Option<Misfit> {
    let at = |(link, at): (LinkId, Vec2)| bodies[link.index()].position(at);
    let off = |guide: &Guide, place: Vec2| {
        let along = guide.along.turned(bodies[guide.guide.index()].u);
        along.cross(place - at((guide.guide, guide.through))).abs()
    };
    let mut turned = 0.0;
    let pair = match spare {
        Spare::Pair(pair) => &mechanism.pair(pair).kind,
        Spare::Link(link) => {
            let apart = match bar(mechanism, link) {
                Some([one, other]) => (at(one.0) - at(other.0)).norm() - (one.1 - other.1).norm(),
                None => slider(mechanism, link).map(|(pin, guide)| off(guide, at(pin.0)))?,
            };
            return Some(Misfit { apart, turned });
        }
        Spare::Drive(drive) => return of_drive(mechanism, &mechanism.drives[drive.index()], bodies),
    };
    let apart = match pair {
        PairKind::Revolute(pins) => {
            let first = at((pins.first()?.link, pins.first()?.at));
            pins.iter().map(|pin| (at((pin.link, pin.at)) - first).norm()).fold(0.0, f64::max)
        }
        PairKind::Slot(g) => off(g, at((g.slider, g.point))),
        PairKind::Prismatic(g) => {
            let along = g.along.turned(bodies[g.guide.index()].u);
            let own = g.direction.turned(bodies[g.slider.index()].u);
            turned = libm::atan2(own.cross(along), own.dot(along)).abs();
            off(g, at((g.slider, g.point)))
        }
        // what its law says of other positions is looked at apart
        PairKind::Transmission(transmission) if transmission.laws.len() == 1 => 0.0,
        PairKind::Contact { first, second, internal, .. } => of_contact(bodies, [first, second], *internal)?,
        _ => return None,
    };
    Some(Misfit { apart, turned })
}

/// By how much a drive is not where it is to be.
fn of_drive(mechanism: &Mechanism, drive: &Drive, bodies: &[BodyState]) -> Option<Misfit> {
    let wanted = first_value(drive)?;
    match (&drive.positions, drive.target) {
        // others may go on with it
        (Positions::List(values), _) if values.len() > 1 => None,
        (Positions::List(_), DriveTarget::Link(link)) => {
            Some(Misfit { apart: 0.0, turned: wrapped(turn(&bodies[link.index()]) - wanted) })
        }
        (Positions::List(_), DriveTarget::Pair(pair)) => {
            Some(Misfit { apart: coordinate(mechanism, pair, bodies)? - wanted, turned: 0.0 })
        }
        _ => None,
    }
}

fn turn(body: &BodyState) -> f64 {
    libm::atan2(body.u.y, body.u.x)
}

/// The coordinate of a slide, or the length of a cylinder.
fn coordinate(mechanism: &Mechanism, pair: PairId, bodies: &[BodyState]) -> Option<f64> {
    let at = |link: LinkId, at: Vec2| bodies[link.index()].position(at);
    match &mechanism.pair(pair).kind {
        PairKind::Prismatic(g) | PairKind::Slot(g) => {
            let along = g.along.turned(bodies[g.guide.index()].u);
            Some(along.dot(at(g.slider, g.point) - at(g.guide, g.through)))
        }
        PairKind::Cylinder { from, to, .. } => Some((at(from.link, from.at) - at(to.link, to.at)).norm()),
        _ => None,
    }
}

fn coordinates(mechanism: &Mechanism, law: &Law, bodies: &[BodyState]) -> Vec<f64> {
    let of = |rate: &Rate| match rate {
        Rate::Turn(link) => turn(&bodies[link.index()]),
        Rate::Slide(pair) => coordinate(mechanism, *pair, bodies).unwrap_or(0.0),
    };
    law.terms.iter().map(|(rate, _)| of(rate)).collect()
}

/// By how much two profiles do not touch.
fn of_contact(bodies: &[BodyState], profiles: [&Profile; 2], internal: bool) -> Option<f64> {
    let round = |profile: &Profile| match profile.shape {
        ProfileShape::Point(at) => Some((bodies[profile.link.index()].position(at), 0.0)),
        ProfileShape::Circle(at, radius) => Some((bodies[profile.link.index()].position(at), radius)),
        ProfileShape::Line(..) | ProfileShape::Rim(_) => None,
    };
    let line = |profile: &Profile| match profile.shape {
        ProfileShape::Line(through, along) => {
            let body = &bodies[profile.link.index()];
            Some((body.position(through), along.turned(body.u)))
        }
        _ => None,
    };
    let [first, second] = profiles;
    let off = |(centre, radius): (Vec2, f64), (through, along): (Vec2, Vec2)| {
        (along.cross(centre - through).abs() - radius).abs()
    };
    match (round(first), round(second)) {
        (Some((a, r_a)), Some((b, r_b))) => {
            let wanted = if internal { (r_a - r_b).abs() } else { r_a + r_b };
            Some(((a - b).norm() - wanted).abs())
        }
        (Some(circle), None) => Some(off(circle, line(second)?)),
        (None, Some(circle)) => Some(off(circle, line(first)?)),
        (None, None) => None,
    }
}
