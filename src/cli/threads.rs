//! Work on several threads, which are started when there is the first of it.

use rayon::prelude::*;
use std::sync::OnceLock;

/// Threads, started when they are needed.
#[derive(Debug)]
pub struct Threads {
    count: usize,
    pool: OnceLock<Option<rayon::ThreadPool>>,
}

impl Threads {
    /// This number of them, or one for every processor.
    #[must_use]
    pub fn new(count: Option<usize>) -> Self {
        let all = || std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
        Self { count: count.unwrap_or_else(all), pool: OnceLock::new() }
    }

    /// How many there are.
    #[must_use]
    pub const fn count(&self) -> usize {
        self.count
    }

    /// Does the work on every item with its number. Where threads cannot be started it is done here.
    pub fn each<T: Send>(&self, items: &mut [T], work: impl Fn((usize, &mut T)) + Sync) {
        let start = || rayon::ThreadPoolBuilder::new().num_threads(self.count).build().ok();
        let several = self.count > 1 && items.len() > 1;
        match if several { self.pool.get_or_init(start) } else { &None } {
            Some(pool) => pool.install(|| items.par_iter_mut().enumerate().for_each(&work)),
            None => items.iter_mut().enumerate().for_each(work),
        }
    }
}
