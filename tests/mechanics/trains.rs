//! Trains of wheels, ropes and sliders against independent paths: Willis' formula in exact fractions, velocities of the
//! points where wheels touch, equilibrium of every shaft, the balance of powers.

use crate::support::random::Random;
use assur::internals::check::Overrides;
use assur::internals::model::{FindKind, Value};
use assur::internals::source::Source;
use std::collections::BTreeMap;

/// What a text asks, by name; panics with the diagnostics where it is not solved.
fn answers(text: &str) -> BTreeMap<String, f64> {
    let source = Source::new("train.mech", text);
    let (solved, problems) = assur::internals::test_source(&source, &Overrides::none());
    let told = || {
        assur::internals::diagnostic::render(&problems, &source, assur::internals::diagnostic::Style::PLAIN)
    };
    let solved = solved.unwrap_or_else(|| panic!("{text}\n{}", told()));
    let model = solved.compiled.model();
    let pose = &solved.solution.poses[0];
    let state = pose.outcome.as_ref().unwrap_or_else(|e| panic!("{text}\n{e:?}"));
    assert!(state.residuals.equilibrium.unwrap_or(0.0) < 1e-12, "{text}\n{:?}", state.residuals);
    assert!(state.residuals.power.unwrap_or(0.0) < 1e-12, "{text}\n{:?}", state.residuals);
    crate::jerks::hold(&model, &state.state, || text.to_owned());
    let view = solved.solution.view(&model, state);
    let finds = model.mechanism.finds.iter().filter_map(|find| match &find.kind {
        FindKind::Value { expr, .. } => match view.value(expr) {
            Value::Scalar(x) => Some((find.name.clone(), x)),
            _ => None,
        },
        FindKind::Reactions | FindKind::Table(_) => None,
    });
    finds.collect()
}

fn close(got: f64, expected: f64, within: f64, what: &str) {
    let size = expected.abs().max(1e-300);
    assert!((got - expected).abs() <= within * size, "{what}: {got:e}, not {expected:e}");
}

/// A fraction in lowest terms.
#[derive(Clone, Copy, Debug)]
struct Fraction(i128, i128);

impl Fraction {
    fn of(n: i128, d: i128) -> Self {
        let (mut a, mut b) = (n.abs(), d.abs());
        while b != 0 {
            (a, b) = (b, a % b);
        }
        let sign = if d < 0 { -1 } else { 1 };
        Self(sign * n / a.max(1), sign * d / a.max(1))
    }
    fn plus(self, o: Self) -> Self {
        Self::of(self.0 * o.1 + o.0 * self.1, self.1 * o.1)
    }
    fn times(self, o: Self) -> Self {
        Self::of(self.0 * o.0, self.1 * o.1)
    }
    fn minus(self, o: Self) -> Self {
        self.plus(Self(-o.0, o.1))
    }
    fn over(self, o: Self) -> Self {
        Self::of(self.0 * o.1, self.1 * o.0)
    }
    #[allow(clippy::cast_precision_loss)]
    fn value(self) -> f64 {
        self.0 as f64 / self.1 as f64
    }
}

/// Rounding of a quotient and a product.
const EXACT: f64 = 4.0 * f64::EPSILON;

fn whole(random: &mut Random, from: usize, to: usize) -> i128 {
    (from + random.below(to - from + 1)) as i128
}

/// (ω_s − ω_H) / (ω_r − ω_H) = −z_r / z_s, (ω_p − ω_H) / (ω_s − ω_H) = −z_s / z_p.
#[test]
fn planetary_trains_obey_willis_in_exact_fractions() {
    let mut random = Random::new(1);
    for _ in 0..60 {
        let (zs, zp) = (whole(&mut random, 12, 90), whole(&mut random, 12, 60));
        let zr = zs + 2 * zp;
        let ratio = Fraction::of(-zr, zs);
        let drives = [("S", 7), ("H", -3), ("R", 11)];
        // two of the three are known
        for (left, _) in drives {
            let known: Vec<(&str, i128)> = drives.iter().copied().filter(|d| d.0 != left).collect();
            let text = format!(
                "shaft S {{ wheel s teeth {zs} }}\nshaft R {{ wheel r teeth {zr} }}\nshaft H\nshaft P on H {{ wheel p teeth {zp} }}\n\
                 mesh a: s - p\nmesh b: p - r {{ internal }}\ndrive {} at {} rad/s\ndrive {} at {} rad/s\nfind omega({left}), omega(P)",
                known[0].0, known[0].1, known[1].0, known[1].1
            );
            let speed = |name: &str| known.iter().find(|k| k.0 == name).map(|k| Fraction::of(k.1, 1));
            let (s, h, r) = (speed("S"), speed("H"), speed("R"));
            let one = Fraction::of(1, 1);
            let (s, h) = match (s, h, r) {
                (Some(s), Some(h), _) => (s, h),
                // s − h = ratio (r − h)
                (Some(s), None, Some(r)) => (s, s.minus(ratio.times(r)).over(one.minus(ratio))),
                (None, Some(h), Some(r)) => (h.plus(ratio.times(r.minus(h))), h),
                _ => unreachable!("two are known"),
            };
            let r = r.unwrap_or(h.plus(s.minus(h).over(ratio)));
            let p = h.minus(s.minus(h).times(Fraction::of(zs, zp)));
            let got = answers(&text);
            let expected = match left {
                "S" => s,
                "H" => h,
                _ => r,
            };
            close(got[&format!("omega({left})")], expected.value(), EXACT, &text);
            close(got["omega(P)"], p.value(), EXACT, &text);
        }
    }
}

/// Stepped planets, the ring of the second step fixed: ω_H = ω_s / (1 + z_p z_r / (z_s z_q)).
#[test]
fn stepped_planets_obey_willis() {
    let mut random = Random::new(2);
    for _ in 0..60 {
        let [zs, zp, zq] = [(15, 60), (20, 70), (12, 40)].map(|(a, b)| whole(&mut random, a, b));
        let zr = zs + zp + zq;
        let text = format!(
            "shaft S {{ wheel s teeth {zs} }}\nground {{ wheel r teeth {zr} }}\nshaft H\n\
             shaft P on H {{ wheel p teeth {zp}; wheel q teeth {zq} }}\n\
             mesh a: s - p\nmesh b: q - r {{ internal }}\ndrive S at 1 rad/s\nfind omega(H)"
        );
        let expected = Fraction::of(1, 1).over(Fraction::of(1, 1).plus(Fraction::of(zp * zr, zs * zq)));
        close(answers(&text)["omega(H)"], expected.value(), EXACT, &text);
    }
}

/// A long row of gear pairs: the product of the ratios, rounded once.
#[test]
fn a_long_train_is_exact() {
    let mut random = Random::new(3);
    let (mut text, mut ratio) = ("shaft I0 { wheel a0 teeth 17 }\n".to_owned(), Fraction::of(1, 1));
    let mut before = 17;
    for i in 1..=10 {
        let (z, next) = (whole(&mut random, 11, 97), whole(&mut random, 11, 97));
        text += &format!(
            "shaft I{i} {{ wheel b{i} teeth {z}; wheel a{i} teeth {next} }}\nmesh k{i}: a{} - b{i}\n",
            i - 1
        );
        ratio = ratio.times(Fraction::of(-before, z));
        before = next;
    }
    text += "drive I0 at 1 rad/s\nfind omega(I10)";
    // each stage is rounded for itself
    close(answers(&text)["omega(I10)"], ratio.value(), 20.0 * f64::EPSILON, &text);
}

/// A network as the test sees it: one row per condition on the rates, found from velocities of points.
#[derive(Default)]
struct Network {
    text: String,
    names: Vec<String>,
    /// Ends of ropes that hang: slider, its load, its mass.
    hanging: Vec<(String, f64, f64)>,
    rows: Vec<Vec<(usize, f64)>>,
    /// Load and inertia (or mass) per coordinate.
    loads: Vec<(f64, f64)>,
    /// Transmissions with the shafts they act on.
    joins: Vec<(String, Vec<usize>)>,
    slider: Vec<bool>,
    /// Fixed rings, as written.
    rings: Vec<String>,
}

impl Network {
    fn add(&mut self, name: String, slider: bool, load: (f64, f64)) -> usize {
        self.names.push(name);
        self.loads.push(load);
        self.slider.push(slider);
        self.names.len() - 1
    }

    fn load(&mut self, random: &mut Random) -> (f64, f64) {
        (random.within(-50.0, 50.0), random.within(0.0, 3.0))
    }

    fn shaft(&mut self, wheels: &str, random: &mut Random) -> usize {
        let (name, load) = (format!("I{}", self.names.len()), self.load(random));
        self.text += &format!("shaft {name} {{ {wheels}; inertia {} kg*m^2 }}\n", load.1);
        self.text += &format!("torque on {name} = {} N*m\n", load.0);
        self.add(name, false, load)
    }

    fn slider(&mut self, random: &mut Random) -> usize {
        let (name, load) = (format!("A{}", self.names.len()), self.load(random));
        let (weight, mass) = (load.0.abs() + 100.0, load.1 + 0.1);
        self.text += &format!("slider {name} {{ mass {mass} kg }}\nforce on {name} = {weight} N\n");
        self.add(name, true, (weight, mass))
    }

    /// A shaft that an earlier one moves.
    fn stage(&mut self, random: &mut Random, from: usize) -> usize {
        let i = self.names.len();
        let radius = random.within(0.1, 0.6);
        let next = self.shaft(&format!("wheel v{i} radius {radius} m; wheel w{i} radius {WHEEL} m"), random);
        let (kind, braces, sign) = match random.below(4) {
            0 => ("mesh", "", -1.0),
            1 => ("mesh", " { internal }", 1.0),
            2 => ("belt", " { crossed }", -1.0),
            _ => ("belt", "", 1.0),
        };
        self.text += &format!("{kind} k{i}: w{from} - v{i}{braces}\n");
        // the rims go equally fast
        self.rows.push(vec![(next, radius), (from, -sign * WHEEL)]);
        self.joins.push((format!("k{i}"), vec![from, next]));
        next
    }

    /// A planetary gear whose sun is on the shaft of `from` and whose ring is fixed; the carrier moves on.
    fn planetary(&mut self, random: &mut Random, from: usize) -> usize {
        let planet = random.within(0.02, 0.1);
        let i = self.names.len();
        self.rings.push(format!("wheel r{i}x radius {} m", WHEEL + 2.0 * planet));
        let carrier = self.shaft(&format!("wheel w{i} radius {WHEEL} m"), random);
        let load = self.load(random);
        self.text += &format!(
            "shaft P{i} on I{i} {{ wheel p{i} radius {planet} m; inertia {} kg*m^2 }}\ntorque on P{i} = {} N*m\n",
            load.1, load.0
        );
        let p = self.add(format!("P{i}"), false, load);
        self.text += &format!("mesh s{i}: w{from} - p{i}\nmesh r{i}: p{i} - r{i}x {{ internal }}\n");
        // the point where sun and planet touch goes with both, the one where planet and ring do stands still
        let arm = WHEEL + planet;
        self.rows.push(vec![(from, WHEEL), (carrier, -arm), (p, planet)]);
        self.rows.push(vec![(carrier, arm), (p, planet)]);
        self.joins.push((format!("s{i}"), vec![from, p, carrier]));
        self.joins.push((format!("r{i}"), vec![p, carrier]));
        carrier
    }

    /// A rope from a drum to a load; half of them by a movable pulley.
    fn rope(&mut self, random: &mut Random, from: usize) {
        let slider = self.slider(random);
        let name = self.names[slider].clone();
        let pulley = random.below(2) == 0;
        let (path, parts) =
            if pulley { (format!("ground - under({name})"), 2.0) } else { (name.clone(), 1.0) };
        self.text += &format!("rope a{slider}: {path} - over(C{slider}) - w{from}\n");
        // what the drum pays out is what the rope grows by
        self.rows.push(vec![(slider, parts), (from, -WHEEL)]);
        self.joins.push((format!("a{slider}"), vec![from]));
        let (weight, mass) = self.loads[slider];
        self.hanging.push((format!("tension(a{slider})"), weight / parts, mass / parts));
    }
}

/// Radius of the wheel `w` of each shaft, m.
const WHEEL: f64 = 0.8;

/// Gauss' elimination, rows of coefficients with the right side behind.
fn eliminate(mut rows: Vec<Vec<f64>>) -> Vec<f64> {
    let n = rows.len();
    for k in 0..n {
        let pivot = (k..n).max_by(|&a, &b| rows[a][k].abs().total_cmp(&rows[b][k].abs())).expect("a row");
        rows.swap(k, pivot);
        let head = rows[k].clone();
        for row in rows.iter_mut().skip(k + 1) {
            let factor = row[k] / head[k];
            for (x, y) in row.iter_mut().zip(&head) {
                *x -= factor * y;
            }
        }
    }
    let mut x = vec![0.0; n];
    for k in (0..n).rev() {
        let sum: f64 = (k + 1..n).map(|j| rows[k][j] * x[j]).sum();
        x[k] = (rows[k][n] - sum) / rows[k][k];
    }
    x
}

#[test]
fn random_networks_agree_with_a_dense_assembly() {
    for seed in 0..60 {
        let mut random = Random::new(seed);
        let mut net = Network::default();
        let first = net.shaft(&format!("wheel w0 radius {WHEEL} m"), &mut random);
        let mut ends = vec![first];
        for _ in 0..1 + random.below(5) {
            let from = ends[random.below(ends.len())];
            match random.below(3) {
                0 => ends.push(net.stage(&mut random, from)),
                1 => ends.push(net.planetary(&mut random, from)),
                _ => net.rope(&mut random, from),
            }
        }
        check(seed, &net, &mut random);
    }
}

fn check(seed: u64, net: &Network, random: &mut Random) {
    let (speed, acceleration) = (random.within(-9.0, 9.0), random.within(-4.0, 4.0));
    let n = net.names.len();
    let solve = |driven: f64| {
        let mut rows = vec![vec![0.0; n + 1]; n];
        (rows[0][0], rows[0][n]) = (1.0, driven);
        for (row, terms) in rows[1..].iter_mut().zip(&net.rows) {
            terms.iter().for_each(|(i, c)| row[*i] += c);
        }
        eliminate(rows)
    };
    assert_eq!(net.rows.len() + 1, n, "{}", net.text);
    let (rates, seconds) = (solve(speed), solve(acceleration));
    let mut asked = vec!["effort(I0)".to_owned()];
    for (name, slider) in net.names.iter().zip(&net.slider) {
        let (first, second) = if *slider { ("velocity", "acceleration") } else { ("omega", "alpha") };
        asked.extend([format!("{first}({name})"), format!("{second}({name})")]);
    }
    asked.extend(net.hanging.iter().map(|h| h.0.clone()));
    for (name, shafts) in &net.joins {
        let ends = shafts.iter().filter(|shaft| joins(net, name, **shaft));
        asked.extend(ends.map(|shaft| format!("moment({name}, {})", net.names[*shaft])));
    }
    let rings =
        if net.rings.is_empty() { String::new() } else { format!("ground {{ {} }}\n", net.rings.join("; ")) };
    let text = format!(
        "{}{rings}drive I0 at {speed} rad/s accelerating {acceleration} rad/s^2\nfind {}",
        net.text,
        asked.join(", ")
    );
    let got = answers(&text);
    let (greatest, most) = (size(&rates), size(&seconds));
    for (i, name) in net.names.iter().enumerate() {
        let (first, second) = if net.slider[i] { ("velocity", "acceleration") } else { ("omega", "alpha") };
        let (v, a) = (got[&format!("{first}({name})")], got[&format!("{second}({name})")]);
        assert!((v - rates[i]).abs() < 1e-12 * greatest, "seed {seed}: {name} {v} {}\n{text}", rates[i]);
        assert!((a - seconds[i]).abs() < 1e-12 * most, "seed {seed}: {name} {a} {}\n{text}", seconds[i]);
    }
    // d'Alembert: the powers of loads, inertia and effort add up to nothing
    let powers = (0..n).map(|i| (net.loads[i].0 - net.loads[i].1 * seconds[i]) * rates[i]);
    let (sum, most) = powers.fold((0.0, 0.0_f64), |(s, m), p| (s + p, m.max(p.abs())));
    let effort = got["effort(I0)"];
    assert!((effort * speed + sum).abs() < 1e-10 * most, "seed {seed}: effort {effort}\n{text}");
    for (name, weight, mass) in &net.hanging {
        let slider = name.trim_start_matches("tension(a").trim_end_matches(')');
        let a = seconds[slider.parse::<usize>().expect("a number")];
        close(got[name], weight - mass * a, 1e-10, &format!("seed {seed}: {name}\n{text}"));
    }
    // every shaft that is no carrier is in equilibrium
    for (i, name) in net.names.iter().enumerate().filter(|(i, _)| *i > 0 && !net.slider[*i]) {
        let all = || net.joins.iter().filter(|(_, shafts)| shafts.contains(&i));
        if all().any(|(k, _)| !joins(net, k, i)) {
            continue;
        }
        let moments: Vec<f64> = all().map(|(k, _)| got[&format!("moment({k}, {name})")]).collect();
        let rest = net.loads[i].0 - net.loads[i].1 * seconds[i];
        let sum: f64 = moments.iter().sum::<f64>() + rest;
        let most = moments.iter().fold(rest.abs(), |m, x| m.max(x.abs()));
        assert!(sum.abs() < 1e-10 * most.max(1e-9), "seed {seed}: {name} {moments:?} {rest}\n{text}");
    }
}

fn size(x: &[f64]) -> f64 {
    x.iter().fold(1e-300, |m, x| m.max(x.abs()))
}

/// Whether a transmission ends at a wheel of this shaft: of a mesh of planets the carrier does not.
fn joins(net: &Network, transmission: &str, shaft: usize) -> bool {
    let Some((_, shafts)) = net.joins.iter().find(|(n, _)| n == transmission) else { return false };
    let carrier = match transmission.as_bytes()[0] {
        b's' => shafts.get(2),
        b'r' => shafts.get(1),
        _ => None,
    };
    carrier != Some(&shaft)
}

/// Losses multiply along a row of stages, whichever way the power goes.
#[test]
fn losses_multiply() {
    let mut random = Random::new(5);
    for _ in 0..30 {
        let stages = 1 + random.below(4);
        let (mut text, mut through, mut ratio) =
            ("shaft I0 { wheel a0 radius 0.1 m }\n".to_owned(), 1.0, 1.0);
        for i in 1..=stages {
            let (r, eta) = (random.within(0.1, 0.5), random.within(0.7, 1.0));
            text += &format!("shaft I{i} {{ wheel b{i} radius {r} m; wheel a{i} radius 0.1 m }}\n");
            text += &format!("mesh k{i}: a{} - b{i} {{ efficiency {eta} }}\n", i - 1);
            (through, ratio) = (through * eta, ratio * -0.1 / r);
        }
        let speed = random.within(1.0, 9.0);
        // resisting, then driving
        for (sign, factor) in [(-1.0, 1.0 / through), (1.0, through)] {
            let torque = sign * ratio.signum() * 70.0;
            let text = format!(
                "{text}drive I0 at {speed} rad/s\ntorque on I{stages} = {torque} N*m\nfind M = effort(I0), e = efficiency()"
            );
            let got = answers(&text);
            close(got["M"], -torque * ratio * factor, 1e-12, &text);
            close(got["e"], through, 1e-12, &text);
        }
    }
}

/// A planetary gear with losses in both meshes, solved by hand: the sun drives, the ring is fixed, the carrier resists.
/// Relative to the carrier power goes from the sun to the ring, so that M_ring = −M_sun (z_r / z_s) η² and
/// M_carrier = −(M_sun + M_ring) = −M_sun (1 + z_r / z_s η²).
#[test]
fn losses_in_a_planetary_gear_count_relative_to_the_carrier() {
    let text = "shaft S { wheel s teeth 24 }\nshaft H\nshaft P on H { wheel p teeth 18 }\nground { wheel r teeth 60 }\n\
                mesh a: s - p { efficiency 0.97 }\nmesh b: p - r { internal; efficiency 0.97 }\n\
                drive S at 100 rad/s\ntorque on H = -500 N*m\nfind M = effort(S), e = efficiency()";
    let got = answers(text);
    let stage = 60.0 / 24.0 * 0.97 * 0.97;
    close(got["M"], 500.0 / (1.0 + stage), 1e-12, text);
    close(got["e"], (1.0 + stage) / (1.0 + 60.0 / 24.0), 1e-12, text);
}

/// A rope with losses pulls at each end with the force of that end: the load with its own weight, the drum with more to raise it and
/// with less to lower it.
#[test]
fn a_rope_with_losses_has_a_pull_at_each_end() {
    let paths = [
        ("rope r: P - w", "P", 1.0),
        ("rope r: w - P", "P", 1.0),
        ("rope r: P - over(c1) - over(c2) - w", "P", 1.0),
        ("rope r: ground - under(P) - w", "ground", 2.0),
    ];
    let mut random = Random::new(11);
    for (rope, end, parts) in paths {
        for sense in [1.0, -1.0] {
            let (radius, weight, eta) =
                (random.within(0.1, 0.5), random.within(50.0, 500.0), random.within(0.3, 1.0));
            let text = format!(
                "shaft drum {{ wheel w radius {radius} m }}\nslider P\n{rope} {{ efficiency {eta} }}\n\
                 drive drum at {} rad/s\nforce W on P = {weight} N\n\
                 find load = tension(r, {end}), drum = tension(r, w), driven = tension(r), P = power(W), M = effort(drum)",
                3.0 * sense
            );
            let got = answers(&text);
            let (load, raised) = (weight / parts, got["P"] < 0.0);
            let drum = if raised { load / eta } else { load * eta };
            close(got["load"], load, 1e-12, &text);
            close(got["drum"], drum, 1e-12, &text);
            close(got["driven"], load.min(drum), 1e-12, &text);
            close(got["M"].abs(), drum * radius, 1e-12, &text);
        }
    }
}
