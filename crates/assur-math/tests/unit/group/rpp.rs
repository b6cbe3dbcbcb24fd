//! A revolute and two sliders.

use super::testing::{Body, Path, Random, close, equilibrium, rate, second_rate};
use assur_math::group::rpp::*;
use assur_math::math::Vec2;

/// A moving pin, a moving and turning guide, a constant angle between the line and the guide.
struct Scene {
    A: Path,
    guide: Body,
    angle: Vec2,
    h: [f64; 2],
}

impl Scene {
    fn random(random: &mut Random) -> Self {
        let angle = Vec2::direction(random.sign() * random.within(0.5, 2.6));
        let h = [random.within(-1.0, 1.0), random.within(-1.0, 1.0)];
        Self { A: Path::random(random), guide: Body::random(random), angle, h }
    }

    fn group(&self, t: f64) -> Rpp<f64> {
        let d_2 = self.guide.direction(t);
        Rpp::new(self.angle.turned(d_2), d_2)
    }

    fn position(&self, t: f64) -> Position<f64> {
        self.group(t).position(self.A.at(t), self.h[0], self.guide.origin(t), self.h[1])
    }
}

#[test]
fn position_closes() {
    let mut random = Random::new(15);
    for _ in 0..300 {
        let scene = Scene::random(&mut random);
        let (p, group) = (scene.position(0.0), scene.group(0.0));
        let p_A = p.p_R + group.d_1 * p.s_1 + group.d_1.perp() * scene.h[0];
        close((p_A - scene.A.at(0.0)).norm(), 0.0, 1e-14, 10.0);
        let r = p.p_R - scene.guide.origin(0.0);
        close(r.dot(group.d_2), p.s_2, 1e-14, 10.0);
        close(group.d_2.cross(r), scene.h[1], 1e-14, 10.0);
    }
}

#[test]
fn velocity_and_acceleration_are_derivatives_of_position() {
    let mut random = Random::new(16);
    for _ in 0..300 {
        let scene = Scene::random(&mut random);
        let group = scene.group(0.0);
        let (v_G, a_G) = scene.guide.motion_at(scene.A.at(0.0));
        let v = group.velocity(scene.A.velocity(), v_G);
        let a = group.acceleration(v.0, v.1, scene.A.acceleration(), a_G, scene.guide.omega);
        let s = |t| Vec2::new(scene.position(t).s_1, scene.position(t).s_2);
        close((Vec2::new(v.0, v.1) - rate(s)).norm(), 0.0, 1e-7, v.0.abs() + v.1.abs() + 1.0);
        close((Vec2::new(a.0, a.1) - second_rate(s)).norm(), 0.0, 1e-5, a.0.abs() + a.1.abs() + 1.0);
    }
}

#[test]
fn reactions_balance_both_bodies() {
    let mut random = Random::new(17);
    for _ in 0..300 {
        let scene = Scene::random(&mut random);
        let (p, group) = (scene.position(0.0), scene.group(0.0));
        let ((F_1, M_1), (F_2, M_2)) = (random.wrench(), random.wrench());
        let got = group.reactions(p.s_1, F_1, M_1, F_2, M_2);
        // Unknowns f_A, N_1, K_1, N_2, K_2; rows: body 1 (x, y, about A), body 2 (x, y, about R).
        let (n, m) = (group.d_1.perp(), group.d_2.perp());
        let arm = (scene.A.at(0.0) - p.p_R).cross(n);
        let want = equilibrium(
            &[
                &[1.0, 0.0, -n.x, 0.0, 0.0, 0.0],
                &[0.0, 1.0, -n.y, 0.0, 0.0, 0.0],
                &[0.0, 0.0, 0.0, -1.0, 0.0, 0.0],
                &[0.0, 0.0, n.x, 0.0, m.x, 0.0],
                &[0.0, 0.0, n.y, 0.0, m.y, 0.0],
                &[0.0, 0.0, arm, 1.0, 0.0, 1.0],
            ],
            &[F_1.x, F_1.y, M_1, F_2.x, F_2.y, M_2],
        );
        let all = [got.f_A.x, got.f_A.y, got.normal_1, got.couple_1, got.normal_2, got.couple_2];
        for (got, want) in all.into_iter().zip(want) {
            close(got, want, 1e-12, want.abs() + 100.0);
        }
    }
}
