//! Reports in LaTeX.

#![allow(clippy::unwrap_used)] // a test that cannot read its files has failed

use assur::internals::check::Overrides;
use assur::internals::report::document::{Column, Report, Section, Table};
use assur::internals::report::{AccuracyShown, Page, PrintedDigits, of_answers};
use assur::internals::source::Source;
use std::path::Path;

fn titled(title: &str) -> String {
    let report = Report { title: title.into(), ..Report::default() };
    Page::Latex.render(&report).trim().to_owned()
}

#[test]
fn signs_are_written_as_latex_reads_them() {
    let written =
        |text: &str| titled(text).trim_start_matches("\\section*{").trim_end_matches('}').to_owned();
    assert_eq!(written("ρ = √2, θ ≤ 5°"), r"$\rho$ = $\surd$2, $\theta$ $\le$ 5$^\circ$");
    assert_eq!(
        written("10⁻⁶ m₁, ω̇, ṡ, q\u{308}"),
        r"10$^-$$^6$ m$_1$, $\dot{\omega}$, $\dot{s}$, $\ddot{q}$"
    );
    assert_eq!(written("50 % & {x}_1"), r"50 \% \& \{x\}\_1");
    // no package, no font encoding
    assert_eq!(written("“a” \"b\" «c»"), "``a'' \\symbol{34}b\\symbol{34} $\\ll$c$\\gg$");
    // letters stay, signs without a place in the table are named
    assert_eq!(written("Kurbel für é Вал"), "Kurbel für é Вал");
    assert_eq!(written("⌘ 🙂"), "U+2318 U+1F642");
}

#[test]
fn no_cell_is_an_argument() {
    let mut table = Table::new(vec![Column::words("pose")], 1);
    table.row(vec!["[a]".into()]);
    table.row(vec!["*b".into()]);
    let mut section = Section::new("Answers");
    section.table(table);
    section.list(vec!["[c]".into()]);
    let report = Report { title: "A".into(), notes: Vec::new(), sections: vec![section] };
    let page = Page::Latex.render(&report);
    for line in ["  {}[a] \\\\\n", "  {}*b \\\\\n", "  \\item {}[c]\n"] {
        assert!(page.contains(line), "no {line} in {page}");
    }
}

#[test]
fn every_example_is_a_page_without_unknown_signs() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let mut pages = 0;
    for path in crate::folder::files(&root, "mech") {
        let source = Source::new(path.display().to_string(), std::fs::read_to_string(&path).unwrap());
        let (Some(solved), _) = assur::internals::solve_source(&source, &Overrides::none()) else { continue };
        let answers = solved.answers(PrintedDigits::READABLE);
        let page = Page::Latex.render(&of_answers("a.mech", &answers, AccuracyShown::EveryPose));
        // letters with accents are read by every engine
        let read = |c: char| c.is_ascii() || c.is_alphabetic() && c <= 'ÿ';
        let left: String = page.chars().filter(|c| !read(*c)).collect();
        assert!(left.is_empty() && !page.contains("U+"), "{}: {left:?}", source.name);
        pages += 1;
    }
    assert!(pages > 100, "{pages}");
}
