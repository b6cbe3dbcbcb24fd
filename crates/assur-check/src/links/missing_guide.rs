//! The prismatic pair that a file names and does not declare.

use crate::expr::context::Context;
use assur_model::model::Link;
use assur_syntax::document::{End, Statement};

/// ``add the line `prismatic D: piston.C - ground.guide` ``: the only line that no pair takes, or the only one there is, and the only link
/// that the fewest pairs join, if it has one point.
pub(crate) fn missing_guide(cx: &Context<'_>, name: &str) -> Option<String> {
    let mech = &cx.builder.mech;
    let lines = mech.links.iter().flat_map(|link| link.lines.iter().map(move |line| (link, &line.name)));
    let (taken, free): (Vec<_>, Vec<_>) = lines.partition(|(link, line)| is_taken(cx, &link.name, line));
    let candidates = if free.is_empty() { taken } else { free };
    let [(guide, line)] = candidates.as_slice() else { return None };
    let pairs = |link: &Link| {
        let joins =
            |p: &&assur_model::model::Pair| p.kind.links().iter().any(|id| mech.link(*id).name == link.name);
        mech.pairs.iter().filter(joins).count()
    };
    let others = || mech.links.iter().skip(1).filter(|link| link.name != guide.name);
    let least = others().map(pairs).min().filter(|least| *least < 2)?;
    let mut loose = others().filter(|link| pairs(link) == least);
    let slider = loose.next().filter(|_| loose.next().is_none())?;
    let [point] = slider.points.as_slice() else { return None };
    Some(format!(
        "add the line `prismatic {name}: {}.{} - {}.{line}`, if `{}` slides there",
        slider.name, point.name, guide.name, slider.name
    ))
}

/// Whether an end of a pair names this line of a link.
fn is_taken(cx: &Context<'_>, link: &str, line: &str) -> bool {
    let names = |end: &End| matches!(end, End::At(path) if path.head.node == link && path.tail.as_ref().is_some_and(|t| t.node == line));
    cx.doc
        .statements
        .iter()
        .any(|s| matches!(&s.node, Statement::Joint(joint) if joint.ends.iter().any(names)))
}
