//! Machines of the textbook as texts, with wild proportions: four-bars, crank-sliders, slotted bars, gears, cams, cylinders,
//! Geneva wheels, trains.

use crate::bars::Tally;
use crate::drawn::{Shown, solved};
use crate::support::random::Random;
use assur::internals::math::Vec2;
use assur::internals::picture::KINDS;
use std::fmt::Write;

/// Draws the machine of a number; whether it is solved.
pub fn judge(seed: u64, tally: &mut Tally) -> bool {
    let text = machine(seed);
    let name = format!("machine {seed}");
    let Some((source, solved)) = solved(&name, &text) else { return false };
    let shown = Shown::of(&source, &solved);
    for kind in KINDS {
        for (pose, sheet) in shown.sheets(kind, true) {
            tally.judge(&shown, kind, pose, &sheet);
        }
    }
    true
}

/// A text that is being written.
struct Maker {
    random: Random,
    /// The size of the machine, m.
    size: f64,
    text: String,
}

/// The text of a number.
pub fn machine(seed: u64) -> String {
    let mut random = Random::new(seed ^ 0x51ed);
    let size = if random.chance(0.3) { libm::exp10(random.within(-5.0, 3.0)) } else { 0.2 };
    let mut maker = Maker { random, size, text: String::from("gravity 9.81 m/s^2\n") };
    match seed % 8 {
        0 => maker.four_bar(),
        1 => maker.crank_slider(),
        2 => maker.slotted_bar(),
        3 => maker.pin_in_slot(),
        4 => maker.geared(),
        5 => maker.cam(),
        6 => maker.cylinder(),
        _ => maker.train(),
    }
    maker.text
}

impl Maker {
    /// A length from tiny to large beside the others, m.
    fn length(&mut self) -> f64 {
        let wild = self.random.chance(0.3);
        self.size
            * if wild { libm::exp10(self.random.within(-1.7, 0.7)) } else { self.random.within(0.4, 1.5) }
    }

    fn spot(&mut self) -> Vec2 {
        self.random.direction() * self.length()
    }

    fn line(&mut self, line: &str) {
        self.text += line;
        self.text.push('\n');
    }

    /// A mass, a named point and its number: what is in the braces of a link.
    fn body(&mut self, name: &str, reach: f64) -> String {
        let (x, y) = (self.random.within(-0.2, 1.2) * reach, self.random.within(-0.4, 0.4) * reach);
        let y = if self.random.chance(0.6) { 0.0 } else { y };
        if self.random.chance(0.3) {
            return String::new();
        }
        let mass = self.random.within(0.1, 5.0);
        let inertia = mass * self.size * self.size * self.random.within(0.01, 0.2);
        format!(" {{ {name} ({x:?} m, {y:?} m); mass {mass:?} kg at {name}; inertia {inertia:?} kg*m^2 }}")
    }

    /// Friction in all hinges.
    fn hinges(&mut self) {
        if self.random.chance(0.4) {
            let radius = self.size * libm::exp10(self.random.within(-4.0, -1.5));
            self.line(&format!("all revolute {{ friction_circle {radius:?} m }}"));
        }
    }

    /// A drive of a link over its turn, or at one position; the balance.
    fn drive(&mut self, link: &str, angle: f64, turns: bool) {
        let speed = self.random.signed(0.5, 60.0);
        let degrees = angle.to_degrees();
        let way = if turns && self.random.chance(0.5) {
            format!("{degrees:?} deg .. {:?} deg in 6 steps", degrees + 360.0 * speed.signum())
        } else {
            format!("{degrees:?} deg")
        };
        self.line(&format!("drive {link} = {way} at {speed:?} rad/s"));
        if self.random.chance(0.8) {
            self.line(&format!("balance torque Mb on {link}"));
        }
    }

    fn crank(&mut self) -> (f64, f64, Vec2) {
        let (r, angle) = (self.length(), self.random.within(-3.1, 3.1));
        let body = self.body("S1", r);
        self.line(&format!("link 1 crank A-B {r:?} m{body}"));
        (r, angle, Vec2::direction(angle) * r)
    }

    fn four_bar(&mut self) {
        self.hinges();
        let (r, angle, b) = self.crank();
        let (d, c) = (self.spot(), self.spot());
        let (l, q, f) = ((c - b).norm(), (c - d).norm(), d.norm());
        let largest = l.max(q).max(f);
        let turns = 2.0 * largest + r < (l + q + f) * 0.98 && r < l.min(q).min(f);
        let left = (b - d).cross(c - d) < 0.0;
        let side = if left { "left" } else { "right" };
        let (coupler, rocker) = (self.body("S2", l), self.body("S3", q));
        self.line(&format!("ground 4 {{ A (0, 0); D ({:?} m, {:?} m) }}", d.x, d.y));
        self.line(&format!("link 2 coupler B-C {l:?} m{coupler}\nlink 3 rocker D-C {q:?} m{rocker}"));
        self.line("revolute A: ground - crank\nrevolute B: crank - coupler");
        self.line("revolute C: coupler - rocker\nrevolute D: ground - rocker");
        self.line(&format!("assemble C {side} of B-D"));
        self.drive("crank", angle, turns);
        let torque = self.random.signed(0.1, 50.0);
        self.line(&format!("torque M on rocker = {torque:?} N*m"));
        if self.random.chance(0.4) {
            let stiffness = self.random.within(1.0, 500.0);
            let free = f * self.random.within(0.2, 2.0);
            let what = format!("stiffness {stiffness:?} N/m; free_length {free:?} m");
            self.line(&format!("spring k: ground.A - rocker.C {{ {what} }}"));
        }
        self.line("find omega(rocker), Mr = moment(A, crank), reactions");
    }

    fn crank_slider(&mut self) {
        self.hinges();
        let (r, angle, _) = self.crank();
        let offset = if self.random.chance(0.5) { 0.0 } else { self.random.signed(0.1, 0.9) * r };
        let l = (r + offset.abs()) * self.random.within(1.02, 6.0);
        let (rod, piston) = (self.body("S2", l), self.body("S3", r));
        let tilt = self.random.within(-180.0, 180.0).round();
        let across = Vec2::direction(tilt.to_radians()).perp() * offset;
        let friction = if self.random.chance(0.3) { " { friction 0.1 }" } else { "" };
        let place = format!("Q ({:?} m, {:?} m)", across.x, across.y);
        self.line(&format!("ground 4 {{ A (0, 0); {place}; line guide through Q along {tilt:?} deg }}"));
        let piston =
            if piston.is_empty() { " { C (0, 0) }".into() } else { piston.replace(" {", " { C (0, 0);") };
        self.line(&format!("link 2 rod B-C {l:?} m{rod}\nlink 3 piston{piston}"));
        self.line("revolute A: ground - crank\nrevolute B: crank - rod\nrevolute C: rod - piston");
        self.line(&format!("prismatic H: piston.C - ground.guide{friction}\nassemble C ahead of B"));
        let force = self.random.within(1.0, 5000.0);
        self.line(&format!("force F on piston at C = {force:?} N against motion"));
        self.drive("crank", angle, true);
        self.line("find travel(H), reactions");
    }

    fn slotted_bar(&mut self) {
        let (r, angle, _) = self.crank();
        let far = r * self.random.within(1.1, 5.0);
        let body = self.body("S4", far + r);
        self.line(&format!("ground {{ A (0, 0); D (0, {:?} m) }}", -far));
        self.line("link 2 block { B (0, 0) }");
        let bar = body.trim_start_matches(" {").trim_end_matches(" }").to_owned();
        let bar = if bar.is_empty() { String::new() } else { format!("; {bar}") };
        self.line(&format!("link 3 bar {{ D (0, 0); line way through D along 0 deg{bar} }}"));
        self.line("revolute A: ground - crank\nrevolute B: crank - block\nrevolute D: ground - bar");
        self.line("prismatic s: block.B - bar.way\nassemble s > 0");
        self.line("torque M on bar = 3 N*m");
        self.drive("crank", angle, true);
        self.line("find omega(bar), reactions");
    }

    fn pin_in_slot(&mut self) {
        let (r, angle, _) = self.crank();
        if self.random.chance(0.5) {
            let slots = 3 + self.random.below(6);
            let far = r / libm::sin(std::f64::consts::PI / slots as f64);
            let near = self.random.within(-20.0, 20.0).to_radians();
            self.line(&format!("ground {{ A (0, 0); C ({far:?} m, 0) }}"));
            self.line("link 2 wheel { C (0, 0); line slot through C along 0 deg; inertia 0.002 kg*m^2; mass 1 kg at C }");
            self.line("revolute A: ground - crank\nrevolute C: ground - wheel");
            self.line(&format!(
                "slot K: crank.B - wheel.slot {{ slots {slots} }}\ntorque L on wheel = 0.3 N*m"
            ));
            self.drive("crank", near, true);
            self.line("find normal(K, wheel)");
        } else {
            self.line("ground { A (0, 0); line way through A along 0 deg }");
            self.line("link 2 yoke { P (0, 0); line slot through P along 90 deg; mass 2 kg at P }");
            self.line(
                "revolute A: ground - crank\nprismatic H: yoke.P - ground.way\nslot K: crank.B - yoke.slot",
            );
            self.drive("crank", angle, true);
            self.line("find normal(K, yoke)");
        }
    }

    fn geared(&mut self) {
        let (z1, z2) = (12 + self.random.below(40), 12 + self.random.below(90));
        let module = self.size / 40.0;
        let e = module * (z1 + z2) as f64 / 2.0;
        let (r, q) = (self.random.within(0.05, 0.5) * e, self.random.within(0.05, 0.5) * e);
        let l = (e + r + q) * self.random.within(0.7, 1.5);
        self.line(&format!("ground {{ A (0, 0); D ({e:?} m, 0) }}"));
        self.line(&format!("link crank A-B {r:?} m {{ wheel z1 teeth {z1} module {module:?} m at A }}"));
        self.line(&format!("link second D-E {q:?} m {{ wheel z2 teeth {z2} at D }}"));
        self.line(&format!("link c B-C {l:?} m\nlink d E-C {l:?} m"));
        self.line("revolute A: ground - crank\nrevolute D: ground - second\nrevolute B: crank - c");
        self.line("revolute E: second - d\nrevolute C: c - d");
        let phase = self.random.within(0.0, 360.0);
        self.line(&format!("mesh k: z1 - z2 {{ phase {phase:?} deg; pressure_angle 20 deg }}"));
        self.line("assemble C left of B-E\nforce P on c at C = 200 N @ 270 deg");
        let angle = self.random.within(-3.0, 3.0);
        self.drive("crank", angle, false);
        self.line("find omega(second), reactions");
    }

    fn cam(&mut self) {
        let base = self.size * 50e-3;
        let lift = base * self.random.within(0.05, 0.9);
        let law = ["parabolic", "harmonic", "cycloidal", "poly345", "modified_sine"][self.random.below(5)];
        let roller = base * self.random.within(0.05, 0.4);
        let offset = if self.random.chance(0.5) { 0.0 } else { base * self.random.within(-0.4, 0.4) };
        let (rise, fall) = (60 + 10 * self.random.below(9), 60 + 10 * self.random.below(9));
        let _ = write!(
            self.text,
            "cam plate {{\n  base_radius {base:?} m\n  turning ccw\n  follower translating roller {{ radius {roller:?} m; offset {offset:?} m }}\n  rise {rise} deg through {lift:?} m {law}\n  dwell 30 deg\n  fall {fall} deg {law}\n}}\n"
        );
        if self.random.chance(0.4) {
            self.line("find profile(plate) in 12 steps, max(pressure_angle(plate))");
            return;
        }
        let place = format!("G ({offset:?} m, 0)");
        self.line(&format!("ground {{ O (0, 0); {place}; line way through G along 90 deg }}"));
        self.line("link disk { O (0, 0); profile rim of plate centre O }");
        self.line(&format!(
            "link plunger {{ P (0, 0); circle roller centre P radius {roller:?} m; mass 1 kg at P }}"
        ));
        self.line("revolute O: ground - disk\nprismatic V: plunger.P - ground.way");
        self.line("contact K: disk.rim - plunger.roller\nforce F on plunger at P = 50 N @ -90 deg");
        let angle = self.random.within(-3.0, 3.0);
        self.drive("disk", angle, true);
        self.line("find travel(V), normal(K, plunger), pressure_angle(K)");
    }

    fn cylinder(&mut self) {
        let (boom, high) = (self.length(), self.length());
        let at = boom * self.random.within(0.15, 0.9);
        let angle = self.random.within(0.2, 1.2);
        let foot = Vec2::new(self.random.within(0.2, 1.0) * boom, -high);
        let s = (Vec2::direction(angle) * at - foot).norm();
        self.line(&format!("ground {{ A (0, 0); G ({:?} m, {:?} m) }}", foot.x, foot.y));
        self.line(&format!("link 1 boom A-B {boom:?} m {{ K ({at:?} m, 0); mass 40 kg at B }}"));
        self.line("revolute A: ground - boom\ncylinder lift: ground.G - boom.K");
        let place = Vec2::direction(angle) * boom;
        self.line(&format!(
            "drive lift = {s:?} m at 0.01 m/s\nassemble B near ({:?} m, {:?} m)",
            place.x, place.y
        ));
        self.line("balance force F in lift\nfind F, reaction(A, boom)");
    }

    fn train(&mut self) {
        let stages = 1 + self.random.below(5);
        self.text.clear();
        for i in 0..=stages {
            let (z, q) = (12 + self.random.below(40), 20 + self.random.below(120));
            self.line(&format!(
                "shaft s{i} {{ wheel a{i} teeth {z} module 2 mm; wheel b{i} teeth {q} module 2 mm }}"
            ));
        }
        for i in 0..stages {
            let internal = if self.random.chance(0.2) { " { internal }" } else { "" };
            self.line(&format!("mesh m{i}: a{i} - b{}{internal}", i + 1));
        }
        let speed = self.random.signed(1.0, 300.0);
        self.line(&format!("drive s0 at {speed:?} rad/s\ntorque M on s{stages} = 30 N*m cw"));
        self.line(&format!("find omega(s{stages}), effort(s0)"));
    }
}
