//! Every folder of `src` uses only those that ARCHITECTURE.md lets it use.

mod folder;

use std::path::PathBuf;

/// The rows of the table: folder and what it may use.
fn table() -> Vec<(String, Vec<String>)> {
    let text = std::fs::read_to_string(root().join("ARCHITECTURE.md")).expect("ARCHITECTURE.md");
    let mut rows: Vec<(String, Vec<String>)> = Vec::new();
    for line in text.lines().filter(|l| l.starts_with("| `src/")) {
        let cells: Vec<&str> = line.split('|').map(str::trim).collect();
        let folder = cells[1].trim_matches('`').trim_start_matches("src/").to_owned();
        let uses = if cells[3] == "everything above" {
            rows.iter().map(|r| r.0.clone()).collect()
        } else {
            cells[3].split(", ").filter(|s| !s.is_empty()).map(str::to_owned).collect()
        };
        rows.push((folder, uses));
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
    for (folder, uses) in &rows {
        for path in folder::files(&root().join("src").join(folder), "rs") {
            let text = std::fs::read_to_string(&path).expect("a source file");
            // what stands below `mod tests` may look anywhere
            let code = text.split("#[cfg(test)]").next().unwrap_or_default();
            for part in code.split("crate::").skip(1) {
                let used: String = part.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
                let known = rows.iter().any(|r| r.0 == used);
                if known && used != *folder && !uses.contains(&used) {
                    wrong.push(format!("{} uses {used}", path.display()));
                }
            }
        }
    }
    wrong.dedup();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
