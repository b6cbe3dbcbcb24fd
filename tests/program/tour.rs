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

/// A line of an excerpt that is not printed after the line before it.
fn not_printed<'a>(excerpt: &'a str, printed: &str) -> Option<&'a str> {
    let mut lines = printed.lines().map(str::trim);
    excerpt
        .lines()
        .map(str::trim)
        .filter(|line| !line.is_empty())
        .find(|line| !lines.any(|there| there == *line))
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
            wrong.extend(not_printed(text, &printed).map(|line| format!("section {number}: {line}")));
        }
    }
    assert_eq!(files, 13, "the sections are found");
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

#[test]
fn steps_that_pages_show_are_those_of_the_worked_solution() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let printed = assur_in(root, &["report", "examples/kinetostatics/six-bar.mech"]).stdout;
    let mut count = 0;
    for page in ["docs/tour.md", "docs/reading.md"] {
        let text = std::fs::read_to_string(root.join(page)).expect("a page");
        let blocks = text.split("```text\n").skip(1).filter_map(|part| part.split("```").next());
        for block in blocks.filter(|block| block.contains("v_C =") || block.contains("v_F =")) {
            count += 1;
            assert_eq!(not_printed(block, &printed), None, "{page}");
        }
    }
    assert_eq!(count, 2);
}

/// The commands of a page, without those that need files of the reader, a browser, another build, or much time.
fn commands(page: &str) -> Vec<Vec<String>> {
    let blocks = page.split("```sh\n").skip(1).filter_map(|part| part.split("```").next());
    let lines = blocks.flat_map(str::lines).filter_map(|line| line.strip_prefix("assur "));
    let is_own = |line: &&str| {
        ["homework", "accuracy ", " answers.csv", ".gif"].iter().all(|word| !line.contains(word))
    };
    // parts in quotes are one word
    let words = |line: &str| {
        let parts = line.split(['"', '\'']).enumerate();
        parts
            .flat_map(|(i, part)| {
                let whole = i % 2 == 1;
                let words: Vec<&str> = if whole { vec![part] } else { part.split_whitespace().collect() };
                words.into_iter().map(str::to_owned).collect::<Vec<_>>()
            })
            .collect()
    };
    lines.filter(is_own).map(words).collect()
}

#[cfg(unix)]
#[test]
fn commands_of_pages_run() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let folder = crate::run::Folder::new("pages");
    std::os::unix::fs::symlink(root.join("examples"), folder.path("examples")).expect("a link");
    let mut count = 0;
    for page in ["tour", "pictures", "report", "teaching", "courses", "simulation", "commands"] {
        let text = std::fs::read_to_string(root.join(format!("docs/{page}.md"))).expect("a page");
        for command in commands(&text) {
            let out = crate::run::assur(&folder, &command.iter().map(String::as_str).collect::<Vec<_>>());
            // the file with mistakes, and answers of which some are wrong
            let wanted =
                i32::from(command.contains(&"examples/tour/2.txt".to_owned()) || command[0] == "grade");
            assert_eq!(out.status, wanted, "{page}: {command:?}: {}", out.stderr);
            count += 1;
        }
    }
    assert!(count > 25, "commands are found: {count}");
}
