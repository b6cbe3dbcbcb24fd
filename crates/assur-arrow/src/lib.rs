//! Tables of Arrow with units: rows in, answers out. It knows no mechanics.

mod cells;
#[cfg(feature = "ipc")]
mod files;
mod given;
mod lines;

#[doc(hidden)]
pub use arrow_array;
pub use arrow_array::{RecordBatch, RecordBatchReader};
#[cfg(feature = "ipc")]
#[doc(hidden)]
pub use arrow_ipc;
pub use arrow_schema::{ArrowError, Field, Schema, SchemaRef};
pub use cells::{array, field};
#[cfg(feature = "ipc")]
pub use files::{Kind, Reader, Writer, open};
pub use given::{Column, columns, names, numbers};
pub use lines::{Head, Lines, Texts};
