//! A machine with AVX-512 never goes through AVX2 by itself: what AVX2 makes has the bits of one lane.

#![cfg(target_arch = "x86_64")]

use assur::internals::check::Overrides;
use assur::internals::solve::{Batch, DriveColumns, DriveInput, Place, WIDTH, block_in_avx2, solve};
use assur::internals::source::Source;

#[test]
fn avx2_has_the_bits_of_one_lane() {
    let text = include_str!("../../examples/kinetostatics/andrews.mech").to_owned();
    let (compiled, _) = assur::internals::compile(&Source::new("andrews.mech", text), &Overrides::none());
    let compiled = compiled.expect("the example compiles");
    let (model, plan) = (compiled.model(), &compiled.plan);
    let solution = solve(&model).expect("the example is solved");
    let states = solution.poses.iter().map(|p| &p.outcome.as_ref().expect("it closes").state);
    let first = &solution.poses[0].outcome.as_ref().expect("it closes").state;
    let inputs: Vec<DriveInput> = states.flat_map(|s| s.motion.inputs.clone()).collect();
    let inputs = DriveColumns::of(&inputs, plan.drives);

    let Some(block) = block_in_avx2(plan, first, &inputs) else { return };
    let mut seen = 0;
    Batch::in_one_lane(plan, first).run(&inputs, |i, place| {
        if i < WIDTH {
            let lane = Place::Lane(&block, i);
            assert_eq!(lane.effort(0).to_bits(), place.effort(0).to_bits(), "position {i}");
            for slot in 1..plan.bodies {
                assert_eq!(format!("{:?}", lane.body(slot)), format!("{:?}", place.body(slot)));
            }
            seen += 1;
        }
    });
    assert_eq!(seen, WIDTH);
}
