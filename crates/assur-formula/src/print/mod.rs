//! Lines in the formats of documents.

mod latex;
mod mathml;
mod text;
mod typst;

pub use latex::{latex, latex_lines, unit_latex};
pub use mathml::{mathml, mathml_lines};
pub use text::{text, text_lines};
pub use typst::{typst, typst_lines};

/// Whether letters are Latin or Greek and slanted as quantities are.
fn is_single(letters: &str) -> bool {
    letters.chars().filter(|c| !matches!(c, '′' | '″')).count() == 1
}
