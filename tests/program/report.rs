//! `assur report` as run from a shell.

use crate::cli::GOOD;
use crate::run::{Folder, assur};

#[test]
fn a_solution_goes_to_standard_output_or_to_a_file() {
    let folder = Folder::new("report-one").with("a.mech", GOOD);
    let out = assur(&folder, &["report", "a.mech"]);
    assert_eq!((out.status, out.stderr.as_str()), (0, ""));
    assert!(out.stdout.contains("1 Structure\n") && out.stdout.contains(" Results\n"), "{}", out.stdout);
    let written = assur(&folder, &["report", "a.mech", "-o", "a.txt"]);
    assert_eq!((written.status, written.stdout.as_str(), written.stderr.as_str()), (0, "", ""));
    assert_eq!(folder.read("a.txt"), out.stdout);
    let page = assur(&folder, &["report", "a.mech", "-o", "a.html"]);
    assert_eq!((page.status, page.stderr.as_str()), (0, ""));
    let page = folder.read("a.html");
    assert!(page.starts_with("<!doctype html>\n<html lang=\"en\">") && page.contains("<math"), "{page}");
    let same = assur(&folder, &["report", "a.mech", "--format", "html"]);
    assert_eq!(same.stdout, page);
}

#[test]
fn pictures_of_markdown_and_typst_are_next_to_it() {
    let folder = Folder::new("report-md").with("a.mech", GOOD);
    let out = assur(&folder, &["report", "a.mech", "-o", "b.md"]);
    assert_eq!((out.status, out.stdout.as_str(), out.stderr.as_str()), (0, "", ""));
    let text = folder.read("b.md");
    assert!(text.contains("![Kinematic scheme") && text.contains("](b-1.svg)"), "{text}");
    assert!(folder.read("b-1.svg").starts_with("<svg "));
    let out = assur(&folder, &["report", "a.mech", "-o", "c.typ"]);
    assert_eq!((out.status, out.stderr.as_str()), (0, ""));
    assert!(folder.read("c.typ").contains("image(\"c-1.svg\")"));
    // on standard output there is no place for them
    let out = assur(&folder, &["report", "a.mech", "--format", "markdown"]);
    assert!(out.status == 0 && !out.stdout.contains(".svg") && out.stdout.contains("$$\n"), "{}", out.stdout);
}

#[test]
fn parts_poses_and_languages_are_chosen() {
    let folder = Folder::new("report-parts").with("a.mech", GOOD);
    let out = assur(&folder, &["report", "a.mech", "--steps", "1,8"]);
    assert!(out.stdout.contains("1 Structure\n") && out.stdout.contains("2 Results\n"), "{}", out.stdout);
    assert!(!out.stdout.contains("Positions"), "{}", out.stdout);
    let second = assur(&folder, &["report", "a.mech", "--pose", "2"]);
    assert!(second.stdout.contains("φ = 90°"), "{}", second.stdout);
    let russian = assur(&folder, &["report", "a.mech", "--lang", "ru"]);
    assert!(russian.stdout.contains("Положения"), "{}", russian.stdout);
}

#[test]
fn wrong_use_is_explained() {
    let folder = Folder::new("report-wrong").with("a.mech", GOOD).with("b.mech", GOOD);
    let out = assur(&folder, &["report", "a.mech", "b.mech", "-o", "x.html"]);
    assert_eq!((out.status, out.stdout.as_str()), (2, ""));
    assert!(out.stderr.contains("one worked solution only"), "{}", out.stderr);
    let out = assur(&folder, &["report", "a.mech", "-o", "x.doc"]);
    assert!(out.status == 2 && out.stderr.contains("`.html`, `.md`, `.typ` or `.txt`"), "{}", out.stderr);
    let out = assur(&folder, &["report", "a.mech", "--steps", "9"]);
    assert!(out.status == 2 && out.stderr.contains("numbers from 0 to 8"), "{}", out.stderr);
    let out = assur(&folder, &["report", "a.mech", "--pose", "7"]);
    assert!(out.status == 1 && out.stderr.contains("mech::picture::no_position"), "{}", out.stderr);
    let out = assur(&folder, &["report", "a.mech", "-o", "a.mech", "--format", "text"]);
    assert!(out.status == 2 && out.stderr.contains("both an input and the output"), "{}", out.stderr);
}

#[test]
fn sheets_have_a_table_of_variants_and_keys_their_answers() {
    let text = "given r = 100 mm
given v_key = 1 m/s
ground { A (0, 0); line guide through A along 0 deg }
link crank A-B r
link rod B-C 350 mm
link piston { C (0, 0) }
revolute A: ground - crank
revolute B: crank - rod
revolute C: rod - piston
prismatic D: piston.C - ground.guide
drive crank = 90 deg at 10 rad/s
assemble C ahead of B
find v = velocity(C).x as m/s
expect v = v_key
variants {
  r [mm], v_key [m/s]
  100, -1
  120, -1.2
}
";
    let folder = Folder::new("report-sheet").with("a.mech", text);
    let sheet = assur(&folder, &["report", "a.mech", "--sheet"]);
    assert_eq!((sheet.status, sheet.stderr.as_str()), (0, ""));
    assert!(sheet.stdout.contains("r, mm") && !sheet.stdout.contains("v_key"), "{}", sheet.stdout);
    assert!(sheet.stdout.contains("v – velocity of C, x component, m/s"), "{}", sheet.stdout);
    let key = assur(&folder, &["report", "a.mech", "--key"]);
    assert!(key.stdout.contains("−1.000") && key.stdout.contains("−1.200"), "{}", key.stdout);
    let each = assur(&folder, &["report", "a.mech", "--sheet", "--per-row", "-o", "s.html"]);
    assert_eq!((each.status, each.stdout.as_str(), each.stderr.as_str()), (0, "", ""));
    assert_eq!(folder.names(), ["a.mech", "s-1.html", "s-2.html"]);
    let without = assur(&folder, &["report", "a.mech", "--per-row"]);
    assert_eq!(without.status, 2);
}

/// Friction of a contact of a line of a free link; a speed of which the square is near the greatest number.
#[test]
fn hard_files_have_a_page() {
    let rubbing = "ground { E (0, 0) }\n\
                   link rod { A (0.1 m, 0); line axis through A along 0 deg; mass 1 kg at A; inertia 1 kg*m^2 }\n\
                   contact K: rod.axis - ground.E { friction 0.4 }\nstart rod = 180 deg\nstart rod.A = (-0.1 m, 0)\n\
                   simulate 0.1 s\nfind angle(rod) as deg\n";
    let fast = "ground { A (0, 0); line guide through A along 0 deg }\nlink crank A-B 100 mm\nlink rod B-C 350 mm\n\
                link piston { C (0, 0) }\nrevolute A: ground - crank\nrevolute B: crank - rod\n\
                revolute C: rod - piston\nprismatic D: piston.C - ground.guide { friction 0.2 }\n\
                drive crank = 30 deg at 1e99 rad/s\nassemble C ahead of B\nforce on piston at C = (-100 N, -40 N)\n\
                balance torque Mb on crank\nfind Mb, T = friction(D, piston)\n";
    let folder = Folder::new("report-hard").with("a.mech", rubbing).with("b.mech", fast);
    for file in ["a.mech", "b.mech"] {
        for out in [&["--format", "text"][..], &["--format", "html"]] {
            let said = assur(&folder, &[&["report", file], out].concat());
            assert_eq!(said.status, 0, "{file}: {}", said.stderr);
            assert!(!said.stdout.contains("inf ") && !said.stdout.contains("NaN"), "{file}: {}", said.stdout);
        }
    }
    let page = assur(&folder, &["report", "b.mech"]).stdout;
    assert!(page.contains("−8.6603·10¹⁹⁶ m/s²"), "{page}");
}

/// A guide bears a couple, and the table of results has it as `solve` does.
#[test]
fn results_have_the_couple_of_a_guide() {
    let text = "link 1 crank { A (0, 0) }\nlink 2 slider { A (0, 0) }\n\
                link 3 bar { C (0, 0); D (0, 30 mm); line slot through D along 0 deg }\nlink 4 arm { C (0, 0) }\n\
                revolute A: crank - slider\nrevolute C: arm - bar\nprismatic s: slider.A - bar.slot\n\
                drive crank.A = 280 mm @ 60 deg + 30 mm @ 150 deg\ndrive arm.C = (0, 0)\nassemble s > 0\n\
                torque on slider = 1.5 N*m cw\ntorque on bar = 25 N*m cw\nfind reactions\n";
    let folder = Folder::new("report-couple").with("a.mech", text);
    let page = assur(&folder, &["report", "a.mech", "--format", "markdown"]).stdout;
    let row = page.lines().find(|line| line.contains("couple in s on link 3")).unwrap_or(&page);
    assert!(row.contains("| −1.5 | N·m |"), "{row}");
}
