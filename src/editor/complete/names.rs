//! Names of the text, by their places.

use super::super::{Analysis, Declaration, Results, SymbolKind};
use super::place::Place;
use super::{Completion, CompletionKind};
use crate::pipeline::assembly_clauses;
use assur_syntax::TokenKind;
use assur_text::language::{
    COLLECTIONS, FUNCTIONS, Function, JointKind, PROPERTIES, Place as WordPlace, Takes, WORDS, Word,
};
use assur_text::source::{Edit, Source, edited};
use indexmap::IndexMap;

/// The assemblies of a larger mechanism are not looked for while it is typed.
const MOST_LINKS: usize = 20;

const VALUES: &[SymbolKind] =
    &[SymbolKind::Given, SymbolKind::Derived, SymbolKind::Load, SymbolKind::Element, SymbolKind::Answer];
const BODIES: &[SymbolKind] = &[SymbolKind::Link, SymbolKind::Wheel];
const MOVING: &[SymbolKind] = &[SymbolKind::Link, SymbolKind::Wheel, SymbolKind::Pair];

impl Analysis {
    fn of_kinds(&self, kinds: &[SymbolKind]) -> Vec<Completion> {
        let found = self.names.declared().filter(|d| kinds.contains(&d.kind));
        distinct(found.map(|d| name(&d.name, d)))
    }

    /// Points with the links before them, and names alone that stand for points.
    fn points(&self) -> Vec<Completion> {
        let points = || self.names.declared().filter(|d| d.kind == SymbolKind::Point);
        let alone = points().map(|d| name(&d.name, d));
        let whole = points().filter_map(|d| Some(name(&format!("{}.{}", d.owner.as_deref()?, d.name), d)));
        distinct(alone.chain(whole).chain(self.of_kinds(BODIES)))
    }

    /// What is inside the link before a dot.
    pub(super) fn parts(&self, place: &Place<'_>) -> Vec<Completion> {
        let owner = place.back(2);
        if owner == ")" {
            return ["x", "y"]
                .map(|part| Completion::plain(part, CompletionKind::Word, "a component"))
                .into();
        }
        let inside = self.names.declared().filter(|d| d.owner.as_deref() == Some(owner));
        let mut found = inside.map(|d| name(&d.name, d)).collect::<Vec<_>>();
        let is_cylinder = |d: &Declaration| d.name == owner && d.kind == SymbolKind::Pair;
        if found.is_empty() && self.names.declared().any(is_cylinder) {
            let link = |part| Completion::plain(part, CompletionKind::Name, "a link of the cylinder");
            found.extend(["barrel", "rod"].map(link));
        }
        found
    }

    /// Names that fit a place within a statement.
    pub(super) fn names_at(&self, place: &Place<'_>) -> Vec<Completion> {
        if let Some((function, count)) = place.call()
            && let Some(function) = Function::named(function)
        {
            return self.arguments(function, count);
        }
        let (head, before) = (place.head(), place.back(1));
        match (head, before) {
            ("all", "all") => kinds(),
            ("ignore", _) => {
                vec![Completion::plain("inertia", CompletionKind::Word, "an effect that is left out")]
            }
            ("balance", "balance") => some(&["force", "torque"]),
            ("assemble", "assemble") => {
                [self.assemblies(place), self.points(), self.of_kinds(MOVING)].concat()
            }
            ("assemble", _) => [self.points(), self.of_kinds(MOVING)].concat(),
            ("find" | "expect", "pose") => self.of_kinds(&[SymbolKind::Pose]),
            (_, "event" | "of") => {
                let kinds = [SymbolKind::Event, SymbolKind::Element, SymbolKind::Link, SymbolKind::Wheel];
                let mut found = self.of_kinds(&kinds);
                found.extend(
                    ["begin", "end"].map(|word| Completion::plain(word, CompletionKind::Word, "of a motion")),
                );
                found
            }
            ("drive" | "start" | "stop", word) if word == head => self.of_kinds(MOVING),
            (_, "for") => self.of_kinds(&[SymbolKind::Load]),
            (_, "on") => self.of_kinds(BODIES),
            (_, "in") => self.of_kinds(MOVING),
            ("group" | "spring", ":" | "," | "-") => self.of_kinds(BODIES),
            ("rope", "over" | "under") => self.of_kinds(BODIES),
            (word, ":" | "-") if JointKind::named(word).is_some() => self.of_kinds(BODIES),
            (_, "through" | "to" | "centre" | "from" | "about") => self.own_points(place),
            (_, "at") => self.at(place),
            ("mass" | "weight", word) if word != "inertia" && place.words().any(|w| w == "at") => {
                let means = "of this mass, about its point";
                vec![Completion::plain("inertia", CompletionKind::Word, means)]
            }
            ("link", "-") => Vec::new(),
            _ if place.link().is_some() => [self.own_points(place), self.values(place)].concat(),
            _ => self.values(place),
        }
    }

    /// The clauses that choose between the assemblies of the text without this statement, which does not read yet.
    fn assemblies(&self, place: &Place<'_>) -> Vec<Completion> {
        if self.names.declared().filter(|d| d.kind == SymbolKind::Link).count() > MOST_LINKS {
            return Vec::new();
        }
        let text = edited(&self.source.text, &[Edit::new(place.line(), "")]);
        let without = Self::of(Source::new(self.source.name.as_str(), text));
        let clauses = without.compiled.as_ref().map(assembly_clauses).unwrap_or_default();
        let clause = |(clause, chosen): &(String, bool)| {
            let means = if *chosen { "an assembly: as it is chosen now" } else { "an assembly" };
            Completion::plain(clause, CompletionKind::Value, means)
        };
        distinct(clauses.iter().map(clause))
    }

    /// The points of the link in whose braces a place is.
    fn own_points(&self, place: &Place<'_>) -> Vec<Completion> {
        let own = |d: &&Declaration| d.kind == SymbolKind::Point && d.owner.as_deref() == place.link();
        self.names.declared().filter(own).map(|d| name(&d.name, d)).collect()
    }

    /// After `at`: points of the link that is named before, drives, values.
    fn at(&self, place: &Place<'_>) -> Vec<Completion> {
        let named = place.words().collect::<Vec<_>>();
        let after_on = named.iter().rposition(|word| *word == "on").and_then(|on| named.get(on + 1));
        let owner = after_on.copied().or(place.link());
        let of_owner = |d: &&Declaration| d.kind == SymbolKind::Point && d.owner.as_deref() == owner;
        let mut found = self.names.declared().filter(of_owner).map(|d| name(&d.name, d)).collect::<Vec<_>>();
        found.extend(self.of_kinds(MOVING));
        found.extend(some(&["pose", "event"]));
        found.extend(self.values(place));
        found
    }

    /// Quantities and functions; after `find` also the words that ask for many answers.
    fn values(&self, place: &Place<'_>) -> Vec<Completion> {
        let mut found = self.of_values();
        if place.head() == "find" {
            let many = COLLECTIONS.iter().map(|c| c.word);
            found.extend(many.map(|word| Completion::plain(word, CompletionKind::Word, "all of them")));
        }
        // a path begins with a link
        found.extend(self.of_kinds(&[SymbolKind::Link, SymbolKind::Pair]));
        found
    }

    /// What a function takes as its next argument, in any of its forms.
    fn arguments(&self, function: Function, count: usize) -> Vec<Completion> {
        let mut found = Vec::new();
        for argument in function.row().forms.iter().filter_map(|form| form.takes.get(count)) {
            if argument.named {
                let text = format!("{} = ", argument.name);
                found.push(Completion {
                    insert: text,
                    ..Completion::plain(argument.name, CompletionKind::Word, "")
                });
            }
            found.extend(match argument.takes {
                Takes::Point | Takes::OwnPoint => self.points(),
                Takes::Link | Takes::Wheel | Takes::Slider => self.of_kinds(BODIES),
                Takes::Pair | Takes::Mesh | Takes::Rope => self.of_kinds(&[SymbolKind::Pair]),
                Takes::RopeEnd | Takes::Drive => self.of_kinds(MOVING),
                Takes::Group => self.of_kinds(&[SymbolKind::Group]),
                Takes::Effort => self.of_kinds(&[&[SymbolKind::Load, SymbolKind::Element], MOVING].concat()),
                Takes::Given => self.of_kinds(&[SymbolKind::Given]),
                Takes::Cam | Takes::Flywheel => self.of_kinds(&[SymbolKind::Element]),
                Takes::Event => self.of_kinds(&[SymbolKind::Event]),
                Takes::Count | Takes::Order | Takes::OneOrTwo | Takes::Fit => Vec::new(),
                Takes::Value(_) | Takes::Angle => self.of_values(),
            });
        }
        distinct(found.into_iter())
    }

    fn of_values(&self) -> Vec<Completion> {
        let functions = FUNCTIONS.iter().map(|row| {
            let means = row.forms.first().map_or("", |form| form.means);
            Completion::snippet(row.name, CompletionKind::Function, means, row.usage)
        });
        let known = [("pi", "3.14159…"), ("time", "the instant of a motion under loads")];
        let known = known.map(|(word, means)| Completion::plain(word, CompletionKind::Word, means));
        self.of_kinds(VALUES).into_iter().chain(known).chain(functions).collect()
    }

    /// `= 26 N*m` after `expect Mb`.
    pub(super) fn expected_value(&self, place: &Place<'_>, results: Option<&Results>) -> Option<Completion> {
        if place.head() != "expect" || !matches!(place.before, Some(TokenKind::Word | TokenKind::Close)) {
            return None;
        }
        let written = place.words().skip(1).collect::<String>();
        let value = results?.value(&written).filter(|value| !value.contains('…'))?;
        Some(Completion::plain(&format!("= {value}"), CompletionKind::Value, "the answer"))
    }
}

fn name(label: &str, declared: &Declaration) -> Completion {
    let owner = declared.owner.as_ref().map(|owner| format!(" of `{owner}`")).unwrap_or_default();
    Completion::plain(label, CompletionKind::Name, &format!("{}{owner}", declared.kind.phrase()))
}

fn distinct(all: impl Iterator<Item = Completion>) -> Vec<Completion> {
    let mut found: IndexMap<String, Completion> = IndexMap::new();
    for one in all {
        found.entry(one.label.clone()).or_insert(one);
    }
    found.into_values().collect()
}

// Words of the language, by their places.

/// What may begin a statement or a member.
pub fn beginnings(place: &Place<'_>) -> Vec<Completion> {
    let begins = |row: &Word| Completion::snippet(row.word, CompletionKind::Snippet, row.means, row.example);
    let of = |places: &[WordPlace]| rows(places).map(begins).collect::<Vec<_>>();
    match place.body() {
        "" => of(&[WordPlace::Statement, WordPlace::Pair]),
        "ground" | "link" | "shaft" | "slider" => of(&[WordPlace::Member]),
        "cam" => [of(&[WordPlace::CamMember]), properties("cam")].concat(),
        word => properties(word),
    }
}

fn rows(places: &[WordPlace]) -> impl Iterator<Item = &'static Word> {
    WORDS.iter().filter(|(place, _)| places.contains(place)).flat_map(|(_, all)| all.iter())
}

fn properties(of: &str) -> Vec<Completion> {
    // a spring in a pair has properties of its own
    let tables = PROPERTIES.iter().filter(|(word, _)| word.split(' ').next() == Some(of));
    let mut found: Vec<Completion> = Vec::new();
    for row in tables.flat_map(|(_, all)| all.iter()) {
        if found.iter().all(|known| known.label != row.name) {
            found.push(Completion::snippet(row.name, CompletionKind::Property, row.means, row.example));
        }
    }
    found
}

pub fn within() -> Vec<Completion> {
    let places = [WordPlace::Connecting, WordPlace::Contextual, WordPlace::Shape, WordPlace::Law];
    let words = rows(&places).map(|row| Completion::plain(row.word, CompletionKind::Word, row.means));
    words.collect()
}

/// Words that begin statements, within others.
pub fn some(words: &[&str]) -> Vec<Completion> {
    let rows = rows(&[WordPlace::Statement]).filter(|row| words.contains(&row.word));
    rows.map(|row| Completion::plain(row.word, CompletionKind::Word, row.means)).collect()
}

/// The kinds of pairs, as `all` takes them.
pub fn kinds() -> Vec<Completion> {
    let words = rows(&[WordPlace::Pair]);
    words.map(|row| Completion::plain(row.word, CompletionKind::Word, row.means)).collect()
}
