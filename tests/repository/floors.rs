//! Floors within a stage use only those that `crates/README.md` lets them use, and no ring of files is long.

use crate::folder;

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// The files of the longest ring that is allowed.
const LONGEST: usize = 5;

/// The folders whose files are judged.
const FOLDERS: [&str; 11] = [
    "crates/assur-text/src",
    "crates/assur-math/src",
    "crates/assur-syntax/src",
    "crates/assur-format/src",
    "crates/assur-model/src",
    "crates/assur-check/src",
    "crates/assur-position/src",
    "crates/assur-solve/src",
    "crates/assur-drawing/src",
    "crates/assur-picture/src",
    "src",
];

/// A row of a table: a floor and those it may use.
type Row = (String, Vec<String>);

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

/// The tables of floors, by the folder they are of.
fn tables() -> Vec<(PathBuf, Vec<Row>)> {
    let text = std::fs::read_to_string(root().join("crates/README.md")).expect("crates/README.md");
    let mut tables = Vec::new();
    for part in text.split("| floor of `").skip(1) {
        let (folder, rest) = part.split_once('`').expect("the folder in backticks");
        let rows = rest.lines().skip(2).take_while(|line| line.starts_with('|')).map(|line| {
            let cells: Vec<&str> = line.split('|').map(str::trim).collect();
            let uses = cells[3].split(", ").filter(|s| !s.is_empty()).map(str::to_owned).collect();
            (cells[1].trim_matches('`').to_owned(), uses)
        });
        tables.push((root().join(folder), rows.collect()));
    }
    tables
}

/// Every path from the crate's root that a file names, as its words; braces are written out.
fn paths(text: &str) -> Vec<Vec<String>> {
    let code: String =
        text.lines().map(|l| l.split("//").next().unwrap_or_default()).collect::<Vec<_>>().join("\n");
    let mut found = Vec::new();
    for part in code.split("crate::").skip(1) {
        let ends = |c: char| !(c.is_alphanumeric() || "_:{}, \n".contains(c));
        expand(&[], &part[..part.find(ends).unwrap_or(part.len())], &mut found);
    }
    found
}

/// Reads one path, or a list of paths in braces, behind some words; gives the rest.
fn expand<'t>(before: &[String], text: &'t str, found: &mut Vec<Vec<String>>) -> &'t str {
    let mut path = before.to_vec();
    let mut rest = text.trim_start();
    loop {
        if let Some(list) = rest.strip_prefix('{') {
            rest = list.trim_start();
            while !rest.is_empty() && !rest.starts_with('}') {
                let after = expand(&path, rest, found);
                // what is no list of paths ends here
                let Some(after) = after.trim_start().strip_prefix(',') else {
                    return after.trim_start().trim_start_matches('}');
                };
                rest = after.trim_start();
            }
            return rest.trim_start_matches('}');
        }
        let end = rest.find(|c: char| !(c.is_alphanumeric() || c == '_')).unwrap_or(rest.len());
        path.push(rest[..end].to_owned());
        rest = &rest[end..];
        match rest.strip_prefix("::") {
            Some(more) => rest = more,
            None => {
                found.push(path);
                return rest;
            }
        }
    }
}

#[test]
fn floors_use_only_those_below() {
    let tables = tables();
    assert!(!tables.is_empty(), "a table is read");
    let mut wrong = Vec::new();
    for (folder, rows) in &tables {
        let known: BTreeSet<&str> = rows.iter().map(|(name, _)| name.as_str()).collect();
        for entry in std::fs::read_dir(folder).expect("a folder") {
            let entry = entry.expect("an entry");
            let name = entry.file_name().to_string_lossy().into_owned();
            let is_floor = entry.file_type().expect("a type").is_dir();
            assert!(!is_floor || known.contains(name.as_str()), "`{name}` is not in the table");
        }
        for (name, uses) in rows {
            for file in folder::files(&folder.join(name), "rs") {
                let text = std::fs::read_to_string(&file).expect("a source file");
                let used = paths(&text).into_iter().map(|p| p[0].clone());
                let bad = used.filter(|u| u != name && known.contains(u.as_str()) && !uses.contains(u));
                wrong.extend(bad.map(|u| format!("{} uses {u}", file.display())));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The module of a file: `a::b` of `a/b.rs` and of `a/b/mod.rs`.
fn module(folder: &Path, file: &Path) -> Vec<String> {
    let path = file.strip_prefix(folder).expect("below the folder").with_extension("");
    let words = path.iter().map(|w| w.to_string_lossy().into_owned());
    words.filter(|w| w != "mod" && w != "lib").collect()
}

/// The text of a file with `super` written out, without unit tests and words of visibility.
fn code(file: &Path, own: &[String]) -> String {
    let text = std::fs::read_to_string(file).expect("a source file");
    let text = text.split("#[cfg(test)]\nmod tests {").next().unwrap_or_default();
    let text = text.replace("pub(super) ", "pub ").replace("pub(crate) ", "pub ");
    let above = |steps: usize| {
        let words = own[..own.len().saturating_sub(steps)].iter().map(|w| format!("{w}::"));
        format!("crate::{}", words.collect::<String>())
    };
    text.replace("super::super::", &above(2)).replace("super::", &above(1))
}

/// What modules hand on by `pub use`: the path by which it is used, and where it is.
fn handed_on(sources: &BTreeMap<PathBuf, (Vec<String>, String)>) -> BTreeMap<Vec<String>, Vec<String>> {
    let mut handed = BTreeMap::new();
    for (own, text) in sources.values() {
        for statement in text.split("\npub use ").skip(1) {
            let path = statement.split(';').next().unwrap_or_default();
            let mut found = Vec::new();
            match path.strip_prefix("crate::") {
                Some(path) => _ = expand(&[], path, &mut found),
                None => _ = expand(own, path, &mut found),
            }
            for path in found {
                let by = own.iter().chain(path.last()).cloned().collect::<Vec<_>>();
                handed.insert(by, path);
            }
        }
    }
    handed
}

/// The files of a crate, and for each the files it uses by `crate::` or `super::`.
fn uses(folder: &Path) -> BTreeMap<PathBuf, BTreeSet<PathBuf>> {
    let source = |file: PathBuf| {
        let own = module(folder, &file);
        let code = code(&file, &own);
        (file, (own, code))
    };
    let sources: BTreeMap<_, _> = folder::files(folder, "rs").into_iter().map(source).collect();
    let by_module: BTreeMap<_, _> = sources.iter().map(|(file, (own, _))| (own.clone(), file)).collect();
    let handed = handed_on(&sources);
    // a path is handed on a few times at most
    let place = |path: Vec<String>| {
        let to = (0..4).fold(path, |path, _| {
            let part = (1..=path.len()).rev().find(|n| handed.contains_key(&path[..*n]));
            let Some(n) = part.filter(|n| *n == path.len() || !by_module.contains_key(&path[..*n])) else {
                return path;
            };
            handed[&path[..n]].iter().chain(&path[n..]).cloned().collect()
        });
        (0..=to.len()).rev().find_map(|n| by_module.get(&to[..n])).map(|file| (*file).clone())
    };
    let used = |(file, (_, text)): (&PathBuf, &(Vec<String>, String))| {
        // what a module only hands on it does not use
        let kept = text.split("\npub use ").enumerate();
        let kept = kept.map(|(i, part)| if i == 0 { part } else { part.split_once(';').map_or("", |p| p.1) });
        let found = paths(&kept.collect::<Vec<_>>().join("\n")).into_iter().filter_map(place);
        (file.clone(), found.filter(|f| f != file).collect())
    };
    sources.iter().map(used).collect()
}

/// All files that can be reached from one.
fn reached(graph: &BTreeMap<PathBuf, BTreeSet<PathBuf>>, from: &Path) -> BTreeSet<PathBuf> {
    let mut seen = BTreeSet::new();
    let mut open = vec![from.to_path_buf()];
    while let Some(at) = open.pop() {
        let next = graph.get(&at).into_iter().flatten();
        open.extend(next.filter(|f| seen.insert((*f).clone())).cloned().collect::<Vec<_>>());
    }
    seen
}

#[test]
fn rings_of_files_are_small() {
    let mut wrong = Vec::new();
    for name in FOLDERS {
        let folder = root().join(name);
        let graph = uses(&folder);
        let all: BTreeMap<&PathBuf, BTreeSet<PathBuf>> =
            graph.keys().map(|f| (f, reached(&graph, f))).collect();
        for (file, reach) in &all {
            let ring: Vec<_> = reach.iter().filter(|f| all[f].contains(*file)).collect();
            if ring.len() > LONGEST && ring.first() == Some(file) {
                wrong.push(format!("{} files: {ring:?}", ring.len()));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn braces_are_written_out() {
    let text = "use crate::a::{b::C, d::{E, F}};\nuse crate::g;\nlet x = crate::h::i(1);";
    let found: Vec<String> = paths(text).into_iter().map(|p| p.join("::")).collect();
    assert_eq!(found, ["a::b::C", "a::d::E", "a::d::F", "g", "h::i"]);
}
