//! `assur course prairielearn`: a folder per problem.

use super::{Exercise, Failed, Piece, encoded};
use crate::cli::args::{Course, PictureArg};
use crate::cli::error::CliError;
use crate::cli::files::made_folder;
use crate::cli::folder_sink;
use crate::cli::variant_rows::ChosenRow;
use crate::handout::course::{Called, PrairieLearn, Quiz, Variant, question};
use std::path::Path;

/// What one question is at the most: rows, and bytes of the program with their table.
const MOST_ROWS: usize = 500;
const MOST_BYTES: usize = 2_000_000;
/// What is in the folder of a question.
const PARTS: [&str; 5] = ["info.json", "question.html", "server.py", "clientFilesQuestion", "solutions"];

/// Whether the options are those of PrairieLearn.
///
/// # Errors
/// An option of Moodle, or no folder to write to.
pub fn checked(args: &Course) -> Result<(), CliError> {
    if args.one_per_answer {
        return Err(CliError::NotOfPlatform { option: "--one-per-answer" });
    }
    if args.unit_penalty.is_some() {
        return Err(CliError::NotOfPlatform { option: "--unit-penalty" });
    }
    match args.out.as_deref() {
        None | Some("-") => Err(CliError::NoQuestionFolder),
        Some(_) => Ok(()),
    }
}

/// Whether the problems are small enough, before they are solved.
///
/// # Errors
/// A problem with too many rows.
pub(super) fn fit(exercises: &[Exercise]) -> Result<(), CliError> {
    let Some(long) = exercises.iter().find(|exercise| exercise.rows.len() > MOST_ROWS) else { return Ok(()) };
    Err(CliError::TooManyRows { name: long.name.clone(), rows: long.rows.len(), most: MOST_ROWS })
}

impl Exercise {
    pub(super) fn variant(&self, args: &Course, row: &ChosenRow, quiz: &Quiz) -> Result<Variant, Failed> {
        let ending = if args.picture == PictureArg::Png { "png" } else { "svg" };
        let place = self.rows.iter().position(|other| std::ptr::eq(other, row)).map_or(1, |i| i + 1);
        let of = PrairieLearn { ending, within: args.within };
        of.variant(quiz, &place.to_string(), &|svg| encoded(args.picture, svg))
    }
}

/// Writes the folders of all problems that have rows, each when it is complete.
///
/// # Errors
/// A question that is too large, or a folder that cannot be written.
pub(super) fn put(args: &Course, pieces: &[Piece<'_>], category: &str) -> Result<(), CliError> {
    let Some(folder) = args.out.as_deref().map(Path::new) else { return Ok(()) };
    let mut questions = Vec::new();
    for pieces in pieces.chunk_by(|a, b| a.exercise.name == b.exercise.name) {
        let Some(Exercise { name, title, .. }) = pieces.first().map(|piece| piece.exercise) else { continue };
        let called = Called { file: name, title, category };
        let rows: Vec<&Variant> = pieces.iter().flat_map(|piece| &piece.variants).collect();
        let files = question(called, &rows);
        let size = files.iter().find(|(name, _)| name == "server.py").map_or(0, |(_, bytes)| bytes.len());
        if size > MOST_BYTES {
            let (name, size, most) = (name.clone(), size / 1000, MOST_BYTES / 1000);
            return Err(CliError::TooLarge { name, size, most });
        }
        if !files.is_empty() {
            questions.push((folder.join(called.folder()), called.uuid(), files));
        }
    }
    if let Some((taken, ..)) = questions.iter().find(|(folder, uuid, _)| !is_free(folder, uuid)) {
        return Err(CliError::OtherQuestion { name: taken.display().to_string() });
    }
    if !questions.is_empty() {
        made_folder(folder)?;
    }
    questions.iter().try_for_each(|(folder, _, files)| folder_sink::put(folder, files))
}

/// Whether nothing is lost where this question is put: there is none, or an export of the same question and nothing else.
fn is_free(folder: &Path, uuid: &str) -> bool {
    if std::fs::symlink_metadata(folder).is_err() {
        return true;
    }
    let is_own = std::fs::read_to_string(folder.join("info.json")).is_ok_and(|info| info.contains(uuid));
    let is_known = |name: &std::ffi::OsStr| PARTS.iter().any(|part| name == *part);
    let entries = std::fs::read_dir(folder).into_iter().flatten();
    is_own && entries.flatten().all(|entry| is_known(&entry.file_name()))
}
