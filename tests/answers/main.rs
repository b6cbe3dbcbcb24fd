//! What the language means and what comes out: values, answers and the rules by which they are judged.

mod accuracy;
mod against_motion;
mod all_motion;
mod arms;
mod bonds;
mod brakes;
#[path = "../busy/mod.rs"]
mod busy;
mod completed;
mod cycle;
mod effects;
mod energy;
mod equal_positions;
mod equilibria;
mod expectations;
mod expressions;
#[path = "../folder/mod.rs"]
mod folder;
mod formatted;
mod free_bodies;
mod geometry;
mod great_numbers;
mod harmonics;
mod honest_runs;
mod jerks;
mod jumps;
mod large;
mod mass_shapes;
mod masses;
mod methods;
mod names;
mod nothing;
mod number_cases;
mod planes;
mod positions;
mod powers;
mod printed;
mod quick_rows;
mod renamed;
mod resting;
mod run_accuracy;
#[path = "../share/mod.rs"]
mod share;
mod simulation;
mod starts;
mod sweep_events;
mod terminal;
mod torsion_springs;
mod trusses;
mod unit;
mod unsmooth;
mod unused;
mod variants;
mod verdicts;
mod welds;
mod zero;
