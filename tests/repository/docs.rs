//! Every snippet of the documents: whole files check, fragments read.

use assur::internals::check::Overrides;
use assur::internals::diagnostic::{Style, render};
use assur::internals::source::Source;
use std::path::Path;

/// Blocks fenced by ```` ```mech ```` (true) or ```` ```mech fragment ```` (false).
fn blocks(text: &str) -> Vec<(bool, String)> {
    let mut found: Vec<(bool, String)> = Vec::new();
    let mut inside = false;
    for line in text.lines() {
        match line.trim_end() {
            "```mech" | "```mech fragment" if !inside => {
                inside = true;
                found.push((line.trim_end() == "```mech", String::new()));
            }
            "```" if inside => inside = false,
            _ if inside => {
                if let Some((_, block)) = found.last_mut() {
                    block.push_str(line);
                    block.push('\n');
                }
            }
            _ => {}
        }
    }
    found
}

#[test]
fn every_snippet_is_right() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut pages = vec![root.join("README.md")];
    for entry in std::fs::read_dir(root.join("docs")).expect("docs").flatten() {
        if entry.path().extension().is_some_and(|e| e == "md") {
            pages.push(entry.path());
        }
    }
    let (mut count, mut wrong) = (0, Vec::new());
    for page in pages {
        let name = page.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
        for (whole, block) in blocks(&std::fs::read_to_string(&page).expect("a page")) {
            count += 1;
            let source = Source::new(&name, block);
            let problems = if whole {
                assur::internals::compile(&source, &Overrides::none()).1
            } else {
                assur::internals::syntax::parse(&source).1
            };
            if problems.has_errors() {
                wrong.push(render(&problems, &source, Style::PLAIN));
            }
        }
    }
    assert!(count > 5, "snippets are found");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
