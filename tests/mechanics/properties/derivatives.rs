//! Velocities against differences of positions, accelerations against differences of velocities: the same mechanism a
//! little earlier and later.

use super::compare::Worst;
use crate::support::draft::Draft;
use crate::support::reference::number;
use crate::support::run::{Run, scalar, vector};
use assur::internals::math::Vec2;
use assur::internals::model::{Expr, LinkId, Mechanism, PointRef, Positions, Query};

/// Step in time, s.
const STEP: f64 = 1e-3;

/// The mechanism at another time: the drives go on with their speeds and accelerations.
fn after(m: &Mechanism, t: f64) -> Mechanism {
    let mut m = m.clone();
    for drive in &mut m.drives {
        let rate = drive.speed.as_ref().map_or(0.0, number);
        let second = drive.acceleration.as_ref().map_or(0.0, number);
        if let Positions::List(list) = &mut drive.positions {
            for x in list {
                *x = Expr::number(number(x) + rate * t + second * (t * t / 2.0));
            }
        }
        drive.speed = Some(Expr::number(rate + second * t));
    }
    m
}

/// Differences of fourth order, in units of a tolerance that leaves room for their own error.
pub fn derivatives(draft: &Draft, run: &Run) -> Result<Worst, String> {
    let times = [-2.0, -1.0, 1.0, 2.0];
    let runs: Vec<Run> =
        times.iter().map(|k| Run::new(&after(&draft.mechanism, k * STEP))).collect::<Result<_, _>>()?;
    let mut views = Vec::new();
    for run in &runs {
        views.push(run.view(0)?);
    }
    let now = run.view(0)?;
    let sigma = run.solved(0)?.condition.clamp(1e-3, 1.0);
    let rate = |f: &dyn Fn(usize) -> Vec2| ((f(2) - f(1)) * 8.0 - (f(3) - f(0))) / (12.0 * STEP);
    let mut worst = Worst::default();
    let links: Vec<LinkId> = (1..draft.frames.len()).map(LinkId::at).collect();
    let of = |query: &dyn Fn(LinkId) -> Query| {
        links.iter().map(|l| vector(&now, &query(*l)).norm()).fold(1.0, f64::max)
    };
    let point = |link| PointRef::Fixed(link, Vec2::new(0.3, -0.2));
    let speed = of(&|l| Query::Velocity(point(l)));
    let most = of(&|l| Query::Acceleration(point(l))).max(speed * speed);
    // the error of the differences grows with the fifth derivative of the motion
    let truncation = (STEP * most.sqrt().max(speed) / sigma).powi(4) * 1e12;
    for &link in &links {
        let p = |i: usize| vector(&views[i], &Query::Position(point(link)));
        let v = |i: usize| vector(&views[i], &Query::Velocity(point(link)));
        let u = |i: usize| vector(&views[i], &Query::LinkDirection(link));
        let (got, want) = (vector(&now, &Query::Velocity(point(link))), rate(&p));
        let room = 1.0 + truncation;
        let name = || format!("link {}", link.0);
        worst.note("differences of positions", (got - want).norm(), 1e2 * room * speed / sigma.powi(2), name);
        let omega = vector(&now, &Query::LinkDirection(link)).cross(rate(&u));
        let got = scalar(&now, &Query::Omega(link));
        worst.note(
            "differences of directions",
            (got - omega).abs(),
            1e2 * room * speed / sigma.powi(2),
            name,
        );
        let (got, want) = (vector(&now, &Query::Acceleration(point(link))), rate(&v));
        worst.note("differences of velocities", (got - want).norm(), 1e2 * room * most / sigma.powi(3), name);
        let w = |i: usize| Vec2::new(scalar(&views[i], &Query::Omega(link)), 0.0);
        let (got, want) = (scalar(&now, &Query::Alpha(link)), rate(&w).x);
        worst.note("differences of omega", (got - want).abs(), 1e2 * room * most / sigma.powi(3), name);
    }
    Ok(worst)
}
