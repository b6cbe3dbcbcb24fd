//! The manual of `batch`.

use super::{BatchFormat, Problem, accuracy, threads};

/// Arguments of `batch`.
#[derive(Clone, Debug, clap::Args)]
pub struct Batch {
    /// Files to solve
    #[command(flatten)]
    pub problem: Problem,
    /// Table of variants that replaces those of the files: names with units in the header, plain numbers below. Comma-separated
    /// values; by its ending also .arrow, .arrows, .feather or .parquet, where this build reads them
    #[arg(long, value_name = "TABLE.csv")]
    pub variants: Option<String>,
    /// Output format [default: by the ending of --out, else table]
    #[arg(long, value_enum)]
    pub format: Option<BatchFormat>,
    /// Write the answers to this file (created only when complete)
    #[arg(long, value_name = "FILE")]
    pub out: Option<String>,
    /// Write the answer key for `assur grade` to this file, as comma-separated values
    #[arg(long, value_name = "KEY.csv")]
    pub key: Option<String>,
    /// Maximum relative error of every row, e.g. 1e-6; the fastest sufficient settings are used
    #[arg(long, value_name = "ERROR", value_parser = accuracy)]
    pub within: Option<f64>,
    /// Number of threads [default: all processors]
    #[arg(long, value_name = "N", value_parser = threads)]
    pub threads: Option<usize>,
}

impl Batch {
    /// The kinds of tables of variants that this build reads.
    pub fn tables() -> impl Iterator<Item = &'static str> {
        let all = [("csv", true), ("arrow", cfg!(feature = "arrow")), ("parquet", cfg!(feature = "parquet"))];
        all.into_iter().filter_map(|(kind, has)| has.then_some(kind))
    }

    /// The format of the option, else of the file name.
    #[must_use]
    pub fn format(&self) -> BatchFormat {
        let of_name = self.out.as_deref().and_then(ending).and_then(BatchFormat::of_ending);
        self.format.or(of_name).unwrap_or_default()
    }
}

/// The ending of a file's name.
pub(in crate::cli) fn ending(name: &str) -> Option<&str> {
    name.rsplit_once('.').map(|(_, ending)| ending)
}
