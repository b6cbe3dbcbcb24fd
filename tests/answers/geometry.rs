//! What the machine of a text becomes in the model: points, pairs, masses, drives, assembly, loads.

use assur::internals::check::{Overrides, check};
use assur::internals::diagnostic::{Style, render};
use assur::internals::math::Vec2;
use assur::internals::model::{
    BalanceKind, DriveTarget, Expr, Guide, HintKind, LoadKind, Mechanism, PairKind, Place, Positions, Value,
};
use assur::internals::source::Source;
use std::path::Path;

/// The mechanism of a text and what is said of it.
fn checked(text: &str) -> (Option<Mechanism>, String) {
    let source = Source::new("text.mech", text);
    let (document, mut problems) = assur::internals::syntax::parse(&source);
    let (mechanism, more) = check(&document, &Overrides::none());
    problems.append(more);
    let mechanism = mechanism.filter(|_| !problems.has_errors());
    (mechanism, render(&problems, &source, Style::PLAIN))
}

fn mechanism(text: &str) -> Mechanism {
    let (mechanism, said) = checked(text);
    mechanism.unwrap_or_else(|| panic!("{said}"))
}

#[track_caller]
fn near(a: Vec2, b: (f64, f64)) {
    assert!((a - Vec2::new(b.0, b.1)).norm() < 1e-15, "{a:?} is not {b:?}");
}

fn constant(expr: &Expr) -> f64 {
    match expr {
        Expr::Constant(Value::Scalar(x)) => *x,
        other => panic!("{other:?}"),
    }
}

fn guide(mechanism: &Mechanism, pair: usize) -> &Guide {
    match &mechanism.pairs[pair].kind {
        PairKind::Prismatic(guide) | PairKind::Slot(guide) => guide,
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_point_by_two_distances_lies_on_its_side() {
    let m = mechanism(
        "link bar { D 80 mm from C 60 mm from E left; E (100 mm, 0); C (0, 0); F 80 mm from C 60 mm from E right; \
         G 30 mm from C 70 mm from E left; H 50 mm from D 50 mm from C left }",
    );
    let point = |name: &str| m.links[1].points.iter().find(|p| p.name == name).map(|p| p.at).unwrap();
    near(point("D"), (0.064, 0.048));
    near(point("F"), (0.064, -0.048));
    near(point("G"), (0.03, 0.0)); // the triangle is flat
    assert!((point("H").norm() - 0.05).abs() < 1e-15);
    let names = m.links[1].points.iter().map(|p| p.name.as_str()).collect::<Vec<_>>();
    assert_eq!(names, ["D", "E", "C", "F", "G", "H"], "points stand in the order written");
}

#[test]
fn lines_are_directed_and_circles_have_their_centre() {
    let m = mechanism(
        "link bar { C (10 mm, 0); B (10 mm, 30 mm); line slot through C to B; line x through B along 180 deg; \
         circle c centre B radius 5 mm }",
    );
    near(m.links[1].lines[0].along, (0.0, 1.0));
    near(m.links[1].lines[1].along, (-1.0, 0.0));
    near(m.links[1].lines[1].through, (0.01, 0.03));
    assert_eq!(m.links[1].circles[0].radius, 0.005);
}

#[test]
fn weight_and_inertia_become_mass_properties() {
    let m = mechanism(
        "gravity 10 m/s^2 @ 180 deg\nground { A (0, 0); line x through A along 0 deg }\n\
         link rod A-B 1 m { S (0.3 m, 0); weight 20 N at S; inertia 0.2 kg*m^2 about A }\n\
         link ram { R (0, 0); mass 3 kg }\nrevolute A: ground - rod\nprismatic D: ram.R - ground.x",
    );
    near(m.gravity.unwrap().acceleration * 0.1, (-1.0, 0.0));
    let rod = m.links[1].mass.unwrap();
    assert!((rod.mass - 2.0).abs() < 1e-15 && (rod.inertia - 0.02).abs() < 1e-15);
    near(rod.centre, (0.3, 0.0));
    assert_eq!(m.links[2].mass.unwrap().mass, 3.0, "what only slides needs no mass centre");
}

#[test]
fn a_point_on_a_line_lays_the_x_axis_along_it() {
    let m = mechanism(
        "ground { A (0, 0); P (1 m, 0); line up through P along 90 deg }\nlink ram { R (0, 0) }\n\
         link box { R (0, 0) }\nprismatic D: ground.up - ram.R { angle 30 deg; contacts -20 mm, 25 mm }\n\
         prismatic E: box.R - ground.up",
    );
    let d = guide(&m, 0);
    assert!(d.guide_first && d.slider.index() == 1 && d.guide.index() == 0);
    near(d.direction, (0.75_f64.sqrt(), -0.5));
    near(d.along, (0.0, 1.0));
    assert_eq!(d.contacts, Some([-0.02, 0.025]));
    assert!(!guide(&m, 1).guide_first);
    near(guide(&m, 1).direction, (1.0, 0.0));
}

#[test]
fn of_two_lines_the_first_slides() {
    let m = mechanism(
        "ground { A (0, 0); line floor through A along 0 deg }\n\
         link box { Q (0, 0); P (5 mm, 0); line base through P along 90 deg }\nprismatic D: box.base - ground.floor",
    );
    let d = guide(&m, 0);
    assert_eq!((d.point_name.as_str(), d.line_name.as_str()), ("P", "floor"));
    near(d.point, (0.005, 0.0));
    near(d.direction, (0.0, 1.0));
}

#[test]
fn a_cylinder_adds_two_links() {
    let m = mechanism(
        "ground { O (0, 0); G (1 m, 0) }\nlink boom { O (0, 0); K (2 m, 0) }\nrevolute O: ground - boom\n\
         cylinder c: ground.G - boom.K\ndrive c = 2 m moving back\nforce H in c = 120 kN",
    );
    let names = m.links.iter().map(|l| l.name.as_str()).collect::<Vec<_>>();
    assert_eq!(names, ["ground", "boom", "c.barrel", "c.rod"]);
    assert_eq!(m.drives[0].sense, Some(-1.0));
    assert!(matches!(m.drives[0].target, DriveTarget::Pair(p) if p.index() == 1));
    assert!(matches!(&m.loads[0].kind, LoadKind::InPair { value, .. } if constant(value) == 120e3));
}

#[test]
fn cw_negates_the_value_before_it() {
    let m = mechanism(
        "ground { A (0, 0) }\nlink crank A-B 1 m\nrevolute A: ground - crank\n\
         drive crank = 1 rad cw, 2 rad at 20 rad/s cw accelerating -5 rad/s^2 cw\npose a at crank = 3 rad cw\n\
         torque on crank = 6 N*m cw",
    );
    let drive = &m.drives[0];
    let Positions::List(list) = &drive.positions else { panic!("another form than written") };
    assert_eq!(list.iter().map(constant).collect::<Vec<_>>(), [-1.0, 2.0]);
    assert_eq!(drive.speed.as_ref().map(constant), Some(-20.0));
    assert_eq!(drive.acceleration.as_ref().map(constant), Some(5.0));
    assert_eq!(constant(&m.poses[0].at[0].1), -3.0);
    assert!(matches!(&m.loads[0].kind, LoadKind::Torque { value, .. } if constant(value) == -6.0));
}

/// The number of steps of a drive that is written with the size of its steps.
fn steps(drive: &str) -> usize {
    let text = format!(
        "ground {{ A (0, 0); Q (0, 50 mm); line guide through Q along 0 deg }}
         link crank A-B 80 mm
         link rod B-C 240 mm
         link ram {{ C (0, 0) }}
         revolute A: ground - crank
         revolute B: crank - rod
         revolute C: rod - ram
         prismatic G: ram.C - ground.guide
         drive {drive}
         find travel(G)"
    );
    match mechanism(&text).drives[0].positions {
        Positions::Range { steps, .. } => steps,
        ref other => panic!("{other:?}"),
    }
}

#[test]
fn a_size_of_steps_needs_only_the_length_of_its_range() {
    assert_eq!(steps("crank = 0 deg .. -360 deg step 30 deg"), 12);
    assert_eq!(steps("crank = dead(G, 1) .. dead(G, 1) - 360 deg step 30 deg"), 12);
    assert_eq!(steps("crank = dead(G, 2) .. dead(G, 2) + 90 deg step 7.5 deg"), 12);
    assert_eq!(steps("crank.B = (30 mm, 40 mm) .. (60 mm, 80 mm) step 5 mm"), 10);
}

#[test]
fn a_pose_keeps_drives_with_one_position() {
    let m = mechanism(
        "ground { A (0, 0) }\nlink a A-B 1 m\nlink b B-C 1 m\nrevolute A: ground - a\nrevolute B: a - b\n\
         drive a = 0 rad, 1 rad\ndrive b = 2 rad\npose p at a = 3 rad",
    );
    let at = m.poses[0].at.iter().map(|(d, e)| (d.index(), constant(e))).collect::<Vec<_>>();
    assert_eq!(at, [(0, 3.0), (1, 2.0)]);
}

#[test]
fn assembly_clauses_find_their_points_and_guides() {
    let m = mechanism(
        "ground { A (0, 0); line guide through A along 0 deg }\nlink crank A-B 100 mm\nlink rod B-C 350 mm\n\
         link piston { C (0, 0) }\nrevolute A: ground - crank\nrevolute B: crank - rod\nrevolute C: rod - piston\n\
         prismatic D: piston.C - ground.guide\ndrive crank = 45 deg\n\
         assemble C ahead of B, D > 0, rod.C right of A-B, D near (0.4 m, 0)",
    );
    let HintKind::Along { point, pair, ahead: true, .. } = &m.hints[0].kind else {
        panic!("another form than written")
    };
    assert_eq!((point.0.index(), pair.index()), (2, 3));
    assert!(matches!(m.hints[1].kind, HintKind::Coordinate { bound: 0.0, greater: true, .. }));
    assert!(matches!(m.hints[2].kind, HintKind::Side { left: false, from, .. } if from.0.index() == 0));
    assert!(matches!(m.hints[3].kind, HintKind::Near { point, .. } if point.0.index() == 3));
}

#[test]
fn loads_and_balances_have_their_frames() {
    let m = mechanism(
        "ground { A (0, 0) }\nlink crank A-B 1 m\nrevolute A: ground - crank\ndrive crank = 0 rad at 1 rad/s\n\
         force on crank at B = (1 N, 2 N) in crank\nforce R on crank at (1 m, 0) = 14 N against motion\n\
         balance force F on crank at B along 90 deg in crank",
    );
    let LoadKind::Force { frame, .. } = &m.loads[0].kind else { panic!("another form than written") };
    assert_eq!(frame.map(|f| f.index()), Some(1));
    assert!(matches!(m.loads[1].kind, LoadKind::ForceAgainstMotion { at: Place::Ground(_), .. }));
    let BalanceKind::Force { along, frame, .. } = &m.balances[0].kind else {
        panic!("another form than written")
    };
    near(*along, (0.0, 1.0));
    assert_eq!(frame.map(|f| f.index()), Some(1));
}

#[test]
fn friction_of_nothing_is_no_friction() {
    let text = |f: &str| {
        format!(
            "ground {{ A (0, 0) }}\nlink crank A-B 1 m\nrevolute A: ground - crank\nall revolute {{ friction_circle {f} }}"
        )
    };
    let rubs = |f: &str| mechanism(&text(f)).pairs[0].friction.is_some_and(|f| f.is_some());
    assert!(!rubs("0 mm"));
    assert!(rubs("5 mm"));
}

/// Where a pair has an error, what refers to it is not an error too.
#[test]
fn one_mistake_is_reported_once() {
    let (_, said) = checked(
        "ground { A (0, 0); line guide through A along 0 deg }\nlink crank A-B 100 mm\nlink rod B-C 0 mm\n\
         link piston { C (0, 0); mass 2 kg }\nrevolute A: ground - crank\nrevolute B: crank - rod\n\
         revolute C: rod - piston\nprismatic D: piston.C - ground.guide\ndrive crank = 45 deg\n\
         assemble C ahead of B\nforce on piston at C = 100 N @ 180 deg\nbalance torque M on crank\nfind reaction(C, rod), M",
    );
    assert_eq!(said.matches("mech::").count(), 1, "{said}");
}

/// Of every page the wrong text shows the page's code, and the mended one nothing but advice.
#[test]
fn pages_show_what_they_explain() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/explain/geometry");
    for entry in std::fs::read_dir(folder).unwrap().flatten() {
        let page = std::fs::read_to_string(entry.path()).unwrap();
        let code = page.lines().next().unwrap().trim_start_matches("# ").to_owned();
        let (mut wrong, mut right) = (0, 0);
        for block in page.split("```mech").skip(1) {
            let (head, text) = block.split("```").next().unwrap().split_once('\n').unwrap();
            let (mechanism, said) = checked(text);
            if head.trim() == "wrong" {
                wrong += 1;
                assert!(said.contains(&code), "{code} is not shown:\n{said}");
            } else {
                right += 1;
                assert!(mechanism.is_some() && !said.contains(&code), "{code} is not mended:\n{said}");
            }
        }
        assert!(wrong > 0 && right > 0, "{code} has no examples");
    }
}

/// An unknown force along a line is the one along its angle; of the link itself it turns with the link. A quantity comes first.
#[test]
fn an_unknown_force_acts_along_a_line() {
    let force = |direction: &str, given: &str| -> f64 {
        let text = format!(
            "{given}ground {{ A (0, 0); line slope through A along -20 deg }}\n\
             link crank A-B 100 mm {{ line face through B along 70 deg }}\nrevolute A: ground - crank\n\
             drive crank = 30 deg\ntorque on crank = 12 N*m\nbalance force P on crank at B along {direction}\nfind P as N\n"
        );
        let solution = assur::solve(text.as_str()).unwrap_or_else(|error| panic!("{error}\n{text}"));
        solution.poses()[0]["P"].number().unwrap()
    };
    assert_eq!(force("slope", ""), force("-20 deg", ""));
    assert_eq!(force("face", ""), force("70 deg in crank", ""));
    assert_eq!(force("slope", "given slope = 55 deg\n"), force("55 deg", ""));
    assert!((force("face", "") + 12.0 / (0.1 * libm::sin(70_f64.to_radians()))).abs() < 1e-9);
}
