//! Plans, and one position from numbers by the steps of a plan.

pub mod plan;
pub mod position;

use assur_math::{element, force, group, math};
use assur_model::{model, structure};
