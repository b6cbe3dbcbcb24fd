//! Numbers in pictures show no rounding.

use crate::drawn::{animated, sheets, solved};
use crate::every_example::examples;
use assur::internals::picture::KINDS;

/// Its lengths are far apart, so that some of its forces are small indeed.
const SMALL: &str = "hard/short-crank.mech";

/// Numbers of a text that are less than 1e-12: `−1.563e−13`.
fn tiny(text: &str) -> Vec<String> {
    let text = text.replace('−', "-");
    let exponent = |(at, _): (usize, &str)| {
        let digits: String = text[at + 2..].chars().take_while(char::is_ascii_digit).collect();
        let is_number = text[..at].ends_with(|c: char| c.is_ascii_digit());
        (is_number && digits.parse::<u32>().is_ok_and(|e| e >= 13)).then(|| {
            text[..at + 2].chars().rev().take(20).collect::<String>().chars().rev().collect::<String>()
                + &digits
        })
    };
    text.match_indices("e-").filter_map(exponent).collect()
}

#[test]
fn what_rounding_leaves_is_nothing() {
    let mut wrong = Vec::new();
    for (name, text) in examples().into_iter().filter(|(name, _)| name != SMALL) {
        let Some((source, solved)) = solved(&name, &text) else { continue };
        for sheet in KINDS.into_iter().flat_map(|kind| sheets(&source, &solved, kind)) {
            let said = sheet.drawing.description.split_once(" Their sum is").map(|(said, _)| said.to_owned());
            let said = said.unwrap_or_else(|| sheet.drawing.description.clone());
            let captions = sheet.drawing.captions.iter().map(|caption| caption.text.plain());
            let labels = sheet.placed.iter().map(|placed| placed.label.text.plain());
            let all = [said].into_iter().chain(captions).chain(labels);
            wrong.extend(
                all.flat_map(|text| tiny(&text)).map(|x| format!("{name}, {}: {x}", sheet.drawing.id)),
            );
        }
        let page = animated(&source, &solved).unwrap_or_default();
        wrong.extend(tiny(&page).into_iter().map(|x| format!("{name}, animation: {x}")));
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
