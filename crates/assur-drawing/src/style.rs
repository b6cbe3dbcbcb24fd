//! Kinds of stroke. Colour never stands alone: widths, dashes and hatching tell apart what colours tell apart.

use crate::label::Role;

/// How a mark is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Style {
    Link,
    /// A bar in tension.
    Pulled,
    /// A bar in compression: wider.
    Pushed,
    Medium,
    /// Hatching, arcs of angles, dimensions, leader lines.
    Thin,
    Ghost,
    /// Lines of a grid.
    Grid,
    Axis,
    /// A dashed line of the construction.
    Dashed,
    /// The path of a point.
    Way,
    /// A hinge, filled with paper.
    Hinge,
    /// The circle of a mass centre.
    Centre,
    Solid,
    /// A block, filled with paper.
    Block,
    /// A circle with a place magnified in it.
    Inset,
    /// A link with three joints and more, a cam: outline and tint.
    Plate,
    Velocity,
    VelocityPart,
    Acceleration,
    /// A normal or a Coriolis part.
    AccelerationPart,
    /// A tangential or a sliding part.
    AccelerationTangent,
    Force,
    /// An unknown effort or reaction.
    Unknown,
    /// A part of it.
    UnknownPart,
    Drive,
    FrictionCircle,
    /// An area of want.
    Want,
    /// An area of surplus.
    Surplus,
    /// Hatching of an area.
    Hatch,
    /// Curves of a diagram, in their order: each has its own dashes.
    Curve1,
    Curve2,
    Curve3,
    Curve4,
    Curve5,
    Curve6,
    /// The circle around the number of a link.
    Number,
    /// Filled with the colour of velocities.
    BlueDot,
    /// Filled with the colour of accelerations.
    VermilionDot,
    /// Filled with the colour of unknown forces.
    GreenDot,
}

/// Styles of curves, in their order.
pub const CURVES: [Style; 6] =
    [Style::Curve1, Style::Curve2, Style::Curve3, Style::Curve4, Style::Curve5, Style::Curve6];

/// All of them, in the order of their rules.
pub const STYLES: [Style; 39] = [
    Style::Link,
    Style::Pulled,
    Style::Pushed,
    Style::Medium,
    Style::Thin,
    Style::Ghost,
    Style::Grid,
    Style::Axis,
    Style::Dashed,
    Style::Way,
    Style::Hinge,
    Style::Centre,
    Style::Solid,
    Style::Block,
    Style::Inset,
    Style::Plate,
    Style::Velocity,
    Style::VelocityPart,
    Style::Acceleration,
    Style::AccelerationPart,
    Style::AccelerationTangent,
    Style::Force,
    Style::Unknown,
    Style::UnknownPart,
    Style::Drive,
    Style::FrictionCircle,
    Style::Want,
    Style::Surplus,
    Style::Hatch,
    Style::Curve1,
    Style::Curve2,
    Style::Curve3,
    Style::Curve4,
    Style::Curve5,
    Style::Curve6,
    Style::Number,
    Style::BlueDot,
    Style::VermilionDot,
    Style::GreenDot,
];

/// What a style comes to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Paint {
    /// The class in the document.
    pub class: &'static str,
    /// Colour and width of the stroke, mm.
    pub stroke: Option<(Role, f64)>,
    pub fill: Option<Role>,
    /// Dashes and gaps, mm.
    pub dashes: &'static str,
    /// How much of its colour there is.
    pub opacity: f64,
}

const fn stroke(class: &'static str, role: Role, width: f64) -> Paint {
    Paint { class, stroke: Some((role, width)), fill: None, dashes: "", opacity: 1.0 }
}

const fn filled(class: &'static str, role: Role, width: f64, fill: Role) -> Paint {
    Paint { fill: Some(fill), ..stroke(class, role, width) }
}

const fn area(class: &'static str, fill: Role) -> Paint {
    Paint { class, stroke: None, fill: Some(fill), dashes: "", opacity: 1.0 }
}

const fn dashed(class: &'static str, role: Role, width: f64, dashes: &'static str) -> Paint {
    Paint { dashes, ..stroke(class, role, width) }
}

impl Style {
    /// Colours, widths and dashes.
    #[must_use]
    pub const fn paint(self) -> Paint {
        match self {
            Self::Link => stroke("l", Role::Ink, 0.7),
            Self::Pulled => stroke("lp", Role::Blue, 0.7),
            Self::Pushed => stroke("lc", Role::Vermilion, 1.3),
            Self::Medium => stroke("m", Role::Ink, 0.45),
            Self::Thin => stroke("t", Role::Ink, 0.22),
            Self::Ghost => Paint { opacity: 0.8, ..stroke("g", Role::Grey, 0.3) },
            Self::Grid => Paint { opacity: 0.55, ..stroke("gr", Role::Grey, 0.18) },
            Self::Axis => dashed("ax", Role::Grey, 0.2, "5 1 1 1"),
            Self::Dashed => dashed("da", Role::Ink, 0.28, "1.6 1"),
            Self::Way => dashed("pa", Role::Grey, 0.3, "2.2 1"),
            Self::Hinge => filled("h", Role::Ink, 0.45, Role::Paper),
            Self::Centre => filled("c", Role::Ink, 0.3, Role::Paper),
            Self::Solid => area("k", Role::Ink),
            Self::Block => filled("b", Role::Ink, 0.5, Role::Paper),
            Self::Inset => filled("in", Role::Ink, 0.35, Role::Paper),
            Self::Plate => filled("tern", Role::Ink, 0.6, Role::Tint),
            Self::Velocity => stroke("v", Role::Blue, 0.5),
            Self::VelocityPart => stroke("v2", Role::Blue, 0.3),
            Self::Acceleration => stroke("a", Role::Vermilion, 0.5),
            Self::AccelerationPart => stroke("a3", Role::Vermilion, 0.3),
            Self::AccelerationTangent => dashed("a2", Role::Vermilion, 0.32, "1.8 .9"),
            Self::Force => stroke("f", Role::Ink, 0.5),
            Self::Unknown => stroke("r", Role::Green, 0.66),
            Self::UnknownPart => dashed("r2", Role::Green, 0.32, "1.8 .9"),
            Self::Drive => stroke("dr", Role::Blue, 0.38),
            Self::FrictionCircle => {
                Paint { dashes: "1.2 .7", ..filled("fc", Role::Vermilion, 0.35, Role::VermilionTint) }
            }
            Self::Want => area("A1", Role::BlueTint),
            Self::Surplus => area("A2", Role::VermilionTint),
            Self::Hatch => stroke("ha", Role::Vermilion, 0.15),
            Self::Curve1 => stroke("q1", Role::Ink, 0.6),
            Self::Curve2 => dashed("q2", Role::Blue, 0.55, "4 1"),
            Self::Curve3 => dashed("q3", Role::Vermilion, 0.55, "1.5 .8"),
            Self::Curve4 => dashed("q4", Role::Green, 0.55, "5 1 1 1"),
            Self::Curve5 => dashed("q5", Role::Grey, 0.7, ".7 .9"),
            Self::Curve6 => dashed("q6", Role::Ink, 0.35, "3 .8 .8 .8 .8 .8"),
            Self::Number => filled("n0", Role::Ink, 0.22, Role::Paper),
            Self::BlueDot => area("kv", Role::Blue),
            Self::VermilionDot => area("ka", Role::Vermilion),
            Self::GreenDot => area("kr", Role::Green),
        }
    }

    /// What no label may touch: links, hinges, outlines, vectors. Labels may cross the rest at a price.
    #[must_use]
    pub const fn is_solid(self) -> bool {
        !matches!(
            self,
            Self::Thin
                | Self::Ghost
                | Self::Grid
                | Self::Axis
                | Self::Dashed
                | Self::Way
                | Self::Want
                | Self::Surplus
                | Self::Hatch
                | Self::Number
        )
    }

    /// Half the width of its stroke, mm.
    #[must_use]
    pub fn half_width(self) -> f64 {
        self.paint().stroke.map_or(0.0, |(_, width)| 0.5 * width)
    }

    /// The colour of what is written about it.
    #[must_use]
    pub const fn text_role(self) -> Role {
        match self.paint().stroke {
            Some((role, _)) => role,
            None => Role::Ink,
        }
    }
}
