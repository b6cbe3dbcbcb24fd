//! All solutions of systems with magnitudes.

use assur_math::math::{AbsLinearSystem, Dense, Part, Vec2};

/// What a solution may leave of the equations.
const SOLVED: f64 = 1e-11;

/// Numbers of a fixed sequence, between −1 and 1.
struct Sequence(u64);

impl Sequence {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        f64::from((self.0 >> 33) as u32) / f64::from(1_u32 << 30) - 1.0
    }
}

fn random(sequence: &mut Sequence, numbers: usize, planes: usize, strength: f64) -> AbsLinearSystem {
    let n = numbers + planes;
    let part = |row: usize, sequence: &mut Sequence| {
        let plane = row >= numbers;
        let mut vector =
            |by: f64| Vec2::new(sequence.next() * by, if plane { sequence.next() * by } else { 0.0 });
        let constant = vector(1.0);
        Part { row, plane, constant, slopes: (0..n).map(|_| vector(strength)).collect() }
    };
    let parts = (0..n).map(|row| part(row, sequence)).collect();
    AbsLinearSystem { orientation: 1.0, weights: (0..n).map(|_| sequence.next().signum()).collect(), parts }
}

/// All patterns of signs, one linear system each.
fn by_patterns(system: &AbsLinearSystem) -> usize {
    let n = system.len();
    let sign = |pattern: usize, p: usize| if pattern >> p & 1 == 0 { 1.0 } else { -1.0 };
    (0..1_usize << n)
        .filter(|pattern| {
            let (mut matrix, mut x) = (Dense::new(n), vec![0.0; n]);
            (0..n).for_each(|i| matrix.row_mut(i)[i] = 1.0);
            for (p, part) in system.parts.iter().enumerate() {
                let weight = system.weights[part.row] * sign(*pattern, p);
                for (slot, slope) in matrix.row_mut(part.row).iter_mut().zip(&part.slopes) {
                    *slot += weight * slope.x;
                }
                x[part.row] -= weight * part.constant.x;
            }
            assert!(matrix.factor(), "regular");
            matrix.solve(&mut x);
            system.parts.iter().enumerate().all(|(p, part)| sign(*pattern, p) * part.at(&x).x >= 0.0)
        })
        .count()
}

#[test]
fn finds_what_all_patterns_of_signs_give() {
    let mut sequence = Sequence(1);
    let mut counts = [0; 4];
    for i in 0..600 {
        let system = random(&mut sequence, 6, 0, 0.1 + 0.002 * f64::from(i));
        let found = system.solutions(1e9);
        let expected = by_patterns(&system);
        assert!(found.complete, "system {i}");
        assert_eq!(found.found.len(), expected, "system {i}");
        counts[expected.min(3)] += 1;
    }
    assert!(counts[..3].iter().all(|c| *c > 10), "{counts:?}");
}

#[test]
fn finds_the_roots_of_a_quadratic_equation() {
    let mut sequence = Sequence(2);
    let mut counts = [0; 3];
    for i in 0..300 {
        let system = random(&mut sequence, 0, 1, 0.5 + 0.01 * f64::from(i));
        // x² = |c + g x|² with the sign of −w
        let part = &system.parts[0];
        let (g, c, w) = (part.slopes[0], part.constant, system.weights[0]);
        let (a, b, d) = (g.dot(g) - 1.0, g.dot(c), c.dot(c));
        let root = b * b - a * d;
        let roots = if root < 0.0 { vec![] } else { vec![(-b - root.sqrt()) / a, (-b + root.sqrt()) / a] };
        let expected = roots.iter().filter(|x| **x * w < 0.0).count();
        let found = system.solutions(1e9);
        assert!(found.complete, "system {i}");
        assert_eq!(found.found.len(), expected, "system {i}: {found:?} {roots:?}");
        counts[expected] += 1;
    }
    assert!(counts.iter().all(|c| *c > 20), "{counts:?}");
}

#[test]
fn numbers_and_vectors_together_solve_what_they_say() {
    let mut sequence = Sequence(3);
    let mut counts = [0; 4];
    for i in 0..200 {
        let system = random(&mut sequence, 2, 3, 0.1 + 0.005 * f64::from(i));
        let found = system.solutions(1e9);
        assert!(found.complete, "system {i}");
        for x in &found.found {
            assert!(system.residual(x) <= SOLVED);
        }
        // none that Newton's method finds from anywhere is missing
        for _ in 0..40 {
            let start: Vec<f64> = (0..5).map(|_| 5.0 * sequence.next()).collect();
            let Some(other) = system.newton(&start).filter(|f| system.residual(&f.x) <= SOLVED) else {
                continue;
            };
            let near =
                |x: &Vec<f64>| x.iter().zip(&other.x).all(|(a, b)| (a - b).abs() < 1e-6 * (1.0 + b.abs()));
            assert!(found.found.iter().any(near), "system {i}: {:?} of {:?}", other.x, found.found);
        }
        counts[found.found.len().min(3)] += 1;
    }
    assert!(counts.iter().sum::<i32>() == 200 && counts[..2].iter().all(|c| *c > 10), "{counts:?}");
    assert!(counts[2] + counts[3] > 5, "{counts:?}");
}
