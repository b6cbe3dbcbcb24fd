//! A slider, a revolute, a slider.

use super::testing::{Body, Random, close, equilibrium, rate, second_rate};
use assur_math::group::prp::*;
use assur_math::math::Vec2;

/// Two moving, turning guides.
struct Scene {
    guides: [Body; 2],
    h: [f64; 2],
}

impl Scene {
    fn random(random: &mut Random) -> Self {
        loop {
            let guides = [Body::random(random), Body::random(random)];
            if guides[0].direction(0.0).cross(guides[1].direction(0.0)).abs() > 0.4 {
                return Self { guides, h: [random.within(-1.0, 1.0), random.within(-1.0, 1.0)] };
            }
        }
    }

    fn group(&self, t: f64) -> Prp<f64> {
        Prp::new(self.guides[0].direction(t), self.guides[1].direction(t))
    }

    fn position(&self, t: f64) -> Position<f64> {
        let [one, two] = &self.guides;
        self.group(t).position(one.origin(t), self.h[0], two.origin(t), self.h[1])
    }
}

#[test]
fn the_pin_is_on_both_paths() {
    let mut random = Random::new(12);
    for _ in 0..300 {
        let scene = Scene::random(&mut random);
        let p = scene.position(0.0);
        for (i, s) in [(0, p.s_1), (1, p.s_2)] {
            let (d, c) = (scene.guides[i].direction(0.0), p.p_C - scene.guides[i].origin(0.0));
            close(c.dot(d), s, 1e-14, 10.0);
            close(d.cross(c), scene.h[i], 1e-14, 10.0);
        }
    }
}

#[test]
fn velocity_and_acceleration_are_derivatives_of_position() {
    let mut random = Random::new(13);
    for _ in 0..300 {
        let scene = Scene::random(&mut random);
        let (p, group) = (scene.position(0.0), scene.group(0.0));
        let [one, two] = &scene.guides;
        let ((v_1, a_1), (v_2, a_2)) = (one.motion_at(p.p_C), two.motion_at(p.p_C));
        let v = group.velocity(v_1, v_2);
        let a = group.acceleration(v.0, a_1, one.omega, v.1, a_2, two.omega);
        let s = |t| Vec2::new(scene.position(t).s_1, scene.position(t).s_2);
        close((Vec2::new(v.0, v.1) - rate(s)).norm(), 0.0, 1e-7, v.0.abs() + v.1.abs() + 1.0);
        close((Vec2::new(a.0, a.1) - second_rate(s)).norm(), 0.0, 1e-5, a.0.abs() + a.1.abs() + 1.0);
    }
}

#[test]
fn reactions_balance_both_bodies() {
    let mut random = Random::new(14);
    for _ in 0..300 {
        let group = Scene::random(&mut random).group(0.0);
        let ((F_1, M_1), (F_2, M_2)) = (random.wrench(), random.wrench());
        let got = group.reactions(F_1, M_1, F_2, M_2);
        // Unknowns f_C, N_1, K_1, N_2, K_2; rows: body 1 (x, y, about C), body 2 (x, y, about C).
        let (n, m) = (group.d_1.perp(), group.d_2.perp());
        let want = equilibrium(
            &[
                &[-1.0, 0.0, n.x, 0.0, 0.0, 0.0],
                &[0.0, -1.0, n.y, 0.0, 0.0, 0.0],
                &[0.0, 0.0, 0.0, 1.0, 0.0, 0.0],
                &[1.0, 0.0, 0.0, 0.0, m.x, 0.0],
                &[0.0, 1.0, 0.0, 0.0, m.y, 0.0],
                &[0.0, 0.0, 0.0, 0.0, 0.0, 1.0],
            ],
            &[F_1.x, F_1.y, M_1, F_2.x, F_2.y, M_2],
        );
        let all = [got.f_C.x, got.f_C.y, got.normal_1, got.couple_1, got.normal_2, got.couple_2];
        for (got, want) in all.into_iter().zip(want) {
            close(got, want, 1e-12, want.abs() + 100.0);
        }
    }
}
