//! Plans, positions, motion and forces; what accuracy costs.

pub mod accuracy;
pub mod plan;
pub mod solve;

use assur_math::{element, force, group, math};
use assur_model::{model, structure};
use assur_text::{language, source, units};
