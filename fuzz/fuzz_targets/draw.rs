//! Text → all its pictures, with everything that options add to them.
//!
//! `fuzz/run.sh 10000000 600 draw`

#![no_main]

use assur::internals::check::Overrides;
use assur::internals::diagnostic::{Problems, Style, render};
use assur::internals::drawing::Theme;
use assur::internals::picture::{KINDS, Kind, Options, Scene, animation, draw, moving};
use assur::internals::pipeline::{dimensions, solve_drawn_conducted, turn, turn_in};
use assur::internals::solve::IntegrationOptions;
use assur::internals::source::Source;
use assur::internals::worked::Language;
use libfuzzer_sys::fuzz_target;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Frames of an animation: more only repeat what these show.
const FRAMES: usize = 12;
/// Steps of all runs of a motion under loads: with more it takes its time in `runs`.
const MOST: usize = 2_000;

fuzz_target!(|text: &str| {
    let source = Source::new("fuzz.mech", text);
    let (document, found) = assur::internals::syntax::parse(&source);
    let document = Arc::new(document);
    let steps = AtomicUsize::new(0);
    let watch = |_: f64, _: f64| steps.fetch_add(1, Ordering::Relaxed) < MOST;
    let conduct = IntegrationOptions { watch: Some(&watch), ..IntegrationOptions::default() };
    let solved = solve_drawn_conducted(&source, &document, found, &Overrides::none(), &KINDS, &conduct).0;
    let Some(solved) = solved.filter(|_| steps.load(Ordering::Relaxed) <= MOST) else { return };
    // positions alone take their time in `solve`
    if solved.solution.poses.len() > 400 || solved.compiled.mechanism.links.len() > 60 {
        return;
    }
    let turn = turn(&solved.compiled, &solved.solution);
    let file = (source.name.as_str(), source.text.as_str());
    let mut problems = Problems::new();
    match Scene::of(solved.compiled.model(), &solved.solution, file, None) {
        Ok(scene) => {
            let frames = turn_in(&solved.compiled, &solved.solution, FRAMES);
            let mut options = Options::default();
            for kind in KINDS {
                // of an animation the first frame is drawn here
                let turn = if kind == Kind::Animation { &frames } else { &turn };
                drawn(kind, &Scene { turn, ..scene }, &options, &mut problems);
            }
            options.scheme.ghosts = 8;
            options.scheme.numbers = true;
            options.scheme.dimensions = dimensions(&document, &solved.compiled.mechanism);
            drawn(Kind::Scheme, &Scene { turn: &turn, ..scene }, &options, &mut problems);
            let scene = Scene { turn: &frames, ..scene };
            let _ = animation(&scene, &Options::default(), Theme::Auto, &Language::English);
            let _ = moving(&scene, &Options::default(), Theme::Mono, &Language::English);
        }
        Err(missing) => problems.push(missing),
    }
    let _ = render(&problems, &source, Style::PLAIN);
});

fn drawn(kind: Kind, scene: &Scene<'_>, options: &Options, problems: &mut Problems) {
    match draw(kind, scene, options) {
        Ok(drawings) => drawings.into_iter().for_each(|drawing| {
            let picture = drawing.placed().svg(Theme::Auto);
            assert!(picture.ends_with("</svg>\n") && !picture.contains("NaN"), "{kind:?}");
        }),
        Err(missing) => problems.push(missing),
    }
}
