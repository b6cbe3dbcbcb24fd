//! Welds: against the same mechanism with one link in place of the welded ones, and against sums over what each carries.

use super::masses::{values, within};
use super::quick_rows::random;
use std::fmt::Write;

fn turned([x, y]: [f64; 2], degrees: f64) -> [f64; 2] {
    let (sine, cosine) = libm::sincos(degrees.to_radians());
    [x * cosine - y * sine, x * sine + y * cosine]
}

/// A welded link: its frame in that of the whole, its mass, a force on it.
struct Part {
    name: String,
    /// The part that carries it, the weld's point there and here.
    on: Option<(usize, [f64; 2], [f64; 2])>,
    origin: [f64; 2],
    angle: f64,
    mass: f64,
    centre: [f64; 2],
    inertia: f64,
    load_at: [f64; 2],
    load: [f64; 2],
}

impl Part {
    fn place(&self, at: [f64; 2]) -> [f64; 2] {
        let at = turned(at, self.angle);
        [self.origin[0] + at[0], self.origin[1] + at[1]]
    }

    fn back(&self, at: [f64; 2]) -> [f64; 2] {
        turned([at[0] - self.origin[0], at[1] - self.origin[1]], -self.angle)
    }
}

/// A tree of welded links.
fn parts(state: &mut u64, name: &str, count: usize) -> Vec<Part> {
    let mut all: Vec<Part> = Vec::new();
    for i in 0..count {
        let point = |state: &mut u64| [within(state, -0.3, 0.5), within(state, -0.3, 0.3)];
        let on = (i > 0).then(|| ((random(state) * i as f64) as usize, point(state), point(state)));
        let (mut origin, mut angle) = ([0.0; 2], 0.0);
        if let Some((base, there, here)) = on {
            let of = &all[base];
            angle = of.angle + if random(state) < 0.3 { 0.0 } else { within(state, -170.0, 170.0) };
            let (at, own) = (of.place(there), turned(here, angle));
            origin = [at[0] - own[0], at[1] - own[1]];
        }
        all.push(Part {
            name: format!("{name}{i}"),
            on,
            origin,
            angle,
            mass: within(state, 0.5, 3.0),
            centre: point(state),
            inertia: within(state, 0.001, 0.1),
            load_at: point(state),
            load: [within(state, -50.0, 50.0), within(state, -50.0, 50.0)],
        });
    }
    all
}

fn vector([x, y]: [f64; 2]) -> String {
    format!("({x} m, {y} m)")
}

/// The links with their welds and loads, and points of the whole on the parts named with them.
fn written(all: &[Part], points: &[(&str, usize, [f64; 2])]) -> String {
    let mut text = String::new();
    for (i, part) in all.iter().enumerate() {
        let _ = write!(text, "link {} {{ S {}; L {}; ", part.name, vector(part.centre), vector(part.load_at));
        let _ = write!(text, "mass {} kg at S; inertia {} kg*m^2; ", part.mass, part.inertia);
        for (name, _, at) in points.iter().filter(|p| p.1 == i) {
            let _ = write!(text, "{name} {}; ", vector(part.back(*at)));
        }
        if let Some((_, _, here)) = part.on {
            let _ = write!(text, "H {}; ", vector(here));
        }
        for (j, other) in all.iter().enumerate() {
            if let Some((base, there, _)) = other.on
                && base == i
            {
                let _ = write!(text, "W{j} {}; ", vector(there));
            }
        }
        text += "}\n";
    }
    for (i, part) in all.iter().enumerate() {
        if let Some((base, ..)) = part.on {
            let (one, angle) = (&all[base].name, part.angle - all[base].angle);
            let _ =
                writeln!(text, "weld w{}: {one}.W{i} - {}.H {{ angle {angle} deg }}", part.name, part.name);
        }
        let [x, y] = part.load;
        let _ = writeln!(text, "force F{} on {} at L = ({x} N, {y} N)", part.name, part.name);
    }
    text
}

/// The same as one link of the first part's frame.
fn whole(all: &[Part], name: &str, points: &[(&str, usize, [f64; 2])]) -> String {
    let mut text = format!("link {name} {{ ");
    for (i, part) in all.iter().enumerate() {
        let _ = write!(
            text,
            "S{i} {}; L{i} {}; ",
            vector(part.place(part.centre)),
            vector(part.place(part.load_at))
        );
        let _ = write!(text, "mass {} kg at S{i} inertia {} kg*m^2; ", part.mass, part.inertia);
    }
    for (point, _, at) in points {
        let _ = write!(text, "{point} {}; ", vector(*at));
    }
    text += "}\n";
    for (i, part) in all.iter().enumerate() {
        let [x, y] = part.load;
        let _ = writeln!(text, "force F{} on {name} at L{i} = ({x} N, {y} N)", part.name);
    }
    text
}

#[track_caller]
fn near(found: f64, wanted: f64, scale: f64, text: &str) {
    assert!((found - wanted).abs() <= 1e-9 * scale.max(1.0), "{found} is not {wanted} of {scale}\n{text}");
}

fn xy(what: &str) -> [String; 2] {
    ["x", "y"].map(|axis| format!("{what}.{axis}"))
}

/// Four-bars and crank-sliders of which the crank or the coupler consists of welded links.
struct Machine {
    text: String,
    one: String,
    all: Vec<Part>,
    welded: &'static str,
    /// Hinges of the welded link: name, part, other link.
    hinges: [(&'static str, usize, &'static str); 2],
}

fn machine(state: &mut u64) -> Machine {
    let is_crank = random(state) < 0.4;
    let slides = random(state) < 0.5;
    let count = 2 + (random(state) * 3.0) as usize;
    let (welded, points) = if is_crank { ("crank", ["A", "B"]) } else { ("rod", ["B", "C"]) };
    let all = parts(state, welded, count);
    let (crank, rod) = (within(state, 0.1, 0.18), within(state, 0.45, 0.6));
    let length = if is_crank { crank } else { rod };
    let on = [0, 1].map(|_| (random(state) * count as f64) as usize);
    let begin = [within(state, -0.1, 0.1), within(state, -0.1, 0.1)];
    let along = turned([length, 0.0], within(state, -180.0, 180.0));
    let places = [begin, [begin[0] + along[0], begin[1] + along[1]]];
    let points: Vec<(&str, usize, [f64; 2])> = (0..2).map(|i| (points[i], on[i], places[i])).collect();
    let named = |i: usize| all[on[i]].name.clone();
    let link = |own: &str, first: bool, one: bool| match (own == welded, one) {
        (true, true) => welded.to_owned(),
        (true, false) => named(usize::from(!first)),
        _ => own.to_owned(),
    };
    let mut texts = [String::new(), String::new()];
    let turned_part = (random(state) * count as f64) as usize;
    let (angle, in_hinge) = (within(state, 0.0, 360.0), random(state) < 0.5);
    for (k, text) in texts.iter_mut().enumerate() {
        let one = k == 1;
        let body = if one { whole(&all, welded, &points) } else { written(&all, &points) };
        let crank_link = if is_crank { body.clone() } else { format!("link crank A-B {crank} m\n") };
        let rod_link = if is_crank { format!("link rod B-C {rod} m\n") } else { body };
        let _ = write!(
            text,
            "gravity 9.81 m/s^2\nground {{ A (0, 0); D (0.5 m, 0); line way through A along 0 deg }}\n{crank_link}{rod_link}"
        );
        let _ = writeln!(text, "revolute A: ground - {}", link("crank", true, one));
        let _ = writeln!(text, "revolute B: {} - {}", link("crank", false, one), link("rod", true, one));
        let end = link("rod", false, one);
        if slides {
            let _ = writeln!(text, "link piston {{ C (0, 0); mass 2 kg at C }}\nrevolute C: {end} - piston");
            *text += "prismatic G: piston.C - ground.way\nassemble C ahead of B\n";
        } else {
            *text += "link rocker D-C 0.45 m { S (0.2 m, 0); mass 1 kg at S; inertia 0.02 kg*m^2 }\n";
            let _ = writeln!(
                text,
                "revolute C: {end} - rocker\nrevolute D: ground - rocker\nassemble C left of B-D"
            );
        }
        // any of the welded links may be driven, or the hinge of one
        let (driven, angle) = match (is_crank, one) {
            (true, false) => (all[turned_part].name.as_str(), angle + all[turned_part].angle),
            _ => ("crank", angle),
        };
        let (target, value) = match (is_crank && in_hinge, one) {
            (true, false) => ("A", angle - all[turned_part].angle + all[on[0]].angle),
            _ => (driven, angle),
        };
        let _ = writeln!(text, "drive {target} = {value} deg at 7 rad/s accelerating 3 rad/s^2");
        let _ = writeln!(text, "balance torque M on {driven}");
    }
    let [text, one] = texts;
    let hinges = if is_crank {
        [("A", on[0], "ground"), ("B", on[1], "rod")]
    } else {
        [("B", on[0], "crank"), ("C", on[1], if slides { "piston" } else { "rocker" })]
    };
    Machine { text, one, all, welded, hinges }
}

/// What acts on each part from outside its welds: force, and moment about the ground's origin; and its places.
fn outside(machine: &Machine) -> Vec<([f64; 2], f64)> {
    let mut names = Vec::new();
    for part in &machine.all {
        let link = &part.name;
        names.extend(xy(&format!("position({link}.S)")));
        names.extend(xy(&format!("acceleration({link}.S)")));
        names.push(format!("alpha({link})"));
        names.extend(xy(&format!("position({link}.L)")));
    }
    for (pair, part, _) in machine.hinges {
        let link = &machine.all[part].name;
        names.extend(xy(&format!("reaction({pair}, {link})")));
        names.extend(xy(&format!("position({link}.{pair})")));
    }
    names.push("M".to_owned());
    let mut found = values(&machine.text, &names).into_iter();
    let mut next = || found.next().expect("as many as asked");
    let mut sums = Vec::new();
    for part in &machine.all {
        let [x, y, ax, ay, alpha, lx, ly] = std::array::from_fn(|_| next());
        let m = part.mass;
        let inertia = [-m * ax, -m * (ay + 9.81)];
        let force = [inertia[0] + part.load[0], inertia[1] + part.load[1]];
        let moment =
            x * inertia[1] - y * inertia[0] - part.inertia * alpha + lx * part.load[1] - ly * part.load[0];
        sums.push((force, moment));
    }
    for (_, part, _) in machine.hinges {
        let [fx, fy, x, y] = std::array::from_fn(|_| next());
        let (force, moment) = &mut sums[part];
        *force = [force[0] + fx, force[1] + fy];
        *moment += x * fy - y * fx;
    }
    if machine.welded == "crank" {
        let torque = next();
        let driven =
            machine.text.lines().find_map(|l| l.strip_prefix("balance torque M on ")).expect("a balance");
        let part = machine.all.iter().position(|p| p.name == driven).expect("a part");
        sums[part].1 += torque;
    }
    sums
}

/// Whether a part is carried by another, or is it.
fn hangs(all: &[Part], part: usize, on: usize) -> bool {
    part == on || all[part].on.is_some_and(|(base, ..)| hangs(all, base, on))
}

/// Each weld against the sum over what it carries: on the ground all, with `about` as its place.
fn check_welds(text: &str, all: &[Part], sums: &[([f64; 2], f64)]) {
    for (i, part) in all.iter().enumerate().filter(|(_, p)| p.on.is_some()) {
        let (weld, link) = (format!("w{}", part.name), &part.name);
        let base = &all[part.on.expect("a base").0].name;
        let mut names = xy(&format!("reaction({weld}, {link})")).to_vec();
        names.push(format!("moment({weld}, {link})"));
        names.extend(xy(&format!("position({link}.H)")));
        names.extend(xy(&format!("reaction({weld}, {base})")));
        let found = values(text, &names);
        let own = (0..all.len()).filter(|other| hangs(all, *other, i));
        let (mut force, mut moment, mut most) = ([0.0; 2], 0.0, 1.0_f64);
        for other in own {
            let (f, m) = sums[other];
            force = [force[0] + f[0], force[1] + f[1]];
            moment += m;
            most = most.max(f[0].abs()).max(f[1].abs()).max(m.abs());
        }
        near(found[0], -force[0], most, text);
        near(found[1], -force[1], most, text);
        near(found[2], -(moment - found[3] * force[1] + found[4] * force[0]), most, text);
        near(found[5], -found[0], most, text);
        near(found[6], -found[1], most, text);
    }
}

#[test]
fn welded_links_are_one_and_each_weld_carries_what_hangs_on_it() {
    let mut state = 20_261_128;
    for _ in 0..500 {
        let machine = machine(&mut state);
        let mut names = [Vec::new(), Vec::new()];
        for (pair, _, other) in machine.hinges {
            names.iter_mut().for_each(|names| names.extend(xy(&format!("reaction({pair}, {other})"))));
        }
        for (i, part) in machine.all.iter().enumerate() {
            for function in ["position", "velocity", "acceleration"] {
                names[0].extend(xy(&format!("{function}({}.S)", part.name)));
                names[1].extend(xy(&format!("{function}({}.S{i})", machine.welded)));
            }
        }
        for (names, link) in names.iter_mut().zip([machine.all[0].name.as_str(), machine.welded]) {
            names.extend([format!("omega({link})"), format!("alpha({link})"), "M".to_owned()]);
            names.push("kinetic_energy()".to_owned());
        }
        let (found, wanted) = (values(&machine.text, &names[0]), values(&machine.one, &names[1]));
        let scale = wanted.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        for ((name, x), y) in names[0].iter().zip(&found).zip(&wanted) {
            near(*x, *y, scale, &format!("{name}\n{}\n{}", machine.text, machine.one));
        }
        check_welds(&machine.text, &machine.all, &outside(&machine));
    }
}

#[test]
fn a_clamp_carries_all_that_hangs_on_it() {
    let mut state = 20_261_129;
    for _ in 0..300 {
        let count = 1 + (random(&mut state) * 6.0) as usize;
        let all = parts(&mut state, "beam", count);
        let (turn, clamp) = (within(&mut state, -180.0, 180.0), [0.3, -0.2]);
        let at = all[0].back([0.1, 0.05]);
        let mut text = format!("gravity 9.81 m/s^2\nground {{ G {} }}\n", vector(clamp));
        text += &written(&all, &[("G", 0, [0.1, 0.05])]);
        let _ = writeln!(text, "weld clamp: ground.G - beam0.G {{ angle {turn} deg }}");
        // everything lies as the first link does
        let origin = turned(at, turn);
        let origin = [clamp[0] - origin[0], clamp[1] - origin[1]];
        let place = |part: &Part, at: [f64; 2]| {
            let at = turned(part.place(at), turn);
            [origin[0] + at[0], origin[1] + at[1]]
        };
        let sums: Vec<([f64; 2], f64)> = (all.iter())
            .map(|part| {
                let (s, l, weight) = (place(part, part.centre), place(part, part.load_at), -9.81 * part.mass);
                let moment = s[0] * weight + l[0] * part.load[1] - l[1] * part.load[0];
                ([part.load[0], part.load[1] + weight], moment)
            })
            .collect();
        check_welds(&text, &all, &sums);
        let mut names = xy("reaction(clamp, beam0)").to_vec();
        names.push("moment(clamp, beam0)".to_owned());
        let found = values(&text, &names);
        let [fx, fy] = [0, 1].map(|k| sums.iter().map(|s| s.0[k]).sum::<f64>());
        let moment: f64 = sums.iter().map(|s| s.1).sum();
        let most =
            sums.iter().fold(1.0, |most: f64, s| most.max(s.0[0].abs()).max(s.0[1].abs()).max(s.1.abs()));
        near(found[0], -fx, most, &text);
        near(found[1], -fy, most, &text);
        near(found[2], -(moment - clamp[0] * fy + clamp[1] * fx), most, &text);
    }
}

#[test]
fn weld_stays_a_name() {
    let text = "given weld = 0.3 m\nground { A (0, 0); weld (0.1 m, 0.2 m) }\nlink arm A-B 0.8 m { weld 0.2 m @ 30 deg }\nrevolute \
                A: ground - arm\ndrive arm = 0 deg at 2 rad/s\nlet x = 2*weld\n";
    let names = ["x", "position(ground.weld).y", "position(arm.weld).y"].map(str::to_owned);
    let found = values(text, &names);
    near(found[0], 0.6, 1.0, text);
    near(found[1], 0.2, 1.0, text);
    near(found[2], 0.1, 1.0, text);
    let link = "ground { A (0, 0) }\nlink weld A-B 0.8 m\nrevolute A: ground - weld\ndrive weld = 30 deg\n";
    near(values(link, &["position(weld.B).y".to_owned()])[0], 0.4, 1.0, link);
}

#[test]
fn a_run_of_welded_links_is_that_of_one() {
    let mut state = 20_261_130;
    for _ in 0..12 {
        let count = 2 + (random(&mut state) * 3.0) as usize;
        let all = parts(&mut state, "arm", count);
        let last = count - 1;
        let points = [("O", 0, [0.02, -0.01]), ("P", last, [0.4, 0.1])];
        let run = |links: &str, first: &str, hinge: &str, angle: f64| {
            format!(
                "gravity 9.81 m/s^2\nground {{ O (0, 0) }}\n{links}link tip P-Q 0.3 m {{ S (0.1 m, 0); mass 1 kg at S; inertia \
                 0.01 kg*m^2 }}\nrevolute O: ground - {first}\nrevolute P: {hinge} - tip\nstart {hinge} = {angle} deg at 1 \
                 rad/s\nstart tip = 20 deg at 0 rad/s\nsimulate 0 s .. 0.3 s in 1 steps\n"
            )
        };
        let turn = within(&mut state, -60.0, 0.0);
        let text = run(&written(&all, &points), "arm0", &all[last].name, turn + all[last].angle);
        let one = run(&whole(&all, "arm", &points), "arm", "arm", turn);
        let asked = |text: &str, link: &str, tip: &str| {
            let names = ["omega(tip)".to_owned(), format!("omega({link})"), format!("position({tip}.P).x")];
            let more = ["reaction(O, LINK).x", "reaction(P, tip).y", "kinetic_energy()"];
            let names = [names.to_vec(), more.map(|name| name.replace("LINK", link)).to_vec()].concat();
            let solution = assur::solve(format!("{text}find {}\n", names.join(", ")))
                .unwrap_or_else(|e| panic!("{e}\n{text}"));
            let pose = solution.poses().last().expect("an instant");
            names.iter().map(|name| pose[name.as_str()].number().expect("a number")).collect::<Vec<_>>()
        };
        let (found, wanted) = (asked(&text, "arm0", &all[last].name), asked(&one, "arm", "arm"));
        let scale = wanted.iter().fold(1.0, |most: f64, x| most.max(x.abs()));
        for (x, y) in found.iter().zip(&wanted) {
            assert!((x - y).abs() <= 1e-6 * scale, "{x} is not {y}\n{text}\n{one}");
        }
    }
}
