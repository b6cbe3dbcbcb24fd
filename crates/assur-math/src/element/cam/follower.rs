//! What a cam moves.

/// The end of a follower that touches the cam.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    Knife,
    /// A roller of this radius, m.
    Roller(f64),
    /// A flat face; that of a translating follower stands across its way.
    Flat,
}

/// A follower. Angles in rad, lengths in m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Follower {
    /// It moves along a line.
    Translating {
        shape: Shape,
        /// Distance of the line of the knife edge or roller centre from the cam's centre; positive on that side on which
        /// it lessens the pressure angle of the rise.
        offset: f64,
    },
    /// It turns about a pivot.
    Oscillating {
        shape: Shape,
        /// Distance of the knife edge or roller centre from the pivot; of no meaning for a flat face.
        arm: f64,
        /// Distance of the pivot from the cam's centre.
        pivot_distance: f64,
        /// The rise turns the follower in the sense of the cam.
        with_cam: bool,
        /// Distance of a flat face from the pivot, positive towards the cam.
        offset: f64,
    },
}

impl Follower {
    #[must_use]
    pub const fn shape(&self) -> Shape {
        match self {
            Self::Translating { shape, .. } | Self::Oscillating { shape, .. } => *shape,
        }
    }

    /// Whether its lift is an angle.
    #[must_use]
    pub const fn oscillates(&self) -> bool {
        matches!(self, Self::Oscillating { .. })
    }
}

impl Shape {
    /// Radius of the roller, m; zero for a knife edge and a face.
    #[must_use]
    pub const fn radius(self) -> f64 {
        match self {
            Self::Roller(r) => r,
            Self::Knife | Self::Flat => 0.0,
        }
    }
}
