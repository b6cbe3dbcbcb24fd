//! `assur course`: an exercise set as questions of a learning platform.

mod prairielearn;
mod upload;

use super::args::{Course, PictureArg, Platform};
use super::error::CliError;
use super::files::{self, Input};
use super::reply::{Reply, Status, complaint, guarded, quiet_panics};
use super::report::folder_names;
use super::screen::Screen;
use super::stop::want_written;
use super::threads::Threads;
use super::variant_rows::{ChosenRow, Refused, RowsWanted, chosen_rows};
use crate::exercise::grade::{Credit, Points, Rules};
use crate::front::in_order::in_order;
use crate::handout::course::{
    CourseError, Moodle, Picture, Question, Quiz, QuizOptions, Variant, checked_credit,
};
use crate::handout::{Handout, Row, Sheets};
use assur_check::Overrides;
use assur_drawing::in_light;
use assur_syntax as syntax;
use assur_syntax::document::Document;
use assur_text::diagnostic::Problems;
use assur_text::source::Source;
use std::collections::BTreeSet;
use std::path::Path;
use std::sync::Arc;
use upload::Upload;

/// Rows that one thread takes at once: what they have in common is found once for all of them.
const PIECE: usize = 8;
/// The category where no folder has a name.
const NAMELESS: &str = "assur";
/// Pixels of a picture from left to right.
#[cfg(feature = "png")]
const WIDTH: u32 = 900;
const NOTHING_ASKED: &str = "mech::course::nothing_asked";

/// Writes questions: 1 where a row or a file is left out.
pub fn run(args: &Course, screen: &Screen) -> Status {
    quiet_panics();
    match written(args, screen) {
        Ok(status) => status,
        Err(error) => {
            screen.complain(&complaint(error, screen));
            Status::Unusable
        }
    }
}

/// A problem with its rows.
struct Exercise {
    source: Source,
    document: Arc<Document>,
    /// Its name in ids.
    name: String,
    /// The number and the title.
    title: String,
    rows: Vec<ChosenRow>,
}

/// Rows of a problem, and what became of them.
struct Piece<'a> {
    exercise: &'a Exercise,
    rows: &'a [ChosenRow],
    /// What was found in its rows.
    problems: Problems,
    /// An error that has no place in the text.
    reply: Reply,
    questions: Vec<(String, Question)>,
    /// The same for PrairieLearn.
    variants: Vec<Variant>,
    /// The names of what is asked.
    names: BTreeSet<String>,
    verdicts: Vec<String>,
}

fn written(args: &Course, screen: &Screen) -> Result<Status, CliError> {
    let rules = Rules {
        within: args.within,
        points: args.points.iter().cloned().fold(Points::default(), Points::and),
        credit: args.credit.iter().cloned().fold(Credit::default(), Credit::and),
        ..Rules::default()
    };
    let no_pixels = args.picture == PictureArg::Png && !cfg!(feature = "png");
    let is_moodle = args.platform == Platform::Moodle;
    if !is_moodle {
        prairielearn::checked(args)?;
    }
    let refused = checked_credit(&rules.credit)
        .err()
        .filter(|_| is_moodle)
        .or(no_pixels.then_some(CourseError::NoPixels));
    if let Some(error) = refused {
        screen.complain(&complaint(error, screen));
        return Ok(Status::Unusable);
    }
    args.variants.iter().for_each(|name| files::keep(Path::new(name)));
    let inputs = files::expand(&args.files);
    let parent = args.category.clone().unwrap_or_else(|| folder_of(&args.files, &inputs));
    let (exercises, mut status) = exercises(args, inputs, screen);
    if !is_moodle {
        prairielearn::fit(&exercises)?;
    }
    if args.out.as_deref().is_some_and(|name| name != "-") {
        want_written(if is_moodle { 1 } else { exercises.len() });
    }
    let mut upload = Upload::new(args, &parent, &exercises, screen);
    let (pieces, failed) =
        pieces(args, &rules, &exercises, screen, |piece| if is_moodle { upload.add(piece) } else { Ok(()) });
    for pieces in pieces.chunk_by(|a, b| a.exercise.name == b.exercise.name) {
        status = status.max(reported(pieces, screen));
    }
    let known: Vec<&str> = pieces.iter().flat_map(|p| p.names.iter().map(String::as_str)).collect();
    if let Some((name, help)) = rules.points.unknown_in(&known).filter(|_| !known.is_empty()) {
        return Err(CliError::NoQuantity { name: name.to_owned(), help });
    }
    if !is_moodle {
        warn(&pieces, screen);
        prairielearn::put(args, &pieces, &parent)?;
        return Ok(status);
    }
    match failed {
        Some(Failed::Course(error)) => {
            screen.complain(&complaint(error, screen));
            return Ok(status.max(Status::Wrong));
        }
        Some(Failed::Cli(error)) => return Err(error),
        None => {}
    }
    if upload.has_questions() {
        warn(&pieces, screen);
    }
    let all = status != Status::Unusable;
    upload.finish(all).map(|whole| status.max(Status::printed(whole)))
}

/// All rows, piece by piece in their order, until one cannot be used.
fn pieces<'e>(
    args: &Course,
    rules: &Rules,
    exercises: &'e [Exercise],
    screen: &Screen,
    mut take: impl FnMut(&mut Piece<'e>) -> Result<(), Failed>,
) -> (Vec<Piece<'e>>, Option<Failed>) {
    let rows: Vec<_> =
        exercises.iter().flat_map(|one| one.rows.chunks(PIECE).map(move |rows| (one, rows))).collect();
    let work = |number: usize, made: &mut Option<Piece<'e>>| {
        let (exercise, rows) = rows[number];
        made.insert(Piece::of(exercise, rows)).fill(args, rules, screen);
    };
    let (mut pieces, mut failed) = (Vec::new(), None);
    let hand_out = |made: &mut Option<Piece<'e>>| {
        let Some(mut piece) = made.take() else { return true };
        failed = take(&mut piece).err();
        pieces.push(piece);
        failed.is_none()
    };
    in_order(&Threads::new(args.threads), rows.len(), &|| None, work, hand_out);
    (pieces, failed)
}

/// The problems of all inputs; what is wrong with the others is reported.
fn exercises(
    args: &Course,
    inputs: Vec<Result<Input, CliError>>,
    screen: &Screen,
) -> (Vec<Exercise>, Status) {
    let names = folder_names(&inputs);
    let (mut exercises, mut status) = (Vec::new(), Status::Fine);
    for (number, input) in (1..).zip(inputs) {
        let exercise = input.and_then(Input::read).map(|source| {
            let name = names.get(&source.name).cloned().unwrap_or_else(|| "problem".to_owned());
            exercise(args, (source, name, number), screen)
        });
        match exercise.unwrap_or_else(|error| Err(Reply::unusable(error, screen))) {
            Ok(exercise) => exercises.push(exercise),
            Err(reply) => {
                screen.complain(&reply.diagnostics);
                status = status.max(reply.status);
            }
        }
    }
    (exercises, status)
}

/// Says what was found in the rows of a problem, no more than is wanted.
fn reported(pieces: &[Piece<'_>], screen: &Screen) -> Status {
    let Some(first) = pieces.first() else { return Status::Fine };
    let mut problems = Problems::new();
    for piece in pieces {
        let is_known = problems.has(NOTHING_ASKED) && piece.problems.has(NOTHING_ASKED);
        problems.append(if is_known { Problems::new() } else { piece.problems.clone() });
    }
    let reply = Reply::new(String::new(), &problems, &first.exercise.source, screen);
    screen.complain(&reply.diagnostics);
    pieces.iter().for_each(|piece| screen.complain(&piece.reply.diagnostics));
    pieces.iter().map(|piece| piece.reply.status).fold(reply.status, Status::max)
}

/// Questions without a number, once per problem.
fn warn(pieces: &[Piece<'_>], screen: &Screen) {
    let mut said = BTreeSet::new();
    for piece in pieces {
        let source = &piece.exercise.source;
        let new = piece.verdicts.iter().filter(|name| said.insert((&source.name, (*name).clone())));
        let found =
            Problems::of(new.map(|name| CourseError::VerdictIsNoNumber {
                file: source.name.clone(),
                name: name.clone(),
            }));
        screen.complain(&screen.diagnostics(&found, source));
    }
}

/// The name of the folder that the command line names, or that the first file is in.
fn folder_of(named: &[String], inputs: &[Result<Input, CliError>]) -> String {
    let folder = named.iter().map(Path::new).find(|path| path.is_dir());
    let first = inputs.iter().flatten().find_map(|input| input.path()?.parent());
    let name = folder.or(first).and_then(Path::file_name);
    name.map_or_else(|| NAMELESS.to_owned(), |name| name.to_string_lossy().into_owned())
}

/// A problem with its rows and its title; what is wrong with it where there is none.
fn exercise(
    args: &Course,
    (source, name, number): (Source, String, usize),
    screen: &Screen,
) -> Result<Exercise, Reply> {
    let (document, found) = syntax::parse(&source);
    if found.has_errors() {
        return Err(Reply::new(String::new(), &found, &source, screen));
    }
    let document = Arc::new(document);
    let overrides = args.overrides();
    let wanted = RowsWanted { variants: args.variants.as_deref(), row: &args.row, all: true };
    let rows = match chosen_rows(wanted, &overrides, &source, &document) {
        Ok(rows) => rows,
        Err(Refused::Table(table, found)) => return Err(Reply::new(String::new(), &found, &table, screen)),
        Err(Refused::Cli(error)) => return Err(Reply::unusable(error, screen)),
    };
    let handout =
        Handout::new(&source, Arc::clone(&document), overrides, args.language.into(), args.pose.as_deref())
            .at(&args.positions);
    let title = Sheets::of_rows(&handout, rows_of(&rows)).title().unwrap_or_else(|| name.clone());
    let digits: String = name.chars().take_while(char::is_ascii_digit).collect();
    let number = if digits.is_empty() || digits.len() > 6 { format!("{number:02}") } else { digits };
    Ok(Exercise { title: format!("{number} {title}"), source, document, name, rows })
}

fn rows_of(rows: &[ChosenRow]) -> Vec<Row> {
    let of = |(number, row): (usize, &ChosenRow)| {
        Row::new(number, Some(row.name.clone()).filter(|name| !name.is_empty()), row.overrides.clone())
    };
    (1..).zip(rows).map(of).collect()
}

impl<'a> Piece<'a> {
    fn of(exercise: &'a Exercise, rows: &'a [ChosenRow]) -> Self {
        Self {
            exercise,
            rows,
            problems: Problems::new(),
            reply: Reply::default(),
            questions: Vec::new(),
            variants: Vec::new(),
            names: BTreeSet::new(),
            verdicts: Vec::new(),
        }
    }

    /// Makes the questions of its rows. A row that cannot be solved is reported and left out.
    fn fill(&mut self, args: &Course, rules: &Rules, screen: &Screen) {
        let Exercise { source, document, .. } = self.exercise;
        let overrides = Overrides { values: args.overrides().values, ..Overrides::none() };
        let pose = args.pose.as_deref();
        let handout = Handout::new(source, Arc::clone(document), overrides, args.language.into(), pose)
            .at(&args.positions);
        let rows = rows_of(self.rows);
        let options =
            QuizOptions { rules, steps: &args.steps, pictures: Picture::from(args.picture) != Picture::None };
        let mut failed = None;
        let mut at = self.rows.iter();
        let exercise = self.exercise;
        let (questions, variants) = (&mut self.questions, &mut self.variants);
        let (names, verdicts) = (&mut self.names, &mut self.verdicts);
        let problems = &mut self.problems;
        let mut reply = guarded(source, screen, |_| {
            Sheets::of_rows(&handout, Vec::new()).quizzes(&rows, options, |_, quiz, mut found| {
                let Some(row) = at.next() else { return false };
                if let Some(quiz) = quiz {
                    let made = match args.platform {
                        Platform::Moodle => exercise.questions(args, row, &quiz).map(|new| {
                            questions.extend(new.into_iter().map(|one| (row.name.clone(), one)));
                        }),
                        Platform::PrairieLearn => {
                            exercise.variant(args, row, &quiz).map(|new| variants.push(new))
                        }
                    };
                    match made {
                        Ok(()) => {}
                        Err(Failed::Course(error)) => found.push(error),
                        Err(Failed::Cli(error)) => failed = Some(error),
                    }
                    names.extend(quiz.names);
                    verdicts.extend(quiz.verdicts);
                }
                if !found.has(NOTHING_ASKED) {
                    problems.append(row.reported(found));
                } else if !problems.has(NOTHING_ASKED) {
                    // it is so for all rows
                    problems.append(found);
                }
                failed.is_none()
            });
            Reply::default()
        });
        if let Some(error) = failed {
            reply.diagnostics += &complaint(error, screen);
            reply.status = Status::Unusable;
        }
        self.reply = reply;
    }
}

/// Why a row has no question, or there is no file of questions.
enum Failed {
    Course(CourseError),
    Cli(CliError),
}

impl From<CourseError> for Failed {
    fn from(error: CourseError) -> Self {
        Self::Course(error)
    }
}

impl From<CliError> for Failed {
    fn from(error: CliError) -> Self {
        Self::Cli(error)
    }
}

impl Exercise {
    fn questions(&self, args: &Course, row: &ChosenRow, quiz: &Quiz) -> Result<Vec<Question>, Failed> {
        let moodle = Moodle {
            file: &self.name,
            title: &self.title,
            row: if row.name.is_empty() { "1" } else { &row.name },
            several: !row.name.is_empty(),
            pose: args.pose.as_deref(),
            one_per_answer: args.one_per_answer,
            unit_penalty: args.unit_penalty.unwrap_or(1.0),
            picture: args.picture.into(),
        };
        moodle.questions(quiz, &|svg| encoded(args.picture, svg))
    }
}

/// The bytes of a picture: a page of a platform is never dark.
fn encoded(picture: PictureArg, svg: &str) -> Result<Vec<u8>, Failed> {
    let light = in_light(svg);
    #[cfg(feature = "png")]
    if picture == PictureArg::Png {
        return super::draw::png_of_width(&light, WIDTH).map_err(Failed::Cli);
    }
    let _ = picture;
    Ok(light.into_bytes())
}
