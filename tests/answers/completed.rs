//! What an editor offers: at every word of every example the word itself.

#![allow(clippy::unwrap_used)] // a test that cannot read its files has failed

use assur::internals::editor::Analysis;
use assur::internals::source::Source;
use assur::internals::syntax::TokenKind;
use std::path::Path;

fn look(text: &str) -> Analysis {
    Analysis::of(Source::new("a.mech", text))
}

#[test]
fn every_word_is_offered_where_it_is() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let (mut all, mut missed) = (0, Vec::new());
    for path in crate::folder::files(&root, "mech") {
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
