//! The program as run from a shell.

mod accuracy;
mod agents;
#[cfg(feature = "arrow")]
mod arrow;
mod asked;
mod batch;
mod cli;
mod course;
mod draw;
mod draw_gif;
mod draw_png;
mod fix;
mod fmt;
#[path = "../folder/mod.rs"]
mod folder;
mod formats;
mod grade;
mod kept_files;
#[cfg(feature = "lsp")]
mod lsp;
mod lsp_answers;
mod lsp_changes;
mod lsp_clients;
mod lsp_documents;
mod lsp_edits;
mod lsp_typing;
mod motions;
mod output;
mod plan;
mod preview;
mod profile;
mod reply;
mod report;
mod row_names;
mod run;
mod schema;
#[path = "../share/mod.rs"]
mod share;
mod sheets;
mod solve;
mod start;
mod tour;
