//! Fourier series and shaking forces against sums over equally spaced positions, closed forms, each mass, and the frame.

use super::masses::within;
use super::quick_rows::random;
use std::f64::consts::{PI, TAU};
use std::fmt::Write;

/// A link with a mass centre of its own.
struct Heavy {
    name: &'static str,
    m: f64,
    j: f64,
}

/// A mechanism whose crank turns fully, with the pairs of its frame: their names, points, and the link there.
struct Machine {
    text: String,
    links: Vec<Heavy>,
    frame: Vec<(&'static str, [f64; 2], &'static str)>,
    slides: bool,
}

fn machine(state: &mut u64) -> Machine {
    let slides = random(state) < 0.5;
    let names = if slides { ["crank", "rod", "piston"] } else { ["crank", "rod", "rocker"] };
    let links: Vec<Heavy> = names
        .into_iter()
        .map(|name| Heavy { name, m: within(state, 0.2, 5.0), j: within(state, 0.001, 0.3) })
        .collect();
    let mass = |state: &mut u64, link: &Heavy| {
        let at = [within(state, -0.2, 0.4), within(state, -0.2, 0.2)];
        format!("{{ S ({} m, {} m); mass {} kg at S; inertia {} kg*m^2 }}", at[0], at[1], link.m, link.j)
    };
    let (r, l) = (within(state, 0.06, 0.12), within(state, 0.4, 0.6));
    let [crank, rod, last] = [0, 1, 2].map(|i| mass(state, &links[i]));
    let mut text = String::new();
    let a = [within(state, -0.3, 0.3), within(state, -0.3, 0.3)];
    let mut frame = vec![("A", a, "crank")];
    if slides {
        let off = within(state, -0.05, 0.05);
        let last = last.replacen('{', "{ C (0, 0);", 1);
        let _ = write!(
            text,
            "ground {{ A ({} m, {} m); P ({} m, {} m); line guide through P along 0 deg }}\nlink crank A-B {r} m {crank}\n\
             link rod B-C {l} m {rod}\nlink piston {last}\nprismatic G: piston.C - ground.guide\nrevolute C: rod - piston\n\
             assemble C ahead of B\n",
            a[0],
            a[1],
            a[0],
            a[1] + off
        );
    } else {
        let (base, rocker) = (within(state, 0.4, 0.5), within(state, 0.4, 0.6));
        let d = [a[0] + base, a[1]];
        frame.push(("D", d, "rocker"));
        let _ = write!(
            text,
            "ground {{ A ({} m, {} m); D ({} m, {} m) }}\nlink crank A-B {r} m {crank}\nlink rod B-C {l} m {rod}\n\
             link rocker D-C {rocker} m {last}\nrevolute C: rod - rocker\nrevolute D: ground - rocker\nassemble C left of B-D\n",
            a[0], a[1], d[0], d[1]
        );
    }
    text += "revolute A: ground - crank\nrevolute B: crank - rod\nbalance torque M on crank\n";
    Machine { text, links, frame, slides }
}

#[test]
fn harmonics_are_sums_over_equally_spaced_positions() {
    let mut state = 20_261_127;
    for case in 0..200 {
        let Machine { text, .. } = machine(&mut state);
        let (from, turns) = (within(&mut state, -90.0, 90.0).round(), if case % 3 == 0 { -2 } else { 1 });
        let count = 128 * i32::abs(turns);
        let to = from + 360.0 * f64::from(turns);
        let x = ["M", "shaking_force().x", "acceleration(rod.S).y", "omega(rod)"][case % 4];
        // of two turns also halves
        let order = f64::from(1 + (random(&mut state) * 6.0) as u32) / if turns == 1 { 1.0 } else { 2.0 };
        let parts = ["cos", "sin", "amplitude", "phase"].map(|part| {
            let unit = if part == "phase" { " as rad" } else { "" };
            format!("{part} = fourier({x}, {order}).{part}{unit}")
        });
        let file = format!(
            "{text}drive crank = {from} deg .. {to} deg in {count} steps at 300 rpm\nfind x = {x}, {}\n",
            parts.join(", ")
        );
        let file = file.replace("cos =", "c_n =").replace("sin =", "s_n =");
        let solution = assur::solve(&file).unwrap_or_else(|e| panic!("{e}\n{file}"));
        let poses = solution.poses();
        assert_eq!(poses.len(), count as usize, "{file}");
        let (mut sum, mut most) = ([0.0; 2], 0.0_f64);
        for (i, pose) in poses.iter().enumerate() {
            let value = pose["x"].number().expect("a number");
            let phi = from.to_radians() + TAU * f64::from(turns) * i as f64 / f64::from(count);
            let weights = [libm::cos(order * phi), libm::sin(order * phi)];
            sum = [0, 1].map(|k| sum[k] + 2.0 * value * weights[k] / f64::from(count));
            most = most.max(value.abs());
        }
        let value = |name: &str| solution[name].number().expect("a number");
        let near = |name: &str, wanted: f64, scale: f64| {
            let found = value(name);
            assert!((found - wanted).abs() <= 1e-11 * scale, "{name}: {found} is not {wanted}\n{file}");
        };
        near("c_n", sum[0], most);
        near("s_n", sum[1], most);
        near("amplitude", libm::hypot(sum[0], sum[1]), most);
        if libm::hypot(sum[0], sum[1]) > 1e-3 * most {
            let apart = (value("phase") - libm::atan2(sum[1], sum[0])) / TAU;
            assert!((apart - apart.round()).abs() < 1e-8, "the phase\n{file}");
        }
    }
}

#[test]
fn shaking_forces_are_those_of_each_mass_and_those_of_the_frame() {
    let mut state = 7;
    for _ in 0..200 {
        let Machine { text, links, frame, slides } = machine(&mut state);
        let angle = within(&mut state, 0.0, 360.0);
        let mut names = vec!["shaking_moment()".to_owned(), "shaking_moment(A)".to_owned(), "M".to_owned()];
        let both = |name: &str| ["x", "y"].map(|axis| format!("{name}.{axis}"));
        names.extend(both("shaking_force()"));
        for link in &links {
            names.extend(both(&format!("position({}.S)", link.name)));
            names.extend(both(&format!("acceleration({}.S)", link.name)));
            names.push(format!("alpha({})", link.name));
        }
        for (pair, _, link) in &frame {
            names.extend(both(&format!("reaction({pair}, {link})")));
        }
        if slides {
            names.extend(both("reaction(G, piston)"));
            names.extend(both("position(piston.C)"));
            names.push("moment(G, piston)".to_owned());
        }
        let asked = format!(
            "{text}drive crank = {angle} deg at 20 rad/s accelerating 30 rad/s^2\nfind {}\n",
            names.join(", ")
        );
        let solution = assur::solve(&asked).unwrap_or_else(|e| panic!("{e}\n{asked}"));
        let pose = &solution.poses()[0];
        let mut known = names.iter().map(|name| pose[name.as_str()].number().expect("a number"));
        let mut next = || known.next().expect("as many as asked");
        let [moment, about, torque, x, y] = [next(), next(), next(), next(), next()];
        let (mut own, mut scale) = ([0.0; 3], 0.0_f64);
        for link in &links {
            let [sx, sy, ax, ay, alpha] = [next(), next(), next(), next(), next()];
            let turned = link.m * (sx * ay - sy * ax) + link.j * alpha;
            own = [own[0] - link.m * ax, own[1] - link.m * ay, own[2] - turned];
            scale = scale.max(link.m * libm::hypot(ax, ay)).max(turned.abs());
        }
        let mut on_frame = [0.0, 0.0, -torque];
        let mut add = |[rx, ry]: [f64; 2], at: [f64; 2]| {
            on_frame = [on_frame[0] - rx, on_frame[1] - ry, on_frame[2] - (at[0] * ry - at[1] * rx)];
            scale = scale.max(libm::hypot(rx, ry));
        };
        for (_, at, _) in &frame {
            add([next(), next()], *at);
        }
        if slides {
            let force = [next(), next()];
            add(force, [next(), next()]);
            on_frame[2] -= next();
        }
        let [ax, ay] = frame[0].1;
        let near = |found: f64, wanted: f64, what: &str| {
            assert!((found - wanted).abs() <= 1e-11 * scale, "{what}: {found} is not {wanted}\n{asked}");
        };
        for (wanted, what) in [(own, "masses"), (on_frame, "frame")] {
            near(x, wanted[0], what);
            near(y, wanted[1], what);
            near(moment, wanted[2], what);
            near(about, wanted[2] - (ax * wanted[1] - ay * wanted[0]), what);
        }
    }
}

const CRANK: &str = "ground { A (0, 0) }\nlink crank A-B 100 mm\nrevolute A: ground - crank\n";

fn of_crank(sweep: &str, asked: &str) -> f64 {
    let file = format!("{CRANK}drive crank = {sweep} at 1 rad/s\nfind y = {asked}\n");
    let solution = assur::solve(&file).unwrap_or_else(|e| panic!("{e}\n{file}"));
    solution["y"].number().expect("a number")
}

#[test]
fn corners_and_jumps_cost_no_digits() {
    let turn = "0 deg .. 360 deg in 12 steps";
    let cases = [
        // |sin φ| = 2/π − (4/π) Σ cos 2kφ/(4k² − 1)
        (turn, "fourier(abs(sin(angle(crank))), 2).cos", -4.0 / (3.0 * PI)),
        (turn, "fourier(abs(sin(angle(crank))), 40).cos", -4.0 / (1599.0 * PI)),
        (turn, "fourier(max(sin(angle(crank)), 0), 1).sin", 0.5),
        // a saw tooth: the angle does not come again
        (turn, "fourier(angle(crank)/(1 rad), 3).sin", -2.0 / 3.0),
        (turn, "fourier(angle(crank)/(1 rad), 3).cos", 0.0),
        ("0 deg .. 720 deg in 12 steps", "fourier(angle(crank)/(1 rad), 1/2).sin", -4.0),
        // a high order of a smooth quantity is not that of low order
        (turn, "fourier(exp(cos(angle(crank))), 16).cos", 1.469_417_8e-18),
        (turn, "fourier(cos(100*angle(crank)), 100).cos", 1.0),
        ("360 deg .. 0 deg in 12 steps", "fourier(sin(angle(crank)), 1).sin", 1.0),
        (turn, "fourier(3, 1).amplitude", 0.0),
    ];
    for (sweep, asked, wanted) in cases {
        let found = of_crank(sweep, asked);
        assert!((found - wanted).abs() < 1e-13, "{asked}: {found} is not {wanted}");
    }
}

#[test]
fn a_steady_motion_has_the_harmonics_of_its_period() {
    let text = "ground { O (0, 0); line way through O along 0 deg }\nlink mass { P (0, 0); mass 1 kg at P }\nprismatic G: \
                mass.P - ground.way\nlet x = displacement(G)/(1 m)\nforce F on mass at P = ((1 - x^2)*1 \
                N*s/m*relative_velocity(G) - 1 N/m*displacement(G), 0 N)\nstart G = 2 m\nevent down: displacement(G) = 0 m \
                falling\nsimulate steady cycle of down in 8 steps within 1e-10\n";
    let solution = assur::solve(format!("{text}find T = period()\n")).expect("it is solved");
    let period = solution["T"].number().expect("a number");
    for n in [1, 3, 9] {
        let names = [
            format!("fourier(x, {n}).cos"),
            format!("2*mean(x*cos({n}*2*pi*time/({period} s)))"),
            format!("fourier(x, {n}).sin"),
            format!("2*mean(x*sin({n}*2*pi*time/({period} s)))"),
        ];
        let file = format!("{text}find {}\n", names.join(", "));
        let solution = assur::solve(&file).unwrap_or_else(|e| panic!("{e}\n{file}"));
        let value = |i: usize| solution[names[i].as_str()].number().expect("a number");
        for i in [0, 2] {
            assert!((value(i) - value(i + 1)).abs() < 2e-9, "{}: {} {}", names[i], value(i), value(i + 1));
        }
    }
}

#[test]
fn names_of_the_functions_stay_names() {
    for word in ["fourier", "shaking_force", "shaking_moment"] {
        let text = format!(
            "given {word} = 3 kg\nground {{ A (0, 0) }}\nlink {word} A-B 0.8 m {{ mass {word} at B }}\nrevolute A: ground - \
             {word}\ndrive {word} = 0 deg .. 360 deg in 4 steps at 2 rad/s\nfind {word}, fourier(angle({word}), 1).sin, \
             shaking_force(), shaking_moment()\n"
        );
        assur::solve(&text).unwrap_or_else(|e| panic!("{e}\n{text}"));
        let curve = format!(
            "curve {word} {{\n  t [m], p [N]\n  0, 0\n  1, 10\n}}\nground {{ A (0, 0) }}\nlink arm A-B 0.8 m\nrevolute A: ground \
             - arm\ndrive arm = 0 deg\nfind y = {word}(position(arm.B).x)\n"
        );
        let solution = assur::solve(&curve).unwrap_or_else(|e| panic!("{e}"));
        let value = solution.poses()[0]["y"].number().expect("a value");
        assert!((value - 8.0).abs() < 1e-9, "{word}");
    }
}
