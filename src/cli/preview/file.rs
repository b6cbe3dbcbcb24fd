//! A file that is followed: it is read again and again, since not every system says when one changes.

use super::board::Board;
use crate::cli::error::CliError;
use crate::cli::files::{Input, missing};
use crate::cli::reply::{Reply, guarded};
use crate::cli::screen::Screen;
use crate::editor::{Analysis, PageParts};
use assur_text::source::Source;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};
use std::thread;
use std::time::{Duration, Instant, SystemTime};

/// Between two looks at the file.
const PAUSE: Duration = Duration::from_millis(200);
/// A file that was changed so short a time ago may change again without another time.
const COARSE: Duration = Duration::from_secs(2);

/// A file as it was last read.
#[derive(Debug)]
pub struct Followed {
    path: PathBuf,
    read: Result<Source, String>,
    /// When it was changed, and its length.
    stamp: Option<(SystemTime, u64)>,
}

impl Followed {
    /// Reads a file.
    ///
    /// # Errors
    /// It cannot be read.
    pub fn open(name: &str) -> Result<(Self, Source), CliError> {
        let path = Path::new(name);
        if name != "-" && !path.exists() {
            return Err(missing(name));
        }
        if name == "-" || !path.is_file() {
            return Err(CliError::PreviewsNoFile { name: name.to_owned() });
        }
        let stamp = stamp(path);
        let source = Input::File(path.to_owned()).read()?;
        Ok((Self { path: path.to_owned(), read: Ok(source.clone()), stamp }, source))
    }

    /// What is in it now, where that is new; or why it cannot be read.
    fn changed(&mut self) -> Option<Result<Source, CliError>> {
        let stamp = stamp(&self.path);
        let is_settled = |(time, _): (SystemTime, u64)| time.elapsed().is_ok_and(|age| age > COARSE);
        if stamp == self.stamp && stamp.is_none_or(is_settled) {
            return None;
        }
        let name = || self.path.display().to_string();
        // a pipe of that name would be waited for
        let is_other = std::fs::metadata(&self.path).is_ok_and(|found| !found.is_file());
        let read = if is_other {
            Err(CliError::PreviewsNoFile { name: name() })
        } else {
            Input::File(self.path.clone()).read()
        };
        // Who writes a file may empty it first: it is looked at again.
        if read.as_ref().is_ok_and(|source| source.text.is_empty()) && !stamp.is_some_and(is_settled) {
            return None;
        }
        self.stamp = stamp;
        let kept = read.clone().map_err(|error| error.to_string());
        if kept.as_ref().map(|source| &source.text) == self.read.as_ref().map(|source| &source.text) {
            return None;
        }
        self.read = kept;
        Some(read)
    }

    /// Shows the file, and all that becomes of it.
    pub fn show(mut self, first: Source, board: &Board, screen: &Screen) -> ! {
        let mut next = Some(Ok(first));
        loop {
            match next.take() {
                Some(Ok(source)) => next = self.show_text(&source, board, screen),
                Some(Err(error)) => {
                    let diagnostics = format!("  × {error}\n");
                    board.show(PageParts { diagnostics, ..PageParts::default() });
                }
                None => {
                    thread::sleep(PAUSE);
                    next = self.changed();
                }
            }
        }
    }

    /// Shows a text; gives what is in the file by then, where that stopped it.
    fn show_text(
        &mut self,
        source: &Source,
        board: &Board,
        screen: &Screen,
    ) -> Option<Result<Source, CliError>> {
        let newer = Mutex::new((Instant::now(), self, None));
        let goes_on = || {
            let mut inside = newer.lock().unwrap_or_else(PoisonError::into_inner);
            let (looked, file, found) = &mut *inside;
            if found.is_none() && looked.elapsed() > PAUSE {
                *looked = Instant::now();
                *found = file.changed();
            }
            found.is_none()
        };
        let reply = guarded(source, screen, |source| {
            let analysis = Analysis::of(source.clone());
            let results = analysis.solve_however_long(&goes_on);
            if goes_on() {
                board.show(analysis.preview(results.as_ref()));
            }
            Reply::default()
        });
        if !reply.diagnostics.is_empty() {
            board.show(PageParts { diagnostics: reply.diagnostics, ..PageParts::default() });
        }
        newer.into_inner().unwrap_or_else(PoisonError::into_inner).2
    }
}

fn stamp(path: &Path) -> Option<(SystemTime, u64)> {
    let found = std::fs::metadata(path).ok()?;
    Some((found.modified().ok()?, found.len()))
}
