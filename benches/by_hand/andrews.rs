//! The reduced dynamics of Andrews' mechanism, written out by hand: what an evaluation of its motion costs at the least.

#![allow(non_snake_case)] // points and moments of inertia as in the source

use assur::internals::math::Vec2;

/// Position, velocity and acceleration of a point.
#[derive(Clone, Copy)]
struct Point {
    p: Vec2,
    v: Vec2,
    a: Vec2,
}

/// Of one position: the reduced moment of inertia I, half its derivative, and −V′, for the crank's angle as the coordinate.
#[derive(Clone, Copy, Default)]
pub struct Reduced {
    pub inertia: f64,
    pub half_rise: f64,
    pub drop: f64,
}

/// A link that turns at unit speed of the crank: direction, angular velocity and acceleration.
struct Link {
    u: Vec2,
    omega: f64,
    alpha: f64,
}

impl Reduced {
    /// Adds a link with its base point, its mass centre along it and to its left, mass, and moment of inertia.
    #[inline(always)]
    fn add(&mut self, base: Point, Link { u, omega, alpha }: &Link, [along, left, m, J]: [f64; 4]) {
        let r = *u * along + u.perp() * left;
        let v = base.v + r.perp() * *omega;
        let a = base.a + r.perp() * *alpha - r * (omega * omega);
        self.inertia += m * v.dot(v) + J * omega * omega;
        self.half_rise += m * v.dot(a) + J * omega * alpha;
    }
}

/// Two links of these lengths from two points; their joint is to the left of the line between them for a side of 1, to the right
/// for −1. Returns it, and the links.
#[inline(always)]
fn dyad([one, two]: [Point; 2], [l, q]: [f64; 2], side: f64) -> (Point, [Link; 2]) {
    let d = two.p - one.p;
    let square = d.dot(d);
    let along = 0.5 * (square + (l * l - q * q)) / square;
    let height = side * (l * l / square - along * along).sqrt();
    let r_1 = d * along + d.perp() * height;
    let r_2 = r_1 - d;
    let inverse = 1.0 / r_1.cross(r_2);
    let solve = |b: Vec2| (b.dot(r_2) * inverse, b.dot(r_1) * inverse);
    let (w_1, w_2) = solve(two.v - one.v);
    let (e_1, e_2) = solve(two.a - one.a + r_1 * (w_1 * w_1) - r_2 * (w_2 * w_2));
    let joint = Point {
        p: one.p + r_1,
        v: one.v + r_1.perp() * w_1,
        a: one.a + r_1.perp() * e_1 - r_1 * (w_1 * w_1),
    };
    let link = |r: Vec2, length: f64, omega, alpha| Link { u: r * (1.0 / length), omega, alpha };
    (joint, [link(r_1, l, w_1, e_1), link(r_2, q, w_2, e_2)])
}

/// At a direction of the crank. Data: E. Hairer, G. Wanner, Solving ordinary differential equations II, section VII.7.
#[inline(always)]
pub fn reduced(u: Vec2) -> Reduced {
    let mut sum = Reduced::default();
    let at = |x, y| Point { p: Vec2::new(x, y), v: Vec2::zero(), a: Vec2::zero() };
    let (O, A, B, C) = (at(0.0, 0.0), at(-0.06934, -0.00227), at(-0.03635, 0.03273), Vec2::new(0.014, 0.072));
    let F = Point { p: u * 0.007, v: u.perp() * 0.007, a: u * -0.007 };
    sum.add(O, &Link { u, omega: 1.0, alpha: 0.0 }, [0.00092, 0.0, 0.04325, 2.194e-6]);

    let (E, [fe, be]) = dyad([F, B], [0.028, 0.035], 1.0);
    sum.add(F, &fe, [0.0115, 0.0, 0.00365, 4.410e-7]);
    sum.add(B, &be, [0.01874, 0.01043, 0.02373, 5.255e-6]);
    let arm = be.u * 0.018 + be.u.perp() * 0.020;
    let spring = B.p + arm - C;
    sum.drop = -4530.0 * (1.0 - 0.07785 / spring.norm()) * spring.dot(arm.perp() * be.omega);

    for (side, along, left, m, J) in
        [(-1.0, 0.02308, 0.00916, 0.07050, 1.169e-5), (1.0, 0.01228, -0.00449, 0.05498, 1.912e-5)]
    {
        let (_, [from_e, from_a]) = dyad([E, A], [0.020, 0.040], side);
        sum.add(E, &from_e, [0.01421, 0.0, 0.00706, 5.667e-7]);
        sum.add(A, &from_a, [along, left, m, J]);
    }
    sum
}
