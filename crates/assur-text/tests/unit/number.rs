//! Numbers in decimal figures.

use assur_text::units::significant;

#[test]
fn rounds_to_significant_digits() {
    for (x, text) in [
        (0.0, "0"),
        (-0.0, "0"),
        (1.0, "1"),
        (98.212_039, "98.212"),
        (-0.002_400_000_01, "-0.0024"),
        (999_999.96, "1000000"),
        (123_456.7, "123457"),
        (1.5e9, "1.5e9"),
        (-2.0e-7, "-2e-7"),
        (0.1 + 0.2, "0.3"),
        (0.000_012_345_67, "0.0000123457"),
    ] {
        assert_eq!(significant(x, 6), text, "{x}");
    }
}

#[test]
fn seventeen_digits_are_all_there_are() {
    assert_eq!(significant(0.1, 17), "0.10000000000000001");
    assert_eq!(significant(250.0, 17), "250");
}
