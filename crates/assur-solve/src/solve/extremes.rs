//! Dead positions, strokes and time ratios: the extremes of a pair's coordinate over one turn of the drive.

use super::failure::Cause;
use super::turn::{NoTurn, Turn};
use crate::answer::{NoExtreme, WholeCycle, every_query};
use crate::language::Function;
use crate::model::{Mechanism, PairId};
use crate::position::{Model, turns};

/// Finds the extremes of every pair whose `dead`, `stroke`, `travel` or `time_ratio` the file names.
pub(crate) fn statics(model: &Model<'_>) -> Result<WholeCycle, Cause> {
    let wanted = wanted(model.mechanism);
    let Some(first) = wanted.first() else { return Ok(WholeCycle::EMPTY) };
    let none = |ask: &ExtremesRequest, why: NoExtreme| {
        let ExtremesRequest { pair, function, which } = *ask;
        Cause::NoExtreme { pair, function, which, why, gap: None }
    };
    match model.mechanism.drives.as_slice() {
        [drive] if turns(model, drive) => {}
        [_] => return Err(none(first, NoExtreme::Slides)),
        _ => return Err(none(first, NoExtreme::Drives)),
    }
    let pairs: Vec<PairId> = wanted.iter().map(|ask| ask.pair).collect();
    let turn = Turn::new(model, &pairs).map_err(|why| match why {
        NoTurn::NotAssembled(cause) => *cause,
        NoTurn::Open { limit, gap } => {
            let ExtremesRequest { pair, function, which } = *first;
            Cause::NoExtreme { pair, function, which, why: NoExtreme::NoTurn(limit), gap: gap.map(Box::new) }
        }
    })?;
    let mut out = Vec::new();
    for (i, ask) in wanted.iter().enumerate() {
        let extremes = turn.extremes(model, i).ok_or_else(|| none(ask, NoExtreme::Monotonic))?;
        out.push((ask.pair, extremes));
    }
    Ok(WholeCycle { extremes: out, ..WholeCycle::EMPTY })
}

/// Whether any is named.
pub(super) fn asks_extremes(mechanism: &Mechanism) -> bool {
    !wanted(mechanism).is_empty()
}

/// A pair whose extremes are asked for, with the query that does.
struct ExtremesRequest {
    pair: PairId,
    function: Function,
    which: Option<u8>,
}

/// Pairs whose extremes are asked for anywhere in the file.
fn wanted(mechanism: &Mechanism) -> Vec<ExtremesRequest> {
    let mut asked: Vec<ExtremesRequest> = Vec::new();
    every_query(mechanism, &mut |query, _| {
        let Some((pair, function, which)) = query.facts().extreme else { return };
        if !asked.iter().any(|a| a.pair == pair) {
            asked.push(ExtremesRequest { pair, function, which });
        }
    });
    asked
}
