//! Values: definitions, their order and what they come to, units, values from outside.

pub mod definition;
pub mod fold;
pub mod format_value;
pub mod order;
pub mod replace;
pub mod roots;
pub mod row;
pub mod store;
pub mod typed;
pub mod unit_use;
