//! A text with numbers between its pieces, which stay the same.

/// The pieces: all but the last have a number behind them.
#[derive(Clone, Debug, Default)]
pub struct Template(Vec<String>);

impl Template {
    /// Of pieces, between each two of which there is a number. The `last` of these are part of the text.
    #[must_use]
    pub fn of(pieces: &[String], last: &[f64]) -> Self {
        let (own, others) = pieces.split_at(pieces.len().saturating_sub(last.len()));
        let mut own = own.to_vec();
        for (number, piece) in last.iter().zip(others) {
            if let Some(text) = own.last_mut() {
                text.push_str(zmij::Buffer::new().format_finite(number + 0.0));
                text.push_str(piece);
            }
        }
        Self(own)
    }

    /// Appends the pieces with the shortest decimal numbers that are read as these, which are finite, between them, as
    /// `serde_json` writes them: zero has no sign.
    pub fn fill(&self, numbers: &[f64], out: &mut Vec<u8>) {
        let mut buffer = zmij::Buffer::new();
        let mut numbers = numbers.iter();
        for piece in &self.0 {
            out.extend_from_slice(piece.as_bytes());
            if let Some(number) = numbers.next() {
                out.extend_from_slice(buffer.format_finite(number + 0.0).as_bytes());
            }
        }
    }
}
