//! Functions of two points or two links, made of the motion of each.

use crate::expr::context::Context;
use crate::expr::results::Call;
use crate::values::fold;
use crate::values::typed::{Type, Typed};
use assur_math::math::Vec2;
use assur_model::model::{Axis, BinaryOp, Expr, Function, LinkId, PointRef, Query};
use assur_text::units::Dimension;

fn difference(a: Expr, b: Expr) -> Expr {
    fold::binary(BinaryOp::Sub, a, b)
}

impl Context<'_> {
    /// `distance(A, rod.C)`
    pub(super) fn distance(&mut self, call: Call<'_>) -> Option<Typed> {
        let args = self.arguments(call, 2, 2)?;
        let [a, b] = [args[0], args[1]].map(|arg| self.point_argument(call, arg));
        let [a, b] = [a?, b?].map(|(link, at)| Expr::Query(Query::Position(PointRef::Fixed(link, at))));
        let apart = fold::call(Function::Mag, vec![difference(a, b)]);
        Some(Typed::new(apart, Type::number(Dimension::LENGTH)))
    }

    /// `instant_centre(rod)`, `instant_centre(rod, rocker)`: with v and ω of L as seen from K, p + (−v_y, v_x) / ω for the
    /// origin p of L. No value where the two do not turn relative to each other.
    pub(super) fn instant_centre(&mut self, call: Call<'_>) -> Option<Typed> {
        let args = self.arguments(call, 1, 2)?;
        let link = self.link_argument(call, args[0])?;
        let seen_from = match args.get(1) {
            Some(other) => self.link_argument(call, other)?,
            None => LinkId::GROUND,
        };
        if link == seen_from {
            self.wrong_argument(call, "a link that moves against the other,", args[args.len() - 1].span);
            return None;
        }
        let origin = (link, Vec2::zero());
        let mut v = Expr::Query(Query::Velocity(PointRef::Fixed(link, Vec2::zero())));
        if seen_from != LinkId::GROUND {
            v = difference(v, Expr::Query(Query::Velocity(PointRef::Under(seen_from, origin))));
        }
        let turned =
            fold::pair(fold::negate(fold::component(v.clone(), Axis::Y)), fold::component(v, Axis::X));
        let arm = fold::binary(BinaryOp::Div, turned, Expr::Query(Query::Turning(link, seen_from)));
        let p = Expr::Query(Query::Position(PointRef::Fixed(link, Vec2::zero())));
        let centre = fold::binary(BinaryOp::Add, p, arm);
        Some(Typed::new(centre, Type::vector(Dimension::LENGTH)))
    }
}
