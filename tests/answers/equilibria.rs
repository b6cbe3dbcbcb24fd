//! Equilibria against the potential energy: its slope is nothing there, and its curvature says whether they are stable.

use super::masses::within;
use libm::{cos, hypot, sin};

fn answers(text: &str, names: &[&str]) -> Result<Vec<assur::Quantity>, String> {
    let asked = format!("{text}find {}\n", names.join(", "));
    let solution = assur::solve(&asked).map_err(|e| e.to_string())?;
    let pose = &solution.poses()[0];
    Ok(names.iter().map(|name| pose[*name].si()).collect())
}

fn number(value: assur::Quantity) -> f64 {
    match value {
        assur::Quantity::Number(x) => x,
        _ => f64::NAN,
    }
}

fn holds(value: assur::Quantity) -> bool {
    value == assur::Quantity::Condition(true)
}

/// A bar of random mass on a random spring: the text, and the slope of its potential energy.
fn bar(state: &mut u64) -> (String, impl Fn(f64) -> f64 + use<>) {
    let (m, l) = (within(state, 1.0, 5.0), within(state, 0.5, 1.5));
    let (x, y) = (within(state, -1.0, 1.0), within(state, 1.0, 2.0));
    let (k, free) = (within(state, 20.0, 200.0), within(state, 0.1, 0.6));
    let text = format!(
        "gravity 9.81 m/s^2\nground {{ A (0, 0); E ({x} m, {y} m) }}\nlink bar A-B {l} m {{ S ({} m, 0); mass {m} kg at S }}\n\
         revolute A: ground - bar\nspring k: bar.B - ground.E {{ stiffness {k} N/m; free_length {free} m }}\n",
        l / 2.0
    );
    let slope = move |q: f64| {
        let (dx, dy) = (x - l * cos(q), y - l * sin(q));
        let d = hypot(dx, dy);
        let turned = (dx * l * sin(q) - dy * l * cos(q)) / d;
        m * 9.81 * l / 2.0 * cos(q) + k * (d - free) * turned
    };
    (text, slope)
}

/// All angles at which a slope is nothing, with that of the slope there.
fn roots(slope: impl Fn(f64) -> f64) -> Vec<(f64, bool)> {
    let n = 4000;
    let at = |i: i32| std::f64::consts::TAU * (f64::from(i) + 0.29) / f64::from(n) - std::f64::consts::PI;
    let mut found = Vec::new();
    for i in 0..n {
        let (mut a, mut b) = (at(i), at(i + 1));
        let (fa, fb) = (slope(a), slope(b));
        if fa.signum() != fb.signum() {
            for _ in 0..100 {
                let middle = 0.5 * (a + b);
                if slope(middle).signum() == fa.signum() { a = middle } else { b = middle }
            }
            found.push((0.5 * (a + b), fb > fa));
        }
    }
    found
}

/// Without whole turns.
fn apart(a: f64, b: f64) -> f64 {
    (a - b + std::f64::consts::PI).rem_euclid(std::f64::consts::TAU) - std::f64::consts::PI
}

#[test]
fn the_nearest_equilibrium_is_found_and_its_kind() {
    let mut state = 17;
    for _ in 0..120 {
        let (text, slope) = bar(&mut state);
        let near = within(&mut state, -3.0, 3.0);
        let wanted = roots(&slope);
        let by = |q: f64| apart(q, near).abs();
        let nearest =
            wanted.iter().copied().min_by(|a, b| by(a.0).total_cmp(&by(b.0))).expect("an equilibrium");
        let second =
            wanted.iter().map(|r| by(r.0)).filter(|d| *d > by(nearest.0)).fold(f64::INFINITY, f64::min);
        if second - by(nearest.0) < 1e-6 {
            continue;
        }
        let file = format!("{text}equilibrium bar near {near} rad\n");
        let found = answers(&file, &["angle(bar)", "stable()"]).unwrap_or_else(|e| panic!("{e}\n{file}"));
        let q = number(found[0]);
        assert!(apart(q, nearest.0).abs() < 1e-11, "{q} is not {}\n{file}", nearest.0);
        assert_eq!(holds(found[1]), nearest.1, "{file}");
    }
}

#[test]
fn all_equilibria_are_listed_with_their_kind() {
    let mut state = 23;
    let mut several = 0;
    for _ in 0..40 {
        let (text, slope) = bar(&mut state);
        let wanted = roots(&slope);
        let file = format!("{text}equilibrium bar\n");
        match answers(&file, &["angle(bar)"]) {
            Ok(found) => {
                assert_eq!(wanted.len(), 1, "{file}");
                assert!(apart(number(found[0]), wanted[0].0).abs() < 1e-11, "{file}");
            }
            Err(message) => {
                several += 1;
                assert_eq!(
                    message.matches("// stable").count(),
                    wanted.iter().filter(|r| r.1).count(),
                    "{message}"
                );
                assert_eq!(
                    message.matches("// unstable").count(),
                    wanted.iter().filter(|r| !r.1).count(),
                    "{message}"
                );
            }
        }
    }
    assert!(several > 20, "{several}");
}

/// Two bars in a chain, a spring from each end to the ground: gradient and curvature of the energy, by differences of the energy.
#[test]
fn two_coordinates_rest_where_the_energy_is_least() {
    let mut state = 29;
    let mut settled = 0;
    for _ in 0..60 {
        let (l1, l2) = (within(&mut state, 0.4, 0.8), within(&mut state, 0.4, 0.8));
        let (m1, m2) = (within(&mut state, 1.0, 3.0), within(&mut state, 1.0, 3.0));
        let springs = [0, 1].map(|_| {
            let at = (within(&mut state, 0.8, 1.6), within(&mut state, -0.5, 0.8));
            (at, within(&mut state, 100.0, 400.0), within(&mut state, 0.1, 0.3))
        });
        let energy = |q: [f64; 2]| {
            let b = (l1 * cos(q[0]), l1 * sin(q[0]));
            let c = (b.0 + l2 * cos(q[1]), b.1 + l2 * sin(q[1]));
            let spring = |p: (f64, f64), (at, k, free): ((f64, f64), f64, f64)| {
                k / 2.0 * (hypot(p.0 - at.0, p.1 - at.1) - free).powi(2)
            };
            9.81 * (m1 * b.1 / 2.0 + m2 * (b.1 + c.1) / 2.0) + spring(b, springs[0]) + spring(c, springs[1])
        };
        // the least energy by descent
        let mut q = [0.3, 0.1];
        let h = 1e-4;
        let gradient = |q: [f64; 2]| {
            [0, 1].map(|i| {
                let at = |s: f64| {
                    let mut moved = q;
                    moved[i] += s;
                    energy(moved)
                };
                (8.0 * (at(h) - at(-h)) - (at(2.0 * h) - at(-2.0 * h))) / (12.0 * h)
            })
        };
        for _ in 0..20_000 {
            let g = gradient(q);
            q = [q[0] - 5e-4 * g[0], q[1] - 5e-4 * g[1]];
        }
        let [(p1, k1, f1), (p2, k2, f2)] = springs;
        let file = format!(
            "gravity 9.81 m/s^2\nground {{ A (0, 0); E ({} m, {} m); F ({} m, {} m) }}\nlink one A-B {l1} m {{ S ({} m, 0); mass {m1} kg at \
             S }}\nlink two B-C {l2} m {{ S ({} m, 0); mass {m2} kg at S }}\nrevolute A: ground - one\nrevolute B: one - two\nspring s: \
             one.B - ground.E {{ stiffness {k1} N/m; free_length {f1} m }}\nspring t: two.C - ground.F {{ stiffness {k2} N/m; free_length \
             {f2} m }}\nequilibrium one near {} rad, two near {} rad\n",
            p1.0,
            p1.1,
            p2.0,
            p2.1,
            l1 / 2.0,
            l2 / 2.0,
            q[0] + 0.02,
            q[1] - 0.02
        );
        let found = answers(&file, &["angle(one)", "angle(two)", "stable()"])
            .unwrap_or_else(|e| panic!("{e}\n{file}"));
        let found_at = [number(found[0]), number(found[1])];
        let g = gradient(found_at);
        assert!(g[0].abs() < 1e-7 && g[1].abs() < 1e-7, "{g:?}\n{file}");
        if apart(found_at[0], q[0]).abs() < 1e-4 && apart(found_at[1], q[1]).abs() < 1e-4 {
            settled += 1;
            assert!(holds(found[2]), "{file}");
        }
    }
    assert!(settled > 50, "{settled}");
}

#[test]
fn the_words_stay_names() {
    let text = "given equilibrium = 1 m\nlet stable = 2*equilibrium\nground { A (0, 0); E (0, stable) }\nlink bar A-B equilibrium { S (0.5 m, 0); \
                mass 4 kg at S }\ngravity 9.81 m/s^2\nrevolute A: ground - bar\nspring k: bar.B - ground.E { stiffness 60 N/m; \
                free_length 0.4 m }\nequilibrium bar near 60 deg\n";
    let found = answers(text, &["stable", "stable()"]).unwrap();
    assert_eq!(number(found[0]), 2.0);
    assert!(!number(found[1]).is_finite());
    let text = text
        .replace("given equilibrium = 1 m\nlet stable = 2*equilibrium\n", "")
        .replace("(0, stable)", "(0, 2 m)");
    let text = text.replace("A-B equilibrium", "A-B 1 m").replace("bar", "equilibrium");
    assert!(answers(&text, &["angle(equilibrium)"]).is_ok(), "{text}");
}

/// A sweep of another drive: each position is the equilibrium of its own file.
#[test]
fn an_equilibrium_follows_another_drive() {
    let file = |drive: &str, near: &str| {
        format!(
            "gravity 9.81 m/s^2\nground {{ A (0, 0); line post through A along 90 deg }}\nlink block {{ E (0, 0) }}\nlink bar A-B 1 m {{ S (0.5 \
             m, 0); mass 4 kg at S }}\nrevolute A: ground - bar\nprismatic H: block.E - ground.post\nspring k: bar.B - block.E {{ stiffness 60 \
             N/m; free_length 0.4 m }}\n{drive}\nequilibrium bar near {near}\nfind angle(bar), effort(H)\n"
        )
    };
    let swept = assur::solve(file("drive H = 1.2 m .. 1.5 m in 6 steps", "60 deg")).unwrap();
    assert_eq!(swept.poses().len(), 7);
    for (i, pose) in swept.poses().iter().enumerate() {
        let height = 1.2 + 0.05 * i as f64;
        let q = number(pose["angle(bar)"].si());
        let alone = assur::solve(file(&format!("drive H = {height} m"), &format!("{q} rad"))).unwrap();
        for name in ["angle(bar)", "effort(H)"] {
            let (a, b) = (number(pose[name].si()), number(alone.poses()[0][name].si()));
            assert!((a - b).abs() < 1e-10 * b.abs().max(1.0), "{name} at {height}: {a} is not {b}");
        }
    }
}

/// A motion that starts in equilibrium stays there, and swings about it with √(K/J).
#[test]
fn a_motion_starts_in_equilibrium() {
    let file = |rate: &str| {
        format!(
            "gravity 9.81 m/s^2\nground {{ A (0, 0); E (0, 1.2 m) }}\nlink bar A-B 1 m {{ S (0.5 m, 0); mass 4 kg at S inertia \
             0.3333333333333333 kg*m^2 }}\nrevolute A: ground - bar\nspring k: bar.B - ground.E {{ stiffness 60 N/m; free_length 0.4 m \
             }}\nequilibrium bar near 60 deg{rate}\nsimulate 0 s .. 3 s in 3 steps\nevent top: omega(bar) = 0 rad/s falling\nfind \
             angle(bar) as deg\n"
        )
    };
    let still = assur::solve(file("")).unwrap();
    for pose in still.poses() {
        assert!((number(pose["angle(bar)"].si()).to_degrees() - 62.961_812_046_662).abs() < 1e-9);
    }
    let text = file(" at 1e-4 rad/s").replace("find", "find time(top), time(top, 2), ");
    let swinging = assur::solve(&text).unwrap();
    let pose = &swinging.poses()[0];
    let period = number(pose["time(top, 2)"].si()) - number(pose["time(top)"].si());
    assert!((std::f64::consts::TAU / period - 5.676_640_638_119_8).abs() < 1e-6, "{period}");
}

#[test]
fn frequencies_follow_from_the_curvature() {
    let mut state = 41;
    for _ in 0..40 {
        let (text, slope) = bar(&mut state);
        let Some((q, _)) = roots(&slope).into_iter().find(|root| root.1) else { continue };
        let inertia = within(&mut state, 0.0, 0.5);
        let text = text.replace("at S }", &format!("at S; inertia {inertia} kg*m^2 }}"));
        let file = format!("{text}equilibrium bar near {q} rad\n");
        let found = answers(&file, &["natural_frequency(1)", "inertia(bar, A)", "damping_ratio(1)"])
            .unwrap_or_else(|e| panic!("{e}\n{file}"));
        let h = 1e-3;
        let curvature =
            (8.0 * (slope(q + h) - slope(q - h)) - (slope(q + 2.0 * h) - slope(q - 2.0 * h))) / (12.0 * h);
        let wanted = (curvature / number(found[1])).sqrt();
        assert!(
            (number(found[0]) - wanted).abs() < 1e-8 * wanted,
            "{} is not {wanted}\n{file}",
            number(found[0])
        );
        assert!(number(found[2]).abs() < 1e-12, "{file}");
    }
}

/// Two masses on one rail: the values with dampers are roots of the characteristic equation of the fourth degree.
#[test]
fn damped_vibrations_solve_the_characteristic_equation() {
    let mut state = 43;
    for _ in 0..40 {
        let [m1, m2] = [0, 1].map(|_| within(&mut state, 0.5, 3.0));
        let [k1, k2, k3] = [0, 1, 2].map(|_| within(&mut state, 100.0, 500.0));
        let [c1, c2, c3] = [0, 1, 2].map(|_| within(&mut state, 0.1, 3.0));
        let file = format!(
            "ground {{ O (0, 0); W (3 m, 0); line rail through O along 0 deg }}\nlink one {{ P (0, 0); mass {m1} kg at P }}\nlink two {{ P (0, \
             0); mass {m2} kg at P }}\nprismatic P1: one.P - ground.rail\nprismatic P2: two.P - ground.rail\nspring s: ground.O - one.P {{ \
             stiffness {k1} N/m; free_length 1 m; damping {c1} N*s/m }}\nspring t: one.P - two.P {{ stiffness {k2} N/m; free_length 1 m; \
             damping {c2} N*s/m }}\nspring u: two.P - ground.W {{ stiffness {k3} N/m; free_length 1 m; damping {c3} N*s/m }}\nequilibrium P1 \
             near 1 m, P2 near 2 m\n"
        );
        let names = ["natural_frequency(1)", "natural_frequency(2)"];
        let [a, b] = [(k1 + k2) / m1, (k2 + k3) / m2];
        let root = (((a - b) / 2.0).powi(2) + k2 * k2 / (m1 * m2)).sqrt();
        let found = answers(&file, &names).unwrap_or_else(|e| panic!("{e}\n{file}"));
        for (found, square) in found.into_iter().zip([(a + b) / 2.0 - root, (a + b) / 2.0 + root]) {
            assert!((number(found) - square.sqrt()).abs() < 1e-9 * square.sqrt(), "{file}");
        }
        for i in 1..=2 {
            let names = [format!("damping_ratio({i})"), format!("damped_frequency({i})")];
            let found = answers(&file, &names.each_ref().map(String::as_str)).unwrap();
            let (zeta, damped) = (number(found[0]), number(found[1]));
            let (re, im) = (-zeta * damped / (1.0 - zeta * zeta).sqrt(), damped);
            let square = (re * re - im * im, 2.0 * re * im);
            // m λ² + c λ + k
            let of = |m: f64, c: f64, k: f64| (m * square.0 + c * re + k, m * square.1 + c * im);
            let (p, q, r) = (of(m1, c1 + c2, k1 + k2), of(m2, c2 + c3, k2 + k3), of(0.0, c2, k2));
            let product = |a: (f64, f64), b: (f64, f64)| (a.0 * b.0 - a.1 * b.1, a.0 * b.1 + a.1 * b.0);
            let (x, y) = (product(p, q), product(r, r));
            let left = hypot(x.0 - y.0, x.1 - y.1);
            assert!(left < 1e-7 * (k1 + k2) * (k2 + k3), "{left}\n{file}");
        }
    }
}
