//! Numbers to plot that are written on the command line: they become items of `find` behind the text, so that they are
//! checked, and followed over the sweep, as if they stood in it.

use crate::cli::args::Picture;
use crate::pipeline;
use assur_check::Overrides;
use assur_model::model::Mechanism;
use assur_picture::Kind;
use assur_text::source::Source;

/// The text with items of `find` for what is plotted and not asked for in it; none where it has all.
pub fn extended(source: &Source, overrides: &Overrides, pictures: &[Picture]) -> Option<Source> {
    let wanted = pictures.iter().filter(|p| p.kind == Kind::Plot).flat_map(|p| parts(&p.of));
    let wanted: Vec<&str> = wanted.collect();
    if wanted.is_empty() {
        return None;
    }
    let compiled = pipeline::compile(source, overrides).0;
    let known = |part: &&str| compiled.as_ref().is_some_and(|c| position(&c.mechanism, part).is_some());
    let mut text = String::new();
    for part in wanted.into_iter().filter(|part| !known(part)) {
        let line = format!("\nfind {part}");
        if !text.contains(&line) {
            text += &line;
        }
    }
    (!text.is_empty()).then(|| Source::new(&source.name, source.text.clone() + &text + "\n"))
}

/// The items of `find` that a plot shows, by index.
pub fn items(source: &Source, mechanism: &Mechanism, wanted: &str) -> Vec<usize> {
    let of = |part: &str| {
        let written = |i: &usize| {
            let span = mechanism.finds[*i].span;
            source.text.get(span.start..span.end).is_some_and(|text| same(text, part))
        };
        position(mechanism, part).or_else(|| (0..mechanism.finds.len()).find(written))
    };
    parts(wanted).into_iter().filter_map(of).collect()
}

/// The item of `find` of a name.
fn position(mechanism: &Mechanism, name: &str) -> Option<usize> {
    mechanism.finds.iter().position(|find| same(&find.name, name))
}

/// Whether two texts differ in blanks alone.
fn same(a: &str, b: &str) -> bool {
    let letters = |text: &str| text.chars().filter(|c| !c.is_whitespace()).collect::<String>();
    letters(a) == letters(b)
}

/// The parts of a list between its commas, those in brackets aside.
fn parts(list: &str) -> Vec<&str> {
    let (mut parts, mut depth, mut start) = (Vec::new(), 0_i32, 0);
    for (at, c) in list.char_indices() {
        match c {
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth -= 1,
            ',' if depth == 0 => {
                parts.push(list[start..at].trim());
                start = at + 1;
            }
            _ => {}
        }
    }
    parts.push(list[start..].trim());
    parts.retain(|part| !part.is_empty());
    parts
}
