//! Changes that are offered at a place, beside those that mend a problem: a declaration, a number as a `given`, an answer as an `expect`.

use super::{Analysis, Results};
use assur_syntax::TokenKind;
use assur_syntax::document::Statement;
use assur_text::language::JointKind;
use assur_text::source::{Edit, Source, Span, edited};

/// Values of a quantity that is not declared: the first that fits its use.
const VALUES: [&str; 10] =
    ["1", "100 mm", "30 deg", "1500 rpm", "1 m/s", "1 kg", "100 N", "10 N*m", "0.01 kg*m^2", "1 s"];
/// In a longer text they are not tried out.
const LINES: usize = 300;

/// What a change is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ChangeKind {
    /// A name is declared.
    Declare,
    /// A number becomes a `given`.
    Extract,
    /// An answer becomes an `expect`.
    Expect,
}

/// A change that is offered.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Change {
    /// What it does.
    pub title: String,
    /// Its edits.
    pub edits: Vec<Edit>,
    /// What it is for.
    pub kind: ChangeKind,
}

impl Analysis {
    /// The changes that are offered at a place; each leaves the text with no error that is new.
    #[must_use]
    pub fn changes_at(&self, at: Span, results: Option<&Results>) -> Vec<Change> {
        let mut found = self.declarations(at);
        found.extend(self.number_as_given(at.start));
        found.extend(results.map(|results| self.answers_as_keys(at, results)).unwrap_or_default());
        found
    }

    /// Declarations of what is used at a place and is not there.
    fn declarations(&self, at: Span) -> Vec<Change> {
        let mut found: Vec<Change> = Vec::new();
        for problem in self.problems.sorted() {
            let Some((kind, name, used)) = problem.undeclared() else { continue };
            if used.end < at.start || at.end < used.start {
                continue;
            }
            let lines = match kind {
                "quantity" if self.source.text.lines().count() > LINES => vec![format!("given {name} = 1")],
                "quantity" => VALUES.iter().map(|value| format!("given {name} = {value}")).collect(),
                "link" => vec![self.link_used(name)],
                _ => continue,
            };
            let before = self.line_start(used.start);
            let change = |line: String| Change {
                title: format!("declare `{line}`"),
                edits: vec![Edit::new(Span::new(before, before), line + "\n")],
                kind: ChangeKind::Declare,
            };
            let better = |change: &Change| self.errors_with(&change.edits) < self.errors();
            found.extend(lines.into_iter().map(change).find(better).filter(|one| !found.contains(one)));
        }
        found
    }

    /// A link with the points that are named of it, by themselves and by pairs.
    fn link_used(&self, link: &str) -> String {
        let mut points: Vec<&str> = Vec::new();
        let text = &self.source.text;
        let words = self.tokens.iter().map(|token| token.text(text)).collect::<Vec<_>>();
        let mut pair = None;
        for (i, word) in words.iter().enumerate() {
            if self.tokens[i].kind == TokenKind::Newline {
                pair = None;
            } else if JointKind::named(word).is_some() {
                pair = words.get(i + 1).copied();
            } else if *word == link {
                let own = if words.get(i + 1) == Some(&".") { words.get(i + 2).copied() } else { pair };
                points.extend(own.filter(|point| !points.contains(point)));
            }
        }
        let point = |(i, name): (usize, &&str)| {
            if i == 0 { format!("{name} (0, 0)") } else { format!("{name} ({} mm, 0)", 100 * i) }
        };
        let points = points.iter().enumerate().map(point).collect::<Vec<_>>();
        format!("link {link} {{ {} }}", points.join("; "))
    }

    /// The number at a byte with a name of its own.
    fn number_as_given(&self, byte: usize) -> Option<Change> {
        let touches = |span: Span| span.start <= byte && byte <= span.end;
        let index = self.tokens.iter().position(|t| t.kind == TokenKind::Number && touches(t.span))?;
        let units = self.tokens[index + 1..].iter().take_while(|t| t.kind == TokenKind::Unit);
        let whole = units.fold(self.tokens[index].span, |whole, unit| whole.to(unit.span));
        let statement = self.document.statements.iter().find(|s| touches(s.span))?;
        if matches!(statement.node, Statement::Given(_)) {
            return None;
        }
        let is_free = |name: &String| self.names.declared().all(|declared| declared.name != *name);
        let name =
            (1..).map(|n| if n == 1 { "value".to_owned() } else { format!("value_{n}") }).find(is_free)?;
        let line = format!("given {name} = {}", self.source.text.get(whole.start..whole.end)?);
        let before = self.line_start(statement.span.start);
        let edits = vec![Edit::new(Span::new(before, before), format!("{line}\n")), Edit::new(whole, name)];
        let change =
            Change { title: format!("declare `{line}` and use it"), edits, kind: ChangeKind::Extract };
        (self.errors_with(&change.edits) <= self.errors()).then_some(change)
    }

    /// The answers that a place asks for, as the expectations of the text.
    fn answers_as_keys(&self, at: Span, results: &Results) -> Vec<Change> {
        let touches = |span: Span| span.start <= at.end && at.start <= span.end;
        let mut found = Vec::new();
        for statement in self.document.statements.iter().filter(|s| touches(s.span)) {
            let Statement::Find(find) = &statement.node else { continue };
            for item in find.items.iter().filter(|item| touches(item.span)) {
                let name = item.name.as_ref().map_or(item.text.as_str(), |name| &name.node);
                let Some(value) = results.value(name).filter(|value| !value.contains('…')) else {
                    continue;
                };
                let line = format!("expect {name} = {value}");
                let end = Span::new(statement.span.end, statement.span.end);
                let edits = vec![Edit::new(end, format!("\n{line}"))];
                let change = Change { title: format!("add `{line}`"), edits, kind: ChangeKind::Expect };
                found.extend((self.errors_with(&change.edits) <= self.errors()).then_some(change));
            }
        }
        found
    }

    fn line_start(&self, byte: usize) -> usize {
        let before = self.source.text.get(..byte).unwrap_or_default();
        before.rfind('\n').map_or(0, |newline| newline + 1)
    }

    fn errors(&self) -> usize {
        self.problems.errors()
    }

    /// How many errors the text has with edits made.
    fn errors_with(&self, edits: &[Edit]) -> usize {
        let text = edited(&self.source.text, edits);
        Self::of(Source::new(self.source.name.as_str(), text)).errors()
    }
}
