//! Columns of positions of which none depends on another, written by all threads where they end up.

use super::stages::{InOrder, Job, Stage, Stages, work};
use super::workers::{Alone, Workers};
use crate::report::{Answers, NumberRows};
use assur_solve::solve::{BLOCK, Block, UpcomingPositions, finite};
use std::collections::VecDeque;
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};

/// Blocks that a thread works on at a time, where there are several threads: handing them over takes little beside the work.
const BLOCKS: usize = 8;
/// Fewer positions are not worth to start threads for.
const FEWEST: usize = 8 * BLOCKS * BLOCK;
/// So many positions are solved before the workers are asked whether to go on.
const ASKED: usize = 4096;
/// Residuals and condition.
pub(super) const OWN: usize = 4;

/// What the columns are made of.
pub(super) struct SideBySide<'s> {
    pub answers: &'s Answers<'s>,
    pub ahead: UpcomingPositions<'s>,
    pub rows: &'s NumberRows,
    /// The columns show angles.
    pub angles: bool,
    pub workers: &'s dyn Workers,
}

impl SideBySide<'_> {
    /// Writes columns, as far as `take` takes the positions over. Returns how many these are, and whether the workers want to go on.
    pub fn write(self, columns: Vec<&mut [f64]>, take: &mut dyn FnMut(&mut Block) -> bool) -> (usize, bool) {
        let count = self.ahead.count();
        let workers = if count < FEWEST { &Alone } else { self.workers };
        let size = if workers.threads() < 2 { BLOCK } else { BLOCKS * BLOCK };
        let pieces = count.div_ceil(size);
        let mut places: Vec<Places<'_>> = (0..pieces).map(|_| Vec::with_capacity(columns.len())).collect();
        for column in columns {
            places.iter_mut().zip(column.chunks_mut(size)).for_each(|(places, part)| places.push(part));
        }
        let places = places.into_iter().map(Mutex::new).collect();
        let mut order = Taking { take, workers: self.workers, taken: 0, asked: 0 };
        let goes_on = work(workers, pieces, &Writing { positions: self, size, places }, &mut order);
        (order.taken, goes_on)
    }
}

/// Where the numbers of some positions go, column by column.
type Places<'c> = Vec<&'c mut [f64]>;

struct Writing<'s, 'c> {
    positions: SideBySide<'s>,
    size: usize,
    places: Vec<Mutex<Places<'c>>>,
}

/// Some positions.
#[derive(Default)]
struct Piece {
    number: usize,
    blocks: Vec<Block>,
    /// The columns have them.
    is_written: bool,
    row: Vec<f64>,
}

impl Stages for Writing<'_, '_> {
    type Piece = Piece;

    fn piece(&self) -> Piece {
        Piece::default()
    }

    fn begin(&self, number: usize, piece: &mut Piece) {
        let ahead = self.positions.ahead.behind(number * self.size);
        piece.number = number;
        piece.blocks.resize_with(ahead.count().min(self.size).div_ceil(BLOCK), Block::default);
        // angles depend on the positions before: others are written while the states are at hand
        piece.is_written = self.positions.rows.wide().is_some() || !self.positions.angles;
        let mut places = self.places[number].lock().unwrap_or_else(PoisonError::into_inner);
        for (i, block) in piece.blocks.iter_mut().enumerate() {
            ahead.solve(block, i * BLOCK);
            if piece.is_written {
                self.positions.write_block(block, &mut piece.row, i * BLOCK, &mut places);
            }
        }
    }

    fn is_finished(&self, piece: &Piece) -> bool {
        piece.is_written
    }

    fn finish(&self, piece: &mut Piece) {
        let mut places = self.places[piece.number].lock().unwrap_or_else(PoisonError::into_inner);
        for (i, block) in piece.blocks.iter_mut().enumerate() {
            self.positions.write_block(block, &mut piece.row, i * BLOCK, &mut places);
        }
    }
}

impl SideBySide<'_> {
    /// Writes the columns of a block from a place on.
    fn write_block(&self, block: &mut Block, row: &mut Vec<f64>, at: usize, places: &mut Places<'_>) {
        let answers = places.len() - OWN;
        let (cells, own) = places.split_at_mut(answers);
        if let Ok(own) = <&mut [&mut [f64]; OWN]>::try_from(own) {
            block.write_quality(&self.answers.model, at, own.each_mut().map(|column| &mut **column));
        }
        if let Some(columns) = self.rows.wide() {
            let places = at..at + block.len();
            return block.write(columns, &mut cells.iter_mut().map(|column| &mut column[places.clone()]));
        }
        self.ahead.answer(block, self.angles);
        for (i, pose) in block.poses().iter().enumerate() {
            self.rows.read(self.answers, pose, row);
            cells.iter_mut().zip(&*row).for_each(|(column, x)| column[at + i] = finite(*x));
        }
    }
}

/// Takes positions over in their order.
struct Taking<'t> {
    take: &'t mut dyn FnMut(&mut Block) -> bool,
    workers: &'t dyn Workers,
    taken: usize,
    /// How many were taken when the workers were asked.
    asked: usize,
}

impl InOrder<Piece> for Taking<'_> {
    fn between(&mut self, piece: &mut Piece) -> bool {
        for i in 0..piece.blocks.len() {
            let whole = (self.take)(&mut piece.blocks[i]);
            self.taken += piece.blocks[i].len();
            if !whole {
                piece.blocks.truncate(i + 1);
                return false;
            }
        }
        true
    }

    fn end(&mut self, _: &mut Piece) -> bool {
        if self.taken < self.asked + ASKED {
            return true;
        }
        self.asked = self.taken;
        self.workers.goes_on()
    }
}

// Where pieces of work wait: for a thread, or for their turn.

/// Jobs that wait for a thread.
pub(super) struct Waiting<P> {
    jobs: Mutex<Jobs<P>>,
    more: Condvar,
}

struct Jobs<P> {
    new: VecDeque<Job<P>>,
    begun: VecDeque<Job<P>>,
    ended: bool,
}

impl<P> Default for Waiting<P> {
    fn default() -> Self {
        let jobs = Jobs { new: VecDeque::new(), begun: VecDeque::new(), ended: false };
        Self { jobs: Mutex::new(jobs), more: Condvar::new() }
    }
}

impl<P> Jobs<P> {
    /// New ones first: what is done with all of them in their order waits for them.
    fn next(&mut self) -> Option<Job<P>> {
        self.new.pop_front().or_else(|| self.begun.pop_front())
    }
}

impl<P> Waiting<P> {
    fn lock(&self) -> MutexGuard<'_, Jobs<P>> {
        self.jobs.lock().unwrap_or_else(PoisonError::into_inner)
    }

    pub fn put(&self, job: Job<P>) {
        let mut jobs = self.lock();
        if job.stage == Stage::New {
            jobs.new.push_back(job)
        } else {
            jobs.begun.push_back(job)
        }
        drop(jobs);
        self.more.notify_one();
    }

    /// The next job, if one waits.
    pub fn take(&self) -> Option<Job<P>> {
        self.lock().next()
    }

    /// The next job, once there is one; none at the end.
    pub fn wait(&self) -> Option<Job<P>> {
        let mut jobs = self.lock();
        loop {
            if jobs.ended {
                return None;
            }
            if let Some(job) = jobs.next() {
                return Some(job);
            }
            jobs = self.more.wait(jobs).unwrap_or_else(PoisonError::into_inner);
        }
    }

    /// Lets those go who wait.
    pub fn end(&self) {
        self.lock().ended = true;
        self.more.notify_all();
    }
}

/// Pieces that come in any order, taken in theirs.
pub(super) struct Line<P> {
    /// The number of the next one.
    first: usize,
    jobs: VecDeque<Option<Job<P>>>,
}

impl<P> Default for Line<P> {
    fn default() -> Self {
        Self { first: 0, jobs: VecDeque::new() }
    }
}

impl<P> Line<P> {
    pub const fn first(&self) -> usize {
        self.first
    }

    pub fn put(&mut self, job: Job<P>) {
        let place = job.number - self.first;
        if self.jobs.len() <= place {
            self.jobs.resize_with(place + 1, || None);
        }
        self.jobs[place] = Some(job);
    }

    /// The next one, if it has come.
    pub fn take(&mut self) -> Option<Job<P>> {
        let job = self.jobs.front_mut()?.take()?;
        self.jobs.pop_front();
        self.first += 1;
        Some(job)
    }
}
