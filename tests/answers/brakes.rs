//! Loads against the motion of several free coordinates, which come to rest one by one and get going again, against a small integrator
//! of its own: Runge and Kutta in short steps, rests and their ends by bisection.

#![allow(clippy::unwrap_used)] // a test that cannot read its text has failed

use crate::share::part;
use assur::Solution;
use assur::internals::check::Overrides;
use assur::internals::solve::IntegrationOptions;
use assur::internals::source::Source;
use assur::internals::{compile, pipeline};
use std::fmt::Write as _;

/// The mass matrix and the forces without brakes: of a phase of the loads, the time, places and rates.
type Law<'w> = &'w dyn Fn(usize, f64, &[f64], &[f64]) -> (Vec<Vec<f64>>, Vec<f64>);

/// A mechanism whose coordinates are those that brakes act on.
struct World<'w> {
    law: Law<'w>,
    /// What the brakes hold at most, at places and rates.
    limits: &'w dyn Fn(f64, &[f64]) -> Vec<f64>,
    /// Where the loads switch, s.
    switches: Vec<f64>,
}

/// Coordinates, rates, works of the brakes and integrals of their efforts, one after the other.
#[derive(Clone)]
struct Now {
    t: f64,
    y: Vec<f64>,
    /// ±1, or 0 where a brake holds.
    senses: Vec<f64>,
    phase: usize,
}

fn solve(mut a: Vec<Vec<f64>>, mut b: Vec<f64>) -> Vec<f64> {
    let n = b.len();
    for i in 0..n {
        let pivot = (i..n).max_by(|p, q| a[*p][i].abs().total_cmp(&a[*q][i].abs())).unwrap();
        a.swap(i, pivot);
        b.swap(i, pivot);
        for k in i + 1..n {
            let part = a[k][i] / a[i][i];
            let row = a[i].clone();
            a[k].iter_mut().zip(&row).skip(i).for_each(|(x, y)| *x -= part * y);
            b[k] -= part * b[i];
        }
    }
    for i in (0..n).rev() {
        let known: f64 = (i + 1..n).map(|j| a[i][j] * b[j]).sum();
        b[i] = (b[i] - known) / a[i][i];
    }
    b
}

impl World<'_> {
    /// Accelerations, and what the brakes exert.
    fn accelerate(&self, now: &Now, t: f64, y: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let n = now.senses.len();
        let (mass, force) = (self.law)(now.phase, t, &y[..n], &y[n..2 * n]);
        let limits = (self.limits)(t, &y[..2 * n]);
        let mut matrix = mass;
        let mut right = force;
        for (i, sense) in now.senses.iter().enumerate() {
            if *sense == 0.0 {
                // the unknown is what holds
                matrix.iter_mut().enumerate().for_each(|(k, row)| row[i] = if k == i { -1.0 } else { 0.0 });
            } else {
                right[i] -= sense * limits[i];
            }
        }
        let x = solve(matrix, right);
        let held = |i: usize| now.senses[i] == 0.0;
        let a = (0..n).map(|i| if held(i) { 0.0 } else { x[i] }).collect();
        let efforts = (0..n).map(|i| if held(i) { x[i] } else { -now.senses[i] * limits[i] }).collect();
        (a, efforts)
    }

    fn step(&self, now: &Now, h: f64) -> Now {
        let n = now.senses.len();
        let slope = |t: f64, y: &[f64]| {
            let (a, efforts) = self.accelerate(now, t, y);
            let powers = efforts.iter().zip(&y[n..2 * n]).map(|(m, w)| m * w);
            [y[n..2 * n].to_vec(), a, powers.collect(), efforts.clone()].concat()
        };
        let on = |k: &[f64], h: f64| now.y.iter().zip(k).map(|(y, k)| y + h * k).collect::<Vec<_>>();
        let one = slope(now.t, &now.y);
        let two = slope(now.t + h / 2.0, &on(&one, h / 2.0));
        let three = slope(now.t + h / 2.0, &on(&two, h / 2.0));
        let four = slope(now.t + h, &on(&three, h));
        let mean: Vec<f64> =
            (0..one.len()).map(|i| (one[i] + 2.0 * (two[i] + three[i]) + four[i]) / 6.0).collect();
        Now { t: now.t + h, y: on(&mean, h), ..now.clone() }
    }

    /// The coordinates that have turned, or whose brakes must hold more than they can.
    fn passed(&self, now: &Now) -> Vec<usize> {
        let n = now.senses.len();
        let (_, efforts) = self.accelerate(now, now.t, &now.y);
        let limits = (self.limits)(now.t, &now.y[..2 * n]);
        let passed = |i: &usize| match now.senses[*i] {
            0.0 => efforts[*i].abs() > limits[*i],
            sense => sense * now.y[n + i] < -1e-13,
        };
        (0..n).filter(passed).collect()
    }

    /// Goes on from where these coordinates have come to rest, or are let go.
    fn choose(&self, now: &mut Now, open: &[usize], let_go: &[usize]) {
        let n = now.senses.len();
        let limits = (self.limits)(now.t, &now.y[..2 * n]);
        for way in 0..3_usize.pow(u32::try_from(open.len()).unwrap()) {
            for (place, &i) in open.iter().enumerate() {
                now.senses[i] = [0.0, 1.0, -1.0][way / 3_usize.pow(u32::try_from(place).unwrap()) % 3];
            }
            let (a, efforts) = self.accelerate(now, now.t, &now.y);
            let fits = open.iter().all(|&i| match now.senses[i] {
                0.0 => !let_go.contains(&i) && efforts[i].abs() <= limits[i],
                sense => a[i] * sense >= -1e-12 * (1.0 + limits[i]),
            });
            if fits {
                return;
            }
        }
        panic!("no way at {}", now.t);
    }

    /// From the coordinates and rates at 0 s, the states at these instants.
    fn run(&self, start: &[(f64, f64)], instants: &[f64], longest: f64) -> Vec<(Now, Vec<f64>)> {
        let n = start.len();
        let rates = start.iter().map(|s| s.1);
        let y = start.iter().map(|s| s.0).chain(rates.clone()).chain(vec![0.0; 2 * n]).collect();
        let senses = rates.map(|rate| if rate == 0.0 { 0.0 } else { rate.signum() }).collect();
        let mut now = Now { t: 0.0, y, senses, phase: 0 };
        let resting = |now: &Now| (0..n).filter(|&i| now.y[n + i] == 0.0).collect::<Vec<_>>();
        let open = resting(&now);
        self.choose(&mut now, &open, &[]);
        let mut found = Vec::new();
        for &instant in instants {
            while now.t < instant {
                let switch = self.switches.get(now.phase).copied().unwrap_or(f64::INFINITY);
                let to = instant.min(switch);
                let h = longest.min(to - now.t);
                let mut then = self.step(&now, h);
                if self.passed(&then).is_empty() {
                    if h == to - now.t {
                        then.t = to;
                    }
                    now = then;
                    if now.t >= switch {
                        now.phase += 1;
                        let open = resting(&now);
                        self.choose(&mut now, &open, &[]);
                    }
                    continue;
                }
                let (mut low, mut high) = (0.0, h);
                for _ in 0..70 {
                    let mid = 0.5 * (low + high);
                    let passed = !self.passed(&self.step(&now, mid)).is_empty();
                    if passed { high = mid } else { low = mid }
                }
                now = self.step(&now, high);
                let passed = self.passed(&now);
                let let_go: Vec<usize> = passed.iter().copied().filter(|i| now.senses[*i] == 0.0).collect();
                passed.iter().for_each(|i| now.y[n + i] = 0.0);
                let open = resting(&now);
                self.choose(&mut now, &open, &let_go);
            }
            let (_, efforts) = self.accelerate(&now, now.t, &now.y);
            found.push((now.clone(), efforts));
        }
        found
    }
}

/// Numbers without end.
fn random(seed: u64) -> impl FnMut(f64, f64) -> f64 {
    let mut state = seed;
    move |from, to| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let part = f64::from(u32::try_from(state >> 32).unwrap()) / f64::from(u32::MAX);
        from + part * (to - from)
    }
}

/// What is asked for: rates and efforts of the brakes by name.
struct Asked<'a> {
    rates: &'a [&'a str],
    efforts: &'a [&'a str],
    /// The efforts are those of the brakes alone.
    alone: bool,
}

/// Solves a file with as many instants, evenly, as the other has, and compares.
fn compare(text: &str, asked: &Asked<'_>, right: &[(Now, Vec<f64>)]) {
    let n = asked.rates.len();
    let mut text = text.to_owned();
    let (last, steps) = (right.last().unwrap().0.t, right.len());
    writeln!(text, "simulate {last} s in {steps} steps").unwrap();
    for (i, rate) in asked.rates.iter().enumerate() {
        writeln!(text, "find w{i} = {rate}").unwrap();
    }
    for (i, effort) in asked.efforts.iter().enumerate() {
        let name = effort.trim_end_matches(".x");
        writeln!(text, "find m{i} = {effort}, work{i} = work({name}), mean{i} = mean({effort})").unwrap();
        writeln!(text, "find most{i} = max({effort}), least{i} = min({effort})").unwrap();
    }
    let solution: Solution = assur::solve(&text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    let at = |pose: usize, name: String| {
        solution.poses()[pose][&*name].number().unwrap_or_else(|| panic!("{name} has no value\n{text}"))
    };
    type At = (Now, Vec<f64>);
    let greatest = |of: &dyn Fn(&At) -> f64| right.iter().map(of).fold(1e-3, f64::max);
    for i in 0..n {
        let fastest = greatest(&|(now, _)| now.y[n + i].abs());
        for (pose, (now, _)) in right.iter().enumerate() {
            let (got, right) = (at(pose + 1, format!("w{i}")), now.y[n + i]);
            assert!(
                (got - right).abs() < 2e-7 * fastest.max(1.0),
                "w{i} at {}: {got}, not {right}\n{text}",
                now.t
            );
            assert!(now.senses[i] != 0.0 || got.abs() < 1e-12, "w{i} at {}: {got} at rest\n{text}", now.t);
        }
    }
    for i in (0..asked.efforts.len()).filter(|_| asked.alone) {
        let strongest = greatest(&|(_, efforts)| efforts[i].abs());
        for (pose, (now, efforts)) in right.iter().enumerate() {
            for (name, right, within) in [
                (format!("m{i}"), efforts[i], 1e-6 * strongest),
                (format!("work{i}"), now.y[2 * n + i], 1e-6 * (1.0 + now.y[2 * n + i].abs())),
            ] {
                let got = at(pose + 1, name.clone());
                assert!((got - right).abs() < within, "{name} at {}: {got}, not {right}\n{text}", now.t);
            }
        }
        let (mean, got) = (right.last().unwrap().0.y[3 * n + i] / last, at(0, format!("mean{i}")));
        assert!((mean - got).abs() < 1e-6 * strongest, "mean{i}: {got}, not {mean}\n{text}");
        let (most, least) = (at(0, format!("most{i}")), at(0, format!("least{i}")));
        for (_, efforts) in right {
            assert!((least..=most).contains(&efforts[i].clamp(least, most)), "{text}");
            assert!(efforts[i] < most + 1e-6 * strongest && efforts[i] > least - 1e-6 * strongest, "{text}");
        }
    }
    let evaluations = evaluations(&text);
    assert!(evaluations < 20_000, "{evaluations} evaluations\n{text}");
}

/// Evaluations in all runs of a motion.
fn evaluations(text: &str) -> usize {
    let (compiled, _) = compile(&Source::new("run.mech", text), &Overrides::none());
    let (solved, _) = pipeline::solve_conducted(compiled.unwrap(), None, &IntegrationOptions::default());
    solved.unwrap_or_else(|_| panic!("{text}")).solution.simulation.unwrap().evaluations
}

fn instants(end: f64, steps: u32) -> Vec<f64> {
    (1..=steps).map(|i| end * f64::from(i) / f64::from(steps)).collect()
}

/// Discs on one pin with springs between them and loads that come and go; brakes also by place, time, or their own speed.
#[test]
fn discs_with_brakes_and_springs() {
    let mut random = random(5);
    for case in 0..part(24) {
        let by_speed = case % 5 == 3;
        let n: usize = if by_speed { 1 + case % 3 } else { 2 + case % 2 };
        let inertias: Vec<f64> = (0..n).map(|_| random(0.5, 3.0)).collect();
        let springs: Vec<f64> =
            (0..n).map(|_| random(0.0, 20.0) * f64::from(u8::from(case % 3 > 0))).collect();
        let braked: Vec<bool> = (0..n).map(|i| by_speed || case % 4 != 3 || i == 1).collect();
        let holds: Vec<f64> =
            braked.iter().map(|braked| if *braked { random(1.0, 6.0) } else { 0.0 }).collect();
        let (pull, turn) = (random(2.0, 9.0), random(0.5, 4.0));
        let (on, extra, which) = (random(1.0, 3.0), random(-15.0, 15.0), case % n);
        let (by_place, by_time) = (case % 5 == 1, case % 5 == 2);
        let start: Vec<(f64, f64)> = (0..n)
            .map(|i| (0.0, if i == 2 || by_speed && i == 0 { 0.0 } else { random(-6.0, 6.0) }))
            .collect();
        let law = |phase: usize, t: f64, q: &[f64], _: &[f64]| {
            let mass =
                (0..n).map(|i| (0..n).map(|j| if i == j { inertias[i] } else { 0.0 }).collect()).collect();
            let mut force = vec![0.0; n];
            force[0] += pull * libm::sin(turn * t);
            force[which] += if phase == 1 { extra } else { 0.0 };
            for i in 0..n {
                let below = if i == 0 { 0.0 } else { q[i - 1] };
                let torque = -springs[i] * (q[i] - below);
                force[i] += torque;
                if i > 0 {
                    force[i - 1] -= torque;
                }
            }
            (mass, force)
        };
        let grows = |t: f64, q: &[f64]| match (by_place, by_time) {
            (true, _) => 1.0 + 0.5 * libm::sin(q[1]),
            (_, true) => 1.0 + 0.5 * libm::cos(2.0 * t),
            _ => 1.0,
        };
        let own = |i: usize, y: &[f64]| if by_speed { 1.0 + 0.4 * y[n + i].abs() } else { 1.0 };
        let limits = |t: f64, y: &[f64]| (0..n).map(|i| holds[i] * grows(t, y) * own(i, y)).collect();
        let world = World { law: &law, limits: &limits, switches: vec![on] };
        let mut text = "ground { O (0, 0) }\n".to_owned();
        for i in 0..n {
            let below = if i == 0 { "ground".into() } else { format!("d{}", i - 1) };
            let (inertia, spring, hold) = (inertias[i], springs[i], holds[i]);
            let factor = match (by_place, by_time) {
                (true, _) => "*(1 + 0.5*sin(angle(d1)))".to_owned(),
                (_, true) => "*(1 + 0.5*cos(2 rad/s*time))".to_owned(),
                _ if by_speed => format!("*(1 + 0.4*abs(omega(d{i})/(1 rad/s)))"),
                _ => String::new(),
            };
            writeln!(
                text,
                "link d{i} {{ O (0, 0); inertia {inertia} kg*m^2 }}\nrevolute H{i}: {below}.O - d{i}.O"
            )
            .unwrap();
            if spring > 0.0 {
                writeln!(text, "spring k{i} in H{i} {{ stiffness {spring} N*m/rad; free_angle 0 deg }}")
                    .unwrap();
            }
            writeln!(text, "start d{i} = 0 deg at {} rad/s", start[i].1).unwrap();
            if braked[i] {
                writeln!(text, "torque M{i} on d{i} = {hold} N*m{factor} against motion").unwrap();
            }
        }
        writeln!(text, "torque P on d0 = {pull} N*m*sin({turn} rad/s*time)").unwrap();
        writeln!(text, "torque E on d{which} = {extra} N*m when time > {on} s").unwrap();
        let rates: Vec<String> = (0..n).map(|i| format!("omega(d{i})")).collect();
        let efforts: Vec<String> = (0..n).map(|i| format!("M{i}")).collect();
        let rates: Vec<&str> = rates.iter().map(String::as_str).collect();
        let mut efforts: Vec<&str> = efforts.iter().map(String::as_str).collect();
        if braked.contains(&false) {
            efforts.clear();
        }
        let asked = Asked { rates: &rates, efforts: &efforts, alone: true };
        compare(&text, &asked, &world.run(&start, &instants(6.0, 7), 2e-3));
    }
}

/// An arm on an arm, upright or lying, with a brake on each, one of them by a force at a point.
#[test]
fn arms_with_brakes() {
    let mut random = random(6);
    for case in 0..part(16) {
        let (length, far) = (random(0.4, 1.0), random(0.2, 0.8));
        let (m1, m2) = (random(0.5, 2.0), random(0.3, 1.5));
        let (j1, j2) = (random(0.05, 0.3), random(0.02, 0.2));
        let gravity = if case % 2 == 0 { 9.81 } else { 0.0 };
        let weight = gravity * (m1 + m2) * length;
        let holds = [random(0.2, 0.9) * weight.max(4.0), random(0.1, 0.8) * (gravity * m2 * far).max(1.5)];
        let (on, extra) = (random(1.0, 2.5), random(-2.0, 2.0) * holds[1]);
        let start = [(random(-2.0, 0.0), random(-5.0, 5.0)), (random(-2.0, 1.0), random(-5.0, 5.0))];
        let law = |phase: usize, _: f64, q: &[f64], w: &[f64]| {
            let (s, c) = libm::sincos(q[0] - q[1]);
            let mixed = m2 * length * far;
            let mass =
                vec![vec![j1 + (m1 + m2) * length * length, mixed * c], vec![mixed * c, j2 + m2 * far * far]];
            let own = if phase == 1 { extra } else { 0.0 };
            let force = vec![
                -mixed * s * w[1] * w[1] - gravity * (m1 + m2) * length * libm::cos(q[0]),
                mixed * s * w[0] * w[0] - gravity * m2 * far * libm::cos(q[1]) + own,
            ];
            (mass, force)
        };
        let limits = |_: f64, _: &[f64]| holds.to_vec();
        let world = World { law: &law, limits: &limits, switches: vec![on] };
        let at_point = case % 4 == 1;
        let first = if at_point {
            format!("force M on a at A = {} N against motion", holds[0] / length)
        } else {
            format!("torque M on a = {} N*m against motion", holds[0])
        };
        let weight = if gravity > 0.0 { "gravity 9.81 m/s^2\n" } else { "" };
        let text = format!(
            "ground {{ O (0, 0) }}
link a O-A {length} m {{ mass {m1} kg at A; inertia {j1} kg*m^2 }}
link b A-B {far} m {{ mass {m2} kg at B; inertia {j2} kg*m^2 }}
revolute O: ground - a
revolute A: a - b
{weight}{first}
torque N on b = {} N*m against motion
torque E on b = {extra} N*m when time > {on} s
start a = {} rad at {} rad/s
start b = {} rad at {} rad/s
",
            holds[1], start[0].0, start[0].1, start[1].0, start[1].1
        );
        let asked = Asked { rates: &["omega(a)", "omega(b)"], efforts: &["M", "N"], alone: !at_point };
        let asked = if at_point { Asked { efforts: &[], ..asked } } else { asked };
        compare(&text, &asked, &world.run(&start, &instants(4.0, 6), 2e-3));
    }
}

/// A slider on a slider: forces against the motion over ground, or one of them and friction between the two.
#[test]
fn sliders_with_brakes_and_friction() {
    let mut random = random(7);
    for case in 0..part(24) {
        let (m1, m2) = (random(0.5, 4.0), random(0.3, 2.0));
        let (friction, between) = (case % 2 == 1, random(0.05, 0.4));
        let g = 10.0;
        let holds = [random(2.0, 15.0), random(1.0, 8.0)];
        let (pull, turn) = (random(2.0, 15.0), random(0.5, 4.0));
        let (on, extra) = (random(1.0, 3.0), random(-20.0, 20.0));
        let rates = [random(-3.0, 3.0), random(-3.0, 3.0)];
        // over ground, or the second from the first
        let start = [(0.0, rates[0]), (0.0, if friction { rates[1] - rates[0] } else { rates[1] })];
        let law = |phase: usize, t: f64, _: &[f64], _: &[f64]| {
            let (one, two) = (pull * libm::sin(turn * t), if phase == 1 { extra } else { 0.0 });
            if friction {
                (vec![vec![m1 + m2, m2], vec![m2, m2]], vec![one + two, two])
            } else {
                (vec![vec![m1, 0.0], vec![0.0, m2]], vec![one, two])
            }
        };
        let limits = |_: f64, _: &[f64]| vec![holds[0], if friction { between * m2 * g } else { holds[1] }];
        let world = World { law: &law, limits: &limits, switches: vec![on] };
        let (rubs, second) = if friction {
            (format!(" {{ friction {between} }}"), String::new())
        } else {
            (String::new(), format!("force N on b at Q = {} N against motion\n", holds[1]))
        };
        let text = format!(
            "gravity {g} m/s^2
ground {{ O (0, 0); line way through O along 0 deg }}
link a {{ P (0, 0); mass {m1} kg at P; line rail through P along 0 deg }}
link b {{ Q (0, 0); mass {m2} kg at Q }}
prismatic G: a.P - ground.way
prismatic H: b.Q - a.rail{rubs}
force M on a at P = {} N against motion
{second}force F on a at P = ({pull} N*sin({turn} rad/s*time), 0)
force E on b at Q = ({extra} N, 0) when time > {on} s
start G = 0 mm at {} m/s
start H = 0 mm at {} m/s
",
            holds[0],
            rates[0],
            rates[1] - rates[0]
        );
        let second = if friction { "relative_velocity(H)" } else { "velocity(b.Q).x" };
        let efforts: &[&str] = if friction { &["M.x"] } else { &["M.x", "N.x"] };
        let asked = Asked { rates: &["velocity(a.P).x", second], efforts, alone: true };
        compare(&text, &asked, &world.run(&start, &instants(6.0, 7), 5e-3));
    }
}

/// A block on a belt that takes it along, with a force against its motion over ground: it stands, or is taken along and held by both.
#[test]
fn a_brake_on_what_a_belt_takes_along() {
    let mut random = random(8);
    for _ in 0..part(20) {
        let (mass, belt) = (random(0.5, 4.0), random(0.2, 2.0));
        let (rubs, holds) = (random(2.0, 20.0), random(2.0, 20.0));
        let end = random(0.3, 4.0);
        let text = format!(
            "gravity 10 m/s^2
ground {{ O (0, 0); line way through O along 0 deg }}
link a {{ P (0, 0); line rail through P along 0 deg }}
link b {{ Q (0, 0); mass {mass} kg at Q }}
prismatic G: a.P - ground.way
prismatic H: b.Q - a.rail {{ friction {} }}
drive G = 0 mm at {belt} m/s
force R on b at Q = {holds} N against motion
start H = 0 mm at -{belt} m/s
simulate {end} s
find v = velocity(b.Q).x, r = R.x, f = friction(H, b), work = work(R)
",
            rubs / mass / 10.0
        );
        let solution = assur::solve(&text).unwrap_or_else(|error| panic!("{error}\n{text}"));
        let a = (rubs - holds).max(0.0) / mass;
        let taken = (a * end).min(belt);
        let (force, friction) = match taken {
            _ if a == 0.0 => (-rubs, rubs),
            v if v < belt => (-holds, rubs),
            _ => (-holds, holds),
        };
        let way = if taken < belt { taken * end / 2.0 } else { belt * (end - belt / a / 2.0) };
        let work = if a == 0.0 { 0.0 } else { -holds * way };
        for (name, right) in [("v", taken), ("r", force), ("f", friction), ("work", work)] {
            let got = solution.poses()[1][name].number().unwrap();
            assert!((got - right).abs() < 1e-8 * (1.0 + right.abs()), "{name}: {got}, not {right}\n{text}");
        }
    }
}

#[test]
fn two_discs_by_hand() {
    let text = include_str!("../cases/use3/numbers/brakes-of-two-discs.mech");
    let solution = assur::solve(text).unwrap_or_else(|error| panic!("{error}"));
    assert!(solution.expectations().iter().all(|expectation| expectation.met), "{}", solution.diagnostics());
    assert!(evaluations(text) < 10_000);
}

#[test]
fn brakes_that_grow_with_their_speed_by_hand() {
    let text = include_str!("../cases/use3/numbers/brake-by-its-own-speed.mech");
    let solution = assur::solve(text).unwrap_or_else(|error| panic!("{error}"));
    assert!(solution.expectations().iter().all(|expectation| expectation.met), "{}", solution.diagnostics());
    assert!(solution.poses().len() == 9 && evaluations(text) < 20_000);
}

/// The body of a cross slide comes to rest under a force against its motion, and stays: the first slide has a mass too.
#[test]
fn a_force_against_motion_holds_a_point_in_the_plane() {
    let text = include_str!("../cases/use3/limits/force-against-motion-in-the-plane.mech");
    let solution = assur::solve(text).unwrap_or_else(|error| panic!("{error}"));
    let last = solution.poses().last().unwrap();
    let speed = last["velocity(b.Q)"].vector().unwrap();
    assert!(last.failure().is_none() && speed == (0.0, 0.0), "{speed:?}");
}
