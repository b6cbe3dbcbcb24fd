//! Numbers of positions side by side, read column by column and handed out line by line.

use super::block::Block;
use crate::answer::WideColumns;

/// Numbers of the positions of a block.
#[derive(Debug, Default)]
pub struct BlockNumbers {
    /// One column after the other.
    all: Vec<f64>,
    /// How many numbers a column has.
    positions: usize,
}

impl BlockNumbers {
    /// Reads them; `false` where one does not exist.
    pub fn read(&mut self, block: &Block, columns: &WideColumns) -> bool {
        self.positions = block.len();
        self.all.clear();
        self.all.resize(columns.count() * self.positions, f64::NAN);
        block.write(columns, &mut self.all.chunks_exact_mut(self.positions.max(1)));
        self.all.iter().fold(true, |all, x| all & !x.is_nan())
    }

    /// All of them, one column after the other, and how many numbers a column has.
    #[must_use]
    pub fn columns(&self) -> (&[f64], usize) {
        (&self.all, self.positions)
    }

    /// Writes the numbers of one of the positions.
    pub fn line(&self, position: usize, out: &mut Vec<f64>) {
        out.clear();
        out.extend(self.all.iter().skip(position).step_by(self.positions.max(1)));
    }
}
