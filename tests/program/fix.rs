//! `assur check --fix`: what it changes, and what it leaves to the author.

use crate::run::{Folder, assur, with_input};

const WRONG: &str = "given r = 5mm\nlnk crank A-B r\ngiven v: 3\nground { A (0, 0) }\nrevolute A: ground - crnk\ndrive crank = 5,5 deg\n";

#[test]
fn what_is_certain_is_fixed() {
    let folder = Folder::new("fix").with("a.mech", WRONG);
    let out = assur(&folder, &["check", "--fix", "a.mech"]);
    assert_eq!(out.status, 0, "{}", out.stderr);
    assert_eq!(out.stderr, "a.mech: 4 fixes applied\n");
    assert!(out.stdout.contains("mobility"), "{}", out.stdout);
    let fixed = WRONG.replace("lnk", "link").replace("v: 3", "v = 3").replace("crnk", "crank");
    assert_eq!(folder.read("a.mech"), fixed.replace("5,5", "5.5"));
    let again = assur(&folder, &["check", "--fix", "a.mech"]);
    assert_eq!((again.status, again.stderr.as_str(), again.stdout), (0, "", out.stdout));
}

/// A pair with a wrong end, where one line in its place makes all determined.
#[test]
fn the_one_right_end_is_written() {
    let right = "ground { A (0, 0); D (3 m, 0) }\nlink crank A-B 1 m\nlink rod B-C 2.5 m\nlink arm D-C 2 m\n\
                 revolute A: ground - crank\nrevolute B: crank - rod\nrevolute C: rod - arm { radius 10 mm }\n\
                 revolute D: ground - arm\ndrive crank = 40 deg\nassemble C left of B-D\n";
    let folder = Folder::new("fix-end").with("a.mech", &right.replace("C: rod - arm", "C: rod.B - arm.C"));
    let out = assur(&folder, &["check", "--fix", "a.mech"]);
    assert_eq!((out.status, folder.read("a.mech").as_str()), (0, right), "{}", out.stderr);
}

#[test]
fn what_may_mean_several_things_stays() {
    // a unit left out, thousands or decimals, another point, another short word, another unit
    let text = "given r = 5\nlink crank A-B1 r\ngiven t = 1,500 m\nfind position(B2)\nforce F im crank = 5 N\ngiven s = 5 mn\n";
    let folder = Folder::new("fix-several").with("a.mech", text);
    let out = assur(&folder, &["check", "--fix", "a.mech"]);
    assert_eq!((out.status, folder.read("a.mech").as_str()), (1, text), "{}", out.stderr);
    assert!(out.stderr.contains("write `given r = 5 mm`"), "{}", out.stderr);
}

/// `350 mm` is as likely as `350 m`; a tolerance is not thrown away.
#[test]
fn broken_units_and_tolerances_stay() {
    for line in [
        "r = 350 m m",
        "v = 5 m m/s",
        "F = 5 k N",
        "n = 10 r pm",
        "r = 5 c m",
        "r = 20 mm +- 1 mm",
        "r = 20 ± 1 mm",
    ] {
        let text = format!("given {line}\n");
        let folder = Folder::new("fix-unit").with("a.mech", &text);
        let out = assur(&folder, &["check", "--fix", "a.mech"]);
        assert_eq!((out.status, folder.read("a.mech")), (1, text), "{}", out.stderr);
    }
    let folder = Folder::new("fix-unit").with("a.mech", "given r = 350 m m\n");
    let said = assur(&folder, &["check", "--fix", "a.mech"]).stderr;
    for meant in ["given r = 350 mm\n", "given r = 350 m\n"] {
        assert!(said.contains(meant), "{meant}: {said}");
    }
}

#[test]
fn standard_input_cannot_be_fixed() {
    let out = with_input(&Folder::new("fix-stdin"), &["check", "--fix", "-"], WRONG);
    assert_eq!((out.status, out.stdout.as_str()), (2, ""));
    assert!(out.stderr.contains("name a file"), "{}", out.stderr);
}
