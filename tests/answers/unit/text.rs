//! Reports for a terminal.

use assur::internals::report::document::{Block, Column, Report, Section, Table};
use assur::internals::report::text::{Look, render};

fn sweep() -> Report {
    let mut table = Table::new(vec![Column::words("pose"), Column::numbers("phi [deg]")], 1);
    for name in ["a", "b", "c"] {
        table.columns.push(Column::numbers(format!("v_{name} [m/s]")));
    }
    table.row(["1", "0", "1.25", "-10.5", "曲"].map(String::from).to_vec());
    table.row(["10", "22.5", "-0.125", "100", "—"].map(String::from).to_vec());
    let mut section = Section::new("Answers");
    section.blocks.push(Block::Facts(vec![("φ".into(), "one".into()), ("曲柄".into(), "two".into())]));
    section.table(table);
    Report { title: "A title".into(), notes: vec!["A note.".into()], sections: vec![section] }
}

#[test]
fn numbers_stand_at_their_decimal_points() {
    insta::assert_snapshot!(render(&sweep(), Look::PLAIN), @r"
    A title

    A note.

    Answers
      φ     one
      曲柄  two
      pose  phi [deg]  v_a [m/s]  v_b [m/s]  v_c [m/s]
      ────  ─────────  ─────────  ─────────  ─────────
      1           0        1.25       -10.5         曲
      10         22.5     -0.125      100            —
    ");
}

#[test]
fn wide_tables_are_broken_and_repeat_their_keys() {
    insta::assert_snapshot!(render(&sweep(), Look { colour: false, width: 32, fill: false }), @r"
    A title

    A note.

    Answers
      φ     one
      曲柄  two
      pose  phi [deg]  v_a [m/s]
      ────  ─────────  ─────────
      1           0        1.25
      10         22.5     -0.125

      pose  v_b [m/s]  v_c [m/s]
      ────  ─────────  ─────────
      1         -10.5         曲
      10        100            —
    ");
}
