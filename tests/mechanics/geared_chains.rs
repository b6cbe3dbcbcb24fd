//! Wheels within closed chains of links: the chain driven by a wheel stands as the same chain driven by a crank, wheels roll
//! on each other, and forces and losses agree with an assembly of the equilibrium of all links by itself.

#![allow(clippy::disallowed_methods, reason = "an independent computation")]

use crate::support::random::Random;
use assur::internals::check::Overrides;
use assur::internals::model::{FindKind, Value};
use assur::internals::source::Source;
use std::collections::BTreeMap;
use std::fmt::Write as _;

pub(crate) type Answers = BTreeMap<String, Vec<f64>>;

/// What a text asks at every pose, by name; `None` where it has no position there. Positions are compared with those of 30 digits.
pub(crate) fn answers(text: &str) -> Vec<Option<Answers>> {
    let source = Source::new("geared.mech", text);
    let (solved, problems) = assur::internals::test_source(&source, &Overrides::none());
    let told = || {
        assur::internals::diagnostic::render(&problems, &source, assur::internals::diagnostic::Style::PLAIN)
    };
    let Some(solved) = solved else { panic!("{text}\n{}", told()) };
    let model = solved.compiled.model();
    let poses = solved.solution.poses.iter().map(|pose| {
        let state = pose.outcome.as_ref().ok()?;
        let sigma = state.condition;
        assert!(state.residuals.closure < 1e-13, "{text}\n{:?}", state.residuals);
        assert!(state.residuals.equilibrium.unwrap_or(0.0) < 1e-12 / sigma, "{text}\n{:?}", state.residuals);
        assert!(state.residuals.power.unwrap_or(0.0) < 1e-12 / sigma, "{text}\n{:?}", state.residuals);
        crate::jerks::hold(&model, &state.state, || text.to_owned());
        let reference = solved.solution.reference(&model, state).expect("a reference");
        assert!(reference.closure < 1e-28 && reference.equilibrium < 1e-26, "{text}\n{reference:?}");
        for (got, exact) in state.state.motion.bodies.iter().zip(&reference.bodies) {
            let off = got.u.x - exact.u.x.high + got.u.y - exact.u.y.high;
            assert!(off.abs() < 1e-14 / sigma, "{text}: direction off by {off:e}");
            assert!(
                (got.alpha - exact.alpha.high).abs() < 1e-11 / sigma.powi(3) * (1.0 + got.alpha.abs()),
                "{text}"
            );
        }
        for (got, exact) in state.state.forces.efforts.iter().zip(&reference.efforts) {
            assert!((got - exact.high).abs() < 1e-11 / sigma.powi(2) * (1.0 + got.abs()), "{text}");
        }
        let view = solved.solution.view(&model, state);
        let finds = model.mechanism.finds.iter().filter_map(|find| match &find.kind {
            FindKind::Value { expr, .. } => match view.value(expr) {
                Value::Scalar(x) => Some((find.name.clone(), vec![x])),
                Value::Vector(v) => Some((find.name.clone(), vec![v.x, v.y])),
                _ => None,
            },
            FindKind::Reactions | FindKind::Table(_) => None,
        });
        Some(finds.collect())
    });
    poses.collect()
}

pub(crate) fn close(got: f64, expected: f64, within: f64, what: &str) {
    assert!((got - expected).abs() <= within * (1.0 + expected.abs()), "{what}: {got:e}, not {expected:e}");
}

/// A geared five-bar, crank and second crank in mesh, with masses, a load, and a torque that balances it.
struct FiveBar {
    ground: f64,
    lengths: [f64; 4],
    radii: [f64; 2],
    phase: f64,
    /// Mass, mass centre along the link, moment of inertia.
    bodies: [(f64, f64, f64); 4],
    force: (f64, f64),
}

impl FiveBar {
    fn new(random: &mut Random) -> Self {
        let ground = random.within(0.15, 0.3);
        let r_1 = ground * random.within(0.3, 0.7);
        Self {
            ground,
            lengths: [
                random.within(0.04, 0.08),
                random.within(0.04, 0.08),
                random.within(0.8, 1.1) * ground,
                random.within(0.8, 1.1) * ground,
            ],
            radii: [r_1, ground - r_1],
            phase: random.within(-3.0, 3.0),
            bodies: std::array::from_fn(|_| {
                (random.within(0.1, 2.0), random.within(0.01, 0.1), random.within(1e-3, 5e-3))
            }),
            force: (random.within(50.0, 300.0), random.within(-3.0, 3.0)),
        }
    }

    fn text(&self, drive: &str, near: Option<[f64; 2]>, balance: &str, mesh: &str) -> String {
        let mut out = format!("ground {{ O1 (0, 0); O2 ({} m, 0) }}\ngravity 9.81 m/s^2\n", self.ground);
        let names = [("crank", "O1-A"), ("second", "O2-B"), ("c", "A-C"), ("d", "B-C")];
        for (i, (name, points)) in names.iter().enumerate() {
            let (m, s, j) = self.bodies[i];
            let wheel = match i {
                0 => format!("wheel z1 radius {} m at O1; ", self.radii[0]),
                1 => format!("wheel z2 radius {} m at O2; ", self.radii[1]),
                _ => String::new(),
            };
            writeln!(
                out,
                "link {name} {points} {} m {{ {wheel}G{i} ({s} m, 0); mass {m} kg at G{i}; inertia {j} kg*m^2 }}",
                self.lengths[i]
            )
            .expect("a text");
        }
        let (force, angle) = self.force;
        out += "revolute O1: ground - crank\nrevolute O2: ground - second\nrevolute A: crank - c\nrevolute B: second - d\n\
                revolute C: c - d\n";
        writeln!(out, "mesh k: z1 - z2 {{ phase {} rad; pressure_angle 20 deg{mesh} }}", self.phase)
            .expect("a text");
        writeln!(out, "{drive}").expect("a text");
        match near {
            Some([x, y]) => writeln!(out, "assemble C near ({x} m, {y} m)"),
            None => writeln!(out, "assemble C left of A-B"),
        }
        .expect("a text");
        writeln!(out, "force P on d at C = {force} N @ {angle} rad").expect("a text");
        writeln!(out, "balance torque M on {balance}").expect("a text");
        out += "find position(C), M, reaction(k, second), reaction(A, c), reaction(B, d), reaction(O1, crank), reaction(O2, second)\n";
        for (name, _) in names {
            writeln!(out, "find angle({name}), omega({name}), alpha({name})").expect("a text");
        }
        for (i, (name, _)) in names.iter().enumerate() {
            writeln!(out, "find acceleration({name}.G{i})").expect("a text");
        }
        out
    }

    /// M, and the tooth force on the second crank, from the equilibrium of all links in one system.
    fn equilibrium(&self, at: &Answers, on: usize) -> Vec<f64> {
        let names = ["crank", "second", "c", "d"];
        let angle: Vec<f64> = names.iter().map(|n| at[&format!("angle({n})")][0]).collect();
        let along = |i: usize, l: f64| [l * angle[i].cos(), l * angle[i].sin()];
        let (o_1, o_2, c) = ([0.0, 0.0], [self.ground, 0.0], &at["position(C)"]);
        let a = along(0, self.lengths[0]);
        let b = along(1, self.lengths[1]);
        let b = [o_2[0] + b[0], b[1]];
        let c = [c[0], c[1]];
        let starts = [o_1, o_2, a, b];
        let pitch = [self.radii[0], 0.0];
        // unknowns: O1 on crank, O2 on second, A on c, B on d, C on d, tooth on second, M
        let mut matrix = vec![vec![0.0; 12]; 12];
        let mut right = vec![0.0; 12];
        let pins = [(0, None, o_1), (1, None, o_2), (2, Some(0), a), (3, Some(1), b), (3, Some(2), c)];
        for (k, (on, from, p)) in pins.into_iter().enumerate() {
            for (body, sign) in [(Some(on), 1.0), (from, -1.0)] {
                let Some(body) = body else { continue };
                matrix[3 * body][2 * k] += sign;
                matrix[3 * body + 1][2 * k + 1] += sign;
                // moments about the origin
                matrix[3 * body + 2][2 * k] -= sign * p[1];
                matrix[3 * body + 2][2 * k + 1] += sign * p[0];
            }
        }
        // the tooth presses up or down and parts the axes: the sign of the tangential part is found by trying both
        let tangent = 20.0_f64.to_radians().tan();
        let side = at["reaction(k, second)"][1].signum();
        let tooth = [side * tangent, 1.0];
        for (body, sign) in [(1, 1.0), (0, -1.0)] {
            matrix[3 * body][10] += sign * tooth[0];
            matrix[3 * body + 1][10] += sign * tooth[1];
            matrix[3 * body + 2][10] += sign * (pitch[0] * tooth[1] - pitch[1] * tooth[0]);
        }
        matrix[3 * on + 2][11] = 1.0;
        for i in 0..4 {
            let (m, s, j) = self.bodies[i];
            let g = along(i, s);
            let p = [starts[i][0] + g[0], starts[i][1] + g[1]];
            let a = &at[&format!("acceleration({}.G{i})", names[i])];
            let f = [-m * a[0], -m * (a[1] + 9.81)];
            right[3 * i] -= f[0];
            right[3 * i + 1] -= f[1];
            right[3 * i + 2] -= p[0] * f[1] - p[1] * f[0] - j * at[&format!("alpha({})", names[i])][0];
        }
        let f = [self.force.0 * self.force.1.cos(), self.force.0 * self.force.1.sin()];
        right[9] -= f[0];
        right[10] -= f[1];
        right[11] -= c[0] * f[1] - c[1] * f[0];
        eliminate(matrix, right)
    }
}

/// The solution of a square system.
pub(crate) fn eliminate(matrix: Vec<Vec<f64>>, right: Vec<f64>) -> Vec<f64> {
    let n = right.len();
    let lu = nalgebra::DMatrix::from_fn(n, n, |i, k| matrix[i][k]).full_piv_lu();
    let found = lu.solve(&nalgebra::DVector::from_vec(right)).expect("a regular system");
    found.iter().copied().collect()
}

/// Driven at the crank it is a train and a dyad; driven at the coupler all links are found together.
#[test]
fn a_geared_five_bar_is_one_whichever_link_is_driven() {
    let mut random = Random::new(71);
    let mut compared = 0;
    for _ in 0..crate::share::part(60) {
        let machine = FiveBar::new(&mut random);
        let phi = random.within(-3.0, 3.0);
        let crank = machine.text(
            &format!("drive crank = {phi} rad at 10 rad/s accelerating 7 rad/s^2"),
            None,
            "crank",
            "",
        );
        let Some(Some(known)) = answers(&crank).into_iter().next() else { continue };
        let exact = machine.equilibrium(&known, 0);
        close(known["M"][0], exact[11], 1e-9, &crank);
        close(known["reaction(k, second)"][1], exact[10], 1e-9, &crank);
        let of = |what: &str| known[what][0];
        let near = [known["position(C)"][0], known["position(C)"][1]];
        // at the first pose angles within a chain lie between −π and π
        let turned =
            ["second", "crank"].iter().any(|n| of(&format!("angle({n})")).abs() > std::f64::consts::PI);
        if turned || of("omega(c)").abs() < 0.05 {
            continue;
        }
        let (at, speed, second) = (of("angle(c)"), of("omega(c)"), of("alpha(c)"));
        let sense = if speed < 0.0 { " cw" } else { " ccw" };
        let drive =
            format!("drive c = {at} rad at {} rad/s{sense} accelerating {} rad/s^2", speed.abs(), second);
        for (on, name) in [(0, "crank"), (1, "second")] {
            let text = machine.text(&drive, Some(near), name, "");
            let found = answers(&text);
            let found = found[0].as_ref().unwrap_or_else(|| panic!("{text}"));
            for (what, value) in &known {
                if what == "M" && on == 1 {
                    close(found["M"][0], machine.equilibrium(&known, 1)[11], 1e-6, &text);
                    continue;
                }
                if what.starts_with("reaction") && on == 1 {
                    continue;
                }
                for (x, y) in found[what].iter().zip(value) {
                    close(*x, *y, 1e-6, &format!("{what}\n{text}"));
                }
            }
            let exact = machine.equilibrium(found, on);
            close(found["reaction(k, second)"][1], exact[10], 1e-8, &text);
            for (slot, what) in [
                (0, "reaction(O1, crank)"),
                (2, "reaction(O2, second)"),
                (4, "reaction(A, c)"),
                (6, "reaction(B, d)"),
            ] {
                close(found[what][0], exact[slot], 1e-8, &text);
                close(found[what][1], exact[slot + 1], 1e-8, &text);
            }
            compared += 1;
        }
    }
    assert!(compared > crate::share::least(60), "{compared}");
}

/// Watt's engine driven at the sun: the planet is fixed to the rod, the arm carries it.
struct Watt {
    arm: f64,
    rod: f64,
    sun: f64,
    internal: bool,
}

impl Watt {
    fn new(random: &mut Random) -> Self {
        let arm = random.within(0.1, 0.2);
        let internal = random.sign() < 0.0;
        let sun = if internal { arm * random.within(1.3, 3.0) } else { arm * random.within(0.2, 0.8) };
        Self { arm, rod: arm * random.within(3.0, 5.0), sun, internal }
    }

    fn planet(&self) -> f64 {
        if self.internal { self.sun - self.arm } else { self.arm - self.sun }
    }

    /// The sun turns this times as fast as the rod, both seen from the arm.
    fn ratio(&self) -> f64 {
        if self.internal { self.planet() / self.sun } else { -self.planet() / self.sun }
    }

    fn text(&self, more: &str, mesh: &str) -> String {
        let internal = if self.internal { "internal; " } else { "" };
        format!(
            "ground {{ O (0, 0); line guide through O along 90 deg }}\n\
             link arm O-A {} m\nlink rod A-B {} m {{ wheel planet radius {} m at A }}\nlink head {{ B (0, 0) }}\n\
             link sun {{ O (0, 0); wheel s radius {} m at O }}\n\
             revolute O: ground - arm - sun\nrevolute A: arm - rod\nrevolute B: rod - head\n\
             prismatic D: head.B - ground.guide\nmesh k: planet - s {{ {internal}{mesh} }}\n\
             {more}\nfind angle(arm), angle(rod), angle(sun), omega(arm), omega(rod), omega(sun), velocity(B).y\n",
            self.arm,
            self.rod,
            self.planet(),
            self.sun
        )
    }

    /// Angle and speed of rod and sun, and the speed of the piston, at an angle of the arm with unit speed.
    fn at(&self, arm: f64) -> [f64; 5] {
        // B over O: the rod's x makes up for the arm's
        let cos = -self.arm * arm.cos() / self.rod;
        let sin = (1.0 - cos * cos).sqrt();
        let rod = sin.atan2(cos);
        let rod_speed = self.arm * arm.sin() / (-self.rod * sin);
        let i = self.ratio();
        let v = self.arm * arm.cos() + self.rod * cos * rod_speed;
        [rod, rod_speed, arm + i * (rod - arm), 1.0 + i * (rod_speed - 1.0), v]
    }
}

/// Over several turns, against the closed form of the crank-slider and Willis' formula.
#[test]
fn a_sun_moves_rod_and_arm() {
    let mut random = Random::new(72);
    let mut solved = 0;
    for _ in 0..25 {
        let watt = Watt::new(&mut random);
        let start = random.within(-1.0, 1.0);
        let way = 12.0 * (1.0 - watt.ratio());
        let from = watt.at(start);
        let drive = format!(
            "drive sun = {} rad .. {} rad in 12 steps at 3 rad/s\nassemble A near ({} m, {} m)\nassemble B ahead of O",
            from[2],
            from[2] + way,
            watt.arm * start.cos(),
            watt.arm * start.sin()
        );
        let text = watt.text(&drive, "");
        for (k, found) in answers(&text).iter().enumerate() {
            let Some(found) = found else { continue };
            solved += 1;
            let arm = found["angle(arm)"][0];
            let [rod, rod_speed, sun, sun_speed, v] = watt.at(arm);
            let speed = found["omega(arm)"][0];
            close(found["omega(sun)"][0], speed * sun_speed, 1e-8, &text);
            close(found["omega(rod)"][0], speed * rod_speed, 1e-8, &text);
            close(found["velocity(B).y"][0], speed * v, 1e-8, &text);
            close(found["angle(rod)"][0], rod, 1e-9, &text);
            close(found["angle(sun)"][0], sun, 1e-9, &text);
            close(found["angle(sun)"][0], from[2] + way * k as f64 / 12.0, 1e-12, &text);
        }
    }
    assert!(solved > 150, "{solved}");
}

/// The part of the power that passes through the mesh, seen from the arm, loses its share.
#[test]
fn a_mesh_within_a_chain_loses_its_share() {
    let mut random = Random::new(73);
    let mut solved = 0;
    for _ in 0..60 {
        let watt = Watt::new(&mut random);
        let start = random.within(-3.0, 3.0);
        let from = watt.at(start);
        if from[2].abs() > 3.1 || from[3].abs() < 0.1 {
            continue;
        }
        let (eta, load) = (random.within(0.7, 0.99), random.sign() * random.within(100.0, 1000.0));
        let more = format!(
            "drive sun = {} rad at {} rad/s {}\nassemble A near ({} m, {} m)\nassemble B ahead of O\n\
             force P on head at B = {load} N @ 90 deg\nbalance torque M on sun\nfind M, tangential_force(k)",
            from[2],
            2.0 * from[3].abs(),
            if from[3] < 0.0 { "cw" } else { "ccw" },
            watt.arm * start.cos(),
            watt.arm * start.sin()
        );
        let text = watt.text(&more, &format!("efficiency {eta}; pressure_angle 20 deg"));
        let found = answers(&text);
        let found = found[0].as_ref().unwrap_or_else(|| panic!("{text}"));
        let (through, out) = (2.0 * (from[3] - 1.0), 2.0 * from[3]);
        let given = 2.0 * from[4] * load;
        // M ω_s + P v is what is lost: the sun drives, or is driven
        let both = [1.0 - eta, 1.0 - 1.0 / eta].map(|lost| -given / (out - lost * through));
        let fits: Vec<f64> = both
            .iter()
            .zip([1.0, -1.0])
            .filter(|(m, sign)| **m * through * sign >= 0.0)
            .map(|x| *x.0)
            .collect();
        let [m] = fits[..] else { continue };
        close(found["M"][0], m, 1e-8, &text);
        let driven = if m * through > 0.0 { eta } else { 1.0 };
        close(found["tangential_force(k)"][0], (m / watt.sun).abs() * driven, 1e-8, &text);
        solved += 1;
    }
    assert!(solved > 30, "{solved}");
}

/// All hinges of a five-bar rub and its mesh loses, driven at the crank and at a coupler: `answers` compares with the equations of all bodies.
#[test]
fn hinges_rub_beside_a_mesh_within_a_chain() {
    let mut random = Random::new(74);
    let mut solved = 0;
    for i in 0..60 {
        let machine = FiveBar::new(&mut random);
        let phi = random.within(-3.0, 3.0);
        let rho = random.within(0.0002, 0.003);
        let rub = |text: String| {
            ["O1: ground - crank", "O2: ground - second", "A: crank - c", "B: second - d", "C: c - d"]
                .iter()
                .fold(text, |text, pair| text.replace(pair, &format!("{pair} {{ friction_circle {rho} m }}")))
                + "find efficiency()\n"
        };
        let crank =
            machine.text(&format!("drive crank = {phi} rad at 10 rad/s"), None, "crank", "; efficiency 0.95");
        let crank = rub(crank);
        let Some(Some(known)) = answers(&crank).into_iter().next() else { continue };
        if !known["M"][0].is_finite() {
            continue;
        }
        solved += 1;
        let of = |what: &str| known[what][0];
        let turned =
            ["second", "crank"].iter().any(|n| of(&format!("angle({n})")).abs() > std::f64::consts::PI);
        if i % 2 == 0 || turned || of("omega(c)").abs() < 0.5 {
            continue;
        }
        let (at, speed, second) = (of("angle(c)"), of("omega(c)"), of("alpha(c)"));
        let sense = if speed < 0.0 { "cw" } else { "ccw" };
        let drive =
            format!("drive c = {at} rad at {} rad/s {sense} accelerating {second} rad/s^2", speed.abs());
        let near = [known["position(C)"][0], known["position(C)"][1]];
        let text = rub(machine.text(&drive, Some(near), "crank", "; efficiency 0.95"));
        let found = answers(&text);
        let found = found[0].as_ref().unwrap_or_else(|| panic!("{text}"));
        close(found["M"][0], known["M"][0], 1e-6, &format!("{crank}\n{text}"));
    }
    assert!(solved > 20, "{solved}");
}
