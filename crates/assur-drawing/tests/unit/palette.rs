use assur_drawing::{Palette, Role};

/// Relative luminance after WCAG 2.
fn luminance(colour: &str) -> f64 {
    let digits: Vec<u32> = colour[1..].chars().filter_map(|c| c.to_digit(16)).collect();
    let parts: Vec<f64> = match digits.as_slice() {
        [r, g, b] => [r, g, b].map(|d| f64::from(d * 17)).to_vec(),
        all => all.chunks(2).map(|d| f64::from(d[0] * 16 + d[1])).collect(),
    };
    let linear = |c: &f64| {
        let c = c / 255.0;
        if c <= 0.04045 { c / 12.92 } else { libm::pow((c + 0.055) / 1.055, 2.4) }
    };
    let parts: Vec<f64> = parts.iter().map(linear).collect();
    0.2126 * parts[0] + 0.7152 * parts[1] + 0.0722 * parts[2]
}

#[test]
fn text_is_readable_in_every_palette() {
    for palette in [Palette::LIGHT, Palette::DARK, Palette::PRINT, Palette::MONO] {
        let paper = luminance(palette.of(Role::Paper));
        for role in [Role::Ink, Role::Grey, Role::Blue, Role::Vermilion, Role::Green] {
            let own = luminance(palette.of(role));
            let (high, low) = if own > paper { (own, paper) } else { (paper, own) };
            let contrast = (high + 0.05) / (low + 0.05);
            assert!(contrast >= 4.5, "{role:?} {}: {contrast}", palette.of(role));
        }
    }
}
