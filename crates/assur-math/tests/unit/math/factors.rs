//! Linear systems with twice the digits.

use assur_math::math::{Double, Factors, Scalar};

fn filled(rows: &[&[f64]]) -> Vec<Vec<Double>> {
    rows.iter().map(|row| row.iter().map(|x| Double::of(*x)).collect()).collect()
}

#[test]
fn solves_to_thirty_digits() {
    let rows: [&[f64]; 4] =
        [&[0.0, 2.0, 1.0, 0.0], &[100.0, 3.0, -1.0, 0.0], &[1.0, 0.5, 4.0, 0.1], &[0.0, 0.0, 1e-9, 7.0]];
    let matrix = filled(&rows);
    let third = Double::one() / Double::of(3.0);
    let x = [third, -third * Double::of(1e5), Double::of(0.1), third / Double::of(7.0)];
    let b: Vec<Double> = matrix
        .iter()
        .map(|row| row.iter().zip(&x).fold(Double::zero(), |sum, (a, x)| sum + *a * *x))
        .collect();
    let got = Factors::new(matrix).expect("regular").solve(&b);
    for (got, want) in got.iter().zip(&x) {
        assert!((*got - *want).high.abs() <= 1e-26, "{got:?} for {want:?}");
    }
}

#[test]
fn tells_singular_from_nearly_so() {
    assert!(Factors::new(filled(&[&[1.0, 2.0], &[2.0, 4.0]])).is_none());
    assert!(Factors::new(filled(&[&[0.0, 0.0], &[2.0, 4.0]])).is_none());
    assert!(Factors::new(filled(&[&[f64::NAN, 0.0], &[2.0, 4.0]])).is_none());
    let nearly = Factors::new(filled(&[&[1.0, 1.0], &[1.0, 1.0 + f64::EPSILON]])).expect("regular");
    let x = nearly.solve(&[Double::of(2.0), Double::of(2.0)]);
    assert!((x[0] - Double::of(2.0)).high.abs() < 1e-15 && x[1].high.abs() < 1e-15);
}
