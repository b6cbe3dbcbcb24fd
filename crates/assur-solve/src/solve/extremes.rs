//! Dead positions, strokes and time ratios: the extremes of a pair's coordinate over one turn of the drive.

use super::cycle::{CycleAnswer, FlywheelAnswer};
use super::error::{SolveError, label};
use super::solution::Scene;
use super::turn::{Failure, Turn};
use super::words::four;
use crate::language::Function;
use crate::model::{Expr, Mechanism, PairId, Positions, Query};
use crate::source::Span;
use std::f64::consts::TAU;

/// Extremes of the pairs asked for.
#[derive(Clone, Debug, Default)]
pub struct Statics {
    extremes: Vec<(PairId, Extremes)>,
    /// Values at which locking begins, by index into [`Mechanism::criticals`].
    pub criticals: Vec<f64>,
    /// Functions over the sweep, by index into [`Mechanism::cycles`].
    pub cycles: Vec<CycleAnswer>,
    /// Flywheels, by index into [`Mechanism::flywheels`].
    pub flywheels: Vec<FlywheelAnswer>,
}

/// Extremes of one coordinate over a turn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extremes {
    /// The least coordinate, m or rad.
    pub least: f64,
    /// The greatest.
    pub greatest: f64,
    /// Drive value of the least in [0, 2π), rad.
    pub at_least: f64,
    /// Drive value of the greatest in [0, 2π), rad.
    pub at_greatest: f64,
}

impl Statics {
    /// Nothing asked for.
    pub const EMPTY: Self =
        Self { extremes: Vec::new(), criticals: Vec::new(), cycles: Vec::new(), flywheels: Vec::new() };

    fn of(&self, pair: PairId) -> Option<&Extremes> {
        self.extremes.iter().find(|(p, _)| *p == pair).map(|(_, e)| e)
    }

    /// The least coordinate of a pair.
    #[must_use]
    pub fn least(&self, pair: PairId) -> f64 {
        self.of(pair).map_or(f64::NAN, |e| e.least)
    }

    /// Greatest less least coordinate.
    #[must_use]
    pub fn stroke(&self, pair: PairId) -> f64 {
        self.of(pair).map_or(f64::NAN, |e| e.greatest - e.least)
    }

    /// Drive value of the least (1) or greatest (2) coordinate, in [0, 2π).
    #[must_use]
    pub fn dead(&self, pair: PairId, which: u8) -> f64 {
        self.of(pair).map_or(f64::NAN, |e| if which == 1 { e.at_least } else { e.at_greatest })
    }

    /// Value of a given at which locking begins; NaN where it does not.
    #[must_use]
    pub fn critical(&self, which: usize) -> f64 {
        self.criticals.get(which).copied().unwrap_or(f64::NAN)
    }

    /// Value of a function over the sweep; NaN where it has none.
    #[must_use]
    pub fn cycle(&self, which: usize) -> f64 {
        self.cycles.get(which).map_or(f64::NAN, |c| c.value)
    }

    /// The longer way between the extremes over the shorter.
    #[must_use]
    pub fn time_ratio(&self, pair: PairId) -> f64 {
        self.of(pair).map_or(f64::NAN, |e| {
            let way = (e.at_greatest - e.at_least).abs();
            let other = TAU - way;
            way.max(other) / way.min(other)
        })
    }
}

/// Finds the extremes of every pair whose `dead`, `stroke`, `travel` or `time_ratio` the file names.
pub(super) fn statics(scene: &Scene<'_>) -> Result<Statics, SolveError> {
    let wanted = wanted(scene.mechanism);
    let Some(first) = wanted.first() else { return Ok(Statics::EMPTY) };
    let drive = match scene.mechanism.drives.as_slice() {
        [drive] if super::positions::turns(scene, drive) => drive,
        [drive] => {
            let why = format!("it takes a drive that turns, and `{}` slides", drive.name);
            let help =
                "drive the crank; the extremes of what moves to and fro are found over its turn".to_owned();
            return Err(none(scene, first, why, help, vec![label("slides", drive.span)]));
        }
        drives => {
            let why = format!("it takes one drive that turns, and there are {}", drives.len());
            let labels = drives.iter().map(|d| label("one of the drives", d.span)).collect();
            let help =
                "the extremes of a coordinate over one turn are not defined where several drives move it";
            return Err(none(scene, first, why, help.to_owned(), labels));
        }
    };
    let pairs: Vec<PairId> = wanted.iter().map(|ask| ask.pair).collect();
    let turn = Turn::new(scene, &pairs).map_err(|why| match why {
        Failure::Error(e) => *e,
        Failure::Open(limit) => {
            let at = limit
                .map_or_else(|| "at 0 deg".to_owned(), |x| format!("beyond {} deg", four(x.to_degrees())));
            none(
                scene,
                first,
                format!("`{}` cannot turn fully, the mechanism does not close {at}", drive.name),
                "give the positions as numbers, or lengths with which the shortest link turns fully"
                    .to_owned(),
                vec![label("does not turn fully", drive.span)],
            )
        }
    })?;
    let mut out = Vec::new();
    for (i, ask) in wanted.iter().enumerate() {
        let extremes = turn.extremes(scene, i).ok_or_else(|| {
            let why =
                format!("the coordinate of `{}` does not go to and fro", scene.mechanism.pair(ask.pair).name);
            let help = "name the pair of a link that swings or slides between two ends".to_owned();
            none(scene, ask, why, help, Vec::new())
        })?;
        out.push((ask.pair, extremes));
    }
    Ok(Statics { extremes: out, ..Statics::EMPTY })
}

fn none(
    scene: &Scene<'_>,
    ask: &Asked,
    why: String,
    help: String,
    mut labels: Vec<miette::LabeledSpan>,
) -> SolveError {
    let pair = scene.mechanism.pair(ask.pair);
    let which = ask.which.map_or_else(String::new, |which| format!(", {which}"));
    labels.insert(0, label("this pair", pair.span));
    SolveError::NoExtreme {
        what: format!("{}({}{which})", ask.function.name(), pair.name),
        why,
        help,
        labels,
    }
}

/// A pair whose extremes are asked for, with the query that does.
struct Asked {
    pair: PairId,
    function: Function,
    which: Option<u8>,
}

/// Pairs whose extremes are asked for anywhere in the file.
fn wanted(mechanism: &Mechanism) -> Vec<Asked> {
    let mut asked: Vec<Asked> = Vec::new();
    every_query(mechanism, &mut |query, _| {
        let Some((pair, function, which)) = query.facts().extreme else { return };
        if !asked.iter().any(|a| a.pair == pair) {
            asked.push(Asked { pair, function, which });
        }
    });
    asked
}

/// Calls `look` on every result that the file asks for, with the place of its statement.
pub(super) fn every_query(mechanism: &Mechanism, look: &mut impl FnMut(&Query, Span)) {
    use crate::model::{At, FindKind, Relation};
    let mut ask = |expr: &Expr, span: Span| expr.queries(&mut |query| look(query, span));
    for drive in &mechanism.drives {
        match &drive.positions {
            Positions::None => {}
            Positions::List(list) => list.iter().for_each(|e| ask(e, drive.span)),
            Positions::Range { from, to, .. } => {
                ask(from, drive.span);
                ask(to, drive.span);
            }
        }
        drive.speed.iter().chain(&drive.acceleration).for_each(|e| ask(e, drive.span));
    }
    for pose in &mechanism.poses {
        pose.at.iter().for_each(|(_, e)| ask(e, pose.span));
    }
    mechanism.quantities.iter().for_each(|q| ask(&q.expr, q.span));
    mechanism.cycles.iter().for_each(|c| ask(&c.expr, c.span));
    for load in &mechanism.loads {
        load.expressions().for_each(|e| ask(e, load.span));
    }
    for find in &mechanism.finds {
        if let FindKind::Value { expr, .. } = &find.kind {
            ask(expr, find.span);
        }
    }
    for expect in &mechanism.expects {
        ask(&expect.expr, expect.span);
        match &expect.relation {
            Relation::Equal(values) => values.iter().for_each(|e| ask(e, expect.span)),
            Relation::Compare(_, bound) => ask(bound, expect.span),
            Relation::Truth => {}
        }
        if let Some(At::Drives(list)) = &expect.at {
            list.iter().for_each(|(_, e)| ask(e, expect.span));
        }
    }
}
