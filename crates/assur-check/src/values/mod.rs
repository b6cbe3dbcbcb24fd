//! Values: definitions, their order and what they come to, units, values from outside.

pub mod definition;
pub mod fold;
pub mod format_value;
pub mod order;
pub mod outside;
pub mod overrides;
pub mod rates;
pub mod replace;
pub mod roots;
pub mod row;
pub mod sizes;
pub mod store;
pub mod texts;
pub mod typed;
pub mod unit_choice;
pub mod unit_use;
