//! Springs and mass substitution.
#![allow(non_snake_case, reason = "names carry the notation of the field: p_A, l_1")]

mod mass_substitution;
mod spring;
