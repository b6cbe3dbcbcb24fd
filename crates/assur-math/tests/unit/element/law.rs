//! Laws of motion of cams.

use assur_math::element::cam::Law;
use assur_math::element::search::greatest;
use std::f64::consts::PI;

const LAWS: [Law; 8] = [
    Law::Uniform,
    Law::Parabolic,
    Law::Harmonic,
    Law::Cycloidal,
    Law::Poly345,
    Law::Poly4567,
    Law::ModifiedTrapezoid,
    Law::ModifiedSine,
];

#[test]
fn every_law_goes_from_nothing_to_one_and_is_antisymmetric() {
    for law in LAWS {
        assert_eq!(law.at(0.0)[0], 0.0, "{law:?}");
        assert!((law.at(1.0)[0] - 1.0).abs() < 1e-15, "{law:?}");
        assert!((law.at(0.5)[0] - 0.5).abs() < 1e-15, "{law:?}");
        for i in 1..50 {
            let x = f64::from(i) / 50.0 + 1e-3;
            let (a, b) = (law.at(x), law.at(1.0 - x));
            let off = [a[0] + b[0] - 1.0, a[1] - b[1], a[2] + b[2], a[3] - b[3]];
            assert!(off.iter().all(|o| o.abs() < 1e-12), "{law:?} at {x}: {off:?}");
        }
    }
}

/// Each derivative against a difference of eighth order of the one before it, inside every part.
#[test]
fn derivatives_are_those_of_the_way() {
    const C: [f64; 4] = [4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0];
    let h = 2e-3;
    for law in LAWS {
        for (part, ends) in law.joints().windows(2).enumerate() {
            for i in 0..=40 {
                let x = ends[0] + 4.5 * h + (ends[1] - ends[0] - 9.0 * h) * f64::from(i) / 40.0;
                for n in 0..3 {
                    let slope: f64 = (1..=4)
                        .map(|k| {
                            let d = f64::from(k) * h;
                            let (r, l) = (law.on_part(part, x + d)[n], law.on_part(part, x - d)[n]);
                            C[k as usize - 1] * (r - l) / h
                        })
                        .sum();
                    let got = law.on_part(part, x)[n + 1];
                    assert!(
                        (slope - got).abs() < 2e-10 * (1.0 + got.abs()),
                        "{law:?} {n} at {x}: {slope} {got}"
                    );
                }
            }
        }
    }
}

#[test]
fn joints_are_as_smooth_as_promised() {
    for law in LAWS {
        let joints = law.joints();
        for (i, &x) in joints.iter().enumerate().skip(1).take(joints.len() - 2) {
            let (before, behind) = (law.on_part(i - 1, x), law.on_part(i, x));
            let continuous = if law == Law::Parabolic { 2 } else { 3 };
            for n in 0..continuous {
                assert!((before[n] - behind[n]).abs() < 1e-13, "{law:?} {n} at {x}: {before:?} {behind:?}");
            }
        }
    }
    for law in [Law::Cycloidal, Law::Poly345, Law::Poly4567, Law::ModifiedTrapezoid, Law::ModifiedSine] {
        for x in [0.0, 1.0] {
            assert!(law.at(x)[1].abs() < 1e-14 && law.at(x)[2].abs() < 1e-14, "{law:?} starts at rest");
        }
    }
    assert!(Law::Poly4567.at(0.0)[3].abs() < 1e-14);
}

/// Greatest velocity and acceleration as tabulated by Norton, table 2-? (values derived: 15/8, 10/√3, 35/16, 84√5/25).
#[test]
fn peak_factors_are_those_of_the_handbook() {
    let peak = |law: Law, n: usize| {
        let each = law
            .joints()
            .windows(2)
            .enumerate()
            .map(|(part, e)| greatest(e[0], e[1], &|x| law.on_part(part, x)[n]).1);
        each.fold(0.0, f64::max)
    };
    let table = [
        (Law::Parabolic, 2.0, 4.0),
        (Law::Harmonic, PI / 2.0, PI * PI / 2.0),
        (Law::Cycloidal, 2.0, 2.0 * PI),
        (Law::Poly345, 15.0 / 8.0, 10.0 / 3.0_f64.sqrt()),
        (Law::Poly4567, 35.0 / 16.0, 84.0 * 5.0_f64.sqrt() / 25.0),
        (Law::ModifiedTrapezoid, 2.0, 8.0 * PI / (2.0 + PI)),
        (Law::ModifiedSine, 4.0 * PI / (4.0 + PI), 4.0 * PI * PI / (4.0 + PI)),
    ];
    for (law, v, a) in table {
        assert!((peak(law, 1) - v).abs() < 1e-13, "{law:?} {}", peak(law, 1));
        assert!((peak(law, 2) - a).abs() < 1e-12, "{law:?} {}", peak(law, 2));
    }
}
