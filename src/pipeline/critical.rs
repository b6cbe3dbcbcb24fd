//! `critical(al)`: the value of a `given` at which locking begins.
//!
//! The file is checked again with other values of the `given`, and its first pose solved. From the file's value the search
//! goes outwards to both sides in growing steps until the verdict changes, and bisects that step to the last digit. The verdict changes
//! too where the ideal power changes its sign: friction is then all that has to be overcome, so the mechanism locks on one side. A side
//! ends where the file has an error or no pose, or where the ideal power changes its sign and nothing locks.

use super::compile::Origin;
use assur_check as check;
use assur_check::Overrides;
use assur_model::model::{Display, Expr, Find, FindKind, Mechanism, Positions, Query, Value};
use assur_model::structure;
use assur_position::plan;
use assur_solve::solve::{self, Model, Progress};
use assur_syntax::document::Document;
use assur_text::source::Span;

/// First step, relative to the value.
const FIRST: f64 = 1e-2;
/// First step where the value is zero, SI.
const FIRST_FROM_ZERO: f64 = 1e-3;
/// Growth of the steps.
const GROWTH: f64 = 1.25;
/// Steps to each side: they reach a hundred times the value.
const STEPS: i32 = 42;
/// Halvings down to the last digit.
const HALVINGS: usize = 100;
/// Halvings towards the end of a side.
const TO_THE_END: usize = 40;

/// The values of all givens whose critical value is asked for, SI; NaN where locking neither begins nor ends, or where `watch` ends
/// the search.
#[must_use]
pub fn criticals(model: &Model<'_>, origin: &Origin, watch: Option<&Progress<'_>>) -> Vec<f64> {
    let (document, overrides) = (&*origin.document, &origin.overrides);
    let names = &model.mechanism.criticals;
    let search = |name| Search { document, overrides, name, watch }.critical(model.mechanism);
    names.iter().map(|name| search(name)).collect()
}

/// What a value of the given makes of the first pose.
#[derive(Clone, Copy, PartialEq)]
struct Verdict {
    locked: bool,
    drives: bool,
}

struct Search<'a> {
    document: &'a Document,
    overrides: &'a Overrides,
    name: &'a str,
    watch: Option<&'a Progress<'a>>,
}

impl Search<'_> {
    fn critical(&self, mechanism: &Mechanism) -> f64 {
        let here = mechanism.values.iter().find(|v| v.name == self.name).map(|v| v.value);
        let Some(Value::Scalar(here)) = here else { return f64::NAN };
        let Some(verdict) = self.verdict(here) else { return f64::NAN };
        let first = if here == 0.0 { FIRST_FROM_ZERO } else { FIRST * here.abs() };
        let mut sides = [Some(here), Some(here)];
        let mut turns: Option<f64> = None;
        for step in 0..STEPS {
            let reach = first * libm::pow(GROWTH, f64::from(step));
            let mut found: Option<f64> = None;
            for (side, sign) in sides.iter_mut().zip([1.0, -1.0]) {
                let Some(from) = *side else { continue };
                let to = here + sign * reach;
                let there = self.verdict(to);
                if there == Some(verdict) {
                    *side = Some(to);
                    continue;
                }
                *side = None;
                let change =
                    if there.is_some() { Some((from, to)) } else { self.before_the_end(from, to, verdict) };
                let Some((at, turned)) = change.and_then(|(from, to)| self.bisected(from, to, verdict))
                else {
                    continue;
                };
                // from where it moves, locking under a load that resists comes first
                let found = if turned && !verdict.locked { &mut turns } else { &mut found };
                if found.is_none_or(|other| (at - here).abs() < (other - here).abs()) {
                    *found = Some(at);
                }
            }
            if let Some(at) = found {
                return at;
            }
        }
        turns.unwrap_or(f64::NAN)
    }

    /// The side ends somewhere in this step: the part before its end where the verdict changes, if any.
    fn before_the_end(&self, mut from: f64, mut to: f64, verdict: Verdict) -> Option<(f64, f64)> {
        for _ in 0..TO_THE_END {
            let middle = 0.5 * (from + to);
            match self.verdict(middle) {
                Some(there) if there == verdict => from = middle,
                Some(_) => return Some((from, middle)),
                None => to = middle,
            }
        }
        None
    }

    /// Where the verdict changes between two values, if locking does just behind it, and whether the ideal power changes its sign.
    fn bisected(&self, mut from: f64, mut to: f64, verdict: Verdict) -> Option<(f64, bool)> {
        let unlike = self.verdict(to)?;
        let is_like = |there: Verdict| match unlike.locked == verdict.locked {
            true => there.drives == verdict.drives,
            false => there.locked == verdict.locked,
        };
        for _ in 0..HALVINGS {
            let middle = 0.5 * (from + to);
            if middle == from || middle == to {
                break;
            }
            if self.verdict(middle).is_some_and(is_like) {
                from = middle;
            } else {
                to = middle;
            }
        }
        let behind = self.verdict(to)?;
        (behind.locked != verdict.locked).then_some((0.5 * (from + to), behind.drives != verdict.drives))
    }

    /// The first pose with this value of the given.
    fn verdict(&self, value: f64) -> Option<Verdict> {
        if self.watch.is_some_and(|goes_on| !goes_on(0.0, 0.0)) {
            return None;
        }
        let (mechanism, _) = check::check_at(self.document, self.overrides, self.name, value);
        let mechanism = first_pose_alone(mechanism?);
        let (structure, _) = structure::structure(&mechanism).ok()?;
        let plan = plan::plan(&mechanism, &structure);
        let model = Model { mechanism: &mechanism, structure: &structure, plan: &plan };
        let solution = solve::solve(&model).ok()?;
        let solved = solution.poses.first()?.outcome.as_ref().ok()?;
        let view = solution.view(&model, solved);
        let (ideal, efficiency) = (view.without_friction().power_of_efforts(), view.efficiency());
        (!efficiency.is_nan()).then_some(Verdict {
            locked: efficiency <= 0.0,
            drives: ideal > 0.0 && !view.overcomes_friction_alone(),
        })
    }
}

/// The mechanism at its first pose, of which nothing but the efficiency is asked.
fn first_pose_alone(mut mechanism: Mechanism) -> Mechanism {
    for drive in &mut mechanism.drives {
        drive.positions = match &drive.positions {
            Positions::None => Positions::None,
            Positions::List(list) => Positions::List(list.iter().take(1).cloned().collect()),
            Positions::Numbers(list) => {
                Positions::List(list.iter().take(1).map(|x| Expr::number(*x)).collect())
            }
            Positions::Range { from, .. } => Positions::List(vec![from.clone()]),
        };
    }
    mechanism.poses.clear();
    mechanism.expects.clear();
    mechanism.cycles.clear();
    mechanism.flywheels.clear();
    let kind = FindKind::Value {
        expr: Expr::Query(Query::Efficiency),
        display: Display::default(),
        poseless: false,
    };
    mechanism.finds = vec![Find { name: String::new(), span: Span::default(), kind }];
    mechanism
}
