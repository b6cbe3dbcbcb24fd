//! Colours that were sent, of which the next differ by little.

use gen_lsp_types::SemanticTokensDeltaParams;
use serde_json::{Value, json};
use std::cell::RefCell;
use std::collections::BTreeMap;

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
