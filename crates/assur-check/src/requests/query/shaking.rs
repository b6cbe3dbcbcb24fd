//! What the inertia of all moving links does to the frame: `shaking_force()`, `shaking_moment(P)`, `rocking_couple()`.

use crate::expr::context::Context;
use crate::expr::positive::Want;
use crate::expr::results::Call;
use crate::names::declared::ThingKind;
use crate::values::fold;
use crate::values::typed::{Type, Typed};
use assur_math::math::Vec2;
use assur_model::model::{
    Axis, BinaryOp, Counterweight, Expr, Function as M, LinkId, MassProperties, PointRef, Query, Value,
};
use assur_syntax::document::{self, Arg, ExprKind};
use assur_text::language::Function;
use assur_text::source::Spanned;
use assur_text::units::Dimension;

impl Context<'_> {
    pub(super) fn on_the_frame(&mut self, call: Call<'_>, function: Function) -> Option<Typed> {
        match function {
            Function::ShakingForce => self.shaking_force(call),
            Function::ShakingMoment => self.shaking_moment(call),
            _ => self.rocking_couple(call),
        }
    }

    /// `shaking_force()`: −Σ m a
    fn shaking_force(&mut self, call: Call<'_>) -> Option<Typed> {
        self.arguments(call, 0, 0)?;
        let of = |(link, m): &(LinkId, MassProperties)| {
            (m.mass > 0.0).then_some(Expr::Query(Query::InertiaForce(*link)))
        };
        let sum = self.shaking(call, of)?;
        Some(Typed::new(sum, Type::vector(Dimension::FORCE)))
    }

    /// `shaking_moment()`, `shaking_moment(P)`: −Σ (r × m a + J α)
    fn shaking_moment(&mut self, call: Call<'_>) -> Option<Typed> {
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
            let moment = fold::call(M::Cross, vec![arm, force]);
            Some(match turned {
                Some(turned) => fold::binary(BinaryOp::Add, moment, turned),
                None => moment,
            })
        };
        let sum = self.shaking(call_of, of)?;
        Some(Typed::new(sum, Type::number(Dimension::TORQUE)))
    }

    /// `rocking_couple()`, `rocking_couple(z)`: Σ z k × (−m a), the planes counted from that named
    fn rocking_couple(&mut self, call: Call<'_>) -> Option<Typed> {
        let from = match self.arguments(call, 0, 1)?[..] {
            [plane] => self.scalar_constant(plane, &Want::LENGTH, "the plane of a rocking couple")?,
            _ => 0.0,
        };
        let heavy = self.heavy(Call { args: &[], ..call })?;
        if heavy.is_empty() {
            self.without_any_mass(call);
            return None;
        }
        self.in_the_plane(call, &heavy)?;
        let mut sum = Expr::Constant(Value::Vector(Vec2::zero()));
        for (link, _) in heavy {
            let own = self.builder.mech.link(link);
            let whole = own.mass.filter(|_| own.mass_parts.is_empty());
            let whole = whole.map(|m| (-from * m.mass, m.centre));
            let parts =
                own.mass_parts.iter().map(|part| ((part.plane - from) * part.own.mass, part.own.centre));
            let moments: Vec<(f64, Vec2)> = whole.into_iter().chain(parts).collect();
            // masses on either side of the plane act as one each
            for side in [1.0, -1.0] {
                let here = moments.iter().filter(|(moment, _)| moment * side > 0.0);
                let (moment, first) = here.fold((0.0, Vec2::zero()), |(m, r), (x, at)| (m + x, r + *at * *x));
                if moment == 0.0 {
                    continue;
                }
                let at = Query::Acceleration(PointRef::Fixed(link, first / moment));
                let part = fold::binary(BinaryOp::Mul, Expr::number(moment), Expr::Query(at));
                sum = if matches!(sum, Expr::Constant(_)) {
                    part
                } else {
                    fold::binary(BinaryOp::Add, sum, part)
                };
            }
        }
        let [x, y] = [Axis::X, Axis::Y].map(|axis| fold::component(sum.clone(), axis));
        Some(Typed::new(fold::pair(y, fold::negate(x)), Type::vector(Dimension::TORQUE)))
    }

    /// `mass(X)`, `angle(X)`, `radius(X)` of a counterweight: `None` where the argument is something else.
    pub(super) fn of_counterweight(&mut self, call: Call<'_>, function: Function) -> Option<Option<Typed>> {
        let [Arg { value: document::Expr { kind: ExprKind::Name(name), span }, name: None }] = call.args
        else {
            return None;
        };
        self.names.things.get(name).filter(|declared| declared.what == ThingKind::Counterweight)?;
        let part = match function {
            Function::Mass => |found: &Counterweight| Typed::constant(found.mass, Dimension::MASS),
            Function::Angle => |found: &Counterweight| Typed::constant(found.angle, Dimension::ANGLE),
            Function::Radius => |found: &Counterweight| Typed::constant(found.radius, Dimension::LENGTH),
            _ => return None,
        };
        self.names.note_thing(&Spanned::new(name.clone(), *span));
        Some(self.builder.mech.counterweights.iter().find(|found| found.name == *name).map(part))
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
