//! Values, dimensions, units and questions as `check` understands them.

use assur::internals::check::Overrides;
use assur::internals::diagnostic::{Style, render};
use assur::internals::model::{At, BinaryOp, Expr, FindKind, Mechanism, Query, Relation, Tolerance, Value};
use assur::internals::source::Source;

const CRANK_SLIDER: &str = "
ground { A (0, 0); line guide through A along 0 deg }
link crank A-B 100 mm
link rod B-C 350 mm
link piston { C (0, 0); mass 2 kg at C }
revolute A: ground - crank
revolute B: crank - rod
revolute C: rod - piston
prismatic D: piston.C - ground.guide
group bc: rod, piston
assemble C ahead of B
";

fn read(text: &str, set: &[(&str, &str)]) -> Result<Mechanism, String> {
    let source = Source::new("text.mech", text);
    let values = set.iter().map(|(n, v)| ((*n).to_owned(), (*v).to_owned())).collect();
    let (mechanism, problems) = assur::internals::check_source(&source, &Overrides::set(values));
    mechanism.ok_or_else(|| render(&problems, &source, Style::PLAIN))
}

fn number(mechanism: &Mechanism, name: &str) -> f64 {
    match mechanism.values.iter().find(|v| v.name == name).map(|v| v.value) {
        Some(Value::Scalar(x)) => x,
        other => panic!("{name} is {other:?}"),
    }
}

fn value_of(expr: &str) -> Result<f64, String> {
    let text = format!("given r = 200 mm\ngiven omega = 30 rad/s\ngiven phi = 60 deg\nlet x = {expr}\n");
    read(&text, &[]).map(|m| number(&m, "x"))
}

fn crank_slider(drive: &str, rest: &str) -> Result<Mechanism, String> {
    read(&format!("{CRANK_SLIDER}drive crank = {drive}\n{rest}\n"), &[])
}

#[test]
fn values_in_si() {
    let cases = [
        ("2 + 3 * 4 - 6 / 2", 11.0),
        ("2^3^2", 512.0),
        ("-2^2", -4.0),
        ("3.5 * r", 0.7),
        ("21 N / (9.81 m/s^2)", 21.0 / 9.81),
        ("60 N*m", 60.0),
        ("0.5 * 90 deg", std::f64::consts::FRAC_PI_4),
        ("sin(phi)^2 + cos(phi)^2", 1.0),
        ("mag((3 m, 4 m))", 5.0),
        ("(100 N @ 90 deg).y", 100.0),
        ("dot((1 m, 2 m), (3 N, 4 N))", 11.0),
        ("cross((1 m, 0), (0, 2 N))", 2.0),
        ("dir((0, 2 m))", std::f64::consts::FRAC_PI_2),
        ("atan2(1 m, 1 m)", std::f64::consts::FRAC_PI_4),
        ("max(1 mm, 2 cm, 3 mm)", 0.02),
        ("sqrt(r * 0.8 m)", 0.4),
        ("12 %", 0.12),
        ("abs(-3 mm)", 0.003),
    ];
    for (expr, si) in cases {
        let x = value_of(expr).unwrap_or_else(|e| panic!("{expr}\n{e}"));
        assert!((x - si).abs() <= 1e-14 * si.abs(), "{expr}: {x} against {si}");
    }
}

#[test]
fn an_angle_is_a_kind() {
    for fine in [
        "phi + pi",
        "phi * 2 / 3",
        "omega * r + 1 m/s",
        "2 m/s / r + omega",
        "20 1/s + omega",
        "omega^2 * r + 1 m/s^2",
        "omega * 2 s + phi",
        "sin(phi + omega * 1 s)",
        "1/phi * phi + 1",
        "2 * pi * 25 Hz + omega",
        "r / (2 m) + 0.5",
        "0 + phi",
        "60 N*m * phi + 5 J",
        "phi / phi + 1",
    ] {
        value_of(fine).unwrap_or_else(|e| panic!("{fine}\n{e}"));
    }
    for (wrong, code) in [
        ("phi + 1", "unit::operands"),
        ("sin(0.5)", "unit::missing"),
        ("omega + 25 Hz", "unit::operands"),
        ("r + phi", "unit::operands"),
        ("acos(phi)", "unit::mismatch"),
        ("sqrt(r)", "unit::power"),
    ] {
        let said = value_of(wrong).expect_err(wrong);
        assert!(said.contains(code), "{wrong}\n{said}");
    }
}

#[test]
fn values_from_outside() {
    let text = "given r = 100 mm\ngiven l = 4 * r\nlet d = 2 * l\n";
    let of = |set: &[(&str, &str)]| read(text, set).map(|m| number(&m, "d"));
    assert_eq!(of(&[]), Ok(0.8));
    assert_eq!(of(&[("r", "200mm")]), Ok(1.6));
    assert_eq!(of(&[("l", "1 m")]), Ok(2.0));
    assert_eq!(of(&[("l", "1 m"), ("l", "2 m")]), Ok(4.0));
    for (name, value, code) in
        [("d", "1 m", "set_unknown"), ("R", "1 m", "set_unknown"), ("r", "1", "set_value")]
    {
        let said = of(&[(name, value)]).expect_err(name);
        assert!(said.contains(code), "{said}");
    }
}

#[test]
fn quantities_stand_after_those_they_hang_on() {
    let mechanism =
        crank_slider("45 deg", "find b = 2 * a\nlet a = displacement(D) + c\nlet c = angle(rod) * 1 m");
    let names = mechanism.unwrap().quantities.into_iter().map(|q| q.name).collect::<Vec<_>>();
    assert_eq!(names, ["c", "a", "b"]);
}

#[test]
fn units_of_answers() {
    let rest = "given q = 3 cm\nfind position(C), v = velocity(C), omega(rod) as rev/s, angle(rod), ratio = displacement(D) / q
expect v = (-8 m/s, 0) within 5 m/s";
    let mechanism = crank_slider("45 deg at 1500 rpm", rest).unwrap();
    let units = mechanism.finds.iter().map(|f| match &f.kind {
        FindKind::Value { display, .. } => (f.name.as_str(), display.unit.as_str()),
        FindKind::Reactions => (f.name.as_str(), "reactions"),
        FindKind::Table(_) => (f.name.as_str(), "table"),
    });
    let expected =
        [("position(C)", "mm"), ("v", "m/s"), ("omega(rod)", "rev/s"), ("angle(rod)", "deg"), ("ratio", "")];
    assert_eq!(units.collect::<Vec<_>>(), expected);
}

#[test]
fn a_power_is_not_printed_in_the_unit_of_a_torque_that_grows() {
    let of = |rest: &str| {
        let mechanism = crank_slider("45 deg at 1500 rpm", rest).unwrap();
        let FindKind::Value { display, .. } = &mechanism.finds[0].kind else { panic!("no value") };
        display.unit.clone()
    };
    assert_eq!(of("given rise = 40 N*m/s\nfind P = 3 N*m * omega(crank)"), "W");
    assert_eq!(of("given rise = 40 N*m/s\ngiven most = 2 kW\nfind P = 3 N*m * omega(crank)"), "kW");
    assert_eq!(of("given rise = 40 N*m/s\nfind growth = rise as N*m/s"), "N*m/s");
}

fn tolerance(expect: &str) -> Tolerance {
    let mechanism = crank_slider("45 deg at 1500 rpm", &format!("given key = 4.17e2 mm\n{expect}"));
    mechanism.unwrap_or_else(|e| panic!("{e}")).expects.remove(0).tolerance
}

#[test]
fn tolerances_from_the_digits_written() {
    let near = |found: Tolerance, si: f64| match found {
        Tolerance::Written(all) => assert!((all[0] - si).abs() < 1e-15, "{all:?} against {si}"),
        other => panic!("{other:?}"),
    };
    near(tolerance("expect displacement(D) = 417 mm"), 1e-3);
    near(tolerance("expect displacement(D) = 0.4 m"), 4e-3);
    near(tolerance("expect displacement(D) = 417.00 mm"), 1e-5);
    near(tolerance("expect displacement(D) = key"), 1e-3);
    near(tolerance("expect -displacement(D) = -417 mm"), 1e-3);
    near(tolerance("expect position(C) = (417.0 mm, 0)"), 1e-4);
    assert_eq!(tolerance("expect displacement(D) = 417 mm within 1 %"), Tolerance::Relative(0.01));
    assert_eq!(tolerance("expect displacement(D) = 417 mm within 2 mm"), Tolerance::Absolute(0.002));
    assert_eq!(tolerance("expect velocity(C).y = 0 m/s within 1e-9 m/s"), Tolerance::Absolute(1e-9));
    assert_eq!(tolerance("expect displacement(D) > 0 mm"), Tolerance::None);
}

#[test]
fn poses_of_expectations() {
    let sweep = "0 deg .. 360 deg in 4 steps at 60 rpm";
    let rest = "pose 4' at crank = 100 deg
expect angle(crank) = 90 deg at pose 2
expect angle(crank) = 100 deg at pose 4'
expect angle(crank) = 10 deg at crank = 10 deg
expect angle(crank) = 0 deg, 90 deg, 180 deg, 270 deg within 1e-9 deg
expect stroke(D) = 200 mm";
    let expects = crank_slider(sweep, rest).unwrap_or_else(|e| panic!("{e}")).expects;
    assert!(matches!(&expects[0].at, Some(At::Pose(name, _)) if name == "2"));
    assert!(matches!(&expects[1].at, Some(At::Pose(name, _)) if name == "4'"));
    assert!(matches!(&expects[2].at, Some(At::Drives(all)) if all.len() == 1));
    assert!(matches!(&expects[3].relation, Relation::Equal(values) if values.len() == 4));
    assert!(expects[3].angle && !expects[3].poseless);
    assert!(expects[4].poseless && !expects[4].angle);
}

#[test]
fn a_reaction_without_link_where_the_sign_is_free() {
    let rest = "force on piston at C = 1 kN @ 180 deg\nfind a = mag(reaction(B)), b = abs(reaction(B).x), c = abs(-2 * moment(D))";
    let mechanism = crank_slider("45 deg", rest).unwrap_or_else(|e| panic!("{e}"));
    let mut on = Vec::new();
    for quantity in &mechanism.quantities {
        quantity.expr.queries(&mut |q| {
            if let Query::Reaction(_, link) | Query::Moment(_, link) = q {
                on.push(mechanism.link(*link).name.clone());
            }
        });
    }
    assert_eq!(on, ["rod", "rod", "ground"]);
    for wrong in [
        "find reaction(B)",
        "find mag(reaction(B) + reaction(C, rod))",
        "find mag(reaction(B)) + moment(D) / (1 m)",
    ] {
        let said = crank_slider("45 deg", wrong).expect_err(wrong);
        assert!(said.contains("request::which_link"), "{said}");
    }
}

#[test]
fn directions_of_links_and_of_vectors() {
    let mechanism = crank_slider("45 deg at 10 rpm", "find a = dir(rod), b = dir(velocity(C))").unwrap();
    assert!(matches!(mechanism.quantities[0].expr, Expr::Query(Query::LinkDirection(_))));
    assert!(matches!(&mechanism.quantities[1].expr, Expr::Call(..)));
}

#[test]
fn time_is_the_instant_of_a_motion_alone() {
    let late = "find late = 2 * time";
    let said = crank_slider("45 deg at 10 rpm", late).expect_err("no motion under loads");
    assert!(said.contains("name::unknown"), "{said}");
    let head = include_str!("../language/19-andrews.mech");
    let text =
        head.replace("find angle(OF)", "find late = 2 * time, twice, angle(OF)") + "let twice = 2 * late\n";
    let mechanism = read(&text, &[]).unwrap_or_else(|e| panic!("{e}"));
    assert!(matches!(mechanism.quantities[0].expr, Expr::Binary(BinaryOp::Mul, _, _)));
}
