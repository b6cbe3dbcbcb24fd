//! What a help offers to paste does what it says.

use crate::paste::{pasted, read};
use assur::internals::check::Overrides;
use assur::internals::diagnostic::DiagnosticView;
use assur::internals::message::clause;
use assur::internals::solve::GroupAssembly;
use assur::internals::source::Source;
use std::path::{Path, PathBuf};

fn diagnostics(text: &str) -> Vec<DiagnosticView> {
    let source = Source::new("text.mech", text);
    assur::internals::solve_source(&source, &Overrides::none()).1.views(&source)
}

fn files(code: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/errors").join(code);
    let entries = std::fs::read_dir(&folder).expect("a folder").flatten().map(|e| e.path());
    let mut files: Vec<PathBuf> = entries.filter(|p| p.extension().is_some_and(|e| e == "mech")).collect();
    files.sort();
    assert!(!files.is_empty(), "{}", folder.display());
    files
}

/// The text and help of a wrong file with the code.
fn help(path: &Path, code: &str) -> (String, String) {
    let text = std::fs::read_to_string(path).expect("a text");
    let code = format!("mech::{}", code.replace('/', "::"));
    let found = diagnostics(&text).into_iter().find(|d| d.code.as_ref() == Some(&code));
    let help = found.and_then(|d| d.help).unwrap_or_else(|| panic!("{}: no help", path.display()));
    (text, help)
}

/// The lines to paste, by the sentence above them.
fn sections(help: &str) -> Vec<(&str, Vec<&str>)> {
    let mut out: Vec<(&str, Vec<&str>)> = Vec::new();
    for line in help.lines() {
        match (line.strip_prefix("  "), out.last_mut()) {
            (Some(pasted), Some(section)) => section.1.push(pasted),
            _ => out.push((line, Vec::new())),
        }
    }
    out.retain(|s| !s.1.is_empty());
    out
}

/// Every choice of one line per section.
fn product<'a>(sections: &[(&str, Vec<&'a str>)]) -> Vec<Vec<&'a str>> {
    sections.iter().fold(vec![Vec::new()], |chosen, (_, lines)| {
        let with = |c: &Vec<&'a str>, line: &&'a str| c.iter().copied().chain([*line]).collect();
        chosen.iter().flat_map(|c| lines.iter().map(move |line| with(c, line))).collect()
    })
}

#[test]
fn a_choice_of_assembly() {
    for path in files("assembly/ambiguous") {
        let (text, help) = help(&path, "assembly/ambiguous");
        let sections = sections(&help);
        assert!(sections.iter().all(|s| s.1.len() > 1), "{help}");
        for lines in product(&sections) {
            let pasted = format!("{text}\n{}\n", lines.join("\n"));
            let found = diagnostics(&pasted);
            assert!(found.is_empty(), "{}\n{lines:?}\n{found:#?}", path.display());
        }
    }
}

#[test]
fn an_assembly_that_there_is() {
    for path in files("assembly/hint_not_met") {
        let (text, help) = help(&path, "assembly/hint_not_met");
        let without: String =
            text.lines().filter(|l| !l.starts_with("assemble")).map(|l| format!("{l}\n")).collect();
        for (_, lines) in sections(&help) {
            for line in lines {
                let found = diagnostics(&format!("{without}{line}\n"));
                assert!(found.is_empty(), "{}\n{line}\n{found:#?}", path.display());
            }
        }
    }
}

/// Lines of one section are alternatives, unless it says to add several.
fn pastes<'a>(help: &'a str) -> Vec<Vec<&'a str>> {
    let each = |(sentence, lines): (&'a str, Vec<&'a str>)| {
        if sentence.ends_with("lines") { vec![lines] } else { lines.into_iter().map(|l| vec![l]).collect() }
    };
    sections(help).into_iter().flat_map(each).collect()
}

#[test]
fn what_holds_or_drives() {
    for code in ["determinacy/underconstrained", "determinacy/efforts"] {
        for path in files(code) {
            let (text, help) = help(&path, code);
            if help.contains("leave out") {
                continue;
            }
            let pastes = pastes(&help);
            assert!(!pastes.is_empty(), "{}: {help}", path.display());
            for lines in pastes {
                let found = diagnostics(&format!("{text}\n{}\n", lines.join("\n")));
                let still =
                    |d: &DiagnosticView| d.code.as_ref().is_some_and(|c| !c.starts_with("mech::assembly"));
                assert!(!found.iter().any(still), "{}\n{lines:?}\n{found:#?}", path.display());
            }
        }
    }
}

/// The assemblies that `assur check --modes` lists: the line of each, and which the file chooses.
fn listed(text: &str) -> Vec<(Option<String>, bool)> {
    let source = Source::new("text.mech", text);
    let (compiled, _) = assur::internals::compile(&source, &Overrides::none());
    let compiled = compiled.expect("it is sound");
    let model = compiled.model();
    let modes = assur::internals::solve::assemblies(&model).expect("it is solved");
    let line = |m: GroupAssembly| (m.clause.map(|c| clause(&model, &c)), m.chosen);
    modes.groups.into_iter().flat_map(|g| g.assemblies).map(line).collect()
}

#[test]
fn a_listed_assembly() {
    for (name, count) in [("general/class-iii-triad", 2), ("../tests/errors/assembly/ambiguous/six", 6)] {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples").join(format!("{name}.mech"));
        let text = std::fs::read_to_string(&path).expect("a text");
        let open: String =
            text.lines().filter(|l| !l.starts_with("assemble")).map(|l| format!("{l}\n")).collect();
        let modes = listed(&open);
        assert_eq!(modes.len(), count, "{name}: {modes:?}");
        assert!(modes.iter().all(|m| !m.1), "{name}: nothing is chosen");
        for (i, (line, _)) in modes.iter().enumerate() {
            let line = line.as_ref().expect("there are others");
            let chosen: Vec<bool> = listed(&format!("{open}{line}\n")).iter().map(|m| m.1).collect();
            assert!(chosen.iter().enumerate().all(|(k, c)| *c == (k == i)), "{line}: {chosen:?}");
        }
    }
}

/// The wrong files of a stage's codes.
fn wrong_files(stage: &str) -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/errors").join(stage);
    let folders = std::fs::read_dir(root).expect("a folder").flatten();
    let files = folders.flat_map(|f| std::fs::read_dir(f.path()).into_iter().flatten().flatten());
    files.map(|f| f.path()).filter(|p| p.extension().is_some_and(|e| e == "mech")).collect()
}

/// In the files of all codes of reading, a fix removes its own message and adds no other.
#[test]
fn every_fix_of_reading_fixes() {
    let mut count = 0;
    for path in wrong_files("syntax") {
        let text = std::fs::read_to_string(&path).expect("a text");
        let found = read(&text);
        for problem in &found {
            for new in pasted(&text, problem) {
                let left = read(&new);
                let same = |d: &DiagnosticView| d.spans == problem.spans && d.help == problem.help;
                assert!(!left.iter().any(same), "{}: {:?}", path.display(), problem.help);
                assert!(left.len() <= found.len(), "{}: {new}\n{left:#?}", path.display());
                count += 1;
            }
        }
    }
    assert!(count > 50, "{count}");
}
