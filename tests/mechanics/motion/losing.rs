//! Losses of transmissions in motions of several free coordinates against the equations of all shafts at once: every direction of the
//! power and every rest of a mesh is tried, and the one that is consistent is taken.

use super::many;
use crate::support::random::Random;
use assur::internals::check::Overrides;
use assur::internals::diagnostic::{Style, render};
use assur::internals::model::{FindKind, Value};
use assur::internals::solve_source;
use assur::internals::source::Source;
use nalgebra::{DMatrix, DVector};

/// Slower sides stand.
const SLOWEST: f64 = 1e-9;
/// Conditions are met but for this part of the greatest.
const NEAR: f64 = 1e-9;

struct Mesh {
    shafts: [usize; 2],
    /// Torques on both sides per unit of the force between the teeth.
    radii: [f64; 2],
    carrier: Option<usize>,
    efficiency: f64,
}

#[derive(Default)]
struct Train {
    lines: Vec<String>,
    inertias: Vec<f64>,
    loads: Vec<f64>,
    meshes: Vec<Mesh>,
    /// Shafts whose motion begins as it is given, and their rates.
    starts: Vec<(usize, f64)>,
}

impl Train {
    fn shaft(&mut self, random: &mut Random, on: Option<usize>, wheels: &[(String, usize)]) -> usize {
        let i = self.inertias.len();
        let inertia = random.within(0.01, 0.5);
        let on = on.map_or(String::new(), |c| format!(" on I{c}"));
        let wheels: String =
            wheels.iter().map(|(name, teeth)| format!("wheel {name} teeth {teeth}; ")).collect();
        self.lines.push(format!("shaft I{i}{on} {{ {wheels}inertia {inertia} kg*m^2 }}"));
        self.inertias.push(inertia);
        self.loads.push(if random.chance(0.6) { random.within(-20.0, 20.0) } else { 0.0 });
        i
    }

    fn mesh(
        &mut self,
        random: &mut Random,
        ends: [(usize, &str, usize); 2],
        (carrier, internal): (Option<usize>, bool),
    ) {
        let efficiency = random.within(0.3, 0.98);
        let kind = if internal { "internal; " } else { "" };
        let [(a, one, z_1), (b, other, z_2)] = ends;
        let line =
            format!("mesh k{}: {one} - {other} {{ {kind}efficiency {efficiency} }}", self.meshes.len());
        self.lines.push(line);
        let second = if internal { -(z_2 as f64) } else { z_2 as f64 };
        self.meshes.push(Mesh { shafts: [a, b], radii: [z_1 as f64, second], carrier, efficiency });
    }

    /// A differential whose carrier is given, with a shaft that its sun drives.
    fn differential(&mut self, random: &mut Random, carrier: usize) -> usize {
        let k = self.meshes.len();
        let (zs, zp, zx) = (18 + random.below(20), 14 + random.below(15), 20 + random.below(30));
        let [s, r, p, d, x] = ["s", "r", "p", "d", "x"].map(|name| format!("{name}{k}"));
        let sun = self.shaft(random, None, &[(s.clone(), zs), (d.clone(), zx)]);
        let ring = self.shaft(random, None, &[(r.clone(), zs + 2 * zp)]);
        let planet = self.shaft(random, Some(carrier), &[(p.clone(), zp)]);
        self.mesh(random, [(planet, &p, zp), (sun, &s, zs)], (Some(carrier), false));
        self.mesh(random, [(planet, &p, zp), (ring, &r, zs + 2 * zp)], (Some(carrier), true));
        if random.chance(0.6) {
            let driven = self.shaft(random, None, &[(x.clone(), zs)]);
            self.mesh(random, [(sun, &d, zx), (driven, &x, zs)], (None, false));
        }
        self.starts.push((sun, 0.0));
        ring
    }

    fn new(random: &mut Random) -> Self {
        let mut train = Self::default();
        let carrier = train.shaft(random, None, &[]);
        train.starts.push((carrier, 0.0));
        let ring = train.differential(random, carrier);
        if random.chance(0.3) {
            train.differential(random, ring);
        }
        for start in 0..train.starts.len() {
            // at rest, as one body, or otherwise
            train.starts[start].1 = match random.below(4) {
                0 => 0.0,
                1 | 2 if start > 0 => train.starts[0].1,
                _ => random.within(-20.0, 20.0),
            };
        }
        train
    }

    /// The motion up to an instant, with what is found of every shaft.
    fn text(&self, (end, within): (f64, f64), what: &str) -> String {
        let mut text = self.lines.join("\n");
        for (i, load) in self.loads.iter().enumerate().filter(|(_, load)| **load != 0.0) {
            text += &format!("\ntorque on I{i} = {load} N*m");
        }
        for (shaft, rate) in &self.starts {
            text += &format!("\nstart I{shaft} at {rate} rad/s");
        }
        let finds: Vec<String> = (0..self.inertias.len()).map(|i| format!("{what}(I{i})")).collect();
        text + &format!("\nsimulate {end} s within {within}\nfind {}\n", finds.join(", "))
    }

    /// The condition of a mesh on rates: those of both sides seen from the carrier, times their radii, vanish together.
    fn row(&self, mesh: &Mesh) -> Vec<f64> {
        let mut row = vec![0.0; self.inertias.len()];
        for (shaft, radius) in mesh.shafts.iter().zip(mesh.radii) {
            row[*shaft] += radius;
            mesh.carrier.into_iter().for_each(|carrier| row[carrier] -= radius);
        }
        row
    }

    fn rates(&self) -> DVector<f64> {
        let n = self.inertias.len();
        let mut matrix = DMatrix::zeros(n, n);
        let mut right = DVector::zeros(n);
        for (i, mesh) in self.meshes.iter().enumerate() {
            self.row(mesh).into_iter().enumerate().for_each(|(j, x)| matrix[(i, j)] = x);
        }
        for (k, (shaft, rate)) in self.starts.iter().enumerate() {
            matrix[(self.meshes.len() + k, *shaft)] = 1.0;
            right[self.meshes.len() + k] = *rate;
        }
        matrix.lu().solve(&right).expect("the train moves")
    }

    /// Seen from the carrier, the first side of a mesh.
    fn relative(mesh: &Mesh, of: &[f64]) -> f64 {
        of[mesh.shafts[0]] - mesh.carrier.map_or(0.0, |carrier| of[carrier])
    }

    /// Accelerations, and the forces on both sides of every mesh, where each passes power on, back, or rests.
    fn with(&self, ways: &[usize]) -> Option<(Vec<f64>, Vec<[f64; 2]>)> {
        let (n, m) = (self.inertias.len(), self.meshes.len());
        let size = n + 2 * m;
        let (mut matrix, mut right) = (DMatrix::zeros(size, size), DVector::zeros(size));
        for i in 0..n {
            matrix[(i, i)] = self.inertias[i];
            right[i] = self.loads[i];
        }
        for (k, mesh) in self.meshes.iter().enumerate() {
            for side in 0..2 {
                let column = n + 2 * k + side;
                matrix[(mesh.shafts[side], column)] -= mesh.radii[side];
                mesh.carrier.into_iter().for_each(|c| matrix[(c, column)] += mesh.radii[side]);
            }
            self.row(mesh).into_iter().enumerate().for_each(|(j, x)| matrix[(n + 2 * k, j)] = x);
            let second = n + 2 * k + 1;
            match ways[k] {
                0 => {
                    matrix[(second, second)] = 1.0;
                    matrix[(second, second - 1)] = -mesh.efficiency;
                }
                1 => {
                    matrix[(second, second - 1)] = 1.0;
                    matrix[(second, second)] = -mesh.efficiency;
                }
                _ => {
                    matrix[(second, mesh.shafts[0])] = 1.0;
                    mesh.carrier.into_iter().for_each(|c| matrix[(second, c)] -= 1.0);
                }
            }
        }
        let x = matrix.full_piv_lu().solve(&right)?;
        let forces = (0..m).map(|k| [x[n + 2 * k], x[n + 2 * k + 1]]).collect();
        Some((x.iter().take(n).copied().collect(), forces))
    }

    /// Whether power flows as it is passed on, and what rests is held.
    fn agrees(&self, rates: &DVector<f64>, ways: &[usize], found: &(Vec<f64>, Vec<[f64; 2]>)) -> bool {
        let greatest = found.1.iter().flatten().fold(0.0_f64, |most, x| most.max(x.abs()));
        self.meshes.iter().zip(&found.1).zip(ways).all(|((mesh, force), way)| {
            let rate = Self::relative(mesh, rates.as_slice());
            let stands = rate.abs() < SLOWEST;
            let moves = if stands { Self::relative(mesh, &found.0) } else { rate };
            // the power that enters on the first side
            let power = -mesh.radii[0] * force[0] * moves;
            let e = mesh.efficiency;
            match way {
                0 => power >= 0.0 && force[0] * force[1] >= 0.0,
                1 => power <= 0.0 && force[0] * force[1] >= 0.0,
                _ => {
                    let (there, back) = (force[0] - e * force[1], force[1] - e * force[0]);
                    stands && there * back >= -NEAR * greatest * greatest
                }
            }
        })
    }

    /// Accelerations that are consistent with rates, and whether something rests.
    fn all(&self, rates: &DVector<f64>) -> Vec<(Vec<f64>, bool)> {
        let m = u32::try_from(self.meshes.len()).expect("few meshes");
        let mut all: Vec<(Vec<f64>, bool)> = Vec::new();
        for number in 0..3_usize.pow(m) {
            let ways: Vec<usize> = (0..m).map(|k| number / 3_usize.pow(k) % 3).collect();
            let Some(found) = self.with(&ways) else { continue };
            if !self.agrees(rates, &ways, &found) {
                continue;
            }
            let size = found.0.iter().fold(1.0_f64, |most, x| most.max(x.abs()));
            let near = |x: &[f64]| x.iter().zip(&found.0).all(|(a, b)| (a - b).abs() <= NEAR * size);
            if !all.iter().any(|(other, _)| near(other)) {
                all.push((found.0, ways.contains(&2)));
            }
        }
        all
    }

    /// Rates after a while: they are straight lines from one rest or turn of a mesh to the next. `None` where they do not go on in
    /// one way.
    fn after(&self, while_: f64) -> Option<(Vec<f64>, usize)> {
        let (mut rates, mut left, mut turns) = (self.rates(), while_, 0);
        while left > 0.0 {
            let all = self.all(&rates);
            let [(accelerations, _)] = &all[..] else { return None };
            let until = |mesh: &Mesh| {
                let (rate, change) =
                    (Self::relative(mesh, rates.as_slice()), Self::relative(mesh, accelerations));
                if rate.abs() >= SLOWEST && rate * change < 0.0 { -rate / change } else { f64::INFINITY }
            };
            let step = self.meshes.iter().map(until).fold(left, f64::min);
            turns += usize::from(step < left);
            (0..rates.len()).for_each(|i| rates[i] += step * accelerations[i]);
            left -= step;
            if turns > 100 {
                return None;
            }
        }
        Some((rates.as_slice().to_vec(), turns))
    }
}

/// What the program finds at the first instant or at the last.
fn found(text: &str, last: bool) -> Result<Vec<f64>, String> {
    let source = Source::new("train.mech", text);
    let (solved, problems) = solve_source(&source, &Overrides::none());
    let solved = solved.ok_or_else(|| render(&problems, &source, Style::PLAIN))?;
    let model = solved.compiled.model();
    let place = if last { solved.solution.poses.len() - 1 } else { 0 };
    let pose = solved.solution.poses[place].outcome.as_ref().map_err(|why| format!("{why:?}"))?;
    if pose.residuals.equilibrium.is_none_or(|r| r > 1e-11) || pose.residuals.power.is_none_or(|r| r > 1e-11)
    {
        return Err(format!("{:?}", pose.residuals));
    }
    let view = solved.solution.view(&model, pose);
    let value = |expr| match view.value(expr) {
        Value::Scalar(x) => x,
        _ => f64::NAN,
    };
    let finds = model.mechanism.finds.iter().filter_map(|find| match &find.kind {
        FindKind::Value { expr, .. } => Some(value(expr)),
        _ => None,
    });
    Ok(finds.collect())
}

/// 300 random trains with two or three free coordinates: at rest, turning as one body, or otherwise.
#[test]
fn losses_of_several_coordinates_are_those_of_all_shafts_at_once() {
    let (mut compared, mut held, mut several, mut worst) = (0, 0, 0, 0.0_f64);
    let mut failures = Vec::new();
    for seed in 1..=many(300) {
        let mut random = Random::new(seed);
        let train = Train::new(&mut random);
        let all = train.all(&train.rates());
        let [(want, rests)] = &all[..] else {
            several += 1;
            continue;
        };
        let text = train.text((1e-6, 1e-3), "alpha");
        match found(&text, false) {
            Ok(got) => {
                let size = want.iter().fold(1.0_f64, |most, x| most.max(x.abs()));
                let off = want.iter().zip(&got).map(|(a, b)| (a - b).abs() / size).fold(0.0, f64::max);
                compared += 1;
                held += u64::from(*rests);
                worst = worst.max(off);
                if off.is_nan() || off > 1e-10 {
                    failures
                        .push(format!("seed {seed}, rests {rests}: {off:e}\n{want:?}\n{got:?}\n{}", text));
                }
            }
            Err(why) => failures.push(format!("seed {seed}, rests {rests}: {why:.600}\n{}", text)),
        }
    }
    println!(
        "{compared} compared, {held} with meshes that rest, {several} without one solution, worst {worst:e}"
    );
    assert!(
        failures.is_empty(),
        "{} failures\n{}",
        failures.len(),
        failures[..failures.len().min(4)].join("\n")
    );
    assert!(held > compared / 20, "{held} of {compared}");
}

/// 100 random trains integrated for a second, in which meshes come to rest and turn.
#[test]
fn meshes_with_losses_come_to_rest_and_turn() {
    let (mut compared, mut turned, mut worst) = (0, 0, 0.0_f64);
    let mut failures = Vec::new();
    for seed in 5_001..=5_000 + many(100) {
        let mut random = Random::new(seed);
        let train = Train::new(&mut random);
        let Some((want, turns)) = train.after(1.0) else { continue };
        let text = train.text((1.0, 1e-9), "omega");
        match found(&text, true) {
            Ok(got) => {
                let size = want.iter().fold(1.0_f64, |most, x| most.max(x.abs()));
                let off = want.iter().zip(&got).map(|(a, b)| (a - b).abs() / size).fold(0.0, f64::max);
                (compared, turned, worst) = (compared + 1, turned + turns, worst.max(off));
                if off.is_nan() || off > 1e-8 {
                    failures.push(format!("seed {seed}, {turns} turns: {off:e}\n{want:?}\n{got:?}\n{text}"));
                }
            }
            Err(why) => failures.push(format!("seed {seed}, {turns} turns: {why:.600}\n{text}")),
        }
    }
    println!("{compared} compared, {turned} rests and turns, worst {worst:e}");
    let few = failures[..failures.len().min(3)].join("\n");
    assert!(failures.is_empty(), "{} failures\n{few}", failures.len());
    assert!(turned > compared / 4, "{turned} of {compared}");
}

/// A differential between two motors, each with its belt: a belt that slips passes on r₂/r₁ of a torque and (1 − s) r₁/r₂ of a speed.
#[test]
fn belts_that_slip_pass_on_less_speed() {
    for seed in 1..=many(20) {
        let mut random = Random::new(seed);
        let (mut motors, mut alone) = (String::new(), String::new());
        let mut wheels = [String::new(), String::new()];
        let mut added = [0.0; 2];
        for (k, shaft) in ["sun", "carrier"].into_iter().enumerate() {
            let [r_1, r_2] = [random.within(50.0, 150.0), random.within(50.0, 250.0)];
            let (slip, inertia) = (random.within(0.005, 0.2), random.within(0.001, 0.01));
            let (torque, rate) = (random.within(5.0, 20.0), random.within(1.0, 20.0));
            let ratio = (1.0 - slip) * r_1 / r_2;
            motors += &format!(
                "shaft m{k} {{ wheel a{k} radius {r_1} mm; inertia {inertia} kg*m^2 }}\n\
                 belt k{k}: a{k} - b{k} {{ slip {slip} }}\ntorque on m{k} = {torque} N*m\n\
                 start m{k} at {} rad/s\n",
                rate / ratio
            );
            wheels[k] = format!("wheel b{k} radius {r_2} mm; ");
            alone +=
                &format!("torque on {shaft} = {} N*m\nstart {shaft} at {rate} rad/s\n", torque * r_2 / r_1);
            added[k] = inertia * r_2 / r_1 / ratio;
        }
        let own = [random.within(0.1, 0.5), random.within(0.1, 0.5), random.within(0.1, 0.5)];
        let train = |wheels: [&str; 2], added: [f64; 2]| {
            format!(
                "mech 1\nshaft sun {{ {}wheel s teeth 20 module 4 mm; inertia {} kg*m^2 }}\nshaft carrier {{ {}inertia {} kg*m^2 }}\n\
                 shaft planet on carrier {{ wheel p teeth 20 module 4 mm; inertia {} kg*m^2 }}\nmesh k: p - s\n",
                wheels[0],
                own[0] + added[0],
                wheels[1],
                own[1] + added[1],
                own[2],
            )
        };
        let rest = "simulate 1 s within 1e-10\nfind omega(sun), omega(carrier), omega(planet), tangential_force(k)\n";
        let with = train([&wheels[0], &wheels[1]], [0.0; 2]) + &motors + rest;
        let got = found(&with, true).unwrap_or_else(|why| panic!("{why}\n{with}"));
        let without = train(["", ""], added) + &alone + rest;
        let want = found(&without, true).unwrap_or_else(|why| panic!("{why}\n{without}"));
        let size = want.iter().fold(1.0_f64, |most, x| most.max(x.abs()));
        let off = want.iter().zip(&got).map(|(a, b)| (a - b).abs() / size).fold(0.0, f64::max);
        assert!(off < 1e-9, "seed {seed}: {off:e}\n{want:?}\n{got:?}\n{with}");
    }
}

/// A hoist with losses in its rope, raised, held and lowered by a constant torque: the pulls at both ends by the equations of the drum
/// and of the load, at every instant and as extremes over the motion.
#[test]
fn a_rope_with_losses_has_a_pull_at_each_end() {
    let (inertia, radius, mass, weight) = (0.5, 0.2, 10.0, 100.0);
    for seed in 1..=many(10) {
        let mut random = Random::new(seed);
        let eta = random.within(0.4, 0.95);
        // α by J α = M − F r, with F = (W + m α r)/η or η (W + m α r), where it has the sense of the motion
        let alpha = |torque: f64, factor: f64| {
            (torque - weight * radius * factor) / (inertia + mass * radius * radius * factor)
        };
        let [least, most] = [weight * radius * eta, weight * radius / eta];
        for (torque, factor) in [
            (random.within(1.1, 2.0) * most, Some(1.0 / eta)),
            (least + random.within(0.1, 0.9) * (most - least), None),
            (random.within(0.0, 0.9) * least, Some(eta)),
        ] {
            let alpha = factor.map_or(0.0, |factor| alpha(torque, factor));
            let load = weight + mass * alpha * radius;
            let drum = factor.map_or(torque / radius, |factor| load * factor);
            let text = format!(
                "mech 1\nshaft drum {{ wheel w radius {radius} m; inertia {inertia} kg*m^2 }}\n\
                 slider L {{ mass {mass} kg }}\nrope r: L - w {{ efficiency {eta} }}\nforce W on L = {weight} N\n\
                 torque M on drum = {} N*m\nstart drum = 0 deg\nsimulate 1 s in 3 steps\n\
                 find load = tension(r, L), drum = tension(r, w)\n\
                 find most = max(tension(r, w)), least = min(tension(r, w)), mean = mean(tension(r, L))\n",
                -torque
            );
            let solution = assur::solve(&text).unwrap_or_else(|error| panic!("{error}\n{text}"));
            for pose in solution.poses() {
                for (name, want) in
                    [("load", load), ("drum", drum), ("most", drum), ("least", drum), ("mean", load)]
                {
                    let got = pose[name].number().unwrap_or(f64::NAN);
                    assert!((got - want).abs() <= 1e-9 * want, "{name}: {got:e}, not {want:e}\n{text}");
                }
            }
        }
    }
}
