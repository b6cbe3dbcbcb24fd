//! Position, velocity, acceleration, all reactions and the balancing torque over a revolution of 360 positions. The direction
//! of the crank is given, except where the name says `from_the_angle`; nothing is followed, and no residuals are computed.
//! Items are positions: divan's throughput is positions per second. `cargo bench --bench kinetostatics`, with `--features lanes` in lanes too.

#[path = "../tests/mechanics/support/machines.rs"]
mod machines;

mod by_hand;

use assur::internals::math::Vec2;
use assur::internals::model::{Friction, Mechanism, PairKind};
use assur::internals::plan::Plan;
use assur::internals::solve::{DriveInput, Model, State, solve};
use assur::internals::structure::Structure;
use divan::counter::ItemsCount;
use divan::{Bencher, black_box};

const POSITIONS: usize = 360;
/// Of the four-bar: crank, coupler, rocker, frame, m.
const LENGTHS: [f64; 4] = [0.1, 0.35, 0.3, 0.4];

fn main() {
    same_by_hand();
    divan::main();
}

/// The solver and the four-bar written out by hand agree.
fn same_by_hand() {
    let mut bench = Bench::new(machine("four-bar"));
    let inputs = bench.inputs.clone();
    for input in inputs {
        bench.inputs = vec![input];
        bench.revolution(Stage::Forces);
        let (_, torque) = by_hand::four_bar(LENGTHS, machines::SPEED, input.place);
        assert!((bench.state.forces.efforts[0] - torque).abs() < 1e-12 * (1.0 + torque.abs()));
    }
}

/// A machine assembled at its first position, and the inputs of all positions.
struct Bench {
    mechanism: Mechanism,
    structure: Structure,
    plan: Plan,
    state: State,
    inputs: Vec<DriveInput>,
}

impl Bench {
    fn new(mechanism: Mechanism) -> Self {
        let (structure, _) =
            assur::internals::structure::structure(&mechanism).expect("the machine is sound");
        let plan = assur::internals::plan::plan(&mechanism, &structure);
        let model = Model { mechanism: &mechanism, structure: &structure, plan: &plan };
        let solution = solve(&model).expect("the machine closes");
        let first = solution.poses[0].outcome.as_ref().expect("the first position is regular");
        let state = first.state.clone().ready(&plan);
        let input = |i: usize| {
            let value = i as f64 * std::f64::consts::TAU / POSITIONS as f64;
            let place = Vec2::direction(value);
            DriveInput { value, place, rate: machines::SPEED, ..DriveInput::default() }
        };
        Self { inputs: (0..POSITIONS).map(input).collect(), state, mechanism, structure, plan }
    }

    /// Runs one revolution; the sum of something of every position, so that nothing is left out.
    fn revolution(&mut self, stage: Stage) -> f64 {
        let model = Model { mechanism: &self.mechanism, structure: &self.structure, plan: &self.plan };
        let state = &mut self.state;
        let mut sum = 0.0;
        for input in &self.inputs {
            state.motion.inputs[0] = *input;
            match stage {
                Stage::Positions => state.run_motion::<0>(&self.plan),
                Stage::Velocities => state.run_motion::<1>(&self.plan),
                _ => state.run_motion::<2>(&self.plan),
            }
            if matches!(stage, Stage::Loads | Stage::Forces | Stage::Friction) {
                state.run_loads(&model, &[]);
            }
            if matches!(stage, Stage::Forces | Stage::Friction) {
                state.set_lines(&self.plan);
                if matches!(stage, Stage::Friction) {
                    state.set_senses(&self.plan);
                }
                state.run_forces(&self.plan);
            }
            sum += state.forces.efforts[0] + state.motion.bodies[2].p.x;
        }
        sum
    }
}

#[derive(Clone, Copy)]
enum Stage {
    Positions,
    Velocities,
    Accelerations,
    Loads,
    Forces,
    Friction,
}

fn machine(name: &str) -> Mechanism {
    let start = machines::list(&[0.0]);
    match name {
        "crank-slider" => machines::crank_slider(0.1, 0.35, 0.0, start),
        "four-bar" => machines::four_bar(LENGTHS, true, start),
        "six-bar" => machines::six_bar(start),
        "triad" => machines::triad(start),
        _ => machines::class_iv(start),
    }
}

/// The machine with friction in every pair: journals of 2 mm friction circle, guides of 0.1.
fn rough(name: &str) -> Mechanism {
    let mut m = machine(name);
    for pair in &mut m.pairs {
        pair.friction = Some(match pair.kind {
            PairKind::Revolute(_) => Friction::Circle(0.002),
            _ => Friction::Coefficient(0.1),
        });
    }
    m
}

fn measure(bencher: Bencher, name: &str, stage: Stage) {
    let mut bench = Bench::new(machine(name));
    bencher.counter(ItemsCount::new(POSITIONS)).bench_local(|| black_box(bench.revolution(black_box(stage))));
}

const MACHINES: [&str; 5] = ["crank-slider", "four-bar", "six-bar", "triad", "class-iv"];

#[divan::bench(args = MACHINES)]
fn a_positions(bencher: Bencher, name: &str) {
    measure(bencher, name, Stage::Positions);
}

#[divan::bench(args = MACHINES)]
fn b_velocities(bencher: Bencher, name: &str) {
    measure(bencher, name, Stage::Velocities);
}

#[divan::bench(args = MACHINES)]
fn c_accelerations(bencher: Bencher, name: &str) {
    measure(bencher, name, Stage::Accelerations);
}

#[divan::bench(args = MACHINES)]
fn d_loads(bencher: Bencher, name: &str) {
    measure(bencher, name, Stage::Loads);
}

#[divan::bench(args = MACHINES)]
fn e_forces(bencher: Bencher, name: &str) {
    measure(bencher, name, Stage::Forces);
}

/// Against `e_forces`: what friction in every pair costs.
#[divan::bench(args = MACHINES)]
fn g_friction_in_every_pair(bencher: Bencher, name: &str) {
    let mut bench = Bench::new(rough(name));
    bencher
        .counter(ItemsCount::new(POSITIONS))
        .bench_local(|| black_box(bench.revolution(black_box(Stage::Friction))));
}

/// The four-bar by hand, with the directions of the crank given or from its angles.
fn by_hand_from(bencher: Bencher, direction: impl Fn(&DriveInput) -> Vec2) {
    let bench = Bench::new(machine("four-bar"));
    let lengths = black_box(LENGTHS);
    let mut out = [[Vec2::zero(); 4]; POSITIONS];
    bencher.counter(ItemsCount::new(POSITIONS)).bench_local(|| {
        let mut sum = 0.0;
        for (input, out) in bench.inputs.iter().zip(&mut out) {
            let (reactions, torque) = by_hand::four_bar(lengths, machines::SPEED, direction(input));
            *out = reactions;
            sum += torque;
        }
        black_box(&out);
        sum
    });
}

#[divan::bench]
fn f_by_hand_four_bar(bencher: Bencher) {
    by_hand_from(bencher, |input| input.place);
}

/// Against `f_by_hand_four_bar`: what the sine and the cosine of the drive cost.
#[divan::bench]
fn f_by_hand_four_bar_from_the_angle(bencher: Bencher) {
    by_hand_from(bencher, |input| Vec2::direction(input.value));
}
