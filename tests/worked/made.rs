//! Worked solutions of texts and of mechanisms.

use crate::reader::{Fault, Read, latex, mathml};
use assur::internals::Solved;
use assur::internals::check::Overrides;
use assur::internals::picture::{Kind, Scene};
use assur::internals::pipeline::solve_drawn;
use assur::internals::source::Source;
use assur::internals::worked::{Language, Worked, html, markdown, worked};

/// A solved text; none where it has errors.
pub fn solved(name: &str, text: &str) -> Option<(Source, Solved)> {
    let source = Source::new(name, text);
    let kinds = [Kind::Scheme, Kind::Velocities, Kind::Accelerations, Kind::Forces];
    solve_drawn(&source, &Overrides::none(), &kinds).0.map(|solved| (source, solved))
}

/// The worked solution of the first position.
pub fn of_solved(source: &Source, solved: &Solved) -> Option<(Worked, f64)> {
    of_position(source, solved, None)
}

/// The worked solution of a position.
pub fn of_position(source: &Source, solved: &Solved, pose: Option<&str>) -> Option<(Worked, f64)> {
    let file = (source.name.as_str(), source.text.as_str());
    let scene = Scene::of(solved.compiled.model(), &solved.solution, file, pose).ok()?;
    Some((worked(scene, Language::English, &[]), scene.solved.condition))
}

/// What is found in solutions.
#[derive(Debug, Default)]
pub struct Tally {
    pub solutions: usize,
    pub equations: usize,
    pub approximate: usize,
    pub derived: [usize; 4],
    /// Reactions and loads that are derived, and that are not.
    pub reactions: [usize; 2],
    pub loads: [usize; 2],
    /// Formulas that are not printed, since the position is next to a dead one.
    pub inaccurate: usize,
    pub wrong: Vec<String>,
}

/// At and below this condition forms lose their digits.
const NEARLY_DEAD: f64 = 2e-3;

impl Tally {
    /// Reads all equations of a solution back, from its page and from Markdown.
    pub fn judge(&mut self, name: &str, made: &Worked, condition: f64) {
        self.solutions += 1;
        if condition < NEARLY_DEAD {
            self.inaccurate += made.disagreements.len();
        } else {
            let differs = |d: &String| format!("{name}: the state differs: {d} (condition {condition:e})");
            self.wrong.extend(made.disagreements.iter().map(differs));
        }
        let (motion, forces) = (made.counts.motion, made.counts.forces);
        for (sum, n) in self.derived.iter_mut().zip([motion[0], motion[1], forces[0], forces[1]]) {
            *sum += n;
        }
        for (sum, n) in self.reactions.iter_mut().zip(made.counts.reactions) {
            *sum += n;
        }
        for (sum, n) in self.loads.iter_mut().zip(made.counts.loads) {
            *sum += n;
        }
        let page = html(&made.document);
        let (text, _) = markdown(&made.document, "x");
        let read = [mathml::equations(&page), latex::equations(&text)];
        if read[0].len() != read[1].len() || read[0].len() < made.equations.len() {
            self.wrong.push(format!("{name}: {} and {} equations are read", read[0].len(), read[1].len()));
        }
        for (i, infix) in read.iter().flatten().enumerate() {
            match Read::of(infix) {
                Ok(equation) => {
                    if i < read[0].len() {
                        self.equations += 1;
                        self.approximate += usize::from(equation.approximate && condition >= NEARLY_DEAD);
                    }
                    if let Err(fault) = equation.judge()
                        && !equation.approximate
                    {
                        self.wrong.push(format!("{name}: {fault:?}"));
                    }
                }
                Err(Fault::Unreadable(_)) if !infix.contains('=') => {}
                Err(fault) => self.wrong.push(format!("{name}: {fault:?}")),
            }
        }
        if page.contains("NaN") || page.contains("inf ") {
            self.wrong.push(format!("{name}: a value is not a number"));
        }
    }

    /// Fails with what is wrong.
    pub fn finish(&self) {
        println!(
            "{} solutions, {} equations, {} approximate, {} not accurate, groups derived and stated: motion {:?}, forces {:?}, reactions {:?}, loads {:?}",
            self.solutions,
            self.equations,
            self.approximate,
            self.inaccurate,
            &self.derived[..2],
            &self.derived[2..],
            self.reactions,
            self.loads
        );
        let shown: Vec<&String> = self.wrong.iter().take(60).collect();
        assert!(self.wrong.is_empty(), "{} faults\n{shown:#?}", self.wrong.len());
        assert!(1000 * self.approximate <= self.equations, "{} of {}", self.approximate, self.equations);
    }
}
