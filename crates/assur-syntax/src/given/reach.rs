//! What can reach an answer: by names, by level, by part of the mechanism. Numbers decide nothing here.

use super::datum::{Datum, GivenLine, Shown};
use super::level::level;
use super::lines;
use crate::document::{Definition, Document, Expr, ExprKind, Statement, parts};
use assur_text::language::Function;
use std::collections::{BTreeMap, BTreeSet};

/// What a document gives for what it asks.
#[derive(Clone, Debug)]
pub struct Given<'d> {
    /// The lines of statements that an answer can depend on, with such data alone.
    pub lines: Vec<GivenLine<'d>>,
    /// The definitions by their names.
    pub definitions: BTreeMap<&'d str, &'d Definition>,
    /// The values that those lines and the questions use, and the values of these.
    pub used: BTreeSet<&'d str>,
}

impl<'d> Given<'d> {
    /// The data that the questions of a document can depend on.
    #[must_use]
    pub fn of(document: &'d Document) -> Self {
        let level = level(document);
        let mut all = lines(document);
        let reached = reached(document, &all);
        let ends = document.statements.iter().any(|s| matches!(s.node, Statement::Until(_)));
        let has_instants = |s: &Statement| matches!(s, Statement::Simulate(run) if run.steps.is_some());
        let is_ended = ends && !document.statements.iter().any(|s| has_instants(&s.node));
        all.retain(|line| {
            let asks = || line.data.iter().any(|datum| datum.shown == Shown::Question);
            line.joins.is_empty() || asks() || line.joins.iter().any(|name| reached.contains(name))
        });
        for line in &mut all {
            line.data.retain(|datum| datum.kind.level <= level);
            // what an event ends takes no longer, and has no other instants
            line.data.retain(|datum| !(is_ended && datum.kind.key == "simulate"));
        }
        let definitions = document.statements.iter().filter_map(|s| match &s.node {
            Statement::Given(value) | Statement::Let(value) => Some((value.name.node.as_str(), value)),
            _ => None,
        });
        let definitions: BTreeMap<_, _> = definitions.collect();
        let data = all.iter().flat_map(|line| &line.data);
        let data = data.filter(|datum| {
            !matches!(datum.shown, Shown::Key | Shown::Method) && !matches!(datum.kind.key, "given" | "let")
        });
        let used = live(data, &definitions);
        let asked = asked(&all, &used, &definitions);
        all.retain(|line| line.subject != "event" || line.joins.iter().any(|name| asked.contains(name)));
        Self { lines: all, definitions, used }
    }

    /// The names of definitions that these names follow from or are: what varies with them.
    #[must_use]
    pub fn following(&self, names: &BTreeSet<&'d str>) -> BTreeSet<&'d str> {
        let mut all = names.clone();
        while let Some(name) = self.definitions.iter().find_map(|(name, definition)| {
            let follows = names_of(&definition.value).iter().any(|used| all.contains(used));
            (follows && !all.contains(name)).then_some(*name)
        }) {
            all.insert(name);
        }
        all
    }
}

/// The names in questions and in what they use, and what a steady motion repeats.
fn asked<'d>(
    all: &[GivenLine<'d>],
    used: &BTreeSet<&'d str>,
    definitions: &BTreeMap<&'d str, &'d Definition>,
) -> BTreeSet<&'d str> {
    let data = all.iter().flat_map(|line| &line.data).filter(|datum| datum.shown == Shown::Question);
    let questions = data.flat_map(Datum::expressions).flat_map(names_of);
    let values = used.iter().filter_map(|name| definitions.get(name)).flat_map(|own| names_of(&own.value));
    let is_run = |line: &&GivenLine<'d>| line.data.iter().any(|datum| datum.kind.key == "steady");
    let repeated = all.iter().filter(is_run).flat_map(|line| line.joins.iter().copied());
    questions.chain(values).chain(repeated).collect()
}

/// The values that data use, and the values of these.
fn live<'a, 'd: 'a>(
    data: impl Iterator<Item = &'a Datum<'d>>,
    definitions: &BTreeMap<&'d str, &'d Definition>,
) -> BTreeSet<&'d str> {
    let mut live = BTreeSet::new();
    let mut todo: Vec<&str> = data.flat_map(Datum::expressions).flat_map(names_of).collect();
    while let Some(name) = todo.pop() {
        if let Some(definition) = definitions.get(name)
            && live.insert(name)
        {
            todo.extend(names_of(&definition.value));
        }
    }
    live
}

/// The names in an expression, those of curves too.
#[must_use]
pub fn names_of(expr: &Expr) -> Vec<&str> {
    let mut names = Vec::new();
    parts(expr, &mut |part| match &part.kind {
        ExprKind::Name(name) => names.push(name.as_str()),
        ExprKind::Call { function, .. } if Function::named(&function.node).is_none() => {
            names.push(&function.node);
        }
        _ => {}
    });
    names
}

/// Whether a question has a function of no part: of the mechanism as a whole.
fn is_of_whole(expr: &Expr) -> bool {
    let mut found = false;
    parts(expr, &mut |part| {
        if let ExprKind::Call { function, args } = &part.kind {
            let names = args.iter().flat_map(|arg| names_of(&arg.value)).count();
            found |= names == 0 || function.node == "critical";
        }
    });
    found
}

/// A question, or what its name stands for.
fn value_of<'d>(document: &'d Document, question: &'d Expr) -> &'d Expr {
    let ExprKind::Name(name) = &question.kind else { return question };
    let own = document.statements.iter().find_map(|s| match &s.node {
        Statement::Let(own) if own.name.node == *name => Some(&own.value),
        _ => None,
    });
    own.unwrap_or(question)
}

/// The names of `let`, which may join parts, and of `given`, which join nothing.
fn definitions(document: &Document) -> [BTreeSet<&str>; 2] {
    let mut names = [BTreeSet::new(), BTreeSet::new()];
    for statement in &document.statements {
        match &statement.node {
            Statement::Let(value) => names[0].insert(value.name.node.as_str()),
            Statement::Given(value) => names[1].insert(&value.name.node),
            _ => false,
        };
    }
    names
}

/// The parts of the mechanism that a question names, and all that is joined to them; all where one is of the whole.
fn reached<'d>(document: &'d Document, all: &[GivenLine<'d>]) -> BTreeSet<&'d str> {
    let nodes: BTreeSet<&str> = all.iter().flat_map(|line| line.joins.iter().copied()).collect();
    let [lets, givens] = definitions(document);
    let is_part = |name: &&str| nodes.contains(name) || lets.contains(name);
    let (mut groups, mut reached) = (Vec::<Vec<&str>>::new(), BTreeSet::new());
    for line in all {
        let names = line.data.iter().flat_map(Datum::expressions).flat_map(names_of);
        match &document.statements[line.statement].node {
            Statement::Find(find) => {
                for item in &find.items {
                    let value = value_of(document, &item.value);
                    let names = names_of(value);
                    let known = |name: &&str| {
                        is_part(name) || givens.contains(name) || matches!(*name, "ground" | "pi")
                    };
                    let parts: Vec<&str> = names.iter().copied().filter(is_part).collect();
                    if is_of_whole(value) || parts.is_empty() || !names.iter().all(known) {
                        return nodes;
                    }
                    reached.extend(parts);
                }
            }
            Statement::Expect(_) | Statement::Given(_) => {}
            Statement::Let(value) => {
                groups.push(names.filter(is_part).chain([value.name.node.as_str()]).collect());
            }
            _ => groups.push(names.filter(is_part).chain(line.joins.iter().copied()).collect()),
        }
    }
    while let Some(i) = groups.iter().position(|group| group.iter().any(|name| reached.contains(name))) {
        reached.extend(groups.swap_remove(i));
    }
    reached
}
