//! Exact ratios.

use assur_math::math::ratio::{Ratio, solve};

#[test]
fn decimals_are_ratios_as_written() {
    assert_eq!(Ratio::of_decimal(0.3), Ratio::new(3, 10));
    assert_eq!(Ratio::of_decimal(-2.5e3), Ratio::new(-2500, 1));
    assert_eq!(Ratio::of_decimal(1.0 / 3.0), None);
}

#[test]
fn a_system_of_ratios_is_solved_without_rounding() {
    // 0.1 x + 0.2 y = 0.3 and 0.3 x − 0.1 y = 0.2: x = y = 1
    let x = solve(&[0.1, 0.2, 0.3, -0.1], &[0.3, 0.2], 2);
    assert_eq!(x, Some(vec![1.0, 1.0]));
}

#[test]
fn rounded_numbers_are_solved_in_floating_point() {
    let third = 1.0 / 3.0;
    let x = solve(&[0.0, third, third, 0.0], &[1.0, 2.0], 2).unwrap_or_default();
    assert!((x[0] - 6.0).abs() < 1e-14 && (x[1] - 3.0).abs() < 1e-14, "{x:?}");
}

#[test]
fn a_singular_system_has_no_solution() {
    assert_eq!(solve(&[1.0, 2.0, 2.0, 4.0], &[1.0, 1.0], 2), None);
    let third = 1.0 / 3.0;
    assert_eq!(solve(&[third, 1.0, 2.0 * third, 2.0], &[1.0, 1.0], 2), None);
}
