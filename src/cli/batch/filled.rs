//! The answers to rows as columns in memory.

#[cfg(feature = "arrow")]
use super::super::args::Format;
use super::super::{args::Batch, error::CliError, sink::Sink};
#[cfg(feature = "arrow")]
use super::columns::Table;
use super::job::Job;
use super::rows::AsWritten;
use crate::front::{Line, RowAnswers, RowLayout};
use crate::report::Answers;
use assur_check::{Row, RowColumn};
use std::path::Path;

/// What lines repeat of their row.
pub struct Cited<'a> {
    /// Counted from 1.
    pub number: usize,
    pub label: Option<&'a str>,
    /// Its cells as written.
    pub written: &'a AsWritten<'a>,
    /// Its numbers, where it could be read.
    pub row: Option<&'a Row>,
}

impl Cited<'_> {
    /// The number in a column, in the unit of that; NaN where it is missing.
    pub fn number_of(&self, i: usize, column: &RowColumn) -> f64 {
        match (self.written, self.row) {
            (AsWritten::No, Some(row)) => {
                row.entries().nth(i).map_or(f64::NAN, |(_, cell)| column.unit.from_si(cell.value))
            }
            (written, _) => written.number(i),
        }
    }
}

/// Columns that rows have filled.
pub struct Filled<'a> {
    layout: &'a RowLayout,
    /// Memory for the answers of a line.
    numbers: Vec<f64>,
    /// The answers; rows are counted from 0.
    pub answers: RowAnswers,
    /// The name of the row of each line.
    pub labels: Vec<Option<String>>,
    /// What is repeated of the rows, in the units of the table.
    pub givens: Vec<Vec<f64>>,
}

impl<'a> Filled<'a> {
    pub fn of(job: &'a Job) -> Self {
        let layout = job.layout();
        let givens = job.givens().map(|_| Vec::new()).collect();
        let (numbers, answers, labels) = (Vec::new(), RowAnswers::of(layout), Vec::new());
        Self { layout, numbers, answers, labels, givens }
    }

    /// Adds the lines of a row; without answers one that says why.
    pub fn row(&mut self, job: &Job, row: &Cited<'_>, answers: Option<&Answers<'_>>, error: &str) {
        let before = self.answers.len();
        let index = row.number.saturating_sub(1);
        Line { layout: self.layout, index, numbers: &mut self.numbers, out: &mut self.answers }
            .all(answers, error);
        let count = self.answers.len() - before;
        for ((i, column), cells) in job.givens().zip(&mut self.givens) {
            cells.extend(std::iter::repeat_n(row.number_of(i, column), count));
        }
        if job.label().is_some() {
            self.labels.extend(std::iter::repeat_n(row.label.map(str::to_owned), count));
        }
    }

    pub fn truncate(&mut self, count: usize) {
        self.answers.truncate(count);
        self.labels.truncate(count);
        self.givens.iter_mut().for_each(|cells| cells.truncate(count));
    }

    /// Adds what another one has.
    pub fn append(&mut self, mut other: Self) {
        self.answers.append(&mut other.answers);
        self.labels.append(&mut other.labels);
        self.givens.iter_mut().zip(&mut other.givens).for_each(|(all, cells)| all.append(cells));
    }
}

// Where answers go: to a text, or to a table of columns.

/// A place for answers.
pub struct Out {
    sink: Sink,
    #[cfg(feature = "arrow")]
    table: Option<Table>,
}

impl Out {
    /// The one that is wanted for the answers of these files.
    pub fn of(args: &Batch, jobs: &[Job]) -> Result<Self, CliError> {
        #[cfg(feature = "arrow")]
        let table = table(args, jobs)?;
        #[cfg(not(feature = "arrow"))]
        let _ = jobs;
        let sink = match &args.out {
            Some(path) => Sink::file(Path::new(path))?,
            None => Sink::stdout(),
        };
        Ok(Self {
            sink,
            #[cfg(feature = "arrow")]
            table,
        })
    }

    /// Whether it takes columns.
    pub const fn takes_columns(&self) -> bool {
        #[cfg(feature = "arrow")]
        return self.table.is_some();
        #[cfg(not(feature = "arrow"))]
        false
    }

    pub fn write(&mut self, text: impl AsRef<[u8]>) -> Result<(), CliError> {
        self.sink.write(text)
    }

    pub fn fill(&mut self, filled: Filled<'_>) -> Result<(), CliError> {
        #[cfg(feature = "arrow")]
        if let Some(table) = &mut self.table {
            let bytes = table.written(filled)?;
            return self.sink.write(bytes);
        }
        drop(filled);
        Ok(())
    }

    /// Whether nobody reads any more.
    pub const fn closed(&self) -> bool {
        self.sink.closed()
    }

    /// What was written, with the end of a table.
    pub fn end(self) -> Result<Sink, CliError> {
        #[cfg(feature = "arrow")]
        if let Some(table) = self.table {
            let mut sink = self.sink;
            sink.write(table.end()?)?;
            return Ok(sink);
        }
        Ok(self.sink)
    }
}

#[cfg(feature = "arrow")]
fn table(args: &Batch, jobs: &[Job]) -> Result<Option<Table>, CliError> {
    use assur_arrow::Kind;
    use std::io::IsTerminal;
    let kind = match args.format() {
        Format::Arrow => Kind::Stream,
        Format::Feather => Kind::File,
        #[cfg(feature = "parquet")]
        Format::Parquet => Kind::Parquet,
        _ => return Ok(None),
    };
    if args.out.is_none() && std::io::stdout().is_terminal() {
        return Err(CliError::OnScreen { how: "`--out answers.arrow`" });
    }
    if args.problem.files.len() > 1 || jobs.len() > 1 {
        return Err(CliError::OneTable);
    }
    let name = args.out.as_deref().unwrap_or("standard output");
    jobs.first().map(|job| Table::of(job, kind, name)).transpose()
}
