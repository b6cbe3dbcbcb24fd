//! Texts that the host shows beside themselves: what is shown goes out as messages.

use assur::internals::lsp::{Pages, View};
use serde_json::{Value, json};
use std::cell::RefCell;
use std::collections::BTreeSet;
use std::rc::Rc;

/// The texts with a panel, and what goes to them.
#[derive(Clone, Debug, Default)]
pub struct Panels(Rc<RefCell<Inside>>);

#[derive(Debug, Default)]
struct Inside {
    open: BTreeSet<String>,
    messages: Vec<Value>,
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
        if let Some(shown) = view(&|| true) {
            self.send("assur/shown", json!({ "uri": uri, "shown": shown }));
        }
    }
}
