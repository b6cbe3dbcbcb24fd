//! Structural groups.
#![allow(non_snake_case, reason = "names carry the notation of the field: p_A, l_1")]

mod general;
mod pp;
mod prp;
mod rpp;
mod rpr;
mod rrp;
mod rrr;
mod testing;
mod triad;
