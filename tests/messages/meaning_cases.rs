//! Mistakes of meaning that people made, in `tests/cases`: how many messages there are, which, with which words; and that
//! what a help offers to paste leaves no error.

use crate::case::Paste::{Before, Line, Part, Whole};
use crate::case::{Case, judge, near, tested, text};
use assur::internals::diagnostic::DiagnosticView;

const UNKNOWN: &[&str] = &["mech::name::unknown"];
const KIND: &[&str] = &["mech::name::wrong_kind"];
const MISMATCH: &[&str] = &["mech::unit::mismatch"];
const JOIN: &[&str] = &["mech::geometry::nothing_to_join"];
const ARGUMENTS: &[&str] = &["mech::request::arguments"];
const TEETH: &[&str] = &["mech::train::sizes"];
const FAILED: &[&str] = &["mech::expect::mismatch"];
const COUNT: &[&str] = &["mech::expect::count"];

const CASES: &[Case] = &[
    near(
        "messages/004-typo-given",
        UNKNOWN,
        "did you mean `phi1`?",
        &[Part("crank = phi at", "phi", "phi1")],
    ),
    near(
        "messages/009-typo-drive",
        &["mech::syntax::misspelt_word"],
        "did you mean `drive`?",
        &[Whole("drvie", "drive")],
    ),
    near(
        "messages/010-typo-steps",
        &["mech::syntax::misspelt_word"],
        "`steps`",
        &[Whole("8 step at", "8 steps at")],
    ),
    near(
        "messages/038-missing-unit-force",
        &["mech::unit::missing"],
        "",
        &[Whole("given P5   = 1000", "given P5 = 1000 N")],
    ),
    near(
        "messages/065-cyrillic-A",
        &["mech::name::look_alike"],
        "the letter `А` is Cyrillic",
        &[Part("revolute А", "А", "A")],
    ),
    near(
        "messages/084-joint-wrong-links",
        &["mech::name::ambiguous_point"],
        "`C` joins other points",
        &[Whole("revolute C: crank.B - rocker.C", "revolute C: coupler - rocker")],
    ),
    near(
        "messages/085-joint-wrong-links-no-point",
        JOIN,
        "the point `C` is on `coupler` and `rocker`",
        &[Whole("revolute C: crank - rocker", "revolute C: coupler - rocker")],
    ),
    near(
        "messages/092-wrong-hint",
        FAILED,
        "12 of 12 poses differ, the greatest difference is at pose 1",
        &[Whole("assemble D left of B-C", "assemble C left of B-D")],
    ),
    near("messages/101-no-balance-but-found", UNKNOWN, "", &[Line("balance torque Mb on crank")]),
    near(
        "messages/102-no-drive",
        &["mech::geometry::not_driven"],
        "",
        &[Line("drive crank = 0 deg .. 360 deg in 12 steps at 60 rpm")],
    ),
    near(
        "messages/106-friction-no-radius",
        &["mech::geometry::incomplete"],
        "`friction` has no effect without `radius`",
        &[Whole("all revolute { friction 0.1 }", "all revolute { radius 20 mm; friction 0.1 }")],
    ),
    near("messages/139-drive-deg-of-length", MISMATCH, "`c1` slides", &[]),
    near(
        "messages/142-gear-frac",
        TEETH,
        "the number of teeth is a whole number",
        &[Whole("given zs = 24.5", "given zs = 24")],
    ),
    near(
        "messages/144-gear-no-carrier",
        &["mech::train::no_carrier"],
        "`P` cannot turn: its axis is on the ground and it meshes with the fixed wheel `ring`",
        &[Whole("shaft P {", "shaft P on H {")],
    ),
    near("messages/146-gear-missing-mesh", UNKNOWN, "there is no pair `sp`", &[]),
    near("messages/159-range-to", &["mech::syntax::other_word"], "-40 deg .. 40 deg", &[]),
    near("messages/160-range-colon", &["mech::syntax::other_word"], "in 8 steps", &[]),
    near(
        "messages/170-torque-in-cyl",
        &["mech::geometry::wrong_effort"],
        "",
        &[Whole("balance torque F in lift", "balance force F in lift")],
    ),
    near("messages/171-steps-missing", &["mech::syntax::missing_word"], "in 12 steps", &[]),
    near(
        "messages/gear-half",
        &["mech::train::sizes", "mech::train::sizes"],
        "wheel `a` has 24.5 teeth",
        &[Whole("teeth 24.5", "teeth 25"), Whole("teeth 40.25", "teeth 41")],
    ),
    near(
        "messages/t0",
        &["mech::unit::missing", "mech::name::unknown", "mech::name::unknown"],
        "`given l = 350 mm`",
        &[],
    ),
    near(
        "messages/t9",
        &["mech::unit::missing", "mech::unit::missing", "mech::geometry::unknown_property"],
        "`2400 rpm`",
        &[],
    ),
    near(
        "spellings/accel",
        &["mech::request::needs_speed"],
        "",
        &[Whole("drive crank = 45 deg", "drive crank = 45 deg at 60 rpm")],
    ),
    near(
        "spellings/angle3",
        &["mech::unit::shape"],
        "or `expect x.x = 413 mm`",
        &[Whole("expect x = 413 mm", "expect mag(x) = 413 mm")],
    ),
    near("spellings/ex", COUNT, "`y` has one value for the whole motion, and 2 are expected", &[]),
    near("spellings/f10", &["mech::assembly::ambiguous"], "at pose 3 (rocker = 90 deg)", &[]),
    near("spellings/f15", &["mech::geometry::unknown_property"], "", &[Whole("length", "free_length")]),
    near("spellings/f17", JOIN, "`A` joins these links already", &[]),
    near(
        "spellings/f19",
        ARGUMENTS,
        "",
        &[
            Line("group dyad: coupler, rocker"),
            Whole("transmission_angle(coupler, rocker)", "transmission_angle(dyad)"),
        ],
    ),
    near("spellings/f20", UNKNOWN, "there is no function `grashof`", &[]),
    near("spellings/f21", UNKNOWN, "", &[Whole("path(coupler.C)", "position(coupler.C)")]),
    near("spellings/f4", &["mech::geometry::load_form"], "", &[Whole("100 N", "100 N @ 270 deg")]),
    near("spellings/l1", COUNT, "one value for the whole motion", &[]),
    near("spellings/l2", COUNT, "one value for the whole motion", &[]),
    near("spellings/l3", COUNT, "`H` has one value for the whole motion", &[]),
    near("spellings/l4", COUNT, "2 values are expected", &[]),
    near(
        "spellings/res2",
        &["mech::geometry::force_without_place"],
        "",
        &[Whole("force P on piston = 3 kN", "force P on piston at C = 3 kN @ 270 deg")],
    ),
    near(
        "spellings/res3",
        &["mech::geometry::load_form", "mech::name::unknown"],
        "`-3 kN @ 180 deg` against it",
        &[Whole("-3 kN", "-3 kN @ 0 deg"), Whole("torque(crank)", "effort(crank)")],
    ),
    near("spellings/rpmless", &["mech::unit::missing"], "", &[Part("= 45 at", "45", "45 deg")]),
    near("spellings/slider", MISMATCH, "drive the pair: `drive D = 400 mm at 2 m/s`", &[]),
    near("spellings/tf", &["mech::geometry::unknown_property"], "a belt has no property `frictio`", &[]),
    near("spellings/v10", KIND, "", &[Whole("omega(B)", "omega(rod)")]),
    near("spellings/v11", ARGUMENTS, "", &[Whole("angle(A, B)", "angle(crank)")]),
    near(
        "spellings/v13",
        UNKNOWN,
        "",
        &[Whole("everything", "position(piston.C), velocity(piston.C), acceleration(piston.C)")],
    ),
    near(
        "spellings/v17",
        &["mech::syntax::other_word"],
        "",
        &[Whole("expect velocity(C).x = -13.4 m/s +- 1%", "expect velocity(C).x = -13.4 m/s within 1%")],
    ),
    near("spellings/v3", KIND, "", &[Whole("speed(C)", "mag(velocity(C))")]),
    near("spellings/v5", MISMATCH, "write `m/s^2`", &[]),
    near(
        "spellings/v6",
        &["mech::request::which_link"],
        "",
        &[Part("find reaction(B)", "reaction(B)", "reaction(B, rod)")],
    ),
    near("spellings/v8", UNKNOWN, "", &[Whole("torque(crank)", "effort(crank)")]),
    near("spellings/v9", KIND, "", &[Part("velocity(piston)", "piston", "piston.C")]),
    near("spellings/vel", UNKNOWN, "", &[Whole("v(C)", "velocity(C)")]),
    near("spellings/w", &["mech::expect::any_value"], "", &[Whole("within 3", "within 3 %")]),
    near("spellings/xb", COUNT, "2 values are expected, but the file has 8 poses", &[]),
    near(
        "messages/053-pair-same-link",
        &["mech::geometry::joined_with_itself"],
        "`piston` has a point `C`",
        &[Whole("revolute  C: rod - rod", "revolute C: rod - piston")],
    ),
    near("messages/054-pair-twice", &["mech::name::duplicate"], "leave this line out", &[]),
    near(
        "messages/055-pair-wrong-kind",
        &["mech::geometry::wrong_ends"],
        "",
        &[Whole("revolute D: piston.C - ground.guide", "prismatic D: piston.C - ground.guide")],
    ),
    near(
        "messages/056-pair-wrong-kind",
        &["mech::geometry::wrong_ends"],
        "both links have the point `C`",
        &[Whole("prismatic C: rod - ram", "revolute C: rod - ram")],
    ),
    near(
        "messages/057-guide-not-said",
        JOIN,
        "",
        &[Whole("prismatic D: piston - ground", "prismatic D: piston.C - ground.guide")],
    ),
    near(
        "messages/075-line-missing",
        UNKNOWN,
        "give `bar` the line",
        &[Before("S (260", "line slot through C to D")],
    ),
    near(
        "messages/076-line-of-wrong-link",
        UNKNOWN,
        "`guide` is a line of `ground`",
        &[Whole("prismatic G: ram.E - bar.guide", "prismatic G: ram.E - ground.guide")],
    ),
    near(
        "messages/077-point-for-line",
        &["mech::geometry::wrong_ends"],
        "name the line",
        &[Whole("prismatic G: ram.E - ground.Q", "prismatic G: ram.E - ground.guide")],
    ),
    near(
        "messages/078-point-missing",
        JOIN,
        "give `piston` the point",
        &[Whole("link 3 piston", "link 3 piston { C (0, 0) }")],
    ),
    near(
        "messages/079-point-other-letter",
        JOIN,
        "",
        &[Whole("revolute  C: rod - piston", "revolute C: rod.D - piston")],
    ),
    near(
        "messages/086-contact-names-missing",
        JOIN,
        "",
        &[Whole("contact  N: disc - lever", "contact N: disc.rim - lever.face")],
    ),
    near(
        "messages/087-cylinder-points-missing",
        JOIN,
        "",
        &[Whole("cylinder  c1: ground - boom", "cylinder c1: ground.G - boom.K")],
    ),
    near(
        "messages/091-pose-twice",
        &["mech::name::duplicate"],
        "`last` is asked for",
        &[Whole("pose upper at crank = 350 deg", "pose last at crank = 350 deg")],
    ),
    near(
        "messages/101-force-point-missing",
        &["mech::geometry::force_without_place"],
        "",
        &[Whole("force on rocker = P @ 0 deg", "force on rocker at E = P @ 0 deg")],
    ),
    near("messages/107-balance-missing", UNKNOWN, "", &[Line("balance force Fg on piston at C along 0 deg")]),
    near(
        "messages/111-balance-name-taken",
        &["mech::name::duplicate"],
        "`Mb` is asked for",
        &[Whole("balance torque F on crank", "balance torque Mb on crank")],
    ),
    near(
        "messages/112-mass-place-missing",
        &["mech::geometry::mass_without_place"],
        "",
        &[Whole("mass 4 kg", "mass 4 kg at S")],
    ),
    near(
        "messages/115-gravity-missing",
        &["mech::geometry::weight_without_gravity"],
        "`coupler`",
        &[Line("gravity 9.81 m/s^2")],
    ),
    near(
        "messages/117-gravity-negative",
        &["mech::geometry::not_positive"],
        "points down",
        &[Whole("gravity -9.81 m/s^2", "gravity 9.81 m/s^2")],
    ),
    near(
        "messages/118-spring-stiffness-missing",
        &["mech::geometry::incomplete"],
        "",
        &[Before("free_length 80", "stiffness k")],
    ),
    near(
        "messages/122-friction-radius-missing",
        &["mech::geometry::incomplete"],
        "",
        &[Whole("{ equivalent_friction 0.12 }", "{ radius 20 mm; equivalent_friction 0.12 }")],
    ),
    near(
        "messages/123-friction-no-sense",
        &["mech::request::needs_speed"],
        "",
        &[Whole("drive P = 0 mm", "drive P = 0 mm at 0.1 m/s")],
    ),
    near(
        "messages/126-friction-mu",
        &["mech::geometry::unknown_property"],
        "did you mean `friction`?",
        &[Part("mu f", "mu", "friction")],
    ),
    near("messages/174-mesh-missing", UNKNOWN, "`sun` meshes with no wheel", &[Line("mesh sp: sun - p")]),
    near(
        "messages/175-mesh-of-shafts",
        KIND,
        "name the wheels",
        &[Whole("mesh k: I - II", "mesh k: z1 - z2")],
    ),
    near("messages/177-modules-differ", TEETH, "the same module", &[]),
    near(
        "messages/181-over-for-under",
        &["mech::train::rope_end"],
        "a movable pulley",
        &[Whole("rope a: ground - over(P) - over(C) - w", "rope a: ground - under(P) - over(C) - w")],
    ),
    near(
        "messages/185-efficiency-percent",
        &["mech::train::efficiency"],
        "",
        &[Whole("given eta = 70", "given eta = 70 %")],
    ),
    near(
        "messages/186-lead-missing",
        &["mech::geometry::incomplete"],
        "add the lead",
        &[Whole("{ efficiency 35 % }", "{ lead 5 mm; efficiency 35% }")],
    ),
];

/// Words without the line ends that a screen puts between them.
fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Messages, labels and help in one line.
fn said(found: &[DiagnosticView]) -> String {
    let said = found.iter().map(|d| {
        let labels = d.spans.iter().filter_map(|s| s.label.as_deref()).collect::<Vec<_>>().join(" ");
        format!("{} {labels} {}", d.message, d.help.as_deref().unwrap_or_default())
    });
    one_line(&said.collect::<Vec<_>>().join(" "))
}

#[test]
fn messages_lead_to_the_fix() {
    judge(CASES, said);
}

/// In place of another assembly, and of another number of teeth, everything is met.
#[test]
fn the_assembly_that_is_proposed_meets_the_key() {
    let paste = Whole("assemble D left of B-C", "assemble C left of B-D");
    let fixed = paste.applied_to(&text("messages/092-wrong-hint")).expect("it is in the file");
    assert!(tested(&fixed).is_empty());
}

/// What people wrote at the first attempt, and is read since.
#[test]
fn what_is_read() {
    for file in ["spellings/v2", "spellings/v12", "spellings/v14", "spellings/res", "spellings/plot"] {
        let found = tested(&text(file));
        assert!(found.is_empty(), "{file}: {found:?}");
    }
}
