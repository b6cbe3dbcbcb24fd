//! What belongs to each pair, found without a search.

use crate::model::PairId;

/// Places in a list, pair by pair.
#[derive(Clone, Debug, Default)]
pub struct ByPair {
    /// Where the places of each pair begin, and where the last end.
    starts: Vec<usize>,
    places: Vec<usize>,
}

impl ByPair {
    /// Of a list whose entries belong to these pairs.
    pub(super) fn of(list: &[PairId]) -> Self {
        let pairs = list.iter().map(|p| p.index() + 1).max().unwrap_or(0);
        let mut starts = vec![0; pairs + 1];
        list.iter().for_each(|p| starts[p.index() + 1] += 1);
        for pair in 0..pairs {
            starts[pair + 1] += starts[pair];
        }
        let mut next = starts.clone();
        let mut places = vec![0; list.len()];
        for (place, pair) in list.iter().enumerate() {
            places[next[pair.index()]] = place;
            next[pair.index()] += 1;
        }
        Self { starts, places }
    }

    /// The places of a pair in the list, in order.
    #[must_use]
    pub fn places(&self, pair: PairId) -> &[usize] {
        match self.starts.get(pair.index()..pair.index() + 2) {
            Some(&[from, to]) => &self.places[from..to],
            _ => &[],
        }
    }
}
