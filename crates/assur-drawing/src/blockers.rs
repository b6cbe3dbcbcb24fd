//! Who is in the way of a place.

/// The labels in the way of a place: how many they are, and the sum of their numbers, which is that of the one if there is one.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Blockers {
    count: usize,
    sum: usize,
}

impl Blockers {
    pub const fn are_none(self) -> bool {
        self.count == 0
    }

    /// The one that is alone in the way.
    pub const fn only(self) -> Option<usize> {
        if self.count == 1 { Some(self.sum) } else { None }
    }

    pub const fn add(&mut self, label: usize) {
        self.count += 1;
        self.sum += label;
    }

    pub const fn remove(&mut self, label: usize) {
        self.count -= 1;
        self.sum -= label;
    }
}
