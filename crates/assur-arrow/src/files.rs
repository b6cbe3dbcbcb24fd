//! Tables in files: streams and files of Arrow IPC, files of Parquet.

use arrow_array::{RecordBatch, RecordBatchReader};
use arrow_ipc::reader::{FileReader, StreamReader};
use arrow_ipc::writer::{FileWriter, StreamWriter};
use arrow_schema::{ArrowError, SchemaRef};
use std::fs::File;
use std::io::{self, BufReader, Read, Seek, Write};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Arc, Mutex, PoisonError};

/// Batches of rows, one after another.
pub type Reader = Box<dyn RecordBatchReader + Send>;

/// How a table is kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A stream of Arrow IPC.
    Stream,
    /// A file of Arrow IPC, which has the places of its batches at its end.
    File,
    /// A file of Parquet.
    #[cfg(feature = "parquet")]
    Parquet,
}

/// Opens a table of any kind: files say by their first bytes what they are.
///
/// # Errors
/// What cannot be read.
pub fn open(mut file: File) -> Result<Reader, ArrowError> {
    let mut first = [0; 4];
    let read = file.read(&mut first)?;
    file.rewind()?;
    careful(|| match &first[..read] {
        b"ARRO" => Ok(Box::new(Checked(FileReader::try_new(BufReader::new(file), None)?)) as Reader),
        b"PAR1" => parquet(file),
        _ => Ok(Box::new(Checked(StreamReader::try_new(BufReader::new(file), None)?)) as Reader),
    })
}

#[cfg(feature = "parquet")]
fn parquet(file: File) -> Result<Reader, ArrowError> {
    use parquet::arrow::arrow_reader::ParquetRecordBatchReaderBuilder;
    let reader = ParquetRecordBatchReaderBuilder::try_new(file)?.with_batch_size(BATCH).build()?;
    Ok(Box::new(Checked(reader)))
}

#[cfg(not(feature = "parquet"))]
fn parquet(_: File) -> Result<Reader, ArrowError> {
    Err(ArrowError::ParquetError("this build of assur reads no Parquet".to_owned()))
}

/// Rows that are read at a time, and lines that are written at a time, of Parquet.
#[cfg(feature = "parquet")]
const BATCH: usize = 1 << 16;

/// Files that are not what they say make a reader give up: that is an error, too.
fn careful<T>(read: impl FnOnce() -> Result<T, ArrowError>) -> Result<T, ArrowError> {
    let not = || ArrowError::IpcError("it is not what its schema says".to_owned());
    catch_unwind(AssertUnwindSafe(read)).unwrap_or_else(|_| Err(not()))
}

struct Checked<R>(R);

impl<R: RecordBatchReader> Iterator for Checked<R> {
    type Item = Result<RecordBatch, ArrowError>;

    fn next(&mut self) -> Option<Self::Item> {
        careful(|| self.0.next().transpose()).transpose()
    }
}

impl<R: RecordBatchReader> RecordBatchReader for Checked<R> {
    fn schema(&self) -> SchemaRef {
        self.0.schema()
    }
}

/// Writes batches as bytes, which are taken as they come.
pub struct Writer {
    bytes: Taken,
    table: Table,
}

enum Table {
    Stream(StreamWriter<Taken>),
    File(FileWriter<Taken>),
    #[cfg(feature = "parquet")]
    Parquet(Box<parquet::arrow::ArrowWriter<Taken>>),
}

/// Bytes that the one writes and the other takes.
#[derive(Clone, Default)]
struct Taken(Arc<Mutex<Vec<u8>>>);

impl Write for Taken {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).extend_from_slice(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl Writer {
    /// Of a kind.
    ///
    /// # Errors
    /// The schema cannot be written.
    pub fn of(kind: Kind, schema: &SchemaRef) -> Result<Self, ArrowError> {
        let bytes = Taken::default();
        let table = match kind {
            Kind::Stream => Table::Stream(StreamWriter::try_new(bytes.clone(), schema)?),
            Kind::File => Table::File(FileWriter::try_new(bytes.clone(), schema)?),
            #[cfg(feature = "parquet")]
            Kind::Parquet => Table::Parquet(Box::new(parquet_writer(bytes.clone(), schema)?)),
        };
        Ok(Self { bytes, table })
    }

    /// Writes a batch.
    ///
    /// # Errors
    /// It cannot be written.
    pub fn write(&mut self, batch: &RecordBatch) -> Result<(), ArrowError> {
        match &mut self.table {
            Table::Stream(writer) => writer.write(batch),
            Table::File(writer) => writer.write(batch),
            #[cfg(feature = "parquet")]
            Table::Parquet(writer) => Ok(writer.write(batch)?),
        }
    }

    /// Writes the end.
    ///
    /// # Errors
    /// It cannot be written.
    pub fn end(&mut self) -> Result<(), ArrowError> {
        match &mut self.table {
            Table::Stream(writer) => writer.finish(),
            Table::File(writer) => writer.finish(),
            #[cfg(feature = "parquet")]
            Table::Parquet(writer) => Ok(writer.finish().map(drop)?),
        }
    }

    /// What was written since.
    #[must_use]
    pub fn take(&mut self) -> Vec<u8> {
        std::mem::take(&mut *self.bytes.0.lock().unwrap_or_else(PoisonError::into_inner))
    }
}

#[cfg(feature = "parquet")]
fn parquet_writer(
    bytes: Taken,
    schema: &SchemaRef,
) -> Result<parquet::arrow::ArrowWriter<Taken>, ArrowError> {
    use parquet::basic::Compression;
    use parquet::file::properties::WriterProperties;
    // what a file of numbers repeats is little: without dictionaries it is written in flat memory
    let properties = WriterProperties::builder()
        .set_compression(Compression::SNAPPY)
        .set_dictionary_enabled(false)
        .set_max_row_group_row_count(Some(BATCH))
        .build();
    Ok(parquet::arrow::ArrowWriter::try_new(bytes, Arc::clone(schema), Some(properties))?)
}
