//! The first file, step by step: which step a text has come to is read off the text.

use super::{Analysis, Results, Wish};
use assur_syntax::document::{Member, Statement};
use assur_worked::{Sentence, TutorialMessage as M};
use serde::Serialize;

/// A way from an empty text to a solved problem.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Tutorial {
    pub title: &'static str,
    pub steps: Vec<Step>,
    /// The first step that is not done; their number where all are.
    pub at: usize,
}

/// One of its steps.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Step {
    pub title: &'static str,
    /// What is to be written, and why.
    pub text: &'static str,
    /// Lines that do it.
    pub example: &'static str,
    /// The text has it.
    pub done: bool,
}

/// Title, text and lines of a step.
const STEPS: [(M, M, &str); 6] = [
    (
        M::GroundTitle,
        M::GroundText,
        "mech 1\nmechanism \"My crank-slider\"\nground { A (0, 0); line guide through A along 0 deg }",
    ),
    (M::LinksTitle, M::LinksText, "link crank  A-B 100 mm\nlink rod    B-C 350 mm\nlink slider { C (0, 0) }"),
    (
        M::PairsTitle,
        M::PairsText,
        "revolute  A: ground - crank\nrevolute  B: crank - rod\nrevolute  C: rod - slider\n\
         prismatic D: slider.C - ground.guide",
    ),
    (M::DriveTitle, M::DriveText, "drive crank = 0 deg .. 360 deg in 36 steps at 120 rpm"),
    (M::AssemblyTitle, M::AssemblyText, "assemble C ahead of B"),
    (
        M::QuestionTitle,
        M::QuestionText,
        "force F on slider at C = 500 N @ 180 deg\nbalance torque M on crank\nfind M, velocity(C)",
    ),
];

impl Analysis {
    /// The steps, and which of them the text has.
    ///
    /// # Errors
    /// There is no such language, in words.
    pub fn tutorial(&self, results: Option<&Results>, wish: &Wish) -> Result<Tutorial, String> {
        let language = wish.language()?;
        let has = self.steps(results);
        let step = |((title, text, example), done): ((M, M, &'static str), bool)| Step {
            title: title.template(language),
            text: text.template(language),
            example,
            done,
        };
        let steps = STEPS.into_iter().zip(has).map(step).collect();
        let at = has.iter().position(|done| !done).unwrap_or(has.len());
        Ok(Tutorial { title: M::Title.template(language), steps, at })
    }

    /// Whether the text has what each step writes. Names, sizes and order are the author's.
    fn steps(&self, results: Option<&Results>) -> [bool; 6] {
        let count = |is: fn(&Statement) -> bool| {
            self.document.statements.iter().filter(|statement| is(&statement.node)).count()
        };
        let ground = count(|s| match s {
            Statement::Ground(ground) => {
                let has = |is: fn(&Member) -> bool| ground.body.iter().any(|m| is(&m.node));
                has(|m| matches!(m, Member::Point(..))) && has(|m| matches!(m, Member::Line(..)))
            }
            _ => false,
        });
        let links = count(|s| matches!(s, Statement::Link(_)));
        let pairs = count(|s| matches!(s, Statement::Joint(_)));
        let drives = count(|s| matches!(s, Statement::Drive(drive) if drive.rate.is_some()));
        let assemblies = count(|s| matches!(s, Statement::Assemble(_)));
        let asked = count(|s| matches!(s, Statement::Find(_))) > 0
            && count(|s| matches!(s, Statement::Balance(_))) > 0
            && count(|s| matches!(s, Statement::Load(_))) > 0;
        let is_solved = results.is_some_and(Results::is_solved) && !self.problems.has_errors();
        // one degree of freedom: 3n − 2p = 1
        let is_joined = links >= 3 && 2 * pairs + 1 >= 3 * links;
        [ground > 0, links >= 3, is_joined, drives > 0, assemblies > 0, asked && is_solved]
    }
}
