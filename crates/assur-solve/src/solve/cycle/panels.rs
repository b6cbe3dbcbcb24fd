//! Quantities as Chebyshev series, panel by panel.

use super::sampler::Sampler;
use crate::answer::{Undefined, WholeCycle, is_zero};
use crate::math::chebyshev::{NODES, Nodes, Series};
use crate::model::Expr;

/// More digits than this are not few.
pub(super) const COARSE: f64 = 1e-9;

/// Panels per turn of the drive at the start.
const PER_TURN: f64 = 8.0;
/// The same where few digits are wanted, and where very few are.
const FEW_PER_TURN: [f64; 2] = [3.0, 1.5];
/// More digits than this are not very few.
const VERY_COARSE: f64 = 1e-5;
/// What a series of a panel that was halved so often still leaves off is rounding below this part of the size of its function.
const NOISE: f64 = 16.0 * f64::EPSILON;
const HALVED: u32 = 3;
const MOST: usize = 2000;
/// A number is unbounded if it exceeds its first magnitude `FAR` times on a panel narrower than this part of the sweep.
const NARROW: f64 = 1e-6;
const FAR: f64 = 1e3;

/// A quantity over the sweep.
#[derive(Clone, Debug)]
pub(super) struct Piecewise {
    /// In order, without gaps, from 0 to 1.
    pub panels: Vec<Series>,
    /// Between which panels the quantity may jump: places.
    pub breaks: Vec<f64>,
    /// The greatest magnitude of all samples.
    pub scale: f64,
    /// What its rounding is small against.
    pub size: f64,
    /// Estimated error of the integral, rounding included.
    pub error: f64,
}

/// A place where a quantity may be greatest or least.
#[derive(Clone, Copy, Debug)]
pub(super) struct Candidate {
    pub at: f64,
    /// The value of the panel's series there.
    pub value: f64,
    /// At a jump, of which the value is one side.
    pub at_jump: bool,
}

impl Piecewise {
    /// The integral over s.
    pub(super) fn integral(&self) -> f64 {
        let sum = self.panels.iter().map(Series::integral).sum();
        if is_zero(sum, self.size) { 0.0 } else { sum }
    }

    /// Whether it is zero everywhere but for rounding.
    pub(super) fn is_nothing(&self) -> bool {
        is_zero(self.scale, self.size)
    }

    /// Places where the quantity may be greatest or least, in order.
    pub(super) fn candidates(&self) -> Vec<Candidate> {
        let mut all = Vec::new();
        let mut slope_before: Option<f64> = None;
        for panel in &self.panels {
            let slope = panel.derivative();
            let at_jump = self.breaks.contains(&panel.from);
            let begins = Candidate { at: panel.from, value: panel.value(panel.from), at_jump };
            // within a smooth stretch only where the slope changes its sign between two panels
            if at_jump || slope_before.is_none_or(|before| before * slope.value(panel.from) <= 0.0) {
                all.push(begins);
            }
            let inside = slope.roots().into_iter();
            all.extend(inside.map(|at| Candidate { at, value: panel.value(at), at_jump: false }));
            let at_jump = self.breaks.contains(&panel.to);
            if at_jump || panel.to == 1.0 {
                all.push(Candidate { at: panel.to, value: panel.value(panel.to), at_jump });
            }
            slope_before = Some(slope.value(panel.to));
        }
        all
    }
}

/// Numbers over the sweep that are smooth between the breaks. If the greatest (1) or the least (−1) of a number is sought, it may grow
/// without bound in the other direction.
pub(super) fn piecewise(
    sampler: &mut Sampler<'_>,
    statics: &WholeCycle,
    (exprs, sought): (&[&Expr], Option<f64>),
    breaks: &[f64],
) -> Result<Vec<Piecewise>, Undefined> {
    let nodes = Nodes::new();
    let small = sampler.tolerance;
    let mut waiting: Vec<(f64, f64, u32)> =
        first_panels(sampler, breaks).into_iter().map(|(from, to)| (from, to, 0)).collect();
    let mut sampled = Vec::new();
    for (from, to, _) in &waiting {
        sampled.push(sample(sampler, statics, exprs, &nodes, *from, *to)?);
    }
    let of_all = |which: usize| {
        let all = sampled.iter().map(|p: &Sampled| &p[which]);
        let (scale, size) = all.fold((0.0_f64, 0.0_f64), |(scale, size), panel| {
            let greatest = panel.values.iter().fold(scale, |most, x| most.max(x.abs()));
            (greatest, size.max(panel.size))
        });
        let error = 4.0 * f64::EPSILON * if is_zero(scale, size) { size } else { scale };
        Piecewise { panels: Vec::new(), breaks: breaks.to_vec(), scale, size, error }
    };
    let mut done: Vec<Piecewise> = (0..exprs.len()).map(of_all).collect();
    // what is nothing but rounding is never smooth, beside something it is nothing
    let is_rounding = done.iter().all(|d| d.scale <= sampler.rounding);
    let rounding = if is_rounding { 0.0 } else { sampler.rounding };
    // from the beginning on: halves go back on the pile
    waiting.reverse();
    sampled.reverse();
    while let (Some((from, to, halved)), Some(panel)) = (waiting.pop(), sampled.pop()) {
        let length = to - from;
        let has_converged = |(panel, of): (&Panel, &Piecewise)| {
            let tail = panel.series.tail();
            of.is_nothing()
                || tail * length <= (small * of.scale).max(rounding)
                || (halved >= HALVED && tail <= NOISE * of.size)
        };
        if panel.iter().zip(&done).all(has_converged) {
            for (panel, out) in panel.into_iter().zip(&mut done) {
                if out.is_nothing() {
                    out.panels.push(panel.series.times(0.0));
                    continue;
                }
                out.error += panel.series.tail() * length;
                out.panels.push(panel.series);
            }
            continue;
        }
        let far = |(panel, of): (&Panel, &Piecewise)| {
            let greatest =
                panel.values.iter().copied().fold(0.0, |a: f64, x| if x.abs() > a.abs() { x } else { a });
            (greatest.abs() > FAR * of.scale).then_some(greatest)
        };
        if let Some(greatest) = panel.iter().zip(&done).find_map(far).filter(|_| length < NARROW) {
            if sought.is_none_or(|sign| sign * greatest > 0.0) {
                return Err(Undefined::Unbounded(sampler.interval.place(from)));
            }
            panel.into_iter().zip(&mut done).for_each(|(panel, out)| out.panels.push(panel.series));
            continue;
        }
        if is_rounding || done.first().map_or(0, |d| d.panels.len()) + waiting.len() > MOST {
            return Err(Undefined::Unresolved);
        }
        let middle = 0.5 * (from + to);
        sampled.push(sample(sampler, statics, exprs, &nodes, middle, to)?);
        sampled.push(sample(sampler, statics, exprs, &nodes, from, middle)?);
        waiting.extend([(middle, to, halved + 1), (from, middle, halved + 1)]);
    }
    Ok(done)
}

/// The stretches between the breaks, divided where they are long.
fn first_panels(sampler: &Sampler<'_>, breaks: &[f64]) -> Vec<(f64, f64)> {
    let turns = sampler.interval.turns.unwrap_or(1.0).abs().max(0.5);
    let per_turn = match sampler.tolerance {
        wanted if wanted > VERY_COARSE => FEW_PER_TURN[1],
        wanted if wanted > COARSE => FEW_PER_TURN[0],
        _ => PER_TURN,
    };
    let longest = 1.0 / (per_turn * turns).max(sampler.waves().map_or(0, |[waves, _]| waves) as f64);
    let mut panels = Vec::new();
    let ends = breaks.iter().copied().chain([1.0]);
    let mut from = 0.0;
    for to in ends {
        let parts = ((to - from) / longest - 1e-9).ceil().max(1.0);
        let mut part = 0.0;
        while part < parts {
            let at = |i: f64| if i == parts { to } else { from + (to - from) * i / parts };
            panels.push((at(part), at(part + 1.0)));
            part += 1.0;
        }
        from = to;
    }
    panels
}

/// A function over a stretch.
struct Panel {
    values: [f64; NODES],
    /// The greatest of its sizes.
    size: f64,
    series: Series,
}

type Sampled = Vec<Panel>;

fn sample(
    sampler: &mut Sampler<'_>,
    statics: &WholeCycle,
    exprs: &[&Expr],
    nodes: &Nodes,
    from: f64,
    to: f64,
) -> Result<Sampled, Undefined> {
    let mut values = vec![([0.0; NODES], 0.0_f64); exprs.len()];
    for node in 0..NODES {
        let s = nodes.at(from, to, node);
        for ((values, size), expr) in values.iter_mut().zip(exprs) {
            let found = sampler.sample(statics, s, expr)?;
            values[node] = found.value;
            *size = size.max(found.size);
        }
    }
    let panel = |(values, size)| Panel { series: nodes.series(from, to, &values), values, size };
    Ok(values.into_iter().map(panel).collect())
}
