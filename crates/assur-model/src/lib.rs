//! A mechanism as plain data, and its structure.

pub mod model;
pub mod structure;

use assur_math::{element, math};
use assur_text::{language, source, units};
