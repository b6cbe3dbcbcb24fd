//! Names of rows of variants come out in every form, and are never run by a spreadsheet.

use crate::run::{Folder, assur, column};

const NAMES: [&str; 5] = ["first", "=1+1", "+a", "-b(1)", "@SUM(1)"];

fn folder() -> Folder {
    let rows: String =
        NAMES.iter().enumerate().map(|(i, name)| format!("  {}, \"{name}\"\n", i + 1)).collect();
    let text =
        format!("given r = 1 mm\nlet y = 2*r\nfind y as mm\nvariants {{\n  r [mm], variant\n{rows}}}\n");
    Folder::new("row_names").with("a.mech", &text)
}

#[test]
fn csv_has_the_names_of_rows() {
    let folder = folder();
    let (solve, batch) = (["solve", "a.mech", "--format", "csv"], ["batch", "a.mech", "--format", "csv"]);
    for args in [&solve, &batch] {
        let said = assur(&folder, args);
        let names = column(&said.stdout, "variant");
        assert_eq!(names, ["first", "'=1+1", "'+a", "'-b(1)", "'@SUM(1)"], "{args:?}: {}", said.stdout);
        assert_eq!(column(&said.stdout, "r [mm]"), ["1", "2", "3", "4", "5"], "{args:?}: {}", said.stdout);
        assert_eq!(column(&said.stdout, "y [mm]"), ["2", "4", "6", "8", "10"], "{args:?}: {}", said.stdout);
    }
}

#[test]
fn json_and_pages_have_the_names_of_rows() {
    let folder = folder();
    for (command, format) in [("solve", "json"), ("solve", "jsonl"), ("batch", "jsonl")] {
        let said = assur(&folder, &[command, "a.mech", "--format", format]).stdout;
        for (line, name) in said.lines().zip(NAMES) {
            assert!(line.contains(&format!("\"name\":\"{name}\"")), "{command} {format}: {line}");
            assert!(!line.contains("\"values\":{\"variant\""), "{command} {format}: {line}");
        }
        assert_eq!(said.lines().count(), NAMES.len(), "{command} {format}");
    }
    for (command, format) in
        [("solve", "table"), ("solve", "markdown"), ("solve", "latex"), ("batch", "table")]
    {
        let said = assur(&folder, &[command, "a.mech", "--format", format]).stdout;
        for name in NAMES {
            let plain = said.replace('\\', "");
            assert!(plain.contains(name), "{command} {format}: no {name} in {said}");
        }
    }
}
