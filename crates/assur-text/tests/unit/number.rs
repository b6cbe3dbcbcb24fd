//! Numbers in decimal figures.

use assur_text::units::significant;
use proptest::prelude::*;

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

/// As `format!` rounds, which knows all digits of a number.
fn as_formatted(x: f64, digits: usize) -> (String, i32) {
    let text = format!("{:.*e}", digits - 1, x.abs());
    let (mantissa, exponent) = text.split_once('e').expect("an exponent");
    let figures: String = mantissa.chars().filter(char::is_ascii_digit).collect();
    let figures = figures.trim_end_matches('0');
    (figures.to_owned(), exponent.parse().expect("a power"))
}

/// The figures and the power of ten of a text.
fn as_written(text: &str) -> (String, i32) {
    let (mantissa, exponent) = text.trim_start_matches('-').split_once('e').unwrap_or((text, "0"));
    let (whole, part) = mantissa.trim_start_matches('-').split_once('.').unwrap_or((mantissa, ""));
    let all = format!("{}{part}", whole.trim_start_matches('-'));
    let figures = all.trim_start_matches('0');
    let leading = i32::try_from(all.len() - figures.len()).expect("few digits");
    let whole = i32::try_from(whole.trim_start_matches('-').len()).expect("few digits");
    let power: i32 = exponent.parse().expect("a power");
    (figures.trim_end_matches('0').to_owned(), power + whole - 1 - leading)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(20_000))]

    #[test]
    fn every_number_is_rounded_as_all_its_digits_say(bits in any::<u64>(), digits in 1_usize..=17) {
        let x = f64::from_bits(bits);
        if x.is_finite() && x != 0.0 {
            prop_assert_eq!(as_written(&significant(x, digits)), as_formatted(x, digits));
        }
    }

    #[test]
    fn numbers_without_exponent_too(mantissa in -10.0..10.0_f64, power in -7_i32..8, digits in 1_usize..=17) {
        let x = mantissa * 10.0_f64.powi(power);
        prop_assert_eq!(as_written(&significant(x, digits)), as_formatted(x, digits));
    }

    #[test]
    fn nines_carry(nines in 1_u32..=16, power in -7_i32..8, digits in 1_usize..=17) {
        let x = (1.0 - 10.0_f64.powi(-i32::try_from(nines).unwrap_or(0))) * 10.0_f64.powi(power);
        prop_assert_eq!(as_written(&significant(x, digits)), as_formatted(x, digits));
    }

    #[test]
    fn numbers_of_few_digits_too(mantissa in -99_999_999_i64..99_999_999, power in -12_i32..12, digits in 1_usize..=17) {
        let x = mantissa as f64 * 10_f64.powi(power);
        if x != 0.0 {
            prop_assert_eq!(as_written(&significant(x, digits)), as_formatted(x, digits));
        }
    }

    #[test]
    fn halves_go_as_all_digits_say(mantissa in 1_i64..1_000_000, shift in 0_i32..12, digits in 1_usize..=7) {
        let x = (mantissa as f64 + 0.5) / f64::from(1 << shift);
        prop_assert_eq!(as_written(&significant(x, digits)), as_formatted(x, digits));
    }
}
