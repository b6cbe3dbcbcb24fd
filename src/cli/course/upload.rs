//! A file of questions for Moodle: written question by question, of a size that is known before.

use super::{Exercise, Failed, Piece};
use crate::cli::args::{Course, PictureArg};
use crate::cli::error::CliError;
use crate::cli::reply::complaint;
use crate::cli::screen::Screen;
use crate::cli::sink::Sink;
use crate::handout::course::{Chapter, Page, Steps};
use std::path::Path;

/// The size follows from this number of questions.
const SAMPLE: usize = 20;
/// A file beyond this size is named, and beyond the other refused, bytes: sites of Moodle take no more.
const LARGE: usize = 20_000_000;
const LARGEST: usize = 50_000_000;
const MEGABYTE: usize = 1_000_000;

pub struct Upload<'a> {
    args: &'a Course,
    screen: &'a Screen,
    page: Page<'a>,
    /// Rows of all problems, and how many of them have been added, with their questions and bytes.
    all: usize,
    rows: usize,
    questions: usize,
    size: usize,
    /// What is not written yet: all of it until the size is known, or where it is printed, since an error must not follow a part.
    held: String,
    sink: Option<Sink>,
    is_known: bool,
    is_said: bool,
}

impl<'a> Upload<'a> {
    pub fn new(args: &'a Course, category: &'a str, exercises: &[Exercise], screen: &'a Screen) -> Self {
        let all = exercises.iter().map(|exercise| exercise.rows.len()).sum();
        let (page, held, sink) = (Page::new(category), String::new(), None);
        let (rows, questions, size, is_known, is_said) = (0, 0, 0, false, false);
        Self { args, screen, page, all, rows, questions, size, held, sink, is_known, is_said }
    }

    pub const fn has_questions(&self) -> bool {
        self.page.end().is_some()
    }

    /// Takes the questions of rows.
    ///
    /// # Errors
    /// Two questions of one name, a file that is too large, or cannot be written.
    pub fn add(&mut self, piece: &mut Piece<'_>) -> Result<(), Failed> {
        let questions = std::mem::take(&mut piece.questions);
        self.rows += piece.rows.len();
        if questions.is_empty() {
            return Ok(());
        }
        let (file, title) = (&piece.exercise.name, &piece.exercise.title);
        let text = self.page.add(Chapter { file, title, questions: &questions })?;
        self.questions += questions.len();
        self.size += text.len();
        self.held += &text;
        if !self.is_known && self.questions >= SAMPLE {
            self.is_known = true;
            self.judge(self.size / self.rows * self.all)?;
        } else if self.size > LARGEST {
            self.judge(self.size)?;
        }
        if self.is_known && self.name().is_some() {
            let mut sink = self.sink()?;
            sink.write(&self.held)?;
            self.held.clear();
            self.sink = Some(sink);
        }
        Ok(())
    }

    /// Writes the end; whether all was read.
    ///
    /// # Errors
    /// It is too large, or cannot be written.
    pub fn finish(mut self, all: bool) -> Result<bool, CliError> {
        let Some(end) = self.page.end() else { return Ok(true) };
        self.judge(self.size)?;
        let mut sink = self.sink()?;
        sink.write(&self.held)?;
        sink.write(end)?;
        sink.finish_of(all)
    }

    fn name(&self) -> Option<&'a str> {
        self.args.out.as_deref().filter(|name| *name != "-")
    }

    fn sink(&mut self) -> Result<Sink, CliError> {
        match (self.sink.take(), self.name()) {
            (Some(sink), _) => Ok(sink),
            (None, Some(name)) => Sink::file(Path::new(name)),
            (None, None) => Ok(Sink::stdout()),
        }
    }

    /// Refuses a size that no site takes; names a large one once.
    fn judge(&mut self, size: usize) -> Result<(), CliError> {
        let megabytes = size.div_ceil(MEGABYTE);
        if size > LARGEST {
            let (rows, most) = (self.all, LARGEST / MEGABYTE);
            return Err(CliError::LargestUpload { rows, size: megabytes, most, help: self.smaller(size) });
        }
        if size > LARGE && !self.is_said {
            self.is_said = true;
            let error = CliError::LargeUpload { size: megabytes, help: self.smaller(size) };
            self.screen.complain(&complaint(error, self.screen));
        }
        Ok(())
    }

    /// The options that make a file of this size smaller.
    fn smaller(&self, size: usize) -> String {
        let mut all = Vec::new();
        if self.args.steps != Steps::None {
            all.push("`--steps none`".to_owned());
        }
        match self.args.picture {
            PictureArg::Png => all.push("`--picture svg`".to_owned()),
            PictureArg::Svg => all.push("`--picture none`".to_owned()),
            PictureArg::None => {}
        }
        if size > LARGEST && self.all > 1 {
            let rows = (LARGEST / (size / self.all).max(1)).max(1);
            all.push(format!("at most {rows} rows: by `--row`, or in a shorter table by `--variants`"));
        }
        format!("to make it smaller write {}", all.join(", or "))
    }
}
