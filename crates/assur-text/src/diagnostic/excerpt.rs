//! The lines of a text that a diagnostic marks, with one line of context: what is drawn costs no more than these lines,
//! however long the text is, and long lines are cut around the marks.

use crate::source::{Source, shown_in_line};
use miette::{LabeledSpan, MietteError, MietteSpanContents, SourceCode, SourceSpan, SpanContents};
use std::ops::Range;

/// Longer lines are cut, bytes.
const LONG: usize = 240;
/// What stays of them on each side of a mark, bytes.
const AROUND: usize = 60;
/// What stands for what is cut off.
const CUT: char = '…';
/// Marks with fewer lines between them are drawn in one piece.
const NEAR: usize = 24;
/// A mark over more lines ends with its first line.
const TALLEST: usize = 40;
/// More marks of one diagnostic are not drawn.
const MOST_MARKS: usize = 24;

/// Neighbouring lines of the text.
struct Piece {
    /// Where its first byte stands among all pieces.
    at: usize,
    /// The number of its first line in the text, from 0.
    first: usize,
    text: String,
}

/// A mark in the text, and where it stands among all pieces.
struct Mark {
    start: usize,
    end: usize,
    lines: (usize, usize),
    drawn: (usize, usize),
}

/// What is drawn of a text for one diagnostic.
pub(super) struct Excerpt {
    name: String,
    lines_before: usize,
    pieces: Vec<Piece>,
    /// Where marks are drawn, with the byte within the line where they stand in the text.
    columns: Vec<(usize, usize)>,
}

impl Excerpt {
    /// The excerpt for marks, and the marks with their places in it.
    pub fn of(source: &Source, lines: &Lines, labels: Vec<LabeledSpan>) -> (Self, Vec<LabeledSpan>) {
        let mut labels = labels;
        labels.sort_by_key(|l| !l.primary());
        labels.truncate(MOST_MARKS);
        let text = source.text.as_str();
        let mut marks: Vec<Mark> = labels.iter().map(|l| Mark::of(l, text, lines)).collect();
        let mut order: Vec<usize> = (0..marks.len()).collect();
        order.sort_by_key(|&i| marks[i].lines);
        let mut pieces: Vec<Piece> = Vec::new();
        let mut rest = order.as_slice();
        while let Some(&first) = rest.first() {
            let (mut last, mut count) = (marks[first].lines.1, 1);
            while let Some(&next) = rest.get(count).filter(|&&i| marks[i].lines.0 <= last + NEAR) {
                last = last.max(marks[next].lines.1);
                count += 1;
            }
            let range = marks[first].lines.0.saturating_sub(1)..(last + 3).min(lines.count());
            let at = pieces.last().map_or(0, |p| p.at + p.text.len() + 1);
            let mut piece = Piece { at, first: range.start, text: String::new() };
            range.for_each(|line| piece.add(text, lines, line, &mut marks));
            pieces.push(piece);
            rest = &rest[count..];
        }
        let columns =
            marks.iter().map(|m| (m.drawn.0, m.start - lines.range(text, m.lines.0).start)).collect();
        let moved = labels.iter().zip(&marks).map(|(label, mark)| {
            let span = (mark.drawn.0, mark.drawn.1.saturating_sub(mark.drawn.0));
            let words = label.label().map(|words| shown_in_line(words).into_owned());
            match label.primary() {
                true => LabeledSpan::new_primary_with_span(words, span),
                false => LabeledSpan::new_with_span(words, span),
            }
        });
        let moved = moved.collect();
        let name = shown_in_line(&source.name).into_owned();
        (Self { name, lines_before: source.lines_before, pieces, columns }, moved)
    }
}

impl Mark {
    fn of(label: &LabeledSpan, text: &str, lines: &Lines) -> Self {
        let boundary = |mut byte: usize| {
            while !text.is_char_boundary(byte) {
                byte -= 1;
            }
            byte
        };
        let start = boundary(label.offset().min(text.len()));
        let mut end = boundary(start.saturating_add(label.len()).min(text.len()));
        let first = lines.of(start);
        let mut last = lines.of(end);
        if last - first > TALLEST {
            (last, end) = (first, lines.range(text, first).end.max(start));
        }
        Self { start, end, lines: (first, last), drawn: (0, 0) }
    }
}

impl Piece {
    /// Adds a line; the marks that begin or end on it learn where they are drawn.
    fn add(&mut self, text: &str, lines: &Lines, line: usize, marks: &mut [Mark]) {
        let range = lines.range(text, line);
        let on_line = |m: &&mut Mark| m.lines.0 <= line && line <= m.lines.1;
        let mut ends: Vec<(usize, &mut usize)> = Vec::new();
        for mark in marks.iter_mut().filter(on_line) {
            if mark.lines.0 == line {
                ends.push((mark.start, &mut mark.drawn.0));
            }
            if mark.lines.1 == line {
                ends.push((mark.end, &mut mark.drawn.1));
            }
        }
        ends.sort_by_key(|e| e.0);
        let kept = kept(text, range.clone(), ends.iter().map(|e| e.0));
        let mut ends = ends.into_iter().peekable();
        let mut before = range.start;
        for part in kept {
            if part.start > before {
                self.text.push(CUT);
            }
            before = part.end;
            let mut from = part.start;
            while let Some((byte, drawn)) = ends.next_if(|e| e.0 <= part.end) {
                let byte = byte.max(from);
                self.text.push_str(&without_controls(&text[from..byte]));
                from = byte;
                *drawn = self.at + self.text.len();
            }
            self.text.push_str(&without_controls(&text[from..part.end]));
        }
        if before < range.end {
            self.text.push(CUT);
        }
        let here = self.at + self.text.len();
        // a mark may take in the end of the line
        let ended = lines.range_with_end(line).end > range.end;
        for (byte, drawn) in ends {
            *drawn = here + usize::from(ended && byte > range.end);
        }
        if ended {
            self.text.push('\n');
        }
    }
}

/// Controls spelt out, but for tabs.
fn without_controls(text: &str) -> String {
    text.split('\t').map(shown_in_line).collect::<Vec<_>>().join("\t")
}

/// The parts of a line that are shown.
fn kept(text: &str, line: Range<usize>, ends: impl Iterator<Item = usize>) -> Vec<Range<usize>> {
    if line.len() <= LONG {
        return vec![line];
    }
    let near = |byte: usize| {
        let from = text.floor_char_boundary(byte.saturating_sub(AROUND).clamp(line.start, line.end));
        let to = text.ceil_char_boundary((byte + AROUND).clamp(line.start, line.end));
        from..to
    };
    let mut parts: Vec<Range<usize>> = Vec::new();
    for part in ends.map(near) {
        match parts.last_mut() {
            Some(last) if part.start <= last.end => last.end = last.end.max(part.end),
            _ => parts.push(part),
        }
    }
    if parts.is_empty() {
        parts.push(near(line.start));
    }
    parts
}

impl SourceCode for Excerpt {
    fn read_span<'b>(
        &'b self,
        span: &SourceSpan,
        before: usize,
        after: usize,
    ) -> Result<Box<dyn SpanContents<'b> + 'b>, MietteError> {
        let within = |p: &&Piece| {
            (p.at..=p.at + p.text.len()).contains(&span.offset())
                && span.offset() + span.len() <= p.at + p.text.len()
        };
        let piece = self.pieces.iter().find(within).ok_or(MietteError::OutOfBounds)?;
        let inner = piece.text.read_span(&(span.offset() - piece.at, span.len()).into(), before, after)?;
        let column = self.columns.iter().find(|c| before == 0 && c.0 == span.offset());
        let own = inner.line_count().saturating_sub(inner.line());
        Ok(Box::new(MietteSpanContents::new_named(
            self.name.clone(),
            inner.data(),
            (inner.span().offset() + piece.at, inner.span().len()).into(),
            inner.line() + piece.first + self.lines_before,
            column.map_or(inner.column(), |c| c.1),
            (inner.line_count() + piece.first).min(own + NEAR),
        )))
    }
}

// Where the lines of a text begin: found once for all that is said about it.

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
