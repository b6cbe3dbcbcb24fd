//! What is asked for: `find`, `expect`, functions of results, tables of variants.

mod all_motion;
mod all_powers;
pub mod bars;
pub mod definitions;
pub mod expect;
pub mod expected_list;
pub mod find;
pub mod internal;
pub mod query;
pub mod tolerance;
pub mod too_wide;
pub mod unknown;
pub mod variants;
