//! Reports in Markdown.

use assur::internals::report::document::{Block, Column, Report, Section, Table};
use assur::internals::report::markdown::render;

#[test]
fn signs_of_markdown_are_escaped() {
    let mut table = Table::new(vec![Column::words("pose"), Column::numbers("|F| [N*m]")], 1);
    table.row(vec!["1".into(), "-0.5".into()]);
    let mut section = Section::new("Answers");
    section.list(vec!["v_B".into()]);
    section.blocks.push(Block::Text("a*b".into()));
    section.table(table);
    let report = Report { title: "A".into(), notes: vec!["Find `x`.".into()], sections: vec![section] };
    insta::assert_snapshot!(render(&report), @r"
    # A

    Find \`x\`.

    ## Answers

    - v\_B

    a\*b

    | pose | \|F\| \[N\*m\] |
    | :--- | ---: |
    | 1 | -0.5 |
    ");
}
