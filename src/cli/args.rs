//! The manual of the command line.

mod command;
mod course;
mod draw;
mod format;
mod pages;
mod report;

pub use command::Command;
pub use course::{Course, PictureArg, Platform};
pub use draw::{Choice, Draw, DrawFormat, Hundredths, LoadsArg, Picture, ThemeArg};
pub use format::{COLUMNS, DRAWINGS, Format, STREAMS, TABLES};
pub use pages::Batch;
pub use pages::Fmt;
#[cfg(feature = "lsp")]
pub use pages::Lsp;
pub(in crate::cli) use pages::ending;
pub use pages::{
    Card, CardFormat, Completions, Explain, Help, Info, InfoFormat, Man, Mcp, New, Preview, StartKind,
};
pub use report::{Report, ReportFormat};

use std::ffi::OsString;

use clap::{Args as _, FromArgMatches, Parser, ValueEnum};

use crate::exercise::grade::{Credit, Points, Submissions};
use assur_check::Overrides;
use assur_math::element::cam::MOST_STEPS;
use assur_solve::solve::Method;
use assur_text::units::{Dimension, lookup};
use format::table_or;

/// Solves planar mechanism problems written as text.
///
/// A file contains the given values, the mechanism, its loads and the questions. Results go to standard output,
/// diagnostics to standard error.
#[derive(Debug, Parser)]
#[command(name = "assur", version, disable_help_subcommand = true, after_help = EXAMPLES, after_long_help = LONG)]
pub struct Args {
    /// The command
    #[command(subcommand)]
    pub command: Command,
    /// What every command takes
    #[command(flatten)]
    pub shared: Shared,
}

/// What every command takes.
#[derive(Debug, clap::Args)]
pub struct Shared {
    /// Use of colours; `auto` respects NO_COLOR and pipes
    #[arg(long, global = true, display_order = 100, value_enum, value_name = "WHEN", default_value_t = Color::Auto)]
    pub color: Color,
    /// Maximum number of diagnostics shown per file; the others are counted
    #[arg(long, global = true, display_order = 100, value_name = "N", default_value_t = 50, value_parser = at_least_one)]
    pub max_errors: usize,
}

impl Args {
    /// The arguments of the program. Where the first names a command, the others are not built.
    ///
    /// # Errors
    /// What is wrong with them, or the help that they ask for.
    pub fn of(args: impl IntoIterator<Item = OsString>) -> Result<Self, clap::Error> {
        let args: Vec<OsString> = args.into_iter().collect();
        let named = args.get(1).and_then(|first| first.to_str()).and_then(Command::named);
        let Some(command) = named else { return Self::try_parse_from(args) };
        let command = Shared::augment_args(command);
        let program = clap::Command::new("assur").disable_help_subcommand(true).subcommand(command);
        let found = program.try_get_matches_from(args)?;
        let shared = found.subcommand().map_or(&found, |(_, own)| own);
        Ok(Self { shared: Shared::from_arg_matches(shared)?, command: Command::from_arg_matches(&found)? })
    }
}

const EXAMPLES: &str = "Example: assur solve engine.mech";
const LONG: &str = "\
Examples:
  assur new engine --kind crank-slider      a file to start from
  assur check engine.mech                   the structure of the mechanism
  assur check --modes engine.mech           its possible assemblies
  assur check --plan engine.mech            cost of every step and effect per position
  assur check --fix engine.mech             correct misspelt words and signs, then check
  assur solve engine.mech                   the answers as a table
  assur solve examples --format json        one object per file and line
  assur solve engine.mech --format csv      one line per pose, for up to a million of them
  assur solve engine.mech --set r=120mm     with another crank
  assur solve engine.mech --within 1e-6     with a maximum relative error
  assur accuracy engine.mech --plot a.svg   computing time of each accuracy
  assur test 'homework/**/*.mech'           compare with the answer key
  assur profile cam.mech --format dxf       a cam as a drawing
  assur draw engine.mech -o engine.svg      the kinematic scheme, to scale
  assur report engine.mech -o engine.html   the worked solution
  assur batch engine.mech --variants T.csv --out answers.csv
  assur batch homework --key key.csv        solve an exercise set and write its answer key
  assur grade key.csv answers.csv           grade answers
  assur grade key.csv answers.csv --points 'Mb=2,F_A=1' --credit sign=0.5
  assur course moodle homework -o quiz.xml  questions for Moodle, with worked solutions
  assur course prairielearn homework -o questions
  assur fmt engine.mech                     blanks and columns in the one style
  assur fmt --check homework                what would change, as a diff
  assur explain mech::assembly::ambiguous   meaning of a diagnostic
  assur help functions                      the functions of the language

Exit status:
  0  success
  1  a problem has errors; with `test`, an expectation fails; with `grade`, an answer is wrong or missing, or a line
     cannot be graded; with `fmt --check`, a file is not formatted
  2  the command line, a value of `--set` or a file cannot be used, or the output is incomplete: the disk is full, or
     a pipe was closed (this is not reported)
  128 + n  signal n ended the program: 129 SIGHUP, 130 SIGINT (Ctrl-C), 143 SIGTERM; no temporary file is left";

/// Files, and values from outside.
#[derive(Clone, Debug, clap::Args)]
pub struct Problem {
    /// Files, folders, globs, or `-` for standard input
    #[arg(required = true, value_name = "FILES")]
    pub files: Vec<String>,
    /// Replace the value of a `given`, e.g. `--set r=120mm`; may be repeated
    #[arg(long = "set", value_name = "NAME=VALUE", value_parser = setting)]
    pub settings: Vec<(String, String)>,
}

/// Arguments of `check`.
#[derive(Clone, Debug, clap::Args)]
pub struct Check {
    /// Files to check
    #[command(flatten)]
    pub problem: Problem,
    /// List all assemblies of every group at the first pose, each with the line that selects it
    #[arg(long)]
    pub modes: bool,
    /// Run the plan over the file's positions, or a turn of its drive, and list the cost of every step and effect
    #[arg(long)]
    pub plan: bool,
    /// Apply the fixes about which there is no doubt to the files, then check them
    #[arg(long)]
    pub fix: bool,
    /// Output format
    #[arg(long, value_name = "FORMAT", default_value = "table", value_parser = table_or(&[]))]
    pub format: Format,
}

/// Arguments of `test`.
#[derive(Clone, Debug, clap::Args)]
pub struct Test {
    /// Files to test
    #[command(flatten)]
    pub problem: Problem,
    /// Output format
    #[arg(long, value_name = "FORMAT", default_value = "table", value_parser = table_or(&[]))]
    pub format: Format,
}

/// Arguments of `solve`.
#[derive(Clone, Debug, clap::Args)]
pub struct Solve {
    /// Files to solve
    #[command(flatten)]
    pub problem: Problem,
    /// Output format
    #[arg(long, value_name = "FORMAT", default_value = "table", value_parser = table_or(STREAMS))]
    pub format: Format,
    /// Maximum relative error, e.g. 1e-6; the fastest sufficient settings are used and the error reached is reported
    #[arg(long, value_name = "ERROR", value_parser = accuracy)]
    pub within: Option<f64>,
    /// How to integrate a motion under loads [default: what its equations are suited to]
    #[arg(long, value_enum, value_name = "METHOD")]
    pub method: Option<MethodArg>,
    /// Show residuals and condition of every pose, and what the accuracy took; without it the worst of all poses in one line
    #[arg(long)]
    pub accuracy: bool,
    /// Number of threads for long sweeps [default: all processors]
    #[arg(long, value_name = "N", value_parser = threads)]
    pub threads: Option<usize>,
}

/// Arguments of `accuracy`.
#[derive(Clone, Debug, clap::Args)]
pub struct Accuracy {
    /// Files to measure
    #[command(flatten)]
    pub problem: Problem,
    /// Maximum relative error for which a setting is recommended [default: the `within` of the file, else 1e-9]
    #[arg(long = "for", value_name = "ERROR", value_parser = accuracy)]
    pub wanted: Option<f64>,
    /// Show all that was measured after the answer
    #[arg(long)]
    pub details: bool,
    /// Write a diagram of error against time to this file
    #[arg(long, value_name = "FILE.svg")]
    pub plot: Option<String>,
    /// Output format
    #[arg(long, value_name = "FORMAT", default_value = "table", value_parser = table_or(&[]))]
    pub format: Format,
}

/// A method to integrate a motion under loads.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum MethodArg {
    /// Dormand and Prince, order 8
    Dop853,
    /// Radau IIA, order 5, from the first instant on: for stiff motions
    Radau,
}

impl From<MethodArg> for Method {
    fn from(method: MethodArg) -> Self {
        match method {
            MethodArg::Dop853 => Self::Dop853,
            MethodArg::Radau => Self::Radau,
        }
    }
}

/// An error as a part of the quantity.
fn accuracy(text: &str) -> Result<f64, String> {
    match text.trim().parse::<f64>() {
        Ok(x) if x > 0.0 && x < 1.0 => Ok(x),
        _ => Err("write a number between 0 and 1, e.g. 1e-6".to_owned()),
    }
}

fn at_least_one(text: &str) -> Result<usize, String> {
    text.parse::<usize>().ok().filter(|n| *n > 0).ok_or_else(|| "write a number from 1".to_owned())
}

fn threads(text: &str) -> Result<usize, String> {
    match text.parse::<usize>() {
        Ok(n) if (1..=1024).contains(&n) => Ok(n),
        _ => Err("write a number from 1 to 1024".to_owned()),
    }
}

/// Arguments of `grade`.
#[derive(Clone, Debug, clap::Args)]
pub struct Grade {
    /// The answer key, as `assur batch --key` writes it; a row `points` in it gives the points of every column
    #[arg(value_name = "KEY.csv")]
    pub key: String,
    /// The answers: quantities by name with their units in the header, rows by `problem`, `row`, `variant`, `pose`, and
    /// `student` for who answered
    #[arg(value_name = "ANSWERS.csv")]
    pub answers: String,
    /// Maximum difference, relative to the value
    #[arg(long, value_name = "TOLERANCE", default_value = "3%", value_parser = tolerance)]
    pub within: f64,
    /// Leave missing answers out of the totals; without it they count as wrong
    #[arg(long)]
    pub only_answered: bool,
    /// Choose the line that counts where a student answers a row more than once
    #[arg(long, value_enum, value_name = "WHICH", default_value_t = SubmissionsArg::Last)]
    pub submissions: SubmissionsArg,
    /// Give quantities points, as in 'Mb=2,F_A=1'; `*` is for all others; may be repeated
    #[arg(long, value_name = "NAME=POINTS,…", value_parser = Points::read)]
    pub points: Vec<Points>,
    /// Give a part of the points for a slip, as in sign=0.5,unit=0.25; may be repeated
    #[arg(long, value_name = "SLIP=PART,…", value_parser = Credit::read)]
    pub credit: Vec<Credit>,
    /// Output format
    #[arg(long, value_name = "FORMAT", default_value = "table", value_parser = table_or(&[]))]
    pub format: Format,
}

/// Which submission of a row counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum SubmissionsArg {
    /// The first line
    First,
    /// The line with the most points
    Best,
    /// The last line
    Last,
}

impl From<SubmissionsArg> for Submissions {
    fn from(which: SubmissionsArg) -> Self {
        match which {
            SubmissionsArg::First => Self::First,
            SubmissionsArg::Best => Self::Best,
            SubmissionsArg::Last => Self::Last,
        }
    }
}

fn tolerance(text: &str) -> Result<f64, String> {
    let (number, part) = match text.trim().strip_suffix('%') {
        Some(number) => (number.trim(), 0.01),
        None => (text.trim(), 1.0),
    };
    match number.parse::<f64>() {
        Ok(x) if x > 0.0 && x * part < 1.0 => Ok(x * part),
        _ => Err("write a number between 0 and 1, e.g. 3% or 0.03".to_owned()),
    }
}

/// Arguments of `profile`.
#[derive(Clone, Debug, clap::Args)]
pub struct Profile {
    /// File with the cam
    #[command(flatten)]
    pub problem: Problem,
    /// Name of the cam, if the file has several
    #[arg(long, value_name = "NAME")]
    pub cam: Option<String>,
    /// Number of steps of the cam angle [default: 360; of a drawing as many as keep it within 10 um]
    #[arg(long, value_parser = clap::value_parser!(u32).range(3..=i64::from(MOST_STEPS)))]
    pub steps: Option<u32>,
    /// Maximum distance from the curve to the lines between its points, e.g. 1um; sets the number of steps
    #[arg(long, value_name = "LENGTH", conflicts_with = "steps", value_parser = length)]
    pub within: Option<f64>,
    /// Output format
    #[arg(long, value_name = "FORMAT", default_value = "csv", value_parser = table_or(DRAWINGS))]
    pub format: Format,
}

/// A length with its unit, m.
fn length(text: &str) -> Result<f64, String> {
    let example = || "write a length above 0 with its unit, e.g. 1um or 0.01mm".to_owned();
    let text = text.trim();
    let unit = text.trim_start_matches(|c: char| c.is_ascii_digit() || "+-.eE".contains(c));
    let number: f64 = text[..text.len() - unit.len()].parse().map_err(|_| example())?;
    let unit =
        lookup(unit.trim()).ok().filter(|unit| unit.dimension == Dimension::LENGTH).ok_or_else(example)?;
    Some(unit.to_si(number)).filter(|x| x.is_finite() && *x > 0.0).ok_or_else(example)
}

/// When to use colours.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Color {
    /// On a terminal, unless `NO_COLOR` is set
    Auto,
    /// Always
    Always,
    /// Never
    Never,
}

impl Problem {
    /// The values from outside.
    #[must_use]
    pub fn overrides(&self) -> Overrides {
        Overrides::set(self.settings.clone())
    }
}

fn setting(text: &str) -> Result<(String, String), String> {
    match text.split_once('=') {
        Some((name, value)) if !name.trim().is_empty() && !value.trim().is_empty() => {
            Ok((name.trim().to_owned(), value.trim().to_owned()))
        }
        _ => Err("write NAME=VALUE, e.g. r=120mm".to_owned()),
    }
}
