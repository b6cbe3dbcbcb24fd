//! Values: definitions, their order and what they come to, units, values from outside.

pub mod definition;
pub mod fold;
pub mod format_value;
pub mod overrides;
pub mod row;
pub mod typed;
pub mod unit_choice;
pub mod value;
