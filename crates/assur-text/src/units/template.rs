//! A text with numbers between its pieces, which stay the same.

/// The most of a piece in a part of the text. Most pieces are shorter, and a size known beforehand takes no loop.
const PIECE: usize = 32;
/// No number is longer than `-2.2250738585072014e-308`.
const LONGEST: usize = 24;
/// What a number is copied by: nearly all have so many characters, and none twice as many.
const HALF: usize = 16;

/// So many numbers are written before the first of them is copied: what was only just written is slow to read.
const GROUP: usize = 128;

#[derive(Clone, Debug, Default)]
pub struct Template {
    all: Pieces,
    /// With the steady numbers written in.
    varying: Pieces,
    constants: Vec<(usize, f64)>,
}

/// Pieces with numbers between them.
#[derive(Clone, Debug, Default)]
pub struct Pieces {
    parts: Vec<Part>,
    /// How many bytes are written at most.
    room: usize,
}

/// Numbers of lines, column by column.
#[derive(Clone, Copy, Debug)]
pub struct Columns<'a> {
    /// One column after the other.
    pub numbers: &'a [f64],
    /// How many numbers a column has.
    pub lines: usize,
}

/// A piece, or some of one, and what is behind it.
#[derive(Clone, Copy, Debug)]
struct Part {
    text: [u8; PIECE],
    len: usize,
    behind: Behind,
}

#[derive(Clone, Copy, Debug)]
enum Behind {
    Nothing,
    /// The number of a column.
    Number(usize),
    /// The same, which may be that of an earlier part.
    Repeated {
        number: usize,
        earlier: usize,
        place: usize,
    },
}

impl Template {
    /// Of pieces, between each two of which there is a number. The first `count` of them have a column, the others are always as in the
    /// example. Those that are `steady` are part of the pieces while they are as in the example. Numbers that are the same in it may be
    /// so each time: those are written once and copied.
    pub fn of<'a>(
        pieces: impl Iterator<Item = &'a str> + Clone,
        example: &[f64],
        count: usize,
        steady: impl Fn(usize) -> bool,
    ) -> Self {
        let all = Pieces::of(pieces.clone(), example, |i| i >= count);
        let varying = Pieces::of(pieces, example, |i| i >= count || steady(i));
        let constants = example.iter().copied().enumerate().take(count).filter(|&(i, _)| steady(i)).collect();
        Self { all, varying, constants }
    }

    /// The pieces for some lines.
    #[must_use]
    pub fn pieces(&self, columns: Columns<'_>) -> &Pieces {
        let is_still = |&(number, x): &(usize, f64)| columns.of(number).iter().all(|&y| y == x);
        if self.constants.iter().all(is_still) { &self.varying } else { &self.all }
    }
}

impl<'a> Columns<'a> {
    fn of(&self, number: usize) -> &'a [f64] {
        &self.numbers[number * self.lines..][..self.lines]
    }
}

impl Behind {
    /// The number of a line, where it is not that of the earlier part.
    #[inline(always)]
    fn fresh(self, columns: Columns<'_>, line: usize) -> Option<f64> {
        let of = |number: usize| columns.numbers[number * columns.lines + line];
        match self {
            Self::Nothing => None,
            Self::Number(number) => Some(of(number)),
            Self::Repeated { number, earlier, .. } => Some(of(number)).filter(|&x| x != of(earlier)),
        }
    }
}

impl Pieces {
    fn of<'a>(
        pieces: impl Iterator<Item = &'a str>,
        example: &[f64],
        written: impl Fn(usize) -> bool,
    ) -> Self {
        let mut made = Self::default();
        let mut text = String::new();
        for (number, piece) in pieces.enumerate() {
            text.push_str(piece);
            match example.get(number) {
                Some(&x) if written(number) => text.push_str(zmij::Buffer::new().format_finite(x + 0.0)),
                Some(_) => {
                    let behind = made.behind(number, example);
                    made.push(&std::mem::take(&mut text), behind);
                }
                None => {}
            }
        }
        made.push(&text, Behind::Nothing);
        let numbers = made.parts.iter().filter(|part| !matches!(part.behind, Behind::Nothing)).count();
        made.room = made.parts.iter().map(|part| part.len).sum::<usize>() + numbers * LONGEST + PIECE;
        made
    }

    /// How a number is found.
    fn behind(&self, number: usize, example: &[f64]) -> Behind {
        // of those that are written together
        let together =
            self.parts.chunks(GROUP).next_back().filter(|parts| parts.len() < GROUP).unwrap_or_default();
        let same = |(place, part): (usize, &Part)| match part.behind {
            Behind::Number(earlier) if example[earlier] == example[number] => {
                Some(Behind::Repeated { number, earlier, place })
            }
            _ => None,
        };
        together.iter().enumerate().find_map(same).unwrap_or(Behind::Number(number))
    }

    fn push(&mut self, text: &str, behind: Behind) {
        let part = |some: &[u8], behind| {
            let mut text = [b' '; PIECE];
            text[..some.len()].copy_from_slice(some);
            Part { text, len: some.len(), behind }
        };
        let (first, last) = text.as_bytes().split_at(text.len().saturating_sub(1) / PIECE * PIECE);
        self.parts.extend(first.chunks(PIECE).map(|some| part(some, Behind::Nothing)));
        self.parts.push(part(last, behind));
    }

    /// Appends the pieces with the shortest decimal numbers that are read as those of a line, which are finite, between them, as
    /// `serde_json` writes them: zero has no sign.
    pub fn fill(&self, columns: Columns<'_>, line: usize, out: &mut Vec<u8>) {
        let end = out.len();
        // with room for what is copied beyond the end of a piece or a number, and written over by the next
        out.resize(end + self.room, 0);
        let mut page = Page { text: out, end };
        for parts in self.parts.chunks(GROUP) {
            let mut buffers: [_; GROUP] = std::array::from_fn(|_| zmij::Buffer::new());
            let mut each = parts.iter().zip(&mut buffers);
            let numbers: [&[u8]; GROUP] = std::array::from_fn(|_| {
                let Some((part, buffer)) = each.next() else { return &[][..] };
                part.behind.fresh(columns, line).map_or(&[], |x| buffer.format_finite(x + 0.0).as_bytes())
            });
            for (part, number) in parts.iter().zip(&numbers) {
                page.push(&part.text, part.len);
                match part.behind {
                    Behind::Repeated { place, .. } if number.is_empty() => page.push_number(numbers[place]),
                    _ => page.push_number(number),
                }
            }
        }
        let end = page.end;
        out.truncate(end);
    }
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
        self.text[self.end..][..N].copy_from_slice(text);
        self.end += len;
    }

    #[inline(always)]
    fn push_number(&mut self, number: &[u8]) {
        if let (Some(first), Some(last)) = (number.first_chunk::<HALF>(), number.last_chunk::<HALF>()) {
            self.push(first, number.len() - HALF);
            self.push(last, HALF);
        } else {
            self.text[self.end..][..number.len()].copy_from_slice(number);
            self.end += number.len();
        }
    }
}
