//! A worked solution before any format: headings, sentences, equations, tables, figures.

use assur_formula::{Lines, Name, Node, header_in_cyrillic, name_node, units_in_cyrillic};

/// A part of a line of text.
#[derive(Clone, Debug, PartialEq)]
pub enum Inline {
    Text(String),
    /// Letters or numbers of a formula.
    Math(Node),
    /// Words that stand out.
    Strong(String),
    /// A figure that the text names.
    Figure(Reference),
}

/// A figure that the text names.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Reference {
    /// What the figure shows.
    pub caption: String,
    /// Its number, once all figures are there.
    pub number: usize,
    /// What is written: `Figure 2`.
    pub words: String,
}

/// A line of text.
pub type Line = Vec<Inline>;

/// A part of a document.
#[derive(Clone, Debug, PartialEq)]
pub enum Block {
    /// A heading of the second level or below.
    Heading(u8, String),
    Paragraph(Line),
    /// A remark in softer print.
    Remark(Line),
    Equation(Lines),
    Table(Table),
    /// A table whose cells are filled in by hand.
    Form(Table),
    /// Numbered items.
    List(Vec<Line>),
    /// Room to write in, with a heading.
    Room(String),
    /// A vector equation with what is known of its terms.
    Vectors(Vec<Term>),
    /// Figures next to each other.
    Figures(Vec<Figure>),
}

#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    pub headers: Vec<Line>,
    pub rows: Vec<Vec<Line>>,
    pub numbers: Vec<usize>,
}

/// A term of a vector equation.
#[derive(Clone, Debug, PartialEq)]
pub struct Term {
    /// The sign before it.
    pub sign: &'static str,
    pub name: Name,
    /// Its magnitude, "?" where that is not known.
    pub magnitude: Line,
    pub direction: Line,
}

#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    pub svg: String,
    /// The name of its picture, for files.
    pub name: String,
    pub caption: String,
}

#[derive(Clone, Debug, Default, PartialEq)]
pub struct Document {
    pub title: String,
    /// What is to be filled in above the title.
    pub fields: Vec<String>,
    /// The language of its sentences.
    pub language: &'static str,
    /// The words that writers need: contents, figure, rows of vector equations.
    pub labels: Labels,
    pub blocks: Vec<Block>,
}

/// Words that writers put before parts.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Labels {
    pub contents: &'static str,
    /// None where figures have no numbers.
    pub figure: &'static str,
    /// The same in a sentence, before the number.
    pub cited: &'static str,
    /// Equation, magnitude, direction
    pub rows: [&'static str; 3],
}

impl Labels {
    /// What stands below a figure: its number, where figures have one, and its caption.
    pub(crate) fn below(&self, number: usize, caption: &str) -> String {
        match self.figure {
            "" => caption.to_owned(),
            label => format!("{label} {number}. {caption}"),
        }
    }
}

impl Document {
    /// Without figures, and without the paragraphs that name them.
    #[must_use]
    pub fn without_figures(mut self) -> Self {
        self.blocks.retain(|block| !matches!(block, Block::Figures(_)));
        self.blocks = cited(self.blocks, self.labels.cited);
        self
    }
}

/// With the numbers of the figures where the text names them; paragraphs that name one that is not there are left out.
pub fn cited(mut blocks: Vec<Block>, label: &str) -> Vec<Block> {
    let figures =
        blocks.iter().filter_map(|b| if let Block::Figures(figures) = b { Some(figures) } else { None });
    let captions: Vec<String> = figures.flatten().map(|figure| figure.caption.clone()).collect();
    blocks.retain_mut(|block| {
        let Block::Paragraph(line) = block else { return true };
        line.iter_mut().all(|part| {
            let Inline::Figure(reference) = part else { return true };
            let Some(at) = captions.iter().position(|c| *c == reference.caption) else { return false };
            reference.number = at + 1;
            let apart = if label.is_ascii() || label.ends_with('.') { "\u{a0}" } else { "" };
            reference.words = format!("{label}{apart}{}", at + 1);
            true
        })
    });
    blocks
}

pub fn text(words: impl Into<String>) -> Inline {
    Inline::Text(words.into())
}

pub fn letter(name: &Name) -> Inline {
    Inline::Math(name_node(name))
}

/// Against a vector of a point.
pub fn against(vector: &str, point: &str) -> Line {
    vec![text("↑↓ "), letter(&Name::new(vector, point))]
}

impl Block {
    /// With decimals behind a comma, and units in Cyrillic letters.
    pub fn with_commas(self) -> Self {
        match self {
            Self::Equation(lines) => Self::Equation(lines.with_commas()),
            Self::Paragraph(line) => Self::Paragraph(line_with_commas(line)),
            Self::Remark(line) => Self::Remark(line_with_commas(line)),
            Self::List(items) => Self::List(items.into_iter().map(line_with_commas).collect()),
            Self::Table(table) => Self::Table(table.with_commas()),
            Self::Form(table) => Self::Form(table.with_commas()),
            Self::Vectors(terms) => {
                let of = |term: Term| Term {
                    magnitude: line_with_commas(term.magnitude),
                    direction: line_with_commas(term.direction),
                    ..term
                };
                Self::Vectors(terms.into_iter().map(of).collect())
            }
            Self::Heading(..) | Self::Figures(_) | Self::Room(_) => self,
        }
    }
}

impl Table {
    fn with_commas(self) -> Self {
        let rows = self.rows.into_iter().map(|row| row.into_iter().map(line_with_commas).collect());
        let header = |part: Inline| match part {
            Inline::Text(words) => Inline::Text(header_in_cyrillic(&commas(&words))),
            part => part_with_commas(part),
        };
        let headers = self.headers.into_iter().map(|line| line.into_iter().map(header).collect());
        Self { headers: headers.collect(), rows: rows.collect(), ..self }
    }
}

fn line_with_commas(line: Line) -> Line {
    line.into_iter().map(part_with_commas).collect()
}

fn part_with_commas(part: Inline) -> Inline {
    match part {
        Inline::Text(words) => Inline::Text(units_in_cyrillic(&commas(&words))),
        Inline::Strong(_) | Inline::Figure(_) => part,
        Inline::Math(node) => Inline::Math(node.with_commas()),
    }
}

/// Points between two figures become commas.
pub fn commas(words: &str) -> String {
    let chars: Vec<char> = words.chars().collect();
    let figure = |i: usize| chars.get(i).is_some_and(char::is_ascii_digit);
    let of = |(i, c): (usize, &char)| {
        if *c == '.' && i > 0 && figure(i - 1) && figure(i + 1) { ',' } else { *c }
    };
    chars.iter().enumerate().map(of).collect()
}
