//! Expressions: names resolved, dimensions checked, constants folded.

mod want;

pub use want::Want;

use super::context::Context;
use crate::math::Vec2;
use crate::model;
use crate::syntax::document::Expr;

impl Context<'_> {
    /// A number that is known before anything is solved: made of numbers, `given` and `let` alone. `what` says what it is
    /// for, as in "the radius of circle `roller`". Reports what does not fit.
    pub fn scalar_constant(&mut self, expr: &Expr, want: &Want, what: &str) -> Option<f64> {
        let _ = (expr, want, what);
        todo!()
    }

    /// A vector that is known before anything is solved; `want` is the dimension of its components.
    pub fn vector_constant(&mut self, expr: &Expr, want: &Want, what: &str) -> Option<Vec2> {
        let _ = (expr, want, what);
        todo!()
    }

    /// A number that may hang on results of the pose. What is known already is folded to `Expr::Constant`.
    /// `None` where there is an error or something that cannot be solved yet; both are noted.
    pub fn scalar(&mut self, expr: &Expr, want: &Want, what: &str) -> Option<model::Expr> {
        let _ = (expr, want, what);
        todo!()
    }

    /// A vector that may hang on results of the pose.
    pub fn vector(&mut self, expr: &Expr, want: &Want, what: &str) -> Option<model::Expr> {
        let _ = (expr, want, what);
        todo!()
    }

    /// A truth that may hang on results of the pose.
    pub fn truth(&mut self, expr: &Expr, what: &str) -> Option<model::Expr> {
        let _ = (expr, what);
        todo!()
    }

    /// As `scalar`, but made of nothing that needs a pose: constants, `dead`, `stroke`, `time_ratio`. For drives and poses.
    pub fn poseless_scalar(&mut self, expr: &Expr, want: &Want, what: &str) -> Option<model::Expr> {
        let _ = (expr, want, what);
        todo!()
    }

    /// As `vector`, but made of nothing that needs a pose.
    pub fn poseless_vector(&mut self, expr: &Expr, want: &Want, what: &str) -> Option<model::Expr> {
        let _ = (expr, want, what);
        todo!()
    }

    /// Whether the expression is a vector (or a pair `(0, 0)`), for places that take either. `None` where it has an error,
    /// which is reported. Nothing is reported twice when the expression is then read by `scalar` or `vector`.
    pub fn is_vector(&mut self, expr: &Expr) -> Option<bool> {
        let _ = expr;
        todo!()
    }
}
