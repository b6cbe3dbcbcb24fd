//! Files of use on which the verdict was wrong or misleading once, with what is wanted of each.

use assur::internals::check::Overrides;
use assur::internals::source::Source;
use std::path::Path;

/// A file, the code of its first error or warning, and words of the message and the help.
type Case = (&'static str, &'static str, &'static [&'static str]);

const CASES: &[Case] = &[
    (
        "cylinders-lost",
        "underconstrained",
        &["  cylinder c1: ground.G1 - boom.K1\n  drive c1 = 2.3 m\n  cylinder c2"],
    ),
    ("rope-lost", "underconstrained", &["a rope may be missing: add the line\n  rope r: B - w4"]),
    ("01-six-bar-without-E", "underconstrained", &["  revolute E: rocker - rod"]),
    ("02-six-bar-without-D", "underconstrained", &["  revolute D: ground - rocker"]),
    ("03-six-bar-without-guide", "underconstrained", &["  prismatic G: ram.F - ground.way"]),
    ("04-floating-link", "floating_link", &["  revolute Q: ground - idle\n  drive idle = 45 deg"]),
    ("05-chain-mobility2-one-drive", "underconstrained", &["  drive d = 135 deg\n  assemble C left of B-D"]),
    ("06-one-drive-too-many", "overconstrained", &["leave out `drive G` or `drive crank`"]),
    ("07-truss-redundant-bar", "overconstrained", &["one of the links `bd`, `ad`, `cd` or `bc`"]),
    ("08-over-here-under-there", "unbalanced", &["leave out link `brace`", "  drive tip = 45 deg"]),
    ("10-higher-pair-twice", "overconstrained", &["`K2` repeats `K`: leave out one of them"]),
    ("11-parallel-crank-3", "repeated", &["`crank3` repeats", "leave out `crank3`"]),
    ("14-slot-for-guide", "underconstrained", &["`ram`", "F = 3·5 − 2·6 − 1 = 2"]),
    ("15-no-drive", "underconstrained", &["  drive crank = 45 deg"]),
    (
        "16-not-grounded",
        "not_grounded",
        &["  revolute A: ground - crank\n  revolute D: ground - rocker\n  prismatic G: ram.F - ground.way"],
    ),
    ("17-extra-coupler-bar", "overconstrained", &["one of the links `strut` or `coupler`"]),
    ("18-wrong-link-hinge", "immobile", &["`rod` and `ram` do not move", "`E`, `F` and `G`"]),
    ("19-two-balances", "efforts", &["leave out `balance M` or `balance N`"]),
    ("20-double-rocker-drive-inner", "underconstrained", &["  revolute G: ground - f"]),
    ("23-weld-as-two-hinges", "overconstrained", &["leave out `revolute W` or `revolute E`"]),
    ("24-gear-five-bar-no-mesh", "underconstrained", &["  drive c = 45 deg"]),
    (
        "25-floating-part-held-too-often",
        "unbalanced",
        &["`d2`, `d1`, `s4`, `s3`, `s2` or `s1`", "  drive r2"],
    ),
    (
        "26-two-hinges-and-a-free-end",
        "overconstrained",
        &["leave out `revolute E` or `revolute W`, after which"],
    ),
    (
        "28-minimal-hidden",
        "unbalanced",
        &["leave out `revolute P` or `revolute Q`", "`c`, `d` and `e` can still"],
    ),
    ("29-minimal-hidden2", "unbalanced", &["leave out `revolute P` or `revolute Q`", "  drive e = 45 deg"]),
    ("30-slot", "underconstrained", &["  drive e = 135 deg"]),
    (
        "31-hinge-and-guide",
        "unbalanced",
        &["write `slot Q: a.Q - b.l` in place of `prismatic Q`", "  drive e"],
    ),
    ("33-ring-hidden", "unbalanced", &["one of the links `w2` or `w`", "  drive e = 45 deg"]),
    ("bad-1", "unbalanced", &["leave out `revolute P6` or `revolute P7`", "  drive L1 = 45 deg"]),
    ("bad-120", "unbalanced", &["leave out `revolute P1` or `revolute P6`", "  drive L3 = 45 deg"]),
    ("brace-beside-a-weld", "overconstrained", &["leave out one of the links `zz` or `rod`"]),
    ("brace-early-return", "overconstrained", &["leave out link `zz` with its pairs"]),
    ("cylinder-of-no-length", "unbalanced", &["leave out `revolute Z`"]),
    ("moved-pin", "unbalanced", &["write `revolute C: rod - arm` in place of `revolute Z`"]),
    ("truss-pin-lost-bends", "underconstrained", &["  revolute A: ground - ac - ad"]),
    ("two-links-on-one-line", "unbalanced", &["leave out `revolute Z`"]),
    (
        "two-points-at-one-pin",
        "overconstrained",
        &["it would bring `rod.B` and `rod.C`", "leave out `revolute Z`"],
    ),
    ("wheel-pin-lost", "underconstrained", &["  revolute A: ground - one"]),
    ("wrong-end", "unbalanced", &["write `revolute C: rod - arm` in place of `revolute C`"]),
    ("brace-not-named", "overconstrained", &["leave out link `brace` with its pairs"]),
    ("surplus-pin-not-named", "overconstrained", &["leave out `revolute Z` or `revolute F`"]),
    ("surplus-pin-2", "overconstrained", &["leave out `revolute Z`, or leave out `revolute B`"]),
    ("surplus-pin-of-two-links", "overconstrained", &["`revolute Z` cannot hold", "leave out `revolute Z`"]),
    ("pin-moved-to-its-neighbour", "unbalanced", &["write `revolute F: rod - out` in place of `revolute F`"]),
    (
        "pin-for-a-slide",
        "unbalanced",
        &["write `prismatic s: block.B - lever.slot` in place of `revolute s`"],
    ),
    ("five-bar-one-drive", "underconstrained", &["  drive d = 90 deg at 60 rpm\n  assemble C left of B-D"]),
    ("planet-without-its-sun", "underconstrained", &["  mesh k: s - p"]),
    ("roller-without-its-pin", "underconstrained", &["  revolute T: tappet - roller"]),
    (
        "truss-without-its-roller",
        "underconstrained",
        &["F = 3·5 − 2·7 = 1", "one of\n  slot E: bd.D - ground.floor"],
    ),
    ("wedge-without-a-face", "underconstrained", &["`block` can still move with 1 freedom"]),
    (
        "line-on-line-2",
        "not_parallel",
        &["at 40 deg (by `a`), `wall` of `ground` at 90 deg", "`line up through B along 90 deg` in `low`"],
    ),
    ("line-on-line-angle-accepted", "not_parallel", &["write `line h through C along 90 deg` in `cross`"]),
    ("wedge-5-degrees-apart", "not_parallel", &["write `line under through B along 20 deg` in `block`"]),
    ("held-twice-help-pasted", "not_parallel", &["write `line face through B along -70 deg` in `block`"]),
    ("four-bar-pinned-again", "overconstrained", &["leave out `revolute K`, or leave out `revolute B` or"]),
];

/// Sound, or wrong in another way than by structure: what was right stays right.
const OTHERS: &[(&str, Option<&str>)] = &[
    ("09-watt-pair-doubled", Some("mech::geometry::stated_twice")),
    ("cylinder-driven-and-lost", Some("mech::name::unknown")),
    ("ropes-asked-and-lost", Some("mech::name::unknown")),
    ("09b-watt-pair-doubled", Some("mech::geometry::joined_twice")),
    ("12-free-roller", None),
    ("held-twice-help", Some("mech::determinacy::not_parallel")),
    ("13-two-guides-same-slider", Some("mech::determinacy::repeated")),
    ("21-balance-where-known", None),
    ("wrong-end-accepted", Some("mech::determinacy::two_letters")),
    ("22-pin-without-shared-point", Some("mech::determinacy::two_letters")),
];

fn problems(name: &str) -> Vec<(String, String)> {
    let path =
        Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cases/structure").join(format!("{name}.mech"));
    let text = std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    let source = Source::new(name, text);
    let (_, problems) = assur::internals::compile(&source, &Overrides::none());
    let views = problems.views(&source).into_iter();
    let shown = |d: assur::internals::diagnostic::DiagnosticView| {
        (d.code.unwrap_or_default(), format!("{}\n{}", d.message, d.help.unwrap_or_default()))
    };
    views.map(shown).collect()
}

#[test]
fn what_is_wanted() {
    for (name, code, words) in CASES {
        let found = problems(name);
        assert_eq!(found.len(), 1, "{name}: {found:?}");
        assert_eq!(found[0].0, format!("mech::determinacy::{code}"), "{name}: {}", found[0].1);
        for words in *words {
            assert!(found[0].1.contains(words), "{name}: {words}\n{}", found[0].1);
        }
    }
}

#[test]
fn what_was_right() {
    for (name, code) in OTHERS {
        let found = problems(name);
        assert_eq!(found.first().map(|f| f.0.as_str()), *code, "{name}: {found:?}");
    }
}

#[test]
fn a_line_that_holds_an_angle_again_fits_beside_the_first() {
    let (_, said) = &problems("held-twice-help")[0];
    assert!(said.contains("write `prismatic c: block.B - wedge.top { angle 70 deg }`"), "{said}");
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cases/structure");
    let text = std::fs::read_to_string(folder.join("held-twice-help.mech")).expect("a file");
    let healed = text.replace("block.B - wedge.top", "block.B - wedge.top { angle 70 deg }");
    assert!(assur::solve(&healed).is_ok());
}

#[test]
fn every_file_is_judged() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cases/structure");
    let files = std::fs::read_dir(folder).expect("a folder").flatten().count();
    assert_eq!(files, CASES.len() + OTHERS.len());
}
