//! Tells the program its target, and links it to a fixed address on Linux: the loader then relocates nothing, a seventh of what a
//! small file takes.

use std::env::var;

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rustc-env=ASSUR_TARGET={}", var("TARGET").unwrap_or_default());
    let is = |name: &str, value: &str| var(name).is_ok_and(|found| found == value);
    if is("CARGO_CFG_TARGET_OS", "linux") && is("CARGO_CFG_TARGET_ENV", "gnu") {
        println!("cargo::rustc-link-arg-bins=-no-pie");
    }
}
