//! Texts that the host shows beside themselves: what is shown goes out as messages.

use assur::internals::editor::{GoesOn, PageParts};
use assur::internals::lsp::{Pages, View};
use serde_json::{Value, json};
use std::cell::RefCell;
use std::collections::BTreeSet;
use std::rc::Rc;

/// What is shown of a text that takes too long.
const LONG: &str = "  ! this takes too long to be solved here\n  help: `assur solve FILE` has no limit\n";

/// The texts with a panel, and what goes to them.
#[derive(Clone, Debug, Default)]
pub struct Panels(Rc<RefCell<Inside>>);

#[derive(Default)]
struct Inside {
    open: BTreeSet<String>,
    messages: Vec<Value>,
    views: Vec<(String, View)>,
}

impl std::fmt::Debug for Inside {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Inside").field("open", &self.open).finish_non_exhaustive()
    }
}

impl Panels {
    /// What goes out since this was asked last.
    pub fn take(&self) -> Vec<Value> {
        std::mem::take(&mut self.0.borrow_mut().messages)
    }

    fn send(&self, method: &str, params: Value) {
        let message = json!({ "jsonrpc": "2.0", "method": method, "params": params });
        self.0.borrow_mut().messages.push(message);
    }

    /// Draws what waits, as long as it does not take too long.
    pub fn draw(&self, goes_on: &GoesOn<'_>) {
        let views = std::mem::take(&mut self.0.borrow_mut().views);
        for (uri, view) in views {
            let shown = view(goes_on)
                .unwrap_or_else(|| PageParts { diagnostics: LONG.to_owned(), ..PageParts::default() });
            self.send("assur/shown", json!({ "uri": uri, "shown": shown }));
        }
    }

    /// Nobody sees a text any more.
    pub fn close(&self, uri: &str) {
        self.0.borrow_mut().open.remove(uri);
    }
}

impl Pages for Panels {
    fn address(&mut self, uri: &str) -> Result<Option<String>, String> {
        self.0.borrow_mut().open.insert(uri.to_owned());
        Ok(None)
    }

    fn has(&self, uri: &str) -> bool {
        self.0.borrow().open.contains(uri)
    }

    fn mark(&mut self, uri: &str, what: Option<(&'static str, String)>) {
        let marked = what.map(|(class, name)| json!({ "class": class, "name": name }));
        self.send("assur/marked", json!({ "uri": uri, "marked": marked }));
    }

    fn show(&mut self, uri: &str, view: View) {
        self.0.borrow_mut().views.push((uri.to_owned(), view));
    }
}
