//! Mistakes in requests, expectations, dimensions and positions that people made, in `tests/cases/requests`: there is one
//! message, it says what is wrong, and what its help offers makes the file right where it is pasted.

use crate::case::Paste::{Part, Whole};
use crate::case::{Case, case, judge, near, said, tested, text};

const MISMATCH: &[&str] = &["mech::unit::mismatch"];
const NO_VALUE: &[&str] = &["mech::unit::no_value"];
const ARGUMENT: &[&str] = &["mech::request::argument"];
const ARGUMENTS: &[&str] = &["mech::request::arguments"];
const COUNT: &[&str] = &["mech::expect::count"];

const CASES: &[Case] = &[
    near(
        "requests/041-dimension-gravity",
        MISMATCH,
        "",
        &[Part("gravity 9.81 m/s", "9.81 m/s", "9.81 m/s^2")],
    ),
    case("requests/043-mass-in-newton", MISMATCH, "", &[Part("mass 2 N at C", "2 N", "2 kg")]),
    case("requests/062-drive-dimension", MISMATCH, "", &[Part("crank = 75 mm", "75 mm", "75 deg")]),
    case(
        "requests/105-torque-in-newton",
        MISMATCH,
        "",
        &[Whole("given M_load = 500 N", "given M_load = 500 N*m")],
    ),
    case(
        "requests/114-inertia-unit",
        MISMATCH,
        "",
        &[Part("inertia 0.0015 kg*m }", "0.0015 kg*m", "0.0015 kg*m^2")],
    ),
    case(
        "requests/151-expect-wrong-unit",
        MISMATCH,
        "",
        &[Part("expect Mb = 0.8650421403570382 N", "0.8650421403570382 N", "0.8650421403570382 N*m")],
    ),
    near(
        "requests/125-friction-angle",
        MISMATCH,
        "is the tangent of its angle",
        &[Part("friction 5.7 deg", "5.7 deg", "tan(5.7 deg)")],
    ),
    near(
        "requests/146-sin-of-length",
        MISMATCH,
        "write an angle, as `psi`",
        &[Part("sin(H/2)", "H/2", "psi")],
    ),
    near(
        "requests/134-condition-dimension",
        &["mech::unit::operands"],
        "`0.9 m`",
        &[Part("> 0.9 and", "0.9", "0.9*stroke(G)")],
    ),
    case("requests/147-sum-of-kinds", &["mech::unit::operands"], "write a length in place of `eps`", &[]),
    case(
        "requests/148-root-of-negative",
        NO_VALUE,
        "`d^2 - y^2` is -0.72877 m^2 where `d` = 31 mm, `y` = 854.243 mm",
        &[],
    ),
    case(
        "requests/149-division-by-zero",
        NO_VALUE,
        "`tan(theta / 2)` is 0 where `theta` = 0 deg, `K` = 1",
        &[],
    ),
    case("requests/092-dead-third", ARGUMENT, "`dead(G, 1)`", &[Whole("dead(G, 3)", "dead(G, 2)")]),
    case(
        "requests/136-find-reaction-singular",
        &["mech::name::unknown"],
        "`reaction(A, crank)`",
        &[Part("find Fb, reaction", "reaction", "reactions")],
    ),
    case(
        "requests/138-arguments-swapped",
        ARGUMENT,
        "a pair, and then a link",
        &[Whole("reaction(rod, B)", "reaction(B, rod)")],
    ),
    case("requests/144-argument-missing", ARGUMENTS, "`omega(disc)`", &[Whole("omega()", "omega(lever)")]),
    case(
        "requests/145-argument-too-many",
        ARGUMENTS,
        "",
        &[Whole("position(coupler.E, 3)", "position(coupler.E)")],
    ),
    case(
        "requests/167-expect-in-find",
        &["mech::name::duplicate"],
        "its `expect` gives the expected value",
        &[Whole("find M = 12 N*m", "find M")],
    ),
    near(
        "requests/130-against-motion-at-rest",
        &["mech::request::needs_speed"],
        "",
        &[Whole("drive crank = phi", "drive crank = phi at 60 rpm")],
    ),
    case(
        "requests/156-list-too-short",
        COUNT,
        "add one: there is one value for each of the 4 poses: I = 0 deg, 30 deg, 60 deg, 90 deg",
        &[],
    ),
    case(
        "requests/157-list-too-long",
        COUNT,
        "leave one out: there is one value for each of the 2 poses: I = 0 deg, 90 deg",
        &[],
    ),
    case(
        "requests/073-cylinder-too-long",
        &["mech::assembly::does_not_close"],
        "drive `c1` between 1.585 m and 2.927 m",
        &[],
    ),
    near(
        "requests/194-cam-base-radius-small",
        &["mech::cam::undercut"],
        "",
        &[Whole("base_radius 5 mm", "base_radius 32.86 mm")],
    ),
];

#[test]
fn each_mistake_has_one_message_that_leads_to_the_fix() {
    judge(CASES, said);
}

/// A sweep that does not close everywhere: one error for what cannot be compared, one for what differs.
#[test]
fn expectations_of_a_sweep_that_does_not_close_are_told_together() {
    let found = tested(&text("requests/072-unreachable-in-sweep"));
    let seen = found.iter().filter_map(|d| d.code.as_deref()).collect::<Vec<_>>();
    assert_eq!(seen, ["mech::expect::pose_failed", "mech::expect::mismatch"]);
    let said = said(&found);
    assert!(said.contains("`angle(rocker)` and 3 more cannot be compared"), "{said}");
    assert!(said.contains("12 more expectations are not met"), "{said}");
}
