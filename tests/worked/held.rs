//! Pairs that share by friction what one of them could hold: only their chain of links has no reactions.

use crate::made::{Tally, of_position, solved};
use assur::internals::worked::text;

/// An engine that friction stops, where more pairs hold than it takes, and a pendulum beside it that swings on.
const BESIDE: &str = r#"mech 1
gravity 9.81 m/s^2
ground { A (0, 0); P (500 mm, 0); line guide through A along 0 deg }
link crank  A-B 60 mm { mass 2 kg at A; inertia 0.03 kg*m^2 }
link rod    B-C 210 mm { S (70 mm, 0); mass 0.9 kg at S; inertia 0.006 kg*m^2 }
link piston { C (0, 0); mass 0.7 kg at C }
link bob    P-Q 100 mm { mass 1 kg at Q }
revolute  A: ground - crank { friction_circle 30 mm }
revolute  B: crank - rod { friction_circle 4 mm }
revolute  C: rod - piston { friction_circle 2 mm }
prismatic D: piston.C - ground.guide { friction 0.4 }
revolute  P: ground - bob
assemble C ahead of B
start crank = 30 deg at 4 rad/s
start bob = -60 deg at 0 rad/s
simulate 1 s in 2 steps within 1e-6
find omega(crank), omega(bob)
find reactions
"#;

#[test]
fn chains_beside_one_that_is_held_are_derived() {
    let (source, solved) = solved("beside", BESIDE).expect("solved");
    let last = &solved.solution.poses.last().expect("positions").name;
    let (made, condition) = of_position(&source, &solved, Some(last)).expect("a position");
    assert_eq!((made.counts.held, made.counts.forces[1], made.counts.reactions), (2, 0, [1, 0]));
    let words = text(&made.document);
    assert!(words.contains("Friction holds these links in more pairs than it takes"), "{words}");
    assert!(words.contains("R_ground,bob = ") && !words.contains("R_ground,crank = "), "{words}");
    assert!(words.contains("Free body: bob") && !words.contains("Free body: crank"), "{words}");
    let mut tally = Tally::default();
    tally.judge("beside", &made, condition);
    // what is left of the energy has fewer digits than are printed
    assert!(tally.approximate <= 1, "{}", tally.approximate);
    tally.approximate = 0;
    tally.finish();
}
