//! Rows that one thread takes at a time.

use super::super::stop;
use super::filled::{Cited, Filled};
use super::line::{RowMessages, RowWriter, write_row};
use super::rows::Chunk;
use super::run::Run;
use crate::pipeline::VariantSolver;
use rayon::prelude::*;
use std::ops::Range;
use std::sync::{Mutex, PoisonError};

/// Rows that one thread takes at a time, at least; of motions under loads, which take longer, one.
const PIECE: usize = 32;
/// The number of pieces of a large chunk.
const PIECES: usize = 64;

#[derive(Default)]
pub struct Piece<'r> {
    pub out: String,
    /// Columns of answers, where they are written as such.
    pub filled: Option<Filled<'r>>,
    /// Lines of the key.
    pub key: String,
    /// The messages about each row, by its number.
    pub said: Vec<(usize, RowMessages)>,
    /// No signal came before its last row.
    pub whole: bool,
}

impl<'r> Run<'r> {
    /// Solves the rows of a chunk on all threads; the pieces come in order.
    pub(super) fn chunk(&self, chunk: &Chunk<'_>, idle: &SolverPool<'r>) -> Vec<Piece<'r>> {
        let size = (chunk.len() / PIECES).max(if self.job.moves() { 1 } else { PIECE });
        let pieces: Vec<Range<usize>> =
            (0..chunk.len()).step_by(size).map(|start| start..(start + size).min(chunk.len())).collect();
        let solved = |range| {
            let mut family = idle.take().unwrap_or_else(|| self.job.family(Some(self.format)));
            let piece = self.piece(&mut family, chunk, range);
            idle.give(family);
            piece
        };
        pieces.into_par_iter().map(solved).collect()
    }

    fn piece(&self, family: &mut VariantSolver<'r>, chunk: &Chunk<'_>, range: Range<usize>) -> Piece<'r> {
        let filled = self.columns.then(|| Filled::of(self.job));
        let mut piece = Piece { whole: true, filled, ..Piece::default() };
        let (mut head, mut cells, mut old) = (String::new(), Vec::new(), None);
        for index in range {
            if stop::wanted() {
                piece.whole = false;
                break;
            }
            let before = (piece.out.len(), piece.key.len());
            let filled_before = piece.filled.as_ref().map_or(0, |filled| filled.answers.len());
            let mut written = RowWriter {
                job: self.job,
                format: self.format,
                layout: self.layout,
                key: self.key,
                out: &mut piece.out,
                filled: piece.filled.as_mut(),
                key_out: &mut piece.key,
                head: &mut head,
                cells: &mut cells,
            };
            let said = match chunk.get(index, (&self.job.columns, self.job.digits), old.take()) {
                Ok(input) => {
                    let said = write_row(self.job, &mut written, family, &input);
                    (old.insert(input).number, said)
                }
                Err((number, fault)) => {
                    let (label, cells) = chunk.as_written(index);
                    let row = Cited { number, label: label.as_deref(), written: &cells, row: None };
                    (number, written.fault(&row, fault))
                }
            };
            if self.job.moves() && stop::wanted() {
                // its motion may have been ended on the way
                piece.out.truncate(before.0);
                piece.key.truncate(before.1);
                piece.filled.iter_mut().for_each(|filled| filled.truncate(filled_before));
                piece.whole = false;
                break;
            }
            piece.said.push(said);
        }
        piece
    }
}

// What one thread has found out about the rows of a file serves the next.

/// Solvers that no thread uses at the moment: what one has found out about the rows serves the next.
#[derive(Default)]
pub struct SolverPool<'r>(Mutex<Vec<VariantSolver<'r>>>);

impl<'r> SolverPool<'r> {
    pub fn take(&self) -> Option<VariantSolver<'r>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).pop()
    }

    pub fn give(&self, solver: VariantSolver<'r>) {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).push(solver);
    }
}
