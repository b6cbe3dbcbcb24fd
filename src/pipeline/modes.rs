//! The clauses that choose between the assemblies of a mechanism at its first position.

use super::compile::Compiled;
use assur_solve::message::clause;
use assur_solve::solve::assemblies;

/// The clauses of all groups that have several assemblies, as they follow `assemble`; whether the file chooses so.
#[must_use]
pub fn assembly_clauses(compiled: &Compiled) -> Vec<(String, bool)> {
    let model = compiled.model();
    let groups = assemblies(&model).map(|found| found.groups).unwrap_or_default();
    let all = groups.iter().flat_map(|group| &group.assemblies);
    all.filter_map(|one| {
        let line = clause(&model, one.clause.as_ref()?);
        Some((line.strip_prefix("assemble ").unwrap_or(&line).to_owned(), one.chosen))
    })
    .collect()
}
