//! Pictures of every example, of random mechanisms and of extreme inputs, judged on their marks and as documents.

#[path = "../folder/mod.rs"]
mod folder;
#[allow(dead_code, reason = "pictures need no reference solution")]
#[path = "../mechanics/support/mod.rs"]
mod support;

mod arrows;
mod bars;
mod corners;
mod dimensioned;
mod drawn;
mod every_example;
mod extreme;
mod film;
mod frames;
mod freed;
mod gears;
mod leaders;
mod looks;
mod moved;
mod mutated;
mod numbers;
mod over_sweeps;
mod over_time;
mod plots;
mod random;
mod read_back;
mod scenes;
#[path = "../share/mod.rs"]
mod share;
mod sheets;
mod trains;
mod without_script;
mod xml;
