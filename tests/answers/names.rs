//! Names and where they are used, over all examples: every word that names something leads to its declaration.

#![allow(clippy::unwrap_used)] // a test that cannot read its files has failed

use crate::folder::files;
use crate::share::spread;
use assur::internals::editor::Analysis;
use assur::internals::source::{Source, Span};
use assur::internals::syntax::document::Statement;
use assur::internals::syntax::{Token, TokenKind};
use std::collections::HashSet;
use std::path::Path;

fn look(text: &str) -> Analysis {
    Analysis::of(Source::new("a.mech", text))
}

/// The words that are called as something declared is, and are neither a declaration nor a use.
fn unknown(analysis: &Analysis) -> Vec<Token> {
    let text = &analysis.source.text;
    let names = analysis.names.declared().map(|d| d.name.as_str()).collect::<HashSet<_>>();
    let declared = analysis.names.declared().map(|d| d.at);
    let known = declared.chain(analysis.names.uses().map(|(at, _)| at)).collect::<HashSet<Span>>();
    let all = analysis.tokens.iter().enumerate().filter(|(_, t)| t.kind == TokenKind::Word);
    let left = all.filter(|(i, t)| {
        names.contains(t.text(text)) && !known.contains(&t.span) && !is_of_language(analysis, *i)
    });
    left.map(|(_, token)| *token).collect()
}

/// Whether a word is one of the language where it is, or the column of a curve.
fn is_of_language(analysis: &Analysis, index: usize) -> bool {
    let kind = |at: Option<usize>| at.and_then(|at| analysis.tokens.get(at)).map(|t| t.kind);
    let token = analysis.tokens[index];
    let text = token.text(&analysis.source.text);
    let (before, after) = (kind(index.checked_sub(1)), kind(Some(index + 1)));
    let begins = matches!(before, None | Some(TokenKind::Newline | TokenKind::Semicolon | TokenKind::Brace));
    let is_part = before == Some(TokenKind::Dot) && kind(index.checked_sub(2)) == Some(TokenKind::Close);
    let in_call = matches!(before, Some(TokenKind::Call | TokenKind::Comma));
    let is_argument =
        in_call && analysis.tokens.get(index + 1).is_some_and(|t| t.text(&analysis.source.text) == "=");
    let in_curve = analysis.document.statements.iter().any(|s| {
        matches!(s.node, Statement::Curve(_))
            && s.span.start <= token.span.start
            && token.span.end <= s.span.end
    });
    begins
        || is_part
        || is_argument
        || in_curve
        || after == Some(TokenKind::Call)
        || ["roller", "teeth", "rod", "disc", "plate"].contains(&text)
}

#[test]
fn every_name_leads_to_its_declaration() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let mut left = Vec::new();
    for path in spread(files(&root, "mech")) {
        let text = std::fs::read_to_string(&path).unwrap();
        let analysis = look(&text);
        for token in unknown(&analysis) {
            let line = text[..token.span.start].lines().count();
            let line_text = text.lines().nth(line.saturating_sub(1)).unwrap_or_default();
            left.push(format!("{}:{line}: {} in {line_text}", path.display(), token.text(&text)));
        }
    }
    assert!(left.is_empty(), "{} left:\n{}", left.len(), left.join("\n"));
}

#[test]
fn uses_are_known_in_a_text_with_errors() {
    let text = "given r = 100\nlnk rod B-C r\nground { A (0, 0); B (r, 0) }\nlink crank A-B 2*r\n\
        revolute A: ground - crank\nrevolute B: crank - rodd\ndrive crank = 4 kg\nfind velocity(crank.B), nothing\n";
    let analysis = look(text);
    assert!(analysis.problems.has_errors());
    let at = |span: Span| (text[..span.start].lines().count(), &text[span.start..span.end]);
    let mut seen = Vec::new();
    for (place, of) in analysis.names.uses() {
        seen.extend(of.iter().map(|of| (at(place), at(*of))));
    }
    let line = |n: usize| move |((line, _), _): &&((usize, &str), (usize, &str))| *line == n;
    assert_eq!(seen.iter().find(line(4)).map(|(_, of)| of.1), Some("r"), "{seen:?}");
    let hinge = seen.iter().filter(line(5)).map(|(_, of)| *of).collect::<Vec<_>>();
    assert_eq!(hinge, [(3, "A"), (4, "A"), (2, "ground"), (4, "crank")], "{seen:?}");
    assert_eq!(
        seen.iter().filter(line(8)).map(|(_, of)| of.1).collect::<Vec<_>>(),
        ["crank", "B"],
        "{seen:?}"
    );
}
