//! Pages of open texts in a browser, and pictures of them.

use super::Server;
use super::client::PREVIEW;
use super::error::{Failure, span};
use super::texts::params;
use crate::editor::{GoesOn, PageParts};
use assur_text::source::Lines;
use gen_lsp_types::{ExecuteCommandParams, Range, TextDocumentPositionParams};
use serde_json::{Value, json};
use std::fmt::Debug;

/// What a page shows of a text, once it is drawn; nothing where it is not to go on.
pub type View = Box<dyn FnOnce(&GoesOn<'_>) -> Option<PageParts> + Send>;

/// Where texts are shown as pages: given by a program that has sockets and threads.
pub trait Pages: Debug {
    /// The address of the page of a text, the same whenever it is asked, after the text was closed and opened again too; nothing where
    /// the client has a panel for it.
    ///
    /// # Errors
    /// Why there is no page, in words.
    fn address(&mut self, uri: &str) -> Result<Option<String>, String>;

    /// Whether a text has a page.
    fn has(&self, uri: &str) -> bool;

    /// Marks on its page what is at the cursor: its class and its name, as groups of the picture have them.
    fn mark(&mut self, uri: &str, what: Option<(&'static str, String)>);

    /// Shows a text on its page, drawn elsewhere: this returns at once, and a newer view replaces one that waits.
    fn show(&mut self, uri: &str, view: View);
}

/// What a client is asked to show.
pub const SHOW: &str = "window/showDocument";

impl Server {
    /// A session that can show texts as pages.
    #[must_use]
    pub fn with_pages(pages: Box<dyn Pages>) -> Self {
        Self { pages: Some(pages), ..Self::default() }
    }

    /// The address of the page of a text, and how it is brought before the author; nothing for another command.
    pub(super) fn preview(&mut self, message: &Value) -> Option<Result<Value, Failure>> {
        let asked = params::<ExecuteCommandParams>(message).ok().filter(|asked| asked.command == PREVIEW)?;
        let uri = asked.arguments.iter().flatten().find_map(Value::as_str);
        let Some(uri) = uri else {
            return Some(Err(Failure::params(format!("`{PREVIEW}` needs the address of a text"))));
        };
        Some(self.page(uri))
    }

    fn page(&mut self, uri: &str) -> Result<Value, Failure> {
        self.texts.analysis(uri)?;
        let pages = self.pages.as_mut();
        let pages = pages.ok_or_else(|| Failure::request("this server has no pages to show".to_owned()))?;
        let address = pages.address(uri).map_err(Failure::request)?;
        if let Some(view) = self.texts.view(uri) {
            pages.show(uri, view);
        }
        if self.cursor.as_ref().is_some_and(|at| at.text_document.uri.to_string() == uri) {
            self.mark_cursor();
        }
        Ok(json!({ "address": address }))
    }

    /// Shows the texts that are solved now, or cannot be, on their pages.
    pub(super) fn show_pages(&mut self) {
        let Some(pages) = &mut self.pages else { return };
        for uri in self.texts.settled() {
            if pages.has(&uri)
                && let Some(view) = self.texts.view(&uri)
            {
                pages.show(&uri, view);
            }
        }
    }

    /// Marks what is at the place that a request is about, on the page of its text.
    pub(super) fn mark(&mut self, message: &Value) {
        let Ok(at) = params::<TextDocumentPositionParams>(message) else { return };
        self.cursor = Some(at);
        self.mark_cursor();
    }

    fn mark_cursor(&mut self) {
        let Some(at) = &self.cursor else { return };
        let uri = at.text_document.uri.to_string();
        let Some(pages) = self.pages.as_mut().filter(|pages| pages.has(&uri)) else { return };
        let Ok(analysis) = self.texts.analysis(&uri) else { return };
        let range = Range { start: at.position, end: at.position };
        let byte = span(&Lines::of(&analysis.source.text), range, self.client.encoding);
        pages.mark(&uri, byte.ok().and_then(|byte| analysis.marked(byte.start)));
    }

    /// Asks the client to open an address; of one that cannot, the author reads it.
    pub(super) fn opened(&self, result: &Value) -> Option<Value> {
        let address = result["address"].as_str()?;
        Some(if self.client.shows_documents {
            let params = json!({ "uri": address, "external": true, "takeFocus": true });
            json!({ "jsonrpc": "2.0", "id": SHOW, "method": SHOW, "params": params })
        } else {
            super::shown(super::INFO, &format!("the preview is at {address}"))
        })
    }
}
