//! Links driven by their neighbours.

use super::testing::{Body, Random, close, equilibrium, rate, second_rate};
use assur_math::group::driven::*;
use assur_math::math::Vec2;

#[test]
fn a_slider_on_a_moving_guide() {
    let mut random = Random::new(10);
    for _ in 0..300 {
        let guide = Body::random(&mut random);
        let (h, s, s_dot, s_ddot) =
            (random.within(-1.0, 1.0), random.within(-2.0, 2.0), random.within(-2.0, 2.0), 1.5);
        let at = |t: f64| {
            let s = s + s_dot * t + s_ddot * (t * t / 2.0);
            prismatic_position(guide.origin(t), guide.direction(t), h, s)
        };
        let d = guide.direction(0.0);
        let (v_G, a_G) = guide.motion_at(at(0.0));
        let v = prismatic_velocity(v_G, d, s_dot);
        let a = prismatic_acceleration(a_G, guide.omega, d, s_dot, s_ddot);
        close((v - rate(at)).norm(), 0.0, 1e-9, v.norm() + 1.0);
        close((a - second_rate(at)).norm(), 0.0, 1e-7, a.norm() + 1.0);
    }
}

#[test]
fn a_crank_turns_with_its_base() {
    let (base, angle) = (Vec2::direction(0.3), Vec2::direction(1.1));
    close((revolute_position(base, angle) - Vec2::direction(1.4)).norm(), 0.0, 1e-15, 1.0);
    assert_eq!((revolute_velocity(2.0, 3.0), revolute_acceleration(-1.0, 4.0)), (5.0, 3.0));
}

#[test]
fn efforts_balance_the_link() {
    let mut random = Random::new(11);
    for _ in 0..300 {
        let (F, M) = random.wrench();
        let (r, u, d) = (random.vector(2.0), random.direction(), random.direction());
        let got = revolute_force(F, M, r, u);
        let rows: [&[f64]; 3] = [&[1.0, 0.0, u.x], &[0.0, 1.0, u.y], &[0.0, 0.0, r.cross(u)]];
        let want = equilibrium(&rows, &[F.x, F.y, M]);
        for (got, want) in [got.f_O.x, got.f_O.y, got.force].into_iter().zip(want) {
            close(got, want, 1e-12, want.abs() + 100.0);
        }
        close(got.sine, r.cross(u) / r.norm(), 1e-15, 2.0);

        let (got, n) = (prismatic_force(F, M, d, r, u), d.perp());
        let rows: [&[f64]; 3] = [&[n.x, 0.0, u.x], &[n.y, 0.0, u.y], &[0.0, 1.0, r.cross(u)]];
        let want = equilibrium(&rows, &[F.x, F.y, M]);
        for (got, want) in [got.normal, got.couple, got.force].into_iter().zip(want) {
            close(got, want, 1e-12, want.abs() + 100.0);
        }
        let got = revolute_torque(F, M);
        assert_eq!((got.f_O + F, got.torque + M), (Vec2::zero(), 0.0));
    }
}
