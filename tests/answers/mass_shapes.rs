//! Masses with a shape against the same masses cut into pieces whose centre and moment of inertia need no formula of the shape.

use super::masses::{values, within};
use super::quick_rows::random;
use std::f64::consts::{PI, TAU};
use std::fmt::Write;

/// A piece of mass: kg, its place in m, its own moment of inertia in kg m².
type Piece = (f64, [f64; 2], f64);

const PLACES: [&str; 4] = ["x", "y", "z", "w"];

/// Points on a circle about a place, evenly, each with its part of a mass.
fn around(m: f64, at: [f64; 2], radius: f64) -> Vec<Piece> {
    let turn = |i: usize| TAU * i as f64 / 8.0;
    (0..8)
        .map(|i| (m / 8.0, [at[0] + radius * libm::cos(turn(i)), at[1] + radius * libm::sin(turn(i))], 0.0))
        .collect()
}

/// The radii and weights by which an integral from 0 to 1 of a polynomial to the fifth degree is exact (Gauss and Legendre).
fn nodes() -> [(f64, f64); 3] {
    let d = 0.6_f64.sqrt() / 2.0;
    [(0.5 - d, 5.0 / 18.0), (0.5, 4.0 / 9.0), (0.5 + d, 5.0 / 18.0)]
}

/// A disc of a mass per area as rings.
fn disc(density: f64, at: [f64; 2], inner: f64, radius: f64) -> Vec<Piece> {
    let width = radius - inner;
    let ring = |(node, weight): (f64, f64)| {
        let r = inner + width * node;
        around(density * TAU * r * width * weight, at, r)
    };
    nodes().into_iter().flat_map(ring).collect()
}

fn sphere(density: f64, at: [f64; 2], radius: f64) -> Vec<Piece> {
    let slice = |(node, weight): (f64, f64)| {
        let z = radius * node;
        // both halves
        let thick = 2.0 * radius * weight;
        disc(density * thick, at, 0.0, (radius * radius - z * z).sqrt())
    };
    nodes().into_iter().flat_map(slice).collect()
}

/// A triangle as masses in the middles of its sides, which has all its moments to the second.
fn triangle(density: f64, corners: [[f64; 2]; 3]) -> Vec<Piece> {
    let [a, b, c] = corners;
    let area = ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2.0;
    let middle = |a: [f64; 2], b: [f64; 2]| [(a[0] + b[0]) / 2.0, (a[1] + b[1]) / 2.0];
    [middle(a, b), middle(b, c), middle(c, a)].map(|at| (density * area / 3.0, at, 0.0)).into()
}

/// A member with a shape, the points that it names, and its pieces.
fn shape(state: &mut u64, name: &str) -> (String, Vec<Piece>) {
    let at = [within(state, -0.4, 0.8), within(state, -0.4, 0.4)];
    let radius = within(state, 0.05, 0.3);
    let mut text = format!("{name}{} ({} m, {} m); ", PLACES[0], at[0], at[1]);
    let kind = (random(state) * 5.0) as usize;
    // 0: the whole, 1: per length or area, 2: per volume
    let given = (random(state) * 3.0) as usize;
    let value = within(state, 0.3, 5.0);
    let across = within(state, 0.01, 0.5);
    let (size, per, member, third, unit_pieces): (f64, usize, String, &str, Vec<Piece>) = match kind {
        0 => {
            let to = [at[0] + within(state, 0.1, 0.5), at[1] + within(state, -0.3, 0.3)];
            let _ = write!(text, "{name}y ({} m, {} m); ", to[0], to[1]);
            let l = libm::hypot(to[0] - at[0], to[1] - at[1]);
            let along = |t: f64| [at[0] + t * (to[0] - at[0]), at[1] + t * (to[1] - at[1])];
            let pieces = nodes().map(|(t, weight)| (l * weight, along(t), 0.0)).into();
            (l, 1, format!("rod {name}x to {name}y"), "section", pieces)
        }
        1 => {
            let inner = radius * within(state, 0.1, 0.9);
            let size = PI * (radius * radius - inner * inner);
            let member = format!("disc centre {name}x radius {radius} m inner {inner} m");
            (size, 2, member, "thickness", disc(1.0, at, inner, radius))
        }
        2 => {
            let size = TAU * radius;
            (size, 1, format!("ring centre {name}x radius {radius} m"), "section", around(size, at, radius))
        }
        3 => {
            let size = 4.0 / 3.0 * PI * radius.powi(3);
            (size, 3, format!("sphere centre {name}x radius {radius} m"), "", sphere(1.0, at, radius))
        }
        _ => {
            // a star about the place, in either sense
            let count = 4;
            let corner = |state: &mut u64, i: usize| {
                let angle = TAU * (i as f64 + within(state, 0.0, 0.8)) / count as f64;
                let r = within(state, 0.05, 0.3);
                [at[0] + r * libm::cos(angle), at[1] + r * libm::sin(angle)]
            };
            let corners: Vec<[f64; 2]> = (0..count).map(|i| corner(state, i)).collect();
            for (letter, p) in ["a", "b", "c", "d"].iter().zip(&corners) {
                let _ = write!(text, "{name}{letter} ({} m, {} m); ", p[0], p[1]);
            }
            let next = |i: usize| corners[(i + 1) % count];
            let pieces: Vec<Piece> =
                (0..count).flat_map(|i| triangle(1.0, [at, corners[i], next(i)])).collect();
            let order = if random(state) < 0.5 { "abcd" } else { "dcba" };
            let names: Vec<String> = order.chars().map(|c| format!("{name}{c}")).collect();
            (pieces.iter().map(|p| p.0).sum(), 2, format!("plate {}", names.join(", ")), "thickness", pieces)
        }
    };
    let (factor, unit, third) = match (given, per) {
        (0, _) => (1.0 / size, "kg".to_owned(), String::new()),
        (1, _) | (2, 3) => (1.0, format!("kg/m^{per}"), String::new()),
        _ => (across, "kg/m^3".to_owned(), format!(" {third} {across} m^{}", 3 - per)),
    };
    let (word, value_of, unit) = match random(state) < 0.3 {
        true => ("weight", value * 9.81, unit.replace("kg", "N")),
        false => ("mass", value, unit),
    };
    let _ = write!(text, "{word} {value_of} {unit} {member}{third}; ");
    (text, unit_pieces.into_iter().map(|(m, at, j)| (value * factor * m, at, j)).collect())
}

#[test]
fn shapes_are_the_sums_of_their_pieces() {
    let mut state = 20_261_128;
    for _ in 0..300 {
        let count = 1 + (random(&mut state) * 3.0) as usize;
        let shapes: Vec<_> = (0..count).map(|i| shape(&mut state, &format!("P{i}"))).collect();
        let members: String = shapes.iter().map(|(text, _)| text.as_str()).collect();
        let pieces: Vec<Piece> = shapes.into_iter().flat_map(|(_, pieces)| pieces).collect();
        let m: f64 = pieces.iter().map(|p| p.0).sum();
        let [x, y] = [0, 1].map(|k| pieces.iter().map(|p| p.0 * p.1[k]).sum::<f64>() / m);
        let about: f64 = pieces.iter().map(|(m, at, j)| j + m * (at[0] * at[0] + at[1] * at[1])).sum();
        let (alpha, omega) = (3.0, 7.0);
        let text = format!(
            "gravity 9.81 m/s^2\nground {{ A (0, 0) }}\nlink arm {{ A (0, 0); {members} }}\nrevolute A: ground - arm\n\
             drive arm = 0 deg at {omega} rad/s accelerating {alpha} rad/s^2\nbalance torque M on arm\n"
        );
        let asked = [
            "mass(arm)",
            "mass_centre(arm).x",
            "mass_centre(arm).y",
            "inertia(arm, A)",
            "M",
            "reaction(A, arm).x",
            "reaction(A, arm).y",
        ];
        let found = values(&text, &asked.map(str::to_owned));
        let wanted = [
            m,
            x,
            y,
            about,
            about * alpha + m * 9.81 * x,
            m * (-omega * omega * x - alpha * y),
            m * (-omega * omega * y + alpha * x + 9.81),
        ];
        let scale = wanted.iter().fold(1.0, |most: f64, x| most.max(x.abs()));
        for ((name, x), y) in asked.iter().zip(found).zip(wanted) {
            assert!((x - y).abs() <= 1e-12 * scale, "{name}: {x} is not {y}\n{text}");
        }
    }
}

#[test]
fn a_hole_takes_away_what_is_in_it() {
    let arm = |members: &str| {
        format!(
            "ground {{ A (0, 0) }}\nlink arm A-B 0.8 m {{ {members} }}\nrevolute A: ground - arm\ndrive arm = 0 deg\n"
        )
    };
    let asked = ["mass(arm)", "mass_centre(arm).x", "inertia(arm)"].map(str::to_owned);
    let cut = arm(
        "mass 3 kg/m^2 disc centre B radius 0.3 m; mass -3 kg/m^2 disc centre B radius 0.1 m; mass 1 kg at A",
    );
    let inner = arm("mass 3 kg/m^2 disc centre B radius 0.3 m inner 0.1 m; mass 1 kg at A");
    for (a, b) in values(&cut, &asked).into_iter().zip(values(&inner, &asked)) {
        assert!((a - b).abs() < 1e-15, "{a} is not {b}");
    }
}

/// Plates whose sides are on one line, touch nothing, and cross nothing.
#[test]
fn plates_may_have_bays() {
    let plate = |corners: &str, order: &str, turned: f64| {
        let points: String = corners
            .split(' ')
            .enumerate()
            .map(|(i, xy)| {
                let [x, y] =
                    [0, 1].map(|k| xy.split(',').nth(k).expect("two").parse::<f64>().expect("a number"));
                let (s, c) = (libm::sin(turned.to_radians()), libm::cos(turned.to_radians()));
                format!("P{i} ({} m, {} m); ", c * x - s * y, s * x + c * y)
            })
            .collect();
        let text = format!(
            "ground {{ P0 (0, 0) }}\nlink u {{ {points} mass 1 kg/m^2 plate {order} }}\nrevolute P0: ground - u\ndrive u = 0 deg\n"
        );
        assur::solve(format!("{text}find mass(u)\n"))
            .map(|s| s.poses()[0]["mass(u)"].number().expect("a number"))
    };
    // a U of three squares' arms, and a comb
    let u = "0,0 3,0 3,2 2,2 2,1 1,1 1,2 0,2";
    let all = "P0, P1, P2, P3, P4, P5, P6, P7";
    for i in 0..36 {
        let area = plate(u, all, f64::from(i) * 10.0).unwrap_or_else(|e| panic!("{e}"));
        assert!((area - 5.0).abs() < 1e-12, "{area}");
        assert!(plate(u, "P0, P2, P1, P3, P4, P5, P6, P7", f64::from(i) * 10.0 + 3.0).is_err());
    }
}

#[test]
fn words_of_shapes_stay_names() {
    for word in ["rod", "disc", "ring", "sphere", "plate", "inner", "thickness", "section"] {
        let text = format!(
            "given {word} = 0.4 m\nground {{ A (0, 0) }}\nlink {word}1 A-B {word} {{ {word} ({word}/2, 0); mass 2 kg at {word} }}\n\
             link b B-C 0.3 m {{ mass 3 kg rod B to C; mass 1 kg disc centre B radius {word} inner {word}/2 }}\n\
             revolute A: ground - {word}1\nrevolute B: {word}1 - b\ndrive {word}1 = 0 deg\ndrive b = 0 deg\n"
        );
        let asked = [word, "mass()"].map(str::to_owned);
        assert_eq!(values(&text, &asked), [0.4, 6.0], "{word}");
        let link = format!(
            "ground {{ A (0, 0) }}\nlink {word} A-B 0.4 m {{ S (0.2 m, 0); mass 2 kg at S }}\nrevolute A: ground - {word}\n\
             drive {word} = 0 deg at 2 rad/s\nlet x = mass({word})*2\n"
        );
        assert_eq!(values(&link, &["x".to_owned(), format!("omega({word})")]), [4.0, 2.0], "{word}");
    }
}

/// Rows that change a density, a radius or a point.
#[test]
fn rows_of_variants_have_their_own_shapes() {
    let rows: Vec<(f64, f64, f64)> = (0..40)
        .map(|i| {
            let x = f64::from(i);
            (20.0 + x, 0.1 + 0.002 * x, 0.5 + 0.01 * x)
        })
        .collect();
    let table = rows.iter().fold(String::new(), |text, (a, b, l)| text + &format!("  {a}, {b}, {l}\n"));
    let text = format!(
        "given rho = 1 kg/m^2\ngiven r = 1 m\ngiven l = 1 m\nvariants {{\n  rho [kg/m^2], r [m], l [m]\n{table}}}\n\
         ground {{ A (0, 0) }}\nlink arm A-B l {{ mass rho disc centre B radius r; mass 2 kg rod A to B }}\n\
         revolute A: ground - arm\ndrive arm = 90 deg at 2 rad/s\nfind inertia(arm, A)\n"
    );
    let solved = assur::Problem::new("rows.mech", text.as_str()).solve_variants().expect("rows");
    assert_eq!(solved.len(), rows.len());
    for (row, (rho, r, l)) in solved.iter().zip(rows) {
        let found = row.as_ref().expect("a row").poses()[0]["inertia(arm, A)"].number().expect("a number");
        let m = rho * PI * r * r;
        let wanted = m * (r * r / 2.0 + l * l) + 2.0 * l * l / 3.0;
        assert!((found - wanted).abs() < 1e-12, "{found} is not {wanted}");
    }
}
