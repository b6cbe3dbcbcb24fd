//! What is printed on a terminal fits it: sentences and tables are broken at blanks, never in a word or a number.

use assur::internals::check::Overrides;
use assur::internals::diagnostic::{Style, render};
use assur::internals::report::document::Report;
use assur::internals::report::text::{self, Look};
use assur::internals::report::{self, AccuracyShown, PrintedDigits};
use assur::internals::source::Source;
use std::collections::HashSet;
use std::path::Path;
use unicode_width::UnicodeWidthStr;

const WIDTHS: [usize; 3] = [60, 80, 120];

/// A line that is too wide has a word that does not fit, or columns of a table that are as narrow as they can be.
fn fits(report: &Report, name: &str) {
    let wide = text::render(report, Look { colour: false, width: usize::MAX, fill: false });
    let words: HashSet<&str> = wide.split_whitespace().collect();
    for width in WIDTHS {
        let page = text::render(report, Look { colour: false, width, fill: true });
        for line in page.lines() {
            let longest = line.split_whitespace().map(UnicodeWidthStr::width).max().unwrap_or(0);
            let indent = line.width() - line.trim_start().width();
            assert!(
                line.width() <= width || longest + indent > width || longest > width / 2,
                "{name}: {width}: {line}"
            );
            for word in line.split_whitespace() {
                let is_rule = word.chars().all(|c| c == '─');
                assert!(is_rule || words.contains(word), "{name}: {width}: {word} in {line}");
            }
        }
    }
}

#[test]
fn every_example_fits_the_terminal() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let mut count = 0;
    for path in crate::folder::files(&root, "mech") {
        let Ok(text) = std::fs::read_to_string(&path) else { continue };
        let name = path.strip_prefix(&root).unwrap_or(&path).display().to_string();
        let source = Source::new(&*name, text);
        let (compiled, _) = assur::internals::compile(&source, &Overrides::none());
        let Some(compiled) = compiled else { continue };
        fits(&report::of_structure(&source, &compiled.model(), None), &name);
        // motions under loads print what sweeps print, and take their time
        if compiled.mechanism.simulation.is_none()
            && let (Ok(solved), _) = assur::internals::pipeline::solve(compiled)
        {
            let answers = solved.answers(PrintedDigits::READABLE);
            fits(&report::of_answers(&source.name, &answers, AccuracyShown::EveryPose), &name);
            count += 1;
        }
    }
    assert!(count > 100, "{count}");
}

/// The words of a message are those of a message that is not broken.
#[test]
fn messages_fit_the_terminal() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/errors");
    for path in crate::folder::files(&root, "mech") {
        let Ok(text) = std::fs::read_to_string(&path) else { continue };
        let source = Source::new("text.mech", text);
        let (_, problems) = assur::internals::check_source(&source, &Overrides::none());
        let drawn = |width| render(&problems, &source, Style::Graphical { colour: false, width });
        let wide = drawn(10_000);
        let words: HashSet<&str> = wide.split_whitespace().collect();
        for width in WIDTHS {
            for word in drawn(width).split_whitespace() {
                assert!(words.contains(word) || word == "│", "{}: {width}: {word}", path.display());
            }
        }
    }
}
