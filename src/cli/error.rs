//! Errors of the command line and with files.

use assur_model::model::{FindKind, Mechanism};
use miette::Diagnostic;
use thiserror::Error;

/// An error that is not one of the text. Its message says all there is to say: it has no code to be explained.
#[derive(Clone, Debug, Error, Diagnostic)]
pub enum CliError {
    #[error("there is no file or folder `{name}`")]
    Missing {
        name: String,
        #[help]
        help: Option<String>,
    },
    /// The file cannot be read.
    #[error("`{name}` cannot be read: {why}")]
    Unreadable {
        name: String,
        /// The message of the system.
        why: String,
    },
    #[error("`{name}` is not UTF-8 text: byte {at} cannot be read")]
    #[diagnostic(help("save the file in the encoding UTF-8"))]
    NotUtf8 {
        name: String,
        /// The first byte that cannot be read, from 1.
        at: usize,
    },
    /// Too long a text, or one without end.
    #[error("`{name}` is longer than {most} MB, the most that is read")]
    TooLong { name: String, most: u64 },
    /// A table that is gone once it is read.
    #[error("`{name}` is not a file, and the rows of a batch are read more than once")]
    #[diagnostic(help("write the table to a file first: `--variants table.csv`"))]
    ReadTwice { name: String },
    #[error("there is no .mech file in the folder `{name}`")]
    #[diagnostic(help(
        "name a file itself to read it although .gitignore names it: such files are left out"
    ))]
    NoMechFiles { name: String },
    /// A glob that matches nothing.
    #[error("no file matches `{pattern}`")]
    NoMatch { pattern: String },
    #[error("`{pattern}` is not a pattern of file names: {why}")]
    BadPattern { pattern: String, why: String },
    /// Several files, one drawing.
    #[error("`{name}` can contain the drawing of one file only, but there are several")]
    #[diagnostic(help("use `--plot` with one file"))]
    OneDrawing { name: String },
    /// Fixes without a file to write them to.
    #[error("`--fix` changes files, and standard input is none")]
    #[diagnostic(help("name a file: `assur check --fix engine.mech`"))]
    FixesStdin,
    /// A preview without a file to follow.
    #[error("`assur preview` follows one file, and `{name}` is none")]
    #[diagnostic(help("name a file: `assur preview engine.mech`"))]
    PreviewsNoFile { name: String },
    /// A page that cannot be served.
    #[error("the page cannot be served{port}: {why}")]
    #[diagnostic(help("without `--port` the system chooses one that is free"))]
    NotServed {
        /// ` on port 80`, or empty.
        port: String,
        /// The message of the system.
        why: String,
    },
    /// Several files, one range of lines.
    #[error("`--range` is of one file, but there are several")]
    #[diagnostic(help("name one file"))]
    OneRange,
    /// Several pictures, one place.
    #[error("`{name}` can contain one picture only, but there are several")]
    #[diagnostic(help("write them to a folder: `-o pictures/{format}`"))]
    OnePicture {
        name: String,
        /// ` --format dxf`, where a folder needs that.
        format: String,
    },
    /// A format that the name of the output is not of.
    #[error("`{name}` is no name of a {ending} file")]
    #[diagnostic(help(
        "let the name end in `{ending}`, leave `--format` out, or write to standard output: `-o -`"
    ))]
    OtherFormat {
        name: String,
        /// `.svg`
        ending: &'static str,
    },
    /// Several worked solutions, one place.
    #[error("`{name}` can contain one worked solution only, but there are several files")]
    #[diagnostic(help("write each to a folder: `assur report homework -o pages`"))]
    OneReport { name: String },
    /// A name that says no format.
    #[error("the ending of `{name}` is not a format of worked solutions")]
    #[diagnostic(help("write `.html`, `.md`, `.typ` or `.txt`, or add `--format html`"))]
    ReportFormat { name: String },
    /// The other poses of a list.
    #[error("pose {first} is drawn, the first of {count}")]
    #[diagnostic(
        severity(Advice),
        help("`-o pictures/` writes one picture per pose; `--pose NAME` draws another")
    )]
    FirstPose {
        /// The one that is drawn.
        first: String,
        /// How many there are.
        count: usize,
    },
    /// Questions as folders.
    #[error("questions of PrairieLearn are folders, and no folder is named")]
    #[diagnostic(help("name one: `assur course prairielearn homework -o questions/`"))]
    NoQuestionFolder,
    /// An option of another platform.
    #[error("`{option}` is an option of Moodle")]
    #[diagnostic(help("leave it out: every answer of PrairieLearn has an input with a unit"))]
    NotOfPlatform { option: &'static str },
    /// A folder that would be replaced.
    #[error("`{name}` is the folder of something else, and is not replaced")]
    #[diagnostic(help(
        "write the questions to another folder; a question is known by its file and its --category"
    ))]
    OtherQuestion { name: String },
    /// A question with too many rows.
    #[error("the question of `{name}` has {rows} rows, and {most} are the most")]
    #[diagnostic(help("choose rows by --row, or give a shorter table by --variants"))]
    TooManyRows { name: String, rows: usize, most: usize },
    /// A question that is too large.
    #[error("the `server.py` of `{name}` has {size} kB, and {most} kB are the most")]
    #[diagnostic(help("choose rows by --row, or give a shorter table by --variants"))]
    TooLarge { name: String, size: usize, most: usize },
    /// A file of questions that no site takes.
    #[error("the file of {rows} rows would have {size} MB, and {most} MB are the most")]
    LargestUpload {
        rows: usize,
        size: usize,
        most: usize,
        #[help]
        help: String,
    },
    /// A large file of questions.
    #[error("the file of questions has {size} MB: many sites of Moodle take no more than 20 MB")]
    #[diagnostic(severity(Advice))]
    LargeUpload {
        size: usize,
        #[help]
        help: String,
    },
    /// No table of variants.
    #[error("`{name}` has no table of variants")]
    #[diagnostic(help("name one: `--variants TABLE.csv`, or write `variants {{ … }}` into the file"))]
    NoTable { name: String },
    /// A build without a kind of picture.
    #[error(
        "`{name}` cannot be written: it takes the feature `{feature}`, which this build of assur does not have"
    )]
    #[diagnostic(help(
        "write `.svg` or `.html`, or install assur with it: `cargo install --path . --features {feature}`"
    ))]
    NotInBuild { name: String, feature: &'static str },
    /// A format of animations, another picture.
    #[error("`{name}` cannot show the picture `{picture}`: {ending} is for animations")]
    #[diagnostic(help("name the animation: `assur draw {file} animation {out}`"))]
    NotAnimation {
        name: String,
        /// `.gif`
        ending: &'static str,
        /// The kind of picture.
        picture: &'static str,
        /// The name of the problem.
        file: String,
        /// `-o engine.gif`
        out: String,
    },
    /// More frames in a time than readers show.
    #[error("{frames} frames in {time} s are more than 50 in a second")]
    #[diagnostic(help(
        "many programs show them slowly: write `--frames {most}` or less, or a longer `--time`"
    ))]
    TooFast {
        frames: usize,
        /// In seconds.
        time: f64,
        most: u32,
    },
    /// A build without files of columns.
    #[error("`{name}` takes the feature `{feature}`, which this build of assur does not have")]
    #[diagnostic(help(
        "use comma-separated values, or install it: `cargo install --path . --features {feature}`"
    ))]
    NoColumns { name: String, feature: &'static str },
    /// An answer key as a table of columns.
    #[error("`{name}` cannot be written: an answer key is comma-separated values")]
    #[diagnostic(help("let its name end in `.csv`; `assur grade` reads no other keys"))]
    KeyOfColumns { name: String },
    #[cfg(feature = "png")]
    #[error("`{name}` cannot be written: no font for its letters is installed")]
    #[diagnostic(help("install one of {families}, e.g. `apt install fonts-liberation`, or write `.svg`"))]
    NoFont {
        name: String,
        /// What is looked for.
        families: String,
    },
    #[error("no row of variants is named `{name}`")]
    NoRow {
        name: String,
        #[help]
        help: String,
    },
    /// An option that changes no picture that is asked for.
    #[error("`{option}` changes no picture that is asked for")]
    NoEffect {
        option: String,
        /// Pictures that it changes.
        #[help]
        help: String,
    },
    /// No cam, or several and no choice.
    #[error("{message}")]
    NoCam {
        message: String,
        #[help]
        help: String,
    },
    /// A cam that takes too many steps.
    #[error("`{name}` needs more than {most} steps to be so accurate: with {most} its error is {reached} µm")]
    #[diagnostic(help("give `--within` a greater length"))]
    TooManySteps { name: String, most: u32, reached: String },
    /// Results that cannot be written.
    #[error("`{name}` cannot be written: {why}")]
    #[diagnostic(help("the existing file was not changed"))]
    Unwritable {
        name: String,
        /// The message of the system.
        why: String,
    },
    /// Several files, or rows of variants, in one stream.
    #[cfg(feature = "arrow")]
    #[error("a stream of Arrow contains the answers of one file without variants")]
    #[diagnostic(help("name one file; `assur batch` solves rows of variants"))]
    OneStream,
    /// A stream on a screen.
    #[cfg(feature = "arrow")]
    #[error("columns cannot be read on a screen")]
    #[diagnostic(help("write it to a file: {how}"))]
    OnScreen {
        /// The words to add.
        how: &'static str,
    },
    /// A table that has no place in lines of answers.
    #[error("`{name}` is a table of its own and not in these lines")]
    #[diagnostic(severity(Advice), help("`assur solve --format table` or `--format json` has it"))]
    TableLeftOut { name: String },
    /// Several files, one table.
    #[cfg(feature = "arrow")]
    #[error("a table of columns contains the answers of one file")]
    #[diagnostic(help("name one file, or write comma-separated values"))]
    OneTable,
    /// Results that cannot be printed.
    #[error("standard output cannot be written: {why}")]
    Unprinted {
        /// The message of the system.
        why: String,
    },
    /// Results in the place of what they are made from.
    #[error("`{name}` is both an input and the output")]
    #[diagnostic(help("write the results to another file"))]
    Overwrites { name: String },
    /// Results that would take the place of those of more files.
    #[error("a file is missing in the results: nothing is replaced")]
    #[diagnostic(help("the results of the other files are kept in {kept}"))]
    NotAll { kept: String },
    #[error("interrupted after {rows} rows")]
    #[diagnostic(help("{}", if kept.is_empty() { "all printed rows are complete".to_owned() }
        else { format!("the complete rows are kept in {kept}") }))]
    Interrupted {
        /// How many are done.
        rows: usize,
        kept: String,
    },
    #[error("the threads cannot be started: {why}")]
    Threads {
        /// The message of the system.
        why: String,
    },
    #[error("there is no diagnostic `{code}`")]
    UnknownCode {
        code: String,
        #[help]
        help: String,
    },
    /// No such topic of the manual.
    #[error("there is no command and no topic `{name}`")]
    UnknownTopic {
        name: String,
        /// What may be meant.
        #[help]
        help: String,
    },
    /// A file in a folder that does not exist.
    #[error("there is no folder `{name}`")]
    #[diagnostic(help("create it first: `mkdir -p {name}`"))]
    NoFolder { name: String },
    /// Several pictures in the place of a file.
    #[error("`{name}` is a file, not a folder for pictures")]
    #[diagnostic(help("name a folder, or a file that ends in `.svg` or `.html`"))]
    NotAFolder { name: String },
    /// A new file would replace another.
    #[error("`{name}` exists already")]
    #[diagnostic(help("choose another name; the existing file was not changed"))]
    Exists { name: String },
    /// A new file that cannot be written.
    #[error("`{name}` cannot be written: {why}")]
    NotCreated {
        name: String,
        /// The message of the system.
        why: String,
    },
    /// Points for what is not in the key.
    #[error("`--points`: the key has no `{name}`")]
    NoQuantity {
        name: String,
        /// What may be meant.
        #[help]
        help: String,
    },
    /// A file or a folder that a folder has.
    #[error(transparent)]
    #[diagnostic(transparent)]
    InFolder(Box<Self>),
    #[error("internal error of assur {version} in `{file}`: {what}")]
    #[diagnostic(help(
        "report it with the file and this message: it is an error of the program, not of your file"
    ))]
    Internal { file: String, what: String, version: &'static str },
}

impl CliError {
    /// What a folder has and cannot be read.
    pub fn in_folder(self) -> Self {
        Self::InFolder(Box::new(self))
    }

    /// Whether a file that a folder has cannot be read: the answers of the others are whole.
    pub const fn is_in_folder(&self) -> bool {
        matches!(self, Self::InFolder(_))
    }

    /// What lines of answers leave out.
    pub fn left_out(mechanism: &Mechanism) -> Option<Self> {
        let table = mechanism.finds.iter().find(|find| matches!(find.kind, FindKind::Table(_)))?;
        Some(Self::TableLeftOut { name: table.name.clone() })
    }
}

impl assur_text::diagnostic::Problem for CliError {}
