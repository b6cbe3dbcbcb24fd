//! Files with a mistake below `tests/cases`: what is reported about them, and what becomes of them where help is followed.

use assur::internals::check::Overrides;
use assur::internals::diagnostic::{DiagnosticView, Problems};
use assur::internals::source::Source;
use std::path::{Path, PathBuf};

/// A file with a mistake.
pub struct Case {
    /// Below `tests/cases`, without its extension.
    pub file: &'static str,
    /// The codes of its errors, in order.
    pub codes: &'static [&'static str],
    /// Words of a message or help.
    pub words: &'static str,
    /// What help offers; with all of it in the file no error is left.
    pub pastes: &'static [Paste],
    /// The answer key belongs to other numbers than those offered.
    pub other_numbers: bool,
}

/// What help offers, and where it goes.
pub enum Paste {
    /// In place of a text.
    Whole(&'static str, &'static str),
    /// In a text, in place of a part of it.
    Part(&'static str, &'static str, &'static str),
    /// Before a text, as a statement of its own.
    Before(&'static str, &'static str),
    /// A line at the end.
    Line(&'static str),
}

impl Paste {
    /// What help offers.
    const fn offered(&self) -> &'static str {
        match self {
            Self::Whole(_, offered)
            | Self::Part(_, _, offered)
            | Self::Before(_, offered)
            | Self::Line(offered) => offered,
        }
    }

    /// The file with it; `None` where its place is not in the file.
    pub fn applied_to(&self, text: &str) -> Option<String> {
        let put = |place: &str, new: &str| text.contains(place).then(|| text.replacen(place, new, 1));
        match self {
            Self::Whole(place, offered) => put(place, offered),
            Self::Part(place, part, offered) => put(place, &place.replacen(part, offered, 1)),
            Self::Before(place, offered) => put(place, &format!("{offered}; {place}")),
            Self::Line(offered) => Some(format!("{text}\n{offered}\n")),
        }
    }
}

/// A case whose answer key is met with what is offered.
pub const fn case(
    file: &'static str,
    codes: &'static [&'static str],
    words: &'static str,
    pastes: &'static [Paste],
) -> Case {
    Case { file, codes, words, pastes, other_numbers: false }
}

/// A case whose answer key may belong to other numbers than those offered.
pub const fn near(
    file: &'static str,
    codes: &'static [&'static str],
    words: &'static str,
    pastes: &'static [Paste],
) -> Case {
    Case { file, codes, words, pastes, other_numbers: true }
}

/// The folder of all cases.
pub fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cases")
}

/// The text of a case.
pub fn text(file: &str) -> String {
    std::fs::read_to_string(folder().join(format!("{file}.mech"))).unwrap_or_else(|e| panic!("{file}: {e}"))
}

/// The errors among the problems.
pub fn errors(problems: &Problems, source: &Source) -> Vec<DiagnosticView> {
    problems.views(source).into_iter().filter(|d| d.severity == "error").collect()
}

/// The errors of a text that is solved and compared with its answer key.
pub fn tested(text: &str) -> Vec<DiagnosticView> {
    let source = Source::new("case.mech", text);
    errors(&assur::internals::test_source(&source, &Overrides::none()).1, &source)
}

/// Messages and help.
pub fn said(found: &[DiagnosticView]) -> String {
    let all = found.iter().map(|d| format!("{} {}", d.message, d.help.as_deref().unwrap_or_default()));
    all.collect::<Vec<_>>().join(" ")
}

/// Judges all cases by what `said` makes of their errors.
pub fn judge(cases: &[Case], said: fn(&[DiagnosticView]) -> String) {
    let wrong = cases.iter().filter_map(|case| judge_one(case, said).err()).collect::<Vec<_>>();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

fn judge_one(case: &Case, said: fn(&[DiagnosticView]) -> String) -> Result<(), String> {
    let Case { file, codes, words, pastes, other_numbers } = case;
    let text = text(file);
    let found = tested(&text);
    let (said, seen) = (said(&found), found.iter().filter_map(|d| d.code.as_deref()).collect::<Vec<_>>());
    if seen != *codes || !said.contains(words) {
        return Err(format!("{file}: {seen:?}: {said}"));
    }
    let mut fixed = text;
    for paste in *pastes {
        let offered = paste.offered();
        if !said.contains(offered) {
            return Err(format!("{file}: `{offered}` is not offered: {said}"));
        }
        fixed =
            paste.applied_to(&fixed).ok_or(format!("{file}: the place of `{offered}` is not in the file"))?;
    }
    if pastes.is_empty() {
        return Ok(());
    }
    let counts =
        |d: &DiagnosticView| !(*other_numbers && d.code.as_deref() == Some("mech::expect::mismatch"));
    let left = tested(&fixed).into_iter().filter(counts);
    let left = left.map(|d| format!("{:?}: {}", d.code, d.message)).collect::<Vec<_>>();
    if left.is_empty() { Ok(()) } else { Err(format!("{file}: {left:#?}")) }
}
