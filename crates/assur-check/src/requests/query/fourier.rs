//! Terms of Fourier series over whole turns: `fourier(M, 2).amplitude`, `fourier(M) in 8 steps`.

use crate::expr::context::Context;
use crate::expr::positive::Want;
use crate::expr::read::no_part;
use crate::expr::results::{Call, Sign};
use crate::motion::simulation::without_meaning;
use crate::requests::query::not_a_quantity;
use crate::statements::written::written;
use crate::values::fold;
use crate::values::format_value::digits;
use crate::values::typed::{Dim, Type, Typed};
use assur_model::model::{
    CycleFunction, Expr as ModelExpr, FindKind, Function as ModelFunction, Harmonic, Part, Table, TableEntry,
};
use assur_syntax::document::{Expr, ExprKind, FindItem, Name, Simulate, Statement, TimeCourse};
use assur_text::diagnostic::Diagnosis;
use assur_text::language::Function;
use assur_text::source::Span;
use assur_text::units::Dimension;

/// The highest order.
const MOST: u32 = 100;

/// What is asked of a term.
#[derive(Clone, Copy, PartialEq, Eq)]
enum TermPart {
    Amplitude,
    Phase,
    Cos,
    Sin,
}

const PARTS: [(&str, TermPart); 4] = [
    ("amplitude", TermPart::Amplitude),
    ("phase", TermPart::Phase),
    ("cos", TermPart::Cos),
    ("sin", TermPart::Sin),
];

impl Context<'_> {
    /// `fourier(M, 2).amplitude`
    pub(crate) fn fourier(&mut self, call: Call<'_>, part: &Name) -> Option<Typed> {
        let args = self.arguments(call, 2, 2)?;
        let Some((_, which)) = PARTS.iter().find(|(name, _)| *name == part.node) else {
            let help = "its parts are `.amplitude`, `.phase`, `.cos`, `.sin`".to_owned();
            self.error(no_part(&part.node, part.span, Some(help)));
            return None;
        };
        let halves = self.order(args[0], args[1]);
        let (x, dim) = self.summed(call, args[0])?;
        let halves = halves?;
        let ty = match which {
            TermPart::Phase => Type::number(Dimension::ANGLE),
            _ => Type::Number(dim),
        };
        if x.pending {
            return Some(Typed::pending(ty));
        }
        Some(Typed::new(self.term(call, (&x.expr, dim), halves, *which), ty))
    }

    /// A term without one of its parts.
    pub(crate) fn fourier_alone(&mut self, call: Call<'_>) -> Option<Typed> {
        let x = call.args.first().map_or_else(|| "Mb".to_owned(), |arg| shown(&arg.value));
        let help = match call.args.len() {
            0 | 1 => {
                format!("write `fourier({x}, 2).amplitude`, or `fourier({x}) in 8 steps` for a table")
            }
            _ => "ask for a part: `.amplitude`, `.phase`, `.cos` or `.sin`".to_owned(),
        };
        self.error(not_a_quantity("fourier(…)", call.span, Some(help)));
        None
    }

    /// `find fourier(M) in 8 steps`; `None` where the item asks no such table.
    pub(crate) fn fourier_table(&mut self, item: &FindItem) -> Option<Option<FindKind>> {
        let ExprKind::Call { function, args } = &item.value.kind else { return None };
        let is_own =
            Function::named(&function.node) == Some(Function::Fourier) && !self.is_curve(&function.node);
        let steps = item.steps.as_ref().filter(|_| is_own && item.name.is_none())?;
        let call = Call { name: function, args, span: item.value.span, sign: Sign::Matters };
        Some(self.table_of_terms(call, steps, item))
    }

    fn table_of_terms(&mut self, call: Call<'_>, steps: &Expr, item: &FindItem) -> Option<FindKind> {
        let args = self.arguments(call, 1, 1)?;
        let count = self.scalar_constant(steps, &Want::NUMBER, "the number of orders")?;
        let whole = (1..=MOST).find(|n| f64::from(*n) == count);
        let (x, dim) = self.summed(call, args[0])?;
        let Some(count) = whole else {
            let range = format!("a whole number from 1 to {MOST}");
            self.error(
                wrong_order("number of orders", &range, count, steps.span)
                    .help("write for example `in 8 steps`, one row for each of the orders 1 to 8"),
            );
            return None;
        };
        let of = match dim {
            Dim::Of(dimension) => dimension,
            Dim::Any => Dimension::NUMBER,
        };
        if x.pending {
            return None;
        }
        let own = match &item.unit {
            Some(word) => {
                let unit = self.unit(word)?;
                self.unit_fits(&unit, &Typed::new(x.expr.clone(), Type::Number(dim)), item)?;
                crate::values::unit_use::display_in(&unit)
            }
            None => self.values.display(of),
        };
        let orders = (1..=count).map(f64::from).collect();
        let mut entries = vec![TableEntry {
            name: "order".to_owned(),
            display: self.values.display(Dimension::NUMBER),
            values: orders,
            found: Vec::new(),
        }];
        for (name, part) in PARTS {
            let angle = part == TermPart::Phase;
            let display = if angle { self.values.display(Dimension::ANGLE) } else { own.clone() };
            let found = (1..=count).map(|n| self.term(call, (&x.expr, dim), 2 * n, part)).collect();
            entries.push(TableEntry { name: name.to_owned(), display, values: Vec::new(), found });
        }
        Some(FindKind::Table(Table { entries, upright: false }))
    }

    /// A part of a term of this order.
    fn term(
        &mut self,
        call: Call<'_>,
        (expr, dim): (&ModelExpr, Dim),
        halves: u32,
        part: TermPart,
    ) -> ModelExpr {
        let dimension = match dim {
            Dim::Of(Dimension { length, mass, time, .. }) => [length, mass, time],
            Dim::Any => [0; 3],
        };
        // marked, and named in pictures, is what the series is of
        let of = Call { span: call.args.first().map_or(call.span, |arg| arg.value.span), ..call };
        let mut coefficient = |sine| {
            let how = CycleFunction::Harmonic(Harmonic { halves, sine });
            self.cycle((how, dimension), expr.clone(), (of, Part::default()))
        };
        match part {
            TermPart::Cos => coefficient(false),
            TermPart::Sin => coefficient(true),
            TermPart::Amplitude | TermPart::Phase => {
                let both = fold::pair(coefficient(false), coefficient(true));
                let of = if part == TermPart::Phase { ModelFunction::Direction } else { ModelFunction::Mag };
                fold::call(of, vec![both])
            }
        }
    }

    /// The number that is a sum of terms, over what turns or comes again.
    fn summed(&mut self, call: Call<'_>, value: &Expr) -> Option<(Typed, Dim)> {
        let t = self.read(value)?;
        let Type::Number(dim) = t.ty else {
            let x = shown(value);
            let written = match call.args.get(1) {
                Some(order) => format!("fourier({x}.x, {}).amplitude", shown(&order.value)),
                None => format!("fourier({x}.x) in 8 steps"),
            };
            let help = matches!(t.ty, Type::Vector(_)).then(|| format!("write `.x` or `.y`: `{written}`"));
            self.shape("the argument of `fourier`", "a number", t.ty, value.span, help);
            return None;
        };
        if !self.names.simulates {
            self.only_drive(call)?;
        } else if !self.is_steady() {
            let help = "ask for the motion that repeats, as in `simulate steady turn of crank`".to_owned();
            self.error(without_meaning("`fourier` of a motion that does not repeat", &help, call.span));
            return None;
        }
        Some((t, dim))
    }

    /// Twice the order that is written.
    fn order(&mut self, x: &Expr, order: &Expr) -> Option<u32> {
        let value = self.scalar_constant(order, &Want::NUMBER, "the order")?;
        let known = (1..=2 * MOST).find(|halves| f64::from(*halves) == 2.0 * value);
        let whole = known.filter(|halves| !self.names.simulates || halves.is_multiple_of(2));
        if whole.is_none() {
            let x = shown(x);
            let range = match self.names.simulates {
                true => format!("1, 2, 3 up to {MOST}"),
                false => format!("1, 2, 3 up to {MOST}, over two turns also 1/2, 3/2"),
            };
            let help = match value {
                0.0 => format!("the term of order 0 is the mean: `mean({x})`"),
                _ => format!("write for example `fourier({x}, 2).amplitude`"),
            };
            self.error(wrong_order("order", &range, value, order.span).help(help));
        }
        whole
    }

    /// Whether the motion that comes again is asked for.
    pub(super) fn is_steady(&self) -> bool {
        let steady = |s: &Statement| {
            matches!(
                s,
                Statement::Simulate(Simulate { course: TimeCourse::Steady(_), .. }) | Statement::Bad(_)
            )
        };
        self.doc.statements.iter().any(|s| steady(&s.node))
    }
}

fn shown(expr: &Expr) -> String {
    written(expr).unwrap_or_else(|| "x".to_owned())
}

fn wrong_order(what: &str, range: &str, found: f64, span: Span) -> Diagnosis {
    let found = digits(found);
    Diagnosis::error(
        "mech::request::argument",
        format!("the {what} of `fourier` must be {range}; got {found}"),
    )
    .primary(span, found)
}
