//! Which calls ask for results.

use crate::names::declared::Names;
use crate::names::functions::FUNCTIONS;
use assur_syntax::document::{Arg, Expr, ExprKind};

impl Names<'_> {
    /// Whether a call asks for something that is known only once the mechanism is solved.
    pub fn is_result(&self, function: &str, args: &[Arg]) -> bool {
        match function {
            "dir" => match args {
                [Arg { value: Expr { kind: ExprKind::Name(name), .. }, .. }] => {
                    !self.quantities.contains_key(name)
                }
                _ => false,
            },
            "max" | "min" => args.len() == 1,
            _ => FUNCTIONS.iter().any(|f| f.name == function && f.result),
        }
    }
}
