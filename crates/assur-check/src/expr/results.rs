//! Functions of results, as expressions see them: they stand above, since they ask for links, pairs and loads.

use crate::expr::context::Context;
use crate::statements::written::written;
use crate::values::typed::Typed;
use assur_syntax::document::{Arg, BinaryOp, Expr, ExprKind, Name};
use assur_text::diagnostic::Diagnosis;
use assur_text::source::Span;

/// A call as the functions of results see it.
#[derive(Clone, Copy)]
pub(crate) struct Call<'c> {
    pub name: &'c Name,
    pub args: &'c [Arg],
    pub span: Span,
    /// Whether the sign of the result matters.
    pub sign: Sign,
}

/// What expressions leave to the functions of results.
#[derive(Clone, Copy)]
pub struct Results {
    /// A function of results, or an error if there is no such function.
    pub call: fn(&mut Context<'_>, Call<'_>) -> Option<Typed>,
    /// A part of a result that has named parts, of a whole expression with its base; `None` where the base is something
    /// else.
    pub part: fn(&mut Context<'_>, &Expr, &Expr, &Name) -> Option<Option<Typed>>,
    /// Reports a name that stands for no quantity.
    pub unknown: fn(&mut Context<'_>, &Name),
    /// How a function is called in the file at hand.
    pub usage: fn(&mut Context<'_>, Call<'_>) -> String,
}

impl Context<'_> {
    /// The arguments, if there are as many as there should be and none has a name.
    pub(crate) fn arguments<'c>(
        &mut self,
        call: Call<'c>,
        least: usize,
        most: usize,
    ) -> Option<Vec<&'c Expr>> {
        let named = call.args.iter().find_map(|a| a.name.as_ref());
        if let Some(name) = named {
            let without = |a: &Arg| {
                Some(match (&a.name, &a.value.kind) {
                    (_, ExprKind::Compare(..)) => return None,
                    _ => written(&a.value)?,
                })
            };
            let plain = call.args.iter().map(without).collect::<Option<Vec<_>>>();
            let plain = plain.filter(|all| (least..=most).contains(&all.len()));
            let usage = match plain {
                Some(all) => format!("{}({})", call.name.node, all.join(", ")),
                None => (self.results.usage)(self, call),
            };
            let wanted = "a value without a name".to_owned();
            self.error(wrong_argument(&call.name.node, &wanted, name.span, &usage));
            return None;
        }
        if (least..=most).contains(&call.args.len()) {
            return Some(call.args.iter().map(|a| &a.value).collect());
        }
        let takes = match (least, most) {
            (0, 0) => "no argument",
            (0, 1) => "at most one argument",
            (1, 1) => "one argument",
            (1, 2) => "one or two arguments",
            (2, 2) => "two arguments",
            (3, 3) => "three arguments",
            _ => "other arguments",
        };
        let function = call.name.node.clone();
        let found = call.args.len();
        let usage = match apart(call) {
            Some(both) if least == 2 => format!("{function}({both})"),
            _ => (self.results.usage)(self, call),
        };
        self.error(argument_count(&function, takes, found, call.span, &usage));
        None
    }

    /// Reports an argument of the wrong kind.
    pub(crate) fn wrong_argument(&mut self, call: Call<'_>, wanted: &str, span: Span) {
        let (function, usage) = (call.name.node.clone(), (self.results.usage)(self, call));
        self.error(wrong_argument(&function, wanted, span, &usage));
    }
}

/// `B, E` for the one argument `B - E`.
fn apart(call: Call<'_>) -> Option<String> {
    let [Arg { value: Expr { kind: ExprKind::Chain(first, rest), .. }, .. }] = call.args else { return None };
    let [(op, second)] = rest.as_slice() else { return None };
    let is_name = |e: &Expr| matches!(e.kind, ExprKind::Name(_) | ExprKind::Member(..));
    let both = op.node == BinaryOp::Subtract && is_name(first) && is_name(second);
    both.then(|| Some(format!("{}, {}", written(first)?, written(second)?))).flatten()
}

/// An argument of the wrong kind.
pub fn wrong_argument(function: &str, wanted: &str, span: Span, usage: &str) -> Diagnosis {
    Diagnosis::error("mech::request::argument", format!("`{function}` takes {wanted} here"))
        .primary(span, format!("{wanted} is expected"))
        .help(format!("write `{usage}`"))
}

/// A function with too few or too many arguments.
pub fn argument_count(
    function: &str,
    takes: &'static str,
    found: usize,
    span: Span,
    usage: &str,
) -> Diagnosis {
    Diagnosis::error("mech::request::arguments", format!("`{function}` takes {takes}, found {found}"))
        .primary(span, format!("{found} given"))
        .help(format!("write `{usage}`"))
}

// Whether the sign of an expression matters.

/// Whether the sign of a value matters where it stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sign {
    Matters,
    /// Only the magnitude is asked: within `mag()` and `abs()`.
    Free,
}
