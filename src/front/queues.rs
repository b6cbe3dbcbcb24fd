//! Where pieces of work wait: for a thread, or for their turn.

use super::stages::{Job, Stage};
use std::collections::VecDeque;
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};

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
