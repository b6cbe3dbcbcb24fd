//! What pest makes of the grammar.

pub use parser::{Grammar, Rule};

mod parser {
    #[derive(pest_derive::Parser)]
    #[grammar = "../../../grammar/mech.pest"]
    pub struct Grammar;
}
