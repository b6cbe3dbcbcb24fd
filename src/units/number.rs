//! Numbers in decimal figures.

/// A number rounded to so many significant digits, without trailing zeros: `98.212`, `-0.0024`, `1.5e9`.
///
/// Very large and very small numbers are written with an exponent.
#[must_use]
pub fn significant(x: f64, digits: usize) -> String {
    if x == 0.0 || !x.is_finite() {
        return if x == 0.0 { "0".to_owned() } else { x.to_string() };
    }
    let digits = digits.clamp(1, 17);
    let scientific = format!("{:.*e}", digits - 1, x);
    let Some((mantissa, exponent)) = scientific.split_once('e') else { return scientific };
    let power = exponent.parse::<i32>().unwrap_or(0);
    if !(-5..=6).contains(&power) {
        return format!("{}e{exponent}", without_trailing_zeros(mantissa));
    }
    let before = usize::try_from(power + 1).unwrap_or(0);
    let zeros = usize::try_from(-power - 1).unwrap_or(0);
    let decimals = if power >= 0 { digits.saturating_sub(before) } else { digits + zeros };
    without_trailing_zeros(&format!("{x:.decimals$}")).to_owned()
}

fn without_trailing_zeros(figures: &str) -> &str {
    if figures.contains('.') { figures.trim_end_matches('0').trim_end_matches('.') } else { figures }
}

#[cfg(test)]
mod tests {
    use super::significant;

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
}
