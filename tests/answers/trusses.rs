//! Loads on pins and forces along bars: trusses by the method of joints, mechanisms with the load on either link of a pin.

use super::masses::{values, within};
use super::quick_rows::random;
use std::fmt::Write;

/// A truss: its pins, its bars as pairs of pins, a load on every pin. The first pin is hinged, the second rolls along x.
struct Truss {
    pins: Vec<[f64; 2]>,
    bars: Vec<[usize; 2]>,
    loads: Vec<[f64; 2]>,
}

/// A triangle, and pins on two bars each.
fn truss(state: &mut u64, more: f64) -> Truss {
    let mut pins = vec![[0.0, 0.0], [within(state, 2.0, 4.0), 0.0]];
    let mut bars = vec![[0, 1]];
    let count = 3 + (random(state) * more) as usize;
    while pins.len() < count {
        let (i, j) =
            ((random(state) * pins.len() as f64) as usize, (random(state) * pins.len() as f64) as usize);
        let at = [within(state, -1.0, 5.0), within(state, -2.0, 3.0)];
        let [a, b] = [i, j].map(|k: usize| [pins[k][0] - at[0], pins[k][1] - at[1]]);
        let sine = (a[0] * b[1] - a[1] * b[0]) / (libm::hypot(a[0], a[1]) * libm::hypot(b[0], b[1]));
        let apart = pins.iter().all(|p: &[f64; 2]| libm::hypot(p[0] - at[0], p[1] - at[1]) > 0.3);
        if i != j && sine.abs() > 0.3 && apart {
            bars.push([i, pins.len()]);
            bars.push([pins.len(), j]);
            pins.push(at);
        }
    }
    let loads = pins.iter().map(|_| [within(state, -5.0, 5.0), within(state, -5.0, 5.0)]).collect();
    Truss { pins, bars, loads }
}

/// The file, with the links of each pin in a random order; by lengths and places, or by the coordinates of all pins.
fn file(truss: &Truss, by_coordinates: bool, state: &mut u64) -> String {
    let names = |i: usize| char::from(b'A' + i as u8);
    let [x, y] = truss.pins[1];
    let mut text = format!("ground {{ A (0, 0); B ({x} m, {y} m); line floor through A along 0 deg }}\n");
    let mut ends: Vec<Vec<String>> = vec![Vec::new(); truss.pins.len()];
    ends[0].push("ground".to_owned());
    for (i, &[a, b]) in truss.bars.iter().enumerate() {
        let length = libm::hypot(truss.pins[b][0] - truss.pins[a][0], truss.pins[b][1] - truss.pins[a][1]);
        let _ = if by_coordinates {
            let point = |k: usize| format!("{} ({} m, {} m)", names(k), truss.pins[k][0], truss.pins[k][1]);
            writeln!(text, "link b{i} {{ {}; {} }}", point(a), point(b))
        } else {
            writeln!(text, "link b{i} {}-{} {length} m", names(a), names(b))
        };
        ends[a].push(format!("b{i}"));
        ends[b].push(format!("b{i}"));
    }
    for (i, ends) in ends.iter_mut().enumerate() {
        let by = (random(state) * ends.len() as f64) as usize;
        ends.rotate_left(by);
        let _ = writeln!(text, "revolute {}: {}", names(i), ends.join(" - "));
    }
    text += "slot Z: b0.B - ground.floor\n";
    let near =
        truss.pins.iter().enumerate().skip(1).map(|(i, [x, y])| format!("{} near ({x} m, {y} m)", names(i)));
    if !by_coordinates {
        let _ = writeln!(text, "assemble {}", near.collect::<Vec<_>>().join(", "));
    }
    for (i, [x, y]) in truss.loads.iter().enumerate() {
        let _ = writeln!(text, "force F{i} at {} = ({x} N, {y} N)", names(i));
    }
    text
}

/// The forces of the bars, of the hinge along x and y, of the roller: the equilibrium of all pins.
fn joints(truss: &Truss) -> Vec<f64> {
    let n = 2 * truss.pins.len();
    let mut rows = vec![vec![0.0; n + 1]; n];
    for (column, &[a, b]) in truss.bars.iter().enumerate() {
        let d = [0, 1].map(|k| truss.pins[b][k] - truss.pins[a][k]);
        let length = libm::hypot(d[0], d[1]);
        for k in [0, 1] {
            rows[2 * a + k][column] = d[k] / length;
            rows[2 * b + k][column] = -d[k] / length;
        }
    }
    let bars = truss.bars.len();
    (rows[0][bars], rows[1][bars + 1], rows[3][bars + 2]) = (1.0, 1.0, 1.0);
    for (i, load) in truss.loads.iter().enumerate() {
        (rows[2 * i][n], rows[2 * i + 1][n]) = (-load[0], -load[1]);
    }
    for column in 0..n {
        let pivot = (column..n).max_by(|a, b| rows[*a][column].abs().total_cmp(&rows[*b][column].abs()));
        rows.swap(column, pivot.expect("a row"));
        let own = rows[column].clone();
        for (i, row) in rows.iter_mut().enumerate() {
            if i != column {
                let factor = row[column] / own[column];
                row.iter_mut().zip(&own).skip(column).for_each(|(x, y)| *x -= factor * y);
            }
        }
    }
    (0..n).map(|i| rows[i][n] / rows[i][i]).collect()
}

#[track_caller]
fn near(found: f64, wanted: f64, scale: f64, text: &str) {
    assert!((found - wanted).abs() <= 1e-9 * scale.max(1.0), "{found} is not {wanted}\n{text}");
}

/// Groups are placed as they are written, however many there are.
#[test]
fn trusses_by_coordinates_need_no_assemble() {
    let mut state = 17;
    for _ in 0..60 {
        let truss = truss(&mut state, 12.0);
        let text = file(&truss, true, &mut state);
        let wanted = joints(&truss);
        let scale = wanted.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        let names: Vec<String> = (0..truss.bars.len()).map(|i| format!("axial(b{i})")).collect();
        for (found, wanted) in values(&text, &names).into_iter().zip(&wanted) {
            near(found, *wanted, scale, &text);
        }
    }
}

/// A Warren truss of some panels, its feet on a hinge and a roller.
fn warren(state: &mut u64) -> Truss {
    let panels = 2 + (random(state) * 3.0) as usize;
    let (width, height) = (within(state, 1.0, 4.0), within(state, 0.8, 3.0));
    let above = |i: usize| if i % 2 == 1 { height } else { 0.0 };
    let mut pins: Vec<[f64; 2]> = (0..=2 * panels).map(|i| [width * 0.5 * i as f64, above(i)]).collect();
    // the roller's pin comes second, as in every truss here
    let last = pins.remove(2 * panels);
    pins.insert(1, last);
    let at = |i: usize| if i == 2 * panels { 1 } else { i + usize::from(i > 0) };
    let ends = (0..2 * panels).map(|i| [i, i + 1]).chain((0..2 * panels - 1).map(|i| [i, i + 2]));
    let mut bars: Vec<[usize; 2]> = ends.map(|[a, b]| [at(a), at(b)]).collect();
    // and its first bar ends there
    let roller = bars.iter().position(|bar| bar[1] == 1).expect("a bar at the roller");
    bars.swap(0, roller);
    let loads = pins.iter().map(|_| [within(state, -10.0, 10.0), within(state, -10.0, 10.0)]).collect();
    Truss { pins, bars, loads }
}

/// The rollers of these are slots within the group of all bars.
#[test]
fn warren_trusses_by_coordinates_need_no_assemble() {
    let mut state = 23;
    for count in 0..40 {
        let truss = warren(&mut state);
        let mut text = file(&truss, true, &mut state);
        if count % 2 == 1 {
            text += "link hook K-H 0.5 m\nrevolute J: b1.C - hook.K\ndrive hook = 250 deg\n";
        }
        let wanted = joints(&truss);
        let scale = wanted.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        let names: Vec<String> = (0..truss.bars.len()).map(|i| format!("axial(b{i})")).collect();
        for (found, wanted) in values(&text, &names).into_iter().zip(&wanted) {
            near(found, *wanted, scale, &text);
        }
    }
}

#[test]
fn trusses_come_out_as_by_the_equilibrium_of_their_pins() {
    let mut state = 11;
    for _ in 0..250 {
        let truss = truss(&mut state, 4.0);
        let text = file(&truss, false, &mut state);
        let wanted = joints(&truss);
        let scale = wanted.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        let mut names: Vec<String> = (0..truss.bars.len()).map(|i| format!("axial(b{i})")).collect();
        names.extend(
            ["-reaction(A, ground).x", "-reaction(A, ground).y", "-reaction(Z, ground).y"].map(str::to_owned),
        );
        for (found, wanted) in values(&text, &names).into_iter().zip(&wanted) {
            near(found, *wanted, scale, &text);
        }
        // the forces of a pin on its links add up to its load
        let pin = truss.pins.len() - 1;
        let name = char::from(b'A' + pin as u8);
        let links = truss.bars.iter().enumerate().filter(|(_, ends)| ends.contains(&pin)).map(|(i, _)| i);
        let sum = |axis: &str| {
            links.clone().map(|i| format!("reaction({name}, b{i}).{axis}")).collect::<Vec<_>>().join(" + ")
        };
        let found = values(&text, &[sum("x"), sum("y")]);
        near(found[0], truss.loads[pin][0], scale, &text);
        near(found[1], truss.loads[pin][1], scale, &text);
    }
}

/// A four-bar with a drive, friction in its pins where `friction` has it, and this load.
fn four_bar(state: &mut u64, load: &str, friction: &str) -> String {
    let (a, b, c, d) =
        (within(state, 0.1, 0.2), within(state, 0.5, 0.6), within(state, 0.4, 0.5), within(state, 0.5, 0.6));
    let angle = within(state, 0.0, 360.0);
    format!(
        "ground {{ A (0, 0); D ({d} m, 0) }}\nlink crank A-B {a} m\nlink rod B-C {b} m {{ S (0.2 m, 0.1 m); mass 3 kg at S inertia \
         0.2 kg*m^2 }}\nlink rocker D-C {c} m\nrevolute A: ground - crank {friction}\nrevolute B: crank - rod {friction}\nrevolute C: \
         rod - rocker {friction}\nrevolute D: ground - rocker\nassemble C left of B-D\ndrive crank = {angle} deg at 8 rad/s\nbalance \
         torque M on crank\n{load}\n"
    )
}

#[test]
fn a_load_on_a_pin_is_a_load_on_either_of_its_links() {
    let mut state = 5;
    for i in 0..250 {
        let (pin, links) = [("B", ["crank", "rod"]), ("C", ["rod", "rocker"])][i % 2];
        let force = format!("({} N, {} N)", within(&mut state, -90.0, 90.0), within(&mut state, -90.0, 90.0));
        let frame = ["", " in rod", " when velocity(rod.S).x < 0.1 m/s"][i % 3];
        let friction = if i % 5 == 0 { "{ friction_circle 4 mm }" } else { "" };
        let begin = state;
        let [on_pin, on_first, on_second] =
            [format!("at {pin}"), format!("on {} at {pin}", links[0]), format!("on {} at {pin}", links[1])]
                .map(|site| {
                    four_bar(&mut begin.clone(), &format!("force P {site} = {force}{frame}"), friction)
                });
        let of = |link: &str| ["x", "y"].map(|axis| format!("reaction({pin}, {link}).{axis}"));
        let names: Vec<String> =
            ["M".to_owned()].into_iter().chain(of(links[1])).chain(of(links[0])).collect();
        let [whole, first, second] = [&on_pin, &on_first, &on_second].map(|text| values(text, &names));
        let scale = whole.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        // the pin sits in its first link
        for k in 0..3 {
            near(whole[k], first[k], scale, &on_pin);
        }
        if friction.is_empty() {
            near(whole[0], second[0], scale, &on_pin);
            near(whole[3], second[3], scale, &on_pin);
            near(whole[4], second[4], scale, &on_pin);
        }
        let load = values(&on_pin, &["P.x".to_owned(), "P.y".to_owned()]);
        near(whole[1] + whole[3], load[0], scale, &on_pin);
        near(whole[2] + whole[4], load[1], scale, &on_pin);
    }
}

#[test]
fn an_unknown_force_on_a_pin_is_part_of_the_force_on_its_first_link() {
    let mut state = 3;
    let text = four_bar(&mut state, "", "")
        .replace("balance torque M on crank", "balance force M at C along 30 deg");
    let names =
        ["M", "reaction(C, rod).x", "reaction(C, rocker).x", "reaction(C, rod).y", "reaction(C, rocker).y"];
    let found = values(&text, &names.map(str::to_owned));
    let angle = 30.0_f64.to_radians();
    near(found[1] + found[2], found[0] * libm::cos(angle), found[0].abs(), &text);
    near(found[3] + found[4], found[0] * libm::sin(angle), found[0].abs(), &text);
}

#[test]
fn axial_stays_a_name() {
    let text = "given axial = 2 m\nground { A (0, 0); C (0, 1.5 m) }\nlink ab A-B axial\nlink cb C-B 2.5 m\nrevolute A: ground - ab\n\
                revolute C: ground - cb\nrevolute B: ab - cb\nassemble B right of A-C\nforce P at B = 5 kN down\n";
    let found = values(text, &["axial".to_owned(), "axial(cb)".to_owned()]);
    near(found[0], 2.0, 1.0, text);
    near(found[1], 5.0 * 2.5 / 1.5, 1.0, text);
    let text = text.replace("given axial = 2 m\n", "").replace("A-B axial", "A-B 2 m").replace("ab", "axial");
    let found = values(&text, &["axial(axial)".to_owned()]);
    near(found[0], -5.0 * 2.0 / 1.5, 1.0, &text);
}
