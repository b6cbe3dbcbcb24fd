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

/// What passes through a mesh, seen from the carrier, has the forces of both wheels in the ratio of the efficiency; each is the torque on
/// its shaft over the radius.
#[test]
fn the_driver_has_the_greater_tooth_force() {
    let mut random = Random::new(102);
    for _ in 0..40 {
        let [zs, zp] = [(15, 60), (15, 40)].map(|(a, b)| (a + random.below(b - a)) as f64);
        let (module, eta) = (random.within(0.001, 0.005), random.within(0.9, 0.995));
        let (drive, load) = if random.sign() < 0.0 { ("S", "H") } else { ("H", "S") };
        let torque = random.sign() * random.within(10.0, 100.0);
        let text = format!(
            "ground {{ wheel r teeth {} }}\nshaft S {{ wheel s teeth {zs} module {module} m }}\nshaft H\n\
             shaft P on H {{ wheel p teeth {zp} }}\n\
             mesh a: s - p {{ efficiency {eta} }}\nmesh b: p - r {{ internal; efficiency {eta} }}\ndrive {drive} at 10 rad/s\n\
             torque Q on {load} = {torque} N*m\nbalance torque M on {drive}\n\
             find omega(S), omega(H), omega(P), moment(a, S), moment(a, P), moment(b, P), tangential_force(a, s), tangential_force(a, P), tangential_force(b, P), tangential_force(b, r), tangential_force(a), M\n",
            zs + 2.0 * zp
        );
        let found = answers(&text);
        let Some(found) = &found[0] else { panic!("{text}") };
        let of = |what: &str| found[what][0];
        let (r_s, r_p) = (0.5 * module * zs, 0.5 * module * zp);
        close(of("tangential_force(a, s)"), of("moment(a, S)").abs() / r_s, 1e-12, &text);
        close(of("tangential_force(a, P)"), of("moment(a, P)").abs() / r_p, 1e-12, &text);
        close(of("tangential_force(b, P)"), of("moment(b, P)").abs() / r_p, 1e-12, &text);
        // the planet turns freely
        close(of("tangential_force(a, P)"), of("tangential_force(b, P)"), 1e-12, &text);
        // power into the sun by the mesh, seen from the carrier: the sun is driven where it is positive
        let driven = of("moment(a, S)") * (of("omega(S)") - of("omega(H)")) > 0.0;
        let step = if driven { 1.0 / eta } else { eta };
        let sun = of("tangential_force(a, s)");
        close(of("tangential_force(a, P)"), sun * step, 1e-12, &text);
        close(of("tangential_force(b, r)"), sun * step * step, 1e-12, &text);
        close(of("tangential_force(a)"), sun * f64::min(1.0, step), 1e-12, &text);
        // equilibrium of all shafts about the axis
        let ring = of("tangential_force(b, r)") * (r_s + 2.0 * r_p);
        let sum = (of("M") + torque).abs();
        close(sum, ring, 1e-10, &text);
    }
}

/// A belt that slips pulls both wheels alike.
#[test]
fn a_slipping_belt_pulls_both_wheels_alike() {
    let text = "shaft I { wheel a radius 0.1 m }\nshaft II { wheel b radius 0.3 m }\nbelt k: a - b { slip 3 % }\n\
                drive I at 10 rad/s\ntorque T on II = -6 N*m\nbalance torque M on I\n\
                find tangential_force(k, a), tangential_force(k, b), tangential_force(k), moment(k, I), M\n";
    let found = answers(text);
    let Some(found) = &found[0] else { panic!("{text}") };
    let of = |what: &str| found[what][0];
    close(of("tangential_force(k, b)"), 20.0, 1e-12, text);
    close(of("tangential_force(k, a)"), 20.0, 1e-12, text);
    close(of("tangential_force(k)"), 20.0, 1e-12, text);
    close(of("M"), 2.0, 1e-12, text);
}
