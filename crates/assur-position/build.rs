//! Says how far the steps of a position are inlined.
//!
//! Vectors reach only what is inlined into the function that is compiled for them, so that all steps are one function where
//! it is fast. Without optimisation its frame would be larger than a thread's stack, and WebAssembly has no lanes.

use std::env::var;

fn main() {
    println!("cargo::rustc-check-cfg=cfg(in_one)");
    println!("cargo::rerun-if-changed=build.rs");
    let fast = matches!(var("OPT_LEVEL").as_deref(), Ok("2" | "3"));
    let wasm = var("CARGO_CFG_TARGET_FAMILY").is_ok_and(|family| family == "wasm");
    if fast && !wasm {
        println!("cargo::rustc-cfg=in_one");
    }
}
