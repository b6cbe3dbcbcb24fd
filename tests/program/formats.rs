//! `--format` has one set of forms in every command, and each of them is what it says.

#![allow(clippy::unwrap_used)] // a test that cannot read its files has failed

use crate::run::{Folder, Said, assur};
use crate::schema::fits_schema;
use serde_json::Value;

const FORMS: [&str; 7] = ["table", "json", "jsonl", "csv", "markdown", "latex", "typst"];

/// Each command with its arguments.
const COMMANDS: &[&[&str]] = &[
    &["check", "a.mech"],
    &["check", "a.mech", "--modes", "--plan"],
    &["solve", "a.mech"],
    &["test", "a.mech"],
    &["test", "a.mech", "b.mech"],
    &["batch", "a.mech", "--variants", "t.csv"],
    &["grade", "k.csv", "k.csv"],
    &["accuracy", "a.mech"],
    &["profile", "c.mech", "--steps", "12"],
];

fn folder(name: &str) -> Folder {
    let crank = "mechanism \"Crank\"\nground { A (0, 0) }\ngiven r = 100 mm\nlink crank A-B r\nrevolute A: ground - crank\n\
                 drive crank = 30 deg at 10 rad/s\nfind y = position(B).y, omega(crank)\nexpect y = r/2 within 1e-9\n";
    let cam =
        std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/src/cli/start/cam.mech")).unwrap();
    Folder::new(name)
        .with("a.mech", crank)
        .with("b.mech", crank)
        .with("t.csv", "variant,r [mm]\none,100\ntwo,200\n")
        .with("k.csv", "variant,y [mm]\none,50\ntwo,100\n")
        .with("c.mech", &cam)
}

fn printed(folder: &Folder, command: &[&str], form: &str) -> String {
    let said: Said = assur(folder, &[command, &["--format", form]].concat());
    assert_eq!(said.status, 0, "{command:?} {form}: {}", said.stderr);
    assert!(!said.stdout.is_empty(), "{command:?} {form}");
    said.stdout
}

#[test]
fn every_command_has_every_form() {
    let folder = folder("formats");
    for command in COMMANDS {
        for form in FORMS {
            let text = printed(&folder, command, form);
            match form {
                "json" | "jsonl" => text.lines().for_each(|line| fits(command, line)),
                "csv" => assert!(text.ends_with("\r\n") && text.lines().count() > 1, "{command:?}: {text}"),
                "markdown" => {
                    assert!(text.starts_with("# ") && text.contains("\n| "), "{command:?}: {text}");
                }
                "latex" => {
                    let ends = text.starts_with("\\section*{") && text.contains("\\end{tabular}");
                    assert!(ends && text.is_ascii(), "{command:?}: {text}");
                }
                "typst" => {
                    let ends = text.starts_with("= ") && text.contains("\n#table(\n  columns: ");
                    assert!(
                        ends && text.matches("#table(").count() == text.matches("\n)\n").count(),
                        "{text}"
                    );
                }
                _ => assert!(!text.contains("\\section") && !text.contains("| "), "{command:?}: {text}"),
            }
        }
    }
}

/// An object of one of the schemas.
fn fits(command: &[&str], line: &str) {
    let value: Value = serde_json::from_str(line).unwrap_or_else(|e| panic!("{command:?}: {e} in {line}"));
    let name = value["schema"].as_str().unwrap_or_default().replace("assur.", "").replace('/', "-");
    fits_schema(&format!("{name}.json"), &value);
    for section in value["sections"].as_array().into_iter().flatten() {
        for block in section["blocks"].as_array().into_iter().flatten() {
            assert_eq!(block.as_object().map(serde_json::Map::len), Some(1), "{command:?}: {block}");
        }
    }
}

#[test]
fn a_table_has_its_cells_in_every_form() {
    let folder = folder("format_cells");
    let wanted = [
        (&["check", "a.mech"][..], "F = 3·1 − 2·1 = 1"),
        (&["test", "a.mech", "b.mech"], "b.mech"),
        (&["batch", "a.mech", "--variants", "t.csv"], "two"),
        (&["profile", "c.mech", "--steps", "12"], "30"),
    ];
    for (command, cell) in wanted {
        for form in FORMS {
            let text = printed(&folder, command, form);
            let plain =
                text.replace("$\\cdot$", "·").replace("$-$", "−").replace("\\_", "_").replace("\\=", "=");
            assert!(plain.contains(cell), "{command:?} {form}: no {cell} in {text}");
        }
    }
}

#[test]
fn expectations_are_counted_in_every_form() {
    let wrong = "given r = 1 mm\nlet y = 2*r\nfind y\nexpect y = 3 mm within 1 %\n";
    let folder = folder("format_test").with("w.mech", wrong);
    let said = assur(&folder, &["test", "a.mech", "w.mech", "--format", "csv"]);
    assert_eq!(said.status, 1);
    let lines: Vec<&str> = said.stdout.lines().collect();
    assert_eq!(
        lines,
        [
            "section,file,rows,met,failed,not solved,errors",
            "Expectations,a.mech,0,1,0,0,0",
            "Expectations,w.mech,0,0,1,0,0"
        ]
    );
}

#[test]
fn a_form_that_is_not_there_is_listed_with_those_that_are() {
    let folder = folder("format_none");
    for command in COMMANDS {
        let said = assur(&folder, &[*command, &["--format", "xml"]].concat());
        assert_eq!(said.status, 2, "{command:?}");
        for form in FORMS {
            assert!(said.stderr.contains(form), "{command:?}: no {form} in {}", said.stderr);
        }
    }
    let said = assur(&folder, &["solve", "a.mech", "--format", "dxf"]);
    assert!(said.status == 2 && !said.stderr.contains("dxf,"), "{}", said.stderr);
    assert!(printed(&folder, COMMANDS[8], "dxf").contains("PROFILE"));
}

#[test]
fn the_ending_of_a_file_chooses_its_form() {
    let folder = folder("format_ending");
    for (name, begins) in
        [("o.md", "# "), ("o.tex", "\\section*"), ("o.csv", "row"), ("o.json", "{"), ("o.txt", "a.mech")]
    {
        let said = assur(&folder, &["batch", "a.mech", "--variants", "t.csv", "--out", name]);
        assert_eq!(said.status, 0, "{}", said.stderr);
        assert!(folder.read(name).starts_with(begins), "{name}: {}", folder.read(name));
    }
}

/// Rounding is 0 in the tables of `batch` as in those of `solve`; lines of values keep all digits.
#[test]
fn tables_of_rows_have_no_rounding() {
    let text = "given r = 100 mm\nground { A (0, 0); line guide through A along 0 deg }\nlink crank A-B r\n\
                link rod B-C 350 mm\nlink piston { C (0, 0); mass 2 kg at C }\nrevolute A: ground - crank\n\
                revolute B: crank - rod\nrevolute C: rod - piston\nprismatic D: piston.C - ground.guide\n\
                drive crank = 30 deg, 70 deg at 1500 rpm\nassemble C ahead of B\nbalance torque M on crank\n\
                find v = velocity(C), M, k = reaction(D, piston)\nvariants {\n r [mm]\n 100\n 90\n}\n";
    let folder = Folder::new("rounding").with("a.mech", text);
    for format in ["table", "markdown", "latex", "typst"] {
        let out = assur(&folder, &["batch", "a.mech", "--format", format]).stdout;
        assert!(!out.contains("e-") && out.contains("-9.81748"), "{format}: {out}");
    }
    assert!(assur(&folder, &["batch", "a.mech", "--format", "csv"]).stdout.contains("e-"));
}

/// What lines of values leave out is said.
#[test]
fn a_table_that_is_not_in_the_lines_is_named() {
    let gears = "given z = 17\nshaft I { wheel z1 teeth z module 2 mm; }\nshaft II { wheel z2 teeth 40 }\nmesh z12: z1 - z2\n\
                 find table(z12), r = radius(z1)\n";
    let rows = format!("{gears}variants {{\n z\n 18\n 19\n}}\n");
    let folder = Folder::new("left-out").with("a.mech", gears).with("b.mech", &rows);
    let words = "`table(z12)` is a table of its own and not in these lines";
    for (args, said) in [
        (&["solve", "--format", "csv"][..], true),
        (&["solve", "--format", "csv", "--within", "1e-9"], true),
        (&["solve", "--format", "jsonl"], true),
        (&["solve", "--format", "json"], false),
        (&["solve"], false),
        (&["batch"], true),
        (&["batch", "--format", "csv"], true),
        (&["batch", "--format", "json"], false),
    ] {
        for file in ["a.mech", "b.mech"] {
            let out = assur(&folder, &[args, &[file]].concat());
            assert_eq!(
                out.stderr.matches(words).count(),
                usize::from(said),
                "{args:?} {file}: {}",
                out.stderr
            );
            assert_eq!(out.status, 0, "{args:?} {file}: {}", out.stderr);
        }
    }
}
