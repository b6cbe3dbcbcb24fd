//! Pages of the texts that an editor has open. Each is drawn on a thread of its own, so that no key waits for it.

use super::board::Board;
use super::site::Site;
use crate::editor::PageParts;
use crate::lsp::{self, View};
use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Arc, Condvar, Mutex, PoisonError};
use std::thread;

/// Pages by the address of their text; they are served from when the first is asked for.
#[derive(Default)]
pub struct Pages {
    site: Option<Arc<Site>>,
    open: BTreeMap<String, Page>,
    moves: Option<Moves>,
}

/// Takes the address of a text, and the part of the way at which its page is.
pub type Moves = Arc<dyn Fn(&str, f64) + Send + Sync>;

impl std::fmt::Debug for Pages {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("Pages")
    }
}

#[derive(Debug)]
struct Page {
    address: String,
    board: Arc<Board>,
    slot: Arc<Slot>,
}

/// Where the newest view waits for the thread that draws it.
#[derive(Default)]
struct Slot {
    next: Mutex<Option<View>>,
    filled: Condvar,
}

impl std::fmt::Debug for Slot {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("Slot")
    }
}

impl Slot {
    fn fill(&self, view: View) {
        *self.next.lock().unwrap_or_else(PoisonError::into_inner) = Some(view);
        self.filled.notify_one();
    }

    fn take(&self) -> View {
        let mut next = self.next.lock().unwrap_or_else(PoisonError::into_inner);
        loop {
            if let Some(view) = next.take() {
                return view;
            }
            next = self.filled.wait(next).unwrap_or_else(PoisonError::into_inner);
        }
    }

    fn is_empty(&self) -> bool {
        self.next.lock().unwrap_or_else(PoisonError::into_inner).is_none()
    }

    /// Draws one view after another, until the program ends.
    fn draw(&self, board: &Board) -> ! {
        loop {
            let view = self.take();
            match catch_unwind(AssertUnwindSafe(|| view(&|| self.is_empty()))) {
                Ok(Some(shown)) => board.show(shown),
                Ok(None) => {}
                Err(_) => {
                    let diagnostics = format!("internal error of assur {}", env!("CARGO_PKG_VERSION"));
                    board.show(PageParts { diagnostics, ..PageParts::default() });
                }
            }
        }
    }
}

impl Pages {
    /// Pages that pass on where they are moved.
    pub fn with_moves(moves: Moves) -> Self {
        Self { moves: Some(moves), ..Self::default() }
    }

    fn started(&mut self, uri: &str) -> std::io::Result<&Page> {
        let site = match &self.site {
            Some(site) => Arc::clone(site),
            None => Arc::clone(self.site.insert(Site::start(0)?)),
        };
        let name = uri.rsplit('/').next().unwrap_or(uri);
        let board = match self.moves.clone() {
            Some(moves) => {
                let uri = uri.to_owned();
                Board::with_moves(name, Box::new(move |part| moves(&uri, part)))
            }
            None => Board::new(name),
        };
        let (board, slot) = (Arc::new(board), Arc::new(Slot::default()));
        let address = site.add(&board)?;
        let (own, drawn) = (Arc::clone(&slot), Arc::clone(&board));
        thread::Builder::new().spawn(move || own.draw(&drawn))?;
        Ok(self.open.entry(uri.to_owned()).or_insert(Page { address, board, slot }))
    }
}

impl lsp::Pages for Pages {
    fn address(&mut self, uri: &str) -> Result<Option<String>, String> {
        if let Some(page) = self.open.get(uri) {
            return Ok(Some(page.address.clone()));
        }
        let page = self.started(uri).map_err(|error| format!("the page cannot be served: {error}"))?;
        Ok(Some(page.address.clone()))
    }

    fn has(&self, uri: &str) -> bool {
        self.open.contains_key(uri)
    }

    fn mark(&mut self, uri: &str, what: Option<(&'static str, String)>) {
        if let Some(page) = self.open.get(uri) {
            page.board.mark(what);
        }
    }

    fn show(&mut self, uri: &str, view: View) {
        if let Some(page) = self.open.get(uri) {
            page.slot.fill(view);
        }
    }
}
