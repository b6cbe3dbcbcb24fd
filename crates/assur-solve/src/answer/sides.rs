//! Expressions that are not smooth, taken on one side of their corners: a condition stays as it is, a curve goes on beyond its
//! point, `max`, `min` and `abs` keep what they chose.

use super::evaluate::compare;
use super::pose_answers::PoseAnswers;
use super::switch::{Side, Switch, side_of};
use crate::model::{Comparison, Curve, CurvePart, Expr, Function};

impl PoseAnswers<'_> {
    fn side(&self, expr: &Expr) -> Option<Side> {
        side_of(self.switches, expr)
    }

    pub(super) fn comparison(&self, expr: &Expr, how: Comparison, (a, b): (&Expr, &Expr)) -> bool {
        match self.side(expr) {
            Some(Side::Truth(truth)) => truth,
            _ => self.compared(how, (a, b)),
        }
    }

    /// As it is here: what differs by rounding of its terms is equal.
    fn compared(&self, how: Comparison, (a, b): (&Expr, &Expr)) -> bool {
        let over = self.scalar(a) - self.scalar(b);
        let equal = self.sizes.is_nothing(over, self.size(a, self.sizes) + self.size(b, self.sizes));
        compare(how, if equal { 0.0 } else { over }, 0.0)
    }

    pub(super) fn curve(&self, expr: &Expr, (curve, part): (&Curve, CurvePart), x: &Expr) -> f64 {
        let x = self.scalar(x);
        match self.side(expr) {
            Some(Side::Piece(piece)) => curve.on(part, piece, x),
            _ => curve.at(part, x),
        }
    }

    /// The value of a function on a side of its corner; none where it is on no side.
    pub(super) fn call_on_side(&self, expr: &Expr, args: &[Expr]) -> Option<f64> {
        match self.side(expr)? {
            Side::Argument(chosen) => Some(self.scalar(args.get(chosen)?)),
            Side::Sign(sign) => Some(sign * self.scalar(args.first()?)),
            Side::Free | Side::Truth(_) | Side::Piece(_) => None,
        }
    }

    /// The side on which a part is here, whatever it is taken for.
    pub(crate) fn side_here<'e>(&self, switch: &Switch<'e>) -> Switch<'e> {
        let side = match switch.expr {
            Expr::Compare(how, a, b) => Side::Truth(self.compared(*how, (a, b))),
            Expr::Curve(curve, _, x) => curve.function.piece(self.scalar(x)).map_or(Side::Free, Side::Piece),
            Expr::Call(Function::Abs, args) => {
                Side::Sign(if args.first().is_some_and(|x| self.scalar(x) < 0.0) { -1.0 } else { 1.0 })
            }
            Expr::Call(function, args) => {
                let above = |i: usize| (0..args.len()).all(|j| self.ahead(*function, args, (i, j)) >= 0.0);
                (0..args.len()).find(|i| above(*i)).map_or(Side::Free, Side::Argument)
            }
            _ => Side::Free,
        };
        Switch { side, ..*switch }
    }

    /// By how much one number of `max` or `min` is chosen before another one.
    fn ahead(&self, function: Function, args: &[Expr], (i, j): (usize, usize)) -> f64 {
        let ahead = self.scalar(&args[i]) - self.scalar(&args[j]);
        if function == Function::Min { -ahead } else { ahead }
    }

    /// A number that falls through zero where the side of a part ends. A piece of a curve has two ends, each with its own number: one
    /// for both would hide the far end of a piece that is shorter than a step.
    pub(crate) fn room(&self, switch: &Switch<'_>, end: usize) -> f64 {
        match (switch.expr, switch.side) {
            (Expr::Compare(how, a, b), Side::Truth(truth)) if end == 0 => {
                let below = matches!(how, Comparison::Less | Comparison::LessEqual) == truth;
                let over = self.scalar(a) - self.scalar(b);
                if below { -over } else { over }
            }
            (Expr::Curve(curve, _, x), Side::Piece(piece)) => {
                let (from, to) = curve.function.bounds(piece);
                let room = if end == 0 { self.scalar(x) - from } else { to - self.scalar(x) };
                if room.is_infinite() { 1.0 } else { room }
            }
            _ if end > 0 => 1.0,
            (Expr::Call(_, args), Side::Sign(sign)) => {
                sign * args.first().map_or(f64::NAN, |x| self.scalar(x))
            }
            (Expr::Call(function, args), Side::Argument(i)) => {
                let others = (0..args.len()).filter(|j| *j != i);
                others.map(|j| self.ahead(*function, args, (i, j))).fold(f64::INFINITY, f64::min)
            }
            _ => 1.0,
        }
    }

    /// What rounding of that number is small against.
    pub(crate) fn room_size(&self, switch: &Switch<'_>) -> f64 {
        let size = |e: &Expr| self.size(e, self.sizes);
        match switch.expr {
            Expr::Compare(_, a, b) => size(a) + size(b),
            Expr::Curve(_, _, x) => size(x),
            Expr::Call(_, args) => args.iter().map(size).sum(),
            _ => 0.0,
        }
    }

    /// The other side of the corner that is at this end.
    pub(crate) fn other_side<'e>(&self, switch: &Switch<'e>, end: usize) -> Switch<'e> {
        let side = match (switch.expr, switch.side) {
            (_, Side::Truth(truth)) => Side::Truth(!truth),
            (_, Side::Sign(sign)) => Side::Sign(-sign),
            (Expr::Curve(curve, ..), Side::Piece(piece)) => {
                Side::Piece(curve.function.beside(piece, end == 1))
            }
            (Expr::Call(function, args), Side::Argument(i)) => {
                let others = (0..args.len()).filter(|j| *j != i);
                let nearest = others.map(|j| (j, self.ahead(*function, args, (i, j))));
                nearest.min_by(|a, b| a.1.total_cmp(&b.1)).map_or(Side::Free, |(j, _)| Side::Argument(j))
            }
            _ => Side::Free,
        };
        Switch { side, ..*switch }
    }
}
