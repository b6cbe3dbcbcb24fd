//! A text with numbers between its pieces, which stay the same.

/// Pieces are copied as so much text, if they are not longer: most are short, and a size known beforehand takes no loop.
const SHORT: usize = 16;
const LONG: usize = 64;
/// No number is longer.
const LONGEST: usize = 32;

/// The pieces.
#[derive(Clone, Debug, Default)]
pub struct Template {
    all: Pieces,
    /// With the steady numbers written in.
    varying: Pieces,
    /// The steady numbers, and their bits.
    constants: Vec<(usize, u64)>,
}

/// Memory for a template that is being filled.
#[derive(Debug, Default)]
pub struct Filled {
    text: Vec<u8>,
    /// Begin and end of each number.
    places: Vec<(usize, usize)>,
}

/// Pieces with numbers between them.
#[derive(Clone, Debug, Default)]
struct Pieces {
    /// One after another, with as much behind the last as is copied at a time.
    text: Vec<u8>,
    holes: Vec<Hole>,
    /// The end of the last piece.
    end: usize,
}

/// Where a number goes.
#[derive(Clone, Copy, Debug)]
struct Hole {
    /// The end of the piece before it.
    end: usize,
    number: usize,
    /// An earlier one that it may repeat.
    repeats: Option<usize>,
}

impl Template {
    /// Of pieces, between each two of which there is a number. Those that are `steady` are part of the pieces while they are as in the
    /// example. Numbers that are the same in it may be so each time: those are written once and copied.
    pub fn of<'a>(
        pieces: impl Iterator<Item = &'a str> + Clone,
        example: &[f64],
        steady: impl Fn(usize) -> bool,
    ) -> Self {
        let all = Pieces::of(pieces.clone(), example, |_| false);
        let varying = Pieces::of(pieces, example, &steady);
        let constants = (0..example.len()).filter(|&i| steady(i)).map(|i| (i, bits(example[i]))).collect();
        Self { all, varying, constants }
    }

    /// Appends the pieces with the shortest decimal numbers that are read as the given ones, which are finite, between them, as
    /// `serde_json` writes them.
    pub fn fill(&self, numbers: &[f64], filled: &mut Filled, out: &mut Vec<u8>) {
        let still = |&(i, constant): &(usize, u64)| numbers.get(i).is_some_and(|&x| bits(x) == constant);
        let pieces = if self.constants.iter().all(still) { &self.varying } else { &self.all };
        pieces.fill(numbers, filled, out);
    }
}

/// The bits of a number; zero has no sign.
fn bits(x: f64) -> u64 {
    (x + 0.0).to_bits()
}

impl Pieces {
    fn of<'a>(
        pieces: impl Iterator<Item = &'a str>,
        example: &[f64],
        steady: impl Fn(usize) -> bool,
    ) -> Self {
        let mut made = Self::default();
        for (number, piece) in pieces.enumerate() {
            made.text.extend_from_slice(piece.as_bytes());
            match example.get(number) {
                Some(&x) if steady(number) => made.text.extend_from_slice(shortest(x).as_bytes()),
                Some(&x) => {
                    // zeros are written as fast as they are copied
                    let same = |hole: &Hole| bits(example[hole.number]) == bits(x) && x != 0.0;
                    let repeats = made.holes.iter().position(same);
                    made.holes.push(Hole { end: made.text.len(), number, repeats });
                }
                None => {}
            }
        }
        made.end = made.text.len();
        made.text.extend_from_slice(&[b' '; LONG]);
        made
    }

    fn fill(&self, numbers: &[f64], Filled { text, places }: &mut Filled, out: &mut Vec<u8>) {
        // with room for what is copied beyond the end of a piece or a number, and written over by the next
        let room = self.text.len() + self.holes.len() * LONGEST;
        if text.len() < room {
            text.resize(room, b' ');
        }
        places.clear();
        let mut page = Page { text, end: 0 };
        let mut begin = 0;
        for &Hole { end, number, repeats } in &self.holes {
            page.push_piece(&self.text[begin..], end - begin);
            begin = end;
            let Some(&x) = numbers.get(number) else { continue };
            let at = page.end;
            match repeats.and_then(|earlier| Some((self.holes[earlier].number, *places.get(earlier)?))) {
                Some((earlier, place)) if numbers[earlier].to_bits() == x.to_bits() => page.push_again(place),
                _ => page.push_shortest(x),
            }
            places.push((at, page.end));
        }
        page.push_piece(&self.text[begin..], self.end - begin);
        out.extend_from_slice(&page.text[..page.end]);
    }
}

/// The shortest decimal number that is read as `x`, which is finite; zero has no sign.
fn shortest(x: f64) -> String {
    zmij::Buffer::new().format_finite(x + 0.0).to_owned()
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
