//! Coupled meshes with losses against an assembly of their own: rates from the points where wheels touch, torques from all
//! directions of the power, one after the other where they are few.

use crate::support::random::Random;
use assur::internals::check::Overrides;
use assur::internals::model::{FindKind, Value};
use assur::internals::source::Source;
use std::collections::BTreeMap;

/// A mesh of two wheels on shafts; the carrier of the first or second shaft, if one is a planet.
struct Mesh {
    shafts: [usize; 2],
    teeth: [f64; 2],
    carrier: Option<usize>,
    internal: bool,
    efficiency: f64,
}

/// A differential whose sun and ring drive one shaft by two rows of wheels, and more differentials behind it.
#[derive(Default)]
struct Train {
    names: Vec<String>,
    wheels: Vec<Vec<String>>,
    carriers: Vec<Option<usize>>,
    loads: Vec<f64>,
    meshes: Vec<Mesh>,
    lines: Vec<String>,
}

impl Train {
    fn shaft(&mut self, carrier: Option<usize>) -> usize {
        let i = self.names.len();
        self.names.push(format!("I{i}"));
        self.wheels.push(Vec::new());
        self.carriers.push(carrier);
        self.loads.push(0.0);
        i
    }

    fn wheel(&mut self, shaft: usize, teeth: usize) -> String {
        let name = format!("w{shaft}x{}", self.wheels[shaft].len());
        self.wheels[shaft].push(format!("wheel {name} teeth {teeth}"));
        name
    }

    fn mesh(
        &mut self,
        shafts: [usize; 2],
        teeth: [usize; 2],
        carrier: Option<usize>,
        internal: bool,
        efficiency: f64,
    ) {
        let [a, b] = [0, 1].map(|i| self.wheel(shafts[i], teeth[i]));
        let kind = if internal { "internal; " } else { "" };
        self.lines
            .push(format!("mesh k{}: {a} - {b} {{ {kind}efficiency {efficiency} }}", self.meshes.len()));
        let teeth = teeth.map(|z| z as f64);
        self.meshes.push(Mesh { shafts, teeth, carrier, internal, efficiency });
    }

    /// A row of `count` meshes from one shaft to another.
    fn row(&mut self, random: &mut Random, from: usize, to: usize, count: usize, least: f64) {
        let mut before = from;
        for i in 0..count {
            let next = if i + 1 == count { to } else { self.shaft(None) };
            let teeth = [16 + random.below(40), 16 + random.below(40)];
            self.mesh([before, next], teeth, None, false, random.within(least, 0.995));
            before = next;
        }
    }

    /// `loops` differentials, `meshes` in all: each closes by two rows on a shaft that carries the next.
    fn new(random: &mut Random, loops: usize, meshes: usize, least: f64) -> Self {
        let mut train = Self::default();
        let mut carrier = train.shaft(None);
        let mut left = meshes;
        for stage in 0..loops {
            let of_stage = if stage + 1 == loops { left } else { meshes / loops };
            left -= of_stage;
            let [sun, ring, out] = [0; 3].map(|_| train.shaft(None));
            let planet = train.shaft(Some(carrier));
            let (zs, zp) = (18 + random.below(20), 14 + random.below(15));
            let zr = zs + 2 * zp;
            train.mesh([planet, sun], [zp, zs], Some(carrier), false, random.within(least, 0.995));
            // the planet has one wheel
            let name = format!("w{planet}x0");
            let wheel = train.wheel(ring, zr);
            let efficiency = random.within(least, 0.995);
            let line = format!(
                "mesh k{}: {name} - {wheel} {{ internal; efficiency {efficiency} }}",
                train.meshes.len()
            );
            train.lines.push(line);
            train.meshes.push(Mesh {
                shafts: [planet, ring],
                teeth: [zp as f64, zr as f64],
                carrier: Some(carrier),
                internal: true,
                efficiency,
            });
            let rows = of_stage.saturating_sub(2).max(2);
            let first = 1 + random.below(rows - 1);
            train.row(random, sun, out, first, least);
            train.row(random, ring, out, rows - first, least);
            carrier = out;
        }
        train.loads[carrier] = random.signed(20.0, 80.0);
        for i in 1..train.names.len() {
            if train.carriers[i].is_none() && random.chance(0.3) {
                train.loads[i] += random.within(-30.0, 30.0);
            }
        }
        train
    }

    fn text(&self) -> String {
        let mut text = String::new();
        for (i, name) in self.names.iter().enumerate() {
            let on = self.carriers[i].map_or(String::new(), |c| format!(" on {}", self.names[c]));
            let wheels = self.wheels[i].join("; ");
            text += &if wheels.is_empty() {
                format!("shaft {name}{on}\n")
            } else {
                format!("shaft {name}{on} {{ {wheels} }}\n")
            };
        }
        text += &self.lines.join("\n");
        for (name, load) in self.names.iter().zip(&self.loads).filter(|(_, load)| **load != 0.0) {
            text += &format!("\ntorque on {name} = {load} N*m");
        }
        let moments = self.meshes.iter().enumerate().map(|(i, m)| {
            format!(
                "a{i} = moment(k{i}, {}), b{i} = moment(k{i}, {})",
                self.names[m.shafts[0]], self.names[m.shafts[1]]
            )
        });
        let moments = moments.collect::<Vec<_>>().join(", ");
        text + &format!("\ndrive I0 at 10 rad/s\nbalance torque M on I0\nfind M, {moments}\n")
    }

    /// Coefficients of the rates of the shafts in the condition of a mesh: the rims go equally fast seen from the carrier.
    fn terms(&self, mesh: &Mesh) -> Vec<(usize, f64)> {
        let second = if mesh.internal { -mesh.teeth[1] } else { mesh.teeth[1] };
        let mut terms = vec![(mesh.shafts[0], mesh.teeth[0]), (mesh.shafts[1], second)];
        if let Some(carrier) = mesh.carrier {
            terms.push((carrier, -mesh.teeth[0] - second));
        }
        terms
    }

    /// Rates of all shafts.
    fn rates(&self) -> Vec<f64> {
        let n = self.names.len();
        let mut rows = vec![vec![0.0; n + 1]; n];
        (rows[0][0], rows[0][n]) = (1.0, 10.0);
        for (row, mesh) in rows[1..].iter_mut().zip(&self.meshes) {
            self.terms(mesh).into_iter().for_each(|(i, c)| row[i] += c);
        }
        solve(rows).expect("the train moves")
    }

    /// Rate of the first side of a mesh seen from the carrier, per tooth force: its power.
    fn speed(&self, mesh: &Mesh, rates: &[f64]) -> f64 {
        let carrier = mesh.carrier.map_or(0.0, |c| rates[c]);
        mesh.teeth[0] * (rates[mesh.shafts[0]] - carrier)
    }

    /// Multipliers and the balance, where power enters the mesh on its second side in `back`.
    fn with_directions(&self, back: &[bool]) -> Option<Vec<f64>> {
        let n = self.names.len();
        let mut rows = vec![vec![0.0; n + 1]; n];
        for (k, mesh) in self.meshes.iter().enumerate() {
            let [one, two] = if back[k] { [mesh.efficiency, 1.0] } else { [1.0, mesh.efficiency] };
            let terms = self.terms(mesh);
            let (first, second) = (terms[0].1 * one, terms[1].1 * two);
            rows[terms[0].0][k] += first;
            rows[terms[1].0][k] += second;
            if let Some(carrier) = mesh.carrier {
                rows[carrier][k] -= first + second;
            }
        }
        rows[0][n - 1] += 1.0;
        (0..n).for_each(|i| rows[i][n] = -self.loads[i]);
        solve(rows)
    }

    /// Directions of the power that these multipliers have; those of rounding as they are in `back`.
    fn directions(&self, x: &[f64], rates: &[f64], back: &[bool]) -> Vec<bool> {
        let powers: Vec<f64> = self.meshes.iter().zip(x).map(|(m, x)| -x * self.speed(m, rates)).collect();
        let most = powers.iter().fold(0.0_f64, |m, p| m.max(p.abs()));
        powers.iter().zip(back).map(|(p, b)| if p.abs() <= 1e-10 * most { *b } else { *p < 0.0 }).collect()
    }

    /// Balances of all consistent directions.
    fn all(&self) -> Vec<f64> {
        let (rates, n) = (self.rates(), self.meshes.len());
        let mut found: Vec<f64> = Vec::new();
        for pattern in 0..1_usize << n {
            let back: Vec<bool> = (0..n).map(|k| pattern >> k & 1 == 1).collect();
            let Some(x) = self.with_directions(&back) else { continue };
            if self.directions(&x, &rates, &back) == back {
                let m = x[n];
                if !found.iter().any(|f| (f - m).abs() <= 1e-9 * m.abs()) {
                    found.push(m);
                }
            }
        }
        found
    }

    /// The balance that is reached by turning contradicting directions, from a start of its own.
    fn turned(&self, random: &mut Random) -> Option<f64> {
        let rates = self.rates();
        let mut back: Vec<bool> = self.meshes.iter().map(|_| random.chance(0.5)).collect();
        for _ in 0..60 {
            let x = self.with_directions(&back)?;
            let next = self.directions(&x, &rates, &back);
            if next == back {
                return Some(x[self.meshes.len()]);
            }
            // one after the other, so that nothing goes round in a circle for ever
            let wrong: Vec<usize> = (0..back.len()).filter(|k| next[*k] != back[*k]).collect();
            for k in wrong {
                if random.chance(0.7) {
                    back[k] = next[k];
                }
            }
        }
        None
    }
}

fn solve(mut rows: Vec<Vec<f64>>) -> Option<Vec<f64>> {
    let n = rows.len();
    for k in 0..n {
        let pivot = (k..n).max_by(|&a, &b| rows[a][k].abs().total_cmp(&rows[b][k].abs()))?;
        rows.swap(k, pivot);
        let head = rows[k].clone();
        if head[k].abs() < 1e-12 {
            return None;
        }
        for row in rows.iter_mut().skip(k + 1) {
            let factor = row[k] / head[k];
            if factor != 0.0 {
                row.iter_mut().zip(&head).for_each(|(x, y)| *x -= factor * y);
            }
        }
    }
    let mut x = vec![0.0; n];
    for k in (0..n).rev() {
        let sum: f64 = (k + 1..n).map(|j| rows[k][j] * x[j]).sum();
        x[k] = (rows[k][n] - sum) / rows[k][k];
    }
    Some(x)
}

/// What the program says: answers by name, or its messages; and whether it warns that there are several.
fn said(text: &str) -> (Result<BTreeMap<String, f64>, String>, bool) {
    let source = Source::new("train.mech", text);
    let (solved, problems) = assur::internals::solve_source(&source, &Overrides::none());
    let words =
        assur::internals::diagnostic::render(&problems, &source, assur::internals::diagnostic::Style::PLAIN);
    let several = words.contains("mech::solve::several_balances");
    let Some(solved) = solved else { return (Err(words), several) };
    let model = solved.compiled.model();
    let pose = match &solved.solution.poses[0].outcome {
        Ok(pose) => pose,
        Err(why) => return (Err(assur::internals::message::failure(&model, why).to_string()), several),
    };
    assert!(pose.residuals.equilibrium.is_some_and(|r| r < 1e-11), "{text}\n{:?}", pose.residuals);
    assert!(pose.residuals.power.is_some_and(|r| r < 1e-11), "{text}\n{:?}", pose.residuals);
    let view = solved.solution.view(&model, pose);
    let finds = model.mechanism.finds.iter().filter_map(|find| match &find.kind {
        FindKind::Value { expr, .. } => match view.value(expr) {
            Value::Scalar(x) => Some((find.name.clone(), x)),
            _ => None,
        },
        FindKind::Reactions | FindKind::Table(_) => None,
    });
    (Ok(finds.collect()), several)
}

/// Every mesh loses what it should in the direction in which power flows, and every shaft is in equilibrium.
fn holds(train: &Train, got: &BTreeMap<String, f64>, text: &str) {
    let rates = train.rates();
    let mut sums = train.loads.clone();
    sums[0] += got["M"];
    let most = got.values().fold(0.0_f64, |m, x| m.max(x.abs()));
    for (k, mesh) in train.meshes.iter().enumerate() {
        let torques = [got[&format!("a{k}")], got[&format!("b{k}")]];
        let carrier = mesh.carrier.map_or(0.0, |c| rates[c]);
        // power into the mesh from each side
        let [one, two] = [0, 1].map(|i| -torques[i] * (rates[mesh.shafts[i]] - carrier));
        let size = one.abs().max(two.abs());
        let (input, output) = if one > two { (one, -two) } else { (two, -one) };
        assert!((output - mesh.efficiency * input).abs() <= 1e-9 * size, "k{k}: {one} {two}\n{text}");
        for i in 0..2 {
            sums[mesh.shafts[i]] += torques[i];
        }
        if let Some(c) = mesh.carrier {
            sums[c] -= torques[0] + torques[1];
        }
    }
    for (name, sum) in train.names.iter().zip(&sums) {
        assert!(sum.abs() <= 1e-9 * most, "{name}: {sum}\n{text}");
    }
}

#[test]
fn few_meshes_agree_with_all_directions() {
    let mut random = Random::new(11);
    let mut counts = [0; 3];
    for i in 0..60 {
        let (loops, meshes) = (1 + random.below(2), 6 + random.below(4));
        let least = [0.9, 0.6, 0.3][i % 3];
        let train = Train::new(&mut random, loops, meshes, least);
        let (text, expected) = (train.text(), train.all());
        counts[expected.len().min(2)] += 1;
        let (got, several) = said(&text);
        match (got, expected.as_slice()) {
            (Err(words), []) => assert!(words.contains("no direction of the power flow"), "{words}\n{text}"),
            (Err(words), _) => panic!("{expected:?}, but {words}\n{text}"),
            (Ok(got), _) => {
                holds(&train, &got, &text);
                let m = got["M"];
                let near = |x: &f64| (x - m).abs() <= 1e-8 * m.abs();
                assert!(expected.iter().any(near), "{m} of {expected:?}\n{text}");
                assert_eq!(several, expected.len() > 1, "{expected:?}\n{text}");
            }
        }
    }
    assert!(counts[0] > 1 && counts[1] > 20, "{counts:?}");
}

#[test]
fn up_to_thirty_coupled_meshes_are_consistent() {
    let mut random = Random::new(12);
    let (mut solved, mut locked, mut undecided) = (0, 0, 0);
    for i in 0..18 {
        let (loops, meshes) = (1 + random.below(3), 12 + random.below(19));
        let least = [0.97, 0.9, 0.8][i % 3];
        let train = Train::new(&mut random, loops, meshes, least);
        let text = train.text();
        let (got, several) = said(&text);
        let reached: Vec<f64> = (0..12).filter_map(|_| train.turned(&mut random)).collect();
        match got {
            Ok(got) => {
                holds(&train, &got, &text);
                solved += 1;
                let near = |x: &&f64| (**x - got["M"]).abs() <= 1e-8 * x.abs();
                assert!(several || reached.iter().all(|x| near(&x)), "{} of {reached:?}\n{text}", got["M"]);
            }
            // refused where the search takes too long: never a wrong number
            Err(words) if words.contains("too many combinations") => undecided += 1,
            Err(words) => {
                assert!(words.contains("no direction of the power flow"), "{words}\n{text}");
                assert!(reached.is_empty(), "{reached:?}\n{text}");
                locked += 1;
            }
        }
    }
    assert!(solved > 8 && undecided < 6, "{solved} solved, {locked} locked, {undecided} undecided");
}

/// A worm below one half whose shaft bears the known torque: driven by the wheel two states are consistent, or none.
#[test]
fn a_worm_that_locks_has_two_states_or_none() {
    let file = |torque: f64, efficiency: &str| {
        format!(
            "shaft I0\nshaft drum {{ wheel z2 teeth 40 }}\nworm s: I0 - z2 {{ efficiency {efficiency} }}\n\
             drive I0 at 100 rad/s\ntorque on I0 = {torque} N*m\nbalance torque M on drum\nfind M, a = moment(s, I0)\n"
        )
    };
    let efficiencies = [("0.25", 0.25), ("0.4", 0.4), ("1/3", 1.0 / 3.0)];
    for (written, efficiency) in efficiencies {
        // the shaft drives: the wheel gives what is left, which is what is reached from no losses
        let (got, several) = said(&file(5.0, written));
        let got = got.unwrap_or_else(|e| panic!("{e}"));
        assert!(several, "{written}");
        let ways: [f64; 2] = [5.0 * 40.0 * efficiency, 5.0 * 40.0 / (2.0 - 1.0 / efficiency)];
        assert!(ways.iter().any(|m| (got["M"].abs() - m.abs()).abs() < 1e-9), "{got:?} {ways:?}");
        // the shaft brakes: what the wheel puts in never reaches it
        let (got, _) = said(&file(-5.0, written));
        let words = got.expect_err("nothing is consistent");
        assert!(words.contains("no direction of the power flow"), "{words}");
    }
    let (got, several) = said(&file(-5.0, "0.8"));
    assert!(!several && (got.expect("it turns")["M"].abs() - 200.0 / 0.75).abs() < 1e-9);
}
