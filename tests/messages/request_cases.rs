//! Mistakes in requests, expectations, dimensions and positions that people made, in `tests/cases/requests`: there is one
//! message, it says what is wrong, and what its help offers makes the file right where it is pasted.

use assur::check::Overrides;
use assur::diagnostic::DiagnosticView;
use assur::source::Source;
use std::path::Path;

/// A file with one mistake.
struct Case {
    /// Below `tests/cases/requests`.
    file: &'static str,
    /// The code of its one error.
    code: &'static str,
    /// Words of the message or the help.
    words: &'static str,
    /// Where something is pasted: text of the file, the part of it to replace, and what is offered in its place.
    paste: Option<[&'static str; 3]>,
    /// The answer key belongs to other numbers than those offered.
    other_numbers: bool,
}

const fn case(file: &'static str, code: &'static str, words: &'static str, paste: [&'static str; 3]) -> Case {
    Case { file, code, words, paste: Some(paste), other_numbers: false }
}

/// As [`case`], where the answer key belongs to other numbers than those offered.
const fn near(file: &'static str, code: &'static str, words: &'static str, paste: [&'static str; 3]) -> Case {
    Case { file, code, words, paste: Some(paste), other_numbers: true }
}

/// Numbers that only the author knows.
const fn told(file: &'static str, code: &'static str, words: &'static str) -> Case {
    Case { file, code, words, paste: None, other_numbers: false }
}

const MISMATCH: &str = "mech::unit::mismatch";
const NO_VALUE: &str = "mech::unit::no_value";
const ARGUMENT: &str = "mech::request::argument";
const ARGUMENTS: &str = "mech::request::arguments";
const COUNT: &str = "mech::expect::count";

const CASES: &[Case] = &[
    near("041-dimension-gravity", MISMATCH, "", ["gravity 9.81 m/s", "9.81 m/s", "9.81 m/s^2"]),
    case("043-mass-in-newton", MISMATCH, "", ["mass 2 N at C", "2 N", "2 kg"]),
    case("062-drive-dimension", MISMATCH, "", ["crank = 75 mm", "75 mm", "75 deg"]),
    case(
        "105-torque-in-newton",
        MISMATCH,
        "",
        ["given M_load = 500 N", "given M_load = 500 N", "given M_load = 500 N*m"],
    ),
    case("114-inertia-unit", MISMATCH, "", ["inertia 0.0015 kg*m }", "0.0015 kg*m", "0.0015 kg*m^2"]),
    case(
        "151-expect-wrong-unit",
        MISMATCH,
        "",
        ["expect Mb = 0.8650421403570382 N", "0.8650421403570382 N", "0.8650421403570382 N*m"],
    ),
    near(
        "125-friction-angle",
        MISMATCH,
        "is the tangent of its angle",
        ["friction 5.7 deg", "5.7 deg", "tan(5.7 deg)"],
    ),
    near("146-sin-of-length", MISMATCH, "write an angle, as `psi`", ["sin(H/2)", "H/2", "psi"]),
    near(
        "134-condition-dimension",
        "mech::unit::operands",
        "`0.9 mm`",
        ["> 0.9 and", "0.9", "0.9*stroke(G)"],
    ),
    told("147-sum-of-kinds", "mech::unit::operands", "write a length in place of `eps`"),
    told("148-root-of-negative", NO_VALUE, "`d^2 - y^2` is -0.72877 m^2 where `d` = 31 mm, `y` = 854.243 mm"),
    told("149-division-by-zero", NO_VALUE, "`tan(theta / 2)` is 0 where `theta` = 0 deg, `K` = 1"),
    case("092-dead-third", ARGUMENT, "`dead(G, 1)`", ["dead(G, 3)", "dead(G, 3)", "dead(G, 2)"]),
    case(
        "136-find-reaction-singular",
        "mech::name::unknown",
        "`reaction(A, crank)`",
        ["find Fb, reaction", "reaction", "reactions"],
    ),
    case(
        "138-arguments-swapped",
        ARGUMENT,
        "a pair, and then a link",
        ["reaction(rod, B)", "reaction(rod, B)", "reaction(B, rod)"],
    ),
    case("144-argument-missing", ARGUMENTS, "`omega(disc)`", ["omega()", "omega()", "omega(lever)"]),
    case(
        "145-argument-too-many",
        ARGUMENTS,
        "",
        ["position(coupler.E, 3)", "position(coupler.E, 3)", "position(coupler.E)"],
    ),
    case(
        "167-expect-in-find",
        "mech::name::duplicate",
        "stands in its `expect`",
        ["find M = 12 N*m", "find M = 12 N*m", "find M"],
    ),
    near(
        "130-against-motion-at-rest",
        "mech::request::needs_speed",
        "",
        ["drive crank = phi", "drive crank = phi", "drive crank = phi at 60 rpm"],
    ),
    told(
        "156-list-too-short",
        COUNT,
        "add one: there is one value for each of the 4 poses: I = 0 deg, 30 deg, 60 deg, 90 deg",
    ),
    told(
        "157-list-too-long",
        COUNT,
        "leave one out: there is one value for each of the 2 poses: I = 0 deg, 90 deg",
    ),
    told("073-cylinder-too-long", "mech::assembly::does_not_close", "drive `c1` between 1.585 m and 2.927 m"),
    near(
        "194-cam-base-radius-small",
        "mech::cam::undercut",
        "",
        ["base_radius 5 mm", "base_radius 5 mm", "base_radius 32.86 mm"],
    ),
];

fn text_of(file: &str) -> String {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cases/requests");
    std::fs::read_to_string(root.join(format!("{file}.mech"))).unwrap_or_default()
}

fn errors(text: &str) -> Vec<DiagnosticView> {
    let source = Source::new("case.mech", text);
    let (_, problems) = assur::test_source(&source, &Overrides::none());
    problems.views(&source).into_iter().filter(|d| d.severity == "error").collect()
}

fn said(found: &[DiagnosticView]) -> String {
    let all = found.iter().map(|d| format!("{} {}", d.message, d.help.as_deref().unwrap_or_default()));
    all.collect::<Vec<_>>().join(" ")
}

#[test]
fn each_mistake_has_one_message_that_leads_to_the_fix() {
    let wrong = CASES.iter().filter_map(|case| judge(case).err()).collect::<Vec<_>>();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

fn judge(case: &Case) -> Result<(), String> {
    let (file, text) = (case.file, text_of(case.file));
    let found = errors(&text);
    let (said, seen) = (said(&found), found.iter().filter_map(|d| d.code.as_deref()).collect::<Vec<_>>());
    if seen != [case.code] || !said.contains(case.words) {
        return Err(format!("{file}: {seen:?}: {said}"));
    }
    let Some([place, from, to]) = case.paste else { return Ok(()) };
    if !said.contains(to) || !text.contains(place) {
        return Err(format!("{file}: `{to}` is not offered, or `{place}` not there: {said}"));
    }
    let fixed = text.replacen(place, &place.replacen(from, to, 1), 1);
    let left = errors(&fixed);
    let counts =
        |d: &&DiagnosticView| !(case.other_numbers && d.code.as_deref() == Some("mech::expect::mismatch"));
    let left = left.iter().filter(counts).map(|d| d.message.as_str()).collect::<Vec<_>>();
    if left.is_empty() { Ok(()) } else { Err(format!("{file}: {left:#?}")) }
}

/// A sweep that does not close everywhere: one error for what cannot be compared, one for what differs.
#[test]
fn expectations_of_a_sweep_that_does_not_close_are_told_together() {
    let found = errors(&text_of("072-unreachable-in-sweep"));
    let seen = found.iter().filter_map(|d| d.code.as_deref()).collect::<Vec<_>>();
    assert_eq!(seen, ["mech::expect::pose_failed", "mech::expect::mismatch"]);
    let said = said(&found);
    assert!(said.contains("`angle(rocker)` and 3 more cannot be compared"), "{said}");
    assert!(said.contains("12 more expectations are not met"), "{said}");
}
