//! In which order definitions depend on one another.

use crate::names::declared::{Names, QuantityKind};
use crate::output::problems::Problems;
use crate::values::definition::{Definitions, Settled};
use crate::values::roots::values;
use assur_syntax::document::{Expr, ExprKind};
use assur_text::diagnostic::Diagnosis;
use assur_text::source::Span;
use indexmap::IndexSet;
use miette::LabeledSpan;

/// Finds the order of the definitions; reports those that depend on themselves.
pub fn order(names: &Names<'_>, definitions: &mut Definitions, problems: &mut Problems) {
    // By the place of a name among the quantities; nothing where it is no definition.
    let expressions = names.quantities.values().map(|d| definition(d.what));
    let uses = expressions.map(|e| e.map(|e| names_in(names, e))).collect::<Vec<_>>();
    let mut state = vec![None; uses.len()]; // false: under way; true: done
    for start in (0..uses.len()).filter(|i| uses[*i].is_some()) {
        let mut path = vec![(start, 0)];
        while let Some((name, next)) = path.pop() {
            if next == 0 && state[name].replace(false).is_some() {
                state[name] = Some(true);
                continue;
            }
            let Some(&used) = uses[name].as_ref().and_then(|used| used.get(next)) else {
                state[name] = Some(true);
                let name = names.quantities.get_index(name).map(|(name, _)| name.clone());
                definitions.order.extend(name);
                continue;
            };
            path.push((name, next + 1));
            match state[used] {
                None => path.push((used, 0)),
                Some(false) => cycle(names, definitions, problems, &path, used),
                Some(true) => {}
            }
        }
    }
    for name in definitions.order.clone() {
        let Some(declared) = names.quantities.get(&name) else { continue };
        let found =
            definition(declared.what).and_then(|e| definitions.first_root(names, e)).map(|(_, root, _)| root);
        let found = found.or_else(|| {
            matches!(declared.what, QuantityKind::Find(_)).then(|| "an item of `find`".to_owned())
        });
        if let Some(result) = found {
            definitions.results.insert(name, result);
        }
    }
}

fn definition(kind: QuantityKind<'_>) -> Option<&Expr> {
    match kind {
        QuantityKind::Given(e) | QuantityKind::Let(e) => Some(e),
        QuantityKind::Find(item) => Some(&item.value),
        QuantityKind::Load(..)
        | QuantityKind::Brake(_)
        | QuantityKind::Balance(..)
        | QuantityKind::Flywheel(_)
        | QuantityKind::Column(_)
        | QuantityKind::Curve(_) => None,
    }
}

/// The definitions whose values an expression uses, as places among the quantities.
fn names_in(names: &Names<'_>, expr: &Expr) -> Vec<usize> {
    let mut found = IndexSet::new();
    values(expr, &mut |part| {
        if let ExprKind::Name(name) = &part.kind
            && let Some((index, _, declared)) = names.quantities.get_full(name)
            && definition(declared.what).is_some()
        {
            found.insert(index);
        }
    });
    found.into_iter().collect()
}

/// How many names of a way round are shown.
const SHOWN: usize = 6;

/// `a` → `b` → `a`, the middle left out where it is long.
pub fn way_round(names: &[String]) -> String {
    let mut quoted = names.iter().take(SHOWN).map(|n| format!("`{n}`")).collect::<Vec<_>>();
    if names.len() > SHOWN {
        quoted.push(format!("{} more", names.len() - SHOWN));
    }
    quoted.extend(names.first().map(|n| format!("`{n}`")));
    quoted.join(" → ")
}

fn cycle(
    declared: &Names<'_>,
    definitions: &mut Definitions,
    problems: &mut Problems,
    path: &[(usize, usize)],
    again: usize,
) {
    let from = path.iter().position(|(name, _)| *name == again).unwrap_or(0);
    let named = |index: usize| declared.quantities.get_index(index).map(|(name, _)| name.clone());
    let names = path[from..].iter().filter_map(|(name, _)| named(*name)).collect::<Vec<_>>();
    let again = named(again).unwrap_or_default();
    let place = |name: &String| declared.quantities.get(name).map_or_else(Span::default, |d| d.span);
    let label =
        |name: &String| LabeledSpan::at(place(name).start..place(name).end, "depends on the next one");
    let others = names.iter().skip(1).take(SHOWN).map(label).collect();
    let span = names.first().map_or_else(Span::default, place);
    let chain = way_round(&names);
    for name in &names {
        definitions.settled.insert(name.clone(), Settled::Failed);
    }
    problems.error(circular(&again, &chain, span, others));
}

/// A definition that depends on itself.
pub fn circular(name: &str, chain: &str, span: Span, others: Vec<LabeledSpan>) -> Diagnosis {
    Diagnosis::error("mech::name::cycle", format!("`{name}` is defined in terms of itself: {chain}"))
        .primary(span, "circular definition starts here")
        .labels(others)
        .help("define one of them without the others")
}
