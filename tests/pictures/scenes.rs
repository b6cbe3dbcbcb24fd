//! The twelve scenes of the design, kept as pictures that were looked at beside it.

use crate::drawn::solved;
use assur::internals::drawing::Theme;
use assur::internals::math::Vec2;
use assur::internals::picture::{Kind, Options, Scene, Scheme, draw};
use std::path::Path;

/// File, kind, position, and which of the pictures.
type Place = (&'static str, Kind, Option<&'static str>, usize);

fn kept(name: &str, (file, kind, pose, number): Place, wanted: Scheme) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples").join(file);
    let text = std::fs::read_to_string(path).expect("an example");
    let (source, solved) = solved(file, &text).expect("a solution");
    let turn = assur::internals::pipeline::turn(&solved.compiled, &solved.solution);
    let model = solved.compiled.model();
    let scene = Scene::of(model, &solved.solution, (&source.name, &source.text), pose).expect("a position");
    let scene = Scene { turn: &turn, ..scene };
    let options = Options { scheme: wanted, ..Options::default() };
    let drawing = draw(kind, &scene, &options).expect("a picture").swap_remove(number);
    insta::with_settings!({ snapshot_path => "snapshots", prepend_module_to_snapshot => false }, {
        insta::assert_binary_snapshot!(&format!("{name}.svg"), drawing.placed().svg(Theme::Auto).into_bytes());
    });
}

fn plain(name: &str, place: Place) {
    kept(name, place, Scheme::default());
}

const SIX_BAR: &str = "kinetostatics/six-bar.mech";
const SHAPER: &str = "shaper/shaper-a.mech";

#[test]
fn schemes() {
    let paths = vec!["coupler.S2".to_owned(), "crank.B".to_owned()];
    kept("scheme-six-bar", (SIX_BAR, Kind::Scheme, None, 0), Scheme { paths, ..Scheme::default() });
    let wanted = Scheme { ghosts: 12, size: Vec2::new(180.0, 160.0), ..Scheme::default() };
    kept("scheme-shaper", (SHAPER, Kind::Scheme, Some("3"), 0), wanted);
}

#[test]
fn plans() {
    plain("velocity-plan-shaper", (SHAPER, Kind::Velocities, Some("3"), 0));
    plain("acceleration-plan-shaper", (SHAPER, Kind::Accelerations, Some("3"), 0));
}

#[test]
fn forces() {
    plain("free-body-group-2-3", (SIX_BAR, Kind::Forces, None, 2));
    plain("force-polygon-group-2-3", (SIX_BAR, Kind::Forces, None, 3));
    plain("zhukovsky-lever-six-bar", (SIX_BAR, Kind::Lever, None, 0));
    plain("friction-circles-four-bar", ("friction/four-bar.mech", Kind::Friction, None, 0));
}

#[test]
fn machines() {
    plain("flywheel-work", (SHAPER, Kind::Work, None, 0));
    plain("cam-lever", ("cams/lever.mech", Kind::Cam, None, 0));
    plain("cam-lever-motion", ("cams/lever.mech", Kind::Cam, None, 1));
    plain("train-planetary", ("trains/planetary-gearbox.mech", Kind::Train, None, 0));
}
