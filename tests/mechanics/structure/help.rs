//! What a help proposes, as edits of a linkage or lines to paste.

use super::linkage::{Kind, Linkage};

/// Something to leave out.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Removal {
    Pair(usize),
    /// A link out of a pin of several.
    Member(usize, usize),
    Link(usize),
    Drive(usize),
    /// A slot in place of a prismatic pair.
    AsSlot(usize),
    /// A prismatic pair in place of a slot whose slider turns.
    AsPrismatic(usize),
}

/// Changes that belong together.
#[derive(Clone, Debug)]
pub struct Proposal {
    pub removals: Vec<Removal>,
    /// After it something more has to be driven.
    pub loosens: bool,
}

/// Everything a help proposes to leave out, in its order.
pub fn removals(help: &str) -> Vec<Proposal> {
    let sentence = help.lines().filter(|l| !l.starts_with("  ")).collect::<Vec<_>>().join(" ");
    // every way begins with its verb
    let marked = sentence.replace("leave out ", "\u{1}-").replace("write ", "\u{1}+");
    marked.split('\u{1}').skip(1).flat_map(way).collect()
}

fn way(text: &str) -> Vec<Proposal> {
    let loosens = text.contains("after which");
    let text = text.split([';']).next().unwrap_or_default();
    if text.starts_with('+') {
        return written(text)
            .into_iter()
            .map(|removal| Proposal { removals: vec![removal], loosens })
            .collect();
    }
    let text = text.trim_start_matches('-');
    let links = text.starts_with("link") || text.starts_with("one of the links");
    let mut found = Vec::new();
    let mut names = quoted(text).into_iter();
    while let Some(name) = names.next() {
        found.push(if links {
            Removal::Link(number(name))
        } else if let Some(drive) = name.strip_prefix("drive ") {
            Removal::Drive(number(drive))
        } else if let Some((_, pair)) = name.split_once(' ') {
            Removal::Pair(number(pair))
        } else {
            let pin = names.next().and_then(|n| n.split_once(' ')).expect("the pin of a member").1;
            Removal::Member(number(pin), number(name))
        });
    }
    if text.contains("` and `") {
        return vec![Proposal { removals: found, loosens }];
    }
    found.into_iter().map(|r| Proposal { removals: vec![r], loosens }).collect()
}

/// A prismatic pair as a slot or a slot as a prismatic pair: what the equations can judge. Others are judged as text.
fn written(text: &str) -> Option<Removal> {
    let words = quoted(text);
    let (word, rest) = words.first()?.split_once(' ')?;
    let name = rest.split(':').next()?;
    match (words.get(1).and_then(|old| old.split_once(' ')), word) {
        (None, "prismatic") => Some(Removal::AsPrismatic(number(name))),
        (Some(("prismatic", old)), "slot") if old == name => Some(Removal::AsSlot(number(name))),
        _ => None,
    }
}

/// Lines with the statements in whose place they would be.
pub fn replacements(help: &str) -> Vec<(&str, &str)> {
    let parts = help.split("write `").skip(1).filter_map(|part| {
        let (line, rest) = part.split_once('`')?;
        let old = rest.strip_prefix(" in place of `")?.split('`').next()?;
        Some((line, old))
    });
    parts.collect()
}

fn quoted(text: &str) -> Vec<&str> {
    text.split('`').skip(1).step_by(2).collect()
}

/// 7 of `P7` and `L7`, 0 of the ground
fn number(name: &str) -> usize {
    if name == "ground" {
        return 0;
    }
    name[1..].parse().unwrap_or_else(|_| panic!("{name}"))
}

pub fn apply(linkage: &Linkage, removals: &[Removal]) -> Linkage {
    let mut out = linkage.clone();
    for removal in removals {
        match removal {
            Removal::Pair(pair) => out = out.without_pair(*pair),
            Removal::Link(link) => out = out.without_link(*link),
            Removal::Drive(link) => out.drives.retain(|d| d != link),
            Removal::Member(pair, link) => {
                for pair in out.pairs.iter_mut().filter(|p| p.number == *pair) {
                    if let Kind::Revolute(links) = &mut pair.kind {
                        links.retain(|l| l != link);
                    }
                }
            }
            Removal::AsSlot(pair) => {
                for pair in out.pairs.iter_mut().filter(|p| p.number == *pair) {
                    if let Kind::Prismatic(a, b) = pair.kind {
                        pair.kind = Kind::Slot(a, b);
                    }
                }
            }
            Removal::AsPrismatic(pair) => {
                for pair in out.pairs.iter_mut().filter(|p| p.number == *pair) {
                    if let Kind::Slot(a, b) = pair.kind {
                        pair.kind = Kind::Prismatic(a, b);
                    }
                }
            }
        }
    }
    out
}

/// Lines to paste: each inner list together.
pub fn pastes(help: &str) -> Vec<Vec<&str>> {
    let mut sections: Vec<(&str, Vec<&str>)> = Vec::new();
    for line in help.lines() {
        match (line.strip_prefix("  "), sections.last_mut()) {
            (Some(pasted), Some(section)) => section.1.push(pasted),
            _ => sections.push((line, Vec::new())),
        }
    }
    sections
        .into_iter()
        .filter(|s| !s.1.is_empty())
        .flat_map(|(sentence, lines)| {
            if sentence.ends_with("lines") {
                vec![lines]
            } else {
                lines.into_iter().map(|l| vec![l]).collect::<Vec<_>>()
            }
        })
        .collect()
}
