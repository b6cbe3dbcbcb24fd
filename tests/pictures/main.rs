//! Pictures of every example and of extreme inputs, judged on their marks and as documents.

#[path = "../folder/mod.rs"]
mod folder;

mod dimensioned;
mod drawn;
mod every_example;
mod extreme;
mod mutated;
mod numbers;
mod over_sweeps;
mod without_script;
mod xml;
