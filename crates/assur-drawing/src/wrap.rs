//! Lines of a text that is too long for one: broken between its items, which two blanks part, else at blanks.

use crate::text::{Level, Run, Text};

/// The lines of a text, none wider than this where its words are not.
pub fn wrapped(text: &Text, size: f64, width: f64) -> Vec<Text> {
    let blank = if text.runs.iter().any(|run| run.letters.contains("  ")) { "  " } else { " " };
    let is_wide = |text: &Text| text.bounds(size).size().x > width;
    if !is_wide(text) {
        return vec![text.clone()];
    }
    let mut lines: Vec<Text> = Vec::new();
    for word in words(text, blank) {
        let longer = lines.last().map(|line| joined(line, &word, blank)).filter(|line| !is_wide(line));
        match (longer, lines.last_mut()) {
            (Some(longer), Some(last)) => *last = longer,
            _ => lines.push(word),
        }
    }
    lines
}

/// The parts of a text between its blanks.
fn words(text: &Text, blank: &str) -> Vec<Text> {
    let mut words = vec![Text::default()];
    for run in &text.runs {
        for (i, part) in run.letters.split(blank).enumerate() {
            if i > 0 && words.last().is_some_and(|word| !word.runs.is_empty()) {
                words.push(Text::default());
            }
            if let (Some(word), false) = (words.last_mut(), part.is_empty()) {
                word.runs.push(Run { letters: part.to_owned(), ..run.clone() });
            }
        }
    }
    words.retain(|word| !word.runs.is_empty());
    words
}

fn joined(line: &Text, word: &Text, between: &str) -> Text {
    let mut line = line.clone();
    for (i, run) in word.runs.iter().enumerate() {
        let blank = if i == 0 { between } else { "" };
        match line.runs.last_mut() {
            Some(last) if last.italic == run.italic && last.level == run.level => {
                last.letters += &format!("{blank}{}", run.letters);
            }
            _ if run.level == Level::Base => {
                line.runs.push(Run { letters: format!("{blank}{}", run.letters), ..run.clone() });
            }
            _ => line.runs.push(run.clone()),
        }
    }
    line
}
