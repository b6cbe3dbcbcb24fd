//! Wheels whose size the file leaves open: answers may not hang on it.
//!
//! The file is checked and solved again with another size of each such wheel. What comes out the same does not hang on
//! it; what does not is an error where it is asked, and is left out where it is not.

use crate::model::{Expr, FindKind, Mechanism, Relation, Scale, Value};
use crate::solve::{self, OpenSizes, Scene, Solution};
use crate::source::Span;
use crate::{Origin, check, plan, structure, syntax};
use miette::Diagnostic;
use thiserror::Error;

/// Numbers that differ by more than this part hang on what was changed.
const EQUAL: f64 = 1e-9;

/// An answer that hangs on a size that is not given.
#[derive(Clone, Debug, Error, Diagnostic)]
pub enum ScaleError {
    /// On the radius of a wheel, or the module of its teeth.
    #[error("`{what}` hangs on the {size} of `{wheel}`, which is not given")]
    #[diagnostic(code(mech::train::missing_radius))]
    MissingRadius {
        /// What is asked.
        what: String,
        /// The wheel.
        wheel: String,
        /// `radius`, `module`
        size: &'static str,
        /// What to write.
        #[help]
        help: String,
        /// Where it is asked.
        #[label(primary, "hangs on it")]
        span: miette::SourceSpan,
        /// The wheel's place.
        #[label("no {size}")]
        wheel_span: miette::SourceSpan,
    },
}

/// Finds what hangs on open sizes: errors for what is asked, and a note in the solution of the rest.
pub fn scales(scene: &Scene<'_>, solution: &mut Solution, origin: &Origin) -> Vec<ScaleError> {
    if scene.mechanism.scales.is_empty() {
        return Vec::new();
    }
    let (document, _) = syntax::parse(&origin.source);
    let mut errors: Vec<ScaleError> = Vec::new();
    let mut open = OpenSizes::default();
    for scale in &scene.mechanism.scales {
        let (mechanism, _) = check::check_stretched(&document, &origin.overrides, &scale.wheel);
        let Some(mechanism) = mechanism else { continue };
        let Ok((structure, _)) = structure::structure(&mechanism) else { continue };
        let plan = plan::plan(&mechanism, &structure);
        let other = Scene { mechanism: &mechanism, structure: &structure, plan: &plan };
        let Ok(changed) = solve::solve(&other) else { continue };
        let compared = Compared { scene, solution, other: &other, changed: &changed };
        for (name, span) in compared.questions() {
            if !errors
                .iter()
                .any(|e| matches!(e, ScaleError::MissingRadius { span: s, .. } if *s == span.into()))
            {
                errors.push(error(scale, name, span));
            }
        }
        compared.note(&mut open);
    }
    solution.open = open;
    errors
}

fn error(scale: &Scale, what: String, span: Span) -> ScaleError {
    let wheel = &scale.wheel;
    let (size, example) = if scale.teeth {
        ("module", format!("wheel {wheel} teeth … module 2 mm"))
    } else {
        ("radius", format!("wheel {wheel} radius 100 mm"))
    };
    ScaleError::MissingRadius {
        what,
        wheel: wheel.clone(),
        size,
        help: format!("give it: `{example}`, or ask for something that the ratios alone determine"),
        span: span.into(),
        wheel_span: scale.span.into(),
    }
}

/// The same file with two sizes of a wheel.
struct Compared<'a> {
    scene: &'a Scene<'a>,
    solution: &'a Solution,
    other: &'a Scene<'a>,
    changed: &'a Solution,
}

impl Compared<'_> {
    /// What is asked and comes out differently.
    fn questions(&self) -> Vec<(String, Span)> {
        let (here, there) = (self.scene.mechanism, self.other.mechanism);
        let mut found = Vec::new();
        for (a, b) in here.finds.iter().zip(&there.finds) {
            if let (FindKind::Value { expr, .. }, FindKind::Value { expr: changed, .. }) = (&a.kind, &b.kind)
                && self.differs(expr, changed)
            {
                found.push((a.name.clone(), a.span));
            }
        }
        for (a, b) in here.expects.iter().zip(&there.expects) {
            let bounds = match (&a.relation, &b.relation) {
                (Relation::Equal(x), Relation::Equal(y)) => x.iter().zip(y).collect(),
                (Relation::Compare(_, x), Relation::Compare(_, y)) => vec![(x, y)],
                _ => Vec::new(),
            };
            if self.differs(&a.expr, &b.expr) || bounds.iter().any(|(x, y)| self.differs(x, y)) {
                found.push((a.text.clone(), a.span));
            }
        }
        found
    }

    fn differs(&self, expr: &Expr, changed: &Expr) -> bool {
        if let (Expr::Constant(a), Expr::Constant(b)) = (expr, changed) {
            return !alike(*a, *b);
        }
        let poses = self.solution.poses.iter().zip(&self.changed.poses);
        poses.into_iter().any(|(a, b)| {
            let (Ok(here), Ok(there)) = (&a.outcome, &b.outcome) else { return false };
            let here = self.solution.view(self.scene, here).value(expr);
            let there = self.changed.view(self.other, there).value(changed);
            !alike(here, there)
        })
    }

    /// Results that come out differently, asked or not.
    fn note(&self, open: &mut OpenSizes) {
        let add = |list: &mut Vec<usize>, i: usize| {
            if !list.contains(&i) {
                list.push(i);
            }
        };
        let same = |x: f64, y: f64| alike(Value::Scalar(x), Value::Scalar(y));
        for (a, b) in self.solution.poses.iter().zip(&self.changed.poses) {
            let (Ok(here), Ok(there)) = (&a.outcome, &b.outcome) else { continue };
            let (x, y) = (&here.state, &there.state);
            for (i, (p, q)) in x.bodies.iter().zip(&y.bodies).enumerate().take(links(self.scene.mechanism)) {
                let equal = same(p.omega, q.omega) && same(p.alpha, q.alpha);
                if !(equal && alike(Value::Vector(p.v), Value::Vector(q.v))) {
                    add(&mut open.links, i);
                }
            }
            let efforts = x.efforts.iter().zip(&y.efforts).enumerate();
            efforts.filter(|(_, (p, q))| !same(**p, **q)).for_each(|(i, _)| add(&mut open.efforts, i));
            for i in 0..self.scene.plan.laws.len() {
                let force = |plan: &plan::Plan, state: &solve::State| {
                    state.law_forces[i].multiplier * plan.laws[i].force
                };
                if !same(force(self.scene.plan, x), force(self.other.plan, y)) {
                    add(&mut open.laws, i);
                }
            }
        }
    }
}

fn links(mechanism: &Mechanism) -> usize {
    mechanism.links.len()
}

fn alike(a: Value, b: Value) -> bool {
    match (a, b) {
        (Value::Scalar(x), Value::Scalar(y)) => {
            x.is_nan() && y.is_nan() || (x - y).abs() <= EQUAL * x.abs().max(y.abs())
        }
        (Value::Vector(x), Value::Vector(y)) => {
            (x - y).norm() <= EQUAL * x.norm().max(y.norm()) || x.norm().is_nan() && y.norm().is_nan()
        }
        (a, b) => a == b,
    }
}
