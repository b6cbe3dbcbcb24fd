//! `assur`: a small declarative language for planar mechanism problems, and the compiler that solves them.

#[cfg(feature = "cli")]
pub mod cli;
pub mod exercise;
pub mod report;

pub use assur_check as check;
pub use assur_math::{element, force, group, math};
pub use assur_model::{model, structure};
pub use assur_solve::{answer, measure, message, plan, position, reference, solve};
pub use assur_syntax as syntax;
pub use assur_text::{diagnostic, source, units};
pub use measure::accuracy;

use accuracy::Reached;
use check::Overrides;
use diagnostic::{DiagnosticView, Problems};
use exercise::{Followed, Outcome, OwnRows, followed};
use model::Mechanism;
use plan::Plan;
use solve::{Pose, Scene, Solution};
use source::Source;
use structure::Structure;

/// A checked mechanism with its structure and its plan.
#[derive(Debug)]
pub struct Compiled {
    /// The mechanism.
    pub mechanism: Mechanism,
    /// What it is built from.
    pub structure: Structure,
    /// How it is solved.
    pub plan: Plan,
    /// What it was compiled from, where its answers take other solutions: see [`Mechanism::asks_again`].
    pub origin: Option<Origin>,
}

/// A text with the values that replace some of its own.
#[derive(Clone, Debug)]
pub struct Origin {
    /// The text.
    pub source: Source,
    /// The values.
    pub overrides: Overrides,
}

/// A compiled mechanism, solved, with what became of its expectations.
#[derive(Debug)]
pub struct Solved {
    /// What was solved.
    pub compiled: Compiled,
    /// Its poses.
    pub solution: Solution,
    /// Its expectations, one per pose.
    pub outcomes: Vec<Outcome>,
    /// What accuracy was wanted and reached, where one was.
    pub reached: Option<Reached>,
}

/// Text → [`Mechanism`], with all that was found on the way. No mechanism comes out where there is an error.
#[must_use]
pub fn check_source(source: &Source, overrides: &Overrides) -> (Option<Mechanism>, Problems) {
    let (document, mut problems) = syntax::parse(source);
    let (mechanism, found) = check::check(&document, overrides);
    problems.append_later(found);
    (mechanism.filter(|_| !problems.has_errors()), problems)
}

/// Text → [`Compiled`]: checked, decomposed into structural groups, planned. Nothing is solved. What is compiled can be
/// looked at even where the problems hold an error: that forces are asked for which are not determined.
#[must_use]
pub fn compile(source: &Source, overrides: &Overrides) -> (Option<Compiled>, Problems) {
    let (mechanism, problems) = check_source(source, overrides);
    let Some(mechanism) = mechanism else { return (None, structure_first(source, overrides, problems)) };
    let origin =
        mechanism.asks_again().then(|| Origin { source: source.clone(), overrides: overrides.clone() });
    plan_mechanism(mechanism, None, problems, origin)
}

/// The defects of the structure in place of errors that all follow from them: names of a pair that is missing, and guides
/// that no pair makes.
fn structure_first(source: &Source, overrides: &Overrides, problems: Problems) -> Problems {
    let (document, found) = syntax::parse(source);
    if found.has_errors() {
        return problems;
    }
    let Err(defects) = structure::structure(&check::sound_part(&document, overrides)) else {
        return problems;
    };
    let mut structural = found;
    structural.extend(defects);
    let proposed = structural.views(source).iter().flat_map(proposed_names).collect::<Vec<_>>();
    let follows = |d: &DiagnosticView| {
        d.severity != "error"
            || d.code.as_deref() == Some("mech::geometry::no_guide")
            // a pair that is there and has an error is not missing
            || d.code.as_deref().is_some_and(|code| code.starts_with("mech::name::"))
                && proposed.iter().any(|name| d.message.contains(&format!("`{name}`")))
    };
    let views = problems.views(source);
    if problems.has_errors() && views.iter().all(follows) { structural } else { problems }
}

/// The names of the pairs that a help proposes to add.
fn proposed_names(defect: &DiagnosticView) -> Vec<String> {
    let lines = defect.help.iter().flat_map(|help| help.lines()).filter(|line| line.starts_with("  "));
    lines.filter_map(|line| Some(line.trim().split_once(':')?.0.split_once(' ')?.1.to_owned())).collect()
}

/// Structure and plan of a mechanism; the structure is known where another row of the same text has the same.
fn plan_mechanism(
    mechanism: Mechanism,
    known: Option<Structure>,
    mut problems: Problems,
    origin: Option<Origin>,
) -> (Option<Compiled>, Problems) {
    let found = known.map_or_else(|| structure::structure(&mechanism), |known| Ok((known, Vec::new())));
    match found {
        Ok((structure, warnings)) => {
            problems.extend(warnings);
            let plan = plan::plan(&mechanism, &structure);
            problems.extend(structure.force_defect.clone().filter(|_| plan.effects.forces));
            (Some(Compiled { mechanism, structure, plan, origin }), problems)
        }
        Err(errors) => {
            problems.extend(errors);
            (None, problems)
        }
    }
}

/// Solves what was compiled and holds it against its answer key. A failed expectation is an outcome, not a problem; one
/// that cannot be evaluated is a problem, and so are more positions than can be kept: see [`solve_each`].
pub fn solve(compiled: Compiled) -> (Result<Solved, Compiled>, Problems) {
    let found = followed(&compiled.scene(), compiled.origin.as_ref(), None);
    evaluated(compiled, found)
}

/// As [`solve()`], however many positions there are: each is handed out, with the answers to what needs none, and of many
/// those alone are kept that an expectation names. Nothing comes out, and nothing is said, where `each` stops it.
pub fn solve_each(
    compiled: Compiled,
    each: &mut dyn FnMut(&report::Answers<'_>, &Pose) -> bool,
) -> (Result<Solved, Compiled>, Problems) {
    let (mechanism, structure, plan) = (&compiled.mechanism, &compiled.structure, &compiled.plan);
    let scene = Scene { mechanism, structure, plan };
    let precision = report::Precision::READABLE;
    let mut answered = |solution: &Solution, pose: &Pose| {
        each(&report::Answers { scene, solution, outcomes: &[], reached: None, precision }, pose)
    };
    let found = followed(&scene, compiled.origin.as_ref(), Some(&mut answered));
    evaluated(compiled, found)
}

/// Holds a solution against its answer key.
fn evaluated(compiled: Compiled, found: Followed) -> (Result<Solved, Compiled>, Problems) {
    match found {
        Err(problems) => (Err(compiled), problems),
        Ok(None) => (Err(compiled), Problems::new()),
        Ok(Some((solution, mut problems))) => {
            let (outcomes, errors) = exercise::evaluate(&compiled.scene(), &solution);
            problems.extend(errors);
            (Ok(Solved { compiled, solution, outcomes, reached: None }), problems)
        }
    }
}

/// As [`solve()`], with the cheapest settings whose answers keep a wanted accuracy, see [`accuracy::candidates`]. Where none
/// do, the finest answer comes out beside an error.
pub fn solve_within(mut compiled: Compiled, within: Option<f64>) -> (Result<Solved, Compiled>, Problems) {
    let Some(wanted) = within else { return solve(compiled) };
    let mut candidates = accuracy::candidates(&compiled.scene(), wanted);
    candidates.reverse();
    while let Some(settings) = candidates.pop() {
        compiled.plan.settings = settings;
        let is_last = candidates.is_empty();
        let (found, mut problems) = solve(compiled);
        compiled = match found {
            Ok(mut solved) => {
                let reached = accuracy::reached(&solved.compiled.scene(), &solved.solution, wanted);
                if reached.is_kept() || is_last {
                    let missed = (!reached.is_kept()).then(|| reached.missed(&solved.compiled.mechanism));
                    problems.extend(missed);
                    solved.reached = Some(reached);
                    return (Ok(solved), problems);
                }
                solved.compiled
            }
            Err(compiled) if is_last => return (Err(compiled), problems),
            Err(compiled) => compiled,
        };
    }
    (Err(compiled), Problems::new())
}

/// Text → [`Solved`], with all that was found on the way. A solution comes out even where an expectation cannot be
/// evaluated.
#[must_use]
pub fn solve_source(source: &Source, overrides: &Overrides) -> (Option<Solved>, Problems) {
    let (compiled, mut problems) = compile(source, overrides);
    let Some(compiled) = compiled.filter(|_| !problems.has_errors()) else { return (None, problems) };
    let (solved, found) = solve(compiled);
    problems.append(found);
    (solved.ok(), problems)
}

/// Text → [`Solved`], with all that was found on the way, failed expectations among it. A text with variants is tested
/// with every row; the solution is that of the first row that has one.
#[must_use]
pub fn test_source(source: &Source, overrides: &Overrides) -> (Option<Solved>, Problems) {
    let (document, mut problems) = syntax::parse(source);
    if let (false, Some(rows)) = (problems.has_errors(), OwnRows::of(source, &document, overrides)) {
        let mut first = None;
        match rows {
            Ok(rows) => rows.solve(true).for_each(|row| {
                problems.append(row.problems);
                first = first.take().or(row.solved);
            }),
            Err(found) => problems.append(found),
        }
        return (first, problems);
    }
    let (compiled, mut problems) = compile(source, overrides);
    let Some(compiled) = compiled.filter(|_| !problems.has_errors()) else { return (None, problems) };
    let (solved, found) = solve_each(compiled, &mut |_, _| true);
    problems.append(found);
    let solved = solved.ok();
    if let Some(solved) = &solved {
        let failed = exercise::mismatches(&solved.outcomes);
        let opens = problems.has("mech::assembly::partial_sweep");
        let failed = if opens { exercise::in_one(failed) } else { failed };
        problems.extend(exercise::in_other_assembly(solved, source, overrides, failed));
    }
    (solved, problems)
}

/// What the author of a text is told about it, failed expectations included, without colour, 100 columns wide; empty
/// where nothing is wrong.
#[must_use]
pub fn diagnose(source: &Source) -> String {
    let (_, problems) = test_source(source, &Overrides::none());
    diagnostic::render(&problems, source, diagnostic::Style::PLAIN)
}

impl Compiled {
    /// As the solver sees it.
    #[must_use]
    pub fn scene(&self) -> Scene<'_> {
        Scene { mechanism: &self.mechanism, structure: &self.structure, plan: &self.plan }
    }
}

impl Solved {
    /// As a report sees it.
    #[must_use]
    pub fn answers(&self, precision: report::Precision) -> report::Answers<'_> {
        let scene = self.compiled.scene();
        let reached = self.reached.as_ref();
        report::Answers { scene, solution: &self.solution, outcomes: &self.outcomes, reached, precision }
    }
}
