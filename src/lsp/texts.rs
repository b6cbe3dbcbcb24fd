//! The texts that are open in the client.

use super::convert::span;
use super::error::Failure;
use assur_text::source::{Edit, Encoding, Lines, Source, edited};
use gen_lsp_types::{
    DidChangeTextDocumentParams, DidCloseTextDocumentParams, DidOpenTextDocumentParams,
    TextDocumentContentChangeEvent,
};
use serde::de::DeserializeOwned;
use serde_json::Value;
use std::collections::BTreeMap;

#[derive(Debug)]
struct Text {
    source: Source,
    version: i32,
    is_new: bool,
}

/// Texts by their address.
#[derive(Debug, Default)]
pub struct Texts {
    open: BTreeMap<String, Text>,
}

/// What a message carries.
pub fn params<T: DeserializeOwned>(params: &Value) -> Result<T, Failure> {
    T::deserialize(params).map_err(|error| Failure::params(error.to_string()))
}

impl Texts {
    /// A text.
    pub fn get(&self, uri: &str) -> Result<&Source, Failure> {
        let text = self.open.get(uri).map(|text| &text.source);
        text.ok_or_else(|| Failure::params(format!("`{uri}` is not open")))
    }

    /// The texts that have changed since this was asked last, with their versions.
    pub fn changed(&mut self) -> Vec<(String, i32, Source)> {
        let changed = |(uri, text): (&String, &mut Text)| {
            let is_new = std::mem::take(&mut text.is_new);
            is_new.then(|| (uri.clone(), text.version, text.source.clone()))
        };
        self.open.iter_mut().filter_map(changed).collect()
    }

    pub fn open(&mut self, message: &Value) -> Result<(), Failure> {
        let opened = params::<DidOpenTextDocumentParams>(message)?.text_document;
        let uri = opened.uri.to_string();
        let source = Source::new(&*uri, opened.text);
        self.open.insert(uri, Text { source, version: opened.version, is_new: true });
        Ok(())
    }

    /// Changes a text; if one of the changes does not fit, none is made.
    pub fn change(&mut self, message: &Value, encoding: Encoding) -> Result<(), Failure> {
        let change = params::<DidChangeTextDocumentParams>(message)?;
        let uri = change.text_document.text_document_identifier.uri.to_string();
        let mut text = self.get(&uri)?.text.clone();
        for change in change.content_changes {
            text = match change {
                TextDocumentContentChangeEvent::TextDocumentContentChangeWholeDocument(whole) => whole.text,
                TextDocumentContentChangeEvent::TextDocumentContentChangePartial(part) => {
                    let at = span(&Lines::of(&text), part.range, encoding)?;
                    edited(&text, &[Edit::new(at, part.text)])
                }
            };
        }
        let version = change.text_document.version;
        let source = Source::new(&*uri, text);
        self.open.insert(uri, Text { source, version, is_new: true });
        Ok(())
    }

    /// Forgets a text; gives its address.
    pub fn close(&mut self, message: &Value) -> Result<String, Failure> {
        let uri = params::<DidCloseTextDocumentParams>(message)?.text_document.uri.to_string();
        self.get(&uri)?;
        self.open.remove(&uri);
        Ok(uri)
    }
}
