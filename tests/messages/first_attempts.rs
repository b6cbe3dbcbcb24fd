//! What people wrote at the first attempt and that is read as they meant it, or answered with one message.

use crate::case::text;
use assur::internals::check::Overrides;
use assur::internals::source::Source;

/// A file below `tests/cases`, the one code reported, and words of its help.
const CASES: &[(&str, Option<&str>, &[&str])] = &[
    (
        "messages/083-extra-pair-other",
        Some("mech::determinacy::overconstrained"),
        &["leave out `revolute X`"],
    ),
    ("messages/178-set-comma", None, &[]),
    ("spellings/f2", Some("mech::name::unknown"), &["`B`, `C`"]),
    ("spellings/f11", None, &[]),
    ("spellings/f22", None, &[]),
    ("spellings/fw", None, &[]),
    ("spellings/g5", None, &[]),
    ("spellings/g6", None, &[]),
    ("spellings/g7", None, &[]),
    ("spellings/lk", None, &[]),
    ("spellings/lower", Some("mech::friction::locked"), &["below 0.06366"]),
    ("spellings/omega2", None, &[]),
    ("spellings/scissor-ambiguous", None, &[]),
    ("spellings/sliderP", Some("mech::assembly::ambiguous"), &["assemble B left of A-C"]),
    ("spellings/two", None, &[]),
    ("spellings/two2", Some("mech::determinacy::efforts"), &["leave out `balance F` or `balance F2`"]),
    ("spellings/two3", None, &[]),
    ("spellings/tx", None, &[]),
    ("spellings/v1", None, &[]),
    ("spellings/v4", Some("mech::request::asked_twice"), &["NAME = omega(rod)"]),
    ("spellings/v7", None, &[]),
    ("spellings/v19", None, &[]),
    ("spellings/v20", None, &[]),
    ("spellings/v21", None, &[]),
    ("spellings/vr", None, &[]),
];

#[test]
fn one_message_or_none() {
    for (case, code, words) in CASES {
        let source = Source::new("case.mech", text(case));
        let found = assur::internals::test_source(&source, &Overrides::none()).1.views(&source);
        let codes: Vec<&str> = found.iter().filter_map(|d| d.code.as_deref()).collect();
        assert_eq!(codes, code.iter().copied().collect::<Vec<_>>(), "{case}: {found:#?}");
        for words in *words {
            assert!(found[0].help.as_ref().is_some_and(|h| h.contains(words)), "{case}: {found:#?}");
        }
    }
}
