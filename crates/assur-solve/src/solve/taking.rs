//! Takes positions over that were solved side by side.

use super::block::Block;
use super::note::Closing;
use super::track::Tracker;
use crate::position::{DriveValue, Model};

/// Positions that are followed one by one where some depend on the one before.
const WAIT: usize = 4;

/// What goes from one position to the next, of a sweep whose next positions are solved side by side.
pub struct Taking<'f, 'a> {
    pub(super) model: &'f Model<'a>,
    pub(super) tracker: &'f mut Tracker,
    pub(super) next: &'f mut usize,
    pub(super) try_at: &'f mut usize,
    pub(super) closing: &'f mut Closing,
    pub(super) last: &'f mut Option<(String, Vec<DriveValue>)>,
}

impl Taking<'_, '_> {
    /// Takes over the next positions as far as following them one by one comes to the same, and goes on behind them. The block
    /// keeps these alone. `false` where some are left: blocks behind this one have no meaning then.
    pub fn take(&mut self, block: &mut Block) -> bool {
        let solved = block.solved();
        let taken = self.tracker.take(self.model, block);
        *self.next += taken;
        self.closing.swept += taken;
        if let Some(last) = taken.checked_sub(1) {
            let (name, drives) = self.last.get_or_insert_default();
            name.clear();
            name.push_str(itoa::Buffer::new().format(*self.next));
            drives.clear();
            drives.extend_from_slice(block.values(last));
        }
        if taken < solved {
            *self.try_at = *self.next + WAIT;
        }
        taken == solved
    }
}
