//! Gear pairs against tests/reference/gears/pairs.py, which finds the working pressure angle by bisection, the contact by
//! cutting lines with circles and the overlap in a ring by following the tips of the pinion.
#![allow(clippy::unwrap_used, reason = "tests")]
#![allow(clippy::disallowed_methods, reason = "an independent computation")]
#![allow(clippy::excessive_precision, reason = "the digits of the reference")]

use assur::internals::element::gear::{GearFault, GearPair, Teeth, involute};

fn teeth(z: [f64; 2], module: f64, shift: [f64; 2], internal: bool) -> Teeth {
    let pressure_angle = 20.0_f64.to_radians();
    Teeth { z, module, pressure_angle, addendum: 1.0, clearance: 0.25, shift, internal }
}

fn near(got: f64, expected: f64) {
    assert!((got - expected).abs() <= 1e-14 * expected.abs(), "{got:?} instead of {expected:?}");
}

#[test]
fn pairs_are_those_of_the_reference() {
    let cases = [
        (
            teeth([18.0, 42.0], 0.016, [0.0; 2], false),
            [20.0, 0.48, 0.32, 0.704, 0.0768193072871296, 1.6263526244114566],
        ),
        (
            teeth([17.0, 40.0], 0.002, [0.5, 0.3], false),
            [
                23.63881286322533,
                0.05846849362399856,
                0.03973698724799711,
                0.08493698724799711,
                0.00813668910199671,
                1.3781041399491547,
            ],
        ),
        (
            teeth([20.0, 60.0], 0.002, [0.0; 2], true),
            [20.0, 0.04, 0.044, 0.116, 0.011511318723702067, 1.9496623000521336],
        ),
        (
            teeth([20.0, 60.0], 0.002, [0.2, 0.6], true),
            [
                22.721087197904463,
                0.040750073639030195,
                0.0448,
                0.1184,
                0.009878866335198312,
                1.6731752219954281,
            ],
        ),
    ];
    for (teeth, [alpha_w, a, da_1, da_2, g, ratio]) in cases {
        let pair = GearPair::new(teeth).unwrap();
        near(pair.alpha_w.to_degrees(), alpha_w);
        near(pair.a, a);
        near(pair.gears[0].da, da_1);
        near(pair.gears[1].da, da_2);
        assert!((pair.g - g).abs() < 2e-14 * a, "{} {g}", pair.g);
        assert!((pair.ratio - ratio).abs() < 1e-13, "{} {ratio}", pair.ratio);
    }
}

/// Standard wheels at the standard distance touch on their reference circles; shifted ones keep the clearance.
#[test]
fn clearances_are_kept() {
    for shift in [[0.0, 0.0], [0.3, -0.3], [0.6, 0.4], [0.2, 0.9]] {
        let pair = GearPair::new(teeth([20.0, 37.0], 0.003, shift, false)).unwrap();
        for i in 0..2 {
            let gap = pair.a - 0.5 * (pair.gears[i].da + pair.gears[1 - i].df);
            assert!((gap - pair.c).abs() < 1e-16, "{shift:?}: {gap}");
        }
        near(0.5 * (pair.gears[0].dw + pair.gears[1].dw), pair.a);
        // without backlash the teeth and spaces fill the working pitch
        let at_work = |i: usize| {
            let g = &pair.gears[i];
            g.dw * (g.s / g.d + involute(pair.teeth.pressure_angle) - involute(pair.alpha_w))
        };
        let pitch = std::f64::consts::PI * pair.gears[0].dw / 20.0;
        assert!((at_work(0) + at_work(1) - pitch).abs() < 1e-16, "{shift:?}");
    }
}

/// Sliding from the velocities of the two wheels at the place where the tips touch, found by cutting circle and line.
#[test]
fn sliding_is_the_difference_of_velocities() {
    let pair = GearPair::new(teeth([17.0, 40.0], 0.002, [0.5, 0.3], false)).unwrap();
    let (sin, cos) = pair.alpha_w.sin_cos();
    let centres = [-0.5 * pair.gears[0].dw, 0.5 * pair.gears[1].dw];
    for i in 0..2 {
        let (c, r) = (centres[i], 0.5 * pair.gears[i].da);
        // P + t (cos, sin), beyond the pitch point for wheel 1, before it for wheel 2
        let root = (c * c * sin * sin - c * c + r * r).sqrt();
        let t = c * sin + if i == 0 { root } else { -root };
        let (x, y) = (t * cos, t * sin);
        // wheel 1 turns clockwise with 1 rad/s
        let omega = [-1.0, 17.0 / 40.0];
        let v = [0, 1].map(|k| (-omega[k] * (y - centres[k]), omega[k] * x));
        let along = (v[0].0 - v[1].0) * -sin + (v[0].1 - v[1].1) * cos;
        let across = (v[0].0 - v[1].0) * cos + (v[0].1 - v[1].1) * sin;
        assert!(across.abs() < 1e-15, "they do not enter each other: {across}");
        near(pair.sliding(i), along.abs());
    }
    let [tangential, radial, normal] = pair.forces();
    near((tangential * tangential + radial * radial).sqrt(), normal);
    near(tangential * 0.5 * pair.gears[0].dw, 1.0);
}

#[test]
fn teeth_that_do_not_run_together_are_found() {
    let faults = |teeth| GearPair::new(teeth).unwrap().faults();
    assert_eq!(faults(teeth([18.0, 42.0], 0.016, [0.0; 2], false)), []);
    let undercut = faults(teeth([12.0, 42.0], 0.002, [0.0; 2], false));
    assert!(matches!(undercut[..], [GearFault::Undercut { wheel: 0, .. }]), "{undercut:?}");
    let pointed = faults(teeth([18.0, 42.0], 0.002, [1.2, -1.2], false));
    assert!(pointed.iter().any(|f| matches!(f, GearFault::Pointed { wheel: 0, .. })), "{pointed:?}");
    // pinion angles: the ring's of the reference times z2/z1
    for (z_1, z_2, gap) in [
        (40.0, 46.0, Some(-0.006490203463097519)),
        (40.0, 48.0, Some(-0.000262865472602368)),
        (40.0, 49.0, None),
        (60.0, 67.0, Some(-0.001857162799084662)),
        (60.0, 69.0, None),
        (90.0, 98.0, None),
    ] {
        let found = faults(teeth([z_1, z_2], 0.002, [0.0; 2], true));
        let overlap =
            found.iter().find_map(|f| if let GearFault::Overlap { gap } = f { Some(gap) } else { None });
        match (gap, overlap) {
            (None, None) => {}
            // the reference looks at 20000 positions of a turn
            (Some(expected), Some(gap)) => {
                assert!((gap * z_1 / z_2 - expected).abs() < 1e-4, "{z_1} {z_2}: {gap}")
            }
            _ => panic!("{z_1} {z_2}: {found:?}"),
        }
    }
    // the tip of an unshifted ring reaches below the involutes of a pinion of 20 teeth: on the line of contact its place is
    // at √(r_a2² − r_b2²) − a sin α = √(58² − 56.3816²) − 40 sin 20° = −0.076 mm from the end of the pinion's flank
    let deep = faults(teeth([20.0, 60.0], 0.002, [0.0; 2], true));
    let [GearFault::Tip { wheel: 0, reached, .. }] = deep[..] else { panic!("{deep:?}") };
    let (base, sin) = (60.0 * 20.0_f64.to_radians().cos(), 20.0_f64.to_radians().sin());
    let expected = (58.0_f64.powi(2) - base * base).sqrt() - 40.0 * sin;
    assert!((reached * 1e3 - expected).abs() < 1e-12, "{reached} {expected}");
    assert_eq!(faults(teeth([20.0, 60.0], 0.002, [0.2, 0.6], true)), []);
    let inside = faults(teeth([20.0, 30.0], 0.002, [0.0; 2], true));
    assert!(matches!(inside[..], [GearFault::RingTip { .. }]), "{inside:?}");
    assert!(GearPair::new(teeth([18.0, 42.0], 0.002, [-1.0, -1.0], false)).is_err());
}
