//! Every folder uses only those that ARCHITECTURE.md lets it use.

use std::path::PathBuf;

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

fn table() -> Vec<Row> {
    let text = std::fs::read_to_string(root().join("ARCHITECTURE.md")).expect("ARCHITECTURE.md");
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
            for part in text.split("crate::").skip(1) {
                let used: String = part.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
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
