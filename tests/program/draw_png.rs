//! Pictures as pixels and as PDF, in builds with them and without.

use crate::cli::GOOD;
use crate::run::{Folder, assur};

#[cfg(not(feature = "png"))]
#[test]
fn a_build_without_png_says_so() {
    let folder = Folder::new("no-png").with("a.mech", GOOD);
    let out = assur(&folder, &["draw", "a.mech", "-o", "a.png"]);
    assert_eq!((out.status, out.stdout.as_str()), (2, ""));
    assert!(out.stderr.contains("`cargo install --path . --features png`"), "{}", out.stderr);
    assert_eq!(folder.names(), ["a.mech"]);
}

#[cfg(feature = "png")]
#[test]
fn a_png_has_the_size_of_its_picture() {
    let folder = Folder::new("png").with("a.mech", GOOD);
    let out = assur(&folder, &["draw", "a.mech", "velocities", "--pose", "2", "-o", "a.png"]);
    if out.stderr.contains("no font for its letters") {
        // a machine without fonts
        assert_eq!((out.status, folder.names()), (2, vec!["a.mech".to_owned()]));
        return;
    }
    assert_eq!((out.status, out.stdout.as_str(), out.stderr.as_str()), (0, "", ""));
    let bytes = std::fs::read(folder.path("a.png")).expect("a picture");
    assert!(bytes.starts_with(b"\x89PNG\r\n"));
    assert_eq!(&bytes[37..41], b"pHYs", "it says how many pixels are a metre");
    let svg = assur(&folder, &["draw", "a.mech", "velocities", "--pose", "2"]).stdout;
    let width =
        svg.split_once("width=\"").and_then(|(_, rest)| rest.split_once("mm")).map(|(width, _)| width);
    let width: f64 = width.and_then(|width| width.parse().ok()).expect("a width");
    let pixels = u32::from_be_bytes([bytes[16], bytes[17], bytes[18], bytes[19]]);
    assert!((f64::from(pixels) - width / 25.4 * 300.0).abs() < 4.0, "{width} mm are {pixels} pixels");
    // the same on standard output and in a folder
    let out = std::process::Command::new(env!("CARGO_BIN_EXE_assur"))
        .current_dir(folder.path(""))
        .args(["draw", "a.mech", "velocities", "--pose", "2", "--format", "png", "-o", "-"])
        .output()
        .expect("the program runs");
    assert!(out.stdout == bytes);
    let out = assur(&folder, &["draw", "a.mech", "velocities", "--pose", "2", "--format", "png", "-o", "p"]);
    assert_eq!((out.status, out.stdout.as_str()), (0, ""));
    assert!(std::fs::read(folder.path("p/a-velocities.png")).expect("a picture") == bytes);
    // lines and letters, and no empty sheet
    assert!(bytes.len() > 4000, "{} bytes", bytes.len());
    let out = assur(&folder, &["draw", "a.mech", "scheme", "velocities", "-o", "b.png"]);
    assert_eq!((out.status, out.stdout.as_str()), (2, ""));
}

#[cfg(not(feature = "pdf"))]
#[test]
fn a_build_without_pdf_says_so() {
    let folder = Folder::new("no-pdf").with("a.mech", GOOD);
    let out = assur(&folder, &["draw", "a.mech", "-o", "a.pdf"]);
    assert_eq!((out.status, out.stdout.as_str()), (2, ""));
    assert!(out.stderr.contains("`cargo install --path . --features pdf`"), "{}", out.stderr);
    assert_eq!(folder.names(), ["a.mech"]);
}

#[cfg(feature = "pdf")]
#[test]
fn a_pdf_has_the_size_of_its_picture_and_is_the_same_each_time() {
    let folder = Folder::new("pdf").with("a.mech", GOOD);
    for name in ["a.pdf", "b.pdf"] {
        let out = assur(&folder, &["draw", "a.mech", "velocities", "--pose", "2", "-o", name]);
        if out.stderr.contains("no font for its letters") {
            return;
        }
        assert_eq!((out.status, out.stdout.as_str(), out.stderr.as_str()), (0, "", ""));
    }
    let read = |name: &str| std::fs::read(folder.path(name)).expect("a picture");
    let bytes = read("a.pdf");
    assert!(bytes.starts_with(b"%PDF-") && bytes == read("b.pdf"));
    let svg = assur(&folder, &["draw", "a.mech", "velocities", "--pose", "2"]).stdout;
    let width =
        svg.split_once("width=\"").and_then(|(_, rest)| rest.split_once("mm")).map(|(width, _)| width);
    let width: f64 = width.and_then(|width| width.parse().ok()).expect("a width");
    let text = String::from_utf8_lossy(&bytes);
    let page = text.split_once("/MediaBox").and_then(|(_, rest)| rest.split_once(']')).expect("a page").0;
    let points: Vec<f64> = page.split(['[', ' ']).filter_map(|x| x.trim().parse().ok()).collect();
    assert!((points[2] - width / 25.4 * 72.0).abs() < 0.1, "{width} mm are {points:?} points");
    // fonts are in it
    assert!(text.contains("/FontFile"), "no font");
}
