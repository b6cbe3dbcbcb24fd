//! What is drawn beside links and pairs of a machine that was laid out.

use super::rope::Rope;
use assur_math::math::Vec2;
use assur_model::model::PairId;

/// Ropes and threads, and how true the picture is.
pub struct Arrangement {
    pub ropes: Vec<Rope>,
    pub threads: Vec<Thread>,
    /// A millimetre of the paper for which it was laid out, m.
    pub unit: f64,
    /// Radii are those of the file, in one scale.
    pub to_scale: bool,
    /// The part of its way that each link goes: less than all where a load would leave the paper.
    pub shares: Vec<f64>,
}

/// A thread that is drawn across the axis of its wheel, or along the way of its nut.
#[derive(Clone, Copy, Debug)]
pub struct Thread {
    /// The worm or the screw.
    pub pair: PairId,
    /// The middle of the thread, and half its length, m.
    pub at: Vec2,
    pub half: f64,
}
