//! `assur profile` as run from a shell.

use crate::cli::GOOD;
use crate::run::{Folder, assur};

pub const CAM: &str = r#"cam plate {
  base_radius 50 mm
  turning ccw
  follower translating roller { radius 10 mm }
  rise 90 deg through 20 mm cycloidal
  fall 90 deg cycloidal
}
"#;

#[test]
fn a_profile_is_printed_in_every_format() {
    let two = format!("{CAM}{}", CAM.replace("plate", "other"));
    let folder = Folder::new("profile").with("a.mech", CAM).with("two.mech", &two).with("none.mech", GOOD);
    let csv = assur(&folder, &["profile", "a.mech", "--steps", "4"]);
    assert_eq!((csv.status, csv.stdout.lines().count()), (0, 5), "{}", csv.stderr);
    assert!(csv.stdout.starts_with("cam angle [deg],s [mm],s' [mm],"), "{}", csv.stdout);
    // at the end of the rise the profile stands 60 mm from the centre, a quarter turn against the cam
    let row = csv.stdout.lines().nth(2).unwrap_or_default();
    let cells: Vec<f64> = row.split(',').map(|c| c.parse().unwrap_or(f64::NAN)).collect();
    assert_eq!(&cells[..2], &[90.0, 20.0], "{row}");
    assert!(cells[7].abs() < 1e-12 && (cells[8] + 60.0).abs() < 1e-12, "{row}");
    let dxf = assur(&folder, &["profile", "a.mech", "--steps", "12", "--format", "dxf"]);
    assert_eq!((dxf.status, dxf.stderr.as_str()), (0, ""));
    let lines: Vec<&str> = dxf.stdout.lines().collect();
    assert_eq!(lines.len() % 2, 0, "codes and values");
    assert_eq!(lines.iter().filter(|l| **l == "VERTEX").count(), 24, "profile and pitch curve");
    assert!(lines.windows(2).any(|l| l[0].trim() == "40" && l[1] == "50.0"), "the base circle");
    assert_eq!(lines[lines.len() - 1], "EOF");
    let vertices = |words: &[&str]| {
        let dxf = assur(&folder, &[&["profile", "a.mech", "--format", "dxf"], words].concat());
        assert_eq!((dxf.status, dxf.stderr.as_str()), (0, ""), "{words:?}");
        dxf.stdout.lines().filter(|line| *line == "VERTEX").count()
    };
    let (usual, fine) = (vertices(&[]), vertices(&["--within", "0.1 um"]));
    assert_eq!((usual, vertices(&["--within", "10µm"])), (vertices(&["--within", "0.01mm"]), usual));
    assert!((9.0..11.0).contains(&(fine as f64 / usual as f64)), "{fine} of {usual}");
    let csv = assur(&folder, &["profile", "a.mech", "--within", "1 mm"]);
    assert!((30..200).contains(&csv.stdout.lines().count()), "{}", csv.stdout.lines().count());
    let out = assur(&folder, &["profile", "a.mech", "--within", "1e-9 um"]);
    assert_eq!((out.status, out.stdout.as_str()), (1, ""));
    assert!(out.stderr.contains("needs more than 36000 steps"), "{}", out.stderr);
    for wrong in [
        &["--within", "1"][..],
        &["--within", "-1um"],
        &["--within", "1 kg"],
        &["--within", "1um", "--steps", "9"],
    ] {
        let out = assur(&folder, &[&["profile", "a.mech"], wrong].concat());
        assert_eq!((out.status, out.stdout.as_str()), (2, ""), "{wrong:?}");
    }
    let unclear = assur(&folder, &["profile", "two.mech"]);
    assert_eq!(unclear.status, 1);
    assert!(unclear.stderr.contains("`plate`, `other`"), "{}", unclear.stderr);
    assert_eq!(assur(&folder, &["profile", "two.mech", "--cam", "other"]).status, 0);
    assert_eq!(assur(&folder, &["profile", "none.mech"]).status, 1);
}
