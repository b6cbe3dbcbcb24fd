//! Parts of a motion under loads: `max(x, after = 2 s, before = time(stopped))`.

use crate::expr::context::Context;
use crate::expr::positive::Want;
use crate::expr::results::Call;
use crate::motion::simulation::{meaningless, statement, without_meaning};
use crate::names::suggestion::wrong_kind;
use crate::statements::written::text;
use crate::values::format_value::format_value;
use assur_model::model::{Bound, Expr as ModelExpr, Part, Query};
use assur_syntax::document::{Expr, ExprKind, Name};
use assur_text::language::Function;
use assur_text::units::Dimension;

impl Context<'_> {
    /// What a function over a motion is taken of, and over which part.
    pub(super) fn value_and_part<'c>(&mut self, call: Call<'c>) -> Option<(&'c Expr, Part)> {
        if !call.args.iter().any(|arg| arg.name.is_some()) {
            return Some((self.arguments(call, 1, 1)?[0], Part::default()));
        }
        if statement(self).is_none() {
            return self.no_part_of_sweep(call);
        }
        let (mut value, mut part) = (None, Part::default());
        for arg in call.args {
            let place = match arg.name.as_ref().map(|name| name.node.as_str()) {
                None if value.is_none() => {
                    value = Some(&arg.value);
                    continue;
                }
                Some("after") if part.after.is_none() => &mut part.after,
                Some("before") if part.before.is_none() => &mut part.before,
                _ => {
                    let wanted = "one value, and behind it `after = …` and `before = …`,";
                    self.wrong_argument(call, wanted, arg.value.span);
                    return None;
                }
            };
            *place = Some(self.bound(&arg.value)?);
        }
        let Some(value) = value else {
            self.wrong_argument(call, "also the value", call.span);
            return None;
        };
        if let (Some(Bound::At(after)), Some(Bound::At(before))) = (part.after, part.before)
            && after >= before
        {
            let instant = |t| format_value(t, Dimension::TIME);
            let what =
                format!("a part of the motion after {} and before {}", instant(after), instant(before));
            let help = "let `after` be the earlier instant, as in `after = 1 s, before = 2 s`".to_owned();
            self.error(without_meaning(&what, &help, call.span));
            return None;
        }
        Some((value, part))
    }

    /// Reports the part of what is no motion under loads.
    fn no_part_of_sweep<T>(&mut self, call: Call<'_>) -> Option<T> {
        let ends = |name: &&Name| matches!(name.node.as_str(), "after" | "before");
        let Some(end) = call.args.iter().filter_map(|arg| arg.name.as_ref()).find(ends) else {
            // reports the name
            self.arguments(call, 1, 1)?;
            return None;
        };
        let what = format!("the bound `{}` of a part of the motion", end.node);
        let drive = self.swept_drive().map_or_else(|| "crank".to_owned(), |drive| text(&drive.target));
        let help = format!(
            "let the drive go through that part alone, as in `drive {drive} = 0 deg .. 120 deg in 12 steps`, and \
             leave `after` and `before` out"
        );
        self.error(meaningless(&what, "where the motion is given", &help, end.span));
        None
    }

    /// An instant that is known beforehand, or that of an event.
    fn bound(&mut self, expr: &Expr) -> Option<Bound> {
        if let ExprKind::Name(name) = &expr.kind
            && self.names.events.contains_key(name)
        {
            let help = format!("write `time({name})`");
            self.error(wrong_kind(name, "an event", "an instant", expr.span, None, Some(help)));
            return None;
        }
        if let ExprKind::Call { function, .. } = &expr.kind
            && Function::named(&function.node) == Some(Function::Time)
        {
            return match self.read(expr)?.expr {
                ModelExpr::Query(Query::EventTime(event, which)) => Some(Bound::Event(event, which)),
                _ => None,
            };
        }
        let instant = self.scalar_constant(expr, &Want(Dimension::TIME), "an end of a part of the motion")?;
        Some(Bound::At(instant))
    }
}
