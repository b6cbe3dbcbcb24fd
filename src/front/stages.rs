//! Pieces of work in two stages on several threads, with something that is done here and in their order between the stages, and behind
//! them.

use super::workers::Workers;
use std::collections::VecDeque;
use std::sync::Mutex;
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
    let (jobs, waiting) = channel();
    let (done, reached) = channel();
    let waiting = Mutex::new(waiting);
    let help = || {
        while let Some(job) = next(&waiting, true) {
            Reply::of(job, stages, &done);
        }
    };
    let (mut jobs, mut goes_on) = (Some(jobs), false);
    workers.beside(&help, &mut || {
        if let Some(jobs) = jobs.take() {
            let pieces = Pieces { jobs, waiting: &waiting, reached: &reached, threads, count };
            goes_on = pieces.in_their_order(stages, order);
        }
    });
    goes_on
}

/// Pieces on their way through the stages.
struct Pieces<'w, P> {
    /// Those who help end with it.
    jobs: Sender<Job<P>>,
    waiting: &'w Mutex<Receiver<Job<P>>>,
    /// What the others have done; nothing of a piece that was lost.
    reached: &'w Receiver<Option<Job<P>>>,
    threads: usize,
    count: usize,
}

impl<P> Pieces<'_, P> {
    fn in_their_order(&self, stages: &impl Stages<Piece = P>, order: &mut impl InOrder<P>) -> bool {
        let mut line = Line { begun: Queue::default(), finished: Queue::default(), free: Vec::new() };
        // a piece more each time that one was wanted: where few are, few are begun in vain
        let (mut window, mut sent, mut wanted) = (1, 0, self.count);
        loop {
            self.reached.try_iter().flatten().for_each(|job| line.put(job));
            while line.begun.first < wanted
                && let Some(mut piece) = line.begun.take()
            {
                let number = line.begun.first - 1;
                if order.between(&mut piece) {
                    window = (window + 1).min(MOST * self.threads);
                } else {
                    wanted = number + 1;
                }
                let stage = if stages.is_finished(&piece) { Stage::Finished } else { Stage::Begun };
                let job = Job { number, piece, stage };
                match job.stage {
                    Stage::Finished => line.put(job),
                    _ => drop(self.jobs.send(job)),
                }
            }
            while let Some(mut piece) = line.finished.take() {
                if !order.end(&mut piece) {
                    return false;
                }
                line.free.push(piece);
            }
            if line.finished.first >= wanted {
                return true;
            }
            while sent < wanted.min(line.finished.first + window) {
                let piece = line.free.pop().unwrap_or_else(|| stages.piece());
                drop(self.jobs.send(Job { number: sent, piece, stage: Stage::New }));
                sent += 1;
            }
            match next(self.waiting, false) {
                Some(job) => line.put(job.done(stages)),
                None => match self.reached.recv() {
                    Ok(Some(job)) => line.put(job),
                    _ => return false,
                },
            }
        }
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

/// The next piece that waits to be worked on; whether to wait for one.
fn next<P>(waiting: &Mutex<Receiver<Job<P>>>, waits: bool) -> Option<Job<P>> {
    if waits { waiting.lock().ok()?.recv().ok() } else { waiting.try_lock().ok()?.try_recv().ok() }
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
enum Stage {
    New,
    Begun,
    Finished,
}

struct Job<P> {
    number: usize,
    piece: P,
    stage: Stage,
}

impl<P> Job<P> {
    /// With the next stage done.
    fn done(self, stages: &impl Stages<Piece = P>) -> Self {
        let Self { number, mut piece, stage } = self;
        let stage = if stage == Stage::New {
            stages.begin(number, &mut piece);
            Stage::Begun
        } else {
            stages.finish(&mut piece);
            Stage::Finished
        };
        Self { number, piece, stage }
    }
}

/// Pieces behind their stages.
struct Line<P> {
    begun: Queue<P>,
    finished: Queue<P>,
    /// Memory of pieces that are done.
    free: Vec<P>,
}

impl<P> Line<P> {
    fn put(&mut self, Job { number, piece, stage }: Job<P>) {
        let queue = if stage == Stage::Finished { &mut self.finished } else { &mut self.begun };
        queue.put(number, piece);
    }
}

/// Pieces that come in any order, taken in theirs.
struct Queue<P> {
    /// The number of the next one.
    first: usize,
    pieces: VecDeque<Option<P>>,
}

impl<P> Default for Queue<P> {
    fn default() -> Self {
        Self { first: 0, pieces: VecDeque::new() }
    }
}

impl<P> Queue<P> {
    fn put(&mut self, number: usize, piece: P) {
        let place = number - self.first;
        if self.pieces.len() <= place {
            self.pieces.resize_with(place + 1, || None);
        }
        self.pieces[place] = Some(piece);
    }

    /// The next one, if it has come.
    fn take(&mut self) -> Option<P> {
        let piece = self.pieces.front_mut()?.take()?;
        self.pieces.pop_front();
        self.first += 1;
        Some(piece)
    }
}
