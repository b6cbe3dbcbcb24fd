//! What an answer claims, and what is true of it.

use super::exact::Exact;
use crate::hard::double_double::DoubleDouble as Real;
use crate::support::digits::force_errors;
use crate::support::equilibrium::{Forces, equilibrium};
use crate::support::reference::{Body, Rates};
use crate::support::run::{Run, scalar, vector};
use assur::internals::math::{V2, Vec2};
use assur::internals::model::{BalanceId, BalanceKind, DriveId, LinkId, Mechanism, PairKind, Query};
use assur::internals::solve::{Note, PoseAnswers, Solved};

/// Digits that an answer claims where no warning says how many are left.
pub const UNWARNED: f64 = 7.0;

/// The kinds of numbers in an answer, with the power of σ in what they lose.
pub const KINDS: [(&str, i32); 4] =
    [("positions", 1), ("velocities", 2), ("accelerations", 3), ("forces", 3)];

/// Relative errors of an answer by kind; `None` for what cannot be judged.
#[derive(Clone, Copy, Debug)]
pub struct Judged {
    pub errors: [Option<f64>; 4],
    pub condition: f64,
    /// Digits left, as warned of.
    pub warned: Option<u32>,
}

/// The digits of the only warning that speaks of digits.
pub fn warned(run: &Run) -> Option<u32> {
    let notes = &run.solution.as_ref().ok()?.notes;
    notes.iter().find_map(|w| match w {
        Note::IllConditioned { digits, .. } => Some(*digits),
        _ => None,
    })
}

/// Judges the answer of a run with one position.
pub fn judge(run: &Run, solved: &Solved) -> Result<Judged, String> {
    let m = &run.mechanism;
    let bodies = &solved.state.motion.bodies[..m.links.len()];
    let poses: Vec<(Vec2, Vec2)> = bodies.iter().map(|b| (b.p, b.u)).collect();
    let size = size(m, &poses);
    let condition = solved.condition;
    let exact = Exact::new(m, &poses, size)
        .ok_or_else(|| format!("no solution is near the answer, condition {condition:.1e}"))?;
    let rounded = |x: V2<Real>| -> Vec2 { Vec2::new(low(x.x), low(x.y)) };
    let mut errors = [0.0_f64; 3];
    let mut most = [1.0, f64::MIN_POSITIVE, f64::MIN_POSITIVE];
    for (i, body) in bodies.iter().enumerate() {
        let r = &exact.rates[i];
        let apart = |got: Vec2, want: V2<Real>| (V2::of(got) - want).norm().0;
        let [v, a] = [rounded(r.v), rounded(r.a)];
        let (omega, alpha) = (low(r.omega), low(r.alpha));
        errors[0] = errors[0].max(apart(body.p, exact.p[i]) / size).max(apart(body.u, exact.u[i]));
        errors[1] = errors[1].max(apart(body.v, r.v) / size).max((body.omega - omega).abs());
        errors[2] = errors[2].max(apart(body.a, r.a) / size).max((body.alpha - alpha).abs());
        most[1] = most[1].max(v.norm() / size).max(omega.abs());
        most[2] = most[2].max(a.norm() / size).max(alpha.abs()).max(omega * omega);
    }
    // what is nothing is not judged relative to itself
    most[2] = most[2].max(most[1] * most[1]);
    let mut out = Judged { errors: [None; 4], condition, warned: warned(run) };
    for k in 0..3 {
        out.errors[k] = Some(errors[k] / most[k]);
    }
    out.errors[3] = forces(run, &exact, size, most[1], &rounded)?;
    Ok(out)
}

fn low(x: Real) -> f64 {
    x.0
}

/// The greatest coordinate in play, m.
fn size(m: &Mechanism, poses: &[(Vec2, Vec2)]) -> f64 {
    let mut size = poses.iter().map(|x| x.0.norm()).fold(0.0, f64::max);
    for pair in &m.pairs {
        let at = match &pair.kind {
            PairKind::Revolute(pins) | PairKind::Weld { pins, .. } => {
                pins.iter().map(|p| p.at.norm()).fold(0.0, f64::max)
            }
            PairKind::Prismatic(g) | PairKind::Slot(g) => g.point.norm().max(g.through.norm()),
            PairKind::Contact { .. } | PairKind::Transmission(_) => 0.0,
            PairKind::Cylinder { from, to, .. } => from.at.norm().max(to.at.norm()),
        };
        size = size.max(at);
    }
    size
}

fn forces(
    run: &Run,
    exact: &Exact,
    size: f64,
    turning: f64,
    rounded: &impl Fn(V2<Real>) -> Vec2,
) -> Result<Option<f64>, String> {
    let m = &run.mechanism;
    let rates: Vec<Rates> = exact
        .rates
        .iter()
        .map(|r| Rates { v: rounded(r.v), omega: low(r.omega), a: rounded(r.a), alpha: low(r.alpha) })
        .collect();
    let bodies: Vec<Body> =
        (0..rates.len()).map(|i| Body::moving(rounded(exact.p[i]), rounded(exact.u[i]), &rates[i])).collect();
    let Some(forces) = equilibrium(m, &bodies, &rates) else { return Ok(None) };
    // a load that depends on the sign of nothing
    if forces.doubtful {
        return Ok(None);
    }
    // where nothing acts, what rounding makes of the inertia is judged relative to the masses in motion
    let masses: f64 = m.links.iter().filter_map(|l| Some(l.mass?.mass)).sum();
    let floor = 1e-6 * masses * size * turning * turning;
    // a system that f64 does not solve to eight digits
    if forces.condition < 1e-7 {
        let (solution, solved) = (run.solution.as_ref().map_err(|e| format!("{e:?}"))?, run.solved(0)?);
        let Some(exact) = solution.reference(&run.model(), solved) else { return Ok(None) };
        let (error, most) = force_errors(&run.model(), solved, &exact);
        return Ok(Some(error / most.max(floor)));
    }
    let most = forces.most.0.max(forces.most.1 / size).max(floor).max(f64::MIN_POSITIVE);
    Ok(Some(off(run, &run.view(0)?, &forces, size) / most))
}

/// The worst error of a force, or of a moment over the size.
fn off(run: &Run, view: &PoseAnswers<'_>, forces: &Forces, size: f64) -> f64 {
    let m = &run.mechanism;
    let mut worst = 0.0_f64;
    for on in &forces.reactions {
        let kind = &m.pair(on.pair).kind;
        if matches!(kind, PairKind::Cylinder { barrel, rod, .. } if on.link == *barrel || on.link == *rod) {
            continue;
        }
        if on.determined.0 {
            worst = worst.max((vector(view, &Query::Reaction(on.pair, on.link)) - on.force).norm());
        }
        if matches!(kind, PairKind::Prismatic(_)) && on.determined.1 {
            let got = scalar(view, &Query::Moment(on.pair, on.link));
            worst = worst.max((got - on.couple).abs() / size);
        }
    }
    for (i, effort) in forces.efforts.iter().enumerate() {
        let (query, torque) = if m.balances.is_empty() {
            (Query::Effort(DriveId::at(i)), m.drives.get(i).is_some_and(|d| turns(m, &d.target)))
        } else {
            let torque = match &m.balances[i].kind.places()[0] {
                BalanceKind::Torque(_) | BalanceKind::Several(_) => true,
                BalanceKind::Force { .. } => false,
                BalanceKind::InPair(pair) => matches!(m.pair(*pair).kind, PairKind::Revolute(_)),
            };
            (Query::Balance(BalanceId::at(i)), torque)
        };
        let scale = if torque { size } else { 1.0 };
        worst = worst.max((scalar(view, &query) - effort).abs() / scale);
    }
    worst
}

fn turns(m: &Mechanism, target: &assur::internals::model::DriveTarget) -> bool {
    match target {
        assur::internals::model::DriveTarget::Link(link) => *link != LinkId::GROUND,
        assur::internals::model::DriveTarget::Pair(pair) => {
            matches!(m.pair(*pair).kind, PairKind::Revolute(_))
        }
        assur::internals::model::DriveTarget::Point(..) | assur::internals::model::DriveTarget::Place(..) => {
            false
        }
    }
}
