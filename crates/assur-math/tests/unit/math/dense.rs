//! Dense linear systems.

use assur_math::math::{Dense, Lu};

fn filled(rows: &[&[f64]]) -> Dense {
    let mut a = Dense::new(rows.len());
    for (i, row) in rows.iter().enumerate() {
        a.row_mut(i).copy_from_slice(row);
    }
    a
}

#[test]
fn solves_both_ways() {
    let rows: [&[f64]; 3] = [&[0.0, 2.0, 1.0], &[100.0, 3.0, -1.0], &[1.0, 0.5, 4.0]];
    let mut a = filled(&rows);
    assert!(a.factor());
    assert_eq!(a.sign(), -1.0);
    let x = [1.0, -2.0, 3.0];
    let mut b = [0, 1, 2].map(|i: usize| (0..3).map(|j| rows[i][j] * x[j]).sum::<f64>());
    a.solve(&mut b);
    let mut c = [0, 1, 2].map(|j: usize| (0..3).map(|i| rows[i][j] * x[i]).sum::<f64>());
    a.solve_transposed(&mut c);
    for i in 0..3 {
        assert!((b[i] - x[i]).abs() < 1e-14 && (c[i] - x[i]).abs() < 1e-14);
    }
}

#[test]
fn tells_its_condition() {
    let mut sums = [0.0; 2];
    let mut a = filled(&[&[1.0, 0.0], &[0.0, 1e9]]);
    assert!(a.factor());
    assert_eq!(a.reciprocal_condition(&mut sums), 1.0);
    let mut a = filled(&[&[1.0, 1.0], &[1.0, 1.0 + 1e-6]]);
    assert!(a.factor());
    let sigma = a.reciprocal_condition(&mut sums);
    assert!(sigma > 1e-7 && sigma < 1e-6);
    let mut a = filled(&[&[1.0, 2.0], &[2.0, 4.0]]);
    assert!(!a.factor());
    assert_eq!((a.sign(), a.reciprocal_condition(&mut sums)), (0.0, 0.0));
    assert!(!filled(&[&[f64::NAN]]).factor());
}

#[test]
fn factors_in_place() {
    let rows = [[1.0, 2.0], [4.0, 2.0]];
    let mut lu = Lu::new(2);
    let mut fill = |rows: [[f64; 2]; 2]| {
        rows.iter().enumerate().for_each(|(i, row)| lu.set_row(i, row.iter().copied()));
        (lu.factor(), lu.clone())
    };
    let (regular, mut lu) = fill(rows);
    assert!(regular);
    assert_eq!((lu.order(), lu.sign(), lu.least_pivot()), (2, -1.0, 1.5));
    let mut b = [5.0, 8.0];
    lu.solve(&mut b);
    assert_eq!(b, [1.0, 2.0]);
    let (regular, lu) = fill([[3.0, 7.0], [3.0, 7.0]]);
    assert!(!regular && lu.sign() == 0.0);
    assert!(!fill([[1.0, 0.0], [0.0, f64::NAN]]).0);
}

#[test]
fn nothing_is_regular() {
    let mut lu = Lu::new(0);
    assert!(lu.factor());
    lu.solve(&mut []);
}
