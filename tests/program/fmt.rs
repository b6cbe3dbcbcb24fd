//! `assur fmt`: which files it changes, and which it leaves alone.

use crate::run::{Folder, assur, with_input};

const WRITTEN: &str = "mech  1\ngiven r=100mm\ngiven long = 2 m;\n";
const FORMATTED: &str = "mech 1\ngiven r    = 100 mm\ngiven long = 2 m\n";
const UNREADABLE: &str = "mech  1\nlink link link\n";

fn folder(name: &str) -> Folder {
    Folder::new(name)
        .with("a.mech", WRITTEN)
        .with("b.mech", FORMATTED)
        .with("in/c.mech", WRITTEN)
        .with("d.txt", WRITTEN)
}

#[test]
fn files_are_put_in_the_one_style() {
    let folder = folder("fmt");
    let out = assur(&folder, &["fmt", "."]);
    let said = "3 files: 2 formatted, 1 unchanged\n";
    assert_eq!((out.status, out.stdout.as_str(), out.stderr.as_str()), (0, "", said));
    for name in ["a.mech", "b.mech", "in/c.mech"] {
        assert_eq!(folder.read(name), FORMATTED, "{name}");
    }
    assert_eq!(folder.read("d.txt"), WRITTEN);
    assert_eq!(folder.names(), ["a.mech", "b.mech", "d.txt", "in"], "no temporary file is left");
    assert_eq!(assur(&folder, &["fmt", "*.mech", "d.txt"]).stderr, "3 files: 1 formatted, 2 unchanged\n");
}

#[test]
fn check_prints_a_diff_and_changes_nothing() {
    let folder = folder("fmt-check");
    let out = assur(&folder, &["fmt", "--check", "a.mech", "b.mech"]);
    assert_eq!(out.status, 1);
    let diff = "--- a/a.mech\n+++ b/a.mech\n@@ -1,3 +1,3 @@\n-mech  1\n-given r=100mm\n-given long = 2 m;\n";
    let added = FORMATTED.lines().map(|line| format!("+{line}\n")).collect::<String>();
    assert_eq!(out.stdout, format!("{diff}{added}"));
    assert_eq!(out.stderr, "a.mech is not formatted\n2 files: 1 not formatted, 1 already formatted\n");
    assert_eq!(folder.read("a.mech"), WRITTEN);
    let out = assur(&folder, &["fmt", "--check", "b.mech"]);
    assert_eq!(
        (out.status, out.stdout.as_str(), out.stderr.as_str()),
        (0, "", "1 file: 1 already formatted\n")
    );
}

#[test]
fn a_file_that_does_not_read_is_left_alone() {
    let folder = folder("fmt-wrong").with("wrong.mech", UNREADABLE);
    let out = assur(&folder, &["fmt", "a.mech", "wrong.mech"]);
    assert_eq!((out.status, out.stdout.as_str()), (1, ""));
    assert!(out.stderr.contains("wrong.mech:2:"), "{}", out.stderr);
    assert!(out.stderr.ends_with("2 files: 1 formatted, 1 with errors, not changed\n"), "{}", out.stderr);
    assert_eq!(folder.read("wrong.mech"), UNREADABLE);
    // errors of meaning do not matter
    let out = with_input(&folder, &["fmt", "-"], "link  crank A-B rr\n");
    assert_eq!((out.status, out.stdout.as_str(), out.stderr.as_str()), (0, "link crank A-B rr\n", ""));
}

#[test]
fn standard_input_goes_to_standard_output() {
    let folder = folder("fmt-stdin");
    for (text, status) in [(WRITTEN, 0), (FORMATTED, 0)] {
        let out = with_input(&folder, &["fmt", "-"], text);
        assert_eq!((out.status, out.stdout.as_str(), out.stderr.as_str()), (status, FORMATTED, ""));
    }
    let name = ["fmt", "-", "--stdin-filename", "mine.mech"];
    let out = with_input(&folder, &name, UNREADABLE);
    assert_eq!((out.status, out.stdout.as_str()), (1, ""));
    assert!(out.stderr.contains("mine.mech:2:"), "{}", out.stderr);
    let out = with_input(&folder, &[&name[..], &["--check"]].concat(), WRITTEN);
    assert!(out.status == 1 && out.stdout.contains("+++ b/mine.mech"), "{}", out.stdout);
}

#[test]
fn a_range_of_lines_is_of_one_file() {
    let folder =
        Folder::new("fmt-range").with("a.mech", "mech  1\nfind  a\nfind  b\n").with("b.mech", FORMATTED);
    assert_eq!(assur(&folder, &["fmt", "--range", "2:2", "a.mech"]).status, 0);
    assert_eq!(folder.read("a.mech"), "mech  1\nfind a\nfind  b\n");
    for range in ["2", "3:2", "0:1", "a:b"] {
        let out = assur(&folder, &["fmt", "--range", range, "a.mech"]);
        assert!(
            out.status == 2 && out.stderr.contains("write two lines, e.g. 10:20"),
            "{range}: {}",
            out.stderr
        );
    }
    let out = assur(&folder, &["fmt", "--range", "1:2", "."]);
    assert!(out.status == 2 && out.stderr.contains("name one file"), "{}", out.stderr);
}

#[cfg(unix)]
#[test]
fn rights_and_links_stay() {
    use std::os::unix::fs::PermissionsExt;
    let folder = folder("fmt-rights");
    let rights =
        |name: &str| std::fs::metadata(folder.path(name)).expect("a file").permissions().mode() & 0o777;
    let set = |name: &str, mode| {
        std::fs::set_permissions(folder.path(name), PermissionsExt::from_mode(mode)).expect("rights");
    };
    set("a.mech", 0o640);
    set("in/c.mech", 0o444);
    std::os::unix::fs::symlink(folder.path("a.mech"), folder.path("link.mech")).expect("a link");
    let out = assur(&folder, &["fmt", "link.mech", "in/c.mech"]);
    assert_eq!(out.status, 2, "{}", out.stderr);
    assert!(out.stderr.contains("`in/c.mech` cannot be written: it is read-only"), "{}", out.stderr);
    assert_eq!((folder.read("a.mech").as_str(), rights("a.mech")), (FORMATTED, 0o640));
    assert_eq!((folder.read("in/c.mech").as_str(), rights("in/c.mech")), (WRITTEN, 0o444));
    assert!(std::fs::symlink_metadata(folder.path("link.mech")).expect("a link").is_symlink());
}

/// A process that may write a kilobyte of a file at most meets the same end as on a disk that is full.
#[cfg(unix)]
#[test]
fn a_full_disk_loses_nothing() {
    let long = "given   r = 100 mm\n".repeat(2000);
    let folder = Folder::new("fmt-full").with("a.mech", &long);
    let script = format!("trap '' XFSZ; ulimit -f 1; exec {} fmt a.mech", env!("CARGO_BIN_EXE_assur"));
    let out = std::process::Command::new("sh")
        .args(["-c", &script])
        .current_dir(folder.path(""))
        .output()
        .expect("a shell");
    let said = String::from_utf8_lossy(&out.stderr);
    assert_eq!(out.status.code(), Some(2), "{said}");
    assert!(said.contains("cannot be written") && said.contains("was not changed"), "{said}");
    assert_eq!(folder.read("a.mech"), long, "the file is as it was");
    assert_eq!(folder.names(), ["a.mech"], "no temporary file is left");
}

/// `+-` is the sign of a tolerance.
#[test]
fn a_sum_and_a_sign_stay_apart() {
    for (written, formatted) in
        [("2 m+ -3 m", "2 m + -3 m"), ("+ -5 m", "+ -5 m"), ("2 m + (+ -3 m)", "2 m + (+ -3 m)")]
    {
        let out = with_input(&Folder::new("fmt-signs"), &["fmt", "-"], &format!("given r = {written}\n"));
        assert_eq!(
            (out.status, out.stdout, out.stderr.as_str()),
            (0, format!("given r = {formatted}\n"), "")
        );
    }
}
