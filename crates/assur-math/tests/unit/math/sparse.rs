//! Systems with many zeros.

use assur_math::math::{Dense, Lu, Sparse};

/// Random rows of order `n`, of which about `share` in ten are not zero.
fn rows(n: usize, share: u64, seed: &mut u64) -> Vec<Vec<f64>> {
    let mut next = || {
        *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        *seed >> 33
    };
    let mut one = || if next() % 10 < share { (next() % 2001) as f64 / 1000.0 - 1.0 } else { 0.0 };
    (0..n).map(|_| (0..n).map(|_| one()).collect()).collect()
}

#[test]
fn has_the_bits_of_the_dense_elimination() {
    let (mut seed, mut regular) = (1, 0);
    for n in 1..30 {
        for share in [2, 4, 10] {
            let rows = rows(n, share, &mut seed);
            let (mut sparse, mut dense) = (Sparse::new(n), Lu::new(n));
            for (i, row) in rows.iter().enumerate() {
                sparse.set_row(i, row.iter().copied());
                dense.set_row(i, row.iter().copied());
            }
            assert_eq!(sparse.factor(), dense.factor());
            assert_eq!(sparse.sign(), dense.sign());
            if sparse.sign() == 0.0 {
                continue;
            }
            regular += 1;
            let [mut x, mut y] = [0, 1].map(|_| (0..n).map(|i| i as f64 - 3.5).collect::<Vec<f64>>());
            sparse.solve(&mut x);
            dense.solve(&mut y);
            assert_eq!(x, y);
        }
    }
    assert!(regular > 40, "{regular}");
}

#[test]
fn tells_the_condition_by_its_inverse() {
    let mut seed = 2;
    for n in 2..20 {
        let rows = rows(n, 5, &mut seed);
        let mut a = Dense::new(n);
        rows.iter().enumerate().for_each(|(i, row)| a.row_mut(i).copy_from_slice(row));
        if !a.factor() {
            continue;
        }
        // the inverse of the scaled matrix, column by column
        let mut sums = vec![0.0; n];
        let greatest = (0..n).fold(vec![0.0; n], |mut all: Vec<f64>, column| {
            let mut x = vec![0.0; n];
            x[column] = 1.0 / a.row_scale(column);
            a.solve(&mut x);
            all.iter_mut().zip(&x).for_each(|(sum, x)| *sum += x.abs());
            all
        });
        let expected = 1.0 / greatest.iter().fold(1.0, |most: f64, sum| most.max(*sum));
        let sigma = a.reciprocal_condition(&mut sums);
        assert!((sigma - expected).abs() <= 1e-9 * expected, "{n}: {sigma} {expected}");
        let mut both =
            (0..n).map(|j| (0..n).map(|i| rows[i][j] * (i as f64 + 1.0)).sum()).collect::<Vec<f64>>();
        a.solve_transposed(&mut both);
        for (i, x) in both.iter().enumerate() {
            assert!((x - (i as f64 + 1.0)).abs() <= 1e-12 * n as f64 / sigma, "{n}: {x}");
        }
    }
}
