//! What pest makes of the grammar.

pub use parser::{Grammar, Rule};

#[allow(missing_docs)]
mod parser {
    #[derive(pest_derive::Parser)]
    #[grammar = "../../../grammar/mech.pest"]
    pub struct Grammar;
}
