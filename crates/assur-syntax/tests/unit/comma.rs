//! Commas between digits.

use assur_syntax::{between_digits, readings};

#[test]
fn three_digits_may_be_thousands() {
    for (text, wanted) in [
        ("0,5", &["0.5"][..]),
        ("120,5; 10,0", &["120.5; 10.0"]),
        ("0,500", &["0.500"]),
        ("1500,250", &["1500.250"]),
        ("1,500 rpm", &["1.500 rpm", "1500 rpm"]),
        ("1,420.5", &["1420.5"]),
        ("12,345,678", &["12345678"]),
        ("a, 5,1", &["a, 5.1"]),
    ] {
        assert_eq!(readings(text, &between_digits(text)), wanted, "{text}");
    }
}
