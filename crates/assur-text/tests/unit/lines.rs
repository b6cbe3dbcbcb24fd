//! Lines and columns of a text.

use assur_text::source::{Encoding, LineColumn, Lines};

const TEXT: &str = "mech 1\r\ngiven φ₁ = 1\rlink 曲柄😀\n";

#[test]
fn places_and_bytes_are_the_same() {
    let lines = Lines::of(TEXT);
    for encoding in [Encoding::Utf8, Encoding::Utf16] {
        for (byte, _) in TEXT.char_indices().filter(|(_, c)| !matches!(c, '\r' | '\n')) {
            assert_eq!(lines.byte(lines.place(byte, encoding), encoding), Some(byte), "{byte} {encoding:?}");
        }
    }
}

#[test]
fn columns_are_counted_as_the_editor_does() {
    let lines = Lines::of(TEXT);
    let equals = TEXT.find('=').expect("a sign");
    assert_eq!(lines.place(equals, Encoding::Utf8), LineColumn { line: 1, column: 12 });
    assert_eq!(lines.place(equals, Encoding::Utf16), LineColumn { line: 1, column: 9 });
    let end = TEXT.len() - 1;
    assert_eq!(lines.place(end, Encoding::Utf16), LineColumn { line: 2, column: 9 });
    assert_eq!(lines.place(999, Encoding::Utf8), LineColumn { line: 3, column: 0 });
}

#[test]
fn what_is_no_place_has_no_byte() {
    let lines = Lines::of(TEXT);
    let byte = |line, column, encoding| lines.byte(LineColumn { line, column }, encoding);
    assert_eq!(byte(0, 999, Encoding::Utf16), Some(6), "past its line");
    assert_eq!(byte(9, 0, Encoding::Utf16), None, "past the text");
    assert_eq!(byte(2, 8, Encoding::Utf16), None, "within a pair of units");
    assert_eq!(byte(1, 7, Encoding::Utf8), None, "within a character");
    assert_eq!(byte(3, 0, Encoding::Utf8), Some(TEXT.len()));
}
