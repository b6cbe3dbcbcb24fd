//! Springs and substitute masses. Pure mathematics, as in `group`.
#![allow(non_snake_case, reason = "names carry the notation of the field: a_S, F, M")]

pub mod mass_substitution;
pub mod spring;
