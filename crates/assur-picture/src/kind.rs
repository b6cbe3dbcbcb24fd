//! The kinds of picture, by name.

use crate::animation::{ArrowKind, still};
use crate::cam::cams;
use crate::equilibrium::equilibrium;
use crate::forces::{forces, friction, lever};
use crate::fourier::fourier;
use crate::hodograph::{hodographs, polars};
use crate::internal::internal;
use crate::motion::{accelerations, velocities};
use crate::paper::Scaled;
use crate::planes::planes;
use crate::plot::plot;
use crate::scene::Scene;
use crate::scheme::{Scheme, axial, curvature, scheme};
use crate::train::train;
use crate::work::work;
use assur_drawing::Drawing;
use assur_model::model::{Level, LinkId};
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
    /// Velocities of a point over the sweep.
    Hodograph,
    /// Reactions in a pair over the sweep.
    Polar,
    /// The mechanism in motion.
    Animation,
}

pub const KINDS: [Kind; 19] = [
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
            Self::Hodograph => "hodograph",
            Self::Polar => "polar",
            Self::Animation => "animation",
        }
    }

    /// How far motion must be followed for it.
    #[must_use]
    pub const fn level(self) -> Level {
        match self {
            Self::Scheme
            | Self::Forces
            | Self::Axial
            | Self::Curvature
            | Self::Train
            | Self::Plot
            | Self::Work
            | Self::Fourier
            | Self::Internal
            | Self::Planes
            | Self::Equilibrium
            | Self::Cam
            | Self::Polar
            | Self::Animation => Level::Positions,
            Self::Velocities | Self::Lever | Self::Friction | Self::Hodograph => Level::Velocities,
            Self::Accelerations => Level::Accelerations,
        }
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
        )
    }

    /// Whether it shows forces.
    #[must_use]
    pub const fn forces(self) -> bool {
        matches!(
            self,
            Self::Forces | Self::Lever | Self::Axial | Self::Internal | Self::Friction | Self::Polar
        )
    }

    /// Whether it shows the whole sweep and not one position.
    #[must_use]
    pub const fn is_of_sweep(self) -> bool {
        matches!(
            self,
            Self::Plot | Self::Work | Self::Fourier | Self::Hodograph | Self::Polar | Self::Animation
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

/// The pictures of a kind at a position.
///
/// # Errors
/// What the file does not declare.
pub fn draw(kind: Kind, scene: &Scene<'_>, options: &Options) -> Result<Vec<Drawing>, Diagnosis> {
    let paper = &options.scheme.paper();
    match kind {
        Kind::Scheme => scheme_or_section(scene, options).map(|scheme| vec![scheme]),
        Kind::Train => train(scene).map(|section| vec![section]),
        Kind::Cam => cams(scene, paper),
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
    }
}

/// The scheme; of shafts that have no place the section.
fn scheme_or_section(scene: &Scene<'_>, options: &Options) -> Result<Drawing, Diagnosis> {
    let placed = (1..scene.mechanism().links.len()).any(|i| scene.is_placed(LinkId::at(i)));
    if placed { scheme(scene, &options.scheme) } else { train(scene) }
}
