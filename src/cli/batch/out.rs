//! Where answers go: to a text, or to a table of columns.

use super::super::args::Batch;
#[cfg(feature = "arrow")]
use super::super::args::BatchFormat;
use super::super::error::CliError;
use super::super::sink::Sink;
#[cfg(feature = "arrow")]
use super::columns::Table;
use super::filled::Filled;
use super::job::Job;
use std::path::Path;

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
    use std::io::IsTerminal;
    let BatchFormat::Columns(kind) = args.format() else { return Ok(None) };
    if args.out.is_none() && std::io::stdout().is_terminal() {
        return Err(CliError::OnScreen { how: "`--out answers.arrow`" });
    }
    if args.problem.files.len() > 1 || jobs.len() > 1 {
        return Err(CliError::OneTable);
    }
    let name = args.out.as_deref().unwrap_or("standard output");
    jobs.first().map(|job| Table::of(job, kind, name)).transpose()
}
