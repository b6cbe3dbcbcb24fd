//! The kinds of picture, by name.

use crate::animation::{ArrowKind, still};
use crate::cam::cams;
use crate::elements::elements;
use crate::equilibrium::equilibrium;
use crate::error;
use crate::forces::{self, forces, friction, frictions, lever};
use crate::fourier::{all_series, fourier};
use crate::gears::gears;
use crate::hodograph::{hodographs, points_asked, polars, reactions_asked};
use crate::internal::internal;
use crate::motion::{self, accelerations, velocities};
use crate::paper::Scaled;
use crate::planes::{planes, rotors};
use crate::plot::{items, plot};
use crate::scene::{Scene, Subject};
use crate::scheme::{Scheme, axial, circles, curvature, scheme};
use crate::train::{has_train, train};
use crate::work::work;
use assur_drawing::Drawing;
use assur_model::model::{Level, LinkId};
use assur_solve::solve::courses;
use assur_text::diagnostic::Diagnosis;

/// A kind of picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    Scheme,
    /// The plan of velocities.
    Velocities,
    /// The plan of accelerations.
    Accelerations,
    /// A free body and a polygon of forces per structural group.
    Forces,
    Lever,
    /// Bars with the forces along them.
    Axial,
    /// Osculating circles of paths.
    Curvature,
    /// Friction circles, angles and action lines.
    Friction,
    Train,
    /// Numbers over the sweep.
    Plot,
    /// Effort and work of a flywheel over the cycle.
    Work,
    /// Amplitudes of Fourier series.
    Fourier,
    /// Forces inside links.
    Internal,
    /// Masses of rotors in their planes.
    Planes,
    /// Potential energy around positions of equilibrium.
    Equilibrium,
    /// Profile and motion of designed cams.
    Cam,
    /// Wheels in mesh with their teeth.
    Gears,
    /// Bearings, belts and screws of formulas.
    Elements,
    /// Velocities of a point over the sweep.
    Hodograph,
    /// Reactions in a pair over the sweep.
    Polar,
    /// The mechanism in motion.
    Animation,
}

pub const KINDS: [Kind; 21] = [
    Kind::Scheme,
    Kind::Velocities,
    Kind::Accelerations,
    Kind::Forces,
    Kind::Lever,
    Kind::Axial,
    Kind::Curvature,
    Kind::Friction,
    Kind::Train,
    Kind::Plot,
    Kind::Work,
    Kind::Fourier,
    Kind::Internal,
    Kind::Planes,
    Kind::Equilibrium,
    Kind::Cam,
    Kind::Gears,
    Kind::Elements,
    Kind::Hodograph,
    Kind::Polar,
    Kind::Animation,
];

/// How pictures are drawn.
#[derive(Clone, Debug, Default)]
pub struct Options {
    pub scheme: Scheme,
    /// The items of `find` that are plotted, by index; all that change where there are none.
    pub plotted: Vec<usize>,
    /// The point of a hodograph, the pair of a polar diagram; all that the file asks for where it is empty.
    pub of: String,
    /// How many frames an animation has, where that is wanted; then all positions of the scene's way are frames.
    pub frames: Option<usize>,
    /// The frames have all effects of the plan: an animation gets arrows.
    pub arrows: bool,
    /// The arrows that it shows first.
    pub shown: Option<ArrowKind>,
}

impl Kind {
    /// Its name on the command line and in file names.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Scheme => "scheme",
            Self::Velocities => "velocities",
            Self::Accelerations => "accelerations",
            Self::Forces => "forces",
            Self::Lever => "lever",
            Self::Axial => "axial",
            Self::Curvature => "curvature",
            Self::Friction => "friction",
            Self::Train => "train",
            Self::Plot => "plot",
            Self::Work => "work",
            Self::Fourier => "fourier",
            Self::Internal => "internal",
            Self::Planes => "planes",
            Self::Equilibrium => "equilibrium",
            Self::Cam => "cam",
            Self::Gears => "gears",
            Self::Elements => "elements",
            Self::Hodograph => "hodograph",
            Self::Polar => "polar",
            Self::Animation => "animation",
        }
    }

    /// What it is made from.
    #[must_use]
    pub const fn needs(self) -> Needs {
        let (place, level, forces) = match self {
            Self::Cam => (Place::Any, Level::Positions, false),
            Self::Gears | Self::Elements => (Place::File, Level::Positions, false),
            Self::Scheme | Self::Curvature | Self::Train | Self::Planes | Self::Equilibrium => {
                (Place::Pose, Level::Positions, false)
            }
            Self::Velocities => (Place::Pose, Level::Velocities, false),
            Self::Accelerations => (Place::Pose, Level::Accelerations, false),
            Self::Forces | Self::Axial | Self::Internal => (Place::Pose, Level::Positions, true),
            Self::Lever | Self::Friction => (Place::Pose, Level::Velocities, true),
            Self::Plot | Self::Work | Self::Fourier | Self::Animation => {
                (Place::Way, Level::Positions, false)
            }
            Self::Hodograph => (Place::Way, Level::Velocities, false),
            Self::Polar => (Place::Way, Level::Positions, true),
        };
        Needs { place, level, forces }
    }

    /// Whether lengths in it stand for a kind of quantity; those of a scheme for forces where it shows numbers.
    #[must_use]
    pub const fn has_scale(self, of: Scaled) -> bool {
        match of {
            Scaled::Length => {
                matches!(
                    self,
                    Self::Scheme
                        | Self::Forces
                        | Self::Axial
                        | Self::Curvature
                        | Self::Friction
                        | Self::Cam
                        | Self::Gears
                        | Self::Animation
                )
            }
            Scaled::Velocity => matches!(self, Self::Velocities | Self::Lever | Self::Hodograph),
            Scaled::Acceleration => matches!(self, Self::Accelerations),
            Scaled::Force => matches!(self, Self::Forces | Self::Polar),
        }
    }

    /// Whether the space that it takes is chosen: diagrams and sections have their own.
    #[must_use]
    pub const fn has_size(self) -> bool {
        !matches!(
            self,
            Self::Train
                | Self::Plot
                | Self::Work
                | Self::Fourier
                | Self::Internal
                | Self::Planes
                | Self::Equilibrium
                | Self::Elements
        )
    }

    /// Whether its name may be followed by what it shows.
    #[must_use]
    pub const fn names_something(self) -> bool {
        matches!(self, Self::Plot | Self::Hodograph | Self::Polar)
    }

    /// The kind of a name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        KINDS.into_iter().find(|kind| kind.name() == name)
    }
}

/// What a kind of picture is made from.
#[derive(Clone, Copy, Debug)]
pub struct Needs {
    pub place: Place,
    /// How far motion must be followed.
    pub level: Level,
    /// It shows forces.
    pub forces: bool,
}

/// The positions that a picture shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// None.
    File,
    /// One, where there is one: cams are drawn as they are designed else.
    Any,
    /// One.
    Pose,
    /// The whole sweep, once.
    Way,
}

impl Place {
    /// Whether there is no picture without one.
    #[must_use]
    pub const fn is_needed(self) -> bool {
        matches!(self, Self::Pose | Self::Way)
    }

    /// Whether each position has its own picture.
    #[must_use]
    pub const fn is_of_position(self) -> bool {
        matches!(self, Self::Any | Self::Pose)
    }
}

impl Subject<'_, '_> {
    /// The kinds that a file has, by what it declares; nothing is drawn for it.
    #[must_use]
    pub fn kinds(&self) -> Vec<Kind> {
        KINDS.into_iter().filter(|kind| self.has(*kind)).collect()
    }

    /// The kind that is drawn where none is named: the scheme, where there is a position.
    #[must_use]
    pub fn first_kind(&self) -> Option<Kind> {
        KINDS.into_iter().find(|kind| self.has(*kind))
    }

    fn has(&self, kind: Kind) -> bool {
        let mechanism = self.mechanism;
        match kind {
            Kind::Cam => return !mechanism.cams.is_empty(),
            Kind::Gears => return !mechanism.gears.is_empty(),
            Kind::Elements => return !mechanism.formulas.is_empty(),
            _ => {}
        }
        let Some(scene) = self.scene else { return false };
        let is_motion = mechanism.simulation.is_some();
        let is_swept = || is_motion || courses(&scene.model, scene.solution, &[]).is_ok();
        match kind {
            Kind::Scheme | Kind::Animation => true,
            Kind::Velocities => motion::with_velocities(scene).is_ok(),
            Kind::Accelerations => motion::with_accelerations(scene).is_ok(),
            Kind::Forces => forces::freed(scene).is_ok(),
            Kind::Lever => forces::levered(scene).is_ok(),
            Kind::Axial => !mechanism.bars.is_empty(),
            Kind::Curvature => !circles(scene, 0.0).is_empty(),
            Kind::Friction => frictions(scene).is_ok(),
            Kind::Train => has_train(scene),
            Kind::Plot => !items(scene, &[]).is_empty() && is_swept(),
            Kind::Work => !mechanism.flywheels.is_empty() && !is_motion && is_swept(),
            Kind::Fourier => !all_series(scene).is_empty(),
            Kind::Internal => !mechanism.asked_inside().is_empty(),
            Kind::Planes => rotors(scene).next().is_some(),
            Kind::Equilibrium => mechanism.equilibria.first().is_some_and(|found| found.sought.is_some()),
            Kind::Cam | Kind::Gears | Kind::Elements => true,
            Kind::Hodograph => points_asked(scene).is_ok_and(|all| !all.is_empty()) && is_swept(),
            Kind::Polar => reactions_asked(scene).is_ok_and(|all| !all.is_empty()) && is_swept(),
        }
    }
}

/// The pictures of a kind.
///
/// # Errors
/// What the file does not declare.
pub fn draw<'s, 'a: 's>(
    kind: Kind,
    of: impl Into<Subject<'s, 'a>>,
    options: &Options,
) -> Result<Vec<Drawing>, Diagnosis> {
    let (subject, paper) = (of.into(), &options.scheme.paper());
    match kind {
        Kind::Cam => return cams(&subject, paper),
        Kind::Gears => return gears(&subject, paper),
        Kind::Elements => return elements(&subject),
        _ => {}
    }
    let Some(scene) = subject.scene else { return Err(error::no_position(&subject, None)) };
    match kind {
        Kind::Scheme => scheme_or_section(scene, options).map(|scheme| vec![scheme]),
        Kind::Train => train(scene).map(|section| vec![section]),
        Kind::Hodograph => hodographs(scene, &options.of, paper),
        Kind::Polar => polars(scene, &options.of, paper),
        Kind::Animation => still(scene, options).map(|first| vec![first]),
        Kind::Work => work(scene),
        Kind::Fourier => fourier(scene),
        Kind::Internal => internal(scene),
        Kind::Planes => planes(scene),
        Kind::Equilibrium => equilibrium(scene).map(|energy| vec![energy]),
        Kind::Plot => plot(scene, &options.plotted).map(|(plot, _)| vec![plot]),
        Kind::Velocities => velocities(scene, paper).map(|plan| vec![plan]),
        Kind::Accelerations => accelerations(scene, paper).map(|plan| vec![plan]),
        Kind::Forces => forces(scene, paper),
        Kind::Friction => friction(scene, paper).map(|picture| vec![picture]),
        Kind::Lever => lever(scene, paper).map(|lever| vec![lever]),
        Kind::Axial => axial(scene, &options.scheme).map(|bars| vec![bars]),
        Kind::Curvature => curvature(scene, &options.scheme).map(|circles| vec![circles]),
        Kind::Cam | Kind::Gears | Kind::Elements => Ok(Vec::new()),
    }
}

/// The scheme; of shafts that have no place the section.
fn scheme_or_section(scene: &Scene<'_>, options: &Options) -> Result<Drawing, Diagnosis> {
    let placed = (1..scene.mechanism().links.len()).any(|i| scene.is_placed(LinkId::at(i)));
    if placed { scheme(scene, &options.scheme) } else { train(scene) }
}
