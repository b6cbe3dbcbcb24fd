//! Arguments that name things.

use crate::expr::context::Context;
use crate::expr::results::Call;
use crate::links::lookup::kind_phrase;
use crate::names::declared::ThingKind;
use assur_math::math::Vec2;
use assur_model::model::{LinkId, PairId};
use assur_syntax::document::{Expr, ExprKind, Name, Path};
use assur_text::diagnostic::Diagnosis;
use assur_text::source::{Span, Spanned};

/// What turns or moves.
pub enum Mover {
    /// A link, a shaft, or the link or shaft of a wheel.
    Link(LinkId),
    /// A slider on a rope.
    Slider,
}

/// `a.b.c` as its names.
pub fn path(expr: &Expr) -> Option<Vec<Name>> {
    match &expr.kind {
        ExprKind::Name(name) => Some(vec![Spanned::new(name.clone(), expr.span)]),
        ExprKind::Member(base, part) => {
            let mut names = path(base)?;
            names.push(part.clone());
            Some(names)
        }
        _ => None,
    }
}

/// Two names as the one of a cylinder's link.
fn joined(head: &Name, tail: &Name) -> Name {
    Spanned::new(format!("{}.{}", head.node, tail.node), head.span.to(tail.span))
}

impl Context<'_> {
    /// Notes the names of an argument that no other function looks up: a drive, a slider, the end of a rope.
    pub(crate) fn note_names(&mut self, expr: &Expr) {
        if let Some([head, tail @ ..]) = path(expr).as_deref() {
            self.names.note_path(&Path { head: head.clone(), tail: tail.first().cloned() });
        }
    }

    /// An argument that names what moves.
    pub(crate) fn mover(&mut self, call: Call<'_>, expr: &Expr) -> Option<Mover> {
        let names = path(expr);
        match names.as_deref() {
            Some([name]) => {
                self.names.note_thing(name);
                if self.names.things.get(&name.node).is_some_and(|d| d.what == ThingKind::Slider) {
                    return Some(Mover::Slider);
                }
                self.link(name).map(Mover::Link)
            }
            Some([head, tail]) => self.link_of_cylinder(head, tail, call).map(Mover::Link),
            _ => {
                self.wrong_argument(call, "a link", expr.span);
                None
            }
        }
    }

    /// An argument that names a link of the linkage.
    pub(crate) fn link_argument(&mut self, call: Call<'_>, expr: &Expr) -> Option<LinkId> {
        match self.mover(call, expr)? {
            Mover::Link(link) => Some(link),
            Mover::Slider => self.find_link(&path(expr)?.first()?.node),
        }
    }

    fn link_of_cylinder(&mut self, head: &Name, tail: &Name, call: Call<'_>) -> Option<LinkId> {
        self.names.note_thing(head);
        let name = joined(head, tail);
        if let Some(link) = self.find_link(&name.node) {
            return Some(link);
        }
        if self.names.things.contains_key(&head.node) || self.names.bad.contains(&head.node) {
            if self.find_pair(&head.node).is_some() || self.find_link(&head.node).is_some() {
                self.wrong_argument(call, "a link", name.span);
            }
            return None;
        }
        self.link(head);
        None
    }

    /// An argument that names a point: `rod.C`, or a name alone that stands for one point.
    pub(crate) fn point_argument(&mut self, call: Call<'_>, expr: &Expr) -> Option<(LinkId, Vec2)> {
        let names = path(expr);
        match names.as_deref() {
            Some([name]) => self.point_of_shared_name(name),
            Some([head, tail]) => {
                if self.find_link(&joined(head, tail).node).is_some() {
                    self.wrong_argument(call, "a point", expr.span);
                    return None;
                }
                let link = self.link(head)?;
                self.point(link, tail).map(|at| (link, at))
            }
            Some([head, middle, tail]) => {
                let link = self.link_of_cylinder(head, middle, call)?;
                self.point(link, tail).map(|at| (link, at))
            }
            _ => {
                self.wrong_argument(call, "a point", expr.span);
                None
            }
        }
    }

    /// An argument that names a pair.
    pub(crate) fn pair_argument(&mut self, call: Call<'_>, expr: &Expr) -> Option<PairId> {
        match path(expr).as_deref() {
            Some([name]) => self.pair(name),
            _ => {
                self.wrong_argument(call, "a pair", expr.span);
                None
            }
        }
    }

    /// Reports a result that this kind of pair has not.
    pub(crate) fn not_of_this_pair(&mut self, call: Call<'_>, pair: PairId, help: Option<&str>) {
        let declared = self.builder.mech.pair(pair);
        let (pair, kind, declared) =
            (declared.name.clone(), kind_phrase(&declared.kind).to_owned(), declared.span);
        self.error(
            Diagnosis::error(
                "mech::request::not_of_this_pair",
                format!("`{}` is not defined for `{pair}`, {kind}", call.name.node),
            )
            .primary(call.span, "this question")
            .label(declared, "declared here")
            .help_if(help.map(str::to_owned)),
        );
    }

    /// Where a pair is declared.
    pub(crate) fn pair_span(&self, pair: PairId) -> Span {
        self.builder.mech.pair(pair).span
    }
}
