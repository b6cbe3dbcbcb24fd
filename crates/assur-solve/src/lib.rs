//! Motion and forces over positions; what accuracy costs.

pub mod answer;
pub mod measure;
pub mod message;
pub mod reference;
pub mod solve;

use assur_math::{element, force, group, math};
use assur_model::{model, structure};
use assur_position::{plan, position};
use assur_text::{language, source, units};
