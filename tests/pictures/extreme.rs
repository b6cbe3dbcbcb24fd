//! Extreme inputs give a picture or a diagnostic.

use crate::drawn::{faults, sheets, solved};
use assur::internals::picture::{KINDS, Kind};

/// Draws all there is; how many pictures, and what is wrong with them.
fn drawn(text: &str) -> (usize, Vec<String>) {
    let Some((source, solved)) = solved("extreme.mech", text) else { return (0, Vec::new()) };
    let sheets: Vec<_> = KINDS.into_iter().flat_map(|kind| sheets(&source, &solved, kind)).collect();
    (sheets.len(), sheets.iter().flat_map(faults).collect())
}

fn four_bar(size: &str, names: [&str; 4]) -> String {
    let [a, b, c, d] = names;
    format!(
        "ground {{ {a} (0, 0); {d} (4 {size}, 0) }}
link crank {a}-{b} 1 {size}
link coupler {b}-{c} 4 {size}
link rocker {d}-{c} 3 {size}
revolute {a}: ground - crank
revolute {b}: crank - coupler
revolute {c}: coupler - rocker
revolute {d}: ground - rocker
drive crank = 60 deg at 10 rad/s
assemble {c} left of {b}-{d}
find omega(rocker)
"
    )
}

#[test]
fn every_size_is_drawn() {
    for power in [-9, -6, -3, 0, 3, 9] {
        let text = four_bar(&format!("e{power} m"), ["A", "B", "C", "D"]).replace(" e", "e");
        let (count, wrong) = drawn(&text);
        assert!(count > 0 && wrong.is_empty(), "1e{power} m: {count} {}", wrong.join("\n"));
    }
}

/// The squares of such accelerations are no numbers, and they are.
#[test]
fn great_accelerations_are_numbers() {
    let text = four_bar("m", ["A", "B", "C", "D"]).replace("10 rad/s", "1e99 rad/s") + "find alpha(rocker)\n";
    let (source, solved) = solved("great.mech", &text).expect("solved");
    let plans = sheets(&source, &solved, Kind::Accelerations);
    let words = &plans.first().expect("a plan").drawing.description;
    assert!(words.contains("a_B = 1e198 m/s²") && !words.contains("inf"), "{words}");
}

#[test]
fn long_and_foreign_names_are_drawn() {
    let long = "L".repeat(200);
    let other = "K".repeat(200);
    let (count, wrong) = drawn(&four_bar("m", [&long, &other, "铰链中心", "Шарнир"]));
    assert!(count > 0 && wrong.is_empty(), "{count}: {}", wrong.join("\n"));
}

#[test]
fn joints_that_coincide_are_drawn() {
    let text = "ground { A (0, 0); D (0, 0) }
link crank A-B 100 mm
link bar D-B 100 mm
link rod B-C 1e-9 m
revolute A: ground - crank
revolute D: ground - bar
drive crank = 0 deg
";
    drawn(text);
    let (_, wrong) = drawn("shaft I\ndrive I at 3 rad/s\nfind omega(I)\n");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    let one = "ground { A (0, 0) }\nlink crank { A (0, 0) }\nrevolute A: ground - crank\ndrive crank = 30 deg at 1 rad/s\nfind omega(crank)\n";
    let (count, wrong) = drawn(one);
    assert!(count > 0 && wrong.is_empty(), "{count}: {}", wrong.join("\n"));
}

#[test]
fn what_does_not_close_has_no_picture() {
    let text = four_bar("m", ["A", "B", "C", "D"]).replace("coupler B-C 4 m", "coupler B-C 40 m");
    assert_eq!(drawn(&text), (0, Vec::new()));
}

/// A chain of dyads on a row of fixed hinges.
fn chain(dyads: usize) -> String {
    let mut text =
        String::from("link crank A0-B0 1 m\nrevolute A0: ground - crank\ndrive crank = 60 deg at 10 rad/s\n");
    let mut points = String::from("A0 (0, 0)");
    for i in 1..=dyads {
        let (before, x) = (i - 1, 3 * i);
        let from = if i == 1 { "crank".to_owned() } else { format!("rocker{before}") };
        points += &format!("; A{i} ({x} m, 0)");
        text += &format!(
            "link rod{i} B{before}-B{i} 3 m\nlink rocker{i} A{i}-B{i} 1.5 m\nrevolute B{before}: {from} - rod{i}\n"
        );
        text += &format!("revolute A{i}: ground - rocker{i}\nassemble B{i} left of B{before}-A{i}\n");
    }
    let last = format!("revolute B{dyads}: rod{dyads} - rocker{dyads}\nfind omega(rocker{dyads})\n");
    // the hinge between a rod and its rocker is that from which the next rod starts
    let mut text = format!("ground {{ {points} }}\n{text}{last}");
    for i in 1..dyads {
        let (old, new) = (
            format!("revolute B{i}: rocker{i} - rod{}", i + 1),
            format!("revolute B{i}: rod{i} - rocker{i} - rod{}", i + 1),
        );
        text = text.replace(&(old + "\n"), &(new + "\n"));
    }
    text
}

#[test]
fn a_thousand_links_are_drawn() {
    let (count, wrong) = drawn(&chain(500));
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(count > 0);
}
