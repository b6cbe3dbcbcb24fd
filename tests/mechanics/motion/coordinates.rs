//! The same motion started by other coordinates: it goes on past their dead positions.

use super::newton_euler::{followed, last};
use super::{freed, many};
use crate::support::run::{Run, scalar, vector};
use assur::internals::math::Vec2;
use assur::internals::model::{
    Drive, DriveTarget, Expr, Find, FindKind, LinkId, PairId, PairKind, PointRef, Positions, Query,
};

/// A drive that is where a link or a sliding pair is at the first instant, as fast as it is there.
fn started(run: &Run, drive: &Drive, target: DriveTarget) -> Option<Drive> {
    let view = run.view(0).ok()?;
    let (value, rate) = match target {
        DriveTarget::Link(link) => (Query::Angle(link), Query::Omega(link)),
        DriveTarget::Pair(pair) => (Query::Displacement(pair), Query::RelativeVelocity(pair)),
        DriveTarget::Point(..) | DriveTarget::Place(..) => return None,
    };
    let (value, rate) = (scalar(&view, &value), scalar(&view, &rate));
    let name = format!("other {}", drive.name);
    let positions = Positions::List(vec![Expr::number(value)]);
    let speed = Some(Expr::number(rate));
    // at its own dead position, where it rests, a coordinate does not say how the mechanism moves
    (value.is_finite() && rate.abs() > 1e-6).then(|| Drive {
        name,
        target,
        positions,
        speed,
        ..drive.clone()
    })
}

/// The greatest difference of two runs of one mechanism at the instants of the first, places over the extent, velocities and
/// forces over the greatest.
fn apart(one: &Run, two: &Run, end: usize) -> f64 {
    let links = || (1..one.mechanism.links.len()).map(LinkId::at);
    let mut most = 0.0_f64;
    let mut look = |queries: &[Query], scale: f64| {
        let mut greatest = scale;
        let mut differs = 0.0_f64;
        for pose in 0..=end {
            let (Ok(a), Ok(b)) = (one.view(pose), two.view(pose)) else { continue };
            for query in queries {
                let (a, b) = (vector(&a, query), vector(&b, query));
                greatest = greatest.max(a.norm());
                let d = (a - b).norm();
                differs = if d.is_nan() { f64::INFINITY } else { differs.max(d) };
            }
        }
        most = most.max(differs / greatest);
    };
    let at = |link| PointRef::Fixed(link, Vec2::new(0.3, -0.2));
    look(&links().map(|link| Query::Position(at(link))).collect::<Vec<_>>(), 1.0);
    look(&links().map(|link| Query::Velocity(at(link))).collect::<Vec<_>>(), 1e-3);
    look(&links().map(|link| Query::Acceleration(at(link))).collect::<Vec<_>>(), 1e-3);
    let pairs = (0..one.mechanism.pairs.len()).map(PairId::at);
    let reactions = pairs.flat_map(|pair| {
        let links = match &one.mechanism.pair(pair).kind {
            PairKind::Revolute(pins) => pins.iter().map(|pin| pin.link).collect(),
            PairKind::Prismatic(guide) => vec![guide.slider],
            _ => Vec::new(),
        };
        links.into_iter().map(move |link| Query::Reaction(pair, link))
    });
    look(&reactions.collect::<Vec<_>>(), 1e-3);
    most
}

/// How far apart both are at the first instant.
fn places_apart(one: &Run, two: &Run) -> f64 {
    let (Ok(a), Ok(b)) = (one.view(0), two.view(0)) else { return f64::INFINITY };
    let links = (1..one.mechanism.links.len()).map(LinkId::at);
    let at = |link| Query::Position(PointRef::Fixed(link, Vec2::new(0.3, -0.2)));
    let each = links.map(|link| (vector(&a, &at(link)) - vector(&b, &at(link))).norm());
    each.fold(0.0, f64::max)
}

#[test]
fn a_motion_does_not_depend_on_what_is_started() {
    let (mut compared, mut changed, mut crossed, mut ended, mut worst) = (0, 0, 0, 0, (0.0, 0));
    for seed in 60_000.. {
        if compared >= many(60) {
            break;
        }
        let mut draft = freed(seed);
        if draft.rollers.len() + usize::from(draft.frames.len() > 9) > 0 {
            continue;
        }
        draft.mechanism.loads.retain(|load| !load.is_against_motion() && load.when.is_none());
        let span = draft.mechanism.drives[0].span;
        draft.mechanism.finds = vec![Find { name: "reactions".into(), span, kind: FindKind::Reactions }];
        followed(&mut draft.mechanism, 0.7, Some(6), 1e-10);
        let Ok(one) = Run::new(&draft.mechanism) else { continue };
        let Some(end) = last(&one) else { continue };
        let drives = draft.mechanism.drives.len();
        let index = draft.random.below(drives);
        if !draft.mechanism.drives[index].free {
            continue;
        }
        let links = (1..draft.mechanism.links.len()).map(|i| DriveTarget::Link(LinkId::at(i)));
        let sliding = (0..draft.mechanism.pairs.len())
            .map(PairId::at)
            .filter(|pair| matches!(draft.mechanism.pair(*pair).kind, PairKind::Prismatic(_)));
        let others: Vec<DriveTarget> = links.chain(sliding.map(DriveTarget::Pair)).collect();
        let target = others[draft.random.below(others.len())];
        if draft.mechanism.drives.iter().any(|drive| drive.target == target) {
            continue;
        }
        let Some(other) = started(&one, &draft.mechanism.drives[index], target) else { continue };
        let mut mechanism = draft.mechanism.clone();
        mechanism.drives[index] = other;
        let Ok(two) = Run::new(&mechanism) else { continue };
        let Ok(solution) = &two.solution else { continue };
        // the other start may choose another assembly
        if places_apart(&one, &two) > 1e-9 {
            continue;
        }
        let Some(report) = solution.simulation.as_ref() else { continue };
        changed += u64::from(!report.changes.is_empty());
        crossed += u64::from(!report.crossed.is_empty());
        let Some(_) = last(&two) else {
            ended += 1;
            continue;
        };
        compared += 1;
        let apart = apart(&one, &two, end);
        if apart > worst.0 {
            worst = (apart, seed);
        }
        if apart > 1e-8 {
            println!("seed {seed}: {apart:e}");
        }
    }
    println!(
        "{compared} compared, {changed} in other coordinates, {crossed} over change points, {ended} ended, worst {worst:?}"
    );
    assert!(worst.0 < 1e-8, "{worst:?}");
    assert!(changed > compared / 10 && ended < compared / 5, "{changed}, {ended}");
}
