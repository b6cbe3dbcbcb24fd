//! Texts of labels: runs of upright and italic letters, raised and lowered, with their measures.

use crate::geometry::Rect;
use crate::widths::width;
use assur_math::math::Vec2;

/// Size of an index over that of its letter.
const INDEX: f64 = 0.68;
/// How far an index is lowered, over the size.
const LOWERED: f64 = 0.2;
/// How far an exponent is raised, over the size.
const RAISED: f64 = 0.36;
/// Height of capitals and of letters with an ascender, over the size.
const ASCENT: f64 = 0.69;
/// Depth of descenders, over the size.
const DESCENT: f64 = 0.22;
/// What a name may have of glyphs before it is shortened, em.
const LONGEST: f64 = 14.0;

/// Where a run is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Level {
    Base,
    Sub,
    /// An exponent above; an index that follows is below it.
    Sup,
}

/// Letters of one kind.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Run {
    pub letters: String,
    /// Slanted: quantities and points.
    pub italic: bool,
    pub level: Level,
    /// A unit, as languages write it.
    pub unit: bool,
}

/// A text of one line.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Text {
    pub runs: Vec<Run>,
    /// What was left out of a long name: all of it.
    pub full: Option<String>,
}

/// A run with its place relative to the begin of the line, and its size, mm.
#[derive(Clone, Debug, PartialEq)]
pub struct Set<'a> {
    pub run: &'a Run,
    /// Begin of its base line; y down.
    pub at: Vec2,
    /// Size of the font.
    pub size: f64,
    pub width: f64,
}

impl Text {
    /// Upright: numbers, units, words.
    #[must_use]
    pub fn upright(letters: &str) -> Self {
        Self::default().and(letters, false, Level::Base)
    }

    /// Italic: one letter of a quantity.
    #[must_use]
    pub fn italic(letters: &str) -> Self {
        Self::default().and(letters, true, Level::Base)
    }

    #[must_use]
    pub fn and(mut self, letters: &str, italic: bool, level: Level) -> Self {
        let mut rest = letters;
        while level == Level::Base
            && let Some((before, exponent, behind)) = exponent(rest)
        {
            self = self.run(before, italic, level).run(&exponent, false, Level::Sup);
            rest = behind;
        }
        self.run(rest, italic, level)
    }

    fn run(mut self, letters: &str, italic: bool, level: Level) -> Self {
        if !letters.is_empty() {
            self.runs.push(Run { letters: clean(letters), italic, level, unit: false });
        }
        self
    }

    /// With a unit of its own: one behind a number needs no mark.
    #[must_use]
    pub fn unit(mut self, unit: &str) -> Self {
        self.runs.push(Run { letters: clean(unit), italic: false, level: Level::Base, unit: true });
        self
    }

    /// With an upright index.
    #[must_use]
    pub fn lowered(self, letters: &str) -> Self {
        self.and(letters, false, Level::Sub)
    }

    /// With an upright exponent.
    #[must_use]
    pub fn raised(self, letters: &str) -> Self {
        self.and(letters, false, Level::Sup)
    }

    /// The name of a point or a quantity as a label: `S2` → S₂, `v_F` → v with index F, `phi1` → φ₁, `B'` → B′, `Mb` → M
    /// with index b.
    #[must_use]
    pub fn name(name: &str) -> Self {
        let (shown, full) = shortened(name);
        let unprimed = shown.trim_end_matches(['\'', '′']);
        let primes = "′".repeat(shown[unprimed.len()..].chars().count());
        let (letters, index) = match unprimed.split_once('_') {
            Some((letters, index)) if !letters.is_empty() && !index.is_empty() => {
                (letters.to_owned(), index.replace('_', " "))
            }
            _ => {
                let bare = unprimed.trim_end_matches(|c: char| c.is_ascii_digit());
                let cut = if bare.is_empty() { unprimed.len() } else { bare.len() };
                (unprimed[..cut].to_owned(), unprimed[cut..].to_owned())
            }
        };
        // `phi_1`, `omega2_x`
        let bare = letters.trim_end_matches(|c: char| c.is_ascii_digit());
        let (letters, index) = if bare.len() < letters.len() && !bare.is_empty() {
            (bare.to_owned(), format!("{}{index}", &letters[bare.len()..]))
        } else {
            (letters, index)
        };
        // `Mb`, `Fr`: a quantity and what it is of
        let described =
            described(&letters).filter(|_| index.is_empty()).map(|(l, i)| (l.to_owned(), i.to_owned()));
        let (letters, index) = described.unwrap_or((letters, index));
        let letters = greek(&letters).unwrap_or(letters);
        let mut text =
            Self::default().and(&letters, true, Level::Base).and(&primes, false, Level::Base).lowered(&index);
        text.full = full;
        text
    }

    #[must_use]
    pub fn plain(&self) -> String {
        if let Some(full) = &self.full {
            return full.clone();
        }
        let mut plain = String::new();
        for run in &self.runs {
            if run.level == Level::Sub {
                plain.push('_');
            }
            let is_exponent = run.level == Level::Sup && run.letters.chars().all(|c| DIGITS.contains(c));
            let raised = |c: char| RAISED_DIGITS.chars().nth(DIGITS.chars().position(|d| d == c)?);
            if is_exponent {
                plain.extend(run.letters.chars().map(|c| raised(c).unwrap_or(c)));
            } else {
                plain.push_str(&run.letters);
            }
        }
        plain
    }

    /// Its runs in place, at a size.
    #[must_use]
    pub fn set(&self, size: f64) -> Vec<Set<'_>> {
        let (mut end, mut below, mut above) = (0.0_f64, 0.0_f64, 0.0_f64);
        let mut placed = Vec::with_capacity(self.runs.len());
        for run in &self.runs {
            let em = if run.level == Level::Base { size } else { INDEX * size };
            let width = run.letters.chars().map(|c| width(c, run.italic)).sum::<f64>() * em;
            let at = match run.level {
                Level::Base => {
                    let start = end.max(below).max(above);
                    end = start + width;
                    (below, above) = (end, end);
                    Vec2::new(start, 0.0)
                }
                Level::Sub => {
                    let start = below;
                    below += width;
                    Vec2::new(start, LOWERED * size)
                }
                Level::Sup => {
                    let start = above;
                    above += width;
                    Vec2::new(start, -RAISED * size)
                }
            };
            placed.push(Set { run, at, size: em, width });
        }
        placed
    }

    /// Its box around the begin of the base line, at a size.
    #[must_use]
    pub fn bounds(&self, size: f64) -> Rect {
        let mut rect = Rect::NOTHING;
        for set in self.set(size) {
            let deep = set.run.letters.chars().any(is_deep);
            let depth = if deep { DESCENT } else { 0.02 };
            rect.add(set.at + Vec2::new(0.0, -ASCENT * set.size));
            rect.add(set.at + Vec2::new(set.width, depth * set.size));
        }
        if rect.is_nothing() { Rect { min: Vec2::zero(), max: Vec2::zero() } } else { rect }
    }
}

/// Digits of exponents, and the signs of them that fonts have or lack.
const DIGITS: &str = "0123456789−";
const RAISED_DIGITS: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹⁻";

/// The digit or the minus that a raised one is.
pub(crate) fn lowered(raised: char) -> Option<char> {
    DIGITS.chars().nth(RAISED_DIGITS.chars().position(|r| r == raised)?)
}

/// What is before the first exponent that fonts have no signs for, its digits, and what is behind.
fn exponent(letters: &str) -> Option<(&str, String, &str)> {
    let is_raised = |c: char| RAISED_DIGITS.contains(c);
    let mut from = 0;
    loop {
        let start = from + letters[from..].find(is_raised)?;
        let length = letters[start..].find(|c| !is_raised(c)).unwrap_or(letters.len() - start);
        let (exponent, behind) = letters[start..].split_at(length);
        if exponent.chars().any(|c| !matches!(c, '¹' | '²' | '³')) {
            return Some((&letters[..start], exponent.chars().filter_map(lowered).collect(), behind));
        }
        from = start + length;
    }
}

/// Whether a glyph reaches below the line.
const fn is_deep(c: char) -> bool {
    matches!(
        c,
        'g' | 'j' | 'p' | 'q' | 'y' | 'Q' | 'f' | ',' | ';' | '(' | ')' | '[' | ']' | '/' | '|' | '_' | '@'
    ) || !c.is_ascii()
        && !matches!(
            c,
            'α' | 'ε'
                | 'ι'
                | 'κ'
                | 'ν'
                | 'ο'
                | 'π'
                | 'σ'
                | 'τ'
                | 'υ'
                | 'ω'
                | 'δ'
                | 'λ'
                | 'θ'
                | '′'
                | '°'
                | '·'
                | '−'
                | '²'
                | '⁻'
        )
}

/// Without signs that no document may contain.
fn clean(letters: &str) -> String {
    letters
        .chars()
        .map(|c| if c.is_control() || matches!(c, '\u{FFFE}' | '\u{FFFF}') { ' ' } else { c })
        .collect()
}

/// A name that is too long, with its middle left out, and all of it.
fn shortened(name: &str) -> (String, Option<String>) {
    let total: f64 = name.chars().map(|c| width(c, true)).sum();
    if total <= LONGEST {
        return (name.to_owned(), None);
    }
    let take = |chars: &mut dyn Iterator<Item = char>| {
        let mut left = LONGEST / 2.0 - 0.5;
        chars
            .take_while(|c| {
                left -= width(*c, true);
                left >= 0.0
            })
            .collect::<Vec<char>>()
    };
    let head: String = take(&mut name.chars()).into_iter().collect();
    let tail: String = take(&mut name.chars().rev()).into_iter().rev().collect();
    (format!("{head}…{tail}"), Some(name.to_owned()))
}

/// A capital followed by few small letters, which are its index.
fn described(letters: &str) -> Option<(&str, &str)> {
    let first = letters.chars().next().filter(|c| c.is_uppercase() && c.is_alphabetic())?;
    let rest = &letters[first.len_utf8()..];
    let small = !rest.is_empty() && rest.chars().count() <= 3 && rest.chars().all(char::is_lowercase);
    (small && greek(letters).is_none()).then_some((&letters[..first.len_utf8()], rest))
}

/// Greek letters by their names.
const GREEK: [(&str, char); 29] = [
    ("alpha", 'α'),
    ("beta", 'β'),
    ("gamma", 'γ'),
    ("delta", 'δ'),
    ("epsilon", 'ε'),
    ("zeta", 'ζ'),
    ("eta", 'η'),
    ("theta", 'θ'),
    ("iota", 'ι'),
    ("kappa", 'κ'),
    ("lambda", 'λ'),
    ("mu", 'μ'),
    ("nu", 'ν'),
    ("xi", 'ξ'),
    ("pi", 'π'),
    ("rho", 'ρ'),
    ("sigma", 'σ'),
    ("tau", 'τ'),
    ("phi", 'φ'),
    ("chi", 'χ'),
    ("psi", 'ψ'),
    ("omega", 'ω'),
    ("Gamma", 'Γ'),
    ("Delta", 'Δ'),
    ("Theta", 'Θ'),
    ("Lambda", 'Λ'),
    ("Phi", 'Φ'),
    ("Psi", 'Ψ'),
    ("Omega", 'Ω'),
];

/// The letter of a word.
fn greek(word: &str) -> Option<String> {
    GREEK.iter().find(|(name, _)| *name == word).map(|(_, letter)| letter.to_string())
}

/// Greek letters that pictures have without a name for them in files.
const MORE: [(&str, char); 5] =
    [("Sigma", 'Σ'), ("Pi", 'Π'), ("Xi", 'Ξ'), ("Upsilon", 'Υ'), ("upsilon", 'υ')];

/// The name of a Greek letter.
pub(crate) fn greek_name(letter: char) -> Option<&'static str> {
    GREEK.iter().chain(&MORE).find(|(_, own)| *own == letter).map(|(name, _)| *name)
}
