//! How a formula is laid out, before any format.

use crate::cyrillic::cyrillic;
use crate::number::Figures;

/// A part of a line.
#[derive(Clone, Debug, PartialEq)]
pub enum Node {
    /// Parts one after another.
    Row(Vec<Node>),
    /// Letters of a quantity: letter, index, mark, arrow.
    Letter {
        letter: String,
        sub: String,
        sup: String,
        arrow: bool,
        /// The power; 1 is the quantity itself.
        power: u8,
    },
    Number(Figures),
    /// A number of degrees.
    Degrees(Figures),
    /// π
    Pi,
    /// An operator between terms or sides.
    Operator(&'static str),
    /// A minus sign before a term.
    Minus,
    /// Product without a sign.
    Times,
    /// Product with a point.
    Dot,
    Fraction(Box<Node>, Box<Node>),
    /// A power of what is not a letter.
    Power(Box<Node>, u8),
    Root(Box<Node>),
    Bars(Box<Node>),
    Brackets(Box<Node>),
    /// A bracket whose other one is on another line, or the stroke of a fraction that goes over lines.
    Fence(&'static str),
    /// A function with what it is of.
    Function(&'static str, Box<Node>),
    /// A unit after a number.
    Unit(String),
    Words(String),
}

impl Node {
    #[must_use]
    pub const fn empty() -> Self {
        Self::Row(Vec::new())
    }

    /// With decimals behind a comma, and units in Cyrillic letters.
    #[must_use]
    pub fn with_commas(self) -> Self {
        let comma = |figures: Figures| Figures { digits: figures.digits.replace('.', ","), ..figures };
        let inner = |node: Box<Self>| Box::new(node.with_commas());
        match self {
            Self::Row(parts) => Self::Row(parts.into_iter().map(Self::with_commas).collect()),
            Self::Number(figures) => Self::Number(comma(figures)),
            Self::Degrees(figures) => Self::Degrees(comma(figures)),
            Self::Fraction(a, b) => Self::Fraction(inner(a), inner(b)),
            Self::Power(x, n) => Self::Power(inner(x), n),
            Self::Root(x) => Self::Root(inner(x)),
            Self::Bars(x) => Self::Bars(inner(x)),
            Self::Brackets(x) => Self::Brackets(inner(x)),
            Self::Function(name, x) => Self::Function(name, inner(x)),
            Self::Unit(unit) => Self::Unit(cyrillic(&unit).unwrap_or(unit)),
            other => other,
        }
    }

    /// How far it reaches above and below the middle of a line, in letters.
    #[must_use]
    pub fn reach(&self) -> [f64; 2] {
        self.reach_in(1.0)
    }

    /// The same, of a fraction whose sides have letters of this size.
    fn reach_in(&self, sides: f64) -> [f64; 2] {
        const BAR: f64 = 0.1;
        const SMALLER: f64 = 0.7;
        match self {
            Self::Row(parts) => {
                let higher = |a: [f64; 2], b: [f64; 2]| [a[0].max(b[0]), a[1].max(b[1])];
                parts.iter().map(|part| part.reach_in(sides)).fold([0.5; 2], higher)
            }
            Self::Fraction(a, b) => {
                [a, b].map(|side| sides * side.reach_in(SMALLER).iter().sum::<f64>() + BAR)
            }
            Self::Power(x, _) => [x.reach_in(sides)[0] + BAR, x.reach_in(sides)[1]],
            Self::Root(x) | Self::Bars(x) | Self::Brackets(x) | Self::Function(_, x) => x.reach_in(sides),
            _ => [0.5; 2],
        }
    }

    /// Its width in figures.
    #[must_use]
    pub fn width(&self) -> f64 {
        let letters = |text: &str| text.chars().count() as f64;
        match self {
            Self::Row(parts) => parts.iter().map(Self::width).sum(),
            Self::Letter { letter, sub, sup, .. } => {
                1.2 * letters(letter) + 0.75 * letters(sub).max(letters(sup))
            }
            Self::Number(figures) => letters(&figures.text()),
            Self::Degrees(figures) => letters(&figures.text()) + 0.8,
            Self::Pi => 1.2,
            Self::Operator(_) => 2.6,
            Self::Minus => 1.4,
            Self::Times => 0.3,
            Self::Dot => 1.0,
            Self::Fence(_) => 0.8,
            Self::Fraction(a, b) => a.width().max(b.width()) + 0.6,
            Self::Power(x, _) => x.width() + 0.8,
            Self::Root(x) => x.width() + 1.8,
            Self::Bars(x) | Self::Brackets(x) => x.width() + 1.6,
            Self::Function(name, x) => 0.9 * letters(name) + 0.6 + x.width(),
            Self::Unit(unit) => 0.9 * letters(unit) + 0.5,
            Self::Words(words) => letters(words),
        }
    }
}
