//! A start of a point may repeat what contacts of its link fix: it must fit them, and such a coordinate is no start.
//!
//! Which coordinates are left out is tried: those are kept from which the mechanism follows best.

use assur_math::math::Vec2;
use assur_model::model::{
    Display, Drive, DriveTarget, Expr, Find, FindKind, Hint, HintKind, LinkId, Mechanism, Pair, PairKind,
    PointRef, Positions, Query, Value,
};
use assur_model::structure;
use assur_position::plan;
use assur_position::position::{BodyState, extent};
use assur_solve::solve::{self, Cause, Failure, Model};
use assur_text::diagnostic::Diagnosis;
use assur_text::source::Span;
use assur_text::units::Dimension;
use miette::LabeledSpan;

/// How well a start fits its contacts: place over the size, velocity over the greatest.
const FITS: f64 = 1e-9;
/// Coordinates among which those are sought that repeat others.
const MOST: usize = 8;
/// Digits of places and velocities.
const DIGITS: usize = 12;

/// A coordinate of a point that is started.
struct Coordinate {
    drive: usize,
    link: LinkId,
    at: Vec2,
}

/// A first position without some of the starts.
struct First {
    left_out: Vec<usize>,
    bodies: Vec<BodyState<f64>>,
    condition: f64,
    size: f64,
}

/// Takes out the starts of points that contacts repeat.
///
/// # Errors
/// One of them does not fit.
pub(super) fn leave_out(mechanism: &mut Mechanism) -> Result<(), Diagnosis> {
    let all = coordinates(mechanism);
    if all.is_empty() || structure::structure(mechanism).is_ok() {
        return Ok(());
    }
    let Some(first) = first_position(mechanism, &all) else { return Ok(()) };
    let left_out = all.iter().filter(|one| first.left_out.contains(&one.drive));
    for one in left_out {
        fit(mechanism, &all, one, &first)?;
    }
    let hints = near(mechanism, &all);
    mechanism.hints.extend(hints);
    remove(mechanism, &first.left_out);
    Ok(())
}

/// The started coordinates of points of links that are in contact, themselves or by what they are joined to.
fn coordinates(mechanism: &Mechanism) -> Vec<Coordinate> {
    let touches = |link| contacts(mechanism, link).next().is_some();
    let drives = mechanism.drives.iter().enumerate().filter(|(_, drive)| drive.free);
    // what is no number is not compared with the contact: the starts are then too many
    let is_number = |expr: Option<&Expr>| matches!(expr, Some(Expr::Constant(Value::Scalar(_))));
    let is_known = |d: &Drive| is_number(place(d)) && is_number(d.speed.as_ref());
    let places = drives.filter_map(|(drive, d)| match d.target {
        DriveTarget::Place(link, at, _) if touches(link) && is_known(d) => {
            Some(Coordinate { drive, link, at })
        }
        _ => None,
    });
    places.take(MOST).collect()
}

/// The contacts of a link, or else of what it is joined to.
fn contacts(mechanism: &Mechanism, link: LinkId) -> impl Iterator<Item = &Pair> {
    let mut joined = vec![link];
    let touching = |joined: &[LinkId], pair: &Pair| {
        let links = pair.kind.links();
        matches!(pair.kind, PairKind::Contact { .. }) && links.iter().any(|link| joined.contains(link))
    };
    let mut next = 0;
    while next < joined.len() && !mechanism.pairs.iter().any(|pair| touching(&joined, pair)) {
        let links = mechanism.pairs.iter().map(|pair| pair.kind.links());
        let beside = links.filter(|links| links.contains(&joined[next])).flatten().collect::<Vec<_>>();
        for link in beside {
            if link != LinkId::GROUND && !joined.contains(&link) {
                joined.push(link);
            }
        }
        next += 1;
    }
    mechanism.pairs.iter().filter(move |pair| touching(&joined, pair))
}

/// The best first position without as few starts as possible. Where none has a position, one of several assemblies of which the file
/// chooses none, or the first that is determined at all: it has no bodies.
fn first_position(mechanism: &Mechanism, all: &[Coordinate]) -> Option<First> {
    for count in 1..=all.len() {
        let sets = (1..1_usize << all.len()).filter(|set| set.count_ones() as usize == count);
        let chosen = |set: usize| (0..all.len()).filter(move |i| set >> i & 1 == 1);
        let sets = sets.map(|set| chosen(set).map(|i| all[i].drive).collect::<Vec<_>>());
        let found = sets.filter_map(|left_out| position(mechanism, all, left_out));
        let best = found.reduce(|best, next| if next.condition > best.condition { next } else { best });
        if best.is_some() {
            return best;
        }
    }
    None
}

/// `None` where the mechanism is not determined without these starts.
fn position(mechanism: &Mechanism, all: &[Coordinate], left_out: Vec<usize>) -> Option<First> {
    let mut still = at_first(mechanism);
    still.hints.extend(near(mechanism, all));
    remove(&mut still, &left_out);
    let (structure, _) = structure::structure(&still).ok()?;
    let plan = plan::plan(&still, &structure);
    let model = Model { mechanism: &still, structure: &structure, plan: &plan };
    let size = extent(&model);
    let outcome = match solve::solve(&model) {
        Ok(mut solution) => solution.poses.pop().map(|pose| pose.outcome),
        Err(mut failures) => failures.pop().map(Err),
    };
    Some(match outcome {
        Some(Ok(one)) => First { left_out, bodies: one.state.motion.bodies, condition: one.condition, size },
        Some(Err(Failure { cause: Cause::Ambiguous { .. }, .. })) => {
            First { left_out, bodies: Vec::new(), condition: f64::MIN_POSITIVE, size }
        }
        _ => First { left_out, bodies: Vec::new(), condition: 0.0, size },
    })
}

/// The mechanism at its first instant, of which nothing but velocities is asked.
fn at_first(mechanism: &Mechanism) -> Mechanism {
    let from = mechanism.simulation.as_ref().map_or(0.0, |simulation| simulation.from);
    let asked = mechanism.drives.iter().find_map(|drive| match drive.target {
        DriveTarget::Place(link, at, _) => Some(Query::Velocity(PointRef::Fixed(link, at))),
        _ => None,
    });
    let mut still = super::equilibrium::at_rest(mechanism);
    for (drive, moving) in still.drives.iter_mut().zip(&mechanism.drives) {
        drive.speed = if moving.of_time { Some(Expr::number(0.0)) } else { moving.speed.clone() };
        drive.of_time = false;
        if let Positions::List(list) = &mut drive.positions {
            let instant = |leaf: &Expr| match leaf {
                Expr::Query(Query::Time) => Expr::number(from),
                other => other.clone(),
            };
            list.iter_mut().for_each(|at| *at = at.map_leaves(&mut { instant }));
        }
    }
    let find = |query: Query| {
        let kind = FindKind::Value { expr: Expr::Query(query), display: Display::default(), poseless: false };
        Find { name: String::new(), span: Span::default(), kind }
    };
    still.finds = asked.map(find).into_iter().collect();
    still
}

fn remove(mechanism: &mut Mechanism, drives: &[usize]) {
    let mut index = 0..;
    mechanism.drives.retain(|_| index.next().is_none_or(|i| !drives.contains(&i)));
}

/// Where the started points are, for the choice of the assembly.
fn near(mechanism: &Mechanism, all: &[Coordinate]) -> Vec<Hint> {
    let hint = |one: &Coordinate| {
        let place = started(mechanism, all, one, place);
        let kind = HintKind::Near { point: (one.link, one.at), place };
        Hint { span: mechanism.drives[one.drive].span, kind }
    };
    let first_of = |i: usize| !all[..i].iter().any(|o| (o.link, o.at) == (all[i].link, all[i].at));
    all.iter().enumerate().filter(|(i, _)| first_of(*i)).map(|(_, one)| hint(one)).collect()
}

/// The coordinate that a start gives.
fn place(drive: &Drive) -> Option<&Expr> {
    match &drive.positions {
        Positions::List(list) => list.first(),
        _ => None,
    }
}

/// What the starts say of a point.
fn started<'m>(
    mechanism: &'m Mechanism,
    all: &[Coordinate],
    of: &Coordinate,
    part: impl Fn(&'m Drive) -> Option<&'m Expr>,
) -> Vec2 {
    let same = all.iter().filter(|one| (one.link, one.at) == (of.link, of.at));
    let parts = same.map(|one| &mechanism.drives[one.drive]).filter_map(|drive| {
        let DriveTarget::Place(_, _, axis) = drive.target else { return None };
        let Some(Expr::Constant(Value::Scalar(x))) = part(drive) else { return None };
        Some(axis.unit() * *x)
    });
    parts.fold(Vec2::zero(), |sum, part| sum + part)
}

/// Whether the point of a start is where the position found has it, and moves as it says.
fn fit(mechanism: &Mechanism, all: &[Coordinate], one: &Coordinate, first: &First) -> Result<(), Diagnosis> {
    let Some(body) = first.bodies.get(one.link.index()) else { return Ok(()) };
    let place = started(mechanism, all, one, place);
    let found = body.position(one.at);
    if (found - place).norm() > FITS * first.size.max(place.norm()) {
        return Err(misfit(mechanism, one, (place, found), Dimension::LENGTH));
    }
    let velocity = started(mechanism, all, one, |drive| drive.speed.as_ref());
    let timed = mechanism.drives.iter().any(|drive| drive.of_time);
    let found = body.velocity(one.at);
    let fastest = first.bodies.iter().map(|b| b.v.norm() + b.omega.abs() * first.size).fold(0.0, f64::max);
    if !timed && (found - velocity).norm() > FITS * fastest.max(velocity.norm()) {
        return Err(misfit(mechanism, one, (velocity, found), Dimension::VELOCITY));
    }
    Ok(())
}

fn misfit(
    mechanism: &Mechanism,
    one: &Coordinate,
    (said, found): (Vec2, Vec2),
    dimension: Dimension,
) -> Diagnosis {
    let drive = &mechanism.drives[one.drive];
    let name = drive.written_name();
    let display = mechanism.display_of(dimension);
    let text = |value: Value, digits| display.text(value, digits);
    let scale = said.norm().max(found.norm());
    let rounded = |x: f64| if x.abs() < FITS * scale { 0.0 } else { x };
    let unit = |x: f64| display.text(Value::Scalar(rounded(x)), DIGITS);
    let vector = format!("({}, {})", unit(found.x), unit(found.y));
    let apart = text(Value::Scalar((found - said).norm()), 4);
    let contacts: Vec<_> = contacts(mechanism, one.link).collect();
    let names: Vec<String> = contacts.iter().map(|pair| format!("`{}`", pair.name)).collect();
    let names = names.join(" and ");
    let (message, line) = if dimension == Dimension::LENGTH {
        let line = format!("start {name} = {vector}");
        (format!("`{name}` starts {apart} from where contact {names} has it"), line)
    } else {
        (
            format!("`{name}` starts at a velocity that differs by {apart} from what contact {names} allows"),
            format!("at {vector}"),
        )
    };
    let mut labels = vec![LabeledSpan::new_primary_with_span(Some("started here".into()), drive.span)];
    labels.extend(
        contacts.iter().map(|pair| LabeledSpan::new_with_span(Some("touches here".into()), pair.span)),
    );
    let help = if dimension == Dimension::LENGTH {
        format!("write `{line}`, with the velocity behind it, or leave contact {names} out")
    } else {
        format!("write the velocity `{line}`")
    };

    Diagnosis::error("mech::simulate::off_contact", message).labels(labels).help(help)
}
