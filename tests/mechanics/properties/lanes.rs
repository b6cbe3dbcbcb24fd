//! Positions side by side have the bits of each alone.

use crate::support::generate;
use crate::support::run::Run;
use assur::internals::math::Vec2;
use assur::internals::plan::Level;
use assur::internals::solve::{Checked, DriveInput, LaneSolver, State, WIDTH};

/// Two full rows.
const POSITIONS: usize = 2 * WIDTH;

#[test]
fn positions_in_lanes_have_the_bits_of_each_alone() {
    let mut in_lanes = 0;
    for seed in crate::share::first(0..600) {
        let Ok(run) = Run::new(&generate::mechanism(seed).mechanism) else { continue };
        in_lanes += compare(&run).unwrap_or_else(|e| panic!("seed {seed}: {e}"));
    }
    assert!(in_lanes > crate::share::least(500), "{in_lanes} positions in lanes");
}

/// The number of positions that were compared, or where one of them differs.
fn compare(run: &Run) -> Result<usize, String> {
    let Ok(solved) = run.solved(0) else { return Ok(0) };
    if !run.plan.is_batchable() {
        return Ok(0);
    }
    let moving: Vec<DriveInput> = (0..POSITIONS).flat_map(|i| moved(&solved.state, i)).collect();
    let mut row = State::closed(&run.plan);
    row.branches.clone_from(&solved.state.branches);
    let (mut rows, mut solver) = (vec![row; POSITIONS / WIDTH], LaneSolver::default());
    let (mut checked, mut in_lanes) = (vec![Checked::default(); rows.len()], 0);
    // nothing of the run before is left in the second
    let still = moving.iter().map(|d| DriveInput { velocity: Vec2::zero(), ..*d }).collect();
    for inputs in [moving, still] {
        for (i, inputs) in inputs.chunks(run.plan.drives).enumerate() {
            let row = rows[i / WIDTH].motion.inputs.iter_mut().zip(inputs);
            row.for_each(|(row, input)| row.set_lane(i % WIDTH, input));
        }
        solver.run(&run.plan, (&mut rows, &[]), &mut checked, true);
        for (row, inputs) in rows.iter().zip(inputs.chunks(WIDTH * run.plan.drives)) {
            let alone = |inputs| alone(run, &solved.state, inputs);
            let alone: Vec<State> = inputs.chunks(run.plan.drives).map(alone).collect();
            if alone.iter().all(|alone| alone.motion.open.is_none()) != row.motion.open.is_none() {
                return Err(format!("open {:?}", row.motion.open));
            }
            if row.motion.open.is_some() {
                continue;
            }
            in_lanes += WIDTH;
            for (lane, alone) in alone.iter().enumerate() {
                let mut state = State::closed(&run.plan);
                row.write_lane(lane, &mut state);
                differs(&state, alone).map_or(Ok(()), |what| Err(format!("lane {lane}: {what}")))?;
            }
        }
    }
    Ok(in_lanes)
}

/// The drives of the solved position moved on; the last far away, where many do not close.
fn moved(state: &State, i: usize) -> impl Iterator<Item = DriveInput> {
    let step = if i == POSITIONS - 1 { 2.0 } else { 1e-3 * i as f64 };
    state.motion.inputs.iter().map(move |input| DriveInput {
        place: input.place.turned(Vec2::direction(step)),
        value: input.value * (1.0 + step),
        rate: input.rate + step,
        ..*input
    })
}

fn alone(run: &Run, reference: &State, inputs: &[DriveInput]) -> State {
    let mut state = reference.clone().ready(&run.plan);
    state.motion.inputs.copy_from_slice(inputs);
    match run.plan.effects.level {
        Level::Positions => state.run_motion::<0>(&run.plan),
        Level::Velocities => state.run_motion::<1>(&run.plan),
        Level::Accelerations => state.run_motion::<2>(&run.plan),
    }
    if run.plan.effects.forces {
        state.run_loads(&run.model(), &[]);
        state.set_lines(&run.plan);
        state.run_forces(&run.plan);
    }
    state
}

fn differs(lane: &State, alone: &State) -> Option<String> {
    let vector = |a: Vec2, b: Vec2| [(a.x, b.x), (a.y, b.y)];
    let mut pairs = Vec::new();
    for (a, b) in lane.motion.bodies.iter().zip(&alone.motion.bodies) {
        pairs.extend([(a.omega, b.omega), (a.alpha, b.alpha)]);
        for (a, b) in [(a.p, b.p), (a.u, b.u), (a.v, b.v), (a.a, b.a)] {
            pairs.extend(vector(a, b));
        }
    }
    for (a, b) in lane.forces.reactions.iter().zip(&alone.forces.reactions) {
        pairs.push((a.couple, b.couple));
        pairs.extend(vector(a.force, b.force));
    }
    let each = |a: &[f64], b: &[f64]| a.iter().copied().zip(b.iter().copied()).collect::<Vec<_>>();
    pairs.extend(each(&lane.forces.efforts, &alone.forces.efforts));
    pairs.extend(each(&lane.motion.conditions, &alone.motion.conditions));
    pairs.extend(each(&lane.forces.conditions, &alone.forces.conditions));
    let same = |(a, b): &(f64, f64)| a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan();
    pairs.iter().find(|pair| !same(pair)).map(|(a, b)| format!("{a:e} beside {b:e} alone"))
}
