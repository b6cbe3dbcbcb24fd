//! What expressions are read in: the document, its names and values, what is made of them, and what is wrong.

use crate::expr::{read::TOO_LARGE, results::Results};
use crate::names::declared::{Names, QuantityKind};
use crate::output::{hinges::Builder, problems::Problems};
use crate::statements::{walk, written::written};
use crate::values::{definition::Settled, replace, store::Values, typed::Typed, unit_use::display_in};
use assur_model::model::{self, Display, Mechanism, NamedValue};
use assur_syntax::document::{Document, Expr, ExprKind, Member, Statement};
use assur_text::diagnostic::{self, Diagnosis, Problem};
use assur_text::source::Span;
use indexmap::IndexSet;

/// The parts of the stage, for what needs more than one of them.
pub struct Context<'a> {
    pub doc: &'a Document,
    /// All names declared in the document.
    pub names: Names<'a>,
    /// Definitions and what they come to.
    pub values: Values<'a>,
    /// The mechanism that is being made.
    pub builder: Builder,
    /// All that was found wrong.
    pub problems: Problems,
    /// The functions of results.
    pub results: Results,
}

impl<'a> Context<'a> {
    /// The state at the start.
    pub fn new(doc: &'a Document, values: Values<'a>, results: Results) -> Self {
        let (names, builder, problems) = (Names::default(), Builder::default(), Problems::default());
        Self { doc, names, values, builder, problems, results }
    }

    /// Reports an error or a warning.
    pub fn error(&mut self, problem: impl Problem) {
        self.problems.error(problem);
    }

    /// What `look` finds, with nothing reported.
    pub fn quietly<T>(&mut self, look: impl FnOnce(&mut Self) -> T) -> T {
        let (before, uses) = (self.problems.start_trial(), self.names.uses.len());
        let found = look(self);
        self.problems = before;
        self.names.uses.truncate(uses);
        found
    }

    /// The mechanism, if nothing is wrong with it, and all that was found.
    pub fn finish(mut self) -> (Option<Mechanism>, diagnostic::Problems) {
        self.builder.mech.displays = self.values.displays();
        let fine = !self.problems.has_errors();
        if !fine && (self.problems.lacks_pair() || !self.pairs_complete()) {
            self.problems.drop_followers(OF_LOST_PAIRS, has_unread(self.doc));
        }
        (fine.then_some(self.builder.mech), self.problems.into_found())
    }
}

/// What is wrong where a pair is missing, which is reported.
const OF_LOST_PAIRS: &[&str] = &[
    "mech::geometry::no_guide",
    "mech::geometry::mass_without_place",
    "mech::geometry::geneva",
    "mech::cam::other_follower",
    "mech::train::no_carrier",
    "mech::request::bends",
    "mech::simulate::no_meaning",
];

/// Whether something in the document could not be read, which is reported.
fn has_unread(doc: &Document) -> bool {
    doc.statements.iter().any(|statement| {
        let body = match &statement.node {
            Statement::Bad(_) => return true,
            Statement::Ground(ground) => &ground.body,
            Statement::Link(link) => &link.body,
            _ => return false,
        };
        body.iter().any(|member| matches!(member.node, Member::Bad(_)))
    })
}

// Expressions with their quantities written out.

/// The largest expression of a drive, in parts.
const LARGEST: usize = 2000;

impl Context<'_> {
    /// The expression with quantities that need no pose written out. Reports one that grows too large.
    pub(crate) fn inline(&mut self, expr: &model::Expr, span: Span) -> Option<model::Expr> {
        if self.values.definitions.size(expr) > LARGEST {
            self.error(undefined("with its definitions inserted it is too long", span, None));
            return None;
        }
        Some(self.written_out(expr))
    }

    fn written_out(&self, expr: &model::Expr) -> model::Expr {
        expr.map_leaves(&mut |leaf| match leaf {
            model::Expr::Quantity(id) if self.values.definitions.needs_no_pose(*id) => {
                self.written_out(&self.builder.mech.quantities[id.index()].expr)
            }
            other => other.clone(),
        })
    }
}

// Which numbers leave a constant expression without a value.

/// Most values that a help states.
const VALUES: usize = 6;

impl Context<'_> {
    /// Reports a constant that is no number, where `operand` is what makes it none.
    pub(crate) fn without_value(&mut self, why: &'static str, span: Span, t: &Typed, operand: &Expr) {
        let help = self.numbers_of(t, operand);
        self.error(undefined(why, span, help));
    }

    /// ``change `K`: `K - 1` is 0 where `K` = 1``
    fn numbers_of(&self, t: &Typed, operand: &Expr) -> Option<String> {
        let mut names = IndexSet::new();
        named(operand, &mut names);
        let mut next = 0;
        while let Some(name) = names.get_index(next).copied().filter(|_| names.len() < VALUES) {
            if let Some(QuantityKind::Let(value)) = self.names.quantities.get(name).map(|d| d.what) {
                named(value, &mut names);
            }
            next += 1;
        }
        let value = |name: &&str| match self.values.definitions.settled.get(*name) {
            Some(Settled::Constant(t)) => {
                Some(format!("`{name}` = {}", self.values.display(t.ty.dimension()).text(t.value()?, 6)))
            }
            _ => None,
        };
        let values = names.iter().filter_map(value).take(VALUES).collect::<Vec<_>>();
        let is = self.values.display(t.ty.dimension()).text(t.value()?, 6);
        let text = written(operand)?;
        Some(match values.as_slice() {
            [] => format!("write another number: `{text}` is {is}"),
            _ => format!("change the values: `{text}` is {is} where {}", values.join(", ")),
        })
    }
}

/// The names in an expression, in the order written.
fn named<'e>(expr: &'e Expr, names: &mut IndexSet<&'e str>) {
    walk::parts(expr, &mut |part| {
        if let ExprKind::Name(name) = &part.kind {
            names.insert(name);
        }
    });
}

/// A constant expression that is not defined.
pub fn undefined(why: &'static str, span: Span, help: Option<String>) -> Diagnosis {
    Diagnosis::error("mech::unit::no_value", format!("this expression is not defined: {why}"))
        .primary(span, why)
        .help_if(help)
}

// The definitions that need no results.

/// Reads the definitions that need no results, and the values from outside.
pub fn constants(cx: &mut Context<'_>) {
    replace::unknown_names(&cx.names, cx.values.outside.overrides, &mut cx.problems);
    for name in cx.values.definitions.order.clone() {
        let Some(kind) = cx.names.quantities.get(&name).map(|d| d.what) else { continue };
        if cx.values.definitions.settled.contains_key(&name) {
            continue;
        }
        let results = cx.values.definitions.results.contains_key(&name);
        let settled = match kind {
            QuantityKind::Given(expr) if results => {
                let result = cx.values.definitions.first_result(&cx.names, expr);
                if let Some((span, result)) = result {
                    cx.error(not_constant(&format!("`given {name}`"), &result, span));
                }
                Settled::Failed
            }
            QuantityKind::Given(expr) | QuantityKind::Let(expr) if !results => match cx.read(expr) {
                Some(t) if t.pending => Settled::Pending(t.ty),
                Some(t) => replace::replaced(&cx.names, &cx.values, &mut cx.problems, &name, t)
                    .and_then(|t| cx.finite(t, TOO_LARGE, expr.span))
                    .map_or(Settled::Failed, Settled::Constant),
                None => Settled::Failed,
            },
            _ => continue,
        };
        cx.values.definitions.settled.insert(name, settled);
    }
    list(cx);
}

/// Enters the values into the mechanism, in the order of the file.
fn list(cx: &mut Context<'_>) {
    for (name, declared) in &cx.names.quantities {
        let (QuantityKind::Given(expr) | QuantityKind::Let(expr)) = declared.what else { continue };
        let given = matches!(declared.what, QuantityKind::Given(_));
        let Some(Settled::Constant(t)) = cx.values.definitions.settled.get(name) else { continue };
        let Some(value) = t.value() else { continue };
        let display = own_unit(cx, expr).unwrap_or_else(|| cx.values.display(t.ty.dimension()));
        cx.builder.mech.values.push(NamedValue { name: name.clone(), value, display, given });
    }
}

/// The unit of a value that is a number as written.
fn own_unit(cx: &Context<'_>, expr: &Expr) -> Option<Display> {
    match &expr.kind {
        ExprKind::Number(n) => cx.values.units.get(&n.unit.as_ref()?.node).map(|(unit, _)| display_in(unit)),
        ExprKind::Unary(_, inner) => own_unit(cx, inner),
        _ => None,
    }
}

/// A value that must be known beforehand depends on results.
pub fn not_constant(what: &str, result: &str, span: Span) -> Diagnosis {
    Diagnosis::error(
        "mech::request::not_constant",
        format!("{what} must be a constant, but it depends on {result}"),
    )
    .primary(span, "known only once the mechanism is solved")
    .help("use numbers, `given` and those `let` that depend only on them")
}
