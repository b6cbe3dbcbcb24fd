//! What the inertia of all moving links does to the frame: `shaking_force()`, `shaking_moment(P)`.

use crate::expr::context::Context;
use crate::expr::results::Call;
use crate::values::fold;
use crate::values::typed::{Type, Typed};
use assur_math::math::Vec2;
use assur_model::model::{BinaryOp, Expr, Function, LinkId, MassProperties, PointRef, Query, Value};
use assur_text::units::Dimension;

impl Context<'_> {
    /// `shaking_force()`: −Σ m a
    pub(super) fn shaking_force(&mut self, call: Call<'_>) -> Option<Typed> {
        self.arguments(call, 0, 0)?;
        let of = |(link, m): &(LinkId, MassProperties)| {
            (m.mass > 0.0).then_some(Expr::Query(Query::InertiaForce(*link)))
        };
        let sum = self.shaking(call, of)?;
        Some(Typed::new(sum, Type::vector(Dimension::FORCE)))
    }

    /// `shaking_moment()`, `shaking_moment(P)`: −Σ (r × m a + J α)
    pub(super) fn shaking_moment(&mut self, call: Call<'_>) -> Option<Typed> {
        let about = match self.arguments(call, 0, 1)?[..] {
            [point] => self.point_on(call, LinkId::GROUND, (point, "a point of the ground"))?,
            _ => Vec2::zero(),
        };
        let about = Expr::Constant(Value::Vector(about));
        let call_of = Call { args: &[], ..call };
        let of = |(link, m): &(LinkId, MassProperties)| {
            let turned = (m.inertia > 0.0).then_some(Expr::Query(Query::InertiaTorque(*link)));
            if m.mass <= 0.0 {
                return turned;
            }
            let centre = Expr::Query(Query::Position(PointRef::Fixed(*link, m.centre)));
            let arm = fold::binary(BinaryOp::Sub, centre, about.clone());
            let force = Expr::Query(Query::InertiaForce(*link));
            let moment = fold::call(Function::Cross, vec![arm, force]);
            Some(match turned {
                Some(turned) => fold::binary(BinaryOp::Add, moment, turned),
                None => moment,
            })
        };
        let sum = self.shaking(call_of, of)?;
        Some(Typed::new(sum, Type::number(Dimension::TORQUE)))
    }

    /// The sum over all moving links that have something of it.
    fn shaking(
        &mut self,
        call: Call<'_>,
        of: impl Fn(&(LinkId, MassProperties)) -> Option<Expr>,
    ) -> Option<Expr> {
        let sum = self.heavy(call)?.iter().filter_map(of).reduce(|a, b| fold::binary(BinaryOp::Add, a, b));
        if sum.is_none() {
            self.without_any_mass(call);
        }
        sum
    }
}
