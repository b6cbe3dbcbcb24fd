//! Texts of labels for TeX: quantities as maths, no letter outside ASCII.

use crate::text::{Level, Run, Text, greek_name, lowered};
use std::fmt::Write;

/// A letter that is not in ASCII, by its number for LuaTeX and by its bytes for pdfTeX, where the document has it.
pub const LETTER: &str = "\\providecommand\\assurletter[2]{\\ifdefined\\Uchar\\Uchar\"#1 \\else\\ifcsname \
                      u8:\\detokenize{#2}\\endcsname#2\\else?\\fi\\fi}\n";

/// A text as maths where it is a quantity, else as words.
pub fn letters(text: &Text) -> String {
    let (mut out, mut is_maths) = (String::new(), false);
    // what the last letter has: an index, an exponent
    let mut has = [false; 2];
    for run in &text.runs {
        let is_prime = run.letters.chars().all(|c| c == '′');
        let wants_maths = run.italic || is_prime || run.level != Level::Base;
        if wants_maths != is_maths {
            out.push('$');
            is_maths = wants_maths;
        }
        let raises = usize::from(run.level == Level::Sup || is_prime);
        if run.level == Level::Base && !is_prime {
            has = [false; 2];
        } else if std::mem::replace(&mut has[raises], true) {
            // a second index is one of nothing
            out.push_str("{}");
            has = [raises == 0, raises == 1];
        }
        match run.level {
            Level::Base if is_prime => out.push_str(&"'".repeat(run.letters.chars().count())),
            Level::Base if run.italic => out.push_str(&maths(run)),
            Level::Base => run.letters.chars().for_each(|c| word(&mut out, c)),
            Level::Sub => out.extend(["_{", &maths(run), "}"]),
            Level::Sup => out.extend(["^{", &maths(run), "}"]),
        }
    }
    out.push_str(if is_maths { "$" } else { "" });
    out
}

/// Letters within maths: one of a quantity is slanted as it is, words have their own face.
fn maths(run: &Run) -> String {
    let mut out = String::new();
    for c in run.letters.chars() {
        match symbol(c) {
            Some(symbol) => out.push_str(&symbol),
            None if c.is_ascii_alphanumeric() || ",.+-=()/".contains(c) => out.push(c),
            None if c == ' ' => out.push_str("\\ "),
            None => {
                out.push_str("\\mbox{");
                word(&mut out, c);
                out.push('}');
            }
        }
    }
    let mut letters = run.letters.chars().filter(char::is_ascii_alphabetic);
    let is_word = letters.next().is_some() && (!run.italic || letters.next().is_some());
    match is_word {
        true if run.italic => format!("\\mathit{{{out}}}"),
        true => format!("\\mathrm{{{out}}}"),
        false => out,
    }
}

/// A letter that is one of maths alone.
fn symbol(c: char) -> Option<String> {
    if let Some(name) = greek_name(c) {
        return Some(format!("\\{name} "));
    }
    if let Some(digit) = lowered(c) {
        return Some(format!("^{{{}}}{{}}", if digit == '−' { '-' } else { digit }));
    }
    let name = match c {
        '−' => "-",
        '·' => "\\cdot ",
        '×' => "\\times ",
        '±' => "\\pm ",
        '°' => "^{\\circ}{}",
        '′' => "'",
        'µ' => "\\mu ",
        '…' => "\\ldots ",
        '≤' => "\\le ",
        '≥' => "\\ge ",
        '≈' => "\\approx ",
        '→' => "\\to ",
        '∞' => "\\infty ",
        '⌀' | '∅' | 'Ø' => "\\oslash ",
        '<' | '>' | '|' | '*' => return Some(c.to_string()),
        _ => return None,
    };
    Some(name.to_owned())
}

/// A letter of a word.
fn word(out: &mut String, c: char) {
    match (c, symbol(c)) {
        (_, Some(symbol)) => out.extend(["$", &symbol, "$"]),
        ('\\', _) => out.push_str("\\textbackslash{}"),
        ('~', _) => out.push_str("\\textasciitilde{}"),
        ('^', _) => out.push_str("\\textasciicircum{}"),
        ('"', _) => out.push_str("''"),
        ('#' | '$' | '%' | '&' | '_' | '{' | '}', _) => out.extend(['\\', c]),
        (c, _) if c.is_ascii_graphic() || c == ' ' => out.push(c),
        (c, _) if c.is_control() => {}
        (c, _) => {
            let bytes: String = c.to_string().bytes().map(|b| format!("^^{b:02x}")).collect();
            let _ = write!(out, "\\assurletter{{{:04X}}}{{{bytes}}}", u32::from(c));
        }
    }
}
