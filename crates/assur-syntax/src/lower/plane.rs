//! `plane v` in a link: the plane of its masses where v is a length, a point of that name where it is a vector.

use crate::document::{Body, Expr, ExprKind, Member, PointMember, Statement};
use assur_text::source::{Span, Spanned};
use std::collections::HashSet;

/// Makes points of the planes whose values are vectors.
pub(super) fn points(statements: &mut [Spanned<Statement>]) {
    let mut vectors: HashSet<String> = HashSet::new();
    for statement in &*statements {
        if let Statement::Given(one) | Statement::Let(one) = &statement.node
            && is_vector(&one.value, &vectors)
        {
            vectors.insert(one.name.node.clone());
        }
    }
    if vectors.is_empty() {
        return;
    }
    for statement in statements {
        match &mut statement.node {
            Statement::Link(link) => of_body(&mut link.body, &vectors),
            Statement::Ground(ground) => of_body(&mut ground.body, &vectors),
            _ => {}
        }
    }
}

fn of_body(body: &mut Body, vectors: &HashSet<String>) {
    for member in body {
        if let Member::Plane(at) = &member.node
            && is_vector(at, vectors)
        {
            let word = "plane";
            let name =
                Spanned::new(word.to_owned(), Span::new(member.span.start, member.span.start + word.len()));
            member.node = Member::Point(PointMember { name, at: at.clone() });
        }
    }
}

/// Whether a vector is written there, or named.
fn is_vector(expr: &Expr, vectors: &HashSet<String>) -> bool {
    match &expr.kind {
        ExprKind::Vector(..) | ExprKind::Polar(..) => true,
        ExprKind::Name(name) => vectors.contains(name),
        ExprKind::Unary(_, of) => is_vector(of, vectors),
        ExprKind::Chain(first, rest) => {
            std::iter::once(&**first).chain(rest.iter().map(|(_, e)| e)).any(|e| is_vector(e, vectors))
        }
        _ => false,
    }
}
