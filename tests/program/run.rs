//! Runs the program in a folder of its own.

#![allow(clippy::unwrap_used)] // a test that cannot write its files has failed

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::sync::atomic::{AtomicU32, Ordering};

/// A folder for one test; it is removed at the end.
pub struct Folder(PathBuf);

impl Folder {
    /// An empty folder.
    pub fn new(name: &str) -> Self {
        // tests run side by side, and two may take the same name
        static COUNT: AtomicU32 = AtomicU32::new(0);
        let count = COUNT.fetch_add(1, Ordering::Relaxed);
        let path = std::env::temp_dir().join(format!("assur-cli-{}-{count}-{name}", std::process::id()));
        // left over from a test that was stopped
        let _ = std::fs::remove_dir_all(&path);
        std::fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    /// With a file in it.
    pub fn with(self, name: &str, text: &str) -> Self {
        self.write_bytes(name, text.as_bytes());
        self
    }

    /// Writes a file.
    pub fn write_bytes(&self, name: &str, bytes: &[u8]) {
        let path = self.0.join(name);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, bytes).unwrap();
    }
}

impl Folder {
    /// The text of a file.
    pub fn read(&self, name: &str) -> String {
        std::fs::read_to_string(self.0.join(name)).unwrap()
    }

    /// The path of a file.
    pub fn path(&self, name: &str) -> String {
        self.0.join(name).display().to_string()
    }

    /// The names of all files.
    pub fn names(&self) -> Vec<String> {
        let entries = std::fs::read_dir(&self.0).unwrap().flatten();
        let mut names: Vec<_> = entries.map(|e| e.file_name().to_string_lossy().into_owned()).collect();
        names.sort();
        names
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

/// What came out.
pub struct Said {
    pub status: i32,
    pub stdout: String,
    pub stderr: String,
}

fn command(folder: &Folder, args: &[&str]) -> Command {
    command_in(&folder.0, args)
}

fn command_in(folder: &Path, args: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_assur"));
    command.current_dir(folder).args(args);
    for name in ["NO_COLOR", "CLICOLOR", "CLICOLOR_FORCE", "RUST_BACKTRACE", "COLUMNS"] {
        command.env_remove(name);
    }
    command
}

fn said(out: Output) -> Said {
    Said {
        status: out.status.code().unwrap_or(-1),
        stdout: String::from_utf8(out.stdout).unwrap(),
        stderr: String::from_utf8(out.stderr).unwrap(),
    }
}

/// Runs the program.
pub fn assur(folder: &Folder, args: &[&str]) -> Said {
    said(command(folder, args).stdin(Stdio::null()).output().unwrap())
}

/// Runs the program in another folder.
pub fn assur_in(folder: &Path, args: &[&str]) -> Said {
    said(command_in(folder, args).stdin(Stdio::null()).output().unwrap())
}

/// Starts the program.
pub fn start(folder: &Folder, args: &[&str]) -> Child {
    let mut command = command(folder, args);
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap()
}

/// Waits for its end.
pub fn end(child: Child) -> Said {
    said(child.wait_with_output().unwrap())
}

/// Runs the program with a text on standard input.
pub fn with_input(folder: &Folder, args: &[&str], text: &str) -> Said {
    let mut child = command(folder, args)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    child.stdin.take().unwrap().write_all(text.as_bytes()).unwrap();
    said(child.wait_with_output().unwrap())
}

/// Runs the program with its standard output in a pipe that nobody reads.
pub fn into_closed_pipe(folder: &Folder, args: &[&str]) -> Said {
    let (reader, writer) = std::io::pipe().unwrap();
    drop(reader);
    said(command(folder, args).stdin(Stdio::null()).stdout(writer).output().unwrap())
}

/// Runs the program with its standard output, or its standard error, going to a file.
pub fn into_file(folder: &Folder, args: &[&str], path: &str, errors: bool) -> Said {
    let file = std::fs::File::options().write(true).create(true).truncate(false).open(path).unwrap();
    let mut command = command(folder, args);
    command.stdin(Stdio::null());
    let out = if errors { command.stderr(file) } else { command.stdout(file) }.output().unwrap();
    said(out)
}

/// What the program says on standard error when nobody reads its standard output.
pub fn with_closed_output(folder: &Folder, args: &[&str]) -> String {
    let mut child = command(folder, args)
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    said(child.wait_with_output().unwrap()).stderr
}

/// The text with its numbers to six decimals: the last digits are the arithmetic's, not the program's.
pub fn rounded(text: &str) -> String {
    let is_figure = |c: char| c.is_ascii_digit() || matches!(c, '.' | 'e' | '-');
    let mut out = String::new();
    let mut number = String::new();
    for c in text.chars().chain(['\0']) {
        if is_figure(c) {
            number.push(c);
            continue;
        }
        match number.parse::<f64>() {
            Ok(x) if number.contains('.') || number.contains("e-") => {
                out += &format!("{:?}", (x * 1e6).round() / 1e6 + 0.0);
            }
            _ => out += &number,
        }
        number.clear();
        out.extend((c != '\0').then_some(c));
    }
    out
}

/// The cells of a table.
pub fn rows(text: &str) -> Vec<Vec<String>> {
    let cells = |line: &str| {
        let cells = assur::internals::exercise::table::cells(
            line,
            assur::internals::exercise::table::Separator::Comma,
        )
        .unwrap();
        cells.into_iter().map(|c| c.text.into_owned()).collect()
    };
    text.lines().map(cells).collect()
}

/// A column of a table by its name.
pub fn column(text: &str, name: &str) -> Vec<String> {
    let rows = rows(text);
    let i = rows[0].iter().position(|h| h == name).unwrap_or_else(|| panic!("{name} in {text}"));
    rows[1..].iter().map(|r| r.get(i).cloned().unwrap_or_default()).collect()
}

/// Whether this process, and so every program it starts, ignores SIGHUP: started by `nohup`.
#[cfg(unix)]
pub fn ignores_hangup() -> bool {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok()).unwrap_or(0) & 1 == 1
}
