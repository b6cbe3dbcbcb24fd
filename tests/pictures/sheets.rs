//! How large the sheets of pictures are, with their labels and the lines below them.

use crate::drawn::{Shown, solved};
use crate::every_example::examples;
use assur::internals::picture::{KINDS, Kind};

/// The largest sheet, mm.
const SHEET: [f64; 2] = [230.0, 200.0];
/// How many times as large as its usual size a scheme of many pairs is.
const MANY: f64 = 4.0;

#[test]
fn no_picture_is_larger_than_its_sheet() {
    let (mut wrong, mut count) = (Vec::new(), 0);
    for (name, text) in examples() {
        let Some((source, solved)) = solved(&name, &text) else { continue };
        let shown = Shown::of(&source, &solved);
        // a plot has a panel per unit
        for kind in KINDS.into_iter().filter(|kind| *kind != Kind::Plot) {
            let times = if matches!(kind, Kind::Scheme | Kind::Animation) { MANY } else { 1.0 };
            for (pose, sheet) in shown.sheets(kind, true) {
                let size = sheet.bounds.size();
                count += 1;
                if size.x > SHEET[0] * times || size.y > SHEET[1] * times {
                    let (kind, pose) = (kind.name(), &pose.name);
                    wrong.push(format!("{name}, {kind} at {pose}: {:.0} × {:.0} mm", size.x, size.y));
                }
            }
        }
    }
    assert!(count > 10_000, "{count} pictures");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
