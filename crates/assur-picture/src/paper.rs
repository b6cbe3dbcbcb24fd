//! The space that a picture has, and the scale factors that are wanted for it.

use assur_drawing::{Rect, Scale};
use assur_math::math::Vec2;
use assur_text::diagnostic::Diagnosis;

/// What has a scale factor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scaled {
    /// Lengths, m/mm.
    Length,
    /// Velocities, (m/s)/mm.
    Velocity,
    /// Accelerations, (m/s²)/mm.
    Acceleration,
    /// Forces, N/mm.
    Force,
}

pub const SCALED: [Scaled; 4] = [Scaled::Length, Scaled::Velocity, Scaled::Acceleration, Scaled::Force];

/// With a greater factor than this many times the fitting one nothing can be seen.
const COARSE: f64 = 50.0;

impl Scaled {
    /// Its name on the command line.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Length => "length",
            Self::Velocity => "velocity",
            Self::Acceleration => "acceleration",
            Self::Force => "force",
        }
    }

    const fn per_mm(self) -> &'static str {
        match self {
            Self::Length => "m/mm",
            Self::Velocity => "(m/s)/mm",
            Self::Acceleration => "(m/s²)/mm",
            Self::Force => "N/mm",
        }
    }

    #[must_use]
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Length => "m",
            Self::Velocity => "m/s",
            Self::Acceleration => "m/s²",
            Self::Force => "N",
        }
    }
}

/// Scale factors that are wanted; the smallest that fits where there is none.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Scales([Option<Scale>; 4]);

impl Scales {
    /// With a factor for what it is of.
    #[must_use]
    pub const fn with(mut self, of: Scaled, scale: Scale) -> Self {
        self.0[of as usize] = Some(scale);
        self
    }

    /// The factor that is wanted, where there is one.
    #[must_use]
    pub const fn wanted(&self, of: Scaled) -> Option<Scale> {
        self.0[of as usize]
    }

    /// The factor that is wanted instead of the smallest that fits; none where nothing has an extent.
    ///
    /// # Errors
    /// The picture would be larger than its space, or too small to be seen.
    pub fn chosen(&self, of: Scaled, fitting: Option<Scale>) -> Result<Option<Scale>, Diagnosis> {
        let (Some(wanted), Some(fitting)) = (self.wanted(of), fitting) else { return Ok(fitting) };
        let share = wanted.factor() / fitting.factor();
        // NaN would be no share either
        if (1.0 - 1e-9..=COARSE).contains(&share) {
            return Ok(Some(wanted));
        }
        let (what, unit, least) = (of.name(), of.per_mm(), fitting.text());
        let why = if share < 1.0 { "the picture is larger than its space" } else { "nothing can be seen" };
        Err(Diagnosis::error(
            "mech::picture::no_scale",
            format!("the scale {what} = {} {unit} does not fit: {why}", wanted.text()),
        )
        .help(format!("the smallest that fits is {least} {unit}: `--scale {what}={}`", fitting.written())))
    }
}

/// The space of a picture.
#[derive(Clone, Copy, Debug)]
pub struct Paper {
    /// The most that the mechanism or the plan takes, mm.
    pub size: Vec2,
    /// It may take more where much is close together.
    pub grows: bool,
    /// Scale factors that are wanted.
    pub scales: Scales,
}

impl Paper {
    /// The frame for a box, without what symbols and labels take around it.
    ///
    /// # Errors
    /// A scale is wanted that does not fit.
    pub fn frame(&self, of: Scaled, bounds: &Rect, around: Vec2) -> Result<Frame, Diagnosis> {
        let fitting = Frame::fitting(bounds, self.size - around);
        Ok(Frame::new(self.scales.chosen(of, fitting.scale)?, fitting.origin))
    }

    /// As [`Paper::frame`], of vectors from the origin.
    ///
    /// # Errors
    /// A scale is wanted that does not fit.
    pub fn plan(&self, of: Scaled, bounds: &Rect, around: Vec2) -> Result<Frame, Diagnosis> {
        Ok(Frame::new(self.frame(of, bounds, around)?.scale, Vec2::zero()))
    }
}

// From the ground's axes to paper.

/// Where the ground's axes lie on paper.
#[derive(Clone, Copy, Debug)]
pub struct Frame {
    /// Length per millimetre, m; none where nothing has an extent.
    pub scale: Option<Scale>,
    /// The point of the ground at the origin of the paper, m.
    pub origin: Vec2,
    /// The factor of the scale.
    factor: f64,
}

impl Frame {
    /// The smallest scale factor with which a box of the ground, m, fits into a size, mm.
    #[must_use]
    pub fn fitting(bounds: &Rect, size: Vec2) -> Self {
        let extent = bounds.size();
        let across = Scale::fitting(extent.x, size.x);
        let up = Scale::fitting(extent.y, size.y);
        let scale = match (across, up) {
            (Some(a), Some(b)) => Some(if a.factor() >= b.factor() { a } else { b }),
            (a, b) => a.or(b),
        };
        let origin = if bounds.is_nothing() { Vec2::zero() } else { bounds.centre() };
        Self::new(scale, origin)
    }

    /// With a scale and an origin.
    #[must_use]
    pub fn new(scale: Option<Scale>, origin: Vec2) -> Self {
        Self { scale, origin, factor: scale.map_or(1.0, |s| s.factor()) }
    }

    /// With a factor, m/mm, that no scale bar shows.
    #[must_use]
    pub const fn of_unit(factor: f64, origin: Vec2) -> Self {
        Self { scale: None, origin, factor }
    }

    /// A point of the ground on paper, mm.
    #[must_use]
    pub fn point(&self, at: Vec2) -> Vec2 {
        let d = at - self.origin;
        Vec2::new(d.x / self.factor, -d.y / self.factor)
    }

    /// A length on paper, mm.
    #[must_use]
    pub fn length(&self, l: f64) -> f64 {
        l / self.factor
    }
}

impl Frame {
    /// A length of the ground that is one millimetre of paper, m.
    #[must_use]
    pub const fn unit(&self) -> f64 {
        self.factor
    }
}
