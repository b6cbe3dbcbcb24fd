//! Expressions of the file in the letters of the steps: loads that depend on the position, and what the file asks for by functions of
//! results. A part that no step has leaves the whole without letters.

use crate::angle::Angle;
use crate::course::Derivation;
use crate::forces::quantity_name;
use assur_formula::{Expr, Function as Of, Name, Unit, rounded, with_digits};
use assur_math::math::{Between, SAME, Vec2};
use assur_model::model::{
    Axis, BinaryOp, Curve, CurvePart, Expr as E, Function, LinkId, PairId, PairKind, PointRef, Query, Value,
};
use assur_model::structure::BodyOrigin;

impl Derivation<'_> {
    /// A number, in the units of equations but an angle in rad.
    pub(crate) fn in_letters(&mut self, of: &E) -> Option<Expr> {
        match of {
            E::Constant(Value::Scalar(x)) => Some(number(*x)),
            E::Negate(x) => Some(-self.in_letters(x)?),
            E::Binary(op, a, b) => {
                let (a, b) = (self.in_letters(a)?, self.in_letters(b)?);
                Some(match op {
                    BinaryOp::Add => a + b,
                    BinaryOp::Sub => a - b,
                    BinaryOp::Mul => a * b,
                    BinaryOp::Div => a / b,
                })
            }
            E::Power(x, exponent) => {
                let x = self.in_letters(x)?;
                match **exponent {
                    E::Constant(Value::Scalar(2.0)) => Some(x.squared()),
                    E::Constant(Value::Scalar(3.0)) => Some(x.cubed()),
                    _ => None,
                }
            }
            E::Call(function, args) => self.called(*function, args),
            E::Component(vector, axis) => {
                let known = self.result(of);
                known.or_else(|| {
                    let [x, y] = self.vector_in_letters(vector)?;
                    Some(if *axis == Axis::X { x } else { y })
                })
            }
            E::Quantity(id) => {
                let known = self.result(of).and_then(|known| self.with_sign_of(of, known));
                let quantity = self.scene.mechanism().quantities.get(id.index())?;
                known.or_else(|| self.in_letters(&quantity.expr))
            }
            E::Query(query) if self.is_nothing(query) => Some(Expr::ZERO),
            E::Query(Query::Angle(_) | Query::Displacement(_)) => {
                let known = self.result(of).and_then(|known| self.with_sign_of(of, known));
                known.or_else(|| Some(Expr::Pi * self.degrees_in_letters(of)? / Expr::Int(180)))
            }
            E::Query(query) => {
                let known = self.result(of).and_then(|known| self.with_sign_of(of, known));
                known.or_else(|| self.derived(query))
            }
            E::Curve(curve, CurvePart::Value, argument) => self.read_from(curve, argument),
            E::Curve(curve, CurvePart::Slope, _) => {
                let Value::Scalar(slope) = self.scene.view().value(of) else { return None };
                let name = quantity_name(&curve.name);
                Some(self.given(Name { letter: format!("{}′", name.letter), ..name }, slope, Unit::One))
            }
            _ => None,
        }
    }

    /// The value of a curve of the file: on the straight line between two rows, else as the file has it.
    fn read_from(&mut self, curve: &Curve, argument: &E) -> Option<Expr> {
        let Value::Scalar(x) = self.scene.view().value(argument) else { return None };
        let (rows, values) = (curve.function.arguments(), curve.function.values());
        let after = rows.partition_point(|row| *row <= x);
        let straight = curve.function.between() == Between::Straight;
        if straight && after > 0 && after < rows.len() {
            let turns = self.degrees_in_letters(argument);
            let scale = if turns.is_some() { 180.0 / std::f64::consts::PI } else { 1.0 };
            let x = turns.or_else(|| self.in_letters(argument))?;
            let [begin, end] = [after - 1, after].map(|i| (scale * rows[i], values[i]));
            let slope = (end.1 - begin.1) / (end.0 - begin.0);
            return Some(number(begin.1) + read(slope) * (x - read(begin.0)));
        }
        Some(self.given(quantity_name(&curve.name), curve.function.value(x), Unit::One))
    }

    /// Whether a result is nothing; a coordinate within rounding.
    fn is_nothing(&self, query: &Query) -> bool {
        match (query, self.scene.view().query(query)) {
            (Query::Displacement(_), Value::Scalar(x)) => x.abs() <= self.tiny,
            (_, value) => value == Value::Scalar(0.0),
        }
    }

    /// Letters with the value of an expression, or their opposite; none where they are of something else.
    pub(crate) fn with_sign_of(&self, of: &E, found: Expr) -> Option<Expr> {
        let Value::Scalar(x) = self.scene.view().value(of) else { return None };
        let near = |found: &Expr| (found.value() - x).abs() <= SAME * found.scale().max(x.abs());
        [found.clone(), -found].into_iter().find(near)
    }

    fn called(&mut self, function: Function, args: &[E]) -> Option<Expr> {
        match (function, args) {
            (Function::Max, [a, b]) => {
                let [a, b] = [self.in_letters(a)?, self.in_letters(b)?];
                Some(if a.value() < b.value() { b } else { a })
            }
            (Function::Sqrt, [x]) => Some(self.in_letters(x)?.root()),
            (Function::Abs, [x]) => Some(self.in_letters(x)?.abs()),
            (Function::Sin, [x]) => Some(self.degrees_in_letters(x)?.of(Of::Sin)),
            (Function::Cos, [x]) => Some(self.degrees_in_letters(x)?.of(Of::Cos)),
            (Function::Tan, [x]) => Some(self.degrees_in_letters(x)?.of(Of::Tan)),
            (Function::Mag, [E::Query(query)]) if self.magnitude_of(query).is_some() => {
                self.magnitude_of(query)
            }
            (Function::Mag, [E::Query(Query::Reaction(pair, _))]) => self.pressed_and_rubbed(*pair),
            (Function::Mag, [v]) => Some(length(self.vector_in_letters(v)?)),
            (Function::Dot, [a, b]) => {
                let ([a, b], [c, d]) = (self.vector_in_letters(a)?, self.vector_in_letters(b)?);
                Some(a * c + b * d)
            }
            (Function::Cross, [a, b]) => {
                let ([a, b], [c, d]) = (self.vector_in_letters(a)?, self.vector_in_letters(b)?);
                Some(a * d - b * c)
            }
            _ => None,
        }
    }

    /// The force in a pair of a normal force and friction.
    fn pressed_and_rubbed(&self, pair: PairId) -> Option<Expr> {
        let index = format!("f{}", self.scene.mechanism().pair(pair).name);
        let friction = self.found.get(&Name::new("F", &index)).cloned()?;
        let normal = self.reactions_of(pair).iter().find_map(|name| self.found.get(name).cloned())?;
        Some(length([normal, friction]))
    }

    /// The direction in which a pair slides: of a guide its line, else that of the block which stands for the pair.
    fn way_of_friction(&self, pair: PairId) -> Option<Angle> {
        if let PairKind::Prismatic(g) = &self.scene.mechanism().pair(pair).kind {
            let carrier = g.guide.index();
            let own = self.direction_given(g.along, || Name::new("λ", &self.label(carrier)));
            return Some(self.bodies[carrier].as_ref()?.angle.plus(&own));
        }
        let bodies = &self.structure().replaced.bodies;
        let block = (0..bodies.len()).find(|i| bodies[*i].origin == BodyOrigin::Imaginary(pair))?;
        Some(self.bodies[block].as_ref()?.angle.clone())
    }

    /// The components of the force of a pair with friction.
    fn pressed_and_rubbed_on(&self, pair: PairId, way: &Angle, v: Vec2) -> Option<[Expr; 2]> {
        let index = format!("f{}", self.scene.mechanism().pair(pair).name);
        let friction = self.found.get(&Name::new("F", &index)).cloned()?;
        let normal = self.reactions_of(pair).iter().find_map(|name| self.found.get(name).cloned())?;
        let signs = [(1, 1), (1, -1), (-1, 1), (-1, -1)];
        let signed = |x: &Expr, sign: i32| if sign < 0 { -x.clone() } else { x.clone() };
        let sums = signs.into_iter().map(|(f, n)| {
            let (f, n) = (signed(&friction, f), signed(&normal, n));
            [f.clone() * way.cos() - n.clone() * way.sin(), f * way.sin() + n * way.cos()]
        });
        let is_it =
            |sum: &[Expr; 2]| Vec2::new(sum[0].value() - v.x, sum[1].value() - v.y).norm() <= SAME * v.norm();
        sums.into_iter().find(is_it)
    }

    /// An angle in degrees.
    pub(crate) fn degrees_in_letters(&mut self, of: &E) -> Option<Expr> {
        match of {
            E::Constant(Value::Scalar(x)) => {
                let degrees = x.to_degrees();
                let whole = (degrees - degrees.round()).abs() <= SAME;
                Some(if whole { Expr::Degrees(degrees.round() as i64) } else { Expr::Number(degrees) })
            }
            E::Negate(x) => Some(-self.degrees_in_letters(x)?),
            E::Binary(BinaryOp::Add, a, b) => Some(self.degrees_in_letters(a)? + self.degrees_in_letters(b)?),
            E::Binary(BinaryOp::Sub, a, b) => Some(self.degrees_in_letters(a)? - self.degrees_in_letters(b)?),
            E::Binary(BinaryOp::Mul, a, b) if matches!(**a, E::Constant(_)) => {
                Some(self.in_letters(a)? * self.degrees_in_letters(b)?)
            }
            E::Quantity(id) => {
                let quantity = self.scene.mechanism().quantities.get(id.index())?;
                self.degrees_in_letters(&quantity.expr)
            }
            E::Call(Function::Direction, args) => {
                let [x, y] = self.vector_in_letters(args.first()?)?;
                let turn = if x.value() < 0.0 { Expr::Degrees(180) } else { Expr::ZERO };
                let Value::Scalar(direction) = self.scene.view().value(of) else { return None };
                let angle = if x.is_zero() {
                    return Some(Expr::Degrees(if y.value() > 0.0 { 90 } else { -90 }));
                } else {
                    (y / x).of(Of::Arctan) + turn
                };
                let turns = ((direction.to_degrees() - angle.value()) / 360.0).round();
                Some(angle + Expr::Degrees(360 * turns as i64))
            }
            E::Query(query @ (Query::Angle(_) | Query::Displacement(_))) => {
                let Value::Scalar(x) = self.scene.view().query(query) else { return None };
                let angle = match query {
                    Query::Angle(link) => self.bodies[link.index()].as_ref()?.angle.whole(),
                    Query::Displacement(pair) => self.between_links(*pair)?,
                    _ => return None,
                };
                let turns = ((x.to_degrees() - angle.value()) / 360.0).round();
                Some(angle + Expr::Degrees(360 * turns as i64))
            }
            _ => None,
        }
    }

    /// The angle of a hinge of two links.
    fn between_links(&self, pair: PairId) -> Option<Expr> {
        let PairKind::Revolute(pins) = &self.scene.mechanism().pair(pair).kind else { return None };
        let [one, two] = pins.as_slice() else { return None };
        let of = |link: LinkId| self.bodies[link.index()].as_ref().map(|body| body.angle.clone());
        Some(of(two.link)?.minus(&of(one.link)?).whole())
    }

    /// The components of a vector.
    pub(crate) fn vector_in_letters(&mut self, of: &E) -> Option<[Expr; 2]> {
        match of {
            E::Constant(Value::Vector(v)) => Some([v.x, v.y].map(number)),
            E::Vector(x, y) => Some([self.in_letters(x)?, self.in_letters(y)?]),
            E::Polar(size, angle) => {
                let (size, angle) = (self.in_letters(size)?, self.degrees_in_letters(angle)?);
                Some([size.clone() * angle.clone().of(Of::Cos), size * angle.of(Of::Sin)])
            }
            E::Negate(v) => Some(self.vector_in_letters(v)?.map(|x| -x)),
            E::Binary(op @ (BinaryOp::Add | BinaryOp::Sub), a, b) => {
                let ([a, b], [c, d]) = (self.vector_in_letters(a)?, self.vector_in_letters(b)?);
                Some(if *op == BinaryOp::Add { [a + c, b + d] } else { [a - c, b - d] })
            }
            E::Binary(BinaryOp::Mul, a, b) => {
                let (size, vector) = match self.vector_in_letters(a) {
                    Some(vector) => (self.in_letters(b)?, vector),
                    None => (self.in_letters(a)?, self.vector_in_letters(b)?),
                };
                Some(vector.map(|x| size.clone() * x))
            }
            E::Binary(BinaryOp::Div, a, b) => {
                let (vector, by) = (self.vector_in_letters(a)?, self.in_letters(b)?);
                Some(vector.map(|x| x / by.clone()))
            }
            E::Call(Function::Unit, args) => {
                let vector = self.vector_in_letters(args.first()?)?;
                let size = length(vector.clone());
                Some(vector.map(|x| x / size.clone()))
            }
            E::Quantity(id) => {
                let quantity = self.scene.mechanism().quantities.get(id.index())?;
                self.vector_in_letters(&quantity.expr)
            }
            E::Query(query) => self.parts_of(query),
            _ => None,
        }
    }

    fn parts_of(&mut self, query: &Query) -> Option<[Expr; 2]> {
        let found = match query {
            Query::Position(PointRef::Fixed(link, at)) => self.position(link.index(), *at),
            Query::Velocity(PointRef::Fixed(link, at)) => self.velocity(link.index(), *at),
            Query::Acceleration(PointRef::Fixed(link, at)) => self.acceleration(link.index(), *at),
            Query::Position(PointRef::Under(_, (other, at))) => self.position(other.index(), *at),
            Query::Velocity(PointRef::Under(link, point)) => self.point_under(1, *link, *point),
            Query::Acceleration(PointRef::Under(link, point)) => self.point_under(2, *link, *point),
            Query::CurvatureCentre(PointRef::Fixed(link, at)) => self.centre_of_curvature(link.index(), *at),
            Query::InertiaForce(_) => self.known_parts(query)?,
            Query::Reaction(pair, link) => match self.known_parts(query) {
                Some(parts) => parts,
                None => match self.reaction_in_truss(*pair, *link) {
                    Some(parts) => parts,
                    None => self.reaction_from_others(*pair, *link)?,
                },
            },
            Query::LinkDirection(link) => {
                let angle = self.bodies[link.index()].as_ref()?.angle.clone();
                [angle.cos(), angle.sin()]
            }
            _ => return None,
        };
        Some(found)
    }

    /// The components of a force that steps have; one that is nothing needs no letters.
    fn known_parts(&mut self, query: &Query) -> Option<[Expr; 2]> {
        let Value::Vector(v) = self.scene.view().query(query) else { return None };
        let mut part = |axis, x: f64| {
            let of = E::Component(Box::new(E::Query(*query)), axis);
            if x.abs() <= SAME * v.norm() { Some(Expr::ZERO) } else { self.result(&of) }
        };
        Some([part(Axis::X, v.x)?, part(Axis::Y, v.y)?])
    }

    /// A reaction that is a force between teeth, or the force in the hinge of a cam's roller with what presses on the roller.
    fn reaction_from_others(&mut self, pair: PairId, link: LinkId) -> Option<[Expr; 2]> {
        let mesh = Name::new("F", &self.scene.mechanism().pair(pair).name);
        let of_teeth = self.free.forces[link.index()].iter().find(|force| force.name == mesh);
        if let Some(force) = of_teeth {
            return Some(force.parts.clone());
        }
        let Value::Vector(v) = self.scene.view().query(&Query::Reaction(pair, link)) else { return None };
        if let Some(sum) =
            self.way_of_friction(pair).and_then(|way| self.pressed_and_rubbed_on(pair, &way, v))
        {
            return Some(sum);
        }
        let contacts = &self.scene.mechanism().cam_contacts;
        let contact =
            contacts.iter().find(|contact| contact.roller.is_some_and(|(_, hinge)| hinge == pair))?;
        let parts = |name: &Name| {
            ["x", "y"].map(|axis| self.found.get(&name.and(axis)).cloned().unwrap_or(Expr::ZERO))
        };
        for (own, pressed) in self.reactions_of(pair).iter().flat_map(|own| {
            self.reactions_of(contact.pair).into_iter().map(move |other| (own.clone(), other))
        }) {
            let ([a, b], [c, d]) = (parts(&own), parts(&pressed));
            let sums = [
                [a.clone() + c.clone(), b.clone() + d.clone()],
                [a.clone() - c.clone(), b.clone() - d.clone()],
                [c.clone() - a.clone(), d.clone() - b.clone()],
                [-(a + c), -(b + d)],
            ];
            let is_it = |sum: &[Expr; 2]| {
                Vec2::new(sum[0].value() - v.x, sum[1].value() - v.y).norm() <= SAME * v.norm()
            };
            if let Some(sum) = sums.into_iter().find(is_it) {
                return Some(sum);
            }
        }
        None
    }

    /// The velocity (1) or acceleration (2) of the point of a link under a point of another.
    fn point_under(&mut self, order: usize, link: LinkId, (other, at): (LinkId, Vec2)) -> [Expr; 2] {
        let here = self.position(other.index(), at);
        let name = self.point_name(other.index(), at);
        self.under(order, link.index(), &name, &here)
    }
}

/// A number that the file does not have as it is: of few digits as they are, else rounded.
fn read(x: f64) -> Expr {
    if x < 0.0 {
        return -read(-x);
    }
    let short = with_digits(x, 5).value();
    if (x - short).abs() <= f64::EPSILON * x { number(x) } else { rounded(x) }
}

/// A constant of the file.
fn number(x: f64) -> Expr {
    if x < 0.0 {
        return -number(-x);
    }
    let whole = x.round();
    if x == whole && whole.abs() < 1e6 { Expr::Int(whole as i64) } else { Expr::Number(x) }
}

/// The magnitude of a vector.
pub(crate) fn length([x, y]: [Expr; 2]) -> Expr {
    match (x.is_zero(), y.is_zero()) {
        (_, true) => x.abs(),
        (true, _) => y.abs(),
        _ => (x.squared() + y.squared()).root(),
    }
}
