//! Pictures that cannot exist.

use assur_solve::solve::Solution;
use miette::Diagnostic;
use thiserror::Error;

/// Why there is no picture.
#[derive(Clone, Debug, Error, Diagnostic)]
pub enum Missing {
    /// No position is solved.
    #[error("there is no position to draw{named}")]
    #[diagnostic(code("mech::picture::no_position"))]
    NoPosition {
        /// `: no solved pose is named `9``, or empty.
        named: String,
        /// What to write.
        #[help]
        help: String,
    },
}

/// The most poses that a help lists.
const MOST: usize = 12;

impl Missing {
    /// No position, or none of a name, is solved.
    pub(crate) fn no_position(solution: &Solution, name: Option<&str>) -> Self {
        let solved = solution.poses.iter().filter(|p| p.outcome.is_ok());
        let known: Vec<String> = solved.map(|p| format!("`{}`", p.name)).collect();
        match name {
            Some(name) if !known.is_empty() => {
                let listed = known[..known.len().min(MOST)].join(", ");
                let more = known.len().saturating_sub(MOST);
                let more = if more > 0 { format!(" and {more} more") } else { String::new() };
                Self::NoPosition {
                    named: format!(": no solved pose is named `{name}`"),
                    help: format!("the poses are {listed}{more}"),
                }
            }
            _ => Self::NoPosition {
                named: String::new(),
                help: "declare a link with a drive: `drive crank = 45 deg`".to_owned(),
            },
        }
    }
}
