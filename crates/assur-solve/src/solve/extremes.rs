//! Dead positions, strokes and time ratios: the extremes of a pair's coordinate over one turn of the drive.

use super::turn::{Failure, Turn};
use crate::answer::{WholeCycle, every_query};
use crate::message::{SolveError, four, label};
use crate::model::{Mechanism, PairId, Query};
use crate::position::{Scene, turns};

/// Finds the extremes of every pair whose `dead`, `stroke`, `travel` or `time_ratio` the file names.
pub(crate) fn statics(scene: &Scene<'_>) -> Result<WholeCycle, SolveError> {
    let wanted = wanted(scene.mechanism);
    let Some(first) = wanted.first() else { return Ok(WholeCycle::EMPTY) };
    let drive = match scene.mechanism.drives.as_slice() {
        [drive] if turns(scene, drive) => drive,
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
    Ok(WholeCycle { extremes: out, ..WholeCycle::EMPTY })
}

fn none(
    scene: &Scene<'_>,
    ask: &Asked,
    why: String,
    help: String,
    mut labels: Vec<miette::LabeledSpan>,
) -> SolveError {
    let pair = scene.mechanism.pair(ask.pair);
    let (before, behind) = ask.query;
    labels.insert(0, label("this pair", pair.span));
    SolveError::NoExtreme { what: format!("{before}({}{behind})", pair.name), why, help, labels }
}

/// A pair whose extremes are asked for, with the query that does.
struct Asked {
    pair: PairId,
    query: (&'static str, &'static str),
}

/// Pairs whose extremes are asked for anywhere in the file.
fn wanted(mechanism: &Mechanism) -> Vec<Asked> {
    let mut asked: Vec<Asked> = Vec::new();
    every_query(mechanism, &mut |query, _| {
        let (pair, query) = match query {
            Query::Travel(p) => (*p, ("travel", "")),
            Query::Stroke(p) => (*p, ("stroke", "")),
            Query::TimeRatio(p) => (*p, ("time_ratio", "")),
            Query::Dead(p, 1) => (*p, ("dead", ", 1")),
            Query::Dead(p, _) => (*p, ("dead", ", 2")),
            _ => return,
        };
        if !asked.iter().any(|a| a.pair == pair) {
            asked.push(Asked { pair, query });
        }
    });
    asked
}
