//! What a sheet lacks: said before a class sees it.

use assur_syntax::document::Statement;
use assur_text::diagnostic::{Problem, Problems};
use assur_text::source::{Span, Spanned};
use assur_worked::{Block, Document, Exercise, Language};
use miette::Diagnostic;
use thiserror::Error;

/// Rows of a table that a page holds beside its text.
const MOST_ROWS: usize = 60;
/// Positions that a sheet asks at in a lesson.
const MOST_POSITIONS: usize = 40;
/// Columns of a strip of a table on a sheet.
const STRIP: usize = 12;

/// Something that a student would miss.
#[derive(Clone, Debug, Error, Diagnostic)]
pub enum Lack {
    #[error("the sheet has no figure: no scheme shows how the parts are joined")]
    #[diagnostic(
        severity(Warning),
        code(mech::sheet::no_figure),
        help("say in a text (`// …`) how they are joined, or hand a picture out")
    )]
    NoFigure,
    #[error("question {number} has no letter: the table of answers calls it ({number})")]
    #[diagnostic(severity(Warning), code(mech::sheet::no_letter))]
    NoLetter {
        number: usize,
        #[help]
        help: String,
        #[label("this formula")]
        span: Span,
    },
    #[error("`{words}` is in the text alone: nothing of the file has this value")]
    #[diagnostic(
        severity(Warning),
        code(mech::sheet::in_words_alone),
        help("write it as a `given`, or as a value of what it is about; or leave it out")
    )]
    InWordsAlone {
        words: String,
        #[label("this text")]
        span: Span,
    },
    #[error("the table of `{curve}` has {rows} rows: on a sheet it takes {strips} strips of 12 columns")]
    #[diagnostic(
        severity(Warning),
        code(mech::sheet::long_table),
        help("write fewer rows, or hand the table out as a file")
    )]
    LongTable {
        curve: String,
        rows: usize,
        strips: usize,
        #[label("this table")]
        span: Span,
    },
    #[error("the sheet asks at {count} positions")]
    #[diagnostic(
        severity(Warning),
        code(mech::sheet::many_positions),
        help("choose some by their names: --positions 1,4,8")
    )]
    ManyPositions { count: usize },
}

impl Problem for Lack {}

/// What the sheet of a file lacks.
pub(super) fn of(exercise: &Exercise<'_>, sheet: &Document, language: Language, problems: &mut Problems) {
    let is_scheme = |block: &Block| match block {
        Block::Figures(figures) => figures.iter().any(|figure| !figure.name.starts_with("table-")),
        _ => false,
    };
    let has_figure = sheet.blocks.iter().any(is_scheme);
    if exercise.mechanism.links.len() > 1 && !has_figure {
        problems.push(Lack::NoFigure);
    }
    problems.extend(exercise.formulas_without_letters(language).into_iter().map(|(number, span)| {
        let written = exercise.text.get(span.start..span.end).unwrap_or_default().trim();
        let help = format!("give it a name of one or two letters: `x = {written}`");
        Lack::NoLetter { number, help, span }
    }));
    let mut reported = Vec::new();
    for note in &exercise.document.notes {
        let alone = exercise.numbers_in_words_alone(&note.node);
        for words in alone.into_iter().filter(|words| !reported.contains(words)).collect::<Vec<_>>() {
            problems.push(Lack::InWordsAlone { words: words.clone(), span: note.span });
            reported.push(words);
        }
    }
    problems.extend(exercise.document.statements.iter().filter_map(long_table));
    if exercise.positions.len() > MOST_POSITIONS {
        problems.push(Lack::ManyPositions { count: exercise.positions.len() });
    }
}

fn long_table(statement: &Spanned<Statement>) -> Option<Lack> {
    let Statement::Curve(curve) = &statement.node else { return None };
    let rows = curve.table.rows.len();
    let (strips, span) = (rows.div_ceil(STRIP), curve.name.span);
    (rows > MOST_ROWS).then(|| Lack::LongTable { curve: curve.name.node.clone(), rows, strips, span })
}
