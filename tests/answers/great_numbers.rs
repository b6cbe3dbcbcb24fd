//! Numbers with which nothing can be computed are an error where they are written, not `inf` and `NaN` in what is printed.

use assur::internals::check::Overrides;
use assur::internals::diagnostic::{Style, render};
use assur::internals::exercise::grade::Sheet;
use assur::internals::source::Source;

fn said(text: &str, set: &[(&str, &str)]) -> String {
    let source = Source::new("great.mech", text);
    let set = set.iter().map(|(name, value)| ((*name).to_owned(), (*value).to_owned())).collect();
    let (_, problems) = assur::internals::solve_source(&source, &Overrides::set(set));
    render(&problems, &source, Style::PLAIN)
}

#[test]
fn great_numbers_are_refused_where_they_are_written() {
    let cases = [
        include_str!("../cases/use3/limits/great-lengths.mech"),
        include_str!("../cases/use3/limits/great-expectation.mech"),
        include_str!("../cases/use3/limits/great-point-drawn.mech"),
    ];
    for case in cases {
        let words = said(case, &[]);
        assert!(words.contains("mech::unit::no_value") && !words.contains("NaN"), "{words}");
    }
    let bar = "given r = 100 mm\nground { O (0, 0) }\nlink a O-A r\nrevolute O: ground - a\ndrive a = 30 deg\nfind position(A)\n";
    assert!(said(bar, &[("r", "1e120mm")]).contains("1e100"));
}

/// Thousands of columns that the key does not have are one warning.
#[test]
fn columns_that_the_key_does_not_have_are_reported_together() {
    let key = Sheet::read("key.csv", "row,x [mm]\n1,413\n".as_bytes(), None).expect("read");
    let key = key.unwrap_or_else(|(_, error)| panic!("{error}"));
    for (count, reported) in [(0, 0), (3, 3), (5, 5), (6, 1), (20_000, 1)] {
        let names: String = (0..count).map(|i| format!(",q{i} [mm]")).collect();
        let text = format!("row,x [mm]{names}\n1,413{}\n", ",1".repeat(count));
        let sheet = Sheet::read("answers.csv", text.as_bytes(), Some(&key)).expect("read");
        let sheet = sheet.unwrap_or_else(|(_, error)| panic!("{error}"));
        assert_eq!(sheet.left_out.len(), reported, "{count}");
        let kept: usize = sheet.left_out.iter().map(|(source, _)| source.text.len()).sum();
        assert!(kept < 1_000, "{count}: {kept} bytes");
    }
}
