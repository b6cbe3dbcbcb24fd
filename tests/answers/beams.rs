//! Loads per length, and forces inside links.

use super::masses::{values, within};
use super::quick_rows::random;
use std::fmt::Write;

#[track_caller]
fn near(found: f64, wanted: f64, scale: f64, text: &str) {
    assert!((found - wanted).abs() <= 1e-9 * scale.max(1.0), "{found} is not {wanted}\n{text}");
}

/// Where Gauss's two points are on a segment.
const GAUSS: [f64; 2] = [0.211_324_865_405_187_1, 0.788_675_134_594_812_9];

/// A four-bar in motion, and the length of a segment PQ of its rod with Gauss's points.
fn four_bar(state: &mut u64) -> (String, f64) {
    let (a, b, c, d) =
        (within(state, 0.1, 0.2), within(state, 0.5, 0.6), within(state, 0.4, 0.5), within(state, 0.5, 0.6));
    let mut at = || [within(state, -0.3, 0.6), within(state, -0.2, 0.3)];
    let (p, q) = (at(), at());
    let along = |s: f64| [0, 1].map(|k| p[k] + (q[k] - p[k]) * s);
    let [p, q, g, h] = [0.0, 1.0, GAUSS[0], GAUSS[1]].map(along).map(|[x, y]| format!("({x} m, {y} m)"));
    let length = libm::hypot(along(1.0)[0] - along(0.0)[0], along(1.0)[1] - along(0.0)[1]);
    let angle = within(state, 0.0, 360.0);
    let text = format!(
        "ground {{ A (0, 0); D ({d} m, 0) }}\nlink crank A-B {a} m\nlink rod B-C {b} m {{ P {p}; Q {q}; G0 {g}; G1 {h}; S (0.2 m, 0.1 m); mass 3 kg at S; \
         inertia 0.2 kg*m^2 }}\nlink rocker D-C {c} m\nrevolute A: ground - crank\nrevolute B: crank - rod\nrevolute C: rod - \
         rocker\nrevolute D: ground - rocker\nassemble C left of B-D\ndrive crank = {angle} deg at 8 rad/s\nbalance torque M on crank\n"
    );
    (text, length)
}

/// Two forces at Gauss's points have the force and the moment of any load that changes linearly.
#[test]
fn a_load_per_length_is_two_forces_at_the_points_of_gauss() {
    let mut state = 41;
    for _ in 0..200 {
        let (machine, length) = four_bar(&mut state);
        let (q_1, q_2, phi) =
            (within(&mut state, -1.0, 5.0), within(&mut state, -1.0, 5.0), within(&mut state, -180.0, 180.0));
        let frame = if random(&mut state) < 0.5 { " in rod" } else { "" };
        let spread = match (random(&mut state) * 3.0) as usize {
            0 => format!("force q on rod from P to Q = {q_1} N/m .. {q_2} N/m @ {phi} deg{frame}\n"),
            1 => format!(
                "force q on rod from P to Q = {q_1} N/m*cos(omega(rod)/(1 rad/s)*1 rad) .. 0 @ {phi} deg{frame}\n\
                 force r on rod from P to Q = 0 N/m .. {q_2}*(1 N/m*cos(omega(rod)/(1 rad/s)*1 rad)) @ {phi} deg{frame}\n"
            ),
            _ => format!(
                "given q1 = {q_1} N/m\nforce q on rod from P to Q = q1 @ {phi} deg .. ({q_2} N/m @ {phi} deg){frame}\n"
            ),
        };
        let factor = if spread.contains("cos") { "*cos(omega(rod)/(1 rad/s)*1 rad)" } else { "" };
        let mut points = String::new();
        for (i, s) in GAUSS.into_iter().enumerate() {
            let half = (q_1 + (q_2 - q_1) * s) * length / 2.0;
            let _ = writeln!(points, "force F{i} on rod at G{i} = {half} N{factor} @ {phi} deg{frame}");
        }
        let names =
            ["M", "reaction(B, rod).x", "reaction(B, rod).y", "reaction(C, rod).x", "reaction(C, rod).y"];
        let names = names.map(str::to_owned);
        let (one, other) =
            (values(&(machine.clone() + &spread), &names), values(&(machine + &points), &names));
        let scale = other.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        one.into_iter().zip(other).for_each(|(found, wanted)| near(found, wanted, scale, &spread));
    }
}

/// A load per length: from, to, at its ends, and its angle.
type Spread = ([f64; 2], [f64; 2], [f64; 2], f64);

/// A rod of a four-bar with rods, masses, loads and a torque on it.
struct Rod {
    machine: String,
    length: f64,
    /// Rods along segments: from, to, mass.
    rods: Vec<([f64; 2], [f64; 2], f64)>,
    /// Masses at points with moments of inertia.
    masses: Vec<([f64; 2], f64, f64)>,
    forces: Vec<([f64; 2], [f64; 2])>,
    spread: Vec<Spread>,
}

impl Rod {
    fn of(state: &mut u64) -> Self {
        let (a, c, d) = (within(state, 0.1, 0.2), within(state, 0.4, 0.5), within(state, 0.5, 0.6));
        let length = within(state, 0.5, 0.6);
        let angle = within(state, 0.0, 360.0);
        let machine = format!(
            "gravity 9.81 m/s^2\nground {{ A (0, 0); D ({d} m, 0) }}\nlink crank A-B {a} m\nlink rocker D-C {c} m\nrevolute A: ground - \
             crank\nrevolute D: ground - rocker\nassemble C left of B-D\ndrive crank = {angle} deg at 8 rad/s accelerating 30 \
             rad/s^2\nbalance torque M on crank\n"
        );
        let at = |state: &mut u64| [within(state, 0.0, length), within(state, -0.1, 0.1)];
        let mut own = Self {
            machine,
            length,
            rods: vec![([0.0, 0.0], [length, 0.0], within(state, 0.5, 2.0))],
            masses: Vec::new(),
            forces: Vec::new(),
            spread: Vec::new(),
        };
        for _ in 0..2 {
            own.rods.push((at(state), at(state), within(state, 0.5, 2.0)));
            own.masses.push((at(state), within(state, 0.5, 2.0), within(state, 0.0, 0.02)));
            own.forces.push((at(state), [within(state, -50.0, 50.0), within(state, -50.0, 50.0)]));
            let ends = [within(state, 1.0, 90.0), within(state, 1.0, 90.0)];
            own.spread.push((at(state), at(state), ends, within(state, -180.0, 180.0)));
        }
        own
    }

    /// The link of what is between two places of the axis, and the loads on it.
    fn part(&self, name: &str, [from, to]: [f64; 2], ends: &str) -> (String, String) {
        let (mut link, mut loads) = (format!("link {name} {{ {ends}"), String::new());
        let mut count = 0;
        let mut point = |link: &mut String, [x, y]: [f64; 2]| {
            count += 1;
            let _ = write!(link, "; P{count} ({x} m, {y} m)");
            format!("P{count}")
        };
        // the shares of a segment between the places
        let shares = |a: [f64; 2], b: [f64; 2]| {
            let share = |x: f64| ((x - a[0]) / (b[0] - a[0])).clamp(0.0, 1.0);
            let (s, t) = (share(from), share(to));
            (s.min(t), s.max(t))
        };
        let on = |a: [f64; 2], b: [f64; 2], s: f64| [0, 1].map(|k| a[k] + (b[k] - a[k]) * s);
        for &(a, b, mass) in &self.rods {
            let (s, t) = shares(a, b);
            if t > s {
                let (p, q) = (point(&mut link, on(a, b, s)), point(&mut link, on(a, b, t)));
                let _ = write!(link, "; mass {} kg rod {p} to {q}", mass * (t - s));
            }
        }
        for &(at, mass, inertia) in self.masses.iter().filter(|m| from <= m.0[0] && m.0[0] < to) {
            let p = point(&mut link, at);
            let _ = write!(link, "; mass {mass} kg at {p} inertia {inertia} kg*m^2");
        }
        for &(at, [x, y]) in self.forces.iter().filter(|f| from <= f.0[0] && f.0[0] < to) {
            let p = point(&mut link, at);
            let _ = writeln!(loads, "force on {name} at {p} = ({x} N, {y} N)");
        }
        for &(a, b, [q_1, q_2], phi) in &self.spread {
            let (s, t) = shares(a, b);
            if t > s {
                let (p, q) = (point(&mut link, on(a, b, s)), point(&mut link, on(a, b, t)));
                let [q_1, q_2] = [s, t].map(|s| q_1 + (q_2 - q_1) * s);
                let _ = writeln!(
                    loads,
                    "force on {name} from {p} to {q} = {q_1} N/m .. {q_2} N/m @ {phi} deg in {name}"
                );
            }
        }
        (link + " }\n", loads)
    }

    /// The machine with the rod as one link.
    fn whole(&self) -> String {
        let l = self.length;
        let (link, loads) = self.part("rod", [-1.0, 9.0], &format!("B (0, 0); C ({l} m, 0)"));
        format!(
            "{}{link}revolute B: crank - rod\nrevolute C: rod - rocker\n{loads}torque on rod = 7 N*m\n",
            self.machine
        )
    }

    /// The machine with the rod as two links that are welded at a place.
    fn welded(&self, x: f64) -> String {
        let l = self.length;
        let (one, on_one) = self.part("one", [-1.0, x], &format!("B (0, 0); W ({x} m, 0)"));
        let (two, on_two) = self.part("two", [x, 9.0], &format!("W ({x} m, 0); C ({l} m, 0)"));
        format!(
            "{}{one}{two}revolute B: crank - one\nrevolute C: two - rocker\nweld W: one - two\n{on_one}{on_two}torque on one = 7 N*m\n",
            self.machine
        )
    }
}

/// The force and the couple of a weld at the place of the cut, by the solver of welded links.
#[test]
fn the_forces_at_a_cut_are_those_of_a_weld_there() {
    let mut state = 12;
    for _ in 0..150 {
        let rod = Rod::of(&mut state);
        let x = within(&mut state, 0.02, rod.length - 0.02);
        let text = rod.whole();
        let parts = ["N", "Q", "M"].map(|part| format!("internal(rod, {x} m).{part}"));
        let found = values(&text, &parts);
        let weld =
            ["dot(reaction(W, one), dir(one))", "-cross(dir(one), reaction(W, one))", "moment(W, one)"];
        let wanted = values(&rod.welded(x), &weld.map(str::to_owned));
        let scale = wanted.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        found.into_iter().zip(wanted).for_each(|(found, wanted)| near(found, wanted, scale, &text));
    }
}

/// Extremes against many cuts, and the shear force as the slope of the moment where all acts on the axis.
#[test]
fn extremes_along_a_link_are_those_of_many_cuts() {
    let mut state = 77;
    for round in 0..40 {
        let mut rod = Rod::of(&mut state);
        if round % 2 == 0 {
            let flat = |at: &mut [f64; 2]| at[1] = 0.0;
            rod.rods.iter_mut().for_each(|r| [&mut r.0, &mut r.1].into_iter().for_each(flat));
            rod.spread.iter_mut().for_each(|r| [&mut r.0, &mut r.1].into_iter().for_each(flat));
        }
        let text = rod.whole();
        let steps = 400;
        let places: Vec<f64> = (0..=steps).map(|i| rod.length * f64::from(i) / f64::from(steps)).collect();
        for part in ["N", "Q", "M"] {
            let mut names: Vec<String> =
                places.iter().map(|x| format!("internal(rod, {x} m).{part}")).collect();
            let whole = ["max", "min", "argmax", "argmin"].map(|how| format!("{how}(internal(rod).{part})"));
            names.extend(whole);
            let all = values(&text, &names);
            let (cuts, extremes) = all.split_at(places.len());
            let scale = cuts.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
            let (most, least) =
                (cuts.iter().fold(f64::MIN, |m, x| m.max(*x)), cuts.iter().fold(f64::MAX, |m, x| m.min(*x)));
            assert!(
                extremes[0] >= most - 1e-9 * scale && extremes[1] <= least + 1e-9 * scale,
                "{extremes:?} {most} {least}\n{text}"
            );
            // between two cuts a moment changes by less than a step times the shear force
            if part == "M" {
                assert!(
                    extremes[0] - most < 0.05 * scale && least - extremes[1] < 0.05 * scale,
                    "{extremes:?} {most} {least}\n{text}"
                );
            }
            for i in 0..2 {
                let beside = [-1e-7, 1e-7].map(|d| (extremes[2 + i] + d).clamp(0.0, rod.length));
                let names = beside.map(|x| format!("internal(rod, {x} m).{part}"));
                let found = values(&text, &names);
                let nearest = found.iter().map(|value| (value - extremes[i]).abs()).fold(f64::MAX, f64::min);
                assert!(nearest <= 1e-4 * scale.max(1.0), "{part} {i}: {found:?} {extremes:?}\n{text}");
            }
        }
        if round % 2 == 0 {
            let x = within(&mut state, 0.05, rod.length - 0.05);
            let h = 1e-4;
            let names = [
                format!("internal(rod, {} m).M", x - h),
                format!("internal(rod, {} m).M", x + h),
                format!("internal(rod, {x} m).Q"),
            ];
            let found = values(&text, &names);
            let forces = rod.forces.iter().map(|f| f.0[0]).chain(rod.masses.iter().map(|m| m.0[0]));
            if forces.into_iter().all(|at| (at - x).abs() > 2.0 * h) {
                near((found[1] - found[0]) / (2.0 * h) / 1e4, found[2] / 1e4, 1.0 + found[2].abs(), &text);
            }
        }
    }
}

#[test]
fn extremes_along_a_link_have_extremes_over_the_sweep() {
    let text = "ground { O (0, 0); line guide through O along 0 deg }\nlink crank O-A 100 mm\nlink rod A-B 400 mm { mass 3 kg rod A to B }\n\
                link piston { B (0, 0) }\nrevolute O: ground - crank\nrevolute A: crank - rod\nrevolute B: rod - piston\nprismatic P: \
                piston.B - ground.guide\nassemble B ahead of A\ndrive crank = 0 deg .. 360 deg in 720 steps at 1200 rpm\nfind m = \
                max(internal(rod).M), most = max(max(internal(rod).M)), place = argmax(max(internal(rod).M)) as deg\n";
    let solution = assur::solve(text).unwrap_or_else(|e| panic!("{e}"));
    let number = |pose: usize, name: &str| solution.poses()[pose][name].number().expect("a number");
    let all = (0..solution.poses().len()).map(|i| number(i, "m"));
    let most = all.fold(f64::MIN, f64::max);
    let found = solution["most"].number().expect("a number");
    assert!(found >= most - 1e-9 && found - most < 1e-2, "{found} {most}");
}

#[test]
fn internal_stays_a_name() {
    let text = "curve internal {\n x, y\n 0, 1\n 1, 3\n}\nground { A (0, 0) }\nlink internal A-B 1 m\nweld A: ground - internal\ngiven M = 2 \
                N*m\ntorque on internal = M\nlet argmin = 3\n";
    let found =
        values(text, &["internal(0.5)".to_owned(), "argmin".to_owned(), "moment(A, internal)".to_owned()]);
    assert_eq!(found[..2], [2.0, 3.0]);
    near(found[2], -2.0, 1.0, text);
}

#[test]
fn links_by_the_coordinates_of_their_points() {
    let boom = "ground { A (0, 0); C (0, 3 m) }\nlink boom { A (0, 0); B (4 m, 3 m); D (2 m, 1.5 m) }\nlink cable { B (4 m, 3 m); C (0, 3 m) }\nrevolute A: ground - boom\nrevolute B: boom - cable\nrevolute C: ground - cable\nforce P on boom at D = 10 kN down\n";
    let found = values(boom, &["max(internal(boom).M)", "internal(boom, 1 m).N"].map(str::to_owned));
    found.into_iter().zip([10e3, -34.0 / 3.0]).for_each(|(found, wanted)| near(found, wanted, 1e4, boom));
    let frame = "ground { A (0, 0) }\nlink col { A (0, 0); B (0, 4 m) }\nlink beam { B (0, 4 m); C (3 m, 4 m); D (2 m, 4 m) }\nweld A: ground - col\nweld B: col - beam\nforce P on beam at C = 5 kN down\nforce Q on beam at D = 2 kN right\n";
    let asked =
        ["internal(beam, 0 m).M", "internal(col, 2 m).M", "internal(col, 2 m).N", "internal(beam, 1 m).N"];
    let found = values(frame, &asked.map(str::to_owned));
    found
        .into_iter()
        .zip([-15e3, -19e3, -5.0, 2.0])
        .for_each(|(found, wanted)| near(found, wanted, 1e4, frame));
}

#[test]
fn a_slider_presses_on_its_guide_at_both_contacts() {
    let cart = "ground { A (0, 0); line way through A along 0 deg }\nlink beam A-B 8 m { line top through A along 0 deg }\nlink cart { C (0, 0); D (2 m, 0) }\nrevolute A: ground - beam\nslot B: beam.B - ground.way\nprismatic P: cart.C - beam.top { contacts 0 m, 2 m }\nassemble beam.B near (8 m, 0)\ndrive P = 3 m\nforce w on cart from C to D = 3 kN/m down\n";
    let found = values(cart, &["max(internal(beam).M)", "internal(beam, 4 m).M"].map(str::to_owned));
    found.into_iter().for_each(|found| near(found, 9e3, 1e4, cart));
}

#[test]
fn a_couple_acts_at_its_point() {
    let mut state = 97;
    for _ in 0..100 {
        let (length, share) = (within(&mut state, 2.0, 8.0), within(&mut state, 0.1, 0.9));
        let (couple, at) = (within(&mut state, -20.0, 20.0), share * length);
        let text = format!(
            "ground {{ A (0, 0); line floor through A along 0 deg }}\nlink beam {{ A (0, 0); D ({at} m, 0); B ({length} m, 0) }}\n\
             revolute A: ground - beam\nslot B: beam.B - ground.floor\ntorque M0 on beam at D = {couple}e3 N*m\n"
        );
        let names = [
            format!("internal(beam, {} m).M", at * 0.999_999),
            format!("internal(beam, {} m).M", at * 1.000_001),
            format!("internal(beam, {} m).Q", at * 0.5),
            "max(internal(beam).M)".to_owned(),
            "min(internal(beam).M)".to_owned(),
        ];
        let found = values(&text, &names);
        // the left support is M0/l upwards: M rises by M0 x/l, and drops by M0 at D
        let slope = couple * 1e3 / length;
        let (before, behind) = (slope * at, slope * at - couple * 1e3);
        let scale = couple.abs() * 1e3;
        near(found[0], before * 0.999_999, scale, &text);
        near(found[1], behind + slope * at * 1e-6, scale, &text);
        near(found[2], slope, scale, &text);
        near(found[3], before.max(behind), scale, &text);
        near(found[4], before.min(behind), scale, &text);
    }
}
