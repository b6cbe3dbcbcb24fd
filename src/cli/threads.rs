//! Work on several threads, which are started when there is the first of it.

use crate::Workers;
use rayon::prelude::*;
use std::sync::OnceLock;

/// Threads, started when they are needed.
#[derive(Debug)]
pub struct Threads {
    count: OnceLock<usize>,
    pool: OnceLock<Option<rayon::ThreadPool>>,
}

impl Threads {
    /// This number of them, or one for every processor.
    #[must_use]
    pub fn new(count: Option<usize>) -> Self {
        Self { count: count.map(OnceLock::from).unwrap_or_default(), pool: OnceLock::new() }
    }

    /// How many they are.
    pub fn count(&self) -> usize {
        let all = || std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
        *self.count.get_or_init(all)
    }

    /// The threads, where there is more than one item and more than one processor.
    fn pool_for(&self, items: usize) -> Option<&rayon::ThreadPool> {
        let start = || rayon::ThreadPoolBuilder::new().num_threads(self.count()).build().ok();
        let several = items > 1 && self.count() > 1;
        several.then(|| self.pool.get_or_init(start).as_ref()).flatten()
    }

    /// Does the work on every item with its number. Where threads cannot be started it is done here.
    pub fn each<T: Send>(&self, items: &mut [T], work: impl Fn((usize, &mut T)) + Sync) {
        match self.pool_for(items.len()) {
            Some(pool) => pool.install(|| items.par_iter_mut().enumerate().for_each(&work)),
            None => items.iter_mut().enumerate().for_each(work),
        }
    }
}

impl Workers for Threads {
    fn threads(&self) -> usize {
        self.count()
    }

    fn beside(&self, help: &(dyn Fn() + Sync), own: &mut dyn FnMut()) {
        std::thread::scope(|scope| {
            for _ in 1..self.count() {
                // the caller does the work where no other thread can be had
                drop(std::thread::Builder::new().spawn_scoped(scope, help));
            }
            own();
        });
    }
}
