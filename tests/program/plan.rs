//! `assur check --plan` as run from a shell.

use crate::cli::GOOD;
use crate::run::{Folder, assur};

/// The lines of the plan and its cost, without the times, which differ from run to run.
fn without_times(report: &str) -> String {
    let is_time = |word: &str| word.contains('.') && word.parse::<f64>().is_ok();
    let lines = report.lines().skip_while(|line| !line.starts_with("Plan"));
    let shown = lines.filter(|line| !line.contains('─')).map(|line| {
        let words: Vec<&str> = line.split_whitespace().collect();
        let shown = words.iter().enumerate().map(|(i, word)| match words.get(i + 1) {
            Some(&"%") => "#",
            _ if is_time(word) => "#.#",
            _ => word,
        });
        shown.collect::<Vec<_>>().join(" ")
    });
    shown.collect::<Vec<_>>().join("\n")
}

#[test]
fn a_plan_has_what_is_asked_for_and_says_what_is_not() {
    let text = GOOD.replace(", v_C = velocity(C)", "").replace("C (0, 0) }", "C (0, 0); mass 2 kg at C }");
    let folder = Folder::new("plan").with("a.mech", &text);
    let out = assur(&folder, &["check", "--plan", "a.mech"]);
    assert_eq!((out.status, out.stderr.as_str()), (0, ""));
    insta::assert_snapshot!(without_times(&out.stdout), @r"
    Plan
    step what how time [ns] share
    1 motion of crank prescribed by drive crank #.# # %
    2 motion of rod, piston closed form, dyad RRP #.# # %

    Cost per position
    effect time [ns] share
    positions #.# # %
    the plan #.# # %
    residuals #.# ns in addition to the plan
    quantities #.# ns in addition to the plan
    not asked for velocities, accelerations, inertia, reactions
    measured best of repeated runs at 2 of the file's positions
    ");
}

#[test]
fn a_plan_says_what_its_steps_and_effects_cost() {
    let loads = "gravity 9.81 m/s^2\nspring k: ground.A - rod.C { stiffness 4 kN/m; free_length 80 mm }\n\
                 force P on piston at C = (-100 N, 0) when displacement(D) > 0.4 m\nbalance torque Mb on crank\n";
    let text = GOOD
        .replace("C (0, 0) }", "C (0, 0); mass 2 kg at C }")
        .replace("ground.guide", "ground.guide { friction 0.1 }")
        .replace("0 deg, 90 deg at", "30 deg at")
        .replace("at pose 1", "")
        .replace("450 mm", "430 mm")
        + loads
        + "find Mb\n";
    let open = GOOD.replace("350 mm", "50 mm").replace("0 deg, 90 deg", "90 deg");
    let folder = Folder::new("costs").with("a.mech", &text).with("open.mech", &open);
    let out = assur(&folder, &["check", "--plan", "a.mech"]);
    assert_eq!((out.status, out.stderr.as_str()), (0, ""));
    insta::assert_snapshot!(without_times(&out.stdout), @r"
    Plan
    step what how time [ns] share
    1 motion of crank prescribed by drive crank #.# # %
    2 motion of rod, piston closed form, dyad RRP #.# # %
    3 weight and inertia force of piston at its mass centre #.# # %
    4 force P on piston evaluated at every pose #.# # %
    5 spring k from its length #.# # %
    6 reactions on rod, piston closed form, dyad RRP, friction by Newton's method #.# # %
    7 reactions on crank equilibrium, with balance Mb #.# # %

    Cost per position
    effect time [ns] share
    positions #.# # %
    velocities #.# # %
    accelerations #.# # %
    gravity #.# # %
    inertia #.# # %
    springs #.# # %
    loads #.# # %
    reactions #.# # %
    friction #.# # %
    the plan #.# # %
    residuals #.# ns in addition to the plan
    quantities #.# ns in addition to the plan
    measured best of repeated runs at 64 positions over one turn of crank
    ");
    // shares add up to the whole
    let shares = out.stdout.lines().skip_while(|l| !l.starts_with("Cost")).filter_map(|line| {
        let (before, _) = line.split_once(" %")?;
        let name = line.split_whitespace().next()?;
        (!["the", "of", "beside"].contains(&name)).then(|| before.rsplit(' ').next()?.parse::<i32>().ok())?
    });
    let sum: i32 = shares.sum();
    assert!((95..=105).contains(&sum), "{}", out.stdout);
    // what does not close has no positions to be run at
    let out = assur(&folder, &["check", "--plan", "open.mech"]);
    assert_eq!(out.status, 1);
    assert!(out.stderr.contains("mech::assembly::does_not_close"), "{}", out.stderr);
    assert!(out.stdout.contains("Plan") && !out.stdout.contains("time [ns]"), "{}", out.stdout);
}

/// The cost of one position of a motion, with and without forces, with functions over the motion.
#[test]
fn a_plan_of_a_motion_has_its_cost() {
    let simulation = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/simulation/");
    let mut folder = Folder::new("plan_of_a_motion");
    let names = ["andrews.mech", "door-closer.mech", "upright-pendulum.mech", "bouncing.mech"];
    for name in names {
        folder =
            folder.with(name, &std::fs::read_to_string(format!("{simulation}{name}")).unwrap_or_default());
    }
    for name in names {
        let out = assur(&folder, &["check", "--plan", name]);
        assert_eq!((out.status, out.stderr.as_str()), (0, ""), "{name}");
        assert!(out.stdout.contains("inertia") && out.stdout.contains("the plan"), "{name}: {}", out.stdout);
    }
}
