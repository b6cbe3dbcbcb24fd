//! Which calls ask for results.

use crate::names::declared::Names;
use assur_syntax::document::{Arg, Expr, ExprKind};
use assur_text::language::Function;

impl Names<'_> {
    /// Whether a call asks for something that is known only once the mechanism is solved.
    pub fn is_result(&self, function: &str, args: &[Arg]) -> bool {
        match Function::named(function) {
            Some(Function::Dir) => match args {
                [Arg { value: Expr { kind: ExprKind::Name(name), .. }, .. }] => {
                    !self.quantities.contains_key(name)
                }
                _ => false,
            },
            Some(Function::Max | Function::Min) => args.len() == 1,
            function => function.is_some_and(|f| f.row().is_result()),
        }
    }
}
