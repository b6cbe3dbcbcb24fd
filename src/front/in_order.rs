//! Pieces of work on several threads, handed out on this one and in their order.

use super::workers::Workers;
use std::collections::VecDeque;
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};

/// Pieces that are begun and not handed out, for every thread.
const AHEAD: usize = 4;

/// Does `work` for every number below a count, on this thread too, and calls `hand_out` here with one piece after another, until it
/// wants no more: then `false`. The memory of pieces is used again.
pub fn in_order<P: Send>(
    workers: &dyn Workers,
    count: usize,
    new: &(impl Fn() -> P + Sync),
    work: impl Fn(usize, &mut P) + Sync,
    mut hand_out: impl FnMut(&mut P) -> bool,
) -> bool {
    let threads = workers.threads().min(count);
    if threads < 2 {
        let mut piece = new();
        return (0..count).all(|number| {
            work(number, &mut piece);
            hand_out(&mut piece)
        });
    }
    let line = Line { state: Mutex::default(), moved: Condvar::new(), count, most: AHEAD * threads };
    let one = |(number, memory): (usize, Option<P>)| {
        let mut piece = Lost { line: &line, number, piece: None };
        let mut memory = memory.unwrap_or_else(new);
        work(number, &mut memory);
        piece.piece = Some(memory);
    };
    let help = || {
        while let Some(next) = line.wait(State::next) {
            one(next);
        }
    };
    let mut goes_on = false;
    workers.beside(&help, &mut || {
        let ending = Ending(&line);
        goes_on = loop {
            match line.wait(State::own) {
                Some(Own::Done(mut piece)) => {
                    if !hand_out(&mut piece) {
                        break false;
                    }
                    line.lock().free.push(piece);
                }
                Some(Own::Next(next)) => one(next),
                None => break !line.lock().lost,
            }
        };
        drop(ending);
    });
    goes_on
}

/// Does `work` for every number below a count, on several threads.
pub fn each(workers: &dyn Workers, count: usize, work: impl Fn(usize) + Sync) {
    in_order(workers, count, &|| (), |number, ()| work(number), |()| true);
}

/// Pieces in their order.
struct Line<P> {
    state: Mutex<State<P>>,
    moved: Condvar,
    count: usize,
    most: usize,
}

struct State<P> {
    /// The first that is not begun.
    next: usize,
    /// The first that is not handed out; those behind it, as far as they are done.
    first: usize,
    done: VecDeque<Option<P>>,
    free: Vec<P>,
    ended: bool,
    /// The work on one of them has panicked.
    lost: bool,
}

impl<P> Default for State<P> {
    fn default() -> Self {
        let (done, free) = (VecDeque::new(), Vec::new());
        Self { next: 0, first: 0, done, free, ended: false, lost: false }
    }
}

/// What this thread does next.
enum Own<P> {
    Done(P),
    Next((usize, Option<P>)),
}

/// What a thread is to do: something, nothing any more, or to wait.
type Turn<T> = Option<Option<T>>;

impl<P> State<P> {
    fn next(&mut self, line: &Line<P>) -> Turn<(usize, Option<P>)> {
        if self.ended || self.next == line.count {
            return Some(None);
        }
        if self.next == self.first + line.most {
            return None;
        }
        self.next += 1;
        self.done.push_back(None);
        Some(Some((self.next - 1, self.free.pop())))
    }

    fn own(&mut self, line: &Line<P>) -> Turn<Own<P>> {
        if self.lost || self.first == line.count {
            return Some(None);
        }
        if let Some(piece) = self.done.front_mut().and_then(Option::take) {
            self.done.pop_front();
            self.first += 1;
            return Some(Some(Own::Done(piece)));
        }
        let next = self.next(line)??;
        Some(Some(Own::Next(next)))
    }
}

impl<P> Line<P> {
    fn lock(&self) -> MutexGuard<'_, State<P>> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// What there is to be done, once it is known.
    fn wait<T>(&self, turn: impl Fn(&mut State<P>, &Self) -> Turn<T>) -> Option<T> {
        let mut state = self.lock();
        loop {
            if let Some(found) = turn(&mut state, self) {
                self.moved.notify_all();
                return found;
            }
            state = self.moved.wait(state).unwrap_or_else(PoisonError::into_inner);
        }
    }
}

/// A piece in work: lost where that panics.
struct Lost<'l, P> {
    line: &'l Line<P>,
    number: usize,
    piece: Option<P>,
}

impl<P> Drop for Lost<'_, P> {
    fn drop(&mut self) {
        let mut state = self.line.lock();
        let place = self.number - state.first;
        state.lost |= self.piece.is_none();
        state.done[place] = self.piece.take();
        self.line.moved.notify_all();
    }
}

/// Lets those go who help.
struct Ending<'l, P>(&'l Line<P>);

impl<P> Drop for Ending<'_, P> {
    fn drop(&mut self) {
        self.0.lock().ended = true;
        self.0.moved.notify_all();
    }
}
