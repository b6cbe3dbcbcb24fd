//! Numbers in tables.

use assur::internals::exercise::table::{PreciseNumber, Separator};

#[test]
fn numbers_with_point_or_comma() {
    let comma = |text| PreciseNumber::read(text, Separator::Comma);
    let semicolon = |text| PreciseNumber::read(text, Separator::Semicolon).map(|w| w.value);
    assert_eq!(comma("0.350"), Ok(PreciseNumber { value: 0.35, digit: 1e-3 }));
    assert_eq!(comma("1.5e3"), Ok(PreciseNumber { value: 1500.0, digit: 100.0 }));
    assert_eq!(comma("−2").map(|w| w.value), Ok(-2.0));
    assert_eq!(semicolon("1,5"), Ok(1.5));
    assert_eq!(semicolon("-1.5"), Ok(-1.5));
}

#[test]
fn what_is_no_number_is_told() {
    for (text, says) in [
        ("0,5", "decimal comma"),
        ("1,500", "thousands"),
        ("1,500.5", "separates thousands"),
        ("120 mm", "has a unit"),
        ("inf", "not a number"),
        ("nan", "not a number"),
        ("1e999", "too large"),
        ("--1", "not a number"),
        ("1.500,5", "not a number"),
    ] {
        let (why, _) = PreciseNumber::read(text, Separator::Comma).unwrap_err();
        assert!(why.contains(says), "{text}: {why}");
    }
}
