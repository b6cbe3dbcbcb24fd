//! Every picture of every example.

use crate::bars::Tally;
use crate::drawn::{Shown, faults, moving, sheets, solved};
use assur::internals::picture::{KINDS, Kind, Options, Scene, Subject, draw};
use std::path::Path;

pub fn examples() -> Vec<(String, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let files = crate::folder::files(&root, "mech").into_iter();
    let texts = files.map(|path| {
        let name = path.strip_prefix(&root).unwrap_or(&path).display().to_string();
        (name, std::fs::read_to_string(&path).expect("an example"))
    });
    texts.collect()
}

#[test]
fn pictures_show_the_solution_and_labels_are_apart() {
    let mut tally = Tally::default();
    for (name, text) in examples() {
        let Some((source, solved)) = solved(&name, &text) else {
            tally.wrong.push(format!("{name}: not solved"));
            continue;
        };
        let shown = Shown::of(&source, &solved);
        for kind in KINDS {
            for (pose, sheet) in shown.sheets(kind, true) {
                tally.judge(&shown, kind, pose, &sheet);
            }
        }
    }
    tally.finish();
    let Tally { sheets, joints, ends, parts, polygons, bodies, levers, lines, .. } = tally;
    assert!(sheets > 1000 && joints > 1000 && ends > 500 && parts > 500, "{tally:?}");
    assert!(bodies > 1000 && polygons > 150 && levers > 100 && lines > 30, "{tally:?}");
}

#[test]
fn paths_and_other_poses_are_drawn() {
    let (mut wrong, mut count) = (Vec::new(), 0);
    for (name, text) in examples() {
        let Some((source, solved)) = solved(&name, &text) else { continue };
        let Some(sheet) = moving(&source, &solved) else { continue };
        count += 1;
        wrong.extend(faults(&sheet).into_iter().take(3).map(|f| format!("{name}: {f}")));
    }
    assert!(count > 100, "paths are drawn: {count}");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn kinds_are_known_without_drawing() {
    let (mut wrong, mut count) = (Vec::new(), 0);
    for (name, text) in examples() {
        let Some((source, solved)) = solved(&name, &text) else { continue };
        let file = (source.name.as_str(), source.text.as_str());
        let (mechanism, solution) = (&solved.compiled.mechanism, &solved.solution);
        let scene = Scene::of(solved.compiled.model(), solution, file, None).ok();
        let subject = Subject::without_position(mechanism, solution, &source.name);
        let subject = Subject { scene: scene.as_ref(), ..subject };
        let kinds = subject.kinds();
        for kind in KINDS.into_iter().filter(|kind| *kind != Kind::Animation) {
            let drawn = draw(kind, subject, &Options::default());
            // what is known only when it is drawn
            let late = ["cannot be read", "has a value over the sweep"];
            let why = drawn.as_ref().err().map(ToString::to_string).unwrap_or_default();
            if !late.iter().any(|late| why.contains(late)) && kinds.contains(&kind) != drawn.is_ok() {
                wrong.push(format!("{name}: {}: {why}", kind.name()));
            }
        }
        count += kinds.len();
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(count > 1000, "{count} pictures");
}

#[test]
fn every_example_has_a_picture() {
    let mut wrong = Vec::new();
    for (name, text) in examples() {
        let Some((source, solved)) = solved(&name, &text) else { continue };
        let has = KINDS.into_iter().any(|kind| !sheets(&source, &solved, kind).is_empty());
        if !has {
            wrong.push(format!("{name}: no picture"));
        }
        // those with positions are judged above
        for kind in [Kind::Cam, Kind::Gears, Kind::Elements] {
            for sheet in sheets(&source, &solved, kind) {
                wrong.extend(faults(&sheet).into_iter().map(|fault| format!("{name}: {fault}")));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
