//! How well the answers satisfy equations that were not used to find them.

use super::answers::{Answers, NONE, Precision};
use super::document::{Column, Report, Section, Table};
use assur_solve::solve::{Pose, Solved};

/// Residuals and condition per pose; the worst of all where there are many.
pub(super) fn section(answers: &Answers<'_>, report: &mut Report) {
    let poses: Vec<(&Pose, &Solved)> =
        answers.poses().filter_map(|p| Some((p, p.outcome.as_ref().ok()?))).collect();
    let precision = answers.precision;
    let with_pose = poses.len() > 1;
    let mut columns = Vec::new();
    if with_pose {
        columns.push(Column::words("pose"));
    }
    columns.extend(["closure", "equilibrium", "power", "condition"].map(Column::right));
    let mut table = Table::new(columns, usize::from(with_pose));
    for (pose, solved) in &poses {
        let residuals = solved.residuals;
        let mut cells: Vec<String> = with_pose.then(|| pose.name.clone()).into_iter().collect();
        for residual in [Some(residuals.closure), residuals.equilibrium, residuals.power] {
            cells.push(residual.map_or_else(|| NONE.to_owned(), |r| order_of(r, precision)));
        }
        cells.push(assur_text::units::significant(solved.condition, 3));
        table.row(cells);
    }
    let mut section = Section::new("Accuracy: residuals of independent equations, condition (1 is best)");
    if let Some(reached) = answers.reached {
        section.text(super::tradeoff::reached(reached));
    }
    section.table(table);
    section.table(super::cycle::accuracy(answers, |r| order_of(r, precision)));
    report.section(section);
}

/// A residual in one figure, or the power of ten it stays below.
fn order_of(residual: f64, precision: Precision) -> String {
    if !precision.coarse_residuals {
        return if residual == 0.0 { "0".to_owned() } else { format!("{residual:.0e}") };
    }
    let bounds = [(1e-12, "< 1e-12"), (1e-9, "< 1e-9"), (1e-6, "< 1e-6"), (1e-3, "< 1e-3")];
    let bound = bounds.iter().find(|b| residual < b.0);
    bound.map_or("large", |b| b.1).to_owned()
}
