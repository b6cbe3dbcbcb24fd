//! Clutches that slip between random shafts, some of them driven, under torques that change once: against accelerations that are
//! constant from event to event. At each event every way in which the clutches at rest may go on is tried.

use crate::support::random::Random;
use std::fmt::Write;

struct Clutch {
    ends: [usize; 2],
    capacity: f64,
}

struct Shafts {
    /// One over the moment of inertia: zero where the shaft is driven.
    lightness: Vec<f64>,
    speeds: Vec<f64>,
    /// Before and after the change.
    torques: [Vec<f64>; 2],
    clutches: Vec<Clutch>,
}

/// When the torques change, and the end, s.
const TIMES: [f64; 2] = [1.5, 3.0];

impl Shafts {
    fn new(random: &mut Random) -> Self {
        let count = 2 + random.below(3);
        let driven = random.below(3) == 0;
        let lightness =
            (0..count).map(|i| if driven && i == 0 { 0.0 } else { 1.0 / random.within(0.5, 5.0) });
        let lightness = lightness.collect();
        let clutches = (1..count).map(|i| {
            let (other, turned) = (random.below(i), random.below(2) == 0);
            let ends = if turned { [i, other] } else { [other, i] };
            Clutch { ends, capacity: random.within(5.0, 60.0) }
        });
        let clutches = clutches.collect();
        let speeds = (0..count).map(|_| if random.below(4) == 0 { 10.0 } else { random.within(-60.0, 60.0) });
        let speeds = speeds.collect();
        let mut torques = |most: f64| (0..count).map(|_| random.within(-most, most)).collect();
        Self { lightness, speeds, torques: [torques(50.0), torques(100.0)], clutches }
    }

    fn text(&self) -> String {
        let (mut text, mut wanted) = (String::new(), Vec::new());
        for (i, (lightness, speed)) in self.lightness.iter().zip(&self.speeds).enumerate() {
            let driven = *lightness == 0.0;
            let inertia = if driven { 1.0 } else { 1.0 / lightness };
            let word = if driven { "drive" } else { "start" };
            let _ = writeln!(text, "shaft s{i} {{ inertia {inertia} kg*m^2 }}\n{word} s{i} at {speed} rad/s");
            for (k, when) in ["<", ">="].iter().enumerate() {
                let torque = self.torques[k][i];
                let _ = writeln!(text, "torque on s{i} = {torque} N*m when time {when} {} s", TIMES[0]);
            }
            wanted.push(format!("w{i} = omega(s{i})"));
        }
        for (k, Clutch { ends: [a, b], capacity }) in self.clutches.iter().enumerate() {
            let _ = writeln!(text, "clutch k{k}: s{a} - s{b} {{ capacity {capacity} N*m; slipping }}");
            let _ = writeln!(
                text,
                "event engaged{k}: sticks(k{k})\nevent freed{k}: slips(k{k})\nevent loose{k}: not sticks(k{k})"
            );
            wanted.push(format!("M{k} = moment(k{k}, s{b}), h{k} = friction_work(k{k})"));
            wanted.push(format!("n{k} = count(engaged{k}), f{k} = count(freed{k}), l{k} = count(loose{k})"));
        }
        text + &format!("simulate {} s in 2 steps within 1e-10\nfind {}\n", TIMES[1], wanted.join(", "))
    }

    fn slip(&self, clutch: &Clutch, speeds: &[f64]) -> f64 {
        speeds[clutch.ends[1]] - speeds[clutch.ends[0]]
    }

    /// Accelerations under the torques of the clutches on their second ends.
    fn accelerations(&self, part: usize, torques: &[f64]) -> Vec<f64> {
        let mut sums = self.torques[part].clone();
        for (clutch, torque) in self.clutches.iter().zip(torques) {
            sums[clutch.ends[1]] += torque;
            sums[clutch.ends[0]] -= torque;
        }
        sums.iter().zip(&self.lightness).map(|(sum, lightness)| sum * lightness).collect()
    }

    /// The torques where the clutches slip in these senses, or hold: from the relative accelerations of those that hold.
    fn torques(&self, part: usize, senses: &[f64]) -> Vec<f64> {
        let mut torques: Vec<f64> =
            self.clutches.iter().zip(senses).map(|(c, sense)| -sense * c.capacity).collect();
        let held: Vec<usize> = (0..senses.len()).filter(|&k| senses[k] == 0.0).collect();
        let relative = |torques: &[f64]| -> Vec<f64> {
            let accelerations = self.accelerations(part, torques);
            held.iter().map(|&k| self.slip(&self.clutches[k], &accelerations)).collect()
        };
        let free = relative(&torques);
        let columns: Vec<Vec<f64>> = held
            .iter()
            .map(|&k| {
                let mut with = torques.clone();
                with[k] += 1.0;
                relative(&with).iter().zip(&free).map(|(with, free)| with - free).collect()
            })
            .collect();
        for (&k, x) in held.iter().zip(solved(&columns, &free)) {
            torques[k] = -x;
        }
        torques
    }

    /// The senses in which the clutches go on, and their torques: the only ones in which all of them do what they should.
    fn goes_on(&self, part: usize, speeds: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let all = 3_usize.pow(u32::try_from(self.clutches.len()).expect("few clutches"));
        let fits = (0..all).find_map(|way| {
            let sense = |k: usize| [0.0, 1.0, -1.0][way / 3_usize.pow(u32::try_from(k).unwrap_or(0)) % 3];
            let senses: Vec<f64> = (0..self.clutches.len()).map(sense).collect();
            let torques = self.torques(part, &senses);
            let accelerations = self.accelerations(part, &torques);
            let fits = self.clutches.iter().enumerate().all(|(k, clutch)| {
                let slip = self.slip(clutch, speeds);
                match (slip == 0.0, senses[k] == 0.0) {
                    (false, _) => senses[k] == slip.signum(),
                    (true, true) => torques[k].abs() <= clutch.capacity,
                    (true, false) => senses[k] * self.slip(clutch, &accelerations) > 0.0,
                }
            });
            fits.then_some((senses, torques))
        });
        fits.expect("a way on")
    }
}

/// Solves a system of few equations by its columns: Gauss with the greatest pivot.
fn solved(columns: &[Vec<f64>], right: &[f64]) -> Vec<f64> {
    let n = right.len();
    let mut rows: Vec<Vec<f64>> =
        (0..n).map(|i| columns.iter().map(|c| c[i]).chain([right[i]]).collect()).collect();
    for i in 0..n {
        let pivot = (i..n).max_by(|a, b| rows[*a][i].abs().total_cmp(&rows[*b][i].abs())).unwrap_or(i);
        rows.swap(i, pivot);
        let first = rows[i].clone();
        for (_, row) in rows.iter_mut().enumerate().filter(|(j, _)| *j != i) {
            let factor = row[i] / first[i];
            row.iter_mut().zip(&first).for_each(|(x, y)| *x -= factor * y);
        }
    }
    (0..n).map(|i| rows[i][n] / rows[i][i]).collect()
}

/// Speeds, heats, torques and senses at the end, and how often each clutch begins to hold.
struct Course {
    speeds: Vec<f64>,
    works: Vec<f64>,
    torques: Vec<f64>,
    senses: Vec<f64>,
    engaged: Vec<f64>,
}

fn course(shafts: &Shafts) -> Course {
    let count = shafts.clutches.len();
    let (mut speeds, mut t, mut part) = (shafts.speeds.clone(), 0.0, 0);
    let (mut works, mut engaged) = (vec![0.0; count], vec![0.0; count]);
    let (mut senses, mut torques) = shafts.goes_on(part, &speeds);
    while t < TIMES[1] {
        let accelerations = shafts.accelerations(part, &torques);
        let mut step = TIMES[part] - t;
        let mut ends = None;
        for (k, clutch) in shafts.clutches.iter().enumerate().filter(|(k, _)| senses[*k] != 0.0) {
            let (slip, change) = (shafts.slip(clutch, &speeds), shafts.slip(clutch, &accelerations));
            if slip * change < 0.0 && -slip / change < step {
                (step, ends) = (-slip / change, Some(k));
            }
        }
        for (k, clutch) in shafts.clutches.iter().enumerate() {
            let (slip, change) = (shafts.slip(clutch, &speeds), shafts.slip(clutch, &accelerations));
            works[k] += torques[k] * (slip * step + change * step * step / 2.0);
        }
        speeds.iter_mut().zip(&accelerations).for_each(|(speed, a)| *speed += a * step);
        t = if ends.is_some() { t + step } else { TIMES[part] };
        join(shafts, &mut speeds, |k| senses[k] == 0.0 || ends == Some(k));
        if ends.is_none() {
            part += 1;
        }
        if t < TIMES[1] {
            let before = std::mem::take(&mut senses);
            (senses, torques) = shafts.goes_on(part, &speeds);
            for (k, engaged) in engaged.iter_mut().enumerate() {
                *engaged += f64::from(u8::from(before[k] != 0.0 && senses[k] == 0.0));
            }
        }
    }
    Course { speeds, works, torques, senses, engaged }
}

/// Gives all shafts that clutches hold together the same bits for a speed.
fn join(shafts: &Shafts, speeds: &mut [f64], holds: impl Fn(usize) -> bool) {
    // each clutch joins a further shaft to one before it
    for (_, clutch) in shafts.clutches.iter().enumerate().filter(|(k, _)| holds(*k)) {
        let [a, b] = clutch.ends;
        speeds[a.max(b)] = speeds[a.min(b)];
    }
}

#[test]
fn clutches_slip_and_hold_as_accelerations_from_event_to_event() {
    let mut random = Random::new(14);
    let (mut held, mut turned) = (0, 0);
    for case in 0..60 {
        let shafts = Shafts::new(&mut random);
        let text = shafts.text();
        let wanted = course(&shafts);
        let solution = assur::solve(&text).unwrap_or_else(|problems| panic!("{case}\n{text}\n{problems}"));
        let pose = &solution.poses()[solution.poses().len() - 1];
        // what a drive keeps needs no pose
        let answer =
            |name: &str| pose.get(name).or_else(|| solution.get(name)).and_then(assur::Answer::number);
        let number = |name: String| answer(&name).unwrap_or(f64::NAN);
        let near = |name: String, wanted: f64, size: f64| {
            let got = number(name.clone());
            assert!((got - wanted).abs() <= 1e-8 * size, "{case} {name}: {got}, not {wanted}\n{text}");
        };
        for (i, speed) in wanted.speeds.iter().enumerate() {
            near(format!("w{i}"), *speed, 100.0);
        }
        for k in 0..shafts.clutches.len() {
            near(format!("M{k}"), wanted.torques[k], 60.0);
            near(format!("h{k}"), wanted.works[k], 1000.0);
            assert_eq!(
                solution[format!("n{k}").as_str()].number(),
                Some(wanted.engaged[k]),
                "{case} {k}\n{text}"
            );
            let [freed, loose] = ["f", "l"].map(|name| number(format!("{name}{k}")));
            assert!(freed == loose, "{case} {k}: {freed}, not {loose}\n{text}");
            held += usize::from(wanted.senses[k] == 0.0);
            turned += usize::from(wanted.senses[k] != 0.0 && wanted.engaged[k] > 0.0);
        }
    }
    assert!(held > 20 && turned > 5, "{held} {turned}");
}
