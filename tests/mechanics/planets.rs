//! Planets with mass against their kinetic energy.

use crate::geared_chains::{answers, close};
use crate::support::random::Random;

/// The torque on the sun is the derivative of the kinetic energy by its angle: Σ (J_i i_i² + m_i a_i²) α, in a gear with stepped
/// planets.
#[test]
fn heavy_planets_take_the_power_of_their_energy() {
    let mut random = Random::new(101);
    for _ in 0..40 {
        let module = random.within(0.001, 0.005);
        let [zs, zp, zq] = [(15, 60), (20, 70), (12, 40)].map(|(a, b)| (a + random.below(b - a)) as f64);
        let zr = zs + zp + zq;
        let [js, jh, jp] = [0, 1, 2].map(|_| random.within(1e-4, 1e-2));
        let (m, speed, acc) =
            (random.within(0.1, 5.0), random.within(1.0, 100.0), random.within(-50.0, 50.0));
        let text = format!(
            "ground {{ wheel r teeth {zr} }}\nshaft S {{ wheel s teeth {zs} module {module} m; inertia {js} kg*m^2 }}\n\
             shaft H {{ inertia {jh} kg*m^2 }}\n\
             shaft P on H {{ wheel p teeth {zp}; wheel q teeth {zq} module {module} m; mass {m} kg; inertia {jp} kg*m^2 }}\n\
             gravity 9.81 m/s^2\nmesh a: s - p\nmesh b: q - r {{ internal }}\ndrive S at {speed} rad/s accelerating {acc} rad/s^2\n\
             balance torque M on S\nfind M, omega(H), omega(P)\n"
        );
        // points of contact: the sun's rim, and the ring at rest
        let (r_s, r_p, r_q) = (0.5 * module * zs, 0.5 * module * zp, 0.5 * module * zq);
        let arm = r_s + r_p;
        // v of the axis = ω_H a; at the sun's rim ω_s r_s = v − ω_p r_p, at the ring 0 = v + ω_p r_q
        let planet = -r_s / (r_p + r_q);
        let carrier = -planet * r_q / arm;
        let found = answers(&text);
        let Some(found) = &found[0] else { panic!("{text}") };
        close(found["omega(H)"][0], carrier * speed, 1e-12, &text);
        close(found["omega(P)"][0], planet * speed, 1e-12, &text);
        let inertia = js + (jh + m * arm * arm) * carrier * carrier + jp * planet * planet;
        close(found["M"][0], inertia * acc, 1e-12, &text);
    }
}
