//! The hard cases, with the accuracy each reaches.
#![allow(non_snake_case, reason = "names carry the notation of the field: p_A, l_1")]

mod catalogue;
pub mod double_double;
mod kernels;
mod long;
mod page;
