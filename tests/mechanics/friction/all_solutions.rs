//! Friction of every mix of pairs, up to 0.8, against all solutions of its laws: reactions from the equations of Newton and
//! Euler of all links, every pattern of signs of the normal forces, hinge forces from many directions. What the program
//! calls locked must have no solution; what it solves must be one of them, and the one reached from no friction.

use super::pair_friction::{Kind, PairFriction, loaded, pair_frictions};
use crate::support::draft::Draft;
use crate::support::equilibrium::{Forces, equilibrium};
use crate::support::generate;
use crate::support::random::Random;
use crate::support::reference::Reference;
use crate::support::run::Run;
use assur::internals::model::{Friction, Mechanism, PairKind};
use nalgebra::{DMatrix, DVector};

/// Positions with a slower sliding velocity, other than none, are left out.
const SLOWEST: f64 = 1e-6;

/// Gives some pairs friction, of all kinds; few enough for all patterns to be tried.
fn roughen(draft: &Draft, random: &mut Random, most: usize) -> Mechanism {
    let mut m = draft.mechanism.clone();
    let (mut signs, mut hinges) = (0, 0);
    for i in random.shuffled(m.pairs.len()) {
        let pair = &mut m.pairs[i];
        if pair.kind.links().iter().any(|l| draft.rollers.contains(l)) || random.chance(0.3) {
            continue;
        }
        let coefficient = random.within(0.02, 0.8);
        pair.friction = match &mut pair.kind {
            PairKind::Revolute(pins) if hinges + pins.len() - 1 <= most.min(3) => {
                hinges += pins.len() - 1;
                Some(Friction::Circle(0.1 * coefficient))
            }
            PairKind::Prismatic(g) if signs + 2 <= most && random.chance(0.5) => {
                signs += 2;
                g.contacts = Some([random.within(0.05, 0.3), -random.within(0.05, 0.3)]);
                Some(Friction::BothEnds(coefficient))
            }
            PairKind::Prismatic(_) | PairKind::Slot(_) | PairKind::Contact { .. } if signs < most => {
                signs += 1;
                Some(Friction::Coefficient(coefficient))
            }
            _ => None,
        };
    }
    m
}

/// The laws x_i = w_i m_i(x), with the measures affine in x.
struct Laws<'a> {
    rubs: &'a [PairFriction],
    /// Measures of each element from the loads, then from a unit of each.
    measures: Vec<Vec<[f64; 2]>>,
}

impl<'a> Laws<'a> {
    fn new(mechanism: &Mechanism, reference: &Reference, rubs: &'a [PairFriction]) -> Option<Self> {
        let n = rubs.len();
        let at = |x: &[f64]| -> Option<Vec<[f64; 2]>> {
            let forces = equilibrium(&loaded(mechanism, rubs, x), &reference.bodies, &reference.rates)?;
            Some(rubs.iter().map(|r| r.measures(&forces)).collect())
        };
        let base = at(&vec![0.0; n])?;
        // a unit that is neither lost beside the loads nor drowns them
        let size = base.iter().flatten().fold(1.0_f64, |m, x| m.max(x.abs()));
        let mut measures: Vec<Vec<[f64; 2]>> = base.iter().map(|m| vec![*m]).collect();
        for j in 0..n {
            let mut x = vec![0.0; n];
            x[j] = size;
            for (row, (with, base)) in measures.iter_mut().zip(at(&x)?.iter().zip(&base)) {
                row.push([(with[0] - base[0]) / size, (with[1] - base[1]) / size]);
            }
        }
        Some(Self { rubs, measures })
    }

    fn measure(&self, i: usize, x: &[f64]) -> [f64; 2] {
        let row = &self.measures[i];
        let mut sum = row[0];
        for (unit, x) in row[1..].iter().zip(x) {
            sum = [sum[0] + unit[0] * x, sum[1] + unit[1] * x];
        }
        sum
    }

    fn pressing(&self, i: usize, x: &[f64]) -> f64 {
        let [a, b] = self.measure(i, x);
        if self.rubs[i].turns() { a.hypot(b) } else { a.abs() + b.abs() }
    }

    /// Newton's method with the given signs of the numbers; hinges as at present, first along `directions`. The solution,
    /// and the determinant.
    fn newton(
        &self,
        signs: &[[f64; 2]],
        directions: &[[f64; 2]],
        part: f64,
        start: Option<&[f64]>,
    ) -> Option<(Vec<f64>, f64)> {
        let n = self.rubs.len();
        let mut x = start.map_or(vec![0.0; n], <[f64]>::to_vec);
        let mut along = directions.to_vec();
        for step in 0..60 {
            let mut a = DMatrix::<f64>::identity(n, n);
            let mut b = DVector::<f64>::zeros(n);
            for i in 0..n {
                let w = part * self.rubs[i].weight();
                let e = if self.rubs[i].turns() { along[i] } else { signs[i] };
                let dot = |m: &[f64; 2]| e[0] * m[0] + e[1] * m[1];
                b[i] = w * dot(&self.measures[i][0]);
                for j in 0..n {
                    a[(i, j)] -= w * dot(&self.measures[i][j + 1]);
                }
            }
            let lu = a.lu();
            let determinant = lu.determinant();
            let next = lu.solve(&b)?;
            let change = (0..n).map(|i| (next[i] - x[i]).abs()).fold(0.0, f64::max);
            let size = next.amax();
            x = next.iter().copied().collect();
            if !size.is_finite() {
                return None;
            }
            if step > 0 && change <= 1e-13 * size || n == 0 {
                return Some((x, determinant));
            }
            for i in (0..n).filter(|i| self.rubs[*i].turns()) {
                let m = self.measure(i, &x);
                let size = m[0].hypot(m[1]);
                if size > 0.0 {
                    along[i] = [m[0] / size, m[1] / size];
                }
            }
        }
        None
    }

    /// What is left of the laws, relative to what presses.
    fn residual(&self, x: &[f64]) -> f64 {
        let n = self.rubs.len();
        let most = (0..n).map(|i| self.pressing(i, x)).fold(f64::MIN_POSITIVE, f64::max);
        let off = |i: usize| (x[i] - self.rubs[i].weight() * self.pressing(i, x)).abs();
        (0..n).map(off).fold(0.0, f64::max) / most
    }

    fn signs_of(&self, x: &[f64]) -> Vec<[f64; 2]> {
        (0..x.len()).map(|i| self.measure(i, x).map(f64::signum)).collect()
    }

    /// All solutions.
    fn all(&self) -> Vec<Vec<f64>> {
        let n = self.rubs.len();
        let numbers: Vec<(usize, usize)> = (0..n)
            .flat_map(|i| match self.rubs[i].kind {
                Kind::Hinge => vec![],
                Kind::Ends(..) => vec![(i, 0), (i, 1)],
                Kind::Along(_) | Kind::Contact(..) => vec![(i, 0)],
            })
            .collect();
        let hinges: Vec<usize> = (0..n).filter(|i| self.rubs[*i].turns()).collect();
        let steps: usize = if hinges.len() > 2 { 5 } else { 9 };
        let mut found: Vec<Vec<f64>> = Vec::new();
        for pattern in 0..1_usize << numbers.len() {
            let mut signs = vec![[0.0; 2]; n];
            for (bit, (i, end)) in numbers.iter().enumerate() {
                signs[*i][*end] = if pattern >> bit & 1 == 0 { 1.0 } else { -1.0 };
            }
            for start in 0..steps.pow(u32::try_from(hinges.len()).expect("few")) {
                let (mut directions, mut rest) = (vec![[0.0; 2]; n], start);
                for i in &hinges {
                    let angle = std::f64::consts::TAU * (rest % steps) as f64 / steps as f64 + 0.1;
                    directions[*i] = [libm::cos(angle), libm::sin(angle)];
                    rest /= steps;
                }
                let Some((x, _)) = self.newton(&signs, &directions, 1.0, None) else { continue };
                if self.residual(&x) > 1e-10 {
                    continue;
                }
                let size = x.iter().fold(f64::MIN_POSITIVE, |m, x| m.max(x.abs()));
                let same = |o: &Vec<f64>| o.iter().zip(&x).all(|(a, b)| (a - b).abs() <= 1e-7 * size);
                if !found.iter().any(same) {
                    found.push(x);
                }
            }
        }
        found
    }

    /// The solution reached from none while all friction grows in small steps; `None` where it jumps or ends.
    fn reached(&self) -> Option<Vec<f64>> {
        let n = self.rubs.len();
        let mut x = vec![0.0; n];
        let steps = 2000;
        for step in 1..=steps {
            let part = f64::from(step) / f64::from(steps);
            let directions = (0..n).map(|i| {
                let m = self.measure(i, &x);
                let size = m[0].hypot(m[1]).max(f64::MIN_POSITIVE);
                [m[0] / size, m[1] / size]
            });
            let directions: Vec<[f64; 2]> = directions.collect();
            let mut signs = self.signs_of(&x);
            let before: Vec<[f64; 2]> = (0..n).map(|i| self.measure(i, &x)).collect();
            // signs that turn within the step
            let mut next = None;
            for _ in 0..8 {
                let (now, determinant) = self.newton(&signs, &directions, part, Some(&x))?;
                let new = self.signs_of(&now);
                let same = (0..n).all(|i| self.rubs[i].turns() || new[i] == signs[i]);
                signs = new;
                if same {
                    next = (determinant > 0.0).then_some(now);
                    break;
                }
            }
            let next = next?;
            let most = before.iter().flatten().fold(f64::MIN_POSITIVE, |m, x| m.max(x.abs()));
            let change = (0..n).map(|i| {
                let now = self.measure(i, &next);
                (now[0] - before[i][0]).abs().max((now[1] - before[i][1]).abs())
            });
            if change.fold(0.0, f64::max) > 0.3 * most {
                return None;
            }
            x = next;
        }
        Some(x)
    }
}

/// What came of many mechanisms.
#[derive(Debug, Default)]
struct Tally {
    moved: usize,
    locked: usize,
    several: usize,
    beyond: usize,
    ends: usize,
    hinges: usize,
    slots: usize,
    contacts: usize,
}

fn compare(seed: u64, draft: &Draft, mechanism: &Mechanism, tally: &mut Tally) -> Result<(), String> {
    let Some(reference) = Reference::new(mechanism, &draft.frames) else { return Ok(()) };
    let rubs = pair_frictions(mechanism, &reference);
    let fine = |f: &&Forces| !f.doubtful && f.condition > 1e-3;
    let Some(forces) = reference.forces.as_ref().filter(fine) else { return Ok(()) };
    if rubs.is_empty() || rubs.iter().any(|r| r.is_slower(SLOWEST) || !r.determined(forces)) {
        return Ok(());
    }
    let Some(laws) = Laws::new(mechanism, &reference, &rubs) else { return Ok(()) };
    let run = Run::new(mechanism)?;
    let solved = run.solved(0)?;
    let (all, reached) = (laws.all(), laws.reached());
    if solved.state.forces.locked {
        tally.locked += 1;
        return if all.is_empty() {
            Ok(())
        } else {
            Err(format!("called locked, but {all:?} solve it, {reached:?}"))
        };
    }
    let view = run.view(0)?;
    let found = view.pair_frictions();
    let mut x = vec![0.0; rubs.len()];
    for (x, rub) in x.iter_mut().zip(&rubs) {
        let r = found
            .iter()
            .find(|r| rub.is_of(r))
            .ok_or_else(|| format!("no friction in pair {}", rub.pair.index()))?;
        *x = r.effort * r.speed.signum() * rub.speed.signum();
    }
    let residual = laws.residual(&x);
    if residual.is_nan() || residual > 1e-8 {
        return Err(format!("{x:?} leave {residual:e} of the laws"));
    }
    tally.moved += 1;
    tally.several += usize::from(all.len() > 1);
    tally.beyond += usize::from(reached.is_none());
    for rub in &rubs {
        match (&mechanism.pair(rub.pair).kind, rub.kind) {
            (_, Kind::Hinge) => tally.hinges += 1,
            (_, Kind::Ends(..)) => tally.ends += 1,
            (_, Kind::Contact(..)) => tally.contacts += 1,
            (PairKind::Slot(_), _) => tally.slots += 1,
            _ => {}
        }
    }
    let size = x.iter().fold(f64::MIN_POSITIVE, |m, x| m.max(x.abs()));
    let near = |o: &Vec<f64>| o.iter().zip(&x).all(|(a, b)| (a - b).abs() <= 1e-6 * size);
    match reached {
        Some(reached) if !near(&reached) => {
            Err(format!("{x:?} is not {reached:?}, which is reached from no friction; {seed}"))
        }
        _ => Ok(()),
    }
}

fn mechanisms(seeds: std::ops::Range<u64>, most: usize) -> Tally {
    let (mut tally, mut wrong) = (Tally::default(), Vec::new());
    let one: Option<u64> = std::env::var("ASSUR_SEED").ok().and_then(|s| s.parse().ok());
    for seed in one.map_or_else(|| crate::share::first(seeds), |s| s..s + 1) {
        let draft = generate::mechanism(seed);
        let mut random = Random::new(seed);
        let mechanism = roughen(&draft, &mut random, most);
        if let Err(e) = compare(seed, &draft, &mechanism, &mut tally) {
            wrong.push(format!("seed {seed}: {e:.500}"));
        }
    }
    let listed = wrong.iter().take(20).map(String::as_str).collect::<Vec<_>>();
    assert!(wrong.is_empty(), "{} wrong, {tally:?}\n{}", wrong.len(), listed.join("\n"));
    tally
}

#[test]
fn every_mix_of_pairs_agrees_with_all_solutions() {
    use crate::share::least;
    let tally = mechanisms(50_000..50_400, 4);
    println!("{tally:?}");
    assert!(tally.moved > least(60) && tally.locked > least(10), "{tally:?}");
    assert!(
        [tally.ends, tally.hinges, tally.slots, tally.contacts].iter().all(|n| *n > least(10)),
        "{tally:?}"
    );
}
