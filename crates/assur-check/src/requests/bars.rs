//! `axial(L)`, `find axial`: links of two hinges, which carry a force along them and nothing else.

use crate::expr::context::Context;
use crate::expr::results::Call;
use crate::links::lookup::kind_phrase;
use crate::loads::mass::inertia_counts;
use crate::values::format_value::format_value;
use crate::values::typed::{Type, Typed};
use crate::values::unit_use::display_in;
use assur_math::math::Vec2;
use assur_model::model::{
    BalanceKind, Bar, DriveTarget, Expr, Find, FindKind, LinkId, LoadId, LoadKind, PairId, PairKind, Place,
    Query,
};
use assur_syntax::document::FindItem;
use assur_text::diagnostic::Diagnosis;
use assur_text::language::Collection;
use assur_text::source::Span;
use assur_text::units::Dimension;

const BETWEEN: &str = "it is loaded between its hinges";

/// Why a link carries more than a force along it, and where that stands.
struct Bends {
    why: String,
    at: Span,
    help: Option<String>,
}

/// What acts on a link, and where.
#[derive(Clone, Copy)]
struct Acting {
    at: Vec2,
    what: What,
}

#[derive(Clone, Copy, PartialEq)]
enum What {
    Hinge(PairId),
    /// A pin of the link in a slot.
    Slot(PairId),
    Load(LoadId),
    /// A spring, a weight, an unknown force: what is not summed here.
    Other(Span),
}

impl Context<'_> {
    /// `axial(L)`
    pub(crate) fn axial(&mut self, call: Call<'_>) -> Option<Typed> {
        let args = self.arguments(call, 1, 1)?;
        let link = self.link_argument(call, args[0])?;
        self.builder.axial.push((link, args[0].span));
        Some(Typed::new(Expr::Query(Query::Axial(link)), Type::number(Dimension::FORCE)))
    }
}

/// The answers of `find axial`; `None` for anything else, and where the file has such a name.
pub(crate) fn asked(cx: &mut Context<'_>, item: &FindItem) -> Option<Vec<Find>> {
    if super::find::collection(cx, item)? != Collection::AXIAL {
        return None;
    }
    let force = Typed::new(Expr::number(0.0), Type::number(Dimension::FORCE));
    let display = match &item.unit {
        Some(word) => {
            let unit = cx.unit(word)?;
            cx.unit_fits(&unit, &force, item)?;
            display_in(&unit)
        }
        None => cx.values.display(Dimension::FORCE),
    };
    let links = (1..cx.builder.mech.links.len()).map(LinkId::at);
    let links: Vec<LinkId> = links.collect();
    let bars: Vec<LinkId> = links.iter().copied().filter(|link| bar(cx, *link).is_ok()).collect();
    if !bars.is_empty() {
        left_out(cx, &links, item.span);
    } else {
        cx.error(
            Diagnosis::error("mech::request::bends", "no link has two hinges and nothing between them")
                .primary(item.span, "the forces along links are asked for")
                .help("ask for `reactions`: the forces in all pairs"),
        );
    }
    cx.builder.axial.extend(bars.iter().map(|link| (*link, item.span)));
    let find = |link: LinkId| {
        let name = format!("axial({})", cx.builder.mech.link(link).name);
        let kind = FindKind::Value {
            expr: Expr::Query(Query::Axial(link)),
            display: display.clone(),
            poseless: false,
        };
        Find { name, span: item.span, kind }
    };
    Some(bars.into_iter().map(find).collect())
}

/// Notes once the links of two hinges that are not among the answers.
fn left_out(cx: &mut Context<'_>, links: &[LinkId], asked: Span) {
    let bent = links.iter().find_map(|&link| match bar(cx, link) {
        Err(bends) if bends.why == BETWEEN => Some((link, bends.at)),
        _ => None,
    });
    let Some((link, at)) = bent else { return };
    let name = &cx.builder.mech.link(link).name;
    let note =
        Diagnosis::advice("mech::request::bends", format!("`{name}` is left out: {BETWEEN}, so it bends"))
            .primary(asked, "the forces along links are asked for")
            .label(at, "this acts on it")
            .help("ask for the forces in its pairs: `find reactions`");
    cx.error(note);
}

/// Enters the links whose axial force is asked for; reports one that bends. Only once all loads are in the mechanism.
pub(crate) fn bars(cx: &mut Context<'_>) {
    let mut asked = std::mem::take(&mut cx.builder.axial);
    asked.sort_unstable_by_key(|(link, span)| (*link, span.start));
    asked.dedup_by_key(|(link, _)| *link);
    for (link, span) in asked {
        match bar(cx, link) {
            Ok(bar) => cx.builder.mech.bars.push(bar),
            Err(bends) if cx.pairs_complete() => report(cx, link, span, bends),
            Err(_) => {}
        }
    }
}

fn report(cx: &mut Context<'_>, link: LinkId, span: Span, bends: Bends) {
    let mech = &cx.builder.mech;
    let name = mech.link(link).name.clone();
    let hinge = mech.pairs.iter().find(|p| p.kind.links().contains(&link));
    let [begin, end] = mech.link(link).extent();
    let force = if begin < end {
        let cut = format_value((begin + end) / 2.0, Dimension::LENGTH);
        Some(format!("ask for the force along it at a cut: `internal({name}, {cut}).N`"))
    } else {
        hinge.map(|pair| format!("ask for the force in a pair: `reaction({}, {name})`", pair.name))
    };
    cx.error(
        Diagnosis::error("mech::request::bends", format!("`{name}` bends: {}", bends.why))
            .primary(span, "the force along it is asked for")
            .label((bends.at != span).then_some(bends.at), "this acts on it")
            .help_if(bends.help.or(force)),
    );
}

/// Notes once that the reaction of a pin on a link is asked for, where a load acts on this link at the pin.
pub(crate) fn load_at_pin(cx: &mut Context<'_>) {
    let mech = &cx.builder.mech;
    let mut asked = Vec::new();
    for find in &mech.finds {
        let FindKind::Value { expr, .. } = &find.kind else { continue };
        expr.queries(&mut |query| {
            if let Query::Reaction(pair, link) = query {
                asked.push((*pair, *link, find.span));
            }
        });
    }
    let noted = asked.into_iter().find_map(|(pair, link, span)| {
        let of = bar(cx, link).ok()?;
        let hinge = mech.point_in(pair, link)?;
        let ends = [of.from, of.to].contains(&pair);
        let load = mech.loads.iter().find(|load| {
            let at = matches!(&load.kind, LoadKind::Force { on, at: Place::Local(at), .. } if *on == link && *at == hinge);
            at && load.pin.is_none() && ends
        })?;
        let pin = mech.pair(pair).name.clone();
        let name = load.name.as_ref().map_or_else(String::new, |name| format!("`{name}` "));
        Some((mech.link(link).name.clone(), pin, name, load.span, span))
    });
    let Some((link, pin, name, load, span)) = noted else { return };
    let it = if name.is_empty() { "the force " } else { &name };
    cx.error(
        Diagnosis::advice(
            "mech::request::load_at_pin",
            format!("{it}acts on `{link}`, whose reaction at {pin} leaves it out"),
        )
        .primary(span, "the reaction is asked for")
        .label(load, format!("acts on `{link}` at its pin"))
        .help(format!("if it loads the pin, write `force {name}at {pin}`")),
    );
}

/// The link as one that carries a force along it and nothing else.
fn bar(cx: &Context<'_>, link: LinkId) -> Result<Bar, Bends> {
    let declared = cx.builder.mech.link(link).span;
    let bends = |why: &str, at: Span| Bends { why: why.to_owned(), at, help: None };
    let mut all = pairs(cx, link)?;
    let hinges = |at: &Acting| matches!(at.what, What::Hinge(_));
    let mut places: Vec<Vec2> = Vec::new();
    for hinge in all.iter().filter(|acting| hinges(acting)) {
        if !places.contains(&hinge.at) {
            places.push(hinge.at);
        }
    }
    let [a, b] = places[..] else {
        let number = if places.len() < 2 { "it has no two hinges" } else { "it has more than two hinges" };
        return Err(bends(number, declared));
    };
    loads(cx, link, &mut all)?;
    others(cx, link, &mut all)?;
    if let Some(between) = all.iter().find(|acting| acting.at != a && acting.at != b) {
        return Err(bends(BETWEEN, span(cx, between.what, declared)));
    }
    let summed = |end: Vec2| all.iter().all(|x| x.at != end || !matches!(x.what, What::Other(_)));
    let (from, to) = match (summed(b), summed(a)) {
        (true, _) => (a, b),
        (_, true) => (b, a),
        _ => {
            let other = all.iter().find(|x| matches!(x.what, What::Other(_)));
            return Err(bends(
                "it is loaded at both ends",
                other.map_or(declared, |x| span(cx, x.what, declared)),
            ));
        }
    };
    let hinge = |end: Vec2| {
        all.iter().find_map(|x| match x.what {
            What::Hinge(pair) if x.at == end => Some(pair),
            _ => None,
        })
    };
    let (Some(first), Some(second)) = (hinge(from), hinge(to)) else {
        return Err(bends("it has no two hinges", declared));
    };
    let at_end = || all.iter().filter(|x| x.at == to).map(|x| x.what);
    Ok(Bar {
        link,
        from: first,
        to: second,
        pairs: at_end()
            .filter_map(|w| if let What::Hinge(p) | What::Slot(p) = w { Some(p) } else { None })
            .collect(),
        loads: at_end().filter_map(|w| if let What::Load(load) = w { Some(load) } else { None }).collect(),
    })
}

fn span(cx: &Context<'_>, what: What, declared: Span) -> Span {
    match what {
        What::Hinge(pair) | What::Slot(pair) => cx.builder.mech.pair(pair).span,
        What::Load(load) => cx.builder.mech.loads.get(load.index()).map_or(declared, |load| load.span),
        What::Other(span) => span,
    }
}

/// The pairs of the link: hinges, and pins in slots.
fn pairs(cx: &Context<'_>, link: LinkId) -> Result<Vec<Acting>, Bends> {
    let mut all = Vec::new();
    for (i, pair) in cx.builder.mech.pairs.iter().enumerate() {
        let id = PairId::at(i);
        if !pair.kind.links().contains(&link) {
            continue;
        }
        let what = match (&pair.kind, cx.builder.mech.point_in(id, link)) {
            (PairKind::Revolute(_), Some(at)) => Acting { at, what: What::Hinge(id) },
            (PairKind::Slot(_), Some(at)) => Acting { at, what: What::Slot(id) },
            (kind, _) => {
                let why = format!("`{}` is {}, and no hinge", pair.name, kind_phrase(kind));
                return Err(Bends { why, at: pair.span, help: None });
            }
        };
        all.push(what);
    }
    Ok(all)
}

/// The loads on the link itself: what acts on a pin is in the force of the pin.
fn loads(cx: &Context<'_>, link: LinkId, all: &mut Vec<Acting>) -> Result<(), Bends> {
    let mech = &cx.builder.mech;
    let turned = |why: &str, at: Span| Err(Bends { why: why.to_owned(), at, help: None });
    for (i, load) in mech.loads.iter().enumerate() {
        match &load.kind {
            LoadKind::InPair { pair, .. } if mech.pair(*pair).kind.links().contains(&link) => {
                return turned("an effort acts in one of its pairs", load.span);
            }
            _ if load.link() != Some(link) || load.pin.is_some() => {}
            LoadKind::Force { at: Place::Local(at), .. } if load.spread.is_none() => {
                all.push(Acting { at: *at, what: What::Load(LoadId::at(i)) });
            }
            LoadKind::ForceAgainstMotion { at: Place::Local(at), .. } => {
                all.push(Acting { at: *at, what: What::Other(load.span) });
            }
            LoadKind::Torque { .. } => return turned("a torque acts on it", load.span),
            _ => return turned(BETWEEN, load.span),
        }
    }
    Ok(())
}

/// Springs, masses and unknown efforts.
fn others(cx: &Context<'_>, link: LinkId, all: &mut Vec<Acting>) -> Result<(), Bends> {
    let mech = &cx.builder.mech;
    let turned = |why: &str, at: Span| Err(Bends { why: why.to_owned(), at, help: None });
    for spring in &mech.springs {
        let ends = [spring.from, spring.to].into_iter().filter(|end| end.0 == link);
        all.extend(ends.map(|(_, at)| Acting { at, what: What::Other(spring.span) }));
    }
    for balance in &mech.balances {
        for place in balance.kind.places() {
            match place {
                // it is in the force of its pin
                BalanceKind::Force { .. } if balance.pin.is_some() => {}
                BalanceKind::Force { on, at: Place::Local(at), .. } if *on == link => {
                    all.push(Acting { at: *at, what: What::Other(balance.span) });
                }
                BalanceKind::Force { on, .. } if *on == link => {
                    return turned(BETWEEN, balance.span);
                }
                BalanceKind::Torque(on) if *on == link => return turned("a torque acts on it", balance.span),
                BalanceKind::InPair(pair) if mech.pair(*pair).kind.links().contains(&link) => {
                    return turned("an effort acts in one of its pairs", balance.span);
                }
                _ => {}
            }
        }
    }
    if mech.balances.is_empty() {
        for drive in mech.drives.iter().filter(|drive| !drive.free) {
            let driven = match drive.target {
                DriveTarget::Link(on) | DriveTarget::Point(on, _) | DriveTarget::Place(on, ..) => on == link,
                DriveTarget::Pair(pair) => mech.pair(pair).kind.links().contains(&link),
            };
            if driven {
                return turned("the effort of the drive acts on it", drive.span);
            }
        }
    }
    let declared = mech.link(link);
    if let Some(mass) = declared.mass.filter(|_| mech.gravity.is_some() || inertia_counts(cx)) {
        let moves = inertia_counts(cx) && mass.inertia > 0.0;
        if moves {
            return turned("its inertia acts on it", declared.span);
        }
        if mass.mass > 0.0 {
            all.push(Acting { at: mass.centre, what: What::Other(declared.span) });
        }
    }
    Ok(())
}
