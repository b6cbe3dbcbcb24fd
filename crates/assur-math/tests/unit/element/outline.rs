use assur_math::element::cam::{Cam, Follower, Law, Program, Shape};
use assur_math::math::Vec2;
use std::f64::consts::PI;

fn cam() -> Cam {
    let program = Program::new(&[(PI / 2.0, 0.02, Law::Cycloidal), (PI / 2.0, -0.02, Law::Cycloidal)]);
    let follower = Follower::Translating { shape: Shape::Roller(0.01), offset: 0.0 };
    Cam::new(0.05, true, follower, program).expect("a cam")
}

/// The error falls with the square of the steps, and few of the chosen ones are too many.
#[test]
fn steps_keep_the_chord_error() {
    let cam = cam();
    for within in [1e-4, 1e-5, 1e-6] {
        let steps = cam.steps_within(within).expect("steps");
        assert!(cam.chord_error(steps) <= within, "{steps}");
        assert!(cam.chord_error(steps * 19 / 20) > within, "{steps}");
        assert_eq!(cam.profile(steps).len(), steps as usize);
    }
    let share = cam.chord_error(200) / cam.chord_error(400);
    assert!((share - 4.0).abs() < 0.4, "{share}");
    assert_eq!(cam.steps_within(1e-12), None);
}

/// A chord of a circle leaves it by r (1 − cos(half its angle)).
#[test]
fn the_error_is_that_of_chords_of_a_circle() {
    let follower = Follower::Translating { shape: Shape::Knife, offset: 0.0 };
    let round = Cam::new(0.05, false, follower, Program::new(&[])).expect("a disc");
    let exact = 0.05 * (1.0 - Vec2::direction(PI / 36.0).x);
    assert!((round.chord_error(36) - exact).abs() < 1e-12);
    assert_eq!(round.pitch_curve(36), None);
}
