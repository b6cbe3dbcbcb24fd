//! Positions side by side have the bits of each alone.

use crate::support::generate;
use crate::support::run::Run;
use assur::internals::math::Vec2;
use assur::internals::plan::Level;
use assur::internals::solve::{Batch, DriveColumns, DriveInput, Place, State, WIDTH};

/// Two full blocks and a rest.
const POSITIONS: usize = 2 * WIDTH + 3;

#[test]
fn positions_of_a_batch_have_the_bits_of_each_alone() {
    let mut in_lanes = 0;
    for seed in crate::share::first(0..600) {
        let Ok(run) = Run::new(&generate::mechanism(seed).mechanism) else { continue };
        in_lanes += compare(&run, seed).expect("the same bits");
    }
    assert!(in_lanes > crate::share::least(500), "{in_lanes} positions in lanes");
}

/// The number of positions that went in lanes, or where one of them differs.
fn compare(run: &Run, seed: u64) -> Result<usize, String> {
    let Ok(solved) = run.solved(0) else { return Ok(0) };
    if !run.plan.is_batchable() {
        return Ok(0);
    }
    let moving: Vec<DriveInput> = (0..POSITIONS).flat_map(|i| moved(&solved.state, i)).collect();
    // nothing of the run before is left in the second
    let still: Vec<DriveInput> = moving.iter().map(|d| DriveInput { velocity: Vec2::zero(), ..*d }).collect();
    let mut in_lanes = 0;
    for new in [Batch::new, Batch::in_one_lane] {
        let mut positions = new(&run.plan, &solved.state);
        for inputs in [&moving, &still] {
            in_lanes += compare_with(run, &solved.state, &mut positions, inputs)
                .map_err(|e| format!("seed {seed}: {e}"))?;
        }
    }
    Ok(in_lanes)
}

fn compare_with(
    run: &Run,
    reference: &State,
    positions: &mut Batch<'_>,
    inputs: &[DriveInput],
) -> Result<usize, String> {
    let drives = run.plan.drives;
    let (mut numbers, mut in_lanes, mut wrong) = (Vec::new(), 0, None);
    positions.run(&DriveColumns::of(inputs, drives), |i, place| {
        numbers.push(i);
        in_lanes += usize::from(matches!(place, Place::Lane(..)));
        let alone = alone(run, reference, &inputs[i * drives..][..drives]);
        if let Some(what) = differs(&place, &alone) {
            wrong.get_or_insert(format!("position {i}: {what}"));
        }
    });
    if numbers != (0..POSITIONS).collect::<Vec<_>>() {
        return Err(format!("handed out {numbers:?}"));
    }
    wrong.map_or(Ok(in_lanes), Err)
}

/// The drives of the solved position moved on; the last of the second block far away, where many do not close.
fn moved(state: &State, i: usize) -> impl Iterator<Item = DriveInput> {
    let step = if i == 2 * WIDTH - 1 { 2.0 } else { 1e-3 * i as f64 };
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

fn differs(place: &Place<'_>, alone: &State) -> Option<String> {
    if place.open() != alone.motion.open {
        return Some(format!("open {:?} and {:?}", place.open(), alone.motion.open));
    }
    let vector = |a: Vec2, b: Vec2| [(a.x, b.x), (a.y, b.y)];
    let mut pairs = Vec::new();
    for (slot, b) in alone.motion.bodies.iter().enumerate() {
        let a = place.body(slot);
        pairs.extend([(a.omega, b.omega), (a.alpha, b.alpha)]);
        for (a, b) in [(a.p, b.p), (a.u, b.u), (a.v, b.v), (a.a, b.a)] {
            pairs.extend(vector(a, b));
        }
    }
    for (slot, b) in alone.forces.reactions.iter().enumerate() {
        let a = place.reaction(slot);
        pairs.push((a.couple, b.couple));
        pairs.extend(vector(a.force, b.force));
    }
    pairs.extend(alone.forces.efforts.iter().enumerate().map(|(slot, &b)| (place.effort(slot), b)));
    pairs
        .extend(alone.motion.conditions.iter().enumerate().map(|(group, &b)| (place.conditioning(group), b)));
    pairs.extend(
        alone.forces.conditions.iter().enumerate().map(|(group, &b)| (place.force_conditioning(group), b)),
    );
    let same = |(a, b): &(f64, f64)| a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan();
    pairs.iter().find(|pair| !same(pair)).map(|(a, b)| format!("{a:e} beside {b:e} alone"))
}
