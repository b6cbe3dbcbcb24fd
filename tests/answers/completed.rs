//! What an editor offers: at every word of every example the word itself.

#![allow(clippy::unwrap_used)] // a test that cannot read its files has failed

use crate::folder::files;
use crate::share::spread;
use assur::internals::editor::Analysis;
use assur::internals::source::{Source, Span};
use assur::internals::syntax::TokenKind;
use std::path::Path;

fn look(text: &str) -> Analysis {
    Analysis::of(Source::new("a.mech", text))
}

#[test]
fn every_word_is_offered_where_it_is() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let (mut all, mut missed) = (0, Vec::new());
    for path in spread(files(&root, "mech")) {
        let text = std::fs::read_to_string(&path).unwrap();
        let analysis = look(&text);
        for token in &analysis.tokens {
            if !matches!(token.kind, TokenKind::Word | TokenKind::Unit)
                || analysis.names.is_declaration(token.span)
            {
                continue;
            }
            let word = token.text(&text);
            // numbers of poses; parts of results
            if word.starts_with(|c: char| c.is_ascii_digit()) || text[..token.span.start].ends_with(").") {
                continue;
            }
            all += 1;
            let labels = analysis.complete(token.span.start, None);
            if !labels.iter().any(|c| c.label == word || c.label.starts_with(&format!("{word}."))) {
                let line = text[token.span.start..].lines().next().unwrap_or_default();
                missed.push(format!("{word} before {line} in {}", path.display()));
            }
        }
    }
    assert!(missed.len() * 100 < all, "{} of {all}:\n{}", missed.len(), missed.join("\n"));
}

#[test]
fn every_question_has_an_answer_in_wrong_texts() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/errors");
    for path in spread(files(&root, "mech")) {
        let Ok(text) = std::fs::read_to_string(&path) else { continue };
        let analysis = look(&text);
        let whole = Span::new(0, text.len());
        assert!(analysis.hints(whole, None, None).iter().all(|hint| text.is_char_boundary(hint.at)));
        assert!(analysis.coloured().iter().all(|one| one.at.end <= text.len()));
        for token in analysis.tokens.iter().step_by(3) {
            for byte in [token.span.start, token.span.end] {
                let (offered, around) = (analysis.complete(byte, None), analysis.selections(byte));
                assert!(offered.iter().all(|one| one.at.end == byte), "{}", path.display());
                assert!(around.iter().is_sorted_by_key(|span| span.end - span.start), "{}", path.display());
                let (shown, helped) = (analysis.hover(byte, None), analysis.signatures(byte));
                assert!(shown.is_none_or(|hover| hover.at.start <= byte && byte <= hover.at.end));
                assert!(helped.iter().all(|one| one.label.contains('(')));
            }
            if let Ok(name) = analysis.renamable(token.span.start) {
                assert!(analysis.names.occurrences(name).iter().all(|at| at.end <= text.len()));
            }
        }
    }
}
