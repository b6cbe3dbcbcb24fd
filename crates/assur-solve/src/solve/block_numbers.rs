//! Numbers of positions side by side, read column by column and handed out line by line.

use super::block::Block;
use crate::answer::WideColumns;

/// Numbers of the positions of a block.
#[derive(Debug, Default)]
pub struct BlockNumbers(Vec<Vec<f64>>);

impl BlockNumbers {
    /// Reads them; `false` where one does not exist.
    pub fn read(&mut self, block: &Block, columns: &WideColumns) -> bool {
        self.0.resize_with(columns.count(), Vec::new);
        self.0.iter_mut().for_each(Vec::clear);
        block.read(columns, &mut self.0);
        self.0.iter().all(|column| column.iter().fold(true, |all, x| all & !x.is_nan()))
    }

    /// Writes the numbers of one of the positions.
    pub fn line(&self, position: usize, out: &mut Vec<f64>) {
        out.clear();
        out.extend(self.0.iter().map(|column| column[position]));
    }
}
