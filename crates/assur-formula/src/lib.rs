//! Formulas as trees, built once: printed as letters, as numbers and as a result, in text, LaTeX, MathML and Typst. A leaf has
//! its value from outside; nothing is solved here.

mod cyrillic;
mod equation;
mod evaluate;
mod expr;
mod lay;
mod lines;
mod node;
mod number;
mod operators;
mod print;
mod quantity;
mod unit;

pub use cyrillic::{cyrillic, header_in_cyrillic, units_in_cyrillic};
pub use equation::{Equation, Set};
pub use expr::{Expr, Function, Sign};
pub use lay::{letters, name_node};
pub use lines::Lines;
pub use node::Node;
pub use number::{Figures, with_decimals, with_digits};
pub use print::{latex, latex_lines, mathml, mathml_lines, text, text_lines, typst, typst_lines, unit_latex};
pub use quantity::Name;
pub use quantity::{Quantity, quantity, rounded};
pub use unit::{Unit, unit_words};
