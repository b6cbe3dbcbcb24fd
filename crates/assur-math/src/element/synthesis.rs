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

#[cfg(test)]
mod tests {
    use super::*;

    fn degrees(x: f64) -> f64 {
        x.to_radians()
    }

    #[test]
    fn the_shaper_of_the_course_project() {
        let found = guide_bar(0.6, 1.8, 0.37).expect("it exists");
        assert!((found.swing - degrees(360.0 / 7.0)).abs() < 1e-15);
        assert!((found.bar - 0.691_429_461_288_745_9).abs() < 1e-15);
        assert!((found.crank - 0.160_536_983_473_496_51).abs() < 1e-15);
        assert!((found.guide - 0.657_192_940_130_223_4).abs() < 1e-15);
        assert!(matches!(guide_bar(0.6, 1.0, 0.37), Err(Impossible::TimeRatio { .. })));
    }

    /// The ends of the stroke from the lengths: r + l and l − r from the crank's centre.
    #[test]
    fn a_crank_slider_has_its_stroke_and_its_time_ratio() {
        for (stroke, offset, ratio) in [(0.3, 0.05, 1.2), (0.5, 0.1, 1.4), (0.05, 0.02, 1.25)] {
            let found = crank_slider(stroke, offset, ratio).expect("it exists");
            let (near, far) = (found.rod - found.crank, found.rod + found.crank);
            let (x_1, x_2) = ((near * near - offset * offset).sqrt(), (far * far - offset * offset).sqrt());
            assert!((x_2 - x_1 - stroke).abs() < 1e-14, "{found:?}");
            let theta = libm::asin(offset / near) - libm::asin(offset / far);
            assert!(((PI + theta) / (PI - theta) - ratio).abs() < 1e-13, "{found:?}");
        }
        assert!(matches!(crank_slider(0.3, 0.9, 1.4), Err(Impossible::Offset { .. })));
        assert!(matches!(crank_slider(0.3, 0.1, 0.9), Err(Impossible::TimeRatio { .. })));
    }

    /// Swing and angle of the crank between the dead positions from the lengths, by the law of cosines.
    #[test]
    fn a_crank_rocker_has_its_swing_and_its_time_ratio() {
        for (c, swing, ratio, d) in
            [(0.3, 40.0, 1.0, 0.5), (0.3, 50.0, 1.25, 0.31), (0.5, 60.0, 1.1, 0.7), (0.3, 30.0, 1.4, 0.2)]
        {
            let found = crank_rocker(c, degrees(swing), ratio, d).expect("it exists");
            let (near, far) = (found.coupler - found.crank, found.coupler + found.crank);
            let at = |x: f64, y: f64, opposite: f64| {
                libm::acos((x * x + y * y - opposite * opposite) / (2.0 * x * y))
            };
            let got = at(c, d, far) - at(c, d, near);
            assert!((got.abs() - degrees(swing)).abs() < 1e-13, "{found:?} {got}");
            let theta = (at(near, d, c) - at(far, d, c)).abs();
            assert!(((PI + theta) / (PI - theta) - ratio).abs() < 1e-13, "{found:?}");
        }
        assert!(matches!(crank_rocker(0.3, degrees(40.0), 1.25, 5.0), Err(Impossible::Ground { .. })));
        assert!(matches!(crank_rocker(0.3, degrees(190.0), 1.25, 0.4), Err(Impossible::NotPositive { .. })));
        assert!(crank_rocker(0.3, degrees(40.0), 1.25, 0.05).is_err());
    }
}
