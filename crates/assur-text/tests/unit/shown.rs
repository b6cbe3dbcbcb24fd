//! Characters that a terminal obeys.

use assur_text::source::{shown, shown_in_line};

#[test]
fn commands_to_the_terminal_are_spelt_out() {
    assert_eq!(shown("a\u{1b}[2J\u{7}\u{9b}m\u{202e}b"), "a\\u{1b}[2J\\u{7}\\u{9b}m\\u{202e}b");
    assert_eq!(shown("Kurbel φ 曲柄\n\tx"), "Kurbel φ 曲柄\n\tx");
    assert_eq!(shown_in_line("a\r\nb\u{2066}"), "a\\u{d}\\u{a}b\\u{2066}");
}
