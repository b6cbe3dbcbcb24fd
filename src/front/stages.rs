//! Pieces of work in two stages on several threads, with something that is done here and in their order between the stages, and behind
//! them. A piece stays with one thread, and so does its memory: that thread has them in its cache.

use super::side_by_side::{Line, Waiting};
use super::workers::Workers;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, Sender, channel};

/// What is done with every piece.
pub trait Stages: Sync {
    /// A piece of work, and memory for the next one.
    type Piece: Send;

    /// A piece that holds nothing yet.
    fn piece(&self) -> Self::Piece;
    /// The first stage of the piece with this number, on any thread.
    fn begin(&self, number: usize, piece: &mut Self::Piece);
    /// Whether a piece has nothing left to be done in the second stage.
    fn is_finished(&self, piece: &Self::Piece) -> bool;
    /// The second stage, on any thread.
    fn finish(&self, piece: &mut Self::Piece);
}

/// What is done in the order of the pieces, on this thread.
pub trait InOrder<P> {
    /// Between the stages: `false` where the pieces behind this one are not wanted.
    fn between(&mut self, piece: &mut P) -> bool;
    /// Behind the second stage: `false` where no more is wanted.
    fn end(&mut self, piece: &mut P) -> bool;
}

/// Pieces in work for every thread, at most: one in work, one that waits for it, and one that waits for its turn.
const MOST: usize = 3;

/// Works on pieces, on this thread too; `false` where an end asked for no more.
pub fn work<S: Stages>(
    workers: &dyn Workers,
    count: usize,
    stages: &S,
    order: &mut impl InOrder<S::Piece>,
) -> bool {
    let threads = workers.threads();
    if threads.min(count) < 2 {
        return one_by_one(count, stages, order);
    }
    let waiting: Vec<Waiting<S::Piece>> = (0..threads).map(|_| Waiting::default()).collect();
    let (done, reached) = channel();
    let here = AtomicUsize::new(1);
    let help = || {
        let Some(waiting) = waiting.get(here.fetch_add(1, Ordering::Relaxed)) else { return };
        while let Some(job) = waiting.wait() {
            Reply::of(job, stages, &done);
        }
    };
    let mut goes_on = false;
    workers.beside(&help, &mut || {
        let _ending = Ending(&waiting);
        goes_on = Pieces::new(&waiting, &reached, count).in_their_order(stages, order);
    });
    goes_on
}

/// Lets those go who help.
struct Ending<'w, P>(&'w [Waiting<P>]);

impl<P> Drop for Ending<'_, P> {
    fn drop(&mut self) {
        self.0.iter().for_each(Waiting::end);
    }
}

/// Pieces on their way through the stages.
struct Pieces<'w, P> {
    /// What waits for each thread, for this one first. What nobody has begun is done here, too.
    waiting: &'w [Waiting<P>],
    /// What the others have done; nothing of a piece that was lost.
    reached: &'w Receiver<Option<Job<P>>>,
    /// How many jobs each thread has.
    given: Vec<usize>,
    /// Memory of pieces that are done, thread by thread.
    free: Vec<Vec<P>>,
    begun: Line<P>,
    finished: Line<P>,
    /// A piece more each time that one was wanted: where few are, few are begun in vain.
    window: usize,
    sent: usize,
    wanted: usize,
}

impl<'w, P> Pieces<'w, P> {
    fn new(waiting: &'w [Waiting<P>], reached: &'w Receiver<Option<Job<P>>>, count: usize) -> Self {
        let (given, free) = (vec![0; waiting.len()], waiting.iter().map(|_| Vec::new()).collect());
        let (begun, finished) = (Line::default(), Line::default());
        Self { waiting, reached, given, free, begun, finished, window: 1, sent: 0, wanted: count }
    }

    fn in_their_order(&mut self, stages: &impl Stages<Piece = P>, order: &mut impl InOrder<P>) -> bool {
        loop {
            self.reached.try_iter().flatten().for_each(|job| self.put(job));
            self.between(stages, order);
            if !self.end(order) {
                return false;
            }
            if self.finished.first() >= self.wanted {
                return true;
            }
            self.give(stages);
            match self.own(stages) {
                Some(job) => self.put(job.done(stages)),
                None => match self.reached.recv() {
                    Ok(Some(job)) => self.put(job),
                    _ => return false,
                },
            }
        }
    }

    /// Takes a job that is done.
    fn put(&mut self, job: Job<P>) {
        self.given[job.thread] -= 1;
        if job.stage == Stage::Finished { self.finished.put(job) } else { self.begun.put(job) }
    }

    /// Gives a thread a job.
    fn send(&mut self, job: Job<P>) {
        self.given[job.thread] += 1;
        self.waiting[job.thread].put(job);
    }

    fn between(&mut self, stages: &impl Stages<Piece = P>, order: &mut impl InOrder<P>) {
        while self.begun.first() < self.wanted
            && let Some(mut job) = self.begun.take()
        {
            if order.between(&mut job.piece) {
                self.window = (self.window + 1).min(MOST * self.waiting.len());
            } else {
                self.wanted = job.number + 1;
            }
            if stages.is_finished(&job.piece) {
                self.finished.put(Job { stage: Stage::Finished, ..job });
            } else {
                self.send(job);
            }
        }
    }

    fn end(&mut self, order: &mut impl InOrder<P>) -> bool {
        while let Some(mut job) = self.finished.take() {
            if !order.end(&mut job.piece) {
                return false;
            }
            self.free[job.thread].push(job.piece);
        }
        true
    }

    /// A new piece for a thread.
    fn new_piece(&mut self, thread: usize, stages: &impl Stages<Piece = P>) -> Option<Job<P>> {
        if self.sent >= self.wanted.min(self.finished.first() + self.window) {
            return None;
        }
        let others = |free: &mut Vec<Vec<P>>| free.iter_mut().find_map(Vec::pop);
        let memory = self.free[thread].pop().or_else(|| others(&mut self.free));
        let piece = memory.unwrap_or_else(|| stages.piece());
        self.sent += 1;
        Some(Job { number: self.sent - 1, piece, stage: Stage::New, thread })
    }

    /// Gives those who help new pieces, in turn.
    fn give(&mut self, stages: &impl Stages<Piece = P>) {
        for jobs in 0..MOST {
            for thread in 1..self.waiting.len() {
                if self.given[thread] <= jobs
                    && let Some(job) = self.new_piece(thread, stages)
                {
                    self.send(job);
                }
            }
        }
    }

    /// What this thread does next.
    fn own(&mut self, stages: &impl Stages<Piece = P>) -> Option<Job<P>> {
        if let Some(job) = self.waiting[0].take() {
            return Some(job);
        }
        if let Some(job) = self.new_piece(0, stages) {
            self.given[0] += 1;
            return Some(job);
        }
        let job = self.waiting[1..].iter().find_map(Waiting::take)?;
        self.given[job.thread] -= 1;
        self.given[0] += 1;
        Some(Job { thread: 0, ..job })
    }
}

/// What comes back of a piece: nothing where the work on it panics.
struct Reply<'d, P> {
    done: &'d Sender<Option<Job<P>>>,
    job: Option<Job<P>>,
}

impl<'d, P> Reply<'d, P> {
    /// Does the next stage.
    fn of(job: Job<P>, stages: &impl Stages<Piece = P>, done: &'d Sender<Option<Job<P>>>) {
        let mut reply = Self { done, job: None };
        reply.job = Some(job.done(stages));
    }
}

impl<P> Drop for Reply<'_, P> {
    fn drop(&mut self) {
        drop(self.done.send(self.job.take()));
    }
}

fn one_by_one<S: Stages>(count: usize, stages: &S, order: &mut impl InOrder<S::Piece>) -> bool {
    let mut piece = stages.piece();
    for number in 0..count {
        stages.begin(number, &mut piece);
        let goes_on = order.between(&mut piece);
        if !stages.is_finished(&piece) {
            stages.finish(&mut piece);
        }
        if !order.end(&mut piece) {
            return false;
        }
        if !goes_on {
            break;
        }
    }
    true
}

/// How far a piece is.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Stage {
    New,
    Begun,
    Finished,
}

pub(super) struct Job<P> {
    pub number: usize,
    pub piece: P,
    pub stage: Stage,
    /// The number of the thread that works on it.
    pub thread: usize,
}

impl<P> Job<P> {
    /// With the next stage done.
    fn done(mut self, stages: &impl Stages<Piece = P>) -> Self {
        if self.stage == Stage::New {
            stages.begin(self.number, &mut self.piece);
            self.stage = Stage::Begun;
        } else {
            stages.finish(&mut self.piece);
            self.stage = Stage::Finished;
        }
        self
    }
}
