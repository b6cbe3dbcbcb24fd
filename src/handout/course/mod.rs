//! Rows of variants as questions for a learning platform: what is shown, gaps with what answers mean, the worked solution.

mod moodle;
mod page;
mod pint;
mod prairielearn;
mod units;
mod uuid;

pub use moodle::{Chapter, Moodle, Page, Picture, Question, checked_credit};
pub use prairielearn::{Called, Part as FilePart, PrairieLearn, Variant, question};
use units::accepted;

use super::Sheets;
use super::lacks;
use super::places;
use super::sheets::{Made, Row};
use super::worked::document_with;
use crate::exercise::grade::{Piece, Quantity, Rules, Sheet, pieces, regions};
use crate::exercise::table::Fault;
use crate::report::Answers;
use crate::report::rows::{AnswerColumns, FULL, write_text};
use assur_solve::solve::Pose;
use assur_text::diagnostic::{Problem, Problems};
use assur_text::source::Source;
use assur_text::units::Unit;
use assur_worked::{Block, Document, Gap, GapSheet, Language, Part, gaps, verdict, without_pictures};
use miette::Diagnostic;
use std::cell::Cell;
use thiserror::Error;

/// Gaps of one question at the most.
const MOST_GAPS: usize = 40;
/// Intervals of a gap at the most, the right ones and those with a part of the points aside.
const MOST_SLIPS: usize = 24;
/// The pictures of a solution take no more, bytes.
const MOST_PICTURES: usize = 80_000;

/// Why there is no question.
#[derive(Clone, Debug, Error, Diagnostic)]
pub enum CourseError {
    #[error("Moodle knows 0.4 and 0.3333333 as parts of a mark, not {part}")]
    #[diagnostic(code(mech::course::part_not_allowed))]
    PartNotAllowed {
        part: f64,
        #[help]
        help: String,
    },
    #[error("`{file}` asks for nothing that has a number")]
    #[diagnostic(code(mech::course::nothing_asked), help("add `find …`"))]
    NothingAsked { file: String },
    #[error("two rows are named `{row}` in the category `{category}`")]
    #[diagnostic(code(mech::course::same_idnumber), help("name the rows apart, or give --category"))]
    SameIdNumber { row: String, category: String },
    #[error("this build draws no PNG")]
    #[diagnostic(
        code(mech::course::no_pixels),
        help("write `--picture svg`, or install assur with it: `cargo install --path . --features png`")
    )]
    NoPixels,
    #[error("`{name}` of `{file}` is a verdict, not a number: it is left out")]
    #[diagnostic(
        code(mech::course::verdict_is_no_number),
        severity(Warning),
        help("ask for a number as well, such as an efficiency")
    )]
    VerdictIsNoNumber { file: String, name: String },
    #[error("`{file}` asks for {count} numbers in one question, and {MOST_GAPS} are the most")]
    #[diagnostic(
        code(mech::course::too_many_gaps),
        help(
            "choose positions by --positions 1,4,8 or --pose NAME, or leave questions out by --points NAME=0"
        )
    )]
    TooManyGaps { file: String, count: usize },
    #[error("the points {points} are not in the ratio of whole numbers up to 100")]
    #[diagnostic(code(mech::course::points_not_whole), help("write whole numbers, e.g. --points Mb=2,F_A=1"))]
    PointsNotWhole { points: String },
}

impl Problem for CourseError {}

/// Which parts of the worked solution are shown after the answer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Steps {
    /// All, with pictures.
    All,
    /// These, without pictures.
    Parts(Vec<Part>),
    None,
}

/// How questions are made.
#[derive(Clone, Copy, Debug)]
pub struct QuizOptions<'a> {
    pub rules: &'a Rules,
    pub steps: &'a Steps,
    pub pictures: bool,
}

/// An interval in the unit of a gap, and what is said of an answer in it.
#[derive(Clone, Debug)]
pub struct Interval {
    pub middle: f64,
    pub half: f64,
    pub words: String,
    /// The part of the points that it gets.
    pub part: f64,
}

/// A gap with its points.
#[derive(Clone, Debug)]
pub struct QuizGap {
    pub gap: Gap,
    pub unit: Unit,
    /// All units that the file has for this kind of quantity.
    pub units: Vec<Unit>,
    pub points: f64,
    /// The right one first; the first that holds an answer counts.
    pub intervals: Vec<Interval>,
}

/// A row as a question.
#[derive(Clone, Debug)]
pub struct Quiz {
    pub language: Language,
    /// Statement, scheme, given values, and the list of questions last.
    pub sheet: Document,
    pub gaps: Vec<QuizGap>,
    /// The worked solution.
    pub solution: Option<Document>,
    /// The names that points can have.
    pub names: Vec<String>,
    /// Questions without a number, which are left out.
    pub verdicts: Vec<String>,
}

impl Sheets<'_> {
    /// Rows as questions, one after another, each with what is wrong in it, until `goes_on` says no.
    pub fn quizzes(
        &self,
        rows: &[Row],
        options: QuizOptions<'_>,
        goes_on: impl FnMut(&Row, Option<Quiz>, Problems) -> bool,
    ) {
        let is_first = Cell::new(true);
        let quiz = |made: &Made<'_>, problems: &mut Problems| {
            let quiz = self.quiz(made, options, problems)?;
            if options.pictures && is_first.replace(false) {
                lacks::of(made.exercise, &quiz.sheet, self.handout.language, problems);
            }
            Some(quiz)
        };
        self.each_made(rows, quiz, goes_on);
    }

    fn quiz(&self, made: &Made<'_>, options: QuizOptions<'_>, problems: &mut Problems) -> Option<Quiz> {
        let language = self.handout.language;
        let GapSheet { document: mut sheet, gaps, verdicts } =
            gaps(made.exercise, language, options.pictures);
        if !options.pictures {
            // a remark is about the picture
            sheet.blocks.retain(|block| !matches!(block, Block::Figures(_) | Block::Remark(_)));
        }
        let scored = scored(made, gaps, options.rules, language);
        let (gaps, names) = scored.map_err(|fault| problems.push(*fault.1)).ok()?;
        let count = gaps.len();
        if count == 0 || count > MOST_GAPS {
            let file = self.handout.source.name.clone();
            problems.push(match count {
                0 => CourseError::NothingAsked { file },
                count => CourseError::TooManyGaps { file, count },
            });
            return None;
        }
        let solution = self.solution(made, options);
        Some(Quiz { language, sheet, gaps, solution, names, verdicts })
    }

    fn solution(&self, made: &Made<'_>, options: QuizOptions<'_>) -> Option<Document> {
        let parts: &[Part] = match options.steps {
            Steps::None => return None,
            Steps::All => &[],
            Steps::Parts(parts) => parts,
        };
        let (handout, language) = (self.handout, self.handout.language);
        let (at, replaced) = ((handout.pose, parts), made.exercise.replaced);
        let solution =
            document_with(handout.source, &handout.document, made.drawn, language, at, replaced).ok()?;
        if !options.pictures || *options.steps != Steps::All {
            return Some(solution.without_figures());
        }
        let size = |block: &Block| match block {
            Block::Figures(figures) => figures.iter().map(|figure| figure.svg.len()).sum(),
            _ => 0,
        };
        let is_large = solution.blocks.iter().map(size).sum::<usize>() > MOST_PICTURES;
        Some(if is_large { without_pictures(solution, language) } else { solution })
    }
}

/// Gaps with what the marker of `grade` says of their answers; those without a number or without points are left out.
fn scored(
    made: &Made<'_>,
    gaps: Vec<Gap>,
    rules: &Rules,
    language: Language,
) -> Result<(Vec<QuizGap>, Vec<String>), Fault> {
    // what needs no position has a line of its own beside several
    let shown = made.exercise.scene.filter(|_| made.exercise.positions.len() <= 1);
    let shown = shown.map(|scene| scene.pose.name.as_str());
    let pose_of = |gap: &Gap| {
        let name = gap.position.as_ref().map(|[name, _]| name.as_str()).or(shown)?;
        made.pose(name)
    };
    let mut poses: Vec<Option<&Pose>> = Vec::new();
    let mut at = Vec::new();
    for gap in &gaps {
        let pose = pose_of(gap);
        let known = poses.iter().position(|known| known.map(|p| &p.name) == pose.map(|p| &p.name));
        at.push(known.unwrap_or(poses.len()));
        poses.extend(known.is_none().then_some(pose));
    }
    if gaps.is_empty() {
        return Ok(Default::default());
    }
    let key = key(made.answers, &poses)?;
    let of = |(gap, row): (Gap, usize)| {
        let place = key.quantities.iter().position(|quantity| quantity.name == gap.name)?;
        let quantity = &key.quantities[place];
        let points = rules.points.of(&key, key.rows.get(row)?, place);
        let regions = regions(&key, row, place, rules);
        let intervals = intervals(&pieces(&regions), quantity, rules, language);
        let alike = key.quantities.iter().filter(|q| q.unit.dimension.fits(quantity.unit.dimension));
        let units = alike.map(|q| q.unit.clone()).collect();
        let is_asked = points > 0.0 && !intervals.is_empty();
        is_asked.then(|| QuizGap { gap, unit: quantity.unit.clone(), units, points, intervals })
    };
    let names = key.quantities.iter().map(|q| q.name.clone()).collect();
    let mut scored: Vec<QuizGap> = gaps.into_iter().zip(at).filter_map(of).collect();
    for gap in &mut scored {
        let Some([name, words]) = &mut gap.gap.position else { continue };
        let drives = made.pose(name).map_or_else(Vec::new, |pose| places::drives_at(made.answers, pose));
        if !drives.is_empty() {
            *words += &format!(" ({})", places::in_words(&drives));
        }
    }
    Ok((scored, names))
}

/// The answer key of a row as `assur batch --key` writes it, a line per position.
fn key(answers: &Answers<'_>, poses: &[Option<&Pose>]) -> Result<Sheet, Fault> {
    let columns = AnswerColumns::of(&answers.model);
    let mut text = "row".to_owned();
    for header in columns.headers(true) {
        text.push(',');
        write_text(&header, &mut text);
    }
    if let Some(cells) = columns.counted_turns(answers.model.mechanism) {
        text += &format!("\nturns{cells}");
    }
    let (whole, greatest) = (columns.whole(answers), answers.greatest());
    let mut cells = Vec::new();
    for (i, pose) in poses.iter().enumerate() {
        text += &format!("\n{i}");
        cells.clear();
        columns.write(answers, (*pose, &whole), (FULL, true, Some(&greatest)), &mut cells);
        text.push_str(std::str::from_utf8(&cells).unwrap_or_default());
    }
    let unread = |error: std::io::Error| {
        let empty = crate::exercise::table::TableError::Empty { what: "no key", span: None };
        (Source::new("key", error.to_string()), Box::new(empty))
    };
    Sheet::read("key", text.as_bytes(), None).map_err(unread)?
}

/// Pieces in the unit of a quantity: the right ones, then the slips that have a part of the points, then the commonest others.
fn intervals(pieces: &[Piece<'_>], of: &Quantity, rules: &Rules, language: Language) -> Vec<Interval> {
    let part = |piece: &Piece<'_>| piece.slip.map_or(1.0, |slip| rules.credit.of(slip));
    let mut kept: Vec<&Piece<'_>> = pieces.iter().collect();
    kept.sort_by_key(|piece| piece.slip.map(|slip| (part(piece) == 0.0, slip.rank())));
    let right = kept.iter().take_while(|piece| piece.slip.is_none()).count();
    let earning = kept[right..].iter().take_while(|piece| part(piece) > 0.0).count();
    let interval = |piece: &Piece<'_>| Interval {
        middle: of.unit.from_si(piece.middle),
        half: of.unit.from_si(piece.half),
        words: verdict(language, piece.slip.map(|slip| slip.words()).as_deref()),
        part: part(piece),
    };
    kept.into_iter().take(right + earning.max(MOST_SLIPS)).map(interval).collect()
}
