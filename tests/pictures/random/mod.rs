//! Random mechanisms. A run draws a few; `ASSUR_PICTURES=2000 cargo test --test pictures random` draws that many.

mod groups;
mod texts;

use crate::bars::Tally;

/// How many are drawn where nothing else is asked for.
const USUAL: u64 = 120;

/// The numbers of the mechanisms of a run.
fn seeds() -> std::ops::Range<u64> {
    let wanted = std::env::var("ASSUR_PICTURES").ok().and_then(|n| n.parse().ok());
    0..wanted.unwrap_or_else(|| crate::share::part(USUAL)) / 2
}

#[test]
fn chains_of_groups_are_drawn_as_they_are_solved() {
    let mut tally = Tally::default();
    let drawn = seeds().filter(|seed| groups::judge(*seed, &mut tally)).count();
    println!("{drawn} mechanisms, {tally}");
    tally.finish();
    assert!(10 * drawn > 9 * seeds().count(), "{drawn}");
}

#[test]
fn machines_of_wild_proportions_are_drawn_as_they_are_solved() {
    let mut tally = Tally::default();
    let drawn = seeds().filter(|seed| texts::judge(*seed, &mut tally)).count();
    println!("{drawn} mechanisms, {tally}");
    tally.finish();
    assert!(10 * drawn > 9 * seeds().count(), "{drawn}");
}
