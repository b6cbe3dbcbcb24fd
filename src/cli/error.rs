//! What can be wrong with the command line and with files.

use miette::Diagnostic;
use thiserror::Error;

/// An error that is not one of the text. Its message says all there is to say: it has no code to be explained.
#[derive(Clone, Debug, Error, Diagnostic)]
pub enum CliError {
    /// No such file.
    #[error("there is no file or folder `{name}`")]
    Missing {
        /// As given.
        name: String,
    },
    /// The file cannot be read.
    #[error("`{name}` cannot be read: {why}")]
    Unreadable {
        /// As given.
        name: String,
        /// What the system says.
        why: String,
    },
    /// No text.
    #[error("`{name}` is not a text in UTF-8: byte {at} cannot be read")]
    #[diagnostic(help("save the file in the encoding UTF-8"))]
    NotUtf8 {
        /// As given.
        name: String,
        /// The first byte that cannot be read, from 1.
        at: usize,
    },
    /// An empty folder.
    #[error("there is no .mech file in the folder `{name}`")]
    #[diagnostic(help(
        "files that .gitignore names are left out; name a file itself to read it all the same"
    ))]
    NoMechFiles {
        /// As given.
        name: String,
    },
    /// A glob that matches nothing.
    #[error("no file matches `{pattern}`")]
    NoMatch {
        /// As given.
        pattern: String,
    },
    /// No glob.
    #[error("`{pattern}` is not a pattern of file names: {why}")]
    BadPattern {
        /// As given.
        pattern: String,
        /// What is wrong.
        why: String,
    },
    /// Several files, one drawing.
    #[error("`{name}` can hold the drawing of one file, and there are several")]
    #[diagnostic(help("give `--plot` with one file"))]
    OneDrawing {
        /// The drawing.
        name: String,
    },
    /// No cam, or several and no choice.
    #[error("{message}")]
    NoCam {
        /// What is wrong.
        message: String,
        /// What to do.
        #[help]
        help: String,
    },
    /// Results that cannot be written.
    #[error("`{name}` cannot be written: {why}")]
    #[diagnostic(help("what stood there is as it was"))]
    Unwritable {
        /// As given.
        name: String,
        /// What the system says.
        why: String,
    },
    /// Results that cannot be printed.
    #[error("standard output cannot be written: {why}")]
    Unprinted {
        /// What the system says.
        why: String,
    },
    /// Results in the place of what they are made from.
    #[error("`{name}` is read and written at once")]
    #[diagnostic(help("give the results a file of their own"))]
    Overwrites {
        /// As given.
        name: String,
    },
    /// A signal.
    #[error("interrupted after {rows} rows")]
    #[diagnostic(help("{}", if kept.is_empty() { "all rows printed are whole".to_owned() }
        else { format!("these rows are kept in {kept}") }))]
    Interrupted {
        /// How many are done.
        rows: usize,
        /// Where they are.
        kept: String,
    },
    /// No threads.
    #[error("the threads cannot be started: {why}")]
    Threads {
        /// What the system says.
        why: String,
    },
    /// No such code.
    #[error("there is no diagnostic `{code}`")]
    UnknownCode {
        /// As given.
        code: String,
        /// What may be meant.
        #[help]
        help: String,
    },
    /// Points for what is not in the key.
    #[error("`--points`: the key has no `{name}`")]
    NoQuantity {
        /// As given.
        name: String,
        /// What may be meant.
        #[help]
        help: String,
    },
    /// Our own mistake.
    #[error("internal error of assur {version} in `{file}`: {what}")]
    #[diagnostic(help(
        "this is a mistake of the program, not of your file: please report it with the file and this message"
    ))]
    Internal {
        /// The file.
        file: String,
        /// The message.
        what: String,
        /// Our version.
        version: &'static str,
    },
}
