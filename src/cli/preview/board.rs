//! What a page shows now, and who waits for what it shows next.

use crate::editor::Shown;
use serde_json::{Value, json};
use std::sync::{Condvar, Mutex, PoisonError};
use std::time::Duration;

/// What a page shows.
#[derive(Debug, Default)]
struct Now {
    /// Counts what was shown, from 1.
    version: u64,
    /// The last good picture, and the version that brought it.
    picture: Option<(u64, String)>,
    /// The rest, as the page reads it.
    state: Value,
}

/// What a page shows; newer texts replace older ones.
#[derive(Debug)]
pub struct Board {
    /// The name of the file.
    name: String,
    now: Mutex<Now>,
    changed: Condvar,
}

impl Board {
    /// Nothing is shown yet.
    pub fn new(name: &str) -> Self {
        Self { name: name.to_owned(), now: Mutex::default(), changed: Condvar::new() }
    }

    /// Shows a text. The picture, the answers and the places of the last good one stay where it has none.
    pub fn show(&self, shown: Shown) {
        let mut now = self.now.lock().unwrap_or_else(PoisonError::into_inner);
        now.version += 1;
        let version = now.version;
        let is_solved = shown.picture.is_some();
        let mut state = std::mem::take(&mut now.state);
        if is_solved || state.is_null() {
            state = json!({ "name": self.name, "answers": shown.answers, "declared": shown.declared });
        }
        if let Some(picture) = shown.picture {
            now.picture = Some((version, picture));
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
        now.picture.as_ref().map(|(_, page)| page.clone())
    }
}
