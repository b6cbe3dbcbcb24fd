//! A text with numbers between its pieces, which stay the same.

/// Longer pieces are copied as they are.
const SHORT: usize = 64;
/// No number is longer.
const LONGEST: usize = 32;

/// The pieces.
#[derive(Clone, Debug, Default)]
pub struct Template {
    /// One after another, with as much behind the last as a short piece has.
    text: Vec<u8>,
    ends: Vec<usize>,
}

impl Template {
    /// Of pieces, between each two of which there is a number.
    pub fn of<'a>(pieces: impl Iterator<Item = &'a str>) -> Self {
        let mut template = Self::default();
        for piece in pieces {
            template.text.extend_from_slice(piece.as_bytes());
            template.ends.push(template.text.len());
        }
        template.text.extend_from_slice(&[b' '; SHORT]);
        template
    }

    /// Appends the pieces with the shortest decimal numbers that are read as the given ones, which are finite, between them, as
    /// `serde_json` writes them.
    pub fn fill(&self, numbers: &[f64], out: &mut Vec<u8>) {
        let start = out.len();
        out.resize(start + self.text.len() + numbers.len() * LONGEST, b' ');
        // pieces and numbers are copied as a whole, with a size known beforehand, and written over by what follows
        let mut to = start;
        let mut begin = 0;
        let mut numbers = numbers.iter();
        for &end in &self.ends {
            let len = end - begin;
            match self.text[begin..].first_chunk::<SHORT>() {
                Some(chunk) if len <= SHORT => out[to..to + SHORT].copy_from_slice(chunk),
                _ => out[to..to + len].copy_from_slice(&self.text[begin..end]),
            }
            (begin, to) = (end, to + len);
            if let Some(&x) = numbers.next() {
                to += write_shortest(&mut out[to..], x);
            }
        }
        out.truncate(to);
    }
}

/// Writes the shortest decimal number that is read as `x`, which is finite, and returns its length; zero has no sign.
fn write_shortest(out: &mut [u8], x: f64) -> usize {
    let mut buffer = zmij::Buffer::new();
    let text = if x == 0.0 { "0.0" } else { buffer.format_finite(x) }.as_bytes();
    match (text.first_chunk::<16>(), text.last_chunk::<16>()) {
        (Some(first), Some(last)) => {
            out[..16].copy_from_slice(first);
            out[text.len() - 16..text.len()].copy_from_slice(last);
        }
        _ => out[..text.len()].copy_from_slice(text),
    }
    text.len()
}
