//! `equilibrium bar near 60 deg`: the positions in which drives need no effort, Q(q) = 0 by the principle of virtual work.
//!
//! They are found on the mechanism at rest before anything else is solved, and put into its drives: what follows is solved as any other
//! position. One coordinate is looked through for changes of the sign of Q, and each is narrowed down to the last digit. Several
//! coordinates follow by Newton's method from the values near them, as does one coordinate from position to position of a sweep.

use super::vibration::Small;
use assur_model::model::{
    Drive, DriveId, DriveTarget, Equilibrium, Expr, Find, FindKind, Mechanism, PairKind, Positions,
    QuantityId, Query, Sought, SoughtWay, Value,
};
use assur_model::structure::{self, Structure};
use assur_position::plan::{self, Plan};
use assur_position::position::{DriveValue, extent};
use assur_solve::message;
use assur_solve::solve::{self, Model};
use assur_text::diagnostic::Diagnosis;
use assur_text::source::Span;
use assur_text::units::{Dimension, significant};
use nalgebra::{DMatrix, DVector};
use std::f64::consts::{PI, TAU};
use std::sync::Arc;

/// Positions that are looked at for a change of sign.
const SAMPLES: usize = 721;
/// Where samples lie between equal steps: symmetric positions are often equilibria, and these shall lie between samples.
const OFFSET: f64 = 0.381_966;
/// Way of a coordinate that slides, in sizes of the mechanism.
const REACH: f64 = 3.0;
/// Steps that narrow a change of sign.
const NARROWING: usize = 120;
/// An effort below this part of the greatest is none; a change of sign above it is a jump.
const NOTHING: f64 = 1e-6;
/// More equilibria than these are none: the effort is rounding everywhere.
const MOST: usize = 24;
/// Steps of Newton's method.
const STEPS: usize = 60;
/// Differences for derivatives, rad or sizes of the mechanism.
const DIFFERENCE: f64 = 1e-4;
/// Steps below this are rounding.
const ROUNDING: f64 = 1e-13;
/// What a matrix of stiffness may differ from its transpose by.
const SYMMETRIC: f64 = 1e-5;

/// Puts the positions of equilibrium into the drives that seek them.
///
/// # Errors
/// None is found, or several of which the file chooses none.
pub fn settle(mechanism: &mut Mechanism) -> Result<(), Diagnosis> {
    let Some(mut search) = Search::of(mechanism) else { return Ok(()) };
    let ways = search.ways();
    let mut found: Vec<Equilibrium> = Vec::new();
    for others in ways {
        let next = match found.as_slice() {
            [] => search.first(&others)?,
            [.., last] => {
                let from = search.of_sought(&last.at);
                search.followed(&others, &from)?
            }
        };
        found.push(next);
    }
    for (i, drive) in mechanism.drives.iter_mut().enumerate().filter(|(_, drive)| drive.sought.is_some()) {
        let values: Vec<f64> = found.iter().map(|equilibrium| equilibrium.at[i]).collect();
        drive.positions = match values.as_slice() {
            [one] => Positions::List(vec![Expr::number(*one)]),
            _ => Positions::Numbers(Arc::new(values)),
        };
    }
    mechanism.equilibria = found;
    Ok(())
}

/// The mechanism at rest, of which nothing but the efforts of the drives sought is asked.
pub(super) struct Search {
    pub(super) mechanism: Mechanism,
    pub(super) structure: Structure,
    pub(super) plan: Plan,
    /// The drives whose positions are sought.
    pub(super) sought: Vec<usize>,
    /// Size of a step of each: 1 rad, or the size of the mechanism.
    pub(super) sizes: Vec<f64>,
    /// What is asked at a position.
    pub(super) asked: Vec<Query>,
    /// Small vibrations are asked for.
    pub(super) vibrates: bool,
}

/// An equilibrium of one coordinate.
#[derive(Clone, Copy)]
struct Root {
    at: f64,
    stable: bool,
}

/// Positions of one coordinate with the efforts there.
type Samples = Vec<(f64, Option<f64>)>;

impl Search {
    fn of(mechanism: &Mechanism) -> Option<Self> {
        let sought: Vec<usize> =
            (0..mechanism.drives.len()).filter(|i| mechanism.drives[*i].sought.is_some()).collect();
        if sought.is_empty() {
            return None;
        }
        let vibrates = mechanism.vibrates;
        let mechanism = at_rest(mechanism);
        // what is wrong with the structure has been reported
        let (structure, _) = structure::structure(&mechanism).ok()?;
        let plan = plan::plan(&mechanism, &structure);
        let size = extent(&Model { mechanism: &mechanism, structure: &structure, plan: &plan });
        let sizes = sought.iter().map(|i| if turns(&mechanism, &mechanism.drives[*i]) { 1.0 } else { size });
        let sizes = sizes.collect();
        let efforts: Vec<Query> = sought.iter().map(|i| Query::Effort(DriveId::at(*i))).collect();
        let mut search = Self { mechanism, structure, plan, sought, sizes, asked: Vec::new(), vibrates };
        search.ask(&efforts);
        Some(search)
    }

    /// Asks these questions alone.
    pub(super) fn ask(&mut self, asked: &[Query]) {
        let find = |query: &Query| {
            let display = assur_model::model::Display::default();
            let kind = FindKind::Value { expr: Expr::Query(*query), display, poseless: false };
            Find { name: String::new(), span: Span::default(), kind }
        };
        self.mechanism.finds = asked.iter().map(find).collect();
        self.plan = plan::plan(&self.mechanism, &self.structure);
        self.asked = asked.to_vec();
    }

    /// The values of all drives at the positions of the sweep; those of drives sought have no meaning.
    fn ways(&mut self) -> Vec<Vec<DriveValue>> {
        let model = Model { mechanism: &self.mechanism, structure: &self.structure, plan: &self.plan };
        let only = self.mechanism.drives.len() == self.sought.len();
        let poses = if only { Vec::new() } else { solve::solve(&model).map_or(Vec::new(), |all| all.poses) };
        if poses.is_empty() {
            return vec![vec![DriveValue::Scalar(0.0); self.mechanism.drives.len()]];
        }
        poses.into_iter().map(|pose| pose.drives).collect()
    }

    fn of_sought(&self, all: &[f64]) -> Vec<f64> {
        self.sought.iter().map(|i| all[*i]).collect()
    }

    /// What is asked at some values of the drives sought, where these positions exist: their efforts.
    pub(super) fn efforts(&mut self, others: &[DriveValue], at: &[Vec<f64>]) -> Vec<Option<Vec<f64>>> {
        for (i, (drive, value)) in self.mechanism.drives.iter_mut().zip(others).enumerate() {
            drive.positions = match (self.sought.iter().position(|s| *s == i), value) {
                (Some(k), _) => Positions::Numbers(Arc::new(at.iter().map(|values| values[k]).collect())),
                (None, DriveValue::Scalar(x)) => Positions::List(vec![Expr::number(*x)]),
                (None, DriveValue::Point(p)) => Positions::List(vec![Expr::Constant(Value::Vector(*p))]),
                (None, DriveValue::None) => Positions::None,
            };
        }
        let model = Model { mechanism: &self.mechanism, structure: &self.structure, plan: &self.plan };
        let Ok(solution) = solve::solve(&model) else { return vec![None; at.len()] };
        let effort = |pose: &solve::Pose| {
            let solved = pose.outcome.as_ref().ok()?;
            let view = solution.view(&model, solved);
            let efforts = self.asked.iter().map(|query| view.scalar(&Expr::Query(*query)));
            Some(efforts.collect::<Vec<f64>>()).filter(|efforts| efforts.iter().all(|x| x.is_finite()))
        };
        solution.poses.iter().take(at.len()).map(effort).collect()
    }

    fn effort(&mut self, others: &[DriveValue], at: f64) -> Option<f64> {
        self.efforts(others, &[vec![at]]).pop()?.and_then(|found| found.first().copied())
    }

    /// The equilibrium at the first position of the sweep.
    fn first(&mut self, others: &[DriveValue]) -> Result<Equilibrium, Diagnosis> {
        let drive = self.drive(0);
        let Some(sought) = drive.sought.filter(|_| self.sought.len() == 1) else {
            let near = self.sought.iter().map(|i| match self.mechanism.drives[*i].sought {
                Some(Sought::Near(x) | Sought::Between(x, _)) => x,
                _ => 0.0,
            });
            let near: Vec<f64> = near.collect();
            return self.followed(others, &near);
        };
        let (turning, size) = (turns(&self.mechanism, drive), self.sizes[0]);
        let half = if turning { PI } else { REACH * size };
        let samples = match sought {
            Sought::Near(x) => self.sampled(others, (x - half, x + half), turning),
            Sought::Between(from, to) => self.sampled(others, (from, to), false),
            Sought::Anywhere => self.sampled(others, (-half, half), turning),
        };
        let mut roots = self.roots(others, &samples);
        let mut efforts = samples.iter().filter_map(|(_, effort)| *effort).peekable();
        let nothing = efforts.peek().is_some() && efforts.all(|x| x == 0.0);
        if nothing || roots.len() > MOST {
            return Err(self.indifferent());
        }
        let equilibria = roots.iter().map(|root| (root.at, root.stable)).collect();
        if let Sought::Near(x) = sought {
            roots.sort_by(|a, b| (a.at - x).abs().total_cmp(&(b.at - x).abs()));
            roots.truncate(1);
        }
        match roots.as_slice() {
            [] if samples.iter().all(|(_, effort)| effort.is_none()) => {
                Err(self.without_position(others, sought))
            }
            [] => Err(self.none(&samples)),
            [root] => {
                let way = SoughtWay { drive: self.sought[0], efforts: samples, equilibria };
                let found = self.equilibrium(others, &[root.at], Some(root.stable));
                Ok(Equilibrium { sought: Some(Arc::new(way)), ..found })
            }
            all => Err(self.several(all)),
        }
    }

    fn drive(&self, k: usize) -> &Drive {
        &self.mechanism.drives[self.sought[k]]
    }

    fn equilibrium(&mut self, others: &[DriveValue], at: &[f64], stable: Option<bool>) -> Equilibrium {
        let small = if self.vibrates || stable.is_none() { self.small(others, at) } else { None };
        let stable = stable.unwrap_or_else(|| small.as_ref().is_some_and(Small::is_stable));
        let modes = small.filter(|_| self.vibrates).map(|small| small.modes()).unwrap_or_default();
        let mut all: Vec<f64> =
            others.iter().map(|value| if let DriveValue::Scalar(x) = value { *x } else { 0.0 }).collect();
        self.sought.iter().zip(at).for_each(|(i, x)| all[*i] = *x);
        Equilibrium { at: all, stable, modes, sought: None }
    }

    /// The efforts at many positions, followed from their middle to both ends: there the mechanism is assembled as the file says.
    fn sampled(&mut self, others: &[DriveValue], (from, to): (f64, f64), turning: bool) -> Samples {
        let half = (SAMPLES - 1) / 2;
        let step = (to - from) / (2 * half) as f64;
        let middle = 0.5 * (from + to);
        let mut side = |sign: f64| {
            let mut at: Vec<f64> = (0..=half).map(|i| middle + sign * step * i as f64).collect();
            // beside the positions that are often equilibria, but at the ends of a range
            let moved = if turning { half + 1 } else { half };
            at[..moved].iter_mut().for_each(|x| *x += OFFSET * step);
            let values: Vec<Vec<f64>> = at.iter().map(|x| vec![*x]).collect();
            let efforts = self.efforts(others, &values).into_iter();
            let efforts = efforts.map(|efforts| efforts.and_then(|e| e.first().copied()));
            at.into_iter().zip(efforts).collect::<Samples>()
        };
        let (up, mut all) = (side(1.0), side(-1.0));
        all.reverse();
        all.extend(up.into_iter().skip(1));
        all
    }

    /// Where the effort changes its sign.
    fn roots(&mut self, others: &[DriveValue], samples: &Samples) -> Vec<Root> {
        let greatest = samples.iter().filter_map(|(_, effort)| *effort).fold(0.0, |m: f64, x| m.max(x.abs()));
        let mut roots: Vec<Root> = Vec::new();
        for pair in samples.windows(2) {
            let [(a, Some(at_a)), (b, Some(at_b))] = pair else { continue };
            let begins = roots.is_empty() && *a == samples[0].0 && *at_a == 0.0;
            if begins {
                roots.push(Root { at: *a, stable: *at_b > 0.0 });
            }
            if *at_a == 0.0 || at_a.signum() == at_b.signum() && *at_b != 0.0 {
                continue;
            }
            let Some((at, left)) = self.narrowed(others, (*a, *at_a), (*b, *at_b)) else { continue };
            if left.abs() <= NOTHING * greatest {
                roots.push(Root { at, stable: at_b > at_a });
            }
        }
        // the first and the last position of a turn are one
        if let [first, .., last] = roots.as_slice()
            && (last.at - first.at - TAU).abs() < 1e-9
        {
            roots.pop();
        }
        roots
    }

    /// The change of sign between two positions, and the effort that is left there.
    fn narrowed(&mut self, others: &[DriveValue], a: (f64, f64), b: (f64, f64)) -> Option<(f64, f64)> {
        let (mut a, mut b) = (a, b);
        let mut best = if a.1.abs() < b.1.abs() { a } else { b };
        for i in 0..NARROWING {
            let middle = 0.5 * (a.0 + b.0);
            if best.1 == 0.0 || middle == a.0 || middle == b.0 {
                break;
            }
            // every third step halves: a chord alone may approach from one side
            let chord = (a.0 * b.1 - b.0 * a.1) / (b.1 - a.1);
            let inside = chord > a.0.min(b.0) && chord < a.0.max(b.0);
            let at = if i % 3 == 2 || !inside { middle } else { chord };
            let next = (at, self.effort(others, at)?);
            if next.1.abs() < best.1.abs() {
                best = next;
            }
            if next.1.signum() == a.1.signum() { a = next } else { b = next }
        }
        Some(best)
    }

    /// The equilibrium near some values, by Newton's method.
    fn followed(&mut self, others: &[DriveValue], from: &[f64]) -> Result<Equilibrium, Diagnosis> {
        let n = from.len();
        let mut at = DVector::from_column_slice(from);
        let mut last = f64::INFINITY;
        for _ in 0..STEPS {
            let Some((efforts, stiffness)) = self.derivatives(others, &at) else { break };
            let Some(step) = stiffness.clone().lu().solve(&efforts) else { break };
            let length = (0..n).map(|k| (step[k] / self.sizes[k]).abs()).fold(0.0, f64::max);
            if length <= ROUNDING || (length < 1e-9 && length >= last) {
                return Ok(self.equilibrium(others, at.as_slice(), is_stable(&stiffness)));
            }
            last = length;
            // a step is no longer than a fifth of a radian, or of the size
            at -= step * (0.2 / length).min(1.0);
        }
        let near =
            self.sought.iter().zip(from).map(|(i, x)| self.value(*i, *x)).collect::<Vec<_>>().join(", ");
        let drive = self.drive(0);
        Err(Diagnosis::error("mech::equilibrium::none", format!("no equilibrium is found near {near}"))
            .label(drive.span, "sought here")
            .help("write other values behind `near`, or look for a missing load or spring"))
    }

    /// The efforts at some values, and their derivatives: the stiffness.
    fn derivatives(
        &mut self,
        others: &[DriveValue],
        at: &DVector<f64>,
    ) -> Option<(DVector<f64>, DMatrix<f64>)> {
        let n = at.len();
        let mut points = vec![at.as_slice().to_vec()];
        for k in 0..n {
            for sign in [1.0, -1.0] {
                let mut point = at.as_slice().to_vec();
                point[k] += sign * DIFFERENCE * self.sizes[k];
                points.push(point);
            }
        }
        let efforts = self.efforts(others, &points).into_iter().collect::<Option<Vec<_>>>()?;
        let stiffness = DMatrix::from_fn(n, n, |i, k| {
            (efforts[2 * k + 1][i] - efforts[2 * k + 2][i]) / (2.0 * DIFFERENCE * self.sizes[k])
        });
        Some((DVector::from_vec(efforts.into_iter().next()?), stiffness))
    }

    /// A value of a drive, of an angle in degrees.
    fn value(&self, drive: usize, x: f64) -> String {
        if turns(&self.mechanism, &self.mechanism.drives[drive]) {
            return format!("{} deg", significant(x.to_degrees(), 4));
        }
        let display = self.mechanism.drive_display(self.mechanism.drives[drive].target);
        display.text(Value::Scalar(x), 4)
    }

    /// Why the mechanism has no position where it is sought.
    fn without_position(&mut self, others: &[DriveValue], sought: Sought) -> Diagnosis {
        let at = match sought {
            Sought::Near(x) => x,
            Sought::Between(from, to) => 0.5 * (from + to),
            Sought::Anywhere => 0.0,
        };
        self.efforts(others, &[vec![at]]);
        let model = Model { mechanism: &self.mechanism, structure: &self.structure, plan: &self.plan };
        let failures = match solve::solve(&model) {
            Ok(solution) => solution.poses.into_iter().filter_map(|pose| pose.outcome.err()).collect(),
            Err(failures) => failures,
        };
        let first = message::failures(&model, &failures).next();
        first.unwrap_or_else(|| self.none(&Samples::new()))
    }

    fn none(&self, samples: &Samples) -> Diagnosis {
        let drive = self.drive(0);
        let efforts = || samples.iter().filter_map(|(_, effort)| *effort);
        let (least, most) =
            (efforts().fold(f64::INFINITY, f64::min), efforts().fold(f64::NEG_INFINITY, f64::max));
        let dimension = if turns(&self.mechanism, drive) { Dimension::TORQUE } else { Dimension::FORCE };
        let display = self.mechanism.display_of(dimension);
        let text = |x: f64| display.text(Value::Scalar(x), 4);
        let why = if most < least {
            "the mechanism has no position there".to_owned()
        } else {
            format!("the effort is never zero: between {} and {}", text(least), text(most))
        };
        Diagnosis::error("mech::equilibrium::none", format!("`{}` has no equilibrium: {why}", drive.name))
            .label(drive.span, "sought here")
            .help(format!(
                "look elsewhere, `equilibrium {} near …`, or look for a missing load or spring",
                drive.name
            ))
    }

    fn several(&self, roots: &[Root]) -> Diagnosis {
        let drive = self.drive(0);
        let line = |root: &Root| {
            let word = if root.stable { "stable" } else { "unstable" };
            format!("\n  equilibrium {} near {}   // {word}", drive.name, self.value(self.sought[0], root.at))
        };
        let lines: String = roots.iter().map(line).collect();
        Diagnosis::error(
            "mech::equilibrium::several",
            format!("`{}` has {} positions of equilibrium", drive.name, roots.len()),
        )
        .label(drive.span, "which one is not stated")
        .help(format!("write one of{lines}"))
    }

    fn indifferent(&self) -> Diagnosis {
        let drive = self.drive(0);
        let message =
            format!("`{}` is in equilibrium everywhere: its effort is zero at all positions", drive.name);
        Diagnosis::error("mech::equilibrium::several", message)
            .label(drive.span, "sought here")
            .help(format!("write a position: `drive {} = …`", drive.name))
    }
}

/// Whether the stiffness brings the mechanism back: it is positive definite. `None` where the loads have no potential, and the
/// masses decide too.
fn is_stable(stiffness: &DMatrix<f64>) -> Option<bool> {
    let transposed = stiffness.transpose();
    let symmetric = (stiffness - &transposed).amax() <= SYMMETRIC * stiffness.amax();
    symmetric.then(|| ((stiffness + transposed) * 0.5).cholesky().is_some())
}

fn turns(mechanism: &Mechanism, drive: &Drive) -> bool {
    match drive.target {
        DriveTarget::Link(_) => true,
        DriveTarget::Pair(pair) => matches!(mechanism.pair(pair).kind, PairKind::Revolute(_)),
        DriveTarget::Point(..) | DriveTarget::Place(..) => false,
    }
}

/// The mechanism without speeds and questions.
pub(super) fn at_rest(mechanism: &Mechanism) -> Mechanism {
    let mut mechanism = mechanism.clone();
    for drive in &mut mechanism.drives {
        (drive.free, drive.speed, drive.acceleration, drive.sense) = (false, None, None, None);
    }
    mechanism.simulation = None;
    mechanism.events.clear();
    mechanism.poses.clear();
    mechanism.expects.clear();
    mechanism.cycles.clear();
    mechanism.flywheels.clear();
    mechanism.criticals.clear();
    mechanism.works.clear();
    mechanism.powers = None;
    let needed = of_loads(&mechanism);
    for (i, quantity) in mechanism.quantities.iter_mut().enumerate() {
        if !needed.contains(&QuantityId::at(i)) {
            quantity.expr = Expr::number(0.0);
        }
    }
    mechanism.finds.clear();
    mechanism
}

/// The quantities of the file that loads depend on.
fn of_loads(mechanism: &Mechanism) -> Vec<QuantityId> {
    let mut needed: Vec<QuantityId> = Vec::new();
    let mut exprs: Vec<Expr> = mechanism.loads.iter().flat_map(|load| load.expressions().cloned()).collect();
    while let Some(expr) = exprs.pop() {
        expr.parts(&mut |part| {
            if let Expr::Quantity(id) = part
                && !needed.contains(id)
            {
                needed.push(*id);
                exprs.extend(mechanism.quantities.get(id.index()).map(|quantity| quantity.expr.clone()));
            }
        });
    }
    needed
}
