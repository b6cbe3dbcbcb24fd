//! Contrast after WCAG 2, and whether what stands for different things is told apart without seeing all colours, or any.

use assur_drawing::{CURVES, Palette, Role, STYLES, Style};

const PALETTES: [Palette; 4] = [Palette::LIGHT, Palette::DARK, Palette::PRINT, Palette::MONO];
const COLOURED: [Palette; 3] = [Palette::LIGHT, Palette::DARK, Palette::PRINT];

/// Red, green and blue as amounts of light.
type Light = [f64; 3];

fn light(colour: &str) -> Light {
    let digits: Vec<u32> = colour[1..].chars().filter_map(|c| c.to_digit(16)).collect();
    let parts: Vec<f64> = match digits.as_slice() {
        [r, g, b] => [r, g, b].map(|d| f64::from(d * 17)).to_vec(),
        all => all.chunks(2).map(|d| f64::from(d[0] * 16 + d[1])).collect(),
    };
    [0, 1, 2].map(|i| {
        let c = parts[i] / 255.0;
        if c <= 0.04045 { c / 12.92 } else { libm::pow((c + 0.055) / 1.055, 2.4) }
    })
}

fn luminance(c: Light) -> f64 {
    0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]
}

fn contrast(a: Light, b: Light) -> f64 {
    let (a, b) = (luminance(a), luminance(b));
    (a.max(b) + 0.05) / (a.min(b) + 0.05)
}

/// A colour over another, mixed as the screen mixes them.
fn over(colour: &str, paper: &str, opacity: f64) -> Light {
    let encoded = |c: f64| if c <= 0.003_130_8 { c * 12.92 } else { 1.055 * libm::pow(c, 1.0 / 2.4) - 0.055 };
    let decoded = |c: f64| if c <= 0.04045 { c / 12.92 } else { libm::pow((c + 0.055) / 1.055, 2.4) };
    let (colour, paper) = (light(colour), light(paper));
    [0, 1, 2].map(|i| decoded(opacity * encoded(colour[i]) + (1.0 - opacity) * encoded(paper[i])))
}

#[test]
fn text_is_readable_in_every_palette() {
    for palette in PALETTES {
        for role in [Role::Ink, Role::Grey, Role::Blue, Role::Vermilion, Role::Green] {
            let found = contrast(light(palette.of(role)), light(palette.of(Role::Paper)));
            assert!(found >= 4.5, "{role:?} {}: {found}", palette.of(role));
        }
    }
}

/// Lines of the grid behind a diagram say nothing that the axis does not say.
#[test]
fn lines_are_seen_in_every_palette() {
    for palette in PALETTES {
        for style in STYLES.into_iter().filter(|s| *s != Style::Grid) {
            let paint = style.paint();
            let Some((role, _)) = paint.stroke else { continue };
            let inside = paint.fill.filter(|f| *f != Role::Paper);
            for ground in [Some(Role::Paper), inside].into_iter().flatten() {
                let ground = palette.of(ground);
                let found = contrast(over(palette.of(role), ground, paint.opacity), light(ground));
                assert!(found >= 3.0, "{style:?} {} on {ground}: {found}", palette.of(role));
            }
        }
    }
}

/// What is seen without one kind of cones, after Machado, Oliveira and Fernandes, 2009.
const SEEN: [(&str, [[f64; 3]; 3]); 3] = [
    ("all cones", [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]),
    (
        "protanopia",
        [
            [0.152_286, 1.052_583, -0.204_868],
            [0.114_503, 0.786_281, 0.099_216],
            [-0.003_882, -0.048_116, 1.051_998],
        ],
    ),
    (
        "deuteranopia",
        [
            [0.367_322, 0.860_646, -0.227_968],
            [0.280_085, 0.672_501, 0.047_413],
            [-0.011_820, 0.042_940, 0.968_881],
        ],
    ),
];

/// Lightness and two opponent colours after CIE 1976, in which a distance of 2 is just seen.
fn lab(c: Light) -> [f64; 3] {
    let f = |t: f64| if t > 0.008_856 { libm::cbrt(t) } else { 7.787 * t + 16.0 / 116.0 };
    let x = f((0.4124 * c[0] + 0.3576 * c[1] + 0.1805 * c[2]) / 0.9505);
    let y = f(luminance(c));
    let z = f((0.0193 * c[0] + 0.1192 * c[1] + 0.9505 * c[2]) / 1.089);
    [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
}

#[test]
fn colours_are_told_apart_without_all_cones() {
    let roles = [Role::Ink, Role::Blue, Role::Vermilion, Role::Green, Role::Grey];
    for palette in COLOURED {
        for (name, matrix) in SEEN {
            let seen = |role: Role| {
                let c = light(palette.of(role));
                lab(matrix.map(|row| (row[0] * c[0] + row[1] * c[1] + row[2] * c[2]).clamp(0.0, 1.0)))
            };
            for (i, a) in roles.into_iter().enumerate() {
                for b in roles.into_iter().skip(i + 1) {
                    let apart: f64 = seen(a).iter().zip(seen(b)).map(|(x, y)| (x - y) * (x - y)).sum();
                    // grey lines are thin and dashed besides
                    let least = if b == Role::Grey { 10.0 } else { 20.0 };
                    assert!(apart.sqrt() >= least, "{name}: {a:?} and {b:?} {}", apart.sqrt());
                }
            }
        }
    }
}

/// In black and white the vectors of a picture differ in width or in dashes.
#[test]
fn vectors_are_told_apart_in_grey() {
    let pictures: [&[Style]; 6] = [
        &[Style::Force, Style::Unknown, Style::Drive],
        &[Style::Velocity, Style::VelocityPart],
        &[Style::Acceleration, Style::AccelerationPart, Style::AccelerationTangent],
        &[Style::Force, Style::Unknown, Style::UnknownPart],
        &[Style::Unknown, Style::Drive, Style::FrictionCircle, Style::Dashed],
        &CURVES,
    ];
    for picture in pictures {
        for (i, a) in picture.iter().enumerate() {
            for b in &picture[i + 1..] {
                let (first, second) = (a.paint(), b.paint());
                let widths = [first, second].map(|p| p.stroke.map_or(0.0, |(_, width)| width));
                let ratio = widths[0].max(widths[1]) / widths[0].min(widths[1]);
                assert!(first.dashes != second.dashes || ratio >= 1.3, "{a:?} and {b:?}");
            }
        }
    }
}
