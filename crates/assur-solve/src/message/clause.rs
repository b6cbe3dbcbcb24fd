//! The clauses of `assemble` that choose an assembly, as lines to paste.

use super::format::{length, short};
use crate::position::{Model, extent};
use crate::solve::{Clause, NamedPoint};

/// `assemble C left of B-D`
#[must_use]
pub fn clause(model: &Model<'_>, clause: &Clause) -> String {
    let name = |pair| &model.mechanism.pair(pair).name;
    match *clause {
        Clause::Side { hinge, from, to, left } => {
            let side = if left { "left" } else { "right" };
            format!("assemble {} {side} of {}-{}", name(hinge), name(from), name(to))
        }
        Clause::Along { hinge, other, ahead } => {
            let word = if ahead { "ahead of" } else { "behind" };
            format!("assemble {} {word} {}", name(hinge), name(other))
        }
        Clause::Sign { pair, positive } => {
            format!("assemble {} {} 0", name(pair), if positive { ">" } else { "<" })
        }
        Clause::Between { pair, above, below } => {
            let bound = |sign: &str, x: f64| format!("{} {sign} {} deg", name(pair), short(x.to_degrees()));
            let bounds = [above.map(|x| bound(">", x)), below.map(|x| bound("<", x))];
            format!("assemble {}", bounds.into_iter().flatten().collect::<Vec<_>>().join(", "))
        }
        Clause::Near { point, place } => {
            // what is nothing but rounding is zero
            let size = extent(model);
            let rounded = |x: f64| if x.abs() < 1e-9 * size { 0.0 } else { x };
            let (x, y) = (length(model, rounded(place.x)), length(model, rounded(place.y)));
            format!("assemble {} near ({x}, {y})", point_name(model, point))
        }
    }
}

/// `rod.S`
pub(super) fn point_name(model: &Model<'_>, point: NamedPoint) -> String {
    let link = model.mechanism.link(point.link);
    format!("{}.{}", link.name, link.points[point.index].name)
}
