//! The step that moves a Geneva wheel.

use crate::model::GenevaPair;

/// A Geneva wheel with the imaginary block that stands for its pin.
#[derive(Clone, Copy, Debug)]
pub struct GenevaStep {
    /// Crank, wheel and frame.
    pub pair: GenevaPair,
    /// Slot of the block.
    pub block: usize,
}
