//! Which positions are asked for: sweeps, named poses, and those an `expect … at` adds.

use super::refusal::Refusal;
use crate::answer::{Swept, WholeCycle, constant};
use crate::model::{At, Drive, DriveId, Expr, Mechanism, Occasion, Positions, Value};
use crate::position::{DriveValue, Model, PoseOrigin, PoseRequest, turns};
use std::sync::Arc;

/// The ends of a range that differ by no more, rad or m, are one position: one of them is found by solving.
const SAME: f64 = 1e-12;

/// The values of one drive over its sweep.
#[derive(Clone, Debug)]
enum Values {
    List(Vec<DriveValue>),
    Numbers(Arc<Vec<f64>>),
    Range {
        from: f64,
        to: f64,
        steps: usize,
        count: usize,
    },
    /// A range with the events in it; the value after whole turns, where it is left out.
    Eventful(Vec<f64>, Option<f64>),
}

impl Values {
    fn of(model: &Model<'_>, statics: &WholeCycle, drive: &Drive) -> Self {
        match &drive.positions {
            Positions::None => Self::List(vec![DriveValue::None]),
            Positions::List(list) => {
                Self::List(list.iter().map(|e| DriveValue::of(constant(model, statics, e))).collect())
            }
            Positions::Numbers(numbers) => Self::Numbers(Arc::clone(numbers)),
            Positions::Range { from, to, steps } => {
                let scalar = |e| match constant(model, statics, e) {
                    Value::Scalar(x) => x,
                    _ => f64::NAN,
                };
                Self::range(scalar(from), scalar(to), *steps, turns(model, drive))
            }
        }
    }

    /// Equal steps; over whole turns of a drive that turns the last position, the first again, is left out.
    fn range(from: f64, to: f64, steps: usize, turning: bool) -> Self {
        let turns = (to - from) / std::f64::consts::TAU;
        let whole = turning && turns.round() != 0.0 && (turns - turns.round()).abs() < 1e-12;
        Self::Range { from, to, steps, count: if whole { steps } else { steps + 1 } }
    }

    /// A range as far as it goes, with the positions of events.
    fn with_events(&self, statics: &WholeCycle, swept: &Swept) -> Self {
        let value = |i| if let DriveValue::Scalar(x) = self.at(i) { x } else { f64::NAN };
        let mut all: Vec<f64> = (0..self.len()).map(value).collect();
        let sense = (swept.to - swept.from).signum();
        all.retain(|x| sense * (swept.to - x) >= 0.0);
        all.extend(statics.events.iter().flatten());
        all.sort_by(|a, b| (sense * a).total_cmp(&(sense * b)));
        all.dedup();
        let after = match self.after_turns() {
            Some(DriveValue::Scalar(x)) if x == swept.to && all.last() != Some(&x) => Some(x),
            _ => None,
        };
        Self::Eventful(all, after)
    }

    fn len(&self) -> usize {
        match self {
            Self::Eventful(list, _) => list.len(),
            Self::List(list) => list.len(),
            Self::Numbers(list) => list.len(),
            Self::Range { count, .. } => *count,
        }
    }

    /// The value after whole turns, at a position that is left out. `None` for a list of several values.
    fn after_turns(&self) -> Option<DriveValue> {
        match self {
            Self::List(list) if list.len() == 1 => list.first().copied(),
            Self::List(_) | Self::Numbers(_) => None,
            Self::Eventful(_, after) => after.map(DriveValue::Scalar),
            Self::Range { to, steps, count, .. } => (count == steps).then_some(DriveValue::Scalar(*to)),
        }
    }

    /// Where a range begins and ends, if that is one position.
    fn empty(&self) -> Option<f64> {
        match self {
            Self::Range { from, to, .. } if (to - from).abs() <= SAME * from.abs().max(1.0) => Some(*from),
            _ => None,
        }
    }

    /// The value at a position; the last one goes on.
    fn at(&self, index: usize) -> DriveValue {
        match self {
            Self::List(list) => list.get(index).or(list.last()).copied().unwrap_or(DriveValue::None),
            Self::Eventful(list, _) => {
                DriveValue::Scalar(list.get(index).or(list.last()).copied().unwrap_or(f64::NAN))
            }
            Self::Numbers(list) => {
                DriveValue::Scalar(list.get(index).or(list.last()).copied().unwrap_or(f64::NAN))
            }
            #[allow(clippy::cast_precision_loss)] // steps are far below 2^52
            Self::Range { from, to, steps, count } => {
                let i = index.min(count.saturating_sub(1));
                DriveValue::Scalar(from + (to - from) * (i as f64 / *steps as f64))
            }
        }
    }

    /// The values at some positions.
    fn write(&self, first: usize, count: usize, out: &mut Vec<DriveValue>) {
        match self {
            Self::Numbers(list) if first + count <= list.len() => {
                out.extend(list[first..first + count].iter().map(|x| DriveValue::Scalar(*x)));
            }
            _ => out.extend((first..first + count).map(|i| self.at(i))),
        }
    }
}

/// The positions of the sweep, of which none is kept.
#[derive(Clone, Debug)]
pub(crate) struct Sweep {
    drives: Vec<Values>,
    len: usize,
    /// The names of its positions, where some are those of events; else they are numbered.
    names: Vec<String>,
}

impl Sweep {
    pub fn of(model: &Model<'_>, statics: &WholeCycle) -> Self {
        let drives = model.mechanism.drives.iter().map(|d| Values::of(model, statics, d));
        let mut drives: Vec<Values> = drives.collect();
        let mut names = Vec::new();
        if let Some(swept) = &statics.swept {
            let range = &mut drives[swept.drive];
            let own = std::mem::replace(range, range.with_events(statics, swept));
            names = names_beside(&own, range, statics, model.mechanism);
        }
        // `check` has seen to it that all are of one length, or single
        let len = drives.iter().map(Values::len).max().unwrap_or(1);
        Self { drives, len, names }
    }

    /// What a position is called, counted from 0.
    fn name(&self, index: usize) -> String {
        self.names.get(index).cloned().unwrap_or_else(|| (index + 1).to_string())
    }

    pub const fn len(&self) -> usize {
        self.len
    }

    /// The number of steps of a drive that goes through a range.
    #[allow(clippy::cast_precision_loss)] // steps are far below 2^52
    pub fn steps(&self, drive: usize) -> f64 {
        match self.drives[drive] {
            Values::Range { steps, .. } => steps as f64,
            _ => f64::NAN,
        }
    }

    /// A range that turned out to have no length: `check` has seen to those whose ends are numbers.
    pub fn empty_range(&self, mechanism: &Mechanism) -> Option<Refusal> {
        let ranges = mechanism.drives.iter().zip(&self.drives).enumerate();
        let solved = |drive: &Drive| match &drive.positions {
            Positions::Range { from, to, .. } => {
                !matches!((from, to), (Expr::Constant(_), Expr::Constant(_)))
            }
            _ => false,
        };
        let mut found = ranges.filter(|(_, (drive, _))| solved(drive));
        found.find_map(|(i, (_, values))| {
            Some(Refusal::EmptyRange { drive: DriveId::at(i), at: values.empty()? })
        })
    }

    /// The position after whole turns, which is left out since the mechanism is where it began; `None` where none is left out.
    pub fn after_turns(&self) -> Option<PoseRequest> {
        let drives = self.drives.iter().map(Values::after_turns).collect::<Option<Vec<_>>>()?;
        let origin = PoseOrigin::Sweep(self.len);
        let numbered = if self.names.is_empty() { self.len } else { numbers(&self.names) };
        (self.len > 1).then(|| PoseRequest { name: (numbered + 1).to_string(), origin, drives })
    }

    /// The position after whole turns is not the first again.
    pub fn keep_last(&mut self) {
        for drive in &mut self.drives {
            match drive {
                Values::Range { steps, count, .. } => *count = *steps + 1,
                Values::Eventful(list, after) => list.extend(after.take()),
                Values::List(_) | Values::Numbers(_) => {}
            }
        }
        self.len += 1;
        if !self.names.is_empty() {
            self.names.push((numbers(&self.names) + 1).to_string());
        }
    }

    /// Drive values at a position, counted from 0.
    pub fn values(&self, index: usize) -> Vec<DriveValue> {
        self.drives.iter().map(|d| d.at(index)).collect()
    }

    /// Writes the same of some positions one after another.
    pub fn write_values(&self, first: usize, out: &mut Vec<DriveValue>, count: usize) {
        out.clear();
        if let [drive] = self.drives.as_slice() {
            drive.write(first, count, out);
        } else {
            out.extend((first..first + count).flat_map(|i| self.drives.iter().map(move |d| d.at(i))));
        }
    }

    pub fn at(&self, index: usize) -> PoseRequest {
        let origin = PoseOrigin::Sweep(index);
        PoseRequest { name: self.name(index), origin, drives: self.values(index) }
    }
}

/// How many of the names are numbers.
fn numbers(names: &[String]) -> usize {
    names.iter().filter(|name| name.bytes().all(|b| b.is_ascii_digit())).count()
}

/// The names of positions with events among them: those of the range have its numbers, the others are called as their event, and which time
/// it is.
fn names_beside(own: &Values, all: &Values, statics: &WholeCycle, mechanism: &Mechanism) -> Vec<String> {
    let Values::Eventful(list, _) = all else { return Vec::new() };
    let own: Vec<DriveValue> = (0..own.len()).map(|i| own.at(i)).collect();
    let of_event = |x: f64| {
        let mut events = mechanism.events.iter().zip(&statics.events);
        let (event, place) =
            events.find_map(|(event, places)| Some((event, places.iter().position(|at| *at == x)?)))?;
        let name = event.name.as_deref().unwrap_or("end");
        Some(if place == 0 { name.to_owned() } else { format!("{name} {}", place + 1) })
    };
    let mut number = 0;
    let name = |x: &f64| {
        let event = if own.contains(&DriveValue::Scalar(*x)) { None } else { of_event(*x) };
        event.unwrap_or_else(|| {
            number += 1;
            number.to_string()
        })
    };
    list.iter().map(name).collect()
}

/// Positions beside the sweep: drives that are not named keep the value of the sweep's first position.
pub(super) fn beside(model: &Model<'_>, statics: &WholeCycle, first: &PoseRequest) -> Vec<PoseRequest> {
    let at = |list: &[(DriveId, Expr)]| {
        let mut drives = first.drives.clone();
        for (id, expr) in list {
            drives[id.index()] = DriveValue::of(constant(model, statics, expr));
        }
        drives
    };
    let named = model.mechanism.poses.iter().enumerate().map(|(i, pose)| PoseRequest {
        name: pose.name.clone(),
        origin: PoseOrigin::Named(i),
        drives: at(&pose.at),
    });
    let expected = model.mechanism.expects.iter().enumerate().filter_map(|(i, e)| match &e.at {
        Some(At::Drives(list)) => Some(PoseRequest {
            name: format!("expect {}", i + 1),
            origin: PoseOrigin::Expected(i),
            drives: at(list),
        }),
        Some(At::Occasion(occasion)) => {
            let swept = statics.swept.as_ref()?;
            let value = match occasion {
                Occasion::Begin => swept.from,
                Occasion::End => swept.to,
                Occasion::Event(event, which) => statics.event(*event, *which),
            };
            let mut drives = first.drives.clone();
            drives[swept.drive] = DriveValue::Scalar(value);
            let (name, origin) = (format!("expect {}", i + 1), PoseOrigin::Expected(i));
            (!value.is_nan()).then_some(PoseRequest { name, origin, drives })
        }
        _ => None,
    });
    named.chain(expected).collect()
}
