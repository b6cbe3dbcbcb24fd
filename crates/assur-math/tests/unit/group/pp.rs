//! Two sliders at a constant angle.

use super::testing::{Body, Random, close, equilibrium, rate, second_rate};
use assur_math::group::pp::*;
use assur_math::math::Vec2;

/// A wedge between a guide and another that turns with it at a constant angle.
fn scene(random: &mut Random) -> (Body, Body, Vec2) {
    let first = Body::random(random);
    let second = Body::random(random).turning_with(&first, random.sign() * random.within(0.5, 2.6));
    (first, second, random.vector(1.0))
}

#[test]
fn position_and_its_derivatives() {
    let mut random = Random::new(18);
    for _ in 0..300 {
        let (first, second, h) = scene(&mut random);
        let group = |t| Pp::new(first.direction(t), second.direction(t));
        let at = |t| group(t).position(first.origin(t), h.x, second.origin(t), h.y);
        let s = |t| Vec2::new(at(t).s_1, at(t).s_2);
        let p = at(0.0);
        for (guide, s, h) in [(&first, p.s_1, h.x), (&second, p.s_2, h.y)] {
            let (d, r) = (guide.direction(0.0), p.p_C - guide.origin(0.0));
            close((d * s + d.perp() * h - r).norm(), 0.0, 1e-14, 10.0);
        }
        let ((v_1, a_1), (v_2, a_2)) = (first.motion_at(p.p_C), second.motion_at(p.p_C));
        let v = group(0.0).velocity(v_1, v_2);
        let a = group(0.0).acceleration(v.0, a_1, v.1, a_2, first.omega);
        close((Vec2::new(v.0, v.1) - rate(s)).norm(), 0.0, 1e-7, v.0.abs() + v.1.abs() + 1.0);
        close((Vec2::new(a.0, a.1) - second_rate(s)).norm(), 0.0, 1e-5, a.0.abs() + a.1.abs() + 1.0);
    }
}

#[test]
fn reactions_balance_the_body() {
    let mut random = Random::new(19);
    for _ in 0..300 {
        let (first, second, _) = scene(&mut random);
        let (d_1, d_2) = (first.direction(0.0), second.direction(0.0));
        let (F, M) = random.wrench();
        let got = Pp::new(d_1, d_2).reactions(F, M);
        let (n, m) = (d_1.perp(), d_2.perp());
        let rows: [&[f64]; 3] = [&[n.x, m.x, 0.0], &[n.y, m.y, 0.0], &[0.0, 0.0, 1.0]];
        let want = equilibrium(&rows, &[F.x, F.y, M]);
        for (got, want) in [got.normal_1, got.normal_2, got.couple].into_iter().zip(want) {
            close(got, want, 1e-12, want.abs() + 100.0);
        }
    }
}
