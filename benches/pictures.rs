//! The time of pictures of every example at its first position, from the solution to the text of the SVG: the scheme, and all
//! that the file declares the effects for. The least of several rounds, in milliseconds; the slowest examples first.
//!
//! `cargo bench --bench pictures -- FILE…`, which prints each kind apart; without files the examples of this folder. With `--frames N` also an animation of N
//! frames, from its positions to the page.

use assur::internals::Solved;
use assur::internals::check::Overrides;
use assur::internals::drawing::Theme;
use assur::internals::picture::{KINDS, Kind, Options, Scene, animation, draw};
use assur::internals::pipeline::{solve_drawn, turn, turn_in};
use assur::internals::source::Source;
use assur::internals::worked::Language;
use std::hint::black_box;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// How often each picture is drawn.
const ROUNDS: usize = 20;
/// Lines of the table.
const SHOWN: usize = 12;
/// What a scheme, and what all pictures, may take, ms.
const BARS: [f64; 2] = [2.0, 20.0];

/// The times of one example, ms.
struct Times {
    name: String,
    scheme: f64,
    all: f64,
    pictures: usize,
}

fn main() {
    let (mut files, mut frames) = (Vec::new(), None);
    let mut args = std::env::args().skip(1);
    while let Some(arg) = args.next() {
        match arg.as_str() {
            // what cargo puts behind the files
            "--bench" => {}
            "--frames" => frames = args.next().and_then(|n| n.parse::<usize>().ok()),
            _ => files.push(PathBuf::from(arg)),
        }
    }
    let apart = !files.is_empty();
    if !apart {
        examples(&Path::new(env!("CARGO_MANIFEST_DIR")).join("examples"), &mut files);
    }
    let mut all: Vec<Times> = files.iter().filter_map(|file| measured(file, frames, apart)).collect();
    all.sort_by(|a, b| b.all.total_cmp(&a.all));
    println!("{:<52} {:>8} {:>8} {:>9}", "example", "scheme", "all", "pictures");
    for times in all.iter().take(SHOWN) {
        println!("{:<52} {:>8.2} {:>8.2} {:>9}", times.name, times.scheme, times.all, times.pictures);
    }
    let slowest = all.iter().max_by(|a, b| a.scheme.total_cmp(&b.scheme));
    if let (Some(slowest), Some(middle)) = (slowest, all.get(all.len() / 2)) {
        println!("slowest scheme {:.2} ms: {}", slowest.scheme, slowest.name);
        println!("in the middle of {} examples all pictures take {:.2} ms", all.len(), middle.all);
    }
    let over = all.iter().filter(|t| t.scheme > BARS[0] || t.all > BARS[1]).count();
    println!("over {} ms for the scheme or {} ms for all: {over}", BARS[0], BARS[1]);
}

/// All `.mech` files of a folder, in order.
fn examples(folder: &Path, files: &mut Vec<PathBuf>) {
    let Ok(entries) = std::fs::read_dir(folder) else { return };
    let mut paths: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
    paths.sort();
    for path in paths {
        if path.is_dir() {
            examples(&path, files);
        } else if path.extension().is_some_and(|ending| ending == "mech") {
            files.push(path);
        }
    }
}

fn measured(file: &Path, frames: Option<usize>, apart: bool) -> Option<Times> {
    let text = std::fs::read_to_string(file).ok()?;
    let name = file.strip_prefix(env!("CARGO_MANIFEST_DIR")).unwrap_or(file).display().to_string();
    let source = Source::new(&name, text);
    let solved = solve_drawn(&source, &Overrides::none(), &KINDS).0?;
    let turn = turn(&solved.compiled, &solved.solution);
    let scene = scene(&source, &solved)?;
    let scene = Scene { turn: &turn, ..scene };
    let still = Scene { turn: &[], ..scene };
    let scheme = least(|| pictures(&still, Kind::Scheme)).0;
    let (all, count) = least(|| KINDS.iter().map(|kind| pictures(&scene, *kind)).sum());
    for kind in KINDS.into_iter().filter(|_| apart) {
        let (time, count) = least(|| pictures(&scene, kind));
        println!("{name}: {} {time:.2} ms, {count} pictures", kind.name());
    }
    if let Some(frames) = frames {
        let positions = turn_in(&solved.compiled, &solved.solution, frames);
        let scene = Scene { turn: &positions, ..scene };
        let options = Options { frames: Some(frames), ..Options::default() };
        let (time, bytes) = least(|| {
            animation(&scene, &options, Theme::Auto, &Language::English).map_or(0, |page| page.len())
        });
        println!("{name}: {frames} frames in {time:.0} ms, {bytes} bytes");
    }
    Some(Times { name, scheme, all, pictures: count })
}

fn scene<'a>(source: &'a Source, solved: &'a Solved) -> Option<Scene<'a>> {
    let file = (source.name.as_str(), source.text.as_str());
    Scene::of(solved.compiled.model(), &solved.solution, file, None).ok()
}

/// Draws the pictures of a kind; how many there are.
fn pictures(scene: &Scene<'_>, kind: Kind) -> usize {
    let drawings = draw(kind, scene, &Options::default()).unwrap_or_default();
    let texts = drawings.into_iter().map(|drawing| black_box(drawing.placed().svg(Theme::Auto)));
    texts.filter(|text| !text.is_empty()).count()
}

/// The least time of several rounds, ms, and what came of it.
fn least(mut work: impl FnMut() -> usize) -> (f64, usize) {
    let mut least = (f64::INFINITY, 0);
    for _ in 0..ROUNDS {
        let start = Instant::now();
        let found = black_box(work());
        least = (least.0.min(1e3 * start.elapsed().as_secs_f64()), found);
    }
    least
}
