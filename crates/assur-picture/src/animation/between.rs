//! Frames between those that are drawn: what keeps its shape is where its link is.

use super::moved::{Body, Moved, SAME, SAME_ANGLE};
use crate::inset::wrapped;
use crate::paper::Frame;
use crate::scene::Scene;
use assur_math::math::Vec2;
use assur_model::model::LinkId;

/// A turn from which on it shows which place of a link a body goes with.
const TURNS: f64 = 1e-3;

/// How a body moves on paper that turns with a link, or goes with a place of it without turning.
struct OnLink<'s, 'a> {
    frames: &'s [Scene<'a>],
    frame: &'s Frame,
    link: LinkId,
    turns: bool,
    /// The angle of the link in the first frame; y is down on paper.
    first: f64,
    /// The place in the first frame, from the origin of the link.
    place: Vec2,
    /// From the place to the centre of the body, in all frames.
    beside: Vec2,
}

impl<'s, 'a> OnLink<'s, 'a> {
    fn of(all: (&'s [Scene<'a>], &[usize], &'s Frame), link: LinkId, body: &Body) -> Option<Self> {
        let (frames, drawn, frame) = all;
        let (origin, beside) = (frames.first()?.body(link), Vec2::zero());
        let (first, place) = (-origin.u.angle(), body.centre - frame.point(origin.p));
        let mut on = Self { frames, frame, link, turns: body.turns, first, place, beside };
        if !body.turns {
            on.place = on.place_of(body, drawn);
            on.beside = place - on.place;
        }
        Some(on)
    }

    /// The place that goes as a body does which does not turn, from where the link has turned most.
    fn place_of(&self, body: &Body, drawn: &[usize]) -> Vec2 {
        let turn = |frame: usize| Vec2::direction(self.angle(frame)) - Vec2::new(1.0, 0.0);
        let turns = drawn.iter().zip(&body.poses).map(|(frame, pose)| (*frame, turn(*frame), pose.0));
        let most = turns.max_by(|a, b| a.1.norm().total_cmp(&b.1.norm()));
        let Some((frame, turn, at)) = most.filter(|(_, turn, _)| turn.norm() > TURNS) else {
            return Vec2::zero();
        };
        let gone = at - body.centre - (self.origin(frame) - self.origin(0));
        // gone = (R - 1) place, and R - 1 is a turn with a stretch
        gone.turned(Vec2::new(turn.x, -turn.y)) / turn.dot(turn)
    }

    fn origin(&self, frame: usize) -> Vec2 {
        self.frame.point(self.frames[frame].body(self.link).p)
    }

    /// How far the link has turned on paper since the first frame, but for whole turns.
    fn angle(&self, frame: usize) -> f64 {
        -self.frames[frame].body(self.link).u.angle() - self.first
    }

    /// Where the body is in a frame, mm, and how far it has turned since the first but for whole turns.
    fn pose(&self, frame: usize) -> (Vec2, f64) {
        let angle = self.angle(frame);
        let at = self.origin(frame) + self.place.turned(Vec2::direction(angle)) + self.beside;
        (at, if self.turns { angle } else { 0.0 })
    }

    /// Whether it is there in the frames that are drawn.
    fn carries(&self, body: &Body, drawn: &[usize]) -> bool {
        drawn.iter().zip(&body.poses).all(|(frame, (at, angle))| {
            let pose = self.pose(*frame);
            (pose.0 - *at).norm() <= SAME && wrapped(pose.1 - angle).abs() < SAME_ANGLE
        })
    }

    /// Its poses in all frames; angles go on without jumps.
    fn poses(&self) -> Vec<(Vec2, f64)> {
        let mut before = 0.0;
        let pose = |frame: usize| {
            let (at, angle) = self.pose(frame);
            before += wrapped(angle - before);
            (at, before)
        };
        (0..self.frames.len()).map(pose).collect()
    }
}

/// Gives all bodies their poses in all frames, of which some are drawn; `None` where something that moves is no part of a link.
pub fn filled(mut moved: Moved, frames: &[Scene<'_>], drawn: &[usize], frame: &Frame) -> Option<Moved> {
    let scene = frames.first().filter(|_| moved.redrawn.is_empty())?;
    let placed = |link: &LinkId| scene.is_placed(*link);
    let links: Vec<LinkId> = (1..scene.mechanism().links.len()).map(LinkId::at).filter(placed).collect();
    for body in &mut moved.bodies {
        let mut places = links.iter().filter_map(|link| OnLink::of((frames, drawn, frame), *link, body));
        body.poses = places.find(|place| place.carries(body, drawn))?.poses();
    }
    Some(moved)
}
