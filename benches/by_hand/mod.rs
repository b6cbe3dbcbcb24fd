//! The four-bar of bars, 2 kg/m, written out by hand: what there is to gain at the most.

use assur::internals::math::{Scalar, V2};

/// Reactions at A, B, C, D and the torque on the crank.
pub type Answer<S> = ([V2<S>; 4], S);

/// For one direction of the crank, or several side by side. The lengths are those of crank, coupler, rocker and frame, m; the crank
/// turns at `omega`, rad/s.
#[inline(always)]
pub fn four_bar<S: Scalar>([r, l, q, frame]: [f64; 4], omega: f64, u: V2<S>) -> Answer<S> {
    let of = S::of;
    let (p_b, p_d) = (u * of(r), V2::new(of(frame), S::zero()));
    let d = p_d - p_b;
    let square = d.dot(d);
    let along = of(0.5) * (square + of(l * l - q * q)) / square;
    let height = (of(l * l) / square - along * along).sqrt();
    let r_2 = d * along + d.perp() * height;
    let r_3 = r_2 - d;
    let inverse = S::one() / r_2.cross(r_3);
    let v_b = p_b.perp() * of(omega);
    let solve = |b: V2<S>| (b.dot(r_3) * inverse, b.dot(r_2) * inverse);
    let (w_2, w_3) = solve(-v_b);
    let a_b = p_b * of(-(omega * omega));
    let (e_2, e_3) = solve(-a_b + r_2 * (w_2 * w_2) - r_3 * (w_3 * w_3));
    let g = V2::new(S::zero(), of(-9.81));
    let load = |length: f64, a: V2<S>, arm: V2<S>, w: S, e: S| {
        let mass = 2.0 * length;
        let force = (g - (a + arm.perp() * e - arm * (w * w))) * of(mass);
        (force, arm.cross(force) - of(mass * length * length / 12.0) * e)
    };
    let (f_1, m_1) = load(r, V2::zero(), p_b * of(0.5), of(omega), S::zero());
    let (f_2, m_2) = load(l, a_b, r_2 * of(0.5), w_2, e_2);
    let (f_3, m_3) = load(q, V2::zero(), r_3 * of(0.5), w_3, e_3);
    let f_c = (r_2 * m_3 + r_3 * m_2) * inverse;
    let (on_2, on_3) = (f_c - f_2, -f_c - f_3);
    ([on_2 - f_1, on_2, f_c, on_3], p_b.cross(on_2) - m_1)
}
