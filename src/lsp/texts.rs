//! The texts that are open in the client.

use super::error::{Failure, span};
use super::guarded;
use super::preview::View;
use crate::editor::{Analysis, Earlier, Results};
use assur_text::source::{Edit, Encoding, Lines, Source, edited};
use gen_lsp_types::{
    DidChangeTextDocumentParams, DidCloseTextDocumentParams, DidOpenTextDocumentParams,
    TextDocumentContentChangeEvent,
};
use serde::Deserialize;
use serde::de::DeserializeOwned;
use serde_json::Value;
use std::cell::OnceCell;
use std::collections::BTreeMap;
use std::sync::Arc;

/// Why solving is to stop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    Later,
    /// It takes too long.
    Never,
}

/// Asked again and again while a text is solved.
pub type Patience<'p> = dyn Fn() -> Option<Stop> + Sync + 'p;

#[derive(Debug)]
struct Text {
    source: Source,
    version: i32,
    is_new: bool,
    /// It was settled before: it is solved, or has no answers.
    is_settled: bool,
    /// The part of the way at which the author looks; it stays while the text changes.
    part: Option<f64>,
    /// What is found in it, once it is asked for.
    analysis: OnceCell<Arc<Analysis>>,
    /// What it comes to; `None` inside where it has no answers or takes too long.
    results: Option<Option<Arc<Results>>>,
    /// The last text with answers before it.
    earlier: Option<Earlier>,
    /// What the last test of its rows came to.
    tested: OnceCell<String>,
    /// An error of the program ended its solution, and nobody heard of it.
    is_broken: bool,
}

impl Text {
    fn new(uri: &str, text: String, version: i32) -> Self {
        Self {
            source: Source::new(uri, text),
            version,
            is_new: true,
            is_settled: false,
            part: None,
            analysis: OnceCell::new(),
            results: None,
            earlier: None,
            tested: OnceCell::new(),
            is_broken: false,
        }
    }

    /// The text with a change, which keeps what does not depend on it.
    fn changed(&self, uri: &str, text: String, version: i32) -> Self {
        let results = self.results.as_ref().and_then(Option::as_ref).filter(|results| results.is_solved());
        let solved = results
            .map(|results| Earlier { analysis: Arc::clone(self.analysis()), results: Arc::clone(results) });
        Self {
            part: self.part,
            earlier: solved.or_else(|| self.earlier.clone()),
            ..Self::new(uri, text, version)
        }
    }

    fn analysis(&self) -> &Arc<Analysis> {
        self.analysis.get_or_init(|| Arc::new(Analysis::of(self.source.clone())))
    }
}

/// Where the author looks at a text.
#[derive(Deserialize)]
struct PoseParams {
    uri: String,
    part: Option<f64>,
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
    /// What is found in a text.
    pub fn analysis(&self, uri: &str) -> Result<&Analysis, Failure> {
        self.get(uri).map(|text| text.analysis().as_ref())
    }

    /// Its version, as the client counts.
    pub fn version(&self, uri: &str) -> Option<i32> {
        self.open.get(uri).map(|text| text.version)
    }

    /// Its answers, where it is solved.
    pub fn results(&self, uri: &str) -> Option<&Results> {
        self.open.get(uri)?.results.as_ref()?.as_deref()
    }

    /// The last text with answers before it, with them.
    pub fn earlier(&self, uri: &str) -> Option<&Earlier> {
        self.open.get(uri)?.earlier.as_ref()
    }

    /// What is written in a text.
    pub fn written(&self, uri: &str) -> Option<&str> {
        Some(&self.open.get(uri)?.source.text)
    }

    /// What the last test of its rows came to.
    pub fn tested(&self, uri: &str) -> Option<&str> {
        self.open.get(uri)?.tested.get().map(String::as_str)
    }

    /// Keeps what a test of its rows came to.
    pub fn keep_tested(&self, uri: &str, what: &str) {
        if let Some(text) = self.open.get(uri) {
            text.tested.get_or_init(|| what.to_owned());
        }
    }

    /// Looks at the part of the way that a message names.
    pub fn look_at(&mut self, message: &Value) -> Result<(), Failure> {
        let asked = params::<PoseParams>(message)?;
        let text = self.open.get_mut(&asked.uri);
        let text = text.ok_or_else(|| Failure::params(format!("`{}` is not open", asked.uri)))?;
        text.part = asked.part;
        let earlier = text.earlier.iter().map(|earlier| &earlier.results);
        text.results.iter().flatten().chain(earlier).for_each(|results| results.look_at(asked.part));
        Ok(())
    }

    /// The addresses of all texts.
    pub fn uris(&self) -> impl Iterator<Item = &str> {
        self.open.keys().map(String::as_str)
    }

    /// Solves the texts that are not solved yet; gives those that have answers now, with their versions. A text that is to be
    /// solved later stays so; one that takes too long has no answers.
    pub fn solve(&mut self, patience: &Patience<'_>) -> Vec<(String, i32)> {
        let mut solved = Vec::new();
        for (uri, text) in self.open.iter_mut().filter(|(_, text)| text.results.is_none()) {
            let tried = guarded(|| text.analysis().solve(&|| patience().is_none()));
            text.is_broken |= tried.is_none();
            let found = tried.flatten();
            if found.is_none() && patience() == Some(Stop::Later) {
                break;
            }
            if found.is_some() {
                solved.push((uri.clone(), text.version));
            }
            found.iter().for_each(|results| results.look_at(text.part));
            text.results = Some(found.map(Arc::new));
        }
        solved
    }

    /// What a page shows of a text that is solved or has no answers. A text that took too long is solved there.
    pub fn view(&self, uri: &str) -> Option<View> {
        let text = self.open.get(uri)?;
        let (analysis, results) = (Arc::clone(text.analysis()), text.results.clone()?);
        Some(Box::new(move |goes_on| match results {
            Some(results) => Some(analysis.preview(Some(&*results))),
            None => {
                let found = analysis.solve_however_long(goes_on);
                goes_on().then(|| analysis.preview(found.as_ref()))
            }
        }))
    }

    /// The texts that are solved, or have no answers, since this was asked last.
    pub fn settled(&mut self) -> Vec<String> {
        let settled = self.open.iter_mut().filter(|(_, text)| text.results.is_some());
        settled
            .filter_map(|(uri, text)| (!std::mem::replace(&mut text.is_settled, true)).then(|| uri.clone()))
            .collect()
    }

    /// The texts at which an error of the program ended the solution since this was asked last.
    pub fn broken(&mut self) -> Vec<String> {
        let broken = self.open.iter_mut().filter(|(_, text)| text.is_broken);
        broken.map(|(uri, text)| (uri.clone(), text.is_broken = false).0).collect()
    }

    fn get(&self, uri: &str) -> Result<&Text, Failure> {
        self.open.get(uri).ok_or_else(|| Failure::params(format!("`{uri}` is not open")))
    }

    /// The texts that have changed since this was asked last, with their versions.
    pub fn changed(&mut self) -> Vec<(String, i32)> {
        let changed = |(uri, text): (&String, &mut Text)| {
            std::mem::take(&mut text.is_new).then(|| (uri.clone(), text.version))
        };
        self.open.iter_mut().filter_map(changed).collect()
    }

    pub fn open(&mut self, message: &Value) -> Result<(), Failure> {
        let opened = params::<DidOpenTextDocumentParams>(message)?.text_document;
        let uri = opened.uri.to_string();
        let text = Text::new(&uri, opened.text, opened.version);
        self.open.insert(uri, text);
        Ok(())
    }

    /// Changes a text; if one of the changes does not fit, none is made.
    pub fn change(&mut self, message: &Value, encoding: Encoding) -> Result<(), Failure> {
        let change = params::<DidChangeTextDocumentParams>(message)?;
        let uri = change.text_document.text_document_identifier.uri.to_string();
        let mut text = self.get(&uri)?.source.text.clone();
        for change in change.content_changes {
            text = match change {
                TextDocumentContentChangeEvent::TextDocumentContentChangeWholeDocument(whole) => whole.text,
                TextDocumentContentChangeEvent::TextDocumentContentChangePartial(part) => {
                    let at = span(&Lines::of(&text), part.range, encoding)?;
                    edited(&text, &[Edit::new(at, part.text)])
                }
            };
        }
        let changed = self.get(&uri)?.changed(&uri, text, change.text_document.version);
        self.open.insert(uri, changed);
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
