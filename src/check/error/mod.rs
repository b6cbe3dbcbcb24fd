//! What can be wrong with the meaning of a document: one enum per topic.

mod name;

pub use name::NameError;
