//! The two cams of the shaper against their key.

use super::{deg, near, rise_dwell_fall};
use assur::internals::element::cam::{Cam, Follower, Law, Shape};

struct ShaperCam {
    lift: f64,
    arm: f64,
    pivot: f64,
    turn: f64,
    start: f64,
    far: f64,
    pressure: [f64; 2],
    at: f64,
    curvature: f64,
    curvature_at: f64,
    points: [(f64, [f64; 4]); 9],
}

/// Exact values of the exercises s004-cam-1 and s004-cam-2; the radii of curvature are those of
/// tests/reference/cams/shaper_cams.py, the exercises' own being differences.
fn shaper_cams() -> [ShaperCam; 2] {
    [
        ShaperCam {
            lift: 18.0,
            arm: 0.13,
            pivot: 0.14,
            turn: 60.0,
            start: 20.922239682576617,
            far: 0.09044790729444421,
            pressure: [44.79541810888772, 51.13672681296346],
            at: 30.0,
            curvature: 0.03124342801547574,
            curvature_at: 47.0,
            points: [
                (0.0, [0.018571428571428572, 0.04642307659791978, 0.013, 0.03249615361854384]),
                (
                    15.0,
                    [0.006549737116325452, 0.054714083315901565, -0.003596013777007825, 0.04366583735509733],
                ),
                (
                    30.0,
                    [-0.008756323745391153, 0.06982356749052603, -0.01931052966953251, 0.059164827541037655],
                ),
                (
                    45.0,
                    [-0.029634295671249648, 0.08016631900920602, -0.03119103976010351, 0.06524731945019341],
                ),
                (60.0, [-0.05130211591526479, 0.07449105205701628, -0.04279410548420156, 0.0621373579331957]),
                (
                    75.0,
                    [-0.06849870944387404, 0.058217149142343154, -0.055862734872718575, 0.05013431878181274],
                ),
                (
                    90.0,
                    [-0.07442034300350443, 0.033409134785194895, -0.05947882432601637, 0.03473239576107053],
                ),
                (
                    120.0,
                    [
                        -0.05173279805724141,
                        -0.007466619187495038,
                        -0.03939066528250914,
                        0.0010581540394523899,
                    ],
                ),
                (180.0, [-0.018571428571428572, -0.04642307659791978, -0.013, -0.03249615361854384]),
            ],
        },
        ShaperCam {
            lift: 15.0,
            arm: 0.12,
            pivot: 0.136,
            turn: 70.0,
            start: 21.369486968571422,
            far: 0.08132622615974205,
            pressure: [37.57776919906117, 38.55324929308166],
            at: 35.0,
            curvature: 0.03614110528855766,
            curvature_at: 114.75,
            points: [
                (0.0, [0.02425, 0.043725707541445225, 0.016975, 0.03060799527901166]),
                (
                    15.0,
                    [0.012461168283663523, 0.05137535478830828, 0.0037884729433086744, 0.0391367128892499],
                ),
                (
                    30.0,
                    [-0.0020426377566941517, 0.06146807012807481, -0.01028079046063626, 0.048932806268604946],
                ),
                (
                    45.0,
                    [-0.021008438233722736, 0.07028161085152124, -0.023808782685062986, 0.05554532668780317],
                ),
                (60.0, [-0.04141767403907359, 0.06850702238006, -0.03613976806016787, 0.05446623506318096]),
                (
                    75.0,
                    [-0.058543183395397554, 0.05645042727312488, -0.04774534126749537, 0.04603857799545567],
                ),
                (
                    90.0,
                    [-0.07012226907353097, 0.03861998469922424, -0.05591710398930176, 0.033801967998361174],
                ),
                (
                    120.0,
                    [-0.06146807012807481, -0.0020426377566941517, -0.0496391197144878, 0.007181023778341685],
                ),
                (180.0, [-0.02425, -0.043725707541445225, -0.016975, -0.03060799527901166]),
            ],
        },
    ]
}

fn shaper_cam(key: &ShaperCam, with_cam: bool) -> Cam {
    let turn = deg(key.turn);
    let program = rise_dwell_fall(turn, deg(10.0), turn, deg(key.lift), [Law::Parabolic; 2]);
    let (shape, arm, pivot_distance) = (Shape::Roller(0.015), key.arm, key.pivot);
    let follower = Follower::Oscillating { shape, arm, pivot_distance, with_cam, offset: 0.0 };
    Cam::new(0.05, false, follower, program).unwrap()
}

#[test]
fn shaper_cams_are_those_of_the_key() {
    for key in shaper_cams() {
        let cam = shaper_cam(&key, true);
        near(cam.start().to_degrees(), key.start, 1e-12);
        let top = cam.at(deg(key.turn + 5.0));
        near(top.tip.norm(), key.far, 1e-12);
        for (phi, [x, y, w_x, w_y]) in key.points {
            let phi = deg(phi);
            let point = cam.at(phi);
            let (pitch, profile) = (cam.in_cam(point.tip, phi), cam.in_cam(point.contact, phi));
            let off = [pitch.x - x, pitch.y - y, profile.x - w_x, profile.y - w_y];
            assert!(off.iter().all(|o| o.abs() < 1e-13), "{off:?} at {phi}");
        }
        near(1.0 / cam.at(deg(key.curvature_at)).curvature, key.curvature, 1e-12);
        for (with_cam, pressure) in [(true, key.pressure[0]), (false, key.pressure[1])] {
            // the key looks at the rise alone
            let turn = deg(key.turn);
            let cam = shaper_cam(&key, with_cam);
            let at = cam.at(deg(key.at)).pressure_angle.to_degrees();
            near(at, pressure, 1e-12);
            let rise = (0..=600).map(|i| cam.at(turn * f64::from(i) / 600.0).pressure_angle.to_degrees());
            assert!(rise.fold(0.0, f64::max) <= pressure + 1e-12);
        }
    }
}
