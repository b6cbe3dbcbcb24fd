//! What is put into the columns of drives comes out of them.

use assur_math::math::Vec2;
use assur_position::position::{DriveColumns, DriveInput};

/// Drive `k` at position `i`, all quantities different.
fn given(i: usize, k: usize) -> DriveInput {
    let x = (10 * i + k) as f64;
    let point = if k == 1 { Vec2::new(x + 0.5, -x) } else { Vec2::zero() };
    DriveInput {
        place: Vec2::new(x, 2.0 * x),
        value: 3.0 * x,
        rate: 4.0 * x,
        acceleration: 5.0 * x,
        velocity: point,
        point_acceleration: point * 2.0,
    }
}

#[test]
fn what_goes_in_comes_out() {
    let inputs: Vec<DriveInput> = (0..5).flat_map(|i| (0..2).map(move |k| given(i, k))).collect();
    let columns = DriveColumns::of(&inputs, 2);
    assert_eq!(columns.len(), 5);
    let (mut one, mut lanes) = ([DriveInput::default(); 2], [DriveInput::default(); 2]);
    columns.read_lanes::<3>(1, &mut lanes);
    for i in 0..5 {
        columns.read(i, &mut one);
        for k in 0..2 {
            assert_eq!(format!("{:?}", one[k]), format!("{:?}", inputs[2 * i + k]));
            if (1..4).contains(&i) {
                let lane = lanes[k];
                let lane = [lane.value, lane.place.y, lane.velocity.x, lane.point_acceleration.y]
                    .map(|l| l.0[i - 1]);
                let want = one[k];
                assert_eq!(lane, [want.value, want.place.y, want.velocity.x, want.point_acceleration.y]);
            }
        }
    }
}

#[test]
fn nothing_without_drives() {
    assert!(DriveColumns::of(&[], 0).is_empty());
}

#[test]
fn a_drive_is_turned_to_angles() {
    let inputs: Vec<DriveInput> = (0..6).map(|i| given(i % 3, i / 3)).collect();
    let mut columns = DriveColumns::of(&inputs, 2);
    columns.set_angles(1, &[0.5, 0.0, 2.0]);
    columns.set_angles(2, &[1.0]);
    let mut one = [DriveInput::default(); 2];
    columns.read(2, &mut one);
    let turned = DriveInput { value: 2.0, place: Vec2::direction(2.0), ..inputs[5] };
    assert_eq!(format!("{one:?}"), format!("{:?}", [inputs[4], turned]));
}
