//! Inertia, springs, mass substitution.
#![allow(non_snake_case, reason = "names carry the notation of the field: p_A, l_1")]

mod inertia;
mod mass_substitution;
mod spring;
mod wrench;
