//! Which of the possible poses is meant.

use crate::expr::context::Context;
use crate::expr::positive::Want;
use crate::expr::property::given_twice;
use crate::links::lookup::{is_pair, place_of_pair};
use crate::motion::drive::{coordinate, no_coordinate};
use crate::statements::written::text;
use assur_model::model;
use assur_model::model::{Hint, HintKind, LinkPoint, PairId, PairKind, Positions, Query};
use assur_syntax::document::{AssembleClause, CompareOp, Expr, Order, Path, Side, Statement};
use assur_text::diagnostic::{Diagnosis, Fix};
use assur_text::language::properties_of_pair;

/// Enters all clauses of `assemble` into the mechanism.
pub(crate) fn hints(cx: &mut Context<'_>) {
    let doc = cx.doc;
    for statement in &doc.statements {
        let Statement::Assemble(assemble) = &statement.node else { continue };
        for clause in &assemble.clauses {
            if let Some(kind) = hint(cx, &clause.node) {
                cx.builder.mech.hints.push(Hint { span: clause.span, kind });
            }
        }
    }
    near_with_dead(cx);
}

/// `k phase 40 deg`: as the property of the transmission.
fn set_phase(cx: &mut Context<'_>, what: &Path, phase: &Expr) -> Option<()> {
    let value = cx.scalar_constant(phase, &Want::ANGLE, "the phase of wheels");
    let pair = cx.pair(&what.head)?;
    let declared = cx.builder.mech.pair(pair);
    let (span, name) = (declared.span, declared.name.clone());
    let of_wheels = match &declared.kind {
        PairKind::Transmission(t) => {
            let two = t.links.len() == 2 && t.bevel.is_none();
            two && properties_of_pair(t.kind.statement()).iter().any(|p| p.name == "phase")
        }
        _ => false,
    };
    if !of_wheels || what.tail.is_some() {
        cx.error(
            Diagnosis::error("mech::geometry::no_phase", format!("`{name}` has no phase"))
                .primary(what.span(), "not a mesh, a belt or a chain")
                .label(span, "declared here")
                .help(
                    "name a mesh, a belt or a chain: `assemble k phase 40 deg`; for links and points see \
                     `near`, `left of` and `> 0`",
                ),
        );
        return None;
    }
    let value = value?;
    let PairKind::Transmission(transmission) = &mut cx.builder.mech.pairs[pair.index()].kind else {
        return None;
    };
    let law = transmission.laws.first_mut()?;
    if law.constant != 0.0 {
        let again = "its phase".to_owned();
        cx.error(given_twice(&again, what.span(), span));
        return None;
    }
    law.constant = law.terms.get(1)?.1 * value;
    Some(())
}

/// `near` holds for the first pose, which is not known where the drive begins at a dead position: that is found from the
/// assembly.
fn near_with_dead(cx: &mut Context<'_>) {
    let near = cx.builder.mech.hints.iter().filter(|h| matches!(h.kind, HintKind::Near { .. }));
    let near = near.map(|h| h.span).collect::<Vec<_>>();
    let dead = cx.builder.mech.drives.iter().find(|d| {
        let mut found = false;
        let mut look = |e: &model::Expr| e.queries(&mut |query| found |= !matches!(query, Query::Time));
        match &d.positions {
            Positions::None | Positions::Numbers(_) => {}
            Positions::List(values) => values.iter().for_each(look),
            Positions::Range { from, to, .. } => [from, to].into_iter().for_each(&mut look),
        }
        found
    });
    let Some((drive, drive_span)) = dead.map(|d| (d.name.clone(), d.span)) else { return };
    for span in near {
        cx.error(
            Diagnosis::error(
                "mech::geometry::near_with_dead",
                format!("`near` needs a known first pose, but `{drive}` begins at a dead position"),
            )
            .primary(span, "refers to the first pose")
            .label(drive_span, "depends on `dead`, `stroke` or `time_ratio`")
            .help(
                "choose the assembly by `left of`, `ahead of` or a sign, as in `assemble s > 0`: it \
                 must be known before the dead position is found",
            ),
        );
    }
}

fn hint(cx: &mut Context<'_>, clause: &AssembleClause) -> Option<HintKind> {
    match clause {
        AssembleClause::Near { what, at } => {
            let point = point(cx, what);
            let place = cx.vector_constant(at, &Want::LENGTH, "the point after `near`");
            Some(HintKind::Near { point: point?, place: place? })
        }
        AssembleClause::Phase { what, phase } => {
            set_phase(cx, what, phase);
            None
        }
        AssembleClause::Side { what, side, from, to } => {
            let points = (point(cx, what), point(cx, from), point(cx, to));
            let (point, start, end) = (points.0?, points.1?, points.2?);
            if start == end || cx.builder.joined_with(start).contains(&end) {
                let span = from.span().to(to.span());
                let name = text(from);
                cx.error(
                    Diagnosis::error(
                        "mech::geometry::no_direction",
                        format!("from `{name}` towards `{name}` there is no direction"),
                    )
                    .label(span, "the same point")
                    .help("name two different points: `C left of B-D` looks from B towards D"),
                );
                return None;
            }
            Some(HintKind::Side { point, from: start, to: end, left: side.node == Side::Left })
        }
        AssembleClause::Order { what, order, than } => {
            let (first, other) = (point(cx, what), point(cx, than));
            let (point, other) = (first?, other?);
            let pair = guide(cx, what, than, order.node, point, other)?;
            Some(HintKind::Along { point, other, pair, ahead: order.node == Order::Ahead })
        }
        AssembleClause::Sign { what, op, bound } => sign(cx, what, op.node, bound),
    }
}

fn sign(cx: &mut Context<'_>, what: &Path, op: CompareOp, bound: &Expr) -> Option<HintKind> {
    if what.tail.is_some() {
        cx.error(no_coordinate(
            &text(what),
            "a point",
            "compare a pair: `s > 0`; for a point write `near`, `left of` or `ahead of`",
            what.span(),
        ));
        return None;
    }
    let (pair, moves) = coordinate(cx, &what.head)?;
    let name = format!("the bound of `{}`", what.head.node);
    let bound = cx.scalar_constant(bound, &Want(moves.dimension(0)), &name)?;
    let greater = matches!(op, CompareOp::Greater | CompareOp::GreaterOrEqual);
    Some(HintKind::Coordinate { pair, bound, greater })
}

/// `L.P`, a pair's pin or named point, or a point name shared by links that are joined there.
fn point(cx: &mut Context<'_>, path: &Path) -> Option<LinkPoint> {
    let head = &path.head;
    if let Some(tail) = &path.tail {
        let link = cx.link(head)?;
        return cx.point(link, tail).map(|at| (link, at));
    }
    if !cx.names.things.get(&head.node).is_some_and(|d| is_pair(d.what)) {
        return cx.point_of_shared_name(head);
    }
    let pair = cx.pair(head)?;
    let kind = &cx.builder.mech.pair(pair).kind;
    let place = place_of_pair(kind);
    if place.is_none() {
        let is = if matches!(kind, PairKind::Cylinder { .. }) { "a cylinder" } else { "a contact" };
        let link = kind.links().last().map(|l| cx.builder.mech.link(*l));
        let point = link.and_then(|l| l.points.first().map(|p| format!("{}.{}", l.name, p.name)));
        let example = point.unwrap_or_else(|| "rod.C".into());
        cx.error(
            Diagnosis::error(
                "mech::geometry::no_single_point",
                format!("`{}` is {is}, which has no single point", head.node),
            )
            .label(head.span, "the point is not clear")
            .help(format!("name a point of a link, as in `{example}`"))
            .fixes(Fix::quoted(&format!("write `{example}`"), head.span)),
        );
    }
    place
}

/// The prismatic pair on whose guide a point slides; of the point itself, or else of its link.
fn guide(
    cx: &mut Context<'_>,
    what: &Path,
    than: &Path,
    order: Order,
    point: LinkPoint,
    other: LinkPoint,
) -> Option<PairId> {
    if let Some(pair) = slides(cx, point) {
        return Some(pair);
    }
    if !cx.pairs_complete() {
        return None;
    }
    let help = match (slides(cx, other), order) {
        (Some(_), Order::Ahead) => format!("reverse it: `{} behind {}`", text(than), text(what)),
        (Some(_), Order::Behind) => format!("reverse it: `{} ahead of {}`", text(than), text(what)),
        _ => format!("write `{0} left of …`, or give its position: `{0} near (100 mm, 0)`", text(what)),
    };
    cx.error(
        Diagnosis::error(
            "mech::geometry::no_guide",
            format!("`ahead` and `behind` need a guide, and `{}` slides on none", text(what)),
        )
        .label(what.span(), "not the point of a prismatic pair")
        .help(help),
    );
    None
}

fn slides(cx: &Context<'_>, point: LinkPoint) -> Option<PairId> {
    let joined = cx.builder.joined_with(point);
    let mut pairs = joined.iter().flat_map(|j| cx.builder.hinges.guided(j.0)).copied().collect::<Vec<_>>();
    pairs.sort_unstable();
    let on_point = pairs.iter().find(|pair| match &cx.builder.mech.pair(**pair).kind {
        PairKind::Prismatic(guide) => joined.contains(&(guide.slider, guide.point)),
        _ => false,
    });
    on_point.or(pairs.first()).copied()
}
