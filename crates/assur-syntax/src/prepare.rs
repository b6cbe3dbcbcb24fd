//! Makes a text readable byte for byte: foreign blanks, signs and digits are replaced by plain ones of the same total
//! length, so that every place stays where it was, and are reported.
//!
//! Comments become blanks: the grammar knows none. Those of other languages, `# …` and `/* … */`, do so too, and are
//! reported.
//!
//! What is left of a replaced character is filled with [`FILL`], which the grammar takes for a blank and which a place
//! that ends before it includes, so that no place ends within a character of the author's.
//!
//! Brackets nested deeper than [`DEPTH`] are blanked out here, before anything descends into them.

use super::trivia::Line;
use crate::recover::comment_sign;
use assur_text::diagnostic::{Diagnosis, Help, Problems};
use assur_text::source::{Edit, Span};

/// How many brackets may be nested.
pub(super) const DEPTH: usize = 64;

/// What stands for the other bytes of a replaced character: next to the blank, so that the grammar looks for both at once.
pub(super) const FILL: char = '\u{1f}';

/// The end of a place in the prepared text, moved over what is left of its last character.
pub(super) fn whole_end(read: &str, end: usize) -> usize {
    let rest = read.as_bytes().get(end..).unwrap_or_default();
    end + rest.iter().take_while(|b| **b == FILL as u8).count()
}

/// The text that the grammar reads, of the same length as the author's.
pub(super) fn prepare(text: &str, problems: &mut Problems) -> String {
    let mut prepare = Prepare {
        text,
        out: String::with_capacity(text.len()),
        changes: Vec::new(),
        comments: Vec::new(),
        block_end: text.rfind("*/").unwrap_or(0),
        deep: None,
    };
    prepare.run(problems);
    problems.extend(comments(text, &prepare.comments));
    report(text, &prepare.changes, problems);
    prepare.out
}

#[derive(Clone, Copy, PartialEq)]
enum Mode {
    Code,
    Comment,
    /// Between `/*` and `*/`; whether the stroke of the end comes next.
    Block(bool),
    /// A text; whether it was opened by a straight quote.
    Text(bool),
}

struct Prepare<'a> {
    text: &'a str,
    out: String,
    changes: Vec<Change>,
    /// The comments of other languages.
    comments: Vec<Span>,
    /// Where the last `*/` stands: a `/*` after it is not closed and ends with its line.
    block_end: usize,
    /// Where brackets were nested too deep first.
    deep: Option<Span>,
}

impl<'a> Prepare<'a> {
    fn run(&mut self, problems: &mut Problems) {
        let mut mode = Mode::Code;
        let mut depth = 0_usize;
        let mut depth_at_line = 0;
        let mut blank_line = false;
        let mut padding = 0;
        let mut lone_return = None;
        let mut rest = self.text;
        loop {
            let plain = plain_start(rest, mode);
            if plain > 0 && !blank_line {
                let (run, behind) = rest.split_at(plain);
                if mode == Mode::Code {
                    let (word, more) = run.split_at(self.continued(run, padding));
                    self.out.push_str(word);
                    if !more.is_empty() {
                        self.pad(&mut padding);
                    }
                    self.out.push_str(more);
                } else {
                    self.pad(&mut padding);
                    self.out.extend(std::iter::repeat_n(' ', plain));
                }
                rest = behind;
            }
            let at = self.text.len() - rest.len();
            let mut chars = rest.chars();
            let Some(c) = chars.next() else { break };
            rest = chars.as_str();
            let span = Span::new(at, at + c.len_utf8());
            let next = chars.next();
            let replaced = if mode == Mode::Code { self.foreign(span, c) } else { None };
            if let Some((plain, pads)) = replaced {
                // Digits and letters are kept together.
                if !plain.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'.') {
                    self.pad(&mut padding);
                }
                self.out.push_str(if blank_line { BLANKS[plain.len()] } else { plain });
                padding += pads;
                mode = if plain == "\"" { Mode::Text(false) } else { mode };
                depth = bracket(depth, plain.chars().next().unwrap_or(' '));
            } else {
                self.pad(&mut padding);
                let is_end = c == '\n' || (c == '\r' && next != Some('\n'));
                if c == '\r' && is_end {
                    lone_return = lone_return.or(Some(span));
                }
                if is_end {
                    self.out.push('\n');
                    mode = if matches!(mode, Mode::Block(_)) { Mode::Block(false) } else { Mode::Code };
                    depth = if blank_line { depth_at_line } else { depth };
                    depth_at_line = depth;
                    blank_line = false;
                    continue;
                }
                let (written, next_mode) = self.plain(span, c, next, mode);
                mode = next_mode;
                if mode == Mode::Code {
                    depth = bracket(depth, c);
                }
                blank_line |= depth > DEPTH;
                if blank_line {
                    self.deep = self.deep.or(Some(span));
                    self.out.extend(std::iter::repeat_n(' ', c.len_utf8()));
                } else {
                    self.out.push_str(written);
                }
            }
        }
        self.pad(&mut padding);
        if let Some(at) = lone_return {
            problems.push(
                Diagnosis::warning(
                    "mech::syntax::lone_carriage_return",
                    "this line ends with a carriage return alone",
                )
                .label(at, "CR without LF")
                .help("save the file with line ends LF or CR LF"),
            );
        }
        if let Some(at) = self.deep {
            problems.push(too_deep(DEPTH, at));
        }
    }

    /// How much of a run continues the word that a replaced character is a part of: a word stays in one piece, and the
    /// filling comes after it. What begins with a digit may be a number and a unit, and is no word.
    fn continued(&self, run: &str, padding: usize) -> usize {
        /// The longest word that is looked at.
        const LONGEST: usize = 64;
        let in_word = |b: &u8| b.is_ascii_alphanumeric() || matches!(b, b'_' | b'\'');
        let before = self.out.bytes().rev().take(LONGEST).take_while(in_word).last();
        if padding == 0 || !before.is_some_and(|b| b.is_ascii_alphabetic()) {
            return 0;
        }
        run.bytes().take_while(in_word).count()
    }

    /// Filling after a run of replaced characters, so that the run itself has none.
    fn pad(&mut self, padding: &mut usize) {
        self.out.extend(std::iter::repeat_n(FILL, *padding));
        *padding = 0;
    }

    /// What is written for a character that stays, and the mode after it.
    fn plain(&mut self, span: Span, c: char, next: Option<char>, mode: Mode) -> (&'a str, Mode) {
        let text = &self.text[span.start..span.end];
        match (mode, c) {
            (Mode::Code, '"') => (text, Mode::Text(true)),
            (Mode::Code, '/') if next == Some('/') => (BLANKS[1], Mode::Comment),
            (Mode::Code, '/') if next == Some('*') => {
                self.comments.push(span);
                let closed = span.end < self.block_end;
                (BLANKS[1], if closed { Mode::Block(false) } else { Mode::Comment })
            }
            (Mode::Code, '#') => {
                self.comments.push(span);
                (BLANKS[1], Mode::Comment)
            }
            (Mode::Block(true), '/') => {
                self.end_comment(span);
                (BLANKS[1], Mode::Code)
            }
            (Mode::Block(_), _) => {
                (BLANKS[c.len_utf8()], Mode::Block(c == '*' && next == Some('/') && self.opened_before(span)))
            }
            (Mode::Comment, _) => (BLANKS[c.len_utf8()], mode),
            (Mode::Text(true), '"') => (text, Mode::Code),
            (Mode::Text(false), '"' | '”' | '“' | '„' | '»' | '«' | '＂') => {
                if c == '"' {
                    (text, Mode::Code)
                } else {
                    self.changes.push(Change { span, kind: Kind::Quote, with: "\"" });
                    (CLOSING[c.len_utf8()], Mode::Code)
                }
            }
            (Mode::Code, _) if c.is_whitespace() || c == '\u{FEFF}' => (BLANKS[c.len_utf8()], mode),
            _ => (text, mode),
        }
    }

    /// Whether the star of an end is not that of the beginning: `/*/`.
    fn opened_before(&self, star: Span) -> bool {
        self.comments.last().is_some_and(|comment| star.start > comment.start + 1)
    }

    /// The comment that was opened last ends here.
    fn end_comment(&mut self, stroke: Span) {
        if let Some(comment) = self.comments.last_mut() {
            comment.end = stroke.end;
        }
    }

    /// What a foreign character in code is replaced by, and how many blanks are owed for it.
    fn foreign(&mut self, span: Span, c: char) -> Option<(&'static str, usize)> {
        let (kind, with) = replacement(c, span.start)?;
        self.changes.push(Change { span, kind, with });
        if kind == Kind::Invisible {
            return Some(("", c.len_utf8()));
        }
        Some((with, c.len_utf8() - with.len()))
    }
}

/// The length of what stays as it is, or is a comment, at the beginning of a text.
fn plain_start(text: &str, mode: Mode) -> usize {
    let plain = |b: &u8| match mode {
        Mode::Code => {
            matches!(b, b' ' | b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'_' | b'.' | b'=' | b',' | b'*'
            | b'+' | b'-' | b'@' | b':' | b';' | b'\'')
        }
        Mode::Comment => matches!(b, b' '..=b'~' | b'\t'),
        Mode::Block(_) => matches!(b, b' '..=b')' | b'+'..=b'.' | b'0'..=b'~' | b'\t'),
        Mode::Text(_) => false,
    };
    text.bytes().take_while(plain).count()
}

/// Blanks of each length.
const BLANKS: [&str; 5] = ["", " ", "  ", "   ", "    "];
/// A closing quote at the end of a character's bytes.
const CLOSING: [&str; 5] = ["", "\"", " \"", "  \"", "   \""];

fn bracket(depth: usize, c: char) -> usize {
    match c {
        '(' | '[' | '{' => depth + 1,
        ')' | ']' | '}' => depth.saturating_sub(1),
        _ => depth,
    }
}

fn replacement(c: char, at: usize) -> Option<(Kind, &'static str)> {
    Some(match c {
        '\u{FF02}' | '“' | '”' | '„' | '«' | '»' | '‟' => (Kind::Quote, "\""),
        '\u{FF01}'..='\u{FF5E}' => (Kind::FullWidth, ascii(c)?),
        '、' => (Kind::FullWidth, ","),
        '。' => (Kind::FullWidth, "."),
        '×' | '∙' | '∗' => (Kind::Sign, "*"),
        '÷' | '∕' => (Kind::Sign, "/"),
        '≤' | '⩽' => (Kind::Sign, "<="),
        '≥' | '⩾' => (Kind::Sign, ">="),
        '…' => (Kind::Sign, ".."),
        '’' | '′' | '‘' => (Kind::Sign, "'"),
        '\u{FEFF}' if at == 0 => return None,
        '\u{FEFF}' | '\u{200B}'..='\u{200F}' | '\u{2060}' | '\u{AD}' | '\u{2028}' | '\u{2029}' => {
            (Kind::Invisible, "")
        }
        c if c.is_control() && !matches!(c, '\t' | '\n' | '\r') => (Kind::Invisible, ""),
        _ => return None,
    })
}

/// The plain character of a full-width one, as a text.
fn ascii(c: char) -> Option<&'static str> {
    const PLAIN: &str =
        "!\"#$%&'()*+,-./0123456789:;<=>?@ABCDEFGHIJKLMNOPQRSTUVWXYZ[\\]^_`abcdefghijklmnopqrstuvwxyz{|}~";
    let index = (c as usize).checked_sub(0xFF01)?;
    PLAIN.get(index..=index)
}

// Characters that were replaced to make a text readable.

/// A replacement that is reported.
pub struct Change {
    pub span: Span,
    pub kind: Kind,
    pub with: &'static str,
}

#[derive(Clone, Copy, PartialEq)]
pub enum Kind {
    FullWidth,
    Quote,
    Sign,
    Invisible,
}

// What is reported of characters and comments of other kinds.

/// One diagnostic for all comments of other languages: they are one habit.
pub(super) fn comments(text: &str, comments: &[Span]) -> Option<Diagnosis> {
    let first = *comments.first()?;
    let sign = if text[first.start..].starts_with('#') { "#" } else { "/*" };
    let line = Line::around(text, first.start);
    let written = |from: usize, to: usize| text.get(from..to).unwrap_or_default();
    let before = written(line.start, first.start).trim();
    let closed = first.end > first.start + 1;
    let (comment, behind) = if closed {
        (written(first.start + 2, first.end - 2), written(first.end, Line::around(text, first.end).end))
    } else {
        (written(first.start + sign.len(), line.end), "")
    };
    let lines = comment.contains('\n');
    let code = [before, behind.trim()].join(" ").trim().to_owned();
    let mut help = match (lines, code.is_empty()) {
        (true, _) => "begin each line of this comment with `//`".to_owned(),
        (false, true) => format!("write: // {}", comment.trim()),
        (false, false) => format!("write: {code}  // {}", comment.trim()),
    };
    if let more @ 1.. = comments.len() - 1 {
        let plural = if more == 1 { "comment" } else { "comments" };
        help = format!("{help}\nand so for {more} more {plural}");
    }
    let at = Span::new(first.start, first.start + sign.len());
    // a sign for a whole comment is one at each of its lines
    let signs = comments.iter().map(|comment| Edit::new(Span::new(comment.start, comment.start + 1), "//"));
    let all_plain = comments.iter().all(|comment| text[comment.start..].starts_with('#'));
    let help = if all_plain { Help::lines(text, at, signs.collect()).in_words(help) } else { help.into() };
    Some(comment_sign(at, sign, help))
}

/// One diagnostic for each kind on a line.
pub(super) fn report(text: &str, changes: &[Change], problems: &mut Problems) {
    let mut rest = changes;
    while let Some(first) = rest.first() {
        let line = Line::around(text, first.span.start);
        let count = rest.iter().take_while(|c| c.span.start < line.end.max(first.span.end)).count();
        let (here, later) = rest.split_at(count);
        let edits = here.iter().map(|change| Edit::new(change.span, change.with)).collect();
        let help = Help::lines(text, Span::new(line.start, line.end), edits);
        for kind in [Kind::FullWidth, Kind::Quote, Kind::Sign, Kind::Invisible] {
            if let Some(problem) = describe(text, here, kind, &help) {
                problems.push(problem);
            }
        }
        rest = later;
    }
}

fn describe(text: &str, changes: &[Change], kind: Kind, help: &Help) -> Option<Diagnosis> {
    let first = changes.iter().find(|c| c.kind == kind)?;
    let found = text[first.span.start..].chars().next()?;
    let help = help.clone();
    // The first run of neighbours.
    let mut at = first.span;
    for change in changes.iter().filter(|c| c.kind == kind && c.with != "\"") {
        if change.span.start == at.end {
            at.end = change.span.end;
        }
    }
    Some(match kind {
        Kind::FullWidth => {
            Diagnosis::error("mech::syntax::full_width", "full-width characters cannot be read")
                .label(at, "written in full width")
                .help(help.certain())
        }
        Kind::Quote => Diagnosis::error("mech::syntax::curly_quotes", "use straight quotes (`\"`)")
            .label(first.span, "this is another kind of quote")
            .help(help.certain()),
        Kind::Sign => Diagnosis::error("mech::syntax::foreign_sign", format!("`{found}` is not used here"))
            .label(first.span, format!("written `{}` in this language", first.with))
            .help(help.certain()),
        Kind::Invisible => Diagnosis::error(
            "mech::syntax::invisible_character",
            format!("invisible character (U+{:04X})", u32::from(found)),
        )
        .label(first.span, "invisible")
        .help(help.certain()),
    })
}

// Errors of the characters of a text, before it is read.

pub fn too_deep(limit: usize, at: Span) -> Diagnosis {
    Diagnosis::error("mech::syntax::too_deep", format!("nested more than {limit} levels deep"))
        .label(at, "one level too many")
        .help("give a part of it a name: let part = …; the rest of this line is not read")
}
