//! The mechanism in motion as pictures one after the other: the first frame, with its parts where they are in another.

use super::moved::{Faded, Moved, Mover};
use super::{Animated, Stage};
use crate::kind::Options;
use crate::scene::Scene;
use crate::wording::Wording;
use assur_drawing::{Theme, number};
use assur_math::math::Vec2;
use assur_text::diagnostic::Diagnosis;

/// The begin of a group, up to its class.
const GROUP: &str = "<g class=\"";

/// All frames of an animation, each as a picture.
pub struct Film {
    first: String,
    count: usize,
    moved: Moved,
    faded: Vec<Faded>,
}

/// What a frame changes in a group.
enum Change<'f> {
    Attribute(String),
    Content(&'f str),
}

/// The frames of an animation.
///
/// # Errors
/// There is no way to go.
pub fn film(
    scene: &Scene<'_>,
    options: &Options,
    theme: Theme,
    wording: &dyn Wording,
) -> Result<Film, Diagnosis> {
    let ways = scene.all_ways();
    let scene = &Scene { ways: &ways, ..*scene };
    let stage = Stage::of(scene, options)?;
    let animated = Animated::of(scene, &stage, options, wording)?;
    let Animated { frames, sheet, moved, faded, .. } = animated;
    Ok(Film { first: sheet.svg(theme), count: frames.len(), moved, faded })
}

impl Film {
    /// The number of frames.
    #[must_use]
    pub const fn count(&self) -> usize {
        self.count
    }

    /// A frame as SVG, counted from 0; behind the last the last.
    #[must_use]
    pub fn frame(&self, frame: usize) -> String {
        let frame = frame.min(self.count.saturating_sub(1));
        let mut out = String::with_capacity(self.first.len() + self.first.len() / 4);
        let mut rest = self.first.as_str();
        while let Some((before, group)) = rest.split_once(GROUP) {
            out.push_str(before);
            out.push_str(GROUP);
            rest = group;
            let Some((class, inside)) = group.split_once("\">") else { continue };
            match self.change(class, frame) {
                None => continue,
                Some(Change::Attribute(attribute)) => {
                    out.push_str(&format!("{class}\" {attribute}>"));
                    rest = inside;
                }
                Some(Change::Content(text)) => {
                    out.push_str(&format!("{class}\">{text}"));
                    rest = inside.find("</g>").map_or("", |end| &inside[end..]);
                }
            }
        }
        out + rest
    }

    /// What a frame changes in the group of a class.
    fn change(&self, class: &str, frame: usize) -> Option<Change<'_>> {
        let label = class.strip_prefix('v').and_then(|index| index.parse::<usize>().ok());
        if let Some(label) = label.and_then(|i| self.faded.get(i)) {
            return label.frames[frame].then(|| Change::Attribute("display=\"none\"".to_owned()));
        }
        let moved = &self.moved;
        match Mover::of_class(class)? {
            Mover::Body(i) => {
                let body = moved.bodies.get(i)?;
                let (to, angle) = body.poses[frame];
                let turn = if body.turns { turned(angle) } else { String::new() };
                let (to, back) = (shifted(to), shifted(-body.centre));
                Some(Change::Attribute(format!("transform=\"{to}{turn}{back}\"")))
            }
            Mover::Follower(i) => {
                let follower = moved.followers.get(i)?;
                let shift = moved.bodies.get(follower.body)?.carried(frame, follower.at) - follower.at;
                Some(Change::Attribute(format!("transform=\"{}\"", shifted(shift))))
            }
            Mover::Redrawn(i) => moved.redrawn.get(i)?.text(frame).map(Change::Content),
        }
    }
}

fn shifted(by: Vec2) -> String {
    format!("translate({} {})", number(by.x), number(by.y))
}

fn turned(angle: f64) -> String {
    format!("rotate({})", number(angle.to_degrees()))
}
