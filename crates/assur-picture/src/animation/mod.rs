//! The mechanism in motion: the scheme of the first frame with how its parts move, as a page or as one picture.

mod arrows;
mod film;
mod motion;
mod moved;
mod page;
mod smil;
mod values;

pub use arrows::ArrowKind;
pub use film::{Film, film};
pub use motion::{Moving, motion};
pub use page::{PLAYER, PLAYER_STYLE, animation};
pub use smil::moving;

use crate::kind::Options;
use crate::machine::{Frames, Laid, frames};
use crate::paper::Frame;
use crate::scene::Scene;
use crate::scheme::{Loads, Motion, Scheme, Traced, asked, captioned, described, frame_of_all, scheme_in};
use crate::shape::{LinkShape, shapes};
use crate::train::{is_in_section, section};
use crate::wording::Wording;
use crate::words;
use assur_drawing::{Drawing, Later, Rect, Sheet, Text};
use assur_solve::solve::Pose;
use assur_text::diagnostic::Diagnosis;
use moved::Faded;
use moved::{Moved, Mover};

/// Room for labels around what moves, mm.
const LABELS: f64 = 6.0;
/// The most frames that labels are placed for.
const LOOKED_AT: usize = 24;

/// The positions that are shown, with all their places.
struct Stage {
    frames: Frames,
    laid: Option<Laid>,
}

impl Stage {
    fn of(scene: &Scene<'_>, options: &Options) -> Result<Self, Diagnosis> {
        let mut frames = frames(scene, options)?;
        // teeth and marks are at rest at the position of the scene
        frames.poses.push(scene.pose.clone());
        let laid = match is_in_section(scene) {
            true => None,
            false => Laid::of(scene, &mut frames.poses),
        };
        Ok(Self { frames, laid })
    }

    /// What is seen at each of them, and at rest.
    fn scenes<'s>(&'s self, scene: &Scene<'s>) -> (Vec<Scene<'s>>, Scene<'s>) {
        let at = |pose: &'s Pose| Some(Scene { pose, solved: pose.outcome.as_ref().ok()?, ..*scene });
        let mut scenes: Vec<Scene<'s>> = match &self.laid {
            Some(laid) => laid.scenes(scene),
            None => self.frames.poses.iter().filter_map(at).collect(),
        };
        for (scene, carried) in scenes.iter_mut().zip(&self.frames.carried) {
            scene.carried = *carried;
        }
        let rest = scenes.pop().unwrap_or(*scene);
        (scenes, rest)
    }
}

/// How the schemes of all frames are drawn: in one place, the first with what stands below.
struct Drawn {
    wanted: Scheme,
    shapes: Vec<LinkShape>,
    frame: Frame,
    /// Points that are asked for, with their paths.
    traced: Vec<Traced>,
    /// Shafts without places whose axes meet: they are seen from the side.
    in_section: bool,
}

impl Drawn {
    fn of(frames: &[Scene<'_>], closed: bool, options: &Options) -> Result<Self, Diagnosis> {
        let wanted = Scheme { loads: Loads::None, ..Scheme::default() };
        // what a link looks like is the same at every position
        let shapes = frames.first().map(shapes).unwrap_or_default();
        let frame = frame_of_all(frames, &shapes, &options.scheme.paper())?;
        let in_section = frames.first().is_some_and(is_in_section);
        let mut traced = frames.first().map(asked).unwrap_or_default();
        if options.frames.is_some() {
            // of few frames the gap would be seen
            traced.iter_mut().for_each(|point| point.closed = closed);
        }
        Ok(Self { wanted, shapes, frame, traced, in_section })
    }

    /// A frame.
    fn scheme<'a>(&self, scene: &Scene<'a>, motion: Motion<'_, 'a>) -> Drawing {
        if self.in_section {
            return section(scene, motion.rest);
        }
        scheme_in(scene, &self.wanted, &self.shapes, &self.frame, &self.traced, motion)
    }

    /// The same with its scale.
    fn first(&self, motion: Motion<'_, '_>) -> Drawing {
        let first = &motion.frames[0];
        let mut scheme = self.scheme(first, motion);
        let laid = first.laid;
        match laid {
            _ if self.in_section => {}
            Some(laid) if !laid.to_scale => scheme.caption(Text::upright("Not to scale.")),
            _ => captioned(&mut scheme, &self.frame, None),
        }
        if laid.is_some_and(|laid| laid.shares.iter().any(|share| *share < 1.0)) {
            scheme.caption(Text::upright("What ropes carry goes a part of its way."));
        }
        scheme
    }

    fn schemes(&self, motion: Motion<'_, '_>) -> Vec<Drawing> {
        let others = motion.frames.iter().skip(1).map(|frame| self.scheme(frame, motion));
        std::iter::once(self.first(motion)).chain(others).collect()
    }
}

/// The first frame.
///
/// # Errors
/// There is no way to go.
pub fn still(scene: &Scene<'_>, options: &Options) -> Result<Drawing, Diagnosis> {
    let ways = scene.all_ways();
    let scene = &Scene { ways: &ways, ..*scene };
    let stage = Stage::of(scene, options)?;
    let (frames, rest) = stage.scenes(scene);
    let drawn = Drawn::of(&frames, stage.frames.closed, options)?;
    let first = drawn.first(Motion { rest: &rest, frames: &frames });
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
    fn of(
        scene: &Scene<'a>,
        stage: &'a Stage,
        options: &Options,
        wording: &dyn Wording,
    ) -> Result<Self, Diagnosis> {
        let (frames, rest) = stage.scenes(scene);
        let drawn = Drawn::of(&frames, stage.frames.closed, options)?;
        let schemes = drawn.schemes(Motion { rest: &rest, frames: &frames });
        let moved = Moved::of(&schemes);
        let paper = (!drawn.in_section).then_some(drawn.frame);
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
