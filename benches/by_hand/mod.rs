//! The four-bar of bars, 2 kg/m, written out by hand: what there is to gain at the most.

use assur::internals::math::Vec2;

/// Reactions at A, B, C, D and the torque on the crank, for one direction of the crank. The lengths are those of crank,
/// coupler, rocker and frame, m; the crank turns at `omega`, rad/s.
#[inline(always)]
pub fn four_bar([r, l, q, frame]: [f64; 4], omega: f64, u: Vec2) -> ([Vec2; 4], f64) {
    let (p_b, p_d) = (u * r, Vec2::new(frame, 0.0));
    let d = p_d - p_b;
    let square = d.dot(d);
    let along = 0.5 * (square + l * l - q * q) / square;
    let height = (l * l / square - along * along).sqrt();
    let r_2 = d * along + d.perp() * height;
    let r_3 = r_2 - d;
    let inverse = 1.0 / r_2.cross(r_3);
    let v_b = p_b.perp() * omega;
    let solve = |b: Vec2| (b.dot(r_3) * inverse, b.dot(r_2) * inverse);
    let (w_2, w_3) = solve(-v_b);
    let a_b = p_b * -(omega * omega);
    let (e_2, e_3) = solve(-a_b + r_2 * (w_2 * w_2) - r_3 * (w_3 * w_3));
    let g = Vec2::new(0.0, -9.81);
    let load = |length: f64, a: Vec2, arm: Vec2, w: f64, e: f64| {
        let mass = 2.0 * length;
        let force = (g - (a + arm.perp() * e - arm * (w * w))) * mass;
        (force, arm.cross(force) - mass * length * length / 12.0 * e)
    };
    let (f_1, m_1) = load(r, Vec2::new(0.0, 0.0), p_b * 0.5, omega, 0.0);
    let (f_2, m_2) = load(l, a_b, r_2 * 0.5, w_2, e_2);
    let (f_3, m_3) = load(q, Vec2::new(0.0, 0.0), r_3 * 0.5, w_3, e_3);
    let f_c = (r_2 * m_3 + r_3 * m_2) * inverse;
    let (on_2, on_3) = (f_c - f_2, -f_c - f_3);
    ([on_2 - f_1, on_2, f_c, on_3], p_b.cross(on_2) - m_1)
}
