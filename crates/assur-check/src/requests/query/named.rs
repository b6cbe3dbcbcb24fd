//! Functions whose arguments have names: `journal_torque(load = 5 kN, …)`.

use crate::expr::context::Context;
use crate::expr::results::Call;
use crate::statements::written::written;
use crate::values::typed::Typed;
use assur_model::model::{Expr as ModelExpr, FormulaCall, Value};
use assur_syntax::document::Expr;
use assur_text::diagnostic::{Diagnosis, Help};
use assur_text::language::{Function, Takes};

/// The arguments given, by name.
pub(super) struct Given<'e> {
    values: Vec<(&'static str, ModelExpr)>,
    /// Arguments that are no plain values, as they are written.
    others: Vec<(&'static str, &'e Expr)>,
    /// One of them cannot be solved yet.
    pub(super) pending: bool,
}

impl<'e> Given<'e> {
    /// A value, where it is given.
    pub(super) fn value(&self, name: &str) -> Option<ModelExpr> {
        self.values.iter().find(|(n, _)| *n == name).map(|(_, value)| value.clone())
    }

    /// A value that is not optional: it is there.
    pub(super) fn must(&self, name: &str) -> ModelExpr {
        self.value(name).unwrap_or(ModelExpr::number(f64::NAN))
    }

    /// An argument that is no plain value, where it is given.
    pub(super) fn other(&self, name: &str) -> Option<&'e Expr> {
        self.others.iter().find(|(n, _)| *n == name).map(|(_, expr)| *expr)
    }

    /// The values, where all are numbers.
    fn numbers(&self) -> Option<Vec<(&'static str, f64)>> {
        let number = |(name, value): &(&'static str, ModelExpr)| match value {
            ModelExpr::Constant(Value::Scalar(x)) => Some((*name, *x)),
            _ => None,
        };
        self.values.iter().map(number).collect()
    }

    fn has(&self, name: &str) -> bool {
        self.values.iter().any(|(n, _)| *n == name) || self.others.iter().any(|(n, _)| *n == name)
    }
}

impl Context<'_> {
    /// Keeps a formula of a machine element whose numbers are known, once.
    pub(super) fn keep_formula(&mut self, function: Function, given: &Given<'_>, found: &Typed) {
        let (Some(values), Some(Value::Scalar(result))) = (given.numbers(), found.value()) else { return };
        let formula = FormulaCall { function, values, result };
        let formulas = &mut self.builder.mech.formulas;
        if result.is_finite() && !formulas.contains(&formula) {
            formulas.push(formula);
        }
    }

    /// The named arguments of a function; reports those that are unknown, repeated or missing.
    pub(super) fn named_arguments<'e>(&mut self, call: Call<'e>, function: Function) -> Option<Given<'e>> {
        let known = function.row().forms.iter().flat_map(|form| form.takes);
        let mut given = Given { values: Vec::new(), others: Vec::new(), pending: false };
        for arg in call.args {
            let Some(name) = &arg.name else {
                let named =
                    |name: &str| call.args.iter().any(|a| a.name.as_ref().is_some_and(|n| n.node == name));
                let next = known.clone().find(|a| !a.optional && !given.has(a.name) && !named(a.name));
                match next.zip(written(&arg.value)) {
                    Some((next, value)) => self.error(
                        Diagnosis::error(
                            "mech::request::argument",
                            format!("`{}` takes arguments with their names", call.name.node),
                        )
                        .primary(arg.value.span, "the name is missing")
                        .help(Help::write(arg.value.span, &[format!("{} = {value}", next.name)])),
                    ),
                    None => self.wrong_argument(call, "an argument with a name", arg.value.span),
                }
                return None;
            };
            let Some(argument) = known.clone().find(|a| a.name == name.node) else {
                self.wrong_argument(call, "another argument", name.span);
                return None;
            };
            let key = argument.name;
            if given.has(key) {
                self.wrong_argument(call, &format!("`{key}` only once"), name.span);
                return None;
            }
            let Takes::Value(Some(dimension)) = argument.takes else {
                given.others.push((key, &arg.value));
                continue;
            };
            let t = self.read(&arg.value)?;
            let t = self.fit(t, dimension, &format!("`{key}`"), &arg.value)?;
            given.pending |= t.pending;
            given.values.push((key, t.expr));
        }
        if let Some(missing) = known.clone().find(|a| !a.optional && !given.has(a.name)) {
            self.wrong_argument(call, &format!("also `{} = …`", missing.name), call.span);
            return None;
        }
        Some(given)
    }
}
