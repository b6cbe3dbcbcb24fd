//! One line of a good file with a mistake: one message, and help that works when it is pasted.

use crate::paste::{checked, paste};

/// A good file, of which a line is replaced.
const GOOD: &str = r#"mechanism "Four-bar"
given r = 40 mm
given n = 120 rpm
gravity 9.81 m/s^2
ground { A (0, 0); D (120 mm, 10 mm) }
link crank A-B r
link coupler B-C 110 mm { S (60 mm, 15 mm); mass 1.2 kg at S; inertia 0.002 kg*m^2 }
link rocker D-C 90 mm
revolute A: ground - crank
revolute B: crank - coupler
revolute C: coupler - rocker
revolute D: ground - rocker
drive crank = 30 deg at n
assemble C left of B-D
torque load on rocker = 8 N*m cw
force F on coupler at S = 20 N @ 270 deg
balance torque Mb on crank
find Mb, w = omega(rocker)
expect w = 1 rad/s within 5 %
"#;

/// A line, the same with a mistake, and what the help says.
const LINES: &[(&str, &str, &str)] = &[
    ("given r = 40 mm", "given r = 40", "`given r = 40 mm`"),
    ("given r = 40 mm", "given r = 1,420 mm", "write one of\n  given r = 1.420 mm\n  given r = 1420 mm"),
    ("given r = 40 mm", "given r = 5 in", "write: given r = 5 inch"),
    ("given r = 40 mm", "given r = 40 [mm]", "write: given r = 40 mm"),
    ("given r = 40 mm", "given r = 40 milimeter", "write `mm`"),
    ("given r = 40 mm", "set r = 40 mm", "write: given r = 40 mm"),
    ("given r = 40 mm", "r = 40 mm", "write: given r = 40 mm"),
    ("given r = 40 mm", "given r = 40 mm  # crank", "write: given r = 40 mm  // crank"),
    ("given r = 40 mm", "given r = 40 /* crank */ mm", "write: given r = 40 mm  // crank"),
    ("given n = 120 rpm", "given n = 120", "`given n = 120 rpm`"),
    ("given n = 120 rpm", "given n = 120 1/min", "write `given n = 120 rpm` or `given n = 2 rad/s`"),
    ("given n = 120 rpm", "given n = 120 min^-1", "`given n = 120 rpm`"),
    ("given n = 120 rpm", "given n = 2 Hz", "write `given n = 2 rev/s` or `given n = 2 rad/s`"),
    ("given n = 120 rpm", "given n = 12 rad/sec", "write `rad/s`"),
    ("given n = 120 rpm", "given n = 120 U/min", "write `rpm`"),
    ("gravity 9.81 m/s^2", "gravity 9.81 m/sec^2", "write `m/s^2`"),
    ("gravity 9.81 m/s^2", "gravity 9.81 m/s2", "write `m/s^2`"),
    ("gravity 9.81 m/s^2", "gravity 9,81 m/s^2", "write: gravity 9.81 m/s^2"),
    ("gravity 9.81 m/s^2", "/* w */ gravity 9.81 m/s^2", "write: gravity 9.81 m/s^2  // w"),
    (
        "find Mb, w = omega(rocker)",
        "find Mb, velocity C, w = omega(rocker)",
        "write: find Mb, velocity(C), w = omega(rocker)",
    ),
    ("find Mb, w = omega(rocker)", "find Mb, w = omega rocker", "write: find Mb, w = omega(rocker)"),
    (
        "find Mb, w = omega(rocker)",
        "find reactions Mb, w = omega(rocker)",
        "write: find reactions, Mb, w = omega(rocker)",
    ),
    (
        "find Mb, w = omega(rocker)",
        "find positions Mb, w = omega(rocker)",
        "write: find positions, Mb, w = omega(rocker)",
    ),
    (
        "find Mb, w = omega(rocker)",
        "find velocities Mb, w = omega(rocker)",
        "write: find velocities, Mb, w = omega(rocker)",
    ),
    (
        "find Mb, w = omega(rocker)",
        "find accelerations Mb, w = omega(rocker)",
        "write: find accelerations, Mb, w = omega(rocker)",
    ),
    (
        "ground { A (0, 0); D (120 mm, 10 mm) }",
        "ground { A (0, 0); D (120 mm; 10 mm) }",
        "write: ground { A (0, 0); D (120 mm, 10 mm) }",
    ),
    (
        "ground { A (0, 0); D (120 mm, 10 mm) }",
        "ground { A (0, 0) D (120 mm, 10 mm) }",
        "write: ground { A (0, 0); D (120 mm, 10 mm) }",
    ),
    (
        "ground { A (0, 0); D (120 mm, 10 mm) }",
        "ground { A [0, 0]; D (120 mm, 10 mm) }",
        "write: ground { A (0, 0); D (120 mm, 10 mm) }",
    ),
    (
        "ground { A (0, 0); D (120 mm, 10 mm) }",
        "frame { A (0, 0); D (120 mm, 10 mm) }",
        "write: ground { A (0, 0); D (120 mm, 10 mm) }",
    ),
    ("link crank A-B r", "bar crank A-B r", "write: link crank A-B r"),
    ("link crank A-B r", "link crank A-B 2 r", "write `2*r`"),
    ("link crank A-B r", "link cra\u{200B}nk A-B r", "write: link crank A-B r"),
    ("link crank A-B r", "link crank\u{200B} A-B r", "write: link crank A-B r"),
    ("link crank A-B r", "link crank A-B 2 cos(0)*r/2", "write: link crank A-B 2*cos(0)*r/2"),
    ("link crank A-B r", "link crank A-B 40 mm mm", "write: link crank A-B 40 mm"),
    ("given r = 40 mm", "given r = 1'500 mm", "write: given r = 1500 mm"),
    ("given r = 40 mm", "given r = 1.500,5 mm", "write: given r = 1500.5 mm"),
    ("given r = 40 mm", "r := 40 mm", "write: given r = 40 mm"),
    ("given n = 120 rpm", "given n = 120 min-1", "write `120 rpm` or `2 rad/s`"),
    ("given n = 120 rpm", "given n = 120 /min", "write `120 rpm` or `2 rad/s`"),
    ("gravity 9.81 m/s^2", "gravity 9.81 m/s^2 % weight", "write: gravity 9.81 m/s^2 // weight"),
    ("link crank A-B r", "crank A-B r", "write: link crank A-B r"),
    ("link crank A-B r", "link crank A-B length r", "write: link crank A-B r"),
    ("revolute A: ground - crank", "revolute joint A: ground - crank", "write: revolute A: ground - crank"),
    ("drive crank = 30 deg at n", "drive crank = 30 deg with n", "write: drive crank = 30 deg at n"),
    ("assemble C left of B-D", "assemble C is left of B-D", "write: assemble C left of B-D"),
    ("torque load on rocker = 8 N*m cw", "torque load on rocker = 8 N-m cw", "write `8 N*m`"),
    ("torque load on rocker = 8 N*m cw", "torque load on rocker = 8 lb*ft cw", "write `8 lbf*ft`"),
    (
        "torque load on rocker = 8 N*m cw",
        "torque load rocker = 8 N*m cw",
        "write: torque load on rocker = 8 N*m cw",
    ),
    (
        "force F on coupler at S = 20 N @ 270 deg",
        "force F on coupler at S = 20 N at 270 deg",
        "write: force F on coupler at S = 20 N @ 270 deg",
    ),
    (
        "force F on coupler at S = 20 N @ 270 deg",
        "force F on S of coupler = 20 N @ 270 deg",
        "write: force F on coupler at S = 20 N @ 270 deg",
    ),
    (
        "ground { A (0, 0); D (120 mm, 10 mm) }",
        "ground { A (0, 0); D (120, 10) mm }",
        "write: ground { A (0, 0); D (120 mm, 10 mm) }",
    ),
    (
        "ground { A (0, 0); D (120 mm, 10 mm) }",
        "ground { A (0, 0); point D (120 mm, 10 mm) }",
        "write: ground { A (0, 0); D (120 mm, 10 mm) }",
    ),
    (
        "ground { A (0, 0); D (120 mm, 10 mm) }",
        "ground { A (0, 0); D 120 mm, 10 mm }",
        "write: ground { A (0, 0); D (120 mm, 10 mm) }",
    ),
    (
        "find Mb, w = omega(rocker)",
        "find Mb, w = omega(rocker) [rpm]",
        "write: find Mb, w = omega(rocker) as rpm",
    ),
    ("expect w = 1 rad/s within 5 %", "expect w = 1 rad/s (5 %)", "write: expect w = 1 rad/s within 5 %"),
    (
        "expect w = 1 rad/s within 5 %",
        "expect w is 1 rad/s within 5 %",
        "write: expect w = 1 rad/s within 5 %",
    ),
    ("link crank A-B r", "link crank A-B r r", "write: link crank A-B r"),
    ("link crank A-B r", "link crank A-B r²/r", "write: link crank A-B r^2/r"),
    (
        "link coupler B-C 110 mm { S (60 mm, 15 mm); mass 1.2 kg at S; inertia 0.002 kg*m^2 }",
        "link coupler B-C 110 mm { S (60 mm, 15 mm) mass 1.2 kg at S inertia 0.002 kg*m^2 }",
        "{ S (60 mm, 15 mm); mass 1.2 kg at S inertia 0.002 kg*m^2 }",
    ),
    (
        "link coupler B-C 110 mm { S (60 mm, 15 mm); mass 1.2 kg at S; inertia 0.002 kg*m^2 }",
        "link coupler B-C 110 mm { S (60 mm, 15 mm); mass 1.2 kg at S; inertia 0.002 kg*m2 }",
        "write `kg*m^2`",
    ),
    ("revolute A: ground - crank", "pin A: ground - crank", "write: revolute A: ground - crank"),
    ("revolute A: ground - crank", "A: ground - crank", "write: revolute A: ground - crank"),
    ("revolute A: ground - crank", "revolute A: ground - crank -", "write: revolute A: ground - crank"),
    ("drive crank = 30 deg at n", "drive crank = 30 at n", "write `30 deg`"),
    ("drive crank = 30 deg at n", "drive crank = 22,5 deg at n", "write: drive crank = 22.5 deg at n"),
    ("drive crank = 30 deg at n", "drive crank = 30 grad at n", "write `deg` or `gon`"),
    ("drive crank = 30 deg at n", "drive crank = 30 deg at 3 Hz", "write `3 rev/s` or `3 rad/s`"),
    ("drive crank = 30 deg at n", "drive crank = 30 deg at 90", "write `90 rpm`"),
    ("drive crank = 30 deg at n", "motor crank = 30 deg at n", "write: drive crank = 30 deg at n"),
    ("torque load on rocker = 8 N*m cw", "torque load on rocker = 8 Nm cw", "write `N*m`"),
    (
        "torque load on rocker = 8 N*m cw",
        "moment load on rocker = 8 N*m cw",
        "write: torque load on rocker = 8 N*m cw",
    ),
    (
        "force F on coupler at S = 20 N @ 270 deg",
        "force F on coupler.S = 20 N @ 270 deg",
        "write: force F on coupler at S = 20 N @ 270 deg",
    ),
    (
        "force F on coupler at S = 20 N @ 270 deg",
        "force F on coupler at S = 20 N downwards",
        "write: force F on coupler at S = 20 N down",
    ),
    (
        "force F on coupler at S = 20 N @ 270 deg",
        "force F on coupler at S = 20 N to the right",
        "write: force F on coupler at S = 20 N @ 0 deg",
    ),
    ("find Mb, w = omega(rocker)", "find Mb; w = omega(rocker)", "write: find Mb, w = omega(rocker)"),
    ("find Mb, w = omega(rocker)", "print Mb, w = omega(rocker)", "write: find Mb, w = omega(rocker)"),
    (
        "find Mb, w = omega(rocker)",
        "find Mb, w = omega(rocker) in rpm",
        "write: find Mb, w = omega(rocker) as rpm",
    ),
    ("expect w = 1 rad/s within 5 %", "expect w = 1 rad/s +- 5 %", "write: expect w = 1 rad/s within 5 %"),
    ("expect w = 1 rad/s within 5 %", "expect w = 1 rad/s +/- 5 %", "write: expect w = 1 rad/s within 5 %"),
    (
        "expect w = 1 rad/s within 5 %",
        "expect w ~ 1 rad/s within 5 %",
        "write: expect w = 1 rad/s within 5 %",
    ),
    (
        "expect w = 1 rad/s within 5 %",
        "expect w = 1 rad/s at 30 deg",
        "write: expect w = 1 rad/s at crank = 30 deg",
    ),
    ("link crank A-B r", "link crank A-B 0.5 x r", "write: link crank A-B 0.5 * r"),
    ("link crank A-B r", "link crank r A-B", "write: link crank A-B r"),
    (
        "link crank A-B r",
        "link crank A-B r { mass 1 kg at A; torque T on crank = 1 N*m }",
        "write: link crank A-B r { mass 1 kg at A }; torque T on crank = 1 N*m",
    ),
    ("given n = 120 rpm", "gegeben n = 120 rpm", "write: given n = 120 rpm"),
    ("link rocker D-C 90 mm", "stab rocker D-C 90 mm", "write: link rocker D-C 90 mm"),
    ("given n = 120 rpm", "given n = 120 об/мин", "write `rev/min`"),
    ("revolute A: ground - crank", "revolute A: ground -> crank", "write: revolute A: ground - crank"),
    ("revolute A: ground - crank", "revolute 1A: ground - crank", "write: revolute A: ground - crank"),
    ("drive crank = 30 deg at n", "drive crank = 30 deg speed n", "write: drive crank = 30 deg at n"),
    ("drive crank = 30 deg at n", "drive crank at n = 30 deg", "write: drive crank = 30 deg at n"),
    ("assemble C left of B-D", "assemble C to the left of B-D", "write: assemble C left of B-D"),
    ("drive crank = 30 deg at n", "drive crank 30 deg at n", "write: drive crank = 30 deg at n"),
    ("drive crank = 30 deg at n", "drive crank = 30 deg at a speed of n", "write: drive crank = 30 deg at n"),
    ("drive crank = 30 deg at n", "drive crank = 30 deg at speed n", "write: drive crank = 30 deg at n"),
    ("link rocker D-C 90 mm", "link rocker from D to C 90 mm", "write: link rocker D-C 90 mm"),
    ("link rocker D-C 90 mm", "link rocker DC 90 mm", "write: link rocker D-C 90 mm"),
    (
        "expect w = 1 rad/s within 5 %",
        "expect w = 1 rad/s at crank = 30 deg within 5 %",
        "write: expect w = 1 rad/s within 5 % at crank = 30 deg",
    ),
    (
        "force F on coupler at S = 20 N @ 270 deg",
        "force F on coupler at S = 20 N at an angle of 270 deg",
        "write: force F on coupler at S = 20 N @ 270 deg",
    ),
    (
        "torque load on rocker = 8 N*m cw",
        "torque load on rocker = 8 N*m opposite to motion",
        "write: torque load on rocker = 8 N*m against motion",
    ),
    (
        "torque load on rocker = 8 N*m cw",
        "torque load on rocker = 8 N*m opposite motion",
        "write: torque load on rocker = 8 N*m against motion",
    ),
    (
        "torque load on rocker = 8 N*m cw",
        "torque load on rocker = 8 N*m cw if omega(rocker) > 0 rad/s",
        "= 8 N*m cw when omega(rocker) > 0 rad/s",
    ),
    (
        "ground { A (0, 0); D (120 mm, 10 mm) }",
        "ground { A (0, 0); D (120 mm, 10 mm); line g along 0 deg }",
        "write one of\n  ground { A (0, 0); D (120 mm, 10 mm); line g through A along 0 deg }",
    ),
    (
        "ground { A (0, 0); D (120 mm, 10 mm) }",
        "ground { A (0, 0); D (120 mm, 10 mm); circle c centre A diameter 50 mm }",
        "circle c centre A radius 25 mm }",
    ),
    ("find Mb, w = omega(rocker)", "find Mb w = omega(rocker)", "write: find Mb, w = omega(rocker)"),
    ("mechanism \"Four-bar\"", "mechanism “Four-bar”", "write: mechanism \"Four-bar\""),
    ("mechanism \"Four-bar\"", "mechanism „Four-bar“", "write: mechanism \"Four-bar\""),
];

#[test]
fn a_line_with_a_mistake() {
    assert!(checked(GOOD).is_empty());
    for (good, bad, wanted) in LINES {
        assert!(GOOD.contains(good), "{good}");
        let text = GOOD.replacen(good, bad, 1);
        let found = checked(&text);
        assert_eq!(found.len(), 1, "{bad}: {found:#?}");
        let help = found[0].help.as_deref().unwrap_or_default();
        assert!(help.contains(wanted), "{bad}: {help}");
        assert!(paste(&text, &found, checked, bad) > 0, "{bad}: {help}");
    }
}

/// Units that are read as they are written.
#[test]
fn units_of_many_countries() {
    for (unit, si) in [
        ("bar", 1e5),
        ("psi", 6_894.757_293_168_36),
        ("hp", 745.699_871_582_270_2),
        ("PS", 735.498_75),
        ("kp", 9.806_65),
        ("gon", std::f64::consts::PI / 200.0),
        ("ft", 0.3048),
        ("inch", 0.0254),
        ("um", 1e-6),
        ("N m", 1.0),
        ("N.m", 1.0),
        ("kg m^2", 1.0),
        ("kg·m²", 1.0),
        ("kN m", 1e3),
        ("N.mm", 1e-3),
    ] {
        let found = assur::internals::units::lookup(unit).unwrap_or_else(|e| panic!("{unit}: {e}")).factor;
        assert!((found / si - 1.0).abs() < 1e-14, "{unit}: {found}");
        let read = checked(&format!("given x = 5 {unit}\nfind y = 2*x\n"));
        assert!(read.is_empty(), "{unit}: {read:#?}");
    }
}
