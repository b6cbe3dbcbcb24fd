//! How well the answers satisfy equations that were not used to find them.

use super::answers::{Answers, NONE, PrintedDigits};
use super::document::{Column, Report, Section, Table};
use super::{cycle, simulation};
use assur_solve::solve::{Pose, Residuals, Solved};
use assur_text::units::significant;

/// How much is shown of the accuracy.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AccuracyShown {
    /// The worst of all poses, in one line.
    Worst,
    /// A row for every pose.
    EveryPose,
}

const DIGITS: usize = 3;
/// Conditions that differ by a smaller part are equal but for rounding.
const EQUAL: f64 = 1e-9;

/// Residuals and condition: the worst of all poses, or those of each.
pub(super) fn section(answers: &Answers<'_>, shown: AccuracyShown, report: &mut Report) {
    let poses: Vec<(&Pose, &Solved)> =
        answers.poses().filter_map(|p| Some((p, p.outcome.as_ref().ok()?))).collect();
    let precision = answers.precision;
    let mut section = Section::new("Accuracy: residuals of independent equations, condition (1 is best)");
    if let Some(reached) = answers.reached {
        section.text(super::tradeoff::reached(reached));
    }
    simulation::lines(answers).into_iter().for_each(|line| section.text(line));
    match shown {
        AccuracyShown::Worst => {
            worst(answers, &poses).into_iter().for_each(|line| section.text(line));
            // of a motion under loads its error says it
            let cycles = cycle::worst_error(answers).filter(|_| answers.solution.simulation.is_none());
            let line = cycles.map(|e| format!("relative error over the sweep: {}", order_of(e, precision)));
            line.into_iter().for_each(|line| section.text(line));
        }
        AccuracyShown::EveryPose => {
            super::cost::line(answers).into_iter().for_each(|line| section.text(line));
            section.table(table(answers, &poses));
            section.table(cycle::accuracy(answers, |r| order_of(r, precision)));
        }
    }
    report.section(section);
}

/// The three residuals of a pose by their names; those of forces where there are forces.
fn named(residuals: Residuals) -> [(&'static str, Option<f64>); 3] {
    let Residuals { closure, equilibrium, power } = residuals;
    [("closure", Some(closure)), ("equilibrium", equilibrium), ("power", power)]
}

/// One line: the greatest of each residual, and the least condition with its pose.
fn worst(answers: &Answers<'_>, poses: &[(&Pose, &Solved)]) -> Option<String> {
    let precision = answers.precision;
    let ((mut pose, first), others) = poses.split_first().map(|(first, others)| (*first, others))?;
    let (mut greatest, mut condition) = (named(first.residuals), first.condition);
    for (other, solved) in others {
        for (most, (_, residual)) in greatest.iter_mut().zip(named(solved.residuals)) {
            most.1 = [most.1, residual].into_iter().flatten().reduce(f64::max);
        }
        if solved.condition < condition * (1.0 - EQUAL) {
            (pose, condition) = (other, solved.condition);
        }
    }
    let residuals =
        greatest.iter().filter_map(|(name, r)| Some(format!("{name} {}", order_of((*r)?, precision))));
    let figures = residuals.chain([format!("condition {}", significant(condition, DIGITS))]);
    let figures = figures.collect::<Vec<_>>().join(", ");
    Some(match others {
        [] => figures,
        _ => format!("worst of {} poses: {figures} {}", poses.len(), answers.at_pose(&pose.name)),
    })
}

/// A row per pose.
fn table(answers: &Answers<'_>, poses: &[(&Pose, &Solved)]) -> Table {
    let (with_pose, precision) = (poses.len() > 1, answers.precision);
    let mut columns = Vec::new();
    if with_pose {
        columns.push(Column::words(answers.pose_header()));
    }
    columns.extend(["closure", "equilibrium", "power", "condition"].map(Column::right));
    let mut table = Table::new(columns, usize::from(with_pose));
    for (pose, solved) in poses {
        let mut cells: Vec<String> = with_pose.then(|| pose.name.clone()).into_iter().collect();
        for (_, residual) in named(solved.residuals) {
            cells.push(residual.map_or_else(|| NONE.to_owned(), |r| order_of(r, precision)));
        }
        cells.push(significant(solved.condition, DIGITS));
        table.row(cells);
    }
    table
}

/// A residual in one figure, or the power of ten it stays below.
pub(super) fn order_of(residual: f64, precision: PrintedDigits) -> String {
    if !precision.coarse_residuals {
        return if residual == 0.0 { "0".to_owned() } else { format!("{residual:.0e}") };
    }
    let bounds = [(1e-12, "< 1e-12"), (1e-9, "< 1e-9"), (1e-6, "< 1e-6"), (1e-3, "< 1e-3")];
    let bound = bounds.iter().find(|b| residual < b.0);
    bound.map_or("large", |b| b.1).to_owned()
}
