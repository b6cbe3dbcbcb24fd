//! The conditions of order of a Runge–Kutta method: one for each rooted tree.

use assur_math::math::Double;
use assur_math::math::Scalar;
use assur_math::math::ode::dop853::coefficients as c;

/// A rooted tree: what grows from its root.
#[derive(Clone, Debug, PartialEq, PartialOrd)]
struct Tree(Vec<Tree>);

impl Tree {
    fn order(&self) -> usize {
        1 + self.0.iter().map(Tree::order).sum::<usize>()
    }

    fn density(&self) -> f64 {
        self.0.iter().map(Tree::density).product::<f64>() * self.order() as f64
    }

    /// The weight of each stage.
    fn weights(&self, stages: &[Vec<Double>]) -> Vec<Double> {
        let children: Vec<_> = self.0.iter().map(|tree| tree.weights(stages)).collect();
        let along = |row: &Vec<Double>, of: &Vec<Double>| {
            row.iter().zip(of).fold(Double::zero(), |sum, (a, b)| sum + *a * *b)
        };
        stages
            .iter()
            .map(|row| children.iter().fold(Double::one(), |product, of| product * along(row, of)))
            .collect()
    }
}

/// All rooted trees of an order: branches in falling sequence.
fn trees(order: usize) -> Vec<Tree> {
    fn forests(size: usize, below: Option<&Tree>) -> Vec<Vec<Tree>> {
        if size == 0 {
            return vec![Vec::new()];
        }
        let mut all = Vec::new();
        for first in 1..=size {
            for tree in trees(first) {
                if below.is_some_and(|below| (below.order(), below) < (first, &tree)) {
                    continue;
                }
                for mut rest in forests(size - first, Some(&tree)) {
                    rest.insert(0, tree.clone());
                    all.push(rest);
                }
            }
        }
        all
    }
    forests(order - 1, None).into_iter().map(Tree).collect()
}

fn two([high, low]: [f64; 2]) -> Double {
    Double::of(high) + Double::of(low)
}

fn spread<const M: usize>(row: &c::Row<M>) -> Vec<Double> {
    let mut out = vec![Double::zero(); 16];
    row.from.iter().zip(row.of).for_each(|(&from, of)| out[from] = two(of));
    out
}

/// All sixteen stages.
fn stages() -> Vec<Vec<Double>> {
    let mut rows = vec![vec![Double::zero(); 16]];
    macro_rules! push { ($($name:ident)*) => { $(rows.push(spread(&c::$name));)* } }
    push!(STAGE_2 STAGE_3 STAGE_4 STAGE_5 STAGE_6 STAGE_7 STAGE_8 STAGE_9 STAGE_10 STAGE_11 STAGE_12 END);
    push!(STAGE_14 STAGE_15 STAGE_16);
    rows
}

/// What the weights of an end leave of the conditions of an order, for a part of the step.
fn worst(stages: &[Vec<Double>], end: &[Double], order: usize, part: f64) -> f64 {
    let left = |tree: Tree| {
        let sum = tree.weights(stages).iter().zip(end).fold(Double::zero(), |sum, (w, b)| sum + *w * *b);
        let power = (0..order).fold(Double::one(), |power, _| power * Double::of(part));
        (sum - power / Double::of(tree.density())).rounded().abs()
    };
    trees(order).into_iter().map(left).fold(0.0, f64::max)
}

#[test]
fn there_are_as_many_trees_as_the_book_says() {
    let counts: Vec<usize> = (1..=8).map(|order| trees(order).len()).collect();
    assert_eq!(counts, [1, 1, 2, 4, 9, 20, 48, 115]);
}

#[test]
fn the_end_has_order_eight_to_28_digits() {
    let (stages, end) = (stages(), spread(&c::END));
    for order in 1..=8 {
        let left = worst(&stages, &end, order, 1.0);
        assert!(left < 1e-28, "order {order}: {left:e}");
    }
    assert!(worst(&stages, &end, 9, 1.0) > 1e-6);
}

#[test]
fn places_are_sums_of_rows() {
    macro_rules! check { ($($name:ident)*) => { $(
        let sum = c::$name.of.iter().fold(Double::zero(), |sum, a| sum + two(*a));
        let off = (sum - two(c::$name.at)).rounded().abs();
        assert!(off < 1e-28, "{off:e}");
    )* } }
    check!(STAGE_2 STAGE_3 STAGE_4 STAGE_5 STAGE_6 STAGE_7 STAGE_8 STAGE_9 STAGE_10 STAGE_11 STAGE_12);
    check!(END STAGE_14 STAGE_15 STAGE_16 THIRD);
}

#[test]
fn the_estimates_have_orders_five_and_three() {
    let (stages, end) = (stages(), spread(&c::END));
    let less = |a: &[Double], b: &[Double]| a.iter().zip(b).map(|(a, b)| *a - *b).collect::<Vec<_>>();
    let fifth = less(&end, &spread(&c::FIFTH));
    assert!((1..=5).all(|order| worst(&stages, &fifth, order, 1.0) < 1e-27));
    assert!(worst(&stages, &fifth, 6, 1.0) > 1e-7);
    let third = spread(&c::THIRD);
    assert!((1..=3).all(|order| worst(&stages, &third, order, 1.0) < 1e-28));
    assert!(worst(&stages, &third, 4, 1.0) > 1e-5);
}

#[test]
fn the_dense_output_has_order_seven_to_26_digits() {
    let (stages, end) = (stages(), spread(&c::END));
    let unit =
        |at: usize| (0..16).map(|i| if i == at { Double::one() } else { Double::zero() }).collect::<Vec<_>>();
    let factors = [&c::DENSE_4, &c::DENSE_5, &c::DENSE_6, &c::DENSE_7].map(spread);
    for part in [0.125, 0.5, 0.8125] {
        let (s, r) = (Double::of(part), Double::of(1.0 - part));
        let weights: Vec<Double> = (0..16)
            .map(|i| {
                let bend = unit(0)[i] - end[i];
                let d = end[i] - unit(12)[i] - bend;
                let inner = factors[2][i] + s * factors[3][i];
                let rest = r * (factors[0][i] + s * (factors[1][i] + r * inner));
                s * (end[i] + r * (bend + s * (d + rest)))
            })
            .collect();
        for order in 1..=7 {
            let left = worst(&stages, &weights, order, part);
            assert!(left < 1e-26, "order {order} at {part}: {left:e}");
        }
        assert!(worst(&stages, &weights, 8, part) > 1e-9);
    }
}
