//! Wheels on racks whose axes move: points that touch have one velocity, a point of the rim runs on a cycloid, and the forces
//! come from the work of all inertia forces.

#![allow(clippy::disallowed_methods, reason = "an independent computation")]

use crate::geared_chains::{answers, close};
use crate::support::random::Random;

/// A disc on a carriage, joined by a rod to a crank: driven at the crank, the disc is found with the rod.
#[test]
fn a_point_of_a_rolling_wheel_runs_on_a_cycloid() {
    let mut random = Random::new(81);
    let mut solved = 0;
    for _ in 0..60 {
        let (r, p) = (random.within(0.05, 0.15), random.within(0.03, 0.2));
        let turn = random.within(-3.0, 3.0);
        let (speed, second) = (random.within(0.5, 3.0), random.within(-5.0, 5.0));
        // the disc is at its angle where its axis is at −r angle
        let at = |t: f64| {
            let angle = turn + speed * t + 0.5 * second * t * t;
            (-r * angle + p * angle.cos(), r + p * angle.sin())
        };
        let (l, crank) = (random.within(0.3, 0.5), random.within(0.1, 0.3));
        let (x, y) = at(0.0);
        let to_q = random.within(-3.0, 3.0);
        let (q_x, q_y) = (x + l * to_q.cos(), y + l * to_q.sin());
        let from_c = random.within(-3.0, 3.0);
        let (c_x, c_y) = (q_x - crank * from_c.cos(), q_y - crank * from_c.sin());
        // the crank's angle by the circle of the rod about the point of the rim
        let crank_at = |t: f64| {
            let (x, y) = at(t);
            let (d_x, d_y) = (x - c_x, y - c_y);
            let d = d_x.hypot(d_y);
            let cos = (crank * crank + d * d - l * l) / (2.0 * crank * d);
            let side = if d_x * from_c.sin() - d_y * from_c.cos() > 0.0 { 1.0 } else { -1.0 };
            d_y.atan2(d_x) + side * cos.acos()
        };
        // Richardson's central differences
        let first = |h: f64| (crank_at(h) - crank_at(-h)) / (2.0 * h);
        let rate = (4.0 * first(5e-4) - first(1e-3)) / 3.0;
        let bend = |h: f64| (crank_at(h) - 2.0 * crank_at(0.0) + crank_at(-h)) / (h * h);
        let bent = (4.0 * bend(1e-3) - bend(2e-3)) / 3.0;
        if !(rate.abs() > 0.3 && rate.abs() < 20.0 && bent.is_finite() && bent.abs() < 500.0) {
            continue;
        }
        let (m, j, cart) = (random.within(0.5, 3.0), random.within(0.01, 0.05), random.within(0.5, 2.0));
        let text = format!(
            "ground {{ O (0, 0); C ({c_x} m, {c_y} m); A0 (0, {r} m); line floor through O along 0 deg; line way through A0 along 0 deg }}\n\
             link cart {{ A (0, 0); mass {cart} kg at A }}\n\
             link disc {{ A (0, 0); P ({p} m, 0); wheel w radius {r} m at A; mass {m} kg at A; inertia {j} kg*m^2 }}\n\
             link c P-Q {l} m\nlink crank C-Q {crank} m\n\
             prismatic D: cart.A - ground.way\nrevolute A: cart - disc\nrevolute P: disc - c\nrevolute Q: c - crank\n\
             revolute C: ground - crank\nrack k: w - ground.floor\n\
             drive crank = {} rad at {} rad/s {} accelerating {bent} rad/s^2\n\
             assemble disc.P near ({x} m, {y} m)\nbalance torque M on crank\n\
             find angle(disc), omega(disc), alpha(disc), displacement(D), position(disc.P), M, tangential_force(k)\n",
            crank_at(0.0),
            rate.abs(),
            if rate < 0.0 { "cw" } else { "ccw" },
        );
        let found = answers(&text);
        let Some(found) = &found[0] else { panic!("{text}") };
        close(found["angle(disc)"][0], turn, 1e-7, &text);
        close(found["displacement(D)"][0], -r * turn, 1e-7, &text);
        close(found["omega(disc)"][0], speed, 1e-6, &text);
        close(found["alpha(disc)"][0], second, 1e-3, &text);
        let (omega, alpha) = (found["omega(disc)"][0], found["alpha(disc)"][0]);
        let power = ((m + cart) * r * r + j) * alpha * omega;
        close(found["M"][0] * rate, power, 1e-5, &text);
        solved += 1;
    }
    assert!(solved > 30, "{solved}");
}

/// A wheel on a carriage of a rack that turns, and a wheel on a link that guides the rack.
#[test]
fn wheels_roll_on_racks_of_links_that_turn() {
    let mut random = Random::new(82);
    for i in 0..40 {
        let r = random.within(0.05, 0.2);
        let (along, height) = (random.within(-180.0, 180.0), random.within(-0.1, 0.1));
        let flipped = random.sign() < 0.0;
        let way = if flipped { along + 180.0 } else { along };
        let (omega, alpha) = (random.within(0.5, 3.0), random.within(-3.0, 3.0));
        let (v, a) = (random.within(0.1, 0.5), random.within(-2.0, 2.0));
        let e = [along.to_radians().cos(), along.to_radians().sin()];
        let n = [-e[1], e[0]];
        let (teeth, axis) = ([n[0] * height, n[1] * height], [n[0] * (height + r), n[1] * (height + r)]);
        let carried = i % 2 == 0;
        let common = format!(
            "ground {{ O (0, 0) }}\n\
             link L {{ O (0, 0); T ({} m, {} m); W ({} m, {} m); line teeth through T along {along} deg; line way through W along {way} deg }}\n\
             revolute O: ground - L\ndrive L = 10 deg at {omega} rad/s accelerating {alpha} rad/s^2\n\
             drive D = 0.1 m at {v} m/s accelerating {a} m/s^2\nbalance torque M on L\n",
            teeth[0], teeth[1], axis[0], axis[1]
        );
        let (m, j) = (random.within(0.5, 2.0), random.within(0.005, 0.02));
        let disc = format!(
            "link disc {{ A (0, 0); wheel w radius {r} m at A; mass {m} kg at A; inertia {j} kg*m^2 }}\n"
        );
        let rest = if carried {
            format!(
                "{disc}link cart {{ A (0, 0) }}\nprismatic D: cart.A - L.way\nrevolute A: cart - disc\nrack k: w - L.teeth\n\
                 balance force F on cart at A along 0 deg\n"
            )
        } else {
            format!(
                "{disc}link bar {{ B (0, 0); line own through B along 0 deg; mass 2 kg at B }}\nprismatic D: bar.B - L.teeth\nrevolute W: L.W - disc.A\n\
                 rack k: w - bar.own\nbalance force F on bar at B along 0 deg\n"
            )
        };
        let text = format!(
            "{common}{rest}find omega(disc), alpha(disc), velocity(disc.A), M, F, velocity(L.T), acceleration(disc.A)\n{}",
            if carried { "" } else { "find velocity(bar.B)\n" }
        );
        let found = answers(&text);
        let Some(found) = &found[0] else { panic!("{text}") };
        // the carriage moves along its own line, which may run against the teeth
        let sense = if flipped && carried { -1.0 } else { 1.0 };
        let rolled = if carried { -sense / r } else { 1.0 / r };
        close(found["omega(disc)"][0], omega + rolled * v, 1e-10, &text);
        close(found["alpha(disc)"][0], alpha + rolled * a, 1e-10, &text);
        // where wheel and rack touch they have one velocity along the teeth
        let turn = 10.0_f64.to_radians();
        let d = [e[0] * turn.cos() - e[1] * turn.sin(), e[0] * turn.sin() + e[1] * turn.cos()];
        let centre = &found["velocity(disc.A)"];
        let touching = centre[0] * d[0] + centre[1] * d[1] + r * found["omega(disc)"][0];
        let rack = if carried { &found["velocity(L.T)"] } else { &found["velocity(bar.B)"] };
        close(rack[0] * d[0] + rack[1] * d[1], touching, 1e-10, &text);
    }
}

/// Rack and carriage both move: two drives.
#[test]
fn a_wheel_between_two_racks_takes_their_mean() {
    let mut random = Random::new(83);
    for _ in 0..20 {
        let (r, v_1, v_2) = (random.within(0.05, 0.2), random.within(0.1, 1.0), random.within(0.1, 1.0));
        let (m, j) = (3.0, random.within(0.01, 0.1));
        // the upper rack is turned over, so that the wheel lies to the left of its own line too
        let text = format!(
            "ground {{ O (0, 0); A (0, {r} m); B (0, {} m); line low through O along 0 deg; line way through A along 0 deg; line high through B along 180 deg }}\n\
             link low {{ O (0, 0); line own through O along 0 deg }}\nlink high {{ B (0, 0); line own through B along 0 deg }}\n\
             link cart {{ A (0, 0) }}\nlink disc {{ A (0, 0); wheel w radius {r} m at A; mass {m} kg at A; inertia {j} kg*m^2 }}\n\
             prismatic L: low.O - ground.low\nprismatic H: high.B - ground.high\nprismatic D: cart.A - ground.way\nrevolute A: cart - disc\n\
             rack k: w - low.own\nrack n: w - high.own\n\
             drive L = 0 m at {v_1} m/s\ndrive H = 0 m at {v_2} m/s accelerating 2 m/s^2\n\
             balance force F on high at B along 0 deg\nbalance force G on low at O along 0 deg\n\
             find velocity(cart.A).x, velocity(high.B).x, velocity(low.O).x, omega(disc), F, G\n",
            2.0 * r
        );
        let found = answers(&text);
        let Some(found) = &found[0] else { panic!("{text}") };
        let of = |what: &str| found[what][0];
        let (low, high) = (of("velocity(low.O).x"), of("velocity(high.B).x"));
        close(of("velocity(cart.A).x"), 0.5 * (low + high), 1e-12, &text);
        close(of("omega(disc)"), (low - high) / (2.0 * r), 1e-12, &text);
        close(low, v_1, 1e-12, &text);
        // accelerations: the high one by 2 along its line, which is half as much of the axis
        let a = if high * v_2 > 0.0 { 2.0 } else { -2.0 };
        let (of_axis, of_turn) = (m * a / 2.0, j * (-a / (2.0 * r)));
        close(of("F"), 0.5 * of_axis - of_turn / (2.0 * r), 1e-10, &text);
        close(of("G"), 0.5 * of_axis + of_turn / (2.0 * r), 1e-10, &text);
    }
}

/// A rack that rolls on a wheel of the ground: its points run on involutes of the wheel.
#[test]
fn a_rack_rolls_on_a_wheel_of_the_ground() {
    let mut random = Random::new(29);
    for _ in 0..20 {
        let (r, phi, omega) = (random.within(0.05, 0.3), random.within(-2.0, 2.0), random.within(0.5, 4.0));
        let (place, force) = (random.within(0.1, 0.5), random.within(10.0, 100.0));
        let text = format!(
            "ground {{ O (0, 0); wheel w radius {r} m at O }}\nlink arm {{ O (0, 0); Q (0, {} m); line way through Q along 0 deg }}\n\
             link bar {{ A (0, 0); B ({place} m, 0); line teeth through A along 0 deg }}\nrevolute O: ground - arm\n\
             prismatic P: bar.A - arm.way\nrack k: w - bar.teeth\ndrive arm = {phi} rad at {omega} rad/s\n\
             force F on bar at B = {force} N down\nbalance torque M on arm\nfind position(bar.A), velocity(bar.A), omega(bar), M\n",
            -r
        );
        let found = answers(&text);
        let Some(found) = &found[0] else { panic!("{text}") };
        let (sin, cos) = (libm::sin(phi), libm::cos(phi));
        // from the place of contact, r (sin, -cos), back along the rack
        let wanted = [r * (sin - phi * cos), -r * (cos + phi * sin)];
        let rate = [r * omega * phi * sin, -r * omega * phi * cos];
        for axis in 0..2 {
            close(found["position(bar.A)"][axis], wanted[axis], 1e-10, &text);
            close(found["velocity(bar.A)"][axis], rate[axis], 1e-10, &text);
        }
        close(found["omega(bar)"][0], omega, 1e-12, &text);
        // it turns about the place of contact
        close(found["M"][0], force * (place - r * phi) * cos, 1e-9, &text);
    }
}
