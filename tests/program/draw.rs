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
fn among_several_files_those_without_positions_are_passed_over() {
    let sizes = "given r = 1 mm\nlet y = 2*r\nfind y\n";
    let folder = Folder::new("draw-sizes").with("a.mech", &one()).with("b.mech", sizes);
    let out = assur(&folder, &["draw", "a.mech", "b.mech", "-o", "all.html"]);
    assert_eq!(
        (out.status, out.stdout.as_str(), out.stderr.as_str()),
        (0, "", "b.mech has no position to draw\n")
    );
    assert_eq!(folder.read("all.html").matches("<svg").count(), 1);
    assert_eq!(assur(&folder, &["draw", "b.mech"]).status, 1);
}

#[test]
fn a_cam_alone_needs_no_position() {
    let cam = "cam plate { base_radius 50 mm; turning ccw; follower translating roller { radius 10 mm }\n\
               rise 120 deg through 30 mm cycloidal; fall 120 deg poly345 }\n";
    let folder = Folder::new("draw-cam").with("a.mech", cam);
    let one = assur(&folder, &["draw", "a.mech"]);
    assert_eq!((one.status, one.stderr.as_str()), (0, ""));
    let all = assur(&folder, &["draw", "a.mech", "--all", "-o", "out"]);
    assert_eq!((all.status, all.stderr.as_str()), (0, ""));
    assert!(folder.read("out/a-cam-1.svg").contains("cam plate"));
    let scheme = assur(&folder, &["draw", "a.mech", "scheme"]);
    assert!(
        scheme.status == 1 && scheme.stderr.contains("without one the file has `cam`"),
        "{}",
        scheme.stderr
    );
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

#[test]
fn a_scale_is_as_wanted_or_refused() {
    let folder = Folder::new("draw-scale").with("a.mech", &one());
    let scaled = |scale: &str, picture: &str| assur(&folder, &["draw", "a.mech", picture, "--scale", scale]);
    let out = scaled("length=0.01,velocity=0.5", "scheme");
    assert_eq!((out.status, out.stdout.as_str()), (2, ""));
    assert!(out.stderr.contains("`--scale velocity` changes no picture"), "{}", out.stderr);
    assert!(out.stderr.contains("`velocities`, `lever`, `hodograph`"), "{}", out.stderr);
    let out = scaled("length=0.01", "scheme");
    assert_eq!((out.status, out.stderr.as_str()), (0, ""));
    assert!(out.stdout.contains("Length scale 0.01 m per mm"), "{}", out.stdout);
    let out = scaled("velocity=0.5", "velocities");
    assert_eq!((out.status, out.stderr.as_str()), (0, ""));
    assert!(out.stdout.contains("Scale 0.5 m/s per mm"), "{}", out.stdout);
    let out = scaled("length=0.0001", "scheme");
    assert_eq!((out.status, out.stdout.as_str()), (1, ""));
    assert!(out.stderr.contains("mech::picture::no_scale"), "{}", out.stderr);
    for (wrong, said) in [
        ("mass=1", "`mass` has no scale: write length, velocity, acceleration, force"),
        ("length=0.003", "write length=0.004"),
        ("length", "write KIND=FACTOR"),
        ("length=-1", "write KIND=FACTOR"),
    ] {
        let out = scaled(wrong, "scheme");
        assert_eq!((out.status, out.stdout.as_str()), (2, ""), "{wrong}");
        assert!(out.stderr.contains(said), "{wrong}: {}", out.stderr);
    }
}

#[test]
fn an_option_of_another_picture_is_refused() {
    let folder = Folder::new("draw-option").with("a.mech", &one());
    for option in [
        &["--ghosts", "4"][..],
        &["--path", "rod.B"],
        &["--loads", "none"],
        &["--frames", "12"],
        &["--dimensions"],
        &["--numbers"],
    ] {
        let out = assur(&folder, &[&["draw", "a.mech", "velocities"], option].concat());
        assert_eq!((out.status, out.stdout.as_str()), (2, ""), "{option:?}");
        assert!(out.stderr.contains("changes no picture"), "{}", out.stderr);
    }
    for option in [["--pose", "1"], ["--size", "100x100"]] {
        let out = assur(&folder, &["draw", "a.mech", "plot", option[0], option[1]]);
        assert_eq!((out.status, out.stdout.as_str()), (2, ""), "{option:?}");
        assert!(out.stderr.contains("changes no picture"), "{}", out.stderr);
    }
    let out = assur(&folder, &["draw", "a.mech", "--numbers", "--loads", "none"]);
    assert_eq!((out.status, out.stdout.as_str()), (2, ""));
}

#[test]
fn dimensions_and_numbers_are_drawn() {
    let text = one() + "force P on piston at C = 400 N @ 180 deg\nbalance torque Mb on crank\n";
    let folder = Folder::new("draw-dimensions").with("a.mech", &text);
    let out = assur(&folder, &["draw", "a.mech", "--dimensions", "--numbers", "--scale", "force=20"]);
    assert_eq!((out.status, out.stderr.as_str()), (0, ""));
    for said in [
        "Dimensions: r = 100 mm",
        "class=\"dimension\" data-name=\"r\"",
        "Loads: P = 400 N",
        "Unknown effort Mb = 0 N·m",
        "Force scale 20 N per mm",
    ] {
        assert!(out.stdout.contains(said), "{said}: {}", out.stdout);
    }
    let out = assur(&folder, &["draw", "a.mech", "--numbers", "--scale", "force=10"]);
    assert_eq!((out.status, out.stdout.as_str()), (1, ""));
    assert!(out.stderr.contains("`--scale force=20`"), "{}", out.stderr);
}

/// How many frames the player of a page has.
fn frames(page: &str) -> Option<usize> {
    page.split_once("\"frames\":")?.1.split(',').next()?.parse().ok()
}

#[test]
fn an_animation_has_the_frames_that_are_wanted() {
    let folder = Folder::new("draw-frames").with("a.mech", &one());
    for count in ["2", "24", "500"] {
        let out = assur(&folder, &["draw", "a.mech", "animation", "--frames", count]);
        assert_eq!((out.status, out.stderr.as_str()), (0, ""));
        assert_eq!(frames(&out.stdout), count.parse().ok());
    }
    for count in ["1", "20000", "x"] {
        let out = assur(&folder, &["draw", "a.mech", "animation", "--frames", count]);
        assert_eq!((out.status, out.stdout.as_str()), (2, ""));
        assert!(out.stderr.contains("from 2 to 10000"), "{}", out.stderr);
    }
}

#[test]
fn an_animation_follows_a_motion_under_loads() {
    let text = include_str!("../../examples/simulation/double-pendulum.mech");
    let folder = Folder::new("draw-motion").with("a.mech", text);
    let out = assur(&folder, &["draw", "a.mech", "animation", "--frames", "4"]);
    assert_eq!(out.status, 0, "{}", out.stderr);
    // the last frame is at 3 s, where the first rod is at 0.44533 rad, 25.5°: the page has steps of a tenth of a degree in
    // base 64, five bits a digit, the least first, of which the first is the sign
    let steps = out.stdout.split_once(r#"["φ_one","°",1,""#).and_then(|(_, rest)| rest.split_once('"'));
    let digit = |c: char| match c {
        'A'..='Z' => c as i64 - 'A' as i64,
        'a'..='z' => c as i64 - 'a' as i64 + 26,
        '0'..='9' => c as i64 - '0' as i64 + 52,
        _ => 62 + i64::from(c == '/'),
    };
    let (mut sums, mut step, mut place) = (vec![0], 0, 1);
    for digit in steps.map_or("", |s| s.0).chars().map(digit) {
        step += digit % 32 * place;
        place *= 32;
        if digit < 32 {
            sums.push(sums[sums.len() - 1] + if step % 2 == 1 { -(step / 2) } else { step / 2 });
            (step, place) = (0, 1);
        }
    }
    assert_eq!((sums.len() - 1, sums.last()), (4, Some(&255)));
    assert!(out.stdout.contains(r#"["t"," s""#) && out.stdout.contains("t = 0.000 s"));
}

#[test]
fn an_animation_is_a_page_or_a_picture() {
    let folder = Folder::new("draw-animation").with("a.mech", &one());
    let out = assur(&folder, &["draw", "a.mech", "animation", "-o", "a.svg"]);
    assert_eq!((out.status, out.stdout.as_str(), out.stderr.as_str()), (0, "", ""));
    let picture = folder.read("a.svg");
    assert!(picture.contains("<animateTransform") && !picture.contains("<script"));
    assert!(picture.starts_with("<svg ") && picture.ends_with("</svg>\n"));
    let out = assur(&folder, &["draw", "a.mech", "animation", "-o", "a.html"]);
    assert_eq!((out.status, out.stdout.as_str(), out.stderr.as_str()), (0, "", ""));
    let page = folder.read("a.html");
    assert!(page.contains("<script ") && page.contains("<output class=\"motion-values\">φ = 0.0°</output>"));
    let out = assur(&folder, &["draw", "a.mech", "animation", "--frames", "10000"]);
    assert!(out.status == 0 && out.stdout.len() < 1_200_000, "{} bytes", out.stdout.len());
}

#[test]
fn an_animation_has_the_arrows_that_are_wanted_or_says_why_not() {
    let folder = Folder::new("draw-arrows").with("a.mech", &one());
    let drawn = |words: &[&str]| assur(&folder, &[&["draw", "a.mech", "animation"], words].concat());
    let out = drawn(&["--arrows", "velocities"]);
    assert_eq!((out.status, out.stderr.as_str()), (0, ""));
    assert!(out.stdout.contains("\"shown\":\"velocities\""));
    let out = drawn(&["--arrows", "loads"]);
    assert_eq!((out.status, out.stdout.as_str()), (1, ""));
    assert!(out.stderr.contains("there are no forces to draw"), "{}", out.stderr);
    let out = assur(&folder, &["draw", "a.mech", "--arrows", "velocities"]);
    assert!(out.status == 2 && out.stderr.contains("it is for `animation`"), "{}", out.stderr);
}

#[test]
fn a_format_is_that_of_the_output() {
    let folder = Folder::new("draw-format").with("a.mech", &one());
    let drawn = |words: &[&str]| assur(&folder, &[&["draw", "a.mech"], words].concat());
    let (plain, named) = (drawn(&[]), drawn(&["--format", "svg", "-o", "-"]));
    assert_eq!((plain.stdout, plain.status), (named.stdout, named.status));
    let page = drawn(&["scheme", "velocities", "--format", "html", "-o", "-"]);
    assert_eq!((page.status, page.stderr.as_str()), (0, ""));
    assert!(page.stdout.starts_with("<!doctype html>") && page.stdout.matches("<svg ").count() == 2);
    let kept = drawn(&["scheme", "velocities", "-o", "a.html"]);
    assert_eq!((kept.status, folder.read("a.html")), (0, page.stdout));
    let other = drawn(&["--format", "svg", "-o", "b.html"]);
    assert_eq!((other.status, other.stdout.as_str()), (2, ""));
    assert!(other.stderr.contains("`b.html` is no name of a .svg file"), "{}", other.stderr);
    assert_eq!(drawn(&["--format", "html", "-o", "pictures"]).status, 2);
    assert_eq!(drawn(&["scheme", "velocities", "--format", "svg", "-o", "-"]).status, 2);
    assert_eq!(folder.names(), ["a.html", "a.mech"]);
}

#[test]
fn pictures_have_the_words_of_a_language() {
    let folder = Folder::new("draw-language").with("a.mech", &one());
    let drawn = |words: &[&str]| assur(&folder, &[&["draw", "a.mech"], words].concat()).stdout;
    let russian = drawn(&["velocities", "--lang", "ru"]);
    assert!(russian.contains("план скоростей") && russian.contains("Скорости из полюса p: "), "{russian}");
    let chinese = drawn(&["--lang", "zh", "scheme", "--format", "html"]);
    assert!(chinese.contains("<html lang=\"zh\">") && chinese.contains("机构运动简图"), "{chinese}");
    assert_eq!(drawn(&["--lang", "en"]), drawn(&[]));
}

#[test]
fn rows_of_variants_are_drawn() {
    let own = format!("{}\nvariants {{\n  variant, r [mm]\n  small, 60\n  large, 120\n}}\n", one());
    let own = own.replace("expect x_C = 450 mm within 1e-9 at pose 1\n", "");
    let folder = Folder::new("draw-rows").with("a.mech", &own).with("T.csv", "r [mm]\n60\n120\n80\n");
    let drawn = |args: &[&str]| assur(&folder, &[&["draw", "a.mech"], args].concat());
    let as_written = drawn(&["--set", "r=120mm"]);
    let large = drawn(&["--row", "large"]);
    assert_eq!((large.status, large.stderr.as_str()), (0, ""));
    assert_eq!(drawn(&["--row", "2"]).stdout, large.stdout);
    let marks = |svg: &str| svg.split_once("</style>").map(|(_, marks)| marks.to_owned());
    assert_eq!(marks(&large.stdout), marks(&as_written.stdout));
    assert!(large.stdout.contains("row 2, variant large (r = 120 mm)"), "{}", large.stdout);
    let out = drawn(&["--row", "larg"]);
    assert_eq!((out.status, out.stdout.as_str()), (2, ""));
    assert!(out.stderr.contains("did you mean `large`?"), "{}", out.stderr);
    let out = drawn(&["--variants", "T.csv", "--row", "9"]);
    assert!(out.stderr.contains("the rows are 1 to 3"), "{}", out.stderr);
    assert_eq!(drawn(&["--variants", "T.csv"]).status, 2, "three pictures in one place");
    let out = drawn(&["--variants", "T.csv", "-o", "out"]);
    assert_eq!((out.status, out.stdout.as_str(), out.stderr.as_str()), (0, "", ""));
    let row = folder.read("out/a-row-2-scheme.svg");
    assert_eq!(marks(&row), marks(&as_written.stdout));
    let page = drawn(&["--variants", "T.csv", "-o", "all.html"]);
    assert_eq!(page.status, 0);
    let page = folder.read("all.html");
    let ids: Vec<&str> = page.split(" id=\"").skip(1).filter_map(|part| part.split('"').next()).collect();
    assert!(ids.len() == 6 && (1..6).all(|i| !ids[..i].contains(&ids[i])), "{ids:?}");
}

#[test]
fn rows_that_cannot_be_drawn_are_said() {
    let folder = Folder::new("draw-no-rows").with("a.mech", &one());
    folder.write_bytes("T.csv", b"rr [mm]\n60\n");
    folder.write_bytes("E.csv", b"r [mm]\n");
    folder.write_bytes("N.csv", b"r [mm]\nx\n");
    folder.write_bytes("far.csv", b"r [mm]\n60\n900\n");
    let drawn = |args: &[&str]| assur(&folder, &[&["draw", "a.mech"], args].concat());
    let out = drawn(&["--row", "1"]);
    assert_eq!((out.status, out.stdout.as_str()), (2, ""));
    assert!(out.stderr.contains("has no table of variants"), "{}", out.stderr);
    let out = drawn(&["--variants", "none.csv"]);
    assert_eq!((out.status, out.stdout.as_str()), (2, ""));
    for (table, code) in [("T.csv", "name::unknown"), ("E.csv", "table::empty"), ("N.csv", "table::number")] {
        let out = drawn(&["--variants", table]);
        assert_eq!((out.status, out.stdout.as_str()), (1, ""), "{table}");
        assert!(out.stderr.contains(&format!("mech::{code}")), "{table}: {}", out.stderr);
    }
    let out = drawn(&["--variants", "far.csv", "velocities", "--pose", "1", "-o", "out"]);
    assert_eq!(out.status, 0, "{}", out.stderr);
    assert!(drawn(&["--set", "r=x"]).stderr.contains("mech::request::set_value"));
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
    assert_eq!(count, 13);
}

#[test]
fn drawings_for_other_programs_hold_one_picture() {
    let folder = Folder::new("draw-other").with("a.mech", &one());
    for (format, begin) in [("dxf", "  0\r\nSECTION"), ("tikz", "% "), ("tex", "\\documentclass{article}")] {
        let name = format!("a.{format}");
        let out = assur(&folder, &["draw", "a.mech", "-o", &name]);
        assert_eq!((out.status, out.stdout.as_str(), out.stderr.as_str()), (0, "", ""));
        assert!(folder.read(&name).starts_with(begin), "{}", folder.read(&name));
        let out = assur(&folder, &["draw", "a.mech", "--format", format]);
        assert_eq!((out.status, out.stdout), (0, folder.read(&name)));
        let out = assur(&folder, &["draw", "a.mech", "scheme", "velocities", "-o", &name]);
        assert_eq!((out.status, out.stdout.as_str()), (2, ""));
        let help = format!("`-o pictures/ --format {format}`");
        assert!(out.stderr.contains("one picture only") && out.stderr.contains(&help), "{}", out.stderr);
        let both = ["draw", "a.mech", "scheme", "velocities", "animation", "-o", "out", "--format", format];
        assert_eq!(assur(&folder, &both).status, 0);
        assert_eq!(folder.read(&format!("out/a-scheme.{format}")), folder.read(&name));
        // what moves elsewhere is still here
        assert!(folder.read(&format!("out/a-animation.{format}")).starts_with(begin));
    }
    let missing = assur(&folder, &["draw", "a.mech", "-o", "none/a.dxf"]);
    assert_eq!((missing.status, missing.stdout.as_str()), (2, ""));
}

#[test]
fn true_size_is_for_schemes_in_dxf() {
    let folder = Folder::new("draw-true-size").with("a.mech", &one());
    let out = assur(&folder, &["draw", "a.mech", "-o", "a.dxf", "--true-size"]);
    assert_eq!((out.status, out.stderr.as_str()), (0, ""));
    assert!(!folder.read("a.dxf").contains("TEXT\r\n"), "{}", folder.read("a.dxf"));
    for (words, said) in [
        (&["-o", "a.svg"][..], "`--true-size` changes no picture"),
        (&["velocities", "-o", "a.dxf"], "`--true-size` changes no picture"),
        (&["-o", "a.dxf", "--ghosts", "3"], "cannot be used with"),
    ] {
        let out = assur(&folder, &[&["draw", "a.mech", "--true-size"], words].concat());
        assert_eq!((out.status, out.stdout.as_str()), (2, ""), "{words:?}");
        assert!(out.stderr.contains(said), "{words:?}: {}", out.stderr);
    }
    let out = assur(&folder, &["draw", "a.mech", "-o", "a.dxf", "--theme", "dark"]);
    assert!(out.status == 2 && out.stderr.contains("`--theme` changes no picture"), "{}", out.stderr);
}
