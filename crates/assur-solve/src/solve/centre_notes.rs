//! Collects instant centres that are asked for where nothing turns, and curvatures of paths where there is none.

use super::note::Note;
use crate::answer::PoseAnswers;
use crate::model::{Expr, FindKind, Mechanism, Query};
use crate::position::{PoseOrigin, PoseRequest};

/// The centres that are asked for, and where they have no value.
#[derive(Debug, Default)]
pub(super) struct CentreNotes(Vec<CentreRequest>);

#[derive(Debug)]
struct CentreRequest {
    find: usize,
    of: Query,
    /// The first position without a value, and how many more there are.
    without: Option<(PoseRequest, usize)>,
}

impl CentreNotes {
    pub(super) fn of(mechanism: &Mechanism) -> Self {
        let mut asked: Vec<CentreRequest> = Vec::new();
        let finds = if is_asked(mechanism) { mechanism.finds.as_slice() } else { &[] };
        for (find, item) in finds.iter().enumerate() {
            let FindKind::Value { expr, .. } = &item.kind else { continue };
            each(mechanism, expr, &mut |of| {
                if !asked.iter().rev().take_while(|a| a.find == find).any(|a| a.of == of) {
                    asked.push(CentreRequest { find, of, without: None });
                }
            });
        }
        Self(asked)
    }

    /// None is asked for.
    pub(super) const fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Looks at the answers of a position.
    pub(super) fn update(&mut self, view: &PoseAnswers<'_>, pose: &PoseRequest) {
        if matches!(pose.origin, PoseOrigin::Expected(_)) {
            return;
        }
        for asked in &mut self.0 {
            if view.query(&asked.of).is_defined() {
                continue;
            }
            match &mut asked.without {
                Some((_, more)) => *more += 1,
                None => asked.without = Some((pose.clone(), 0)),
            }
        }
    }

    /// All that was found.
    pub(super) fn into_notes(self) -> impl Iterator<Item = Note> {
        self.0.into_iter().filter_map(|CentreRequest { find, of, without }| {
            without.map(|(pose, more)| Note::NoCentre { find, of, pose, more })
        })
    }
}

const fn is_centre(query: &Query) -> bool {
    matches!(query, Query::Turning(..) | Query::CurvatureRadius(_) | Query::CurvatureCentre(_))
}

/// Whether any answer or quantity is made of such a centre.
fn is_asked(mechanism: &Mechanism) -> bool {
    let finds = mechanism.finds.iter().filter_map(|find| match &find.kind {
        FindKind::Value { expr, .. } => Some(expr),
        _ => None,
    });
    let mut found = false;
    for expr in finds.chain(mechanism.quantities.iter().map(|quantity| &quantity.expr)) {
        expr.queries(&mut |query| found |= is_centre(query));
    }
    found
}

/// The centres of an expression and of the quantities in it, each quantity read once.
fn each(mechanism: &Mechanism, expr: &Expr, visit: &mut impl FnMut(Query)) {
    let mut read = vec![false; mechanism.quantities.len()];
    let mut open = vec![expr];
    while let Some(expr) = open.pop() {
        expr.parts(&mut |part| match part {
            Expr::Query(query) if is_centre(query) => visit(*query),
            Expr::Quantity(id) if !read[id.index()] => {
                read[id.index()] = true;
                open.push(&mechanism.quantities[id.index()].expr);
            }
            _ => {}
        });
    }
}
