//! A definition that nothing uses asks for nothing.

use assur::internals::check::Overrides;
use assur::internals::report::{AccuracyShown, PrintedDigits, of_answers};
use assur::internals::source::Source;

/// Definitions of every kind that nothing uses, of any drive: no speed is wanted for them, no sweep, and nothing is solved.
#[test]
fn definitions_that_nothing_uses_change_nothing() {
    let kinds = [
        "mag(velocity(rod.B))",
        "mag(acceleration(rod.B))",
        "alpha(rod)",
        "mag(reaction(B, rod))",
        "max(omega(rod))",
        "integral(power(E))",
        "mean(mag(reaction(B, rod)))",
        "efficiency()",
        "dead(D, 1)",
        "stroke(D)",
        "2*q0 + 1 m/s",
    ];
    let lets: String = kinds.iter().enumerate().map(|(i, kind)| format!("let q{i} = {kind}\n")).collect();
    let file = |drive: &str, lets: &str, find: &str| {
        format!(
            "gravity 9.81 m/s^2\nground {{ A (0, 0); line guide through A along 0 deg }}
link a A-B 100 mm {{ mass 1 kg at B; inertia 0 kg*m^2 }}
link rod B-C 350 mm
link piston {{ C (0, 0); mass 2 kg at C }}
revolute A: ground - a
revolute B: a - rod {{ radius 5 mm; friction 0.1 }}
revolute C: rod - piston
prismatic D: piston.C - ground.guide {{ friction 0.1 }}
force E on piston at C = (30 N, 0)
assemble C ahead of B
{drive}
{lets}find {find}
"
        )
    };
    let drives = [
        ("drive a = 30 deg", "displacement(D), angle(rod)"),
        ("drive a = 10 deg .. 60 deg in 5 steps", "position(piston.C)"),
        ("drive a = 30 deg turning cw", "mag(velocity(C)), displacement(D)"),
        ("drive D = 420 mm\nassemble B left of A-C", "angle(a)"),
        ("drive a = 0 deg .. 360 deg in 6 steps at 30 rpm", "v = velocity(C).x, effort(a)"),
        ("start a = 80 deg\nsimulate 0.05 s in 2 steps", "angle(a), max(omega(a))"),
    ];
    for (drive, find) in drives {
        // a motion has neither, and says so
        let meant = |line: &&str| {
            !drive.starts_with("start") || !(line.contains("dead(") || line.contains("stroke("))
        };
        let lets: String = lets.lines().filter(meant).map(|line| format!("{line}\n")).collect();
        let report = |lets: &str| {
            let text = file(drive, lets, find);
            let source = Source::new("case.mech", text.as_str());
            let (solved, problems) = assur::internals::solve_source(&source, &Overrides::none());
            let solved = solved.unwrap_or_else(|| panic!("{problems:?}\n{text}"));
            let (cycles, plan) = (solved.compiled.mechanism.cycles.len(), &solved.compiled.plan);
            let answers = solved.answers(PrintedDigits::READABLE);
            let report = of_answers("case.mech", &answers, AccuracyShown::Worst);
            (
                cycles,
                [plan.motion.len(), plan.loads.len(), plan.forces.len()],
                format!("{report:?}"),
                problems.has_errors(),
            )
        };
        assert_eq!(report(""), report(&lets), "{drive}");
    }
    let unused = include_str!("../cases/use3/numbers/unused-let-velocity.mech");
    let solution = assur::solve(unused).expect("it is solved");
    let at = solution.poses()[0]["position(a.A)"].vector().expect("a vector");
    assert!((at.0 - 173.205_080_756_887_74).abs() + (at.1 - 100.0).abs() < 1e-12, "{at:?}");
}
