//! What is shown in and beside a text: hints, lenses, colours, selections.

use super::asked::TextRequest;
use super::client::{PREVIEW, SOLVE, TEST};
use super::error::Failure;
use crate::editor::Action;
use assur_text::source::Span;
use gen_lsp_types::{Position, Range, SemanticTokensDeltaParams};
use serde_json::{Value, json};
use std::cell::RefCell;
use std::collections::BTreeMap;

impl TextRequest<'_> {
    pub fn hints(&self, range: Range) -> Result<Vec<Value>, Failure> {
        let found = self.analysis.hints(self.span(range)?, self.results, self.earlier).into_iter();
        let found = found.filter(|one| self.client.wants(one.kind));
        let hint = |at: usize, text: &str| {
            let position = self.range(Span::new(at, at)).start;
            json!({ "position": position, "label": text, "paddingLeft": true })
        };
        Ok(found.map(|one| hint(one.at, &one.text)).collect())
    }

    pub fn lenses(&self) -> Vec<Value> {
        let lens = |at: Span, title: &str, action: Action| {
            let command = match action {
                Action::Solve => SOLVE,
                Action::Test => TEST,
                Action::Preview => PREVIEW,
            };
            let command = json!({ "title": title, "command": command, "arguments": [self.uri] });
            json!({ "range": self.range(at), "command": command })
        };
        let found = self.analysis.lenses(self.results, self.tested).into_iter();
        found.map(|one| lens(one.at, &one.title, one.action)).collect()
    }

    /// Five numbers each: lines and columns from the one before, length, kind, whether it is declared there.
    pub fn semantic_tokens(&self) -> Vec<u32> {
        let mut data = Vec::new();
        let mut last = Position::default();
        for one in self.analysis.coloured() {
            let Range { start, end } = self.range(one.at);
            let lines = start.line - last.line;
            let columns = if lines == 0 { start.character - last.character } else { start.character };
            let kind = u32::try_from(one.colour).unwrap_or_default();
            data.extend([
                lines,
                columns,
                end.character - start.character,
                kind,
                u32::from(one.is_declaration),
            ]);
            last = start;
        }
        data
    }

    /// For each position the ever larger parts around it, as a chain from the inside.
    pub fn selections(&self, positions: &[Position]) -> Result<Vec<Value>, Failure> {
        let chain = |position: &Position| {
            let around = self.analysis.selections(self.byte(*position)?);
            let outward = around.into_iter().rev().fold(Value::Null, |parent, span| {
                let mut one = json!({ "range": self.range(span) });
                if !parent.is_null() {
                    one["parent"] = parent;
                }
                one
            });
            Ok(outward)
        };
        positions.iter().map(chain).collect()
    }
}

// Colours that were sent, of which the next differ by little.

/// What was sent last of each text.
#[derive(Debug, Default)]
pub struct Sent {
    inside: RefCell<Inside>,
}

#[derive(Debug, Default)]
struct Inside {
    count: u64,
    last: BTreeMap<String, (String, Vec<u32>)>,
}

impl Sent {
    /// All colours of a text, to be known by an id.
    pub fn whole(&self, uri: &str, data: &[u32]) -> Value {
        json!({ "resultId": self.keep(uri, data), "data": data })
    }

    /// What is to be changed in those of an id: one part of them; all, where these are no longer known.
    pub fn changed(&self, asked: &SemanticTokensDeltaParams, data: &[u32]) -> Value {
        let uri = asked.text_document.uri.to_string();
        let known = self.inside.borrow_mut().last.remove(&uri);
        let Some((_, old)) = known.filter(|(id, _)| *id == asked.previous_result_id) else {
            return self.whole(&uri, data);
        };
        let least = old.len().min(data.len());
        let before = old.iter().zip(data).take_while(|(old, new)| old == new).count();
        let behind = old.iter().rev().zip(data.iter().rev()).take_while(|(old, new)| old == new).count();
        let behind = behind.min(least - before);
        let part = data.get(before..data.len() - behind).unwrap_or_default();
        let edit = json!({ "start": before, "deleteCount": old.len() - behind - before, "data": part });
        let edits = if old == data { Vec::new() } else { vec![edit] };
        json!({ "resultId": self.keep(&uri, data), "edits": edits })
    }

    pub fn forget(&self, uri: &str) {
        self.inside.borrow_mut().last.remove(uri);
    }

    fn keep(&self, uri: &str, data: &[u32]) -> String {
        let mut inside = self.inside.borrow_mut();
        inside.count += 1;
        let id = inside.count.to_string();
        inside.last.insert(uri.to_owned(), (id.clone(), data.to_vec()));
        id
    }
}
