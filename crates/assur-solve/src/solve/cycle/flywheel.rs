//! Flywheels: how much inertia keeps the speed of a shaft within bounds over a cycle.
//!
//! The effort of power P has on the drive's shaft the torque P/ω_d, on the flywheel's P/ω. Against its mean over the
//! cycle it does the work W(φ) = ∫ (P/ω_d − mean) dφ, whose extremes lie where the difference passes through zero. The
//! effort comes from kinetostatics at constant speed: what the links' own kinetic energy takes and gives is in it. With
//! ω = ω_m (1 + e) and small e, (J + J_r(φ)) ω_m² e(φ) = W(φ) + const, where J_r is the reduced moment of inertia of the
//! links; the flywheel alone keeps δ = e_max − e_min with J = [W]/(ω_m² δ). With `with_links` the mean of J_r takes its
//! share of it.

use super::panels::{Piecewise, piecewise};
use super::sampler::Sampler;
use super::switches::breaks;
use crate::answer::{FlywheelAnswer, NoFlywheel, Undefined, WholeCycle, constant};
use crate::math::chebyshev::Series;
use crate::model::{BinaryOp, DriveId, Expr, Flywheel, FlywheelPart, FlywheelTorque, Query, Value};
use crate::position::{Model, turns};
use crate::structure::EffortSource;

/// How much the ratio of the shaft to the drive may vary, relative to its mean.
const EVEN: f64 = 1e-9;
/// Places at which that is looked at: no whole part of a turn of common mechanisms.
const PLACES: u8 = 23;

/// A flywheel, and what it was compared with.
pub(super) struct Found {
    pub answer: FlywheelAnswer,
    /// It is not needed: moment of inertia of the links, and that needed in all.
    pub needless: Option<[f64; 2]>,
}

/// A flywheel that is asked for.
#[derive(Clone, Copy)]
pub(super) struct FlywheelRequest {
    /// Index into [`crate::model::Mechanism::flywheels`].
    pub index: usize,
    /// As it would be without friction.
    pub ideal: bool,
}

pub(super) fn flywheel(
    model: &Model<'_>,
    statics: &WholeCycle,
    sampler: &mut Sampler<'_>,
    asked: FlywheelRequest,
) -> Result<Found, NoFlywheel> {
    let wheel = &model.mechanism.flywheels[asked.index];
    let rate = one_turning_drive(model, statics, sampler)?;
    let Some([torque, links]) = numbers(model, statics, asked) else {
        return Err(NoFlywheel::Efforts);
    };
    let ratio = even_ratio(statics, sampler, wheel, rate)?;
    let both = [&torque, &links];
    sampler.begin();
    let found = breaks(model, statics, sampler, &torque)
        .and_then(|breaks| Ok((piecewise(sampler, statics, (&both, None), &breaks)?, breaks)));
    let (all, breaks) = found.map_err(NoFlywheel::Undefined)?;
    let [torque, links] = all.as_slice() else {
        return Err(NoFlywheel::Undefined(Undefined::Unresolved));
    };
    let mean_speed = match wheel.speed {
        Some(speed) => speed,
        None if model.plan.effects.timed => (rate * ratio).abs(),
        None => return Err(NoFlywheel::NeedsSpeed),
    };
    let mean = torque.integral();
    let work = work(torque, mean, sampler.interval.length());
    let (least, greatest) = extremes(torque, &work, mean);
    let fluctuation = greatest.1 - least.1;
    let (least_links, greatest_links) = bounds(links);
    // nothing but rounding where all links stand
    let least_links = Some(least_links).filter(|x| *x > 1e-12 * greatest_links).unwrap_or(0.0);
    let reduced = [links.integral(), least_links, greatest_links];
    let needed = fluctuation / (mean_speed * mean_speed * wheel.fluctuation);
    let own = if wheel.with_links { reduced[0] } else { 0.0 };
    let needless = (needed <= own && wheel.with_links).then_some([own, needed]);
    let answer = FlywheelAnswer {
        inertia: (needed - own).max(0.0),
        fluctuation,
        mean_torque: mean / ratio,
        speed: mean_speed,
        ratio,
        extremes: [least.0, greatest.0].map(|s| sampler.interval.value(s)),
        links: reduced,
        error: 2.0 * torque.error * sampler.interval.length().abs(),
        samples: sampler.samples,
        splits: breaks.iter().map(|s| sampler.interval.value(*s)).collect(),
        work,
        interval: (sampler.interval.value(0.0), sampler.interval.length()),
    };
    Ok(Found { answer, needless })
}

/// The speed of the one drive, which goes through whole turns.
fn one_turning_drive(
    model: &Model<'_>,
    statics: &WholeCycle,
    sampler: &Sampler<'_>,
) -> Result<f64, NoFlywheel> {
    let [drive] = model.mechanism.drives.as_slice() else { return Err(NoFlywheel::Drives) };
    if !turns(model, drive) || !sampler.interval.is_closed {
        return Err(NoFlywheel::NoCycle(sampler.interval.turns));
    }
    match rate(model, statics) {
        0.0 if model.plan.effects.timed => Err(NoFlywheel::StandsStill),
        0.0 => Err(NoFlywheel::NeedsSpeed),
        rate => Ok(rate),
    }
}

/// Speed of the one drive, rad/s, or its sense; zero where it has neither.
fn rate(model: &Model<'_>, statics: &WholeCycle) -> f64 {
    let Some(drive) = model.mechanism.drives.first() else { return 0.0 };
    let constant = |e: &Expr| match constant(model, statics, e) {
        Value::Scalar(x) => Some(x),
        _ => None,
    };
    drive.speed.as_ref().and_then(constant).or(drive.sense).unwrap_or(0.0)
}

/// What is followed over the cycle: the effort reduced to the drive, the reduced moment of inertia of the links.
pub(super) fn numbers(model: &Model<'_>, statics: &WholeCycle, asked: FlywheelRequest) -> Option<[Expr; 2]> {
    let FlywheelRequest { index, ideal } = asked;
    let power = power(model, &model.mechanism.flywheels[index])?;
    let power = if ideal { Expr::Frictionless(Box::new(power)) } else { power };
    let rate = Expr::number(rate(model, statics));
    let torque = Expr::Binary(BinaryOp::Div, Box::new(power), Box::new(rate));
    Some([torque, Expr::Query(Query::Flywheel(index, FlywheelPart::LinksInertia))])
}

/// The power of the effort that is evened out.
fn power(model: &Model<'_>, wheel: &Flywheel) -> Option<Expr> {
    let query = match wheel.torque {
        Some(FlywheelTorque::Balance(id)) => Query::BalancePower(id),
        Some(FlywheelTorque::Load(id)) => Query::LoadPower(id),
        None => match model.structure.efforts.as_slice() {
            [effort] => match effort.source {
                EffortSource::Balance(id) => Query::BalancePower(id),
                EffortSource::Drive(id) => Query::EffortPower(DriveId::at(id.index())),
            },
            _ => return None,
        },
    };
    Some(Expr::Query(query))
}

/// The constant ratio of the flywheel's shaft to the drive.
fn even_ratio(
    statics: &WholeCycle,
    sampler: &mut Sampler<'_>,
    wheel: &Flywheel,
    rate: f64,
) -> Result<f64, NoFlywheel> {
    let speed = Expr::Query(Query::Omega(wheel.on));
    let (mut least, mut greatest) = (f64::INFINITY, f64::NEG_INFINITY);
    for place in 0..PLACES {
        let s = f64::from(place) / f64::from(PLACES);
        let here = sampler.sample(statics, s, &speed);
        let ratio = here.map_err(NoFlywheel::Undefined)?.value / rate;
        (least, greatest) = (least.min(ratio), greatest.max(ratio));
    }
    if greatest - least <= EVEN * greatest.abs() && greatest.abs() > 0.0 {
        return Ok(wheel.ratio * 0.5 * (least + greatest));
    }
    Err(NoFlywheel::Uneven([least, greatest]))
}

/// The antiderivative of the difference to the mean over the drive's value, panel by panel.
fn work(torque: &Piecewise, mean: f64, length: f64) -> Vec<Series> {
    let mut done = 0.0;
    let mut panels = Vec::with_capacity(torque.panels.len());
    for panel in &torque.panels {
        let work = panel.clone().less(mean).times(length).antiderivative(done);
        done = work.value(work.to);
        panels.push(work);
    }
    panels
}

/// Least and greatest work, each with its place: at the roots of the difference, and where the torque jumps.
fn extremes(torque: &Piecewise, work: &[Series], mean: f64) -> ((f64, f64), (f64, f64)) {
    let (mut least, mut greatest) = ((0.0, 0.0), (0.0, 0.0));
    for (panel, work) in torque.panels.iter().zip(work) {
        let roots = panel.clone().less(mean).roots();
        for s in roots.into_iter().chain([panel.to]) {
            let here = (s, work.value(s));
            if here.1 < least.1 {
                least = here;
            }
            if here.1 > greatest.1 {
                greatest = here;
            }
        }
    }
    (least, greatest)
}

/// Least and greatest value.
fn bounds(of: &Piecewise) -> (f64, f64) {
    let values = of.candidates().into_iter().map(|c| c.value);
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), x| (least.min(x), most.max(x)))
}
