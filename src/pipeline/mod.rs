//! Read, compile, solve, and solve again with other values.

mod agrees;
mod closing;
mod compile;
mod critical;
mod dimensions;
mod equilibrium;
mod file_variants;
mod followed;
mod lost;
mod mends;
mod open_sizes;
mod repeated;
mod solved;
mod test;
mod turn;
mod variant_solver;
mod vibration;

pub use compile::assembly_clauses;
pub use compile::{CompileFindings, Compiled, Origin, analyze, check_source, compile, compile_document};
pub use compile::{certain_edits, fixed};
pub use dimensions::dimensions;
pub use file_variants::{FileVariants, SolvedRow, file_row_words, look_at, row_words};
pub use followed::{Followed, Sink, followed, is_long, most_positions};
pub use solved::{
    Solved, solve, solve_conducted, solve_each, solve_source, solve_source_conducted, solve_within,
};
pub use solved::{planned_to_draw, solve_document_drawn, solve_drawn, solve_drawn_conducted};
pub use test::{diagnose, test_document, test_source, test_text};
pub use turn::elsewhere;
pub use turn::{turn, turn_in, turn_with_effects};
pub use variant_solver::VariantSolver;
