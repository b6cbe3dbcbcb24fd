//! `docs/tour.md`: its files are those of `examples/tour`, and what it shows is what the program prints of them. The pages of
//! commands list all commands.

use crate::run::assur_in;
use std::path::Path;

/// The sections with a number, with their blocks: the language of each, and its text.
fn sections(page: &str) -> Vec<(String, Vec<(&str, &str)>)> {
    page.split("\n## ")
        .filter_map(|section| {
            let (number, _) = section.split_once(". ").filter(|(n, _)| n.parse::<u32>().is_ok())?;
            let fenced = section.split("\n```").skip(1).step_by(2);
            Some((number.to_owned(), fenced.filter_map(|block| block.split_once('\n')).collect()))
        })
        .collect()
}

#[test]
fn the_tour_shows_its_files_and_what_the_program_prints() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let page = std::fs::read_to_string(root.join("docs/tour.md")).expect("the tour");
    let (mut files, mut wrong) = (0, Vec::new());
    for (number, blocks) in sections(&page) {
        // the file with mistakes has another ending, so that folders of examples are free of them
        let found = ["mech", "txt"].map(|ending| format!("examples/tour/{number}.{ending}"));
        let Some(file) = found.iter().find(|file| root.join(file).exists()) else { continue };
        files += 1;
        let written = std::fs::read_to_string(root.join(file)).expect("a file");
        let shown = blocks.first().map_or("", |block| block.1);
        assert_eq!(format!("{shown}\n"), written, "{file} is not the one of section {number}");
        let (mut printed, command) = (String::new(), if file.ends_with("txt") { "check" } else { "solve" });
        // a four-bar without its choice is what the message is about
        let unchosen = written.replace("assemble C left of B-D\n", "");
        let copy = crate::run::Folder::new(&format!("tour-{number}")).with("file.mech", &unchosen);
        for out in [assur_in(root, &[command, file]), crate::run::assur(&copy, &["solve", "file.mech"])] {
            printed += &out.stderr;
            printed += &out.stdout;
        }
        for (_, text) in blocks.iter().skip(1).filter(|block| block.0 == "text") {
            // each block by itself, in its order
            let mut lines = printed.lines();
            for line in text.lines().map(str::trim_end).filter(|line| !line.is_empty()) {
                if !lines.any(|there| there.trim_end() == line) {
                    wrong.push(format!("section {number}: `{line}` is not printed after the line before it"));
                    break;
                }
            }
        }
    }
    assert_eq!(files, 10, "the sections are found");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn pages_list_every_command() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let help = assur_in(root, &["help"]).stdout;
    let (_, list) = help.split_once("Commands:\n").expect("a list");
    let commands: Vec<&str> = list
        .lines()
        .take_while(|line| !line.is_empty())
        .filter(|line| line.starts_with("  ") && !line.starts_with("   "))
        .filter_map(|line| line.split_whitespace().next())
        .collect();
    assert!(commands.len() > 12, "{commands:?}");
    for (page, heading) in [("README.md", "## Commands"), ("docs/commands.md", "## List of commands")] {
        let text = std::fs::read_to_string(root.join(page)).expect("a page");
        let (_, below) = text.split_once(heading).expect("a heading");
        let rows: Vec<&str> = below.lines().skip(2).take_while(|line| line.starts_with('|')).collect();
        let words: Vec<&str> = rows.iter().flat_map(|row| row.split(['`', ' '])).collect();
        let missing: Vec<_> = commands.iter().filter(|command| !words.contains(command)).collect();
        assert!(missing.is_empty(), "{page} does not list {missing:?}");
    }
}
