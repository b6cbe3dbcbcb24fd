//! `internal(beam, 1.2 m).M`, `max(internal(beam).M)`, `find internal(beam) in 12 steps`: forces inside a link.

use crate::expr::context::Context;
use crate::expr::positive::Want;
use crate::expr::read::no_part;
use crate::expr::results::{Call, Sign};
use crate::loads::mass::inertia_counts;
use crate::motion::drive::wrong_steps;
use crate::output::hinges::Inside;
use crate::requests::query::not_a_quantity;
use crate::values::format_value::{digits, format_value};
use crate::values::typed::{Type, Typed};
use assur_model::model::{
    AlongLink, Cut, CycleFunction, Expr as ModelExpr, FindKind, Internal, InternalPart, LinkId, Query, Table,
    TableEntry,
};
use assur_syntax::document::{Arg, Expr, ExprKind, FindItem, Member, Name, Statement};
use assur_text::diagnostic::Diagnosis;
use assur_text::language::Function;
use assur_text::source::Span;
use assur_text::units::Dimension;

/// The most steps of a table.
const MOST_STEPS: usize = 1000;
/// A place this part of the length beyond an end is the end.
const ROUNDING: f64 = 1e-9;

const fn dimension(part: InternalPart) -> Dimension {
    match part {
        InternalPart::Normal | InternalPart::Shear => Dimension::FORCE,
        InternalPart::Moment => Dimension::TORQUE,
    }
}

fn query(link: LinkId, part: InternalPart, at: Cut) -> ModelExpr {
    ModelExpr::Query(Query::Internal(Internal { link, part, at }))
}

impl Context<'_> {
    /// `internal(beam, 1.2 m).M`
    pub(crate) fn internal(&mut self, call: Call<'_>, part: &Name) -> Option<Typed> {
        let args = self.arguments(call, 1, 2)?;
        let (link, which) = (self.link_argument(call, args[0]), self.internal_part(part));
        let Some(at) = args.get(1) else {
            let link = self.builder.mech.link(link?).name.clone();
            let path = format!("internal({link}).{}", part.node);
            let help = format!(
                "name the cut, as in `internal({link}, 0.2 m).{0}`, or ask for `max({path})`",
                part.node
            );
            let span = Span { start: call.span.start, end: part.span.end };
            self.error(not_a_quantity(&path, span, Some(help)));
            return None;
        };
        let x = self.scalar_constant(at, &Want::LENGTH, "the place of the cut");
        let (link, which, x) = (link?, which?, x?);
        self.builder.inside.push(Inside { link, span: args[0].span, cut: Some((x, at.span)) });
        Some(Typed::new(query(link, which, Cut::At(x)), Type::number(dimension(which))))
    }

    fn internal_part(&mut self, part: &Name) -> Option<InternalPart> {
        let known = InternalPart::ALL.into_iter().find(|known| known.name() == part.node);
        if known.is_none() {
            let help =
                "its parts are `.N`, the normal force, `.Q`, the shear force, and `.M`, the bending moment";
            self.error(no_part(&part.node, part.span, Some(help.to_owned())));
        }
        known
    }

    /// The forces inside a link without one of their parts.
    pub(crate) fn internal_alone(&mut self, call: Call<'_>) -> Option<Typed> {
        let args = self.arguments(call, 1, 2)?;
        let link = self.link_argument(call, args[0])?;
        let link = &self.builder.mech.link(link).name;
        let help = format!(
            "ask for a part, as in `internal({link}, 0.2 m).M` or `max(internal({link}).M)`; or for a table: `find … in 12 \
             steps`"
        );
        self.error(not_a_quantity("internal(…)", call.span, Some(help)));
        None
    }

    /// `max(internal(beam).M)` along the link; `None` where the argument asks something else.
    pub(crate) fn along_link(
        &mut self,
        call: Call<'_>,
        how: CycleFunction,
        least: bool,
    ) -> Option<Option<Typed>> {
        let [Arg { name: None, value }] = call.args else { return None };
        let ExprKind::Member(base, part) = &value.kind else { return None };
        let (inner, [_]) = self.is_internal(base)? else { return None };
        let along = match how {
            CycleFunction::Max => AlongLink { greatest: true, place: false },
            CycleFunction::Min => AlongLink { greatest: false, place: false },
            CycleFunction::Argmax => AlongLink { greatest: !least, place: true },
            _ => return None,
        };
        let (link, which) = (self.link_argument(inner, &inner.args[0].value), self.internal_part(part));
        let (Some(link), Some(which)) = (link, which) else { return Some(None) };
        self.builder.inside.push(Inside { link, span: inner.args[0].value.span, cut: None });
        let dimension = if along.place { Dimension::LENGTH } else { dimension(which) };
        Some(Some(Typed::new(query(link, which, Cut::Extreme(along)), Type::number(dimension))))
    }

    /// A call of this function, where the file has no curve of its name.
    fn is_internal<'e>(&self, expr: &'e Expr) -> Option<(Call<'e>, &'e [Arg])> {
        let ExprKind::Call { function, args } = &expr.kind else { return None };
        let own =
            Function::named(&function.node) == Some(Function::Internal) && !self.is_curve(&function.node);
        own.then(|| (Call { name: function, args, span: expr.span, sign: Sign::Matters }, &args[..]))
    }

    /// `find internal(beam) in 12 steps`; `None` where the item asks no such table.
    pub(crate) fn internal_table(&mut self, item: &FindItem) -> Option<Option<FindKind>> {
        let (call, [link]) = self.is_internal(&item.value)? else { return None };
        let steps = item.steps.as_ref().filter(|_| item.name.is_none())?;
        Some(self.table_along(call, &link.value, steps, item))
    }

    fn table_along(
        &mut self,
        call: Call<'_>,
        link: &Expr,
        steps: &Expr,
        item: &FindItem,
    ) -> Option<FindKind> {
        let count = self.scalar_constant(steps, &Want::NUMBER, "the number of steps");
        let (of, count) = (self.link_argument(call, link)?, count?);
        if count.fract() != 0.0 || !(1.0..=MOST_STEPS as f64).contains(&count) {
            self.error(wrong_steps(&digits(count), MOST_STEPS, steps.span));
            return None;
        }
        if let Some(unit) = &item.unit {
            let help = Some("leave out `as …`: each column has a unit of its own".to_owned());
            self.error(not_a_quantity("a table", unit.span, help));
            return None;
        }
        self.builder.inside.push(Inside { link: of, span: link.span, cut: None });
        let [begin, end] = self.builder.mech.link(of).extent();
        let at = |i: usize| begin + (end - begin) * (i as f64 / count);
        let places: Vec<f64> = (0..=count as usize).map(at).collect();
        let column = |part: InternalPart| TableEntry {
            name: part.name().to_owned(),
            display: self.values.display(dimension(part)),
            values: Vec::new(),
            found: places.iter().map(|x| query(of, part, Cut::At(*x))).collect(),
        };
        let parts = InternalPart::ALL.map(column);
        let x = TableEntry {
            name: "x".to_owned(),
            display: self.values.display(Dimension::LENGTH),
            values: places,
            found: Vec::new(),
        };
        Some(FindKind::Table(Table { entries: std::iter::once(x).chain(parts).collect(), upright: false }))
    }
}

/// Reports cuts beside their links, and masses whose spread is not known. Only once all links and drives are in the mechanism.
pub(crate) fn inside(cx: &mut Context<'_>) {
    let mut asked = std::mem::take(&mut cx.builder.inside);
    if !cx.pairs_complete() {
        return;
    }
    asked.sort_by_key(|inside| inside.span.start);
    asked.dedup_by_key(|inside| (inside.span, inside.cut));
    let mut spread: Vec<LinkId> = Vec::new();
    for Inside { link, span, cut } in asked {
        let of = cx.builder.mech.link(link);
        let (name, [begin, end], axis) = (of.name.clone(), of.extent(), of.axis());
        let first = of.points.first().map_or_else(String::new, |point| point.name.clone());
        let reactions = "ask for the forces in its pairs: `find reactions`";
        let message = if link == LinkId::GROUND {
            Some(("the ground is fixed, and carries everything".to_owned(), reactions))
        } else if axis.is_none() {
            let why = format!("no two points of `{name}` are on its x axis, and not all are on another line");
            Some((why, "give it two points on the line along which it is cut: `A (0, 0); B (2 m, 0)`"))
        } else {
            (begin == end).then(|| (format!("`{name}` has no length: its points are one place"), reactions))
        };
        if let Some((message, help)) = message {
            cx.error(
                Diagnosis::error(CODE, message)
                    .primary(span, "the forces inside it are asked for")
                    .help(help),
            );
            continue;
        }
        if let Some((x, at)) = cut {
            let slack = ROUNDING * (end - begin);
            if !(begin - slack..=end + slack).contains(&x) {
                let [x, begin, end] = [x, begin, end].map(|x| format_value(x, Dimension::LENGTH));
                let on_x = axis.is_some_and(|(from, along)| from.norm() == 0.0 && along.y == 0.0);
                let (line, origin) = if on_x {
                    ("its x axis", "the origin of the link".to_owned())
                } else {
                    ("the line of its points", format!("its point `{first}`"))
                };
                let message =
                    format!("{x} is not on `{name}`, which goes from {begin} to {end} along {line}");
                let help = format!("write a place between {begin} and {end}, from {origin}");
                cx.error(Diagnosis::error(CODE, message).primary(at, x).help(help));
            }
        }
        if !spread.contains(&link) {
            spread.push(link);
            spread_of(cx, link, span);
        }
    }
}

const CODE: &str = "mech::request::inside";

/// Reports a moment of inertia that is not said to be anywhere.
fn spread_of(cx: &mut Context<'_>, link: LinkId, span: Span) {
    let of = cx.builder.mech.link(link);
    if !inertia_counts(cx) || of.mass.is_none_or(|mass| mass.inertia == 0.0) {
        return;
    }
    let members = cx.doc.statements.iter().find_map(|statement| match &statement.node {
        Statement::Link(written) if written.name.node == of.name => Some(&written.body),
        _ => None,
    });
    let inertia = members.into_iter().flatten().find(|member| matches!(member.node, Member::Inertia(_)));
    let Some(at) = inertia.map(|member| member.span) else { return };
    let ends = |first: bool| {
        let by_x = |a: &&assur_model::model::Point, b: &&assur_model::model::Point| a.at.x.total_cmp(&b.at.x);
        let points = of.points.iter();
        if first { points.min_by(by_x) } else { points.max_by(by_x) }
    };
    let rod = ends(true).zip(ends(false)).map(|(a, b)| format!("{} to {}", a.name, b.name));
    let rod = rod.unwrap_or_else(|| "A to B".to_owned());
    let help = format!(
        "write how the mass is spread, as in `mass 3 kg rod {rod}`; or masses at their points, as in `mass 3 kg at S inertia \
         0.04 kg*m^2`"
    );
    let message = format!("where the mass of `{}` is along the link is not known", of.name);
    cx.error(
        Diagnosis::error(CODE, message)
            .primary(span, "the forces inside it are asked for")
            .label(at, "is of the whole link")
            .help(help),
    );
}
