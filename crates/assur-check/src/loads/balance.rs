//! Unknown efforts.

use super::pin::LoadedPin;
use crate::expr::context::Context;
use crate::expr::positive::Want;
use crate::loads::load::{
    effort, example, form, frame, moving, no_place, of_open_shaft, place, slider, whole_link,
};
use crate::names::suggestion::not_declared;
use assur_math::math::Vec2;
use assur_model::model;
use assur_model::model::BalanceKind;
use assur_syntax::document;
use assur_syntax::document::{Balance, Expr, ExprKind, LoadKind, Name, Site, Statement};
use assur_text::diagnostic::{Diagnosis, Help};
use assur_text::source::Spanned;

/// Enters all unknown efforts into the mechanism.
pub(crate) fn balances(cx: &mut Context<'_>) {
    let doc = cx.doc;
    for statement in &doc.statements {
        if let Statement::Balance(balance) = &statement.node
            && let Some(kind) = all_places(cx, balance)
        {
            let (name, span) = (balance.name.node.clone(), balance.name.span);
            let pin = match &balance.site {
                Site::Pin(pin) => cx.find_pair(&pin.node),
                Site::Link { .. } | Site::Segment { .. } | Site::Pair(_) => None,
            };
            cx.builder.mech.balances.push(model::Balance { name, span, kind, pin });
        }
    }
}

/// The effort at its place or, if it acts at several, at each of them.
fn all_places(cx: &mut Context<'_>, balance: &Balance) -> Option<BalanceKind> {
    let first = kind(cx, balance);
    if balance.also.is_empty() {
        return first;
    }
    if matches!(first, Some(BalanceKind::Force { .. })) {
        let message = "a force at a point acts at one place alone".into();
        let help = "write the same torque on several links, or the same effort in several pairs: \
            `balance force F in c1, c2`";
        form(cx, message, help, balance.also[0].span);
        return None;
    }
    let mut places = vec![first];
    let mut names = vec![match &balance.site {
        Site::Link { link, .. } | Site::Segment { link, .. } => link,
        Site::Pair(name) | Site::Pin(name) => name,
    }];
    for name in &balance.also {
        if names.iter().any(|n| n.node == name.node) {
            let message = format!("`{}` is named twice", name.node);
            form(cx, message, "leave it out once: the effort acts there once", name.span);
            places.push(None);
            continue;
        }
        let site = match &balance.site {
            Site::Link { .. } | Site::Segment { .. } => Site::Link { link: name.clone(), at: None },
            Site::Pair(_) => Site::Pair(name.clone()),
            Site::Pin(_) => Site::Pin(name.clone()),
        };
        places.push(kind(cx, &Balance { site, also: Vec::new(), ..balance.clone() }));
        names.push(name);
    }
    places.into_iter().collect::<Option<_>>().map(BalanceKind::Several)
}

fn kind(cx: &mut Context<'_>, balance: &Balance) -> Option<BalanceKind> {
    let (link, at) = match &balance.site {
        Site::Link { link, at } => (link, at.as_ref()),
        Site::Segment { link, from, to } => {
            let message = "an unknown load does not act along a segment".to_owned();
            let help = format!("give one point: `on {} at {}`", link.node, to.node);
            form(cx, message, &help, from.span.to(to.span));
            return None;
        }
        Site::Pin(name) => {
            let pin = LoadedPin::of(cx, name, balance.kind.node)?;
            let pin = pin.moves(cx, name, "no force is to be found there")?;
            let example = format!("balance force {} at {} along 90 deg", balance.name.node, name.node);
            return along(cx, balance, &example, (pin.on, model::Place::Local(pin.at)));
        }
        Site::Pair(pair) => {
            let word = if balance.kind.node == LoadKind::Torque { "torque" } else { "force" };
            let line = format!("balance {word} {} in {}", balance.name.node, pair.node);
            let pair = effort(cx, balance.kind.node, balance.kind.span, (&line, pair));
            undirected(cx, balance, "a load in a pair acts along its coordinate")?;
            return Some(BalanceKind::InPair(pair?.0));
        }
    };
    match balance.kind.node {
        LoadKind::Torque => {
            let on = moving(cx, link, "a torque");
            whole_link(cx, at, &format!("balance torque {} on {}", balance.name.node, link.node))?;
            undirected(cx, balance, "a torque has no direction in the plane")?;
            on.map(BalanceKind::Torque)
        }
        LoadKind::Force => force(cx, balance, link, at),
    }
}

fn force(
    cx: &mut Context<'_>,
    balance: &Balance,
    link: &Name,
    at: Option<&document::Place>,
) -> Option<BalanceKind> {
    if let Some(pair) = slider(cx, link) {
        undirected(cx, balance, "a slider moves along one line")?;
        return Some(BalanceKind::InPair(pair));
    }
    of_open_shaft(cx, link, "an unknown force")?;
    let on = moving(cx, link, "a force");
    let name = &balance.name.node;
    let site = match at {
        Some(document::Place::Point(point)) => format!("{} at {}", link.node, point.node),
        _ => example(cx, on, &link.node),
    };
    let example = format!("balance force {name} on {site} along 90 deg");
    let place = match at {
        Some(at) => on.and_then(|on| place(cx, on, at)),
        None => {
            on?;
            no_place(cx, "an unknown force", link, example);
            return None;
        }
    };
    along(cx, balance, &example, (on?, place?))
}

/// A force along the direction of the file at its place.
fn along(
    cx: &mut Context<'_>,
    balance: &Balance,
    example: &str,
    (on, at): (model::LinkId, model::Place),
) -> Option<BalanceKind> {
    let name = &balance.name.node;
    let Some(along) = &balance.along else {
        cx.error(
            Diagnosis::error(
                "mech::geometry::force_without_direction",
                format!("the force `{name}` has no direction"),
            )
            .label(balance.name.span, "the direction is missing")
            .help(format!("give its direction: `{example}`")),
        );
        return None;
    };
    if let Some((along, frame)) = along_line(cx, balance, along, on) {
        return Some(BalanceKind::Force { on, at, along, frame });
    }
    no_line(cx, along, on)?;
    let along = cx.scalar_constant(along, &Want::ANGLE, &format!("the direction of the force `{name}`"));
    let frame = frame(cx, balance.frame.as_ref());
    Some(BalanceKind::Force { on, at, along: Vec2::direction(along?), frame: frame? })
}

/// Reports a name after `along` that is neither a quantity nor a line, where there are lines.
fn no_line(cx: &mut Context<'_>, along: &Expr, on: model::LinkId) -> Option<()> {
    let ExprKind::Name(name) = &along.kind else { return Some(()) };
    let unknown = !cx.names.quantities.contains_key(name) && !cx.names.bad.contains(name) && name != "pi";
    let of = |link: model::LinkId| cx.names.inside.get(link.index()).into_iter().flat_map(|i| i.lines.keys());
    let lines = of(model::LinkId::GROUND).chain(of(on)).cloned().collect::<Vec<_>>();
    let span = along.span;
    if !unknown || lines.is_empty() || lines.contains(name) {
        return Some(());
    }
    let help = match lines.as_slice() {
        [only] => {
            Help::write(span, std::slice::from_ref(only)).in_words(format!("write `{only}`: the only line"))
        }
        _ => {
            format!("the lines are {}", lines.iter().map(|l| format!("`{l}`")).collect::<Vec<_>>().join(", "))
                .into()
        }
    };
    cx.error(not_declared("line or angle", name, None, span, Some(help)));
    None
}

/// The direction of a line that is named in place of an angle, of the ground or of the link itself, with the link whose axes it is
/// given in. Quantities come first.
fn along_line(
    cx: &mut Context<'_>,
    balance: &Balance,
    along: &Expr,
    on: model::LinkId,
) -> Option<(Vec2, Option<model::LinkId>)> {
    let ExprKind::Name(name) = &along.kind else { return None };
    if balance.frame.is_some() || cx.names.quantities.contains_key(name) {
        return None;
    }
    let has = |link: &model::LinkId| cx.kind_inside(*link, name) == Some("line");
    let link = [model::LinkId::GROUND, on].into_iter().find(has)?;
    let line = cx.line(link, &Spanned::new(name.clone(), along.span))?;
    Some((line.along, (link != model::LinkId::GROUND).then_some(link)))
}

/// Reports a direction where there can be none.
fn undirected(cx: &mut Context<'_>, balance: &Balance, message: &str) -> Option<()> {
    let along = balance.along.as_ref().map(|e| e.span).or(balance.frame.as_ref().map(|f| f.span));
    let Some(span) = along else { return Some(()) };
    form(cx, message.into(), "leave the direction out", span);
    None
}
