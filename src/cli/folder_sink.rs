//! Folders that are there only when complete.

use super::error::CliError;
use super::sink::unfinished;
use super::stop::count_written;
use std::fs;
use std::io;
use std::path::Path;
use tempfile::Builder;

/// Writes files to a temporary folder, then puts it in place; what was there before goes.
///
/// # Errors
/// It cannot be written; then what was there is still there.
pub fn put(folder: &Path, files: &[(String, Vec<u8>)]) -> Result<(), CliError> {
    put_in(folder, files).map_err(|error| {
        let (name, why) = (folder.display().to_string(), error.to_string());
        if folder.exists() { CliError::Unwritable { name, why } } else { CliError::NotCreated { name, why } }
    })
}

fn put_in(folder: &Path, files: &[(String, Vec<u8>)]) -> io::Result<()> {
    let parent = folder.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
    // a signal waits until it is there
    let _whole = unfinished();
    let temporary = Builder::new().prefix(".assur-").suffix(".tmp").tempdir_in(parent)?;
    // the temporary folder itself is for one user alone
    let (new, old) = (temporary.path().join("new"), temporary.path().join("old"));
    for (name, bytes) in files {
        let path = new.join(name);
        fs::create_dir_all(path.parent().unwrap_or(&new))?;
        fs::write(&path, bytes)?;
        fs::File::open(&path)?.sync_all()?;
    }
    let is_there = folder.exists();
    if is_there {
        fs::rename(folder, &old)?;
    }
    let done = fs::rename(&new, folder);
    if done.is_err() && is_there {
        fs::rename(&old, folder)?;
    }
    done.inspect(|()| count_written())
}
