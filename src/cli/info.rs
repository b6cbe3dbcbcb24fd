//! `assur info`: what this build is and can do, for reports of errors.

use super::args::{
    Args, Batch, COLUMNS, Completions, DRAWINGS, DrawFormat, Format, Info, InfoFormat, Man, ReportFormat,
    STREAMS, TABLES,
};
use super::error::CliError;
use super::reply::{Status, complaint};
use super::screen::Screen;
use assur_text::diagnostic::did_you_mean;
use clap::{CommandFactory, ValueEnum};
use serde::Serialize;
use std::collections::BTreeMap;
use std::io;
use std::num::NonZero;
use std::path::{Path, PathBuf};

/// The features that a build may have.
const FEATURES: [(&str, bool); 6] = [
    ("arrow", cfg!(feature = "arrow")),
    ("gif", cfg!(feature = "gif")),
    ("lsp", cfg!(feature = "lsp")),
    ("parquet", cfg!(feature = "parquet")),
    ("pdf", cfg!(feature = "pdf")),
    ("png", cfg!(feature = "png")),
];

#[derive(Serialize)]
struct About {
    version: &'static str,
    target: &'static str,
    features: Vec<&'static str>,
    reads: BTreeMap<&'static str, Vec<&'static str>>,
    writes: BTreeMap<&'static str, Vec<String>>,
    processors: usize,
    documents: Option<PathBuf>,
}

/// Prints what this build is and can do.
pub fn run(args: &Info, screen: &Screen) -> Status {
    let about = About::this();
    let text = match args.format {
        InfoFormat::Text => about.text(),
        // plain data is always written
        InfoFormat::Json => serde_json::to_string(&about).unwrap_or_default() + "\n",
    };
    Status::printed(screen.print(text))
}

impl About {
    fn this() -> Self {
        let reads =
            [("problems", vec!["mech"]), ("variants", Batch::tables().collect()), ("grade", vec!["csv"])];
        let writes = [
            ("solve", tables(STREAMS)),
            ("batch", tables(COLUMNS)),
            ("draw", drawn()),
            ("report", values::<ReportFormat>()),
            ("profile", tables(DRAWINGS)),
            ("other tables", tables(&[])),
        ];
        Self {
            version: env!("CARGO_PKG_VERSION"),
            target: env!("ASSUR_TARGET"),
            features: FEATURES.iter().filter(|(_, has)| *has).map(|(name, _)| *name).collect(),
            reads: reads.into_iter().collect(),
            writes: writes.into_iter().collect(),
            processors: std::thread::available_parallelism().map_or(1, NonZero::get),
            documents: documents(),
        }
    }

    fn text(&self) -> String {
        let list = |(what, names): (&&str, String)| format!("  {what:<13}{names}\n");
        let reads: String = self.reads.iter().map(|(what, names)| list((what, names.join(", ")))).collect();
        let writes: String = self.writes.iter().map(|(what, names)| list((what, names.join(", ")))).collect();
        let documents = match &self.documents {
            Some(folder) => format!("{} and `assur help`", folder.display()),
            None => "`assur help`, `assur explain`, and docs in the sources".to_owned(),
        };
        let features = if self.features.is_empty() { "none".to_owned() } else { self.features.join(", ") };
        format!(
            "assur {}\ntarget      {}\nfeatures    {features}\nprocessors  {}\ndocuments   {documents}\n\nreads\n{reads}\nwrites\n{writes}",
            self.version, self.target, self.processors
        )
    }
}

/// The names of formats; without those that only other builds have.
fn values<T: ValueEnum>() -> Vec<String> {
    names(T::value_variants())
}

/// The names of the forms of tables and of others.
fn tables(others: &[Format]) -> Vec<String> {
    names(&[TABLES, others].concat())
}

fn names(values: &[impl ValueEnum]) -> Vec<String> {
    let values = values.iter().filter_map(ValueEnum::to_possible_value);
    values.map(|value| value.get_name().to_owned()).collect()
}

/// Pixels are of builds with that feature.
fn drawn() -> Vec<String> {
    let is_there = |format: &&DrawFormat| format.missing_feature().is_none();
    let formats = DrawFormat::value_variants().iter().filter(is_there);
    formats.map(|format| format.ending().trim_start_matches('.').to_owned()).collect()
}

/// The folder of documents that an installation has next to the program.
fn documents() -> Option<PathBuf> {
    let program = std::env::current_exe().ok()?;
    let folder = program.parent()?.parent()?.join(Path::new("share/doc/assur"));
    folder.is_dir().then_some(folder)
}

// What an installation adds to a system: `assur completions`, `assur man`.

/// Prints the completions of a shell.
pub fn completions(args: &Completions, screen: &Screen) -> Status {
    let mut script = Vec::new();
    clap_complete::generate(args.shell, &mut Args::command(), "assur", &mut script);
    Status::printed(screen.print(script))
}

/// Prints a manual page.
pub fn manual(args: &Man, screen: &Screen) -> Status {
    let mut program = Args::command();
    // gives every command its full name
    program.build();
    let Some(name) = &args.command else { return page(program, "assur", screen) };
    if let Some(command) = program.find_subcommand(name) {
        return page(command.clone(), &format!("assur-{name}"), screen);
    }
    let near = did_you_mean(name, program.get_subcommands().map(clap::Command::get_name));
    let help = match near.first() {
        Some(near) => format!("did you mean `assur man {near}`?"),
        None => "`assur help` lists the commands".to_owned(),
    };
    screen.complain(&complaint(CliError::UnknownTopic { name: name.clone(), help }, screen));
    Status::Unusable
}

fn page(command: clap::Command, title: &str, screen: &Screen) -> Status {
    let mut roff = Vec::new();
    match clap_mangen::Man::new(command).title(title).render(&mut roff) {
        Ok(()) => Status::printed(screen.print(roff)),
        Err(io::Error { .. }) => Status::Unusable,
    }
}
