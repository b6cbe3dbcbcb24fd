//! The digit that a number was written to.

use assur_check::parts::digit_of;
use assur_syntax::document::Number;

#[test]
fn the_last_digit_written() {
    let of = |text: &str| {
        digit_of(&Number { value: text.parse().unwrap(), text: text.into(), unit: None }).unwrap()
    };
    for (text, digit) in [("26", 1.0), ("0.350", 1e-3), ("1.5e3", 100.0), ("2e-3", 1e-3), ("100.0", 0.1)] {
        assert_eq!(of(text), digit, "{text}");
    }
}
