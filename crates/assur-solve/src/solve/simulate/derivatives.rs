//! Value and first three derivatives of an expression of the instant.

use crate::answer::{Side, Switch, side_of};
use crate::model::{Axis, BinaryOp, CurvePart, Expr, Function, Query, Value};

/// A number that depends on time, with its first three derivatives. What is no number has none.
#[derive(Clone, Copy, Debug)]
pub(super) struct Derivatives(pub [f64; 4]);

/// Whether an expression of the instant is a vector.
fn is_vector(expr: &Expr) -> bool {
    match expr {
        Expr::Constant(Value::Vector(_)) | Expr::Vector(..) | Expr::Polar(..) => true,
        Expr::Negate(x) | Expr::Binary(BinaryOp::Div, x, _) => is_vector(x),
        Expr::Binary(_, x, y) => is_vector(x) || is_vector(y),
        _ => false,
    }
}

impl Derivatives {
    const UNKNOWN: Self = Self([f64::NAN; 4]);

    const fn constant(x: f64) -> Self {
        Self([x, 0.0, 0.0, 0.0])
    }

    /// A function of it, by value and derivatives of the function.
    fn through(self, [f, f_1, f_2, f_3]: [f64; 4]) -> Self {
        let [_, v, a, j] = self.0;
        // what does not change has no rate, whatever the slope
        let part = |slope: f64, rate: f64| if rate == 0.0 { 0.0 } else { slope * rate };
        let third = part(f_3, v * v * v) + part(3.0 * f_2, v * a) + part(f_1, j);
        Self([f, part(f_1, v), part(f_2 * v, v) + part(f_1, a), third])
    }

    fn plus(self, other: Self) -> Self {
        Self(std::array::from_fn(|i| self.0[i] + other.0[i]))
    }

    fn scaled(self, factor: f64) -> Self {
        Self(self.0.map(|x| x * factor))
    }

    fn times(self, other: Self) -> Self {
        let ([x, v, a, j], [y, w, b, k]) = (self.0, other.0);
        let third = j * y + 3.0 * (a * w + v * b) + x * k;
        Self([x * y, v * y + x * w, a * y + 2.0 * v * w + x * b, third])
    }

    fn inverse(self) -> Self {
        let y = 1.0 / self.0[0];
        self.through([y, -y * y, 2.0 * y * y * y, -6.0 * y * y * y * y])
    }

    fn power(self, exponent: Self) -> Self {
        let (x, n) = (self.0[0], exponent.0[0]);
        if exponent.0[1..] == [0.0; 3] {
            let term = |factor: f64, n: f64| if factor == 0.0 { 0.0 } else { factor * libm::pow(x, n) };
            let [slope, bend] = [n, n * (n - 1.0)];
            return self.through([
                libm::pow(x, n),
                term(slope, n - 1.0),
                term(bend, n - 2.0),
                term(bend * (n - 2.0), n - 3.0),
            ]);
        }
        let power = exponent.times(Self::call(Function::Log, std::iter::once(self)));
        power.through([libm::exp(power.0[0]); 4])
    }

    /// Of an expression at an instant, s; what is not smooth, on its side.
    pub fn of(expr: &Expr, t: f64, switches: &[Switch<'_>]) -> Self {
        let of = |expr: &Expr| Self::of(expr, t, switches);
        match expr {
            Expr::Constant(Value::Scalar(x)) => Self::constant(*x),
            Expr::Query(Query::Time) => Self([t, 1.0, 0.0, 0.0]),
            Expr::Negate(x) => of(x).scaled(-1.0),
            Expr::Binary(op, x, y) => {
                let (x, y) = (of(x), of(y));
                match op {
                    BinaryOp::Add => x.plus(y),
                    BinaryOp::Sub => x.plus(y.scaled(-1.0)),
                    BinaryOp::Mul => x.times(y),
                    BinaryOp::Div => x.times(y.inverse()),
                }
            }
            Expr::Power(x, n) => of(x).power(of(n)),
            Expr::Component(vector, axis) => Self::component(vector, *axis, t, switches),
            Expr::Call(function, arguments) => match (side_of(switches, expr), arguments.first()) {
                (Some(Side::Sign(sign)), Some(x)) => of(x).scaled(sign),
                (Some(Side::Argument(i)), _) => arguments.get(i).map_or(Self::UNKNOWN, of),
                _ => Self::call(*function, arguments.iter().map(of)),
            },
            Expr::Curve(curve, part, x) => {
                let x = of(x);
                let [f, f_1, f_2, f_3] = match side_of(switches, expr) {
                    Some(Side::Piece(piece)) => curve.function.derivatives_on(piece, x.0[0]),
                    _ => curve.function.derivatives(x.0[0]),
                };
                x.through(match part {
                    CurvePart::Value => [f, f_1, f_2, f_3],
                    // its pieces are cubics
                    CurvePart::Slope => [f_1, f_2, f_3, 0.0],
                })
            }
            _ => Self::UNKNOWN,
        }
    }

    /// Of a component of a vector.
    pub fn component(expr: &Expr, axis: Axis, t: f64, switches: &[Switch<'_>]) -> Self {
        let of = |expr: &Expr| Self::of(expr, t, switches);
        let part = |expr: &Expr| Self::component(expr, axis, t, switches);
        match expr {
            Expr::Constant(Value::Vector(v)) => Self::constant(if axis == Axis::X { v.x } else { v.y }),
            Expr::Vector(x, y) => of(if axis == Axis::X { x } else { y }),
            Expr::Polar(r, angle) => {
                let function = if axis == Axis::X { Function::Cos } else { Function::Sin };
                of(r).times(Self::call(function, std::iter::once(of(angle))))
            }
            Expr::Negate(v) => part(v).scaled(-1.0),
            Expr::Binary(BinaryOp::Add, v, w) => part(v).plus(part(w)),
            Expr::Binary(BinaryOp::Sub, v, w) => part(v).plus(part(w).scaled(-1.0)),
            Expr::Binary(BinaryOp::Mul, v, x) if is_vector(v) => part(v).times(of(x)),
            Expr::Binary(BinaryOp::Mul, x, v) => of(x).times(part(v)),
            Expr::Binary(BinaryOp::Div, v, x) => part(v).times(of(x).inverse()),
            _ => Self::UNKNOWN,
        }
    }

    fn call(function: Function, mut all: impl Iterator<Item = Self>) -> Self {
        let Some(x) = all.next() else { return Self::UNKNOWN };
        let u = x.0[0];
        match function {
            Function::Sqrt => {
                let root = libm::sqrt(u);
                x.through([root, 0.5 / root, -0.25 / (root * u), 0.375 / (root * u * u)])
            }
            Function::Abs => x.scaled(if u < 0.0 { -1.0 } else { 1.0 }),
            Function::Sin => x.through([libm::sin(u), libm::cos(u), -libm::sin(u), -libm::cos(u)]),
            Function::Cos => x.through([libm::cos(u), -libm::sin(u), -libm::cos(u), libm::sin(u)]),
            Function::Tan => {
                let (tan, slope) = (libm::tan(u), 1.0 + libm::tan(u) * libm::tan(u));
                x.through([tan, slope, 2.0 * tan * slope, slope * (2.0 * slope + 4.0 * tan * tan)])
            }
            Function::Asin | Function::Acos => {
                let slope = 1.0 / libm::sqrt((1.0 - u) * (1.0 + u));
                let cube = slope * slope * slope;
                let bend = cube * (1.0 + 3.0 * u * u * slope * slope);
                let arcs = x.through([libm::asin(u), slope, u * cube, bend]);
                if function == Function::Asin {
                    return arcs;
                }
                Self([libm::acos(u), -arcs.0[1], -arcs.0[2], -arcs.0[3]])
            }
            Function::Atan => {
                let slope = 1.0 / (1.0 + u * u);
                x.through([
                    libm::atan(u),
                    slope,
                    -2.0 * u * slope * slope,
                    slope * slope * (8.0 * u * u * slope - 2.0),
                ])
            }
            Function::Exp => x.through([libm::exp(u); 4]),
            Function::Log => x.through([libm::log(u), 1.0 / u, -1.0 / (u * u), 2.0 / (u * u * u)]),
            Function::Atan2 => all.next().map_or(Self::UNKNOWN, |other| Self::angle(x, other)),
            // of two that are equal at a corner the one that will be greater, or less, just behind it
            Function::Max => all.fold(x, |most, x| if x.0 > most.0 { x } else { most }),
            Function::Min => all.fold(x, |least, x| if x.0 < least.0 { x } else { least }),
            Function::Mag | Function::Dot | Function::Cross | Function::Unit | Function::Direction => {
                Self::UNKNOWN
            }
        }
    }

    /// atan2(y, x): the rate is (x y' − y x')/(x² + y²).
    fn angle(y: Self, x: Self) -> Self {
        let square = x.times(x).plus(y.times(y)).0;
        let ([x, v, a, j], [y, w, b, k]) = (x.0, y.0);
        let rate = (x * w - y * v) / square[0];
        let second = (x * b - y * a - rate * square[1]) / square[0];
        let swept = v * b - w * a + x * k - y * j;
        let third = (swept - 2.0 * second * square[1] - rate * square[2]) / square[0];
        Self([libm::atan2(y, x), rate, second, third])
    }
}
