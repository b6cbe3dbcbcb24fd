//! Where the lines of a text begin: found once for all that is said about it.

use std::ops::Range;

/// The lines of a text. They end in `\n`, `\r\n` or a lone `\r`.
pub(super) struct Lines {
    starts: Vec<usize>,
    length: usize,
}

impl Lines {
    /// Those of a text.
    pub fn of_text(text: &str) -> Self {
        let bytes = text.as_bytes();
        let ends = bytes.iter().enumerate().filter(|(i, b)| match b {
            b'\n' => true,
            b'\r' => bytes.get(i + 1) != Some(&b'\n'),
            _ => false,
        });
        let starts = std::iter::once(0).chain(ends.map(|(i, _)| i + 1)).collect();
        Self { starts, length: bytes.len() }
    }

    /// How many there are.
    pub fn count(&self) -> usize {
        self.starts.len()
    }

    /// The line of a byte, from 0.
    pub fn of(&self, byte: usize) -> usize {
        self.starts.partition_point(|&start| start <= byte) - 1
    }

    /// The bytes of a line with those that end it.
    pub fn range_with_end(&self, line: usize) -> Range<usize> {
        self.starts[line]..self.starts.get(line + 1).copied().unwrap_or(self.length)
    }

    /// The bytes of a line without those that end it.
    pub fn range(&self, text: &str, line: usize) -> Range<usize> {
        let Range { start, end } = self.range_with_end(line);
        start..start + text[start..end].trim_end_matches(['\n', '\r']).len()
    }
}
