//! What every effect costs that is asked for: Andrews' mechanism, three dyads on a crank, from its text, over a revolution
//! of 360 positions. Items are positions. `cargo bench --bench ladder`; the figures are in `docs/measured/effects.md`.

#[path = "by_hand/andrews.rs"]
mod by_hand;
mod run;

use assur::internals::math::Vec2;
use assur::internals::model::Mechanism;
use assur::internals::solve::State;
use by_hand::{Reduced, reduced};
use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use run::{Run, asking};

fn main() {
    powers_balance();
    divan::main();
}

const LADDER: [&str; 4] = ["a positions", "b velocities", "c accelerations", "e reactions"];

/// The example with 360 positions, asking for one thing.
fn text(what: &str) -> String {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/kinetostatics/andrews.mech");
    let example = std::fs::read_to_string(path).expect("the example").replace("in 12 steps", "in 360 steps");
    let find = match what {
        "a positions" => "position(AH.H)",
        "b velocities" => "velocity(AH.H)",
        "c accelerations" => "acceleration(AH.H)",
        _ => "Mb, reactions",
    };
    asking(&example, find)
}

#[divan::bench(args = LADDER)]
fn one_by_one(bencher: Bencher<'_, '_>, what: &str) {
    let mut run = Run::of(&text(what));
    let positions = run.positions();
    bencher.counter(ItemsCount::new(positions)).bench_local(|| black_box(run.one_by_one()));
}

#[divan::bench(args = LADDER)]
fn side_by_side_in_lanes(bencher: Bencher<'_, '_>, what: &str) {
    let run = Run::of(&text(what));
    let mut positions = run.side_by_side();
    bencher
        .counter(ItemsCount::new(run.positions()))
        .bench_local(|| black_box(positions.sum(&run.compiled.plan)));
}

/// The mechanism from rest, 360 instants.
fn motion() -> String {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/simulation/andrews.mech");
    let example = std::fs::read_to_string(path).expect("the example").replace("in 30 steps", "in 360 steps");
    asking(&example, "angle(OF)")
}

/// From motion at a steady speed ω: Σ m v² + J ω² over ω², Σ m v·a + J ω α over ω³, and the power of the spring over ω.
fn from_motion(mechanism: &Mechanism, state: &State) -> Reduced {
    let omega = state.motion.bodies[1].omega;
    let mut sum = Reduced::default();
    for (link, body) in mechanism.links.iter().zip(&state.motion.bodies) {
        let Some(mass) = &link.mass else { continue };
        let r = mass.centre.turned(body.u);
        let v = body.v + r.perp() * body.omega;
        let a = body.a + r.perp() * body.alpha - r * (body.omega * body.omega);
        sum.inertia += mass.mass * v.dot(v) + mass.inertia * body.omega * body.omega;
        sum.half_rise += mass.mass * v.dot(a) + mass.inertia * body.omega * body.alpha;
    }
    for spring in &mechanism.springs {
        let (one, two) =
            (&state.motion.bodies[spring.from.0.index()], &state.motion.bodies[spring.to.0.index()]);
        let d: Vec2 = two.position(spring.to.1) - one.position(spring.from.1);
        let rate = d.dot(two.velocity(spring.to.1) - one.velocity(spring.from.1));
        sum.drop -= spring.stiffness * (1.0 - spring.free_length / d.norm()) * rate;
    }
    Reduced {
        inertia: sum.inertia / (omega * omega),
        half_rise: sum.half_rise / (omega * omega * omega),
        drop: sum.drop / omega,
    }
}

/// Accelerations and from them the equation of motion, as a motion under loads needs it at every position. No reactions.
#[divan::bench]
fn one_by_one_d_reduced(bencher: Bencher<'_, '_>) {
    let mut run = Run::of(&motion());
    let (model, positions) = (run.compiled.model(), run.positions());
    let mut reduced = assur::internals::position::Reduced::new(&run.compiled.plan, vec![0], false);
    bencher.counter(ItemsCount::new(positions)).bench_local(|| {
        let (mut sum, mut acceleration) = (0.0, [0.0]);
        for input in &run.inputs {
            run.state.motion.inputs[0] = *input;
            reduced.run_motion(&run.compiled.plan, &mut run.state);
            sum += reduced.load(&model, &mut run.state, &[]);
            reduced.accelerations(&mut acceleration);
            sum += acceleration[0];
        }
        black_box(sum)
    });
}

/// The same written out by hand.
#[divan::bench]
fn by_hand_d_reduced(bencher: Bencher<'_, '_>) {
    let run = Run::of(&text("c accelerations"));
    bencher.counter(ItemsCount::new(run.positions())).bench_local(|| {
        let mut sum = 0.0;
        for input in &run.inputs {
            let reduced = reduced(input.place);
            sum += reduced.inertia + reduced.half_rise + reduced.drop;
        }
        black_box(sum)
    });
}

/// The balancing torque from the reduced dynamics is that from the reactions: Mb = I′ω²/2 + V′ − M.
fn powers_balance() {
    let mut run = Run::of(&text("e reactions"));
    let inputs = run.inputs.clone();
    for input in inputs {
        run.inputs = vec![input];
        run.one_by_one();
        let Reduced { inertia, half_rise, drop } = from_motion(&run.compiled.mechanism, &run.state);
        let by_hand = reduced(input.place);
        let pairs = [(inertia, by_hand.inertia), (half_rise, by_hand.half_rise), (drop, by_hand.drop)];
        assert!(pairs.iter().all(|(a, b)| (a - b).abs() < 1e-11 * (1e-6 + b.abs())), "{pairs:?}");
        let omega = run.state.motion.bodies[1].omega;
        let torque = half_rise * omega * omega - drop - 0.033;
        let got = run.state.forces.efforts[0];
        assert!((torque - got).abs() < 1e-11 * (1.0 + got.abs()), "{torque} {got}");
    }
}
