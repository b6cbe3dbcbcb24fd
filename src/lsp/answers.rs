//! Answers to questions about a text.

use super::convert::{edits, range, span};
use super::error::Failure;
use super::texts::{Texts, params};
use crate::editor::{Analysis, Hover, Symbol, SymbolKind, folds, symbols};
use assur_text::diagnostic::{Fix, Problem};
use assur_text::source::{Edit, Encoding, Lines, Span};
use gen_lsp_types::{
    CodeAction, CodeActionKind, CodeActionParams, Diagnostic, DiagnosticRelatedInformation,
    DiagnosticSeverity, DocumentFormattingParams, DocumentRangeFormattingParams, DocumentSymbol,
    DocumentSymbolParams, FoldingRange, FoldingRangeParams, HoverParams, Location, LspRequestMethod,
    MarkupContent, MarkupKind, WorkspaceEdit,
};
use miette::Severity;
use serde::Serialize;
use serde_json::Value;
use std::collections::HashMap;

/// A text that is looked at.
struct Looked<'a> {
    uri: &'a str,
    analysis: &'a Analysis,
    lines: Lines<'a>,
    encoding: Encoding,
}

/// The answer to a request.
pub fn answer(
    method: &LspRequestMethod<'_>,
    message: &Value,
    texts: &Texts,
    encoding: Encoding,
) -> Result<Value, Failure> {
    match method {
        LspRequestMethod::TextDocumentCodeAction => {
            let asked = params::<CodeActionParams>(message)?;
            let uri = asked.text_document.uri.to_string();
            of(texts, &uri, encoding, |text| Ok(text.actions(text.span(asked.range)?)))
        }
        LspRequestMethod::TextDocumentFormatting => {
            let uri = params::<DocumentFormattingParams>(message)?.text_document.uri.to_string();
            of(texts, &uri, encoding, |text| Ok(text.edits(&text.analysis.formatting(None))))
        }
        LspRequestMethod::TextDocumentRangeFormatting => {
            let asked = params::<DocumentRangeFormattingParams>(message)?;
            let uri = asked.text_document.uri.to_string();
            of(texts, &uri, encoding, |text| {
                let at = text.span(asked.range)?;
                let line = |byte| text.lines.place(byte, encoding).line + 1;
                Ok(text.edits(&text.analysis.formatting(Some(line(at.start)..=line(at.end)))))
            })
        }
        LspRequestMethod::TextDocumentDocumentSymbol => {
            let uri = params::<DocumentSymbolParams>(message)?.text_document.uri.to_string();
            of(texts, &uri, encoding, |text| {
                Ok(symbols(&text.analysis.document).iter().map(|s| text.symbol(s)).collect::<Vec<_>>())
            })
        }
        LspRequestMethod::TextDocumentFoldingRange => {
            let uri = params::<FoldingRangeParams>(message)?.text_document.uri.to_string();
            of(texts, &uri, encoding, |text| {
                let found = folds(&text.analysis.source.text, &text.analysis.tokens);
                Ok(found.into_iter().map(|span| text.fold(span)).collect::<Vec<_>>())
            })
        }
        LspRequestMethod::TextDocumentHover => {
            let asked = params::<HoverParams>(message)?.text_document_position_params;
            let uri = asked.text_document.uri.to_string();
            of(texts, &uri, encoding, |text| {
                let at = text.span(gen_lsp_types::Range { start: asked.position, end: asked.position })?;
                Ok(text.analysis.hover(at.start).map(|hover| text.hover(hover)))
            })
        }
        other => Err(Failure::unknown_method(other.as_str())),
    }
}

/// What is asked of an open text.
fn of<T: Serialize>(
    texts: &Texts,
    uri: &str,
    encoding: Encoding,
    ask: impl FnOnce(&Looked<'_>) -> Result<T, Failure>,
) -> Result<Value, Failure> {
    let analysis = Analysis::of(texts.get(uri)?.clone());
    let lines = Lines::of(&analysis.source.text);
    let answer = ask(&Looked { uri, analysis: &analysis, lines, encoding })?;
    serde_json::to_value(answer).map_err(|_| Failure::internal())
}

/// What is wrong with a text.
pub fn diagnostics(uri: &str, analysis: &Analysis, encoding: Encoding) -> Vec<Diagnostic> {
    let lines = Lines::of(&analysis.source.text);
    let text = Looked { uri, analysis, lines, encoding };
    analysis.problems.sorted().into_iter().map(|problem| text.diagnostic(problem)).collect()
}

impl Looked<'_> {
    fn span(&self, range: gen_lsp_types::Range) -> Result<Span, Failure> {
        span(&self.lines, range, self.encoding)
    }

    fn range(&self, span: Span) -> gen_lsp_types::Range {
        range(&self.lines, span, self.encoding)
    }

    fn edits(&self, edits_of: &[Edit]) -> Vec<gen_lsp_types::TextEdit> {
        edits(&self.lines, edits_of, self.encoding)
    }

    fn diagnostic(&self, problem: &dyn Problem) -> Diagnostic {
        let mut labels = problem.labels().map(Iterator::collect::<Vec<_>>).unwrap_or_default();
        labels.sort_by_key(|label| !label.primary());
        let places = labels.iter().map(|label| {
            let at = Span::new(label.offset(), label.offset() + label.len());
            (self.range(at), label.label().unwrap_or_default().to_owned())
        });
        let mut places = places.collect::<Vec<_>>().into_iter();
        let (range, _) = places.next().unwrap_or_default();
        let related = places.map(|(range, message)| {
            let location = Location { uri: self.uri.into(), range };
            DiagnosticRelatedInformation { location, message }
        });
        let code = problem.code().map(|code| code.to_string());
        let help = problem.help().map(|help| format!("\nhelp: {help}")).unwrap_or_default();
        Diagnostic {
            range,
            severity: Some(match problem.severity() {
                Some(Severity::Advice) => DiagnosticSeverity::Information,
                Some(Severity::Warning) => DiagnosticSeverity::Warning,
                _ => DiagnosticSeverity::Error,
            }),
            code: code.map(Into::into),
            code_description: None,
            source: Some("assur".to_owned()),
            message: format!("{problem}{help}").into(),
            tags: None,
            related_information: Some(related.collect()),
            data: None,
        }
    }

    /// The fixes at a place, and all certain ones at once.
    fn actions(&self, at: Span) -> Vec<CodeAction> {
        let fixes = self.analysis.fixes_at(at);
        let fixes = fixes.into_iter().map(|(problem, fix)| self.action(problem, &fix));
        let mut actions = fixes.collect::<Vec<_>>();
        let all = self.analysis.certain_edits();
        if !all.is_empty() {
            actions.push(CodeAction {
                title: "fix all that is certain".to_owned(),
                kind: Some(CodeActionKind::SourceFixAll),
                edit: Some(self.change(&all)),
                ..CodeAction::default()
            });
        }
        actions
    }

    fn action(&self, problem: &dyn Problem, fix: &Fix) -> CodeAction {
        CodeAction {
            title: fix.title.clone(),
            kind: Some(CodeActionKind::QuickFix),
            diagnostics: Some(vec![self.diagnostic(problem)]),
            is_preferred: Some(fix.certain),
            edit: Some(self.change(&fix.edits)),
            ..CodeAction::default()
        }
    }

    fn change(&self, edits: &[Edit]) -> WorkspaceEdit {
        let changes = HashMap::from([(self.uri.into(), self.edits(edits))]);
        WorkspaceEdit { changes: Some(changes), ..WorkspaceEdit::default() }
    }

    fn symbol(&self, symbol: &Symbol) -> DocumentSymbol {
        use gen_lsp_types::SymbolKind as Kind;
        let parts = symbol.parts.iter().map(|part| self.symbol(part)).collect::<Vec<_>>();
        #[allow(deprecated, reason = "the type has no other way to be made than with all of its fields")]
        DocumentSymbol {
            name: symbol.name.clone(),
            detail: None,
            kind: match symbol.kind {
                SymbolKind::Given => Kind::Constant,
                SymbolKind::Derived | SymbolKind::Answer => Kind::Variable,
                SymbolKind::Link => Kind::Class,
                SymbolKind::Point | SymbolKind::Shape => Kind::Field,
                SymbolKind::Pair => Kind::Interface,
                SymbolKind::Element => Kind::Object,
                SymbolKind::Load | SymbolKind::Pose => Kind::Event,
                SymbolKind::Group => Kind::Namespace,
            },
            tags: None,
            deprecated: None,
            range: self.range(symbol.whole),
            selection_range: self.range(symbol.at),
            children: (!parts.is_empty()).then_some(parts),
        }
    }

    fn hover(&self, hover: Hover) -> gen_lsp_types::Hover {
        let contents = MarkupContent { kind: MarkupKind::Markdown, value: hover.text };
        gen_lsp_types::Hover { contents: contents.into(), range: Some(self.range(hover.at)) }
    }

    fn fold(&self, span: Span) -> FoldingRange {
        let range = self.range(span);
        FoldingRange { start_line: range.start.line, end_line: range.end.line, ..FoldingRange::default() }
    }
}
