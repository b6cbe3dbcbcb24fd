//! The closed forms of the groups, with the accuracy each reaches, against double-double arithmetic on the same numbers.

use super::double_double::DoubleDouble;
use assur::internals::group::general::{Constraint, General, Point, Pose};
use assur::internals::group::{rrp, rrr};
use assur::internals::math::{Scalar, V2, Vec2};

const ROWS: [f64; 4] = [1e-1, 1e-5, 1e-9, 1e-13];
const DYADS: usize = 300;

/// Deterministic numbers in [0, 1).
struct Random(u64);

impl Random {
    fn within(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * ((self.0 >> 11) as f64 / (1u64 << 53) as f64)
    }
    fn direction(&mut self) -> Vec2 {
        Vec2::direction(self.within(-3.2, 3.2))
    }
    fn sign(&mut self) -> f64 {
        if self.within(-1.0, 1.0) < 0.0 { -1.0 } else { 1.0 }
    }
}

type Exact = V2<DoubleDouble>;

/// |got − want|.
fn distance(got: Vec2, want: Exact) -> f64 {
    (Exact::of(got) - want).norm().0
}

fn ulp(x: f64) -> f64 {
    let x = x.abs();
    f64::from_bits(x.to_bits() + 1) - x
}

/// Two links between A and B.
#[derive(Clone, Copy, Debug)]
struct Dyad {
    p_A: Vec2,
    p_B: Vec2,
    l_1: f64,
    l_2: f64,
    side: f64,
}

impl Dyad {
    fn position(&self) -> rrr::Position<f64> {
        rrr::position(self.p_A, self.p_B, self.l_1, self.l_2, self.side)
    }

    /// The same by the plain formula, a² + b² = l_1², in double-double.
    fn exact(&self) -> Exact {
        let [l_1, l_2] = [self.l_1, self.l_2].map(DoubleDouble::of);
        let r = Exact::of(self.p_B) - Exact::of(self.p_A);
        let square = r.dot(r);
        let along = (square + l_1 * l_1 - l_2 * l_2) / (square + square);
        let across = (l_1 * l_1 / square - along * along).sqrt() * DoubleDouble::of(self.side);
        Exact::of(self.p_A) + r * along + r.perp() * across
    }

    /// What the pin moves when l_1 changes in its last place: ulp / σ.
    fn pin_move(&self) -> f64 {
        let c = self.exact();
        let (r_1, r_2) = (c - Exact::of(self.p_A), c - Exact::of(self.p_B));
        let conditioning = r_1.cross(r_2) / (r_1.norm() * r_2.norm());
        ulp(self.l_1) / conditioning.abs().0
    }
}

/// Length of r against l, in units of the last place of l.
fn closure(r: Vec2, l: f64) -> f64 {
    let residual = Exact::of(r).norm() - DoubleDouble::of(l);
    residual.abs().0 / ulp(l)
}

/// The goals: error ≤ 4 × what the pin moves per ulp of l_1, both links closed to 4 ulp of their own lengths.
fn hold_to_goals(dyad: Dyad) {
    let p = dyad.position();
    let (error, moved) = (distance(p.p_C, dyad.exact()), dyad.pin_move());
    assert!(error <= 4.0 * moved, "{dyad:?}: error {error:e}, the pin moves {moved:e} per ulp");
    for (r, l) in [(p.r_1, dyad.l_1), (p.r_2, dyad.l_2)] {
        let residual = closure(r, l);
        assert!(residual <= 4.0, "{dyad:?}: link {l} closes to {residual} ulp");
    }
}

/// Random dyads: l_1 the longer, pins `span(l_1, l_2)` apart.
fn dyads(seed: u64, p_A: Vec2, span: impl Fn(f64, f64) -> f64) -> Vec<Dyad> {
    let mut random = Random(seed);
    (0..DYADS)
        .map(|_| {
            let l_1 = random.within(1.0, 2.0);
            let l_2 = l_1 * random.within(0.2, 1.0);
            let p_B = p_A + random.direction() * span(l_1, l_2);
            Dyad { p_A, p_B, l_1, l_2, side: random.sign() }
        })
        .collect()
}

#[test]
fn rrr_near_stretched() {
    for row in ROWS {
        dyads(1, Vec2::zero(), |l_1, l_2| (l_1 + l_2) * (1.0 - row)).into_iter().for_each(hold_to_goals);
    }
}

#[test]
fn rrr_near_folded() {
    for row in ROWS {
        let dyads = dyads(2, Vec2::zero(), |l_1, l_2| (l_1 - l_2) * (1.0 + row));
        dyads.into_iter().filter(|d| d.l_1 - d.l_2 > 0.2).for_each(hold_to_goals);
    }
}

#[test]
fn rrr_away_from_the_origin() {
    for row in ROWS {
        let p_A = Vec2::new(0.7, -0.4);
        for dyad in dyads(3, p_A, |l_1, l_2| (l_1 + l_2) * (1.0 - row)) {
            let (error, moved) = (distance(dyad.position().p_C, dyad.exact()), dyad.pin_move());
            assert!(error <= 4.0 * moved, "{dyad:?}: error {error:e}, the pin moves {moved:e} per ulp");
        }
    }
}

#[test]
fn rrr_with_a_link_a_million_times_shorter() {
    let mut random = Random(4);
    for _ in 0..DYADS {
        let l_1 = random.within(1.0, 2.0);
        let l_2 = 1e-6 * l_1;
        let p_B = random.direction() * (l_1 + l_2 * random.within(-0.9, 0.9));
        let dyad = Dyad { p_A: Vec2::zero(), p_B, l_1, l_2, side: random.sign() };
        hold_to_goals(dyad);
        let error = distance(dyad.position().p_C, dyad.exact());
        assert!(error <= 1e-8 * l_2, "{dyad:?}: error {error:e}");
        let turned = Dyad { p_A: p_B, p_B: Vec2::zero(), l_1: l_2, l_2: l_1, side: -dyad.side };
        let error = distance(turned.position().p_C, dyad.exact());
        assert!(error <= 1e-8 * l_2, "{turned:?}: error {error:e}");
    }
}

#[test]
fn rrr_with_pins_close_together() {
    for span in [1e-3, 1e-6, 1e-9] {
        let mut random = Random(5);
        for _ in 0..DYADS {
            let l_1 = random.within(1.0, 2.0);
            let p_B = random.direction() * span;
            let l_2 = l_1 + span * random.within(-0.9, 0.9);
            hold_to_goals(Dyad { p_A: Vec2::zero(), p_B, l_1, l_2, side: random.sign() });
        }
    }
}

#[test]
fn rrr_velocity_and_acceleration_lose_one_more_power_of_sigma_each() {
    let (v_A, v_B) = (Vec2::new(0.3, -0.8), Vec2::new(-0.5, 0.2));
    let (a_A, a_B) = (Vec2::new(-0.6, 0.1), Vec2::new(0.4, 0.9));
    for row in [1e-1, 1e-3, 1e-5, 1e-7] {
        for dyad in dyads(6, Vec2::zero(), |l_1, l_2| (l_1 + l_2) * (1.0 - row)) {
            let motion = motion(dyad.position(), [v_A, v_B, a_A, a_B]);
            let [p_A, p_B] = [dyad.p_A, dyad.p_B].map(Exact::of);
            let [l_1, l_2, side] = [dyad.l_1, dyad.l_2, dyad.side].map(DoubleDouble::of);
            let p = rrr::position(p_A, p_B, l_1, l_2, side);
            let exact = self::motion(p, [v_A, v_B, a_A, a_B].map(Exact::of));
            let sigma = p.conditioning.abs().0;
            // Velocities are of the order 1/(l σ), accelerations of the order 1/(l² σ³).
            for (i, power) in [(0, 3), (1, 3), (2, 5), (3, 5)] {
                let error = (exact[i] - DoubleDouble::of(motion[i])).abs().0;
                let bound = 100.0 * f64::EPSILON / sigma.powi(power) / dyad.l_2.powi(2);
                assert!(error <= bound, "{dyad:?} [{i}]: error {error:e}, bound {bound:e}");
            }
        }
    }
}

/// ω_1, ω_2, α_1, α_2.
fn motion<S: Scalar>(p: rrr::Position<S>, [v_A, v_B, a_A, a_B]: [V2<S>; 4]) -> [S; 4] {
    let group = rrr::Rrr::new(p.r_1, p.r_2);
    let (omega_1, omega_2) = group.velocity(v_A, v_B);
    let (alpha_1, alpha_2) = group.acceleration(omega_1, omega_2, a_A, a_B);
    [omega_1, omega_2, alpha_1, alpha_2]
}

#[test]
fn rrp_near_its_dead_centre() {
    for row in ROWS {
        let mut random = Random(8);
        for _ in 0..DYADS {
            let l = random.within(1.0, 2.0);
            let (d, root) = (random.direction(), random.sign());
            let h = random.sign() * l * (1.0 - row);
            let p = rrp::position(Vec2::zero(), l, Vec2::zero(), d, h, root);
            // d is a unit vector but for its rounding, so the exact answer takes it as given in both places.
            let [l_, h_] = [l, h].map(DoubleDouble::of);
            let u = (l_ * l_ - h_ * h_).sqrt() * DoubleDouble::of(root);
            let want = Exact::of(d) * u + Exact::of(d).perp() * h_;
            let moved = ulp(l) / (u / l_).abs().0;
            let error = distance(p.p_C, want);
            assert!(error <= 4.0 * moved, "l {l}, h {h}: error {error:e}, the pin moves {moved:e} per ulp");
            assert!((DoubleDouble::of(p.s) - u).abs().0 <= 4.0 * moved);
            assert!(closure(p.r_1, l) <= 4.0, "closes to {}", closure(p.r_1, l));
        }
    }
}

/// The dyad as a general group, started at `turn` rad from where its links are.
fn by_newton(dyad: &Dyad, turn: f64) -> Option<Vec2> {
    let p = dyad.position();
    let point = |body, r| Point { body, r };
    let (tip_1, tip_2) = (Vec2::new(dyad.l_1, 0.0), Vec2::new(dyad.l_2, 0.0));
    let joints = vec![
        Constraint::Revolute { a: point(0, Vec2::zero()), b: point(2, dyad.p_A) },
        Constraint::Revolute { a: point(0, tip_1), b: point(1, tip_2) },
        Constraint::Revolute { a: point(1, Vec2::zero()), b: point(2, dyad.p_B) },
    ];
    let mut group = General::new(2, 3, joints).expect("three constraints per body");
    let u = Vec2::direction(turn);
    let mut poses = [
        Pose { p: dyad.p_A, u: (p.r_1 / dyad.l_1).turned(u) },
        Pose { p: dyad.p_B, u: (p.r_2 / dyad.l_2).turned(u) },
        Pose { p: Vec2::zero(), u: Vec2::new(1.0, 0.0) },
    ];
    group.position(&mut poses, 1e-12).ok().map(|_| poses[0].point(tip_1))
}

#[test]
fn newton_near_a_dead_centre() {
    for row in ROWS {
        for dyad in dyads(9, Vec2::zero(), |l_1, l_2| (l_1 + l_2) * (1.0 - row)) {
            let bound = 16.0 * dyad.pin_move();
            let sigma = dyad.position().conditioning.abs();
            let got = by_newton(&dyad, 0.05 * sigma).expect("a start beside the answer");
            assert!(distance(got, dyad.exact()) <= bound, "{dyad:?}");
            // From farther away it may find the other assembly or nothing, but no wrong answer.
            let other = Dyad { side: -dyad.side, ..dyad };
            for turn in [-1.0, -0.1, 0.3, 2.0] {
                if let Some(got) = by_newton(&dyad, turn) {
                    let error = distance(got, dyad.exact()).min(distance(got, other.exact()));
                    assert!(error <= bound, "{dyad:?}: error {error:e} of {bound:e}");
                }
            }
        }
    }
}

#[test]
fn newton_at_a_dead_centre() {
    let p_B = Vec2::new(3.0, 4.0);
    let dyad = Dyad { p_A: Vec2::zero(), p_B, l_1: 2.0, l_2: 3.0, side: 1.0 };
    for turn in [0.0, 1e-9, 1e-3, 0.3] {
        if let Some(got) = by_newton(&dyad, turn) {
            // Half the digits are all that a double root gives.
            assert!((got - Vec2::new(1.2, 1.6)).norm() < 1e-6, "{got:?}");
        }
    }
}

#[test]
fn exactly_dead() {
    let zero = Vec2::zero();
    // 3-4-5: stretched and folded on exact lengths.
    let stretched = rrr::position(zero, Vec2::new(3.0, 4.0), 2.0, 3.0, 1.0);
    assert_eq!((stretched.closure, stretched.conditioning), (0.0, 0.0));
    let folded = rrr::position(zero, Vec2::new(3.0, 4.0), 7.0, 2.0, -1.0);
    assert_eq!((folded.closure, folded.conditioning), (0.0, 0.0));
    let across = rrp::position(zero, 2.0, zero, Vec2::new(1.0, 0.0), -2.0, 1.0);
    assert_eq!((across.closure, across.conditioning), (0.0, 0.0));
}
