//! Jerks of all bodies against differences of accelerations with twice the digits: the position a little earlier and later is
//! solved anew, from the equations of all bodies, to 30 digits.

use crate::share::{first, least};
use crate::support::generate;
use crate::support::run::Run;
use assur::internals::check::Overrides;
use assur::internals::math::{Double, Scalar, V2, Vec2};
use assur::internals::plan::{Effects, Level, plan_with};
use assur::internals::solve::{Model, Reference, State, reference};
use assur::internals::source::Source;
use std::path::{Path, PathBuf};

/// Turn of the fastest body in a step, rad.
const STEP: f64 = 1e-3;
/// Nearer to a seam of a cam's law than this nothing is compared, rad.
const SEAM: f64 = 4.0 * STEP;
/// Differences with half the step are off by this much less: positions at which they are not have a corner near.
const SMOOTH: f64 = 1e-8;

/// What jerks may be off, as parts of the greatest term.
const BOUND: f64 = 1e-10;

/// What is found of a position.
#[derive(Debug, Default)]
struct Errors {
    /// Of jerks in `f64`, over the greatest term, times the condition to the fourth power.
    state: f64,
    /// Of those with twice the digits.
    exact: f64,
}

/// The state a time later: the drives go on with their speeds and accelerations.
fn later(state: &State, t: f64) -> State {
    let mut state = state.clone();
    for input in &mut state.motion.inputs {
        let (v, a) = (input.velocity, input.point_acceleration);
        if input.place == Vec2::direction(input.value) {
            input.value += (input.rate + 0.5 * input.acceleration * t) * t;
            input.rate += input.acceleration * t;
            input.place = Vec2::direction(input.value);
        } else {
            input.place += (v + a * (0.5 * t)) * t;
            input.velocity += a * t;
        }
    }
    state
}

/// Rates of accelerations and angular accelerations of all bodies by differences of fourth order.
fn rates(model: &Model<'_>, state: &State, h: f64) -> Option<Vec<(Vec2, f64)>> {
    let at = |k: f64| reference(model, &later(state, k * h), &[]);
    let all: [Reference; 4] = [at(-2.0)?, at(-1.0)?, at(1.0)?, at(2.0)?];
    let rate = |f: &dyn Fn(usize) -> Double| {
        let (near, far) = (f(2) - f(1), f(3) - f(0));
        ((near * Double::of(8.0) - far) / Double::of(12.0 * h)).rounded()
    };
    let of = |slot: usize| {
        let a = |i: usize| -> V2<Double> { all[i].bodies[slot].a };
        (Vec2::new(rate(&|i| a(i).x), rate(&|i| a(i).y)), rate(&|i| all[i].bodies[slot].alpha))
    };
    Some((0..state.motion.bodies.len()).map(of).collect())
}

/// Compares a solved state; nothing where it has no jerk: near dead positions and corners.
fn errors(given: &Model<'_>, solved: &State) -> Option<Errors> {
    let effects = Effects {
        level: Level::Accelerations,
        beyond: true,
        moving: true,
        timed: true,
        ..Effects::default()
    };
    let plan = plan_with(given.mechanism, given.structure, effects);
    let model = Model { plan: &plan, ..*given };
    assert!(plan.rate_groups.is_some(), "a group has not as many equations as unknowns");
    let mut state = solved.clone().ready(&plan);
    let still = |state: &State| {
        state.motion.inputs.iter().all(|input| input.rate == 0.0 && input.velocity == Vec2::zero())
    };
    if still(&state) {
        state.motion.inputs.iter_mut().for_each(|input| input.rate = 1.0);
    }
    state.run_planned_motion(&plan);
    let condition = state.motion.conditions.iter().fold(1.0_f64, |least, c| least.min(c.abs()));
    if state.motion.open.is_some() || condition < 1e-2 {
        return None;
    }
    // over a seam of a law differences are of both sides
    let at_seam = plan.cams.iter().any(|step| {
        let phi = state.cam_angle(step).0;
        let [before, after] = [phi - SEAM, phi + SEAM].map(|phi| step.cam.program.part_at(phi));
        before != after
    });
    if at_seam {
        return None;
    }
    let bodies = &state.motion.bodies;
    let fastest = bodies.iter().fold(0.0_f64, |most, b| most.max(b.omega.abs()).max(b.v.norm()));
    let h = STEP / fastest;
    let (coarse, fine) = (rates(&model, &state, h)?, rates(&model, &state, 0.5 * h)?);
    let exact = reference(&model, &state, &[])?;
    let size = bodies.iter().fold(0.0_f64, |most, b| most.max(b.p.norm())).max(1.0);
    let most = |f: &dyn Fn(usize) -> f64| (0..bodies.len()).map(f).fold(0.0, f64::max);
    let turning = most(&|i| bodies[i].zeta.abs()).max(fastest.powi(3));
    let moving = most(&|i| bodies[i].j.norm()).max(size * fastest.powi(3));
    let mut worst = Errors::default();
    for i in (0..bodies.len()).filter(|i| !plan.is_block(*i)) {
        let off = |(j, zeta): (Vec2, f64)| {
            ((j - fine[i].0).norm() / moving).max((zeta - fine[i].1).abs() / turning)
        };
        if off(coarse[i]) > SMOOTH {
            return None;
        }
        worst.state = worst.state.max(off((bodies[i].j, bodies[i].zeta)) * condition.powi(4));
        let own = &exact.bodies[i];
        let j = Vec2::new(own.j.x.rounded(), own.j.y.rounded());
        worst.exact = worst.exact.max(off((j, own.zeta.rounded())) * condition.powi(4));
    }
    Some(worst)
}

/// Keeps the worst.
#[derive(Debug, Default)]
struct Tally {
    worst: Errors,
    judged: usize,
    left_out: usize,
}

impl Tally {
    fn add(&mut self, name: &str, found: Option<Errors>) {
        let Some(found) = found else {
            self.left_out += 1;
            return;
        };
        self.judged += 1;
        assert!(found.state <= BOUND && found.exact <= BOUND, "{name}: {found:?}");
        self.worst.state = self.worst.state.max(found.state);
        self.worst.exact = self.worst.exact.max(found.exact);
    }
}

/// Holds the jerks of a state of a mechanism made at random elsewhere, in `name`.
pub fn hold(model: &Model<'_>, state: &State, name: impl Fn() -> String) {
    if let Some(found) = errors(model, state) {
        assert!(found.state <= BOUND && found.exact <= BOUND, "{found:?}\n{}", name());
    }
}

fn examples(folder: &Path, out: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).expect("a folder").flatten() {
        let path = entry.path();
        if path.is_dir() {
            examples(&path, out);
        } else if path.extension().is_some_and(|e| e == "mech") {
            out.push(path);
        }
    }
}

#[test]
fn jerks_of_every_example_are_the_rates_of_its_accelerations() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut tally = Tally::default();
    let mut paths = Vec::new();
    examples(&root.join("examples"), &mut paths);
    paths.sort();
    for path in paths {
        let name = path.strip_prefix(root).expect("below the root").display().to_string();
        let source = Source::new(&name, std::fs::read_to_string(&path).expect("a file"));
        let (Some(solved), _) = assur::internals::solve_source(&source, &Overrides::none()) else { continue };
        if solved.compiled.mechanism.simulation.is_some() || solved.compiled.mechanism.drives.is_empty() {
            continue;
        }
        let model = solved.compiled.model();
        let poses: Vec<_> = solved.solution.poses.iter().collect();
        // a few of each: which of them are near a corner is a matter of chance
        for pose in poses.iter().step_by(1 + poses.len() / 6) {
            let Ok(at) = &pose.outcome else { continue };
            tally.add(&format!("{name}, {}", pose.name), errors(&model, &at.state));
        }
    }
    println!("{tally:?}");
    assert!(tally.judged > 200 && tally.left_out < tally.judged / 5, "{tally:?}");
}

#[test]
fn jerks_of_random_groups_are_the_rates_of_their_accelerations() {
    let mut tally = Tally::default();
    for seed in first(7000..7500) {
        let draft = generate::mechanism(seed);
        let Ok(run) = Run::new(&draft.mechanism) else { continue };
        let Ok(at) = run.solved(0) else { continue };
        tally.add(&format!("seed {seed}"), errors(&run.model(), &at.state));
    }
    println!("{tally:?}");
    assert!(tally.judged > least(200), "{tally:?}");
}
