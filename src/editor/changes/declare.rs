//! Declarations of what is used and is not there.

use super::super::{Analysis, SymbolKind};
use super::{Change, ChangeKind};
use assur_syntax::{Token, TokenKind};
use assur_text::diagnostic::Undeclared;
use assur_text::language::JointKind;
use assur_text::source::{Edit, Span};

/// Values of a quantity that is not declared: the first that fits its use.
const VALUES: [&str; 10] =
    ["1", "100 mm", "30 deg", "1500 rpm", "1 m/s", "1 kg", "100 N", "10 N*m", "0.01 kg*m^2", "1 s"];
/// Where a point is that is not declared, until the author says it.
const PLACE: &str = "(50 mm, 50 mm)";
/// In a longer text values are not tried out.
const LINES: usize = 300;
/// The links among which an author can choose.
const LINKS: usize = 8;

impl Analysis {
    /// Declarations of what is used at a place and is not there.
    pub(super) fn declarations(&self, at: Span) -> Vec<Change> {
        let mut found: Vec<Change> = Vec::new();
        for problem in self.problems.sorted() {
            let Some(missing) = problem.undeclared() else { continue };
            if missing.at.end < at.start || at.end < missing.at.start {
                continue;
            }
            let better = |change: &Change| self.errors_with(&change.edits) < self.errors();
            match missing.kind {
                "quantity" | "link" => found.extend(self.lines_declaring(missing).into_iter().find(better)),
                "point" | "point or line" => {
                    found.extend(self.points_declaring(missing).into_iter().filter(better));
                }
                _ => {}
            }
        }
        found.dedup();
        found
    }

    /// Lines before the use, of which one is meant.
    fn lines_declaring(&self, missing: &Undeclared) -> Vec<Change> {
        let name = &missing.name;
        let lines = match missing.kind {
            "link" => vec![self.link_used(name)],
            _ if self.source.text.lines().count() > LINES => vec![format!("given {name} = 1")],
            _ => VALUES.iter().map(|value| format!("given {name} = {value}")).collect(),
        };
        let before = self.line_start(missing.at.start);
        let change = |line: String| Change {
            title: format!("declare `{line}`"),
            edits: vec![Edit::new(Span::new(before, before), line + "\n")],
            kind: ChangeKind::Declare,
        };
        lines.into_iter().map(change).collect()
    }

    /// A point in the link in which it is looked for; where none is named, in each that moves.
    fn points_declaring(&self, missing: &Undeclared) -> Vec<Change> {
        let point = format!("{} {PLACE}", missing.name);
        let links = self.names.declared().filter(|d| match &missing.owner {
            Some(owner) => d.kind == SymbolKind::Link && d.name == *owner,
            None => d.kind == SymbolKind::Link && d.name != "ground",
        });
        let change = |(link, edit): (&str, Edit)| {
            let owner =
                if link == "ground" { "on the ground".to_owned() } else { format!("in link `{link}`") };
            Change {
                title: format!("declare `{point}` {owner}"),
                edits: vec![edit],
                kind: ChangeKind::Declare,
            }
        };
        let with_edits =
            links.take(LINKS).filter_map(|d| Some((d.name.as_str(), self.member_added(d.whole, &point)?)));
        with_edits.map(change).collect()
    }

    /// A member behind those that a statement has in its braces, or in braces of its own.
    fn member_added(&self, statement: Span, member: &str) -> Option<Edit> {
        let within = |token: &&Token| statement.start <= token.span.start && token.span.end <= statement.end;
        let own = self.tokens.iter().filter(within).collect::<Vec<_>>();
        let (last, before) = own.split_last()?;
        let behind = |token: &Token| Span::new(token.span.end, token.span.end);
        if last.kind != TokenKind::BraceEnd {
            return Some(Edit::new(behind(last), format!(" {{ {member} }}")));
        }
        let before = before.iter().rev();
        let is_in_lines = before.clone().next().is_some_and(|token| token.kind == TokenKind::Newline);
        let written = before.clone().find(|token| token.kind != TokenKind::Newline)?;
        let with = match written.kind {
            TokenKind::Brace if is_in_lines => format!("\n  {member}"),
            TokenKind::Brace if written.span.end == last.span.start => format!(" {member} "),
            TokenKind::Brace => format!(" {member}"),
            _ if is_in_lines => format!("\n  {member}"),
            _ => format!("; {member}"),
        };
        Some(Edit::new(behind(written), with))
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
}
