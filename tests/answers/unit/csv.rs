//! Tables as comma-separated values.

use assur::internals::report::csv::{field, render};
use assur::internals::report::document::{Column, Table};

#[test]
fn formulas_are_texts() {
    assert_eq!(field("=1+1"), "'=1+1");
    assert_eq!(field("=HYPERLINK(\"a\",\"b\")"), "\"'=HYPERLINK(\"\"a\"\",\"\"b\"\")\"");
    assert_eq!(field("-0.125"), "-0.125");
}

#[test]
fn fields_with_commas_and_quotes_are_quoted() {
    let mut table = Table::new(vec![Column::words("pose"), Column::numbers("reaction(B, rod).x [N]")], 1);
    table.row(vec!["the \"first\"".into(), "1.5".into()]);
    assert_eq!(render(&table), "pose,\"reaction(B, rod).x [N]\"\r\n\"the \"\"first\"\"\",1.5\r\n");
}
