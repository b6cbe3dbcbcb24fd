//! Files to start from, and the manual.

#![allow(clippy::unwrap_used)] // a test that cannot read its files has failed

use crate::run::{Folder, assur};
use assur::internals::language::{FUNCTIONS, UNITS, WORDS};

const KINDS: [&str; 5] = ["four-bar", "crank-slider", "six-bar", "train", "cam"];

#[test]
fn a_new_file_is_short_and_right() {
    for kind in KINDS {
        let folder = Folder::new("new");
        let out = assur(&folder, &["new", "first", "--kind", kind]);
        assert_eq!((out.status, out.stderr.as_str()), (0, ""), "{kind}");
        assert_eq!(out.stdout, "wrote first.mech; solve it with: assur solve first.mech\n");
        let text = folder.read("first.mech");
        assert!(text.lines().count() <= 25, "{kind}: {}", text.lines().count());
        assert!(text.lines().all(|line| line.chars().count() <= 100), "{kind}");
        assert!(text.matches("//").count() >= 3, "{kind} has comments");
        for command in ["check", "solve", "test"] {
            let out = assur(&folder, &[command, "first.mech"]);
            assert_eq!((out.status, out.stderr.as_str()), (0, ""), "{kind}: {command}");
            assert!(command != "test" || out.stdout.contains("met"), "{kind}: {}", out.stdout);
        }
    }
}

#[test]
fn a_new_file_replaces_none() {
    let folder = Folder::new("new_twice").with("mine.mech", "// mine\n");
    let out = assur(&folder, &["new", "mine"]);
    assert_eq!((out.status, out.stdout.as_str()), (2, ""));
    assert!(out.stderr.contains("`mine.mech` exists already"), "{}", out.stderr);
    assert_eq!(folder.read("mine.mech"), "// mine\n");
    assert_eq!(assur(&folder, &["new", "other.mech"]).status, 0);
    assert!(folder.read("other.mech").contains("A four-bar linkage"), "the usual kind");
    for args in [&["new"][..], &["new", ""], &["new", "nowhere/a"], &["new", "b", "--kind", "clock"]] {
        let out = assur(&folder, args);
        assert_eq!((out.status, out.stdout.as_str()), (2, ""), "{args:?}");
        assert!(!out.stderr.is_empty(), "{args:?}");
    }
    assert_eq!(folder.names(), ["mine.mech", "other.mech"]);
}

#[test]
fn the_manual_has_the_tables_of_the_language() {
    let folder = Folder::new("manual");
    let page = |topic: &str| {
        let out = assur(&folder, &["help", topic]);
        assert_eq!((out.status, out.stderr.as_str()), (0, ""), "{topic}");
        out.stdout
    };
    let functions = page("functions");
    for row in FUNCTIONS {
        assert!(functions.contains(&format!("\n  {}(", row.name)), "{}", row.name);
        assert!(row.forms.iter().all(|form| functions.contains(form.means)), "{}", row.name);
    }
    let units = page("units");
    for unit in UNITS {
        assert!(units.contains(&format!("\n  {} ", unit.text)), "{}", unit.text);
    }
    assert!(units.lines().any(|l| l.split_whitespace().eq(["mm", "0.001", "m", "length"])), "{units}");
    let statements = page("statements");
    for row in WORDS.iter().flat_map(|(_, list)| *list).filter(|row| !row.example.is_empty()) {
        assert!(statements.contains(&format!("\n  {} ", row.word)), "{}", row.word);
        assert!(statements.contains(row.example), "{}", row.word);
    }
}

#[test]
fn the_manual_has_every_command() {
    let folder = Folder::new("commands");
    let whole = assur(&folder, &["help"]);
    assert_eq!((whole.status, whole.stderr.as_str()), (0, ""));
    assert_eq!(whole.stdout, assur(&folder, &["--help"]).stdout);
    for command in [
        "check",
        "solve",
        "test",
        "batch",
        "grade",
        "accuracy",
        "profile",
        "explain",
        "fmt",
        "lsp",
        "new",
        "completions",
        "man",
        "info",
        "help",
    ] {
        let out = assur(&folder, &["help", command]);
        assert_eq!((out.status, out.stderr.as_str()), (0, ""), "{command}");
        assert_eq!(out.stdout, assur(&folder, &[command, "--help"]).stdout, "{command}");
        assert!(out.stdout.contains(&format!("Usage: assur {command}")), "{}", out.stdout);
    }
    let unknown = assur(&folder, &["help", "function"]);
    assert_eq!((unknown.status, unknown.stdout.as_str()), (2, ""));
    assert!(unknown.stderr.contains("did you mean `assur help functions`?"), "{}", unknown.stderr);
}

#[test]
fn shells_and_manuals_know_every_command() {
    let folder = Folder::new("completions");
    for shell in ["bash", "elvish", "fish", "powershell", "zsh"] {
        let script = assur(&folder, &["completions", shell]);
        assert_eq!((script.status, script.stderr.as_str()), (0, ""), "{shell}");
        for word in ["assur", "solve", "variants", "threads"] {
            assert!(script.stdout.contains(word), "{word} in {shell}");
        }
    }
    let bash = assur(&folder, &["completions", "bash"]).stdout;
    assert!(bash.contains("latex") && bash.contains("crank-slider"), "the values of options");
    let page = assur(&folder, &["man"]);
    assert_eq!((page.status, page.stderr.as_str()), (0, ""));
    assert!(page.stdout.contains(".TH assur 1") && page.stdout.contains("solve"), "{}", page.stdout);
    let page = assur(&folder, &["man", "solve"]);
    assert!(page.stdout.contains("assur solve") && page.stdout.contains("\\-\\-within"), "{}", page.stdout);
    let unknown = assur(&folder, &["man", "slove"]);
    assert_eq!((unknown.status, unknown.stdout.as_str()), (2, ""));
    assert!(unknown.stderr.contains("did you mean `assur man solve`?"), "{}", unknown.stderr);
}

#[test]
fn a_build_says_what_it_can_do() {
    let folder = Folder::new("info");
    let text = assur(&folder, &["info"]);
    assert_eq!((text.status, text.stderr.as_str()), (0, ""));
    let version = env!("CARGO_PKG_VERSION");
    assert!(text.stdout.starts_with(&format!("assur {version}\ntarget ")), "{}", text.stdout);
    let json = assur(&folder, &["info", "--format", "json"]);
    let about: serde_json::Value = serde_json::from_str(&json.stdout).unwrap();
    assert_eq!(about["version"], version);
    assert!(about["processors"].as_u64().unwrap() > 0 && about["target"].as_str().unwrap().contains('-'));
    let has = |what: &str, name: &str| about[what].as_array().unwrap().iter().any(|found| found == name);
    assert_eq!(has("features", "arrow"), cfg!(feature = "arrow"));
    assert_eq!(has("features", "lsp"), cfg!(feature = "lsp"));
    let writes = about["writes"]["batch"].as_array().unwrap();
    assert!(writes.iter().any(|name| name == "csv"));
    assert_eq!(writes.iter().any(|name| name == "parquet"), cfg!(feature = "parquet"));
    assert_eq!(about["reads"]["problems"], serde_json::json!(["mech"]));
}
