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
    let (allowed, letters) = (distance_allowed(name), letters(name));
    // every letter of one that the other lacks takes a change of its own; a part of a name lacks none
    let lacks = |a: u128, b: u128| usize::try_from((a & !b).count_ones()).unwrap_or(usize::MAX);
    let far = |c: &str| {
        let theirs = self::letters(c);
        let (here, there) = (lacks(letters, theirs), lacks(theirs, letters));
        here.max(there) > allowed && here.min(there) > 0
    };
    let mut ranked = candidates
        .into_iter()
        .filter(|c| *c != name && !far(c))
        .filter_map(|c| rank(&folded, &c.to_lowercase(), allowed).map(|r| (r, c)))
        .collect::<Vec<_>>();
    ranked.sort();
    ranked.dedup();
    ranked.into_iter().map(|(_, c)| c).take(3).collect()
}

/// Which letters a name of ASCII has, capitals as small ones; all of them where it has others.
fn letters(name: &str) -> u128 {
    if name.is_ascii() { name.bytes().fold(0, |all, b| all | 1 << b.to_ascii_lowercase()) } else { u128::MAX }
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
