//! Cells of a line.

use assur::internals::exercise::table::{Separator, cells};
use assur::internals::source::Span;

fn texts(line: &str) -> Vec<String> {
    cells(line, Separator::of(line))
        .expect("quotes are closed")
        .into_iter()
        .map(|c| c.text.into_owned())
        .collect()
}

#[test]
fn cells_with_and_without_quotes() {
    assert_eq!(texts("1, 2,,3"), ["1", "2", "", "3"]);
    assert_eq!(texts(r#""a, ""b""" ,2"#), [r#"a, "b""#, "2"]);
    assert_eq!(texts("1,5; 2"), ["1,5", "2"]);
    assert_eq!(texts("\"a;b\",2"), ["a;b", "2"]);
    assert_eq!(texts(""), [""]);
}

#[test]
fn a_quote_that_is_not_closed_has_a_place() {
    assert_eq!(cells("1,\"2,3", Separator::Comma), Err(Span::new(2, 6)));
    assert_eq!(cells("\"1\"2,3", Separator::Comma), Err(Span::new(0, 6)));
}
