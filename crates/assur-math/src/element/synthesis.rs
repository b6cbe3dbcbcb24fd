//! Lengths of a mechanism from what it is to do: stroke or swing, and the ratio K of the times of both ways.
//!
//! A crank that turns evenly takes the longer way in the time of 180° + θ and the shorter in that of 180° − θ, so that
//! K = (180° + θ)/(180° − θ) and θ = 180° (K − 1)/(K + 1): the angle between the crank's two dead positions, less 180°.
//! In the language the same formulas are `let`: see `examples/synthesis`.
#![allow(non_snake_case, reason = "names carry the notation of the field: p_A")]

use crate::math::Vec2;
use std::f64::consts::PI;
use thiserror::Error;

/// Why there is no such mechanism.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum Impossible {
    /// A length, a swing or a ratio that is not positive and finite.
    #[error("{what} must be greater than zero, it is {value}")]
    NotPositive {
        /// What it is.
        what: &'static str,
        /// Its value, SI.
        value: f64,
    },
    /// A time ratio that this mechanism does not have.
    #[error("the time ratio must be {needed}, it is {ratio}")]
    TimeRatio {
        /// The ratio.
        ratio: f64,
        /// What it would have to be.
        needed: &'static str,
    },
    /// The offset is too large for stroke and time ratio.
    #[error("with an offset of {offset} m there is no crank: it must be less than {limit} m")]
    Offset {
        /// The offset, m.
        offset: f64,
        /// The offset at which the crank has no length left, m.
        limit: f64,
    },
    /// The ground link is too short or too long for swing and time ratio.
    #[error(
        "with a ground link of {ground} m there is no crank: it must lie between {least} m and {greatest} m"
    )]
    Ground {
        /// The ground link, m.
        ground: f64,
        /// The least, m.
        least: f64,
        /// The greatest, m.
        greatest: f64,
    },
    /// The lengths follow, but the crank does not turn fully.
    #[error("the crank of {crank} m cannot turn fully")]
    DoesNotTurn {
        /// The crank, m.
        crank: f64,
    },
}

/// A crank with a slotted bar that drives a ram by a rod.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GuideBar {
    /// Swing of the bar ψ, rad.
    pub swing: f64,
    /// Crank O2A, m.
    pub crank: f64,
    /// Bar O3B, m.
    pub bar: f64,
    /// Height of the ram's guide above O3, m: the middle of the arc's rise, where pressure angles are least.
    pub guide: f64,
}

/// A crank-slider with its guide beside the crank's centre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CrankSlider {
    /// Crank, m.
    pub crank: f64,
    /// Rod, m.
    pub rod: f64,
    /// Least angle between rod and the guide's normal, rad.
    pub transmission: f64,
}

/// A four-bar whose crank turns and whose rocker swings.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CrankRocker {
    /// Crank, m.
    pub crank: f64,
    /// Coupler, m.
    pub coupler: f64,
    /// Least transmission angle, rad.
    pub transmission: f64,
}

/// θ = π (K − 1)/(K + 1), rad, of a time ratio K ≥ 1.
///
/// # Errors
/// A ratio below 1.
pub fn advance(time_ratio: f64) -> Result<f64, Impossible> {
    if !(time_ratio.is_finite() && time_ratio >= 1.0) {
        return Err(Impossible::TimeRatio {
            ratio: time_ratio,
            needed: "1 or more, the longer way over the shorter",
        });
    }
    Ok(PI * (time_ratio - 1.0) / (time_ratio + 1.0))
}

/// A guide-bar mechanism from the ram's stroke H, the time ratio K and the distance of the centres O2O3.
///
/// The bar stands at its ends where the crank is perpendicular to it, so that its swing is ψ = θ:
/// O3B = H/(2 sin ψ/2), O2A = O2O3 sin ψ/2. The guide halves the rise of B's arc: O3M = O3B (1 + cos ψ/2)/2.
///
/// # Errors
/// Lengths that are not positive; a ratio of 1, at which the bar would have no end.
pub fn guide_bar(stroke: f64, time_ratio: f64, centres: f64) -> Result<GuideBar, Impossible> {
    positive("the stroke", stroke)?;
    positive("the distance of the centres", centres)?;
    let swing = advance(time_ratio)?;
    if swing == 0.0 {
        return Err(Impossible::TimeRatio {
            ratio: time_ratio,
            needed: "greater than 1: the bar swings by θ",
        });
    }
    let (sin, cos) = (libm::sin(0.5 * swing), libm::cos(0.5 * swing));
    let bar = stroke / (2.0 * sin);
    Ok(GuideBar { swing, crank: centres * sin, bar, guide: 0.5 * bar * (1.0 + cos) })
}

/// A crank-slider from its stroke H, the offset e of its guide and the time ratio K.
///
/// The crank's centre A sees both ends C1, C2 of the stroke under θ, at the distances l − r and l + r. Twice the area of
/// the triangle is H e = (l² − r²) sin θ; with the law of cosines H² = 2(l² + r²) − 2(l² − r²) cos θ follow
/// r = ½ √(H² − 2 H e tan θ/2) and l = ½ √(H² + 2 H e cot θ/2).
///
/// # Errors
/// Lengths that are not positive; a ratio of 1, which leaves the rod open; an offset at which no crank is left.
pub fn crank_slider(stroke: f64, offset: f64, time_ratio: f64) -> Result<CrankSlider, Impossible> {
    positive("the stroke", stroke)?;
    positive("the offset", offset)?;
    let half = 0.5 * advance(time_ratio)?;
    if half == 0.0 {
        return Err(Impossible::TimeRatio {
            ratio: time_ratio,
            needed: "greater than 1 where there is an offset",
        });
    }
    let tan = libm::tan(half);
    let limit = stroke / (2.0 * tan);
    if offset >= limit {
        return Err(Impossible::Offset { offset, limit });
    }
    let crank = 0.5 * (stroke * (stroke - 2.0 * offset * tan)).sqrt();
    let rod = 0.5 * (stroke * (stroke + 2.0 * offset / tan)).sqrt();
    // both ends of the stroke lie on the guide, so that l − r > e: the crank turns fully
    Ok(CrankSlider { crank, rod, transmission: libm::acos((crank + offset) / rod) })
}

/// A crank-rocker from the rocker's length c and swing ψ, the time ratio K and the length d of the ground link.
///
/// The crank's centre A sees the ends C1, C2 of the rocker's pin under θ: it lies on the circle of radius
/// h/sin θ, h = c sin ψ/2, through both, whose centre lies h cot θ below their middle, towards the rocker's centre D; and
/// at the distance d from D. AC1 = l − r, AC2 = l + r. With K = 1 the circle is the line C1C2: r = h,
/// l² = d² − c² cos² ψ/2.
///
/// # Errors
/// Lengths that are not positive, a swing that is not below 180°; a ground link that does not reach the circle; a crank
/// that cannot turn fully, or that swings the rocker to the other side.
pub fn crank_rocker(
    rocker: f64,
    swing: f64,
    time_ratio: f64,
    ground: f64,
) -> Result<CrankRocker, Impossible> {
    positive("the rocker", rocker)?;
    positive("the swing", swing)?;
    positive("the ground link", ground)?;
    if swing >= PI {
        return Err(Impossible::NotPositive { what: "what the swing lacks to 180°", value: PI - swing });
    }
    let theta = advance(time_ratio)?;
    let (h, height) = (rocker * libm::sin(0.5 * swing), rocker * libm::cos(0.5 * swing));
    let Some(p_A) = centre(h, height, theta, ground) else {
        let centre = if theta > 0.0 { height - h / libm::tan(theta) } else { height };
        let radius = if theta > 0.0 { h / libm::sin(theta) } else { 0.0 };
        let least = if theta > 0.0 { (centre.abs() - radius).abs() } else { centre };
        let greatest = if theta > 0.0 { centre.abs() + radius } else { f64::INFINITY };
        return Err(Impossible::Ground { ground, least, greatest });
    };
    let (near, far) = (Vec2::new(-h, height) - p_A, Vec2::new(h, height) - p_A);
    let crank = 0.5 * (far.norm() - near.norm());
    let coupler = 0.5 * (far.norm() + near.norm());
    // Grashof: the crank is the shortest link, and with the longest shorter than the other two
    let lengths = [crank, coupler, rocker, ground];
    let longest = lengths.iter().copied().fold(0.0, f64::max);
    let turns = crank > 0.0 && 2.0 * (crank + longest) < lengths.iter().sum();
    // both ends lie on one side of the ground link
    let one_side = p_A.cross(near) * p_A.cross(far) > 0.0;
    if !(turns && one_side) {
        return Err(Impossible::DoesNotTurn { crank });
    }
    let angle = |d: f64| {
        let cos = (coupler * coupler + rocker * rocker - d * d) / (2.0 * coupler * rocker);
        libm::acos(cos.abs().min(1.0))
    };
    let transmission = angle(ground - crank).min(angle(ground + crank));
    Ok(CrankRocker { crank, coupler, transmission })
}

/// The crank's centre on the left of the rocker's, where there is one.
fn centre(h: f64, height: f64, theta: f64, ground: f64) -> Option<Vec2> {
    if theta == 0.0 {
        let along = ground * ground - height * height;
        return (along > h * h).then(|| Vec2::new(-along.sqrt(), height));
    }
    let (middle, radius) = (height - h / libm::tan(theta), h / libm::sin(theta));
    let y = (ground * ground + middle * middle - radius * radius) / (2.0 * middle);
    let square = ground * ground - y * y;
    // below C1C2, where the arc is that sees them under θ
    (square > 0.0 && y < height).then(|| Vec2::new(-square.sqrt(), y))
}

fn positive(what: &'static str, value: f64) -> Result<(), Impossible> {
    if value.is_finite() && value > 0.0 { Ok(()) } else { Err(Impossible::NotPositive { what, value }) }
}
