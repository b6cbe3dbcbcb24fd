//! Elimination over the prime field.

use assur_model::structure::echelon::{Echelon, Number, Row, row};

fn some(columns: &[usize], seed: u64) -> Row {
    row(columns.iter().map(|&c| (c, Number::random(seed + c as u64))).collect())
}

#[test]
fn a_sum_of_rows_depends_on_them() {
    let (a, b) = (some(&[0, 2, 3], 10), some(&[1, 2], 20));
    let sum = row(a.iter().chain(&b).copied().collect());
    let mut echelon = Echelon::of(4, [&a, &b]);
    assert!(!echelon.add(sum));
    assert_eq!(echelon.rank(), 2);
    assert!(echelon.add(some(&[0, 1], 30)));
}

#[test]
fn null_vectors_are_taken_to_zero() {
    let rows = [some(&[0, 2, 3], 1), some(&[1, 2, 4], 2), some(&[0, 3, 4], 3)];
    let x = Echelon::of(5, &rows).null_vector(|c| Number::random(c as u64));
    assert!(x.iter().any(|x| !x.is_zero()));
    for row in &rows {
        let sum = row.iter().fold(Number::ZERO, |sum, t| sum + t.1 * x[t.0]);
        assert!(sum.is_zero());
    }
}
