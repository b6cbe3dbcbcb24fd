//! 3,000 random linkages: no sound one is refused, none is accepted that is over- or underconstrained anywhere, and what a
//! help proposes does what it says.

use super::help::{Removal, apply, pastes, removals, replacements};
use super::linkage::{Kind, Linkage, Pair, link_name};
use super::oracle::{Truth, truth};
use crate::support::random::Random;
use assur::internals::check::Overrides;
use assur::internals::source::Source;

const LINKAGES: u64 = 3_000;

/// The codes and the help of the first error or warning on structure.
struct Verdict {
    codes: Vec<String>,
    message: String,
    help: String,
}

fn verdict(text: &str) -> Verdict {
    let source = Source::new("random.mech", text);
    let (_, problems) = assur::internals::compile(&source, &Overrides::none());
    let views = problems.views(&source);
    let codes = views.iter().filter_map(|d| d.code.clone()).collect();
    let first = views.into_iter().next();
    let (message, help) = first.map(|d| (d.message, d.help.unwrap_or_default())).unwrap_or_default();
    Verdict { codes, message, help }
}

/// Whether the verdict is what the rank says.
fn agrees(verdict: &Verdict, truth: &Truth) -> bool {
    let names = |code: &str| verdict.codes.iter().any(|c| c == &format!("mech::determinacy::{code}"));
    let islands = names("floating_link") || names("not_grounded");
    let over = names("overconstrained") || names("repeated");
    match (truth.surplus > 0, truth.missing > 0) {
        (false, false) => {
            let still = names("immobile") != truth.immobile.is_empty();
            let named = truth.immobile.iter().take(5).all(|l| verdict.message.contains(&quoted(*l)));
            still && named && verdict.codes.len() == usize::from(!truth.immobile.is_empty())
        }
        (true, false) => over,
        (false, true) => names("underconstrained") || islands,
        (true, true) => names("unbalanced") || islands,
    }
}

fn quoted(link: usize) -> String {
    format!("`{}`", link_name(link))
}

/// A linkage and what was done to it.
struct Sample {
    linkage: Linkage,
    /// The pairs whose points and lines are there.
    places: Vec<Pair>,
    change: Change,
}

enum Change {
    None,
    Missing(Pair),
    Surplus(usize),
    Several,
}

/// Put together from structural groups. Both ends of a dyad on one pin make it unsound: such a one is drawn again.
fn sound(random: &mut Random) -> Linkage {
    loop {
        let mut linkage = Linkage::with_cranks(1 + random.below(2));
        for _ in 0..1 + random.below(4) {
            linkage.add_group(random);
        }
        if truth(&linkage, random.next()).is_sound() {
            return linkage;
        }
    }
}

fn sample(random: &mut Random) -> Sample {
    let mut sound = sound(random);
    let places = sound.pairs.clone();
    match random.below(5) {
        0 => Sample { places, linkage: sound, change: Change::None },
        1 => {
            let i = random.below(sound.pairs.len());
            let pair = sound.pairs.remove(i);
            Sample { places, linkage: sound, change: Change::Missing(pair) }
        }
        2 => {
            let number = sound.add_any(random);
            Sample { places: sound.pairs.clone(), linkage: sound, change: Change::Surplus(number) }
        }
        3 => {
            for _ in 0..1 + random.below(2) {
                let i = random.below(sound.pairs.len());
                sound.pairs.remove(i);
                sound.add_any(random);
            }
            let places = places.into_iter().chain(sound.pairs.clone()).collect();
            Sample { places: distinct(places), linkage: sound, change: Change::Several }
        }
        _ => {
            let mut any = Linkage::with_cranks(1);
            for _ in 0..2 + random.below(5) {
                any.add_link();
            }
            let freedoms = 3 * (any.links.len() - 1);
            let mut taken = 3;
            while taken < freedoms {
                any.add_any(random);
                let last = any.pairs.last().expect("one was added");
                taken += if matches!(last.kind, Kind::Slot(..)) { 1 } else { 2 };
            }
            Sample { places: any.pairs.clone(), linkage: any, change: Change::Several }
        }
    }
}

fn distinct(pairs: Vec<Pair>) -> Vec<Pair> {
    let mut out: Vec<Pair> = Vec::new();
    for pair in pairs {
        if !out.iter().any(|p| p.number == pair.number) {
            out.push(pair);
        }
    }
    out
}

#[derive(Default)]
struct Tally {
    sound: usize,
    wrong: Vec<String>,
    missing: usize,
    missing_named: usize,
    surplus: usize,
    surplus_named: usize,
    /// How far down its list a surplus pair stands.
    places: Vec<usize>,
    fixes: usize,
    wrong_fixes: Vec<String>,
    without_fix: Vec<String>,
}

#[test]
fn verdicts_agree_with_the_rank() {
    use crate::share::least;
    let mut tally = Tally::default();
    for seed in crate::share::first(0..LINKAGES) {
        judge(seed, &mut tally);
    }
    let share = |some: usize, all: usize| some as f64 / all as f64;
    println!(
        "{} sound; {} of {} missing pairs named, {} of {} surplus pairs; {} fixes pasted; {} without one; places {:?}",
        tally.sound,
        tally.missing_named,
        tally.missing,
        tally.surplus_named,
        tally.surplus,
        tally.fixes,
        tally.without_fix.len(),
        (0..13).map(|i| tally.places.iter().filter(|p| **p == i).count()).collect::<Vec<_>>()
    );
    assert!(tally.wrong.is_empty(), "{}\n{}", tally.wrong.len(), tally.wrong[0]);
    assert!(tally.wrong_fixes.is_empty(), "{}\n{}", tally.wrong_fixes.len(), tally.wrong_fixes[0]);
    assert!(tally.without_fix.is_empty(), "{}\n{}", tally.without_fix.len(), tally.without_fix[0]);
    assert!(
        tally.sound > least(600)
            && tally.missing > least(300)
            && tally.surplus > least(300)
            && tally.fixes > least(3_000)
    );
    assert!(share(tally.missing_named, tally.missing) >= 0.99, "missing pairs");
    assert!(share(tally.surplus_named, tally.surplus) >= 0.99, "surplus pairs");
}

fn judge(seed: u64, tally: &mut Tally) {
    let random = &mut Random::new(seed);
    let Sample { linkage, places, change } = sample(random);
    let real = truth(&linkage, seed);
    let text = linkage.text(&places, &mut Random::new(seed));
    let found = verdict(&text);
    if !agrees(&found, &real) {
        tally
            .wrong
            .push(format!("{real:?} but {:?}\n{}\n{}\n{text}", found.codes, found.message, found.help));
        return;
    }
    tally.sound += usize::from(real.is_sound());
    match change {
        Change::Missing(pair) if real.missing > 0 => {
            tally.missing += 1;
            tally.missing_named += usize::from(is_named(&pair, &found.help));
            if !is_named(&pair, &found.help) {
                println!("not named: {pair:?}\n{}\n{text}", found.help);
            }
        }
        Change::Surplus(number) if real.surplus > 0 => {
            tally.surplus += 1;
            let proposals = removals(&found.help);
            let alone = |r: &Removal| *r == Removal::Pair(number);
            let place = proposals.iter().position(|p| p.removals.len() == 1 && alone(&p.removals[0]));
            tally.surplus_named += usize::from(place.is_some());
            tally.places.extend(place);
            if place.is_none() {
                println!("not named: P{number}\n{}\n{text}", found.help);
            }
        }
        _ => {}
    }
    if !real.is_sound() && !found.codes.iter().any(|c| c.ends_with("repeated")) {
        fixes(seed, (&linkage, &text), &real, &found, tally);
    }
}

/// One of the lines joins two of its links at its points.
fn is_named(pair: &Pair, help: &str) -> bool {
    let name = pair.name();
    let links: Vec<String> = pair.links().iter().map(|l| link_name(*l)).collect();
    let joins = |line: &str| {
        let Some((word, rest)) = line.trim().split_once(' ') else { return false };
        let Some((own, ends)) = rest.split_once(": ") else { return false };
        let ends: Vec<&str> = ends.split(" - ").collect();
        let is_end = |end: &&str| match end.split_once('.') {
            Some((link, point)) => {
                links.iter().any(|l| l == link)
                    && [name.clone(), format!("l{name}")].iter().any(|n| n == point)
            }
            None => own == name && links.iter().any(|l| l == end),
        };
        word == pair.word() && ends.iter().all(is_end)
    };
    help.lines().any(joins)
}

/// Everything the help proposes, each by itself.
fn fixes(seed: u64, (linkage, text): (&Linkage, &str), real: &Truth, found: &Verdict, tally: &mut Tally) {
    let proposals = removals(&found.help);
    let islands = found.codes.iter().any(|c| c.ends_with("floating_link") || c.ends_with("not_grounded"));
    for proposal in &proposals {
        tally.fixes += 1;
        let now = truth(&apply(linkage, &proposal.removals), seed);
        let fixed = match proposal.removals.as_slice() {
            [Removal::AsPrismatic(_)] => now.missing < real.missing && now.surplus == real.surplus,
            _ => now.surplus < real.surplus && (now.missing == real.missing) != proposal.loosens,
        };
        if !fixed {
            tally.wrong_fixes.push(format!("{proposal:?}: {real:?} -> {now:?}\n{}\n{text}", found.help));
        }
    }
    let pastes = pastes(&found.help);
    for lines in &pastes {
        tally.fixes += 1;
        let now = verdict(&format!("{text}{}\n", lines.join("\n")));
        let determinacy: Vec<&String> = now.codes.iter().filter(|c| !c.ends_with("immobile")).collect();
        let fixed = if islands {
            // one island may be left where there are several
            now.codes.len() < found.codes.len() || !now.codes.contains(&found.codes[0])
        } else if real.surplus > 0 {
            determinacy.iter().all(|c| c.ends_with("overconstrained") || c.ends_with("repeated"))
        } else {
            determinacy.is_empty()
        };
        if !fixed {
            let shown =
                format!("{lines:?}: {real:?} -> {:?} {}\n{}\n{text}", now.codes, now.message, found.help);
            tally.wrong_fixes.push(shown);
        }
    }
    let swaps = swaps(&found.help, text, real, tally);
    let lacks = swaps == 0
        && (real.surplus > 0 && proposals.is_empty() && replacements(&found.help).is_empty() && !islands
            || real.missing > 0 && pastes.is_empty());
    if lacks && !islands {
        tally.without_fix.push(format!("{real:?}\n{}\n{text}", found.help));
    }
}

/// Pairs written in place of others: each makes all determined. How many there are.
fn swaps(help: &str, text: &str, real: &Truth, tally: &mut Tally) -> usize {
    let swaps = replacements(help);
    let are_whole = real.surplus > 0 && real.missing > 0 && !help.contains("can still move");
    for (line, old) in swaps.iter().filter(|_| are_whole) {
        tally.fixes += 1;
        let is_old = |written: &&str| written.strip_prefix(old).is_some_and(|rest| rest.starts_with(':'));
        let kept: String = text.lines().filter(|l| !is_old(l)).map(|l| format!("{l}\n")).collect();
        let now = verdict(&format!("{kept}{line}\n"));
        if now.codes.iter().any(|c| !c.ends_with("immobile") && !c.ends_with("two_letters")) {
            tally
                .wrong_fixes
                .push(format!("{line} for {old}: {:?} {}\n{help}\n{text}", now.codes, now.message));
        }
    }
    if are_whole { swaps.len() } else { 0 }
}
