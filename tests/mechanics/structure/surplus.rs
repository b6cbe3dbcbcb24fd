//! What was added to a sound machine is named among what may be left out: pins between any two points, and links between them.

use assur::Problem;

const MACHINES: [(&str, &[(&str, &str)]); 3] = [
    (
        "ground { A (0, 0); D (0.9 m, 0.3 m); line way through A along 80 deg }
link crank A-B 0.2 m
link rod B-C 0.7 m
link arm D-C 0.5 m
link push C-E 0.6 m
link ram { E (0, 0) }
revolute A: ground - crank
revolute B: crank - rod
revolute C: rod - arm - push
revolute D: ground - arm
revolute E: push - ram
prismatic W: ram.E - ground.way
drive crank = 40 deg
",
        &[
            ("ground", "A"),
            ("ground", "D"),
            ("crank", "B"),
            ("rod", "C"),
            ("arm", "D"),
            ("push", "E"),
            ("ram", "E"),
        ],
    ),
    (
        "ground { A (0, 0); G (2 m, 0.2 m) }
link crank A-B 0.3 m
link base B-C 0.8 m { D (0.5 m, 0.5 m) }
link left C-E 0.6 m
link right D-F 0.7 m
link top E-F 0.5 m { G (0.9 m, 0.1 m) }
revolute A: ground - crank
revolute B: crank - base
revolute C: base - left
revolute D: base - right
revolute E: left - top
revolute F: right - top
revolute G: ground - top
drive crank = 70 deg
",
        &[
            ("ground", "A"),
            ("ground", "G"),
            ("crank", "B"),
            ("base", "C"),
            ("base", "D"),
            ("left", "E"),
            ("right", "F"),
            ("top", "G"),
        ],
    ),
    (
        "ground { A (0, 0); D (0.5 m, 0) }
link crank A-B 0.1 m
link rod B-C 0.4 m
link stub C-H 0.1 m
link rocker D-C 0.3 m
revolute A: ground - crank
revolute B: crank - rod
revolute C: rod - rocker
weld W: rod.C - stub.C { angle 60 deg }
revolute D: ground - rocker
drive crank = 70 deg
",
        &[("ground", "A"), ("ground", "D"), ("crank", "B"), ("rod", "C"), ("stub", "H"), ("rocker", "D")],
    ),
];

/// The words of all errors of a text that is no mechanism.
fn words(text: &str) -> String {
    let diagnostics = Problem::new("surplus", text).check();
    let errors = diagnostics.iter().filter(|d| d.severity == "error");
    errors.map(|d| format!("{}\n{}\n", d.message, d.help.clone().unwrap_or_default())).collect()
}

#[test]
fn what_was_added_is_named() {
    let mut failures = Vec::new();
    let mut cases = 0;
    for (machine, points) in MACHINES {
        for (i, one) in points.iter().enumerate() {
            for other in points.iter().skip(i + 1).filter(|other| other.0 != one.0) {
                // what one pin joins already is another mistake
                if one.1 == other.1 {
                    continue;
                }
                let pin = format!("revolute Z: {}.{} - {}.{}\n", one.0, one.1, other.0, other.1);
                let link = format!(
                    "link zz U-V 1.2 m\nrevolute zu: zz.U - {}.{}\nrevolute zv: zz.V - {}.{}\n",
                    one.0, one.1, other.0, other.1
                );
                for (added, name) in [(pin, "`revolute Z`"), (link, "`zz`")] {
                    cases += 1;
                    let text = format!("{machine}{added}");
                    let said = words(&text);
                    if !said.contains(name) {
                        failures.push(format!("{added}{said}"));
                    }
                }
            }
        }
    }
    assert!(failures.is_empty(), "{} of {cases}\n{}", failures.len(), failures.join("\n"));
}
