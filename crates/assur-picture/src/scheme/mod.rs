//! The kinematic scheme: the mechanism at one position, to scale.

mod axial;
mod curvature;
mod dimension;
mod effort;
mod freed;
mod geneva;
mod hidden;
mod label;
mod link;
mod mass_shape;
mod mesh;
mod numbers;
mod pair;
mod profile;
mod room;
mod rope;
mod true_size;
mod ways;
mod weld;

pub use axial::axial;
pub use curvature::{circles, curvature};
pub use dimension::{Dimension, Measured};
pub use freed::Freed;
use mesh::crossed;
pub use true_size::true_size;
pub use ways::{Traced, asked};

use crate::machine::Laid;
use crate::paper::{Frame, Paper, Scaled, Scales};
use crate::scene::Scene;
use crate::shape::{LinkShape, Outline, shapes};
use crate::words;
use assur_drawing::{Caption, Drawing, Rect, Scale, Segment, Text, plain, round_length};
use assur_math::math::Vec2;
use assur_model::model::LinkId;
use assur_text::diagnostic::Diagnosis;
use std::cell::OnceCell;

/// Which loads a scheme shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Loads {
    /// Loads, weights, unknown efforts.
    #[default]
    All,
    /// Not the unknown efforts.
    Given,
    None,
}

/// What a scheme shows of its position.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Shows {
    #[default]
    Links,
    /// Bars have the forces along them in place of their names.
    Axial,
    /// Osculating circles of paths.
    Curvature,
}

impl Shows {
    /// The begin of its ids, and what its title says.
    const fn words(self) -> [&'static str; 2] {
        match self {
            Self::Links => ["scheme", "kinematic scheme"],
            Self::Axial => ["axial", "axial forces"],
            Self::Curvature => ["curvature", "curvature of paths"],
        }
    }
}

/// What a scheme shows, and how large.
#[derive(Clone, Debug)]
pub struct Scheme {
    pub loads: Loads,
    /// Loads against the motion, which show its sense, are among them.
    pub against_motion: bool,
    /// The most that the mechanism takes, mm.
    pub size: Vec2,
    /// It may take more where many pairs need the room.
    pub grows: bool,
    /// Scale factors, where they are wanted.
    pub scales: Scales,
    /// How many other poses are shown.
    pub ghosts: usize,
    /// Points whose paths are shown: `coupler.S2`.
    pub paths: Vec<String>,
    /// Whether loads and efforts have their numbers, and arrows of forces lengths in proportion.
    pub numbers: bool,
    pub shows: Shows,
    /// Lengths that are shown with their names.
    pub dimensions: Vec<Dimension>,
}

impl Default for Scheme {
    fn default() -> Self {
        let (ghosts, paths, numbers, dimensions) = (0, Vec::new(), false, Vec::new());
        let (size, scales) = (Vec2::new(180.0, 120.0), Scales::default());
        let shows = Shows::Links;
        Self {
            loads: Loads::All,
            against_motion: true,
            size,
            grows: true,
            scales,
            ghosts,
            paths,
            numbers,
            shows,
            dimensions,
        }
    }
}

impl Scheme {
    /// The space that pictures have.
    #[must_use]
    pub const fn paper(&self) -> Paper {
        Paper { size: self.size, grows: self.grows, scales: self.scales }
    }
}

/// What symbols and labels take beside the links, mm.
const AROUND: Vec2 = Vec2::new(20.0, 16.0);
/// How much taller what is taller than wide may be.
const TALLER: f64 = 1.35;
/// The longest scale bar, mm.
const BAR: f64 = 25.0;

/// The scheme of a position.
///
/// # Errors
/// A path is wanted of a point that is not there, or where the drive has no way.
pub fn scheme(scene: &Scene<'_>, wanted: &Scheme) -> Result<Drawing, Diagnosis> {
    let laid = Laid::at_rest(scene);
    let scene = &laid.as_ref().and_then(|laid| laid.still(scene)).unwrap_or(*scene);
    let shapes = shapes(scene);
    let traced = ways::traced(scene, wanted)?;
    let mut bounds = extent(scene, &shapes);
    ways::extent(scene, wanted, &traced, &mut bounds);
    let circles = curvature::shown(scene, wanted, &mut bounds);
    let size = if wanted.grows { room::for_pairs(scene, &bounds, wanted.size) } else { wanted.size };
    let sheet = Paper { size: paper(&bounds, size), ..wanted.paper() };
    let frame = sheet.frame(Scaled::Length, &bounds, AROUND)?;
    let forces = if wanted.numbers { numbers::scale(scene, wanted)? } else { None };
    let mut drawing = drawn(scene, wanted, &shapes, (&frame, None), (&traced, &circles), forces);
    captioned(&mut drawing, &frame, forces);
    Sketch::new(scene, &shapes, &frame).hidden(&mut drawing);
    Ok(described(scene, wanted, drawing))
}

/// The size and place on paper that hold a mechanism of these shapes at several positions.
///
/// # Errors
/// A scale is wanted that does not fit.
pub fn frame_of_all(scenes: &[Scene<'_>], shapes: &[LinkShape], space: &Paper) -> Result<Frame, Diagnosis> {
    let mut bounds = Rect::NOTHING;
    scenes.iter().for_each(|scene| bounds.join(&extent(scene, shapes)));
    let size = scenes.first().map_or(space.size, |scene| room::for_pairs(scene, &bounds, space.size));
    Paper { size: paper(&bounds, size), ..*space }.frame(Scaled::Length, &bounds, AROUND)
}

/// The scheme of a position where others have their places too, without words and scales; with the paths of points.
pub fn scheme_in<'a>(
    scene: &Scene<'a>,
    wanted: &Scheme,
    shapes: &[LinkShape],
    frame: &Frame,
    traced: &[Traced],
    motion: Motion<'_, 'a>,
) -> Drawing {
    drawn(scene, wanted, shapes, (frame, Some(motion)), (traced, &[]), None)
}

/// With its title and what it shows.
pub fn described(scene: &Scene<'_>, wanted: &Scheme, mut drawing: Drawing) -> Drawing {
    let [_, what] = wanted.shows.words();
    drawing.title = format!("{}: {what}{}", words::title(scene), words::at_position(scene));
    drawing.description = words::mechanism(scene) + &drawing.description;
    drawing
}

/// Loads and unknown efforts alone, beside what begins at places in directions already.
pub fn efforts(scene: &Scene<'_>, frame: &Frame, taken: Vec<(Vec2, Vec2)>, drawing: &mut Drawing) {
    let shapes = shapes(scene);
    let mut sketch = Sketch::new(scene, &shapes, frame);
    sketch.taken = taken;
    sketch.loads(drawing, true);
    sketch.balances(drawing);
    drawing.description += &sketch.said;
}

/// What a train has in front view: wheels, all that runs between them, carriers, axes and the senses in which these turn.
pub fn front_view(scene: &Scene<'_>, shapes: &[LinkShape], frame: &Frame, drawing: &mut Drawing) {
    let sketch = Sketch::new(scene, shapes, frame);
    sketch.wheels(|_| true, drawing);
    sketch.transmissions(drawing);
    sketch.bars(drawing);
    sketch.axes(drawing);
}

fn drawn<'a>(
    scene: &Scene<'a>,
    wanted: &Scheme,
    shapes: &[LinkShape],
    (frame, motion): (&Frame, Option<Motion<'_, 'a>>),
    (traced, circles): (&[Traced], &[curvature::Circle]),
    forces: Option<Scale>,
) -> Drawing {
    let mut drawing = Drawing::new(&words::id(scene, wanted.shows.words()[0]), String::new(), String::new());
    let mut sketch = Sketch::new(scene, shapes, frame);
    sketch.motion = motion;
    (sketch.numbers, sketch.forces) = (wanted.numbers, forces);
    if wanted.shows == Shows::Axial {
        sketch.shows_axial();
    }
    sketch.ghosts(&mut drawing, wanted.ghosts);
    sketch.paths(&mut drawing, traced);
    sketch.circles(&mut drawing, circles);
    sketch.draw(&mut drawing, wanted);
    drawing.description = sketch.said;
    drawing
}

/// With its scales below.
pub fn captioned(drawing: &mut Drawing, frame: &Frame, forces: Option<Scale>) {
    if let Some(scale) = frame.scale {
        drawing.captions.insert(0, length_scale(&scale));
        drawing.description += &format!("Length scale {} m per mm.", scale.text());
    }
    if let Some(scale) = forces {
        drawing.captions.push(numbers::caption(&scale));
        drawing.description += &format!(" Force scale {} N per mm.", scale.text());
    }
}

/// The size for a box: what is taller than wide may be taller.
fn paper(bounds: &Rect, size: Vec2) -> Vec2 {
    let extent = bounds.size();
    if extent.y > extent.x { Vec2::new(size.x, size.y * TALLER) } else { size }
}

/// The line below a picture with lengths: scale factor and bar.
#[must_use]
pub fn length_scale(scale: &Scale) -> Caption {
    let text = Text::italic("μ").and("l", true, assur_drawing::Level::Sub);
    let text = text.and(&format!(" = {} m/mm", scale.text()), false, assur_drawing::Level::Base);
    let (mantissa, exponent) = round_length(scale, BAR);
    let length = mantissa * libm::pow(10.0, f64::from(exponent)) / scale.factor();
    let words = match exponent {
        -1.. => format!("{} m", plain(mantissa, exponent)),
        -4..=-2 => format!("{} mm", plain(mantissa, exponent + 3)),
        -7..=-5 => format!("{} µm", plain(mantissa, exponent + 6)),
        _ => format!("{} m", plain(mantissa, exponent)),
    };
    Caption { text, bar: Some((length, Text::upright(&words))) }
}

/// All that the scheme must contain, m.
fn extent(scene: &Scene<'_>, shapes: &[LinkShape]) -> Rect {
    let mut bounds = Rect::NOTHING;
    let mechanism = scene.mechanism();
    for (i, shape) in shapes.iter().enumerate() {
        let link = LinkId::at(i);
        if link == LinkId::GROUND {
            shape.joints.iter().for_each(|at| bounds.add(*at));
        } else if scene.is_placed(link) && !scene.is_in_cylinder(link) {
            shape.extent(scene, link, &mut bounds);
        }
    }
    profile::extent(scene, &mut bounds);
    pair::extent(scene, &mut bounds);
    rope::extent(scene, &mut bounds);
    for spring in &mechanism.springs {
        for (link, at) in [spring.from, spring.to] {
            bounds.add(scene.at(link, at));
        }
    }
    bounds
}

/// Whether any of some points is so near to a place, mm.
fn any_near(points: &[Vec2], at: Vec2, within: f64) -> bool {
    points.iter().any(|point| {
        let d = *point - at;
        d.dot(d) <= within * within
    })
}

/// The motion of which a scheme is a frame: its marks show what turns and what runs.
#[derive(Clone, Copy)]
pub struct Motion<'s, 'a> {
    /// The position at which a tooth is in a gap, and marks that run have their places.
    pub rest: &'s Scene<'a>,
    pub frames: &'s [Scene<'a>],
}

/// A scheme that is being drawn.
struct Sketch<'a, 's> {
    scene: &'s Scene<'a>,
    shapes: &'s [LinkShape],
    frame: &'s Frame,
    /// The links that are drawn; all where there are none.
    only: Option<&'s [LinkId]>,
    motion: Option<Motion<'s, 'a>>,
    /// Lines of the links on paper, when they are asked for; none for those that have their own symbol.
    outlines: OnceCell<Vec<Outline>>,
    /// All of them, each with the box of what is at it.
    lines: OnceCell<Vec<(Rect, Segment)>>,
    /// Sentences on loads and drives.
    said: String,
    /// Where arrows of loads begin, so that none lies on another.
    taken: Vec<(Vec2, Vec2)>,
    /// Blocks on paper: middle, direction, half sizes.
    blocks: Vec<(LinkId, Vec2, Vec2, Vec2)>,
    /// Named points that have a label.
    labelled: Vec<Vec2>,
    /// Hinges on the ground.
    supports: Vec<Vec2>,
    rods: Vec<(LinkId, Vec2, Vec2)>,
    /// Whether loads and efforts have their numbers.
    numbers: bool,
    /// The scale of their arrows, where they have.
    forces: Option<Scale>,
    /// The forces along bars, where they are shown.
    axial: Option<axial::Axial>,
}

impl<'a, 's> Sketch<'a, 's> {
    fn new(scene: &'s Scene<'a>, shapes: &'s [LinkShape], frame: &'s Frame) -> Self {
        let (said, taken, blocks) = (String::new(), Vec::new(), Vec::new());
        let (labelled, supports, rods) = (Vec::new(), Vec::new(), Vec::new());
        let (numbers, forces) = (false, None);
        Self {
            scene,
            shapes,
            frame,
            only: None,
            motion: None,
            outlines: OnceCell::new(),
            lines: OnceCell::new(),
            said,
            taken,
            blocks,
            labelled,
            supports,
            rods,
            numbers,
            forces,
            axial: None,
        }
    }

    /// From the back to the front.
    fn draw(&mut self, drawing: &mut Drawing, wanted: &Scheme) {
        self.rails(drawing);
        self.walls(drawing);
        self.mass_shapes(drawing);
        self.wheels(|_| true, drawing);
        self.transmissions(drawing);
        self.thread_names(drawing);
        self.profiles(drawing);
        self.genevas(|_| true, drawing);
        self.plates(drawing);
        self.draw_blocks(drawing);
        self.loads_on_ropes(drawing);
        self.bare_shafts(drawing);
        self.bars(drawing);
        self.welds(drawing);
        self.slots(drawing);
        self.cylinders(drawing);
        self.springs(drawing);
        self.pins_of_wheels(drawing);
        self.hinges(drawing);
        self.rollers(drawing);
        self.points(drawing);
        self.numbers(drawing);
        self.drives(drawing);
        if wanted.loads != Loads::None {
            self.loads(drawing, wanted.against_motion);
        }
        if wanted.loads == Loads::All {
            self.balances(drawing);
        }
        self.dimensions(drawing, &wanted.dimensions);
    }

    fn outlines(&self) -> &[Outline] {
        self.outlines.get_or_init(|| {
            let outline = |(i, shape): (usize, &LinkShape)| {
                let link = LinkId::at(i);
                let hidden = !self.scene.is_placed(link) || self.scene.is_in_cylinder(link);
                if link == LinkId::GROUND || hidden || !self.shows(link) {
                    return Outline::default();
                }
                let body = self.scene.body(link);
                shape.outline(self.frame, &|at| body.position(at))
            };
            self.shapes.iter().enumerate().map(outline).collect()
        })
    }

    /// A point of a link on paper.
    fn on_paper(&self, link: LinkId, at: Vec2) -> Vec2 {
        self.frame.point(self.scene.at(link, at))
    }

    /// A direction of a link on paper.
    fn direction(&self, link: LinkId, along: Vec2) -> Vec2 {
        crate::inset::flipped(along.turned(self.scene.body(link).u))
    }

    /// The angle of a link on paper, rad.
    fn angle_of(&self, link: LinkId) -> f64 {
        -self.scene.body(link).u.angle()
    }

    /// How far a link has turned since marks were at rest, whole turns included, rad.
    fn turned(&self, link: LinkId) -> f64 {
        self.motion.map_or(0.0, |motion| self.scene.turned_since(motion.rest, link))
    }

    fn link_name(&self, link: LinkId) -> &'a str {
        &self.scene.mechanism().link(link).name
    }
}
