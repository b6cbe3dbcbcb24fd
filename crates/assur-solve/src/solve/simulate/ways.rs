//! Ways in which pairs that rub and stops that are touched may go on.

/// A way on: the senses of the elements that may be held, and which of the stops that are touched are closed.
#[derive(Clone, PartialEq)]
pub(super) struct Way {
    pub senses: Vec<f64>,
    pub closed: Vec<bool>,
}

impl Way {
    /// All of so many elements and stops, those first in which least slides.
    pub fn all(open: usize, stops: usize) -> Vec<Self> {
        let count = 3_usize.pow(open as u32) << stops;
        let mut ways: Vec<Self> = (0..count)
            .map(|way| Self {
                senses: ternary(way >> stops, open),
                closed: (0..stops).map(|stop| way >> stop & 1 == 1).collect(),
            })
            .collect();
        ways.sort_by_key(|way| way.senses.iter().filter(|sense| **sense != 0.0).count());
        ways
    }
}

/// The digits of a number to base three, as senses.
fn ternary(mut way: usize, count: usize) -> Vec<f64> {
    let digits = (0..count).map(|_| {
        let digit = way % 3;
        way /= 3;
        [0.0, 1.0, -1.0][digit]
    });
    digits.collect()
}
