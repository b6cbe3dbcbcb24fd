//! The mechanism in motion: the scheme of the first frame with how its parts move, as a page or as one picture.

mod arrows;
mod between;
mod film;
mod motion;
mod moved;
mod page;
mod smil;
mod train;
mod values;

pub use arrows::ArrowKind;
pub use film::{Film, film};
pub use motion::{Moving, motion};
pub use page::{PLAYER, PLAYER_STYLE, animation};
pub use smil::moving;

use crate::inset::wrapped;
use crate::kind::Options;
use crate::paper::Frame;
use crate::scene::Scene;
use crate::scheme::{Loads, Scheme, Traced, asked, captioned, described, frame_of_all, scheme_in};
use crate::shape::{LinkShape, shapes};
use crate::wording::Wording;
use crate::{error, no_diagram, words};
use assur_drawing::{Drawing, Later, Rect, Sheet};
use assur_solve::answer::NoSweep;
use assur_solve::solve::{Cause, DriveValue, Pose};
use assur_text::diagnostic::Diagnosis;
use moved::Faded;
use moved::{Moved, Mover};

const MOST: usize = 400;
/// Room for labels around what moves, mm.
const LABELS: f64 = 6.0;
/// The most frames that labels are placed for.
const LOOKED_AT: usize = 24;

/// The frames of a mechanism: positions over the way of its drive.
fn frames<'a>(scene: &Scene<'a>, options: &Options) -> Result<Vec<Scene<'a>>, Diagnosis> {
    let all: &'a [Pose] = if scene.turn.is_empty() { &scene.solution.poses } else { scene.turn };
    let at = |pose: &'a Pose| Some(Scene { pose, solved: pose.outcome.as_ref().ok()?, ..*scene });
    let mut solved: Vec<Scene<'a>> = all.iter().filter_map(at).collect();
    if goes_back(&solved) {
        // from the same position where it comes back to it
        let comes_back = is_turn(&solved);
        solved.reverse();
        solved.rotate_right(usize::from(comes_back));
    }
    let most = options.frames.map_or(MOST, |_| usize::MAX);
    let step = solved.len().div_ceil(most).max(1);
    let frames: Vec<Scene<'a>> = solved.into_iter().step_by(step).collect();
    if frames.len() < 2 {
        let cause = Cause::NoSweep(NoSweep::OnePosition);
        return Err(no_diagram::no_sweep(scene, "animation", &cause));
    }
    Ok(frames)
}

/// Whether the drive moves against the order of the positions.
fn goes_back(frames: &[Scene<'_>]) -> bool {
    let (Some(first), Some(second)) = (frames.first(), frames.get(1)) else { return false };
    let drives = first.mechanism().drives.iter().enumerate();
    let senses = drives.filter_map(|(i, drive)| {
        let value = |scene: &Scene<'_>| match scene.pose.drives.get(i) {
            Some(DriveValue::Scalar(x)) => Some(*x),
            _ => None,
        };
        let way = value(second)? - value(first)?;
        let speed = drive.speed.as_ref().map(|e| first.view().scalar(e)).or(drive.sense)?;
        Some(way * speed).filter(|sense| *sense != 0.0 && first.mechanism().simulation.is_none())
    });
    senses.into_iter().next().is_some_and(|sense| sense < 0.0)
}

/// Whether the frame after the last is the first again.
fn is_turn(frames: &[Scene<'_>]) -> bool {
    let along = |i: usize| frames.get(i).and_then(Scene::along);
    let (Some(a), Some(b), Some(last)) = (along(0), along(1), along(frames.len() - 1)) else { return false };
    let (step, left) = (b - a, wrapped(a - last));
    wrapped(step - left).abs() < 0.5 * step.abs()
}

/// How the schemes of all frames are drawn: in one place, the first with what stands below.
struct Drawn {
    wanted: Scheme,
    shapes: Vec<LinkShape>,
    frame: Frame,
    /// Points that are asked for, with their paths.
    traced: Vec<Traced>,
}

impl Drawn {
    fn of(scene: &Scene<'_>, frames: &[Scene<'_>], options: &Options) -> Result<Self, Diagnosis> {
        let wanted = Scheme { loads: Loads::None, ..Scheme::default() };
        // what a link looks like is the same at every position
        let shapes = frames.first().map(shapes).unwrap_or_default();
        let frame = frame_of_all(frames, &shapes, &options.scheme.paper())?;
        if frame.scale.is_none() {
            return Err(error::nothing_placed(scene, "an animation shows links that move"));
        }
        let mut traced = asked(scene);
        if options.frames.is_some() {
            // of few frames the gap would be seen
            let closed = is_turn(frames);
            traced.iter_mut().for_each(|point| point.closed = closed);
        }
        Ok(Self { wanted, shapes, frame, traced })
    }

    fn first(&self, scene: &Scene<'_>) -> Drawing {
        let mut scheme = self.other(scene);
        captioned(&mut scheme, &self.frame, None);
        scheme
    }

    fn other(&self, scene: &Scene<'_>) -> Drawing {
        scheme_in(scene, &self.wanted, &self.shapes, &self.frame, &self.traced)
    }

    /// Frames, of which the first is the first.
    fn schemes<'s>(&self, frames: impl Iterator<Item = &'s Scene<'s>>) -> Vec<Drawing> {
        frames
            .enumerate()
            .map(|(i, scene)| if i == 0 { self.first(scene) } else { self.other(scene) })
            .collect()
    }
}

/// The first frame.
///
/// # Errors
/// There is no way to go.
pub fn still(scene: &Scene<'_>, options: &Options) -> Result<Drawing, Diagnosis> {
    let ways = scene.all_ways();
    let scene = &Scene { ways: &ways, ..*scene };
    let (frames, first) = match train::turning(scene, options) {
        Some((frames, schemes)) => (frames, schemes.into_iter().next().unwrap_or_default()),
        None => {
            let frames = frames(scene, options)?;
            let first = Drawn::of(scene, &frames, options)?.first(&frames[0]);
            (frames, first)
        }
    };
    let mut first = described(&frames[0], &options.scheme, first);
    first.id = words::id(scene, "animation");
    Ok(first)
}

/// The first frame with its labels, and how its parts move.
struct Animated<'a> {
    title: String,
    frames: Vec<Scene<'a>>,
    sheet: Sheet,
    /// Where the ground's axes lie on it; nowhere in a train without places.
    paper: Option<Frame>,
    moved: Moved,
    /// Labels that give way to others.
    faded: Vec<Faded>,
}

impl<'a> Animated<'a> {
    fn of(scene: &Scene<'a>, options: &Options, wording: &dyn Wording) -> Result<Self, Diagnosis> {
        let (frames, paper, (schemes, moved)) = match train::turning(scene, options) {
            Some((frames, schemes)) => {
                let moved = Moved::of(&schemes);
                (frames, None, (schemes, moved))
            }
            None => {
                let frames = frames(scene, options)?;
                let drawn = Drawn::of(scene, &frames, options)?;
                let moving = moving_marks(&frames, &drawn);
                (frames, Some(drawn.frame), moving)
            }
        };
        let mut room = Rect::NOTHING;
        schemes.iter().for_each(|scheme| room.join(&scheme.extent()));
        let others = schemes.iter().step_by(schemes.len().div_ceil(LOOKED_AT));
        let others: Vec<Later> = others.map(|frame| moved::later(&schemes[0], frame)).collect();
        let first = schemes.into_iter().next().unwrap_or_default();
        let mut first = described(&frames[0], &options.scheme, first);
        first.id = words::id(scene, "animation");
        // labels are beside what moves
        first.room = Some(room.grown(LABELS));
        first.title = format!("{}: animation", words::title(scene));
        let first = wording.drawing(scene.mechanism(), first);
        let title = first.title.clone();
        let mut sheet = first.placed_through(&others);
        let count = sheet.drawing.labels.len().max(sheet.placed.len());
        sheet.moved = moved.movers.each_ref().map(|all| all.iter().map(|by| by.map(Mover::class)).collect());
        sheet.moved[1].resize(count, None);
        let faded = moved::faded(&sheet.placed, &moved, frames.len());
        for (i, label) in faded.iter().enumerate() {
            let moves = sheet.moved[1][label.label].take().map_or_else(String::new, |class| class + " ");
            sheet.moved[1][label.label] = Some(format!("{moves}v{i}"));
        }
        Ok(Self { title, frames, sheet, paper, moved, faded })
    }
}

/// The frames that are drawn, and how what is in them moves through all: of many frames some are drawn where all that moves goes
/// with links.
fn moving_marks(frames: &[Scene<'_>], drawn: &Drawn) -> (Vec<Drawing>, Moved) {
    let step = frames.len().div_ceil(MOST);
    if step > 1 {
        let some: Vec<usize> = (0..frames.len()).step_by(step).collect();
        let schemes = drawn.schemes(some.iter().map(|i| &frames[*i]));
        if let Some(moved) = between::filled(Moved::of(&schemes), frames, &some, &drawn.frame) {
            return (schemes, moved);
        }
    }
    let schemes = drawn.schemes(frames.iter());
    let moved = Moved::of(&schemes);
    (schemes, moved)
}
