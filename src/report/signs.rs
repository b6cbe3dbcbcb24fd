//! Answers with a meaning by their sign: which forces drive and which resist, which links are pulled and which pushed.

use super::answers::{Answers, with_unit};
use super::document::{Column, Report, Section, Table};
use assur_model::model::{Expr, FindKind, Mechanism, Query};
use assur_solve::solve::Solved;
use assur_text::units::Dimension;

/// A power below this part of the greatest one is nothing.
const NOTHING: f64 = 1e-12;
/// Most poses that are named one by one.
const NAMED: usize = 3;

/// Numbers whose sign is what they are asked for.
struct Signed<'a> {
    title: &'static str,
    /// Heads of the first two columns.
    heads: [&'static str; 2],
    /// Head of the numbers at a single pose.
    single: Option<&'static str>,
    /// Above, below and at nothing.
    words: [&'static str; 3],
    dimension: Dimension,
    rows: Vec<(&'a str, &'a Expr)>,
}

/// One row per power that `find powers` asks for.
pub(super) fn powers(answers: &Answers<'_>, report: &mut Report) {
    let mechanism: &Mechanism = answers.model.mechanism;
    let Some((first, last)) = mechanism.powers else { return };
    let finds = mechanism.finds.get(first..last).unwrap_or_default();
    let rows = finds.iter().filter_map(|find| match &find.kind {
        FindKind::Value { expr, .. } => {
            let of = find.name.strip_prefix("power(").and_then(|name| name.strip_suffix(')'));
            Some((of.unwrap_or(&find.name), expr))
        }
        FindKind::Reactions | FindKind::Table(_) => None,
    });
    let powers = Signed {
        title: "Roles of forces",
        heads: ["power of", "role"],
        single: None,
        words: ["drives", "resists", "no power"],
        dimension: Dimension::POWER,
        rows: rows.collect(),
    };
    powers.section(answers, report);
}

/// One row per link whose axial force is asked for.
pub(super) fn bars(answers: &Answers<'_>, report: &mut Report) {
    let mechanism = answers.model.mechanism;
    let exprs: Vec<Expr> = mechanism.bars.iter().map(|bar| Expr::Query(Query::Axial(bar.link))).collect();
    let names = mechanism.bars.iter().map(|bar| mechanism.link(bar.link).name.as_str());
    let bars = Signed {
        title: "Axial forces",
        heads: ["link", "carries"],
        single: Some("force"),
        words: ["tension", "compression", "zero"],
        dimension: Dimension::FORCE,
        rows: names.zip(&exprs).collect(),
    };
    bars.section(answers, report);
}

impl Signed<'_> {
    fn section(&self, answers: &Answers<'_>, report: &mut Report) {
        let solved: Vec<(&str, &Solved)> = answers
            .poses()
            .filter_map(|p| Some((p.name.as_str(), p.outcome.as_ref().ok()?)))
            .filter(|(_, solved)| !solved.state.forces.locked)
            .collect();
        let values = |expr: &Expr| -> Vec<f64> {
            solved.iter().map(|(_, s)| answers.solution.view(&answers.model, s).scalar(expr)).collect()
        };
        let all: Vec<(&str, Vec<f64>)> = self.rows.iter().map(|(name, expr)| (*name, values(expr))).collect();
        if all.is_empty() || solved.is_empty() {
            return;
        }
        let finite = |x: &&f64| x.is_finite();
        let greatest =
            all.iter().flat_map(|(_, v)| v.iter().filter(finite)).fold(0.0, |m, x| f64::max(m, x.abs()));
        let display = answers.model.mechanism.display_of(self.dimension);
        let single = self.single.filter(|_| solved.len() == 1);
        let numbers = single.map_or(vec!["least", "greatest"], |head| vec![head]);
        let mut columns: Vec<Column> = self.heads.map(Column::words).into_iter().collect();
        columns.extend(numbers.iter().map(|head| Column::numbers(with_unit(head, &display.unit))));
        let mut table = Table::new(columns, 1);
        let figures = |x: f64| answers.precision.figures(display.of_si(x), display.of_si(greatest));
        let names: Vec<&str> = solved.iter().map(|(name, _)| *name).collect();
        for (name, values) in all {
            let least = values.iter().filter(finite).fold(f64::INFINITY, |m, x| m.min(*x));
            let most = values.iter().filter(finite).fold(f64::NEG_INFINITY, |m, x| m.max(*x));
            let word = self.word(&names, &values, NOTHING * greatest);
            let mut row = vec![name.to_owned(), word, figures(least)];
            row.extend(single.is_none().then(|| figures(most)));
            table.row(row);
        }
        let mut section = Section::new(self.title);
        section.table(table);
        report.section(section);
    }

    /// `drives`, `resists`, or at which poses it does which.
    fn word(&self, names: &[&str], values: &[f64], nothing: f64) -> String {
        let [above, below, none] = self.words;
        let at = |holds: &dyn Fn(f64) -> bool| -> Vec<&str> {
            names.iter().zip(values).filter(|(_, x)| holds(**x)).map(|(name, _)| *name).collect()
        };
        match (at(&|x| x > nothing).as_slice(), at(&|x| x < -nothing).as_slice()) {
            ([], []) => none.to_owned(),
            (_, []) => above.to_owned(),
            ([], _) => below.to_owned(),
            (a, b) => {
                format!("{above} at {}, {below} at {}", poses(a, names.len()), poses(b, names.len()))
            }
        }
    }
}

fn poses(names: &[&str], all: usize) -> String {
    if names.len() <= NAMED {
        format!("pose{} {}", if names.len() == 1 { "" } else { "s" }, names.join(", "))
    } else {
        format!("{} of {all} poses", names.len())
    }
}
