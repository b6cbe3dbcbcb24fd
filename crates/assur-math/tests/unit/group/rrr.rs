//! Three revolutes.

use super::testing::{Path, Random, close, equilibrium, rate, rate_of_direction, second_rate};
use assur_math::group::Gap;
use assur_math::group::rrr::*;
use assur_math::math::Vec2;

/// Two links whose outer revolutes move on given paths.
struct Scene {
    A: Path,
    B: Path,
    l_1: f64,
    l_2: f64,
    side: f64,
}

impl Scene {
    fn random(random: &mut Random) -> Self {
        let (A, B) = (Path::random(random), Path::random(random));
        let span = (B.at(0.0) - A.at(0.0)).norm();
        let l_1 = span * random.within(0.4, 1.5);
        let (least, most) = ((span - l_1).abs(), span + l_1);
        let l_2 = least + (most - least) * random.within(0.2, 0.8);
        Self { A, B, l_1, l_2, side: random.sign() }
    }

    fn position(&self, t: f64) -> Position<f64> {
        position(self.A.at(t), self.B.at(t), self.l_1, self.l_2, self.side)
    }
}

#[test]
fn position_closes_on_the_side_asked_for() {
    let mut random = Random::new(1);
    for _ in 0..300 {
        let scene = Scene::random(&mut random);
        let (p_A, p_B) = (scene.A.at(0.0), scene.B.at(0.0));
        let p = scene.position(0.0);
        close((p.p_C - p_A).norm(), scene.l_1, 1e-15, scene.l_1.max(scene.l_2) * 8.0);
        close((p.p_C - p_B).norm(), scene.l_2, 1e-15, scene.l_1.max(scene.l_2) * 8.0);
        close(p.conditioning, p.r_1.cross(p.r_2) / (scene.l_1 * scene.l_2), 1e-13, 1.0);
        assert_eq!((p_B - p_A).cross(p.p_C - p_A).signum(), scene.side);
        assert_eq!(p.conditioning.signum(), scene.side);
        assert!(p.closure > 0.0);
        assert_eq!(gap(p_A, p_B, scene.l_1, scene.l_2), None);
    }
}

#[test]
fn velocity_and_acceleration_are_derivatives_of_position() {
    let mut random = Random::new(2);
    for _ in 0..300 {
        let scene = Scene::random(&mut random);
        let p = scene.position(0.0);
        let group = Rrr::new(p.r_1, p.r_2);
        let (omega_1, omega_2) = group.velocity(scene.A.velocity(), scene.B.velocity());
        let (alpha_1, alpha_2) =
            group.acceleration(omega_1, omega_2, scene.A.acceleration(), scene.B.acceleration());
        close(omega_1, rate_of_direction(|t| scene.position(t).r_1), 1e-7, omega_1.abs() + 1.0);
        close(omega_2, rate_of_direction(|t| scene.position(t).r_2), 1e-7, omega_2.abs() + 1.0);
        let v_C = rate(|t| scene.position(t).p_C);
        let a_C = second_rate(|t| scene.position(t).p_C);
        let v = scene.A.velocity() + p.r_1.perp() * omega_1;
        let a = scene.A.acceleration() + p.r_1.perp() * alpha_1 - p.r_1 * (omega_1 * omega_1);
        let a_by_2 = scene.B.acceleration() + p.r_2.perp() * alpha_2 - p.r_2 * (omega_2 * omega_2);
        close((v - v_C).norm(), 0.0, 1e-7, v.norm() + 1.0);
        close((a - a_C).norm(), 0.0, 1e-5, a.norm() + 1.0);
        close((a - a_by_2).norm(), 0.0, 1e-11, a.norm() + 1.0);
    }
}

#[test]
fn a_link_may_change_its_length() {
    let mut random = Random::new(21);
    for _ in 0..300 {
        let scene = Scene::random(&mut random);
        let (rate_2, second_2) = (random.within(-1.0, 1.0), random.within(-1.0, 1.0));
        let at = |t: f64| {
            let l_2 = scene.l_2 + rate_2 * t + second_2 * (t * t / 2.0);
            position(scene.A.at(t), scene.B.at(t), scene.l_1, l_2, scene.side)
        };
        let p = at(0.0);
        let (group, u) = (Rrr::new(p.r_1, p.r_2), p.r_2 / scene.l_2);
        let (omega_1, omega_2) = group.velocity(scene.A.velocity(), scene.B.velocity() + u * rate_2);
        close(omega_1, rate_of_direction(|t| at(t).r_1), 1e-7, omega_1.abs() + 1.0);
        let a_B = scene.B.acceleration() + u * second_2 + u.perp() * (2.0 * omega_2 * rate_2);
        let (alpha_1, _) = group.acceleration(omega_1, omega_2, scene.A.acceleration(), a_B);
        let a = scene.A.acceleration() + p.r_1.perp() * alpha_1 - p.r_1 * (omega_1 * omega_1);
        close((a - second_rate(|t| at(t).p_C)).norm(), 0.0, 1e-5, a.norm() + 1.0);
    }
}

#[test]
fn reactions_balance_both_links() {
    let mut random = Random::new(3);
    for _ in 0..300 {
        let p = Scene::random(&mut random).position(0.0);
        let ((F_1, M_1), (F_2, M_2)) = (random.wrench(), random.wrench());
        let got = Rrr::new(p.r_1, p.r_2).reactions(F_1, M_1, F_2, M_2);
        // Unknowns f_A, f_C, f_B; rows: link 1 (x, y, about A), link 2 (x, y, about B).
        let (c, d) = (p.r_1, p.r_2);
        let want = equilibrium(
            &[
                &[1.0, 0.0, -1.0, 0.0, 0.0, 0.0],
                &[0.0, 1.0, 0.0, -1.0, 0.0, 0.0],
                &[0.0, 0.0, c.y, -c.x, 0.0, 0.0],
                &[0.0, 0.0, 1.0, 0.0, 1.0, 0.0],
                &[0.0, 0.0, 0.0, 1.0, 0.0, 1.0],
                &[0.0, 0.0, -d.y, d.x, 0.0, 0.0],
            ],
            &[F_1.x, F_1.y, M_1, F_2.x, F_2.y, M_2],
        );
        let all = [got.f_A.x, got.f_A.y, got.f_C.x, got.f_C.y, got.f_B.x, got.f_B.y];
        for (got, want) in all.into_iter().zip(want) {
            close(got, want, 1e-12, want.abs() + 100.0);
        }
    }
}

#[test]
fn what_does_not_close_says_by_how_much() {
    let at = |x: f64| Vec2::new(x, 0.0);
    assert_eq!(gap(at(0.0), at(4.0), 1.0, 2.0), Some(Gap::TooFar(1.0)));
    assert_eq!(gap(at(0.0), at(1.0), 1.0, 4.0), Some(Gap::TooNear(2.0)));
    let stretched = position(at(0.0), at(4.0), 1.0, 2.0, 1.0);
    assert_eq!((stretched.conditioning, stretched.p_C.y), (0.0, 0.0));
    // (3² − 4²) / 2·3: 1 but for the second order
    assert!((stretched.closure + 7.0 / 6.0).abs() < 1e-15);
    let folded = position(at(0.0), at(1.0), 1.0, 4.0, 1.0);
    assert_eq!(folded.conditioning, 0.0);
    // (1² − 3²) / 2·3
    assert!((folded.closure + 4.0 / 3.0).abs() < 1e-15);
    let dead = position(at(0.0), at(3.0), 1.0, 2.0, 1.0);
    assert_eq!((dead.closure, dead.conditioning, dead.p_C), (0.0, 0.0, at(1.0)));
}

#[test]
fn coincident_pins_are_a_dead_position() {
    let p = position(Vec2::zero(), Vec2::zero(), 1.0, 1.0, 1.0);
    assert_eq!(p.conditioning, 0.0);
    assert!(p.closure >= 0.0);
}
