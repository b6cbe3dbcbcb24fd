//! How a function is called in the file at hand: with its own names.

use crate::expr::{
    context::Context,
    results::{Call, wrong_argument},
};
use crate::names::declared::{ThingKind, of_things, usage};
use crate::statements::written::written;
use assur_syntax::document::{Arg, Expr, ExprKind, Number};
use assur_text::language::Function;
use assur_text::source::{Span, Spanned};

/// Most calls that a help proposes.
const PROPOSED: usize = 2;
/// Most calls that are tried.
const TRIED: usize = 60;

impl Context<'_> {
    /// Calls that can be read: with the arguments that are right, else with the first names of the file that fit; where
    /// none is found, how it is written anywhere.
    pub(crate) fn own_usage(&mut self, call: Call<'_>) -> String {
        if self.is_curve(&call.name.node) {
            return format!("{}(x)", call.name.node);
        }
        let known = usage(&call.name.node);
        let asks = of_things(&call.name.node).is_some();
        let trying = ("trial", String::new());
        // a call that is tried has no trials of its own
        if !asks || self.problems.reported.contains(&trying) {
            return known;
        }
        let found = self.candidates(call).into_iter().find_map(|calls| {
            let found = self.quietly(|cx| {
                cx.problems.reported.insert(trying.clone());
                cx.readable(call, calls)
            });
            (!found.is_empty()).then_some(found)
        });
        found.map_or(known, |found| found.join("` or `"))
    }

    /// The first calls with these arguments that can be read.
    fn readable(&mut self, call: Call<'_>, candidates: Vec<Vec<Arg>>) -> Vec<String> {
        let mut found = Vec::new();
        for args in candidates.into_iter().take(TRIED) {
            let function = call.name.clone();
            let expr = Expr { kind: ExprKind::Call { function, args }, span: call.span };
            if self.read(&expr).is_some() {
                found.extend(written(&expr));
            }
            if found.len() == PROPOSED {
                break;
            }
        }
        found
    }

    /// Lists of arguments: those with the first one as it is written, and those with any names of the file.
    fn candidates(&self, call: Call<'_>) -> [Vec<Vec<Arg>>; 3] {
        let span = call.span;
        let arg = |kind: ExprKind| Arg { name: None, value: Expr { kind, span } };
        let links = self.builder.mech.links.iter().skip(1).map(|l| arg(ExprKind::Name(l.name.clone())));
        let links = links.collect::<Vec<_>>();
        let things = self.names.things.iter().filter(|(_, d)| d.what != ThingKind::Link);
        let things = things.map(|(name, _)| arg(ExprKind::Name(name.clone()))).collect::<Vec<_>>();
        let numbers = ["1", "2"].map(|text| arg(number(text)));
        let with_second = |first: &Arg| {
            let second = links.iter().chain(&numbers);
            second.map(|other| vec![first.clone(), other.clone()]).collect::<Vec<_>>()
        };
        let first = call.args.first().filter(|a| a.name.is_none());
        let alone = first.iter().map(|first| vec![(*first).clone()]).collect();
        let pairs = first.map(with_second).unwrap_or_default();
        let any = links.iter().chain(&things).map(|one| vec![one.clone()]);
        [alone, pairs, any.chain(things.iter().flat_map(with_second)).collect()]
    }

    /// Reports a link before the pair on which a force acts: `reaction(rod, B)`. Whether it was.
    pub(crate) fn link_before_pair(&mut self, call: Call<'_>) -> bool {
        let [Arg { value: first, .. }, Arg { value: second, .. }] = call.args else { return false };
        let (ExprKind::Name(link), ExprKind::Name(pair)) = (&first.kind, &second.kind) else { return false };
        let swapped = self.find_link(link).is_some()
            && self.find_pair(link).is_none()
            && self.find_pair(pair).is_some()
            && self.find_link(pair).is_none();
        if swapped {
            let (function, wanted) = (call.name.node.clone(), "a pair, and then a link,".to_owned());
            let (usage, span) = (format!("{function}({pair}, {link})"), first.span.to(second.span));
            self.error(wrong_argument(&function, &wanted, span, &usage));
        }
        swapped
    }

    /// What may be meant by a function's name that stands alone.
    pub(crate) fn function_alone(&mut self, name: &str, span: Span) -> Option<String> {
        let function = of_things(name)?;
        let name = Spanned::new(function.name().to_owned(), span);
        let call = Call { name: &name, args: &[], span, sign: crate::expr::results::Sign::Matters };
        let calls = self.own_usage(call);
        Some(if function == Function::Reaction {
            format!("write `reactions` for all of them, or `{calls}`")
        } else {
            format!("write `{calls}`")
        })
    }
}

fn number(text: &str) -> ExprKind {
    let value = text.parse().unwrap_or(0.0);
    ExprKind::Number(Number { value, text: text.to_owned(), unit: None })
}
