//! The repository holds to its own pages: floors, snippets, reference scripts.

mod architecture;
mod docs;
#[path = "../folder/mod.rs"]
mod folder;
mod reference_scripts;
