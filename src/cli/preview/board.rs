//! What a page shows now, and who waits for what it shows next.

use crate::editor::PageParts;
use serde_json::{Value, json};
use std::sync::{Condvar, Mutex, PoisonError};
use std::time::Duration;

/// What a page shows.
#[derive(Debug, Default)]
struct Now {
    /// Counts what was shown, from 1.
    version: u64,
    /// The last good picture as the page reads it, and the version that brought it.
    picture: Option<(u64, String)>,
    /// The rest, as the page reads it.
    state: Value,
    /// What is at the cursor of an editor, which may be known before the first picture is drawn.
    #[cfg(feature = "lsp")]
    marked: Value,
}

/// What a page shows; newer texts replace older ones.
pub struct Board {
    /// The name of the file.
    name: String,
    now: Mutex<Now>,
    changed: Condvar,
    /// Takes the part of the way at which the page is.
    moved: Option<Moved>,
}

/// Takes the place to which a page is moved.
pub type Moved = Box<dyn Fn(f64) + Send + Sync>;

impl std::fmt::Debug for Board {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Board").field("name", &self.name).finish_non_exhaustive()
    }
}

impl Board {
    /// Nothing is shown yet.
    pub fn new(name: &str) -> Self {
        Self { name: name.to_owned(), now: Mutex::default(), changed: Condvar::new(), moved: None }
    }

    /// A board that passes on where its page is moved.
    #[cfg(feature = "lsp")]
    pub fn with_moves(name: &str, moved: Moved) -> Self {
        Self { moved: Some(moved), ..Self::new(name) }
    }

    /// The page is at a part of the way, from 0 to 1.
    pub fn moved(&self, part: f64) {
        if let Some(moved) = &self.moved {
            moved(part);
        }
    }

    /// Marks what is at the cursor of an editor.
    #[cfg(feature = "lsp")]
    pub fn mark(&self, what: Option<(&'static str, String)>) {
        let marked = what.map(|(class, name)| json!({ "class": class, "name": name })).unwrap_or_default();
        let mut now = self.now.lock().unwrap_or_else(PoisonError::into_inner);
        if now.marked == marked {
            return;
        }
        now.marked = marked.clone();
        if now.state.is_object() {
            now.state["marked"] = marked;
            now.version += 1;
            self.changed.notify_all();
        }
    }

    /// Shows a text. The picture, the answers and the places of the last good one stay where it has none.
    pub fn show(&self, shown: PageParts) {
        let mut now = self.now.lock().unwrap_or_else(PoisonError::into_inner);
        now.version += 1;
        let version = now.version;
        let is_solved = shown.picture.is_some();
        let mut state = std::mem::take(&mut now.state);
        if is_solved || state.is_null() {
            let (answers, declared) = (shown.answers, shown.declared);
            state = json!({ "name": self.name, "answers": answers, "declared": declared });
            #[cfg(feature = "lsp")]
            {
                state["marked"] = now.marked.clone();
            }
            state["follows"] = self.moved.is_some().into();
        }
        if let Some(picture) = shown.picture {
            now.picture = Some((version, serde_json::to_string(&picture).unwrap_or_default()));
        }
        state["diagnostics"] = shown.diagnostics.into();
        state["picture"] = now.picture.as_ref().map(|(version, _)| *version).into();
        state["old"] = (!is_solved).into();
        now.state = state;
        self.changed.notify_all();
    }

    /// What is shown after a version, with its own; nothing where none comes within a time.
    pub fn after(&self, version: u64, time: Duration) -> Option<(u64, String)> {
        let now = self.now.lock().unwrap_or_else(PoisonError::into_inner);
        let is_old = |now: &mut Now| now.version <= version;
        let waited = self.changed.wait_timeout_while(now, time, is_old);
        let (now, _) = waited.unwrap_or_else(PoisonError::into_inner);
        (now.version > version).then(|| (now.version, now.state.to_string()))
    }

    /// The last good picture.
    pub fn picture(&self) -> Option<String> {
        let now = self.now.lock().unwrap_or_else(PoisonError::into_inner);
        now.picture.as_ref().map(|(_, moving)| moving.clone())
    }
}
