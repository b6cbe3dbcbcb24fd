//! One run of the integrator at one tolerance.

use super::chart::Chart;
use super::compare::{Kinds, Outcome};
use super::coordinates::{Change, Charts};
use super::corners::Corners;
use super::equations::Equations;
use super::event_detector::AT_ONCE;
use super::functions::OverRun;
use super::integration::{Ended, Integration};
use super::pass::{Pass, SHORTER};
use super::records::Records;
use super::report::Holder;
use super::report::{Energy, Method, NotByEnergy};
use super::setup::{Outputs, StartState, allowed, at_rest, scale};
use super::stop::Stops;
use super::trace::{Fraction, Trace};
use super::truncation::TruncationError;
use super::unilateral::UnilateralConditions;
use crate::math::lobatto::Short;
use crate::math::ode::{Counts, Dop853, Energy as ByEnergy, Integrator, Radau, System, Tolerance, Undefined};
use crate::model::DriveTarget;
use crate::position::Model;
use crate::solve::failure::Halt;

/// Steps of a run at least, where something may end a rest.
const AT_REST: f64 = 200.0;

pub(super) struct Run {
    pub method: Method,
    /// Why it does not follow from the energy, where it was looked at.
    pub why: Option<NotByEnergy>,
    pub records: Records,
    pub counts: Counts,
    pub energy: Energy,
    pub worst_condition: (f64, f64),
    /// Instants of every event, s.
    pub events: Vec<Vec<f64>>,
    /// The greatest magnitudes of each kind, where they are measured.
    pub kinds: Kinds,
    /// Functions over the run, each with the greatest magnitude in play.
    pub functions: Vec<OverRun>,
    /// Their series, where they are drawn.
    pub courses: Vec<Vec<Short>>,
    /// What holds at rest, from when to when, s.
    pub held: Vec<(Holder, f64, Option<f64>)>,
    /// What stopped at once, and when, s.
    pub jammed: Vec<(Holder, f64)>,
    /// When other coordinates were taken, s, and which.
    pub changes: Vec<(f64, Vec<DriveTarget>)>,
    /// When change points were passed, s.
    pub crossed: Vec<f64>,
    /// When each stop is closed, and when it opens again, s.
    pub closed: Vec<Vec<(f64, Option<f64>)>>,
    /// The event that ended it.
    pub ended_by: Option<usize>,
    /// Why it ended early, and when, s.
    pub stopped: Option<(f64, Halt)>,
    /// The last instant that was reached, s.
    pub end: f64,
    /// What its steps leave off.
    pub left_off: TruncationError,
    /// By how much rounding may shift an impact, of the length of the run.
    pub shift: f64,
    /// By how much rounding of the energy may shift its instants, s.
    pub late: f64,
    pub tolerance: f64,
    /// The part that its steps are of those of the run before.
    pub part: Option<Fraction>,
    /// What it leaves to a finer run.
    pub trace: Trace,
}

/// Integrates from the first of the instants, s, to the last.
pub(super) fn run(
    begin: &StartState<'_>,
    charts: &mut Charts<'_>,
    pass: Pass<'_>,
    outputs: &Outputs<'_>,
    last: f64,
) -> Run {
    let mut equations = begin.equations();
    equations.goes_until(last);
    let mut y = equations.start();
    if let Err(halt) = start(&mut equations, begin.from, &mut y) {
        return Run::halted(begin.from, halt);
    }
    let at_once = AT_ONCE * (last - begin.from);
    let before = y.clone();
    let mut stops = Stops::new(begin.model.mechanism.stops.len(), at_once);
    if let Err(halt) = stops.begin(&mut equations, begin.from, &mut y) {
        return Run::halted(begin.from, halt);
    }
    let bonds = UnilateralConditions::new(begin.model.mechanism);
    if let Some((pair, bond)) = bonds.at_once(&mut equations, begin.from, &y) {
        return Run::halted(begin.from, Halt::Opens { pair, bond });
    }
    let mut going = Integration::new(&equations, (bonds, stops), outputs, (begin.from, last), pass);
    if before != y && !equations.rubs() {
        going.recorder.struck = Some((begin.from, before));
    }
    going.note_held(&mut equations, begin.from);
    equations.accepted(begin.from, &y);
    let mut part = match going.better(&mut equations, (begin.from, &y), charts) {
        Some(change) => Part::changed(change),
        None => going.part(&mut equations, charts, (begin.from, &y)),
    };
    drop(equations);
    while let Ended::Changed(to) = part.ended {
        going.changes.push((to.t, to.coordinates(begin.model)));
        going.pass.most = pass.most.saturating_sub(part.counts.evaluations);
        let next = going.changed(begin, charts, &to);
        part = Part {
            counts: sum(part.counts, next.counts),
            left_off: part.left_off.with(next.left_off),
            by: part.by.or(next.by),
            ..next
        };
    }
    Run { tolerance: pass.tolerance, part: pass.before.map(|(_, part)| part), ..going.end(part) }
}

/// What became of a part of a run in one choice of coordinates.
pub(super) struct Part {
    ended: Ended,
    by: By,
    counts: Counts,
    /// Its last instant, s.
    end: f64,
    left_off: TruncationError,
}

/// By what it was integrated.
#[derive(Clone, Copy, Default)]
struct By {
    /// The least special method, where there is any step.
    method: Option<Method>,
    /// Why not by energy.
    why: Option<NotByEnergy>,
}

impl By {
    /// And the same for what comes after it.
    fn or(self, next: Self) -> Self {
        let rank = |by: Self| {
            by.method.map(|method| match method {
                Method::Energy => 0,
                Method::Dop853 => 1,
                Method::Radau => 2,
            })
        };
        let method = if rank(next) > rank(self) { next.method } else { self.method };
        Self { method, why: self.why.or(next.why) }
    }
}

/// Where a method has come to.
struct Reached {
    ended: Ended,
    counts: Counts,
    /// Its last instant, s.
    end: f64,
    y: Vec<f64>,
    left_off: TruncationError,
}

impl Part {
    /// None, up to where other coordinates are taken.
    fn changed(change: Change) -> Self {
        Self::none(change.t, Ended::Changed(Box::new(change)))
    }

    /// None: it does not go on from an instant, s.
    fn halted(t: f64, halt: Halt) -> Self {
        Self::none(t, Ended::Halted(halt))
    }

    fn none(end: f64, ended: Ended) -> Self {
        let (counts, left_off) = (Counts::default(), TruncationError::default());
        Self { ended, by: By::default(), counts, end, left_off }
    }
}

impl Integration<'_, '_> {
    /// Integrates from here, in the coordinates of the equations, as far as they go.
    fn part(
        &mut self,
        equations: &mut Equations<'_, '_>,
        charts: &mut Charts<'_>,
        (t, y): (f64, &[f64]),
    ) -> Part {
        let Pass { tolerance, measures, shorter, before, works, .. } = self.pass;
        let length = self.last - self.begin;
        self.corners = Corners::new(equations, AT_ONCE * length);
        equations.take_sides(t, y);
        let allowed = allowed(equations, (tolerance, works), length);
        let fewest = self.outputs.conduct.steps;
        let rests = self.wakes && equations.slipping.is_some() || equations.order() == 0;
        let least = if rests { AT_REST.max(fewest) } else { fewest };
        // at rest nothing bounds the steps; two runs of equal steps would say nothing of their error
        self.longest = (least > 0.0).then_some(shorter / SHORTER * length / least);
        (self.turning, self.place) = (None, None);
        let asked = self.outputs.conduct.method;
        let mut why = equations.not_by_energy();
        self.by_energy = asked.is_none_or(|m| m == Method::Energy) && why.is_none();
        let mut found = if self.by_energy {
            let watched = equations.model.mechanism.stops.len();
            let mut method = ByEnergy::new(y.len(), watched, tolerance, scale(equations));
            method.lengthen(shorter / SHORTER);
            equations.begin_walk(y[0]);
            let mut found = self.begin_with(&mut method, equations, charts, (t, y));
            found.left_off = TruncationError::of_series(method.left_off());
            self.late += method.late_by_rounding();
            found
        } else {
            self.begin_explicit(equations, charts, &allowed, (t, y))
        };
        why = why.or(match found.ended {
            Ended::Struck(stop) => Some(NotByEnergy::Stop(stop)),
            // what is looked at far ahead may be out of reach, and the next short step not
            Ended::Stuck(_) if equations.walk.is_some() => Some(NotByEnergy::Beyond),
            _ => None,
        });
        if self.by_energy && why.is_some() {
            equations.walk = None;
            self.by_energy = false;
            let before = (found.counts, found.left_off);
            found = self.begin_explicit(equations, charts, &allowed, (found.end, &found.y));
            (found.counts, found.left_off) = (sum(before.0, found.counts), before.1.with(found.left_off));
        }
        let mut name = if self.by_energy { Method::Energy } else { Method::Dop853 };
        if matches!(found.ended, Ended::Stiff) {
            self.trace.stiff.get_or_insert(found.end);
            let mut implicit = Radau::new(&allowed);
            if !measures && before.is_none() {
                let gap = shorter * self.outputs.longest_gap(length);
                self.longest = Some(if fewest > 0.0 { gap.min(length / fewest) } else { gap });
            }
            self.bound(&mut implicit);
            let ended = match implicit.start(equations, found.end, &found.y, self.last) {
                Ok(()) => self.integrate(equations, &mut implicit, (charts, true)),
                Err(Undefined) => Ended::Halted(equations.halt()),
            };
            let counts = sum(found.counts, implicit.counts());
            let left_off =
                found.left_off.with(TruncationError::of_steps(tolerance, implicit.progress().errors));
            let y = Vec::new();
            (found, name) = (Reached { ended, counts, end: implicit.t(), y, left_off }, Method::Radau);
        }
        let Reached { ended, counts, end, left_off, .. } = found;
        self.crossed.append(&mut equations.crossed);
        self.kinds.found(equations);
        Part { ended, by: By { method: Some(name), why }, counts, end, left_off }
    }

    /// Integrates by the explicit method from an instant, s.
    fn begin_explicit(
        &mut self,
        equations: &mut Equations<'_, '_>,
        charts: &mut Charts<'_>,
        allowed: &Tolerance<f64>,
        from: (f64, &[f64]),
    ) -> Reached {
        let mut method = Dop853::new(allowed.clone());
        self.place = Some(0);
        self.begin_with(&mut method, equations, charts, from)
    }

    /// Integrates by a method up to the end, or up to where an implicit one is asked for.
    fn begin_with<M: Integrator<f64>>(
        &mut self,
        method: &mut M,
        equations: &mut Equations<'_, '_>,
        charts: &mut Charts<'_>,
        (t, y): (f64, &[f64]),
    ) -> Reached {
        self.trace.note(t, 0);
        self.bound(method);
        let ended = match method.start(equations, t, y, self.last) {
            Ok(()) if self.outputs.conduct.method == Some(Method::Radau) => Ended::Stiff,
            Ok(()) => {
                method.progress_mut().begin_with(std::mem::replace(&mut self.first, f64::INFINITY));
                self.integrate(equations, method, (charts, false))
            }
            Err(Undefined) => {
                equations.accepted(t, y);
                Ended::Halted(equations.halt())
            }
        };
        let left_off = TruncationError::of_steps(self.pass.tolerance, method.progress().errors);
        Reached { ended, counts: method.counts(), end: method.t(), y: method.y().to_vec(), left_off }
    }

    /// Goes on in other coordinates.
    fn changed(&mut self, begin: &StartState<'_>, charts: &mut Charts<'_>, to: &Change) -> Part {
        let own = to.chart.as_deref().map(Chart::model);
        let model = own.as_ref().unwrap_or(begin.model);
        let mut equations = Equations::new(model, begin, to.chart.as_deref(), (to.t, &to.state, &to.angles));
        let still = begin.still.and_then(|_| at_rest(model));
        let still = still.as_ref().map(|(mechanism, plan)| Model { mechanism, plan, ..*model });
        equations.still = still.as_ref();
        equations.goes_until(self.last);
        equations.closed.clone_from(&to.closed);
        let mut y = to.y.clone();
        if let Some(held) = &to.held
            && let Err(halt) = equations.begin_slipping(to.t, &mut y, Some(held))
        {
            return Part::halted(to.t, halt);
        }
        self.note_stops(&equations, &to.closed, (to.t, &[], Some(to.t)));
        self.part(&mut equations, charts, (to.t, &y))
    }

    /// What a run has found.
    fn end(self, part: Part) -> Run {
        let stopped = match part.ended {
            Ended::Halted(halt) | Ended::Stuck(halt) => Some((part.end, halt)),
            Ended::Done | Ended::Stiff | Ended::Struck(_) | Ended::Changed(_) => None,
        };
        let end = part.end;
        let shift = (self.stops.shift / (self.last - self.begin)).max(self.cancelled());
        let (functions, left_off) = (self.watch.functions(end), self.watch.left_off());
        let courses = self.watch.courses();
        let Integration {
            watch,
            recorder,
            kinds,
            worst_condition,
            ended_by,
            held,
            jammed,
            stops,
            changes,
            crossed,
            trace,
            late,
            ..
        } = self;
        let mut events = watch.times;
        if let Some((event, f64::INFINITY)) = self.outputs.guard.filter(|_| stopped.is_none()) {
            events[event].push(end);
        }
        let (records, energy) = recorder.end();
        Run {
            method: part.by.method.unwrap_or_default(),
            why: part.by.why,
            counts: part.counts,
            energy,
            worst_condition,
            events,
            kinds,
            functions,
            courses,
            held,
            jammed,
            changes,
            crossed,
            closed: stops.rests,
            ended_by,
            stopped,
            end,
            left_off: part.left_off.with_functions(left_off),
            shift,
            late,
            tolerance: 0.0,
            part: None,
            trace: trace.with_works(&records),
            records,
        }
    }
}

const fn sum(a: Counts, b: Counts) -> Counts {
    Counts {
        evaluations: a.evaluations + b.evaluations,
        steps: a.steps + b.steps,
        rejected: a.rejected + b.rejected,
        shortened: a.shortened + b.shortened,
    }
}

/// Chooses how what rubs or stands at a stop begins.
fn start(equations: &mut Equations<'_, '_>, first: f64, y: &mut [f64]) -> Result<(), Halt> {
    let opposing = &equations.model.plan.opposing;
    let held = |id| opposing.iter().any(|load| load.load == id);
    let stops = !equations.model.mechanism.stops.is_empty();
    if stops || equations.model.plan.effects.loses() || equations.acting().any(|(id, _, _)| held(id)) {
        equations.begin_slipping(first, y, None)?;
    }
    for stop in 0..equations.model.mechanism.stops.len() {
        if equations.slopes(stop).iter().all(|slope| *slope == 0.0) {
            return Err(Halt::NothingFree { stop });
        }
    }
    Ok(())
}

impl Run {
    /// What it has found.
    pub fn outcome(&self) -> Outcome<'_> {
        Outcome {
            records: &self.records,
            events: &self.events,
            functions: &self.functions,
            kinds: &self.kinds,
            opens: match self.stopped {
                Some((time, Halt::Opens { .. })) => Some(time),
                _ => None,
            },
            halted: self.stopped.is_some(),
            end: self.end,
        }
    }

    /// A run that does not begin.
    fn halted(first: f64, halt: Halt) -> Self {
        Self {
            method: Method::Dop853,
            why: None,
            records: Records::default(),
            counts: Counts::default(),
            energy: Energy::default(),
            worst_condition: (1.0, first),
            events: Vec::new(),
            kinds: Kinds::default(),
            functions: Vec::new(),
            courses: Vec::new(),
            held: Vec::new(),
            jammed: Vec::new(),
            changes: Vec::new(),
            crossed: Vec::new(),
            closed: Vec::new(),
            ended_by: None,
            stopped: Some((first, halt)),
            end: first,
            left_off: TruncationError::default(),
            shift: 0.0,
            late: 0.0,
            tolerance: 0.0,
            part: None,
            trace: Trace::default(),
        }
    }
}
