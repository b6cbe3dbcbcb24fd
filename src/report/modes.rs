//! All assemblies of every group at the first pose.

use super::document::{Column, Section, Table};
use assur_solve::message::{clause, place};
use assur_solve::solve::{Assemblies, Model};

/// One row per assembly.
pub(super) fn section(model: &Model<'_>, modes: &Assemblies) -> Section {
    let mut columns = vec![Column::right("#"), Column::words("kind")];
    columns.push(Column::right("assembly"));
    columns.push(Column::right("condition"));
    columns.extend(["chosen", "selected by"].map(Column::words));
    let mut table = Table::new(columns, 3);
    for group in &modes.groups {
        let structure = &model.structure.motion[group.group];
        for (i, mode) in group.assemblies.iter().enumerate() {
            table.row(vec![
                (group.group + 1).to_string(),
                structure.kind_name().to_owned(),
                format!("{} of {}", i + 1, group.assemblies.len()),
                assur_text::units::significant(mode.condition, 3),
                if mode.chosen { "chosen" } else { "" }.to_owned(),
                mode.clause.as_ref().map(|c| clause(model, c)).unwrap_or_default(),
            ]);
        }
    }
    let mut section = Section::new(format!(
        "Assemblies{}",
        modes.pose.as_ref().map(|p| place(model, p)).unwrap_or_default()
    ));
    section.table(table);
    if modes.groups.iter().any(|g| g.searched) {
        section.text("The assemblies of general groups come from a search: there may be others.");
    }
    section
}
