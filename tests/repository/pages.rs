//! Pages for users have short sentences, and their links lead somewhere.

use crate::folder;
use std::path::{Path, PathBuf};

/// The greatest number of words in a sentence of the first two pages that are read, and of all others.
const WORDS: (usize, usize) = (25, 35);

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Paragraphs and items of lists, each with the number of its first line; without code, tables, headings and comments.
fn paragraphs(text: &str) -> Vec<(usize, String)> {
    let mut found: Vec<(usize, String)> = Vec::new();
    let (mut code, mut open) = (false, false);
    for (i, line) in text.lines().enumerate() {
        let line = line.trim();
        if line.starts_with("```") {
            (code, open) = (!code, false);
            continue;
        }
        if code || line.is_empty() || ["|", "#", "<!--", "@"].iter().any(|sign| line.starts_with(sign)) {
            open = false;
            continue;
        }
        let item = item(line);
        match found.last_mut() {
            Some((_, paragraph)) if open && item.is_none() => {
                paragraph.push(' ');
                paragraph.push_str(line);
            }
            _ => found.push((i + 1, item.unwrap_or(line).to_owned())),
        }
        open = true;
    }
    found
}

/// What is behind the sign or the number of an item.
fn item(line: &str) -> Option<&str> {
    let signs = ["- ", "* ", "> "].iter().find_map(|sign| line.strip_prefix(sign));
    signs.or_else(|| line.split_once(". ").filter(|(n, _)| n.parse::<u32>().is_ok()).map(|(_, rest)| rest))
}

/// A text with one word for each piece of code and without the addresses of links.
fn read_aloud(text: &str) -> String {
    let code = text.split('`').enumerate().map(|(i, part)| if i % 2 == 1 { "code" } else { part });
    let text = code.collect::<String>();
    let mut said = String::new();
    let mut rest = text.as_str();
    while let Some((before, after)) = rest.split_once("](") {
        said.push_str(before);
        rest = after.split_once(')').map_or("", |(_, rest)| rest);
    }
    said.push_str(rest);
    said.replace(['*', '[', '!'], "")
}

/// Sentences, each with its number of words.
fn sentences(paragraph: &str) -> Vec<(usize, String)> {
    let mut found = vec![String::new()];
    for word in read_aloud(paragraph).split_whitespace() {
        if let Some(last) = found.last_mut() {
            last.push_str(word);
            last.push(' ');
        }
        if word.trim_end_matches([')', '"', '”']).ends_with(['.', '?']) {
            found.push(String::new());
        }
    }
    let words = |text: &String| text.split(' ').filter(|w| w.chars().any(char::is_alphanumeric)).count();
    found.into_iter().map(|text| (words(&text), text)).filter(|(count, _)| *count > 0).collect()
}

/// The pages for users: those at the top of `docs`, those of all codes, and the first one.
fn pages() -> Vec<PathBuf> {
    let is_measured = |path: &PathBuf| path.starts_with(root().join("docs/measured"));
    let mut pages = folder::files(&root().join("docs"), "md");
    pages.retain(|path| !is_measured(path));
    pages.push(root().join("README.md"));
    pages.push(root().join("CHANGELOG.md"));
    pages
}

#[test]
fn sentences_are_short() {
    let (mut count, mut wrong) = (0, Vec::new());
    for page in pages() {
        let text = std::fs::read_to_string(&page).expect("a page");
        let name = page.strip_prefix(root()).expect("below the root").display().to_string();
        let most = if name == "README.md" || name == "docs/tour.md" { WORDS.0 } else { WORDS.1 };
        for (line, paragraph) in paragraphs(&text) {
            for (words, sentence) in sentences(&paragraph) {
                count += 1;
                if words > most {
                    wrong.push(format!("{name}:{line}: {words} words, at most {most}: {sentence}"));
                }
            }
        }
    }
    assert!(count > 1000, "sentences are found: {count}");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn sentences_are_found() {
    let text = "# Head\n\nOne `a b. c` [two](x.md). Three (at 0.5 m)\nfour.\n\n- five\n- 6. six\n\n| a. b |\n\n```sh\nc. d.\n```\n";
    let found: Vec<_> = paragraphs(text).into_iter().flat_map(|(_, p)| sentences(&p)).collect();
    let words: Vec<_> = found.iter().map(|(count, text)| (*count, text.trim())).collect();
    assert_eq!(
        words,
        [(3, "One code two."), (5, "Three (at 0.5 m) four."), (1, "five"), (1, "6."), (1, "six")]
    );
}

/// The name by which a heading is found: `## Find and expect` by `find-and-expect`.
fn anchor(heading: &str) -> String {
    let text = read_aloud(&heading.replace('`', "")).to_lowercase();
    let kept = text.trim().chars().filter(|c| c.is_alphanumeric() || [' ', '-', '_'].contains(c));
    kept.map(|c| if c == ' ' { '-' } else { c }).collect()
}

#[test]
fn links_lead_somewhere() {
    // made when the pages are published
    const MADE: [&str; 2] = ["../playground/", "../index.html"];
    let mut every = pages();
    every.extend(folder::files(&root().join("docs/measured"), "md"));
    every.extend(["ARCHITECTURE.md", "CONTRIBUTING.md"].map(|name| root().join(name)));
    let (mut count, mut wrong) = (0, Vec::new());
    for page in every {
        let text = std::fs::read_to_string(&page).expect("a page");
        let mut fenced = false;
        let prose = text.lines().filter(|line| {
            fenced ^= line.trim_start().starts_with("```");
            !fenced
        });
        for link in prose.flat_map(|line| line.split("](").skip(1)).filter_map(|part| part.split(')').next())
        {
            if link.starts_with("http") || MADE.contains(&link) {
                continue;
            }
            count += 1;
            let (file, place) = link.split_once('#').unwrap_or((link, ""));
            let target =
                if file.is_empty() { page.clone() } else { page.parent().expect("a folder").join(file) };
            let headings = || {
                let text = std::fs::read_to_string(&target).unwrap_or_default();
                text.lines().filter(|line| line.starts_with('#')).any(|line| {
                    let heading = line.trim_start_matches('#');
                    anchor(heading) == place
                })
            };
            if !target.exists() || (!place.is_empty() && !headings()) {
                wrong.push(format!("{}: {link}", page.display()));
            }
        }
    }
    assert!(count > 100, "links are found: {count}");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// What these pages show was measured: each line of a block is in the page of its name below `measured`, in this order.
#[test]
fn figures_are_those_that_were_measured() {
    let read = |path: &str| std::fs::read_to_string(root().join("docs").join(path)).expect("a page");
    let measured = ["accuracy", "simulation", "effects"].map(|name| read(&format!("measured/{name}.md")));
    for page in ["accuracy.md", "effects.md"] {
        let text = read(page);
        for block in text.split("```text\n").skip(1).filter_map(|part| part.split("```").next()) {
            let is_in = |page: &String| {
                let mut lines = page.lines();
                block.lines().all(|line| lines.any(|there| there == line))
            };
            assert!(measured.iter().any(is_in), "{page}:\n{block}");
        }
    }
}
