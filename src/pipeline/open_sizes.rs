//! Wheels whose size the file leaves open: answers may not depend on it.
//!
//! The file is checked and solved again with another size of each such wheel. What comes out the same does not depend on
//! it; what does not is an error where it is asked, and is left out where it is not.

use super::compile::Origin;
use assur_check as check;
use assur_model::model::{Expr, FindKind, Mechanism, OpenSize, Relation, Value};
use assur_model::structure;
use assur_position::plan;
use assur_solve::solve::{self, Following, Model, OpenSizes, Pose, WholeCycle};
use assur_text::diagnostic::Diagnosis;
use assur_text::source::Span;

/// Numbers that differ by more than this part depend on what was changed.
const EQUAL: f64 = 1e-9;

/// Finds what depends on open sizes.
///
/// # Errors
/// What is asked and depends on them.
pub fn open_sizes(model: &Model<'_>, origin: &Origin) -> Result<OpenSizes, Vec<Diagnosis>> {
    let mut open = OpenSizes::default();
    if model.mechanism.open_sizes.is_empty() {
        return Ok(open);
    }
    let (mut errors, mut reported) = (Vec::new(), Vec::new());
    for size in &model.mechanism.open_sizes {
        let (mechanism, _) = check::check_with_other_size(&origin.document, &origin.overrides, &size.wheel);
        let Some(mechanism) = mechanism else { continue };
        let Ok((structure, _)) = structure::structure(&mechanism) else { continue };
        let plan = plan::plan(&mechanism, &structure);
        let other = Model { mechanism: &mechanism, structure: &structure, plan: &plan };
        let Some(compared) = Compared::of(model, &other) else { continue };
        for (name, span) in compared.questions() {
            if !reported.contains(&span) {
                reported.push(span);
                errors.push(error(size, &name, span));
            }
        }
        compared.note(&mut open);
    }
    if errors.is_empty() { Ok(open) } else { Err(errors) }
}

fn error(open: &OpenSize, what: &str, span: Span) -> Diagnosis {
    let wheel = &open.wheel;
    let (size, example) = if open.teeth {
        ("module", format!("wheel {wheel} teeth … module 2 mm"))
    } else {
        ("radius", format!("wheel {wheel} radius 100 mm"))
    };
    let message = format!("`{what}` depends on the {size} of `{wheel}`, which is not given");
    Diagnosis::error("mech::train::missing_radius", message)
        .primary(span, "depends on it")
        .label(open.span, format!("no {size}"))
        .help(format!("give the size, as in `{example}`, or ask for a quantity that depends only on ratios"))
}

/// An expression of the file, and the same where the size is another.
type Pair<'a> = (&'a Expr, &'a Expr);

/// What is asked: its name, its place, its expressions, and whether one of them comes out differently.
struct Question<'a> {
    name: &'a str,
    span: Span,
    asked: Vec<Pair<'a>>,
    differs: bool,
}

/// The same file with two sizes of a wheel.
struct Compared<'a> {
    model: &'a Model<'a>,
    other: &'a Model<'a>,
    questions: Vec<Question<'a>>,
    links: Vec<bool>,
    efforts: Vec<bool>,
    laws: Vec<bool>,
}

impl<'a> Compared<'a> {
    /// Both solved, position by position; `None` where one cannot be.
    fn of(model: &'a Model<'a>, other: &'a Model<'a>) -> Option<Self> {
        let mut compared = Self {
            model,
            other,
            questions: questions(model.mechanism, other.mechanism),
            links: vec![false; model.mechanism.links.len()],
            efforts: vec![false; model.structure.efforts.len()],
            laws: vec![false; model.plan.laws.len()],
        };
        let constants = |(a, b): &Pair<'_>| match (a, b) {
            (Expr::Constant(a), Expr::Constant(b)) => !alike(*a, *b),
            _ => false,
        };
        for question in &mut compared.questions {
            question.differs = question.asked.iter().any(constants);
        }
        let mut here = Following::new(model, Vec::new()).ok()?;
        let mut there = Following::new(other, Vec::new()).ok()?;
        while let (Some(a), Some(b)) = (&mut here, &mut there) {
            let (Some(first), Some(second)) = (a.next(), b.next()) else { break };
            compared.compare((a.statics(), &first.ok()?), (b.statics(), &second.ok()?));
        }
        Some(compared)
    }

    /// Looks at one position of both.
    fn compare(&mut self, (statics, a): (&WholeCycle, &Pose), (changed, b): (&WholeCycle, &Pose)) {
        let (Ok(here), Ok(there)) = (&a.outcome, &b.outcome) else { return };
        let (view, other) = (here.view(self.model, statics), there.view(self.other, changed));
        for question in self.questions.iter_mut().filter(|q| !q.differs) {
            let both_constant = |(a, b): &Pair<'_>| matches!((a, b), (Expr::Constant(_), Expr::Constant(_)));
            let mut asked = question.asked.iter().filter(|pair| !both_constant(pair));
            question.differs = asked.any(|(a, b)| !alike(view.value(a), other.value(b)));
        }
        let same = |x: f64, y: f64| alike(Value::Scalar(x), Value::Scalar(y));
        let (x, y) = (&here.state, &there.state);
        for (differs, (p, q)) in self.links.iter_mut().zip(x.motion.bodies.iter().zip(&y.motion.bodies)) {
            let equal = same(p.omega, q.omega) && same(p.alpha, q.alpha);
            *differs |= !(equal && alike(Value::Vector(p.v), Value::Vector(q.v)));
        }
        for (differs, (p, q)) in self.efforts.iter_mut().zip(x.forces.efforts.iter().zip(&y.forces.efforts)) {
            *differs |= !same(*p, *q);
        }
        for (i, differs) in self.laws.iter_mut().enumerate() {
            let force = |plan: &plan::Plan, state: &solve::State| {
                state.forces.law_forces[i].multiplier * plan.laws[i].force
            };
            *differs |= !same(force(self.model.plan, x), force(self.other.plan, y));
        }
    }

    /// What is asked and comes out differently.
    fn questions(&self) -> Vec<(String, Span)> {
        self.questions.iter().filter(|q| q.differs).map(|q| (q.name.to_owned(), q.span)).collect()
    }

    /// Results that come out differently, asked or not.
    fn note(&self, open: &mut OpenSizes) {
        let add = |list: &mut Vec<usize>, differ: &[bool]| {
            for (i, _) in differ.iter().enumerate().filter(|(_, differs)| **differs) {
                if !list.contains(&i) {
                    list.push(i);
                }
            }
        };
        add(&mut open.links, &self.links);
        add(&mut open.efforts, &self.efforts);
        add(&mut open.laws, &self.laws);
    }
}

/// What a file asks and expects, in both.
fn questions<'a>(here: &'a Mechanism, there: &'a Mechanism) -> Vec<Question<'a>> {
    let question = |name, span, asked| Question { name, span, asked, differs: false };
    let finds = here.finds.iter().zip(&there.finds).filter_map(|(a, b)| match (&a.kind, &b.kind) {
        (FindKind::Value { expr, .. }, FindKind::Value { expr: changed, .. }) => {
            Some(question(a.name.as_str(), a.span, vec![(expr, changed)]))
        }
        _ => None,
    });
    let expects = here.expects.iter().zip(&there.expects).map(|(a, b)| {
        let bounds: Vec<Pair<'a>> = match (&a.relation, &b.relation) {
            (Relation::Equal(x), Relation::Equal(y)) => x.iter().zip(y).collect(),
            (Relation::Compare(_, x), Relation::Compare(_, y)) => vec![(x, y)],
            _ => Vec::new(),
        };
        let asked = std::iter::once((&a.expr, &b.expr)).chain(bounds).collect();
        question(a.text.as_str(), a.span, asked)
    });
    finds.chain(expects).collect()
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
