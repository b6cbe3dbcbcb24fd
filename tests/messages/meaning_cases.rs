//! Mistakes of meaning that people made, in `tests/cases`: how many messages there are, which, with which words; and that
//! what a help offers to paste leaves no error.

use assur::check::Overrides;
use assur::diagnostic::DiagnosticView;
use assur::source::Source;
use std::path::Path;

/// A file with a mistake.
struct Case {
    /// Below `tests/cases`.
    file: &'static str,
    /// The codes of its errors, in order.
    codes: &'static [&'static str],
    /// Words of a message or help.
    words: &'static str,
    /// Texts and what help offers in their place; nothing is a line to add.
    pastes: &'static [(&'static str, &'static str)],
}

const fn case(
    file: &'static str,
    codes: &'static [&'static str],
    words: &'static str,
    pastes: &'static [(&'static str, &'static str)],
) -> Case {
    Case { file, codes, words, pastes }
}

const UNKNOWN: &[&str] = &["mech::name::unknown"];
const KIND: &[&str] = &["mech::name::wrong_kind"];
const MISMATCH: &[&str] = &["mech::unit::mismatch"];
const JOIN: &[&str] = &["mech::geometry::nothing_to_join"];
const ARGUMENTS: &[&str] = &["mech::request::arguments"];
const TEETH: &[&str] = &["mech::train::sizes"];
const FAILED: &[&str] = &["mech::expect::mismatch"];
const COUNT: &[&str] = &["mech::expect::count"];

const CASES: &[Case] = &[
    case("messages/004-typo-given", UNKNOWN, "did you mean `phi1`?", &[("crank = phi at", "phi1")]),
    case(
        "messages/009-typo-drive",
        &["mech::syntax::misspelt_word"],
        "did you mean `drive`?",
        &[("drvie", "drive")],
    ),
    case(
        "messages/010-typo-steps",
        &["mech::syntax::misspelt_word"],
        "`steps`",
        &[("8 step at", "8 steps at")],
    ),
    case(
        "messages/038-missing-unit-force",
        &["mech::unit::missing"],
        "",
        &[("given P5   = 1000", "given P5 = 1000 N")],
    ),
    case(
        "messages/065-cyrillic-A",
        &["mech::name::look_alike"],
        "the letter `А` is Cyrillic",
        &[("revolute А", "A")],
    ),
    case(
        "messages/084-joint-wrong-links",
        &["mech::name::ambiguous_point"],
        "`C` joins other points",
        &[("revolute C: crank.B - rocker.C", "revolute C: coupler - rocker")],
    ),
    case(
        "messages/085-joint-wrong-links-no-point",
        JOIN,
        "the point `C` is on `coupler` and `rocker`",
        &[("revolute C: crank - rocker", "revolute C: coupler - rocker")],
    ),
    case(
        "messages/092-wrong-hint",
        FAILED,
        "12 of 12 poses differ, most at pose 1",
        &[("assemble D left of B-C", "assemble C left of B-D")],
    ),
    case("messages/101-no-balance-but-found", UNKNOWN, "", &[("", "balance torque Mb on crank")]),
    case(
        "messages/102-no-drive",
        &["mech::geometry::not_driven"],
        "",
        &[("", "drive crank = 0 deg .. 360 deg in 12 steps at 60 rpm")],
    ),
    case(
        "messages/106-friction-no-radius",
        &["mech::geometry::incomplete"],
        "`friction` means nothing without `radius`",
        &[("all revolute { friction 0.1 }", "all revolute { radius 20 mm; friction 0.1 }")],
    ),
    case("messages/139-drive-deg-of-length", MISMATCH, "`c1` slides", &[]),
    case(
        "messages/142-gear-frac",
        TEETH,
        "teeth are a whole number",
        &[("given zs = 24.5", "given zs = 24")],
    ),
    case(
        "messages/144-gear-no-carrier",
        &["mech::train::no_carrier"],
        "`P` turns on the ground and meshes with the fixed wheel `ring`",
        &[("shaft P {", "shaft P on H {")],
    ),
    case("messages/146-gear-missing-mesh", UNKNOWN, "there is no pair `sp`", &[]),
    case("messages/159-range-to", &["mech::syntax::other_word"], "-40 deg .. 40 deg", &[]),
    case("messages/160-range-colon", &["mech::syntax::other_word"], "in 8 steps", &[]),
    case(
        "messages/170-torque-in-cyl",
        &["mech::geometry::wrong_effort"],
        "",
        &[("balance torque F in lift", "balance force F in lift")],
    ),
    case("messages/171-steps-missing", &["mech::syntax::missing_word"], "in 12 steps", &[]),
    case(
        "messages/gear-half",
        &["mech::train::sizes", "mech::train::sizes"],
        "wheel `a` has 24.5 teeth",
        &[("teeth 24.5", "teeth 25"), ("teeth 40.25", "teeth 41")],
    ),
    case(
        "messages/t0",
        &["mech::unit::missing", "mech::name::unknown", "mech::name::unknown"],
        "`given l = 350 mm`",
        &[],
    ),
    case(
        "messages/t9",
        &["mech::unit::missing", "mech::unit::missing", "mech::geometry::unknown_property"],
        "`2400 rpm`",
        &[],
    ),
    case(
        "spellings/accel",
        &["mech::request::needs_speed"],
        "",
        &[("drive crank = 45 deg", "drive crank = 45 deg at 60 rpm")],
    ),
    case(
        "spellings/angle3",
        &["mech::unit::shape"],
        "or `expect x.x = 413 mm`",
        &[("expect x = 413 mm", "expect mag(x) = 413 mm")],
    ),
    case("spellings/ex", COUNT, "`y` has one value for the whole motion, and 2 are expected", &[]),
    case("spellings/f10", &["mech::assembly::ambiguous"], "at pose 3 (rocker = 90 deg)", &[]),
    case("spellings/f15", &["mech::geometry::unknown_property"], "", &[("length", "free_length")]),
    case("spellings/f17", JOIN, "`A` joins these links already", &[]),
    case(
        "spellings/f19",
        ARGUMENTS,
        "",
        &[
            ("", "group dyad: coupler, rocker"),
            ("transmission_angle(coupler, rocker)", "transmission_angle(dyad)"),
        ],
    ),
    case("spellings/f20", UNKNOWN, "there is no function `grashof`", &[]),
    case("spellings/f21", UNKNOWN, "", &[("path(coupler.C)", "position(coupler.C)")]),
    case("spellings/f4", &["mech::geometry::load_form"], "", &[("100 N", "100 N @ 270 deg")]),
    case("spellings/l1", COUNT, "one value for the whole motion", &[]),
    case("spellings/l2", COUNT, "one value for the whole motion", &[]),
    case("spellings/l3", COUNT, "`H` has one value for the whole motion", &[]),
    case("spellings/l4", COUNT, "2 values are expected", &[]),
    case(
        "spellings/res2",
        &["mech::geometry::force_without_place"],
        "",
        &[("force P on piston = 3 kN", "force P on piston at C = 3 kN @ 270 deg")],
    ),
    case(
        "spellings/res3",
        &["mech::geometry::load_form", "mech::name::unknown"],
        "`-3 kN @ 180 deg` against it",
        &[("-3 kN", "-3 kN @ 0 deg"), ("torque(crank)", "effort(crank)")],
    ),
    case("spellings/rpmless", &["mech::unit::missing"], "", &[("= 45 at", "45 deg")]),
    case("spellings/slider", MISMATCH, "drive the pair: `drive D = 400 mm at 2 m/s`", &[]),
    case("spellings/tf", &["mech::geometry::unknown_property"], "a belt has no property `frictio`", &[]),
    case("spellings/v10", KIND, "", &[("omega(B)", "omega(rod)")]),
    case("spellings/v11", ARGUMENTS, "", &[("angle(A, B)", "angle(crank)")]),
    case("spellings/v12", UNKNOWN, "", &[("distance(A, C)", "mag(position(A) - position(C))")]),
    case(
        "spellings/v13",
        UNKNOWN,
        "",
        &[("everything", "position(piston.C), velocity(piston.C), acceleration(piston.C)")],
    ),
    case(
        "spellings/v14",
        &["mech::name::unknown", "mech::name::unknown"],
        "",
        &[("positions", "position(piston.C)"), ("velocities", "velocity(piston.C)")],
    ),
    case(
        "spellings/v17",
        &["mech::syntax::other_word"],
        "",
        &[("expect velocity(C).x = -13.4 m/s +- 1%", "expect velocity(C).x = -13.4 m/s within 1%")],
    ),
    case("spellings/v2", UNKNOWN, "there is no function `instant_centre`", &[]),
    case("spellings/v3", KIND, "", &[("speed(C)", "mag(velocity(C))")]),
    case("spellings/v5", MISMATCH, "write `m/s^2`", &[]),
    case("spellings/v6", &["mech::request::which_link"], "", &[("find reaction(B)", "reaction(B, rod)")]),
    case("spellings/v8", UNKNOWN, "", &[("torque(crank)", "effort(crank)")]),
    case("spellings/v9", KIND, "", &[("velocity(piston)", "piston.C")]),
    case("spellings/vel", UNKNOWN, "", &[("v(C)", "velocity(C)")]),
    case("spellings/w", &["mech::expect::any_value"], "", &[("within 3", "within 3 %")]),
    case("spellings/xb", COUNT, "2 values are expected, but the file has 8 poses", &[]),
    case(
        "messages/053-pair-same-link",
        &["mech::geometry::joined_with_itself"],
        "`piston` has a point `C`",
        &[("revolute  C: rod - rod", "revolute C: rod - piston")],
    ),
    case("messages/054-pair-twice", &["mech::name::duplicate"], "leave this line out", &[]),
    case(
        "messages/055-pair-wrong-kind",
        &["mech::geometry::wrong_ends"],
        "",
        &[("revolute D: piston.C - ground.guide", "prismatic D: piston.C - ground.guide")],
    ),
    case(
        "messages/056-pair-wrong-kind",
        &["mech::geometry::wrong_ends"],
        "both links have the point `C`",
        &[("prismatic C: rod - ram", "revolute C: rod - ram")],
    ),
    case(
        "messages/057-guide-not-said",
        JOIN,
        "",
        &[("prismatic D: piston - ground", "prismatic D: piston.C - ground.guide")],
    ),
    case(
        "messages/075-line-missing",
        UNKNOWN,
        "give `bar` the line",
        &[("S (260", "line slot through C to D")],
    ),
    case(
        "messages/076-line-of-wrong-link",
        UNKNOWN,
        "`guide` is a line of `ground`",
        &[("prismatic G: ram.E - bar.guide", "prismatic G: ram.E - ground.guide")],
    ),
    case(
        "messages/077-point-for-line",
        &["mech::geometry::wrong_ends"],
        "name the line",
        &[("prismatic G: ram.E - ground.Q", "prismatic G: ram.E - ground.guide")],
    ),
    case(
        "messages/078-point-missing",
        JOIN,
        "give `piston` the point",
        &[("link 3 piston", "link 3 piston { C (0, 0) }")],
    ),
    case(
        "messages/079-point-other-letter",
        JOIN,
        "",
        &[("revolute  C: rod - piston", "revolute C: rod.D - piston")],
    ),
    case(
        "messages/086-contact-names-missing",
        JOIN,
        "",
        &[("contact  N: disc - lever", "contact N: disc.rim - lever.face")],
    ),
    case(
        "messages/087-cylinder-points-missing",
        JOIN,
        "",
        &[("cylinder  c1: ground - boom", "cylinder c1: ground.G - boom.K")],
    ),
    case(
        "messages/091-pose-twice",
        &["mech::name::duplicate"],
        "`last` is asked for",
        &[("pose upper at crank = 350 deg", "pose last at crank = 350 deg")],
    ),
    case(
        "messages/101-force-point-missing",
        &["mech::geometry::force_without_place"],
        "",
        &[("force on rocker = P @ 0 deg", "force on rocker at E = P @ 0 deg")],
    ),
    case(
        "messages/106-torque-at-point",
        &["mech::geometry::load_form"],
        "",
        &[("torque on rocker at C = 12 N*m cw", "torque on rocker = 12 N*m cw")],
    ),
    case("messages/107-balance-missing", UNKNOWN, "", &[("", "balance force Fg on piston at C along 0 deg")]),
    case(
        "messages/111-balance-name-taken",
        &["mech::name::duplicate"],
        "`Mb` is asked for",
        &[("balance torque F on crank", "balance torque Mb on crank")],
    ),
    case(
        "messages/112-mass-place-missing",
        &["mech::geometry::mass_without_place"],
        "",
        &[("mass 4 kg", "mass 4 kg at S")],
    ),
    case(
        "messages/115-gravity-missing",
        &["mech::geometry::weight_without_gravity"],
        "`coupler`",
        &[("", "gravity 9.81 m/s^2")],
    ),
    case(
        "messages/117-gravity-negative",
        &["mech::geometry::not_positive"],
        "points down",
        &[("gravity -9.81 m/s^2", "gravity 9.81 m/s^2")],
    ),
    case(
        "messages/118-spring-stiffness-missing",
        &["mech::geometry::incomplete"],
        "",
        &[("free_length 80", "stiffness k")],
    ),
    case(
        "messages/122-friction-radius-missing",
        &["mech::geometry::incomplete"],
        "",
        &[("{ equivalent_friction 0.12 }", "{ radius 20 mm; equivalent_friction 0.12 }")],
    ),
    case(
        "messages/123-friction-no-sense",
        &["mech::request::needs_speed"],
        "",
        &[("drive P = 0 mm", "drive P = 0 mm at 0.1 m/s")],
    ),
    case(
        "messages/126-friction-mu",
        &["mech::geometry::unknown_property"],
        "did you mean `friction`?",
        &[("mu f", "friction")],
    ),
    case("messages/174-mesh-missing", UNKNOWN, "`sun` meshes with no wheel", &[("", "mesh sp: sun - p")]),
    case("messages/175-mesh-of-shafts", KIND, "name the wheels", &[("mesh k: I - II", "mesh k: z1 - z2")]),
    case("messages/177-modules-differ", TEETH, "one module", &[]),
    case(
        "messages/181-over-for-under",
        &["mech::train::rope_end"],
        "a movable pulley",
        &[("rope a: ground - over(P) - over(C) - w", "rope a: ground - under(P) - over(C) - w")],
    ),
    case(
        "messages/185-efficiency-percent",
        &["mech::train::efficiency"],
        "",
        &[("given eta = 70", "given eta = 70 %")],
    ),
    case(
        "messages/186-lead-missing",
        &["mech::geometry::incomplete"],
        "add the lead",
        &[("{ efficiency 35 % }", "{ lead 5 mm; efficiency 35% }")],
    ),
];

fn errors(text: &str) -> Vec<DiagnosticView> {
    let source = Source::new("text.mech", text);
    let found = assur::test_source(&source, &Overrides::none()).1.views(&source);
    found.into_iter().filter(|d| d.severity == "error").collect()
}

/// Words without the line ends that a screen puts between them.
fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The text with what help offers: in place of a statement or a call the whole of it, else the part of it that differs.
fn pasted(text: &str, from: &str, to: &str) -> Option<String> {
    if from.is_empty() {
        return Some(format!("{text}\n{to}\n"));
    }
    let (before, after) = text.split_once(from)?;
    let whole = match from {
        "crank = phi at" => format!("crank = {to} at"),
        "revolute А" => format!("revolute {to}"),
        "= 45 at" => format!("= {to} at"),
        "find reaction(B)" => format!("find {to}"),
        "velocity(piston)" => format!("velocity({to})"),
        "mu f" => format!("{to} f"),
        "S (260" | "free_length 80" => format!("{to}; {from}"),
        _ => to.to_owned(),
    };
    Some(format!("{before}{whole}{after}"))
}

#[test]
fn messages_lead_to_the_fix() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cases");
    let wrong = CASES.iter().filter_map(|case| judge(&root, case).err()).collect::<Vec<_>>();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

fn judge(root: &Path, case: &Case) -> Result<(), String> {
    let Case { file, codes, words, pastes } = case;
    let text =
        std::fs::read_to_string(root.join(format!("{file}.mech"))).map_err(|e| format!("{file}: {e}"))?;
    let found = errors(&text);
    let said = found.iter().map(|d| {
        let labels = d.spans.iter().filter_map(|s| s.label.as_deref()).collect::<Vec<_>>().join(" ");
        format!("{} {labels} {}", d.message, d.help.as_deref().unwrap_or_default())
    });
    let said = one_line(&said.collect::<Vec<_>>().join(" "));
    let seen = found.iter().filter_map(|d| d.code.as_deref()).collect::<Vec<_>>();
    if seen != *codes || !said.contains(words) {
        return Err(format!("{file}: {seen:?}: {said}"));
    }
    let mut fixed = text;
    for (from, to) in *pastes {
        if !said.contains(to) {
            return Err(format!("{file}: `{to}` is not offered: {said}"));
        }
        fixed = pasted(&fixed, from, to).ok_or(format!("{file}: `{from}` is not in the file"))?;
    }
    // the answer key of a file may belong to other numbers than those proposed
    let left = errors(&fixed).into_iter().filter(|d| d.code.as_deref() != Some("mech::expect::mismatch"));
    let left = left.map(|d| format!("{:?}: {}", d.code, d.message)).collect::<Vec<_>>();
    if pastes.is_empty() || left.is_empty() { Ok(()) } else { Err(format!("{file}: {left:#?}")) }
}

/// In place of another assembly, and of another number of teeth, everything is met.
#[test]
fn the_assembly_that_is_proposed_meets_the_key() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cases/messages/092-wrong-hint.mech");
    let text = std::fs::read_to_string(path).expect("a text");
    let fixed = pasted(&text, "assemble D left of B-C", "assemble C left of B-D").expect("it is in the file");
    assert!(errors(&fixed).is_empty());
}
