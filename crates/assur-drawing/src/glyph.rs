//! The width of a glyph.

use crate::widths::{ITALIC, UPRIGHT};

/// Units of an em in the tables.
const EM: f64 = 2048.0;

/// Width over the size of the font: one em for Chinese, Japanese and Korean signs and for all that no table has.
#[must_use]
pub fn width(c: char, italic: bool) -> f64 {
    let code = u32::from(c);
    // marks that sit on the letter before
    if (0x300..=0x36F).contains(&code) || (0x200B..=0x200F).contains(&code) {
        return 0.0;
    }
    let ranges = if italic { ITALIC } else { UPRIGHT };
    let units = ranges.iter().find_map(|(first, widths)| {
        let place = usize::try_from(code.checked_sub(*first)?).ok()?;
        widths.get(place).copied()
    });
    match units {
        Some(units) if units > 0 => f64::from(units) / EM,
        _ => 1.0,
    }
}
