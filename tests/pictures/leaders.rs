//! Labels beside the drawing with a line to their place are few, in every kind of picture.

use crate::drawn::{Shown, solved};
use crate::every_example::examples;
use assur::internals::picture::KINDS;
use std::collections::{BTreeMap, BTreeSet};

/// The most pictures of a kind that have one.
const MOST: f64 = 0.035;

#[test]
fn leaders_are_few() {
    let mut counts: BTreeMap<_, (usize, usize, Vec<String>)> = BTreeMap::new();
    for (name, text) in examples() {
        let Some((source, solved)) = solved(&name, &text) else { continue };
        let shown = Shown::of(&source, &solved);
        for kind in KINDS {
            let mut seen = BTreeSet::new();
            for (pose, sheet) in shown.sheets(kind, true) {
                // positions of one name are one
                if !seen.insert((pose.name.clone(), sheet.drawing.id.clone())) {
                    continue;
                }
                let with = sheet.placed.iter().filter(|p| p.leader.is_some());
                let labels: Vec<String> = with.map(|p| p.label.text.plain()).collect();
                let count = counts.entry(kind).or_default();
                count.0 += 1;
                if !labels.is_empty() {
                    count.1 += 1;
                    count.2.push(format!("{name} {}: {}", pose.name, labels.join(", ")));
                }
            }
        }
    }
    let mut wrong = Vec::new();
    for (kind, (all, with, names)) in &counts {
        println!("{kind:?}: {with} of {all}");
        if *with as f64 > MOST * *all as f64 {
            wrong.push(format!("{kind:?}: {with} of {all}\n    {}", names.join("\n    ")));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
