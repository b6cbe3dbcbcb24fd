//! What the tests share: random and known mechanisms, and independent computations of their motion and forces.

pub mod change;
pub mod digits;
pub mod draft;
pub mod equilibrium;
pub mod generate;
pub mod groups;
pub mod jet;
pub mod loads;
pub mod machines;
pub mod random;
pub mod reference;
pub mod run;
