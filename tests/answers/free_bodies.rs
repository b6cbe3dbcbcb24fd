//! Links that stand freely: against closed forms, and against the same motions by multipliers in steps of their own.

use super::masses::within;
use libm::{cos, sin};
use nalgebra::{DMatrix, DVector};
use std::f64::consts::PI;

const G: f64 = 9.81;

/// Numbers at the end of a motion, SI.
fn at_end(text: &str, names: &[&str]) -> Vec<f64> {
    let solution = assur::solve(format!("{text}find {}\n", names.join(", ")));
    let solution = solution.unwrap_or_else(|e| panic!("{text}\n{e}"));
    let pose = solution.poses().last().expect("a motion has an end");
    let number = |name: &&str| match pose[*name].si() {
        assur::Quantity::Number(x) => x,
        other => panic!("{name} is {other:?} in\n{text}"),
    };
    names.iter().map(number).collect()
}

fn agree(text: &str, found: &[f64], expected: &[f64], tolerance: f64) {
    let most = expected.iter().fold(1.0, |most: f64, x| most.max(x.abs()));
    for (a, b) in found.iter().zip(expected) {
        assert!((a - b).abs() <= tolerance * most, "{found:?} for {expected:?} in\n{text}");
    }
}

#[test]
fn thrown_rods() {
    let mut state = 41;
    for _ in 0..60 {
        let (l, m, t) =
            (within(&mut state, 0.1, 2.0), within(&mut state, 0.1, 9.0), within(&mut state, 0.2, 2.0));
        let [x, y, vx, vy] = [0; 4].map(|_| within(&mut state, -6.0, 6.0));
        let (phi, w, s) =
            (within(&mut state, -PI, PI), within(&mut state, -9.0, 9.0), within(&mut state, 0.1, 0.9));
        // started at a point beside the mass centre
        let (dx, dy) = (-s * l * cos(phi), -s * l * sin(phi));
        let text = format!(
            "gravity 9.81 m/s^2\nlink rod A-B {l} m {{ S ({} m, 0); mass {m} kg at S; inertia {} kg*m^2 }}\nstart rod.A = \
             ({} m, {} m) at ({} m/s, {} m/s)\nstart rod = {phi} rad at {w} rad/s\nsimulate {t} s within 1e-11\n",
            s * l,
            m * l * l / 12.0,
            x + dx,
            y + dy,
            vx - w * dy,
            vy + w * dx,
        );
        let names =
            ["position(rod.S).x", "position(rod.S).y", "velocity(rod.S).y", "omega(rod)", "angle(rod)"];
        let expected = [x + vx * t, y + vy * t - G * t * t / 2.0, vy - G * t, w, phi + w * t];
        agree(&text, &at_end(&text, &names), &expected, 1e-9);
    }
}

/// A disc on a slope: way, speed, angle and rate after a time, and whether it rolls then.
struct Disc {
    r: f64,
    /// J/(m r²)
    j: f64,
    beta: f64,
    f: f64,
    v: f64,
    w: f64,
}

impl Disc {
    fn after(&self, time: f64) -> ([f64; 4], bool) {
        let (pull, grip) = (G * sin(self.beta), self.f * G * cos(self.beta));
        let (mut t, mut s, mut v, mut phi, mut w) = (0.0, 0.0, self.v, 0.0, self.w);
        // what holds it when it rolls
        let rolls = pull * self.j / (1.0 + self.j) <= grip;
        loop {
            // of the point that touches; down the slope is positive, and so is the rate counter-clockwise
            let slip = v + w * self.r;
            let resting = slip.abs() < 1e-12 * (1.0 + v.abs());
            let sense = if resting { 1.0 } else { slip.signum() };
            let (a, alpha) = if resting && rolls {
                (pull / (1.0 + self.j), -pull / (1.0 + self.j) / self.r)
            } else {
                (pull - sense * grip, -sense * grip / (self.j * self.r))
            };
            let change = a + alpha * self.r;
            let until = if !resting && slip * change < 0.0 { -slip / change } else { f64::INFINITY };
            let step = until.min(time - t);
            (s, phi) = (s + (v + a * step / 2.0) * step, phi + (w + alpha * step / 2.0) * step);
            (v, w) = (v + a * step, w + alpha * step);
            t += step;
            if step < until {
                return ([s, v, phi, w], resting && rolls);
            }
        }
    }
}

#[test]
fn discs_on_slopes() {
    let mut state = 42;
    let mut rolling = 0;
    for _ in 0..80 {
        let disc = Disc {
            r: within(&mut state, 0.05, 0.5),
            j: within(&mut state, 0.4, 1.0),
            beta: within(&mut state, 0.02, 1.2),
            f: within(&mut state, 0.05, 0.7),
            v: within(&mut state, -4.0, 4.0),
            w: within(&mut state, -20.0, 20.0),
        };
        let (m, t) = (within(&mut state, 0.5, 5.0), within(&mut state, 0.5, 3.0));
        let (c, s) = (cos(disc.beta), sin(disc.beta));
        let text = format!(
            "gravity 9.81 m/s^2\ngiven beta = {} rad\nground {{ O (0, 0); line slope through O along -beta }}\nlink disc {{ C \
             (0, 0); circle rim centre C radius {} m; mass {m} kg at C; inertia {} kg*m^2 }}\ncontact K: disc.rim - \
             ground.slope {{ friction {} }}\nstart disc.C = ({} m, {} m) at ({} m/s, {} m/s)\nstart disc = 0 rad at {} \
             rad/s\nsimulate {t} s within 1e-11\nlet way = position(disc.C).x*cos(beta) - position(disc.C).y*sin(beta)\nlet \
             speed = velocity(disc.C).x*cos(beta) - velocity(disc.C).y*sin(beta)\n",
            disc.beta,
            disc.r,
            disc.j * m * disc.r * disc.r,
            disc.f,
            disc.r * s,
            disc.r * c,
            disc.v * c,
            -disc.v * s,
            disc.w,
        );
        let (expected, rolls) = disc.after(t);
        rolling += usize::from(rolls);
        agree(&text, &at_end(&text, &["way", "speed", "angle(disc)", "omega(disc)"]), &expected, 1e-8);
    }
    assert!((20..60).contains(&rolling), "{rolling} roll in the end");
}

/// Two hinged rods of lengths, masses: places of both mass centres and angles, accelerated by weights and a multiplier.
fn accelerated(l: [f64; 2], m: [f64; 2], state: &DVector<f64>) -> DVector<f64> {
    let mut a = DMatrix::zeros(8, 8);
    let mut b = DVector::zeros(8);
    for i in 0..2 {
        let (phi, w) = (state[3 * i + 2], state[6 + 3 * i + 2]);
        // the hinge from the mass centre: at the end of the first, at the begin of the second
        let sign = if i == 0 { 1.0 } else { -1.0 };
        let (rx, ry) = (sign * l[i] / 2.0 * cos(phi), sign * l[i] / 2.0 * sin(phi));
        for (k, mass) in [m[i], m[i], m[i] * l[i] * l[i] / 12.0].into_iter().enumerate() {
            a[(3 * i + k, 3 * i + k)] = mass;
        }
        b[3 * i + 1] = -m[i] * G;
        for (row, gradient) in [[1.0, 0.0, -ry], [0.0, 1.0, rx]].into_iter().enumerate() {
            for (k, g) in gradient.into_iter().enumerate() {
                a[(6 + row, 3 * i + k)] = sign * g;
                a[(3 * i + k, 6 + row)] = sign * g;
            }
            b[6 + row] += sign * [rx, ry][row] * w * w;
        }
    }
    let found = a.lu().solve(&b).expect("masses are positive");
    let mut rates = DVector::zeros(12);
    for k in 0..6 {
        (rates[k], rates[6 + k]) = (state[6 + k], found[k]);
    }
    rates
}

#[test]
fn hinged_rods() {
    let mut state = 43;
    for _ in 0..60 {
        let l = [0; 2].map(|_| within(&mut state, 0.2, 1.0));
        let m = [0; 2].map(|_| within(&mut state, 0.5, 4.0));
        let [phi, other] = [0; 2].map(|_| within(&mut state, -PI, PI));
        let [w, turn] = [0; 2].map(|_| within(&mut state, -5.0, 5.0));
        let [x, y, vx, vy] = [0; 4].map(|_| within(&mut state, -3.0, 3.0));
        let t = 0.5;
        let link = |name: &str, ends: &str, i: usize| {
            format!(
                "link {name} {ends} {} m {{ S ({} m, 0); mass {} kg at S; inertia {} kg*m^2 }}\n",
                l[i],
                l[i] / 2.0,
                m[i],
                m[i] * l[i] * l[i] / 12.0
            )
        };
        let text = format!(
            "gravity 9.81 m/s^2\n{}{}revolute B: a - b\nstart a.S = ({x} m, {y} m) at ({vx} m/s, {vy} m/s)\nstart a = {phi} \
             rad at {w} rad/s\nstart b = {other} rad at {turn} rad/s\nsimulate {t} s within 1e-11\n",
            link("a", "A-B", 0),
            link("b", "B-C", 1),
        );
        let half = |i: usize, angle: f64| (l[i] / 2.0 * cos(angle), l[i] / 2.0 * sin(angle));
        let ((ax, ay), (bx, by)) = (half(0, phi), half(1, other));
        let mut now = DVector::from_vec(vec![
            x,
            y,
            phi,
            x + ax + bx,
            y + ay + by,
            other,
            vx,
            vy,
            w,
            vx - ay * w - by * turn,
            vy + ax * w + bx * turn,
            turn,
        ]);
        let steps = 1000;
        let h = t / f64::from(steps);
        for _ in 0..steps {
            let k_1 = accelerated(l, m, &now);
            let k_2 = accelerated(l, m, &(&now + &k_1 * (h / 2.0)));
            let k_3 = accelerated(l, m, &(&now + &k_2 * (h / 2.0)));
            let k_4 = accelerated(l, m, &(&now + &k_3 * h));
            now += (k_1 + k_2 * 2.0 + k_3 * 2.0 + k_4) * (h / 6.0);
        }
        let names = ["position(a.S).x", "position(a.S).y", "angle(a)", "angle(b)", "omega(a)", "omega(b)"];
        let expected = [now[0], now[1], now[2], now[5], now[8], now[11]];
        agree(&text, &at_end(&text, &names), &expected, 1e-7);
    }
}

#[test]
fn round_a_bowl_and_over_a_hill() {
    // x and y of the ball take turns as its coordinate; rolling, its speed follows from the energy
    let text = "gravity 9.81 m/s^2\nground { O (0, 0); circle loop centre O radius 1 m }\nlink disc { C (0, 0); circle rim centre C \
                radius 0.1 m; mass 2 kg at C; inertia 0.01 kg*m^2 }\ncontact K: disc.rim - ground.loop { internal; friction 0.9 \
                }\nstart disc.C = (0, -0.9 m) at (7 m/s, 0)\nstart disc = 0 deg at -70 rad/s\nsimulate 3 s within 1e-10\n";
    let found = at_end(text, &["position(disc.C).y", "mag(velocity(disc.C))", "mag(position(disc.C))"]);
    let fall = -0.9 - found[0];
    agree(text, &found[1..], &[(49.0 + 4.0 / 3.0 * G * fall).sqrt(), 0.9], 1e-8);
    // friction of 0.9 would lock the disc against a force along x here, but there is none
    let text = "gravity 9.81 m/s^2\nground { O (0, 0); circle hill centre O radius 2 m }\nlink disc { C (0, 0); circle rim centre C \
                radius 0.1 m; mass 1 kg at C; inertia 0.005 kg*m^2 }\ncontact K: disc.rim - ground.hill { friction 0.9 }\nstart \
                disc.C = 2.1 m @ 140 deg at 3.4 m/s @ 50 deg\nstart disc = 0 deg at -34 rad/s\nsimulate 0.6 s within 1e-10\n";
    let found = at_end(text, &["mag(velocity(disc.C)) + omega(disc)*0.1 m / 1 rad", "mag(position(disc.C))"]);
    agree(text, &found, &[0.0, 2.1], 1e-8);
}

#[test]
fn functions_of_a_slide_that_begins_at_the_origin() {
    let text = "ground { O (0, 0); line way through O along 0 deg }\nlink slide { S (0, 0); mass 8 kg at S }\nprismatic G: slide.S - \
                ground.way\ndrive G = 0 mm at 1 m/s accelerating 2 m/s^2\nsimulate 2 s\n";
    let names = ["max(power(G))", "min(power(G))", "mean(power(G))", "integral(power(G))"];
    let solution = assur::solve(format!("{text}find {}\n", names.join(", "))).expect("a motion");
    let found: Vec<f64> = names
        .iter()
        .map(|name| match solution[*name].si() {
            assur::Quantity::Number(x) => x,
            other => panic!("{name} is {other:?}"),
        })
        .collect();
    agree(text, &found, &[80.0, 16.0, 48.0, 96.0], 1e-9);
}

#[test]
fn the_corner_of_a_drive_has_the_rate_behind_it() {
    let text = "ground { A (0, 0) }\nlink crank A-B 60 mm { mass 2 kg at B; inertia 0.01 kg*m^2 }\nrevolute A: ground - crank\ndrive crank = \
                20 rad/s^2*min(time, 1 s)^2/2 + 20 rad/s*max(time - 1 s, 0 s)\nsimulate 2 s in 2 steps\n";
    let solution = assur::solve(format!("{text}find omega(crank)\n")).expect("a motion");
    assert_eq!(solution.poses()[1]["omega(crank)"].si(), assur::Quantity::Number(20.0));
    // both ends of the drive turn at one instant: between them there is no speed of 40 rad/s
    let extremes = ["max(omega(crank))", "max(alpha(crank))", "min(alpha(crank))"];
    let solution = assur::solve(format!("{text}find {}\n", extremes.join(", "))).expect("a motion");
    let found = extremes.map(|name| solution[name].si());
    assert_eq!(found, [20.0, 20.0, 0.0].map(assur::Quantity::Number));
}

#[test]
fn discs_that_slide_off_a_hill() {
    let mut state = 47;
    for _ in 0..12 {
        let (r, radius, m) =
            (within(&mut state, 0.02, 0.2), within(&mut state, 0.5, 3.0), within(&mut state, 0.5, 5.0));
        let (f, from) = (within(&mut state, 0.02, 0.2), within(&mut state, 0.1, 0.4));
        let all = r + radius;
        let speed = within(&mut state, 0.3, 0.6) * (G * all * cos(from)).sqrt();
        // the angle from the top, its rate, and the rolling speed, which stays behind; until nothing presses
        let rates = |[angle, rate, _]: [f64; 3]| {
            let presses = G * cos(angle) - all * rate * rate;
            [rate, (G * sin(angle) - f * presses) / all, 2.0 * f * presses]
        };
        let step = |y: [f64; 3], h: f64| {
            let plus = |k: [f64; 3], h: f64| [0, 1, 2].map(|i| y[i] + h * k[i]);
            let a = rates(y);
            let b = rates(plus(a, h / 2.0));
            let c = rates(plus(b, h / 2.0));
            let d = rates(plus(c, h));
            [0, 1, 2].map(|i| y[i] + h / 6.0 * (a[i] + 2.0 * (b[i] + c[i]) + d[i]))
        };
        let presses = |[angle, rate, _]: [f64; 3]| G * cos(angle) - all * rate * rate;
        let (mut y, mut t, mut h) = ([from, speed / all, 0.0], 0.0, 1e-3);
        while h > 1e-14 {
            let then = step(y, h);
            if presses(then) > 0.0 {
                (y, t) = (then, t + h);
            } else {
                h /= 2.0;
            }
        }
        assert!(y[1] * all > y[2], "it rolls: {f} {y:?}");
        let turned = 90.0 - from.to_degrees();
        let j = m * r * r / 2.0;
        let text = &format!(
            "gravity 9.81 m/s^2\nground {{ O (0, 0); circle hill centre O radius {radius:?} m }}\nlink disc {{ C (0, 0); circle rim centre C \
             radius {r:?} m; mass {m:?} kg at C; inertia {j:?} kg*m^2 }}\ncontact K: disc.rim - ground.hill {{ friction {f:?} \
             }}\nstart disc.C = {all:?} m @ {turned:?} deg at {speed:?} m/s @ {:?} deg\nstart disc = 0 deg at 0 rad/s\nuntil \
             normal(K, disc) < 0 N\nsimulate 9 s within 1e-10\n",
            turned - 90.0
        );
        let found = at_end(text, &["time", "mag(velocity(disc.C))", "omega(disc)", "position(disc.C).y"]);
        agree(text, &found, &[t, y[1] * all, -y[2] / r, all * cos(y[0])], 1e-7);
        let opens = assur::solve(text.replace("until normal(K, disc) < 0 N\n", "")).expect(text);
        assert!(
            opens.diagnostics().iter().any(|d| d.code.as_deref() == Some("mech::simulate::opens")),
            "{text}"
        );
    }
}
