//! Help while a text is typed: completions, signatures.

use super::asked::Asked;
use crate::editor::{Completion, CompletionKind, Signature};
use gen_lsp_types::{CompletionItemKind, InsertTextFormat};
use serde_json::{Value, json};

impl Asked<'_> {
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
