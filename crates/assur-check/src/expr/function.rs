//! Mathematical functions.

use crate::expr::{
    context::Context,
    read::no_power,
    results::{Call, Sign},
};
use crate::values::{
    fold,
    typed::{Dim, Type, Typed, phrase},
};
use assur_model::model::{Expr as ModelExpr, Function, Value};
use assur_syntax::document::{Arg, Expr, Name};
use assur_text::source::Span;
use assur_text::units::Dimension;

impl Context<'_> {
    /// A call of any function.
    pub(crate) fn call(&mut self, name: &Name, args: &[Arg], span: Span, sign: Sign) -> Option<Typed> {
        (self.results.call)(self, Call { name, args, span, sign })
    }

    /// `abs`
    pub(crate) fn absolute(&mut self, call: Call<'_>) -> Option<Typed> {
        let (t, expr) = self.one(call, Sign::Free)?;
        let help = matches!(t.ty, Type::Vector(_)).then(|| "write `mag(…)`".to_owned());
        let Type::Number(_) = t.ty else {
            self.shape("the argument of `abs`", "a number", t.ty, expr.span, help);
            return None;
        };
        Some(apply(Function::Abs, t.ty, [t]))
    }

    /// `unit`
    pub(crate) fn unit_vector(&mut self, call: Call<'_>) -> Option<Typed> {
        let (t, expr) = self.one(call, Sign::Matters)?;
        self.is_vector_argument(&t, call, expr)?;
        let t = apply(Function::Unit, Type::vector(Dimension::NUMBER), [t]);
        self.finite(t, "the null vector has no direction", call.span)
    }

    /// `dir` of a vector
    pub(crate) fn direction(&mut self, call: Call<'_>) -> Option<Typed> {
        let (t, expr) = self.one(call, Sign::Matters)?;
        self.is_vector_argument(&t, call, expr)?;
        Some(apply(Function::Direction, Type::number(Dimension::ANGLE), [t]))
    }

    /// `sin`, `cos`, `tan`
    pub(crate) fn of_angle(&mut self, call: Call<'_>, f: Function) -> Option<Typed> {
        self.of(call, Dimension::ANGLE, f, Dimension::NUMBER)
    }

    /// `asin`, `acos`, `atan`
    pub(crate) fn angle_of(&mut self, call: Call<'_>, f: Function) -> Option<Typed> {
        self.of(call, Dimension::NUMBER, f, Dimension::ANGLE)
    }

    /// `exp`, `log`
    pub(crate) fn of_number(&mut self, call: Call<'_>, f: Function) -> Option<Typed> {
        self.of(call, Dimension::NUMBER, f, Dimension::NUMBER)
    }

    fn one<'c>(&mut self, call: Call<'c>, sign: Sign) -> Option<(Typed, &'c Expr)> {
        let args = self.arguments(call, 1, 1)?;
        Some((self.read_signed(args[0], sign)?, args[0]))
    }

    /// A function of a number of one dimension with a number of another.
    fn of(&mut self, call: Call<'_>, from: Dimension, f: Function, to: Dimension) -> Option<Typed> {
        let (t, expr) = self.one(call, Sign::Matters)?;
        let t = self.fit(t, from, &format!("the argument of `{}`", call.name.node), expr)?;
        if from == Dimension::NUMBER
            && matches!(f, Function::Asin | Function::Acos)
            && let Some(Value::Scalar(x)) = t.value()
            && x.abs() > 1.0
        {
            self.without_value("a sine or cosine is at most 1 in magnitude", call.span, &t, expr);
            return None;
        }
        let t = apply(f, Type::number(to), [t]);
        let why = match f {
            Function::Log => "a logarithm is of a number greater than 0",
            Function::Exp => "the result is too great for a number",
            _ => "a sine or cosine is at most 1 in magnitude",
        };
        self.finite(t, why, call.span)
    }

    /// `sqrt`
    pub(crate) fn root(&mut self, call: Call<'_>) -> Option<Typed> {
        let (t, expr) = self.one(call, Sign::Matters)?;
        let Type::Number(dim) = t.ty else {
            self.shape("the argument of `sqrt`", "a number", t.ty, expr.span, None);
            return None;
        };
        let root = match dim {
            Dim::Any => Some(Dim::Any),
            Dim::Of(d) => d.sqrt().map(Dim::Of),
        };
        let Some(root) = root else {
            let base = dim.known();
            let what = format!("the square root of {}", phrase(base));
            let help = Some("add the missing square: the square root of an area is a length".to_owned());
            self.error(no_power(&what, expr.span, base, help));
            return None;
        };
        if let Some(Value::Scalar(x)) = t.value()
            && x < 0.0
        {
            self.without_value("the square root of a negative number", call.span, &t, expr);
            return None;
        }
        let t = apply(Function::Sqrt, Type::Number(root), [t]);
        self.finite(t, "the square root of a negative number", call.span)
    }

    /// `atan2`
    pub(crate) fn atan2(&mut self, call: Call<'_>) -> Option<Typed> {
        let args = self.arguments(call, 2, 2)?;
        let (y, x) = (self.read(args[0]), self.read(args[1]));
        let (y, x) = (y?, x?);
        let fits = match (y.ty, x.ty) {
            (Type::Number(a), Type::Number(b)) => a.unify(b).is_some(),
            _ => false,
        };
        if !fits {
            self.operands("compared", &y, &x, args[0], args[1]);
            return None;
        }
        Some(apply(Function::Atan2, Type::number(Dimension::ANGLE), [y, x]))
    }

    /// `mag`
    pub(crate) fn magnitude(&mut self, call: Call<'_>) -> Option<Typed> {
        let (t, expr) = self.one(call, Sign::Free)?;
        match t.ty {
            Type::Vector(dim) => Some(apply(Function::Mag, Type::Number(dim), [t])),
            Type::Number(_) => Some(apply(Function::Abs, t.ty, [t])),
            Type::Bool => {
                self.shape("the argument of `mag`", "a vector", t.ty, expr.span, None);
                None
            }
        }
    }

    fn is_vector_argument(&mut self, t: &Typed, call: Call<'_>, expr: &Expr) -> Option<()> {
        if matches!(t.ty, Type::Vector(_)) || t.pending {
            return Some(());
        }
        self.shape(&format!("the argument of `{}`", call.name.node), "a vector", t.ty, expr.span, None);
        None
    }

    /// `dot`, `cross`
    pub(crate) fn product(&mut self, call: Call<'_>, f: Function) -> Option<Typed> {
        let args = self.arguments(call, 2, 2)?;
        let (a, b) = (self.read(args[0]), self.read(args[1]));
        let (a, b) = (a?, b?);
        self.is_vector_argument(&a, call, args[0])?;
        self.is_vector_argument(&b, call, args[1])?;
        let dim = match (a.ty, b.ty) {
            (Type::Vector(x), Type::Vector(y)) => x.times(y),
            _ => Dim::Any,
        };
        Some(apply(f, Type::Number(dim), [a, b]))
    }

    /// `max` and `min` of two or more numbers.
    pub(crate) fn extreme(&mut self, call: Call<'_>, f: Function) -> Option<Typed> {
        let args = self.arguments(call, 2, usize::MAX)?;
        let read = args.iter().map(|a| self.read(a)).collect::<Vec<_>>();
        let read = read.into_iter().collect::<Option<Vec<_>>>()?;
        let mut dim = Dim::Any;
        for (t, expr) in read.iter().zip(&args) {
            let unified = match t.ty {
                Type::Number(d) => dim.unify(d),
                _ => None,
            };
            let Some(unified) = unified else {
                self.operands("compared", &read[0], t, args[0], expr);
                return None;
            };
            dim = unified;
        }
        Some(apply(f, Type::Number(dim), read))
    }
}

fn apply(f: Function, ty: Type, args: impl IntoIterator<Item = Typed>) -> Typed {
    let args = args.into_iter().collect::<Vec<_>>();
    let pending = args.iter().any(|t| t.pending);
    let args = args.into_iter().map(|t| t.expr).collect();
    let expr = if pending { ModelExpr::Constant(Value::Scalar(0.0)) } else { fold::call(f, args) };
    Typed { expr, ty, pending }
}
