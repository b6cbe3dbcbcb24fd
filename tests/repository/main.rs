//! The repository holds to its own pages: floors, snippets, reference scripts.

mod architecture;
mod docs;
mod editors;
mod floors;
#[path = "../folder/mod.rs"]
mod folder;
mod language_tables;
mod pages;
mod plain_words;
mod reference_scripts;
#[path = "../share/mod.rs"]
mod share;
