//! An open text of which something is asked, and what is found in it in the words of the protocol.

use super::client::{Client, EXPLAIN};
use super::error::{Failure, edits, range, span};
use crate::editor::{
    Analysis, Change, ChangeKind, Completion, CompletionKind, Declaration, Earlier, Hover, Results,
    Signature, Symbol, SymbolKind,
};
use assur_text::diagnostic::{Fix, Problem};
use assur_text::source::{Edit, Lines, Span};
use gen_lsp_types::{
    CodeAction, CodeActionKind, Command, CompletionItemKind, Diagnostic, DiagnosticRelatedInformation,
    DiagnosticSeverity, DiagnosticTag, DocumentHighlight, DocumentHighlightKind, DocumentSymbol,
    FoldingRange, InsertTextFormat, Location, MarkupContent, MarkupKind, Position, PrepareRenamePlaceholder,
    TextEdit, WorkspaceEdit,
};
use miette::Severity;
use serde_json::{Value, json};
use std::collections::HashMap;

/// A text that is looked at.
pub struct TextRequest<'a> {
    pub uri: &'a str,
    pub analysis: &'a Analysis,
    /// Its answers, where it is solved.
    pub results: Option<&'a Results>,
    /// The last one before it that had answers.
    pub earlier: Option<&'a Earlier>,
    /// What the last test of its rows came to.
    pub tested: Option<&'a str>,
    pub lines: Lines<'a>,
    pub client: Client,
}

impl<'a> TextRequest<'a> {
    /// A text of which nothing is known but what is in it and what it comes to.
    pub fn of(uri: &'a str, analysis: &'a Analysis, results: Option<&'a Results>, client: Client) -> Self {
        let lines = Lines::of(&analysis.source.text);
        Self { uri, analysis, results, earlier: None, tested: None, lines, client }
    }
}

impl TextRequest<'_> {
    /// What is wrong with the text, with what its answers show where it is solved; then what nothing depends on, where it is shown faded.
    pub fn diagnostics(&self) -> Vec<Diagnostic> {
        // editors show it faded
        let is_faded = |code: String| code == "mech::name::unused";
        let all = self.analysis.problems_with(self.results).into_iter();
        let all = all.filter(|problem| !problem.code().is_some_and(|code| is_faded(code.to_string())));
        let unused = if self.client.fades { self.analysis.unused() } else { Vec::new() };
        all.map(|problem| self.diagnostic(problem))
            .chain(unused.into_iter().map(|one| self.unused(one)))
            .collect()
    }

    fn unused(&self, declared: &Declaration) -> Diagnostic {
        Diagnostic {
            range: self.range(declared.at),
            severity: Some(DiagnosticSeverity::Hint),
            source: Some("assur".to_owned()),
            message: format!("nothing depends on `{}`", declared.name).into(),
            tags: Some(vec![DiagnosticTag::Unnecessary]),
            ..Diagnostic::default()
        }
    }

    pub fn span(&self, range: gen_lsp_types::Range) -> Result<Span, Failure> {
        span(&self.lines, range, self.client.encoding)
    }

    /// The byte at a position.
    pub fn byte(&self, at: Position) -> Result<usize, Failure> {
        Ok(self.span(gen_lsp_types::Range { start: at, end: at })?.start)
    }

    pub fn range(&self, span: Span) -> gen_lsp_types::Range {
        range(&self.lines, span, self.client.encoding)
    }

    pub fn edits(&self, edits_of: &[Edit]) -> Vec<TextEdit> {
        edits(&self.lines, edits_of, self.client.encoding)
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

    /// The edits that put the lines of a range in the one style.
    pub fn formatting(&self, range: gen_lsp_types::Range) -> Result<Vec<TextEdit>, Failure> {
        let at = self.span(range)?;
        let line = |byte| self.lines.place(byte, self.client.encoding).line + 1;
        Ok(self.edits(&self.analysis.formatting(Some(line(at.start)..=line(at.end)))))
    }

    /// The fixes at a place, what else is offered there, all certain fixes at once, and what the diagnostics mean.
    pub fn actions(&self, at: Span) -> Vec<CodeAction> {
        let fixes = self.analysis.fixes_at(at, self.results);
        let fixes = fixes.into_iter().map(|(problem, fix)| self.action(problem, &fix));
        let mut actions = fixes.collect::<Vec<_>>();
        actions.extend(self.analysis.changes_at(at, self.results).iter().map(|change| self.offered(change)));
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
            .extend(self.analysis.codes_at(at, self.results).into_iter().map(|code| self.explanation(code)));
        actions
    }

    /// Shows the page of a code.
    fn explanation(&self, code: String) -> CodeAction {
        let title = format!("explain `{code}`");
        let arguments = Some(vec![self.uri.into(), code.into()]);
        let command =
            Command { title: title.clone(), command: EXPLAIN.to_owned(), arguments, ..Command::default() };
        CodeAction {
            title,
            kind: Some(CodeActionKind::QuickFix),
            command: Some(command),
            ..CodeAction::default()
        }
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

    fn offered(&self, change: &Change) -> CodeAction {
        let kind = match change.kind {
            ChangeKind::Declare => CodeActionKind::QuickFix,
            ChangeKind::Extract => CodeActionKind::RefactorExtract,
            ChangeKind::Rewrite => CodeActionKind::RefactorRewrite,
        };
        let edit = Some(self.change(&change.edits));
        CodeAction { title: change.title.clone(), kind: Some(kind), edit, ..CodeAction::default() }
    }

    pub fn change(&self, edits: &[Edit]) -> WorkspaceEdit {
        let changes = HashMap::from([(self.uri.into(), self.edits(edits))]);
        WorkspaceEdit { changes: Some(changes), ..WorkspaceEdit::default() }
    }

    /// The declarations in whose names a text is.
    pub fn symbols_called(&self, query: &str) -> Vec<Value> {
        let called = self.analysis.names.declared().filter(|d| d.name.to_lowercase().contains(query));
        let symbol = |d: &Declaration| {
            let location = Location { uri: self.uri.into(), range: self.range(d.at) };
            json!({ "name": d.name, "kind": kind(d.kind), "location": location, "containerName": d.owner })
        };
        called.map(symbol).collect()
    }

    pub fn symbol(&self, symbol: &Symbol) -> DocumentSymbol {
        let parts = symbol.parts.iter().map(|part| self.symbol(part)).collect::<Vec<_>>();
        #[allow(deprecated, reason = "the type has no other way to be made than with all of its fields")]
        DocumentSymbol {
            name: symbol.name.clone(),
            detail: None,
            kind: kind(symbol.kind),
            tags: None,
            deprecated: None,
            range: self.range(symbol.whole),
            selection_range: self.range(symbol.at),
            children: (!parts.is_empty()).then_some(parts),
        }
    }

    pub fn hover(&self, hover: Hover) -> gen_lsp_types::Hover {
        let contents = MarkupContent { kind: MarkupKind::Markdown, value: hover.text };
        gen_lsp_types::Hover { contents: contents.into(), range: Some(self.range(hover.at)) }
    }

    pub fn fold(&self, span: Span) -> FoldingRange {
        let range = self.range(span);
        FoldingRange { start_line: range.start.line, end_line: range.end.line, ..FoldingRange::default() }
    }
}

/// What a symbol is called in the protocol.
const fn kind(kind: SymbolKind) -> gen_lsp_types::SymbolKind {
    use gen_lsp_types::SymbolKind as Kind;
    match kind {
        SymbolKind::Given => Kind::Constant,
        SymbolKind::Derived | SymbolKind::Answer => Kind::Variable,
        SymbolKind::Link => Kind::Class,
        SymbolKind::Point | SymbolKind::Shape | SymbolKind::Wheel => Kind::Field,
        SymbolKind::Pair => Kind::Interface,
        SymbolKind::Element => Kind::Object,
        SymbolKind::Load | SymbolKind::Pose | SymbolKind::Event => Kind::Event,
        SymbolKind::Group => Kind::Namespace,
    }
}

// Help while a text is typed: completions, signatures.

impl TextRequest<'_> {
    pub fn completions(&self, byte: usize) -> Vec<Value> {
        // the line that is typed has no answers yet
        let results = self.results.or(self.earlier.map(|earlier| &*earlier.results));
        let all = self.analysis.complete(byte, results).into_iter().enumerate();
        all.map(|(index, one)| self.completion(index, &one)).collect()
    }

    fn completion(&self, index: usize, one: &Completion) -> Value {
        let kind = match one.kind {
            CompletionKind::Word => CompletionItemKind::Keyword,
            CompletionKind::Snippet => CompletionItemKind::Snippet,
            CompletionKind::Property => CompletionItemKind::Property,
            CompletionKind::Function => CompletionItemKind::Function,
            CompletionKind::Unit => CompletionItemKind::Unit,
            CompletionKind::Name => CompletionItemKind::Variable,
            CompletionKind::Value => CompletionItemKind::Value,
        };
        let format = if one.is_snippet { InsertTextFormat::Snippet } else { InsertTextFormat::PlainText };
        json!({
            "label": one.label,
            "kind": kind,
            "detail": one.means,
            "sortText": format!("{index:04}"),
            "insertTextFormat": format,
            "textEdit": { "range": self.range(one.at), "newText": one.insert },
        })
    }

    pub fn signatures(&self, byte: usize) -> Value {
        let all = self.analysis.signatures(byte);
        let signature = |one: &Signature| {
            let arguments = one.arguments.iter().map(|label| json!({ "label": label })).collect::<Vec<_>>();
            json!({ "label": one.label, "documentation": one.means, "parameters": arguments })
        };
        let Some(active) = all.first().map(|one| one.active) else { return Value::Null };
        json!({
            "signatures": all.iter().map(signature).collect::<Vec<_>>(),
            "activeSignature": 0,
            "activeParameter": active,
        })
    }
}

// Where a name leads to and where it is used; another name.

impl TextRequest<'_> {
    fn location(&self, at: Span) -> Location {
        Location { uri: self.uri.into(), range: self.range(at) }
    }

    /// The declarations to which a name leads. A pair leads to the points that it finds by its name.
    pub fn definition(&self, byte: usize) -> Vec<Location> {
        let names = &self.analysis.names;
        let Some(name) = names.at(byte) else { return Vec::new() };
        let found = names.declarations(name).into_iter().map(|d| d.at).collect::<Vec<_>>();
        let elsewhere = found.iter().filter(|at| **at != name).copied().collect::<Vec<_>>();
        let shown = if elsewhere.is_empty() { found } else { elsewhere };
        shown.into_iter().map(|at| self.location(at)).collect()
    }

    pub fn references(&self, byte: usize, with_declarations: bool) -> Result<Vec<Location>, Failure> {
        let names = &self.analysis.names;
        let all = names.at(byte).map(|name| names.occurrences(name)).unwrap_or_default();
        let shown = all.into_iter().filter(|at| with_declarations || !names.is_declaration(*at));
        Ok(shown.map(|at| self.location(at)).collect())
    }

    /// The places of what has the name at a byte; those where it is declared as written.
    pub fn highlights(&self, byte: usize) -> Vec<DocumentHighlight> {
        let names = &self.analysis.names;
        let all = names.at(byte).map(|name| names.occurrences(name)).unwrap_or_default();
        let highlight = |at: Span| {
            let declared = names.is_declaration(at);
            let kind = if declared { DocumentHighlightKind::Write } else { DocumentHighlightKind::Read };
            DocumentHighlight { range: self.range(at), kind: Some(kind) }
        };
        all.into_iter().map(highlight).collect()
    }

    pub fn prepare_rename(&self, byte: usize) -> Result<PrepareRenamePlaceholder, Failure> {
        let at = self.analysis.renamable(byte).map_err(Failure::request)?;
        let placeholder = self.analysis.source.text.get(at.start..at.end).unwrap_or_default().to_owned();
        Ok(PrepareRenamePlaceholder { range: self.range(at), placeholder })
    }

    pub fn rename(&self, byte: usize, name: &str) -> Result<WorkspaceEdit, Failure> {
        let edits = self.analysis.rename(byte, name).map_err(Failure::request)?;
        Ok(self.change(&edits))
    }
}
