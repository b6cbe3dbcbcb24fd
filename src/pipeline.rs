//! One way through: text → Document → Mechanism → Structure → Plan → Solution.

use crate::check::{Overrides, check};
use crate::diagnostic::Problems;
use crate::model::Mechanism;
use crate::plan::{Plan, plan};
use crate::solve::{Scene, Solution, solve};
use crate::source::Source;
use crate::structure::{Structure, structure};
use crate::syntax::parse;

/// A mechanism with its structure and plan, ready to be solved.
#[derive(Clone, Debug)]
pub struct Compiled {
    /// The mechanism.
    pub mechanism: Mechanism,
    /// What it is built from.
    pub structure: Structure,
    /// What is done at every position.
    pub plan: Plan,
}

impl Compiled {
    /// The three together, as solving and reporting take them.
    #[must_use]
    pub fn scene(&self) -> Scene<'_> {
        Scene { mechanism: &self.mechanism, structure: &self.structure, plan: &self.plan }
    }

    /// Solves all positions. Errors and warnings of the file as a whole go to `problems`, with those of the positions that
    /// failed.
    pub fn solve(&self, problems: &mut Problems) -> Option<Solution> {
        match solve(&self.scene()) {
            Ok(solution) => {
                solution.warnings.iter().for_each(|w| problems.push(w.clone()));
                let failures = solution.poses.iter().filter_map(|p| p.outcome.as_ref().err());
                failures.for_each(|e| problems.push(e.clone()));
                Some(solution)
            }
            Err(errors) => {
                errors.into_iter().for_each(|e| problems.push(e));
                None
            }
        }
    }
}

/// Everything up to the plan. What is wrong, or worth saying, is in the collection; without a plan something is wrong.
#[must_use]
pub fn compile(source: &Source, overrides: &Overrides) -> (Option<Compiled>, Problems) {
    let (document, mut problems) = parse(source);
    let (mechanism, found) = check(&document, overrides);
    problems.append(found);
    let Some(mechanism) = mechanism.filter(|_| !problems.has_errors()) else { return (None, problems) };
    match structure(&mechanism) {
        Ok((structure, warnings)) => {
            warnings.into_iter().for_each(|w| problems.push(w));
            let plan = plan(&mechanism, &structure);
            structure
                .force_defect
                .iter()
                .filter(|_| plan.effects.forces)
                .for_each(|e| problems.push(e.clone()));
            (Some(Compiled { mechanism, structure, plan }), problems)
        }
        Err(errors) => {
            errors.into_iter().for_each(|e| problems.push(e));
            (None, problems)
        }
    }
}
