//! "Did you mean …?"

/// How far a name may be from another and still be taken for a slip of the pen.
#[must_use]
pub fn distance_allowed(name: &str) -> usize {
    (name.chars().count() / 3).max(1)
}

/// Which of the candidates a misspelt name may mean, the nearest first, at most three.
///
/// A candidate that differs in its capitals alone comes first, then those within Damerau's distance of a third of the
/// name's length, then those that contain the name or are contained in it.
#[must_use]
pub fn did_you_mean<'a>(name: &str, candidates: impl IntoIterator<Item = &'a str>) -> Vec<&'a str> {
    let folded = name.to_lowercase();
    let mut ranked = candidates
        .into_iter()
        .filter(|c| *c != name)
        .filter_map(|c| rank(&folded, &c.to_lowercase(), distance_allowed(name)).map(|r| (r, c)))
        .collect::<Vec<_>>();
    ranked.sort();
    ranked.dedup();
    ranked.into_iter().map(|(_, c)| c).take(3).collect()
}

/// Nothing if the two are unlike.
fn rank(name: &str, candidate: &str, allowed: usize) -> Option<usize> {
    let long = |s: &str| s.chars().count() >= 3;
    let distance = strsim::damerau_levenshtein(name, candidate);
    let shortest = name.chars().count().min(candidate.chars().count());
    // With every letter exchanged it is another name, however short.
    if distance <= allowed && distance < shortest.max(1) {
        return Some(distance);
    }
    let within = (long(name) && candidate.contains(name)) || (long(candidate) && name.contains(candidate));
    within.then_some(1000 + distance)
}
