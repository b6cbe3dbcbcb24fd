//! The program as run from a shell.

mod batch;
mod cli;
#[path = "../folder/mod.rs"]
mod folder;
mod formats;
mod grade;
mod output;
mod reply;
mod row_names;
mod run;
mod schema;
mod start;
