//! Position, velocity, acceleration, all reactions and the balancing torque over a revolution of 360 positions. Items are
//! positions: divan's throughput is positions per second. `cargo bench --bench kinetostatics`.

#[path = "../tests/properties/machines.rs"]
mod machines;

use assur::math::Vec2;
use assur::model::Mechanism;
use assur::plan::Plan;
use assur::solve::{DriveInput, Scene, State, solve};
use assur::structure::Structure;
use divan::counter::ItemsCount;
use divan::{Bencher, black_box};

const POSITIONS: usize = 360;

fn main() {
    divan::main();
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
        let (structure, _) = assur::structure::structure(&mechanism).expect("the machine is sound");
        let plan = assur::plan::plan(&mechanism, &structure);
        let scene = Scene { mechanism: &mechanism, structure: &structure, plan: &plan };
        let solution = solve(&scene).expect("the machine closes");
        let state = solution.poses[0].outcome.as_ref().expect("the first position is regular").state.clone();
        let input = |i: usize| {
            let value = i as f64 * std::f64::consts::TAU / POSITIONS as f64;
            let place = Vec2::direction(value);
            DriveInput { value, place, rate: machines::SPEED, ..DriveInput::default() }
        };
        Self { inputs: (0..POSITIONS).map(input).collect(), state, mechanism, structure, plan }
    }

    /// Runs one revolution; the sum of something of every position, so that nothing is left out.
    fn revolution(&mut self, stage: Stage) -> f64 {
        let scene = Scene { mechanism: &self.mechanism, structure: &self.structure, plan: &self.plan };
        let state = &mut self.state;
        let mut sum = 0.0;
        for input in &self.inputs {
            state.inputs[0] = *input;
            match stage {
                Stage::Positions => state.run_motion::<0>(&self.plan),
                Stage::Velocities => state.run_motion::<1>(&self.plan),
                _ => state.run_motion::<2>(&self.plan),
            }
            if matches!(stage, Stage::Loads | Stage::Forces) {
                state.run_loads(&scene, &[]);
            }
            if matches!(stage, Stage::Forces) {
                state.set_lines(&scene);
                state.run_forces(&self.plan);
            }
            sum += state.efforts[0] + state.bodies[2].p.x;
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
}

fn machine(name: &str) -> Mechanism {
    let start = machines::list(&[0.0]);
    match name {
        "crank-slider" => machines::crank_slider(0.1, 0.35, 0.0, start),
        "four-bar" => machines::four_bar([0.1, 0.35, 0.3, 0.4], true, start),
        "six-bar" => machines::six_bar(start),
        _ => machines::triad(start),
    }
}

fn measure(bencher: Bencher, name: &str, stage: Stage) {
    let mut bench = Bench::new(machine(name));
    bencher.counter(ItemsCount::new(POSITIONS)).bench_local(|| black_box(bench.revolution(black_box(stage))));
}

const MACHINES: [&str; 4] = ["crank-slider", "four-bar", "six-bar", "triad"];

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
