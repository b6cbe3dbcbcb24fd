//! Cams and Geneva wheels on a frame that moves: relative motion gives every step.

use crate::made::{Tally, of_position, solved};

const LEVER: &str = r#"mech 1
mechanism "A cam and its lever on an arm that turns"
cam plate {
  base_radius 50 mm
  turning cw
  follower oscillating roller { arm 130 mm; pivot_distance 140 mm; radius 15 mm; with_cam }
  rise 60 deg through 18 deg modified_sine
  dwell 10 deg
  fall 70 deg poly345
}
ground { Z (0, 0) }
link arm { Z (0, 0); O (200 mm, 50 mm); P (340 mm, 50 mm); S (150 mm, 0); mass 1 kg at S; inertia 0.02 kg*m^2 }
link disk { O (0, 0); profile rim of plate centre O }
link lever P-R 130 mm { circle roller centre R radius 15 mm; S (65 mm, 0); mass 2 kg at S; inertia 0.01 kg*m^2 }
revolute Z: ground - arm
revolute O: arm - disk
revolute P: arm - lever
contact  K: disk.rim - lever.roller
drive arm = 20 deg, 50 deg, 80 deg, 100 deg at 60 rpm
drive disk = 5 deg, -15 deg, -20 deg, -30 deg at 300 rpm cw
balance torque Ma on arm
balance torque Mb on disk
torque Q on lever = 20 N*m
find omega(lever), alpha(lever), Ma, Mb, reactions
"#;

const TAPPET: &str = r#"mech 1
mechanism "A cam and its tappet on an arm that turns"
cam plate {
  base_radius 50 mm
  turning ccw
  follower translating roller { radius 10 mm; offset 8 mm }
  rise 90 deg through 20 mm modified_trapezoid
  fall 90 deg cycloidal
}
ground { Z (0, 0) }
link arm { Z (0, 0); O (200 mm, 50 mm); G (208 mm, 50 mm); line way through G along 90 deg; S (150 mm, 0); mass 1 kg at S; inertia 0.02 kg*m^2 }
link disk { O (0, 0); profile rim of plate centre O }
link tappet { R (0, 0); circle roller centre R radius 10 mm; mass 0.5 kg at R }
revolute Z: ground - arm
revolute O: arm - disk
prismatic V: tappet.R - arm.way
contact  K: disk.rim - tappet.roller
drive arm = 20 deg, 50 deg, 80 deg, 100 deg at 60 rpm
drive disk = 125 deg, 200 deg, 280 deg, 320 deg at 200 rpm
balance torque Ma on arm
balance torque Mb on disk
find velocity(tappet.R), acceleration(tappet.R), Ma, Mb, reactions
"#;

const TURNED: &str = r#"mech 1
mechanism "A lever turns its cam on an arm that turns"
cam plate {
  base_radius 50 mm
  turning cw
  follower oscillating roller { arm 130 mm; pivot_distance 140 mm; radius 15 mm; with_cam }
  rise 60 deg through 18 deg cycloidal
  dwell 10 deg
  fall 70 deg poly345
}
ground { Z (0, 0) }
link arm { Z (0, 0); O (200 mm, 50 mm); P (340 mm, 50 mm) }
link disk { O (0, 0); profile rim of plate centre O }
link lever P-R 130 mm { circle roller centre R radius 15 mm }
revolute Z: ground - arm
revolute O: arm - disk
revolute P: arm - lever
contact  K: disk.rim - lever.roller
drive arm = 20 deg, 50 deg at 60 rpm
drive lever = 172 deg, 200 deg at 30 rpm
assemble O > -67 deg
find angle(disk), omega(disk), alpha(disk)
"#;

const GENEVA: &str = r#"mech 1
mechanism "A Geneva wheel on an arm that turns"
ground { Z (0, 0) }
link arm { Z (0, 0); A (200 mm, 50 mm); C (300 mm, 50 mm); S (150 mm, 0); mass 1 kg at S; inertia 0.02 kg*m^2 }
link crank A-B 100 mm*sin(180 deg/4) { S (20 mm, 0); mass 0.5 kg at S; inertia 0.001 kg*m^2 }
link wheel { C (0, 0); line slot through C along 0 deg; mass 1.2 kg at C; inertia 0.002 kg*m^2 }
revolute Z: ground - arm
revolute A: arm - crank
revolute C: arm - wheel
slot     K: crank.B - wheel.slot { slots 4 }
drive arm = 10 deg, 20 deg, 30 deg at 30 rpm
drive crank = 0 deg, 50 deg, 130 deg at 60 rpm
torque L on wheel = 0.3 N*m
balance torque Ma on arm
balance torque Mb on crank
find angle(wheel), omega(wheel), alpha(wheel), Ma, Mb, reactions
"#;

#[test]
fn elements_on_a_moving_frame_are_derived() {
    let mut tally = Tally::default();
    for (name, text) in [("lever", LEVER), ("tappet", TAPPET), ("turned", TURNED), ("geneva", GENEVA)] {
        let (source, solved) = solved(name, text).expect("solved");
        for pose in &solved.solution.poses {
            let (made, condition) = of_position(&source, &solved, Some(&pose.name)).expect("a position");
            tally.judge(&format!("{name} at {}", pose.name), &made, condition);
        }
    }
    tally.finish();
    assert!(tally.solutions == 13 && tally.derived[1] == 0, "{tally:?}");
}
