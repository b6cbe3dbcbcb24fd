//! A revolute, a slider, a revolute.

use super::testing::{Path, Random, close, equilibrium, rate, rate_of_direction, second_rate};
use assur_math::group::Gap;
use assur_math::group::rpr::*;
use assur_math::math::Vec2;

/// A line that turns about one moving pin and is led through another.
struct Scene {
    A: Path,
    B: Path,
    h: f64,
    root: f64,
}

impl Scene {
    fn random(random: &mut Random) -> Self {
        let (A, B) = (Path::random(random), Path::random(random));
        let h = (B.at(0.0) - A.at(0.0)).norm() * random.within(-0.8, 0.8);
        Self { A, B, h, root: random.sign() }
    }

    fn position(&self, t: f64) -> Position<f64> {
        position(self.A.at(t), self.B.at(t), self.h, self.root)
    }

    fn group(&self, p: &Position<f64>) -> Rpr<f64> {
        Rpr::new(self.B.at(0.0) - self.A.at(0.0), p.e, self.h, p.s)
    }
}

#[test]
fn position_leads_the_line_past_both_pins() {
    let mut random = Random::new(7);
    for _ in 0..300 {
        let scene = Scene::random(&mut random);
        let p = scene.position(0.0);
        close(p.e.norm(), 1.0, 1e-15, 4.0);
        let r = scene.B.at(0.0) - scene.A.at(0.0);
        close((p.e * p.s + p.e.perp() * scene.h - r).norm(), 0.0, 1e-15, 16.0);
        close(p.conditioning, r.dot(p.e) / r.norm(), 1e-14, 1.0);
        assert_eq!(p.conditioning.signum(), scene.root);
        assert!(p.closure > 0.0);
        assert_eq!(gap(scene.A.at(0.0), scene.B.at(0.0), scene.h), None);
    }
}

#[test]
fn velocity_and_acceleration_are_derivatives_of_position() {
    let mut random = Random::new(8);
    for _ in 0..300 {
        let scene = Scene::random(&mut random);
        let p = scene.position(0.0);
        let group = scene.group(&p);
        let (omega, s_dot) = group.velocity(scene.A.velocity(), scene.B.velocity());
        let (alpha, s_ddot) =
            group.acceleration(omega, s_dot, scene.A.acceleration(), scene.B.acceleration());
        close(omega, rate_of_direction(|t| scene.position(t).e), 1e-6, omega.abs() + 1.0);
        let s = |t| Vec2::new(scene.position(t).s, 0.0);
        close(s_dot, rate(s).x, 1e-6, s_dot.abs() + 1.0);
        close(s_ddot, second_rate(s).x, 1e-3, s_ddot.abs() + omega * omega + 1.0);
        let e_ddot = second_rate(|t| scene.position(t).e);
        close(alpha, p.e.cross(e_ddot), 1e-3, alpha.abs() + omega * omega + 1.0);
    }
}

#[test]
fn reactions_balance_both_bodies() {
    let mut random = Random::new(9);
    for _ in 0..300 {
        let scene = Scene::random(&mut random);
        let p = scene.position(0.0);
        let ((F_1, M_1), (F_2, M_2)) = (random.wrench(), random.wrench());
        let got = scene.group(&p).reactions(F_1, M_1, F_2, M_2);
        // Unknowns f_A, f_B, N, K; rows: body 1 (x, y, about A), body 2 (x, y, about B).
        let (n, r) = (p.e.perp(), scene.B.at(0.0) - scene.A.at(0.0));
        let want = equilibrium(
            &[
                &[1.0, 0.0, 0.0, 0.0, -n.x, 0.0],
                &[0.0, 1.0, 0.0, 0.0, -n.y, 0.0],
                &[0.0, 0.0, 0.0, 0.0, -r.cross(n), -1.0],
                &[0.0, 0.0, 1.0, 0.0, n.x, 0.0],
                &[0.0, 0.0, 0.0, 1.0, n.y, 0.0],
                &[0.0, 0.0, 0.0, 0.0, 0.0, 1.0],
            ],
            &[F_1.x, F_1.y, M_1, F_2.x, F_2.y, M_2],
        );
        let all = [got.f_A.x, got.f_A.y, got.f_B.x, got.f_B.y, got.normal, got.couple];
        for (got, want) in all.into_iter().zip(want) {
            close(got, want, 1e-12, want.abs() + 100.0);
        }
    }
}

#[test]
fn pins_too_near_say_by_how_much() {
    let (origin, x) = (Vec2::zero(), Vec2::new(1.0, 0.0));
    assert_eq!(gap(origin, x, -3.0), Some(Gap::TooNear(2.0)));
    let p = position(origin, x, -3.0, 1.0);
    assert_eq!((p.closure, p.conditioning, p.s), (-2.0, 0.0, 0.0));
    let p = position(x, x, 0.0, 1.0);
    assert_eq!((p.closure, p.conditioning, p.e), (0.0, 0.0, origin));
}
