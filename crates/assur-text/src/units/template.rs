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
    /// For every number an earlier one that it may repeat.
    repeats: Vec<Option<usize>>,
}

/// Where the numbers of a filled template are: begin and end of each.
pub type Places = Vec<(usize, usize)>;

impl Template {
    /// Of pieces, between each two of which there is a number. Numbers that are the same in `example` may be so each time: those are
    /// written once and copied.
    pub fn of<'a>(pieces: impl Iterator<Item = &'a str>, example: &[f64]) -> Self {
        let mut template = Self::default();
        for piece in pieces {
            template.text.extend_from_slice(piece.as_bytes());
            template.ends.push(template.text.len());
        }
        template.text.extend_from_slice(&[b' '; SHORT]);
        template.repeats = (0..example.len()).map(|i| repeated(example, i)).collect();
        template
    }

    /// Appends the pieces with the shortest decimal numbers that are read as the given ones, which are finite, between them, as
    /// `serde_json` writes them. `places` is memory.
    pub fn fill(&self, numbers: &[f64], places: &mut Places, out: &mut Vec<u8>) {
        out.reserve(self.text.len() + numbers.len() * LONGEST);
        places.clear();
        let mut begin = 0;
        for (i, &end) in self.ends.iter().enumerate() {
            self.push_piece(begin, end, out);
            begin = end;
            let Some(&x) = numbers.get(i) else { continue };
            let at = out.len();
            match self.repeats.get(i) {
                Some(&Some(earlier)) if numbers[earlier].to_bits() == x.to_bits() => {
                    push_again(places[earlier], out);
                }
                _ => push_shortest(x, out),
            }
            places.push((at, out.len()));
        }
    }

    // pieces and numbers are copied as a whole, with a size known beforehand, and written over by what follows
    #[inline]
    fn push_piece(&self, begin: usize, end: usize, out: &mut Vec<u8>) {
        let (at, len) = (out.len(), end - begin);
        match self.text[begin..].first_chunk::<SHORT>() {
            Some(chunk) if len <= SHORT => {
                out.extend_from_slice(chunk);
                out.truncate(at + len);
            }
            _ => out.extend_from_slice(&self.text[begin..end]),
        }
    }
}

/// An earlier number with the same bits as this one; zeros are written as fast as they are copied.
fn repeated(numbers: &[f64], i: usize) -> Option<usize> {
    let same = |x: &f64| x.to_bits() == numbers[i].to_bits();
    numbers[..i].iter().position(same).filter(|_| numbers[i] != 0.0)
}

/// Appends a part of the text once more.
#[inline]
fn push_again((begin, end): (usize, usize), out: &mut Vec<u8>) {
    let at = out.len();
    match out[begin..].first_chunk::<LONGEST>().copied() {
        Some(chunk) => {
            out.extend_from_slice(&chunk);
            out.truncate(at + end - begin);
        }
        None => out.extend_from_within(begin..end),
    }
}

/// Appends the shortest decimal number that is read as `x`, which is finite; zero has no sign.
#[inline]
fn push_shortest(x: f64, out: &mut Vec<u8>) {
    if x == 0.0 {
        return out.extend_from_slice(b"0.0");
    }
    let mut buffer = zmij::Buffer::new();
    let text = buffer.format_finite(x).as_bytes();
    match (text.first_chunk::<16>(), text.last_chunk::<16>()) {
        (Some(first), Some(last)) => {
            let rest = out.len() + text.len() - 16;
            out.extend_from_slice(first);
            out.truncate(rest);
            out.extend_from_slice(last);
        }
        _ => out.extend_from_slice(text),
    }
}
