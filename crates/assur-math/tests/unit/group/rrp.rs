//! Two revolutes and a slider.

use super::testing::{Body, Path, Random, close, equilibrium, rate, rate_of_direction, second_rate};
use assur_math::group::Gap;
use assur_math::group::rrp::*;
use assur_math::math::Vec2;

/// A rod on a moving pin and a slider on a moving, turning guide.
struct Scene {
    A: Path,
    guide: Body,
    l: f64,
    h: f64,
    root: f64,
}

impl Scene {
    fn random(random: &mut Random) -> Self {
        let (A, guide) = (Path::random(random), Body::random(random));
        let l = random.within(0.5, 3.0);
        let foot = guide.direction(0.0).cross(A.at(0.0) - guide.origin(0.0));
        Self { A, guide, l, h: foot + l * random.within(-0.8, 0.8), root: random.sign() }
    }

    fn position(&self, t: f64) -> Position<f64> {
        position(self.A.at(t), self.l, self.guide.origin(t), self.guide.direction(t), self.h, self.root)
    }
}

#[test]
fn position_closes_on_the_root_asked_for() {
    let mut random = Random::new(4);
    for _ in 0..300 {
        let scene = Scene::random(&mut random);
        let p = scene.position(0.0);
        let d = scene.guide.direction(0.0);
        close((p.p_C - scene.A.at(0.0)).norm(), scene.l, 1e-14, 1.0);
        let c = p.p_C - scene.guide.origin(0.0);
        close(c.dot(d), p.s, 1e-14, 1.0);
        close(d.cross(c), scene.h, 1e-14, 1.0);
        close(p.conditioning, p.r_1.dot(d) / scene.l, 1e-14, 1.0);
        assert_eq!(p.conditioning.signum(), scene.root);
        assert!(p.closure > 0.0);
        assert_eq!(gap(scene.A.at(0.0), scene.l, scene.guide.origin(0.0), d, scene.h), None);
    }
}

#[test]
fn velocity_and_acceleration_are_derivatives_of_position() {
    let mut random = Random::new(5);
    for _ in 0..300 {
        let scene = Scene::random(&mut random);
        let p = scene.position(0.0);
        let group = Rrp::new(p.r_1, scene.guide.direction(0.0));
        let (v_G, a_G) = scene.guide.motion_at(p.p_C);
        let (omega_1, s_dot) = group.velocity(scene.A.velocity(), v_G);
        let (alpha_1, s_ddot) =
            group.acceleration(omega_1, s_dot, scene.A.acceleration(), a_G, scene.guide.omega);
        close(omega_1, rate_of_direction(|t| scene.position(t).r_1), 1e-7, omega_1.abs() + 1.0);
        let s = |t| Vec2::new(scene.position(t).s, 0.0);
        close(s_dot, rate(s).x, 1e-7, s_dot.abs() + 1.0);
        close(s_ddot, second_rate(s).x, 1e-5, s_ddot.abs() + 1.0);
        let a_C = second_rate(|t| scene.position(t).p_C);
        let a = scene.A.acceleration() + p.r_1.perp() * alpha_1 - p.r_1 * (omega_1 * omega_1);
        close((a - a_C).norm(), 0.0, 1e-5, a.norm() + 1.0);
    }
}

#[test]
fn reactions_balance_both_bodies() {
    let mut random = Random::new(6);
    for _ in 0..300 {
        let scene = Scene::random(&mut random);
        let (p, d) = (scene.position(0.0), scene.guide.direction(0.0));
        let ((F_1, M_1), (F_2, M_2)) = (random.wrench(), random.wrench());
        let got = Rrp::new(p.r_1, d).reactions(F_1, M_1, F_2, M_2);
        // Unknowns f_A, f_C, N, K; rows: link 1 (x, y, about A), body 2 (x, y, about C).
        let (c, n) = (p.r_1, d.perp());
        let want = equilibrium(
            &[
                &[1.0, 0.0, -1.0, 0.0, 0.0, 0.0],
                &[0.0, 1.0, 0.0, -1.0, 0.0, 0.0],
                &[0.0, 0.0, c.y, -c.x, 0.0, 0.0],
                &[0.0, 0.0, 1.0, 0.0, n.x, 0.0],
                &[0.0, 0.0, 0.0, 1.0, n.y, 0.0],
                &[0.0, 0.0, 0.0, 0.0, 0.0, 1.0],
            ],
            &[F_1.x, F_1.y, M_1, F_2.x, F_2.y, M_2],
        );
        let all = [got.f_A.x, got.f_A.y, got.f_C.x, got.f_C.y, got.normal, got.couple];
        for (got, want) in all.into_iter().zip(want) {
            close(got, want, 1e-12, want.abs() + 100.0);
        }
    }
}

#[test]
fn what_does_not_reach_says_by_how_much() {
    let (origin, x) = (Vec2::zero(), Vec2::new(1.0, 0.0));
    assert_eq!(gap(origin, 2.0, origin, x, -3.0), Some(Gap::TooFar(1.0)));
    let p = position(origin, 2.0, origin, x, -3.0, 1.0);
    assert_eq!((p.closure, p.conditioning, p.s, p.p_C), (-1.0, 0.0, 0.0, Vec2::new(0.0, -3.0)));
}
