//! Motions of all kinds as text, with random sizes.

use std::fmt::Write;

/// Random numbers of three digits (Steele, Lea and Flood's splitmix).
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ 0x5bd1_e995)
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    #[allow(clippy::cast_precision_loss)]
    pub fn between(&mut self, from: f64, to: f64) -> f64 {
        let part = (self.next() >> 11) as f64 / (1_u64 << 53) as f64;
        let x = from + (to - from) * part;
        (x * 1e4).round() / 1e4
    }

    pub fn one_of<T: Copy>(&mut self, all: &[T]) -> T {
        all[(self.next() % all.len() as u64) as usize]
    }
}

type Write1 = fn(&mut Random) -> String;

/// All kinds by name.
pub const KINDS: [(&str, Write1); 27] = [
    ("pendulum", pendulum),
    ("slider-crank by energy", slider_crank),
    ("four-bar by energy", four_bar),
    ("slider-crank with a motor", motor),
    ("double pendulum", double_pendulum),
    ("damped spring", damped),
    ("stop", stop),
    ("stop that is not hit", stop_afar),
    ("bouncing linkage", bouncing),
    ("guide friction", guide_friction),
    ("friction circles", friction_circles),
    ("two rough blocks", rough_blocks),
    ("brake", brake),
    ("train", train),
    ("change points", change_points),
    ("load when", load_when),
    ("curve of the angle", curve_of_angle),
    ("curve of time", curve_of_time),
    ("shaken", shaken),
    ("cam", cam),
    ("slot friction", slot_friction),
    ("against motion on a line", against_on_line),
    ("against motion of a point", against_of_point),
    ("lossy mesh", lossy_mesh),
    ("three pendulums", three_pendulums),
    ("elastic impacts", elastic),
    ("plastic impacts", plastic),
];

fn pendulum(r: &mut Random) -> String {
    format!(
        "gravity 9.81 m/s^2
ground {{ O (0, 0); Q ({} m, {} m) }}
link b O-P {} m {{ mass {} kg at P; inertia {} kg*m^2 }}
revolute O: ground - b
spring s: ground.Q - b.P {{ stiffness {} N/m; free_length {} m }}
start b = {} deg at {} rad/s
simulate {} s in 7 steps
find angle(b), omega(b), alpha(b)
",
        r.between(1.5, 2.5),
        r.between(-1.0, 1.0),
        r.between(0.3, 0.9),
        r.between(0.5, 3.0),
        r.between(0.0, 0.1),
        r.between(1.0, 80.0),
        r.between(0.1, 0.6),
        r.between(-180.0, 180.0),
        r.between(-8.0, 8.0),
        r.between(1.0, 6.0)
    )
}

fn crank_and_slider(r: &mut Random) -> String {
    let crank = r.between(50.0, 120.0);
    format!(
        "gravity 9.81 m/s^2
ground {{ A (0, 0); line guide through A along {} deg }}
link crank A-B {crank} mm {{ mass {} kg at B; inertia {} kg*m^2 }}
link rod B-C {} mm {{ S (70 mm, 0); mass {} kg at S; inertia 0.006 kg*m^2 }}
link piston {{ C (0, 0); mass {} kg at C }}
revolute A: ground - crank
revolute B: crank - rod
revolute C: rod - piston
assemble C ahead of B
",
        r.between(-90.0, 90.0),
        r.between(0.5, 4.0),
        r.between(0.005, 0.2),
        crank * r.between(2.2, 4.5),
        r.between(0.3, 2.0),
        r.between(0.3, 3.0)
    )
}

fn slider_crank(r: &mut Random) -> String {
    format!(
        "{}prismatic D: piston.C - ground.guide
force F on piston at C = ({} N, {} N)
start crank = {} deg at {} rad/s
simulate {} s in 6 steps
find angle(crank), omega(crank), displacement(D)
",
        crank_and_slider(r),
        r.between(-60.0, 60.0),
        r.between(-60.0, 60.0),
        r.between(10.0, 170.0),
        r.between(-15.0, 15.0),
        r.between(0.3, 2.0)
    )
}

fn four_bar(r: &mut Random) -> String {
    format!(
        "gravity 9.81 m/s^2
ground {{ A (0, 0); D (300 mm, 0) }}
link crank A-B {} mm {{ mass {} kg at B; inertia 0.02 kg*m^2 }}
link coupler B-C {} mm {{ S (120 mm, 30 mm); mass 0.5 kg at S; inertia 0.004 kg*m^2 }}
link rocker D-C {} mm {{ mass {} kg at C; inertia 0.01 kg*m^2 }}
revolute A: ground - crank
revolute B: crank - coupler
revolute C: coupler - rocker
revolute D: ground - rocker
assemble C left of B-D
torque M on crank = {} N*m
start crank = {} deg at {} rad/s
simulate {} s in 5 steps
find angle(crank), omega(rocker), alpha(coupler)
",
        r.between(70.0, 100.0),
        r.between(0.5, 2.0),
        r.between(240.0, 270.0),
        r.between(190.0, 220.0),
        r.between(0.2, 2.0),
        r.between(-2.0, 2.0),
        r.between(0.0, 360.0),
        r.between(-12.0, 12.0),
        r.between(0.3, 3.0)
    )
}

fn motor(r: &mut Random) -> String {
    format!(
        "{}prismatic D: piston.C - ground.guide
torque M on crank = {} N*m - {} N*m*s*omega(crank)
start crank = {} deg at {} rad/s
simulate {} s in 6 steps
find angle(crank), omega(crank), work(M), max(omega(crank))
",
        crank_and_slider(r),
        r.between(2.0, 12.0),
        r.between(0.02, 0.5),
        r.between(0.0, 360.0),
        r.between(0.0, 15.0),
        r.between(0.3, 1.5)
    )
}

fn double_pendulum(r: &mut Random) -> String {
    format!(
        "gravity 9.81 m/s^2
ground {{ O (0, 0) }}
link a O-A {} m {{ mass {} kg at A; inertia 0.01 kg*m^2 }}
link b A-B {} m {{ S (0.17 m, 0.02 m); mass {} kg at S; inertia 0.008 kg*m^2 }}
revolute O: ground - a
revolute A: a - b
start a = {} deg at {} rad/s
start b = {} deg at {} rad/s
simulate {} s in 6 steps
find angle(a), omega(b), alpha(b), reaction(A, b)
",
        r.between(0.3, 0.6),
        r.between(0.5, 2.0),
        r.between(0.3, 0.6),
        r.between(0.3, 1.5),
        r.between(-180.0, 180.0),
        r.between(-3.0, 3.0),
        r.between(-180.0, 180.0),
        r.between(-3.0, 3.0),
        r.between(0.5, 2.0)
    )
}

fn damped(r: &mut Random) -> String {
    format!(
        "{}prismatic D: piston.C - ground.guide
spring s: ground.A - piston.C {{ stiffness {} N/m; free_length {} mm; damping {} N*s/m }}
start crank = {} deg at {} rad/s
simulate {} s in 6 steps
find angle(crank), omega(crank), work(s)
",
        crank_and_slider(r),
        r.between(50.0, 3000.0),
        r.between(100.0, 400.0),
        r.between(0.5, 40.0),
        r.between(0.0, 360.0),
        r.between(-15.0, 15.0),
        r.between(0.3, 1.5)
    )
}

fn stop(r: &mut Random) -> String {
    format!(
        "gravity 9.81 m/s^2
ground {{ O (0, 0) }}
link b O-P {} m {{ mass {} kg at P; inertia {} kg*m^2 }}
revolute O: ground - b
stop O > {} deg {{ restitution {} }}
start b = {} deg
simulate {} s in 6 steps
find angle(b), omega(b)
",
        r.between(0.3, 1.0),
        r.between(0.5, 2.0),
        r.between(0.0, 0.1),
        r.between(-120.0, -70.0),
        r.between(0.3, 0.95),
        r.between(-60.0, 60.0),
        r.between(0.8, 2.5)
    )
}

fn stop_afar(r: &mut Random) -> String {
    let text = slider_crank(r);
    text.replace("start crank", "stop D < 2 m\nstop D > -1 m\nstart crank")
}

fn bouncing(r: &mut Random) -> String {
    let from = r.between(80.0, 100.0);
    format!(
        "{}prismatic D: piston.C - ground.guide
stop D > {} mm {{ restitution {} }}
force F on piston at C = {} N @ {} deg
start crank = {from} deg at {} rad/s
simulate {} s in 6 steps
find angle(crank), omega(crank), displacement(D)
",
        "gravity 9.81 m/s^2
ground { A (0, 0); line guide through A along 0 deg }
link crank A-B 100 mm { mass 1 kg at B; inertia 0.02 kg*m^2 }
link rod B-C 300 mm { S (70 mm, 0); mass 0.7 kg at S; inertia 0.006 kg*m^2 }
link piston { C (0, 0); mass 1.3 kg at C }
revolute A: ground - crank
revolute B: crank - rod
revolute C: rod - piston
assemble C ahead of B
",
        r.between(215.0, 260.0),
        r.between(0.3, 0.95),
        r.between(0.0, 40.0),
        r.between(150.0, 210.0),
        r.between(-5.0, 10.0),
        r.between(0.2, 1.0)
    )
}

fn guide_friction(r: &mut Random) -> String {
    format!(
        "{}prismatic D: piston.C - ground.guide {{ friction {} }}
force F on piston at C = ({} N, 0)
start crank = {} deg at {} rad/s
simulate {} s in 6 steps
find angle(crank), omega(crank), friction_work(D)
",
        crank_and_slider(r),
        r.between(0.02, 0.3),
        r.between(-60.0, 60.0),
        r.between(20.0, 160.0),
        r.between(-15.0, 15.0),
        r.between(0.2, 1.0)
    )
}

fn friction_circles(r: &mut Random) -> String {
    format!(
        "gravity 9.81 m/s^2
ground {{ O (0, 0) }}
link a O-A {} m {{ S (0.2 m, 0); mass 1 kg at S; inertia 0.01 kg*m^2 }}
link b A-B 0.35 m {{ S (0.17 m, 0); mass {} kg at S; inertia 0.008 kg*m^2 }}
revolute O: ground - a {{ friction_circle {} mm }}
revolute A: a - b {{ friction_circle {} mm }}
start a = {} rad at {} rad/s
start b = {} rad at {} rad/s
simulate {} s in 10 steps
find angle(a), omega(b), alpha(b), reaction(A, b)
",
        r.between(0.3, 0.5),
        r.between(0.4, 1.5),
        r.between(1.0, 5.0),
        r.between(1.0, 5.0),
        r.between(-3.0, 3.0),
        r.between(-2.0, 2.0),
        r.between(-3.0, 3.0),
        r.between(-2.0, 2.0),
        r.between(0.5, 2.0)
    )
}

fn rough_blocks(r: &mut Random) -> String {
    format!(
        "gravity 9.81 m/s^2
ground {{ O (0, 0); line slope through O along {} deg }}
link lower {{ A (0, 0); mass {} kg at A }}
link upper {{ B (0, 0); mass 3 kg at B }}
prismatic P: lower.A - ground.slope {{ friction {} }}
prismatic Q: upper.B - ground.slope {{ friction {} }}
spring s: lower.A - upper.B {{ stiffness {} N/m; free_length 300 mm }}
start P = 0 mm at {} m/s
start Q = {} mm
simulate {} s in 10 steps
find displacement(P), displacement(Q), relative_velocity(P)
",
        r.between(0.0, 12.0),
        r.between(1.0, 4.0),
        r.between(0.05, 0.4),
        r.between(0.05, 0.4),
        r.between(50.0, 400.0),
        r.between(0.5, 2.0),
        r.between(250.0, 400.0),
        r.between(0.5, 1.5)
    )
}

fn brake(r: &mut Random) -> String {
    format!(
        "gravity 9.81 m/s^2
ground {{ O (0, 0) }}
link b O-P {} m {{ mass {} kg at P; inertia {} kg*m^2 }}
revolute O: ground - b
torque B on b = {} N*m against motion
start b = {} deg at {} rad/s
simulate {} s in 6 steps
find angle(b), omega(b), work(B)
",
        r.between(0.3, 0.9),
        r.between(0.5, 2.0),
        r.between(0.0, 0.2),
        r.between(0.1, 2.0),
        r.between(-120.0, 90.0),
        r.between(-6.0, 6.0),
        r.between(1.0, 3.0)
    )
}

fn train(r: &mut Random) -> String {
    let (sun, planet) = (r.one_of(&[18, 20, 24]), r.one_of(&[16, 24, 30]));
    format!(
        "shaft S {{ wheel sun teeth {sun} module 2 mm; inertia 0.02 kg*m^2 }}
shaft R {{ wheel ring teeth {}; inertia {} kg*m^2 }}
shaft H {{ inertia {} kg*m^2 }}
shaft P on H {{ wheel p teeth {planet}; mass 1.2 kg; inertia 4e-4 kg*m^2 }}
mesh sp: sun - p
mesh pr: p - ring {{ internal }}
torque M on S = {} N*m - 0.08 N*m*s*omega(S)
torque Q on H = -{} N*m*s*omega(H)
torque B on R = -{} N*m*s*omega(R)
start S at 0 rpm
start R at {} rpm
simulate {} s in 8 steps
find omega(S), omega(H), omega(P)
",
        sun + 2 * planet,
        r.between(0.05, 0.3),
        r.between(0.1, 0.6),
        r.between(5.0, 20.0),
        r.between(0.05, 0.5),
        r.between(0.05, 0.9),
        r.between(0.0, 50.0),
        r.between(2.0, 8.0)
    )
}

fn change_points(r: &mut Random) -> String {
    format!(
        "gravity 9.81 m/s^2
ground {{ A0 (0, 0); A1 (1 m, 0) }}
link r0 A0-B0 {length} m {{ S (0.5 m, 0); mass {} kg at S; inertia 0.08 kg*m^2 }}
link r1 A1-B1 {length} m {{ S (0.5 m, 0); mass {} kg at S; inertia 0.08 kg*m^2 }}
link c1 B0-B1 1 m {{ S (0.5 m, 0); mass {} kg at S; inertia 0.08 kg*m^2 }}
revolute A0: ground - r0
revolute A1: ground - r1
revolute B0: r0 - c1
revolute B1: r1 - c1
assemble B1 near (1 m, {length} m)
start r0 = {} deg at {} rad/s
simulate {} s in 6 steps
find angle(r0), omega(r0), angle(c1)
",
        r.between(0.5, 2.0),
        r.between(0.5, 2.0),
        r.between(0.5, 2.0),
        r.between(60.0, 120.0),
        r.between(-7.0, 7.0),
        r.between(1.0, 4.0),
        length = r.between(0.6, 1.4)
    )
}

fn load_when(r: &mut Random) -> String {
    let when = match r.one_of(&[0, 1, 2, 3]) {
        0 => format!("time > {} s", r.between(0.1, 0.4)),
        1 => format!("relative_velocity(D) > {} m/s", r.between(-0.2, 0.2)),
        2 => format!("displacement(D) > {} mm", r.between(150.0, 350.0)),
        _ => format!("time > {} s and time < {} s", r.between(0.1, 0.2), r.between(0.25, 0.4)),
    };
    format!(
        "{}prismatic D: piston.C - ground.guide
force F on piston at C = ({} N, 0) when {when}
torque M on crank = {} N*m - 0.1 N*m*s*omega(crank)
start crank = {} deg at {} rad/s
simulate {} s in 6 steps
find angle(crank), omega(crank), work(F)
",
        crank_and_slider(r),
        r.between(-60.0, 60.0),
        r.between(1.0, 5.0),
        r.between(0.0, 360.0),
        r.between(0.0, 15.0),
        r.between(0.5, 1.0)
    )
}

fn table(r: &mut Random, from: f64, to: f64, scale: f64) -> String {
    let mut rows = String::new();
    let count = 7;
    for i in 0..=count {
        let x = from + (to - from) * f64::from(i) / f64::from(count);
        let y = if i == count && from == 0.0 { 0.0 } else { r.between(-1.0, 1.0) * scale };
        let y = if i == 0 { 0.0 } else { y };
        let _ = writeln!(rows, "  {x:.4}, {y:.4}");
    }
    rows
}

fn curve_of_angle(r: &mut Random) -> String {
    let how = r.one_of(&["linear periodic", "periodic"]);
    format!(
        "curve p {how} {{\n  phi [deg], M [N*m]\n{}}}\n{}prismatic D: piston.C - ground.guide
torque M on crank = p(angle(crank))
start crank = {} deg at {} rad/s
simulate {} s in 6 steps
find angle(crank), omega(crank)
",
        table(r, 0.0, 360.0, 3.0),
        crank_and_slider(r),
        r.between(0.0, 360.0),
        r.between(-15.0, 15.0),
        r.between(0.3, 1.5)
    )
}

fn curve_of_time(r: &mut Random) -> String {
    let how = r.one_of(&["linear held", "held"]);
    format!(
        "curve p {how} {{\n  t [s], M [N*m]\n{}}}\n{}prismatic D: piston.C - ground.guide
torque M on crank = p(time)
start crank = {} deg at {} rad/s
simulate {} s in 6 steps
find angle(crank), omega(crank)
",
        table(r, 0.0, 1.0, 3.0),
        crank_and_slider(r),
        r.between(0.0, 360.0),
        r.between(-15.0, 15.0),
        r.between(0.5, 1.5)
    )
}

fn shaken(r: &mut Random) -> String {
    format!(
        "gravity 9.81 m/s^2
ground {{ O (0, 0); line way through O along {} deg }}
link base {{ B (0, 0) }}
link b B-P {} m {{ mass 1 kg at P; inertia {} kg*m^2 }}
prismatic G: base.B - ground.way
revolute B: base - b
drive G = {} mm*sin({} 1/s*time)
start b = {} deg
simulate {} s in 6 steps
find angle(b), omega(b), alpha(b)
",
        r.between(0.0, 180.0),
        r.between(0.3, 0.8),
        r.between(0.0, 0.1),
        r.between(10.0, 80.0),
        r.between(2.0, 25.0),
        r.between(-180.0, 180.0),
        r.between(1.0, 3.0)
    )
}

fn cam(r: &mut Random) -> String {
    let laws =
        ["harmonic", "cycloidal", "poly345", "poly4567", "modified_trapezoid", "modified_sine", "parabolic"];
    let motor = r.one_of(&["", " - 0.05 N*m*s*omega(disk)"]);
    format!(
        "gravity 9.81 m/s^2
cam plate {{
  base_radius 50 mm
  turning ccw
  follower translating roller {{ radius 10 mm }}
  rise {} deg through {} mm {}
  dwell 30 deg
  fall 120 deg {}
}}
ground {{ O (0, 0); line way through O along 90 deg }}
link disk {{ O (0, 0); profile rim of plate centre O; mass 1 kg at O; inertia {} kg*m^2 }}
link pl {{ F (0, 0); circle roller centre F radius 10 mm; mass {} kg at F }}
revolute O: ground - disk
prismatic V: pl.F - ground.way
contact K: disk.rim - pl.roller
force sp on pl at F = (0, -{} N - 500 N/m*(displacement(V) - 50 mm))
torque M on disk = {} N*m{motor}
start disk = {} deg at {} rad/s
simulate {} s in 8 steps
find angle(disk), omega(disk), alpha(disk), normal(K, pl)
",
        r.between(90.0, 150.0),
        r.between(5.0, 20.0),
        r.one_of(&laws),
        r.one_of(&laws),
        r.between(0.01, 0.1),
        r.between(0.2, 1.0),
        r.between(200.0, 400.0),
        r.between(-0.5, 1.5),
        r.between(-180.0, 180.0),
        r.between(10.0, 25.0),
        r.between(0.2, 0.6)
    )
}

fn slot_friction(r: &mut Random) -> String {
    format!(
        "ground {{ O (0, 0); line guide through O along 0 deg }}
link a O-B {} m {{ mass 1 kg at O inertia {} kg*m^2 }}
link yoke {{ C (0, 0); line slot through C along 90 deg; mass {} kg at C }}
revolute O: ground - a
slot K: a.B - yoke.slot {{ friction {} }}
prismatic D: yoke.C - ground.guide
force F on yoke at C = (-{} N/m*displacement(D), 0)
torque M on a = {} N*m
start a = {} deg at {} rad/s
simulate {} s in 6 steps
find angle(a), omega(a), alpha(a)
",
        r.between(0.04, 0.1),
        r.between(0.05, 0.2),
        r.between(1.0, 5.0),
        r.between(0.05, 0.2),
        r.between(0.0, 400.0),
        r.between(-3.0, 3.0),
        r.between(0.0, 360.0),
        r.between(6.0, 15.0),
        r.between(0.3, 0.8)
    )
}

fn against_on_line(r: &mut Random) -> String {
    format!(
        "{}prismatic D: piston.C - ground.guide
force F on piston at C = {} N against motion
torque M on crank = {} N*m
start crank = {} deg at {} rad/s
simulate {} s in 6 steps
find angle(crank), omega(crank), work(F)
",
        crank_and_slider(r),
        r.between(2.0, 30.0),
        r.between(-2.0, 5.0),
        r.between(20.0, 160.0),
        r.between(8.0, 15.0),
        r.between(0.2, 0.8)
    )
}

fn against_of_point(r: &mut Random) -> String {
    against_on_line(r).replace("force F on piston at C", "force F on crank at B")
}

/// The torque of the spring makes the power turn round.
fn lossy_mesh(r: &mut Random) -> String {
    format!(
        "shaft S {{ wheel a teeth 20 module 4 mm; inertia {} kg*m^2 }}
shaft T {{ wheel b teeth {} module 4 mm; inertia {} kg*m^2 }}
mesh m: a - b {{ efficiency {} }}
torque M on S = {} N*m - 0.1 N*m*s*omega(S)
torque Q on T = -{} N*m*sin(angle(T))
start S = 0 deg at {} rad/s
simulate {} s in 6 steps
find angle(S), omega(S), alpha(T)
",
        r.between(0.02, 0.2),
        r.between(25.0, 60.0).round(),
        r.between(0.05, 0.5),
        r.between(0.85, 0.99),
        r.between(0.5, 4.0),
        r.between(3.0, 20.0),
        r.between(10.0, 40.0),
        r.between(0.5, 2.0)
    )
}

fn three_pendulums(r: &mut Random) -> String {
    format!(
        "gravity 9.81 m/s^2
ground {{ O (0, 0) }}
link a O-A {} m {{ mass {} kg at A; inertia 0.02 kg*m^2 }}
link b A-B {} m {{ mass {} kg at B; inertia 0.01 kg*m^2 }}
link c B-C {} m {{ mass {} kg at C; inertia 0.01 kg*m^2 }}
revolute O: ground - a
revolute A: a - b
revolute B: b - c
start a = {} rad
start b = {} rad
start c = {} rad
simulate {} s in 6 steps
find angle(a), angle(b), angle(c), alpha(c)
",
        r.between(0.3, 0.6),
        r.between(0.5, 2.0),
        r.between(0.3, 0.6),
        r.between(0.5, 2.0),
        r.between(0.3, 0.6),
        r.between(0.5, 2.0),
        r.between(-3.0, 3.0),
        r.between(-3.0, 3.0),
        r.between(-3.0, 3.0),
        r.between(1.0, 6.0)
    )
}

fn elastic(r: &mut Random) -> String {
    format!(
        "gravity 9.81 m/s^2
ground {{ O (0, 0); line up through O along 90 deg }}
link b {{ B (0, 0); mass 1 kg at B }}
prismatic P: b.B - ground.up
stop P > 0 m {{ restitution 1 }}
force F on b at B = (0, -{} N*s/m*relative_velocity(P) + {} N*sin({} rad/m*displacement(P)))
start P = {} m
simulate {} s in 6 steps
find displacement(P), relative_velocity(P)
",
        r.one_of(&[0.0, 0.1, 0.5]),
        r.between(0.0, 3.0),
        r.between(1.0, 20.0),
        r.between(0.3, 2.0),
        r.between(1.0, 6.0)
    )
}

fn plastic(r: &mut Random) -> String {
    format!(
        "gravity 9.81 m/s^2
ground {{ O (0, 0); line way through O along {} deg }}
link w {{ A (0, 0); mass {} kg at A }}
link p A-B {} m {{ mass {} kg at B; inertia 0.01 kg*m^2 }}
prismatic P: w.A - ground.way
revolute A: w - p
stop P < 0.2 m {{ restitution {} }}
spring s: ground.O - w.A {{ stiffness {} N/m; free_length 0.1 m }}
start P = 0.1 m at {} m/s
start p = {} deg
simulate {} s in 6 steps
find displacement(P), angle(p), omega(p)
",
        r.between(-30.0, 30.0),
        r.between(1.0, 3.0),
        r.between(0.2, 0.6),
        r.between(0.3, 1.0),
        r.one_of(&[0.0, 0.5, 1.0]),
        r.between(20.0, 200.0),
        r.between(1.0, 3.0),
        r.between(-150.0, 60.0),
        r.between(0.5, 2.0)
    )
}
