//! What depends on the columns of a table of variants, as a flat list of operations on numbers in SI: each writes the register
//! of its own place. They are those of `values::fold`, in the same order, so that a number comes out to the last bit as if it
//! were read again.

use crate::expr::read::LARGEST;
use crate::values::row::Row;
use assur_math::math::Vec2;
use assur_model::model::{Axis, BinaryOp, Expr, Function, QuantityId, Value};

pub(crate) type Register = usize;

#[derive(Clone, Copy, Debug)]
enum Operation {
    /// A number of the file.
    Number(f64),
    /// The value in a column of the row.
    Cell(usize),
    /// One unit in the last digit of it.
    Digit(usize),
    Negate(Register),
    Add(Register, Register),
    Subtract(Register, Register),
    Multiply(Register, Register),
    Divide(Register, Register),
    Power(Register, Register),
    /// A function of one number, of two where it has two.
    Call(Function, Register, Register),
    /// A component of the direction of an angle.
    Direction(Register, Axis),
}

impl Operation {
    /// The registers that it reads; none where it reads the row or nothing.
    const fn operands(&self) -> Option<[Register; 2]> {
        match *self {
            Self::Number(_) | Self::Cell(_) | Self::Digit(_) => None,
            Self::Negate(a) | Self::Direction(a, _) => Some([a, a]),
            Self::Add(a, b)
            | Self::Subtract(a, b)
            | Self::Multiply(a, b)
            | Self::Divide(a, b)
            | Self::Power(a, b)
            | Self::Call(_, a, b) => Some([a, b]),
        }
    }

    fn value(&self, r: &[f64], row: &Row) -> f64 {
        match *self {
            Self::Number(x) => x,
            Self::Cell(column) => row.cell(column).map_or(f64::NAN, |cell| cell.value),
            Self::Digit(column) => row.cell(column).map_or(f64::NAN, |cell| cell.digit),
            Self::Negate(a) => -r[a],
            Self::Add(a, b) => r[a] + r[b],
            Self::Subtract(a, b) => r[a] - r[b],
            Self::Multiply(a, b) => r[a] * r[b],
            Self::Divide(a, b) => r[a] / r[b],
            Self::Power(a, b) if r[b] == 2.0 => r[a] * r[a],
            Self::Power(a, b) => libm::pow(r[a], r[b]),
            Self::Call(function, a, b) => call(function, r[a], r[b]),
            Self::Direction(a, Axis::X) => Vec2::direction(r[a]).x,
            Self::Direction(a, Axis::Y) => Vec2::direction(r[a]).y,
        }
    }
}

/// The operations, with their registers.
#[derive(Clone, Debug, Default)]
pub(crate) struct Program {
    operations: Vec<Operation>,
    registers: Vec<f64>,
    /// Divisors of what is found at each position.
    divisors: Vec<Register>,
    /// What stands for a register in an expression has an id from this one on.
    symbols: usize,
}

/// What an expression comes to.
pub(crate) enum Compiled {
    /// It depends on no column.
    Constant(Value),
    Number(Register),
    Vector(Register, Register),
    /// It depends on results of a position.
    Result,
}

impl Program {
    /// Nothing yet; quantities from this id on stand for registers.
    pub(crate) fn new(symbols: usize) -> Self {
        Self { symbols, ..Self::default() }
    }

    /// The value in a column.
    pub(crate) fn cell(&mut self, column: usize) -> Register {
        self.push(Operation::Cell(column))
    }

    /// A share of the magnitude of a number, or one unit in the last digit of a column where that is less.
    pub(crate) fn share(&mut self, share: f64, of: Register, digit: Option<usize>) -> Register {
        let magnitude = self.push(Operation::Call(Function::Abs, of, of));
        let share = self.number(share);
        let part = self.push(Operation::Multiply(share, magnitude));
        let Some(column) = digit else { return part };
        let digit = self.push(Operation::Digit(column));
        self.push(Operation::Call(Function::Min, digit, part))
    }

    /// The mass of a weight.
    pub(crate) fn mass(&mut self, weight: Register, gravity: f64) {
        let gravity = self.number(gravity);
        self.push(Operation::Divide(weight, gravity));
    }

    /// The magnitude of a vector.
    pub(crate) fn magnitude(&mut self, x: Register, y: Register) -> Register {
        self.push(Operation::Call(Function::Mag, x, y))
    }

    /// The direction of an angle.
    pub(crate) fn direction(&mut self, angle: Register) {
        self.push(Operation::Direction(angle, Axis::X));
        self.push(Operation::Direction(angle, Axis::Y));
    }

    /// What stands for a register.
    pub(crate) const fn symbol(&self, register: Register) -> Expr {
        Expr::Quantity(QuantityId::at(self.symbols + register))
    }

    /// The values that the last row gave.
    pub(crate) fn values(&self) -> &[f64] {
        &self.registers
    }

    /// Computes all of it for a row; whether all of it is finite.
    pub(crate) fn run(&mut self, row: &Row) -> bool {
        self.registers.clear();
        for operation in &self.operations {
            let value = operation.value(&self.registers, row);
            // NaN too
            if value.abs().partial_cmp(&LARGEST).is_none_or(std::cmp::Ordering::is_gt) {
                return false;
            }
            self.registers.push(value);
        }
        self.divisors.iter().all(|d| self.registers[*d] != 0.0)
    }

    /// Whether a register is the same for all rows.
    pub(crate) fn is_known(&self, register: Register) -> bool {
        matches!(self.operations[register], Operation::Number(_))
    }

    /// An operation on numbers of the file alone is done here.
    fn push(&mut self, operation: Operation) -> Register {
        let known = operation.operands().is_none_or(|all| all.iter().all(|r| self.is_known(*r)));
        let value = if known { operation.value(&self.registers, &Row::default()) } else { f64::NAN };
        let reads_row = matches!(operation, Operation::Cell(_) | Operation::Digit(_));
        self.operations.push(if known && !reads_row { Operation::Number(value) } else { operation });
        self.registers.push(value);
        self.operations.len() - 1
    }

    /// Compiles an expression, and what it has of such parts where it depends on results; `None` for what a row may change in
    /// another way than by its numbers: conditions, and functions that are not among the operations.
    pub(crate) fn compile(&mut self, expr: &Expr) -> Option<Compiled> {
        Some(match expr {
            Expr::Constant(value) => Compiled::Constant(*value),
            Expr::Quantity(id) if id.index() >= self.symbols => Compiled::Number(id.index() - self.symbols),
            Expr::Quantity(_) | Expr::Query(_) => Compiled::Result,
            Expr::Vector(x, y) => self.pair(x, y)?,
            Expr::Polar(r, phi) => self.polar(r, phi)?,
            Expr::Component(v, axis) => match (self.compile(v)?, axis) {
                (Compiled::Vector(x, _), Axis::X) | (Compiled::Vector(_, x), Axis::Y) => Compiled::Number(x),
                (Compiled::Result, _) => Compiled::Result,
                _ => return None,
            },
            Expr::Negate(a) => match self.compile(a)? {
                Compiled::Number(a) => Compiled::Number(self.push(Operation::Negate(a))),
                Compiled::Vector(x, y) => {
                    let [x, y] = [x, y].map(|a| self.push(Operation::Negate(a)));
                    Compiled::Vector(x, y)
                }
                other => other,
            },
            Expr::Binary(op, a, b) => self.binary(*op, a, b)?,
            Expr::Power(a, b) => match self.numbers(a, b)? {
                Some((a, b)) => Compiled::Number(self.push(Operation::Power(a, b))),
                None => Compiled::Result,
            },
            Expr::Call(function, args) => self.call(*function, args)?,
            Expr::Compare(_, a, b) | Expr::And(a, b) | Expr::Or(a, b) => {
                let (a, b) = (self.compile(a)?, self.compile(b)?);
                // its truth would go with the row
                let open = matches!(a, Compiled::Result) || matches!(b, Compiled::Result);
                if !open {
                    return None;
                }
                Compiled::Result
            }
            Expr::Not(a) | Expr::Frictionless(a) => match self.compile(a)? {
                Compiled::Result => Compiled::Result,
                _ => return None,
            },
            Expr::Curve(..) => return None,
        })
    }

    fn number(&mut self, x: f64) -> Register {
        self.push(Operation::Number(x))
    }

    /// Both as registers, where both are numbers; nothing where one depends on results.
    fn numbers(&mut self, a: &Expr, b: &Expr) -> Option<Option<(Register, Register)>> {
        let (a, b) = (self.compile(a)?, self.compile(b)?);
        if matches!(a, Compiled::Result) || matches!(b, Compiled::Result) {
            return Some(None);
        }
        Some(Some((self.register(&a)?, self.register(&b)?)))
    }

    fn register(&mut self, value: &Compiled) -> Option<Register> {
        match value {
            Compiled::Number(r) => Some(*r),
            Compiled::Constant(Value::Scalar(x)) => Some(self.number(*x)),
            _ => None,
        }
    }

    fn vector(&mut self, value: &Compiled) -> Option<(Register, Register)> {
        match value {
            Compiled::Vector(x, y) => Some((*x, *y)),
            Compiled::Constant(Value::Vector(v)) => Some((self.number(v.x), self.number(v.y))),
            _ => None,
        }
    }

    fn pair(&mut self, x: &Expr, y: &Expr) -> Option<Compiled> {
        Some(self.numbers(x, y)?.map_or(Compiled::Result, |(x, y)| Compiled::Vector(x, y)))
    }

    fn polar(&mut self, r: &Expr, phi: &Expr) -> Option<Compiled> {
        let Some((r, phi)) = self.numbers(r, phi)? else { return Some(Compiled::Result) };
        let [x, y] = [Axis::X, Axis::Y].map(|axis| {
            let part = self.push(Operation::Direction(phi, axis));
            self.push(Operation::Multiply(part, r))
        });
        Some(Compiled::Vector(x, y))
    }

    fn binary(&mut self, op: BinaryOp, a: &Expr, b: &Expr) -> Option<Compiled> {
        let (a, b) = (self.compile(a)?, self.compile(b)?);
        if let (BinaryOp::Div, Compiled::Number(divisor)) = (op, &b) {
            self.divisors.push(*divisor);
        }
        if matches!(a, Compiled::Result) || matches!(b, Compiled::Result) {
            return Some(Compiled::Result);
        }
        let of = match op {
            BinaryOp::Add => Operation::Add,
            BinaryOp::Sub => Operation::Subtract,
            BinaryOp::Mul => Operation::Multiply,
            BinaryOp::Div => Operation::Divide,
        };
        if let (Some(a), Some(b)) = (self.register(&a), self.register(&b)) {
            return Some(Compiled::Number(self.push(of(a, b))));
        }
        let [x, y] = match (op, self.vector(&a), self.vector(&b)) {
            (BinaryOp::Add | BinaryOp::Sub, Some(u), Some(v)) => [of(u.0, v.0), of(u.1, v.1)],
            (BinaryOp::Mul | BinaryOp::Div, Some(v), None) => {
                let k = self.register(&b)?;
                [of(v.0, k), of(v.1, k)]
            }
            (BinaryOp::Mul, None, Some(v)) => {
                let k = self.register(&a)?;
                [of(v.0, k), of(v.1, k)]
            }
            _ => return None,
        };
        Some(Compiled::Vector(self.push(x), self.push(y)))
    }

    fn call(&mut self, function: Function, args: &[Expr]) -> Option<Compiled> {
        let args = args.iter().map(|a| self.compile(a)).collect::<Option<Vec<_>>>()?;
        if args.iter().any(|a| matches!(a, Compiled::Result)) {
            return Some(Compiled::Result);
        }
        if let (Function::Mag, [v]) = (function, args.as_slice()) {
            let (x, y) = self.vector(v)?;
            return Some(Compiled::Number(self.push(Operation::Call(function, x, y))));
        }
        let args = args.iter().map(|a| self.register(a)).collect::<Option<Vec<_>>>()?;
        let two = matches!(function, Function::Max | Function::Min | Function::Atan2);
        match (function, args.as_slice()) {
            (Function::Dot | Function::Cross | Function::Unit | Function::Direction | Function::Mag, _) => {
                None
            }
            (_, [a]) if !two => Some(Compiled::Number(self.push(Operation::Call(function, *a, *a)))),
            (_, [a, b, more @ ..]) if two => {
                let first = self.push(Operation::Call(function, *a, *b));
                let all = more.iter().fold(first, |r, x| self.push(Operation::Call(function, r, *x)));
                Some(Compiled::Number(all))
            }
            _ => None,
        }
    }
}

fn call(function: Function, a: f64, b: f64) -> f64 {
    match function {
        Function::Sqrt => a.sqrt(),
        Function::Abs => a.abs(),
        Function::Sin => libm::sin(a),
        Function::Cos => libm::cos(a),
        Function::Tan => libm::tan(a),
        Function::Asin => libm::asin(a),
        Function::Acos => libm::acos(a),
        Function::Exp => libm::exp(a),
        Function::Log => libm::log(a),
        Function::Atan => libm::atan(a),
        Function::Atan2 => libm::atan2(a, b),
        Function::Mag => libm::hypot(a, b),
        Function::Max => a.max(b),
        Function::Min => a.min(b),
        Function::Dot | Function::Cross | Function::Unit | Function::Direction => f64::NAN,
    }
}
