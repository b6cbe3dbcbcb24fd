//! `assur check`

use super::args::Problem;
use super::reply::{Reply, Status, for_each_file};
use super::screen::Screen;
use crate::report;

/// Prints what the mechanisms are built from.
pub fn run(args: &Problem, screen: &Screen) -> Status {
    let overrides = args.overrides();
    for_each_file(&args.files, screen, "\n", |source| {
        let (compiled, problems) = crate::compile(source, &overrides);
        let results = compiled.map_or_else(String::new, |c| {
            report::text::render(&report::of_structure(source, &c.scene()), screen.look())
        });
        Reply::new(results, &problems, source, screen)
    })
}
