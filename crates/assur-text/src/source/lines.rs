//! Lines and columns of a text, as editors count them.

/// What a column counts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Encoding {
    Utf8,
    /// Units of UTF-16.
    #[default]
    Utf16,
}

/// A place between characters, both from 0.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct LineColumn {
    pub line: usize,
    pub column: usize,
}

/// Where the lines of a text begin. A line ends with LF, CR LF or CR.
#[derive(Clone, Debug)]
pub struct Lines<'t> {
    text: &'t str,
    starts: Vec<usize>,
}

impl<'t> Lines<'t> {
    /// The lines of a text.
    #[must_use]
    pub fn of(text: &'t str) -> Self {
        let bytes = text.as_bytes();
        let ends = |&i: &usize| bytes[i] == b'\n' || (bytes[i] == b'\r' && bytes.get(i + 1) != Some(&b'\n'));
        let starts = std::iter::once(0).chain((0..bytes.len()).filter(ends).map(|i| i + 1)).collect();
        Self { text, starts }
    }

    /// Line and column of a byte; one within a character is that character's first, one past the end is the end.
    #[must_use]
    pub fn place(&self, byte: usize, encoding: Encoding) -> LineColumn {
        let byte = self.text.floor_char_boundary(byte.min(self.text.len()));
        let line = self.starts.partition_point(|&start| start <= byte) - 1;
        let before = &self.text[self.starts[line]..byte];
        LineColumn { line, column: units(before, encoding) }
    }

    /// The byte of a place; a column past the end of its line is that end. Nothing for a line that there is not, and for a place within a
    /// character.
    #[must_use]
    pub fn byte(&self, place: LineColumn, encoding: Encoding) -> Option<usize> {
        let start = *self.starts.get(place.line)?;
        let end = self.starts.get(place.line + 1).copied().unwrap_or(self.text.len());
        let line = self.text[start..end].trim_end_matches(['\n', '\r']);
        let mut column = 0;
        for (at, c) in line.char_indices() {
            if column >= place.column {
                return (column == place.column).then_some(start + at);
            }
            column += match encoding {
                Encoding::Utf8 => c.len_utf8(),
                Encoding::Utf16 => c.len_utf16(),
            };
        }
        (place.column >= column).then_some(start + line.len())
    }
}

fn units(text: &str, encoding: Encoding) -> usize {
    match encoding {
        Encoding::Utf8 => text.len(),
        Encoding::Utf16 => text.encode_utf16().count(),
    }
}
