//! What deserves a warning, collected over all positions and said once.

use super::consistent_warnings::ConsistentNotes;
use super::error::{SolveError, label};
use super::format::{drive_text, four, labels, links, place, short, with_unit};
use super::train_error::TrainError;
use crate::model::{Expr, PairId, Positions, Value};
use crate::position::{DriveValue, Model, Wanted, turns};
use crate::structure::Group;
use crate::units::Dimension;

/// With fewer digits left a warning tells how many: σ = 1e-3 for accelerations, 5e-5 for velocities and forces.
const FEW_DIGITS: f64 = 7.0;
/// Digits that forces of inertia lose beside: 16 ε/σ³.
const GATHERED: f64 = 1.2;

/// More switches are counted, not reported.
const MOST_SWITCHES: usize = 1000;
/// The same for gaps.
const MOST_GAPS: usize = 100;

/// Drive values between which a sweep does not close; absent at its ends.
#[derive(Debug, Default)]
struct Gap {
    from: Option<Vec<DriveValue>>,
    to: Option<Vec<DriveValue>>,
}

/// A contact that pulls: where it pulls most, and how often.
#[derive(Debug)]
struct Pull {
    pair: PairId,
    normal: f64,
    place: String,
    poses: usize,
}

/// How many positions of the sweep there are, and how many of them do not close.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Closing {
    pub swept: usize,
    pub open: usize,
    /// One of them can be assembled in several ways.
    pub ambiguous: bool,
}

/// Warnings of a run.
#[derive(Debug, Default)]
pub(crate) struct Notes {
    switches: Vec<SolveError>,
    /// Switches that are not kept.
    more_switches: usize,
    gaps: Vec<Gap>,
    /// Gaps that are not kept.
    more_gaps: usize,
    in_gap: bool,
    /// The fewest digits left, with their warning.
    fewest: Option<(f64, SolveError)>,
    pulls: Vec<Pull>,
    /// Ropes that push, with their pull in place of the normal force.
    slack: Vec<Pull>,
    locking: Option<(TrainError, usize)>,
    /// Several states of the forces.
    pub(crate) consistent: ConsistentNotes,
    /// The greatest figure h beyond 1/2, with its warning, and how many positions have one.
    uncertified: Option<(f64, SolveError)>,
    uncertified_poses: usize,
}

impl Notes {
    pub(crate) const fn in_gap(&self) -> bool {
        self.in_gap
    }

    pub(crate) fn gap_begins(&mut self, from: Option<Vec<DriveValue>>) {
        self.in_gap = true;
        if self.gaps.len() < MOST_GAPS {
            self.gaps.push(Gap { from, to: None });
        } else {
            self.more_gaps += 1;
        }
    }

    pub(crate) fn gap_ends(&mut self, to: Vec<DriveValue>) {
        self.in_gap = false;
        if let Some(gap) = self.gaps.last_mut().filter(|_| self.more_gaps == 0) {
            gap.to = Some(to);
        }
    }

    pub(crate) fn switched(
        &mut self,
        model: &Model<'_>,
        (group, at): (usize, &[DriveValue]),
        from: &str,
        to: &str,
    ) {
        if self.switches.len() == MOST_SWITCHES {
            self.more_switches += 1;
            return;
        }
        let group = &model.structure.motion[group];
        self.switches.push(SolveError::BranchSwitch {
            links: links(model, group),
            from: from.to_owned(),
            to: to.to_owned(),
            near: drive_text(model, &rounded(model, at, 1.0)),
            labels: labels(model, group, "this group"),
        });
    }

    /// The condition figure σ of a group; the error of what is asked of it grows as ε over this power of σ.
    pub(crate) fn condition(
        &mut self,
        model: &Model<'_>,
        group: &Group,
        (condition, what, power): (f64, &'static str, u8),
        pose: &Wanted,
    ) {
        // forces of inertia add up what the accelerations of several links lose
        let gathered = if power == 3 && model.plan.effects.inertia { GATHERED } else { 0.0 };
        let left = f64::from(power) * condition.max(f64::MIN_POSITIVE).log10() - f64::EPSILON.log10();
        let digits = left - gathered;
        // what is no number is reported by itself; positions near a double root keep half their digits
        if condition.is_nan()
            || what == "positions"
            || digits >= FEW_DIGITS
            || self.fewest.as_ref().is_some_and(|f| f.0 <= digits)
        {
            return;
        }
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // between 0 and 7
        let warning = SolveError::IllConditioned {
            pose: place(model, pose),
            links: links(model, group),
            condition,
            digits: digits.clamp(0.0, FEW_DIGITS) as u32,
            what,
            labels: labels(model, group, "near a dead position"),
        };
        self.fewest = Some((digits, warning));
    }

    /// The figure h of Newton and Kantorovich of a group that was solved by iteration.
    pub(crate) fn certificate(
        &mut self,
        model: &Model<'_>,
        group: &Group,
        h: f64,
        sigma: f64,
        pose: &Wanted,
    ) {
        if h <= 0.5 {
            return;
        }
        self.uncertified_poses += 1;
        if self.uncertified.as_ref().is_some_and(|worst| h <= worst.0) {
            return;
        }
        let warning = SolveError::NotCertified {
            pose: place(model, pose),
            links: links(model, group),
            figure: format!("{h:.1e}, with the condition figure σ = {sigma:.1e}"),
            more: String::new(),
            labels: labels(model, group, "this group"),
        };
        self.uncertified = Some((h, warning));
    }

    pub(crate) fn pulls(&mut self, model: &Model<'_>, pair: PairId, normal: f64, pose: &Wanted) {
        let here = || place(model, pose);
        match self.pulls.iter_mut().find(|p| p.pair == pair) {
            Some(pull) => {
                pull.poses += 1;
                if normal < pull.normal {
                    (pull.normal, pull.place) = (normal, here());
                }
            }
            None => self.pulls.push(Pull { pair, normal, place: here(), poses: 1 }),
        }
    }

    pub(crate) fn pushes(&mut self, model: &Model<'_>, pair: PairId, normal: f64, pose: &Wanted) {
        match self.slack.iter_mut().find(|p| p.pair == pair) {
            Some(pull) => {
                pull.poses += 1;
                if normal < pull.normal {
                    (pull.normal, pull.place) = (normal, place(model, pose));
                }
            }
            None => self.slack.push(Pull { pair, normal, place: place(model, pose), poses: 1 }),
        }
    }

    /// The load cannot drive the mechanism.
    pub(crate) fn self_locking(&mut self, model: &Model<'_>, pose: &Wanted) {
        if let Some((_, more)) = &mut self.locking {
            *more += 1;
            return;
        }
        let lossy =
            model.plan.laws.iter().filter_map(|l| Some((model.mechanism.pair(l.pair), l.efficiency?)));
        let lossy: Vec<_> = lossy.collect();
        let labels = lossy.iter().map(|(p, _)| label("loses more than comes back", p.span)).collect();
        let back = lossy.iter().map(|(p, [there, back])| {
            if there == back {
                format!("`{}` lets {} of the power through", p.name, four(*back))
            } else {
                format!(
                    "`{}` lets 2 − 1/{} = {} of the power through backwards",
                    p.name,
                    four(*there),
                    four(*back)
                )
            }
        });
        let back = back.collect::<Vec<_>>().join(", ");
        let help = format!(
            "{back}; where that comes to less than 0, the unknown effort has to drive in this sense too"
        );
        let pose = place(model, pose);
        self.locking = Some((TrainError::SelfLocking { pose, more: String::new(), help, labels }, 0));
    }

    /// The warnings, and how many there are more.
    pub(crate) fn into_warnings(self, model: &Model<'_>, closing: Closing) -> (Vec<SolveError>, usize) {
        let mut warnings = self.switches;
        if let Some((mut error, count)) = self.locking {
            if let TrainError::SelfLocking { more, .. } = &mut error {
                *more = and_at(count);
            }
            warnings.push(error.into());
        }
        warnings.extend(self.consistent.into_warning());
        for pull in self.slack {
            let pair = model.mechanism.pair(pull.pair);
            let (name, span) = (pair.name.clone(), pair.span.into());
            let (tension, pose, more) =
                (with_unit(model, pull.normal, Dimension::FORCE), pull.place, and_at(pull.poses - 1));
            warnings.push(TrainError::RopePushes { name, pose, more, tension, span }.into());
        }
        for pull in self.pulls {
            let pair = model.mechanism.pair(pull.pair);
            let more = and_at(pull.poses - 1);
            let (normal, pose) = (with_unit(model, pull.normal, Dimension::FORCE), pull.place);
            let name = pair.name.clone();
            warnings.push(SolveError::ContactPulls { name, pose, normal, more, span: pair.span.into() });
        }
        warnings.extend(partial_sweep(model, closing, &self.gaps, self.more_gaps));
        warnings.extend(self.fewest.map(|f| f.1));
        if let Some((_, mut warning)) = self.uncertified {
            if let SolveError::NotCertified { more, .. } = &mut warning {
                *more = and_at(self.uncertified_poses.saturating_sub(1));
            }
            warnings.push(warning);
        }
        (warnings, self.more_switches)
    }
}

/// `, and at 3 other poses`
fn and_at(more: usize) -> String {
    match more {
        0 => String::new(),
        1 => ", and at 1 other pose".to_owned(),
        n => format!(", and at {n} other poses"),
    }
}

/// Angles rounded to a part of a degree.
fn rounded(model: &Model<'_>, values: &[DriveValue], per_degree: f64) -> Vec<DriveValue> {
    let drives = model.mechanism.drives.iter().zip(values);
    drives
        .map(|(drive, value)| match value {
            DriveValue::Scalar(x) if turns(model, drive) => {
                DriveValue::Scalar(((x.to_degrees() * per_degree).round() / per_degree).to_radians())
            }
            other => *other,
        })
        .collect()
}

/// A warning that tells over which ranges a sweep does not close.
fn partial_sweep(model: &Model<'_>, closing: Closing, gaps: &[Gap], more: usize) -> Option<SolveError> {
    // where the assembly is not chosen yet, nothing is known of what closes
    if gaps.is_empty() || closing.ambiguous {
        return None;
    }
    let Closing { swept: total, open, .. } = closing;
    let closed = total - open;
    let text = |values: &[DriveValue]| drive_text(model, &rounded(model, values, 100.0));
    let ranges = gaps.iter().map(|gap| match (&gap.from, &gap.to) {
        (Some(from), Some(to)) => format!("from {} to {}", text(from), text(to)),
        (Some(from), None) => format!("beyond {}", text(from)),
        (None, Some(to)) => format!("before {}", text(to)),
        (None, None) => "anywhere".to_owned(),
    });
    let drive = model.mechanism.drives.first()?;
    let (positions, listed) = if closed == total {
        let positions = "the positions close, but not the way between them".to_owned();
        (positions, "the side of every group is kept across the gap")
    } else {
        (
            format!("{closed} of {total} positions close"),
            "positions that do not close are left out of the answers",
        )
    };
    let help = match closing_range(model, gaps) {
        Some(line) => format!("{listed}; to sweep over the part that closes write\n  {line}"),
        None => listed.to_owned(),
    };
    let mut ranges = ranges.collect::<Vec<_>>().join(", nor ");
    if more > 0 {
        ranges += &format!(", nor in {more} other ranges");
    }
    Some(SolveError::PartialSweep { positions, ranges, help, span: drive.span.into() })
}

/// The sweep of a single drive that turns, cut to what closes.
fn closing_range(model: &Model<'_>, gaps: &[Gap]) -> Option<String> {
    let ([drive], [gap]) = (model.mechanism.drives.as_slice(), gaps) else { return None };
    let Positions::Range { from, to, steps } = &drive.positions else { return None };
    let (Expr::Constant(Value::Scalar(first)), Expr::Constant(Value::Scalar(last))) = (from, to) else {
        return None;
    };
    if !turns(model, drive) {
        return None;
    }
    let degrees = |values: &Option<Vec<DriveValue>>| match values.as_deref() {
        Some([DriveValue::Scalar(x)]) => Some(x.to_degrees()),
        _ => None,
    };
    let (first, last) = (first.to_degrees(), last.to_degrees());
    let way = (last - first).signum();
    // rounded to the side that closes
    let inwards = |x: f64, sense: f64| (x * 100.0 * sense * way).floor() / 100.0 * sense * way;
    let (begin, end) = match (degrees(&gap.from), degrees(&gap.to)) {
        (Some(a), Some(b)) if ((last - first).abs() - 360.0).abs() < 1e-9 => {
            (inwards(b - 360.0 * way, -1.0), inwards(a, 1.0))
        }
        (Some(a), _) => (first, inwards(a, 1.0)),
        (None, Some(b)) => (inwards(b, -1.0), last),
        (None, None) => return None,
    };
    Some(format!("drive {} = {} deg .. {} deg in {steps} steps", drive.name, short(begin), short(end)))
}
