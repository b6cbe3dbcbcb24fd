//! Expressions: names resolved, dimensions checked, constants folded.

pub mod by_time;
pub mod context;
pub mod curve;
pub mod factor;
pub mod fit;
pub mod function;
pub mod named;
pub mod number;
pub mod other_unit;
pub mod positive;
pub mod property;
pub mod read;
pub mod results;

use crate::expr::{
    context::{Context, not_constant},
    positive::Want,
};
use crate::values::{
    fold,
    typed::{Dim, Type, Typed},
};
use assur_math::math::Vec2;
use assur_model::model;
use assur_syntax::document::Expr;
use assur_text::diagnostic::Diagnosis;
use assur_text::units::Dimension;

impl Context<'_> {
    /// A number that is known before anything is solved: made of numbers, `given` and `let` alone. `what` says what it is
    /// for, as in "the radius of circle `roller`". Reports what does not fit.
    pub fn scalar_constant(&mut self, expr: &Expr, want: &Want, what: &str) -> Option<f64> {
        let t = self.constant(expr, what)?;
        let t = self.fit(t, want.0, what, expr)?;
        fold::scalar(&t.expr)
    }

    /// A number that is known before anything is solved, with that of several dimensions which it has. One of another
    /// dimension is reported against the first.
    pub fn scalar_of_one(
        &mut self,
        expr: &Expr,
        wants: &[Dimension],
        what: &str,
    ) -> Option<(f64, Dimension)> {
        let t = self.constant(expr, what)?;
        let has =
            |want: &&Dimension| matches!(t.ty, Type::Number(dim) if dim.unify(Dim::Of(**want)).is_some());
        let want = *wants.iter().find(has).or(wants.first())?;
        let t = self.fit(t, want, what, expr)?;
        Some((fold::scalar(&t.expr)?, want))
    }

    /// A vector that is known before anything is solved; `want` is the dimension of its components.
    pub fn vector_constant(&mut self, expr: &Expr, want: &Want, what: &str) -> Option<Vec2> {
        let t = self.constant(expr, what)?;
        let t = self.fit_vector(t, want.0, what, expr)?;
        fold::vector(&t.expr)
    }

    /// A number that may depend on results of the pose. What is known already is folded to `Expr::Constant`.
    /// `None` where there is an error or something that cannot be solved yet; both are noted.
    pub fn scalar(&mut self, expr: &Expr, want: &Want, what: &str) -> Option<model::Expr> {
        let t = self.read(expr)?;
        self.fit(t, want.0, what, expr).and_then(solvable)
    }

    /// A vector that may depend on results of the pose.
    pub fn vector(&mut self, expr: &Expr, want: &Want, what: &str) -> Option<model::Expr> {
        let t = self.read(expr)?;
        self.fit_vector(t, want.0, what, expr).and_then(solvable)
    }

    /// A condition that may depend on results of the pose.
    pub fn condition(&mut self, expr: &Expr, what: &str) -> Option<model::Expr> {
        let t = self.read(expr)?;
        self.fit_condition(t, what, expr).and_then(solvable)
    }

    /// As `scalar`, but made of nothing that needs a pose: constants, `dead`, `stroke`, `time_ratio`. For drives and
    /// poses.
    pub fn poseless_scalar(&mut self, expr: &Expr, want: &Want, what: &str) -> Option<model::Expr> {
        let found = self.scalar(expr, want, what)?;
        self.without_pose(found, expr, what)
    }

    /// As `poseless_scalar`, or made of the instant of a motion and nothing else that needs a pose.
    pub fn timed_scalar(&mut self, expr: &Expr, want: &Want, what: &str) -> Option<model::Expr> {
        let found = self.scalar(expr, want, what)?;
        self.timed(found, expr, what)
    }

    /// The same of a vector.
    pub fn timed_vector(&mut self, expr: &Expr, want: &Want, what: &str) -> Option<model::Expr> {
        let found = self.vector(expr, want, what)?;
        self.timed(found, expr, what)
    }

    fn timed(&mut self, found: model::Expr, expr: &Expr, what: &str) -> Option<model::Expr> {
        let inlined = self.inline(&found, expr.span)?;
        let (mut timed, mut other) = (false, false);
        inlined.queries(&mut |query| match query {
            model::Query::Time => timed = true,
            _ => other = true,
        });
        if timed && !other { Some(inlined) } else { self.without_pose(found, expr, what) }
    }

    /// As `vector`, but made of nothing that needs a pose.
    pub fn poseless_vector(&mut self, expr: &Expr, want: &Want, what: &str) -> Option<model::Expr> {
        let found = self.vector(expr, want, what)?;
        self.without_pose(found, expr, what)
    }

    /// What the expression is: a number or a vector, for places that take either. `None` where it has an error, which is
    /// reported; do not read it again then.
    pub fn is_vector(&mut self, expr: &Expr) -> Option<bool> {
        self.read(expr).map(|t| matches!(t.ty, Type::Vector(_)))
    }

    fn without_pose(&mut self, found: model::Expr, expr: &Expr, what: &str) -> Option<model::Expr> {
        let found = self.inline(&found, expr.span)?;
        // these are found from the solved mechanism
        let mut of_solution = false;
        found.queries(&mut |q| of_solution |= q.facts().of_solution);
        if of_solution || !self.values.definitions.is_poseless(&found) {
            self.error(
                Diagnosis::error(
                    "mech::request::needs_pose",
                    format!("{what} cannot depend on computed results"),
                )
                .primary(expr.span, "differs from pose to pose")
                .help(
                    "use numbers, `given`, `let`, `dead(…)` and `stroke(…)`: this value \
                     determines the poses",
                ),
            );
            return None;
        }
        Some(found)
    }

    fn constant(&mut self, expr: &Expr, what: &str) -> Option<Typed> {
        if let Some((span, result)) = self.values.definitions.first_result(&self.names, expr) {
            self.error(not_constant(what, &result, span));
            return None;
        }
        self.read(expr).filter(|t| !t.pending)
    }
}

/// What stands for nothing that cannot be solved yet.
fn solvable(t: Typed) -> Option<model::Expr> {
    (!t.pending).then_some(t.expr)
}
