//! Trains with one and two freedoms, and wheels beside linkages, against their kinetic energy by hand.

#![allow(clippy::disallowed_methods, reason = "an independent computation")]

use super::many;
use crate::geared_chains::{answers, close};
use crate::support::random::Random;
use std::fmt::Write as _;

/// What the file finds at its first instant.
fn first(text: &str) -> impl Fn(&str) -> f64 {
    let mut poses = answers(text);
    let found = poses.swap_remove(0).unwrap_or_else(|| panic!("{text}"));
    move |name| found.get(name).unwrap_or_else(|| panic!("{name} of {found:?}"))[0]
}

/// A planetary stage between shafts in a row: speeds of all shafts are linear in those of sun and carrier.
#[test]
fn planetary_trains_with_two_freedoms() {
    for seed in 0..many(30) {
        let random = &mut Random::new(60_000 + seed);
        let (zs, zp) = (12 + random.below(40), 12 + random.below(40));
        let zr = zs + 2 * zp;
        let module = random.within(1.0, 6.0) * 1e-3;
        let (z1, z2) = (12 + random.below(50), 12 + random.below(50));
        let crossed = random.chance(0.5);
        let radii = [random.within(0.05, 0.3), random.within(0.05, 0.3)];
        let number = |x: usize| f64::from(u32::try_from(x).expect("teeth"));
        let arm = module * number(zs + zp) / 2.0;
        let mass = random.within(0.1, 5.0);
        // sun, ring, carrier, planets, the shaft that meshes with the sun, and the one that a belt joins to the carrier
        let inertia: Vec<f64> = (0..6).map(|_| random.within(0.01, 0.5)).collect();
        let torque: Vec<f64> =
            (0..6).map(|i| if i == 3 { 0.0 } else { random.within(-30.0, 30.0) }).collect();
        let drag: Vec<f64> = (0..6).map(|i| if i == 3 { 0.0 } else { random.within(0.0, 0.3) }).collect();
        let start = [random.within(-50.0, 50.0), random.within(-50.0, 50.0)];
        let (i, n) = (number(zs) / number(zr), number(zs) / number(zp));
        let belt = radii[1] / radii[0] * if crossed { -1.0 } else { 1.0 };
        let rows = [
            [1.0, 0.0],
            [-i, 1.0 + i],
            [0.0, 1.0],
            [-n, 1.0 + n],
            [-number(zs) / number(z1) * number(z2) / number(z2), 0.0],
            [0.0, belt],
        ];
        let names = ["S", "R", "H", "P", "A", "B"];
        let mut text = format!(
            "shaft S {{ wheel sun teeth {zs} module {module} m; inertia {} kg*m^2 }}
shaft R {{ wheel ring teeth {zr}; inertia {} kg*m^2 }}
shaft H {{ wheel h radius {} m; inertia {} kg*m^2 }}
shaft P on H {{ wheel p teeth {zp}; mass {mass} kg; inertia {} kg*m^2 }}
shaft A {{ wheel a teeth {z1}; inertia {} kg*m^2 }}
shaft B {{ wheel b radius {} m; inertia {} kg*m^2 }}
mesh sp: sun - p\nmesh pr: p - ring {{ internal }}\nmesh sa: sun - a\nbelt hb: h - b {{{}}}
start S at {} rad/s\nstart H at {} rad/s\nsimulate 1 ms within 1e-6\n",
            inertia[0],
            inertia[1],
            radii[1],
            inertia[2],
            inertia[3],
            inertia[4],
            radii[0],
            inertia[5],
            if crossed { " crossed " } else { "" },
            start[0],
            start[1],
        );
        for k in [0, 1, 2, 4, 5] {
            let name = names[k];
            writeln!(text, "torque M{name} on {name} = {} N*m - {} N*m*s*omega({name})", torque[k], drag[k])
                .expect("written");
        }
        text.push_str("find kinetic_energy()");
        names.iter().for_each(|name| write!(text, ", alpha({name}), omega({name})").expect("written"));
        text.push('\n');
        let mut m = [[0.0; 2]; 2];
        let (mut q, mut energy) = ([0.0; 2], 0.0);
        for (k, row) in rows.iter().enumerate() {
            let j = inertia[k] + if k == 2 { mass * arm * arm } else { 0.0 };
            let omega = row[0] * start[0] + row[1] * start[1];
            energy += 0.5 * j * omega * omega;
            for a in 0..2 {
                q[a] += row[a] * (torque[k] - drag[k] * omega);
                for b in 0..2 {
                    m[a][b] += j * row[a] * row[b];
                }
            }
        }
        let det = m[0][0] * m[1][1] - m[0][1] * m[1][0];
        let alpha = [(q[0] * m[1][1] - q[1] * m[0][1]) / det, (q[1] * m[0][0] - q[0] * m[1][0]) / det];
        let found = first(&text);
        close(found("kinetic_energy()"), energy, 1e-12, &format!("{text}\nenergy"));
        for (name, row) in names.iter().zip(rows) {
            let what = format!("{text}\n{name}");
            close(found(&format!("omega({name})")), row[0] * start[0] + row[1] * start[1], 1e-12, &what);
            close(found(&format!("alpha({name})")), row[0] * alpha[0] + row[1] * alpha[1], 1e-11, &what);
        }
    }
}

/// A motor with a pinion on the crank of a heavy crank-slider; a planet that rolls in a ring hangs on the crank's pin.
#[test]
fn wheels_beside_a_linkage() {
    for seed in 0..many(40) {
        let random = &mut Random::new(61_000 + seed);
        let (r, phi) = (random.within(0.05, 0.2), random.within(-3.1, 3.1));
        let (l, s) = (r * random.within(1.5, 4.0), random.within(0.02, 0.2));
        let (rod, piston, planet) =
            (random.within(0.5, 4.0), random.within(0.5, 4.0), random.within(0.2, 2.0));
        let j: Vec<f64> = (0..4).map(|_| random.within(0.001, 0.1)).collect();
        let (r1, r2) = (random.within(0.02, 0.1), random.within(0.05, 0.3));
        let omega = if random.chance(0.2) { 0.0 } else { random.within(-40.0, 40.0) };
        let (motor, load, g) = (random.within(-50.0, 50.0), random.within(-300.0, 300.0), 9.81);
        let wheel = r * random.within(0.1, 0.8);
        let text = format!(
            "gravity {g} m/s^2
ground {{ O (0, 0); M ({} m, 0); line way through O along 0 deg; wheel ring radius {} m at O }}
link crank O-B {r} m {{ wheel big radius {r2} m at O; mass 1 kg at O; inertia {} kg*m^2 }}
link rotor {{ M (0, 0); wheel pinion radius {r1} m at M; mass 1 kg at M; inertia {} kg*m^2 }}
link rod B-C {l} m {{ S ({s} m, 0); mass {rod} kg at S; inertia {} kg*m^2 }}
link piston {{ C (0, 0); mass {piston} kg at C }}
link roll {{ B (0, 0); wheel w radius {wheel} m at B; mass {planet} kg at B; inertia {} kg*m^2 }}
revolute O: ground - crank\nrevolute M: ground - rotor\nrevolute B: crank - rod - roll\nrevolute C: rod - piston
prismatic D: piston.C - ground.way\nmesh k: pinion - big\nmesh p: w - ring {{ internal }}
assemble C ahead of B
torque on rotor = {motor} N*m\nforce on piston at C = ({load} N, 0)
start crank = {phi} rad at {omega} rad/s\nsimulate 1e-4 s within 1e-6
find alpha(crank), alpha(rod), alpha(rotor), alpha(roll), acceleration(C), kinetic_energy()\n",
            r1 + r2,
            r + wheel,
            j[0],
            j[1],
            j[2],
            j[3],
        );
        let (sin, cos) = phi.sin_cos();
        let sin_psi = -r * sin / l;
        let cos_psi = (1.0 - sin_psi * sin_psi).sqrt();
        let psi_1 = -r * cos / (l * cos_psi);
        let psi_2 = (r * sin + l * sin_psi * psi_1 * psi_1) / (l * cos_psi);
        // first and second derivatives by the angle of the crank of a point at this distance along the rod
        let along = |s: f64| {
            let first = (-r * sin - s * psi_1 * sin_psi, r * cos + s * psi_1 * cos_psi);
            let square = psi_1 * psi_1;
            let second = (
                -r * cos - s * (psi_2 * sin_psi + square * cos_psi),
                -r * sin + s * (psi_2 * cos_psi - square * sin_psi),
            );
            (first, second)
        };
        let ((s_1, s_2), (c_1, c_2)) = (along(s), along(l));
        // ring - w internal: r_w ω_w = (r + r_w) 0 - r ω, the ring at rest
        let (i_motor, i_roll) = (-r2 / r1, -r / wheel);
        let inertia = j[0]
            + j[1] * i_motor * i_motor
            + rod * (s_1.0 * s_1.0 + s_1.1 * s_1.1)
            + j[2] * psi_1 * psi_1
            + piston * c_1.0 * c_1.0
            + planet * r * r
            + j[3] * i_roll * i_roll;
        let slope = rod * (s_1.0 * s_2.0 + s_1.1 * s_2.1) + j[2] * psi_1 * psi_2 + piston * c_1.0 * c_2.0;
        let push = motor * i_motor + load * c_1.0 - g * (rod * s_1.1 + planet * r * cos);
        let alpha = (push - slope * omega * omega) / inertia;
        let found = first(&text);
        let check = |name: &str, value: f64| close(found(name), value, 1e-10, &format!("{text}\n{name}"));
        check("alpha(crank)", alpha);
        check("alpha(rod)", psi_1 * alpha + psi_2 * omega * omega);
        check("alpha(rotor)", i_motor * alpha);
        check("alpha(roll)", i_roll * alpha);
        check("acceleration(C)", c_1.0 * alpha + c_2.0 * omega * omega);
        check("kinetic_energy()", 0.5 * inertia * omega * omega);
    }
}
