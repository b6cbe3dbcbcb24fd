//! `assur draw` as run from a shell.

use crate::cli::GOOD;
use crate::run::{Folder, assur, assur_in};
use std::path::Path;

/// [`GOOD`] at one position.
fn one() -> String {
    GOOD.replace("0 deg, 90 deg", "0 deg")
}

#[test]
fn one_picture_goes_to_standard_output_or_to_a_file() {
    let folder = Folder::new("draw-one").with("a.mech", &one());
    let out = assur(&folder, &["draw", "a.mech"]);
    assert_eq!((out.status, out.stderr.as_str()), (0, ""));
    assert!(out.stdout.starts_with("<svg ") && out.stdout.ends_with("</svg>\n"), "{}", out.stdout);
    let written = assur(&folder, &["draw", "a.mech", "-o", "a.svg"]);
    assert_eq!((written.status, written.stdout.as_str(), written.stderr.as_str()), (0, "", ""));
    assert_eq!(folder.read("a.svg"), out.stdout);
    let dark = assur(&folder, &["draw", "a.mech", "--theme", "dark"]);
    assert!(!dark.stdout.contains("@media") && dark.stdout.contains("#16181c"));
}

#[test]
fn several_pictures_go_to_a_folder() {
    let folder = Folder::new("draw-several").with("a.mech", &one());
    let out = assur(&folder, &["draw", "a.mech", "scheme", "velocities"]);
    assert_eq!((out.status, out.stdout.as_str()), (2, ""));
    assert!(out.stderr.contains("one picture only") && out.stderr.contains("-o pictures/"), "{}", out.stderr);
    let out = assur(&folder, &["draw", "a.mech", "scheme", "velocities", "-o", "out"]);
    assert_eq!((out.status, out.stdout.as_str(), out.stderr.as_str()), (0, "", ""));
    let names = Path::new(&folder.path("out")).read_dir().expect("the folder");
    let mut names: Vec<String> =
        names.flatten().map(|f| f.file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    assert_eq!(names, ["a-scheme.svg", "a-velocities.svg"]);
    let all = assur(&folder, &["draw", "a.mech", "--all", "-o", "all"]);
    assert_eq!((all.status, all.stderr.as_str()), (0, ""));
}

#[test]
fn every_pose_of_a_list_is_drawn_into_a_folder() {
    let folder = Folder::new("draw-list").with("a.mech", GOOD);
    let out = assur(&folder, &["draw", "a.mech", "scheme", "velocities", "-o", "."]);
    assert_eq!((out.status, out.stdout.as_str(), out.stderr.as_str()), (0, "", ""));
    assert_eq!(
        folder.names(),
        ["a-scheme-1.svg", "a-scheme-2.svg", "a-velocities-1.svg", "a-velocities-2.svg", "a.mech"]
    );
    let out = assur(&folder, &["draw", "a.mech"]);
    assert_eq!((out.status, out.stdout), (0, folder.read("a-scheme-1.svg")));
    assert!(out.stderr.contains("pose 1 is drawn, the first of 2"), "{}", out.stderr);
    let out = assur(&folder, &["draw", "a.mech", "--pose", "2", "--pose", "2"]);
    assert_eq!((out.status, out.stdout, out.stderr), (0, folder.read("a-scheme-2.svg"), String::new()));
    let out = assur(&folder, &["draw", "a.mech", "--pose", "1", "--pose", "2"]);
    assert_eq!((out.status, out.stdout.as_str()), (2, ""));
}

#[test]
fn of_a_sweep_the_first_pose_is_drawn() {
    let sweep = GOOD.replace("0 deg, 90 deg", "0 deg .. 360 deg in 12 steps");
    let folder = Folder::new("draw-sweep").with("a.mech", &sweep);
    let out = assur(&folder, &["draw", "a.mech", "-o", "out"]);
    assert_eq!((out.status, out.stdout.as_str(), out.stderr.as_str()), (0, "", ""));
    let names = Path::new(&folder.path("out")).read_dir().expect("the folder").flatten();
    assert_eq!(names.map(|f| f.file_name()).collect::<Vec<_>>(), ["a-scheme.svg"]);
}

#[test]
fn all_pictures_of_several_files_are_on_one_page() {
    let folder = Folder::new("draw-page").with("a/x.mech", GOOD).with("b/x.mech", GOOD);
    let out = assur(&folder, &["draw", "a", "b", "--all", "-o", "all.html"]);
    assert_eq!((out.status, out.stdout.as_str(), out.stderr.as_str()), (0, "", ""));
    let page = folder.read("all.html");
    assert!(page.starts_with("<!doctype html>") && page.ends_with("</html>\n"));
    let ids: Vec<&str> = page.split(" id=\"").skip(1).filter_map(|part| part.split('"').next()).collect();
    assert!(ids.len() >= 12, "{ids:?}");
    assert!((1..ids.len()).all(|i| !ids[..i].contains(&ids[i])), "{ids:?}");
    assert!(!page.contains("<script") && !page.replace("http://www.w3.org/2000/svg", "").contains("http"));
}

#[test]
fn what_cannot_be_drawn_is_said() {
    let still = GOOD.replace(" at 100 rad/s", "").replace(", v_C = velocity(C)", "");
    let folder = Folder::new("draw-not").with("a.mech", &still).with("wrong.mech", "link a A-B\n");
    let out = assur(&folder, &["draw", "a.mech", "--pose", "99"]);
    assert_eq!((out.status, out.stdout.as_str()), (1, ""));
    assert!(out.stderr.contains("mech::picture::no_position"), "{}", out.stderr);
    let out = assur(&folder, &["draw", "wrong.mech"]);
    assert_eq!((out.status, out.stdout.as_str()), (1, ""));
    let out = assur(&folder, &["draw", "missing.mech"]);
    assert_eq!((out.status, out.stdout.as_str()), (2, ""));
    let out = assur(&folder, &["draw", "a.mech", "-o", "a.mech/x.svg"]);
    assert_eq!((out.status, out.stdout.as_str()), (2, ""));
    let out = assur(&folder, &["draw", "a.mech", "--size", "1x1"]);
    assert_eq!((out.status, out.stdout.as_str()), (2, ""));
}

/// `docs/pictures.sh` writes what is there.
#[test]
fn the_pictures_of_the_documents_are_of_now() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let script = std::fs::read_to_string(root.join("docs/pictures.sh")).expect("the script");
    let lines = script.lines().filter_map(|line| line.strip_prefix("draw ")?.split_once(" -o "));
    let mut count = 0;
    for (args, file) in lines {
        let args: Vec<&str> = ["draw"].into_iter().chain(args.split(' ')).collect();
        let out = assur_in(root, &args);
        let there = std::fs::read_to_string(root.join(file)).expect("a picture");
        assert!(out.stdout == there, "{file} is not what is drawn: run docs/pictures.sh");
        count += 1;
    }
    assert_eq!(count, 2);
}
