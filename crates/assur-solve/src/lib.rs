//! Plans, positions, motion and forces; what accuracy costs.

pub mod accuracy;
pub mod plan;
pub mod position;
pub mod solve;

use assur_math::{element, force, group, math};
use assur_model::{model, structure};
use assur_text::{source, units};
