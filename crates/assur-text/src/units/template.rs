//! A text with numbers between its pieces, which stay the same.

/// Pieces are copied as so much text, if they are not longer: most are short, and a size known beforehand takes no loop.
const SHORT: usize = 16;
const LONG: usize = 64;
/// No number is longer.
const LONGEST: usize = 32;

/// The pieces.
#[derive(Clone, Debug, Default)]
pub struct Template {
    /// One after another, with as much behind the last as is copied at a time.
    text: Vec<u8>,
    ends: Vec<usize>,
    /// For every number an earlier one that it may repeat.
    repeats: Vec<Option<usize>>,
}

/// Memory for a template that is being filled.
#[derive(Debug, Default)]
pub struct Filled {
    text: Vec<u8>,
    /// Begin and end of each number.
    places: Vec<(usize, usize)>,
}

impl Template {
    /// Of pieces, between each two of which there is a number. Numbers that are the same in `example` may be so each time: those are
    /// written once and copied.
    pub fn of<'a>(pieces: impl Iterator<Item = &'a str>, example: &[f64]) -> Self {
        let mut template = Self::default();
        for piece in pieces {
            template.text.extend_from_slice(piece.as_bytes());
            template.ends.push(template.text.len());
        }
        template.text.extend_from_slice(&[b' '; LONG]);
        template.repeats = (0..example.len()).map(|i| repeated(example, i)).collect();
        template
    }

    /// Appends the pieces with the shortest decimal numbers that are read as the given ones, which are finite, between them, as
    /// `serde_json` writes them.
    pub fn fill(&self, numbers: &[f64], Filled { text, places }: &mut Filled, out: &mut Vec<u8>) {
        // with room for what is copied beyond the end of a piece or a number, and written over by the next
        text.resize(self.text.len() + numbers.len() * LONGEST, b' ');
        places.resize(numbers.len(), (0, 0));
        let mut page = Page { text, end: 0 };
        let mut begin = 0;
        for (i, &end) in self.ends.iter().enumerate() {
            page.push_piece(&self.text[begin..], end - begin);
            begin = end;
            let Some(&x) = numbers.get(i) else { continue };
            let at = page.end;
            match self.repeats.get(i) {
                Some(&Some(earlier)) if numbers[earlier].to_bits() == x.to_bits() => {
                    page.push_again(places[earlier]);
                }
                _ => page.push_shortest(x),
            }
            places[i] = (at, page.end);
        }
        out.extend_from_slice(&page.text[..page.end]);
    }
}

/// An earlier number with the same bits as this one; zeros are written as fast as they are copied.
fn repeated(numbers: &[f64], i: usize) -> Option<usize> {
    let same = |x: &f64| x.to_bits() == numbers[i].to_bits();
    numbers[..i].iter().position(same).filter(|_| numbers[i] != 0.0)
}

/// A text that is being written.
struct Page<'a> {
    text: &'a mut [u8],
    end: usize,
}

impl Page<'_> {
    /// Copies a text of a size known beforehand, of which `len` is meant.
    #[inline(always)]
    fn push<const N: usize>(&mut self, text: &[u8; N], len: usize) {
        self.text[self.end..self.end + N].copy_from_slice(text);
        self.end += len;
    }

    /// The begin of a text.
    #[inline(always)]
    fn push_piece(&mut self, text: &[u8], len: usize) {
        match (text.first_chunk::<SHORT>(), text.first_chunk::<LONG>()) {
            (Some(piece), _) if len <= SHORT => self.push(piece, len),
            (_, Some(piece)) if len <= LONG => self.push(piece, len),
            _ => self.push_text(&text[..len]),
        }
    }

    fn push_text(&mut self, text: &[u8]) {
        self.text[self.end..self.end + text.len()].copy_from_slice(text);
        self.end += text.len();
    }

    /// A part of the text once more.
    #[inline(always)]
    fn push_again(&mut self, (begin, end): (usize, usize)) {
        match self.text[begin..].first_chunk::<LONGEST>().copied() {
            Some(part) => self.push(&part, end - begin),
            None => {
                self.text.copy_within(begin..end, self.end);
                self.end += end - begin;
            }
        }
    }

    /// The shortest decimal number that is read as `x`, which is finite; zero has no sign.
    #[inline(always)]
    fn push_shortest(&mut self, x: f64) {
        if x == 0.0 {
            return self.push(b"0.0", 3);
        }
        let mut buffer = zmij::Buffer::new();
        let text = buffer.format_finite(x).as_bytes();
        match (text.first_chunk::<16>(), text.last_chunk::<16>()) {
            (Some(first), Some(last)) => {
                self.push(first, text.len() - 16);
                self.push(last, 16);
            }
            _ => self.push_text(text),
        }
    }
}
