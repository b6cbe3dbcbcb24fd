//! Every folder uses only those that `crates/README.md` lets it use, every test is named in `tests/README.md`, and ARCHITECTURE.md
//! names files that exist.

use std::path::{Path, PathBuf};

/// A row of the table.
#[derive(Debug)]
struct Row {
    /// What others call it.
    name: String,
    /// Where it is.
    path: PathBuf,
    /// What it may use.
    uses: Vec<String>,
}

fn page(name: &str) -> String {
    std::fs::read_to_string(root().join(name)).expect("a page")
}

fn table() -> Vec<Row> {
    let text = page("crates/README.md");
    let mut rows: Vec<Row> = Vec::new();
    for line in text.lines().filter(|l| l.starts_with("| `") && l.contains("src")) {
        let cells: Vec<&str> = line.split('|').map(str::trim).collect();
        let path = cells[1].trim_matches('`');
        let (parent, last) = path.rsplit_once('/').expect("a folder below another");
        // a crate that is one floor is called by its own name
        let name = if last == "src" { parent.trim_start_matches("crates/assur-") } else { last };
        let uses = if cells[3] == "everything above" {
            rows.iter().map(|r| r.name.clone()).collect()
        } else {
            cells[3].split(", ").filter(|s| !s.is_empty()).map(str::to_owned).collect()
        };
        rows.push(Row { name: name.to_owned(), path: root().join(path), uses });
    }
    rows
}

/// The first name of every path that begins at a crate: `crate::name`, `assur_math::name`; of `assur_check`, the crate.
fn floors_named(text: &str) -> Vec<String> {
    let word =
        |part: &str| -> String { part.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect() };
    let own = text.split("crate::").skip(1).map(word);
    let others = text.split("assur_").skip(1).flat_map(|part| {
        let name = word(part);
        let inner = part[name.len()..].strip_prefix("::").unwrap_or_default();
        let listed =
            inner.strip_prefix('{').and_then(|list| list.split_once('}')).map_or(inner, |(list, _)| list);
        let names =
            listed.split(',').map(|n| word(n.trim())).take(if inner.starts_with('{') { 99 } else { 1 });
        names.chain([name.clone()]).collect::<Vec<_>>()
    });
    own.chain(others).collect()
}

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

#[test]
fn every_folder_uses_only_those_before_it() {
    let rows = table();
    assert!(rows.len() > 10, "the table is read: {rows:?}");
    let mut wrong = Vec::new();
    for row in &rows {
        let files = crate::folder::files(&row.path, "rs");
        assert!(!files.is_empty(), "{}", row.path.display());
        for path in files {
            let text = std::fs::read_to_string(&path).expect("a source file");
            for used in floors_named(&text) {
                let known = rows.iter().any(|r| r.name == used);
                if known && used != row.name && !row.uses.contains(&used) {
                    wrong.push(format!("{} uses {used}", path.display()));
                }
            }
        }
    }
    wrong.dedup();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn the_protocol_of_editors_is_in_one_folder() {
    let of = |folder: &str| crate::folder::files(&root().join(folder), "rs");
    for file in of("src/editor") {
        let text = std::fs::read_to_string(&file).expect("a source file");
        assert!(!text.contains("lsp"), "{} names the protocol", file.display());
    }
    for file in of("src/lsp") {
        let text = std::fs::read_to_string(&file).expect("a source file");
        for floor in ["assur_check", "assur_model", "assur_solve", "crate::pipeline", "crate::report"] {
            assert!(!text.contains(floor), "{} names {floor}", file.display());
        }
    }
}

/// What a text names of the modules of clocks and threads.
fn clocks_and_threads(text: &str) -> Vec<&'static str> {
    let code: String = text.lines().map(|l| l.split("//").next().unwrap_or_default()).collect();
    let code = code.replace(char::is_whitespace, "");
    let listed = |module: &str| {
        let lists = code.split("std::{").skip(1).map(|list| list.split(';').next().unwrap_or_default());
        lists.flat_map(|list| list.split([',', '{', '}'])).any(|name| name.split("::").next() == Some(module))
    };
    let of_std = [("std::time", "time"), ("std::thread", "thread")];
    let mut named: Vec<_> = of_std
        .into_iter()
        .filter(|(path, module)| code.contains(path) || listed(module))
        .map(|(path, _)| path)
        .collect();
    named.extend(code.contains("rayon").then_some("rayon"));
    named
}

#[test]
fn clocks_and_threads_are_of_the_command_line() {
    let mut wrong = Vec::new();
    for folder in ["src", "crates"] {
        for path in crate::folder::files(&root().join(folder), "rs") {
            let own = path.strip_prefix(root()).expect("below the root");
            let is_test =
                own.starts_with("crates") && own.iter().any(|part| part == "tests" || part == "benches");
            if own.starts_with("src/cli") || is_test {
                continue;
            }
            let text = std::fs::read_to_string(&path).expect("a source file");
            let named = clocks_and_threads(&text).into_iter();
            wrong.extend(named.map(|name| format!("{} names {name}", own.display())));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    for text in
        ["use std::time::Instant;", "use std::{fmt, time::{Duration}};", "std ::\n time ::Instant::now()"]
    {
        assert_eq!(clocks_and_threads(text), ["std::time"], "{text}");
    }
    assert!(clocks_and_threads("use std::{fmt, sync::Arc}; // std::time").is_empty());
}

/// The paths in the first column of the table of tests.
fn tests_named() -> Vec<String> {
    let text = page("tests/README.md");
    let first = |line: &str| line.strip_prefix("| `")?.split(" | ").next().map(str::to_owned);
    let cells = text.lines().filter_map(first).collect::<Vec<_>>();
    cells.iter().flat_map(|cell| cell.split(", ")).map(|path| path.trim_matches('`').to_owned()).collect()
}

/// `tests/mechanics/friction` of `tests/mechanics/friction/fixed_point.rs`, `tests/mechanics` of its `main.rs`.
fn module_of(file: &Path) -> String {
    let path = file.strip_prefix(root()).expect("below the root").with_extension("");
    let parts = path.iter().map(|part| part.to_string_lossy()).take(3);
    parts.filter(|part| part != "main" && part != "mod").collect::<Vec<_>>().join("/")
}

#[test]
fn every_test_is_named() {
    let named = tests_named();
    assert!(named.len() > 40, "the table is read: {named:?}");
    let files = crate::folder::files(&root().join("tests"), "rs");
    let mut wrong =
        files.iter().map(|file| module_of(file)).filter(|m| !named.contains(m)).collect::<Vec<_>>();
    wrong.dedup();
    assert!(wrong.is_empty(), "not in the table: {wrong:?}");
    let is_there = |path: &String| root().join(path).exists() || root().join(format!("{path}.rs")).exists();
    let gone = named.iter().filter(|path| !is_there(path)).collect::<Vec<_>>();
    assert!(gone.is_empty(), "in the table alone: {gone:?}");
    for krate in std::fs::read_dir(root().join("crates")).expect("crates").flatten() {
        let unit = format!("crates/{}/tests/unit", krate.file_name().to_string_lossy());
        assert!(named.contains(&unit) || !root().join(&unit).exists(), "not in the table: {unit}");
    }
}

/// The rows of "A change: where does it go?": what is changed, and the paths.
fn changes(text: &str) -> Vec<(&str, Vec<&str>)> {
    let (_, rest) = text.split_once("\n## A change: where does it go?\n").expect("a heading");
    let (rows, _) = rest.split_once("\n## ").expect("a heading after it");
    rows.lines()
        .filter_map(|line| line.strip_prefix("| ")?.split_once(" | "))
        .map(|(what, row)| {
            let words = row.split('`').skip(1).step_by(2);
            (what, words.filter(|word| word.contains('/')).collect())
        })
        .collect()
}

#[test]
fn files_of_a_change_are_there() {
    let text = page("ARCHITECTURE.md");
    let paths: Vec<&str> = changes(&text).into_iter().flat_map(|(_, paths)| paths).collect();
    assert!(paths.len() > 20, "the table is read: {paths:?}");
    let gone: Vec<_> = paths.into_iter().filter(|path| !root().join(path).exists()).collect();
    assert!(gone.is_empty(), "{gone:?}");
    assert!(text.len() <= 16_000, "{} bytes", text.len());
}

/// Jerks are in the files that the rows of a question and of a derivative name, and in no others; worked solutions are apart.
#[test]
fn a_derivative_is_in_the_files_of_its_rows() {
    let text = page("ARCHITECTURE.md");
    let rows = changes(&text);
    let of = |what: &str| {
        let row = rows.iter().find(|row| row.0.starts_with(what));
        row.unwrap_or_else(|| panic!("no row of {what}")).1.clone()
    };
    let named = [of("a question"), of("another derivative")].concat();
    let apart = ["crates/assur-formula/", "crates/assur-worked/"];
    // the third derivative of the law of a cam, and a letter
    let others = ["model/cam_part.rs", "latex/signs.rs", "drawing/src/text.rs"];
    let mut found = Vec::new();
    for path in ["src", "crates"].iter().flat_map(|folder| crate::folder::files(&root().join(folder), "rs")) {
        let own = path.strip_prefix(root()).expect("below the root").display().to_string();
        let text = std::fs::read_to_string(&path).expect("a source file").to_lowercase();
        let is_apart = own.contains("/tests/")
            || apart.iter().any(|folder| own.starts_with(folder))
            || others.iter().any(|end| own.ends_with(end));
        if !is_apart && (text.contains("jerk") || text.contains("zeta")) {
            found.push(own);
        }
    }
    let astray: Vec<_> = found.iter().filter(|own| !named.iter().any(|row| own.starts_with(row))).collect();
    assert!(astray.is_empty(), "{astray:?}");
    assert!(found.len() <= 14, "{} files: {found:?}", found.len());
}
